//! The names of what is drawn, on the right of the axes.

use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

use super::{Dash, MarkerShape, symbol, text};

/// One name, and what it is the name of.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) label: String,
    pub(super) colour: Color,
    pub(super) sample: Sample,
}

/// What stands before a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sample {
    Line { dash: Dash, width: f64 },
    Marker { shape: MarkerShape, hollow: bool },
    Area,
    Cell,
    Nothing,
}

/// The names a legend has room for.
const NAMES: usize = 17;
/// A name's height in its font's size.
const LEADING: f64 = 1.55;
/// A sample's width.
const SAMPLE: f64 = 28.0;
/// Between sample and name.
const GAP: f64 = 7.0;

/// Cut to what there is room for.
pub(super) fn fit(entries: &mut Vec<Entry>) {
    if entries.len() > NAMES {
        let label = format!("… and {} more", entries.len() + 1 - NAMES);
        entries.truncate(NAMES - 1);
        entries.push(Entry { label, colour: Color::None, sample: Sample::Nothing });
    }
}

/// Its width in pixels, in a font of this size.
pub(super) fn width(entries: &[Entry], size: u32) -> f64 {
    let names = entries.iter().map(|entry| text::width(&entry.label, f64::from(size))).fold(0.0, f64::max);
    if entries.is_empty() { 0.0 } else { SAMPLE + GAP + names }
}

/// Drawn from its upper left corner on.
pub(super) fn draw(entries: &[Entry], scene: &mut Scene, (x, y): (f64, f64), size: u32, ground: &Color) {
    for (i, entry) in entries.iter().enumerate() {
        let middle = y + (i as f64 + 0.5) * LEADING * f64::from(size);
        let (x1, x2) = (x, x + SAMPLE);
        let colour = entry.colour.clone();
        match entry.sample {
            Sample::Line { dash, width } => scene.add(Primitive::Line {
                x1,
                y1: middle,
                x2,
                y2: middle,
                stroke: colour,
                stroke_width: width,
                stroke_dasharray: dash.pattern(),
            }),
            Sample::Marker { shape, hollow } => {
                scene.add(symbol::marker(shape, (0.5 * (x1 + x2), middle), hollow, colour, ground.clone()));
            }
            Sample::Area => scene.add(block(x1 + 4.0, middle - 6.0, SAMPLE - 8.0, colour, 0.25)),
            Sample::Cell => scene.add(block(x1 + 8.0, middle - 6.0, 12.0, colour, 1.0)),
            Sample::Nothing => {}
        }
        scene.add(Primitive::Text {
            x: x2 + GAP,
            y: middle + 0.35 * f64::from(size),
            content: entry.label.clone(),
            size,
            anchor: TextAnchor::Start,
            rotate: None,
            bold: false,
            color: None,
        });
    }
}

fn block(x: f64, y: f64, width: f64, fill: Color, opacity: f64) -> Primitive {
    Primitive::Rect { x, y, width, height: 12.0, fill, stroke: None, stroke_width: None, opacity: Some(opacity) }
}
