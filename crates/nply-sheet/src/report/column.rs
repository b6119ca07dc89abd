//! Everything a report says of a state, in one list: text, JSON and CSV are made from it.

use core::f64::consts::TAU;

use nply::mechanics::{Equilibrium, Stiffness};

use super::Measure;

/// The part of the report in which a quantity stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Section {
    /// Angles, radii, lay.
    Shape,
    /// Twist of the strands.
    Twist,
    /// The ledger of link, of all strands together.
    Link,
    /// End loads and what presses between strands.
    Loads,
    /// How far loads, turns and pretwist can change.
    Margin,
    /// Energies.
    Energy,
    /// What the ply does when loads change.
    Response,
    /// When the ply buckles as a whole.
    Buckling,
}

impl Section {
    /// All, in the order of the report.
    pub(super) const ALL: [Self; 8] =
        [Self::Shape, Self::Twist, Self::Link, Self::Loads, Self::Margin, Self::Energy, Self::Response, Self::Buckling];

    /// The heading.
    #[must_use]
    pub const fn heading(self) -> &'static str {
        match self {
            Self::Shape => "Shape",
            Self::Twist => "Twist",
            Self::Link => "Link, all strands together: put in = twist + writhe",
            Self::Loads => "Loads and contact",
            Self::Margin => "Margin to separation and other limits",
            Self::Energy => "Energy of one strand, per strand length",
            Self::Response => "Response to a change of load",
            Self::Buckling => "Buckling of the ply as a whole, hinged ends",
        }
    }
}

/// One reported quantity.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Column {
    /// Its name in JSON and CSV.
    pub name: &'static str,
    /// Its name for a reader; empty for what a reader's table leaves out.
    pub label: &'static str,
    /// Where it stands.
    pub section: Section,
    /// Its kind of number.
    pub measure: Measure,
    /// Its dimensionless value; `None` where it has none, such as a flexibility at a fold.
    pub value: fn(&Equilibrium) -> Option<f64>,
}

const fn column(
    section: Section,
    name: &'static str,
    label: &'static str,
    measure: Measure,
    value: fn(&Equilibrium) -> Option<f64>,
) -> Column {
    Column { name, label, section, measure, value }
}

fn stiffness(state: &Equilibrium, part: fn(Stiffness) -> f64) -> Option<f64> {
    state.stiffness().map(part)
}

fn published(state: &Equilibrium, part: fn(Stiffness) -> f64) -> Option<f64> {
    state.stiffness_as_published().map(part)
}

fn flexibility(state: &Equilibrium, row: usize, column: usize) -> Option<f64> {
    state.flexibility().map(|matrix| matrix[row][column])
}

fn flexibility_published(state: &Equilibrium, row: usize, column: usize) -> Option<f64> {
    state.flexibility_as_published().map(|matrix| matrix[row][column])
}

/// Every number of a state, in the order of the report.
pub const COLUMNS: &[Column] = {
    use Measure::{
        AnglePerForce, AnglePerMoment, Degrees, Force, ForcePerLength, Length, Moment, Number, PerLength, Percent,
        TurnsPerLength,
    };
    use Section::{Buckling, Energy, Link, Loads, Response, Shape, Twist};
    &[
        column(Shape, "helical_angle_deg", "helical angle (lay angle)", Degrees, |s| {
            Some(s.contact().angle().degrees())
        }),
        column(Shape, "pitch_angle_deg", "pitch angle", Degrees, |s| Some(s.contact().pitch_angle().to_degrees())),
        column(Shape, "lay_length", "lay length", Length, |s| Some(s.contact().lay_length())),
        column(Shape, "lay_ratio", "lay ratio (lay length/outer diameter)", Number, |s| Some(s.contact().lay_ratio())),
        column(Shape, "turns_per_ply_length", "turns per ply length", TurnsPerLength, |s| {
            Some(1.0 / s.contact().lay_length())
        }),
        column(Shape, "turns_per_strand_length", "turns per strand length", TurnsPerLength, |s| {
            Some(s.rotation().abs() / TAU)
        }),
        column(Shape, "radius_ratio", "helix radius/strand radius", Number, |s| Some(s.contact().radius_ratio())),
        column(Shape, "ply_radius", "helix radius", Length, |s| Some(s.contact().radius_ratio())),
        column(Shape, "outer_diameter", "outer diameter", Length, |s| Some(2.0 * s.contact().outer_radius())),
        column(Shape, "hole_radius", "hole radius", Length, |s| Some(s.contact().hole_radius())),
        column(Shape, "contact_line_radius", "contact line radius", Length, |s| {
            Some(s.contact().contact_line_radius())
        }),
        column(Shape, "arclength_shift", "arclength shift/helix radius", Number, |s| {
            Some(s.contact().arclength_shift())
        }),
        column(Shape, "extension", "ply length/strand length", Number, |s| Some(s.extension())),
        column(Shape, "rotation", "", Number, |s| Some(s.rotation())),
        column(Shape, "retraction_percent", "retraction", Percent, |s| Some(retraction(s))),
        column(Shape, "curvature", "curvature of a strand", PerLength, |s| Some(s.contact().curvature())),
        column(Shape, "torsion", "", PerLength, |s| Some(s.handedness().sign() * s.contact().torsion())),
        column(Twist, "pretwist", "pretwist (tan of the surface angle)", Number, |s| Some(s.pretwist())),
        column(Twist, "pretwist_per_length", "pretwist per strand length", TurnsPerLength, |s| {
            Some(s.pretwist() / TAU)
        }),
        column(Twist, "strand_twist", "strand twist r u₃", Number, |s| Some(s.strand_twist())),
        column(Twist, "strand_twist_per_length", "strand twist per strand length", TurnsPerLength, |s| {
            Some(s.strand_twist() / TAU)
        }),
        column(Link, "link_put_in", "put in, per strand length", TurnsPerLength, |s| Some(s.link().put_in)),
        column(Link, "link_twist", "twist, per strand length", TurnsPerLength, |s| Some(s.link().twist)),
        column(Link, "link_writhe", "writhe, per strand length", TurnsPerLength, |s| Some(s.link().writhe)),
        column(Loads, "force", "end force (tension +)", Force, |s| Some(s.load().force)),
        column(Loads, "moment", "end moment (right-handed +)", Moment, |s| Some(s.load().moment)),
        column(Loads, "resultant_pressure", "resultant pressure p", ForcePerLength, |s| Some(s.resultant_pressure())),
        column(Loads, "interstrand_pressure", "interstrand pressure p₁", ForcePerLength, |s| {
            Some(s.interstrand_pressure())
        }),
        column(Loads, "strand_axial_force", "", Force, |s| Some(s.strand_resultant().axial_force)),
        column(Loads, "strand_hoop_force", "", Force, |s| Some(s.strand_resultant().hoop_force)),
        column(Loads, "strand_axial_moment", "", Moment, |s| Some(s.strand_resultant().axial_moment)),
        column(Loads, "strand_hoop_moment", "", Moment, |s| Some(s.strand_resultant().hoop_moment)),
        column(Energy, "bending_energy", "bending", Force, |s| Some(s.energy().bending)),
        column(Energy, "torsion_energy", "torsion", Force, |s| Some(s.energy().torsion)),
        column(Energy, "pressure_energy", "", Force, |s| Some(s.energy().pressure)),
        column(Energy, "load_energy", "end loads", Force, |s| Some(s.energy().load)),
        column(Energy, "total_energy", "total", Force, |s| Some(s.energy().total())),
        column(Response, "angle_per_force", "helical angle per force", AnglePerForce, |s| Some(s.angle_slopes()?.0)),
        column(Response, "angle_per_moment", "helical angle per moment", AnglePerMoment, |s| Some(s.angle_slopes()?.1)),
        column(Response, "torsional_stiffness", "torsional stiffness C_ply", Measure::Stiffness, |s| {
            stiffness(s, |k| k.torsional)
        }),
        column(Response, "axial_stiffness", "axial stiffness K_ply", Force, |s| stiffness(s, |k| k.axial)),
        column(Response, "force_per_twist", "force per ply twist A_ply", Moment, |s| {
            stiffness(s, |k| k.force_per_twist)
        }),
        column(Response, "moment_per_extension", "moment per extension H_ply", Moment, |s| {
            stiffness(s, |k| k.moment_per_extension)
        }),
        column(Response, "torsional_stiffness_as_published", "", Measure::Stiffness, |s| published(s, |k| k.torsional)),
        column(Response, "axial_stiffness_as_published", "", Force, |s| published(s, |k| k.axial)),
        column(Response, "force_per_twist_as_published", "", Moment, |s| published(s, |k| k.force_per_twist)),
        column(Response, "moment_per_extension_as_published", "", Moment, |s| published(s, |k| k.moment_per_extension)),
        column(Response, "extension_per_force", "", Number, |s| flexibility(s, 0, 0)),
        column(Response, "extension_per_moment", "", Number, |s| flexibility(s, 0, 1)),
        column(Response, "rotation_per_force", "", Number, |s| flexibility(s, 1, 0)),
        column(Response, "rotation_per_moment", "", Number, |s| flexibility(s, 1, 1)),
        column(Response, "extension_per_force_as_published", "", Number, |s| flexibility_published(s, 0, 0)),
        column(Response, "extension_per_moment_as_published", "", Number, |s| flexibility_published(s, 0, 1)),
        column(Response, "rotation_per_force_as_published", "", Number, |s| flexibility_published(s, 1, 0)),
        column(Response, "rotation_per_moment_as_published", "", Number, |s| flexibility_published(s, 1, 1)),
        column(Response, "second_variation", "second variation of energy", Force, |s| s.second_variation()),
        column(Response, "balance_slope", "", Number, |s| Some(s.balance_slope())),
        column(Buckling, "bending_stiffness_sliding", "bending stiffness, strands sliding", Measure::Stiffness, |s| {
            Some(s.bending_bounds().sliding)
        }),
        column(
            Buckling,
            "bending_stiffness_locked",
            "bending stiffness, solid strands locked",
            Measure::Stiffness,
            |s| Some(s.bending_bounds().locked),
        ),
    ]
};

/// One quantity that needs the length of the strands besides the state.
#[derive(Clone, Copy, Debug)]
pub(super) struct LengthColumn {
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    pub(super) section: Section,
    pub(super) measure: Measure,
    /// Its dimensionless value, from the state and L/r.
    pub(super) value: fn(&Equilibrium, f64) -> Option<f64>,
}

/// Every number of a ply of known length, in the order of the report.
pub(super) const LENGTH_COLUMNS: &[LengthColumn] = {
    use Measure::{Force, Turns};
    use Section::{Buckling, Link};
    const fn column(
        section: Section,
        name: &'static str,
        label: &'static str,
        measure: Measure,
        value: fn(&Equilibrium, f64) -> Option<f64>,
    ) -> LengthColumn {
        LengthColumn { name, label, section, measure, value }
    }
    &[
        column(Link, "link_put_in_total", "put in, over the strand length", Turns, |s, length| {
            Some(s.link().put_in * length)
        }),
        column(Link, "link_twist_total", "twist, over the strand length", Turns, |s, length| {
            Some(s.link().twist * length)
        }),
        column(Link, "link_writhe_total", "writhe, over the strand length", Turns, |s, length| {
            Some(s.link().writhe * length)
        }),
        column(Buckling, "buckling_thrust_sliding", "thrust it buckles at, strands sliding", Force, |s, length| {
            Some(buckling_thrust(s, length)?[0])
        }),
        column(Buckling, "buckling_thrust_locked", "thrust it buckles at, solid strands locked", Force, |s, length| {
            Some(buckling_thrust(s, length)?[1])
        }),
    ]
};

/// What of the list holds for solid round strands alone.
pub(super) const OF_SOLID_STRANDS: [&str; 2] = ["bending_stiffness_locked", "buckling_thrust_locked"];

/// The two bounds on the thrust at which a state of strands of length L/r buckles as a whole, under its own moment. None where neighbours
/// would have to pull: such a ply has come apart, and is no column.
pub(super) fn buckling_thrust(state: &Equilibrium, strand_length: f64) -> Option<[f64; 2]> {
    // a pressure that is 0 but for rounding
    const NOTHING: f64 = 1e-14;
    if state.interstrand_pressure() < -NOTHING {
        return None;
    }
    state.bending_bounds().buckling_thrust(strand_length * state.extension(), state.load().moment).ok()
}

/// A quantity with its value in each state.
pub(super) struct Entry {
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    pub(super) section: Section,
    pub(super) measure: Measure,
    pub(super) values: Vec<Option<f64>>,
}

/// Both lists, of these states, by section; without a length, what needs it has no value.
pub(super) fn entries(states: &[Equilibrium], strand_length: Option<f64>) -> Vec<Entry> {
    let of_state = COLUMNS.iter().map(|column| {
        let Column { name, label, section, measure, .. } = *column;
        Entry { name, label, section, measure, values: states.iter().map(|state| column.of(state)).collect() }
    });
    let of_length = LENGTH_COLUMNS.iter().map(|column| {
        let LengthColumn { name, label, section, measure, value } = *column;
        let values = states.iter().map(|state| written(value(state, strand_length?))).collect();
        Entry { name, label, section, measure, values }
    });
    let mut entries: Vec<Entry> = of_state.chain(of_length).collect();
    entries.sort_by_key(|entry| entry.section);
    entries
}

/// What can be written as a number.
pub(super) fn written(value: Option<f64>) -> Option<f64> {
    // adding 0 takes the sign from a negative zero
    value.filter(|value| value.is_finite()).map(|value| value + 0.0)
}

/// How much shorter the ply is than its strands, in percent: 100 (1 − cos θ), regular for small angles.
fn retraction(state: &Equilibrium) -> f64 {
    let half = libm::sin(0.5 * state.contact().helical_angle());
    200.0 * half * half
}

impl Column {
    /// The value, if there is one and it can be written as a number.
    #[must_use]
    pub fn of(&self, state: &Equilibrium) -> Option<f64> {
        written((self.value)(state))
    }
}

#[cfg(test)]
mod tests {
    use super::entries;

    #[test]
    fn names_are_unique() {
        let entries = entries(&[], None);
        for (i, entry) in entries.iter().enumerate() {
            assert!(entries[..i].iter().all(|other| other.name != entry.name), "{}", entry.name);
        }
    }
}
