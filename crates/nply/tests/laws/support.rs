//! Supports: every contact pushes, energy is stationary on what the contacts leave free, and the ends carry what the strands and
//! their contacts carry together.

use std::f64::consts::{FRAC_PI_4, TAU};

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Ends, Holding, Load, Ply, Stability, Support, SupportedState, Twist};
use proptest::prelude::*;

use crate::common::touch::{bisect, slope, touch_at};
use crate::common::vector::{Vector, add, cross, dot, norm, sub, times};
use crate::{config, hand, strands};

/// (56) per strand, typed again, at any θ and ρ; a strand twist that is held works against its moment through Love's torsion.
pub(crate) fn energy(n: f64, gamma: f64, eps: f64, twist: Twist, load: Load, theta: f64, rho: f64) -> f64 {
    let (s, c) = theta.sin_cos();
    let torsion = eps * s * c / rho;
    let twisting = match twist {
        Twist::Pretwist(pretwist) => 0.5 * gamma * (pretwist + torsion).powi(2),
        Twist::StrandTwist(u3) => gamma * u3 * torsion,
    };
    s.powi(4) / (2.0 * rho * rho) + twisting - load.force / n * c - eps * load.moment / (n * rho) * s
}

/// A ply, its twist, how its ends are held, and its core.
#[derive(Clone, Debug)]
pub(crate) struct Given {
    pub(crate) n: u32,
    pub(crate) gamma: f64,
    pub(crate) twist: Twist,
    pub(crate) ends: Ends,
    pub(crate) core: Option<f64>,
}

impl Given {
    pub(crate) fn ply(&self) -> Ply {
        Ply::new(self.n, self.gamma).unwrap()
    }

    pub(crate) fn states(&self) -> Vec<SupportedState> {
        self.ply().supported_states(self.twist, self.ends, self.core).unwrap()
    }

    /// The energy of one hand under given loads.
    pub(crate) fn energy(&self, hand: Handedness, load: Load) -> impl Fn(f64, f64) -> f64 {
        let (n, gamma, twist) = (f64::from(self.n), self.gamma, self.twist);
        move |theta, rho| energy(n, gamma, hand.sign(), twist, load, theta, rho)
    }
}

pub(crate) fn any_twist() -> impl Strategy<Value = Twist> {
    prop_oneof![(-2.0..2.0).prop_map(Twist::Pretwist), (-1.0..1.0).prop_map(Twist::StrandTwist)]
}

/// Dead loads, the rotation held, or the length held.
pub(crate) fn any_ends() -> impl Strategy<Value = Ends> {
    let turns = prop_oneof![-0.8..-0.02, 0.02..0.8];
    prop_oneof![
        3 => (-3.0..12.0, -8.0..12.0).prop_map(|(force, moment)| Ends::Loads(Load { force, moment })),
        1 => (turns, -3.0..6.0).prop_map(|(rotation, force)| Ends::Rotation { rotation, force }),
        1 => (0.1..0.995, -6.0..8.0).prop_map(|(extension, moment)| Ends::Length { extension, moment }),
    ]
}

pub(crate) fn given() -> impl Strategy<Value = Given> {
    let data = (2..10_u32, 0.4..1.5, any_twist(), any_ends(), prop_oneof![Just(None), (0.2..3.0).prop_map(Some)]);
    data.prop_map(|(n, gamma, twist, ends, core)| Given { n, gamma, twist, ends, core })
}

/// (∂E/∂θ, ∂E/∂ρ) by central differences of fourth order.
fn slopes(e: impl Fn(f64, f64) -> f64, theta: f64, rho: f64) -> (f64, f64) {
    let d = |f: &dyn Fn(f64) -> f64, h: f64| (8.0 * (f(h) - f(-h)) - (f(2.0 * h) - f(-2.0 * h))) / (12.0 * h);
    (d(&|h| e(theta + h, rho), 1e-3 * theta), d(&|h| e(theta, rho + h), 1e-3 * rho))
}

/// Where the least distance of two curves in space has strand 0 at arclength 0 touch the next one round, as far as `reach` down it:
/// there the line between the points is square to the tangent.
fn shift_to_the_next(
    strand: &impl Fn(u32, f64) -> Vector,
    tangent: &impl Fn(u32, f64) -> Vector,
    eps: f64,
    reach: f64,
) -> f64 {
    let apart = |s: f64| sub(strand(1, -eps * s), strand(0, 0.0));
    let step = reach / 400.0;
    let near =
        (0..=400).map(|k| f64::from(k) * step).min_by(|a, b| norm(apart(*a)).total_cmp(&norm(apart(*b)))).unwrap();
    let slant = |s: f64| -eps * dot(apart(s), tangent(1, -eps * s));
    -eps * bisect(slant, (near - step).max(0.0), near + step)
}

proptest! {
    #![proptest_config(config(1500))]

    /// On the contact set: ∂E/∂θ = −p₁ x²ρ² cot θ/2 and ∂E/∂ρ = 2p₁/ρ + p_c, whatever is held, and no contact pulls or overlaps.
    #[test]
    fn contacts_balance_the_slopes_of_energy(given in given()) {
        for state in given.states() {
            let (support, angle, rho, load) = (state.support(), state.angle(), state.radius_ratio(), state.load());
            let (p1, pc) = (state.interstrand_pressure(), state.core_pressure());
            prop_assert!(p1 >= 0.0 && pc >= 0.0 && state.neighbour_gap() >= 0.0 && state.core_gap().is_none_or(|gap| gap >= 0.0), "{state:?}");
            prop_assert_eq!(p1 > 0.0, matches!(support, Support::Neighbours | Support::Both));
            prop_assert_eq!(pc > 0.0, matches!(support, Support::Core | Support::Both));
            match given.ends {
                Ends::Loads(given) => prop_assert_eq!(load, given),
                Ends::Rotation { force, .. } => prop_assert_eq!(load.force, force),
                Ends::Length { moment, .. } => prop_assert_eq!(load.moment, moment),
            }
            let theta = angle.radians();
            if !(0.02..=1.55).contains(&theta) { continue; } // differences lose their digits there
            let (by_angle, by_radius) = slopes(given.energy(state.handedness(), load), theta, rho);
            let touching = Contact::at_angle(given.n, angle).unwrap();
            let x = touching.arclength_shift();
            let size = 1e-8 * (1.0 + load.force.abs() + load.moment.abs());
            prop_assert!((by_angle + 0.5 * p1 * x * x * rho * rho / theta.tan()).abs() < size, "{by_angle} {state:?}");
            prop_assert!((by_radius - 2.0 * p1 / rho - pc).abs() < size, "{by_radius} {state:?}");
            prop_assert!((state.neighbour_gap() - 2.0 * (rho / touching.radius_ratio() - 1.0)).abs() < 1e-12);
        }
    }

    /// What crosses a plane across the ply adds up to the end loads: the strands' own forces and moments, by the statics of a rod
    /// (n′ = −contact forces, m′ = n × t, m = κb + γu₃t), and every contact that joins a point above with one below.
    #[test]
    fn a_plane_across_the_ply_carries_the_loads(given in given()) {
        for state in given.states() {
            let (eps, theta, rho, n) = (state.handedness().sign(), state.angle().radians(), state.radius_ratio(), given.n);
            if !(0.05..=1.5).contains(&theta) { continue; }
            let (s, c) = theta.sin_cos();
            let azimuth = |i: u32, at: f64| eps * at * s / rho + TAU * f64::from(i) / f64::from(n);
            let strand = |i: u32, at: f64| [rho * azimuth(i, at).cos(), rho * azimuth(i, at).sin(), at * c];
            let outward = |i: u32, at: f64| [azimuth(i, at).cos(), azimuth(i, at).sin(), 0.0];
            let axis = [0.0, 0.0, 1.0];
            let along = |i: u32, at: f64| add(times(eps * s, cross(axis, outward(i, at))), times(c, axis));
            let touching = matches!(state.support(), Support::Neighbours | Support::Both);
            let shift = if touching { shift_to_the_next(&strand, &along, eps, TAU / f64::from(n) * rho / s) } else { 0.0 };
            // what the contact with strand i + 1, and that with strand i − 1, does to strand i per length of it
            let push = |i: u32, at: f64, next: bool| {
                let there = if next { strand(i + 1, at + shift) } else { strand(i + n - 1, at - shift) };
                let towards = sub(strand(i, at), there);
                times(if touching { state.interstrand_pressure() / norm(towards) } else { 0.0 }, towards)
            };
            if touching {
                prop_assert!((norm(sub(strand(1, shift), strand(0, 0.0))) - 2.0).abs() < 1e-9, "{state:?}");
            }
            let (mut force, mut moment): (Vector, Vector) = ([0.0; 3], [0.0; 3]);
            let mut largest = 1.0;
            let mut act = |f: Vector, at: Vector, couple: Vector| {
                force = add(force, f);
                moment = add(moment, add(couple, cross(at, f)));
                largest += norm(f) * (1.0 + norm(at)) + norm(couple);
            };
            for i in 0..n {
                let e_r = outward(i, 0.0);
                let e_psi = cross(axis, e_r);
                let tangent = along(i, 0.0);
                let binormal = cross(tangent, times(-1.0, e_r));
                let couple = add(times(s * s / rho, binormal), times(given.gamma * state.strand_twist(), tangent));
                // everything turns about the axis with the strand
                let change = |v: Vector| times(eps * s / rho, cross(axis, v));
                let shear = cross(tangent, change(couple)); // m′ = n × t
                let load = add(add(push(i, 0.0, true), push(i, 0.0, false)), times(state.core_pressure(), e_r));
                prop_assert!(norm(sub(load, times(dot(load, e_r), e_r))) < 1e-7 * (1.0 + norm(load)), "radial by symmetry");
                // n′ = −load: −ε(sin θ/ρ) n_ψ = −load
                let hoop = dot(load, e_r) * rho * eps / s;
                let tension = (hoop - dot(shear, e_psi)) / (eps * s);
                act(add(times(tension, tangent), shear), strand(i, 0.0), couple);
                let steps = 8;
                for k in 0..steps {
                    let here = -shift * (f64::from(k) + 0.5) / f64::from(steps);
                    let p = times(shift.abs() / f64::from(steps), push(i, here, true));
                    let middle = times(0.5, add(strand(i, here), strand(i + 1, here + shift)));
                    // on whichever of the two is below
                    act(if here < 0.0 { p } else { times(-1.0, p) }, middle, [0.0; 3]);
                }
            }
            let Load { force: f, moment: m } = state.load();
            prop_assert!((force[2] - f).abs() < 1e-7 * largest, "{force:?} {state:?}");
            prop_assert!((moment[2] - m).abs() < 1e-7 * largest, "{moment:?} {state:?}");
            prop_assert!(force[0].hypot(force[1]) < 1e-7 * largest && moment[0].hypot(moment[1]) < 1e-7 * largest);
        }
    }

    /// Limp strands: where the loads are everything, M/F = R tan θ/(1 − q). The angle comes to that as one over the loads, by what the
    /// strands' own energy makes of the second variation of the loads' alone.
    #[test]
    fn great_loads_make_strands_limp(n in strands(), gamma in 0.4..1.5, theta in 0.15..1.3, hand in hand(), pull in 0.3..2.0, twist in any_twist()) {
        let contact = Contact::new(n, theta).unwrap();
        let q = contact.shift_ratio_squared();
        prop_assume!((q - 1.0).abs() > 0.1 && !(n == 2 && (theta - FRAC_PI_4).abs() < 0.05));
        let ratio = hand.sign() * contact.radius_ratio() * theta.tan() / (1.0 - q);
        let of = |load: Load, t: f64| energy(f64::from(n), gamma, hand.sign(), twist, load, t, touch_at(n, t).rho);
        let unit = Load { force: pull, moment: pull * ratio };
        let work = |t: f64| of(unit, t) - of(Load::NONE, t);
        let bend = slope(|t| slope(work, t, 1e-2), theta, 1e-2);
        let first_order = -slope(|t| of(Load::NONE, t), theta, 1e-3) / bend;
        prop_assume!(bend.abs() > 0.05 * (1.0 + unit.moment.abs()) / f64::from(n) && first_order.abs() < 30.0);
        for greatness in [1e5, 2e5] {
            let load = Load { force: greatness * unit.force, moment: greatness * unit.moment };
            let states = Ply::new(n, gamma).unwrap().equilibria(twist, load).unwrap();
            let off = states.iter().filter(|s| s.handedness() == hand).map(|s| s.contact().helical_angle() - theta);
            let off = off.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap();
            prop_assert!((off * greatness - first_order).abs() < 1e-2 * (0.1 + first_order.abs()), "{} {first_order}", off * greatness);
        }
        // straight from the balance: the moment is linear in the force, and what is left over does not grow with it
        let moment = |force: f64| Ply::new(n, gamma).unwrap().moment_at(HelicalAngle::new(theta).unwrap(), hand, twist, force).unwrap().load().moment;
        let left_over = |force: f64| moment(force) - ratio * force;
        prop_assert!((left_over(1e4) - left_over(0.0)).abs() < 1e-9 * (1.0 + moment(1e4).abs()));
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
                    .find(|s| s.support() == Support::Both && s.handedness() == wedge.handedness)
            };
            let inside = both(at(across));
            prop_assert!(inside.is_some_and(|s| (s.angle().radians() - wedge.angle.radians()).abs() < 1e-14));
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
                states.iter().any(|q| q.support() == Support::Free && q.handedness() == hand
                    && (q.angle().radians() - theta).abs() < 1e-7 && (q.radius_ratio() / rho - 1.0).abs() < 1e-6),
                "{theta} {rho}: {states:?}"
            );
        }
    }

    /// Where only the core carries, the state is one of radial balance at the core's radius.
    #[test]
    fn on_the_core_balance_is_radial(n in 3..8_u32, gamma in 0.4..1.5, twist in -1.0..1.0, f in 0.0..10.0, core in 0.3..3.0) {
        let ply = Ply::with_balance(n, gamma, Balance::Radial).unwrap();
        for state in ply.supported_states(Twist::Pretwist(twist), Load { force: f, moment: 0.0 }, Some(core)).unwrap() {
            if state.support() == Support::Core {
                let (theta, rho, eps, strands) = (state.angle().radians(), 1.0 + core, state.handedness().sign(), f64::from(n));
                let (s, c) = theta.sin_cos();
                // (40)
                let g = 2.0 * strands * s.powi(3) * c + eps * strands * rho * gamma * state.strand_twist() * (2.0 * theta).cos() + rho * rho * f * s;
                prop_assert!(g.abs() < 1e-11 * (1.0 + f) * rho * rho * strands, "{g} {state:?}");
            }
        }
    }

    /// What is free of all contacts has the curvatures of the energy over angle and rotation, differenced: held at its rotation that along the
    /// angle, at its length that along the rotation, and under dead loads the least there is.
    #[test]
    fn free_helices_have_the_curvatures_of_the_energy(given in given()) {
        for state in given.states() {
            let (theta, y) = (state.angle().radians(), state.rotation().abs());
            if state.support() != Support::Free || !(0.1..1.45).contains(&theta) || y < 1e-3 { continue; }
            let e = given.energy(state.handedness(), state.load());
            let (h, k) = (1e-4, 1e-4 * y);
            let at = |i: f64, j: f64| {
                let (angle, rotation) = (theta + h * i, y + k * j);
                e(angle, angle.sin() / rotation)
            };
            let aa = (at(1.0, 0.0) - 2.0 * at(0.0, 0.0) + at(-1.0, 0.0)) / (h * h);
            let yy = (at(0.0, 1.0) - 2.0 * at(0.0, 0.0) + at(0.0, -1.0)) / (k * k);
            let ay = (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * h * k);
            let least = 0.5 * (aa + yy) - (0.25 * (aa - yy) * (aa - yy) + ay * ay).sqrt();
            // what differences leave of numbers of the energy's size
            let rounding = 1e-15 * (1.0 + at(0.0, 0.0).abs() + state.load().force.abs() + state.load().moment.abs() * y);
            let near = |got: Option<f64>, wanted: f64| {
                (got.unwrap() - wanted).abs() < 1e-5 * (aa.abs() + yy.abs() + ay.abs()) + 4.0 * rounding / (h * h).min(k * k)
            };
            prop_assert!(near(state.second_variation(Holding::Rotation), aa), "{state:?} {aa}");
            prop_assert!(near(state.second_variation(Holding::Length), yy), "{state:?} {yy}");
            prop_assert!(near(state.second_variation(Holding::DeadLoads), least), "{state:?} {least}");
        }
    }

    /// A lay length is the ply length in which a strand goes round once: by it and by the length ratio the ply's rotation is that of its strands.
    #[test]
    fn once_round_in_a_lay_length(given in given()) {
        for state in given.states() {
            let turns = state.extension() / state.lay_length(); // per strand length
            let rotation = state.handedness().sign() * TAU * turns;
            prop_assert!((rotation - state.rotation()).abs() < 1e-12 * rotation.abs(), "{state:?}");
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
                energy(f64::from(n), gamma, state.handedness().sign(), Twist::Pretwist(twist), load, t, rho)
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
