//! Every equilibrium, and no other: `Ply::equilibria` against a slow scan of the printed balance.
//!
//! The scan knows nothing of the library's method: contact by bisection of (5), the balance at 40,000 angles and at
//! logarithmic steps towards both ends, each dip towards zero searched for a pair of roots that fell between two angles.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // an independent route

mod common;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use common::touch::{Touch, touch};
use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Equilibrium, Load, Plies, Ply, States, Twist, Twists};

/// Weights (1, γ, εγφ̄a, f, εm).
type Weights = [f64; 5];

/// cos²θ times the terms of (47), and of the contact balance Ĝ = G + nρ²p̂ρ′ with p̂ of (37) and ρ′ of (65).
fn terms(strands: u32, balance: Balance, angle: HelicalAngle) -> Weights {
    let Touch { n, s, c, x, rho, .. } = touch(strands, angle);
    let cos2 = (angle.pitch_angle() - angle.radians()).sin();
    let sin4 = 4.0 * s * c * cos2;
    let mut all = [2.0 * n * s * s * s * c, n / 4.0 * sin4, n * rho * cos2, rho * rho * s, -rho * c];
    if balance == Balance::Contact {
        let k = n * rho * rho * (rho * rho * rho * x * x * c / s / 4.0);
        let pressure = [
            -(s * s * s * s) / (rho * rho * rho),
            -(s * c / rho) * s * c / (rho * rho),
            -s * c / (rho * rho),
            0.0,
            s / (n * rho * rho),
        ];
        for (term, p) in all.iter_mut().zip(pressure) {
            *term += k * p;
        }
    }
    all.map(|term| term * c * c)
}

fn value(t: &Weights, w: &Weights) -> f64 {
    t[0] * w[0] + t[1] * w[1] + t[2] * w[2] + t[3] * w[3] + t[4] * w[4]
}

fn size(t: &Weights, w: &Weights) -> f64 {
    (0..5).map(|k| (t[k] * w[k]).abs()).sum()
}

/// An angle by itself below 1 rad, by its complement above.
fn place(t: f64, flat: bool) -> HelicalAngle {
    if flat { HelicalAngle::from_pitch_angle(t).unwrap() } else { HelicalAngle::new(t).unwrap() }
}

struct Table {
    strands: u32,
    balance: Balance,
    angles: Vec<HelicalAngle>,
    terms: Vec<Weights>,
}

/// A root of the scan; two of them that rounding might merge or part are doubtful.
#[derive(Debug)]
struct Found {
    angle: HelicalAngle,
    doubtful: bool,
}

impl Table {
    fn new(strands: u32, balance: Balance) -> Self {
        let half: Vec<f64> = (0..400)
            .map(|i| 1e-13 * 10_f64.powf(f64::from(i) / 40.0))
            .filter(|t| *t < FRAC_PI_4 / 20_000.0)
            .chain((1..=20_000).map(|i| FRAC_PI_4 * f64::from(i) / 20_000.0))
            .collect();
        let steep = half.iter().map(|&t| place(t, false));
        let flat = half.iter().rev().skip(1).map(|&t| place(t, true));
        let angles: Vec<_> = steep.chain(flat).collect();
        let terms = angles.iter().map(|&angle| terms(strands, balance, angle)).collect();
        Self { strands, balance, angles, terms }
    }

    /// The balance between angles `i` and `j` of the table: by the complement near π/2.
    fn between(&self, i: usize, j: usize) -> (bool, f64, f64) {
        let flat = self.angles[i].radians() > 1.0;
        let t = |k: usize| if flat { self.angles[k].pitch_angle() } else { self.angles[k].radians() };
        (flat, t(i), t(j))
    }

    fn at(&self, t: f64, flat: bool, w: &Weights) -> f64 {
        value(&terms(self.strands, self.balance, place(t, flat)), w)
    }

    fn root(&self, flat: bool, mut from: f64, mut to: f64, w: &Weights, doubtful: bool) -> Found {
        let positive = self.at(from, flat, w) > 0.0;
        for _ in 0..70 {
            let middle = 0.5 * (from + to);
            if middle == from || middle == to {
                break;
            }
            if (self.at(middle, flat, w) > 0.0) == positive { from = middle } else { to = middle }
        }
        Found { angle: place(0.5 * (from + to), flat), doubtful }
    }

    fn roots(&self, w: &Weights) -> Vec<Found> {
        let values: Vec<f64> = self.terms.iter().map(|t| value(t, w)).collect();
        let mut found = Vec::new();
        for i in 1..values.len() {
            let (before, here) = (values[i - 1], values[i]);
            if (before > 0.0) != (here > 0.0) {
                let (flat, from, to) = self.between(i - 1, i);
                found.push(self.root(flat, from, to, w, false));
            }
            let Some(&after) = values.get(i + 1) else { continue };
            let (a, b, c) = (before.abs(), here.abs(), after.abs());
            let dips = b <= a && b <= c && (before > 0.0) == (here > 0.0) && (here > 0.0) == (after > 0.0);
            if dips && b <= 4.0 * a.max(c) - 4.0 * b + 1e-12 * size(&self.terms[i], w) {
                self.dip(i, w, here > 0.0, &mut found);
            }
        }
        found
    }

    /// The least of |G| about angle `i`, by golden section, and the pair of roots if it is beyond zero.
    fn dip(&self, i: usize, w: &Weights, positive: bool, found: &mut Vec<Found>) {
        let (flat, from, to) = self.between(i - 1, i + 1);
        let height = |t: f64| if positive { self.at(t, flat, w) } else { -self.at(t, flat, w) };
        let golden = 0.618_033_988_749_894_9;
        let (mut a, mut d) = (from, to);
        let (mut b, mut c) = (d - golden * (d - a), a + golden * (d - a));
        let (mut at_b, mut at_c) = (height(b), height(c));
        for _ in 0..45 {
            if at_b < at_c {
                (d, c, at_c) = (c, b, at_b);
                b = d - golden * (d - a);
                at_b = height(b);
            } else {
                (a, b, at_b) = (b, c, at_c);
                c = a + golden * (d - a);
                at_c = height(c);
            }
        }
        let (low, least) = if at_b < at_c { (b, at_b) } else { (c, at_c) };
        let doubtful = least.abs() < 1e-13 * size(&self.terms[i], w);
        if least < 0.0 && !doubtful {
            found.push(self.root(flat, from, low, w, false));
            found.push(self.root(flat, low, to, w, false));
        } else if doubtful {
            found.push(Found { angle: place(low, flat), doubtful });
        }
    }

    /// An array of this case alone has the same states.
    fn hold_array(&self, case: &Case, states: &[Equilibrium]) {
        let mut array = States::new();
        let plies = Plies {
            strands: &[self.strands],
            stiffness_ratio: &[case.gamma],
            twist: Twists::Pretwist(&[case.pretwist]),
            force: &[case.force],
            moment: &[case.moment],
        };
        plies.equilibria(self.balance, &mut array).unwrap();
        let told = || format!("n = {}, {:?}, {case:?}: {array:?}", self.strands, self.balance);
        assert_eq!(array.len(), states.len(), "{}", told());
        for (k, state) in states.iter().enumerate() {
            let angle = state.contact().angle();
            let away = (array.helical_angle()[k] - angle.radians()).abs();
            let away = away.min((array.pitch_angle()[k] - angle.pitch_angle()).abs());
            let slope = (state.balance_slope() * angle.cos() * angle.cos()).abs();
            let at = terms(self.strands, self.balance, angle);
            let rounding = 3e-14 * size(&at, &case.weights(state.handedness())) / slope;
            assert!(away <= 1e-12 + rounding || state.is_fold(), "{away:e} apart: {}", told());
            assert_eq!(array.handedness()[k], state.handedness(), "{}", told());
        }
    }

    /// Holds the library's states against the scan. Gives how many roots there were and whether any was doubtful.
    fn hold(&self, case: &Case) -> (usize, bool) {
        let ply = Ply::with_balance(self.strands, case.gamma, self.balance).unwrap();
        let load = Load { force: case.force, moment: case.moment };
        let states = ply.equilibria(Twist::Pretwist(case.pretwist), load).unwrap();
        self.hold_array(case, &states);
        let (mut count, mut any) = (0, false);
        for hand in Handedness::BOTH {
            let w = case.weights(hand);
            let mut want = self.roots(&w);
            want.sort_by(|a, b| {
                a.angle
                    .radians()
                    .total_cmp(&b.angle.radians())
                    .then(b.angle.pitch_angle().total_cmp(&a.angle.pitch_angle()))
            });
            // the scan begins at 1e-13 from either end
            let seen = |angle: HelicalAngle| angle.radians() > 1e-13 && angle.pitch_angle() > 1e-13;
            let got: Vec<_> = states.iter().filter(|s| s.handedness() == hand && seen(s.contact().angle())).collect();
            let told = || {
                format!(
                    "n = {}, {:?}, {hand:?}, {case:?}:\n got {:?}\nwant {:?}",
                    self.strands,
                    self.balance,
                    got.iter().map(|s| (s.contact().angle(), s.is_fold())).collect::<Vec<_>>(),
                    want
                )
            };
            count += want.len();
            if want.iter().any(|f| f.doubtful) {
                // up to two of the library's for each doubtful one, and all others as they are
                any = true;
                let sure = want.iter().filter(|f| !f.doubtful).count();
                let doubtful = want.len() - sure;
                assert!(got.len() >= sure && got.len() <= sure + 2 * doubtful, "{}", told());
                continue;
            }
            assert_eq!(got.len(), want.len(), "{}", told());
            for (state, found) in got.iter().zip(&want) {
                let angle = state.contact().angle();
                let away = (angle.radians() - found.angle.radians())
                    .abs()
                    .min((angle.pitch_angle() - found.angle.pitch_angle()).abs());
                let at = terms(self.strands, self.balance, found.angle);
                let slope = (state.balance_slope() * angle.cos() * angle.cos()).abs();
                let least = angle.radians().min(angle.pitch_angle());
                assert!(away <= 1e-13 * least + 3e-14 * size(&at, &w) / slope, "{away:e} apart: {}", told());
            }
        }
        (count, any)
    }
}

#[derive(Clone, Copy, Debug)]
struct Case {
    gamma: f64,
    pretwist: f64,
    force: f64,
    moment: f64,
}

impl Case {
    fn weights(&self, hand: Handedness) -> Weights {
        let eps = hand.sign();
        [1.0, self.gamma, eps * self.gamma * self.pretwist, self.force, eps * self.moment]
    }
}

/// Splitmix: the same cases on every machine.
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[(self.roll() * from.len() as f64) as usize]
    }

    /// A load: none, tiny, moderate, or large.
    fn load(&mut self, largest: f64) -> f64 {
        let sign = self.pick(&[-1.0, 1.0]);
        match self.pick(&[0, 1, 2, 3]) {
            0 => 0.0,
            1 => sign * 10_f64.powf(self.within(-9.0, -3.0)),
            2 => self.within(-1.0, 1.0),
            _ => self.within(-largest, largest),
        }
    }

    fn case(&mut self) -> Case {
        let pretwist = if self.roll() < 0.15 { 0.0 } else { self.within(-3.0, 3.0) };
        Case { gamma: self.within(0.3, 1.5), pretwist, force: self.load(50.0), moment: self.load(20.0) }
    }

    /// Angles at which something is easily lost: both ends, π/4 and its neighbourhood, multiples of 15°.
    fn angle(&mut self) -> HelicalAngle {
        let near = |t: f64| HelicalAngle::new(t).unwrap();
        match self.pick(&[0, 1, 2, 3, 4, 5]) {
            0 => near(self.pick(&[15.0_f64, 30.0, 45.0, 60.0, 75.0]).to_radians()),
            1 => near(FRAC_PI_4 + self.pick(&[-1.0, 1.0]) * 10_f64.powf(self.within(-12.0, -3.0))),
            2 => near(10_f64.powf(self.within(-10.0, -1.0))),
            3 => HelicalAngle::from_pitch_angle(10_f64.powf(self.within(-8.0, -1.0))).unwrap(),
            _ => near(self.within(0.01, FRAC_PI_2 - 0.01)),
        }
    }
}

/// A table for each number of strands and each balance, handed to `check` with dice of its own.
fn for_each_table(seed: u64, check: impl Fn(&Table, &mut Dice) + Sync) {
    // two at a time: as many as the least machine has
    std::thread::scope(|scope| {
        for balance in Balance::BOTH {
            let check = &check;
            scope.spawn(move || {
                for n in 2..=12 {
                    let table = Table::new(n, balance);
                    check(&table, &mut Dice(seed + u64::from(n)));
                }
            });
        }
    });
}

#[test]
fn none_missed_and_none_extra() {
    for_each_table(1, |table, dice| {
        let mut roots = 0;
        for _ in 0..50 {
            roots += table.hold(&dice.case()).0;
        }
        // roots at chosen places: one datum is solved for
        for _ in 0..60 {
            let (angle, hand, mut case) = (dice.angle(), dice.pick(&Handedness::BOTH), dice.case());
            let t = terms(table.strands, table.balance, angle);
            let which = dice.pick(&[2, 3, 4]);
            let eps = hand.sign();
            match which {
                2 => case.pretwist = 0.0,
                3 => case.force = 0.0,
                _ => case.moment = 0.0,
            }
            let missing = -value(&t, &case.weights(hand)) / t[which];
            match which {
                2 => case.pretwist = eps * missing / case.gamma,
                3 => case.force = missing,
                _ => case.moment = eps * missing,
            }
            if missing.is_finite() && missing.abs() < 1e6 {
                let (count, doubtful) = table.hold(&case);
                assert!(count > 0 || doubtful || angle.radians() < 1e-9, "lost the root at {angle:?}: {case:?}");
                roots += count;
            }
        }
        // straight strands held exactly: the root at zero is no state
        for _ in 0..10 {
            let mut case = dice.case();
            case.moment = f64::from(table.strands) * case.gamma * case.pretwist;
            roots += table.hold(&case).0;
        }
        assert!(roots > 150, "{roots} roots tried no case in earnest");
    });
}

/// Two roots that are about to meet, or have just gone: loads solved for from G = 0 and a small G_θ.
#[test]
fn near_folds() {
    for_each_table(7, |table, dice| {
        let mut near = 0;
        for _ in 0..60 {
            let (hand, mut case) = (dice.pick(&Handedness::BOTH), dice.case());
            let theta = dice.within(0.05, 1.5);
            if (theta - FRAC_PI_4).abs() < 1e-3 {
                continue;
            }
            let by = |theta: f64| terms(table.strands, table.balance, HelicalAngle::new(theta).unwrap());
            let t = by(theta);
            let slopes: [f64; 5] = std::array::from_fn(|k| common::touch::slope(|theta| by(theta)[k], theta, 4e-4));
            (case.force, case.moment) = (0.0, 0.0);
            let w = case.weights(hand);
            let wanted = dice.pick(&[0.0, 1e-9, -1e-9, 1e-7, 1e-6, -1e-6, 1e-5, 1e-4, -1e-3]);
            // t₃ f + t₄ εm = −G, and the same for the slopes
            let (g, slope) = (value(&t, &w), value(&slopes, &w) - wanted);
            let determinant = t[3] * slopes[4] - t[4] * slopes[3];
            case.force = (-g * slopes[4] + slope * t[4]) / determinant;
            case.moment = hand.sign() * (-slope * t[3] + g * slopes[3]) / determinant;
            if case.force.abs() < 1e4 && case.moment.abs() < 1e4 {
                near += 1;
                table.hold(&case);
                // lifted by a hair either way: two roots or none
                for lift in [-1e-10, 1e-10, -1e-8, 1e-8, -1e-6, 1e-6] {
                    table.hold(&Case { force: case.force + lift * (1.0 + case.force.abs()), ..case });
                }
            }
        }
        assert!(near > 30, "{near} folds");
    });
}

/// Under the moment that holds the straight ply and near the thrust at which it buckles, the state has left θ = 0 by the square root of
/// what is left: nearer to 0 only rounding has a sign.
#[test]
fn near_the_buckling_of_straight_strands_the_state_is_found() {
    let (gamma, pretwist) = (0.663_675_149_415_629_6, -2.983_416_924_467_827_7);
    let load = Load { force: -0.718_491_745_343_212_8, moment: 9.0 * gamma * pretwist };
    let ply = Ply::with_balance(9, gamma, Balance::Radial).unwrap();
    assert!(ply.straight_holds(Twist::Pretwist(pretwist), load));
    let states = ply.equilibria(Twist::Pretwist(pretwist), load).unwrap();
    let near = states.iter().find(|s| s.contact().helical_angle() < 0.1).expect("one that has just buckled");
    // between these angles the printed balance changes its sign
    let eps = near.handedness().sign();
    let weights = [1.0, gamma, eps * gamma * pretwist, load.force, eps * load.moment];
    let balance = |theta: f64| -> f64 {
        let terms = terms(9, Balance::Radial, HelicalAngle::new(theta).unwrap());
        terms.iter().zip(weights).map(|(term, weight)| term * weight).sum()
    };
    let theta = near.contact().helical_angle();
    assert!((theta - 0.002_163).abs() < 1e-5, "{theta}");
    assert!(balance(0.99 * theta) * balance(1.01 * theta) < 0.0);
}
