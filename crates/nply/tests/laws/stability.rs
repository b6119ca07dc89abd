//! Stable states are where energy is least among uniform plies that keep off their obstacles; and the ply as a column.

use std::f64::consts::{FRAC_PI_4, PI, TAU};

use nply::mechanics::{Holding, Ply, Stability, Support, SupportedState, Twist};
use proptest::prelude::*;

use crate::common::touch::{bisect, touch_at};
use crate::config;
use crate::support::{Given, given};

/// Small steps (θ, ρ) away from a state that keep strands out of each other and of the core and leave the held displacement as it
/// is: all round for dead loads, with the steps that would go into an obstacle turned aside along it; to both sides otherwise.
fn steps(state: &SupportedState, holding: Holding, size: f64, turn: f64) -> Vec<(f64, f64)> {
    let (theta, rho) = (state.angle().radians(), state.radius_ratio());
    let obstacle = |theta: f64| touch_at(state.strands(), theta).rho.max(1.0 + state.core_radius().unwrap_or(0.0));
    let clear = |(theta, rho): &(f64, f64)| *rho >= obstacle(*theta) * (1.0 - 1e-14);
    let sides = [-size, size];
    match holding {
        Holding::DeadLoads => (0..180)
            .map(|k| {
                let (up, along) = (turn + TAU * f64::from(k) / 180.0).sin_cos();
                (theta + size * along, (rho * (1.0 + size * up)).max(obstacle(theta + size * along)))
            })
            // straight into an obstacle is no step at all
            .filter(|(t, r)| (t - theta).abs() + (r / rho - 1.0).abs() > 0.2 * size)
            .collect(),
        Holding::Rotation => {
            sides.map(|h| (theta + h, rho * (theta + h).sin() / theta.sin())).into_iter().filter(clear).collect()
        }
        Holding::Length => sides.map(|h| (theta, rho * (1.0 + h))).into_iter().filter(clear).collect(),
    }
}

/// The verdict against the energies of the steps, where digits are enough to tell.
fn verdict_is_that_of_the_energy(
    given: &Given,
    state: &SupportedState,
    holding: Holding,
    turn: f64,
) -> Result<(), TestCaseError> {
    let (theta, rho, load) = (state.angle().radians(), state.radius_ratio(), state.load());
    let corner = given.n == 2 && (theta - FRAC_PI_4).abs() < 0.01; // two curvatures meet there
    // a contact about to open has no first order to hold it by
    let firm = |p: f64, closed: bool| !closed || p > 0.02;
    let closed = |support| state.support() == support || state.support() == Support::Both;
    let clear = [state.neighbour_gap(), state.core_gap().unwrap_or(1.0)].iter().all(|gap| *gap == 0.0 || *gap > 1e-2);
    let most_turns = holding == Holding::Rotation && (state.touching().shift_ratio_squared() - 1.0).abs() < 0.05;
    let weak = state
        .second_variation(holding)
        .is_some_and(|second| second.abs() < 0.02 * (1.0 + load.force.abs() + load.moment.abs()));
    if !(0.1..1.45).contains(&theta)
        || rho > 50.0 // helices that have all but straightened out
        || corner
        || weak
        || most_turns
        || !clear
        || !firm(state.interstrand_pressure(), closed(Support::Neighbours))
        || !firm(state.core_pressure(), closed(Support::Core))
    {
        return Ok(());
    }
    let e = given.energy(state.handedness(), load);
    let here = e(theta, rho);
    let rises: Vec<f64> = steps(state, holding, 1e-4, turn).into_iter().map(|(t, r)| e(t, r) - here).collect();
    match state.stability(holding) {
        Stability::Stable => prop_assert!(rises.iter().all(|rise| *rise > 0.0), "{holding:?} {state:?} {rises:?}"),
        Stability::Unstable => prop_assert!(rises.iter().any(|rise| *rise < 0.0), "{holding:?} {state:?} {rises:?}"),
        Stability::Marginal => prop_assert!(false, "far from a fold: {holding:?} {state:?}"),
    }
    Ok(())
}

/// ∫ over a turn of an explicit helix: the mean over directions of a bending moment M, and over places, of
/// (t·M)²/C + (1 − (t·M)²)/B, per length of the axis.
fn compliance_of_a_spring(theta: f64, gamma: f64) -> f64 {
    let turns = 64;
    let mean: f64 = (0..turns)
        .map(|k| {
            let psi = TAU * f64::from(k) / f64::from(turns);
            let tangent = [-theta.sin() * psi.sin(), theta.sin() * psi.cos(), theta.cos()];
            let along = tangent[0]; // the moment about x
            along * along / gamma + (1.0 - along * along)
        })
        .sum::<f64>()
        / f64::from(turns);
    mean / theta.cos()
}

/// The deflection u = y + iz at the far end of a column hinged at both, of slope 1 at the near one: B u″ = iM u′ − P u by
/// Runge and Kutta.
fn far_end(stiffness: f64, length: f64, thrust: f64, moment: f64) -> [f64; 2] {
    let rate =
        |[y, z, v, w]: [f64; 4]| [v, w, (-thrust * y - moment * w) / stiffness, (-thrust * z + moment * v) / stiffness];
    let plus = |a: [f64; 4], k: f64, b: [f64; 4]| std::array::from_fn(|i| a[i] + k * b[i]);
    let steps = 400;
    let h = length / f64::from(steps);
    let end = (0..steps).fold([0.0, 0.0, 1.0, 0.0], |at, _| {
        let k1 = rate(at);
        let k2 = rate(plus(at, h / 2.0, k1));
        let k3 = rate(plus(at, h / 2.0, k2));
        let k4 = rate(plus(at, h, k3));
        std::array::from_fn(|i| at[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    });
    [end[0], end[1]]
}

/// The determinant of the far ends of the two columns of slopes 1 and i: zero where a deflection fits both hinges.
fn determinant([y, z]: [f64; 2]) -> f64 {
    y * y + z * z
}

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn stable_states_are_minima_and_unstable_ones_are_not(given in given(), turn in 0.0..0.03) {
        for state in given.states() {
            for held in Holding::ALL {
                verdict_is_that_of_the_energy(&given, &state, held, turn)?;
                // as if a torque were held at the ends of the strands
                let torque = Given { twist: Twist::StrandTwist(state.strand_twist()), ..given.clone() };
                verdict_is_that_of_the_energy(&torque, &state.with_strand_twist_held(), held, turn)?;
            }
        }
    }

    /// What holds more cannot make a state less stable: a displacement that is held takes a way down away.
    #[test]
    fn holding_does_not_unsettle(given in given()) {
        for state in given.states() {
            if state.stability(Holding::DeadLoads) == Stability::Stable {
                for held in [Holding::Rotation, Holding::Length] {
                    prop_assert!(state.stability(held) != Stability::Unstable, "{held:?} {state:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(config(300))]

    /// A ply bends no more easily than its strands as springs side by side, and no less than a solid of parallel wires.
    #[test]
    fn bending_lies_between_its_bounds(given in given()) {
        for state in given.states() {
            let (n, theta, rho) = (f64::from(given.n), state.angle().radians(), state.radius_ratio());
            let bounds = state.bending_bounds();
            prop_assert!(bounds.sliding <= n && n < bounds.locked);
            if theta > 1.55 { continue; }
            let springs = n / compliance_of_a_spring(theta, given.gamma);
            prop_assert!((bounds.sliding - springs).abs() < 1e-12 * n, "{} {springs}", bounds.sliding);
            // a solid round wire of radius 1 has A = π and I = π/4, so EA = 4 EI, and ρ² is on average halved across the bending
            let steiner: f64 = (0..given.n).map(|i| (rho * (TAU * f64::from(i) / n).sin()).powi(2)).sum();
            if given.n > 2 {
                prop_assert!((bounds.locked - (n + 4.0 * steiner)).abs() < 1e-10 * bounds.locked);
            }
        }
    }

    #[test]
    fn straighter_strands_bend_as_rods_side_by_side(n in 2..12_u32, gamma in 0.4..1.5, theta in 1e-4..1e-2) {
        let angle = nply::geometry::HelicalAngle::new(theta).unwrap();
        let ply = Ply::new(n, gamma).unwrap();
        let state = ply.moment_at(angle, nply::Handedness::Left, Twist::Pretwist(0.2), 1.0).unwrap();
        let lost = 1.0 - state.bending_bounds().sliding / f64::from(n);
        // to second order in θ
        let small = 0.5 * theta * theta / gamma;
        prop_assert!((lost - small).abs() < 10.0 * small * small + 1e-15);
    }
}

proptest! {
    #![proptest_config(config(24))]

    /// Greenhill's thrust is the lowest at which the twisted column has a bent form of its own.
    #[test]
    fn the_thrust_is_the_lowest_eigenvalue(n in 2..8_u32, degrees in 5.0..60.0_f64, gamma in 0.5..1.3, length in 50.0..300.0_f64, share in -1.5..1.5_f64) {
        let angle = nply::geometry::HelicalAngle::new(degrees.to_radians()).unwrap();
        let state = Ply::new(n, gamma).unwrap().force_at(angle, nply::Handedness::Right, Twist::Pretwist(-0.3), 0.0).unwrap();
        let bounds = state.bending_bounds();
        let euler = bounds.sliding * (PI / length).powi(2);
        let moment = share * 2.0 * bounds.sliding * PI / length;
        let thrusts = bounds.buckling_thrust(length, moment).unwrap();
        for (stiffness, thrust) in [bounds.sliding, bounds.locked].into_iter().zip(thrusts) {
            // under a strong pull the column comes back straight; follow the far end from there along that way
            let unit = stiffness * (PI / length).powi(2);
            let pulled = far_end(stiffness, length, -4.0 * unit, moment);
            let along = |p: f64| {
                let [y, z] = far_end(stiffness, length, p, moment);
                -(y * pulled[0] + z * pulled[1])
            };
            let scan: Vec<f64> = (0..=60).map(|k| (-4.0 + 0.1 * f64::from(k)) * unit).collect();
            let first = scan.windows(2).find(|pair| along(pair[0]) < 0.0 && along(pair[1]) >= 0.0).unwrap();
            let lowest = bisect(along, first[0], first[1]);
            prop_assert!((lowest - thrust).abs() < 1e-6 * unit, "{lowest} {thrust}");
            prop_assert!(determinant(far_end(stiffness, length, lowest, moment)) < 1e-12 * length * length);
        }
        let [plain, stiff] = bounds.buckling_thrust(length, 0.0).unwrap();
        prop_assert!((plain - euler).abs() < 1e-12 * euler && stiff > plain);
    }
}
