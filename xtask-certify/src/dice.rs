//! Random plies: the same ones on every machine for a seed.
#![allow(clippy::disallowed_methods)] // a last digit of a random number matters to nobody

use std::f64::consts::FRAC_PI_4;

use nply::mechanics::{Balance, Load, Twist};

use crate::case::Case;
use crate::interval::Interval;
use crate::jet::Jet;
use crate::sheet::{Division, Sheet};

/// Splitmix.
pub struct Dice {
    state: u64,
    /// numbers of strands beyond twelve that are in use
    many: Vec<u32>,
}

impl Dice {
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut dice = Self { state: seed, many: Vec::new() };
        dice.change_many();
        dice
    }

    /// Other numbers of strands beyond twelve, up to a thousand, spread over the decades: few at a time, because each needs tables.
    pub fn change_many(&mut self) {
        self.many = (0..16).map(|_| self.decades(13_f64.log10(), 3.0).round() as u32).collect();
    }

    fn roll(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    /// Spread evenly over decades.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        10_f64.powf(self.within(low, high))
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[(self.roll() * from.len() as f64) as usize]
    }

    /// A datum of either sign: none, of everyday size, over many decades, or of any size at all.
    fn datum(&mut self) -> f64 {
        let sign = self.pick(&[-1.0, 1.0]);
        sign * match (self.roll() * 100.0) as u32 {
            0..20 => 0.0,
            20..50 => self.within(0.0, 3.0),
            50..70 => self.decades(-3.0, 2.0),
            70..94 => self.decades(-12.0, 8.0),
            _ => self.decades(-40.0, 40.0),
        }
    }

    fn strands(&mut self) -> u32 {
        if self.roll() < 0.9 {
            2 + (self.roll() * 11.0) as u32
        } else {
            let at = (self.roll() * self.many.len() as f64) as usize;
            self.many[at]
        }
    }

    fn stiffness_ratio(&mut self) -> f64 {
        match (self.roll() * 4.0) as u32 {
            0 | 1 => self.within(0.5, 1.2),
            2 => self.decades(-2.0, 2.0),
            // of few digits, as people write it
            _ => self.pick(&[0.5, 0.75, 0.769_230_8, 1.0, 1.25]),
        }
    }

    /// The next ply.
    pub fn case(&mut self) -> Case {
        let (twist, force, moment) = (self.datum(), self.datum(), self.datum());
        let twist = if self.roll() < 0.8 { Twist::Pretwist(twist) } else { Twist::StrandTwist(twist) };
        let case = Case {
            strands: self.strands(),
            balance: self.pick(&Balance::BOTH),
            stiffness_ratio: self.stiffness_ratio(),
            twist,
            load: Load { force, moment },
        };
        match (self.roll() * 100.0) as u32 {
            0..65 => case,
            65..80 => self.with_root_somewhere(case),
            80..96 => self.near_fold(case),
            _ => self.held(case),
        }
    }

    /// Straight strands held, exactly or to rounding, and from a hair beside.
    fn held(&mut self, case: Case) -> Case {
        let twist = if self.roll() < 0.5 { self.within(-64.0, 64.0).round() / 32.0 } else { self.within(-3.0, 3.0) };
        let beside = if self.roll() < 0.7 { 0.0 } else { self.decades(-15.0, -3.0) };
        let moment = f64::from(case.strands) * case.stiffness_ratio * twist * (1.0 + beside);
        let twist = match case.twist {
            Twist::Pretwist(_) => Twist::Pretwist(twist),
            Twist::StrandTwist(_) => Twist::StrandTwist(twist),
        };
        Case { twist, load: Load { moment, ..case.load }, ..case }
    }

    /// A place on the branch: all over, next to its ends, next to 45° of two strands.
    fn place(&mut self, strands: u32) -> (Sheet, f64) {
        let sheet = self.pick(Sheet::all(strands));
        let end = sheet.end(strands);
        let part = match (self.roll() * 4.0) as u32 {
            0 => self.decades(-10.0, 0.0),
            1 => 1.0 - self.decades(-12.0, 0.0),
            _ => self.roll(),
        };
        (sheet, end * part)
    }

    /// The balance's terms for a hand, not divided, their values or slopes.
    fn terms(case: &Case, hand: f64, (sheet, t): (Sheet, f64), of: fn(&Jet) -> Interval) -> [f64; 5] {
        let whole = Division { power: 0, held: false };
        let jets = sheet.terms(case.strands, case.balance, whole, Jet::variable(Interval::point(t)));
        let mut terms = jets.map(|jet| of(&jet).middle_and_radius().0);
        terms[2] *= hand;
        terms[4] *= hand;
        terms
    }

    /// One datum solved for, so that there is a root at a chosen place.
    fn with_root_somewhere(&mut self, mut case: Case) -> Case {
        let place = self.place(case.strands);
        let hand = self.pick(&[-1.0, 1.0]);
        let terms = Self::terms(&case, hand, place, |jet| jet.value);
        let weights = case.weights();
        let others = |k: usize| (0..5).filter(|&i| i != k).map(|i| terms[i] * weights[i]).sum::<f64>();
        match self.pick(&[2, 3, 4]) {
            2 => {
                let twist = -others(2) / terms[2] / case.stiffness_ratio;
                if twist.abs() < 1e40 {
                    case.twist = match case.twist {
                        Twist::Pretwist(_) => Twist::Pretwist(twist),
                        Twist::StrandTwist(_) => Twist::StrandTwist(twist),
                    };
                }
            }
            3 => {
                let force = -others(3) / terms[3];
                if force.abs() < 1e40 {
                    case.load.force = force;
                }
            }
            _ => {
                let moment = -others(4) / terms[4];
                if moment.abs() < 1e40 {
                    case.load.moment = moment;
                }
            }
        }
        case
    }

    /// Two roots that are about to meet, or have just gone: force and moment from the balance and a small slope, then a hair beside.
    fn near_fold(&mut self, mut case: Case) -> Case {
        let place = self.place(case.strands);
        let hand = self.pick(&[-1.0, 1.0]);
        let t = Self::terms(&case, hand, place, |jet| jet.value);
        let s = Self::terms(&case, hand, place, |jet| jet.slope);
        let weights = case.weights();
        let sum = |terms: &[f64; 5]| (0..3).map(|k| weights[k] * terms[k]).sum::<f64>();
        let sign = self.pick(&[-1.0, 1.0]);
        let wanted = sign * self.pick(&[0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-3]);
        let (g, slope) = (sum(&t), sum(&s) - wanted);
        let determinant = t[3] * s[4] - t[4] * s[3];
        let (force, moment) = ((-g * s[4] + slope * t[4]) / determinant, (-slope * t[3] + g * s[3]) / determinant);
        if force.abs() < 1e40 && moment.abs() < 1e40 {
            let sign = self.pick(&[-1.0, 1.0]);
            let lift = sign * self.pick(&[0.0, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4]);
            case.load = Load { force: force + lift * (1.0 + force.abs()), moment };
        }
        case
    }
}

/// The helical angle's half of the branch is the steep one up to here.
pub(crate) const HALF: f64 = FRAC_PI_4;
