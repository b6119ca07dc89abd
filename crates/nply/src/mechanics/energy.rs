//! Energy, (52)–(56).

use super::{Equilibrium, Load};

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
    /// Of a strand with r κ and r u₃ that carries its share of the loads through the displacements a·d_f and a·d_m.
    pub(super) fn of_strand(curvature: f64, gamma: f64, u3: f64, share: Load, displacements: (f64, f64)) -> Self {
        let (extension, rotation) = displacements;
        Self {
            bending: 0.5 * curvature * curvature,
            torsion: 0.5 * gamma * u3 * u3,
            pressure: 0.0,
            load: -share.force * extension - share.moment * rotation,
        }
    }

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
        let n = f64::from(self.contact.strands());
        let share = Load { force: self.load.force / n, moment: self.load.moment / n };
        let displacements = (self.extension(), self.rotation());
        let (kappa, gamma, u3) = (self.contact.curvature(), self.stiffness_ratio, self.strand_twist());
        let pressure = -self.external_pressure * self.contact.radius_ratio();
        Energy { pressure, ..Energy::of_strand(kappa, gamma, u3, share, displacements) }
    }
}
