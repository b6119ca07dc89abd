//! Uniform plies: their writhe at any length, their ledger of link, the closed curve itself.

mod chord;
mod closed;
mod link;
mod periods;
mod piece;
mod tail;
mod writhe;

use crate::DomainError;

pub use closed::ClosedPly;
pub use link::PlyLink;
pub use piece::{Part, Piece};
pub use writhe::{Contribution, PlyWrithe};

/// Refuses no strands, and more than there is memory for.
fn check_strands(strands: u32) -> Result<(), DomainError> {
    let allowed = "a whole number of at least 1 and at most a million";
    DomainError::check((1..=1_000_000).contains(&strands), "strands", f64::from(strands), allowed)
}
