//! How the ends of the ply are held.

use super::Load;
use crate::DomainError;

/// What is given at the ends: of each pair, load and displacement, one.
///
/// Displacements are per strand length: the ply's length over the strands', a·d_f = cos θ (50), and the rotation of its end per
/// strand length times r, a·d_m = ε sin θ/ρ (51). Both held needs strands that stretch.
///
/// ```
/// use nply::mechanics::{Ends, Holding, Load};
/// assert_eq!(Ends::from(Load::NONE).holding(), Holding::DeadLoads);
/// assert_eq!(Ends::Rotation { rotation: 0.3, force: 0.0 }.holding(), Holding::Rotation);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// Dead force and moment; a torque-free swivel has moment 0.
    Loads(Load),
    /// Ends that cannot turn, under a dead force.
    Rotation {
        /// a·d_m = ε sin θ/ρ: right-handed positive.
        rotation: f64,
        /// f.
        force: f64,
    },
    /// Ends a given distance apart, under a dead moment.
    Length {
        /// a·d_f = cos θ: ply length over strand length.
        extension: f64,
        /// m.
        moment: f64,
    },
}

/// The way in which ends are held, without its numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Holding {
    /// Dead force and moment.
    #[default]
    DeadLoads,
    /// The rotation is held, the force is dead.
    Rotation,
    /// The length is held, the moment is dead.
    Length,
}

impl Holding {
    /// All, the default first.
    pub const ALL: [Self; 3] = [Self::DeadLoads, Self::Rotation, Self::Length];

    /// The name used in files, flags and JSON: `dead_loads`, `rotation_held` or `length_held`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::DeadLoads => "dead_loads",
            Self::Rotation => "rotation_held",
            Self::Length => "length_held",
        }
    }
}

impl Ends {
    /// What is held.
    #[must_use]
    pub const fn holding(self) -> Holding {
        match self {
            Self::Loads(_) => Holding::DeadLoads,
            Self::Rotation { .. } => Holding::Rotation,
            Self::Length { .. } => Holding::Length,
        }
    }

    /// The loads given; a load that has to be found is 0.
    pub(super) const fn given(self) -> Load {
        match self {
            Self::Loads(load) => load,
            Self::Rotation { force, .. } => Load { force, moment: 0.0 },
            Self::Length { moment, .. } => Load { force: 0.0, moment },
        }
    }

    /// Displacements that a ply can have; its loads are checked with the twist.
    pub(super) fn check(self) -> Result<(), DomainError> {
        match self {
            Self::Loads(_) => Ok(()),
            Self::Rotation { rotation, .. } => DomainError::check(
                (1e-140..f64::INFINITY).contains(&rotation.abs()),
                "rotation",
                rotation,
                "finite and not 0 (at least 1e-140), which straight strands have",
            ),
            Self::Length { extension, .. } => check_extension(extension),
        }
    }
}

/// Between flat rings and straight strands, neither of them a ply with a hand.
fn check_extension(extension: f64) -> Result<(), DomainError> {
    DomainError::check(
        extension > 1e-150 && extension < 1.0,
        "extension",
        extension,
        "greater than 0 and less than 1: a ply is shorter than its strands",
    )
}

impl From<Load> for Ends {
    fn from(load: Load) -> Self {
        Self::Loads(load)
    }
}
