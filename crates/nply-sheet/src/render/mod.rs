//! Still pictures of plies: rays against the exact surfaces, lit, shaded by each other, in perspective of none.
//!
//! ```
//! use nply_sheet::Spec;
//! use nply_sheet::mesh::{Assembly, Subject, Wanted};
//! use nply_sheet::render::{Picture, View};
//! let ply = Subject::of(&Spec::from_flags([("strands", "3"), ("helical-angle", "30 deg")])?, None)?;
//! let assembly = Assembly::of(&ply, &Wanted { lay_lengths: Some(0.5), ..Wanted::default() })?;
//! let picture = Picture::of(&[(&assembly, [0.0; 3])], View { width: 64, ..View::default() })?;
//! let rows: Vec<_> = (0..picture.height()).map(|row| picture.row(row)).collect();
//! assert!(picture.png(&rows)?.starts_with(b"\x89PNG"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod body;
mod coil;
mod light;
mod picture;

pub use picture::{Ground, Picture, RenderError, View};
