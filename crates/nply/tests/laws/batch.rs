//! Arrays of plies at once, held against one ply at a time.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle, contact_batch};
use nply::mechanics::{Balance, Equilibrium, Load, Plies, Ply, States, Twist, Twists};
use proptest::prelude::*;

use super::config;

fn contacts(strands: &[u32], angles: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<usize>) {
    let (mut shift, mut radius) = (vec![0.0; strands.len()], vec![0.0; strands.len()]);
    let mut refused = Vec::new();
    contact_batch(strands, angles, &mut shift, &mut radius, |row, _| refused.push(row)).unwrap();
    (shift, radius, refused)
}

/// Units in the last place between two numbers of one sign.
fn units(got: f64, want: f64) -> u64 {
    got.to_bits().abs_diff(want.to_bits())
}

/// Both ends, π/4 and the doubles next to it, borders of any halving of the range, and what lies between.
fn angles() -> impl Strategy<Value = f64> {
    let ulps = |from: f64| (-40..=40_i64).prop_map(move |k| f64::from_bits(from.to_bits().wrapping_add_signed(k)));
    prop_oneof![
        4 => 0.0..FRAC_PI_2,
        1 => (-300.0..0.0_f64).prop_map(|e| 10_f64.powf(e)),
        1 => (-15.0..0.0_f64).prop_map(|e| FRAC_PI_2 - 10_f64.powf(e)),
        1 => (-16.0..-1.0_f64).prop_map(|e| FRAC_PI_4 + 10_f64.powf(e)),
        1 => ulps(FRAC_PI_4),
        1 => (0..=96_i32).prop_map(|k| FRAC_PI_2 * f64::from(k) / 96.0),
        1 => (1..=40_u64).prop_map(|k| f64::from_bits(FRAC_PI_2.to_bits() - k)),
    ]
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn contacts_of_an_array_are_those_of_its_rows(
        rows in prop::collection::vec((prop_oneof![2 => Just(2_u32), 6 => 2..=12_u32, 1 => 13..=1000_u32], angles()), 0..150),
    ) {
        let (strands, angles): (Vec<u32>, Vec<f64>) = rows.into_iter().unzip();
        let (shift, radius, refused) = contacts(&strands, &angles);
        prop_assert!(refused.is_empty());
        for (i, (&n, &theta)) in strands.iter().zip(&angles).enumerate() {
            let one = Contact::new(n, theta).unwrap();
            let (x, rho) = (one.arclength_shift(), one.radius_ratio());
            prop_assert!(units(shift[i], x) <= 8, "n = {n} at {theta:e}: x {:e}, alone {x:e}", shift[i]);
            prop_assert!(units(radius[i], rho) <= 8, "n = {n} at {theta:e}: ρ {:e}, alone {rho:e}", radius[i]);
        }
    }
}

#[test]
fn a_refused_row_touches_no_other() {
    let count = 100;
    let strands: Vec<u32> = (0..count).map(|i| 2 + i % 12).collect(); // up to thirteen
    let angles: Vec<f64> = (0..count).map(|i| 0.015 * f64::from(i)).collect();
    let (shift, radius, _) = contacts(&strands, &angles);
    let bad = [
        (0, 1, 0.3),
        (7, 0, 0.3),
        (33, 3, f64::NAN),
        (34, 3, -1e-300),
        (35, 3, 1.571),
        (63, 40, f64::INFINITY),
        (99, u32::MAX, -0.1),
    ];
    let (mut n, mut theta) = (strands, angles);
    for (row, strands, angle) in bad {
        (n[row], theta[row]) = (strands, angle);
    }
    let (mut x, mut rho) = (vec![0.0; n.len()], vec![0.0; n.len()]);
    let mut reasons = Vec::new();
    contact_batch(&n, &theta, &mut x, &mut rho, |row, error| reasons.push((row, error.quantity))).unwrap();
    let angle = "helical_angle";
    let want = [(0, "strands"), (7, "strands"), (33, angle), (34, angle), (35, angle), (63, angle), (99, angle)];
    assert_eq!(reasons, want);
    for row in 0..n.len() {
        if bad.iter().any(|b| b.0 == row) {
            assert!(x[row].is_nan() && rho[row].is_nan());
        } else {
            assert_eq!(
                (x[row].to_bits(), rho[row].to_bits()),
                (shift[row].to_bits(), radius[row].to_bits()),
                "row {row}"
            );
        }
    }
    assert_eq!(contact_batch(&n, &theta[1..], &mut x, &mut rho, |_, _| ()).unwrap_err().quantity, "helical_angles");
}

#[test]
fn a_row_is_the_same_wherever_it_stands() {
    let strands: Vec<u32> = (0..77).map(|i| 2 + (i * 5) % 11).collect();
    let angles: Vec<f64> = (0..77).map(|i| 0.02 * f64::from(i)).collect();
    let (shift, radius, _) = contacts(&strands, &angles);
    for start in 0..77 {
        let (x, rho, _) = contacts(&strands[start..], &angles[start..]);
        assert_eq!((&x[..], &rho[..]), (&shift[start..], &radius[start..]));
    }
}

/// Any data: moderate, tiny, none, large, and such that straight strands are held exactly.
fn data() -> impl Strategy<Value = (u32, f64, f64, f64, f64)> {
    let load = |largest: f64| {
        prop_oneof![
            2 => Just(0.0),
            1 => (-12.0..-2.0_f64).prop_map(|e| -10_f64.powf(e)),
            1 => (-12.0..-2.0_f64).prop_map(|e| 10_f64.powf(e)),
            4 => -1.0..1.0_f64,
            2 => -largest..largest,
        ]
    };
    let strands = prop_oneof![2 => Just(2_u32), 8 => 2..=12_u32, 1 => 13..=40_u32];
    let twist = prop_oneof![1 => Just(0.0), 8 => -3.0..3.0_f64, 1 => -1e6..1e6_f64];
    (strands, 0.3..1.6_f64, twist, load(50.0), load(20.0), 0..20_u32).prop_map(
        |(n, gamma, twist, force, moment, held)| {
            (n, gamma, twist, force, if held == 0 { f64::from(n) * gamma * twist } else { moment })
        },
    )
}

/// What [`Plies`] borrows.
#[derive(Default)]
struct Rows {
    strands: Vec<u32>,
    numbers: [Vec<f64>; 4],
}

impl Rows {
    fn push(&mut self, (n, gamma, twist, force, moment): (u32, f64, f64, f64, f64)) {
        self.strands.push(n);
        for (list, value) in self.numbers.iter_mut().zip([gamma, twist, force, moment]) {
            list.push(value);
        }
    }

    fn states(&self, balance: Balance, clipped: bool) -> States {
        let [stiffness_ratio, twist, force, moment] = &self.numbers;
        let twist = if clipped { Twists::Pretwist(twist) } else { Twists::StrandTwist(twist) };
        let mut states = States::new();
        Plies { strands: &self.strands, stiffness_ratio, twist, force, moment }
            .equilibria(balance, &mut states)
            .unwrap();
        states
    }

    /// The states of one row by itself.
    fn alone(&self, row: usize, balance: Balance, clipped: bool) -> Vec<Equilibrium> {
        let [gamma, twist, force, moment] = self.numbers.each_ref().map(|list| list[row]);
        let twist = if clipped { Twist::Pretwist(twist) } else { Twist::StrandTwist(twist) };
        let load = Load { force, moment };
        Ply::with_balance(self.strands[row], gamma, balance).unwrap().equilibria(twist, load).unwrap()
    }

    /// Holds every row against itself alone, as near as the sum of the balance's terms and its slope tell two angles apart.
    fn hold(&self, balance: Balance, clipped: bool) {
        let states = self.states(balance, clipped);
        assert!(states.refused().is_empty());
        assert_eq!(states.offsets().len(), self.strands.len() + 1);
        for row in 0..self.strands.len() {
            let (alone, places) = (self.alone(row, balance, clipped), states.row(row));
            let told = || {
                let angles = |s: &Equilibrium| (s.handedness(), s.contact().helical_angle(), s.is_fold());
                let data = self.numbers.each_ref().map(|list| list[row]);
                let batch: Vec<_> =
                    places.clone().map(|k| (states.handedness()[k], states.helical_angle()[k])).collect();
                let alone: Vec<_> = alone.iter().map(angles).collect();
                format!("n = {}, {balance:?}, clipped {clipped}, {data:?}:\n{batch:?}\n{alone:?}", self.strands[row])
            };
            assert_eq!(places.len(), alone.len(), "{}", told());
            for (k, state) in places.clone().zip(&alone) {
                assert_eq!(
                    (states.handedness()[k], states.fold()[k]),
                    (state.handedness(), state.is_fold()),
                    "{}",
                    told()
                );
                let angle = state.contact().angle();
                let away = (states.helical_angle()[k] - angle.radians())
                    .abs()
                    .min((states.pitch_angle()[k] - angle.pitch_angle()).abs());
                assert!(away < 1e-12, "{away:e} apart: {}", told());
                assert!((states.helical_angle()[k] + states.pitch_angle()[k] - FRAC_PI_2).abs() < 1e-15);
            }
        }
    }
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn equilibria_of_an_array_are_those_of_its_rows(rows in prop::collection::vec(data(), 1..300), clipped: bool) {
        let mut all = Rows::default();
        rows.into_iter().for_each(|row| all.push(row));
        for balance in Balance::BOTH {
            all.hold(balance, clipped);
        }
    }
}

/// States at chosen places, each with the load that holds it there, and loads by which two of them have just met or not quite: no
/// array may miss one.
#[test]
fn an_array_loses_no_state_at_borders_and_folds() {
    for balance in Balance::BOTH {
        let mut all = Rows::default();
        for n in 2..=12_u32 {
            let ply = Ply::with_balance(n, 0.8, balance).unwrap();
            let twist = Twist::Pretwist(-0.4);
            let places = (1..=47).map(|k| FRAC_PI_2 * f64::from(k) / 48.0); // all borders of panels among them
            let near = [1e-9, -1e-9, 1e-13, -1e-13].map(|d| FRAC_PI_4 + d);
            let ends = [1e-7, 1e-4, FRAC_PI_2 - 1e-4, FRAC_PI_2 - 1e-7];
            for (i, theta) in places.chain(near).chain(ends).enumerate() {
                let angle = HelicalAngle::new(theta).unwrap();
                let hand = Handedness::BOTH[i % 2];
                let moment = 0.3 * f64::from(n);
                if let Ok(state) = ply.force_at(angle, hand, twist, moment) {
                    all.push((n, 0.8, -0.4, state.load().force, moment));
                }
                if let Ok(state) = ply.moment_at(angle, hand, twist, 0.5) {
                    all.push((n, 0.8, -0.4, 0.5, state.load().moment));
                }
            }
            // the greatest force along the branch is a fold; next to it two states are close
            for moment in [-2.0, -0.5, 0.5, 2.0] {
                let force = |theta: f64| {
                    let held = ply.force_at(HelicalAngle::new(theta).unwrap(), Handedness::Right, twist, moment);
                    held.unwrap().load().force
                };
                for i in 2..400 {
                    let step = FRAC_PI_2 / 402.0;
                    let (mut low, mut high) = (step * f64::from(i - 1), step * f64::from(i + 1));
                    let (a, b, c) = (force(low), force(step * f64::from(i)), force(high));
                    if (b - a) * (b - c) <= 0.0 {
                        continue;
                    }
                    let sign = (b - a).signum();
                    for _ in 0..100 {
                        let (left, right) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
                        if sign * force(left) < sign * force(right) { low = left } else { high = right }
                    }
                    let top = force(low);
                    for apart in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3] {
                        all.push((n, 0.8, -0.4, top * (1.0 + apart), moment));
                        all.push((n, 0.8, -0.4, top * (1.0 - apart), moment));
                    }
                }
            }
        }
        assert!(all.strands.len() > 1500, "{}", all.strands.len());
        let states = all.states(balance, true);
        for row in 0..all.strands.len() {
            let alone = all.alone(row, balance, true);
            assert_eq!(states.row(row).len(), alone.len(), "row {row}: n = {}", all.strands[row]);
        }
    }
}

/// A state is that of its own row: asked of another, or of a row that there is not, it is none.
#[test]
fn a_state_belongs_to_one_row() {
    let (n, gamma, none) = ([3, 4], [0.75, 0.75], [0.0, 0.0]);
    let pretwist = [-1.0, -1.0];
    let plies =
        Plies { strands: &n, stiffness_ratio: &gamma, twist: Twists::Pretwist(&pretwist), force: &none, moment: &none };
    let mut states = States::new();
    plies.equilibria(Balance::Contact, &mut states).unwrap();
    let [first, second] = [0, 1].map(|row| states.row(row).start);
    let strands =
        |row, at| plies.equilibrium(Balance::Contact, &states, row, at).map(|state| state.contact().strands());
    assert_eq!([strands(0, first), strands(1, second)], [Some(3), Some(4)]);
    assert_eq!([strands(0, second), strands(1, first)], [None, None]);
    assert_eq!(strands(0, states.row(1).end), None);
}

#[test]
fn a_refused_ply_touches_no_other() {
    let mut good = Rows::default();
    for i in 0..400 {
        let x = f64::from(i);
        good.push((2 + i as u32 % 12, 0.75, (0.7 * x).sin(), (1.1 * x).cos(), 2.0 * (1.3 * x).sin()));
    }
    let want = good.states(Balance::Contact, true);
    let mut bad = Rows::default();
    let mut reasons = Vec::new();
    for row in 0..400 {
        let mut data = (good.strands[row], 0.75, good.numbers[1][row], good.numbers[2][row], good.numbers[3][row]);
        if row % 7 == 3 {
            let quantity = match row % 6 {
                0 => ("strands", data.0 = 1).0,
                1 => ("stiffness_ratio", data.1 = -0.75).0,
                2 => ("stiffness_ratio", data.1 = f64::NAN).0,
                3 => ("pretwist", data.2 = f64::INFINITY).0,
                4 => ("force", data.3 = f64::NAN).0,
                _ => ("moment", data.4 = f64::NEG_INFINITY).0,
            };
            reasons.push((row, quantity));
        }
        bad.push(data);
    }
    let got = bad.states(Balance::Contact, true);
    let told: Vec<_> = got.refused().iter().map(|(row, error)| (*row, error.quantity)).collect();
    assert_eq!(told, reasons);
    for row in 0..400 {
        if reasons.iter().any(|reason| reason.0 == row) {
            assert!(got.row(row).is_empty());
        } else {
            assert_eq!(got.helical_angle()[got.row(row)], want.helical_angle()[want.row(row)], "row {row}");
        }
    }
    let short =
        Plies { force: &[], strands: &[3], stiffness_ratio: &[0.75], twist: Twists::Pretwist(&[0.1]), moment: &[0.0] };
    assert_eq!(short.equilibria(Balance::Contact, &mut States::new()).unwrap_err().quantity, "force");
    assert!(got.row(400).is_empty() && got.row(usize::MAX).is_empty());
}
