//! Kepler's equation in the form that contact takes: E + tan²θ sin E = λ, λ = 2π/n, 0 < E ≤ λ.
//!
//! E = π − z and λ = π − M turn it into z − e sin z = M with eccentricity e = tan²θ. The main branch has one root. For up to
//! twelve strands it is charted: polynomials in the pitch angle, exact to rounding, with nothing left to correct. Two strands
//! past π/4, and more than twelve, start from a close guess, and one correction of fourth order ends within rounding.

use core::f64::consts::PI;

use super::kepler_chart::{CHARTS, LAST, PIECES, PITCHFORK, TALL};
use super::quadrant::sincos;
use super::series::one_minus_sinc;

/// The root by the sine and cosine of its half, both to a few units in the last place, even where they vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HalfAnomaly {
    /// sin(E/2)
    pub(crate) sin: f64,
    /// cos(E/2); zero in line contact
    pub(crate) cos: f64,
    /// cos²θ + sin²θ cos E, the slope of Kepler's equation times cos²θ; zero at the pitchfork together with `cos`
    slope: f64,
}

impl HalfAnomaly {
    /// Two strands in line contact: E = π.
    pub(crate) const LINE: Self = Self { sin: 1.0, cos: 0.0, slope: 1.0 };

    /// cos²(E/2)/(cos²θ + sin²θ cos E), which stays finite at the pitchfork.
    #[inline]
    pub(crate) fn share_of_slope(&self) -> f64 {
        self.cos * self.cos / self.slope
    }

    /// The slope dθ of [`share_of_slope`](Self::share_of_slope), from those of cos²(E/2) and of the slope of Kepler's equation.
    pub(crate) fn share_slope(&self, cos_squared_slope: f64, slope_slope: f64) -> f64 {
        // two strands at the pitchfork: numerator and denominator vanish together; the limit is −12/5
        const NEAREST: f64 = 3e-6;
        if self.cos == 0.0 {
            0.0
        } else if self.slope < NEAREST {
            -2.4
        } else {
            (cos_squared_slope - self.share_of_slope() * slope_slope) / self.slope
        }
    }
}

/// The main branch for `strands` ≥ 2 at the angle with sine `s` > 0 or 0, cosine `c` > 0 and complement `pitch`.
///
/// `cos_double` is cos 2θ, wanted to full relative precision near θ = π/4 when there are two strands; others ignore it.
#[inline(always)]
pub(crate) fn main_branch(strands: u32, pitch: f64, s: f64, c: f64, cos_double: f64) -> HalfAnomaly {
    let w = c * c;
    if strands > 2 && strands as usize <= LAST {
        charted(strands as usize, pitch, s, w)
    } else if strands > 2 {
        let lambda = 2.0 * PI / f64::from(strands);
        rising(start(lambda, s, w), lambda, s, w)
    } else if cos_double >= 0.0 {
        HalfAnomaly::LINE
    } else if w < 0.25 {
        rising(w * polynomial(&TALL, 8.0 * w - 1.0), PI, s, w)
    } else {
        pitchfork(s, -cos_double / (s * s))
    }
}

/// Three to twelve strands, from the pitch angle alone, while sine and cosine of the angle are still being worked out.
#[inline(always)]
fn charted(strands: usize, pitch: f64, s: f64, w: f64) -> HalfAnomaly {
    let place = pitch * (PIECES as f64 * core::f64::consts::FRAC_2_PI);
    let piece = (place as usize).min(PIECES - 1); // straight strands stand at the end of the last
    let u = 2.0 * (place - piece as f64) - 1.0;
    let [sine, cosine] = &CHARTS[strands - 3][piece];
    let (sin, cos) = (pitch * pitch * short_polynomial(sine, u), short_polynomial(cosine, u));
    HalfAnomaly { sin, cos, slope: w + s * s * (cos - sin) * (cos + sin) }
}

/// Where the correction for many strands begins: sin E = E − E³/6 turned round to third order; λ < 1/2 leaves a relative
/// error below 1e-4.
#[inline]
fn start(lambda: f64, s: f64, w: f64) -> f64 {
    let first = lambda * w;
    let a = s * s * first * first / 6.0;
    first * (1.0 + a * (1.0 + 3.0 * a))
}

/// One correction of fourth order in E on the rising part of E + e sin E, all terms multiplied by w = cos²θ.
#[inline(always)]
fn rising(start: f64, lambda: f64, s: f64, w: f64) -> HalfAnomaly {
    let ss = s * s;
    let (sh, ch) = sincos(0.5 * start);
    let (sin_e, cos_e) = (2.0 * sh * ch, (ch - sh) * (ch + sh));
    let residual = w * (lambda - start) - ss * sin_e;
    let (sin, cos) = turn(sh, ch, 0.5 * inverse_series(residual, w + ss * cos_e, -ss * sin_e, -ss * cos_e));
    HalfAnomaly { sin, cos, slope: w + ss * (cos - sin) * (cos + sin) }
}

/// Two strands just above π/4, in z = π − E, where z ≈ √(6μ) and μ = 1 − cot²θ.
///
/// The residual is z − e sin z = e z ((1 − sin z/z) − μ): both brackets are small together and neither has cancelled.
#[inline]
fn pitchfork(s: f64, mu: f64) -> HalfAnomaly {
    let z = libm::sqrt(mu) * polynomial(&PITCHFORK, 1.0 - 2.0 * mu);
    let (sh, ch) = sincos(0.5 * z); // sin(z/2) = cos(E/2)
    // everything divided by e: v z − sin z = 0, v = 1 − μ = 1/e
    let residual = z * (mu - one_minus_sinc(z));
    let slope = 2.0 * sh * sh - mu; // v − cos z
    let (cos, sin) = turn(sh, ch, 0.5 * inverse_series(residual, slope, 2.0 * sh * ch, (ch - sh) * (ch + sh)));
    HalfAnomaly { sin, cos, slope: s * s * (2.0 * cos * cos - mu) }
}

/// The step δ with f₁ δ + f₂ δ²/2 + f₃ δ³/6 = `residual`, by reversion: the error is of fourth order in δ.
#[inline(always)]
fn inverse_series(residual: f64, f1: f64, f2: f64, f3: f64) -> f64 {
    let inverse = 1.0 / f1;
    let (d, a2, a3) = (residual * inverse, 0.5 * f2 * inverse, f3 * inverse * (1.0 / 6.0));
    d * (1.0 - d * (a2 - d * (2.0 * a2 * a2 - a3)))
}

/// (sin, cos) turned on by a small angle d, |d| < 1e-4: the first term left out is d⁴/24.
#[inline(always)]
fn turn(sin: f64, cos: f64, d: f64) -> (f64, f64) {
    let (even, odd) = (0.5 * d * d, d * (1.0 - d * d * (1.0 / 6.0)));
    (sin + (cos * odd - sin * even), cos - (sin * odd + cos * even))
}

/// Estrin's scheme: short chains instead of Horner's long one.
#[inline(always)]
fn polynomial(a: &[f64; 13], u: f64) -> f64 {
    let u2 = u * u;
    let u4 = u2 * u2;
    let u8 = u4 * u4;
    let low = (a[0] + a[1] * u) + (a[2] + a[3] * u) * u2;
    let middle = (a[4] + a[5] * u) + (a[6] + a[7] * u) * u2;
    let high = (a[8] + a[9] * u) + (a[10] + a[11] * u) * u2;
    (low + middle * u4) + (high + a[12] * u4) * u8
}

/// As [`polynomial`], one degree less.
#[inline(always)]
fn short_polynomial(a: &[f64; 12], u: f64) -> f64 {
    let u2 = u * u;
    let u4 = u2 * u2;
    let low = (a[0] + a[1] * u) + (a[2] + a[3] * u) * u2;
    let middle = (a[4] + a[5] * u) + (a[6] + a[7] * u) * u2;
    let high = (a[8] + a[9] * u) + (a[10] + a[11] * u) * u2;
    low + (middle + high * u4) * u4
}
