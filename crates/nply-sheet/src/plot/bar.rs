//! The colours of a field's numbers, beside it.

use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

use super::axis::{TICKS, Window};
use super::panel::{GAP, LABEL, TICK, words};
use super::picture::add_image;
use super::{Axis, ColourMap, Theme, raster, text};

/// The bar's width.
const BAR: f64 = 16.0;

/// A colour bar with its labels.
pub(super) struct Bar {
    map: ColourMap,
    window: Window,
    ticks: Vec<(f64, String)>,
    label: String,
    digits: f64,
}

impl Bar {
    pub(super) fn of(axis: &Axis, map: ColourMap) -> Option<Self> {
        let (low, high) = axis.fixed()?;
        let window = Window::exact(low, high);
        let ticks: Vec<(f64, String)> = window.ticks(TICKS);
        let digits = ticks.iter().map(|(_, t)| text::width(t, f64::from(TICK))).fold(0.0, f64::max);
        let label = axis.label(&window);
        Some(Self { map, window, ticks, label, digits })
    }

    pub(super) fn width(&self) -> f64 {
        let label = if self.label.is_empty() { 0.0 } else { 8.0 + f64::from(LABEL) };
        GAP + BAR + 8.0 + self.digits + label
    }

    /// Drawn with its left side at `x`, as high as the axes.
    pub(super) fn add_to(&self, scene: &mut Scene, images: &mut Vec<String>, [x, top, height]: [f64; 3], theme: Theme) {
        if let Some(png) = raster::bar(self.map) {
            add_image(scene, images, raster::element(&png, [x, top, BAR, height]));
        }
        scene.add(Primitive::Rect {
            x,
            y: top,
            width: BAR,
            height,
            fill: Color::None,
            stroke: Some(theme.frame()),
            stroke_width: Some(1.0),
            opacity: None,
        });
        for (value, label) in &self.ticks {
            let y = top + height * (self.window.high - value) / (self.window.high - self.window.low);
            scene.add(Primitive::Line {
                x1: x + BAR,
                y1: y,
                x2: x + BAR + 5.0,
                y2: y,
                stroke: theme.frame(),
                stroke_width: 1.0,
                stroke_dasharray: None,
            });
            let place = (x + BAR + 8.0, y + 0.35 * f64::from(TICK));
            scene.add(words(label.clone(), place, TICK, TextAnchor::Start, None));
        }
        let place = (x + self.width() - GAP, top + height / 2.0);
        scene.add(words(self.label.clone(), place, LABEL, TextAnchor::Middle, Some(-90.0)));
    }
}
