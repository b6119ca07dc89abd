//! Pictures for a person: charts of curves and rasters over a rectangle, as SVG text.
//!
//! ```
//! use nply_sheet::plot::{Axis, Chart, Curve, Picture};
//! let x = || Axis::new("end force", "N");
//! let angle = Chart::new("Angle", x(), Axis::new("helical angle", "deg"))
//!     .with_curve(Curve::new("", [(0.0, 30.0), (1.0, 25.0)]));
//! let pressure = Chart::new("Pressure", x(), Axis::new("p", "N/m"))
//!     .with_curve(Curve::new("", [(0.0, 1.0), (1.0, 4.0)]));
//! let svg = Picture::column([angle, pressure]).svg();
//! assert!(svg.ends_with("</svg>"));
//! ```

mod axis;
mod bar;
#[cfg(feature = "png")]
mod bitmap;
mod braille;
mod chart;
mod clip;
mod field;
#[cfg(test)]
mod hostile;
mod legend;
mod palette;
mod panel;
mod picture;
mod raster;
pub(crate) mod sample;
mod symbol;
mod text;
pub(crate) mod theme;

pub use axis::Axis;
#[cfg(feature = "png")]
pub use bitmap::{BitmapError, png};
pub use chart::{Area, Chart, Curve, Dash, Marker, MarkerShape, Note, Side};
pub use field::Field;
pub use palette::ColourMap;
pub(crate) use palette::STRANDS;
pub use picture::{Panel, Picture};
pub use theme::Theme;
