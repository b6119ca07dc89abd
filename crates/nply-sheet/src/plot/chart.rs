//! Curves and points over one pair of axes.

use super::{Axis, Theme, picture};

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
    pub areas: Vec<Area>,
    /// What is drawn over the areas.
    pub curves: Vec<Curve>,
    /// What is drawn over the curves.
    pub markers: Vec<Marker>,
    /// Words beside places.
    pub notes: Vec<Note>,
    /// Whether the names stand in a list on the right of the axes.
    pub legend: bool,
    /// Width and height between the axes, in pixels.
    pub size: (f64, f64),
}

/// Between the axes, in pixels.
const SIZE: (f64, f64) = (460.0, 340.0);

impl Chart {
    /// Empty axes, with a legend as soon as something has a name.
    #[must_use]
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            areas: Vec::new(),
            curves: Vec::new(),
            markers: Vec::new(),
            notes: Vec::new(),
            legend: true,
            size: SIZE,
        }
    }

    /// The same with one area more.
    #[must_use]
    pub fn with_area(mut self, area: Area) -> Self {
        self.areas.push(area);
        self
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

    /// The same with words at a place.
    #[must_use]
    pub fn with_note(mut self, note: Note) -> Self {
        self.notes.push(note);
        self
    }

    /// The same with another width and height between the axes, in pixels; what is not a size (at least 40, at most 4000) is not taken.
    #[must_use]
    pub fn with_size(mut self, width: f64, height: f64) -> Self {
        let is_size = |side: f64| (40.0..=4000.0).contains(&side);
        if is_size(width) && is_size(height) {
            self.size = (width, height);
        }
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
        self.svg_in(Theme::Light)
    }

    /// The same on light or dark ground.
    #[must_use]
    pub fn svg_in(&self, theme: Theme) -> String {
        picture::draw(&[self.view()], picture::Arrangement::ROW, theme)
    }

    pub(super) fn view(&self) -> picture::View<'_> {
        picture::View { chart: self, raster: None }
    }
}

/// A curve through points in their order; it may turn back on itself.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Curve {
    /// Its name in the legend; empty for none. Curves and markers of one name share colour and entry.
    pub name: String,
    /// Its points in the axes' units. A point that is not finite leaves a gap.
    pub points: Vec<(f64, f64)>,
    /// How its stroke is broken.
    pub dash: Dash,
    /// The stroke's width in pixels; 2 as a rule.
    pub width: f64,
    /// Whether its colour is mixed with the ground's.
    pub pale: bool,
    /// Its number in the palette (counted round); `None` for the next that is free.
    pub colour: Option<usize>,
}

/// How a stroke is broken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Dash {
    /// Not at all.
    #[default]
    Solid,
    /// Into dashes.
    Dashed,
    /// Into dots.
    Dotted,
    /// Into dashes and dots in turn.
    DashDotted,
}

impl Curve {
    /// A solid curve.
    #[must_use]
    pub fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let points = points.into_iter().collect();
        Self { name: name.into(), points, dash: Dash::Solid, width: 2.0, pale: false, colour: None }
    }

    /// The same, dashed.
    #[must_use]
    pub fn dashed(self) -> Self {
        self.with_dash(Dash::Dashed)
    }

    /// The same, its stroke broken in a certain way.
    #[must_use]
    pub fn with_dash(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }

    /// The same with a stroke of another width, in pixels; not wider than 20.
    #[must_use]
    pub fn with_width(mut self, width: f64) -> Self {
        if (0.1..=20.0).contains(&width) {
            self.width = width;
        }
        self
    }

    /// The same in a paler colour.
    #[must_use]
    pub fn pale(mut self) -> Self {
        self.pale = true;
        self
    }

    /// The same in a certain colour of the palette: 0 blue, 1 vermilion, 2 green, 3 purple, 4 orange, 5 sky blue, 6 black (white on dark ground).
    #[must_use]
    pub fn with_colour(mut self, colour: usize) -> Self {
        self.colour = Some(colour);
        self
    }
}

/// A polygon, filled so thinly that what lies over it stays clear.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Area {
    /// Its name in the legend; empty for none.
    pub name: String,
    /// Its corners in the axes' units; what lies beyond the axes is cut off. Without three finite corners it is not drawn.
    pub corners: Vec<(f64, f64)>,
    /// Its number in the palette (counted round).
    pub colour: usize,
}

impl Area {
    /// A polygon in a colour of the palette.
    #[must_use]
    pub fn new(name: impl Into<String>, corners: impl IntoIterator<Item = (f64, f64)>, colour: usize) -> Self {
        Self { name: name.into(), corners: corners.into_iter().collect(), colour }
    }
}

/// Words beside a place.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Note {
    /// The words.
    pub words: String,
    /// The place, in the axis' unit. A note that is not finite or out of the axes is not written.
    pub x: f64,
    /// The place, in the axis' unit.
    pub y: f64,
    /// On which side of the place the words stand.
    pub side: Side,
    /// Its number in the palette (counted round); `None` for the colour of text.
    pub colour: Option<usize>,
}

/// A side of a place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "sides as they are called")]
pub enum Side {
    #[default]
    Right,
    Left,
    Above,
    Below,
}

impl Note {
    /// Words on one side of a place.
    #[must_use]
    pub fn new(words: impl Into<String>, x: f64, y: f64, side: Side) -> Self {
        Self { words: words.into(), x, y, side, colour: None }
    }

    /// The same in a colour of the palette.
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
    /// Whether it is an outline only.
    pub hollow: bool,
    /// Its number in the palette (counted round); `None` for the next that is free.
    pub colour: Option<usize>,
}

impl Marker {
    /// A marker in the next free colour.
    #[must_use]
    pub fn new(name: impl Into<String>, x: f64, y: f64, shape: MarkerShape) -> Self {
        Self { name: name.into(), x, y, shape, hollow: false, colour: None }
    }

    /// The same as an outline.
    #[must_use]
    pub fn hollow(mut self) -> Self {
        self.hollow = true;
        self
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
