//! `cargo xtask certify`: random plies, every state of the solver held against roots that interval arithmetic has proved.
//!
//! The balance is written out anew (`sheet`), in coordinates of the branch in which it is explicit, and evaluated with its first two
//! derivatives between rigorous bounds (`interval`, `series`, `jet`). A piece of the branch is *free* when its range does not hold zero,
//! *monotone* when the slope's does not; anything else is halved, until rounding hides what it is. A monotone piece with sure signs at its ends holds
//! one root or none. What is left is *open*, and counted by its reason. Nothing of the library's own method takes part.

#![allow(clippy::collapsible_if)] // one question, then what its answer asks

pub mod case;
pub mod dice;
pub mod interval;
pub mod jet;
pub mod run;
pub mod scan;
pub mod series;
pub mod sheet;
pub mod table;
pub mod verdict;
