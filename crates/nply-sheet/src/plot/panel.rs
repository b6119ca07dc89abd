//! One pair of axes, drawn.

use std::collections::{BTreeMap, BTreeSet};

use kuva::render::axis::{add_axes_and_grid, add_labels_and_title};
use kuva::render::color::Color;
use kuva::render::layout::{AxisLabelOverlap, ComputedLayout, Layout};
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

use super::axis::{TICKS, Window};
use super::bar::Bar;
use super::clip::Frame;
use super::legend::{self, Entry, Sample};
use super::picture::{View, add_image};
use super::raster::{self, Meaning};
use super::{Axis, Chart, Side, Theme, palette, symbol, text};

const TITLE: u32 = 16;
pub(super) const LABEL: u32 = 14;
pub(super) const TICK: u32 = 12;
/// Between the axes and what stands on their right.
pub(super) const GAP: f64 = 18.0;
/// How much of its colour an area has.
const THIN: f64 = 0.16;

/// A panel with its places found.
pub(super) struct Drawing<'a> {
    view: View<'a>,
    theme: Theme,
    x: Window,
    y: Window,
    layout: Layout,
    places: ComputedLayout,
    bar: Option<Bar>,
    colours: Vec<usize>,
    legend: Vec<Entry>,
}

impl<'a> Drawing<'a> {
    pub(super) fn of(view: View<'a>, theme: Theme) -> Self {
        let chart = view.chart;
        let (x, y) = windows(view);
        let colours = colours(chart);
        let mut legend = Vec::new();
        let mut bar = None;
        match view.raster.map(|raster| &raster.meaning) {
            Some(Meaning::Values { bar: axis, map }) => bar = Bar::of(axis, *map),
            Some(Meaning::Categories(names)) => legend.extend(names.iter().enumerate().map(|(i, name)| {
                let [r, g, b] = raster::area(i);
                Entry { label: text::name(name), colour: Color::Rgb(r, g, b), sample: Sample::Cell }
            })),
            None => {}
        }
        if chart.legend {
            entries(chart, &colours, theme, &mut legend);
        }
        legend::fit(&mut legend);
        let layout = layout(chart, &x, &y, view.raster.is_some(), theme);
        let mut places = ComputedLayout::from_layout(&layout);
        places.margin_left += 6.0;
        let names = if legend.is_empty() { 0.0 } else { GAP + legend::width(&legend, TICK) };
        let side = bar.as_ref().map_or(0.0, Bar::width) + names;
        places.margin_right = places.margin_right.max(side + 12.0);
        let mut drawing = Self { view, theme, x, y, layout, places, bar, colours, legend };
        drawing.fit();
        drawing
    }

    /// Between the axes, in pixels.
    fn inside(&self) -> (f64, f64) {
        self.view.chart.size
    }

    /// The picture's size follows from the margins.
    fn fit(&mut self) {
        let (width, height) = self.inside();
        let places = &mut self.places;
        places.width = places.margin_left + width + places.margin_right;
        places.height = places.margin_top + height + places.margin_bottom;
        places.recompute_transforms();
    }

    /// Axes above each other begin and end at the same places.
    pub(super) fn align_sides<'d>(drawings: impl Iterator<Item = &'d mut Self>)
    where
        'a: 'd,
    {
        let drawings: Vec<&mut Self> = drawings.collect();
        let widest = |of: fn(&Self) -> f64| drawings.iter().map(|d| of(d)).fold(0.0, f64::max);
        let (left, right) = (widest(|d| d.places.margin_left), widest(|d| d.places.margin_right));
        for drawing in drawings {
            (drawing.places.margin_left, drawing.places.margin_right) = (left, right);
            drawing.fit();
        }
    }

    /// Axes beside each other begin at the same height; titles stay right above them.
    pub(super) fn align_tops(drawings: &mut [Self]) {
        let top = drawings.iter().map(|d| d.places.margin_top).fold(0.0, f64::max);
        for drawing in drawings {
            drawing.places.title_y += top - drawing.places.margin_top;
            drawing.places.margin_top = top;
            drawing.fit();
        }
    }

    pub(super) fn width(&self) -> f64 {
        self.places.width
    }

    pub(super) fn height(&self) -> f64 {
        self.places.height
    }

    pub(super) fn font(&self) -> Option<String> {
        self.places.font_family.clone()
    }

    fn right(&self) -> f64 {
        self.places.margin_left + self.inside().0
    }

    pub(super) fn add_to(&self, scene: &mut Scene, images: &mut Vec<String>) {
        if let Some(raster) = self.view.raster {
            let runs_back = |axis: &Axis| axis.fixed().is_some_and(|(from, to)| from > to);
            let mirrored = [runs_back(&self.view.chart.x), runs_back(&self.view.chart.y)];
            if let Some(png) = raster.png(mirrored) {
                let (width, height) = self.inside();
                let place = [self.places.margin_left, self.places.margin_top, width, height];
                add_image(scene, images, raster::element(&png, place));
            }
        }
        add_axes_and_grid(scene, &self.places, &self.layout);
        self.add_between_decades(scene);
        self.add_areas(scene);
        self.add_curves(scene);
        self.add_markers(scene);
        self.add_notes(scene);
        add_labels_and_title(scene, &self.places, &self.layout);
        let mut side = self.right() + GAP;
        if let Some(bar) = &self.bar {
            bar.add_to(scene, images, [side, self.places.margin_top, self.inside().1], self.theme);
            side += bar.width();
        }
        legend::draw(&self.legend, scene, (side, self.places.margin_top - 2.0), TICK, &self.ground());
    }

    fn ground(&self) -> Color {
        let [r, g, b] = self.theme.ground();
        Color::Rgb(r, g, b)
    }

    fn at(&self, point: [f64; 2]) -> (f64, f64) {
        (self.places.map_x(point[0]), self.places.map_y(point[1]))
    }

    fn scaled(&self, (x, y): (f64, f64)) -> [f64; 2] {
        [self.x.scaled(x), self.y.scaled(y)]
    }

    fn frame(&self) -> Frame {
        Frame { low: [self.x.low, self.y.low], high: [self.x.high, self.y.high] }
    }

    /// What the axes do not draw themselves: ticks within a decade.
    fn add_between_decades(&self, scene: &mut Scene) {
        let (left, top) = (self.places.margin_left, self.places.margin_top);
        let (right, bottom) = (self.right(), top + self.inside().1);
        let mut line = |[x1, y1, x2, y2]: [f64; 4], stroke: &str| {
            scene.add(Primitive::Line {
                x1,
                y1,
                x2,
                y2,
                stroke: Color::from(stroke),
                stroke_width: 1.0,
                stroke_dasharray: None,
            });
        };
        let theme = &self.places.theme;
        let mut labels = Vec::new();
        for (tick, label) in self.x.between_decades() {
            let x = self.places.map_x(tick);
            line([x, top, x, bottom], &theme.grid_color);
            line([x, bottom, x, bottom + 5.0], &theme.tick_color);
            labels.push(words(label, (x, bottom + 5.0 + f64::from(TICK)), TICK, TextAnchor::Middle, None));
        }
        for (tick, label) in self.y.between_decades() {
            let y = self.places.map_y(tick);
            line([left, y, right, y], &theme.grid_color);
            line([left - 5.0, y, left, y], &theme.tick_color);
            labels.push(words(label, (left - 8.0, y + 0.35 * f64::from(TICK)), TICK, TextAnchor::End, None));
        }
        labels.into_iter().for_each(|label| scene.add(label));
    }

    fn add_areas(&self, scene: &mut Scene) {
        for area in &self.view.chart.areas {
            let corners: Vec<[f64; 2]> = area.corners.iter().map(|&p| self.scaled(p)).collect();
            let corners = self.frame().polygon(corners);
            if corners.len() < 3 {
                continue;
            }
            let places: Vec<String> =
                corners.iter().map(|&corner| self.at(corner)).map(|(x, y)| format!("{x:.2} {y:.2}")).collect();
            scene.add(Primitive::Path(Box::new(PathData {
                d: format!("M {} Z", places.join(" L ")),
                fill: Some(self.theme.stroke(area.colour, false)),
                stroke: Color::None,
                stroke_width: 0.0,
                opacity: Some(THIN),
                stroke_dasharray: None,
            })));
        }
    }

    fn add_curves(&self, scene: &mut Scene) {
        for (curve, &colour) in self.view.chart.curves.iter().zip(&self.colours) {
            let stroke = self.theme.stroke(colour, curve.pale);
            for piece in self.frame().pieces(curve.points.iter().map(|&p| self.scaled(p))) {
                let points: Vec<(f64, f64)> = piece.into_iter().map(|p| self.at(p)).collect();
                match points[..] {
                    [place] => scene.add(symbol::disc(place, curve.width, stroke.clone(), self.ground(), 1.0)),
                    _ => scene.add(Primitive::PolyLine {
                        points,
                        stroke: stroke.clone(),
                        stroke_width: curve.width,
                        stroke_dasharray: curve.dash.pattern(),
                    }),
                }
            }
        }
    }

    fn add_markers(&self, scene: &mut Scene) {
        let chart = self.view.chart;
        for (marker, &colour) in chart.markers.iter().zip(&self.colours[chart.curves.len()..]) {
            let point = self.scaled((marker.x, marker.y));
            if self.frame().holds(point) {
                let colour = self.theme.stroke(colour, false);
                scene.add(symbol::marker(marker.shape, self.at(point), marker.hollow, colour, self.ground()));
            }
        }
    }

    fn add_notes(&self, scene: &mut Scene) {
        for note in &self.view.chart.notes {
            let point = self.scaled((note.x, note.y));
            if !self.frame().holds(point) {
                continue;
            }
            let (x, y) = self.at(point);
            let (dx, dy, anchor) = match note.side {
                Side::Right => (8.0, 4.0, TextAnchor::Start),
                Side::Left => (-8.0, 4.0, TextAnchor::End),
                Side::Above => (0.0, -9.0, TextAnchor::Middle),
                Side::Below => (0.0, 17.0, TextAnchor::Middle),
            };
            let color = note.colour.map(|colour| self.theme.stroke(colour, false));
            let content = text::clean(&note.words);
            let (x, y) = (x + dx, y + dy);
            scene.add(Primitive::Text { x, y, content, size: TICK, anchor, rotate: None, bold: false, color });
        }
    }
}

pub(super) fn words(
    content: String,
    (x, y): (f64, f64),
    size: u32,
    anchor: TextAnchor,
    rotate: Option<f64>,
) -> Primitive {
    Primitive::Text { x, y, content, size, anchor, rotate, bold: false, color: None }
}

/// What the axes show.
pub(super) fn windows(View { chart, raster }: View<'_>) -> (Window, Window) {
    #[allow(clippy::cast_precision_loss, reason = "fewer cells than 2⁵³")]
    let sides = raster.map(|r| (r.columns as f64, r.cells.len().checked_div(r.columns).unwrap_or(0) as f64));
    let window = |axis: &Axis, side: Option<f64>, of: fn((f64, f64)) -> f64| match (axis.fixed(), side) {
        (Some((a, b)), _) => axis.window(a, b),
        (None, Some(side)) => Window::exact(0.0, side),
        (None, None) => {
            // A point counts where both its numbers do.
            let curves = chart.curves.iter().flat_map(|curve| curve.points.iter().copied());
            let points = curves.chain(chart.markers.iter().map(|marker| (marker.x, marker.y)));
            axis.window_around(points.filter(|(x, y)| x.is_finite() && y.is_finite()).map(of))
        }
    };
    (window(&chart.x, sides.map(|s| s.0), |p| p.0), window(&chart.y, sides.map(|s| s.1), |p| p.1))
}

fn layout(chart: &Chart, x: &Window, y: &Window, is_field: bool, theme: Theme) -> Layout {
    let (width, height) = chart.size;
    let mut layout = Layout::new((x.low, x.high), (y.low, y.high))
        .with_x_axis_min(x.low)
        .with_x_axis_max(x.high)
        .with_y_axis_min(y.low)
        .with_y_axis_max(y.high)
        .with_x_tick_format(x.format())
        .with_y_tick_format(y.format())
        .with_ticks(TICKS)
        .with_theme(theme.kuva())
        .with_show_grid(!is_field)
        .with_box_axes()
        .with_x_label_overlap(AxisLabelOverlap::Thin)
        .with_title_size(TITLE)
        .with_label_size(LABEL)
        .with_tick_size(TICK)
        .with_title_wrap(text::fitting(width, TITLE))
        .with_x_label_wrap(text::fitting(width, LABEL))
        .with_y_label_wrap(text::fitting(height, LABEL));
    if let Some(step) = x.step {
        layout = layout.with_x_tick_step(step);
    }
    if let Some(step) = y.step {
        layout = layout.with_y_tick_step(step);
    }
    for (text, label) in [
        (text::clean(&chart.title), &mut layout.title),
        (chart.x.label(x), &mut layout.x_label),
        (chart.y.label(y), &mut layout.y_label),
    ] {
        *label = (!text.is_empty()).then_some(text);
    }
    layout
}

/// The palette's number of every curve, then of every marker: one for each name, and each without a name its own.
pub(super) fn colours(chart: &Chart) -> Vec<usize> {
    let curves = chart.curves.iter().map(|c| (c.name.as_str(), c.colour));
    let all: Vec<(&str, Option<usize>)> =
        curves.chain(chart.markers.iter().map(|m| (m.name.as_str(), m.colour))).collect();
    let taken: BTreeSet<usize> = all.iter().filter_map(|(_, colour)| *colour).collect();
    let free: Vec<usize> = (0..palette::LINES.len()).filter(|i| !taken.contains(i)).collect();
    let mut free = free.into_iter().cycle();
    let mut named: BTreeMap<&str, usize> = BTreeMap::new();
    let mut colours = Vec::with_capacity(all.len());
    for (name, colour) in all {
        let own = colour.map(|c| c % palette::LINES.len());
        let colour = own.or_else(|| named.get(name).copied()).unwrap_or_else(|| free.next().unwrap_or(0));
        if !name.is_empty() {
            named.entry(name).or_insert(colour);
        }
        colours.push(colour);
    }
    colours
}

/// The names of areas, curves and markers, each way of drawing once.
fn entries(chart: &Chart, colours: &[usize], theme: Theme, legend: &mut Vec<Entry>) {
    let curves = chart.curves.iter().map(|c| (&c.name, Sample::Line { dash: c.dash, width: c.width }, c.pale));
    let markers = chart.markers.iter().map(|m| (&m.name, Sample::Marker { shape: m.shape, hollow: m.hollow }, false));
    let areas = chart.areas.iter().map(|a| ((&a.name, Sample::Area, false), a.colour % palette::LINES.len()));
    let mut seen: Vec<(&str, Sample, bool, usize)> = Vec::new();
    for ((name, sample, pale), colour) in curves.chain(markers).zip(colours.iter().copied()).chain(areas) {
        let kind = (name.as_str(), sample, pale, colour);
        if !name.is_empty() && !seen.contains(&kind) {
            seen.push(kind);
            legend.push(Entry { label: text::name(name), colour: theme.stroke(colour, pale), sample });
        }
    }
}
