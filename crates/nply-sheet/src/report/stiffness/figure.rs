//! The one list of what is reported of a cable, of its core and of its layers.

use core::f64::consts::PI;
use core::ops::Deref;

use nply::Handedness;
use nply::mechanics::{Cable, CableGrips, CableState, LayerState, Rod};

use crate::Dimension;
use crate::report::figured::figure;

/// What sort of number it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Number,
    Percent,
    Degrees,
    Of(Dimension),
    /// A stress, which people read in a unit of their own beside that of the modulus.
    Stress,
    /// Turning per length per force: a twist over a force.
    Unlay,
}

/// One reported number.
pub(super) type Figure<T> = crate::report::figured::Figure<T, Sort>;

/// The cable under its loads, with the strands that its core and rods may be.
pub(super) struct Whole {
    pub(super) state: CableState,
    pub(super) strands: Vec<Option<Cable>>,
}

impl Deref for Whole {
    type Target = CableState;

    fn deref(&self) -> &CableState {
        &self.state
    }
}

/// One rod of the cable: its core, or a wire of a layer.
pub(super) struct Member {
    pub(super) state: CableState,
    /// `None`: the core
    pub(super) layer: Option<LayerState>,
    /// where it is a strand: that strand alone, strained and twisted as it is here
    pub(super) within: Option<CableState>,
}

const FORCE: Sort = Sort::Of(Dimension::FORCE);
const MOMENT: Sort = Sort::Of(Dimension::MOMENT);
const STIFFNESS: Sort = Sort::Of(Dimension::STIFFNESS);
const LENGTH: Sort = Sort::Of(Dimension::LENGTH);
const TURNING: Sort = Sort::Of(Dimension::ANGLE_PER_LENGTH);
const PRESSURE: Sort = Sort::Of(Dimension::PRESSURE);
const LINE: Sort = Sort::Of(Dimension::FORCE_PER_LENGTH);

const STATE: &str = "Loads and shape";
pub(super) const SMALL: &str = "Stiffness against small changes";
const STRENGTH: &str = "Strength";
const OPENS: &str = "Margin to birdcaging (what presses least lets go)";

#[rustfmt::skip] // a table: one row a line
pub(super) static OF_CABLE: [Figure<Whole>; 24] = [
    figure(STATE, "force", "force (tension +)", FORCE, |s| Some(s.force())),
    figure(STATE, "moment", "moment (right-handed +)", MOMENT, |s| Some(s.moment())),
    figure(STATE, "strain", "strain", Sort::Percent, |s| Some(s.strain())),
    figure(STATE, "turning", "turns put in (right-handed +)", TURNING, |s| Some(s.turning())),
    figure(STATE, "outer_diameter", "outer diameter", LENGTH, |s| Some(2.0 * s.outer_radius())),
    figure(STATE, "wire_section_area", "sections across each wire, the core's too unless of fibre", Sort::Of(Dimension::AREA), |s| Some(s.cable().wire_section_area())),
    figure(SMALL, "axial_stiffness", "EA, ends cannot turn", FORCE, |s| Some(s.stiffness()?.axial)),
    figure(SMALL, "axial_stiffness_free", "EA, ends free to turn", FORCE, |s| Some(s.stiffness()?.axial_free())),
    figure(SMALL, "modulus", "EA over these sections, ends cannot turn", PRESSURE, |s| Some(s.stiffness()?.axial / s.cable().wire_section_area())),
    figure(SMALL, "modulus_free", "EA over these sections, ends free to turn", PRESSURE, |s| Some(s.stiffness()?.axial_free() / s.cable().wire_section_area())),
    figure(SMALL, "torsional_stiffness", "GJ, length held", STIFFNESS, |s| Some(s.stiffness()?.torsional)),
    figure(SMALL, "torsional_stiffness_free", "GJ, length free to change", STIFFNESS, |s| Some(s.stiffness()?.torsional_free())),
    figure(SMALL, "coupling", "coupling: moment per strain, force per turning", MOMENT, |s| Some(s.stiffness()?.coupling)),
    figure(SMALL, "torque_factor", "torque factor: change of moment/(of force × outer diameter)", Sort::Number, |s| if s.stiffness().is_some() || s.shares() { s.torque_factor() } else { None }),
    figure(SMALL, "unlay", "turning per force, ends free to turn", Sort::Unlay, |s| Some(s.stiffness()?.rotation_by_force())),
    figure(SMALL, "contraction", "contraction of the outer diameter per strain", Sort::Number, |s| s.contraction()),
    figure(SMALL, "bending_stiffness_sliding", "bending stiffness, wires sliding freely", STIFFNESS, |s| Some(s.cable().sliding_bending_stiffness())),
    figure(STRENGTH, "metallic_breaking_load", "metallic breaking load: strength × section, summed", FORCE, |s| s.cable().metallic_breaking_load()),
    figure(STRENGTH, "force_at_strength", "a wire first reaches its strength at a force of, ends not turning", FORCE, force_at_strength),
    figure(OPENS, "lift_off_force", "at a force of, ends not turning", FORCE, |s| lift_off(s, true, CableState::force)),
    figure(OPENS, "lift_off_force_at_moment", "at a force of, under this moment", FORCE, |s| lift_off(s, false, CableState::force)),
    figure(OPENS, "lift_off_strain", "at a strain of, ends not turning", Sort::Percent, |s| lift_off(s, true, CableState::strain)),
    figure(OPENS, "lift_off_turning_left", "at turns put in of, turned to the left, under this force", TURNING, |s| Some(s.lift_off_by_turning(Handedness::Left)?.state.turning())),
    figure(OPENS, "lift_off_turning_right", "at turns put in of, turned to the right, under this force", TURNING, |s| Some(s.lift_off_by_turning(Handedness::Right)?.state.turning())),
];

const SHAPE: &str = "Core and layers";
const SHARE: &str = "What each carries";
const STRESS: &str = "Stress at the surface of a wire";
const PRESS: &str = "What presses";

#[rustfmt::skip] // a table: one row a line
pub(super) static OF_MEMBER: [Figure<Member>; 25] = [
    figure(SHAPE, "lay_angle", "lay angle", Sort::Degrees, |m| Some(m.layer?.angle.degrees())),
    figure(SHAPE, "lay_radius", "lay radius", LENGTH, |m| Some(m.layer?.radius)),
    figure(SHAPE, "wire_gap", "gap between neighbours", LENGTH, |m| Some(m.layer?.gap)),
    figure(SHAPE, "wire_strain", "strain of a wire", Sort::Percent, |m| Some(m.layer.map_or(m.state.strain(), |l| l.strain))),
    figure(SHAPE, "wire_tension", "pull that would strain a wire alone so", FORCE, |m| Some(m.layer?.tension())),
    figure(SHAPE, "wire_twist", "turns put into a wire, per its length", TURNING, |m| Some(m.layer?.twist())),
    figure(SHARE, "force_share", "force", FORCE, force),
    figure(SHARE, "force_fraction", "share of the force", Sort::Percent, |m| Some(force(m)? / loaded(m.state.force(), m)?)),
    figure(SHARE, "moment_share", "moment", MOMENT, moment),
    figure(STRESS, "stress_stretch", "from stretch", Sort::Stress, |m| Some(stress(m)?.stretch)),
    figure(STRESS, "stress_pressure", "along a core, from the pressure on it", Sort::Stress, |m| if m.layer.is_none() { Some(stress(m)?.pressure) } else { None }),
    figure(STRESS, "stress_bending", "from bending", Sort::Stress, |m| Some(stress(m)?.bending)),
    figure(STRESS, "stress_twist", "shear from twist", Sort::Stress, |m| Some(stress(m)?.twist)),
    figure(STRESS, "stress_greatest", "stretch, pressure and bending, greatest", Sort::Stress, greatest),
    figure(STRESS, "stress_equivalent", "equivalent (von Mises), greatest", Sort::Stress, |m| Some(stress(m)?.equivalent())),
    figure(STRESS, "strength_used", "stretch, pressure and bending, of the tensile strength", Sort::Percent, strength_used),
    figure(PRESS, "pressure_on_core", "on the core, evenly spread", Sort::Stress, |m| if m.layer.is_none() { m.state.pressure_on_core() } else { None }),
    figure(PRESS, "pressure_below", "force of a wire on what is below, per cable length", LINE, |m| Some(m.layer?.pressure_below)),
    figure(PRESS, "interstrand_pressure", "force between neighbours, per cable length", LINE, |m| Some(m.layer?.interstrand_pressure)),
    figure(PRESS, "core_line_load", "line load on the core", LINE, |m| m.layer?.core_line_load),
    figure(PRESS, "core_hertz_pressure", "Hertz pressure on the core", Sort::Stress, |m| m.layer?.core_hertz_pressure),
    figure(PRESS, "neighbour_line_load", "line load between neighbours", LINE, |m| m.layer?.neighbour_line_load),
    figure(PRESS, "neighbour_hertz_pressure", "Hertz pressure between neighbours", Sort::Stress, |m| m.layer?.neighbour_hertz_pressure),
    figure("", "youngs_modulus", "", PRESSURE, modulus),
    figure("", "section_area", "", Sort::Of(Dimension::AREA), |m| Some(PI * radius(m)? * radius(m)?)),
];

/// The core, if there is one, and a wire of each layer from the inside, with the strands that these are.
pub(super) fn members(state: &CableState, strands: &[Option<Cable>]) -> Vec<Member> {
    let core = state.cable().core().map(|_| None);
    let layers = state.layers().iter().map(|layer| Some(*layer));
    let within = |at: usize, layer: Option<LayerState>| {
        let [strain, turning] = layer.map_or([state.strain(), state.turning()], |layer| [layer.strain, layer.twist()]);
        strands.get(at)?.as_ref()?.loaded(CableGrips::Clamped { strain, turning }).ok()
    };
    let all = core.into_iter().chain(layers).enumerate();
    all.map(|(at, layer)| Member { state: state.clone(), layer, within: within(at, layer) }).collect()
}

/// The rod that it is one of.
fn rod(m: &Member) -> Option<Rod> {
    m.layer.map_or(m.state.cable().core(), |layer| Some(layer.layer.rod))
}

/// Stretch, pressure and bending where it is pulled most: of a solid wire, or of all the wires of a strand. These slide freely, and are bent as far as the strand is.
fn greatest(m: &Member) -> Option<f64> {
    over_wires(m, |wire, bent| Some(stress(wire)?.pull() + modulus(wire)? * radius(wire)? * bent))
}

/// How much of its tensile strength that is, of the wire that uses most; `None` where a strength is not known.
pub(super) fn strength_used(m: &Member) -> Option<f64> {
    over_wires(m, |wire, bent| {
        let (stress, rod) = (stress(wire)?, rod(wire)?);
        let pull = stress.pull() + modulus(wire)? * radius(wire)? * bent;
        Some(pull * rod.area() / rod.breaking_load()?)
    })
}

/// The greatest of something over the wires of a strand that count as metal, told with the change of the strand's own curvature; of a solid wire, its own.
/// `None` where it is not known of one of them.
fn over_wires(m: &Member, of: impl Fn(&Member, f64) -> Option<f64>) -> Option<f64> {
    let Some(strand) = &m.within else { return of(m, 0.0) };
    let bent = m.layer.map_or(0.0, |layer| layer.bending_strain.abs() / layer.layer.rod.radius());
    let wires = members(strand, &[]).into_iter().filter(is_counted);
    let mut values = wires.map(|wire| of(&wire, bent));
    values.try_fold(f64::NEG_INFINITY, |most, value| Some(most.max(value?)))
}

/// Whether it counts as metal.
pub(super) fn is_counted(m: &Member) -> bool {
    rod(m).is_some_and(|rod| rod.area() > 0.0)
}

/// The force at which, with ends that do not turn from here, a wire first reaches its tensile strength, be it a wire of a strand. `None`
/// unless the strength of all that counts as wire is known.
fn force_at_strength(s: &Whole) -> Option<f64> {
    let at = |strain: f64| s.cable().loaded(CableGrips::Clamped { strain, turning: s.turning() }).ok();
    let most_used = |state: &CableState| {
        let mut used = members(state, &s.strands).into_iter().filter(is_counted).map(|m| strength_used(&m));
        used.try_fold(0.0, |most: f64, used| Some(most.max(used?)))
    };
    // from no strain up to where it is passed, then halved until nothing is left to halve
    let mut high = 1e-4;
    while most_used(&at(high)?)? < 1.0 {
        high *= 2.0;
    }
    let mut low = 0.0;
    if most_used(&at(low)?)? >= 1.0 {
        return None; // laid so, it has no strength left
    }
    while 0.5 * (low + high) > low && 0.5 * (low + high) < high {
        let middle = 0.5 * (low + high);
        if most_used(&at(middle)?)? < 1.0 { low = middle } else { high = middle }
    }
    Some(at(high)?.force())
}

/// A number of the state in which the first contact lets go, 0 where it is nothing but rounding.
fn lift_off(s: &CableState, ends_cannot_turn: bool, of: impl Fn(&CableState) -> f64) -> Option<f64> {
    let state = s.lift_off(ends_cannot_turn)?.state;
    let unloaded = state.force().abs() <= 1e-12 * s.stiffness()?.axial;
    Some(if unloaded { 0.0 } else { of(&state) })
}

fn force(m: &Member) -> Option<f64> {
    m.layer.map_or(m.state.core_force(), |layer| Some(layer.force))
}

fn moment(m: &Member) -> Option<f64> {
    m.layer.map_or(m.state.core_moment(), |layer| Some(layer.moment))
}

/// A load that is more than rounding.
fn loaded(force: f64, m: &Member) -> Option<f64> {
    let least = 1e-12 * m.state.stiffness()?.axial;
    Some(force).filter(|force| force.abs() > least)
}

/// As made: strains and stresses are over sections as made.
fn radius(m: &Member) -> Option<f64> {
    Some(rod(m)?.radius())
}

pub(super) fn modulus(m: &Member) -> Option<f64> {
    rod(m)?.youngs_modulus()
}

/// Stresses of a solid round wire, or of a core that is one.
pub(super) struct Stress {
    pub(super) stretch: f64,
    /// Of a core, along it: held at its strain, what presses on it from the sides pushes it as 2ν times that pressure. With the stretch it is the
    /// force in the core over its section.
    pub(super) pressure: f64,
    pub(super) bending: f64,
    pub(super) twist: f64,
    /// Of a core, across it: what presses on its sides, evenly spread.
    sides: f64,
}

impl Stress {
    /// Along the wire, where it is pulled most.
    fn pull(&self) -> f64 {
        self.stretch + self.pressure + self.bending
    }

    /// The greatest by von Mises, of what is along the wire, the pressure from the sides and the shear: alike from all sides and along it, a pressure is none.
    pub(super) fn equivalent(&self) -> f64 {
        let along = (self.stretch + self.pressure + self.sides).abs() + self.bending;
        libm::sqrt(along * along + 3.0 * self.twist * self.twist)
    }
}

pub(super) fn stress(m: &Member) -> Option<Stress> {
    let modulus = modulus(m)?;
    Some(match m.layer {
        Some(layer) => {
            let shear = 0.5 / (1.0 + layer.layer.rod.poissons_ratio());
            Stress {
                stretch: modulus * layer.strain,
                pressure: 0.0,
                bending: modulus * layer.bending_strain.abs(),
                twist: modulus * shear * layer.twist_strain.abs(),
                sides: 0.0,
            }
        }
        None => {
            let core = m.state.cable().core()?;
            let shear = 0.5 / (1.0 + core.poissons_ratio());
            let sides = m.state.pressure_on_core().unwrap_or(0.0);
            let thinned = m.state.core_radius()? / core.radius();
            Stress {
                stretch: modulus * m.state.strain(),
                pressure: -2.0 * core.poissons_ratio() * sides * thinned,
                bending: 0.0,
                twist: modulus * shear * core.radius() * m.state.turning().abs(),
                sides,
            }
        }
    })
}
