//! A row of data solved at once finds what solving value by value finds.
#![allow(missing_docs, clippy::unwrap_used, clippy::disallowed_methods)]

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Along, Balance, Equilibrium, Load, Ply, RowState, Stability, Twist};
use proptest::prelude::*;

#[derive(Clone, Debug)]
struct Case {
    strands: u32,
    balance: Balance,
    gamma: f64,
    twist: Twist,
    load: Load,
    along: Along,
    values: Vec<f64>,
}

impl Case {
    fn ply(&self, gamma: f64) -> Ply {
        Ply::with_balance(self.strands, gamma, self.balance).unwrap()
    }

    /// The states of one value, by the solver that knows no rows.
    fn alone(&self, x: f64) -> Vec<Equilibrium> {
        let (mut gamma, mut twist, mut load) = (self.gamma, self.twist, self.load);
        match self.along {
            Along::Force => load.force = x,
            Along::Moment => load.moment = x,
            Along::Pretwist => twist = Twist::Pretwist(x),
            Along::StrandTwist => twist = Twist::StrandTwist(x),
            Along::StiffnessRatio => gamma = x,
        }
        self.ply(gamma).equilibria(twist, load).unwrap()
    }

    /// The states of every value, by the row.
    fn row(&self) -> Vec<Vec<RowState>> {
        let mut found = vec![Vec::new(); self.values.len()];
        let push = |i: usize, state| found[i].push(state);
        self.ply(self.gamma).each_equilibrium_along(self.along, &self.values, self.twist, self.load, push).unwrap();
        for states in &mut found {
            let left = |s: &RowState| s.handedness == Handedness::Left;
            states.sort_by(|a, b| left(a).cmp(&left(b)).then(b.pitch_angle.total_cmp(&a.pitch_angle)));
        }
        found
    }

    /// Compares; gives the number of states.
    fn hold(&self) -> usize {
        let mut count = 0;
        for (&x, row) in self.values.iter().zip(self.row()) {
            let alone = self.alone(x);
            // next to no twist or moment coils the strands next to not at all, but it does
            assert!(alone.iter().all(|state| state.contact().helical_angle() > 0.0), "straight strands are no state");
            count += alone.len();
            if alone.len() == row.len() {
                row.iter().zip(&alone).for_each(|(row, alone)| self.same(x, row, alone));
            } else {
                // two states that rounding cannot tell apart may be told apart, be one, or be none
                let near = |a: &HelicalAngle, b: &HelicalAngle| (a.radians() - b.radians()).abs() < 1e-6;
                let angles: Vec<_> = alone.iter().map(|s| s.contact().angle()).collect();
                let met = alone.iter().any(Equilibrium::is_fold)
                    || angles.windows(2).any(|pair| near(&pair[0], &pair[1]))
                    || row.len() == alone.len() + 2
                        && row.windows(2).any(|pair| (pair[0].helical_angle - pair[1].helical_angle).abs() < 1e-6);
                assert!(met, "x = {x}: {row:#?} instead of {alone:#?} of {self:?}");
            }
        }
        count
    }

    fn same(&self, x: f64, row: &RowState, alone: &Equilibrium) {
        let contact = alone.contact();
        assert_eq!(row.handedness, alone.handedness(), "{self:?}");
        // how far rounding of the balance's terms may move a root
        let (n, rho) = (f64::from(self.strands), contact.radius_ratio());
        let gamma = alone.stiffness_ratio();
        let (f, m) = (alone.load().force.abs(), alone.load().moment.abs());
        let size = n + n * gamma * (1.0 + rho * alone.pretwist().abs()) + rho * rho * f + rho * m;
        let moved = 16.0 * f64::EPSILON * size / alone.balance_slope().abs();
        let (angle, pitch) = (contact.helical_angle(), contact.pitch_angle());
        let allowed = if alone.is_fold() { 1e-6 } else { 1e-12 * angle.min(pitch) + moved.min(1e-6) };
        let off = if angle < pitch { row.helical_angle - angle } else { pitch - row.pitch_angle };
        assert!(off.abs() <= allowed, "x = {x}: off by {off:e} > {allowed:e}: {row:?} for {alone:?} of {self:?}");
        assert!((row.helical_angle + row.pitch_angle - std::f64::consts::FRAC_PI_2).abs() < 4e-16);

        let s = contact.angle().sin();
        let scale = s / (rho * rho) * (m / n + gamma * (alone.pretwist().abs() + contact.torsion()) + s * s * s / rho);
        let close = |got: f64, exact: f64, scale: f64| {
            let allowed = scale * (1e-12 + 4.0 * allowed / angle.min(pitch));
            assert!((got - exact).abs() <= allowed, "x = {x}: {got} for {exact}: {row:?} of {self:?}");
            exact.abs() > allowed
        };
        // 1 − cos β, by which contact forces add up to a radial pressure
        let half = (0.5 * contact.anomaly()).sin();
        let (radial, apart) = match self.balance {
            Balance::Contact => (rho * rho * half * half, 0.5 * rho),
            Balance::Radial => (1.0, 0.5 / (rho * half * half)),
        };
        close(row.resultant_pressure, alone.resultant_pressure(), scale * radial);
        if close(row.interstrand_pressure, alone.interstrand_pressure(), scale * apart) {
            assert_eq!(row.is_separated(), alone.is_separated(), "{row:?} of {self:?}");
            let (one, other) = (row.stability, alone.stability());
            let marginal = [one, other].contains(&Some(Stability::Marginal));
            assert!(one == other || marginal, "x = {x}: {row:?} for {alone:?} of {self:?}");
        }
    }
}

fn load(largest: f64) -> impl Strategy<Value = f64> {
    prop_oneof![
        2 => Just(0.0),
        1 => -1e-6..1e-6_f64,
        4 => -2.0..2.0_f64,
        2 => -largest..largest,
    ]
}

/// Rows of every width about 0 or elsewhere, even or not, some of one value.
fn values(along: Along) -> impl Strategy<Value = Vec<f64>> {
    let width = prop_oneof![Just(1e-6), Just(0.5), Just(3.0), Just(20.0), Just(1e3)];
    (width, -1.0..1.0_f64, proptest::collection::vec(-1.0..1.0_f64, 1..40), any::<bool>()).prop_map(
        move |(width, shift, parts, even)| {
            let last = (parts.len().max(2) - 1) as f64;
            let place = |i: usize, part: f64| if even { 2.0 * i as f64 / last - 1.0 } else { part };
            let mut values: Vec<f64> =
                parts.iter().enumerate().map(|(i, &part)| width * (place(i, part) + shift)).collect();
            if even {
                values.push(0.0);
            }
            if along == Along::StiffnessRatio {
                values = values.iter().map(|value| value.abs() + 1e-3).collect();
            }
            values.sort_by(f64::total_cmp);
            values
        },
    )
}

fn case() -> impl Strategy<Value = Case> {
    let strands = prop_oneof![8 => 2..=12_u32, 1 => Just(40_u32)];
    let twist = prop_oneof![
        1 => Just(Twist::Pretwist(0.0)),
        3 => (-3.0..3.0_f64).prop_map(Twist::Pretwist),
        1 => (-3.0..3.0_f64).prop_map(Twist::StrandTwist),
    ];
    let along = proptest::sample::select(Along::ALL.as_slice());
    let balance = proptest::sample::select(Balance::BOTH.as_slice());
    (strands, balance, 0.3..1.5_f64, twist, load(50.0), load(20.0), along, any::<bool>()).prop_flat_map(
        |(strands, balance, gamma, twist, force, mut moment, along, straight)| {
            if let (Twist::Pretwist(pretwist), true) = (twist, straight) {
                moment = f64::from(strands) * gamma * pretwist; // straight strands hold
            }
            values(along).prop_map(move |mut values| {
                if along == Along::Moment && straight {
                    values.push(moment);
                    values.sort_by(f64::total_cmp);
                }
                Case { strands, balance, gamma, twist, load: Load { force, moment }, along, values }
            })
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_row_finds_what_each_value_finds(case in case()) {
        case.hold();
    }
}

fn even(low: f64, high: f64, count: u32) -> Vec<f64> {
    (0..count).map(|i| low + (high - low) * f64::from(i) / f64::from(count - 1)).collect()
}

#[test]
fn a_map_finds_what_each_pixel_finds() {
    for (strands, balance) in
        [(2, Balance::Contact), (3, Balance::Contact), (3, Balance::Radial), (7, Balance::Contact)]
    {
        let mut states = 0;
        for moment in even(-3.0, 3.0, 200) {
            let (gamma, twist, load) = (0.75, Twist::Pretwist(-0.2), Load { force: 0.0, moment });
            let case = Case { strands, balance, gamma, twist, load, along: Along::Force, values: even(-2.0, 2.0, 200) };
            states += case.hold();
        }
        assert!(states > 40_000, "{states} states");
    }
}

/// Rows through chosen states, folds among them: the moment and the force of each are worked out.
#[test]
fn rows_through_folds() {
    for strands in [2, 3, 5, 12] {
        for along in [Along::Force, Along::Moment] {
            for theta in even(0.08, 1.5, 60) {
                let ply = Ply::new(strands, 0.75).unwrap();
                let at = |theta: f64, force: f64| {
                    let angle = HelicalAngle::new(theta).unwrap();
                    ply.moment_at(angle, Handedness::Right, Twist::Pretwist(-0.5), force).unwrap()
                };
                // dm/dθ along given force is linear in the force: its zero makes θ a fold
                let slope = |force: f64| at(theta, force).balance_slope();
                let (s0, s1) = (slope(0.0), slope(1.0));
                let force = -s0 / (s1 - s0);
                let fold = at(theta, force);
                if !(force.abs() < 1e3 && fold.load().moment.abs() < 1e3) {
                    continue;
                }
                let middle = if along == Along::Force { force } else { fold.load().moment };
                let mut values = vec![middle];
                for k in 0..12 {
                    let lift = 10_f64.powi(-k) * (0.1 + middle.abs());
                    values.extend([middle - lift, middle + lift]);
                }
                values.sort_by(f64::total_cmp);
                let load = fold.load();
                let (balance, gamma, twist) = (Balance::Contact, 0.75, Twist::Pretwist(-0.5));
                let count = Case { strands, balance, gamma, twist, load, along, values }.hold();
                assert!(count > 0);
            }
        }
    }
}

/// Values a few units in the last place about those whose states lie where two cells of the branch meet: each is found once.
#[test]
fn rows_through_borders() {
    for strands in [2, 3, 7] {
        for balance in Balance::BOTH {
            let ply = Ply::with_balance(strands, 0.75, balance).unwrap();
            for i in 1..96 {
                let (quarter, part) = (std::f64::consts::FRAC_PI_4 / 48.0, f64::from(i.min(96 - i)));
                let angle = match i {
                    0..=48 => HelicalAngle::new(quarter * part),
                    _ => HelicalAngle::from_pitch_angle(quarter * part),
                };
                let (hand, twist, moment) = (Handedness::Left, Twist::Pretwist(0.3), 0.4);
                let force = ply.force_at(angle.unwrap(), hand, twist, moment).unwrap().load().force;
                let mut values: Vec<f64> =
                    (0..40).scan(force, |x, _| Some(std::mem::replace(x, x.next_up()))).collect();
                values.extend((0..40).scan(force, |x, _| Some(std::mem::replace(x, x.next_down()))));
                values.sort_by(f64::total_cmp);
                let load = Load { force, moment };
                let case = Case { strands, balance, gamma: 0.75, twist, load, along: Along::Force, values };
                assert!(case.hold() >= 80);
            }
        }
    }
}

#[test]
fn data_that_are_refused() {
    let ply = Ply::new(3, 0.75).unwrap();
    let along = |ply: &Ply, along, values: &[f64], twist, load| {
        ply.each_equilibrium_along(along, values, twist, load, |_, _| ()).map_err(|error| error.quantity)
    };
    let (twist, none) = (Twist::Pretwist(-0.2), Load::NONE);
    assert_eq!(along(&ply, Along::Force, &[], twist, none), Ok(()));
    assert_eq!(along(&ply, Along::Force, &[0.0, 0.0], twist, none), Ok(()));
    assert_eq!(along(&ply, Along::Force, &[0.0, f64::NAN], twist, none), Err("force"));
    assert_eq!(along(&ply, Along::Moment, &[1.0, 0.0], twist, none), Err("moment"));
    assert_eq!(along(&ply, Along::StrandTwist, &[f64::INFINITY], twist, none), Err("strand_twist"));
    assert_eq!(along(&ply, Along::StiffnessRatio, &[0.0, 1.0], twist, none), Err("stiffness_ratio"));
    let nowhere = Load { force: f64::NAN, moment: 0.0 };
    assert_eq!(along(&ply, Along::Moment, &[0.0], twist, nowhere), Err("force"));
    assert_eq!(along(&ply, Along::Force, &[0.0], twist, nowhere), Ok(())); // the varied datum's own value is ignored
    let pressed = ply.with_external_pressure(-0.1).unwrap();
    assert_eq!(along(&pressed, Along::Force, &[0.0], twist, none), Err("external_pressure"));
}

/// The datum that holds an angle, put back in, gives that angle again.
#[test]
fn a_point_of_a_row_is_a_state() {
    for balance in Balance::BOTH {
        for (strands, degrees) in [(2, 12.0), (2, 63.0), (3, 31.0), (3, 71.0), (6, 20.0)] {
            let ply = Ply::with_balance(strands, 0.7, balance).unwrap();
            let contact = Contact::new(strands, f64::to_radians(degrees)).unwrap();
            let (twist, load) = (Twist::Pretwist(-0.3), Load { force: 0.2, moment: -0.4 });
            for hand in Handedness::BOTH {
                for along in Along::ALL {
                    let found = ply.equilibrium_along(along, contact, hand, twist, load);
                    let Ok((x, state)) = found else {
                        assert_eq!(along, Along::StiffnessRatio, "{found:?}"); // it would have to be negative
                        continue;
                    };
                    assert!(state.balance_residual().abs() < 1e-12, "{along:?}: {state:?}");
                    let again = match along {
                        Along::Force => ply.equilibria(twist, Load { force: x, ..load }),
                        Along::Moment => ply.equilibria(twist, Load { moment: x, ..load }),
                        Along::Pretwist => ply.equilibria(Twist::Pretwist(x), load),
                        Along::StrandTwist => ply.equilibria(Twist::StrandTwist(x), load),
                        Along::StiffnessRatio => {
                            Ply::with_balance(strands, x, balance).unwrap().equilibria(twist, load)
                        }
                    };
                    let near = |s: &nply::mechanics::Equilibrium| {
                        s.handedness() == hand && (s.contact().angle().degrees() - degrees).abs() < 1e-9
                    };
                    assert!(again.unwrap().iter().any(near), "{along:?} {x} {strands} {degrees} {hand:?}");
                }
            }
        }
    }
}
