//! Link, twist and writhe of any curve, as the Appendix of the paper defines them: (A.2)–(A.4).
//!
//! Signs are those of the integral (A.4): a crossing is positive where it is right-handed, so that a right-handed trefoil has positive
//! writhe, and a right-handed plectoneme, whose strands run in opposite directions, negative writhe.

mod average_crossing;
mod closure_point;
mod crossing;
mod curve;
mod error;
mod extension;
mod linking;
mod orientation;
mod pair_kernel;
mod ply;
mod polar_writhe;
mod sample;
mod segments;
mod shadow;
mod twist;
mod view;
mod writhe;
mod writhe_map;

pub use average_crossing::{AverageCrossings, CrossingShare};
pub use curve::Curve;
pub use error::CurveError;
pub use extension::Along;
pub use linking::{LinkingIntegral, LinkingNumber, linking_integral, linking_matrix, linking_number};
pub use ply::{ClosedPly, Contribution, Part, Piece, PlyLink, PlyWrithe};
pub use polar_writhe::PolarWrithe;
pub use sample::Sampled;
pub use twist::{Frame, Twist};
pub use writhe::Writhe;
pub use writhe_map::{WritheMap, WritheShares};
