//! The chord between two points of two equal helices: the cosine of its angle to the axis, integrated over the lag of the points.
//!
//! With u = Δψ and D² = 4 sin²((u − α)/2) sin²θ + u² cos²θ that cosine is C(u) = u cos θ/D, and it is the integral (A.10), (A.21) of
//! the kernels of (A.5), (A.16). Once more by parts the weight Ψ − |u| of the double integrals goes too, and what is
//! left is ∫ C du: near the lag zero by Gauss's rule on panels that the zeros of D stay clear of, at large lags by series.

use core::f64::consts::{FRAC_PI_2, TAU};

use crate::geometry::HelicalAngle;
use crate::numerics::gauss::{ACROSS, ALONG, LEFT, RULE};
use crate::numerics::quadrant;
use crate::numerics::series::one_minus_sinc;

/// A panel is narrow enough when its error is below this, rad, or when it is itself.
const SETTLED: f64 = 3e-13;
const NARROWEST: f64 = 1e-16;

/// A number and a bound on its error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bounded {
    pub(super) value: f64,
    pub(super) bound: f64,
}

impl core::ops::AddAssign for Bounded {
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        self.bound += other.bound;
    }
}

/// The chord from a helix to the one turned by α, −2π < α < 2π, at either of the points' lags.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    pub(super) sin: f64,
    pub(super) cos: f64,
    alpha: f64,
    half_sin: f64,
    half_cos: f64,
}

/// What holds of D on the ellipse about a panel.
pub(super) struct Clearance {
    /// no zero of D, and |D| at least this
    least: f64,
    /// |u| at most this
    most: f64,
}

impl Chord {
    pub(super) fn new(angle: HelicalAngle, alpha: f64) -> Self {
        let (half_sin, half_cos) = libm::sincos(0.5 * alpha);
        Self { sin: angle.sin(), cos: angle.cos(), alpha, half_sin, half_cos }
    }

    /// ∫ C du from `from` ≥ 0 to `to` for every chord, added to `sums`; for α = 0, where C jumps at zero, of C − cos θ.
    pub(super) fn integrals(chords: &[Self], from: f64, to: f64, sums: &mut [Bounded]) {
        let mut order: Vec<usize> = (0..chords.len()).collect();
        let mut low = from;
        while low < to {
            let next = libm::floor(low * (1.0 + f64::EPSILON) / TAU) * TAU + TAU;
            let high = if next < to { next } else { to };
            let panel = Panel { centre: 0.5 * (low + high), half: 0.5 * (high - low) };
            panel.each(chords, &mut order, &Self::error_on, &Self::sum_on, sums);
            low = high;
        }
    }

    /// Bound on the rule's error for the integrals on a panel, or none.
    fn error_on(&self, panel: &Panel) -> Option<f64> {
        if panel.half <= NARROWEST {
            return Some(4.0 * panel.half); // 0 ≤ C ≤ 1, summed or not
        }
        let clear = if self.itself() { self.own_clearance(panel) } else { self.clearance(panel, 0.0) }?;
        let bound = LEFT * panel.half * (self.cos * clear.most / clear.least + self.cos);
        (bound < SETTLED).then_some(bound)
    }

    fn sum_on(&self, nodes: &Nodes) -> f64 {
        if self.itself() {
            nodes.sum(self, |u, s| self.excess(u, s))
        } else {
            nodes.sum(self, |u, s| self.cosine(u, s))
        }
    }

    fn itself(&self) -> bool {
        self.half_sin.abs() < f64::MIN_POSITIVE
    }

    /// C at the lag u, with s = 2 sin((u − α)/2).
    #[inline(always)]
    fn cosine(&self, u: f64, s: f64) -> f64 {
        let (across, along) = (self.sin * s, self.cos * u);
        along / (across * across + along * along).sqrt()
    }

    /// C − cos θ for α = 0, where s/u → 1.
    fn excess(&self, u: f64, s: f64) -> f64 {
        let lack = if u < 0.5 { near_zero(0.25 * u * u) } else { 1.0 - s / u };
        let sinc = 1.0 - lack;
        let (across, along) = (self.sin * sinc, self.cos);
        let distance = (across * across + along * along).sqrt();
        along * self.sin * self.sin * lack * (1.0 + sinc) / (distance * (1.0 + distance))
    }

    /// On the ellipse about a panel, moved by whole periods, Re D² ≥ 4 sin²θ (sin²(η/2) − cos η sinh²(y/2)) + cos²θ (x² − y²), with η the least
    /// |u − α| modulo 2π and x the least |u| over its real parts, y its greatest imaginary part.
    pub(super) fn clearance(&self, panel: &Panel, periods: f64) -> Option<Clearance> {
        let (reach, y) = (ALONG * panel.half, ACROSS * panel.half);
        let phase = panel.centre - self.alpha;
        let turns = (phase / TAU + f64::copysign(0.5, phase)) as i64;
        let eta = ((phase - TAU * turns as f64).abs() - reach).max(0.0);
        let centre = panel.centre + periods;
        let x = (centre - reach).max(0.0);
        let (sine, _) = quadrant::sincos(0.5 * eta);
        let cos_eta = 1.0 - 2.0 * sine * sine;
        let swell = if cos_eta > 0.0 { sinh_above(0.5 * y) } else { 0.0 };
        let least = 4.0 * self.sin * self.sin * (sine * sine - cos_eta * swell * swell)
            + self.cos * self.cos * (x - y) * (x + y);
        (least > 0.0).then(|| Clearance { least: least.sqrt(), most: centre + reach + y })
    }

    /// The same for α = 0, where D has a double zero at u = 0 that C has not: for |Re u| ≤ π/2 Re (4 sin²(u/2)/u²) =
    /// ∫₋₁¹ (1 − |t|) cos(xt) cosh(yt) dt ≥ 4 sin²(x/2)/x².
    fn own_clearance(&self, panel: &Panel) -> Option<Clearance> {
        let x = panel.centre + ALONG * panel.half;
        if x > FRAC_PI_2 {
            return self.clearance(panel, 0.0);
        }
        let across = self.sin * (1.0 - one_minus_sinc(0.5 * x));
        Some(Clearance { least: (across * across + self.cos * self.cos).sqrt(), most: 1.0 })
    }
}

/// 1 − sin z/z from y = z² ≤ 1/16, by Taylor's series.
#[inline]
fn near_zero(y: f64) -> f64 {
    const LAST: f64 = 1.0 / 6_227_020_800.0;
    y * (1.0 / 6.0
        - y * (1.0 / 120.0 - y * (1.0 / 5_040.0 - y * (1.0 / 362_880.0 - y * (1.0 / 39_916_800.0 - y * LAST)))))
}

/// At least sinh t, for 0 ≤ t ≤ 1.2.
#[inline]
fn sinh_above(t: f64) -> f64 {
    t + t * t * t * (1.0 / 6.0 + t * t / 115.0)
}

/// A stretch of lags, at most one period.
#[derive(Clone, Copy, Debug)]
pub(super) struct Panel {
    pub(super) centre: f64,
    pub(super) half: f64,
}

impl Panel {
    /// Adds `sum` over the panel for each chord with a bound on its error, over its halves for the others. Chords share nodes.
    pub(super) fn each(
        &self,
        chords: &[Chord],
        order: &mut [usize],
        error: &impl Fn(&Chord, &Self) -> Option<f64>,
        sum: &impl Fn(&Chord, &Nodes) -> f64,
        sums: &mut [Bounded],
    ) {
        let (mut nodes, mut left) = (None, 0);
        for at in 0..order.len() {
            let which = order[at];
            if let Some(bound) = error(&chords[which], self) {
                let value = sum(&chords[which], nodes.get_or_insert_with(|| Nodes::new(self)));
                sums[which] += Bounded { value, bound: bound + 4.0 * f64::EPSILON * value.abs() };
            } else {
                order.swap(left, at);
                left += 1;
            }
        }
        if left > 0 {
            let half = 0.5 * self.half;
            for centre in [self.centre - half, self.centre + half] {
                Self { centre, half }.each(chords, &mut order[..left], error, sum, sums);
            }
        }
    }
}

/// The nodes of a panel: lags u, with sin(u/2) and cos(u/2).
pub(super) struct Nodes {
    half: f64,
    lag: [f64; 24],
    sin: [f64; 24],
    cos: [f64; 24],
}

impl Nodes {
    fn new(panel: &Panel) -> Self {
        let (sin, cos) = libm::sincos(0.5 * panel.centre);
        let mut nodes = Self { half: panel.half, lag: [0.0; 24], sin: [0.0; 24], cos: [0.0; 24] };
        for (i, (x, _)) in RULE.into_iter().enumerate() {
            let (step_sin, step_cos) = quadrant::sincos(0.5 * panel.half * x);
            (nodes.lag[i], nodes.lag[i + 12]) = (panel.centre - panel.half * x, panel.centre + panel.half * x);
            (nodes.sin[i], nodes.sin[i + 12]) = (sin * step_cos - cos * step_sin, sin * step_cos + cos * step_sin);
            (nodes.cos[i], nodes.cos[i + 12]) = (cos * step_cos + sin * step_sin, cos * step_cos - sin * step_sin);
        }
        nodes
    }

    /// Gauss's rule for f(u, s). Values stand in an array first, so that square roots and divisions go side by side.
    #[inline(always)]
    pub(super) fn sum(&self, chord: &Chord, mut f: impl FnMut(f64, f64) -> f64) -> f64 {
        let mut values = [0.0; 24];
        for (((value, u), sin), cos) in values.iter_mut().zip(self.lag).zip(self.sin).zip(self.cos) {
            *value = f(u, 2.0 * (sin * chord.half_cos - cos * chord.half_sin));
        }
        self.half * RULE.iter().enumerate().map(|(i, (_, weight))| weight * (values[i] + values[i + 12])).sum::<f64>()
    }
}
