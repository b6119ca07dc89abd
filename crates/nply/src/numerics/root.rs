//! One root in a bracket.

use super::dual::Dual;

/// A step so small that the next one, which squares it, is lost in rounding.
const SETTLED: f64 = 3e-9;
/// Newton steps before every other one halves the bracket.
const PATIENCE: u32 = 10;

/// Newton's method between 0 ≤ `low` < `high`; `f` is positive at `low` or at `high` alone, as `positive_low` says (zero
/// counts as positive). Gives the root and the slope there.
#[inline]
pub(crate) fn bracketed(
    f: impl Fn(f64) -> Dual,
    mut low: f64,
    mut high: f64,
    positive_low: bool,
    start: f64,
) -> (f64, f64) {
    let mut t = if start > low && start < high { start } else { between(low, high) };
    let mut turn = 0;
    loop {
        let here = f(t);
        if (here.value >= 0.0) == positive_low {
            low = t;
        } else {
            high = t;
        }
        let next = t - here.value / here.slope;
        if (next - t).abs() <= SETTLED * t && next >= low && next <= high {
            return (next, here.slope);
        }
        turn += 1;
        let trusted = next > low && next < high && (turn < PATIENCE || turn % 2 == 0);
        t = if trusted { next } else { between(low, high) };
        if t <= low || t >= high {
            return (t, here.slope);
        }
    }
}

/// Squares of less underflow, and what is made of them has no sign.
const LEAST: f64 = 1e-150;

/// A point between 0 ≤ `low` < `high`: in the middle, or midway in orders of magnitude where those differ.
fn between(low: f64, high: f64) -> f64 {
    if high > 4.0 * low && low < 1e-3 { libm::sqrt(low.max(1e-300) * high).max(LEAST) } else { 0.5 * (low + high) }
}

#[cfg(test)]
mod tests {
    use super::{Dual, bracketed};

    #[test]
    fn finds_roots_of_every_size() {
        for root in [1e-200, 1e-17, 1e-5, 0.3, 0.999] {
            let f = |t: f64| Dual::new(t * t * t - root * root * root, 3.0 * t * t);
            let (got, _) = bracketed(f, 0.0, 1.0, false, 0.5);
            assert!((got / root - 1.0).abs() < 1e-15 || root < 1e-100, "{got} for {root}");
        }
        let (got, slope) = bracketed(|t| Dual::new(0.25 - t, -1.0), 0.0, 1.0, true, 0.9);
        assert!((got - 0.25).abs() < 1e-16 && slope < 0.0);
    }
}
