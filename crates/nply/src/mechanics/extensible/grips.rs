//! How the ends of a ply that stretches are held: along and around, each by itself.

use crate::DomainError;
use crate::mechanics::{Ends, Load};

/// Along the axis: a dead force, or a length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axial {
    /// f.
    Force(f64),
    /// Ply length over unstretched strand length, λ cos θ.
    Extension(f64),
}

/// Around the axis: a dead moment, or a rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turning {
    /// m.
    Moment(f64),
    /// Rotation of the ply's end per unstretched strand length, times r: ε λ sin θ/ρ.
    Rotation(f64),
}

/// What is given at the ends: along the axis and around it, a load or a displacement each. Strands that stretch can have both
/// displacements held, as between clamps.
///
/// ```
/// use nply::mechanics::{Axial, Ends, Grips, Turning};
/// let clamped = Grips { axial: Axial::Extension(0.95), turning: Turning::Rotation(0.2) };
/// assert_ne!(clamped, Grips::from(Ends::Rotation { rotation: 0.2, force: 0.0 }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grips {
    /// Along the axis.
    pub axial: Axial,
    /// Around the axis.
    pub turning: Turning,
}

impl Grips {
    /// The loads given; one that has to be found is 0.
    pub(super) const fn given(self) -> Load {
        let force = match self.axial {
            Axial::Force(force) => force,
            Axial::Extension(_) => 0.0,
        };
        let moment = match self.turning {
            Turning::Moment(moment) => moment,
            Turning::Rotation(_) => 0.0,
        };
        Load { force, moment }
    }

    pub(super) fn check(self, stretches: bool) -> Result<(), DomainError> {
        let finite = |name, value: f64| DomainError::check(value.is_finite(), name, value, "finite");
        match self.axial {
            Axial::Force(force) => finite("force", force)?,
            Axial::Extension(extension) => DomainError::check(
                extension > 1e-150 && extension < if stretches { 2.0 } else { 1.0 },
                "extension",
                extension,
                "greater than 0 and less than 1, or than 2 where strands stretch",
            )?,
        }
        match self.turning {
            Turning::Moment(moment) => finite("moment", moment)?,
            Turning::Rotation(rotation) => DomainError::check(
                (1e-140..f64::INFINITY).contains(&rotation.abs()),
                "rotation",
                rotation,
                "finite and not 0 (at least 1e-140), which straight strands have",
            )?,
        }
        let both = matches!((self.axial, self.turning), (Axial::Extension(_), Turning::Rotation(_)));
        let allowed = "free where the length is held too, unless strands stretch";
        DomainError::check(stretches || !both, "rotation", f64::NAN, allowed)
    }
}

impl From<Load> for Grips {
    fn from(load: Load) -> Self {
        Self { axial: Axial::Force(load.force), turning: Turning::Moment(load.moment) }
    }
}

impl From<Ends> for Grips {
    fn from(ends: Ends) -> Self {
        match ends {
            Ends::Loads(load) => load.into(),
            Ends::Rotation { rotation, force } => {
                Self { axial: Axial::Force(force), turning: Turning::Rotation(rotation) }
            }
            Ends::Length { extension, moment } => {
                Self { axial: Axial::Extension(extension), turning: Turning::Moment(moment) }
            }
        }
    }
}
