//! The displacements through which the end loads do work, (50) and (51).

use super::Equilibrium;

impl Equilibrium {
    #[doc = include_str!("../equations/eq50.md")]
    ///
    /// a·d_f = cos θ: ply length per strand length.
    #[must_use]
    pub fn extension(&self) -> f64 {
        self.contact.angle().cos()
    }

    #[doc = include_str!("../equations/eq51.md")]
    ///
    /// a·d_m = ε sin θ/ρ: rotation of the ply's end in rad per strand length, times r.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.handedness.sign() * self.contact.angle().sin() / self.contact.radius_ratio()
    }

    /// d(a·d_f)/dθ and d(a·d_m)/dθ along the branch.
    pub(super) fn displacement_slopes(&self) -> (f64, f64) {
        let (s, c) = (self.contact.angle().sin(), self.contact.angle().cos());
        let at = self.contact.regular();
        // (cos θ/ρ)(1 − q) = (cos²θ − q cos²θ)/(ρ cos θ)
        (-s, self.handedness.sign() * (c * c - s * s * at.share.value) / at.radius.value)
    }
}
