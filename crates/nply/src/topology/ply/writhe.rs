//! Writhe of a uniform ply of any length: Tables I and II for every n.

use core::f64::consts::{PI, TAU};

use super::check_strands;
use super::chord::{Bounded, Chord};
use super::periods::{FIRST, WORTHWHILE};
use super::tail::Tail;
use crate::geometry::{Contact, HelicalAngle};
use crate::{DomainError, Handedness};

/// What one pair of strands, or a strand with itself, adds to the writhe double integral (A.4), in turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// The term that grows with length: (A.15), (A.23), (A.24) at this length.
    pub leading: f64,
    /// The rest, which stays bounded however long the ply.
    pub remainder: f64,
    /// Bound on the error of `remainder`.
    pub error_bound: f64,
    /// Both together; of a short ply with more digits than their sum.
    pub writhe: f64,
}

/// Writhe contributions of the strands of a uniform ply, in turns.
///
/// With u = Δψ and D the distance of two points over R (times sin θ) the kernels of (A.5) and (A.16) are slopes of C = u cos θ/D, the cosine of
/// the chord's angle to the axis, and the double integral over two strands of rotation Ψ = |ψ_L| is
///
/// ```text
/// ∫₀^Ψ∫₀^Ψ C′(ψ₁ − ψ₂) dψ₁ dψ₂ = ∫₋Ψ^Ψ (Ψ − |u|) C′(u) du = ∫₀^Ψ [C(u) − C(−u)] du
/// ```
///
/// so that no weight grows with the length. Up to four turns of lag this is summed by Gauss's rule on panels whose error is bounded by where D
/// vanishes in the complex plane; beyond, by the harmonics of 1 − C; whole periods of flat strands by Euler and Maclaurin.
///
/// Any length, any angle 0 ≤ θ < π/2, any n ≥ 1. Accuracy: `error_bound`, below 1e-11 turns up to θ = 89°; flatter strands
/// lose digits: a bound of tan θ times 1e-13.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::HelicalAngle;
/// use nply::topology::PlyWrithe;
/// let ply = PlyWrithe::new(2, HelicalAngle::new(20_f64.to_radians())?, Right, 3.0)?;
/// assert!((ply.itself().writhe - 0.1509278217).abs() < 1e-10);
/// assert!((ply.pair(1).writhe - 2.907609033).abs() < 1e-9);
/// assert!((ply.total().writhe - 2.0 * (0.1509278217 - 2.907609033)).abs() < 1e-9); // Table I, summed
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlyWrithe {
    strands: u32,
    angle: HelicalAngle,
    handedness: Handedness,
    turns: f64,
    /// of a strand with itself, and with those 1, 2, … ⌊n/2⌋ places on, run the same way
    contributions: Vec<Contribution>,
}

impl PlyWrithe {
    /// From the number of strands n ≥ 1, the helical angle, the hand and the turns |ψ_L|/2π of each strand round the axis.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` if it is 0 or above a million, and on `turns` unless it is at least 0 and at most 1e15, beyond which a double does not tell
    /// where in its turn the ply ends.
    pub fn new(strands: u32, angle: HelicalAngle, handedness: Handedness, turns: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        DomainError::check((0.0..=1e15).contains(&turns), "turns", turns, "at least 0 and at most 1e15")?;
        let contributions = Lag::new(angle, turns).contributions(strands, handedness.sign());
        Ok(Self { strands, angle, handedness, turns, contributions })
    }

    /// Of touching strands of a given length, in units of r.
    ///
    /// # Errors
    /// [`DomainError`] on `strand_length` unless it is finite and not negative, and on `turns` as above.
    pub fn of_ply(contact: &Contact, handedness: Handedness, strand_length: f64) -> Result<Self, DomainError> {
        let finite = (0.0..f64::INFINITY).contains(&strand_length);
        DomainError::check(finite, "strand_length", strand_length, "finite and at least 0")?;
        let turns = strand_length * contact.angle().sin() / contact.radius_ratio() / TAU;
        Self::new(contact.strands(), contact.angle(), handedness, turns)
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// θ.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.angle
    }

    /// ε.
    #[must_use]
    pub const fn handedness(&self) -> Handedness {
        self.handedness
    }

    /// |ψ_L|/2π.
    #[must_use]
    pub const fn turns(&self) -> f64 {
        self.turns
    }

    /// W_r^s: a strand with itself, both orders of its points.
    ///
    #[doc = include_str!("../../equations/eqA05.md")]
    ///
    #[doc = include_str!("../../equations/eqA06.md")]
    ///
    #[doc = include_str!("../../equations/eqA07.md")]
    ///
    #[doc = include_str!("../../equations/eqA08.md")]
    ///
    #[doc = include_str!("../../equations/eqA09.md")]
    ///
    #[doc = include_str!("../../equations/eqA10.md")]
    ///
    #[doc = include_str!("../../equations/eqA11.md")]
    ///
    #[doc = include_str!("../../equations/eqA12.md")]
    ///
    #[doc = include_str!("../../equations/eqA13.md")]
    ///
    #[doc = include_str!("../../equations/eqA14.md")]
    ///
    #[doc = include_str!("../../equations/eqA15.md")]
    #[must_use]
    pub fn itself(&self) -> Contribution {
        self.contributions[0]
    }

    /// W_r^{α+}, α = 2πi/n: a strand with the one `places` on, i taken modulo n, run the same way; 0 places is the strand itself.
    ///
    #[doc = include_str!("../../equations/eqA16.md")]
    ///
    #[doc = include_str!("../../equations/eqA17.md")]
    ///
    #[doc = include_str!("../../equations/eqA18.md")]
    ///
    #[doc = include_str!("../../equations/eqA19.md")]
    ///
    #[doc = include_str!("../../equations/eqA20.md")]
    ///
    #[doc = include_str!("../../equations/eqA21.md")]
    ///
    #[doc = include_str!("../../equations/eqA22.md")]
    ///
    #[doc = include_str!("../../equations/eqA23.md")]
    #[must_use]
    pub fn pair(&self, places: u32) -> Contribution {
        let places = places % self.strands;
        self.contributions[places.min(self.strands - places) as usize]
    }

    /// The entry of Tables I and II in a row and a column, counted from 0: strands run forwards and backwards by turns, as they do
    /// when one centreline goes through all of them. Rows and columns are taken modulo n.
    ///
    #[doc = include_str!("../../equations/eqA24.md")]
    #[must_use]
    pub fn entry(&self, row: u32, column: u32) -> Contribution {
        let (row, column) = (row % self.strands, column % self.strands);
        let sense = if row.abs_diff(column) % 2 == 0 { 1.0 } else { -1.0 };
        self.pair(row.abs_diff(column)).times(sense)
    }

    /// The sum of all n² entries: what (A.25)–(A.27) give in the limit of a long ply, and the rest.
    ///
    #[doc = include_str!("../../equations/eqA25.md")]
    ///
    #[doc = include_str!("../../equations/eqA26.md")]
    ///
    #[doc = include_str!("../../equations/eqA27.md")]
    #[must_use]
    pub fn total(&self) -> Contribution {
        let n = f64::from(self.strands);
        let sigma = f64::from(self.strands % 2);
        let own = self.itself();
        let mut total = own.times(n);
        for places in 1..self.strands {
            let sense = if places % 2 == 0 { 1.0 } else { -1.0 };
            let pair = self.pair(places).times(sense * 2.0 * f64::from(self.strands - places));
            total.remainder += pair.remainder;
            total.writhe += pair.writhe;
            total.error_bound += pair.error_bound;
        }
        total.leading = self.handedness.sign() * self.turns * (sigma - n * self.angle.cos());
        if self.turns > 4.0 {
            total.writhe = total.leading + total.remainder;
        }
        total
    }
}

impl Contribution {
    fn times(self, factor: f64) -> Self {
        Self {
            leading: factor * self.leading,
            remainder: factor * self.remainder,
            error_bound: libm::fabs(factor) * self.error_bound,
            writhe: factor * self.writhe,
        }
    }
}

/// The integrals over the lag for strands of one angle and length.
struct Lag {
    angle: HelicalAngle,
    turns: f64,
    /// panels go up to `near` and from `rest` to `summed`, rad; between them the periods from [`FIRST`] to `periods` are summed as such
    near: f64,
    periods: f64,
    rest: f64,
    summed: f64,
    /// the tails from `summed` and from Ψ = |ψ_L| on, where `summed` is not Ψ itself
    tails: Option<[Tail; 2]>,
}

impl Lag {
    fn new(angle: HelicalAngle, turns: f64) -> Self {
        let (tan, most) = (angle.tan(), TAU * turns);
        let least = Tail::least_lag(tan);
        // whole turns up to where the tail begins, four of them at least, or five if it falls slowly there
        let whole = libm::ceil(least / TAU).max(if least < 0.6 * 4.0 * TAU { 4.0 } else { 5.0 });
        let tails = (turns >= whole).then(|| [Tail::new(tan, TAU * whole), Tail::new(tan, most)]);
        let summed = if tails.is_some() { TAU * whole } else { most };
        let last = libm::floor(turns.min(whole));
        if last - FIRST < WORTHWHILE {
            return Self { angle, turns, near: summed, periods: FIRST, rest: summed, summed, tails };
        }
        Self { angle, turns, near: TAU * FIRST, periods: last, rest: TAU * last, summed, tails }
    }

    /// Of a strand with itself, and with those 1, 2, … ⌊n/2⌋ places on; `eps` is the hand.
    fn contributions(&self, strands: u32, eps: f64) -> Vec<Contribution> {
        // α = 0, then every other α with −α beside it
        let alphas: Vec<f64> = (1..=strands / 2).map(|i| TAU * f64::from(i) / f64::from(strands)).collect();
        let chords: Vec<Chord> = core::iter::once(0.0)
            .chain(alphas.iter().flat_map(|&alpha| [alpha, -alpha]))
            .take(strands as usize) // of α = π the other one is the same
            .map(|alpha| Chord::new(self.angle, alpha))
            .collect();
        let mut sums = vec![Bounded::default(); chords.len()];
        Chord::integrals(&chords, 0.0, self.near, &mut sums);
        Chord::periods(&chords, FIRST, self.periods, &mut sums);
        Chord::integrals(&chords, self.rest, self.summed, &mut sums);

        let cos = self.angle.cos();
        let rise = self.angle.sin() * self.angle.sin() / (1.0 + cos); // 1 − cos θ
        sums[0].value -= cos * TAU * (self.periods - FIRST); // periods take C for all, panels C − cos θ for α = 0
        let mut contributions = Vec::with_capacity(alphas.len() + 1);
        contributions.push(self.contribution(rise, [sums[0], sums[0]], 1.0).times(eps));
        for (pair, alpha) in sums[1..].chunks(2).zip(alphas) {
            let both = [pair[0], *pair.last().unwrap_or(&pair[0])];
            contributions.push(self.contribution(1.0, both, libm::cos(alpha)).times(eps));
        }
        contributions
    }

    /// From both signs' integrals; the leading term is `rate` times the turns.
    fn contribution(&self, rate: f64, [one, other]: [Bounded; 2], cos_alpha: f64) -> Contribution {
        let (share, sum) = (0.25 / PI, one.value + other.value);
        let mut rest = sum - 2.0 * rate * self.summed;
        let mut bound = one.bound + other.bound;
        if let Some([from, to]) = &self.tails {
            let (from, to) = (from.pair(cos_alpha), to.pair(cos_alpha));
            rest += to.value - from.value;
            bound += to.bound + from.bound;
        }
        let (leading, remainder) = (rate * self.turns, share * rest);
        Contribution {
            leading,
            remainder,
            error_bound: share * (bound + 4.0 * f64::EPSILON * sum.abs()),
            writhe: if self.tails.is_some() { leading + remainder } else { share * sum },
        }
    }
}
