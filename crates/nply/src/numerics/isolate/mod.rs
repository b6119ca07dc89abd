//! Every root of a linear combination of known functions on an interval, none missed and none twice.
//!
//! The functions are kept as polynomials (a [`Panel`]) with a bound on what the polynomials leave out, so that a
//! combination costs a few products and its coefficients' signs tell how many roots there can be: none or one at once,
//! nearly always. Where they do not decide, the derivative's signs may (monotone; one extremum, whose exact height then
//! decides), and otherwise the panel is halved and fitted anew. Ends shared by two panels have one exact sign, zero
//! counting as positive, so that a root on the border belongs to exactly one of them. Roots at coordinate 0 itself are
//! divided out.

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

/// Halvings after which a panel is narrower than rounding can tell apart.
const DEEPEST: u32 = 44;

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
        let parts = (self.sum(&pair.even), self.sum(&pair.odd));
        for side in [1.0, -1.0] {
            let (b, tolerance) = joined(&parts, side);
            if !bernstein::one_sign(&b, tolerance) {
                let here = Combination::new(basis, pair, side);
                self.search(&here, &b, tolerance, &mut |root| found(side, root), DEEPEST);
            }
        }
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
                match self.sign_past_zero(here, slope, slope_lost) {
                    Some(from) => {
                        // nearer to 0 than this what is left of the terms that cancel there hides the first order
                        let hidden = if slope == 0.0 { FIRST } else { self.rounding_at_start(here) / slope.abs() };
                        let low = hidden.min(0.5 * self.end);
                        self.search_past_zero(here, b, tolerance, (from, low), found, depth);
                    }
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

    /// Either half, fitted anew.
    fn halve<B: Basis<K>>(&self, here: &Combination<'_, B, K>, found: &mut impl FnMut(Root), depth: u32) {
        let middle = 0.5 * (self.start + self.end);
        for (start, end) in [(self.start, middle), (middle, self.end)] {
            Self::fit(here.basis, start, end).search_fitted(here, found, depth - 1);
        }
    }

    /// The search of a panel of which the combination's polynomial is not known yet.
    fn search_fitted<B: Basis<K>>(&self, here: &Combination<'_, B, K>, found: &mut impl FnMut(Root), depth: u32) {
        let parts = (self.sum(&here.pair.even), self.sum(&here.pair.odd));
        let (b, tolerance) = joined(&parts, here.side);
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
            _ if depth > 0 && here.may_halve() => self.halve(here, found, depth),
            // narrower than rounding: value, slope and curvature vanish together
            _ => here.around(0.5 * (self.start + self.end), self.start, self.end, from, to, found),
        }
    }

    /// The sign just past coordinate 0, where the combination vanishes; `None` where its first order cancels to rounding.
    fn sign_past_zero<B: Basis<K>>(&self, here: &Combination<'_, B, K>, slope: f64, slope_lost: bool) -> Option<bool> {
        if slope != 0.0 {
            return (!slope_lost).then_some(slope > 0.0);
        }
        // all functions vanish to a higher order: so close to 0 nothing but the lowest counts
        let values = here.basis.at(FIRST).map(|function| function.value);
        let (value, size) = here.sum_and_size(&values);
        (!slope_lost && value.abs() > 8.0 * f64::EPSILON * size).then_some(value > 0.0)
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

    /// The combination vanishes at coordinate 0, beyond which it has the sign `from`, at `low` for sure: its roots elsewhere are those of the
    /// quotient by the coordinate.
    #[cold]
    fn search_past_zero<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        b: &Bernstein,
        tolerance: f64,
        (from, low): (bool, f64),
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        let to = b[ORDER - 1] >= 0.0;
        if self.is_lost(here, b) {
            if depth < DEEPEST && from != to {
                found(here.refine_past_zero(low, self.end, from));
            }
            return;
        }
        // t·Σ cᵢ Bᵢ¹⁰ = Σ bᵢ Bᵢ¹¹ gives cᵢ = 11 bᵢ₊₁/(i + 1), of which the first keeps no digits but has a sure sign
        let mut quotient: [f64; ORDER - 1] = core::array::from_fn(|i| b[i + 1] * ((ORDER - 1) as f64 / (i + 1) as f64));
        quotient[0] = if from { 1.0 } else { -1.0 };
        // what a polynomial of degree k within the tolerance is over t is at most 2k² times it (Markov)
        match bernstein::sign_changes(&quotient, (2 * (ORDER - 1) * (ORDER - 1)) as f64 * tolerance) {
            0 => {}
            1 => found(here.refine_past_zero(low, self.end, from)),
            _ if depth > 0 && here.may_halve() => self.halve(here, found, depth),
            _ if from == to => {}
            _ => found(here.refine_past_zero(low, self.end, from)),
        }
    }

    /// Whether the combination is zero all over the panel to within rounding.
    fn is_lost<B: Basis<K>>(&self, here: &Combination<'_, B, K>, b: &Bernstein) -> bool {
        let greatest = self.functions.map(|f| f.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        let rounding = 8.0 * f64::EPSILON * here.sum_and_size(&greatest).1;
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

/// Even part plus, or less, odd part.
#[inline]
fn joined(parts: &(Sum, Sum), side: Side) -> Sum {
    let ((even, even_tolerance), (odd, odd_tolerance)) = parts;
    (core::array::from_fn(|i| even[i] + side * odd[i]), even_tolerance + odd_tolerance)
}

#[cfg(test)]
mod tests;
