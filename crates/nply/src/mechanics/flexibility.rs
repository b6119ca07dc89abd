//! How the ply gives when its loads change, (60)–(66).

use super::atlas::Condition;
use super::{Balance, Equilibrium};

impl Equilibrium {
    /// dθ/df and dθ/dm at the held twist, (62): rad per unit of load. `None` at a fold, where they are unbounded, and so near
    /// to one that rounding leaves fewer than four digits of them (or so near to θ = π/2, where the balance's terms cancel).
    #[must_use]
    pub fn angle_slopes(&self) -> Option<(f64, f64)> {
        let (slope, lost) = self.slope_and_rounding();
        let [_, _, _, force, moment] = self.balance.terms(&self.contact);
        (!self.fold && slope.abs() > 1e4 * lost)
            .then(|| (-force.value / slope, -self.handedness.sign() * moment.value / slope))
    }

    #[doc = include_str!("../equations/eq60.md")]
    ///
    /// a·[[∂d_f/∂f, ∂d_f/∂m], [∂d_m/∂f, ∂d_m/∂m]], per unit of dimensionless load, at this state, loaded or not, at the held
    /// [`twist`](Self::twist). `None` at a fold, where it is unbounded.
    ///
    /// The whole derivative of d_m is taken, with ρ′: in contact balance the matrix is symmetric (Maxwell and Betti); in
    /// radial balance it is not for n ≥ 3. [`flexibility_as_published`](Self::flexibility_as_published) has (63).
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-0.8), Load::NONE)?[0];
    /// let [[_, fm], [mf, mm]] = state.flexibility().expect("no fold");
    /// assert!((fm - mf).abs() < 1e-14 && (mm - 0.10509360657842202).abs() < 1e-12); // 40-digit table
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn flexibility(&self) -> Option<[[f64; 2]; 2]> {
        let (by_force, by_moment) = self.angle_slopes()?;
        let (df, dm) = self.displacement_slopes();
        Some([[df * by_force, df * by_moment], [dm * by_force, dm * by_moment]])
    }

    #[doc = include_str!("../equations/eq63.md")]
    ///
    /// In radial balance, as printed: without the ρ′ of d_m, and so symmetric for every n. `None` at a fold and in
    /// contact balance, which is not the paper's.
    #[must_use]
    pub fn flexibility_as_published(&self) -> Option<[[f64; 2]; 2]> {
        let slope = self.published_slope()?;
        let (s, c, rho) = (self.contact.angle().sin(), self.contact.angle().cos(), self.contact.radius_ratio());
        let cross = -self.handedness.sign() * rho * s * c / slope;
        Some([[rho * rho * s * s / slope, cross], [cross, c * c / slope]])
    }

    /// ∂G/∂θ of radial balance, where it is not zero.
    pub(super) fn published_slope(&self) -> Option<f64> {
        let slope = self.balance_slope();
        (self.balance == Balance::Radial && !self.fold && slope != 0.0).then_some(slope)
    }
}
