//! Panels beside or above each other in one picture.

use kuva::backend::svg::SvgBackend;
use kuva::render::render::{Primitive, Scene};

use super::panel::Drawing;
use super::raster::Raster;
use super::{Chart, Field, Theme, theme};

/// Several panels in one picture.
///
/// ```
/// use nply_sheet::plot::{Axis, Chart, Field, Panel, Picture};
/// let axes = || (Axis::new("f", ""), Axis::new("m", ""));
/// let ((x, y), (f, m)) = (axes(), axes());
/// let map = Field::of_categories("States", f, m, 2, &[0, 1, 2, 1], ["none", "one", "two"]);
/// let svg = Picture::row([Panel::from(Chart::new("", x, y)), Panel::from(map)]).svg();
/// assert!(svg.contains("two"));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Picture {
    /// The panels in their order.
    pub panels: Vec<Panel>,
    arrangement: Arrangement,
}

impl Picture {
    /// Panels from left to right.
    #[must_use]
    pub fn row<P: Into<Panel>>(panels: impl IntoIterator<Item = P>) -> Self {
        Self { panels: panels.into_iter().map(Into::into).collect(), arrangement: Arrangement::ROW }
    }

    /// Panels from top to bottom, their axes in line.
    #[must_use]
    pub fn column<P: Into<Panel>>(panels: impl IntoIterator<Item = P>) -> Self {
        Self::grid(panels, 1)
    }

    /// Panels in rows of so many (at least one), from left to right and from top to bottom, their axes in line.
    #[must_use]
    pub fn grid<P: Into<Panel>>(panels: impl IntoIterator<Item = P>, columns: usize) -> Self {
        let arrangement = Arrangement { columns: columns.max(1) };
        Self { panels: panels.into_iter().map(Into::into).collect(), arrangement }
    }

    /// The picture.
    #[must_use]
    pub fn svg(&self) -> String {
        self.svg_in(Theme::Light)
    }

    /// The same on light or dark ground.
    #[must_use]
    pub fn svg_in(&self, theme: Theme) -> String {
        let views: Vec<View<'_>> = self.panels.iter().map(Panel::view).collect();
        draw(&views, self.arrangement, theme)
    }
}

/// One pair of axes and what is drawn in it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Panel {
    /// Curves and points.
    Chart(Chart),
    /// A raster.
    Field(Field),
}

impl Panel {
    fn view(&self) -> View<'_> {
        match self {
            Self::Chart(chart) => chart.view(),
            Self::Field(field) => field.view(),
        }
    }
}

impl From<Chart> for Panel {
    fn from(chart: Chart) -> Self {
        Self::Chart(chart)
    }
}

impl From<Field> for Panel {
    fn from(field: Field) -> Self {
        Self::Field(field)
    }
}

/// How many panels stand beside each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Arrangement {
    columns: usize,
}

impl Arrangement {
    /// All in one row.
    pub(super) const ROW: Self = Self { columns: usize::MAX };
}

/// A panel that is only looked at.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) chart: &'a Chart,
    pub(super) raster: Option<&'a Raster>,
}

/// All panels as one text.
pub(super) fn draw(views: &[View<'_>], Arrangement { columns }: Arrangement, theme: Theme) -> String {
    let mut drawings: Vec<Drawing<'_>> = views.iter().map(|&view| Drawing::of(view, theme)).collect();
    let columns = columns.min(drawings.len()).max(1);
    for column in 0..columns {
        Drawing::align_sides(drawings.iter_mut().skip(column).step_by(columns));
    }
    drawings.chunks_mut(columns).for_each(Drawing::align_tops);
    let row_width = |row: &[Drawing<'_>]| row.iter().map(Drawing::width).sum::<f64>();
    let row_height = |row: &[Drawing<'_>]| row.iter().map(Drawing::height).fold(0.0, f64::max);
    let width = drawings.chunks(columns).map(row_width).fold(0.0, f64::max);
    let height = drawings.chunks(columns).map(row_height).sum::<f64>();
    let ground = theme::hex(theme.ground());
    let mut scene = Scene::new(width, height).with_background(Some(&ground));
    scene.text_color = Some(theme::hex(theme.ink()));
    let mut images = Vec::new();
    let mut y = 0.0;
    for row in drawings.chunks(columns) {
        let mut x = 0.0;
        for drawing in row {
            scene.font_family = drawing.font();
            let transform = Some(format!("translate({x:.2},{y:.2})"));
            scene.add(Primitive::GroupStart { transform, title: None, extra_attrs: None });
            drawing.add_to(&mut scene, &mut images);
            scene.add(Primitive::GroupEnd);
            x += drawing.width();
        }
        y += row_height(row);
    }
    let mut svg = SvgBackend::new().render_scene(&scene);
    for (i, image) in images.iter().enumerate() {
        svg = svg.replacen(&format!("<g {}></g>", place(i)), image, 1);
    }
    svg
}

/// The attribute that keeps the place of image number i; no text of others can hold it, since their quotation marks are
/// escaped.
fn place(i: usize) -> String {
    format!(r#"data-image="{i}""#)
}

/// Puts an image where the scene stands now.
pub(super) fn add_image(scene: &mut Scene, images: &mut Vec<String>, image: String) {
    let extra_attrs = Some(place(images.len()));
    scene.add(Primitive::GroupStart { transform: None, title: None, extra_attrs });
    scene.add(Primitive::GroupEnd);
    images.push(image);
}
