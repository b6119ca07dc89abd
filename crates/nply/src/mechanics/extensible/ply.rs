//! The ply of strands that stretch.

use super::strand::{FormedLay, StretchingStrand, WorkingCore};
use crate::DomainError;
use crate::geometry::{Contact, check_strands};

/// n strands that stretch, perhaps laid on a core that works, perhaps formed beforehand.
///
#[doc = include_str!("../../equations/extensible_energy.md")]
///
/// With [`StretchingStrand::inextensible`] and nothing formed it is the paper's ply in
/// contact balance, with supports. Every contact pushes and none pulls; no friction.
///
/// ```
/// use nply::mechanics::{ExtensiblePly, Grips, Load, Support, StretchingStrand, Twist};
/// // a yarn of three solid fibres: it stretches a little, and its lay is that of the paper but for that
/// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(1.0 / 3.0)?)?;
/// let load = Load { force: 0.03, moment: 0.0 };
/// let states = yarn.states(Twist::Pretwist(-0.2), load)?;
/// let state = states.iter().find(|s| s.support() == Support::Neighbours).expect("it holds together");
/// assert!((state.strain() - 0.01 * state.angle().cos() / 4.0).abs() < 1e-3);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExtensiblePly {
    strands: u32,
    strand: StretchingStrand,
    core: Option<WorkingCore>,
    formed: Option<FormedLay>,
}

impl ExtensiblePly {
    /// n ≥ 2 strands, straight where nothing is done to them, without a core.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`.
    pub fn new(strands: u32, strand: StretchingStrand) -> Result<Self, DomainError> {
        check_strands(strands)?;
        Ok(Self { strands, strand, core: None, formed: None })
    }

    /// The same with a core. One that carries needs the lay in which it is free of stress: [`formed_in`](Self::formed_in).
    ///
    /// # Errors
    /// [`DomainError`] if the lay given already lies inside the core.
    pub fn with_core(mut self, core: WorkingCore) -> Result<Self, DomainError> {
        self.core = Some(core);
        self.checked()
    }

    /// The same, made in a lay: the core is free of stress there, and strands as far as they are preformed.
    ///
    /// # Errors
    /// [`DomainError`] unless the lay has 0 < θ₀ < π/2, its strands clear of each other and of the core (to within rounding), and
    /// 0 ≤ preforming ≤ 1.
    pub fn formed_in(mut self, lay: FormedLay) -> Result<Self, DomainError> {
        self.formed = Some(lay);
        self.checked()
    }

    fn checked(self) -> Result<Self, DomainError> {
        let Some(lay) = self.formed else { return Ok(self) };
        let FormedLay { angle, radius_ratio, preforming, .. } = lay;
        DomainError::check(
            angle.sin() > 0.0,
            "helical_angle",
            angle.radians(),
            "greater than 0 where a ply is formed",
        )?;
        DomainError::check((0.0..=1.0).contains(&preforming), "preforming", preforming, "between 0 and 1")?;
        let touching = Contact::at(self.strands, angle).radius_ratio();
        let rounding = 1.0 - 64.0 * f64::EPSILON;
        DomainError::check(
            radius_ratio >= touching * rounding && radius_ratio < f64::INFINITY,
            "radius_ratio",
            radius_ratio,
            "at least that of strands that touch each other at this angle",
        )?;
        let least = self.core.map_or(0.0, |core| 1.0 + core.radius());
        DomainError::check(
            radius_ratio >= least * rounding,
            "radius_ratio",
            radius_ratio,
            "at least 1 more than the core's radius, on which the strands lie",
        )?;
        Ok(self)
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// What the strands are.
    #[must_use]
    pub const fn strand(&self) -> StretchingStrand {
        self.strand
    }

    /// The core, if there is one.
    #[must_use]
    pub const fn core(&self) -> Option<WorkingCore> {
        self.core
    }

    /// The lay in which it was made, if it was.
    #[must_use]
    pub const fn formed(&self) -> Option<FormedLay> {
        self.formed
    }
}
