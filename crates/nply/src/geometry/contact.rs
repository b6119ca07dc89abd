//! Contact between neighbouring strands, (4)–(7), by Kepler's equation.

use core::f64::consts::PI;

use super::HelicalAngle;
use crate::DomainError;
use crate::numerics::dual::Dual;
use crate::numerics::jet::Jet;
use crate::numerics::kepler::{HalfAnomaly, main_branch};

#[doc = include_str!("../equations/kepler.md")]
///
/// The main branch: the one without self-penetration. Every angle in [0, π/2) has exactly one such contact for each
/// n ≥ 2, and everything about it is explicit in the half anomaly E/2 that is kept here. Lengths are in units of r.
///
/// Accuracy: every quantity to 8 units in the last place (1e-15) over the whole range, both ends and the pitchfork of
/// n = 2 at π/4 included; [`radius_ratio_slope`](Self::radius_ratio_slope) and
/// [`shift_ratio_squared_slope`](Self::shift_ratio_squared_slope) to 16.
///
/// ```
/// use nply::geometry::Contact;
/// let rope = Contact::new(6, 20_f64.to_radians())?;
/// assert!((rope.radius_ratio() - 2.0998).abs() < 5e-5); // the paper's Figure 11
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    strands: u32,
    angle: HelicalAngle,
    half: HalfAnomaly,
    /// c² + s² cos²(E/2) = 1 − s² sin²(E/2)
    gap: f64,
}

/// The least number of strands that can touch a neighbour.
#[inline]
pub(crate) fn check_strands(strands: u32) -> Result<(), DomainError> {
    DomainError::check(strands >= 2, "strands", f64::from(strands), "a whole number of at least 2")
}

impl Contact {
    /// From the number of strands n ≥ 2 and the helical angle θ in rad, 0 ≤ θ < π/2.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` or `helical_angle`.
    #[inline(always)]
    pub fn new(strands: u32, helical_angle: f64) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Ok(Self::at(strands, HelicalAngle::new(helical_angle)?))
    }

    /// From the number of strands n ≥ 2 and a helical angle.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    #[inline]
    pub fn at_angle(strands: u32, angle: HelicalAngle) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Ok(Self::at(strands, angle))
    }

    /// Two strands in line contact at any angle: the trivial branch of Figure 1 (x = 0, ρ = 1).
    ///
    /// Up to π/4 it is the main branch; above it the strands penetrate each other, and it is of interest as the continuation
    /// that Figure 6 shows.
    ///
    /// ```
    /// use nply::geometry::{Contact, HelicalAngle};
    /// let steep = HelicalAngle::new(0.6)?;
    /// assert_eq!(Contact::line(steep), Contact::at_angle(2, steep)?);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn line(angle: HelicalAngle) -> Self {
        Self { strands: 2, angle, half: HalfAnomaly::LINE, gap: angle.cos() * angle.cos() }
    }

    /// As [`at_angle`](Self::at_angle), for strands known to be at least two.
    #[inline(always)] // the angle and the contact stay in registers
    pub(crate) fn at(strands: u32, angle: HelicalAngle) -> Self {
        let (s, c) = (angle.sin(), angle.cos());
        let cos_double = if strands == 2 { angle.cos_double() } else { 0.0 };
        let half = main_branch(strands, angle.pitch_angle(), s, c, cos_double);
        Self { strands, angle, half, gap: c * c + s * s * half.cos * half.cos }
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// θ with its complement.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.angle
    }

    /// θ in rad.
    #[must_use]
    pub const fn helical_angle(&self) -> f64 {
        self.angle.radians()
    }

    /// π/2 − θ in rad.
    #[must_use]
    pub const fn pitch_angle(&self) -> f64 {
        self.angle.pitch_angle()
    }

    /// E = λ − x sin θ = −β of (66), in (0, 2π/n]: the angle about the ply's axis between two touching sections.
    #[must_use]
    pub fn anomaly(&self) -> f64 {
        2.0 * libm::atan2(self.half.sin, self.half.cos)
    }

    /// sin E.
    fn sin_anomaly(&self) -> f64 {
        2.0 * self.half.sin * self.half.cos
    }

    #[doc = include_str!("../equations/eq06.md")]
    ///
    /// x ≥ 0, dimensionless (divided by R, times ε).
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let three = Contact::new(3, 60_f64.to_radians())?;
    /// // (5): x cos²θ + sin θ sin(x sin θ − 2π/n) = 0
    /// let (x, s) = (three.arclength_shift(), three.angle().sin());
    /// assert!((x * 0.25 + s * (x * s - std::f64::consts::TAU / 3.0).sin()).abs() < 1e-15);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn arclength_shift(&self) -> f64 {
        let (s, c) = (self.angle.sin(), self.angle.cos());
        s * self.sin_anomaly() / (c * c)
    }

    #[doc = include_str!("../equations/eq04.md")]
    ///
    /// ρ = R/r: 1/sin(π/n) for straight strands (7), growing with θ, without bound as θ → π/2.
    #[inline(always)]
    #[must_use]
    pub fn radius_ratio(&self) -> f64 {
        // above 1 by nature; just past the pitchfork rounding alone could take it below
        (self.angle.cos() / (self.half.sin * libm::sqrt(self.gap))).max(1.0)
    }

    #[doc = include_str!("../equations/eq65.md")]
    ///
    /// dρ/dθ ≥ 0 per rad, along the branch.
    #[must_use]
    pub fn radius_ratio_slope(&self) -> f64 {
        let (s, c) = (self.angle.sin(), self.angle.cos());
        self.radius_ratio() * s * self.half.cos * self.half.cos / (c * self.gap)
    }

    #[doc = include_str!("../equations/shift_ratio.md")]
    ///
    /// q ≥ 0.
    #[must_use]
    pub fn shift_ratio_squared(&self) -> f64 {
        let (s, c, ch) = (self.angle.sin(), self.angle.cos(), self.half.cos);
        s * s * ch * ch / (c * c * self.gap)
    }

    /// q/sin θ, which vanishes with θ.
    pub(crate) fn shift_ratio_squared_over_sin(&self) -> f64 {
        let (s, c, ch) = (self.angle.sin(), self.angle.cos(), self.half.cos);
        s * ch * ch / (c * c * self.gap)
    }

    /// dq/dθ per rad, along the branch. For n = 2 at θ = π/4 exactly it is that of line contact, 0.
    #[must_use]
    pub fn shift_ratio_squared_slope(&self) -> f64 {
        let (s, c, ch) = (self.angle.sin(), self.angle.cos(), self.half.cos);
        // q = s² cos²(E/2)/(c² gap), each factor's slope in turn
        let cos_squared_slope = self.cos_squared_slope();
        let gap_slope = s * s * cos_squared_slope - 2.0 * s * c * self.half.sin * self.half.sin;
        (2.0 * s * ch * ch / c + s * s * (cos_squared_slope - ch * ch * gap_slope / self.gap)) / (c * c * self.gap)
    }

    /// d cos²(E/2)/dθ.
    fn cos_squared_slope(&self) -> f64 {
        4.0 * self.angle.tan() * self.half.sin * self.half.sin * self.half.share_of_slope()
    }

    /// Curvature of the centreline r κ = sin²θ/ρ, dimensionless; at most 1 where the tube does not fold on itself.
    ///
    /// ```
    /// use nply::geometry::Contact;
    /// let two = Contact::new(2, 30_f64.to_radians())?;
    /// assert!((two.curvature() - 0.25).abs() < 1e-16); // line contact, ρ = 1
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn curvature(&self) -> f64 {
        self.angle.sin() * self.angle.sin() / self.radius_ratio()
    }

    /// Torsion of the right-handed centreline r τ = sin θ cos θ/ρ, dimensionless, the second term of (44).
    #[must_use]
    pub fn torsion(&self) -> f64 {
        self.angle.sin() * self.angle.cos() / self.radius_ratio()
    }

    /// Radius of the helix along which neighbours touch, (13), in units of r: ρ |cos(β/2)|; 0 in line contact.
    #[must_use]
    pub fn contact_line_radius(&self) -> f64 {
        self.half.cos * self.radius_ratio()
    }

    /// Radius of the empty hole along the ply's axis in units of r: ρ − 1; 0 in line contact.
    ///
    /// For n = 2 just above π/4, where ρ → 1, it keeps its digits.
    #[must_use]
    pub fn hole_radius(&self) -> f64 {
        if self.strands > 2 || self.angle.cos() < 0.5 {
            return self.radius_ratio() - 1.0;
        }
        // 1/ρ² = 1 − h, h = (S/c²)(s² S + cos 2θ), S = cos²(E/2); S and −cos 2θ vanish as 3 : 2 (z²/4 and z²/6)
        let (s, c) = (self.angle.sin(), self.angle.cos());
        let big_s = self.half.cos * self.half.cos;
        let h = big_s / (c * c) * (s * s * big_s + self.angle.cos_double());
        let root = libm::sqrt(1.0 - h);
        h / (root * (1.0 + root))
    }

    /// Ply length per turn of a strand, in units of r: 2πρ/tan θ. Infinite for straight strands.
    ///
    /// It falls from infinity to 2n (n flat rings on top of each other) as θ goes from 0 to π/2.
    #[must_use]
    pub fn lay_length(&self) -> f64 {
        let (s, c) = (self.angle.sin(), self.angle.cos());
        2.0 * PI * c * c / (s * self.half.sin * libm::sqrt(self.gap))
    }

    /// Lay length over the ply's outer diameter 2(R + r). Infinite for straight strands.
    #[must_use]
    pub fn lay_ratio(&self) -> f64 {
        0.5 * self.lay_length() / self.outer_radius()
    }

    /// Radius of the cylinder that encloses the ply, in units of r: ρ + 1.
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        self.radius_ratio() + 1.0
    }

    /// 1 − cos β = 2 sin²(E/2), by which neighbours' contact forces add up to a radial one, (30).
    #[must_use]
    pub(crate) fn one_minus_cos_beta(&self) -> f64 {
        2.0 * self.half.sin * self.half.sin
    }

    /// The branch in functions that stay finite, with their slopes dθ, over the whole range.
    #[inline]
    pub(crate) fn regular(&self) -> Regular {
        let (s, c) = (self.angle.sin(), self.angle.cos());
        let (sh, ch, gap) = (self.half.sin, self.half.cos, self.gap);
        // n flat rings at c = 0 exactly: ρ cos θ = n/π, the limit
        let radius = if c > 0.0 { c * c / (sh * libm::sqrt(gap)) } else { f64::from(self.strands) / PI };
        let share = ch * ch / gap;
        let turn = 2.0 * s * c * sh * sh / gap;
        Regular {
            sin: Dual::new(s, c),
            cos: Dual::new(c, -s),
            radius: Dual::new(radius, -0.5 * turn * radius),
            share: Dual::new(share, turn * (2.0 * self.half.share_of_slope() / gap + share)),
        }
    }

    /// ρ₀² = 1/sin²(π/n) of straight strands, (7).
    #[inline]
    pub(crate) fn straight_radius_ratio_squared(strands: u32) -> f64 {
        let sin = match strands {
            2 => 1.0,
            n => libm::sin(PI / f64::from(n)),
        };
        1.0 / (sin * sin)
    }

    /// (ρ² cos²θ/ρ₀² − 1)/sin²θ up to θ = π/12, where κ = 2π/n − E = tan²θ sin E is small:
    ///
    /// 1/ρ² = sin²(E/2) + (κ/4) sin E, so that 1/ρ₀² − 1/ρ² = sin(E + κ/2) sin(κ/2) − (κ/4) sin E, of which κ/2 is a factor.
    pub(crate) fn spread(&self) -> Dual {
        let Regular { sin: s, cos: c, radius, .. } = self.regular();
        let (sine, cosine) = (self.sin_anomaly(), (self.half.cos - self.half.sin) * (self.half.cos + self.half.sin));
        // dE/dθ = −2 tan θ sin E/(cos²θ + sin²θ cos E)
        let along = -2.0 * self.angle.tan() * sine / (c.value * c.value + s.value * s.value * cosine);
        let (sine, cosine) = (Dual::new(sine, cosine * along), Dual::new(cosine, -sine * along));
        let secant = c.recip();
        let half = 0.5 * (s * s * secant * secant * sine); // κ/2 < 0.04
        let y = half * half;
        let nested =
            |d: [f64; 3]| d.iter().fold(Dual::new(1.0, 0.0), |sum, d| Dual::new(1.0, 0.0) - (1.0 / d) * (y * sum));
        let (sinc, cos) = (nested([42.0, 20.0, 6.0]), nested([30.0, 12.0, 2.0]));
        let mean = (sine * cos + cosine * half * sinc) * sinc; // sin between E and 2π/n
        let ratio = radius * radius * secant * secant; // ρ²
        0.5 * (ratio * sine * (mean - 0.5 * sine)) - Dual::new(1.0, 0.0)
    }

    /// As [`regular`](Self::regular), with second derivatives. Those of two strands jump at π/4 and keep some six digits
    /// within 1e-6 above it.
    pub(crate) fn curved(&self) -> Curved {
        let (s, c) = (self.angle.sin(), self.angle.cos());
        let Regular { radius, share, .. } = self.regular();
        let (sh, gap) = (self.half.sin, self.gap);
        let ss_h = sh * sh; // sin²(E/2), which vanishes as cos⁴θ
        let w = self.half.share_of_slope();
        let cos_squared_slope = if c > 0.0 { 4.0 * s / c * ss_h * w } else { 0.0 };
        let gap_slope = s * s * cos_squared_slope - 2.0 * s * c * ss_h;
        let w_slope = self.half.share_slope(cos_squared_slope, 2.0 * s * s * cos_squared_slope - 4.0 * s * c * ss_h);
        let turn = 2.0 * s * c * ss_h / gap;
        let turn_slope = 2.0 * ((c * c - s * s) * ss_h - s * c * (cos_squared_slope + ss_h * gap_slope / gap)) / gap;
        let inner = 2.0 * w / gap + share.value;
        let inner_slope = 2.0 * (w_slope - w * gap_slope / gap) / gap + share.slope;
        Curved {
            sin: Jet::new(s, c, -s),
            cos: Jet::new(c, -s, -c),
            radius: Jet::new(radius.value, radius.slope, -0.5 * (turn_slope * radius.value + turn * radius.slope)),
            share: Jet::new(share.value, share.slope, turn_slope * inner + turn * inner_slope),
        }
    }
}

/// As [`Regular`], with second derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curved {
    pub(crate) sin: Jet,
    pub(crate) cos: Jet,
    pub(crate) radius: Jet,
    pub(crate) share: Jet,
}

impl Curved {
    /// sin θ/ρ, the ply's rotation per strand length, of touching strands.
    pub(crate) fn rotation(&self) -> Jet {
        self.sin * self.cos * self.radius.recip()
    }
}

/// sin θ, cos θ and, finite at θ = π/2 where ρ and q are not, ρ cos θ and q cot²θ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Regular {
    pub(crate) sin: Dual,
    pub(crate) cos: Dual,
    /// ρ cos θ: from 1/sin(π/n) to n/π
    pub(crate) radius: Dual,
    /// q cot²θ: from cos²(π/n) to 1
    pub(crate) share: Dual,
}

#[cfg(test)]
mod tests {
    use super::{Contact, Curved, HelicalAngle};

    /// Second derivatives against differences of the first.
    #[test]
    fn bends_are_slopes_of_slopes() {
        for strands in [2, 3, 7, 30] {
            for theta in [1e-3, 0.2, 0.7, 0.785, 0.786, 0.8, 1.0, 1.4, 1.569] {
                let at = |t| Contact::at(strands, HelicalAngle::steep(t)).curved();
                let h = 1e-5;
                let (here, before, after) = (at(theta), at(theta - h), at(theta + h));
                for part in [|c: &Curved| c.radius, |c: &Curved| c.share, Curved::rotation] {
                    let slope = (part(&after).slope - part(&before).slope) / (2.0 * h);
                    let bend = part(&here).bend;
                    assert!((bend - slope).abs() < 2e-6 * (1.0 + bend.abs()), "n {strands} at {theta}: {bend} {slope}");
                }
            }
        }
    }
}
