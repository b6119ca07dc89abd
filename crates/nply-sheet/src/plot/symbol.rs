//! Strokes, discs and symbols.

use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive};

use super::{Dash, MarkerShape};

impl Dash {
    /// Lengths of strokes and gaps, as SVG has them.
    pub(super) fn pattern(self) -> Option<String> {
        let pattern = match self {
            Self::Solid => return None,
            Self::Dashed => "6 4",
            Self::Dotted => "2 3",
            Self::DashDotted => "8 3 2 3",
        };
        Some(pattern.to_owned())
    }
}

/// Half the size of a symbol, in pixels.
const SIZE: f64 = 5.0;

/// A disc with a rim.
pub(super) fn disc((cx, cy): (f64, f64), r: f64, fill: Color, rim: Color, width: f64) -> Primitive {
    Primitive::Circle { cx, cy, r, fill, fill_opacity: None, stroke: Some(rim), stroke_width: Some(width) }
}

/// A marker; a filled one has a rim in the ground's colour so that it stands off from what is below, a hollow one is filled with it.
pub(super) fn marker(shape: MarkerShape, (x, y): (f64, f64), hollow: bool, colour: Color, ground: Color) -> Primitive {
    let (fill, rim, width) = if hollow { (ground, colour.clone(), 1.8) } else { (colour.clone(), ground, 1.0) };
    let path = |corners: &[(f64, f64)], joins: &str| {
        let mut d = String::new();
        for (i, (dx, dy)) in corners.iter().enumerate() {
            let letter = if i == 0 || (joins.is_empty() && i % 2 == 0) { 'M' } else { 'L' };
            d += &format!("{letter} {:.2} {:.2} ", x + SIZE * dx, y + SIZE * dy);
        }
        let is_area = !joins.is_empty();
        Primitive::Path(Box::new(PathData {
            d: d + joins,
            fill: is_area.then(|| fill.clone()),
            stroke: if is_area { rim.clone() } else { colour.clone() },
            stroke_width: if is_area { width } else { 2.0 },
            opacity: None,
            stroke_dasharray: None,
        }))
    };
    match shape {
        MarkerShape::Circle => disc((x, y), SIZE, fill, rim, width),
        MarkerShape::Square => path(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)], "Z"),
        MarkerShape::Triangle => path(&[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)], "Z"),
        MarkerShape::Diamond => path(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)], "Z"),
        MarkerShape::Cross => path(&[(-0.9, -0.9), (0.9, 0.9), (-0.9, 0.9), (0.9, -0.9)], ""),
        MarkerShape::Plus => path(&[(-1.2, 0.0), (1.2, 0.0), (0.0, -1.2), (0.0, 1.2)], ""),
    }
}
