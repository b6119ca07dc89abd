//! A sheet in panels, the ranges of the terms on each worked out once: a case is then a few sums.

use nply::mechanics::Balance;

use crate::interval::Interval;
use crate::jet::Jet;
use crate::sheet::{Division, Sheet, TERMS};

/// Panels of a sheet.
pub const PANELS: usize = 128;

/// Value, slope and second derivative.
const ORDERS: usize = 3;

/// Numbers, panel by panel.
type Row = [f64; PANELS];

/// The terms of one balance, over one power of the coordinate, on one sheet.
pub struct Table {
    pub sheet: Sheet,
    pub strands: u32,
    pub balance: Balance,
    pub division: Division,
    /// the panels' borders, one more than panels
    pub borders: Vec<f64>,
    /// half a panel's width, or more
    pub half: f64,
    /// value and slope in the panel's middle, second derivative all over it
    middle: [[Row; TERMS]; ORDERS],
    /// how far each may be off, and what rounding adds to it in a sum of five
    radius: [[Row; TERMS]; ORDERS],
}

/// What a panel tells for a case and a hand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Panel {
    /// no root; whether the balance is positive
    Free(bool),
    /// whether it rises with the coordinate all over
    Monotone(bool),
    /// neither
    Open,
}

/// Half a step between doubles at 1.
const UNIT: f64 = 0.5 * f64::EPSILON;

impl Table {
    #[must_use]
    pub fn new(strands: u32, balance: Balance, sheet: Sheet, division: Division) -> Self {
        let end = sheet.end(strands);
        let mut borders: Vec<f64> = (0..=PANELS).map(|i| end * (i as f64 / PANELS as f64)).collect();
        borders[PANELS] = end;
        let mut table = Self {
            sheet,
            strands,
            balance,
            division,
            half: 0.0,
            borders,
            middle: [[[0.0; PANELS]; TERMS]; ORDERS],
            radius: [[[0.0; PANELS]; TERMS]; ORDERS],
        };
        for i in 0..PANELS {
            let (from, to) = (table.borders[i], table.borders[i + 1]);
            let middle = 0.5 * (from + to);
            table.half = table.half.max((to - middle).max(middle - from).next_up());
            let at = table.jets(Interval::point(middle));
            let over = table.jets(Interval::between(from, to));
            for k in 0..TERMS {
                for (order, range) in [at[k].value, at[k].slope, over[k].curve].into_iter().enumerate() {
                    let (middle, radius) = range.middle_and_radius();
                    table.middle[order][k][i] = middle;
                    // five products of a rounded weight, four sums, the sum of both hands' parts
                    table.radius[order][k][i] = (radius + 8.0 * UNIT * middle.abs()) * (1.0 + 4.0 * f64::EPSILON);
                }
            }
        }
        table
    }

    /// The terms with their first two derivatives.
    #[must_use]
    pub fn jets(&self, t: Interval) -> [Jet; TERMS] {
        self.sheet.terms(self.strands, self.balance, self.division, Jet::variable(t))
    }

    /// The terms.
    #[must_use]
    pub fn values(&self, t: Interval) -> [Interval; TERMS] {
        self.sheet.terms(self.strands, self.balance, self.division, t)
    }

    /// Every panel for both hands: weights 2 and 4 carry ε.
    pub fn judge(&self, weights: &[f64; TERMS], judged: &mut [[Panel; PANELS]; 2]) {
        let mut even = [[0.0; PANELS]; ORDERS];
        let mut odd = [[0.0; PANELS]; ORDERS];
        let mut off = [[1e-300; PANELS]; ORDERS];
        for (k, &weight) in weights.iter().enumerate() {
            if weight == 0.0 {
                continue;
            }
            for order in 0..ORDERS {
                let sums = if k % 2 == 0 && k > 0 { &mut odd[order] } else { &mut even[order] };
                for ((sum, off), (middle, radius)) in
                    sums.iter_mut().zip(&mut off[order]).zip(self.middle[order][k].iter().zip(&self.radius[order][k]))
                {
                    *sum += weight * middle;
                    *off += weight.abs() * radius;
                }
            }
        }
        // what rounding made of the sums of the sizes, and of the few products below
        let more = 1.0 + 32.0 * f64::EPSILON;
        for i in 0..PANELS {
            let [off_value, off_slope, off_curve] = [off[0][i] * more, off[1][i] * more, off[2][i] * more];
            for (judged, sign) in judged.iter_mut().zip([1.0, -1.0]) {
                let [value, slope, curve] = std::array::from_fn(|order| even[order][i] + sign * odd[order][i]);
                let bend = (curve.abs() + off_curve) * self.half * more;
                let lean = (slope.abs() + off_slope) * self.half * more;
                judged[i] = if value.abs() > (off_value + lean + 0.5 * bend * self.half) * more {
                    Panel::Free(value > 0.0)
                } else if slope.abs() > (off_slope + bend) * more {
                    Panel::Monotone(slope > 0.0)
                } else {
                    Panel::Open
                };
            }
        }
    }
}

/// Tables made when they are first asked for.
#[derive(Default)]
pub struct Tables {
    made: std::collections::HashMap<(u32, bool, usize, u32, bool), Box<Table>>,
}

impl Tables {
    /// Makes a table unless there is one.
    pub fn prepare(&mut self, strands: u32, balance: Balance, place: usize, division: Division) {
        let key = (strands, balance == Balance::Radial, place, division.power, division.held);
        self.made
            .entry(key)
            .or_insert_with(|| Box::new(Table::new(strands, balance, Sheet::all(strands)[place], division)));
    }

    /// A table that was made.
    #[must_use]
    pub fn made(&self, strands: u32, balance: Balance, place: usize, division: Division) -> Option<&Table> {
        let key = (strands, balance == Balance::Radial, place, division.power, division.held);
        self.made.get(&key).map(|table| &**table)
    }

    /// Forgets the tables of ropes of many strands, of which there are too many to keep.
    pub fn forget_many_strands(&mut self) {
        self.made.retain(|key, _| key.0 <= 12);
    }
}
