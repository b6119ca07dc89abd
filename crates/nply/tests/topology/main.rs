//! Link, twist and writhe of any curve: laws, known values, and the long way round.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

#[path = "../common/vector.rs"]
#[allow(dead_code)]
mod vector;

mod average_crossing;
mod curves;
mod linking;
mod polar_writhe;
mod refusal;
mod ribbon;
mod sample;
mod writhe;
mod writhe_map;

use proptest::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}
