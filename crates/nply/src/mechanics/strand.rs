//! Force and moment inside a strand, (22)–(36).

use super::{Balance, Equilibrium};

/// Internal force (units B/r²) and moment (B/r) of a strand in the cylindrical frame (e_r, e_ψ, e_z) of (17). Their radial
/// components vanish, (26).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrandResultant {
    /// F_ψ, (36), around the ply.
    pub hoop_force: f64,
    /// F_z, (34), along the ply.
    pub axial_force: f64,
    /// M_ψ by (23).
    pub hoop_moment: f64,
    /// M_z by (23).
    pub axial_moment: f64,
}

impl Equilibrium {
    #[doc = include_str!("../equations/eq34_36.md")]
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let rope = Ply::new(3, 0.75)?;
    /// let state = rope.equilibria(Twist::Pretwist(-1.0), Load { force: 0.2, moment: 0.1 })?[0];
    /// let (inside, contact) = (state.strand_resultant(), state.contact());
    /// // (31): p = ε F_ψ sin θ/ρ
    /// let p = state.handedness().sign() * inside.hoop_force * contact.angle().sin() / contact.radius_ratio();
    /// assert!((p - state.resultant_pressure()).abs() < 1e-14);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn strand_resultant(&self) -> StrandResultant {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let (eps, gamma, u3) = (self.handedness.sign(), self.stiffness_ratio, self.strand_twist());
        // contact forces that cross a section of the ply: p₁ x²ρ²/2 = 2 q p₁ along cos θ and −ε cos²θ/sin θ
        let crossing = match self.balance {
            Balance::Radial => 0.0,
            Balance::Contact => 2.0 * self.interstrand_pressure(),
        };
        let q_over_s = self.contact.shift_ratio_squared_over_sin();
        StrandResultant {
            hoop_force: self.load.moment / (n * rho)
                - eps * s * s * s / (rho * rho)
                - gamma * u3 / rho * c
                - eps * crossing * q_over_s * c * c,
            axial_force: self.load.force / n + crossing * q_over_s * s * c,
            hoop_moment: gamma * u3 * eps * s - s * s * c / rho,
            axial_moment: eps * s * s * s / rho + gamma * u3 * c,
        }
    }
}
