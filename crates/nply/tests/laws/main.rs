//! Laws that hold for every ply: any number of strands, both hands, states drawn at random.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

#[path = "../common/mod.rs"]
mod common;

mod batch;
mod cable;
mod chords;
mod clearance;
mod closed_ply;
mod equilibrium;
mod extensible;
mod geometry;
mod holding;
mod ply_writhe;
mod refusal;
mod section;
mod separation;
mod stability;
mod stretch_path;
mod support;
mod tube;
mod wire_layer;

use nply::Handedness;
use proptest::prelude::*;

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Two to twelve strands mostly, up to forty sometimes.
fn strands() -> impl Strategy<Value = u32> {
    prop_oneof![6 => 2..=12_u32, 1 => 13..=40_u32]
}

fn hand() -> impl Strategy<Value = Handedness> {
    prop_oneof![Just(Handedness::Right), Just(Handedness::Left)]
}
