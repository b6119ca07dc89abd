//! Every root of a linear combination of known functions on an interval, none missed and none twice.
//!
//! The functions are kept as polynomials (a [`Panel`]) with a bound on what the polynomials leave out, so that a
//! combination costs a few products and its coefficients' signs tell how many roots there can be: none or one at once,
//! nearly always. Where they do not decide, the derivative's signs may (monotone; one extremum, whose exact height then
//! decides), and otherwise the panel is halved and fitted anew. Ends shared by two panels have one exact sign, zero
//! counting as positive, so that a root on the border belongs to exactly one of them. Roots at coordinate 0 itself are
//! divided out.

use core::cell::Cell;

use super::bernstein::{self, Bernstein, NODES, ORDER};
use super::dual::Dual;
use super::root;

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

/// Halvings in one search, far more than two roots near each other need.
const MOST_HALVINGS: u32 = 1000;

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
        let (even, even_tolerance) = self.sum(&pair.even);
        let (odd, odd_tolerance) = self.sum(&pair.odd);
        let tolerance = even_tolerance + odd_tolerance;
        for side in [1.0, -1.0] {
            let b: Bernstein = core::array::from_fn(|i| even[i] + side * odd[i]);
            if !bernstein::one_sign(&b, tolerance) {
                let here = Combination { basis, pair, side, halvings: Cell::new(MOST_HALVINGS) };
                self.search(&here, &b, tolerance, &mut |root| found(side, root), DEEPEST);
            }
        }
    }

    /// The polynomial of a weighted sum, and how far it may be off.
    #[inline]
    fn sum(&self, weights: &[f64; K]) -> (Bernstein, f64) {
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
                    Some(from) => self.search_past_zero(here, b, tolerance, from, found, depth),
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
        let (even, even_tolerance) = self.sum(&here.pair.even);
        let (odd, odd_tolerance) = self.sum(&here.pair.odd);
        let b = core::array::from_fn(|i| even[i] + here.side * odd[i]);
        self.search(here, &b, even_tolerance + odd_tolerance, found, depth);
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
        let rounding = self.rounding(here);
        if b.iter().all(|value| value.abs() <= rounding) {
            // zero all over to within rounding: on a whole panel no root stands out; on a part of one, two roots may meet
            if depth == DEEPEST {
            } else if self.start > 0.0 {
                here.around(0.5 * (self.start + self.end), self.start, self.end, from, to, found);
            } else if from != to {
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
        let values = here.basis.at(1e-60).map(|function| function.value);
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

    /// The combination vanishes at coordinate 0, beyond which it has the sign `from`: its roots elsewhere are those of the
    /// quotient by the coordinate.
    #[cold]
    fn search_past_zero<B: Basis<K>>(
        &self,
        here: &Combination<'_, B, K>,
        b: &Bernstein,
        tolerance: f64,
        from: bool,
        found: &mut impl FnMut(Root),
        depth: u32,
    ) {
        // t·Σ cᵢ Bᵢ¹⁰ = Σ bᵢ Bᵢ¹¹ gives cᵢ = 11 bᵢ₊₁/(i + 1), of which the first keeps no digits but has a sure sign
        let mut quotient: [f64; ORDER - 1] = core::array::from_fn(|i| b[i + 1] * ((ORDER - 1) as f64 / (i + 1) as f64));
        quotient[0] = if from { 1.0 } else { -1.0 };
        match bernstein::sign_changes(&quotient, (ORDER - 1) as f64 * tolerance) {
            0 => {}
            1 => found(here.refine(self.start, self.end, from, 0.5 * self.end)),
            _ if depth > 0 && here.may_halve() => self.halve(here, found, depth),
            _ if from == (b[ORDER - 1] >= 0.0) => {}
            _ => found(here.refine(self.start, self.end, from, 0.5 * self.end)),
        }
    }

    /// What rounding may leave of a combination that vanishes on the whole panel.
    fn rounding<B: Basis<K>>(&self, here: &Combination<'_, B, K>) -> f64 {
        let greatest = self.functions.map(|f| f.iter().fold(0.0, |m: f64, v| m.max(v.abs())));
        8.0 * f64::EPSILON * here.sum_and_size(&greatest).1
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

/// One combination of a pair, evaluated exactly.
struct Combination<'a, B, const K: usize> {
    basis: &'a B,
    pair: &'a Pair<K>,
    side: Side,
    /// halvings left: where rounding alone is at work they would go on and on
    halvings: Cell<u32>,
}

impl<B: Basis<K>, const K: usize> Combination<'_, B, K> {
    #[inline]
    fn at(&self, t: f64) -> Dual {
        let (mut even, mut odd) = (Dual::new(0.0, 0.0), Dual::new(0.0, 0.0));
        for (k, function) in self.basis.at(t).iter().enumerate() {
            even = even + self.pair.even[k] * *function;
            odd = odd + self.pair.odd[k] * *function;
        }
        even + self.side * odd
    }

    /// Takes one from the halvings left, if there is one.
    fn may_halve(&self) -> bool {
        let left = self.halvings.get();
        self.halvings.set(left.saturating_sub(1));
        left > 0
    }

    /// The combination of given values, and the sum of its terms' sizes.
    fn sum_and_size(&self, values: &[f64; K]) -> (f64, f64) {
        let (mut even, mut odd, mut size) = (0.0, 0.0, 0.0);
        for (k, value) in values.iter().enumerate() {
            even += self.pair.even[k] * value;
            odd += self.pair.odd[k] * value;
            size += (self.pair.even[k] * value).abs() + (self.pair.odd[k] * value).abs();
        }
        (even + self.side * odd, size)
    }

    /// What rounding may make of the combination at `t`.
    fn rounding(&self, t: f64) -> f64 {
        8.0 * f64::EPSILON * self.sum_and_size(&self.basis.at(t).map(|f| f.value)).1
    }

    /// The root between `low` and `high`, of which the combination is positive at `low` or at `high` alone.
    #[inline]
    fn refine(&self, low: f64, high: f64, positive_low: bool, start: f64) -> Root {
        let (at, slope) = root::bracketed(|t| self.at(t), low, high, positive_low, start);
        Root { at, slope, double: false }
    }

    /// Where the slope vanishes, known to happen once between `low` and `high`.
    fn extremum(&self, mut low: f64, mut high: f64, rises: bool) -> f64 {
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if (self.at(middle).slope > 0.0) == rises {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The roots on either side of the only extremum, at `top`.
    fn around(&self, top: f64, start: f64, end: f64, from: bool, to: bool, found: &mut impl FnMut(Root)) {
        let height = self.at(top);
        let above = height.value >= 0.0;
        if from != to {
            let (low, high) = if above == from { (top, end) } else { (start, top) };
            found(self.refine(low, high, from, 0.5 * (low + high)));
        } else if height.value.abs() <= self.rounding(top) {
            found(Root { at: top, slope: height.slope, double: true });
        } else if above != from {
            found(self.refine(start, top, from, 0.5 * (start + top)));
            found(self.refine(top, end, above, 0.5 * (top + end)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Powers 1, t, … t⁶, of which any polynomial is a combination.
    struct Powers;

    impl Basis<7> for Powers {
        fn at(&self, t: f64) -> [Dual; 7] {
            let x = Dual::new(t, 1.0);
            let mut power = Dual::new(1.0, 0.0);
            core::array::from_fn(|_| {
                let this = power;
                power = power * x;
                this
            })
        }
    }

    /// Coefficients of Π (t − root).
    fn with_roots(roots: &[f64]) -> [f64; 7] {
        let mut c = [0.0; 7];
        c[0] = 1.0;
        for (degree, root) in roots.iter().enumerate() {
            for k in (0..=degree + 1).rev() {
                c[k] = if k > 0 { c[k - 1] } else { 0.0 } - root * c[k];
            }
        }
        c
    }

    fn all(weights: &[f64; 7]) -> Vec<Root> {
        let mut roots = Vec::new();
        for i in 0..4 {
            let (a, b) = (0.25 * f64::from(i), 0.25 * f64::from(i + 1));
            // of the mirror image, with all coefficients negative, the roots are the same
            let pair = Pair { even: [0.0; 7], odd: *weights };
            Panel::fit(&Powers, a, b).roots(&Powers, &pair, &mut |side, root| {
                if side > 0.0 {
                    roots.push(root);
                }
            });
        }
        roots.sort_by(|a, b| a.at.total_cmp(&b.at));
        roots
    }

    #[test]
    fn none_missed_none_twice() {
        for roots in [
            vec![],
            vec![0.3],
            vec![0.25], // on a border
            vec![0.25, 0.5, 0.75],
            vec![0.4, 0.4000001],
            vec![0.1, 0.10001, 0.9, 0.95],
            vec![0.2, 0.7, 1.5, -0.3],
            vec![1e-7, 0.6],
            vec![0.31, 0.32, 0.33, 0.34, 0.35],
        ] {
            let got = all(&with_roots(&roots));
            let mut inside: Vec<f64> = roots.iter().copied().filter(|r| (0.0..1.0).contains(r)).collect();
            inside.sort_by(f64::total_cmp);
            assert_eq!(got.len(), inside.len(), "{roots:?} gave {got:?}");
            for (g, want) in got.iter().zip(&inside) {
                assert!((g.at - want).abs() < 1e-8 && !g.double, "{roots:?} gave {got:?}");
            }
        }
    }

    #[test]
    fn touching_zero_is_one_double_root() {
        let got = all(&with_roots(&[0.6, 0.6]));
        assert!(got.len() == 1 && got[0].double && (got[0].at - 0.6).abs() < 1e-7, "{got:?}");
        let got = all(&[0.36 + 1e-9, -1.2, 1.0, 0.0, 0.0, 0.0, 0.0]); // and misses it by 1e-9
        assert!(got.is_empty(), "{got:?}");
    }

    /// A dip midway between two nodes, so narrow that the nodes hardly see it.
    struct Dip;

    const MIDWAY: f64 = 0.5 * (NODES[4] + NODES[5]);
    const WIDTH: f64 = 0.03;

    impl Basis<2> for Dip {
        fn at(&self, t: f64) -> [Dual; 2] {
            let from = (t - MIDWAY) / WIDTH;
            let dip = libm::exp(-from * from);
            [Dual::new(dip, -2.0 * from / WIDTH * dip), Dual::new(1.0, 0.0)]
        }
    }

    #[test]
    fn where_the_polynomials_fail_they_are_not_trusted() {
        let panel = Panel::fit(&Dip, 0.0, 1.0);
        for (depth, want) in [(1.2, 2), (0.999, 0)] {
            let pair = Pair { even: [-depth, 1.0], odd: [0.0; 2] };
            let mut roots = Vec::new();
            panel.roots(&Dip, &pair, &mut |side, root| {
                if side > 0.0 {
                    roots.push(root.at);
                }
            });
            assert_eq!(roots.len(), want, "depth {depth}: {roots:?}");
            for root in roots {
                assert!(((root - MIDWAY).abs() - WIDTH * libm::sqrt(libm::log(depth))).abs() < 1e-12, "{root}");
            }
        }
    }

    #[test]
    fn zero_everywhere_has_no_root_that_stands_out() {
        assert!(all(&[0.0; 7]).is_empty()); // and ends at once
        let faint = with_roots(&[0.6, 0.7]).map(|c| c * 1e-300);
        assert_eq!(all(&faint).len(), 2);
    }

    #[test]
    fn orders_that_cancel_at_zero_end_the_search() {
        // t − sin t and t cancel to third order: t − sin t − h t has a root at √(6h) about
        struct Third;
        impl Basis<3> for Third {
            fn at(&self, t: f64) -> [Dual; 3] {
                let (sin, cos) = libm::sincos(t);
                [Dual::new(t, 1.0), Dual::new(sin, cos), Dual::new(t * t * t, 3.0 * t * t)]
            }
        }
        let count = |weights: [f64; 3]| {
            let mut roots = Vec::new();
            let pair = Pair { even: weights, odd: [0.0; 3] };
            Panel::fit(&Third, 0.0, 0.5).roots(&Third, &pair, &mut |side, root| {
                if side > 0.0 {
                    roots.push(root.at);
                }
            });
            roots
        };
        assert!(count([1.0, -1.0, 0.0]).is_empty());
        let _ = count([1.0, -1.0, -1.0 / 6.0]); // fifth order is lost in rounding, but the search ends
        let small = count([1.0 - 1e-6, -1.0, 0.0]);
        assert!(small.len() == 1 && (small[0] / libm::sqrt(6e-6) - 1.0).abs() < 1e-6, "{small:?}");
        let half = count([1.0, -1.0, -1.0 / 6.0 + 1e-3]); // t⁵/120 = 1e-3 t³
        assert!(half.len() == 1 && (half[0] - libm::sqrt(0.12)).abs() < 1e-2, "{half:?}");
    }

    #[test]
    fn zero_itself_is_divided_out() {
        let got = all(&with_roots(&[0.0, 0.0, 0.6])); // t²(t − 0.6)
        assert!(got.len() == 1 && (got[0].at - 0.6).abs() < 1e-14, "{got:?}");
        let got = all(&with_roots(&[0.0, 1e-12, 0.6]));
        assert!(got.len() == 2 && (got[0].at / 1e-12 - 1.0).abs() < 1e-12, "{got:?}");
    }
}
