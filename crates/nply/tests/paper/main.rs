//! Every numbered equation of the paper's sections 2 to 6 and its appendix, typed again in the paper's letters and held against the
//! library on a grid of strands, angles, hands, stiffness ratios, twists and loads. Where print is in error the corrected
//! equation is here and the printed one in `errata.rs`.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

#[path = "../common/mod.rs"]
mod common;

mod appendix;
mod balance;
mod centreline;
mod contact;
mod displacement;
mod energy;
mod flexibility;
mod force;
mod pretwist;
mod section;
mod state;
mod stiffness;
