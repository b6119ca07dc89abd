//! The ply as one straight rod, (68)–(75).

use super::Equilibrium;

/// Effective stiffnesses of the ply: each is one load over one strain with the other load held, as the paper defines
/// them. The ply's strands do not stretch, so that its flexibility has rank one and these are not a matrix's inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// C_ply/B, (72): moment per ply twist, force held.
    pub torsional: f64,
    /// K_ply r²/B, (73): force per extension, moment held.
    pub axial: f64,
    /// A_ply r/B, (74): force per ply twist.
    pub force_per_twist: f64,
    /// H_ply r/B, (75): moment per extension.
    pub moment_per_extension: f64,
}

impl Equilibrium {
    #[doc = include_str!("../equations/eq68.md")]
    ///
    /// r u₃,ply = ε tan θ/ρ, dimensionless.
    #[must_use]
    pub fn ply_twist(&self) -> f64 {
        self.handedness.sign() * self.contact.angle().tan() / self.contact.radius_ratio()
    }

    #[doc = include_str!("../equations/eq72_75.md")]
    ///
    /// About this state, loaded or not, at the held [`twist`](Self::twist), with the whole derivative of the ply's twist
    /// (ρ′ kept). `None` at a fold, where they vanish together, and for straight strands.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let state = Ply::new(2, 0.75)?.equilibria(Twist::Pretwist(-1e-3), Load::NONE)?[0];
    /// let stiffness = state.stiffness().expect("no fold");
    /// assert!((stiffness.torsional - 2.0 * 0.75).abs() < 1e-4); // two parallel rods: nγ
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn stiffness(&self) -> Option<Stiffness> {
        let (by_force, by_moment) = self.angle_slopes()?;
        let (s, c) = (self.contact.angle().sin(), self.contact.angle().cos());
        let at = self.contact.regular();
        // d(tan θ/ρ)/dθ = (1 − q cos²θ)/(ρ cos²θ) and d(cos θ/cos θ₀)/dθ at θ₀
        let twist = self.handedness.sign() * (1.0 - s * s * at.share.value) / (at.radius.value * c);
        let extension = -s / c;
        (s > 0.0).then(|| Stiffness {
            torsional: 1.0 / (twist * by_moment),
            axial: 1.0 / (extension * by_force),
            force_per_twist: 1.0 / (twist * by_force),
            moment_per_extension: 1.0 / (extension * by_moment),
        })
    }

    /// (72)–(75) as printed, in radial balance. `None` at a fold, for straight strands and in contact balance.
    #[must_use]
    pub fn stiffness_as_published(&self) -> Option<Stiffness> {
        let slope = self.published_slope()?;
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let eps = self.handedness.sign();
        (s > 0.0).then(|| Stiffness {
            torsional: c * slope,
            axial: c * slope / (rho * rho * s * s),
            force_per_twist: -eps * c * c * slope / (rho * s),
            moment_per_extension: -eps * slope / (rho * s),
        })
    }
}
