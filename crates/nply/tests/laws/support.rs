//! Supports: every contact pushes, and energy is stationary on what the contacts leave free.

use nply::Handedness;
use nply::geometry::Contact;
use nply::mechanics::{Balance, Load, Ply, Stability, Support, SupportedState, Twist};
use proptest::prelude::*;

use crate::config;

/// (56) per strand, typed again, at any θ and ρ.
fn energy(n: f64, gamma: f64, eps: f64, twist: f64, load: Load, theta: f64, rho: f64) -> f64 {
    let (s, c) = theta.sin_cos();
    let u3 = twist + eps * s * c / rho;
    s.powi(4) / (2.0 * rho * rho) + 0.5 * gamma * u3 * u3 - load.force / n * c - eps * load.moment / (n * rho) * s
}

/// (∂E/∂θ, ∂E/∂ρ) by central differences of fourth order.
fn slopes(e: impl Fn(f64, f64) -> f64, theta: f64, rho: f64) -> (f64, f64) {
    let d = |f: &dyn Fn(f64) -> f64, h: f64| (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
    (d(&|h| e(theta + h, rho), 1e-3 * theta), d(&|h| e(theta, rho + h), 1e-3 * rho))
}

proptest! {
    #![proptest_config(config(1500))]

    #[test]
    fn contacts_balance_the_slopes_of_energy(
        n in 2..10_u32, gamma in 0.4..1.5, twist in -2.0..2.0, f in -3.0..12.0, m in -8.0..12.0, core in 0.2..3.0, cored in any::<bool>(),
    ) {
        let load = Load { force: f, moment: m };
        let ply = Ply::new(n, gamma).unwrap();
        let core = cored.then_some(core);
        for state in ply.supported_states(Twist::Pretwist(twist), load, core).unwrap() {
            let SupportedState { support, handedness, angle, radius_ratio: rho, interstrand_pressure: p1, core_pressure: pc, .. } = state;
            prop_assert!(p1 >= 0.0 && pc >= 0.0 && state.neighbour_gap >= 0.0 && state.core_gap >= 0.0, "{state:?}");
            prop_assert_eq!(p1 > 0.0, matches!(support, Support::Neighbours | Support::Both));
            prop_assert_eq!(pc > 0.0, matches!(support, Support::Core | Support::Both));
            let theta = angle.radians();
            if !(0.02..=1.55).contains(&theta) { continue; } // differences lose their digits there
            let (n, eps) = (f64::from(n), handedness.sign());
            let (by_angle, by_radius) = slopes(|t, r| energy(n, gamma, eps, twist, load, t, r), theta, rho);
            // ∂E/∂θ = −p₁ x²ρ² cot θ/2 and ∂E/∂ρ = 2p₁/ρ + p_c
            let touching = Contact::at_angle(ply.strands(), angle).unwrap();
            let x = touching.arclength_shift();
            let size = 1e-8 * (1.0 + f.abs() + m.abs());
            prop_assert!((by_angle + 0.5 * p1 * x * x * rho * rho / theta.tan()).abs() < size, "{by_angle} {state:?}");
            prop_assert!((by_radius - 2.0 * p1 / rho - pc).abs() < size, "{by_radius} {state:?}");
            prop_assert!((state.neighbour_gap - 2.0 * (rho / touching.radius_ratio() - 1.0)).abs() < 1e-12);
        }
    }

    #[test]
    fn inside_the_wedge_the_core_fixes_the_angle(
        n in 3..10_u32, gamma in 0.4..1.5, twist in -2.0..2.0, along in 0.01..20.0, across in 0.02..0.98, wider in 1.01..2.5,
    ) {
        let ply = Ply::new(n, gamma).unwrap();
        let core = wider / (std::f64::consts::PI / f64::from(n)).sin() - 1.0;
        for wedge in ply.wedges(Twist::Pretwist(twist), core).unwrap().unwrap() {
            let (a, b) = (wedge.neighbours_just_touch, wedge.core_just_touches);
            let at = |share: f64| Load {
                force: wedge.tip.force + along * ((1.0 - share) * a.force + share * b.force),
                moment: wedge.tip.moment + along * ((1.0 - share) * a.moment + share * b.moment),
            };
            let both = |load| {
                ply.supported_states(Twist::Pretwist(twist), load, Some(core)).unwrap().into_iter()
                    .find(|s| s.support == Support::Both && s.handedness == wedge.handedness)
            };
            let inside = both(at(across));
            prop_assert!(inside.is_some_and(|s| (s.angle.radians() - wedge.angle.radians()).abs() < 1e-14));
            prop_assert!(both(at(-0.02)).is_none() && both(at(1.02)).is_none());
        }
    }

    /// A free helix is a rod by itself: its moment and force along the axis are M = sin³θ/ρ + γu₃ cos θ·ε …, typed again.
    #[test]
    fn free_helices_carry_their_loads_alone(n in 2..8_u32, gamma in 0.4..1.5, theta in 0.05..1.5, wider in 1.001..4.0, u3 in -1.0..1.0, left in any::<bool>()) {
        let (s, c) = f64::sin_cos(theta);
        let rho: f64 = wider * Contact::new(n, theta).unwrap().radius_ratio();
        let hand = if left { Handedness::Left } else { Handedness::Right };
        let (eps, strands) = (hand.sign(), f64::from(n));
        let load = Load {
            force: strands * s / rho * (eps * gamma * u3 - s * c / rho),
            moment: strands * (eps * s * s * s / rho + gamma * u3 * c),
        };
        let pretwist = u3 - eps * s * c / rho;
        for twist in [Twist::Pretwist(pretwist), Twist::StrandTwist(u3)] {
            let states = Ply::new(n, gamma).unwrap().supported_states(twist, load, None).unwrap();
            prop_assert!(
                states.iter().any(|q| q.support == Support::Free && q.handedness == hand
                    && (q.angle.radians() - theta).abs() < 1e-7 && (q.radius_ratio / rho - 1.0).abs() < 1e-6),
                "{theta} {rho}: {states:?}"
            );
        }
    }

    /// Where only the core carries, the state is one of radial balance at the core's radius.
    #[test]
    fn on_the_core_balance_is_radial(n in 3..8_u32, gamma in 0.4..1.5, twist in -1.0..1.0, f in 0.0..10.0, core in 0.3..3.0) {
        let ply = Ply::with_balance(n, gamma, Balance::Radial).unwrap();
        for state in ply.supported_states(Twist::Pretwist(twist), Load { force: f, moment: 0.0 }, Some(core)).unwrap() {
            if state.support == Support::Core {
                let (theta, rho, eps, strands) = (state.angle.radians(), 1.0 + core, state.handedness.sign(), f64::from(n));
                let (s, c) = theta.sin_cos();
                // (40)
                let g = 2.0 * strands * s.powi(3) * c + eps * strands * rho * gamma * state.strand_twist * (2.0 * theta).cos() + rho * rho * f * s;
                prop_assert!(g.abs() < 1e-11 * (1.0 + f) * rho * rho * strands, "{g} {state:?}");
            }
        }
    }

    /// A stable state is where energy is least among its neighbours along touching strands, an unstable one is not; and a state that
    /// may lift off too (θ and ρ both free, ρ above contact) has no way down either.
    #[test]
    fn stable_states_are_least_in_energy(n in 2..10_u32, gamma in 0.4..1.5, twist in -3.0..3.0, f in -0.5..3.0, m in -3.0..3.0, lift in 0.0..1.0) {
        let load = Load { force: f, moment: m };
        for state in Ply::new(n, gamma).unwrap().equilibria(Twist::Pretwist(twist), load).unwrap() {
            let Some(verdict) = state.stability() else { continue };
            let theta = state.contact().helical_angle();
            // the corner of two strands at 45° has two curvatures, and the ends are too near to step aside
            if !(0.05..1.5).contains(&theta) || n == 2 && (theta - std::f64::consts::FRAC_PI_4).abs() < 0.01 { continue; }
            let e = |t: f64, above: f64| {
                let rho = Contact::new(n, t).unwrap().radius_ratio() + above;
                energy(f64::from(n), gamma, state.handedness().sign(), twist, load, t, rho)
            };
            let h = 1e-3;
            let sides = [e(theta - h, 0.0) - e(theta, 0.0), e(theta + h, 0.0) - e(theta, 0.0)];
            if state.second_variation().unwrap().abs() > 0.02 {
                prop_assert_eq!(verdict == Stability::Stable, sides.iter().all(|rise| *rise > 0.0), "{:?} {:?}", state, sides);
                prop_assert_eq!(verdict == Stability::Unstable, sides.iter().all(|rise| *rise < 0.0), "{:?} {:?}", state, sides);
            }
            if verdict == Stability::Stable && state.interstrand_pressure() > 1e-3 {
                let up = 1e-5 * lift;
                prop_assert!(e(theta, up) >= e(theta, 0.0), "{state:?} lifts off");
            }
        }
    }
}
