//! ∫ (1 − C) du at large lags, where every pair of strands has the same few harmonics.
//!
//! 1 − C = −Σ (−½ over j) (s tan θ/u)²ʲ, s² = 2 − 2 cos(u − α), is a sum of cos m(u − α)/u²ʲ. Integrated from U to ∞ and added for
//! α and −α it is 2 Σ Aₘ(U) cos mα: what depends on the ply and on U is worked out once for all its strands.

use super::chord::Bounded;

/// Most powers (s tan θ/u)².
const POWERS: usize = 16;
/// Greatest ratio 2 tan θ/U for which those powers are enough: what is left out is below 1e-16.
const STEEPEST: f64 = 1.0 / 3.0;

/// Aₘ(U), m = 0, 1, …
#[derive(Clone, Copy, Debug)]
pub(super) struct Tail {
    harmonics: [f64; POWERS + 1],
    count: usize,
    bound: f64,
}

impl Tail {
    /// The least lag from which it holds for a helix of this tan θ; by itself it also wants U of some 25 or more.
    pub(super) fn least_lag(tan: f64) -> f64 {
        2.0 * tan / STEEPEST
    }

    pub(super) fn new(tan: f64, lag: f64) -> Self {
        let ratio = tan / lag;
        let square = ratio * ratio;
        // (−½ over j) (tan θ/U)²ʲ, until what is left out, s² ≤ 4 and signs alternating, is below rounding
        let mut terms = [0.0; POWERS + 1];
        let (mut term, mut power, mut count) = (1.0, lag, 0);
        let next = |term: f64, j: f64| -term * square * (2.0 * j - 1.0) / (2.0 * j);
        for (slot, j) in terms[1..].iter_mut().zip(1_usize..) {
            term = next(term, j as f64);
            power *= 4.0;
            if term.abs() * power < 1e-17 {
                break;
            }
            (*slot, count) = (term, j);
        }
        let left_out = if count < POWERS { 1e-17 } else { next(term, 1.0 + POWERS as f64).abs() * power * 4.0 };
        let mut tail = Self { harmonics: [0.0; POWERS + 1], count, bound: 2.0 * left_out };
        let mut binomial = 1.0;
        for (j, term) in terms.iter().enumerate().take(count + 1).skip(1) {
            let j = j as f64;
            binomial *= 2.0 * (2.0 * j - 1.0) / j; // (2j over j)
            tail.harmonics[0] -= term * binomial * lag / (2.0 * j - 1.0);
        }
        let (sin, cos) = libm::sincos(lag);
        let mut turn = (1.0, 0.0); // exp(imU)
        let mut sign = 1.0;
        for m in 1..=count {
            turn = (turn.0 * cos - turn.1 * sin, turn.0 * sin + turn.1 * cos);
            sign = -sign;
            tail.harmonics[m] = -2.0 * sign * tail.harmonic(m, lag, turn, &terms);
        }
        tail
    }

    /// Re Σⱼ (−½ over j) tan²ʲθ (2j over j + m) Jₚ, p = 2j, with Jₚ = ∫ exp(imu) u⁻ᵖ du from U to ∞: by parts Jₚ = (i/m) exp(imU) U⁻ᵖ − (ip/m) Jₚ₊₁,
    /// from a p where the two terms would grow equal, downwards.
    fn harmonic(&mut self, m: usize, lag: f64, turn: (f64, f64), terms: &[f64; POWERS + 1]) -> f64 {
        let step = 1.0 / m as f64;
        let far = (m as f64 * lag).min(36.0) as usize;
        let start = far.max(2 * self.count);
        // kappa = Jₚ Uᵖ exp(−imU) = i ∫ exp(−my) (1 + iy/U)⁻ᵖ dy; at the start as if it changed no more with p, by which it changes less than 1/m²U
        let q = start as f64 * step / lag;
        let mut kappa = (step * q / (1.0 + q * q), step / (1.0 + q * q));
        let mut lost = step * step / lag * q / libm::sqrt(1.0 + q * q); // bound on its error, passed on
        let mut weights = [0.0; POWERS + 1];
        let mut binomial = 1.0;
        for j in m..=self.count {
            weights[j] = terms[j] * binomial;
            let (j, m) = (j as f64, m as f64);
            binomial *= (2.0 * j + 1.0) * (2.0 * j + 2.0) / ((j + 1.0 + m) * (j + 1.0 - m));
        }
        let mut sum = (0.0, 0.0);
        for p in (2 * m..start).rev() {
            let q = p as f64 * step / lag;
            kappa = (q * kappa.1, step - q * kappa.0);
            lost *= q;
            if p % 2 == 0 && p / 2 <= self.count {
                sum.0 += weights[p / 2] * kappa.0;
                sum.1 += weights[p / 2] * kappa.1;
                self.bound += 4.0 * weights[p / 2].abs() * lost;
            }
        }
        turn.0 * sum.0 - turn.1 * sum.1
    }

    /// ∫ (1 − C_α) + (1 − C₋α) du from U to ∞.
    pub(super) fn pair(&self, cos_alpha: f64) -> Bounded {
        let (mut before, mut here) = (1.0, cos_alpha);
        let mut sum = self.harmonics[0];
        for harmonic in &self.harmonics[1..=self.count] {
            sum += harmonic * here;
            (before, here) = (here, 2.0 * cos_alpha * here - before);
        }
        Bounded { value: 2.0 * sum, bound: self.bound + 8.0 * f64::EPSILON * self.harmonics[0] }
    }
}
