//! Every root of a linear combination of known functions on an interval, none missed and none twice.
//!
//! The functions are kept as polynomials (a [`Panel`]) with a bound on what the polynomials leave out, so that a
//! combination costs a few products and its coefficients' signs tell how many roots there can be: none or one at once,
//! nearly always. Where they do not decide, the derivative's signs may (monotone; one extremum, whose exact height then
//! decides), and otherwise the panel is parted and fitted anew. Ends shared by two panels have one exact sign, zero
//! counting as positive, so that a root on the border belongs to exactly one of them. Roots at coordinate 0 itself are
//! divided out, with the power of the coordinate that they have.

mod combination;

use super::bernstein::{self, Bernstein, NODES, ORDER};
use super::dual::Dual;
use combination::Combination;

/// K functions of one coordinate, with their slopes.
pub(crate) trait Basis<const K: usize> {
    /// The functions at `t`.
    fn at(&self, t: f64) -> [Dual; K];
}

/// K functions between two coordinates, as polynomials.
#[derive(Clone, Debug)]
pub(crate) struct Panel<const K: usize> {
    start: f64,
    end: f64,
    functions: [Bernstein; K],
    /// how far each polynomial may be from its function
    tolerance: [f64; K],
    /// the slopes at the start, per unit of the coordinate
    slopes: [f64; K],
}

/// A root, with the combination's slope there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Root {
    pub(crate) at: f64,
    pub(crate) slope: f64,
    /// two roots that rounding cannot tell apart: the combination touches zero
    pub(crate) double: bool,
}

/// Where the terms of first order cancel at 0, roots nearer to it than this cannot be told from it: there the terms of
/// higher order are a millionth of a millionth of those that cancel, and rounding is not far below.
const NEAREST: f64 = 1e-6;

/// Where all functions vanish to a higher order than the first at 0, their sign is asked for here: nearer still their products underflow.
const FIRST: f64 = 1e-60;

/// A panel next to 0 as narrow as this is not parted: in narrower ones the squares of coordinates underflow.
const NARROWEST: f64 = 1e-150;

/// Halvings after which a panel is narrower than rounding can tell apart.
const DEEPEST: u32 = 44;

/// The highest power of the coordinate that is divided out.
const MOST_ORDER: f64 = 3.0;

/// How a combination leaves coordinate 0, where it vanishes.
struct PastZero {
    positive: bool,
    /// its sign is sure from here on
    from: f64,
    /// the power of the coordinate with which it vanishes
    order: usize,
}

/// A pair of combinations that are mirror images: even part plus, and less, odd part.
///
/// Sums are always taken part by part, here, in polynomials and in exact values alike, so that a value on a border of
/// two panels is the same to the bit from either side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<const K: usize> {
    pub(crate) even: [f64; K],
    pub(crate) odd: [f64; K],
}

impl<const K: usize> Pair<K> {
    /// Weights of one size, so that no sum of terms overflows.
    pub(crate) fn tamed(self) -> Self {
        let largest = self.even.iter().chain(&self.odd).fold(0.0, |m: f64, w| m.max(w.abs()));
        if largest > 1e100 {
            Self { even: self.even.map(|w| w / largest), odd: self.odd.map(|w| w / largest) }
        } else {
            self
        }
    }
}

/// Which of a pair: +1.0 or −1.0, the factor of the odd part.
pub(crate) type Side = f64;

impl<const K: usize> Panel<K> {
    /// Fits the functions between `start` and `end`.
    ///
    /// The tolerance is four times the greatest difference at the eleven points midway between nodes, where the
    /// interpolation error of a smooth function is near its greatest, and never below rounding.
    pub(crate) fn fit(basis: &impl Basis<K>, start: f64, end: f64) -> Self {
        let place = |node: f64| start + (end - start) * node;
        let mut samples = [[0.0; ORDER]; K];
        let mut slopes = [0.0; K];
        for (i, &node) in NODES.iter().enumerate() {
            let at = basis.at(if i + 1 == ORDER { end } else { place(node) });
            for (k, dual) in at.iter().enumerate() {
                samples[k][i] = dual.value;
                if i == 0 {
                    slopes[k] = dual.slope;
                }
            }
        }
        let functions = samples.map(|values| bernstein::fit(&values));
        let mut tolerance = samples.map(|values| f64::EPSILON * values.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        for pair in NODES.windows(2) {
            let node = 0.5 * (pair[0] + pair[1]);
            for (k, dual) in basis.at(place(node)).iter().enumerate() {
                tolerance[k] = tolerance[k].max((bernstein::value(&functions[k], node) - dual.value).abs());
            }
        }
        Self { start, end, functions, tolerance: tolerance.map(|t| 4.0 * t), slopes }
    }

    /// Hands every root of either combination on this panel to `found`, in no order.
    #[inline]
    pub(crate) fn roots(&self, basis: &impl Basis<K>, pair: &Pair<K>, found: &mut impl FnMut(Side, Root)) {
        self.roots_up_to(basis, pair, None, found);
    }

    /// As [`roots`](Self::roots), where the next panel is one of other functions: `border` is the pair there as that panel
    /// [starts](Self::at_start) with it, so that both see the same sign.
    #[inline]
    pub(crate) fn roots_up_to(
        &self,
        basis: &impl Basis<K>,
        pair: &Pair<K>,
        border: Option<(f64, f64)>,
        found: &mut impl FnMut(Side, Root),
    ) {
        let parts = (self.sum(&pair.even), self.sum(&pair.odd));
        for side in [1.0, -1.0] {
            let border = border.map(|(even, odd)| (self.end, even + side * odd));
            let here = Combination::new(basis, pair, side, border);
            let (b, tolerance) = self.joined(&here, &parts);
            if !bernstein::one_sign(&b, tolerance) {
                self.search(&here, &b, tolerance, &mut |root| found(side, root), DEEPEST);
            }
        }
    }

    /// The pair's even and odd part at the start, to the bit those of the polynomials' sums.
    #[inline]
    pub(crate) fn at_start(&self, pair: &Pair<K>) -> (f64, f64) {
        let sum = |weights: &[f64; K]| {
            let terms = weights.iter().zip(&self.functions).filter(|(weight, _)| **weight != 0.0);
            terms.fold(0.0, |sum, (weight, function)| sum + weight * function[0])
        };
        (sum(&pair.even), sum(&pair.odd))
    }

    /// The polynomial of a weighted sum, and how far it may be off.
    #[inline]
    fn sum(&self, weights: &[f64; K]) -> Sum {
        let (mut sum, mut tolerance) = ([0.0; ORDER], 0.0);
        for (k, &weight) in weights.iter().enumerate() {
            if weight != 0.0 {
                tolerance += self.tolerance[k] * weight.abs();
                for (total, coefficient) in sum.iter_mut().zip(&self.functions[k]) {
                    *total += weight * coefficient;
                }
            }
        }
        (sum, tolerance)
    }

    /// Even part plus, or less, odd part.
    #[inline]
    fn joined<B: Basis<K>>(&self, here: &Combination<'_, B, K>, parts: &(Sum, Sum)) -> Sum {
        let ((even, even_tolerance), (odd, odd_tolerance)) = parts;
        let mut sum: Bernstein = core::array::from_fn(|i| even[i] + here.side * odd[i]);
        if let Some((_, value)) = here.border.filter(|(end, _)| *end <= self.end) {
            sum[ORDER - 1] = value;
        }
        (sum, even_tolerance + odd_tolerance)
    }

    fn search<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        b: &Bernstein,
        tolerance: f64,
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        if self.start == 0.0 {
            let (slope, size) = here.sum_and_size(&self.slopes);
            let slope_lost = size > 0.0 && slope.abs() <= 8.0 * f64::EPSILON * size;
            let unnoticed = if slope_lost { NEAREST * NEAREST * NEAREST * size } else { 0.0 };
            if b[0].abs() <= self.rounding_at_start(here).max(unnoticed) {
                match self.past_zero(here, slope, slope_lost) {
                    Some(past) => self.search_past_zero(here, b, tolerance, &past, found, depth),
                    None => self.search_away_from_zero(here, found, depth),
                }
                return;
            }
        }
        match bernstein::sign_changes(b, tolerance) {
            0 => {}
            1 => found(here.refine(self.start, self.end, b[0] >= 0.0, self.guess(b))),
            _ => self.examine(here, b, tolerance, found, depth),
        }
    }

    /// Either half, fitted anew. Next to 0, where coordinates keep their digits however small they are, a sixteenth and the rest, of which
    /// neither is any deeper: some 120 steps lead to [`NARROWEST`].
    fn halve<B: Basis<K>>(&self, here: &Combination<'_, B, K>, found: &mut impl FnMut(Root), depth: u32) {
        let (middle, depth) = if self.start == 0.0 {
            (0.0625 * self.end, DEEPEST - 1)
        } else {
            (0.5 * (self.start + self.end), depth - 1)
        };
        for (start, end) in [(self.start, middle), (middle, self.end)] {
            Self::fit(here.basis, start, end).search_fitted(here, found, depth);
        }
    }

    /// Whether halves can be told from the whole.
    fn may_halve<B: Basis<K>>(&self, here: &Combination<'_, B, K>, depth: u32) -> bool {
        (if self.start == 0.0 { self.end > NARROWEST } else { depth > 0 }) && here.may_halve()
    }

    /// The search of a panel of which the combination's polynomial is not known yet.
    fn search_fitted<B: Basis<K>>(&self, here: &Combination<'_, B, K>, found: &mut impl FnMut(Root), depth: u32) {
        let parts = (self.sum(&here.pair.even), self.sum(&here.pair.odd));
        let (b, tolerance) = self.joined(here, &parts);
        self.search(here, &b, tolerance, found, depth);
    }

    /// More than one root is possible: ask the derivative.
    #[cold]
    fn examine<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        b: &Bernstein,
        tolerance: f64,
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        let (from, to) = (b[0] >= 0.0, b[ORDER - 1] >= 0.0);
        if self.is_lost(here, b) {
            // zero all over to within rounding: on a whole panel no root stands out; on a part of one, two roots may meet
            let part = depth < DEEPEST;
            if part && self.start > 0.0 {
                here.around(0.5 * (self.start + self.end), self.start, self.end, from, to, found);
            } else if part && from != to {
                found(here.refine(self.start, self.end, from, 0.5 * self.end));
            }
            return;
        }
        let mut differences = [0.0; ORDER - 1];
        for (difference, pair) in differences.iter_mut().zip(b.windows(2)) {
            *difference = pair[1] - pair[0];
        }
        let sure = |difference: f64| difference.abs() > 2.0 * tolerance;
        let turns = if sure(differences[0]) && sure(differences[ORDER - 2]) {
            bernstein::sign_changes(&differences, 2.0 * tolerance)
        } else {
            usize::MAX
        };
        match turns {
            0 if from == to => {}
            0 => found(here.refine(self.start, self.end, from, self.guess(b))),
            1 => {
                let top = here.extremum(self.start, self.end, differences[0] > 0.0);
                here.around(top, self.start, self.end, from, to, found);
            }
            _ if self.may_halve(here, depth) => self.halve(here, found, depth),
            // narrower than rounding: value, slope and curvature vanish together
            _ => here.around(0.5 * (self.start + self.end), self.start, self.end, from, to, found),
        }
    }

    /// How the combination leaves coordinate 0, where it vanishes; `None` where its first order cancels to rounding.
    fn past_zero<B: Basis<K>>(&self, here: &Combination<'_, B, K>, slope: f64, slope_lost: bool) -> Option<PastZero> {
        if slope != 0.0 {
            // nearer to 0 than this what is left of the terms that cancel there hides the first order
            let hidden = self.rounding_at_start(here) / slope.abs();
            return (!slope_lost).then_some(PastZero { positive: slope > 0.0, from: hidden, order: 1 });
        }
        // all functions vanish to a higher order: so close to 0 nothing but the lowest counts
        let values = here.basis.at(FIRST).map(|function| function.value);
        let (value, size) = here.sum_and_size(&values);
        let order = |value: &f64| libm::round(libm::log(value.abs()) / libm::log(FIRST));
        let taking_part = values.iter().enumerate().filter(|(k, value)| here.takes(*k) && **value != 0.0);
        let order = taking_part.map(|(_, value)| order(value)).fold(MOST_ORDER, f64::min).max(1.0) as usize;
        let sure = !slope_lost && value.abs() > 8.0 * f64::EPSILON * size;
        sure.then_some(PastZero { positive: value > 0.0, from: FIRST, order })
    }

    /// Roots beyond where the combination first stands out from the rounding of its terms, some thousandfold; nearer ones
    /// cannot be told from the one at 0.
    #[cold]
    fn search_away_from_zero<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        let mut start = NEAREST;
        while start < self.end && here.at(start).value.abs() < 1e3 * here.rounding(start) {
            start *= 2.0;
        }
        if start < self.end {
            Self::fit(here.basis, start, self.end).search_fitted(here, found, depth);
        }
    }

    /// The combination vanishes at coordinate 0: its roots elsewhere are those of the quotient by the power of the coordinate with which it
    /// vanishes.
    #[cold]
    fn search_past_zero<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        b: &Bernstein,
        tolerance: f64,
        past: &PastZero,
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        let (from, to) = (past.positive, b[ORDER - 1] >= 0.0);
        let low = past.from.min(0.5 * self.end);
        if self.is_lost(here, b) {
            if depth < DEEPEST && from != to {
                found(here.refine_past_zero(low, self.end, from));
            }
            return;
        }
        let mut quotient = bernstein::over_power(b, past.order);
        quotient[0] = if from { 1.0 } else { -1.0 }; // it keeps no digits but has a sure sign
        let quotient = &quotient[..ORDER - past.order];
        match bernstein::sign_changes(quotient, bernstein::growth(past.order) * tolerance) {
            0 => {}
            1 => found(here.refine_past_zero(low, self.end, from)),
            _ if self.may_halve(here, depth) => self.halve(here, found, depth),
            _ if from == to => {}
            _ => found(here.refine_past_zero(low, self.end, from)),
        }
    }

    /// Whether the combination is zero all over the panel to within rounding, or so small that it has lost digits for that alone.
    fn is_lost<B: Basis<K>>(&self, here: &Combination<'_, B, K>, b: &Bernstein) -> bool {
        let greatest = self.functions.map(|f| f.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        let rounding = (8.0 * f64::EPSILON * here.sum_and_size(&greatest).1).max(f64::MIN_POSITIVE);
        b.iter().all(|value| value.abs() <= rounding)
    }

    /// What rounding may leave of a combination that vanishes at the start.
    #[inline]
    fn rounding_at_start<B: Basis<K>>(&self, here: &Combination<'_, B, K>) -> f64 {
        4.0 * f64::EPSILON * here.sum_and_size(&self.functions.map(|f| f[0])).1
    }

    /// The root of a polynomial with one change of sign: where the control polygon crosses, then two of Halley's steps.
    #[inline]
    fn guess(&self, b: &Bernstein) -> f64 {
        let positive = b[0] >= 0.0;
        let after = b.iter().position(|&value| (value >= 0.0) != positive).unwrap_or(ORDER - 1).max(1);
        let (before, past) = (b[after - 1], b[after]);
        let t = ((after - 1) as f64 + before / (before - past)) / (ORDER - 1) as f64;
        self.start + (self.end - self.start) * bernstein::polish(b, t)
    }
}

/// A polynomial and how far it may be off.
type Sum = (Bernstein, f64);

#[cfg(test)]
mod tests;
