//! ∫ (1 − C) du at large lags, where every pair of strands has the same few harmonics.
//!
//! 1 − C = −Σ (−½ over j) (s tan θ/u)²ʲ, s² = 2 − 2 cos(u − α), is a sum of cos m(u − α)/u²ʲ. Integrated from U to ∞ and added for
//! α and −α it is 2 Σ Aₘ(U) cos mα: what depends on the ply and on U is worked out once for all its strands.

use super::chord::Bounded;

/// Most powers (s tan θ/u)², and most harmonics.
const POWERS: usize = 15;
/// Greatest ratio 2 tan θ/U for which those powers are enough: what is left out is below 1e-15.
const STEEPEST: f64 = 1.0 / 3.0;
/// (2j over j + m): row j, column m, both from 0.
const BINOMIALS: [[f64; POWERS + 1]; POWERS + 1] = binomials();

const fn binomials() -> [[f64; POWERS + 1]; POWERS + 1] {
    let mut table = [[0.0; POWERS + 1]; POWERS + 1];
    table[0][0] = 1.0;
    let mut j = 1;
    while j <= POWERS {
        let mut m = 0;
        while m <= j {
            // Pascal's rule twice; the row above is even in m
            let above = table[j - 1];
            let left = if m == 0 { above[1] } else { above[m - 1] };
            let right = if m < POWERS { above[m + 1] } else { 0.0 };
            table[j][m] = left + 2.0 * above[m] + right;
            m += 1;
        }
        j += 1;
    }
    table
}

/// Aₘ(U), m = 0, 1, …
#[derive(Clone, Copy, Debug)]
pub(super) struct Tail {
    harmonics: [f64; POWERS + 1],
    count: usize,
    bound: f64,
}

/// Jₚ Uᵖ exp(−imU) for every m, with Jₚ = ∫ exp(imu) u⁻ᵖ du from U to ∞: i ∫ exp(−my) (1 + iy/U)⁻ᵖ dy from 0.
///
/// By parts Jₚ = (i/m) exp(imU) U⁻ᵖ − (ip/m) Jₚ₊₁, from a p where the two terms are nearly as great, downwards.
struct Ladder {
    re: [f64; POWERS + 1],
    im: [f64; POWERS + 1],
    /// bound on their errors
    lost: [f64; POWERS + 1],
    /// 1/m and 1/mU
    step: [f64; POWERS + 1],
    ratio: [f64; POWERS + 1],
}

impl Ladder {
    const TOP: usize = 2 * POWERS;

    /// At the top as if it changed no more with p, by which it changes less than 1/m²U.
    fn new(lag: f64) -> Self {
        let (mut re, mut im, mut lost) = ([0.0; POWERS + 1], [0.0; POWERS + 1], [0.0; POWERS + 1]);
        let (mut step, mut ratio) = ([0.0; POWERS + 1], [0.0; POWERS + 1]);
        for m in 1..=POWERS {
            step[m] = 1.0 / m as f64;
            ratio[m] = step[m] / lag;
            let q = Self::TOP as f64 * ratio[m];
            let square = 1.0 + q * q;
            (re[m], im[m]) = (step[m] * q / square, step[m] / square);
            lost[m] = step[m] * ratio[m] * q / square.sqrt();
        }
        Self { re, im, lost, step, ratio }
    }

    /// From p + 1 to p.
    fn down(&mut self, p: f64) {
        for m in 0..=POWERS {
            let q = p * self.ratio[m];
            (self.re[m], self.im[m]) = (q * self.im[m], self.step[m] - q * self.re[m]);
            self.lost[m] *= q;
        }
    }
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
        // Aₘ = −2 (−1)ᵐ Re Σⱼ (−½ over j) tan²ʲθ (2j over j + m) J₂ⱼ, and half of it for m = 0, where J₂ⱼ = U¹⁻²ʲ/(2j − 1)
        let (mut re, mut im) = ([0.0; POWERS + 1], [0.0; POWERS + 1]);
        let mut ladder = Ladder::new(lag);
        for j in (1..=POWERS).rev() {
            if j < POWERS {
                ladder.down(2.0 * j as f64 + 1.0);
                ladder.down(2.0 * j as f64);
            }
            if j > count {
                continue;
            }
            tail.harmonics[0] -= terms[j] * BINOMIALS[j][0] * lag / (2.0 * j as f64 - 1.0);
            for m in 1..=POWERS {
                let weight = terms[j] * BINOMIALS[j][m];
                re[m] += weight * ladder.re[m];
                im[m] += weight * ladder.im[m];
                tail.bound += 4.0 * weight.abs() * ladder.lost[m];
            }
        }
        let (sin, cos) = libm::sincos(lag);
        let mut turn = (1.0, 0.0); // exp(imU)
        for m in 1..=count {
            turn = (turn.0 * cos - turn.1 * sin, turn.0 * sin + turn.1 * cos);
            let sign = if m % 2 == 0 { -2.0 } else { 2.0 };
            tail.harmonics[m] = sign * (turn.0 * re[m] - turn.1 * im[m]);
        }
        tail
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
