//! Curves: one datum runs, all else stands.

use core::f64::consts::{FRAC_PI_2, PI};

use nply::geometry::{BranchKind, Contact, HelicalAngle, branch_at_anomaly, branches};
use nply::mechanics::{Equilibrium, Ply, Support, Twist};
use nply::{DomainError, Handedness};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::strands::{load, ply, twist};

/// Columns of [`course`].
const COLUMNS: usize = 8;

/// Touching states along their branch from straight strands to flat rings, right-handed ones first, `points` of each hand, and the datum
/// that holds each: `along` is `pretwist`, `force` or `moment`. Eight numbers a state: hand, θ in degrees, the datum, p₁, p, a·d_f, a·d_m, and
/// whether it is stable (1), unstable (−1) or neither is said (0). Where no datum holds an angle, NaN.
#[wasm_bindgen]
#[must_use]
#[expect(clippy::too_many_arguments, reason = "plain numbers come over the border one by one")]
pub fn course(
    strands: u32,
    stiffness_ratio: f64,
    balance: &str,
    along: &str,
    twist_kind: &str,
    twist_value: f64,
    force: f64,
    moment: f64,
    points: usize,
) -> Vec<f64> {
    let Ok(ply) = ply(strands, stiffness_ratio, balance) else { return Vec::new() };
    let given = twist(twist_kind, twist_value);
    let mut rows = Vec::with_capacity(2 * points * COLUMNS);
    for hand in Handedness::BOTH {
        for angle in angles(points) {
            let state = match along {
                "force" => ply.force_at(angle, hand, given, moment),
                "moment" => ply.moment_at(angle, hand, given, force),
                _ => ply.pretwist_at(angle, hand, load(force, moment)),
            };
            let datum = |state: &Equilibrium| match along {
                "force" => state.load().force,
                "moment" => state.load().moment,
                _ => state.pretwist(),
            };
            row(&mut rows, hand, angle, state.ok().as_ref().map(|state| (datum(state), state)));
        }
    }
    rows
}

fn row(rows: &mut Vec<f64>, hand: Handedness, angle: HelicalAngle, state: Option<(f64, &Equilibrium)>) {
    use nply::mechanics::Stability::{Stable, Unstable};
    rows.extend([hand.sign(), angle.degrees()]);
    match state {
        Some((datum, state)) => rows.extend([
            datum,
            state.interstrand_pressure(),
            state.resultant_pressure(),
            state.extension(),
            state.rotation(),
            match state.stability() {
                Some(Stable) => 1.0,
                Some(Unstable) => -1.0,
                _ => 0.0,
            },
        ]),
        None => rows.extend([f64::NAN; COLUMNS - 2]),
    }
}

/// Angles from near 0 to near 90°, closer to each other towards both ends.
fn angles(points: usize) -> impl Iterator<Item = HelicalAngle> {
    (0..points).filter_map(move |i| {
        let share = (i as f64 + 0.5) / points as f64;
        let eased = share * share * (3.0 - 2.0 * share);
        HelicalAngle::new(FRAC_PI_2 * eased).ok()
    })
}

/// States of a ply round a core, or without one, at each of `points` values of `along` from `from` to `to`: the datum, hand, θ in degrees,
/// what carries the strands (0 neighbours, 1 core, 2 both, 3 nothing), p₁, p_c, a·d_f, a·d_m.
#[wasm_bindgen]
#[must_use]
#[expect(clippy::too_many_arguments, reason = "plain numbers come over the border one by one")]
pub fn supported_course(
    strands: u32,
    stiffness_ratio: f64,
    core_radius: f64,
    along: &str,
    twist_kind: &str,
    twist_value: f64,
    force: f64,
    moment: f64,
    from: f64,
    to: f64,
    points: usize,
) -> Vec<f64> {
    let Ok(ply) = Ply::new(strands, stiffness_ratio) else { return Vec::new() };
    let core = (core_radius > 0.0).then_some(core_radius);
    let mut rows = Vec::new();
    for i in 0..points {
        let x = from + (to - from) * i as f64 / (points.max(2) - 1) as f64;
        let (given, load) = match along {
            "force" => (twist(twist_kind, twist_value), load(x, moment)),
            "moment" => (twist(twist_kind, twist_value), load(force, x)),
            _ => (Twist::Pretwist(x), load(force, moment)),
        };
        for state in ply.supported_states(given, load, core).unwrap_or_default() {
            rows.extend([
                x,
                state.handedness().sign(),
                state.angle().degrees(),
                match state.support() {
                    Support::Neighbours => 0.0,
                    Support::Core => 1.0,
                    Support::Both => 2.0,
                    Support::Free => 3.0,
                },
                state.interstrand_pressure(),
                state.core_pressure(),
                state.extension(),
                state.rotation(),
            ]);
        }
    }
    rows
}

/// Figures 1 to 3: how strands touch at every angle, branch by branch. Five numbers a point: the branch (0 main, then 1, 2, …), its kind (0 main,
/// 1 trivial, 2 satellite), θ in degrees, x and R/r; a branch's points follow on each other. `satellites` of them are drawn.
#[wasm_bindgen]
#[must_use]
pub fn contact_diagram(strands: u32, points: usize, satellites: u32) -> Vec<f64> {
    diagram(strands, points, satellites).unwrap_or_default()
}

fn diagram(strands: u32, points: usize, satellites: u32) -> Result<Vec<f64>, DomainError> {
    let mut rows = Vec::new();
    for angle in angles(points) {
        let contact = Contact::at_angle(strands, angle)?;
        rows.extend([0.0, 0.0, angle.degrees(), contact.arclength_shift(), contact.radius_ratio()]);
    }
    let mut number = 1.0;
    if strands == 2 {
        // the other of the pair that leaves x = 0 at 45°, and what stays there
        let past: Vec<HelicalAngle> = angles(points).filter(|angle| angle.tan() > 1.0).collect();
        for kind in [BranchKind::Main, BranchKind::Trivial] {
            for &angle in &past {
                let here = branches(2, angle, 3)?;
                let wanted = |branch: &&nply::geometry::Branch| {
                    branch.kind == kind && (kind != BranchKind::Main || branch.arclength_shift < 0.0)
                };
                if let Some(branch) = here.iter().find(wanted) {
                    let code = if kind == BranchKind::Main { 0.0 } else { 1.0 };
                    rows.extend([number, code, angle.degrees(), branch.arclength_shift, branch.radius_ratio]);
                }
            }
            number += 1.0;
        }
    }
    // between odd and even multiples of π, on either side, each curve runs through once
    for k in 0..satellites {
        let turn = f64::from(k / 2 + u32::from(strands == 2 && k % 2 == 0)); // the first of two strands is the mirror image above
        let from = if k % 2 == 0 { (2.0 * turn + 1.0) * PI } else { -(2.0 * turn + 2.0) * PI };
        for i in 1..points {
            let share = i as f64 / points as f64;
            let eased = share * share * (3.0 - 2.0 * share);
            if let Some((angle, branch)) = branch_at_anomaly(strands, from + PI * eased)? {
                rows.extend([number, 2.0, angle.degrees(), branch.arclength_shift, branch.radius_ratio]);
            }
        }
        number += 1.0;
    }
    Ok(rows)
}
