//! The locus p = 0 in the plane of force and moment, Figures 9 and 10, as a curve.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{Load, Ply, Twist};
use crate::geometry::HelicalAngle;
use crate::numerics::quadrant::{octant, sincos};
use crate::numerics::wide::{Job, Wide, dispatch_alike};
use crate::{DomainError, Handedness};

/// The loads at which touching strands just stop pressing on each other, from straight strands to flat rings, for both hands.
///
/// Everything on it is explicit in the anomaly E between touching sections (Kepler's equation gives tan²θ = (λ − E)/sin E, λ = 2π/n),
/// so that nothing is solved for.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::mechanics::{Ply, Twist};
/// let ply = Ply::new(3, 0.75)?;
/// let locus = ply.separation_locus(Twist::Pretwist(-0.2), 100)?;
/// let (angle, load) = locus.point(Right, 50);
/// let exact = ply.separation_at(angle, Right, Twist::Pretwist(-0.2))?.load();
/// assert!((load.force - exact.force).abs() < 1e-14 && (load.moment - exact.moment).abs() < 1e-14);
/// assert!((locus.point(Right, 0).1.moment + 0.45).abs() < 1e-15); // the square of Figure 10: m = nγφ̄a
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Locus {
    sin_squared: Vec<f64>,
    cos_squared: Vec<f64>,
    /// f and m of the right hand, then of the left
    forces: [Vec<f64>; 2],
    moments: [Vec<f64>; 2],
}

impl Ply {
    /// The locus at `points` angles, θ = 0 and θ = π/2 included, spaced more or less evenly; each for both hands.
    ///
    /// # Errors
    /// [`DomainError`] unless the twist is finite, `points` is at least 2 and at most ten million, and no external pressure acts.
    pub fn separation_locus(&self, twist: Twist, points: usize) -> Result<Locus, DomainError> {
        self.check(twist, Load::NONE)?;
        self.check_unpressed()?;
        let allowed = "at least 2 and at most 10 million";
        DomainError::check((2..=10_000_000).contains(&points), "points", points as f64, allowed)?;
        let (love, held) = twist.weights(self.stiffness_ratio());
        let n = f64::from(self.strands());
        let size = n * (1.0 + love.abs() + held.abs());
        let allowed = "small enough for the loads of n strands to be numbers, stiffness ratio included";
        DomainError::check(size < 1e300, "twist", held, allowed)?;
        // two strands lie in line contact up to π/4, the first half
        let line = if self.strands() == 2 { points / 2 } else { 0 };
        let (rest, past) = (points - line, usize::from(line > 0));
        let step = 1.0 / (rest - 1 + past) as f64;
        let empty = || vec![0.0; points.next_multiple_of(WIDTH)];
        let mut locus = Locus {
            sin_squared: empty(),
            cos_squared: empty(),
            forces: [empty(), empty()],
            moments: [empty(), empty()],
        };
        // as wide registers as the processor has, but the same products and sums, and so the same bits
        dispatch_alike(Drawing { curve: Curve { n, love, held, line, past, step }, locus: &mut locus });
        let Locus { sin_squared, cos_squared, forces, moments } = &mut locus;
        for array in [sin_squared, cos_squared].into_iter().chain(forces).chain(moments) {
            array.truncate(points);
        }
        Ok(locus)
    }
}

/// What the curve is worked out from.
#[derive(Clone, Copy)]
struct Curve {
    n: f64,
    love: f64,
    held: f64,
    /// points in line contact
    line: usize,
    past: usize,
    step: f64,
}

/// A curve to be drawn into its arrays.
struct Drawing<'a> {
    curve: Curve,
    locus: &'a mut Locus,
}

impl Job for Drawing<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self, _: W) {
        self.curve.fill(self.locus);
    }
}

impl Curve {
    #[inline(always)]
    fn fill(self, locus: &mut Locus) {
        let Self { n, love, held, line, past, step } = self;
        let Locus { sin_squared, cos_squared, forces: [right_f, left_f], moments: [right_m, left_m] } = locus;
        let places = sin_squared.chunks_exact_mut(WIDTH).zip(cos_squared.chunks_exact_mut(WIDTH));
        let pairs = right_f.chunks_exact_mut(WIDTH).zip(left_f.chunks_exact_mut(WIDTH));
        let pairs = pairs.zip(right_m.chunks_exact_mut(WIDTH).zip(left_m.chunks_exact_mut(WIDTH)));
        for (block, ((sin, cos), ((rf, lf), (rm, lm)))) in places.zip(pairs).enumerate() {
            // from the corner on, and from the beginning where there is none
            let origin = (block * WIDTH) as f64 - line as f64 + past as f64;
            let [ss, cc, y]: [Lanes; 3] = if line == 0 {
                bent(TAU / n, PLACES.map(|k| ((origin + k) * step).min(1.0)))
            } else {
                let turn = |i: f64| match i * step {
                    share if share > 0.0 => past_corner(share.min(1.0)),
                    _ => in_line((i + line as f64 - past as f64) / line as f64),
                };
                let turns = PLACES.map(|k| turn(origin + k));
                [0, 1, 2].map(|part| turns.map(|turn| turn[part]))
            };
            sin.copy_from_slice(&ss);
            cos.copy_from_slice(&cc);
            // (48) and (37): f = n((love − 1)y²c + εh y), m = n(hc + εy(s² + love c²))
            for k in 0..WIDTH {
                let c = cc[k].sqrt();
                let (even_f, odd_f) = (n * (love - 1.0) * y[k] * y[k] * c, n * held * y[k]);
                let (even_m, odd_m) = (n * held * c, n * y[k] * (ss[k] + love * cc[k]));
                (rf[k], lf[k]) = (even_f + odd_f, even_f - odd_f);
                (rm[k], lm[k]) = (even_m + odd_m, even_m - odd_m);
            }
        }
    }
}

/// Points worked out together, so that a processor can take several at a time.
const WIDTH: usize = 8;
type Lanes = [f64; WIDTH];
const PLACES: Lanes = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// sin²θ, cos²θ and sin θ/ρ of two strands in line contact, from tan θ.
#[inline(always)]
fn in_line(tan: f64) -> [f64; 3] {
    let cc = 1.0 / (1.0 + tan * tan);
    let ss = tan * tan * cc;
    [ss, cc, ss.sqrt()]
}

/// The same past the corner of two strands.
fn past_corner(share: f64) -> [f64; 3] {
    let (shift, half) = anomaly(PI, share);
    branch(shift, sincos(half.min(FRAC_PI_2)))
}

/// The same of three and more strands, several at a time and without a branch.
#[inline(always)]
fn bent(lambda: f64, share: Lanes) -> [Lanes; 3] {
    let mut out = [[0.0; WIDTH]; 3];
    for k in 0..WIDTH {
        let (shift, half) = anomaly(lambda, share[k]);
        let (s, c) = octant(0.5 * half);
        let [ss, cc, y] = branch(shift, (2.0 * s * c, (c - s) * (c + s)));
        (out[0][k], out[1][k], out[2][k]) = (ss, cc, y);
    }
    out
}

/// λ − E and E/2 at a share of the way from straight strands to flat rings: they vanish as the squares of θ and of its complement.
#[inline(always)]
fn anomaly(lambda: f64, share: f64) -> (f64, f64) {
    let rest = 1.0 - share;
    (lambda * share * share * (3.0 - 2.0 * share), 0.5 * lambda * rest * rest * (1.0 + 2.0 * share))
}

/// sin²θ, cos²θ and sin θ/ρ from λ − E and the sine and cosine of E/2.
#[inline(always)]
fn branch(shift: f64, (sh, ch): (f64, f64)) -> [f64; 3] {
    let sin_e = 2.0 * sh * ch;
    let sum = sin_e + shift;
    let inverse = 1.0 / (sum * ch); // one division for both
    let (ss, cc) = (shift * ch * inverse, sin_e * ch * inverse);
    // y² = sin²θ/ρ² = sin²θ sin²(E/2)(1 + tan²θ cos²(E/2)), with cos²θ = sin E/(sin E + λ − E)
    [ss, cc, (0.5 * ss * sh * sum * (sum * inverse) * (cc + ss * ch * ch)).sqrt()]
}

impl Locus {
    /// How many angles.
    #[must_use]
    pub fn len(&self) -> usize {
        self.sin_squared.len()
    }

    /// Whether there is none; there are two at least.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.sin_squared.is_empty()
    }

    /// f along the locus of a hand.
    #[must_use]
    pub fn forces(&self, handedness: Handedness) -> &[f64] {
        &self.forces[side(handedness)]
    }

    /// m along the locus of a hand.
    #[must_use]
    pub fn moments(&self, handedness: Handedness) -> &[f64] {
        &self.moments[side(handedness)]
    }

    /// Angle and loads of point `i`, of which there are [`len`](Self::len); the last, flat rings, has the least pitch angle a number
    /// can have.
    ///
    /// # Panics
    /// Where there is no such point, as with any index.
    #[must_use]
    pub fn point(&self, handedness: Handedness, i: usize) -> (HelicalAngle, Load) {
        let (s, c) = (libm::sqrt(self.sin_squared[i]), libm::sqrt(self.cos_squared[i]));
        let angle = if s < c {
            HelicalAngle::steep(libm::atan2(s, c))
        } else {
            HelicalAngle::flat(libm::atan2(c, s).max(HelicalAngle::FLATTEST))
        };
        (angle, Load { force: self.forces(handedness)[i], moment: self.moments(handedness)[i] })
    }
}

const fn side(handedness: Handedness) -> usize {
    match handedness {
        Handedness::Right => 0,
        Handedness::Left => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the width of the registers, the bits are the same.
    #[test]
    fn wide_registers_give_the_same_bits() {
        for strands in [2, 3, 40] {
            let ply = Ply::new(strands, 0.8).expect("a ply");
            let drawn = ply.separation_locus(Twist::Pretwist(0.3), 64).expect("a locus");
            let line = if strands == 2 { 32 } else { 0 };
            let past = usize::from(line > 0);
            let step = 1.0 / (64 - line - 1 + past) as f64;
            let mut plain = drawn.clone();
            plain.forces = [vec![0.0; 64], vec![0.0; 64]];
            Curve { n: f64::from(strands), love: 0.8, held: 0.8 * 0.3, line, past, step }.fill(&mut plain);
            assert_eq!(plain, drawn);
        }
    }
}
