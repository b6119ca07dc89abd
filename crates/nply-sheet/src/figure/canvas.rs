//! A drawing that is no chart: strokes, areas and words, on light or dark ground.

use core::fmt::Write as _;

use base64::Engine as _;

use crate::plot::Theme;
use crate::plot::theme::{hex, mixed};

/// What letters are drawn in.
const FONT: &str = "DejaVu Sans, Verdana, Liberation Sans, Arial, sans-serif";

/// A drawing; x to the right, y down, in pixels.
pub(super) struct Canvas {
    theme: Theme,
    body: String,
    width: f64,
    height: f64,
}

/// How an outline is drawn.
#[derive(Clone, Debug)]
pub(super) struct Pen {
    pub(super) colour: [u8; 3],
    pub(super) width: f64,
    pub(super) dash: &'static str,
}

impl Pen {
    pub(super) fn new(colour: [u8; 3], width: f64) -> Self {
        Self { colour, width, dash: "" }
    }

    pub(super) fn dashed(mut self, dash: &'static str) -> Self {
        self.dash = dash;
        self
    }

    fn attributes(&self) -> String {
        let dash = if self.dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", self.dash) };
        format!(
            "stroke=\"{}\" stroke-width=\"{:.2}\" stroke-linecap=\"round\" stroke-linejoin=\"round\"{dash}",
            hex(self.colour),
            self.width
        )
    }
}

/// Where words stand by their place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Canvas {
    pub(super) fn new(width: f64, height: f64, theme: Theme) -> Self {
        Self { theme, body: String::new(), width, height }
    }

    pub(super) fn line_colour(&self, i: usize) -> [u8; 3] {
        self.theme.line(i, false)
    }

    pub(super) fn ink(&self) -> [u8; 3] {
        self.theme.ink()
    }

    pub(super) fn grey(&self) -> [u8; 3] {
        self.theme.grey()
    }

    pub(super) fn ground(&self) -> [u8; 3] {
        self.theme.ground()
    }

    /// A colour with a share of the ground's.
    pub(super) fn washed(&self, colour: [u8; 3], share: f64) -> [u8; 3] {
        mixed(colour, self.theme.ground(), share)
    }

    pub(super) fn line(&mut self, points: &[[f64; 2]], pen: &Pen) {
        let _ = writeln!(self.body, "<polyline points=\"{}\" fill=\"none\" {}/>", joined(points), pen.attributes());
    }

    /// A stroke whose ends are cut straight.
    pub(super) fn flat(&mut self, points: &[[f64; 2]], pen: &Pen) {
        let stroke = pen.attributes().replace("round\" stroke-linejoin", "butt\" stroke-linejoin");
        let _ = writeln!(self.body, "<polyline points=\"{}\" fill=\"none\" {stroke}/>", joined(points));
    }

    pub(super) fn polygon(&mut self, points: &[[f64; 2]], fill: [u8; 3], pen: Option<&Pen>) {
        let stroke = pen.map(Pen::attributes).unwrap_or_default();
        let _ = writeln!(self.body, "<polygon points=\"{}\" fill=\"{}\" {stroke}/>", joined(points), hex(fill));
    }

    pub(super) fn circle(&mut self, [x, y]: [f64; 2], r: f64, pen: &Pen) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{r:.2}\" fill=\"none\" {}/>",
            pen.attributes()
        );
    }

    /// A line with a head at its end.
    pub(super) fn arrow(&mut self, points: &[[f64; 2]], pen: &Pen) {
        self.line(points, pen);
        if let [.., from, tip] = points {
            self.head(*from, *tip, 4.0 + 2.2 * pen.width, pen.colour);
        }
    }

    /// The head of an arrow that comes from `from`, its tip at `tip`.
    pub(super) fn head(&mut self, from: [f64; 2], tip: [f64; 2], size: f64, colour: [u8; 3]) {
        let (dx, dy) = (tip[0] - from[0], tip[1] - from[1]);
        let length = libm::hypot(dx, dy).max(1e-9);
        let (dx, dy) = (dx / length, dy / length);
        let back = [tip[0] - size * dx, tip[1] - size * dy];
        let side = 0.42 * size;
        let corners = [tip, [back[0] - side * dy, back[1] + side * dx], [back[0] + side * dy, back[1] - side * dx]];
        self.polygon(&corners, colour, None);
    }

    pub(super) fn words(&mut self, text: &str, [x, y]: [f64; 2], size: f64, anchor: Anchor, colour: [u8; 3]) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = writeln!(
            self.body,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{}\">{}</text>",
            hex(colour),
            lowered(&escaped(text), size)
        );
    }

    /// A PNG that fills a rectangle: left, top, width, height.
    pub(super) fn image(&mut self, png: &[u8], [x, y, width, height]: [f64; 4]) {
        let data = base64::engine::general_purpose::STANDARD.encode(png);
        let _ = writeln!(
            self.body,
            "<image x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" href=\"data:image/png;base64,{data}\"/>"
        );
    }

    pub(super) fn svg(self, label: &str) -> String {
        let Self { theme, body, width, height } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
             font-family=\"{FONT}\" role=\"img\" aria-label=\"{}\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"{}\"/>\n{body}</svg>",
            escaped(label),
            hex(theme.ground()),
        )
    }
}

/// What follows an underline, one letter or all in braces, set low and small: `ψ_L`, `E_{12}`.
fn lowered(text: &str, size: f64) -> String {
    let mut parts = text.split('_');
    let mut set = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.chars().next().map_or(0, char::len_utf8);
        let (low, rest) = match part.strip_prefix('{').and_then(|part| part.split_once('}')) {
            Some(split) => split,
            None => part.split_at(end),
        };
        let drop = 0.22 * size;
        let _ = write!(set, "<tspan dy=\"{drop:.2}\" font-size=\"{:.1}\">{low}</tspan>", 0.72 * size);
        if !rest.is_empty() {
            let _ = write!(set, "<tspan dy=\"-{drop:.2}\">{rest}</tspan>");
        }
    }
    set
}

fn joined(points: &[[f64; 2]]) -> String {
    points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
