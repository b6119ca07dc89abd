//! A grid of cells as one embedded PNG, a byte a cell.

use base64::Engine as _;

use super::{Axis, ColourMap, axis, palette};

/// What the cells mean, besides their bytes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Meaning {
    /// Numbers from a lower to an upper limit, told by a colour bar.
    Values { bar: Axis, map: ColourMap },
    /// Names, told by a legend.
    Categories(Vec<String>),
}

/// Cells in rows from the bottom to the top, each from left to right.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Raster {
    pub(super) columns: usize,
    /// 0 for nothing there, else one more than the number of the colour.
    pub(super) cells: Vec<u8>,
    pub(super) meaning: Meaning,
}

/// The colour of category number i.
pub(super) fn area(i: usize) -> [u8; 3] {
    palette::AREAS[i % palette::AREAS.len()]
}

impl Raster {
    /// Numbers; where the bar has no range, it is found, and written there.
    pub(super) fn of_values(columns: usize, values: &[f64], mut bar: Axis, map: ColourMap) -> Self {
        let (mut low, mut high) = bar.fixed().or_else(|| axis::extent(values.iter().copied())).unwrap_or((0.0, 1.0));
        if low > high {
            (low, high) = (high, low);
        }
        if map == ColourMap::Diverging {
            high = low.abs().max(high.abs());
            low = -high;
        }
        bar.range = Some((low, high));
        let step = |value: f64| {
            // Halves, since the difference of the limits may overflow.
            let fraction = (value.clamp(low, high) / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
            let fraction = if fraction.is_finite() { fraction } else { 0.5 };
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 254")]
            let step = libm::round(fraction * f64::from(palette::STEPS - 1)) as u8;
            step + 1
        };
        let cells = values.iter().map(|&v| if v.is_nan() { 0 } else { step(v) }).collect();
        Self { columns, cells, meaning: Meaning::Values { bar, map } }
    }

    /// Names by their number; a number without a name is nothing there.
    pub(super) fn of_categories(columns: usize, numbers: &[u8], names: Vec<String>) -> Self {
        let known = |&n: &u8| if n < u8::MAX && usize::from(n) < names.len() { n + 1 } else { 0 };
        let cells = numbers.iter().map(known).collect();
        Self { columns, cells, meaning: Meaning::Categories(names) }
    }

    fn colours(&self) -> Vec<[u8; 3]> {
        match &self.meaning {
            Meaning::Values { map, .. } => map.steps(),
            Meaning::Categories(_) => (0..usize::from(u8::MAX)).map(area).collect(),
        }
    }

    /// The picture, `mirrored` where an axis runs the other way; `None` where there is no cell.
    pub(super) fn png(&self, mirrored: [bool; 2]) -> Option<Vec<u8>> {
        let rows: Vec<&[u8]> = match self.columns {
            0 => Vec::new(),
            columns => self.cells.chunks_exact(columns).collect(),
        };
        let mut bytes = Vec::with_capacity(self.cells.len());
        let row = |bytes: &mut Vec<u8>, row: &[u8]| match mirrored[0] {
            false => bytes.extend_from_slice(row),
            true => bytes.extend(row.iter().rev()),
        };
        match mirrored[1] {
            false => rows.iter().rev().for_each(|cells| row(&mut bytes, cells)),
            true => rows.iter().for_each(|cells| row(&mut bytes, cells)),
        }
        png(self.columns, rows.len(), &bytes, &self.colours())
    }
}

/// The colour bar's picture: one column, the upper limit on top.
pub(super) fn bar(map: ColourMap) -> Option<Vec<u8>> {
    let steps: Vec<u8> = (1..=palette::STEPS).rev().collect();
    png(1, steps.len(), &steps, &map.steps())
}

/// Bytes as an indexed PNG, byte 0 transparent; `None` where it has no size, or more than a PNG can have.
fn png(width: usize, height: usize, bytes: &[u8], colours: &[[u8; 3]]) -> Option<Vec<u8>> {
    let size = |n: usize| u32::try_from(n).ok().filter(|&n| n > 0);
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size(width)?, size(height)?);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette([0; 3].iter().copied().chain(colours.iter().flatten().copied()).collect::<Vec<u8>>());
    encoder.set_trns(vec![0]);
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(bytes).ok()?;
    writer.finish().ok()?;
    Some(file)
}

/// An image element that fills a rectangle, its pixels not blurred.
pub(super) fn element(png: &[u8], [x, y, width, height]: [f64; 4]) -> String {
    format!(
        concat!(
            r#"<image x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}" preserveAspectRatio="none" "#,
            r#"image-rendering="optimizeSpeed" style="image-rendering:pixelated" href="data:image/png;base64,{png}"/>"#
        ),
        x = x,
        y = y,
        width = width,
        height = height,
        png = base64::engine::general_purpose::STANDARD.encode(png)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(file: &[u8]) -> (u32, Vec<[u8; 4]>) {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        (info.width, bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect())
    }

    #[test]
    fn the_first_row_is_at_the_bottom() {
        // Two columns, three rows; in the picture's order the top row comes first.
        let values = [0.0, 1.0, f64::NAN, 0.5, f64::INFINITY, f64::NEG_INFINITY];
        let raster = Raster::of_values(2, &values, Axis::default(), ColourMap::Sequential);
        let opaque = |fraction: f64| {
            let [r, g, b] = ColourMap::Sequential.at(fraction);
            [r, g, b, 255]
        };
        let (width, pixels) = decoded(&raster.png([false; 2]).unwrap());
        assert_eq!((width, pixels.len()), (2, 6));
        assert_eq!(pixels[4..], [opaque(0.0), opaque(1.0)]);
        assert_eq!((pixels[2][3], pixels[3]), (0, opaque(0.5)));
        assert_eq!(pixels[..2], [opaque(1.0), opaque(0.0)]);
        let (_, mirrored) = decoded(&raster.png([true, true]).unwrap());
        assert_eq!(mirrored[..2], [opaque(1.0), opaque(0.0)]);
        assert_ne!(opaque(0.0), opaque(1.0));
    }

    #[test]
    fn a_category_without_a_name_is_nothing() {
        let raster = Raster::of_categories(3, &[1, 2, 255], vec!["none".into(), "one".into()]);
        let (_, pixels) = decoded(&raster.png([false; 2]).unwrap());
        assert_eq!((&pixels[0][..3], pixels[1][3], pixels[2][3]), (&area(1)[..], 0, 0));
    }
}
