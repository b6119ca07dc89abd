//! What presses on a strand, (30), (37), (38), (41), (43), (48).

use super::{Balance, Equilibrium};

impl Equilibrium {
    #[doc = include_str!("../equations/eq37.md")]
    ///
    /// p̂ r³/B: the resultant pressure were the whole load between strands radial.
    /// Exactly 0 where its terms cancel to rounding, as on the verge of separation.
    #[must_use]
    pub fn radial_pressure(&self) -> f64 {
        self.pressure_beyond(0.0)
    }

    /// p̂ less a given pressure, 0 where no digit of the difference is left.
    fn pressure_beyond(&self, given: f64) -> f64 {
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let n = f64::from(self.contact.strands());
        let (eps, gamma, u3) = (self.handedness.sign(), self.stiffness_ratio, self.strand_twist());
        let m = self.load.moment;
        let scale = s / (rho * rho);
        let (moment, twist, bending) = (scale * (m / n), scale * (gamma * u3 * c), scale * (s * s * s / rho));
        let pressure = eps * (moment - twist) - bending - given;
        let size = moment.abs() + twist.abs() + bending + given.abs();
        if pressure.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { pressure }
    }

    #[doc = include_str!("../equations/eq30.md")]
    ///
    /// p r³/B, outward positive, all pressure on the strand together: negative where touching strands would have to
    /// pull on each other.
    #[must_use]
    pub fn resultant_pressure(&self) -> f64 {
        match self.balance {
            Balance::Radial => self.radial_pressure(),
            Balance::Contact => {
                let rho = self.contact.radius_ratio();
                self.external_pressure + rho * self.interstrand_pressure() * self.contact.one_minus_cos_beta()
            }
        }
    }

    #[doc = include_str!("../equations/eq38.md")]
    ///
    /// p₁ r³/B: the force per length with which each of the two neighbours presses, negative where they would have to
    /// pull.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let yarn = Ply::new(2, 0.75)?;
    /// let state = yarn.equilibria(Twist::Pretwist(-0.2), Load::NONE)?[0];
    /// assert_eq!(state.interstrand_pressure(), state.resultant_pressure() / 2.0); // line contact, counted twice
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn interstrand_pressure(&self) -> f64 {
        let rho = self.contact.radius_ratio();
        match self.balance {
            Balance::Radial => self.radial_pressure() / (rho * self.contact.one_minus_cos_beta()),
            Balance::Contact => 0.5 * rho * self.pressure_beyond(self.external_pressure),
        }
    }

    #[doc = include_str!("../equations/eq57.md")]
    ///
    /// λ r⁴/B, the multiplier of the constraint (59): 0 in radial balance, a quarter of p₁ in contact balance.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
    /// // (57): p = p̂ − 2λρΔ with Δ = 4/ρ², and no pressure from outside
    /// let balance = state.radial_pressure() - 8.0 * state.constraint_multiplier() / state.contact().radius_ratio();
    /// assert!(balance.abs() < 1e-16);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn constraint_multiplier(&self) -> f64 {
        match self.balance {
            Balance::Radial => 0.0,
            Balance::Contact => 0.25 * self.interstrand_pressure(),
        }
    }

    /// Whether the neighbours would have to pull (p₁ < 0) to keep this shape: the ply has come apart, unless its
    /// strands attract each other.
    #[must_use]
    pub fn is_separated(&self) -> bool {
        self.interstrand_pressure() < 0.0
    }
}
