//! The figures and tables of Neukirch and van der Heijden's paper, worked out anew: data, picture, a caption in our own words.
//!
//! Where the two balances differ, both are drawn and named.
//!
//! ```
//! use nply_sheet::figure::Figure;
//! use nply_sheet::plot::Theme;
//! let figure = Figure::named("1")?.expect("there is a Figure 1");
//! assert!(figure.svg(Theme::Light).starts_with("<svg "));
//! assert!(figure.csv().starts_with("curve,helical_angle_deg,arclength_shift"));
//! # Ok::<(), nply::DomainError>(())
//! ```

mod arclength_shift;
mod balanced;
mod balanced_angle;
mod canvas;
mod contribution;
mod control_plane;
mod cored;
mod cut;
mod data;
mod domain;
mod gallery;
mod link;
mod pieces;
mod shaded;

use std::sync::Arc;

use nply::DomainError;

use crate::plot::{Picture, Theme};
pub use data::{Cell, Data};
pub use gallery::{html, markdown};

/// One figure or table.
#[derive(Clone)]
#[non_exhaustive]
pub struct Figure {
    /// What it is called by: `1` to `15`, `table1`, `table2`.
    pub name: &'static str,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// What there is to see, in whole sentences.
    pub caption: String,
    /// The numbers drawn.
    pub data: Data,
    drawing: Drawing,
}

/// How it becomes a picture.
#[derive(Clone)]
enum Drawing {
    Charts(Picture),
    Free(Arc<dyn Fn(Theme) -> String + Send + Sync>),
}

/// What makes a figure.
struct Recipe {
    name: &'static str,
    title: &'static str,
    make: fn() -> Result<Parts, DomainError>,
}

/// A figure but for its name.
struct Parts {
    caption: String,
    data: Data,
    drawing: Drawing,
}

impl Parts {
    fn charts(caption: impl Into<String>, data: Data, picture: Picture) -> Self {
        Self { caption: caption.into(), data, drawing: Drawing::Charts(picture) }
    }

    fn free(caption: impl Into<String>, data: Data, draw: impl Fn(Theme) -> String + Send + Sync + 'static) -> Self {
        Self { caption: caption.into(), data, drawing: Drawing::Free(Arc::new(draw)) }
    }
}

static RECIPES: [Recipe; 17] = {
    const fn recipe(name: &'static str, title: &'static str, make: fn() -> Result<Parts, DomainError>) -> Recipe {
        Recipe { name, title, make }
    }
    [
        recipe("1", "Where two strands touch", arclength_shift::two),
        recipe("2", "Two strands at 60°", shaded::two),
        recipe("3", "Where three strands touch", arclength_shift::three),
        recipe("4", "Three strands at 60°", shaded::three),
        recipe("5", "Three strands cut across", cut::make),
        recipe("6", "Two strands without loads", balanced::two),
        recipe("7", "Three strands without loads", balanced::three),
        recipe("8", "The angle a pretwist makes", balanced_angle::make),
        recipe("9", "Two strands under force and moment", control_plane::two),
        recipe("10", "Three strands under force and moment", control_plane::three),
        recipe("11", "Six strands on a core", cored::make),
        recipe("12", "Three strands let go, with their closure", link::make),
        recipe("13", "Where the writhe of a helix is summed", domain::make),
        recipe("14", "The pieces of a closed ply of two strands", pieces::two),
        recipe("15", "The pieces of a closed ply of three strands", pieces::three),
        recipe("table1", "Writhe of a ply of two strands, piece by piece", contribution::two),
        recipe("table2", "Writhe of a ply of three strands, piece by piece", contribution::three),
    ]
};

impl Figure {
    /// The names of all, in the paper's order.
    pub fn names() -> impl Iterator<Item = &'static str> {
        RECIPES.iter().map(|recipe| recipe.name)
    }

    /// The figure of a name; `None` where there is none.
    ///
    /// # Errors
    /// [`DomainError`] is never met: the figures' own data are within the theory's reach, as tests hold.
    pub fn named(name: &str) -> Result<Option<Self>, DomainError> {
        let Some(recipe) = RECIPES.iter().find(|recipe| recipe.name == name) else { return Ok(None) };
        let Parts { caption, data, drawing } = (recipe.make)()?;
        Ok(Some(Self { name: recipe.name, title: recipe.title, caption, data, drawing }))
    }

    /// `Figure 1` or `Table I`.
    #[must_use]
    pub fn heading(&self) -> String {
        match self.name {
            "table1" => "Table I".to_owned(),
            "table2" => "Table II".to_owned(),
            number => format!("Figure {number}"),
        }
    }

    /// What its files are called, but for their endings.
    #[must_use]
    pub fn file_name(&self) -> String {
        match self.name.parse::<u32>() {
            Ok(number) => format!("figure-{number:02}"),
            Err(_) => self.name.replace("table", "table-"),
        }
    }

    /// The picture.
    #[must_use]
    pub fn svg(&self, theme: Theme) -> String {
        match &self.drawing {
            Drawing::Charts(picture) => picture.svg_in(theme),
            Drawing::Free(draw) => draw(theme),
        }
    }

    /// The numbers drawn, with a line of names.
    #[must_use]
    pub fn csv(&self) -> String {
        self.data.csv()
    }
}

/// An angle in radians.
fn rad(degrees: f64) -> f64 {
    degrees.to_radians()
}
