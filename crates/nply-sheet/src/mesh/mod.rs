//! Shapes for other programs: surfaces in triangles, and centrelines, in the formats that printing, finite-element and molecular people
//! read.
//!
//! ```
//! use nply_sheet::Spec;
//! use nply_sheet::mesh::{Assembly, FileUnit, Fineness, Subject, Surface, SurfaceFormat, Wanted};
//! let flags = [("strands", "3"), ("helical-angle", "30 deg"), ("diameter", "2 mm")];
//! let ply = Subject::of(&Spec::from_flags(flags)?, None)?;
//! let assembly = Assembly::of(&ply, &Wanted { length: Some("20 mm"), ..Wanted::default() })?;
//! let surface = Surface::of(&ply, &assembly, Fineness::default())?;
//! let bytes = SurfaceFormat::Stl.write(&surface, &FileUnit::of(&ply, None, None)?);
//! assert_eq!(bytes.len(), 84 + 50 * surface.counts()[1]);
//! # Ok::<(), nply_sheet::SpecError>(())
//! ```

mod abaqus;
mod assembly;
mod chain;
mod element;
mod format;
mod glb;
mod layered;
mod obj;
mod pdb;
mod ply;
mod size;
mod start;
mod stl;
mod subject;
mod summary;
mod surface;
mod vtk;
mod xyz;

pub use assembly::{Assembly, CORE_COLOUR, Line, LineKind, Wanted, Wire};
pub use chain::{Chain, Spacing, chains};
pub use element::Element;
pub use format::{LineFormat, SurfaceFormat};
pub use layered::Layered;
pub use size::FileUnit;
pub use start::{StartGeometry, StartWanted};
pub use subject::{LayerLine, Subject};
pub use summary::{chain_summary, surface_summary};
pub(crate) use surface::pale;
pub use surface::{Fineness, Part, Surface};

use crate::Measure;

/// What a file says of itself, on one line of plain letters.
fn said(title: &str, unit: &FileUnit) -> String {
    let title: String =
        title.chars().map(|c| if c.is_ascii() && !c.is_control() { c } else { '?' }).take(120).collect();
    format!("nply {}: {title}; coordinates in {}", env!("CARGO_PKG_VERSION"), in_words(unit))
}

/// `mm`, or `strand radii`.
fn in_words(unit: &FileUnit) -> String {
    match unit.name.as_str() {
        "r" => "strand radii".to_owned(),
        "µm" => "um".to_owned(),
        "Å" => "Angstrom".to_owned(),
        name => name.to_owned(),
    }
}

/// The name of a value with its unit, and its size in a file: per length in the file's unit, forces per length in N/m where the strand's
/// stiffness is known and else in B/r³.
fn field((name, measure, value): (&str, Measure, f64), unit: &FileUnit, scale: Option<nply::Scale>) -> (String, f64) {
    match (measure, scale) {
        (Measure::PerLength, _) => {
            let per = in_words(unit).replace("strand radii", "r");
            (format!("{name}_per_{per}"), value / unit.per_radius)
        }
        (Measure::ForcePerLength, Some(scale)) => (format!("{name}_N_per_m"), scale.force_per_length(value)),
        (Measure::ForcePerLength, None) => (format!("{name}_B_per_r3"), value),
        _ => (name.to_owned(), value),
    }
}

/// A number as short as it is exact to single precision, which is what such files hold.
#[expect(clippy::cast_possible_truncation, reason = "a mesh is known to its chord error, not to sixteen digits")]
const fn single(value: f64) -> f32 {
    value as f32
}
