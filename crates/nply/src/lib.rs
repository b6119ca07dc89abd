//! Geometry and mechanics of uniform n-plies: n elastic strands coiled round each other, touching.
//!
//! After S. Neukirch and G. H. M. van der Heijden, *Geometry and Mechanics of Uniform n-Plies*, Journal of Elasticity 69 (2002)
//! 41–72, whose equation numbers stand in parentheses throughout. Everything is dimensionless: strand radius r = 1 and
//! bending stiffness B = 1; [`Scale`] turns results into lengths and forces. Angles are in rad.
//!
//! - [`geometry`]: how strands touch at a helical angle: [`geometry::Contact`];
//! - [`mechanics`]: which angles are in equilibrium, and what presses, pulls and gives there: [`mechanics::Ply`];
//! - [`topology`]: link, twist and writhe of any curve: [`topology::Curve`].
//!
//! ```
//! use nply::mechanics::{Load, Ply, Twist};
//! // three strands, C/B = 3/4, each twisted by φ̄a = −1 (left-handed), clipped together and let go
//! let states = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?;
//! let ply = states[0].contact();
//! assert!((ply.angle().degrees() - 30.6130).abs() < 5e-5);
//! assert!((ply.radius_ratio() - 1.21823).abs() < 5e-6);
//! # Ok::<(), nply::DomainError>(())
//! ```
#![warn(missing_docs)]

mod error;
mod handedness;
mod scale;

pub mod geometry;
pub mod mechanics;
mod numerics;
pub mod topology;

pub use error::DomainError;
pub use handedness::Handedness;
pub use scale::Scale;

/// The README's program, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
