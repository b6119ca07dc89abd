//! The ply whose states are asked for.

use std::borrow::Cow;
use std::sync::OnceLock;

use super::Balance;
use super::near_straight::ChartedBalance;
use crate::DomainError;
use crate::geometry::check_strands;

/// n strands of stiffness ratio γ = C/B, and the balance that holds between them.
///
/// Cheap to make for 2 … 12 strands, whose branch is charted once in a program; others chart it when made (some tens of
/// microseconds), so keep them.
///
/// ```
/// use nply::mechanics::{Load, Ply, Twist};
/// let yarn = Ply::new(3, 0.75)?;
/// // released after a left-handed pretwist φ̄a = −1 the strands coil right-handed, at 30.613° (simulated: 30.6130°)
/// let states = yarn.equilibria(Twist::Pretwist(-1.0), Load::NONE)?;
/// assert!((states[0].contact().angle().degrees() - 30.613).abs() < 5e-4);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Ply {
    strands: u32,
    stiffness_ratio: f64,
    balance: Balance,
    external_pressure: f64,
    atlas: Cow<'static, ChartedBalance>,
}

impl Ply {
    /// n ≥ 2 strands with γ = C/B > 0, in contact balance.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` or `stiffness_ratio`.
    pub fn new(strands: u32, stiffness_ratio: f64) -> Result<Self, DomainError> {
        Self::with_balance(strands, stiffness_ratio, Balance::Contact)
    }

    /// n ≥ 2 strands with γ = C/B > 0, in the given balance.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` or `stiffness_ratio`.
    pub fn with_balance(strands: u32, stiffness_ratio: f64, balance: Balance) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Self::check_ratio(stiffness_ratio)?;
        let atlas = chart(strands, balance);
        Ok(Self { strands, stiffness_ratio, balance, external_pressure: 0.0, atlas })
    }

    fn check_ratio(stiffness_ratio: f64) -> Result<(), DomainError> {
        DomainError::check(
            stiffness_ratio > 0.0 && stiffness_ratio < f64::INFINITY,
            "stiffness_ratio",
            stiffness_ratio,
            "greater than 0 and finite",
        )
    }

    /// The same ply with another γ, without charting its branch anew.
    ///
    /// # Errors
    /// [`DomainError`] on `stiffness_ratio` unless it is greater than 0 and finite.
    ///
    /// ```
    /// use nply::mechanics::Ply;
    /// assert_eq!(Ply::new(3, 0.75)?.with_stiffness_ratio(1.5)?.stiffness_ratio(), 1.5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn with_stiffness_ratio(&self, stiffness_ratio: f64) -> Result<Self, DomainError> {
        Self::check_ratio(stiffness_ratio)?;
        Ok(Self { stiffness_ratio, ..self.clone() })
    }

    #[doc = include_str!("../equations/external_pressure.md")]
    ///
    /// p_e r³/B, outward positive, on strands in contact balance.
    ///
    /// # Errors
    /// [`DomainError`] unless finite, or if not 0 in radial balance, which is itself the case of a certain pressure.
    ///
    /// ```
    /// use nply::mechanics::{Balance, Load, Ply, Twist};
    /// // the pressure p̂ that leaves the neighbours nothing to carry takes contact balance to radial balance
    /// let radial = Ply::with_balance(3, 0.75, Balance::Radial)?;
    /// let free = radial.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
    /// let pressed = Ply::new(3, 0.75)?.with_external_pressure(free.resultant_pressure())?;
    /// let states = pressed.equilibria(Twist::Pretwist(-1.0), Load::NONE)?;
    /// let same = |s: &&nply::mechanics::Equilibrium| (s.contact().helical_angle() - free.contact().helical_angle()).abs() < 1e-12;
    /// assert!(states.iter().find(same).is_some_and(|s| s.interstrand_pressure().abs() < 1e-12));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn with_external_pressure(mut self, external_pressure: f64) -> Result<Self, DomainError> {
        let allowed = match self.balance {
            Balance::Contact => external_pressure.is_finite(),
            Balance::Radial => external_pressure == 0.0,
        };
        DomainError::check(
            allowed,
            "external_pressure",
            external_pressure,
            "finite, and 0 in radial balance, which leaves the neighbours nothing to carry",
        )?;
        self.external_pressure = external_pressure;
        Ok(self)
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// γ = C/B.
    #[must_use]
    pub const fn stiffness_ratio(&self) -> f64 {
        self.stiffness_ratio
    }

    /// The balance in force.
    #[must_use]
    pub const fn balance(&self) -> Balance {
        self.balance
    }

    /// p_e r³/B, outward positive.
    #[must_use]
    pub const fn external_pressure(&self) -> f64 {
        self.external_pressure
    }

    pub(crate) fn atlas(&self) -> &ChartedBalance {
        &self.atlas
    }
}

/// The charted branch, kept for the numbers of strands that people use.
fn chart(strands: u32, balance: Balance) -> Cow<'static, ChartedBalance> {
    const KEPT: usize = 11; // n = 2 … 12
    static CONTACT: [OnceLock<ChartedBalance>; KEPT] = [const { OnceLock::new() }; KEPT];
    static RADIAL: [OnceLock<ChartedBalance>; KEPT] = [const { OnceLock::new() }; KEPT];
    let kept = match balance {
        Balance::Contact => &CONTACT,
        Balance::Radial => &RADIAL,
    };
    let new = || ChartedBalance::new(strands, balance);
    kept.get(strands as usize - 2).map_or_else(|| Cow::Owned(new()), |once| Cow::Borrowed(once.get_or_init(new)))
}
