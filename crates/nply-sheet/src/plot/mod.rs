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
mod chart;
mod clip;
mod field;
#[cfg(test)]
mod hostile;
mod palette;
mod panel;
mod picture;
mod raster;
mod text;

pub use axis::Axis;
pub use chart::{Chart, Curve, Marker, MarkerShape};
pub use field::Field;
pub use palette::ColourMap;
pub(crate) use palette::STRANDS;
pub use picture::{Panel, Picture};
