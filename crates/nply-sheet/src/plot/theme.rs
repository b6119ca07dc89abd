//! Light or dark ground, and the colours that stand out on it.

use kuva::Theme as Kuva;
use kuva::render::color::Color;

use super::palette;

/// The ground of a picture.
///
/// ```
/// use nply_sheet::plot::{Axis, Chart, Curve, Theme};
/// let chart = Chart::new("", Axis::new("f", ""), Axis::new("m", "")).with_curve(Curve::new("", [(0.0, 0.0), (1.0, 1.0)]));
/// assert_ne!(chart.svg_in(Theme::Dark), chart.svg());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on nearly black.
    Dark,
}

impl Theme {
    /// The ground.
    pub(crate) const fn ground(self) -> [u8; 3] {
        match self {
            Self::Light => [0xff, 0xff, 0xff],
            Self::Dark => [0x17, 0x19, 0x1d],
        }
    }

    /// Text.
    pub(crate) const fn ink(self) -> [u8; 3] {
        match self {
            Self::Light => [0x22, 0x22, 0x22],
            Self::Dark => [0xe6, 0xe6, 0xe6],
        }
    }

    /// What stands back: dashed outlines, help lines.
    pub(crate) const fn grey(self) -> [u8; 3] {
        match self {
            Self::Light => [0x8a, 0x8a, 0x8a],
            Self::Dark => [0x92, 0x96, 0x9c],
        }
    }

    /// Colour number i of the palette, counted round; a pale one is half the ground's.
    pub(crate) fn line(self, i: usize, pale: bool) -> [u8; 3] {
        let colours = match self {
            Self::Light => &palette::LINES,
            Self::Dark => &palette::LINES_ON_DARK,
        };
        let colour = colours[i % colours.len()];
        if pale { mixed(colour, self.ground(), 0.5) } else { colour }
    }

    pub(super) fn stroke(self, i: usize, pale: bool) -> Color {
        let [r, g, b] = self.line(i, pale);
        Color::Rgb(r, g, b)
    }

    /// The same for axes and legends.
    pub(super) fn kuva(self) -> Kuva {
        let (frame, grid) = match self {
            Self::Light => ("#000000", "#e4e4e4"),
            Self::Dark => ("#b8bcc4", "#33373e"),
        };
        let mut theme = Kuva::light();
        theme.background = hex(self.ground());
        theme.legend_bg = hex(self.ground());
        theme.text_color = hex(self.ink());
        theme.grid_color = grid.to_owned();
        for colour in
            [&mut theme.axis_color, &mut theme.tick_color, &mut theme.legend_border, &mut theme.colorbar_border]
        {
            *colour = frame.to_owned();
        }
        theme
    }

    /// The frame round a colour bar.
    pub(super) fn frame(self) -> Color {
        let [r, g, b] = match self {
            Self::Light => [0; 3],
            Self::Dark => [0xb8, 0xbc, 0xc4],
        };
        Color::Rgb(r, g, b)
    }
}

/// One colour with a share of another.
pub(crate) fn mixed(colour: [u8; 3], other: [u8; 3], share: f64) -> [u8; 3] {
    core::array::from_fn(|i| {
        let mixed = (1.0 - share) * f64::from(colour[i]) + share * f64::from(other[i]);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
        let byte = libm::round(mixed.clamp(0.0, 255.0)) as u8;
        byte
    })
}

/// As `#rrggbb`.
pub(crate) fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
