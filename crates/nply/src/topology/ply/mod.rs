//! Uniform plies: their writhe at any length, their ledger of link, the closed curve itself.

mod chord;
mod closed;
mod link;
mod periods;
mod piece;
mod tail;
mod writhe;

pub use closed::ClosedPly;
pub use link::PlyLink;
pub use piece::{Part, Piece};
pub use writhe::{Contribution, PlyWrithe};
