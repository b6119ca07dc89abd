//! Link, twist and writhe of any curve: laws, known values, and the long way round.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

#[path = "../common/vector.rs"]
mod vector;

mod curves;
mod writhe;
