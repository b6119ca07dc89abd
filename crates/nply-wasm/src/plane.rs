//! The plane of force and moment: where touching strands part, and where the angle stays.

use nply::geometry::HelicalAngle;
use nply::{DomainError, Handedness};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::strands::{hand, ply, twist};

/// The locus p = 0 at `points` angles of each hand, right-handed first: hand, θ in degrees, f, m.
#[wasm_bindgen]
#[must_use]
pub fn locus(strands: u32, stiffness_ratio: f64, twist_kind: &str, twist_value: f64, points: usize) -> Vec<f64> {
    let given = twist(twist_kind, twist_value);
    let found = ply(strands, stiffness_ratio, "contact").and_then(|ply| ply.separation_locus(given, points));
    let Ok(locus) = found else { return Vec::new() };
    let mut rows = Vec::with_capacity(8 * points);
    for hand in Handedness::BOTH {
        for i in 0..points {
            let (angle, load) = locus.point(hand, i);
            rows.extend([hand.sign(), angle.degrees(), load.force, load.moment]);
        }
    }
    rows
}

/// Two points, f and m of each, of the line of loads that hold an angle (in degrees); its piece from the first on, towards the second, is where
/// strands press on each other. Empty where no loads hold it.
#[wasm_bindgen]
#[must_use]
pub fn angle_line(
    strands: u32,
    stiffness_ratio: f64,
    balance: &str,
    twist_kind: &str,
    twist_value: f64,
    handedness: f64,
    degrees: f64,
) -> Vec<f64> {
    line(strands, stiffness_ratio, balance, twist_kind, twist_value, handedness, degrees).unwrap_or_default()
}

fn line(
    strands: u32,
    stiffness_ratio: f64,
    balance: &str,
    twist_kind: &str,
    twist_value: f64,
    handedness: f64,
    degrees: f64,
) -> Result<Vec<f64>, DomainError> {
    let ply = ply(strands, stiffness_ratio, balance)?;
    let (angle, hand, given) =
        (HelicalAngle::new(degrees.to_radians())?, hand(handedness), twist(twist_kind, twist_value));
    let parting = ply.separation_at(angle, hand, given)?.load();
    // m is explicit in f at an angle; where that fails, at the most turns, f is in m
    let further = |step: f64| match ply.moment_at(angle, hand, given, parting.force + step) {
        Ok(state) => Ok(state),
        Err(_) => ply.force_at(angle, hand, given, parting.moment + step),
    };
    let (up, down) = (further(1.0)?, further(-1.0)?);
    let pressing = if up.interstrand_pressure() >= down.interstrand_pressure() { up } else { down };
    let to = pressing.load();
    Ok(vec![parting.force, parting.moment, to.force, to.moment])
}
