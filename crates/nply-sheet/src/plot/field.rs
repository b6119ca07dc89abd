//! A raster over a rectangle.

use super::raster::Raster;
use super::{Axis, Chart, ColourMap, Curve, Marker, Theme, picture};

/// A quantity, or a category, over a rectangle of cells, with curves and points over it.
///
/// The cells come in rows from the bottom to the top, each row from left to right; cells that do not fill a row are left
/// out. The axes' ranges are the rectangle's sides, outer edge to outer edge; without a range a cell has size 1. An axis
/// whose range is given from the larger to the smaller number is drawn rising all the same, and the cells with it.
///
/// ```
/// use nply_sheet::plot::{Axis, Field};
/// let x = Axis::new("end force", "N").with_range(0.0, 2.0);
/// let y = Axis::new("end moment", "N m").with_range(-1.0, 1.0);
/// let field = Field::of_values("Pressure", x, y, 2, &[0.5, 1.5, f64::NAN, 2.5], Axis::new("p", "N/m"));
/// assert!(field.svg().contains("data:image/png;base64,"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    chart: Chart,
    raster: Raster,
}

impl Field {
    /// Numbers, with a colour bar `bar` (its range: the colours' limits). NaN is nothing there; numbers beyond the limits
    /// have the limits' colours.
    #[must_use]
    pub fn of_values(title: impl Into<String>, x: Axis, y: Axis, columns: usize, values: &[f64], bar: Axis) -> Self {
        let raster = Raster::of_values(columns, values, bar, ColourMap::Sequential);
        Self { chart: Chart::new(title, x, y), raster }
    }

    /// Numbers about zero: as [`Field::of_values`] in the colours of [`ColourMap::Diverging`].
    #[must_use]
    pub fn of_signed_values(
        title: impl Into<String>,
        x: Axis,
        y: Axis,
        columns: usize,
        values: &[f64],
        bar: Axis,
    ) -> Self {
        let raster = Raster::of_values(columns, values, bar, ColourMap::Diverging);
        Self { chart: Chart::new(title, x, y), raster }
    }

    /// Categories by their number, with a legend of `names`. A number that has no name (255 never has) is nothing there.
    #[must_use]
    pub fn of_categories<N: Into<String>>(
        title: impl Into<String>,
        x: Axis,
        y: Axis,
        columns: usize,
        numbers: &[u8],
        names: impl IntoIterator<Item = N>,
    ) -> Self {
        let raster = Raster::of_categories(columns, numbers, names.into_iter().map(Into::into).collect());
        Self { chart: Chart::new(title, x, y), raster }
    }

    /// The same with a curve over it.
    #[must_use]
    pub fn with_curve(mut self, curve: Curve) -> Self {
        self.chart.curves.push(curve);
        self
    }

    /// The same with a point over it.
    #[must_use]
    pub fn with_marker(mut self, marker: Marker) -> Self {
        self.chart.markers.push(marker);
        self
    }

    /// The field as a picture of its own.
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
        picture::View { chart: &self.chart, raster: Some(&self.raster) }
    }
}
