//! The one list of everything that can be written of a ply: keys of the file, flags of the command line.

mod construction;

use crate::Dimension;
pub use construction::CONSTRUCTION_KEYS;

/// A table of the input file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Table {
    /// `[ply]`: number of strands, balance, hand.
    Ply,
    /// `[strand]`: size and stiffness of a strand.
    Strand,
    /// `[twist]`: the twist put into the strands.
    Twist,
    /// `[lay]`: the shape of the ply, where it is given and not asked for.
    Lay,
    /// `[formed]`: the lay in which a ply of strands that stretch was made.
    Formed,
    /// `[load]`: what pulls and turns the ply.
    Load,
    /// `[ends]`: how the ply's ends are held, where a displacement is given instead of a load.
    Ends,
    /// `[support]`: a core that the strands may lie on or lift off from.
    Support,
    /// `[construction]` of a layered strand: its name and outer diameter.
    Construction,
    /// `[core]` of a layered strand: the king wire, or whatever the first layer lies on.
    Core,
    /// `[[layer]]` of a layered strand: wires alike, laid side by side.
    Layer,
}

impl Table {
    /// All tables of a ply, in the order in which a file is usually written.
    pub const ALL: [Self; 8] =
        [Self::Ply, Self::Strand, Self::Twist, Self::Lay, Self::Formed, Self::Load, Self::Ends, Self::Support];

    /// What stands in it, on one line.
    pub(crate) const fn about(self) -> &'static str {
        match self {
            Self::Ply => "The ply: number of strands, balance, hand",
            Self::Strand => "Size and stiffness of a strand",
            Self::Twist => "The twist put into the strands: one of these",
            Self::Lay => "The shape of the ply, where it is given and not asked for: one of these",
            Self::Formed => "The lay in which a ply of strands that stretch was made",
            Self::Load => "What pulls and turns it",
            Self::Ends => "How the ends are held, where a displacement is given instead of a load",
            Self::Support => "A core that the strands may lie on or lift off from",
            Self::Construction => "The layered strand as a whole",
            Self::Core => "The king wire, or whatever the first layer lies on",
            Self::Layer => "Wires alike, laid side by side",
        }
    }

    /// The name between the brackets.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ply => "ply",
            Self::Strand => "strand",
            Self::Twist => "twist",
            Self::Lay => "lay",
            Self::Formed => "formed",
            Self::Load => "load",
            Self::Ends => "ends",
            Self::Support => "support",
            Self::Construction => "construction",
            Self::Core => "core",
            Self::Layer => "layer",
        }
    }
}

/// The sort of value a key takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// A whole number.
    Count,
    /// A pure number.
    Number,
    /// `contact` or `radial`.
    Balance,
    /// `right`, `left`, `Z` or `S`.
    Hand,
    /// Free text.
    Text,
    /// `true` or `false`; as a flag it needs no value.
    Switch,
    /// A length; bare, in strand radii.
    Length,
    /// Force times length squared.
    Stiffness,
    /// Force per area.
    Pressure,
    /// Mass per length, or a yarn count: the titre of a strand.
    LinearDensity,
    /// An absolute temperature.
    Temperature,
    /// An angle, always with its unit.
    Angle,
    /// A number of turns, bare or as an angle.
    Turns,
    /// Turns (or another angle) per length; bare, turns per strand radius.
    TurnsPerLength,
    /// An angle per length; bare, radians per strand radius.
    Twist,
    /// A force; bare, in B/r².
    Force,
    /// A moment; bare, in B/r.
    Moment,
    /// A force per length; bare, in B/r³.
    ForcePerLength,
    /// Mass per volume; bare where lengths are.
    Density,
    /// Young's modulus, or strength, of a layer or core; bare where lengths are.
    Modulus,
}

impl Kind {
    /// What is wanted, with an example, as part of a sentence.
    #[must_use]
    pub const fn wanted(self) -> &'static str {
        match self {
            Self::Count => "a whole number, such as 3",
            Self::Number => "a pure number, such as 0.75",
            Self::Balance => "\"contact\" or \"radial\"",
            Self::Hand => "\"right\" (Z) or \"left\" (S)",
            Self::Text => "a text in quotation marks",
            Self::Switch => "true or false",
            Self::Length => "a length, such as \"0.5 mm\"",
            Self::Stiffness => "a stiffness (force times length squared), such as \"50 pN nm^2\"",
            Self::Pressure | Self::Modulus => "a pressure, such as \"70 GPa\"",
            Self::LinearDensity => "a linear density, such as \"94 tex\", \"840 den\" or \"Ne 30\"",
            Self::Temperature => "a temperature, such as \"298 K\"",
            Self::Angle => "an angle, such as \"20 deg\"",
            Self::Turns => "a number of turns, such as 12 or \"12 turns\"",
            Self::TurnsPerLength => "turns per length, such as \"200 turns/m\"",
            Self::Twist => "an angle per length, such as \"200 turns/m\" or \"3 rad/mm\"",
            Self::Force => "a force, such as \"1.2 kN\"",
            Self::Moment => "a moment, such as \"12 N m\" or \"4.1 pN nm\"",
            Self::ForcePerLength => "a force per length, such as \"5 N/mm\"",
            Self::Density => "a density, such as \"7.85 g/cm^3\"",
        }
    }

    /// The dimension its unit must have; `None` for words and switches.
    #[must_use]
    pub const fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Count | Self::Number => Some(Dimension::NUMBER),
            Self::Balance | Self::Hand | Self::Text | Self::Switch => None,
            Self::Length => Some(Dimension::LENGTH),
            Self::Stiffness => Some(Dimension::STIFFNESS),
            Self::Pressure | Self::Modulus => Some(Dimension::PRESSURE),
            Self::LinearDensity => Some(Dimension::LINEAR_DENSITY),
            Self::Temperature => Some(Dimension::TEMPERATURE),
            Self::Angle | Self::Turns => Some(Dimension::ANGLE),
            Self::TurnsPerLength | Self::Twist => Some(Dimension::ANGLE_PER_LENGTH),
            Self::Force => Some(Dimension::FORCE),
            Self::Moment => Some(Dimension::MOMENT),
            Self::ForcePerLength => Some(Dimension::FORCE_PER_LENGTH),
            Self::Density => Some(Dimension::DENSITY),
        }
    }

    /// Whether a unit of this dimension is the one wanted once the temperature (kT) or the linear density (cN/tex) is known.
    pub(crate) fn is_relative(self, found: Dimension) -> bool {
        match self {
            Self::Stiffness | Self::Force | Self::Moment | Self::ForcePerLength | Self::Pressure => {
                self.dimension().and_then(|wanted| wanted.times(Dimension::TEMPERATURE, -1)) == Some(found)
                    || (self == Self::Force && found == Dimension::SPECIFIC_STRESS)
            }
            _ => false,
        }
    }

    /// Whether a bare number can be meant at all; whether it may stand in a given input depends on what else is given.
    pub(crate) const fn may_be_bare(self) -> bool {
        !matches!(self, Self::Stiffness | Self::Pressure | Self::LinearDensity | Self::Temperature | Self::Angle)
    }
}

/// Data of which only one can be given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Group {
    /// Radius or diameter.
    Size,
    /// What gives the bending stiffness B.
    Bending,
    /// What gives the torsional stiffness C, or γ.
    Torsion,
    /// The twist put in.
    Twist,
    /// The shape of the ply.
    Lay,
    /// How the ply's ends are held.
    Ends,
    /// The size of a core the strands may lie on.
    Support,
    /// Poisson's ratio by which strands thin.
    Thinning,
    /// The lay in which the ply was made.
    Formed,
    /// What gives a core's stiffness against stretch.
    CoreAxial,
    /// What gives a core's stiffness against twist.
    CoreTorsion,
    /// The size of a layered strand's core.
    CoreSize,
    /// The lay of a layer.
    LayerLay,
    /// What core or wires weigh.
    Density,
}

/// One datum, whatever it is called on paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[expect(missing_docs, reason = "each is the key of the same name; KEYS and CONSTRUCTION_KEYS say what it means")]
#[non_exhaustive]
pub enum Datum {
    Title,
    Strands,
    Balance,
    Hand,
    Radius,
    Diameter,
    LinearDensity,
    Density,
    PackingFraction,
    BendingStiffness,
    TorsionalStiffness,
    StiffnessRatio,
    YoungsModulus,
    PoissonsRatio,
    ShearModulus,
    BendingPersistenceLength,
    TwistPersistenceLength,
    Temperature,
    StrandLength,
    Pretwist,
    SurfaceAngle,
    TurnsPerLength,
    Turns,
    EndRotation,
    StrandTwist,
    HelicalAngle,
    LayAngle,
    PitchAngle,
    LayLength,
    LayRatio,
    PlyTurnsPerLength,
    RadiusRatio,
    HelixRadius,
    CoreRadius,
    CoreDiameter,
    Force,
    Moment,
    ExternalPressure,
    Separation,
    PlyRotation,
    PlyTurns,
    PlyTurnsPerStrandLength,
    PlyLength,
    LengthRatio,
    SupportCoreRadius,
    SupportCoreDiameter,
    Stretch,
    AxialStiffness,
    ThinningRatio,
    FormedHelicalAngle,
    FormedLayLength,
    FormedRadiusRatio,
    FormedHand,
    Preforming,
    SupportCoreYoungsModulus,
    SupportCorePoissonsRatio,
    SupportCoreAxialStiffness,
    SupportCoreTorsionalStiffness,
    StrandTitle,
    StrandOuterDiameter,
    StrandCoreDiameter,
    StrandCoreDiameterRatio,
    StrandCoreDensity,
    StrandCoreMaterial,
    StrandCoreYoungsModulus,
    StrandCorePoissonsRatio,
    StrandCoreTensileStrength,
    StrandCoreFibre,
    LayerWires,
    LayerWireDiameter,
    LayerLayLength,
    LayerLayRatio,
    LayerLayAngle,
    LayerHand,
    LayerGap,
    LayerDensity,
    LayerMaterial,
    LayerYoungsModulus,
    LayerPoissonsRatio,
    LayerTensileStrength,
    LayerPreforming,
    LayerPretwist,
    CableForce,
    CableMoment,
    CableTurning,
    CableTorqueFactor,
    CableBalancedLayer,
}

/// One key: where it stands in the file, its flag, what it means.
///
/// ```
/// use nply_sheet::KEYS;
/// let key = KEYS.iter().find(|key| key.flag == "ply-turns-per-length").unwrap();
/// assert_eq!((key.table.name(), key.name), ("lay", "turns_per_length"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Which datum it is.
    pub datum: Datum,
    /// The table it belongs to.
    pub table: Table,
    /// Its name in the file.
    pub name: &'static str,
    /// Its flag, without dashes in front.
    pub flag: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// What it means, on one line.
    pub help: &'static str,
    pub(crate) group: Option<Group>,
}

pub(crate) const fn key(
    datum: Datum,
    table: Table,
    name: &'static str,
    flag: &'static str,
    kind: Kind,
    help: &'static str,
) -> Key {
    Key { datum, table, name, flag, kind, help, group: None }
}

impl Key {
    pub(crate) const fn one_of(mut self, group: Group) -> Self {
        self.group = Some(group);
        self
    }

    /// Whether it can change along a path or over a map: loads, twist, ends, the support's core, the stiffness ratio.
    ///
    /// ```
    /// use nply_sheet::KEYS;
    /// assert!(KEYS.iter().any(|key| key.flag == "force" && key.may_change()));
    /// assert!(KEYS.iter().all(|key| key.flag != "strands" || !key.may_change()));
    /// ```
    #[must_use]
    pub const fn may_change(&self) -> bool {
        matches!(self.table, Table::Twist | Table::Ends)
            || matches!(self.datum, Datum::SupportCoreRadius | Datum::SupportCoreDiameter)
            || matches!(self.datum, Datum::Force | Datum::Moment | Datum::StiffnessRatio)
    }

    /// Whether its sign is a hand, so that S or Z can be written in its place: every twist and every turning of the ply.
    ///
    /// ```
    /// use nply_sheet::KEYS;
    /// assert!(KEYS.iter().any(|key| key.flag == "ply-turns-per-length" && key.takes_hand()));
    /// assert!(KEYS.iter().all(|key| key.flag != "moment" || !key.takes_hand()));
    /// ```
    #[must_use]
    pub const fn takes_hand(&self) -> bool {
        matches!(self.table, Table::Twist)
            || matches!(
                self.datum,
                Datum::PlyTurnsPerLength
                    | Datum::PlyRotation
                    | Datum::PlyTurns
                    | Datum::PlyTurnsPerStrandLength
                    | Datum::LayerPretwist
                    | Datum::CableTurning
            )
    }

    /// Whether it takes words, and no number.
    pub(crate) const fn is_word(&self) -> bool {
        matches!(self.kind, Kind::Balance | Kind::Hand | Kind::Text | Kind::Switch)
    }

    /// What the datum is called in a table: its flag, and its table before it where an answer of another meaning has that name.
    pub(crate) fn column_name(&self) -> String {
        let flag = self.flag.replace('-', "_");
        match self.datum {
            Datum::TorsionalStiffness | Datum::AxialStiffness => format!("strand_{flag}"),
            _ => flag,
        }
    }

    /// The key of a datum.
    pub(crate) fn of(datum: Datum) -> Option<&'static Self> {
        Self::every().find(|key| key.datum == datum)
    }

    /// The keys of every kind of document.
    pub(crate) fn every() -> impl Iterator<Item = &'static Self> {
        KEYS.iter().chain(&CONSTRUCTION_KEYS)
    }
}

/// Every key of a ply, table by table.
#[rustfmt::skip] // a table: one row a line
pub static KEYS: [Key; 58] = [
    key(Datum::Title, Table::Ply, "title", "title", Kind::Text, "A name for the report"),
    key(Datum::Strands, Table::Ply, "strands", "strands", Kind::Count, "Number of strands n, 2 or more"),
    key(Datum::Balance, Table::Ply, "balance", "balance", Kind::Balance, "contact (touching strands, the default) or radial (as published)"),
    key(Datum::Hand, Table::Ply, "hand", "hand", Kind::Hand, "Which way a given lay winds: right (Z) or left (S); both if absent"),

    key(Datum::Radius, Table::Strand, "radius", "radius", Kind::Length, "Strand radius r").one_of(Group::Size),
    key(Datum::Diameter, Table::Strand, "diameter", "diameter", Kind::Length, "Strand diameter 2r").one_of(Group::Size),
    key(Datum::LinearDensity, Table::Strand, "linear_density", "linear-density", Kind::LinearDensity, "Mass per length of a strand: tex, den, or a count as in \"Ne 30\"; with density it gives the diameter"),
    key(Datum::Density, Table::Strand, "density", "density", Kind::Density, "Density of the fibre or wire itself, for linear_density"),
    key(Datum::PackingFraction, Table::Strand, "packing_fraction", "packing-fraction", Kind::Number, "Share of a strand's cross-section that is fibre, for linear_density; 1 (solid) if absent"),
    key(Datum::BendingStiffness, Table::Strand, "bending_stiffness", "bending-stiffness", Kind::Stiffness, "Bending stiffness B of a strand").one_of(Group::Bending),
    key(Datum::TorsionalStiffness, Table::Strand, "torsional_stiffness", "torsional-stiffness", Kind::Stiffness, "Torsional stiffness C of a strand").one_of(Group::Torsion),
    key(Datum::StiffnessRatio, Table::Strand, "stiffness_ratio", "stiffness-ratio", Kind::Number, "Stiffness ratio C/B, greater than 0").one_of(Group::Torsion),
    key(Datum::YoungsModulus, Table::Strand, "youngs_modulus", "youngs-modulus", Kind::Pressure, "Young's modulus E of a solid round strand, B = pi E r^4/4").one_of(Group::Bending),
    key(Datum::PoissonsRatio, Table::Strand, "poissons_ratio", "poissons-ratio", Kind::Number, "Poisson's ratio of a solid round strand, C/B = 1/(1 + nu)").one_of(Group::Torsion),
    key(Datum::ShearModulus, Table::Strand, "shear_modulus", "shear-modulus", Kind::Pressure, "Shear modulus G of a solid round strand, C = pi G r^4/2").one_of(Group::Torsion),
    key(Datum::BendingPersistenceLength, Table::Strand, "bending_persistence_length", "bending-persistence-length", Kind::Length, "Bending persistence length A, B = kT A").one_of(Group::Bending),
    key(Datum::TwistPersistenceLength, Table::Strand, "twist_persistence_length", "twist-persistence-length", Kind::Length, "Twist persistence length C', C = kT C'").one_of(Group::Torsion),
    key(Datum::Temperature, Table::Strand, "temperature", "temperature", Kind::Temperature, "Temperature T for persistence lengths"),
    key(Datum::StrandLength, Table::Strand, "length", "strand-length", Kind::Length, "Strand length L; needed for turns and rotations, and for the ply's length"),

    key(Datum::Stretch, Table::Strand, "stretch", "stretch", Kind::Switch, "Strands stretch and thin under load; ends may be held in length and rotation both"),
    key(Datum::AxialStiffness, Table::Strand, "axial_stiffness", "axial-stiffness", Kind::Force, "Stiffness EA of a strand that stretches; follows from Young's modulus where it is solid and round"),
    key(Datum::ThinningRatio, Table::Strand, "thinning_ratio", "thinning-ratio", Kind::Number, "Poisson's ratio by which a strand thins as it stretches, where poissons_ratio is not given; 0 if absent").one_of(Group::Thinning),

    key(Datum::Pretwist, Table::Twist, "pretwist", "pretwist", Kind::Number, "Rotation put into each strand per length, times r; right-handed positive").one_of(Group::Twist),
    key(Datum::SurfaceAngle, Table::Twist, "surface_angle", "surface-angle", Kind::Angle, "Angle chi of a stripe on the straight strand, pretwist = tan chi").one_of(Group::Twist),
    key(Datum::TurnsPerLength, Table::Twist, "turns_per_length", "turns-per-length", Kind::TurnsPerLength, "Turns put into each strand per length").one_of(Group::Twist),
    key(Datum::Turns, Table::Twist, "turns", "turns", Kind::Turns, "Turns put into each strand over its length").one_of(Group::Twist),
    key(Datum::EndRotation, Table::Twist, "end_rotation", "end-rotation", Kind::Angle, "Rotation put into each strand over its length").one_of(Group::Twist),
    key(Datum::StrandTwist, Table::Twist, "strand_twist", "strand-twist", Kind::Twist, "Twist u3 of the strands in the ply itself; bare, r u3").one_of(Group::Twist),

    key(Datum::HelicalAngle, Table::Lay, "helical_angle", "helical-angle", Kind::Angle, "Angle of the strands to the ply axis, 0 up to 90 deg").one_of(Group::Lay),
    key(Datum::LayAngle, Table::Lay, "lay_angle", "lay-angle", Kind::Angle, "The same as helical_angle").one_of(Group::Lay),
    key(Datum::PitchAngle, Table::Lay, "pitch_angle", "pitch-angle", Kind::Angle, "90 deg less the helical angle").one_of(Group::Lay),
    key(Datum::LayLength, Table::Lay, "lay_length", "lay-length", Kind::Length, "Ply length of one turn of a strand").one_of(Group::Lay),
    key(Datum::LayRatio, Table::Lay, "lay_ratio", "lay-ratio", Kind::Number, "Lay length over the outer diameter of the ply").one_of(Group::Lay),
    key(Datum::PlyTurnsPerLength, Table::Lay, "turns_per_length", "ply-turns-per-length", Kind::TurnsPerLength, "Turns of the ply per ply length; right-handed positive").one_of(Group::Lay),
    key(Datum::RadiusRatio, Table::Lay, "radius_ratio", "radius-ratio", Kind::Number, "Helix radius of the strands over the strand radius, R/r").one_of(Group::Lay),
    key(Datum::HelixRadius, Table::Lay, "helix_radius", "helix-radius", Kind::Length, "Radius R of the helix of the strands' centrelines; beside another lay, it gives the strand's size"),
    key(Datum::CoreRadius, Table::Lay, "core_radius", "core-radius", Kind::Length, "Radius of a core that touching strands do lie on (this gives the shape), R = core radius + r").one_of(Group::Lay),
    key(Datum::CoreDiameter, Table::Lay, "core_diameter", "core-diameter", Kind::Length, "Diameter of a core that touching strands do lie on (this gives the shape)").one_of(Group::Lay),

    key(Datum::FormedHelicalAngle, Table::Formed, "helical_angle", "formed-helical-angle", Kind::Angle, "Lay angle in which the ply was made: its core is free of stress there").one_of(Group::Formed),
    key(Datum::FormedLayLength, Table::Formed, "lay_length", "formed-lay-length", Kind::Length, "The same, by its lay length").one_of(Group::Formed),
    key(Datum::FormedRadiusRatio, Table::Formed, "radius_ratio", "formed-radius-ratio", Kind::Number, "R/r in which the ply was made; the least there is, on the core or on neighbours, if absent"),
    key(Datum::FormedHand, Table::Formed, "hand", "formed-hand", Kind::Hand, "Which way the ply was laid: right (Z), as if absent, or left (S)"),
    key(Datum::Preforming, Table::Formed, "preforming", "preforming", Kind::Number, "How far strands were bent to this lay beforehand: 0 straight, as if absent, to 1 free of stress in it"),

    key(Datum::Force, Table::Load, "force", "force", Kind::Force, "End force on the ply, tension positive"),
    key(Datum::Moment, Table::Load, "moment", "moment", Kind::Moment, "End moment on the ply, right-handed positive"),
    key(Datum::ExternalPressure, Table::Load, "external_pressure", "external-pressure", Kind::ForcePerLength, "Radial force per strand length from outside, outward positive"),
    key(Datum::Separation, Table::Load, "separation", "separation", Kind::Switch, "Find the load at which the strands just stop pressing on each other"),

    key(Datum::PlyRotation, Table::Ends, "rotation", "ply-rotation", Kind::Angle, "Angle the ply's end is turned by and held at, from straight strands on; right-handed positive").one_of(Group::Ends),
    key(Datum::PlyTurns, Table::Ends, "turns", "ply-turns", Kind::Turns, "The same in turns: 12 turns lay the strands 12 times round").one_of(Group::Ends),
    key(Datum::PlyTurnsPerStrandLength, Table::Ends, "turns_per_strand_length", "ply-turns-per-strand-length", Kind::TurnsPerLength, "The same in turns per strand length").one_of(Group::Ends),
    key(Datum::PlyLength, Table::Ends, "length", "ply-length", Kind::Length, "Length the ply is held at, less than the strand length").one_of(Group::Ends),
    key(Datum::LengthRatio, Table::Ends, "length_ratio", "length-ratio", Kind::Number, "The same over the strand length, between 0 and 1").one_of(Group::Ends),

    key(Datum::SupportCoreRadius, Table::Support, "core_radius", "support-core-radius", Kind::Length, "Radius of a core that strands may lie on or lift off from (whether they do is found)").one_of(Group::Support),
    key(Datum::SupportCoreDiameter, Table::Support, "core_diameter", "support-core-diameter", Kind::Length, "Diameter of a core that strands may lie on or lift off from (whether they do is found)").one_of(Group::Support),
    key(Datum::SupportCoreYoungsModulus, Table::Support, "core_youngs_modulus", "support-core-youngs-modulus", Kind::Pressure, "Young's modulus of a solid round core that works along with strands that stretch").one_of(Group::CoreAxial),
    key(Datum::SupportCorePoissonsRatio, Table::Support, "core_poissons_ratio", "support-core-poissons-ratio", Kind::Number, "Poisson's ratio of the core, by which it thins; the strands' if absent"),
    key(Datum::SupportCoreAxialStiffness, Table::Support, "core_axial_stiffness", "support-core-axial-stiffness", Kind::Force, "Stiffness EA of the core, where it is not solid and round").one_of(Group::CoreAxial),
    key(Datum::SupportCoreTorsionalStiffness, Table::Support, "core_torsional_stiffness", "support-core-torsional-stiffness", Kind::Stiffness, "Stiffness GJ of the core; 0 if absent").one_of(Group::CoreTorsion),
];

/// The name among `known` that is nearest to what was written, if it is near enough to have been meant.
pub(crate) fn nearest<'n>(written: &str, known: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    // no slip of the hand, and a megabyte of it would take its time
    if written.len() > 100 {
        return None;
    }
    let lower = written.to_lowercase().replace('-', "_");
    let enough = (written.chars().count() / 3).max(1);
    known
        .map(|name| (strsim::damerau_levenshtein(&lower, &name.replace('-', "_")), name))
        .filter(|(distance, _)| *distance <= enough)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_key_stands_once_in_the_list() {
        for (at, key) in KEYS.iter().enumerate() {
            for other in &KEYS[at + 1..] {
                assert_ne!(key.datum, other.datum);
                assert_ne!(key.flag, other.flag);
                assert_ne!((key.table, key.name), (other.table, other.name));
            }
        }
    }

    #[test]
    fn a_flag_is_its_key_with_dashes_but_where_two_keys_share_a_name() {
        for key in &KEYS {
            let same = key.name.replace('_', "-");
            match key.datum {
                Datum::StrandLength => assert_eq!(key.flag, "strand-length"),
                Datum::PlyTurnsPerLength => assert_eq!(key.flag, "ply-turns-per-length"),
                Datum::PlyRotation | Datum::PlyTurns | Datum::PlyTurnsPerStrandLength | Datum::PlyLength => {
                    assert_eq!(key.flag, format!("ply-{same}"));
                }
                _ if key.table == Table::Support => assert_eq!(key.flag, format!("support-{same}")),
                Datum::Preforming => assert_eq!(key.flag, "preforming"),
                _ if key.table == Table::Formed => assert_eq!(key.flag, format!("formed-{same}")),
                _ => assert_eq!(key.flag, same),
            }
        }
    }

    #[test]
    fn only_what_is_near_is_proposed() {
        let names = || KEYS.iter().map(|key| key.name);
        assert_eq!(nearest("pretwst", names()), Some("pretwist"));
        assert_eq!(nearest("Young-modulus", names()), Some("youngs_modulus"));
        assert_eq!(nearest("colour", names()), None);
        assert_eq!(nearest("", names()), None);
        let long: &'static str = "pretwist".repeat(20).leak();
        assert_eq!(nearest(long, core::iter::once(long)), None);
    }
}
