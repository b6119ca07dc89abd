//! Energy, (52)–(56).

use super::Equilibrium;

/// Energy per strand length of one strand, in units of B/r².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// ½ κ², (52).
    pub bending: f64,
    /// ½ γ (r u₃)², (53).
    pub torsion: f64,
    /// −p_e ρ, (54), with the external pressure alone: contact forces do no work.
    pub pressure: f64,
    /// −(f/n) cos θ − ε(m/nρ) sin θ, (55).
    pub load: f64,
}

impl Energy {
    /// The sum, (56) with λ = 0.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.bending + self.torsion + self.pressure + self.load
    }
}

impl Equilibrium {
    #[doc = include_str!("../equations/eq52_56.md")]
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let released = Ply::new(2, 1.0)?.equilibria(Twist::Pretwist(-0.5), Load::NONE)?[0];
    /// let before = 0.5 * 1.0 * 0.5 * 0.5; // torsion of the straight strands, ½γ(φ̄a)²
    /// assert!(released.energy().total() < before);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn energy(&self) -> Energy {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let (eps, gamma, u3) = (self.handedness.sign(), self.stiffness_ratio, self.strand_twist());
        let (f, m) = (self.load.force, self.load.moment);
        let kappa = self.contact.curvature();
        Energy {
            bending: 0.5 * kappa * kappa,
            torsion: 0.5 * gamma * u3 * u3,
            pressure: -self.external_pressure * rho,
            load: -f / n * c - eps * m / (n * rho) * s,
        }
    }
}
