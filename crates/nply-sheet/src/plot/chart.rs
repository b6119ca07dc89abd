//! Curves and points over one pair of axes.

use super::{Axis, picture};

/// One pair of axes with curves and points.
///
/// ```
/// use nply_sheet::plot::{Axis, Chart, Curve, Marker, MarkerShape};
/// let chart = Chart::new("Untwisting", Axis::new("end moment", "N m"), Axis::new("helical angle", "deg"))
///     .with_curve(Curve::new("stable", [(0.0, 30.0), (1e-3, 34.0)]).with_colour(0))
///     .with_curve(Curve::new("unstable", [(1e-3, 34.0), (0.5e-3, 40.0)]).with_colour(0).dashed())
///     .with_marker(Marker::new("fold", 1e-3, 34.0, MarkerShape::Diamond));
/// assert!(chart.svg().starts_with("<svg "));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Chart {
    /// The line above; empty for none.
    pub title: String,
    /// The axis below.
    pub x: Axis,
    /// The axis on the left.
    pub y: Axis,
    /// What is drawn first.
    pub curves: Vec<Curve>,
    /// What is drawn over the curves.
    pub markers: Vec<Marker>,
    /// Whether the names stand in a list on the right of the axes.
    pub legend: bool,
}

impl Chart {
    /// Empty axes, with a legend as soon as something has a name.
    #[must_use]
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self { title: title.into(), x, y, curves: Vec::new(), markers: Vec::new(), legend: true }
    }

    /// The same with one curve more.
    #[must_use]
    pub fn with_curve(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// The same with one point more.
    #[must_use]
    pub fn with_marker(mut self, marker: Marker) -> Self {
        self.markers.push(marker);
        self
    }

    /// The same without a list of names.
    #[must_use]
    pub fn without_legend(mut self) -> Self {
        self.legend = false;
        self
    }

    /// The chart as a picture of its own.
    #[must_use]
    pub fn svg(&self) -> String {
        picture::draw(&[self.view()], picture::Direction::Row)
    }

    pub(super) fn view(&self) -> picture::View<'_> {
        picture::View { chart: self, raster: None }
    }
}

/// A curve through points in their order; it may turn back on itself.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Curve {
    /// Its name in the legend; empty for none. Curves and markers of one name share colour and entry.
    pub name: String,
    /// Its points in the axes' units. A point that is not finite leaves a gap.
    pub points: Vec<(f64, f64)>,
    /// Whether it is dashed.
    pub dashed: bool,
    /// Its number in the palette (counted round); `None` for the next that is free.
    pub colour: Option<usize>,
}

impl Curve {
    /// A solid curve.
    #[must_use]
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Self { name: name.into(), points: points.into_iter().collect(), dashed: false, colour: None }
    }

    /// The same, dashed.
    #[must_use]
    pub fn dashed(mut self) -> Self {
        self.dashed = true;
        self
    }

    /// The same in a certain colour of the palette: 0 blue, 1 vermilion, 2 green, 3 purple, 4 orange, 5 sky blue, 6 black.
    #[must_use]
    pub fn with_colour(mut self, colour: usize) -> Self {
        self.colour = Some(colour);
        self
    }
}

/// A point that deserves attention.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Marker {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// Where it stands, in the axis' unit. A marker that is not finite or out of the axes is not drawn.
    pub x: f64,
    /// Where it stands, in the axis' unit.
    pub y: f64,
    /// What it looks like.
    pub shape: MarkerShape,
    /// Its number in the palette (counted round); `None` for the next that is free.
    pub colour: Option<usize>,
}

impl Marker {
    /// A marker in the next free colour.
    #[must_use]
    pub fn new(name: impl Into<String>, x: f64, y: f64, shape: MarkerShape) -> Self {
        Self { name: name.into(), x, y, shape, colour: None }
    }

    /// The same in a certain colour of the palette, as of [`Curve::with_colour`].
    #[must_use]
    pub fn with_colour(mut self, colour: usize) -> Self {
        self.colour = Some(colour);
        self
    }
}

/// What a marker looks like.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum MarkerShape {
    /// A disc.
    #[default]
    Circle,
    /// A square.
    Square,
    /// A triangle, point up.
    Triangle,
    /// A square on its corner.
    Diamond,
    /// Two strokes, ×.
    Cross,
    /// Two strokes, +.
    Plus,
}
