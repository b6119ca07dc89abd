//! The two balances, by name; they are never mixed.

use core::ops::{Add, Mul, Neg, Sub};

use super::atlas::Condition;
use crate::geometry::Contact;
use crate::numerics::dual::Dual;
use crate::numerics::jet::Jet;

/// Which equation of equilibrium is used where strands touch at different heights (arclength shift x ≠ 0).
///
/// They are the same for the 2-ply with line contact (n = 2, θ ≤ π/4) and at p = 0.
///
/// ```
/// use nply::mechanics::Balance;
/// assert_eq!(Balance::default(), Balance::Contact);
/// assert_eq!(Balance::Radial.name(), "radial");
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Balance {
    #[doc = include_str!("../equations/contact_balance.md")]
    #[default]
    Contact,
    #[doc = include_str!("../equations/eq40.md")]
    ///
    /// The paper as published: exact for line contact and for strands carried by a core.
    Radial,
}

impl Balance {
    /// Both balances, the default first.
    pub const BOTH: [Self; 2] = [Self::Contact, Self::Radial];

    /// The name used in files, flags and JSON: `contact` or `radial`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Contact => "contact",
            Self::Radial => "radial",
        }
    }
}

impl Balance {
    /// The factor by which term `k` may vanish at an angle, and the sum of its parts' sizes: cos 2θ − q cos²θ for the
    /// pretwist, sin θ for the force, 1 − q for the moment (times cos²θ).
    pub(super) fn factor(self, contact: &Contact, k: usize) -> (f64, f64) {
        let (s, c) = (contact.angle().sin(), contact.angle().cos());
        let q_cc = match self {
            Self::Contact => s * s * contact.regular().share.value,
            Self::Radial => 0.0,
        };
        match k {
            2 => (c * c - s * s - q_cc, 1.0 + q_cc),
            3 => (s, s),
            4 => (c * c - q_cc, c * c + q_cc),
            _ => (1.0, 1.0),
        }
    }
}

impl Condition<5> for Balance {
    #[inline]
    fn terms(&self, contact: &Contact) -> [Dual; 5] {
        let at = contact.regular();
        self.terms_of(contact.strands(), [at.sin, at.cos, at.radius, at.share])
    }
}

impl Balance {
    /// As [`Condition::terms`], with second derivatives.
    pub(super) fn curved_terms(self, contact: &Contact) -> [Jet; 5] {
        let at = contact.curved();
        self.terms_of(contact.strands(), [at.sin, at.cos, at.radius, at.share])
    }

    /// cos²θ times the balance, term by term, for the weights (1, γ, εγφ̄a, f, εm) when the pretwist is given and
    /// (1, 0, εγ r u₃, f, εm) when the strand twist is.
    ///
    /// Radial, (40) with (45):  G = 2n sin³θ cos θ + γ n sin θ cos θ cos 2θ + εγφ̄a nρ cos 2θ + f ρ² sin θ − εm ρ cos θ.
    /// Contact adds nρ² p̂ ρ′(θ), which brings in q:  2 → 2 − q, cos 2θ → cos 2θ − q cos²θ, 1 → 1 − q in the moment's term.
    #[inline]
    fn terms_of<T>(self, strands: u32, [s, c, radius, share]: [T; 4]) -> [T; 5]
    where
        T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>,
        f64: Mul<T, Output = T>,
    {
        let n = f64::from(strands);
        let (ss, cc) = (s * s, c * c);
        let q_cc = match self {
            Self::Contact => ss * share,
            Self::Radial => 0.0 * ss,
        };
        let cos2 = cc - ss - q_cc;
        let sc = s * c;
        [
            n * (sc * ss * (2.0 * cc - q_cc)),
            n * (sc * cc * cos2),
            n * (radius * c * cos2),
            radius * radius * s,
            -(radius * (cc - q_cc)),
        ]
    }
}

/// The contact balance under an external radial pressure p_e, cos⁴θ times, with the weight p_e last.
///
/// d[E − p_e ρ(θ)]/dθ = 0 takes nρ² p_e ρ′(θ) from the contact balance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pressurised;

impl Condition<6> for Pressurised {
    fn terms(&self, contact: &Contact) -> [Dual; 6] {
        let at = contact.regular();
        let n = f64::from(contact.strands());
        let cc = at.cos * at.cos;
        let [bending, twisting, pretwist, force, moment] = Balance::Contact.terms(contact);
        let pressure = -(n * (at.radius * at.radius * at.radius * at.sin * at.share));
        [cc * bending, cc * twisting, cc * pretwist, cc * force, cc * moment, pressure]
    }
}
