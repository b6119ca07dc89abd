//! What can be measured of a ply, or held while something else is.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::sensed::Sensed;
use super::state::Readings;
use crate::Dimension;

/// A column of measurements. Each is called as the flag of the same name, with underscores.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Observable {
    /// End force on the ply, tension positive.
    Force,
    /// End moment on the ply, right-handed positive.
    Moment,
    /// Ply length over (unstretched) strand length.
    LengthRatio,
    /// Ply length; needs the strand length.
    PlyLength,
    /// Rotation of the ply's end from straight strands on, rad; needs the strand length.
    PlyRotation,
    /// The same, counted in turns.
    PlyTurns,
    /// The same per strand length, rad per length.
    PlyTurnsPerStrandLength,
    /// Rotation per ply length, rad per length.
    PlyTurnsPerLength,
    /// θ, rad; without a sign.
    HelicalAngle,
    /// The same.
    LayAngle,
    /// π/2 − θ, rad.
    PitchAngle,
    /// Ply length of one turn of a strand.
    LayLength,
    /// Lay length over outer diameter.
    LayRatio,
    /// R/r.
    RadiusRatio,
    /// R.
    HelixRadius,
    /// 2(R + r).
    OuterDiameter,
}

impl Observable {
    /// All, loads first.
    pub const ALL: [Self; 16] = [
        Self::Force,
        Self::Moment,
        Self::LengthRatio,
        Self::PlyLength,
        Self::PlyRotation,
        Self::PlyTurns,
        Self::PlyTurnsPerStrandLength,
        Self::PlyTurnsPerLength,
        Self::HelicalAngle,
        Self::LayAngle,
        Self::PitchAngle,
        Self::LayLength,
        Self::LayRatio,
        Self::RadiusRatio,
        Self::HelixRadius,
        Self::OuterDiameter,
    ];

    /// The name of its column.
    ///
    /// ```
    /// use nply_sheet::regression::Observable;
    /// assert_eq!(Observable::LayLength.name(), "lay_length");
    /// ```
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Moment => "moment",
            Self::LengthRatio => "length_ratio",
            Self::PlyLength => "ply_length",
            Self::PlyRotation => "ply_rotation",
            Self::PlyTurns => "ply_turns",
            Self::PlyTurnsPerStrandLength => "ply_turns_per_strand_length",
            Self::PlyTurnsPerLength => "ply_turns_per_length",
            Self::HelicalAngle => "helical_angle",
            Self::LayAngle => "lay_angle",
            Self::PitchAngle => "pitch_angle",
            Self::LayLength => "lay_length",
            Self::LayRatio => "lay_ratio",
            Self::RadiusRatio => "radius_ratio",
            Self::HelixRadius => "helix_radius",
            Self::OuterDiameter => "outer_diameter",
        }
    }

    /// What its unit must be.
    #[must_use]
    pub const fn dimension(self) -> Dimension {
        match self {
            Self::Force => Dimension::FORCE,
            Self::Moment => Dimension::MOMENT,
            Self::LengthRatio | Self::LayRatio | Self::RadiusRatio => Dimension::NUMBER,
            Self::PlyLength | Self::LayLength | Self::HelixRadius | Self::OuterDiameter => Dimension::LENGTH,
            Self::PlyRotation | Self::PlyTurns | Self::HelicalAngle | Self::LayAngle | Self::PitchAngle => {
                Dimension::ANGLE
            }
            Self::PlyTurnsPerStrandLength | Self::PlyTurnsPerLength => Dimension::ANGLE_PER_LENGTH,
        }
    }

    /// Whether its sign is the hand's.
    #[must_use]
    pub const fn is_signed(self) -> bool {
        matches!(self, Self::PlyRotation | Self::PlyTurns | Self::PlyTurnsPerStrandLength | Self::PlyTurnsPerLength)
    }

    /// Whether it is a load at the ends and not a shape.
    #[must_use]
    pub const fn is_load(self) -> bool {
        matches!(self, Self::Force | Self::Moment)
    }

    /// Whether the strand length has to be known.
    #[must_use]
    pub const fn needs_length(self) -> bool {
        matches!(self, Self::PlyLength | Self::PlyRotation | Self::PlyTurns)
    }

    /// What a bare number of it counts in units of the theory: turns are written, radians meant.
    pub(super) const fn of_bare(self) -> f64 {
        match self {
            Self::PlyTurns | Self::PlyTurnsPerStrandLength | Self::PlyTurnsPerLength => TAU,
            _ => 1.0,
        }
    }

    /// Of a state, in SI (in the theory's units where the strand has no size).
    pub(super) fn of(self, at: &Readings) -> Sensed {
        let length = Sensed::constant(at.strand_length);
        let r = at.radius;
        match self {
            Self::Force => at.force * at.bending * (r * r).recip(),
            Self::Moment => at.moment * at.bending * r.recip(),
            Self::LengthRatio => at.extension,
            Self::PlyLength => at.extension * length,
            Self::PlyRotation | Self::PlyTurns => at.rotation * length * r.recip(),
            Self::PlyTurnsPerStrandLength => at.rotation * r.recip(),
            Self::PlyTurnsPerLength => at.rotation * (at.extension * r).recip(),
            Self::HelicalAngle | Self::LayAngle => at.angle,
            Self::PitchAngle => Sensed::constant(FRAC_PI_2) - at.angle,
            Self::LayLength => TAU * (at.lay() * r),
            Self::LayRatio => 0.5 * TAU * (at.lay() * at.outer.recip()),
            Self::RadiusRatio => at.radius_ratio,
            Self::HelixRadius => at.radius_ratio * r,
            Self::OuterDiameter => 2.0 * (at.outer * r),
        }
    }
}
