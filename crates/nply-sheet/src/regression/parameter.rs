//! What can be estimated.

use crate::Dimension;

/// A number of the strands that can be estimated, named as its key in the input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parameter {
    /// r.
    Radius,
    /// 2r.
    Diameter,
    /// B.
    BendingStiffness,
    /// E of a solid round strand, B = πEr⁴/4.
    YoungsModulus,
    /// γ = C/B.
    StiffnessRatio,
    /// C.
    TorsionalStiffness,
    /// G of a solid round strand, C = πGr⁴/2.
    ShearModulus,
    /// φ̄a.
    Pretwist,
    /// The rotation put into a strand per length, φ̄/L.
    TurnsPerLength,
    /// u₃.
    StrandTwist,
    /// EA, the k of a string: force per strain of a strand that stretches.
    AxialStiffness,
}

/// Which of five numbers it gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    Radius,
    Bending,
    Torsion,
    Twist,
    Axial,
}

impl Parameter {
    /// All.
    pub const ALL: [Self; 11] = [
        Self::StiffnessRatio,
        Self::BendingStiffness,
        Self::YoungsModulus,
        Self::TorsionalStiffness,
        Self::ShearModulus,
        Self::Radius,
        Self::Diameter,
        Self::Pretwist,
        Self::TurnsPerLength,
        Self::StrandTwist,
        Self::AxialStiffness,
    ];

    /// The key's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Radius => "radius",
            Self::Diameter => "diameter",
            Self::BendingStiffness => "bending_stiffness",
            Self::YoungsModulus => "youngs_modulus",
            Self::StiffnessRatio => "stiffness_ratio",
            Self::TorsionalStiffness => "torsional_stiffness",
            Self::ShearModulus => "shear_modulus",
            Self::Pretwist => "pretwist",
            Self::TurnsPerLength => "turns_per_length",
            Self::StrandTwist => "strand_twist",
            Self::AxialStiffness => "axial_stiffness",
        }
    }

    /// By its name, with dashes or underscores; `strand_radius` is the radius.
    ///
    /// ```
    /// use nply_sheet::regression::Parameter;
    /// assert_eq!(Parameter::named("stiffness-ratio"), Some(Parameter::StiffnessRatio));
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let name = name.trim().replace('-', "_");
        let name = if name == "strand_radius" { "radius" } else { name.as_str() };
        Self::ALL.into_iter().find(|parameter| parameter.name() == name)
    }

    /// What its unit must be.
    #[must_use]
    pub const fn dimension(self) -> Dimension {
        match self {
            Self::Radius | Self::Diameter => Dimension::LENGTH,
            Self::BendingStiffness | Self::TorsionalStiffness => Dimension::STIFFNESS,
            Self::YoungsModulus | Self::ShearModulus => Dimension::PRESSURE,
            Self::StiffnessRatio | Self::Pretwist => Dimension::NUMBER,
            Self::TurnsPerLength | Self::StrandTwist => Dimension::ANGLE_PER_LENGTH,
            Self::AxialStiffness => Dimension::FORCE,
        }
    }

    pub(super) const fn slot(self) -> Slot {
        match self {
            Self::Radius | Self::Diameter => Slot::Radius,
            Self::BendingStiffness | Self::YoungsModulus => Slot::Bending,
            Self::StiffnessRatio | Self::TorsionalStiffness | Self::ShearModulus => Slot::Torsion,
            Self::Pretwist | Self::TurnsPerLength | Self::StrandTwist => Slot::Twist,
            Self::AxialStiffness => Slot::Axial,
        }
    }

    /// Whether it must be greater than 0; then its logarithm is what is sought, so that no bound is ever met.
    #[must_use]
    pub const fn is_positive(self) -> bool {
        !matches!(self.slot(), Slot::Twist)
    }
}
