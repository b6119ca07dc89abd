//! Panels beside or above each other in one picture.

use kuva::backend::svg::SvgBackend;
use kuva::render::render::{Primitive, Scene};

use super::panel::Drawing;
use super::raster::Raster;
use super::{Chart, Field};

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
    direction: Direction,
}

impl Picture {
    /// Panels from left to right.
    #[must_use]
    pub fn row<P: Into<Panel>>(panels: impl IntoIterator<Item = P>) -> Self {
        Self { panels: panels.into_iter().map(Into::into).collect(), direction: Direction::Row }
    }

    /// Panels from top to bottom, their axes in line.
    #[must_use]
    pub fn column<P: Into<Panel>>(panels: impl IntoIterator<Item = P>) -> Self {
        Self { panels: panels.into_iter().map(Into::into).collect(), direction: Direction::Column }
    }

    /// The picture.
    #[must_use]
    pub fn svg(&self) -> String {
        let views: Vec<View<'_>> = self.panels.iter().map(Panel::view).collect();
        draw(&views, self.direction)
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

/// Where the next panel stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    Row,
    Column,
}

/// A panel that is only looked at.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    pub(super) chart: &'a Chart,
    pub(super) raster: Option<&'a Raster>,
}

/// All panels as one text.
pub(super) fn draw(views: &[View<'_>], direction: Direction) -> String {
    let mut drawings: Vec<Drawing<'_>> = views.iter().map(|&view| Drawing::of(view)).collect();
    match direction {
        Direction::Column => Drawing::align_sides(&mut drawings),
        Direction::Row => Drawing::align_tops(&mut drawings),
    }
    let size = |of: fn(&Drawing<'_>) -> f64, along: bool| {
        let sizes = drawings.iter().map(of);
        if along { sizes.sum::<f64>() } else { sizes.fold(0.0, f64::max) }
    };
    let width = size(|d| d.width(), direction == Direction::Row);
    let height = size(|d| d.height(), direction == Direction::Column);
    let mut scene = Scene::new(width, height).with_background(Some("white"));
    scene.text_color = Some("#222222".to_owned());
    let mut images = Vec::new();
    let (mut x, mut y) = (0.0, 0.0);
    for drawing in &drawings {
        scene.font_family = drawing.font();
        let transform = Some(format!("translate({x:.2},{y:.2})"));
        scene.add(Primitive::GroupStart { transform, title: None, extra_attrs: None });
        drawing.add_to(&mut scene, &mut images);
        scene.add(Primitive::GroupEnd);
        match direction {
            Direction::Row => x += drawing.width(),
            Direction::Column => y += drawing.height(),
        }
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
