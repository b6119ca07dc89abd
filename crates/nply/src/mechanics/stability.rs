//! Which states stay where they are, among uniform plies.

use super::{Balance, Equilibrium};

/// What a uniform ply under dead loads does after a small disturbance that leaves it uniform.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stability {
    /// It comes back: the energy is least here.
    Stable,
    /// It runs away.
    Unstable,
    /// Neither can be said to within rounding: a fold.
    Marginal,
}

impl Stability {
    /// By the sign of a second variation, of which rounding may make up so much.
    pub(super) fn of(second: f64, rounding: f64) -> Self {
        if second > rounding {
            Self::Stable
        } else if second < -rounding {
            Self::Unstable
        } else {
            Self::Marginal
        }
    }

    /// The name used in JSON, CSV and the report.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stable => "stable",
            Self::Unstable => "unstable",
            Self::Marginal => "marginal",
        }
    }
}

impl Equilibrium {
    /// d²E/dθ² along touching strands, per strand and strand length, in B/r²: the second variation of the energy under dead
    /// force and moment with the twist held as given. `None` in radial balance, which is not the slope of this energy, and
    /// where neighbours do not press on each other, so that they need not stay together.
    ///
    /// nρ² dE/dθ is the contact balance, so that it is the balance's slope over nρ².
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Twist};
    /// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
    /// assert!(state.second_variation().is_some_and(|second| second > 0.0)); // simulated: it stays at 30.6130°
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn second_variation(&self) -> Option<f64> {
        let rho = self.contact.radius_ratio();
        let n = f64::from(self.contact.strands());
        (self.balance == Balance::Contact && self.interstrand_pressure() > 0.0)
            .then(|| self.balance_slope() / (n * rho * rho))
    }

    /// The verdict of the [second variation](Self::second_variation); `None` where that is. It covers uniform plies alone: a
    /// stable ply can still buckle as a whole, loop locally, or collapse into its hole.
    #[must_use]
    pub fn stability(&self) -> Option<Stability> {
        let second = self.second_variation()?;
        let (slope, rounding) = self.slope_and_rounding();
        Some(if self.fold || slope.abs() <= 8.0 * rounding {
            Stability::Marginal
        } else if second > 0.0 {
            Stability::Stable
        } else {
            Stability::Unstable
        })
    }
}
