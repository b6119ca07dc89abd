//! Ends that are held: the state keeps its displacement, and what then holds it is the other load. What was put in as link stays.

use std::f64::consts::TAU;

use nply::geometry::HelicalAngle;
use nply::mechanics::{Ends, Equilibrium, Holding, Load, Ply, Support, SupportedState, Twist};
use proptest::prelude::*;

use crate::config;
use crate::support::{Given, any_twist, given};

/// The ends that hold a state as it is.
fn held_as_it_is(state: &SupportedState, holding: Holding) -> Ends {
    let load = state.load();
    match holding {
        Holding::DeadLoads => Ends::Loads(load),
        Holding::Rotation => Ends::Rotation { rotation: state.rotation(), force: load.force },
        Holding::Length => Ends::Length { extension: state.extension(), moment: load.moment },
    }
}

/// How far the nearest of `states` with the same support and hand is from this one, in angle, radius and loads.
fn nearest(states: &[SupportedState], state: &SupportedState) -> f64 {
    let size = 1.0 + state.load().force.abs() + state.load().moment.abs();
    let away = |s: &&SupportedState| {
        (s.angle().radians() - state.angle().radians()).abs()
            + (s.radius_ratio() / state.radius_ratio() - 1.0).abs()
            + ((s.load().force - state.load().force).abs() + (s.load().moment - state.load().moment).abs()) / size
    };
    let alike = |s: &&SupportedState| s.support() == state.support() && s.handedness() == state.handedness();
    states.iter().filter(alike).map(|s| away(&s)).fold(f64::MAX, f64::min)
}

/// The unforced and the forced sides of a flat place have the digits of a square root: states with room on every side alone.
fn plain(state: &SupportedState) -> bool {
    let (theta, q) = (state.angle().radians(), state.touching().shift_ratio_squared());
    let firm = |p: f64, closed: bool| !closed || p > 1e-6;
    let closed = |support| state.support() == support || state.support() == Support::Both;
    let clear = |gap: f64| gap == 0.0 || gap > 1e-6;
    (0.05..1.5).contains(&theta)
        && state.radius_ratio() < 50.0 // not all but straightened out
        && (q - 1.0).abs() > 0.05
        && firm(state.interstrand_pressure(), closed(Support::Neighbours))
        && firm(state.core_pressure(), closed(Support::Core))
        && clear(state.neighbour_gap())
        && state.core_gap().is_none_or(clear)
}

proptest! {
    #![proptest_config(config(1500))]

    /// The displacement is the one asked for, and so is the load that was given.
    #[test]
    fn held_states_keep_what_is_held(given in given()) {
        for state in given.states() {
            match given.ends {
                Ends::Loads(load) => prop_assert_eq!(state.load(), load),
                Ends::Rotation { rotation, force } => {
                    prop_assert!((state.rotation() - rotation).abs() < 1e-14 * (1.0 + rotation.abs()), "{state:?}");
                    prop_assert_eq!(state.load().force, force);
                }
                Ends::Length { extension, moment } => {
                    prop_assert!((state.extension() - extension).abs() < 1e-15, "{state:?}");
                    prop_assert_eq!(state.load().moment, moment);
                }
            }
        }
    }

    /// A state is found again when its own displacement is held with its own other load: with the load that it carried; and one
    /// that was found held is found again under its loads.
    #[test]
    fn a_state_is_found_again_however_it_is_held(given in given()) {
        for state in given.states().into_iter().filter(plain) {
            for holding in Holding::ALL {
                // both contacts hold at one displacement alone
                if state.support() == Support::Both && holding != Holding::DeadLoads { continue; }
                // strands with γ = 1 that hang free under a held rotation are as well at any angle
                let loose = matches!(state.twist(), Twist::Pretwist(_)) && (given.gamma - 1.0).abs() < 0.02
                    || matches!(state.twist(), Twist::StrandTwist(_)) && state.strand_twist().abs() < 0.02;
                if state.support() == Support::Free && loose { continue; }
                let weak = state.second_variation(Holding::DeadLoads).is_some_and(|second| second.abs() < 1e-3);
                if weak { continue; }
                let again = Given { ends: held_as_it_is(&state, holding), ..given.clone() };
                prop_assert!(nearest(&again.states(), &state) < 1e-5, "{holding:?} {state:?}");
            }
        }
    }

    /// Touching states alone, with or without pressure between them: as with supports, and in balance.
    #[test]
    fn touching_strands_held(n in 2..12_u32, gamma in 0.4..1.4, twist in any_twist(), force in -2.0..3.0, moment in -3.0..3.0) {
        let ply = Ply::new(n, gamma).unwrap();
        for state in ply.equilibria(twist, Load { force, moment }).unwrap() {
            let (theta, q) = (state.contact().helical_angle(), state.contact().shift_ratio_squared());
            if !(0.05..1.5).contains(&theta) || (q - 1.0).abs() < 0.05 { continue; }
            for ends in [
                Ends::Loads(state.load()),
                Ends::Rotation { rotation: state.rotation(), force },
                Ends::Length { extension: state.extension(), moment },
            ] {
                let held = ply.equilibria_held(twist, ends).unwrap();
                if let Ends::Rotation { .. } = ends {
                    // below and above the angle of the most turns
                    prop_assert!(held.len() == 2 && held.iter().all(|s| s.handedness() == state.handedness()));
                    prop_assert!(held[0].contact().shift_ratio_squared() < 1.0 && held[1].contact().shift_ratio_squared() > 1.0);
                }
                if let Ends::Length { .. } = ends {
                    prop_assert!(held.len() == 2 && held[0].handedness() != held[1].handedness());
                }
                let near = |s: &&Equilibrium| s.handedness() == state.handedness() && (s.contact().helical_angle() - theta).abs() < 1e-9;
                let again = held.iter().find(near);
                prop_assert!(again.is_some(), "{ends:?} {held:?}");
                let Load { force: f, moment: m } = again.unwrap().load();
                let digits = 1e-8 * (1.0 + force.abs() + moment.abs() + state.pretwist().abs()) * f64::from(n);
                prop_assert!((f - force).abs() < digits && (m - moment).abs() < digits, "{f} {m} {state:?}");
                for s in &held {
                    let c2 = s.contact().angle().cos().powi(2);
                    let size = 1.0 + s.load().force.abs() + s.load().moment.abs() + s.pretwist().abs();
                    prop_assert!((s.balance_residual() * c2).abs() < 1e-12 * size * f64::from(n * n), "{s:?}");
                }
            }
        }
    }

    /// A free helix under a held rotation or length carries as a rod by itself: f/n = y(γu₃ε − y cos θ), εm/n = y sin²θ + γu₃ε cos θ.
    #[test]
    fn free_helices_held(n in 2..8_u32, gamma in 0.4..0.95, theta in 0.1..1.4_f64, wider in 1.01..4.0, u3 in -1.0..1.0_f64, hand in crate::hand()) {
        prop_assume!(u3.abs() > 0.05);
        let (s, c) = theta.sin_cos();
        let angle = HelicalAngle::new(theta).unwrap();
        let rho: f64 = wider * nply::geometry::Contact::at_angle(n, angle).unwrap().radius_ratio();
        let (eps, strands, y) = (hand.sign(), f64::from(n), s / rho);
        let force = strands * y * (eps * gamma * u3 - y * c);
        let moment = eps * strands * (y * s * s + eps * gamma * u3 * c);
        for ends in [Ends::Rotation { rotation: eps * y, force }, Ends::Length { extension: c, moment }] {
            // a held torque leaves the angle of a free helix open only through its bending
            for twist in [Twist::Pretwist(u3 - eps * y * c), Twist::StrandTwist(u3)] {
                let states = Ply::new(n, gamma).unwrap().supported_states(twist, ends, None).unwrap();
                let free = states.iter().find(|q| q.support() == Support::Free && (q.angle().radians() - theta).abs() < 1e-7 && q.handedness() == hand);
                prop_assert!(free.is_some(), "{ends:?} {twist:?} {states:?}");
                let (free, size) = (free.unwrap(), 1e-7 * strands);
                prop_assert!((free.radius_ratio() / rho - 1.0).abs() < 1e-7);
                prop_assert!((free.load().force - force).abs() < size && (free.load().moment - moment).abs() < size);
            }
        }
    }

    /// Link that was put in is there as twist and writhe; the writhe is that of n helices, −ε n sin θ cos θ/2πρ per strand length.
    #[test]
    fn link_is_kept(given in given()) {
        let n = f64::from(given.n);
        for state in given.states() {
            let link = state.link();
            let size = 1e-14 * n * (1.0 + state.pretwist().abs());
            prop_assert!((link.put_in - link.twist - link.writhe).abs() < size, "{link:?}");
            prop_assert!((link.put_in - n * state.pretwist() / TAU).abs() < size);
            let (s, c) = state.angle().radians().sin_cos();
            prop_assert!((link.writhe + state.handedness().sign() * n * s * c / (TAU * state.radius_ratio())).abs() < 1e-13 * n);
            prop_assert!(link.writhe * state.handedness().sign() < 0.0);
            // whatever the loads or the ends
            if let Twist::Pretwist(pretwist) = given.twist {
                prop_assert!((link.put_in - n * pretwist / TAU).abs() < size);
            }
        }
    }

    /// In the mirror the same states are found with the other hand, and their link has the other sign.
    #[test]
    fn the_mirror_image_has_the_other_link(given in given()) {
        let ends = match given.ends {
            Ends::Loads(Load { force, moment }) => Ends::Loads(Load { force, moment: -moment }),
            Ends::Rotation { rotation, force } => Ends::Rotation { rotation: -rotation, force },
            Ends::Length { extension, moment } => Ends::Length { extension, moment: -moment },
        };
        let twist = match given.twist {
            Twist::Pretwist(pretwist) => Twist::Pretwist(-pretwist),
            Twist::StrandTwist(u3) => Twist::StrandTwist(-u3),
        };
        let mirrored = Given { ends, twist, ..given.clone() }.states();
        let states = given.states();
        prop_assert_eq!(states.len(), mirrored.len());
        for state in &states {
            let image = mirrored.iter().find(|s| {
                s.support() == state.support() && s.handedness() != state.handedness() && s.angle() == state.angle() && s.radius_ratio() == state.radius_ratio()
            });
            prop_assert!(image.is_some(), "{state:?} {mirrored:?}");
            let (here, there) = (state.link(), image.unwrap().link());
            prop_assert_eq!((here.put_in, here.twist, here.writhe), (-there.put_in, -there.twist, -there.writhe));
        }
    }

    /// Touching strands keep the same ledger as states among supports do.
    #[test]
    fn loads_do_not_change_the_link(n in 2..12_u32, gamma in 0.4..1.4, pretwist in -2.0..2.0, loads in prop::collection::vec((-2.0..2.0, -3.0..3.0), 4)) {
        let ply = Ply::new(n, gamma).unwrap();
        for (force, moment) in loads {
            for state in ply.equilibria(Twist::Pretwist(pretwist), Load { force, moment }).unwrap() {
                let link = state.link();
                let size = 1e-14 * f64::from(n) * (1.0 + pretwist.abs());
                prop_assert!((link.put_in - f64::from(n) * pretwist / TAU).abs() < size);
                prop_assert!((link.twist + link.writhe - link.put_in).abs() < size);
            }
        }
    }
}

proptest! {
    #![proptest_config(config(600))]

    /// Strands lift off their core where a free helix lies on it: p_c = 0 and both slopes of the energy vanish.
    #[test]
    fn strands_lift_off_their_core_where_free_helices_lie_on_it(
        n in 2..9_u32, gamma in 0.4..1.5, twist in -1.5..1.5, given in -2.0..2.0, core in 0.2..3.0, by_force in any::<bool>(),
    ) {
        let ply = Ply::new(n, gamma).unwrap();
        let twist = Twist::Pretwist(twist);
        let lifted = if by_force { ply.lift_off_at_force(twist, given, core) } else { ply.lift_off_at_moment(twist, given, core) };
        for state in lifted.unwrap() {
            let load = state.load();
            let kept = if by_force { load.force } else { load.moment };
            prop_assert!((kept - given).abs() < 1e-12 * (1.0 + given.abs()), "{state:?}");
            prop_assert!(state.core_pressure().abs() < 1e-12 * (1.0 + load.force.abs() + load.moment.abs()));
            let (s, c, rho) = (state.angle().sin(), state.angle().cos(), state.radius_ratio());
            prop_assert!((rho - 1.0 - core).abs() < 1e-15 && state.neighbour_gap() > 0.0);
            // (40) at this radius, typed again
            let (strands, eps) = (f64::from(n), state.handedness().sign());
            let g = 2.0 * strands * s.powi(3) * c + eps * strands * rho * gamma * state.strand_twist() * (c * c - s * s)
                + rho * rho * load.force * s - eps * rho * load.moment * c;
            prop_assert!(g.abs() < 1e-12 * strands * rho * rho * (1.0 + load.force.abs() + load.moment.abs()), "{g} {state:?}");
            // and a helix that nothing carries is in equilibrium there too
            let free = ply.supported_states(twist, load, None).unwrap();
            let near = |s: &SupportedState| s.support() == Support::Free && (s.radius_ratio() / rho - 1.0).abs() < 1e-5;
            prop_assert!(state.neighbour_gap() < 1e-3 || s < 0.05 || rho * s < 0.05 || free.iter().any(near), "{state:?}");
        }
    }
}
