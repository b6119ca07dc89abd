//! What is said of strands that stretch: the numbers of a state, and what a reader should know.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use nply::Handedness;
use nply::mechanics::{
    Axial, Clamped, ExtensibleState, Grips, Stability, StretchStiffness, Support, Turning, Twist, WireStress,
};

use super::Measure;
use super::item::{Item, item};
use super::support::{Carried, Verdict};
use crate::solve::Supported;
use crate::{Case, Datum, Question, SpecError};

/// Young's modulus of a strand that is a solid round wire, in B/r⁴: 4/π. None for others, of whose section nothing is known.
fn modulus(state: &ExtensibleState) -> Option<f64> {
    const SOLID: f64 = 4.0;
    let solid = (state.ply().strand().axial_stiffness() - SOLID).abs() < 1e-9;
    solid.then_some(1.0 / FRAC_PI_4)
}

/// The same of a core that is solid and round: one whose EA and GJ go together with its Poisson's ratio.
fn core_modulus(state: &ExtensibleState) -> Option<f64> {
    let core = state.ply().core()?;
    let (area, nu) = (PI * core.radius() * core.radius(), core.poissons_ratio());
    let modulus = core.axial_stiffness() / area;
    let polar = 0.5 * area * core.radius() * core.radius();
    let torsional = modulus / (2.0 * (1.0 + nu)) * polar;
    let solid = modulus > 0.0 && (core.torsional_stiffness() - torsional).abs() <= 1e-9 * torsional;
    solid.then_some(modulus)
}

fn strand_stress(state: &ExtensibleState, part: fn(&WireStress) -> f64) -> Option<f64> {
    Some(modulus(state)? * part(&state.strand_stress()))
}

fn core_stress(state: &ExtensibleState, part: fn(&WireStress) -> f64) -> Option<f64> {
    Some(core_modulus(state)? * part(&state.core_stress()?))
}

fn stiffness(state: &ExtensibleState, part: fn(&StretchStiffness) -> f64) -> Option<f64> {
    state.stiffness().as_ref().map(part)
}

/// Cross-sections of solid strands, and of a core that is solid, in r²; what a rope maker divides its stiffness by.
fn metal(state: &ExtensibleState) -> Option<f64> {
    let core = match state.ply().core() {
        Some(core) if core_modulus(state).is_some() => PI * core.radius() * core.radius(),
        Some(core) if core.axial_stiffness() > 0.0 => return None,
        _ => 0.0,
    };
    modulus(state).map(|_| PI * f64::from(state.ply().strands()) + core)
}

const STATE: &[Item<ExtensibleState>] = {
    use Measure::{
        AnglePerMoment, Degrees, Force, ForcePerLength, Length, Moment, Number, Stiffness, Stress, TurnsPerLength,
    };
    const SHAPE: &str = "Shape";
    const TWIST: &str = "Twist";
    const LOADS: &str = "Loads and contacts";
    const STRAIN: &str = "Strains and stresses";
    const RESPONSE: &str = "Stiffness about this state";
    const ENERGY: &str = "Energy per unstretched strand length";
    &[
        item(SHAPE, "helical_angle_deg", "helical angle (lay angle)", Degrees, |s| Some(s.angle().degrees())),
        item(SHAPE, "pitch_angle_deg", "pitch angle", Degrees, |s| Some(s.angle().pitch_angle().to_degrees())),
        item(SHAPE, "lay_length", "lay length", Length, |s| Some(s.lay_length())),
        item(SHAPE, "turns_per_strand_length", "turns per strand length", TurnsPerLength, |s| {
            Some(s.rotation().abs() / TAU)
        }),
        item(SHAPE, "radius_ratio", "helix radius/strand radius", Number, |s| Some(s.radius_ratio())),
        item(SHAPE, "thickness", "strand radius, stretched/unstretched", Number, |s| Some(s.thickness())),
        item(SHAPE, "outer_diameter", "outer diameter", Length, |s| Some(2.0 * s.outer_radius())),
        item(SHAPE, "neighbour_gap", "gap between neighbours", Length, |s| Some(s.neighbour_gap())),
        item(SHAPE, "core_gap", "gap to the core", Length, ExtensibleState::core_gap),
        item(SHAPE, "stretched_core_radius", "", Length, ExtensibleState::core_radius),
        item(SHAPE, "extension", "ply length/strand length", Number, |s| Some(s.extension())),
        item(SHAPE, "rotation", "", Number, |s| Some(s.rotation())),
        item(TWIST, "strand_twist", "strand twist r u₃", Number, |s| Some(s.strand_twist())),
        item(TWIST, "strand_twist_per_length", "strand twist per strand length", TurnsPerLength, |s| {
            Some(s.strand_twist() / TAU)
        }),
        item(LOADS, "force", "end force (tension +)", Force, |s| Some(s.load().force)),
        item(LOADS, "moment", "end moment (right-handed +)", Moment, |s| Some(s.load().moment)),
        item(LOADS, "core_force", "of the force, the core's", Force, |s| s.ply().core().map(|_| s.core_force())),
        item(LOADS, "core_moment", "of the moment, the core's", Moment, |s| s.ply().core().map(|_| s.core_moment())),
        item(LOADS, "interstrand_pressure", "pressure of each neighbour p₁", ForcePerLength, |s| {
            Some(s.interstrand_pressure())
        }),
        item(LOADS, "core_pressure", "pressure of the core p_c", ForcePerLength, |s| {
            s.ply().core().map(|_| s.core_pressure())
        }),
        item(LOADS, "neighbour_line_load", "line load between neighbours", ForcePerLength, |s| {
            Some(s.neighbour_line_load())
        }),
        item(LOADS, "core_line_load", "line load on the core", ForcePerLength, |s| {
            s.ply().core().map(|_| s.core_line_load())
        }),
        item(STRAIN, "strain", "strain of a strand", Number, |s| Some(s.strain())),
        item(STRAIN, "bending_strain", "strain by bending, outer fibre (below 0: inner pulled)", Number, |s| {
            Some(s.bending())
        }),
        item(STRAIN, "strand_stress", "greatest pull in a strand", Stress, |s| strand_stress(s, WireStress::greatest)),
        item(STRAIN, "strand_shear_stress", "shear by twist in a strand", Stress, |s| strand_stress(s, |w| w.twist)),
        item(STRAIN, "strand_equivalent_stress", "von Mises' stress in a strand", Stress, |s| {
            strand_stress(s, WireStress::equivalent)
        }),
        item(STRAIN, "core_stress", "pull in the core", Stress, |s| core_stress(s, WireStress::greatest)),
        item(STRAIN, "core_equivalent_stress", "von Mises' stress in the core", Stress, |s| {
            core_stress(s, WireStress::equivalent)
        }),
        item(STRAIN, "neighbour_hertz_pressure", "Hertz pressure between neighbours", Stress, |s| {
            Some(modulus(s)? * s.neighbour_hertz_pressure()?)
        }),
        item(STRAIN, "core_hertz_pressure", "Hertz pressure on the core, as of one material", Stress, |s| {
            Some(modulus(s)? * s.core_hertz_pressure()?)
        }),
        item(RESPONSE, "axial_stiffness", "EA, ends cannot turn", Force, |s| stiffness(s, |k| k.axial)),
        item(RESPONSE, "axial_torsional_coupling", "coupling", Moment, |s| stiffness(s, |k| k.coupling)),
        item(RESPONSE, "torsional_stiffness", "GJ, length held", Stiffness, |s| stiffness(s, |k| k.torsional)),
        item(RESPONSE, "axial_stiffness_free_ends", "EA, ends free to turn", Force, |s| {
            stiffness(s, StretchStiffness::axial_free)
        }),
        item(RESPONSE, "torsional_stiffness_free_length", "GJ, length free", Stiffness, |s| {
            stiffness(s, StretchStiffness::torsional_free)
        }),
        item(RESPONSE, "modulus", "modulus, ends cannot turn", Stress, |s| {
            Some(stiffness(s, |k| k.axial)? / metal(s)?)
        }),
        item(RESPONSE, "modulus_free_ends", "modulus, ends free to turn", Stress, |s| {
            Some(stiffness(s, StretchStiffness::axial_free)? / metal(s)?)
        }),
        item(RESPONSE, "torque_factor", "torque factor dM/(dF d), d the outer diameter", Number, |s| {
            Some(stiffness(s, StretchStiffness::moment_by_force)? / (2.0 * s.outer_radius()))
        }),
        item(RESPONSE, "rotation_per_length_per_force", "turning per length per force", AnglePerMoment, |s| {
            stiffness(s, StretchStiffness::rotation_by_force)
        }),
        item(ENERGY, "stretch_energy", "stretch", Force, |s| Some(s.energy().stretch)),
        item(ENERGY, "bending_energy", "bending", Force, |s| Some(s.energy().bending)),
        item(ENERGY, "torsion_energy", "torsion", Force, |s| Some(s.energy().torsion)),
        item(ENERGY, "core_energy", "core, per strand", Force, |s| s.ply().core().map(|_| s.energy().core)),
        item(ENERGY, "load_energy", "end loads", Force, |s| Some(s.energy().loads)),
        item(ENERGY, "total_energy", "total", Force, |s| Some(s.energy().total())),
    ]
};

const VERDICTS: &[Verdict<ExtensibleState>] = &[
    ("dead_loads", "under dead loads", |s| Some(s.stability(Clamped::default()))),
    ("rotation_held", "ends cannot turn", |s| Some(s.stability(Clamped { length: false, rotation: true }))),
    ("length_held", "length held", |s| Some(s.stability(Clamped { length: true, rotation: false }))),
    ("both_held", "length and rotation held", |s| Some(s.stability(Clamped { length: true, rotation: true }))),
    ("strand_twist_held", "strand twist held", |s| {
        let given = matches!(s.twist(), Twist::Pretwist(_));
        given.then(|| s.with_strand_twist_held().stability(Clamped::default()))
    }),
];

impl Carried for ExtensibleState {
    const NUMBERS: &'static [Item<Self>] = STATE;
    const VERDICTS: &'static [Verdict<Self>] = VERDICTS;

    fn hand(&self) -> Handedness {
        self.handedness()
    }

    fn carried_by(&self) -> Support {
        self.support()
    }

    fn radians(&self) -> f64 {
        self.angle().radians()
    }
}

/// What is given at the ends, by name.
pub(super) fn held(grips: Grips) -> Vec<(&'static str, f64)> {
    let along = match grips.axial {
        Axial::Force(force) => ("force", force),
        Axial::Extension(extension) => ("extension", extension),
    };
    let around = match grips.turning {
        Turning::Moment(moment) => ("moment", moment),
        Turning::Rotation(rotation) => ("rotation", rotation),
    };
    vec![along, around]
}

/// Refuses strands that stretch where they are not known.
pub(super) fn not_here(case: &Case, what: &str) -> SpecError {
    case.refuse(
        |entry| entry.key.datum == Datum::Stretch,
        |said| format!("{said} goes with `nply support`, `nply solve` and `nply trace`, and {what} knows only strands that do not stretch: remove it"),
    )
}

/// What a reader should know, a sentence each.
pub(super) fn notes(case: &Case, stretched: &Supported<ExtensibleState>) -> Vec<String> {
    let Question::Stretched { ply, .. } = case.question else { return Vec::new() };
    let states = &stretched.states;
    let mut notes = Vec::new();
    let mut say = |holds: bool, note: &str| {
        if holds {
            notes.push(note.to_owned());
        }
    };
    say(
        states.is_empty(),
        "No state of helical strands (straight ones may still hang in equilibrium): neither neighbours nor a core can hold helical strands under these data, nor do they stand free, with strains \
         between -1/2 and 1; the ply runs away or snaps into a shape that is no uniform helix.",
    );
    say(
        ply.core().is_some_and(|core| core.axial_stiffness() == 0.0),
        "The core only keeps the strands out: it carries nothing and does not thin. Give its Young's modulus, or its stiffness, if \
         it works along.",
    );
    say(
        ply.strand().poissons_ratio() == 0.0,
        "Strands do not thin as they stretch: no Poisson's ratio is given for that.",
    );
    say(
        states.iter().any(|s| modulus(s).is_none()),
        "Stresses are those of solid round strands, and none are given: these strands have a stiffness EA of their own.",
    );
    say(
        !states.is_empty(),
        "Contacts are without friction, strands and core are linearly elastic; stresses beyond the yield point say that it is passed, not \
         what happens then.",
    );
    say(
        states.iter().any(|s| s.stability(Clamped::default()) == Stability::Stable),
        "Stable means among uniform plies of equal helices with the given twist held (or the strands' torque, where it says so); buckling \
         as a whole, local loops and the collapse of a hole are not covered.",
    );
    notes
}
