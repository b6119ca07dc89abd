//! Pictures as pixels.

use std::sync::{Arc, OnceLock};

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};

/// DejaVu Sans, Latin, Greek and what formulas need of it; the same on every machine.
static FONT: &[u8] = include_bytes!("../../fonts/DejaVuSans-subset.ttf");

/// Why a picture has no pixels.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BitmapError {
    /// The text is no SVG.
    #[error("the picture cannot be read: {0}")]
    Unreadable(String),
    /// It has no size, or one too large to be held.
    #[error("a picture of {width} × {height} pixels cannot be drawn: ask for a smaller one")]
    Size {
        /// Pixels across.
        width: f64,
        /// Pixels up.
        height: f64,
    },
}

/// The longest side, in pixels.
const MOST: f64 = 20_000.0;

/// An SVG drawn as PNG, `zoom` pixels to a unit of its own (2 for a sharp picture on paper), at most 20 000 on a side.
///
/// # Errors
/// [`BitmapError`] where the text is no SVG, or the picture would have no size or too great a one.
///
/// ```
/// use nply_sheet::plot::{Axis, Chart, Curve, png};
/// let chart = Chart::new("", Axis::new("θ", "deg"), Axis::new("ρ", "")).with_curve(Curve::new("", [(0.0, 1.0), (1.0, 2.0)]));
/// assert!(png(&chart.svg(), 2.0)?.starts_with(b"\x89PNG"));
/// # Ok::<(), nply_sheet::plot::BitmapError>(())
/// ```
pub fn png(svg: &str, zoom: f64) -> Result<Vec<u8>, BitmapError> {
    let mut options = Options { font_family: "DejaVu Sans".to_owned(), ..Options::default() };
    options.fontdb = fonts();
    let tree = Tree::from_str(svg, &options).map_err(|error| BitmapError::Unreadable(error.to_string()))?;
    let side = |length: f32| libm::ceil(f64::from(length) * zoom);
    let (width, height) = (side(tree.size().width()), side(tree.size().height()));
    let size = || BitmapError::Size { width, height };
    if !((1.0..=MOST).contains(&width) && (1.0..=MOST).contains(&height)) {
        return Err(size());
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 1 and the most")]
    let (mut pixels, zoom) = (Pixmap::new(width as u32, height as u32).ok_or_else(size)?, zoom as f32);
    resvg::render(&tree, Transform::from_scale(zoom, zoom), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| BitmapError::Unreadable(error.to_string()))
}

/// The one font, read once, and only when a picture is drawn.
fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let read = || {
        let mut fonts = Database::new();
        fonts.load_font_data(FONT.to_vec());
        fonts.set_sans_serif_family("DejaVu Sans");
        Arc::new(fonts)
    };
    FONTS.get_or_init(read).clone()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_leave_ink() {
        let ink = |text: &str| {
            let svg = format!(
                r#"<svg xmlns="http://www.w3.org/2000/svg" width="60" height="20"><text x="2" y="15" font-size="14" font-family="Arial, sans-serif">{text}</text></svg>"#
            );
            let file = png(&svg, 1.0).unwrap();
            let mut reader = png::Decoder::new(std::io::Cursor::new(&file)).read_info().unwrap();
            let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
            reader.next_frame(&mut bytes).unwrap();
            bytes.chunks_exact(4).map(|pixel| u32::from(pixel[3])).sum::<u32>()
        };
        assert_eq!(ink(" "), 0);
        for word in ["θ", "ρ", "γ", "φ̄a", "p₁", "10⁻²¹", "−1 π ∞"] {
            assert!(ink(word) > 500, "{word}");
        }
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        assert!(matches!(png("no picture", 1.0), Err(BitmapError::Unreadable(_))));
        let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="10" height="10"/>"#;
        for zoom in [0.0, -1.0, f64::NAN, 1e9] {
            assert!(matches!(png(svg, zoom), Err(BitmapError::Size { .. })), "{zoom}");
        }
    }
}
