//! Where states end: folds, separation, the margins up to them, and the locus p = 0.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Cause, Change, Ends, Equilibrium, Limit, Load, Ply, Twist};
use nply::{DomainError, Handedness};
use proptest::prelude::*;

use crate::common::touch::{Touch, slope, touch, touch_at};
use crate::support::{any_twist, energy};
use crate::{config, strands};

/// The datum that is free.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Free {
    Force,
    Moment,
    Pretwist,
}

/// A ply, its twist and loads; one datum of them is varied.
#[derive(Clone, Debug)]
struct Data {
    ply: Ply,
    twist: Twist,
    load: Load,
    free: Free,
}

impl Data {
    fn with(&self, datum: f64) -> (Twist, Load) {
        match self.free {
            Free::Force => (self.twist, Load { force: datum, ..self.load }),
            Free::Moment => (self.twist, Load { moment: datum, ..self.load }),
            Free::Pretwist => (Twist::Pretwist(datum), self.load),
        }
    }

    fn states(&self, datum: f64) -> Vec<Equilibrium> {
        let (twist, load) = self.with(datum);
        self.ply.equilibria(twist, load).unwrap()
    }

    fn folds(&self) -> Vec<Equilibrium> {
        match self.free {
            Free::Force => self.ply.folds_at_moment(self.twist, self.load.moment).unwrap(),
            Free::Moment => self.ply.folds_at_force(self.twist, self.load.force).unwrap(),
            Free::Pretwist => self.ply.folds_at_loads(self.load).unwrap(),
        }
    }

    fn datum(&self, state: &Equilibrium) -> f64 {
        match self.free {
            Free::Force => state.load().force,
            Free::Moment => state.load().moment,
            Free::Pretwist => state.pretwist(),
        }
    }

    /// At which a state comes out of, or ends in, straight strands, m = nγ·twist, or flat rings, ρ → n/(π cos θ) and q → 1/cos²θ,
    /// where the balance leaves f = −επm/n and p_e nothing, or a pretwist without end.
    fn ends(&self) -> Vec<f64> {
        let n = f64::from(self.ply.strands());
        let (Twist::Pretwist(straight) | Twist::StrandTwist(straight)) = self.twist;
        match self.free {
            Free::Force => vec![PI * self.load.moment / n, -PI * self.load.moment / n],
            Free::Moment => {
                let rings = n * self.load.force / PI;
                vec![n * self.ply.stiffness_ratio() * straight, rings, -rings]
            }
            Free::Pretwist => vec![self.load.moment / (n * self.ply.stiffness_ratio())],
        }
    }
}

fn data() -> impl Strategy<Value = Data> {
    let free = prop_oneof![Just(Free::Force), Just(Free::Moment), Just(Free::Pretwist)];
    let balance = prop_oneof![3 => Just(Balance::Contact), 1 => Just(Balance::Radial)];
    (prop_oneof![1 => Just(2), 4 => strands()], 0.4..1.4, any_twist(), -2.0..2.0, -3.0..3.0, free, balance).prop_map(
        |(n, gamma, twist, force, moment, free, balance)| Data {
            ply: Ply::with_balance(n, gamma, balance).unwrap(),
            twist,
            load: Load { force, moment },
            free,
        },
    )
}

/// dE/dθ along touching strands, and how large its parts are.
fn slope_of_energy(state: &Equilibrium, theta: f64) -> f64 {
    let (n, gamma, eps) = (state.contact().strands(), state.stiffness_ratio(), state.handedness().sign());
    let h = 1e-3 * theta.min(FRAC_PI_2 - theta);
    slope(|t| energy(f64::from(n), gamma, eps, state.twist(), state.load(), t, touch_at(n, t).rho), theta, h)
}

/// ∂E/∂ρ, (37), and ∂E/∂θ at fixed ρ, (40) over nρ², typed again.
fn pressure_and_turning(touch: &Touch, gamma: f64, eps: f64, u3: f64, load: Load) -> (f64, f64) {
    let Touch { n, s, c, rho, .. } = *touch;
    let p = -s.powi(4) / rho.powi(3) - eps * gamma * u3 * s * c / (rho * rho) + eps * load.moment * s / (n * rho * rho);
    let g = 2.0 * n * s.powi(3) * c + eps * n * rho * gamma * u3 * (c * c - s * s) + rho * rho * load.force * s
        - eps * rho * load.moment * c;
    (p, g / (n * rho * rho))
}

fn strand_twist(twist: Twist, eps: f64, touch: &Touch) -> f64 {
    match twist {
        Twist::Pretwist(pretwist) => pretwist + eps * touch.s * touch.c / touch.rho,
        Twist::StrandTwist(u3) => u3,
    }
}

proptest! {
    #![proptest_config(config(400))]

    /// At a fold two states meet and end: the balance vanishes with its slope, and there are two states more on one side of it.
    #[test]
    fn two_states_meet_at_a_fold(data in data()) {
        let folds = data.folds();
        for fold in &folds {
            let (at, theta) = (data.datum(fold), fold.contact().helical_angle());
            prop_assert!(fold.is_fold());
            if !(0.03..1.54).contains(&theta) || at.abs() > 1e3 { continue; }
            let size = 1.0 + fold.load().force.abs() + fold.load().moment.abs() + fold.pretwist().abs();
            // at the corner of two strands the datum turns without a level place
            let corner = data.ply.strands() == 2 && (theta - FRAC_PI_4).abs() < 0.02;
            if !corner && data.ply.balance() == Balance::Contact {
                prop_assert!(slope_of_energy(fold, theta).abs() < 1e-8 * size, "{fold:?}");
                let h = 1e-3 * theta.min(FRAC_PI_2 - theta);
                let second = slope(|t| slope_of_energy(fold, t), theta, h);
                prop_assert!(second.abs() < 1e-4 * size, "{second} {fold:?}");
            } else if !corner {
                let eps = fold.handedness().sign();
                let turning = |t: f64| {
                    let t = touch_at(data.ply.strands(), t);
                    pressure_and_turning(&t, fold.stiffness_ratio(), eps, strand_twist(fold.twist(), eps, &t), fold.load()).1
                };
                prop_assert!(turning(theta).abs() < 1e-8 * size && slope(turning, theta, 1e-3 * theta.min(FRAC_PI_2 - theta)).abs() < 1e-6 * size, "{fold:?}");
            }
            // nothing else changes this near
            let aside = 1e-5 * (1.0 + at.abs());
            let others = folds.iter().filter(|f| *f != fold).map(|f| data.datum(f)).chain(data.ends());
            if others.map(|other| (other - at).abs()).fold(f64::MAX, f64::min) > 3.0 * aside {
                let count = |datum: f64| data.states(datum).len();
                prop_assert_eq!(count(at - aside).abs_diff(count(at + aside)), 2, "{:?}", fold);
            }
        }
    }

    /// As one datum runs over its range the number of states changes at folds, at straight strands and at flat rings, by two
    /// or by what ends there, and nowhere else.
    #[test]
    fn states_come_and_go_at_folds_alone(data in data(), wide in 1.0..12.0, start in 0.0..1.0) {
        let folds: Vec<f64> = data.folds().iter().map(|fold| data.datum(fold)).collect();
        let ends = data.ends();
        let steps = 120;
        let place = |k: i32| wide * ((f64::from(k) + start) / f64::from(steps) * 2.0 - 1.0);
        let mut before = data.states(place(0)).len();
        for k in 1..steps {
            let (from, to) = (place(k - 1), place(k));
            let after = data.states(to).len();
            let within = |list: &[f64]| list.iter().filter(|at| (from - 1e-9..=to + 1e-9).contains(*at)).count();
            let most = 2 * (within(&folds) + within(&ends));
            prop_assert!(before.abs_diff(after) <= most, "{before} states at {from}, {after} at {to}, {most} accounted for");
            if within(&ends) == 0 {
                prop_assert_eq!((before + after) % 2, 0, "between {} and {}", from, to);
                if within(&folds) == 1 && folds.iter().all(|at| (at - from).abs() > 1e-6 && (at - to).abs() > 1e-6) {
                    prop_assert_eq!(before.abs_diff(after), 2, "between {} and {}", from, to);
                }
            }
            before = after;
        }
    }
}

/// The state at a datum that has been changed, found among all states of its hand as the one nearest to where the last was.
fn follow(state: &Equilibrium, change: Change, by: f64, near: f64) -> Option<Equilibrium> {
    let ply = Ply::with_balance(state.contact().strands(), state.stiffness_ratio(), state.balance()).unwrap();
    let Load { force, moment } = state.load();
    let twist = state.twist();
    let states = match change {
        Change::Force => ply.equilibria(twist, Load { force: force + by, moment }),
        Change::Moment => ply.equilibria(twist, Load { force, moment: moment + by }),
        Change::Pretwist => ply.equilibria(Twist::Pretwist(state.pretwist() + by), state.load()),
        Change::Turns => ply.equilibria_held(twist, Ends::Rotation { rotation: state.rotation() + by, force }),
        Change::ForceEndsHeld => {
            ply.equilibria_held(twist, Ends::Rotation { rotation: state.rotation(), force: force + by })
        }
    };
    let away = |s: &Equilibrium| (s.contact().helical_angle() - near).abs();
    states
        .unwrap_or_default()
        .into_iter()
        .filter(|s| s.handedness() == state.handedness())
        .min_by(|a, b| away(a).total_cmp(&away(b)))
}

/// What a walk of the datum meets, and how far from the start the step ended in which it met it.
#[derive(Debug, PartialEq)]
enum Met {
    Nothing,
    Opened(f64),
    Lost(f64, f64),
}

/// 400 small steps of the datum up to `reach`, halved where the angle moves fast.
fn walk(state: &Equilibrium, change: Change, reach: f64) -> Met {
    let steps = 400;
    let mut near = state.contact().helical_angle();
    for k in 0..steps {
        let at = |parts: f64| reach * (f64::from(k) + parts) / f64::from(steps);
        let (mut done, mut part) = (0.0, 1.0);
        while done < 1.0 {
            match follow(state, change, at(done + part), near) {
                Some(next) if (next.contact().helical_angle() - near).abs() < 0.02 => {
                    if next.interstrand_pressure() < 0.0 {
                        return Met::Opened(at(done + part));
                    }
                    near = next.contact().helical_angle();
                    done += part;
                }
                _ if part > 1e-4 => part *= 0.5,
                _ => return Met::Lost(at(done), near),
            }
        }
    }
    Met::Nothing
}

fn check_side(state: &Equilibrium, change: Change, limit: Option<Limit>, side: f64) -> Result<(), TestCaseError> {
    let said = limit.map_or(f64::INFINITY, |limit| limit.change);
    let far = if change == Change::Turns { 1.0 } else { 20.0 };
    if limit.is_some() && (said.abs() > far || said.abs() < 1e-3) {
        return Ok(());
    }
    let reach = if limit.is_some() { 1.05 * said } else { side * far };
    let step = reach.abs() / 400.0;
    if let Some(Limit { cause: Cause::Fold, state: fold, .. }) = limit {
        // two folds closer together than a step of the walk: it may step over both
        let (twist, Load { force, moment }) = (state.twist(), state.load());
        let ply = Ply::with_balance(state.contact().strands(), state.stiffness_ratio(), state.balance()).unwrap();
        let (free, datum) = match change {
            Change::Force => (Free::Force, force + said),
            Change::Moment => (Free::Moment, moment + said),
            _ => (Free::Pretwist, state.pretwist() + said),
        };
        let data = Data { ply, twist, load: state.load(), free };
        let folds = data.folds();
        let near =
            folds.iter().filter(|f| f.handedness() == fold.handedness() && (data.datum(f) - datum).abs() < 3.0 * step);
        if near.count() > 1 {
            return Ok(());
        }
    }
    let met = walk(state, change, reach);
    let about = |by: f64| (by.abs() - said.abs()).abs() <= 1.01 * step;
    let good = match (&met, limit.map(|limit| limit.cause)) {
        (Met::Nothing, None) => true,
        (Met::Opened(by), Some(Cause::Separation)) => about(*by),
        // a fold just beyond the separation: the walk's finest step, of 1e-4, passes both
        (Met::Lost(by, angle), Some(Cause::Separation)) => {
            let parted = limit.map_or(f64::NAN, |limit| limit.state.contact().helical_angle());
            (by.abs() - said.abs()).abs() <= 2e-4 * step && (angle - parted).abs() < 0.02
        }
        (Met::Lost(by, _), Some(Cause::Fold | Cause::MostTurns | Cause::Straight)) => about(*by),
        (Met::Lost(by, angle), Some(Cause::Rings)) => about(*by) && *angle > 1.56,
        _ => false,
    };
    prop_assert!(good, "{change:?} {side}: said {limit:?}, met {met:?}, from {state:?}");
    Ok(())
}

/// Where a datum does next to no work many of its values have states next to each other: too near for a walk to tell them apart.
fn off_poles(state: &Equilibrium) -> bool {
    let (q, angle) = (state.contact().shift_ratio_squared(), state.contact().angle());
    let twisting = |q: f64| (angle.cos_double() - q * angle.cos().powi(2)).abs();
    (1.0 - q).abs() > 0.02 && twisting(q) > 0.02 && twisting(0.0) > 0.02
}

fn touching_state() -> impl Strategy<Value = Equilibrium> {
    let balance = prop_oneof![3 => Just(Balance::Contact), 1 => Just(Balance::Radial)];
    (2..9_u32, 0.4..1.4, any_twist(), -2.0..2.0, -3.0..3.0, any::<usize>(), balance).prop_filter_map(
        "no state that touches",
        |(n, gamma, twist, force, moment, which, balance)| {
            let states =
                Ply::with_balance(n, gamma, balance).unwrap().equilibria(twist, Load { force, moment }).unwrap();
            let touching: Vec<Equilibrium> = states
                .into_iter()
                .filter(|s| {
                    s.interstrand_pressure() > 1e-3
                        && (0.05..1.45).contains(&s.contact().helical_angle())
                        && off_poles(s)
                })
                .collect();
            (!touching.is_empty()).then(|| touching[which % touching.len()])
        },
    )
}

proptest! {
    #![proptest_config(config(150))]

    #[test]
    fn a_margin_is_how_far_one_can_walk(state in touching_state()) {
        for change in Change::ALL {
            if let Some(margin) = state.margin(change).unwrap() {
                prop_assert!(margin.below.is_none_or(|l| l.change < 0.0) && margin.above.is_none_or(|l| l.change >= 0.0));
                check_side(&state, change, margin.below, -1.0)?;
                check_side(&state, change, margin.above, 1.0)?;
            }
        }
    }
}

/// The extremes of a table of the locus of one hand, as the angles on either side of each.
fn turns_of(table: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let is_turn = |w: &&[(f64, f64)]| (w[1].1 - w[0].1) * (w[2].1 - w[1].1) < 0.0;
    table.windows(3).filter(is_turn).map(|w| (w[0].0, w[2].0)).collect()
}

proptest! {
    #![proptest_config(config(150))]

    /// Every point of the locus is a state on the verge: nothing presses, and both balances hold.
    #[test]
    fn the_locus_is_of_states_that_just_touch(n in strands(), gamma in 0.4..1.4, twist in any_twist(), points in 2..60_usize) {
        let ply = Ply::new(n, gamma).unwrap();
        let locus = ply.separation_locus(twist, points).unwrap();
        prop_assert_eq!(locus.len(), points);
        let (Twist::Pretwist(straight) | Twist::StrandTwist(straight)) = twist;
        for hand in Handedness::BOTH {
            let eps = hand.sign();
            let mut last = -1.0;
            for i in 0..points {
                let (angle, load) = locus.point(hand, i);
                let theta = angle.radians();
                prop_assert!(theta > last);
                last = theta;
                if angle.cos() < 1e-6 || theta == 0.0 { continue; }
                let t = touch(n, angle);
                let u3 = strand_twist(twist, eps, &t);
                let (p, turning) = pressure_and_turning(&t, gamma, eps, u3, load);
                let size = 1e-12 * (1.0 + u3.abs()) / (t.c * t.rho).min(1.0);
                prop_assert!(p.abs() < size && turning.abs() < size, "{p:e} {turning:e} at {theta}");
                let exact = ply.separation_at(angle, hand, twist).unwrap().load();
                prop_assert!((load.force - exact.force).abs() < 1e-12 * f64::from(n) && (load.moment - exact.moment).abs() < 1e-12 * f64::from(n));
            }
            let (start, first) = locus.point(hand, 0);
            prop_assert!(start.radians() == 0.0 && first.force == 0.0);
            prop_assert!((first.moment - f64::from(n) * gamma * straight).abs() < 1e-14 * f64::from(n));
            let (end, rings) = locus.point(hand, points - 1);
            let nothing = 1e-14 * f64::from(n);
            prop_assert!((end.radians() - FRAC_PI_2).abs() < 1e-15 && rings.force.abs() < nothing && rings.moment.abs() < nothing);
        }
    }

    /// Its turning points are those of a dense table.
    #[test]
    fn the_extremes_are_those_of_a_table(n in strands(), gamma in 0.4..1.4, twist in any_twist()) {
        let ply = Ply::new(n, gamma).unwrap();
        let extremes = ply.separation_extremes(twist).unwrap();
        let most = 1500;
        for hand in Handedness::BOTH {
            let at = |k: i32| ply.separation_at(HelicalAngle::new(FRAC_PI_2 * f64::from(k) / f64::from(most)).unwrap(), hand, twist).unwrap();
            let states: Vec<Equilibrium> = (0..most).map(at).collect();
            for (found, of) in extremes.iter().zip([(|load: Load| load.force) as fn(Load) -> f64, |load| load.moment]) {
                let table: Vec<(f64, f64)> = states.iter().map(|s| (s.contact().helical_angle(), of(s.load()))).collect();
                let angles: Vec<f64> = found.iter().filter(|s| s.handedness() == hand).map(|s| s.contact().helical_angle()).collect();
                for (low, high) in turns_of(&table) {
                    // the corner of two strands is no turning point of a smooth curve
                    let corner = n == 2 && (low..=high).contains(&FRAC_PI_4);
                    prop_assert!(corner || angles.iter().any(|t| (low..=high).contains(t)), "{low} {high}: {angles:?}");
                }
                for theta in angles {
                    let value = |t: f64| of(ply.separation_at(HelicalAngle::new(t).unwrap(), hand, twist).unwrap().load());
                    if !(0.01..1.5).contains(&theta) || n == 2 && (theta - FRAC_PI_4).abs() < 0.01 { continue; }
                    let rise = [value(theta - 1e-3) - value(theta), value(theta + 1e-3) - value(theta)];
                    prop_assert!(rise[0] * rise[1] > 0.0 || rise[0].abs().max(rise[1].abs()) < 1e-9, "{theta}: {rise:?}");
                }
            }
        }
    }

    /// Whichever datum is left to be found, the same states are on the verge.
    #[test]
    fn the_verge_is_the_same_from_every_side(n in strands(), gamma in 0.4..1.4, pretwist in -2.0..2.0, force in -2.0..2.0) {
        let ply = Ply::new(n, gamma).unwrap();
        let near = |states: Result<Vec<Equilibrium>, DomainError>, like: &Equilibrium| {
            let away = |s: &Equilibrium| {
                (s.contact().helical_angle() - like.contact().helical_angle()).abs()
                    + (s.pretwist() - like.pretwist()).abs()
                    + (s.load().force - like.load().force).abs()
                    + (s.load().moment - like.load().moment).abs()
            };
            states.unwrap().iter().filter(|s| s.handedness() == like.handedness()).map(away).fold(f64::MAX, f64::min)
        };
        for state in ply.separation_at_force(Twist::Pretwist(pretwist), force).unwrap() {
            let theta = state.contact().helical_angle();
            // where the locus turns, or the balance of the loads does, the angle has half the digits
            if !(0.05..1.5).contains(&theta) || n == 2 && (theta - FRAC_PI_4).abs() < 0.02 { continue; }
            prop_assert!(near(ply.separation_at_loads(state.load()), &state) < 1e-5, "{state:?}");
            prop_assert!(near(ply.separation_at_moment(state.twist(), state.load().moment), &state) < 1e-5, "{state:?}");
        }
        for state in ply.separation_at_loads(Load { force, moment: pretwist }).unwrap() {
            let theta = state.contact().helical_angle();
            if !(0.05..1.5).contains(&theta) || n == 2 && (theta - FRAC_PI_4).abs() < 0.02 { continue; }
            let t = touch_at(n, theta);
            let eps = state.handedness().sign();
            let (p, turning) = pressure_and_turning(&t, gamma, eps, strand_twist(state.twist(), eps, &t), state.load());
            let size = 1e-9 * (1.0 + state.pretwist().abs());
            prop_assert!(p.abs() < size && turning.abs() < size, "{p:e} {turning:e} {state:?}");
            prop_assert_eq!(state.load(), Load { force, moment: pretwist });
            prop_assert!(near(ply.separation_at_force(state.twist(), force), &state) < 1e-5, "{state:?}");
        }
    }
}

/// Touching strands have one radius at each angle, so that the walk of a margin starts where the state is.
#[test]
fn a_state_is_found_where_it_is() {
    let ply = Ply::new(3, 0.75).unwrap();
    let state = ply.equilibria(Twist::Pretwist(-0.5), Load::NONE).unwrap()[0];
    for change in Change::ALL {
        let again = follow(&state, change, 0.0, state.contact().helical_angle()).unwrap();
        assert!((again.contact().helical_angle() - state.contact().helical_angle()).abs() < 1e-12, "{change:?}");
    }
    assert!(
        (Contact::new(3, state.contact().helical_angle()).unwrap().radius_ratio() - state.contact().radius_ratio())
            .abs()
            < 1e-14
    );
}
