//! A cable under load.

use super::deformed::Deformed;
use super::layer::LayerSupport;
use super::shared::Sharing;
use super::{Cable, Layer, Rod};
use crate::geometry::HelicalAngle;
use crate::mechanics::StretchStiffness;
use crate::mechanics::line_contact::{WireSurface, hertz_pressure, inward_to_neighbour};
use crate::numerics::jet::Jet;
use crate::numerics::jet2::Jet2;
use crate::{DomainError, Handedness};

/// How the ends of a cable are held: the force is given, and either the moment or the turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableGrips {
    /// A dead force and a dead moment; a swivel has moment 0.
    Loads {
        /// Tension positive.
        force: f64,
        /// Right-handed positive.
        moment: f64,
    },
    /// A dead force, and turns put in from the lay as made: rad per cable length; 0 for ends that cannot turn.
    Turned {
        /// Tension positive.
        force: f64,
        /// Right-handed positive.
        turning: f64,
    },
    /// Both displacements.
    Clamped {
        /// Of the cable's axis.
        strain: f64,
        /// rad per cable length, right-handed positive.
        turning: f64,
    },
}

impl CableGrips {
    /// Newton's step from a state towards one under these loads.
    fn step_from(self, state: &CableState) -> [f64; 2] {
        let StretchStiffness { axial, coupling, torsional } = state.unchecked_stiffness();
        match self {
            Self::Loads { force, moment } => {
                let (df, dm) = (force - state.force(), moment - state.moment());
                let determinant = axial * torsional - coupling * coupling;
                [(torsional * df - coupling * dm) / determinant, (axial * dm - coupling * df) / determinant]
            }
            Self::Turned { force, .. } => [(force - state.force()) / axial, 0.0],
            Self::Clamped { strain, turning } => [strain - state.strain, turning - state.turning],
        }
    }
}

/// One layer of a loaded cable.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LayerState {
    /// The layer as it was given.
    pub layer: Layer,
    /// What carries it.
    pub support: LayerSupport,
    /// Lay radius.
    pub radius: f64,
    /// Lay angle.
    pub angle: HelicalAngle,
    /// Strain of a rod's centreline.
    pub strain: f64,
    /// Change of curvature times the rod's radius: strain of its outer fibre by bending.
    pub bending_strain: f64,
    /// Change of twist times the rod's radius, right-handed positive.
    pub twist_strain: f64,
    /// What of the cable's force is carried in this layer.
    pub force: f64,
    /// What of the cable's moment is carried in this layer.
    pub moment: f64,
    /// Radial force on what is below per rod and cable length, as made; 0 where neighbours carry. Negative: it would have to be held down.
    pub pressure_below: f64,
    /// Contact force between neighbours per cable length, as made; 0 with gaps. Negative: they would have to be held together.
    pub interstrand_pressure: f64,
    /// Least distance between the surfaces of neighbours.
    pub gap: f64,
    /// Where the innermost layer lies along a core, each rod: force per length of the line of contact. Layers that cross those below touch them in
    /// points, of which nothing is said.
    pub core_line_load: Option<f64>,
    /// The greatest pressure there, by Hertz, of solid wires on a solid core.
    pub core_hertz_pressure: Option<f64>,
    /// Force between neighbours per length of the line along which they touch.
    pub neighbour_line_load: Option<f64>,
    /// The greatest pressure there, by Hertz, of solid wires.
    pub neighbour_hertz_pressure: Option<f64>,
}

impl LayerState {
    /// The pull that would strain one rod alone so, at this twist: EA × its strain, and of a strand its coupling × its twist. In the cable it carries
    /// a little less, its part of the force over cos θ: what presses on its sides stretches it as well.
    #[must_use]
    pub fn tension(&self) -> f64 {
        let rod = self.layer.rod;
        rod.axial_stiffness() * self.strain + rod.coupling() * self.twist()
    }

    /// Twist of one rod against what it takes by itself, rad per rod length, right-handed positive: of a strand in a rope, the turns that the rope's
    /// lay and its turning put into it.
    #[must_use]
    pub fn twist(&self) -> f64 {
        self.twist_strain / self.layer.rod.radius()
    }
}

/// Why no state is found under given loads.
pub(super) enum Lost {
    /// None near the lay as made.
    Nowhere,
    /// Where a layer comes to lie on its neighbours as well as on what is below, the loads step from one value to another at the same strain
    /// and turning; between the two both carry. The place near which layers changed over, and which did.
    Shared { strain: f64, turning: f64, layers: Vec<usize> },
}

impl Lost {
    fn said(&self, value: f64) -> DomainError {
        let allowed = match self {
            Self::Nowhere => {
                "such that a state near the lay as made holds it: strains between -1/2 and 1, no layer unlaid"
            }
            Self::Shared { .. } => {
                "outside the loads under which several layers at once come to lie on what is below and on their neighbours: \
                 a little more or less of force or moment is answered"
            }
        };
        DomainError { quantity: "force", value, allowed }
    }
}

/// A cable at a strain and a turning of its axis, with the loads that hold it there.
#[derive(Clone, Debug, PartialEq)]
pub struct CableState {
    cable: Cable,
    strain: f64,
    turning: f64,
    /// energy per cable length as made
    energy: Jet2,
    core: Option<(f64, [f64; 2], f64)>,
    layers: Vec<LayerState>,
    contraction: Option<f64>,
    /// of the layers that lie on both, in order
    meetings: Vec<Jet2>,
    outer_radius: f64,
}

impl Cable {
    /// As laid: without strain and turning. Where rods are not preformed, or only in part, a moment holds them.
    ///
    /// # Errors
    /// None for a cable that could be made; the same kind of value as from [`loaded`](Self::loaded).
    pub fn laid(&self) -> Result<CableState, DomainError> {
        self.loaded(CableGrips::Clamped { strain: 0.0, turning: 0.0 })
    }

    /// The state near the lay as made, under given loads or displacements.
    ///
    /// # Errors
    /// [`DomainError`] on data that are not finite, and where no state is found between half and double the length with every layer
    /// still wound the way it was laid.
    ///
    /// ```
    /// use nply::mechanics::{Cable, CableGrips, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let six = Layer {
    ///     strands: 6,
    ///     rod: Rod::solid_round(2.5, 200e3, 0.3)?,
    ///     handedness: Handedness::Right,
    ///     lay: WireLay::Length(220.0),
    ///     preforming: 1.0,
    ///     pretwist: 0.0,
    /// };
    /// let strand = Cable::new(Some(Rod::solid_round(2.6, 200e3, 0.3)?), &[six])?;
    /// let pulled = strand.loaded(CableGrips::Turned { force: 100e3, turning: 0.0 })?;
    /// assert!(pulled.moment() > 0.0); // it wants to unlay, and is held
    /// let swivel = strand.loaded(CableGrips::Loads { force: 100e3, moment: 0.0 })?;
    /// assert!(swivel.turning() < 0.0 && swivel.strain() > pulled.strain());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn loaded(&self, grips: CableGrips) -> Result<CableState, DomainError> {
        let finite = |name, value: f64| DomainError::check(value.is_finite(), name, value, "finite");
        match grips {
            CableGrips::Clamped { strain, turning } => {
                finite("turning", turning)?;
                DomainError::check(strain > -0.5 && strain < 1.0, "strain", strain, "between -1/2 and 1")?;
                self.at(strain, turning, &Sharing::NONE)
                    .ok_or_else(|| DomainError { quantity: "turning", ..Lost::Nowhere.said(turning) })
            }
            CableGrips::Turned { force, turning } => {
                finite("force", force)?;
                finite("turning", turning)?;
                self.sought(grips, [0.0, turning]).or_else(|why| self.shared(grips, why)).map_err(|why| why.said(force))
            }
            CableGrips::Loads { force, moment } => {
                finite("force", force)?;
                finite("moment", moment)?;
                self.sought(grips, [0.0; 2]).or_else(|why| self.shared(grips, why)).map_err(|why| why.said(force))
            }
        }
    }

    /// Newton's iteration from a strain and a turning, its steps shortened where they would unlay a layer.
    pub(super) fn sought(&self, grips: CableGrips, [strain, turning]: [f64; 2]) -> Result<CableState, Lost> {
        let regime = |state: &CableState| state.layers.iter().map(|layer| layer.support).collect::<Vec<_>>();
        let mut here = self.at(strain, turning, &Sharing::NONE).ok_or(Lost::Nowhere)?;
        // the step in which a layer last changed over
        let mut changed = vec![None; self.layers.len()];
        let least = self.layers.iter().map(|laid| laid.angle.tan() / laid.radius).fold(f64::INFINITY, f64::min);
        let mut last = f64::INFINITY;
        const MOST: usize = 200;
        for step in 0..MOST {
            let [de, dw] = grips.step_from(&here);
            if !(de.is_finite() && dw.is_finite()) {
                return Err(Lost::Nowhere);
            }
            let mut share = (0.1 / de.abs()).min(0.3 * least / dw.abs()).min(1.0);
            let next = loop {
                let there = self.at(here.strain + share * de, here.turning + share * dw, &Sharing::NONE);
                match there {
                    Some(next) if next.strain > -0.5 && next.strain < 1.0 => break next,
                    _ if share > 1e-6 => share *= 0.5,
                    _ => return Err(Lost::Nowhere),
                }
            };
            // Newton's steps shrink by squares until rounding is all that is left of them
            let size = de.abs().max(dw.abs() / least);
            let done = share >= 1.0 && (size <= 1e-16 || size <= 1e-9 && size >= 0.25 * last);
            for (last, (a, b)) in changed.iter_mut().zip(regime(&next).iter().zip(&regime(&here))) {
                if a != b {
                    *last = Some(step);
                }
            }
            here = next;
            last = size;
            if done {
                return Ok(here.under(grips));
            }
        }
        let lately = |(i, last): (usize, &Option<usize>)| last.is_some_and(|step| step + 8 > MOST).then_some(i);
        let layers: Vec<usize> = changed.iter().enumerate().filter_map(lately).collect();
        if layers.is_empty() {
            return Err(Lost::Nowhere);
        }
        Err(Lost::Shared { strain: here.strain, turning: here.turning, layers })
    }

    /// The state at a strain and a turning, with the layers that share; `None` where a layer is unlaid.
    pub(super) fn at(&self, strain: f64, turning: f64, sharing: &Sharing) -> Option<CableState> {
        let mut below = match self.core {
            Some(core) => {
                let nu = core.poissons_ratio();
                Jet2::of_a(Jet::new(core.radius() * (1.0 - nu * strain), -core.radius() * nu, 0.0))
            }
            None => Jet2::constant(0.0),
        };
        let core_radius = below;
        let mut energy = self.core.map_or(Jet2::constant(0.0), |core| {
            let (e, w) = (Jet2::of_a(Jet::new(strain, 1.0, 0.0)), Jet2::of_b(Jet::new(turning, 1.0, 0.0)));
            (0.5 * core.axial_stiffness()) * (e * e)
                + (0.5 * core.torsional_stiffness()) * (w * w)
                + core.coupling() * (e * w)
        });
        let mut deformed: Vec<Deformed> = Vec::with_capacity(self.layers.len());
        let mut meetings = Vec::new();
        for (i, laid) in self.layers.iter().enumerate() {
            let here = laid.deformed(strain, turning, below, sharing.pushes(i).is_some())?;
            energy = energy + self.per_length(laid) * here.energy;
            if let (Some(push), Some(meeting)) = (sharing.pushes(i), here.meeting) {
                energy = energy + push * meeting;
                meetings.push(meeting);
            }
            below = here.outer;
            deformed.push(here);
        }
        // what each layer presses with, from the outside in: on what is below, and between neighbours
        let mut carried = vec![[0.0; 2]; deformed.len()];
        let mut above = 0.0;
        for (i, (laid, here)) in self.layers.iter().zip(&deformed).enumerate().rev() {
            let inward = self.per_length(laid) * here.by_radius + above * here.outer_by_radius;
            let between = match here.support {
                LayerSupport::Below => 0.0,
                LayerSupport::Neighbours => inward,
                LayerSupport::Both => sharing.pushes(i).unwrap_or(0.0),
            };
            carried[i] = [(inward - between) / here.give[0], between / here.give[1]];
            above = carried[i][0];
        }
        let layers = self.layers.iter().zip(&deformed).enumerate().map(|(i, (laid, here))| {
            let rods = self.per_length(laid);
            let above = carried.get(i + 1).map_or(0.0, |[below, _]| *below);
            let [force, moment] = laid
                .share(here, strain, turning, carried[i].map(|load| load / rods), above / rods)
                .map(|share| rods * share);
            let rod = laid.layer.rod;
            let (n, r) = (f64::from(laid.layer.strands), rod.radius());
            let thick = r * (1.0 - rod.poissons_ratio() * here.strain);
            let [pressure_below, between] = carried[i].map(|load| load / n);
            let interstrand_pressure = 0.5 * between * here.touching.radius_ratio();
            let gap = match here.support {
                LayerSupport::Below => 2.0 * (here.radius.value / here.touching.radius_ratio() - thick),
                LayerSupport::Neighbours | LayerSupport::Both => 0.0,
            };
            // wires along each other: loads per length of their common line
            let wire =
                WireSurface { radius: thick, curvature: here.angle.sin() * here.angle.sin() / here.radius.value };
            let turn = (laid.rotation() / laid.angle.cos() + laid.layer.handedness.sign() * turning).abs();
            let line = |radius: f64| libm::hypot(1.0 + strain, radius * turn);
            let on_core = (i == 0 && pressure_below > 0.0).then_some(self.core).flatten();
            let core_line_load = on_core.map(|_| pressure_below / line(core_radius.value));
            let pressed = interstrand_pressure > 0.0;
            let neighbour_line_load =
                pressed.then(|| interstrand_pressure / line(here.touching.contact_line_radius() * thick));
            let hertz = |load: Option<f64>, curvature: f64, other: Option<Rod>| {
                hertz_pressure(load?, curvature, [rod.material()?, other?.material()?])
            };
            LayerState {
                layer: laid.layer,
                support: here.support,
                radius: here.radius.value,
                angle: here.angle,
                strain: here.strain,
                bending_strain: here.bending * r,
                twist_strain: here.torsion * r,
                force,
                moment,
                pressure_below,
                interstrand_pressure,
                gap,
                core_line_load,
                core_hertz_pressure: hertz(core_line_load, wire.facing(1.0) + 1.0 / core_radius.value, on_core),
                neighbour_line_load,
                neighbour_hertz_pressure: hertz(
                    neighbour_line_load,
                    2.0 * wire.facing(inward_to_neighbour(&here.touching)),
                    Some(rod),
                ),
            }
        });
        let layers: Vec<LayerState> = layers.collect();
        let on_core = carried.first().map_or(0.0, |[below, _]| *below);
        let core = self.core.map(|core| {
            let force = core.axial_stiffness() * strain + core.coupling() * turning + on_core * core_radius.a;
            let moment = core.torsional_stiffness() * turning + core.coupling() * strain;
            (core_radius.value, [force, moment], on_core)
        });
        Some(CableState {
            cable: self.clone(),
            strain,
            turning,
            energy,
            core,
            layers,
            contraction: meetings.is_empty().then_some(-below.a / below.value),
            meetings,
            outer_radius: below.value,
        })
    }

    /// Rod length of a layer per cable length, all rods together.
    fn per_length(&self, laid: &super::layer::Laid) -> f64 {
        f64::from(laid.layer.strands) / laid.angle.cos()
    }
}

impl CableState {
    /// The cable.
    #[must_use]
    pub const fn cable(&self) -> &Cable {
        &self.cable
    }

    /// The loads that were given, in place of what Newton's iteration leaves of their digits.
    pub(super) const fn under(mut self, grips: CableGrips) -> Self {
        match grips {
            CableGrips::Loads { force, moment } => {
                self.energy.a = force;
                self.energy.b = moment;
            }
            CableGrips::Turned { force, .. } => self.energy.a = force,
            CableGrips::Clamped { .. } => {}
        }
        self
    }

    /// Strain of the axis, from the lay as made.
    #[must_use]
    pub const fn strain(&self) -> f64 {
        self.strain
    }

    /// Turns put in from the lay as made, rad per cable length as made, right-handed positive.
    #[must_use]
    pub const fn turning(&self) -> f64 {
        self.turning
    }

    /// Force on the cable, tension positive.
    #[must_use]
    pub const fn force(&self) -> f64 {
        self.energy.a
    }

    /// Moment on the cable, right-handed positive.
    #[must_use]
    pub const fn moment(&self) -> f64 {
        self.energy.b
    }

    /// The layers, from the inside out.
    #[must_use]
    pub fn layers(&self) -> &[LayerState] {
        &self.layers
    }

    /// Force in the core, what its squeezed section adds included; `None` without one.
    #[must_use]
    pub fn core_force(&self) -> Option<f64> {
        self.core.map(|(_, [force, _], _)| force)
    }

    /// Moment in the core; `None` without one.
    #[must_use]
    pub fn core_moment(&self) -> Option<f64> {
        self.core.map(|(_, [_, moment], _)| moment)
    }

    /// Radius of the core, thinned; `None` without one.
    #[must_use]
    pub fn core_radius(&self) -> Option<f64> {
        self.core.map(|(radius, ..)| radius)
    }

    /// Mean pressure on the core of what lies on it: n times the force of each rod of the innermost layer, over the core's surface, per cable length as
    /// made. `None` without a core, and where the innermost layer does not lie on it.
    #[must_use]
    pub fn pressure_on_core(&self) -> Option<f64> {
        let (radius, first) = (self.core_radius()?, self.layers.first()?);
        let lies = first.support != LayerSupport::Neighbours;
        lies.then(|| f64::from(first.layer.strands) * first.pressure_below / (core::f64::consts::TAU * radius))
    }

    /// By how much the [pressure on it](Self::pressure_on_core) would make a solid core thinner, over its radius: (1 + ν)(1 − 2ν) p/E, its length
    /// held. It is not part of the state, in which the core keeps its round outline; [`Cable::core_give`] tells whether that matters. `None` of a
    /// core that is no solid, and where nothing lies on it.
    #[must_use]
    pub fn core_squeeze(&self) -> Option<f64> {
        let [modulus, nu] = self.cable.core()?.material()?;
        Some((1.0 + nu) * (1.0 - 2.0 * nu) * self.pressure_on_core()? / modulus)
    }

    /// Radius of the cylinder around the cable.
    #[must_use]
    pub const fn outer_radius(&self) -> f64 {
        self.outer_radius
    }

    /// By how much the outside shrinks per strain at no turning, over itself: Poisson's ratio of the cable, which may be more than 1/2. `None`
    /// where a layer lies on what is below and on its neighbours: no strain at no turning keeps both.
    #[must_use]
    pub const fn contraction(&self) -> Option<f64> {
        self.contraction
    }

    /// Whether a layer would have to be held down, or its rods together: it lifts off, and what is said of the cable holds no more. Pressures that are
    /// nothing but rounding of what is stored do not count.
    #[must_use]
    pub fn lifts(&self) -> bool {
        let stiff = self.unchecked_stiffness().axial;
        let least = -1e-12 * stiff / self.outer_radius;
        self.layers.iter().any(|layer| layer.pressure_below < least || layer.interstrand_pressure < least)
    }

    /// The 2 × 2 stiffness, per cable length as made: EA, coupling, GJ; `None` unless it resists every small strain and turning, and where a layer
    /// lies on what is below and on its neighbours: as long as both push, small changes of the loads are met without strain and turning of their
    /// own, and there is no such matrix.
    ///
    /// Symmetric: the second derivatives of the energy, the radius of every layer following what it lies on.
    #[must_use]
    pub fn stiffness(&self) -> Option<StretchStiffness> {
        let k = self.unchecked_stiffness();
        let positive = k.axial > 0.0 && k.torsional > 0.0 && k.axial * k.torsional > k.coupling * k.coupling;
        (positive && self.meetings.is_empty()).then_some(k)
    }

    pub(super) const fn unchecked_stiffness(&self) -> StretchStiffness {
        StretchStiffness { axial: self.energy.aa, coupling: self.energy.ab, torsional: self.energy.bb }
    }

    /// Moment over force and outer diameter while the ends cannot turn: the torque factor of rope makers, right-handed positive. As the ratio of small
    /// changes about this state; `None` where two layers lie on what is below and on their neighbours, so that the moment is not told by the force.
    #[must_use]
    pub fn torque_factor(&self) -> Option<f64> {
        let by_force = match self.meetings[..] {
            [] => self.unchecked_stiffness().moment_by_force(),
            // neither strain nor turning changes: what changes is how the two contacts share
            [meeting] => meeting.b / meeting.a,
            _ => return None,
        };
        Some(by_force / (2.0 * self.outer_radius))
    }

    /// Whether a layer lies on what is below and on its neighbours at once.
    #[must_use]
    pub fn shares(&self) -> bool {
        !self.meetings.is_empty()
    }

    /// What must vanish for the layers that share, with derivatives by strain and turning.
    pub(super) fn meetings(&self) -> &[Jet2] {
        &self.meetings
    }

    /// Energy per cable length as made, of layers that share with what holds them together.
    pub(super) const fn energy(&self) -> Jet2 {
        self.energy
    }

    /// The hand of the outermost layer.
    #[must_use]
    pub fn handedness(&self) -> Handedness {
        self.cable.handedness()
    }
}
