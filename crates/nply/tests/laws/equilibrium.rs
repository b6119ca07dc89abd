//! Equilibrium: energy, forces, flexibility, inverses, scales.

use std::f64::consts::FRAC_PI_4;

use nply::geometry::{Centreline, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::{Handedness, Scale};
use proptest::prelude::*;

use crate::common::touch::{slope, touch_at};
use crate::common::vector::{Vector, add, cross, norm, sub, times};
use crate::{config, hand, strands};

/// (56) along the branch, by bisection: E(θ, ρ(θ)) at a state's data.
fn energy(state: &Equilibrium, theta: f64) -> f64 {
    let t = touch_at(state.contact().strands(), theta);
    let (eps, gamma) = (state.handedness().sign(), state.stiffness_ratio());
    let u3 = match state.twist() {
        Twist::Pretwist(pretwist) => pretwist + eps * t.s * t.c / t.rho,
        Twist::StrandTwist(_) => unreachable!("pretwist is given here"),
    };
    let Load { force, moment } = state.load();
    t.s.powi(4) / (2.0 * t.rho * t.rho) + gamma / 2.0 * u3 * u3
        - state.external_pressure() * t.rho
        - force / t.n * t.c
        - eps * moment / (t.n * t.rho) * t.s
}

/// A state at a random angle, its moment solved for; away from π/4, where the 2-ply's branch has a corner.
fn state(balance: Balance) -> impl Strategy<Value = Equilibrium> {
    let data = (strands(), 0.4..1.4_f64, 3.0..80.0_f64, hand(), -2.0..2.0_f64, -3.0..3.0_f64, any::<bool>());
    data.prop_filter_map("no moment does work here", move |(n, gamma, degrees, hand, pretwist, force, pressed)| {
        let pressure = if pressed && balance == Balance::Contact { 0.3 } else { 0.0 };
        let ply = Ply::with_balance(n, gamma, balance).unwrap().with_external_pressure(pressure).unwrap();
        let theta = degrees.to_radians();
        let angle = HelicalAngle::new(theta).unwrap();
        let state = ply.moment_at(angle, hand, Twist::Pretwist(pretwist), force).ok()?;
        ((theta - FRAC_PI_4).abs() > 0.02 && state.load().moment.abs() < 1e3).then_some(state)
    })
}

fn either() -> impl Strategy<Value = Equilibrium> {
    prop_oneof![state(Balance::Contact), state(Balance::Radial)]
}

fn ply(state: &Equilibrium) -> Ply {
    Ply::with_balance(state.contact().strands(), state.stiffness_ratio(), state.balance())
        .unwrap()
        .with_external_pressure(state.external_pressure())
        .unwrap()
}

/// How far the nearest of `states` with this hand is from this angle.
fn nearest(states: &[Equilibrium], state: &Equilibrium) -> f64 {
    let away = |s: &&Equilibrium| (s.contact().helical_angle() - state.contact().helical_angle()).abs();
    states.iter().filter(|s| s.handedness() == state.handedness()).map(|s| away(&s)).fold(f64::MAX, f64::min)
}

/// Terms of the balance, for tolerances.
fn size(state: &Equilibrium) -> f64 {
    let (n, rho) = (f64::from(state.contact().strands()), state.contact().radius_ratio());
    let q = state.contact().shift_ratio_squared();
    (1.0 + q)
        * (3.0 * n
            + n * rho * 2.0 * state.pretwist().abs()
            + rho * rho * state.load().force.abs()
            + rho * state.load().moment.abs())
        + n * rho.powi(3) * q * state.external_pressure().abs()
}

proptest! {
    #![proptest_config(config(300))]

    /// Contact balance is dE/dθ = 0 along the branch, external pressure or none, and its slope is nρ² d²E/dθ².
    #[test]
    fn contact_balance_is_the_slope_of_energy(state in state(Balance::Contact)) {
        let theta = state.contact().helical_angle();
        let (n, rho) = (f64::from(state.contact().strands()), state.contact().radius_ratio());
        let h = 0.02 * (theta - FRAC_PI_4).abs().min(theta).min(2.0 * FRAC_PI_4 - theta);
        let first = |theta: f64| slope(|t| energy(&state, t), theta, h);
        prop_assert!((energy(&state, theta) - state.energy().total()).abs() < 1e-12 * (1.0 + size(&state)));
        let g = n * rho * rho * first(theta);
        prop_assert!(g.abs() < (1e-6 + 1e-13 / h * rho * rho) * size(&state), "{g:e} of {:e}", size(&state));
        let want = n * rho * rho * slope(first, theta, h);
        let got = state.balance_slope();
        let slack = (1e-5 / h + 1e-13 / (h * h) * rho * rho) * size(&state);
        prop_assert!((got - want).abs() < slack, "{got:e} {want:e} {slack:e}");
        prop_assert!(state.balance_residual().abs() < 1e-13 * size(&state) / state.contact().angle().cos().powi(2));
    }

    /// Radial balance is the slope of energy at a fixed radius.
    #[test]
    fn radial_balance_is_the_partial_slope(state in state(Balance::Radial)) {
        let (n, rho, eps) =
            (f64::from(state.contact().strands()), state.contact().radius_ratio(), state.handedness().sign());
        let Load { force, moment } = state.load();
        let e = |theta: f64, rho: f64| {
            let (s, c) = theta.sin_cos();
            let u3 = state.pretwist() + eps * s * c / rho;
            s.powi(4) / (2.0 * rho * rho) + state.stiffness_ratio() / 2.0 * u3 * u3 - force / n * c - eps * moment / (n * rho) * s
        };
        let theta = state.contact().helical_angle();
        let g = n * rho * rho * slope(|t| e(t, rho), theta, 1e-3);
        prop_assert!(g.abs() < 1e-9 * rho * rho * size(&state), "{g:e}");
        let p = slope(|rho| e(theta, rho), rho, 1e-3 * rho);
        prop_assert!((p - state.radial_pressure()).abs() < 1e-9 * size(&state));
        prop_assert!((f64::from(state.contact().strands()) * state.strand_resultant().axial_force - force).abs() < 1e-12);
    }

    /// A plane across the ply: what the upper part does to the lower, summed strand by strand and contact by contact, is
    /// the applied force and moment.
    #[test]
    fn all_forces_across_a_plane(state in state(Balance::Contact)) {
        let (contact, hand, n) = (state.contact(), state.handedness(), state.contact().strands());
        let strand = |i: u32| Centreline::new(contact, hand, i);
        let inside = state.strand_resultant();
        let (mut force, mut moment): (Vector, Vector) = ([0.0; 3], [0.0; 3]);
        let mut largest = 1.0 + state.load().moment.abs();
        let mut act = |f: Vector, at: Vector, couple: Vector| {
            force = add(force, f);
            moment = add(moment, add(couple, cross(at, f)));
            largest += norm(f) * (1.0 + norm(at));
        };
        let shift = -hand.sign() * contact.arclength_shift() * contact.radius_ratio();
        for i in 0..n {
            let (at, frame) = (strand(i).position(0.0), strand(i).frame(0.0));
            let e_r = times(-1.0, frame.normal);
            let e_psi = cross([0.0, 0.0, 1.0], e_r);
            let along = |psi: f64, z: f64| add(times(psi, e_psi), [0.0, 0.0, z]);
            act(along(inside.hoop_force, inside.axial_force), at, along(inside.hoop_moment, inside.axial_moment));
            // section s₁ of this strand touches s₁ + shift of the next: one below the plane, one above, for s₁ between
            // −shift and 0
            let steps = 16;
            for k in 0..steps {
                let s1 = -shift * (f64::from(k) + 0.5) / f64::from(steps);
                let (here, there) = (strand(i).position(s1), strand(i + 1).position(s1 + shift));
                let towards = sub(here, there);
                let p21 = times(state.interstrand_pressure() * shift.abs() / f64::from(steps) / norm(towards), towards);
                let middle = times(0.5, add(here, there));
                // on whichever is below
                if here[2] < 0.0 { act(p21, middle, [0.0; 3]) } else { act(times(-1.0, p21), middle, [0.0; 3]) }
            }
        }
        let Load { force: f, moment: m } = state.load();
        prop_assert!((force[2] - f).abs() < 1e-12 * largest, "{force:?} {f}");
        prop_assert!((moment[2] - m).abs() < 1e-12 * largest, "{moment:?} {m}");
        // strands in equal turns about the axis: nothing across it
        prop_assert!(force[0].hypot(force[1]) < 1e-12 * largest && moment[0].hypot(moment[1]) < 1e-11 * largest);
    }

    /// Maxwell and Betti; and differences of states solved anew under loads a little off.
    #[test]
    fn flexibility(state in either()) {
        prop_assume!(state.flexibility().is_some());
        let [[ff, fm], [mf, mm]] = state.flexibility().unwrap();
        if state.balance() == Balance::Contact {
            prop_assert!((fm - mf).abs() <= 1e-13 * fm.abs().max((ff * mm).abs().sqrt()), "{fm:e} {mf:e}");
            prop_assert!((ff * mm - fm * mf).abs() <= 1e-12 * (ff * mm).abs(), "rank one");
        } else if state.contact().shift_ratio_squared() > 0.1 {
            prop_assert!((fm - mf).abs() > 1e-3 * fm.abs(), "radial balance: not symmetric");
        }
        let reach = size(&state) / state.balance_slope().abs(); // rad per relative change of the loads
        prop_assume!(reach < 1e3);
        let again = |force: f64, moment: f64| {
            let load = Load { force: state.load().force + force, moment: state.load().moment + moment };
            let states = ply(&state).equilibria(state.twist(), load).unwrap();
            let near = |s: &&Equilibrium| (s.contact().helical_angle() - state.contact().helical_angle()).abs();
            let of_hand = states.into_iter().filter(|s| s.handedness() == state.handedness()).collect::<Vec<_>>();
            let best = of_hand.iter().min_by(|a, b| near(a).total_cmp(&near(b))).copied();
            best.map_or((f64::NAN, f64::NAN), |s| (s.extension(), s.rotation()))
        };
        let h = 1e-4 / reach.max(1.0);
        let (hf, hm) = (h, h);
        let by_force = |k: fn((f64, f64)) -> f64| slope(|f| k(again(f, 0.0)), 0.0, hf);
        let by_moment = |k: fn((f64, f64)) -> f64| slope(|m| k(again(0.0, m)), 0.0, hm);
        let scale = ff.abs() + fm.abs() + mf.abs() + mm.abs();
        for (got, want) in [(ff, by_force(|d| d.0)), (mf, by_force(|d| d.1)), (fm, by_moment(|d| d.0)), (mm, by_moment(|d| d.1))] {
            prop_assert!((got - want).abs() < 1e-5 * scale * reach.max(1.0) + 1e-14 / h, "{got:e} {want:e}");
        }
    }

    /// What holds a state finds it.
    #[test]
    fn holders_are_inverse(state in either(), by_strand in any::<bool>()) {
        let (ply, angle, hand) = (ply(&state), state.contact().angle(), state.handedness());
        let reach = size(&state) / state.balance_slope().abs() / angle.cos().powi(2);
        prop_assume!(reach < 1e4);
        let (near, same) = (1e-13 * reach + 1e-13, 1e-11 * size(&state) / angle.cos().powi(2));
        let Load { force, moment } = state.load();
        prop_assert!(nearest(&ply.equilibria(state.twist(), state.load()).unwrap(), &state) < near);
        let twist = if by_strand { Twist::StrandTwist(state.strand_twist()) } else { state.twist() };
        let again = ply.force_at(angle, hand, twist, moment).unwrap();
        prop_assert!((again.load().force - force).abs() < same / angle.sin(), "{:?}", again.load());
        prop_assert_eq!(again.load().moment, moment);
        let again = ply.moment_at(angle, hand, twist, force).unwrap();
        prop_assert!((again.load().moment - moment).abs() < same * (1.0 + moment.abs()), "{:?}", again.load());
        if let Ok(again) = ply.pretwist_at(angle, hand, state.load()) {
            let works = (angle.cos_double() - state.contact().shift_ratio_squared() * angle.cos().powi(2)).abs();
            prop_assert!((again.pretwist() - state.pretwist()).abs() < same / works.min(1.0));
        }
        let fixed = ply.force_at(angle, hand, Twist::StrandTwist(state.strand_twist()), moment).unwrap();
        prop_assert!((fixed.pretwist() - state.pretwist()).abs() < 1e-14 * (1.0 + state.pretwist().abs()));
        let found = ply.equilibria(fixed.twist(), fixed.load()).unwrap();
        let reach = size(&fixed) / fixed.balance_slope().abs() / angle.cos().powi(2);
        prop_assert!(nearest(&found, &state) < 1e-13 * reach + 1e-13);
    }

    /// The pressure of radial balance, put on from outside, leaves the neighbours nothing to carry.
    #[test]
    fn radial_balance_is_contact_under_its_own_pressure(state in state(Balance::Radial)) {
        let pressed = Ply::new(state.contact().strands(), state.stiffness_ratio())
            .unwrap()
            .with_external_pressure(state.resultant_pressure())
            .unwrap();
        let again = pressed.moment_at(state.contact().angle(), state.handedness(), state.twist(), state.load().force).unwrap();
        prop_assume!((state.contact().shift_ratio_squared() - 1.0).abs() > 1e-2);
        prop_assert!((again.load().moment - state.load().moment).abs() < 1e-10 * size(&state));
        prop_assert!(again.interstrand_pressure().abs() < 1e-10 * size(&state));
        let found = pressed.equilibria(state.twist(), state.load()).unwrap();
        let reach = size(&again) / again.balance_slope().abs() / state.contact().angle().cos().powi(2);
        prop_assert!(nearest(&found, &state) < 1e-12 * reach + 1e-12);
    }

    /// States with p = 0, from either load, in both balances the same.
    #[test]
    fn separation(n in strands(), gamma in 0.4..1.4_f64, pretwist in -2.0..2.0_f64, load in -2.0..2.0_f64, by_strand in any::<bool>()) {
        let twist = if by_strand { Twist::StrandTwist(pretwist) } else { Twist::Pretwist(pretwist) };
        let [contact, radial] = Balance::BOTH.map(|b| Ply::with_balance(n, gamma, b).unwrap());
        for (states, others) in [
            (contact.separation_at_force(twist, load).unwrap(), radial.separation_at_force(twist, load).unwrap()),
            (contact.separation_at_moment(twist, load).unwrap(), radial.separation_at_moment(twist, load).unwrap()),
        ] {
            prop_assert_eq!(states.len(), others.len());
            for (state, other) in states.iter().zip(&others) {
                prop_assert!((state.contact().helical_angle() - other.contact().helical_angle()).abs() < 1e-15);
                let rho = state.contact().radius_ratio();
                let c = state.contact().angle().cos();
                prop_assert!(state.resultant_pressure().abs() < 1e-13 * (1.0 + state.load().moment.abs()) / c, "{state:?}");
                prop_assert!(state.balance_residual().abs() < 1e-12 * size(state) / (c * c) + 1e-12 * rho * rho, "{state:?}");
                let of = |s: &Equilibrium| if states[0].load().force == load { s.load().force } else { s.load().moment };
                prop_assert_eq!(of(state), load);
                let (found, reach) =
                    (contact.equilibria(twist, state.load()).unwrap(), size(state) / state.balance_slope().abs() / (c * c));
                if reach < 1e4 {
                    prop_assert!(nearest(&found, state) < 1e-11 * reach);
                }
            }
        }
    }

    /// The other hand under mirrored twist and moment: the same angle, and these signs change.
    #[test]
    fn mirror_image(state in either()) {
        let (Twist::Pretwist(twist) | Twist::StrandTwist(twist)) = state.twist();
        let Load { force, moment } = state.load();
        let other = ply(&state)
            .equilibria(Twist::Pretwist(-twist), Load { force, moment: -moment })
            .unwrap();
        let here = ply(&state).equilibria(state.twist(), state.load()).unwrap();
        prop_assert_eq!(here.len(), other.len());
        let of = |states: &[Equilibrium], hand: Handedness| {
            states.iter().filter(|s| s.handedness() == hand).copied().collect::<Vec<_>>()
        };
        for hand in Handedness::BOTH {
            for (a, b) in of(&here, hand).iter().zip(&of(&other, hand.opposite())) {
                prop_assert_eq!(a.contact(), b.contact());
                prop_assert_eq!(a.strand_twist(), -b.strand_twist());
                prop_assert_eq!(a.rotation(), -b.rotation());
                prop_assert_eq!(a.ply_twist(), -b.ply_twist());
                prop_assert_eq!(a.extension(), b.extension());
                prop_assert_eq!(a.resultant_pressure(), b.resultant_pressure());
                prop_assert_eq!(a.energy(), b.energy());
                let (x, y) = (a.strand_resultant(), b.strand_resultant());
                prop_assert_eq!((x.axial_force, x.axial_moment), (y.axial_force, -y.axial_moment));
                prop_assert_eq!((x.hoop_force, x.hoop_moment), (-y.hoop_force, y.hoop_moment));
                if let (Some(x), Some(y)) = (a.flexibility(), b.flexibility()) {
                    prop_assert_eq!((x[0][0], x[0][1], x[1][0], x[1][1]), (y[0][0], -y[0][1], -y[1][0], y[1][1]));
                }
                if let (Some(x), Some(y)) = (a.stiffness(), b.stiffness()) {
                    prop_assert_eq!((x.torsional, x.axial), (y.torsional, y.axial));
                    prop_assert_eq!((x.force_per_twist, x.moment_per_extension), (-y.force_per_twist, -y.moment_per_extension));
                }
            }
        }
    }

    /// Each quantity by its own powers of r and B.
    #[test]
    fn scales(r in 0.01..100.0_f64, b in 0.01..100.0_f64, k in 1.1..5.0_f64, v in -9.0..9.0_f64) {
        let unit = Scale::new(r, b).unwrap();
        let (wide, stiff) = (Scale::new(k * r, b).unwrap(), Scale::new(r, k * b).unwrap());
        type Quantity = fn(Scale, f64) -> f64;
        let powers: [(Quantity, i32, i32); 7] = [
            (Scale::length, 1, 0),
            (Scale::per_length, -1, 0),
            (Scale::force, -2, 1),
            (Scale::moment, -1, 1),
            (Scale::stiffness, 0, 1),
            (Scale::force_per_length, -3, 1),
            (Scale::energy_per_length, -2, 1),
        ];
        for (quantity, of_r, of_b) in powers {
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b.abs();
            prop_assert!(near(quantity(unit, v), v * r.powi(of_r) * b.powi(of_b)));
            prop_assert!(near(quantity(wide, v), quantity(unit, v) * k.powi(of_r)));
            prop_assert!(near(quantity(stiff, v), quantity(unit, v) * k.powi(of_b)));
        }
        prop_assert_eq!((unit.strand_radius(), unit.bending_stiffness()), (r, b));
    }
}

#[test]
fn straight_strands_hold() {
    for n in 2..=12 {
        let ply = Ply::new(n, 0.75).unwrap();
        let held = f64::from(n) * 0.75 * -0.2;
        assert!(ply.straight_holds(Twist::Pretwist(-0.2), Load { force: 3.0, moment: held }));
        assert!(ply.straight_holds(Twist::StrandTwist(-0.2), Load { force: -3.0, moment: held }));
        assert!(ply.straight_holds(Twist::Pretwist(0.0), Load::NONE));
        assert!(!ply.straight_holds(Twist::Pretwist(-0.2), Load { force: 3.0, moment: 1.001 * held }));
    }
}
