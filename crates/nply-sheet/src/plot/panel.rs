//! One pair of axes, drawn.

use std::collections::{BTreeMap, BTreeSet};

use kuva::plot::scatter::MarkerShape as Kuva;
use kuva::plot::{LegendEntry, LegendShape};
use kuva::render::axis::{add_axes_and_grid, add_labels_and_title};
use kuva::render::color::Color;
use kuva::render::layout::{AxisLabelOverlap, ComputedLayout, Layout};
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor, render_legend_at};
use kuva::render::render_utils::generate_ticks;

use super::axis::{TICKS, Window};
use super::clip::Frame;
use super::picture::{View, add_image};
use super::raster::{self, Meaning};
use super::{Axis, Chart, ColourMap, MarkerShape, palette, text};

/// The inside of the axes, in pixels.
const INSIDE: (f64, f64) = (460.0, 340.0);
const TITLE: u32 = 16;
const LABEL: u32 = 14;
const TICK: u32 = 12;
/// Between the axes and what stands on their right.
const GAP: f64 = 18.0;
/// The colour bar's width.
const BAR: f64 = 16.0;
/// Dashes and the gaps between them.
const DASH: &str = "5 3";
/// The names a legend has room for.
const NAMES: usize = 17;

/// A panel with its places found.
pub(super) struct Drawing<'a> {
    view: View<'a>,
    x: Window,
    y: Window,
    layout: Layout,
    places: ComputedLayout,
    bar: Option<Bar>,
    colours: Vec<usize>,
    legend: Vec<LegendEntry>,
}

/// A colour bar with its labels.
struct Bar {
    map: ColourMap,
    window: Window,
    ticks: Vec<(f64, String)>,
    label: String,
    digits: f64,
}

impl Bar {
    fn of(axis: &Axis, map: ColourMap) -> Option<Self> {
        let (low, high) = axis.fixed()?;
        let window = Window::exact(low, high);
        let format = window.format();
        let ticks: Vec<(f64, String)> =
            generate_ticks(window.low, window.high, TICKS).into_iter().map(|t| (t, format.format(t))).collect();
        let digits = ticks.iter().map(|(_, t)| text::width(t, f64::from(TICK))).fold(0.0, f64::max);
        let label = axis.label(&window);
        Some(Self { map, window, ticks, label, digits })
    }

    fn width(&self) -> f64 {
        let label = if self.label.is_empty() { 0.0 } else { 8.0 + f64::from(LABEL) };
        GAP + BAR + 8.0 + self.digits + label
    }
}

impl<'a> Drawing<'a> {
    pub(super) fn of(view: View<'a>) -> Self {
        let chart = view.chart;
        let (x, y) = windows(view);
        let colours = colours(chart);
        let mut legend = Vec::new();
        let mut bar = None;
        match view.raster.map(|raster| &raster.meaning) {
            Some(Meaning::Values { bar: axis, map }) => bar = Bar::of(axis, *map),
            Some(Meaning::Categories(names)) => legend.extend(names.iter().enumerate().map(|(i, name)| LegendEntry {
                label: text::name(name),
                color: hex(raster::area(i)),
                shape: LegendShape::Rect,
                dasharray: None,
            })),
            None => {}
        }
        if chart.legend {
            entries(chart, &colours, &mut legend);
        }
        if legend.len() > NAMES {
            let more = format!("… and {} more", legend.len() + 1 - NAMES);
            legend.truncate(NAMES - 1);
            legend.push(LegendEntry {
                label: more,
                color: "none".to_owned(),
                shape: LegendShape::Rect,
                dasharray: None,
            });
        }
        let layout = layout(chart, &x, &y, view.raster.is_some());
        let mut places = ComputedLayout::from_layout(&layout);
        places.margin_left += 6.0;
        let names = legend.iter().map(|entry| text::width(&entry.label, f64::from(TICK))).fold(0.0, f64::max);
        let side = bar.as_ref().map_or(0.0, Bar::width) + if legend.is_empty() { 0.0 } else { GAP + 25.0 + names };
        places.margin_right = places.margin_right.max(side + 12.0);
        let mut drawing = Self { view, x, y, layout, places, bar, colours, legend };
        drawing.fit();
        drawing
    }

    /// The picture's size follows from the margins.
    fn fit(&mut self) {
        let places = &mut self.places;
        places.width = places.margin_left + INSIDE.0 + places.margin_right;
        places.height = places.margin_top + INSIDE.1 + places.margin_bottom;
        places.recompute_transforms();
    }

    /// Axes above each other begin and end at the same places.
    pub(super) fn align_sides(drawings: &mut [Self]) {
        let widest = |of: fn(&Self) -> f64| drawings.iter().map(of).fold(0.0, f64::max);
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
        self.places.margin_left + INSIDE.0
    }

    pub(super) fn add_to(&self, scene: &mut Scene, images: &mut Vec<String>) {
        if let Some(raster) = self.view.raster {
            let runs_back = |axis: &Axis| axis.fixed().is_some_and(|(from, to)| from > to);
            let mirrored = [runs_back(&self.view.chart.x), runs_back(&self.view.chart.y)];
            if let Some(png) = raster.png(mirrored) {
                let place = [self.places.margin_left, self.places.margin_top, INSIDE.0, INSIDE.1];
                add_image(scene, images, raster::element(&png, place));
            }
        }
        add_axes_and_grid(scene, &self.places, &self.layout);
        self.add_curves(scene);
        self.add_markers(scene);
        add_labels_and_title(scene, &self.places, &self.layout);
        let mut side = self.right() + GAP;
        if let Some(bar) = &self.bar {
            self.add_bar(bar, side, scene, images);
            side += bar.width();
        }
        if !self.legend.is_empty() {
            let (x, y) = (side - 5.0, self.places.margin_top + 4.0);
            render_legend_at(&self.legend, None, None, false, scene, x, y, 0.0, TICK, &self.places.theme);
        }
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

    fn add_curves(&self, scene: &mut Scene) {
        for (curve, &colour) in self.view.chart.curves.iter().zip(&self.colours) {
            for piece in self.frame().pieces(curve.points.iter().map(|&p| self.scaled(p))) {
                let points: Vec<(f64, f64)> = piece.into_iter().map(|p| self.at(p)).collect();
                match points[..] {
                    [(cx, cy)] => scene.add(disc(cx, cy, 2.0, colour)),
                    _ => scene.add(Primitive::PolyLine {
                        points,
                        stroke: line_colour(colour),
                        stroke_width: 2.0,
                        stroke_dasharray: curve.dashed.then(|| DASH.to_owned()),
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
                scene.add(symbol(marker.shape, self.at(point), colour));
            }
        }
    }

    fn add_bar(&self, bar: &Bar, x: f64, scene: &mut Scene, images: &mut Vec<String>) {
        let (top, height) = (self.places.margin_top, INSIDE.1);
        if let Some(png) = raster::bar(bar.map) {
            add_image(scene, images, raster::element(&png, [x, top, BAR, height]));
        }
        scene.add(Primitive::Rect {
            x,
            y: top,
            width: BAR,
            height,
            fill: Color::None,
            stroke: Some(Color::Rgb(0, 0, 0)),
            stroke_width: Some(1.0),
            opacity: None,
        });
        for (value, label) in &bar.ticks {
            let y = top + height * (bar.window.high - value) / (bar.window.high - bar.window.low);
            scene.add(Primitive::Line {
                x1: x + BAR,
                y1: y,
                x2: x + BAR + 5.0,
                y2: y,
                stroke: Color::Rgb(0, 0, 0),
                stroke_width: 1.0,
                stroke_dasharray: None,
            });
            let place = (x + BAR + 8.0, y + 0.35 * f64::from(TICK));
            scene.add(words(label.clone(), place, TICK, TextAnchor::Start, None));
        }
        let place = (x + bar.width() - GAP, top + height / 2.0);
        scene.add(words(bar.label.clone(), place, LABEL, TextAnchor::Middle, Some(-90.0)));
    }
}

fn words(content: String, (x, y): (f64, f64), size: u32, anchor: TextAnchor, rotate: Option<f64>) -> Primitive {
    Primitive::Text { x, y, content, size, anchor, rotate, bold: false, color: None }
}

/// What the axes show.
fn windows(View { chart, raster }: View<'_>) -> (Window, Window) {
    #[allow(clippy::cast_precision_loss, reason = "fewer cells than 2⁵³")]
    let sides = raster.map(|r| (r.columns as f64, r.cells.len().checked_div(r.columns).unwrap_or(0) as f64));
    let window = |axis: &Axis, side: Option<f64>, of: fn((f64, f64)) -> f64| match (axis.fixed(), side) {
        (Some((a, b)), _) => Window::exact(a, b),
        (None, Some(side)) => Window::exact(0.0, side),
        (None, None) => {
            // A point counts where both its numbers do.
            let curves = chart.curves.iter().flat_map(|curve| curve.points.iter().copied());
            let points = curves.chain(chart.markers.iter().map(|marker| (marker.x, marker.y)));
            Window::around(points.filter(|(x, y)| x.is_finite() && y.is_finite()).map(of))
        }
    };
    (window(&chart.x, sides.map(|s| s.0), |p| p.0), window(&chart.y, sides.map(|s| s.1), |p| p.1))
}

fn layout(chart: &Chart, x: &Window, y: &Window, is_field: bool) -> Layout {
    let mut layout = Layout::new((x.low, x.high), (y.low, y.high))
        .with_x_axis_min(x.low)
        .with_x_axis_max(x.high)
        .with_y_axis_min(y.low)
        .with_y_axis_max(y.high)
        .with_x_tick_format(x.format())
        .with_y_tick_format(y.format())
        .with_ticks(TICKS)
        .with_show_grid(!is_field)
        .with_box_axes()
        .with_x_label_overlap(AxisLabelOverlap::Thin)
        .with_title_size(TITLE)
        .with_label_size(LABEL)
        .with_tick_size(TICK)
        .with_title_wrap(text::fitting(INSIDE.0, TITLE))
        .with_x_label_wrap(text::fitting(INSIDE.0, LABEL))
        .with_y_label_wrap(text::fitting(INSIDE.1, LABEL));
    layout.theme.grid_color = "#e4e4e4".to_owned();
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
fn colours(chart: &Chart) -> Vec<usize> {
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

/// The names of curves and markers, each way of drawing once.
fn entries(chart: &Chart, colours: &[usize], legend: &mut Vec<LegendEntry>) {
    let mut seen = BTreeSet::new();
    let curves = chart.curves.iter().map(|c| (&c.name, LegendShape::Line, usize::from(c.dashed)));
    let markers = chart.markers.iter().map(|m| (&m.name, LegendShape::Marker(kuva(m.shape)), 2 + m.shape as usize));
    for ((name, shape, kind), &colour) in curves.chain(markers).zip(colours) {
        if !name.is_empty() && seen.insert((name.as_str(), kind, colour)) {
            let dasharray = (kind == 1).then(|| DASH.to_owned());
            legend.push(LegendEntry { label: text::name(name), color: hex(palette::LINES[colour]), shape, dasharray });
        }
    }
}

fn kuva(shape: MarkerShape) -> Kuva {
    match shape {
        MarkerShape::Circle => Kuva::Circle,
        MarkerShape::Square => Kuva::Square,
        MarkerShape::Triangle => Kuva::Triangle,
        MarkerShape::Diamond => Kuva::Diamond,
        MarkerShape::Cross => Kuva::Cross,
        MarkerShape::Plus => Kuva::Plus,
    }
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn line_colour(colour: usize) -> Color {
    let [r, g, b] = palette::LINES[colour % palette::LINES.len()];
    Color::Rgb(r, g, b)
}

fn disc(cx: f64, cy: f64, r: f64, colour: usize) -> Primitive {
    Primitive::Circle {
        cx,
        cy,
        r,
        fill: line_colour(colour),
        fill_opacity: None,
        stroke: Some(Color::Rgb(255, 255, 255)),
        stroke_width: Some(1.0),
    }
}

/// A marker, with a white rim so that it stands off from what is below.
fn symbol(shape: MarkerShape, (x, y): (f64, f64), colour: usize) -> Primitive {
    let path = |corners: &[(f64, f64)], joins: &str| {
        let mut d = String::new();
        for (i, (dx, dy)) in corners.iter().enumerate() {
            let letter = if i == 0 || (joins.is_empty() && i % 2 == 0) { 'M' } else { 'L' };
            d += &format!("{letter} {:.2} {:.2} ", x + 5.0 * dx, y + 5.0 * dy);
        }
        let is_area = !joins.is_empty();
        Primitive::Path(Box::new(PathData {
            d: d + joins,
            fill: is_area.then(|| line_colour(colour)),
            stroke: if is_area { Color::Rgb(255, 255, 255) } else { line_colour(colour) },
            stroke_width: if is_area { 1.0 } else { 2.0 },
            opacity: None,
            stroke_dasharray: None,
        }))
    };
    match shape {
        MarkerShape::Circle => disc(x, y, 5.0, colour),
        MarkerShape::Square => path(&[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)], "Z"),
        MarkerShape::Triangle => path(&[(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)], "Z"),
        MarkerShape::Diamond => path(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)], "Z"),
        MarkerShape::Cross => path(&[(-0.9, -0.9), (0.9, 0.9), (-0.9, 0.9), (0.9, -0.9)], ""),
        MarkerShape::Plus => path(&[(-1.2, 0.0), (1.2, 0.0), (0.0, -1.2), (0.0, 1.2)], ""),
    }
}
