//! The paperwork of nply: what a person writes in, what a person reads out. Text in, text out; no files, no printing.
//!
//! A text becomes a [`Spec`] (what was written, and where), a spec becomes a [`Case`] (dimensionless numbers and one question):
//!
//! ```
//! use nply_sheet::{Question, Spec};
//! let text = "[ply]\nstrands = 3\n[strand]\nstiffness_ratio = 0.75\n[twist]\npretwist = -1\n";
//! let case = Spec::from_toml("ply.toml", text)?.check()?;
//! assert_eq!(case.strands, 3);
//! assert!(matches!(case.question, Question::States { .. }));
//! # Ok::<(), nply_sheet::SpecError>(())
//! ```
#![warn(missing_docs)]

mod case;
pub mod construction;
pub mod curves;
mod diagnostic;
pub mod figure;
pub mod graph;
mod key;
pub mod map;
pub mod mesh;
pub mod plot;
mod preferred;
mod preset;
mod quantity;
pub mod regression;
pub mod render;
mod report;
pub mod schema;
mod solve;
mod spec;
mod study;
pub mod sweep;
pub mod table;

pub use case::{Case, Lay, Question, Shape, StringStiffness, Strings};
pub use diagnostic::{ErrorKind, Place, SpecError};
pub use key::{Datum, KEYS, Key, Kind, Table};
pub use preferred::PreferredUnits;
pub use preset::{PRESETS, Preset, list_presets};
pub use quantity::{Dimension, KnownUnit, Quantity, QuantityError, Unit, known_units, unit_prefixes};
pub use report::{
    AngleLine, COLUMNS, ClearanceReport, Column, Extension, FitReport, Known, LaysReport, Link, LinkReport,
    LocusReport, Measure, PlyingReport, Reading, Report, Section, ShapeReport, SpecialPoint, StiffnessReport,
    StringsGoal, StringsReport, TraceReport, Walk, WritheQuestion, WritheReport, Writhing,
};
pub use solve::{Opening, Solution, Supported};
pub use spec::Spec;

/// What was read, in quotation marks, without control characters and not longer than a line.
fn quoted(text: &str) -> String {
    const LONGEST: usize = 60;
    let mut shown: String = text.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    format!("\"{shown}\"")
}
