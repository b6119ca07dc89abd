//! Geometry and mechanics of uniform n-plies.
#![warn(missing_docs)]

mod error;
mod handedness;
mod scale;

pub mod geometry;
pub mod mechanics;
mod numerics;

pub use error::DomainError;
pub use handedness::Handedness;
pub use scale::Scale;
