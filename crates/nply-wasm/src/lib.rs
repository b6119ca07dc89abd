//! nply in the browser: text and arrays of numbers in, text and arrays of numbers out. What they mean is said in `nply-sheet` (documents,
//! reports, shapes) and `nply` (everything dimensionless); nothing is worked out here.
//!
//! A refusal is an answer too: JSON with `error`, which holds the sentence that the command prints.
#![warn(missing_docs)]

mod course;
mod document;
mod plane;
mod refusal;
mod shape;
mod strands;
mod take_away;
mod walk;

pub use course::{contact_diagram, course, supported_course};
pub use document::{keys, presets, read, solve};
pub use plane::{angle_line, locus};
pub use shape::{outline, touching_sides};
pub use take_away::{mesh, report};
pub use walk::walk;
