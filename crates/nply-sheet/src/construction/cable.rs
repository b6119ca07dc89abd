//! A strand or rope as something that carries: the theory's cable, and the loads on it.

use core::f64::consts::{PI, TAU};

use nply::DomainError;
use nply::geometry::{LayerContact, WireLayer, WireStrand};
use nply::mechanics::{Cable, CableGrips, Layer as Laid, Rod};

use super::check::turning;
use super::{Construction, ConstructionSpec, Core, Layer};
use crate::key::Group;
use crate::preferred::six_digits;
use crate::spec::Entry;
use crate::{Datum, Dimension, ErrorKind, Key, SpecError};

/// A cable with its loads, and what is to be found for it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CableCase {
    /// As it was described.
    pub construction: Construction,
    /// As the theory has it, in the units of the construction.
    pub cable: Cable,
    /// What the core (if there is one) and the rods of each layer are made of, from the inside: a strand within, or `None` of solid ones.
    pub strands: Vec<Option<Cable>>,
    /// What its ends are given; `None` as laid.
    pub grips: Option<CableGrips>,
    /// What else is asked.
    pub question: CableQuestion,
}

/// What is to be found beside the state.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CableQuestion {
    /// Nothing more.
    State,
    /// The lay lengths of a layer (0 the innermost) at which the torque factor is as wanted; where its wires are not preformed, the pretwist too at
    /// which the cable as laid asks for no moment.
    Balance {
        /// Moment over force and outer diameter.
        torque_factor: f64,
        /// Which layer gives way.
        layer: usize,
    },
}

impl ConstructionSpec {
    /// Understands the strand or rope with its loads: every size and every modulus is given.
    ///
    /// # Errors
    /// [`SpecError`] as for [`check`](Self::check), where a modulus or Poisson's ratio is missing, and where no such cable can be laid.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// let flags = [
    ///     ("core-diameter", "3.94 mm"), ("core-youngs-modulus", "188 GPa"), ("core-poissons-ratio", "0.3"),
    ///     ("strands", "6"), ("wire-diameter", "3.73 mm"), ("lay-length", "115 mm"),
    ///     ("wire-youngs-modulus", "188 GPa"), ("wire-poissons-ratio", "0.3"), ("force", "50 kN"),
    /// ];
    /// let case = ConstructionSpec::from_flags(flags)?.check_cable()?;
    /// let state = case.cable.loaded(case.grips.expect("a force is given"))?;
    /// assert!((state.force() - 50e3).abs() < 1e-6 && state.moment() > 0.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn check_cable(&self) -> Result<CableCase, SpecError> {
        let construction = self.check()?;
        if let Some(entry) = self.layers.iter().flat_map(|part| &part.entries).find(|e| e.key.datum == Datum::LayerGap)
        {
            let message =
                format!("{} is for finding a core with `nply fit-check`: give the core's diameter here", entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        let cable = self.cable_of(&construction)?;
        let core = construction.core.iter().map(|core| (core.strand.as_deref(), self.core_strand.as_deref()));
        let layers = construction.layers.iter().zip(&self.layers);
        let layers = layers.map(|(layer, part)| (layer.strand.as_deref(), part.strand.as_deref()));
        let within = core
            .chain(layers)
            .map(|(strand, spec)| strand.zip(spec).map(|(strand, spec)| spec.cable_of(strand)).transpose());
        let strands = within.collect::<Result<Vec<_>, SpecError>>()?;
        let finite = |entry: &Entry| entry.finite(entry.number());
        let force = self.head(Datum::CableForce).map(finite).transpose()?;
        let ends: Vec<&Entry> = self.head.iter().filter(|entry| entry.key.group == Some(Group::Ends)).collect();
        if let [first, second, ..] = ends.as_slice() {
            let message =
                format!("{} and {} both say how the ends are held: give one of them", first.said(), second.said());
            return Err(second.error(ErrorKind::Contradiction, message));
        }
        let moment = self.head(Datum::CableMoment).map(finite).transpose()?;
        let turned = self.head(Datum::CableTurning).map(turning).transpose()?;
        let grips = match (force, moment, turned) {
            (None, None, None) => None,
            (force, Some(moment), _) => Some(CableGrips::Loads { force: force.unwrap_or(0.0), moment }),
            (force, None, turned) => {
                Some(CableGrips::Turned { force: force.unwrap_or(0.0), turning: turned.unwrap_or(0.0) })
            }
        };
        Ok(CableCase { question: self.balance(construction.layers.len())?, construction, cable, strands, grips })
    }

    fn balance(&self, layers: usize) -> Result<CableQuestion, SpecError> {
        let (factor, layer) = (self.head(Datum::CableTorqueFactor), self.head(Datum::CableBalancedLayer));
        let Some(factor) = factor else {
            return match layer {
                None => Ok(CableQuestion::State),
                Some(entry) => {
                    let wanted = self.ask_for(Datum::CableTorqueFactor);
                    let message =
                        format!("{} says which layer gives way, but not to what: give {wanted}", entry.said());
                    Err(entry.error(ErrorKind::Missing, message))
                }
            };
        };
        let torque_factor = factor.finite(factor.number())?;
        let layer = match layer {
            None => layers,
            Some(entry) => {
                let number = entry.number();
                match (1..=layers).find(|at| (*at as f64 - number).abs() < 0.5 && libm::trunc(number) >= number) {
                    Some(at) => at,
                    None => {
                        let message =
                            format!("{}: the layers are counted from 1, the innermost, to {layers}", entry.said());
                        return Err(entry.error(ErrorKind::Domain, message));
                    }
                }
            }
        };
        Ok(CableQuestion::Balance { torque_factor, layer: layer - 1 })
    }

    fn cable_of(&self, construction: &Construction) -> Result<Cable, SpecError> {
        let core = match &construction.core {
            None => None,
            Some(core) => {
                let rod = match (&core.strand, &self.core_strand) {
                    (Some(strand), Some(spec)) => spec.rod_of(strand)?,
                    _ => {
                        let modulus = self.known(None, core.youngs_modulus, Datum::StrandCoreYoungsModulus)?;
                        let nu = self.known(None, core.poissons_ratio, Datum::StrandCorePoissonsRatio)?;
                        self.rod(0, 0.5 * core.diameter, [modulus, nu], core.tensile_strength)?
                    }
                };
                Some(if core.fibre { rod.uncounted() } else { rod })
            }
        };
        let layers = construction.layers.iter().enumerate().map(|(at, layer)| {
            let within = self.layers.get(at).and_then(|part| part.strand.as_ref());
            let rod = match (&layer.strand, within) {
                (Some(strand), Some(spec)) => spec.rod_of(strand)?,
                _ => {
                    let modulus = self.known(Some(at), layer.youngs_modulus, Datum::LayerYoungsModulus)?;
                    let nu = self.known(Some(at), layer.poissons_ratio, Datum::LayerPoissonsRatio)?;
                    self.rod(at, 0.5 * layer.wire_diameter, [modulus, nu], layer.tensile_strength)?
                }
            };
            let Layer { wires, hand, lay, preforming, pretwist, .. } = *layer;
            Ok(Laid { strands: wires, rod, handedness: hand, lay, preforming, pretwist })
        });
        let layers = layers.collect::<Result<Vec<_>, SpecError>>()?;
        // layer by layer, so that a refusal is said at the layer it is about
        for at in 0..layers.len() {
            Cable::new(core, &layers[..=at]).map_err(|error| self.locate(at, &error))?;
        }
        Cable::new(core, &layers).map_err(|error| self.locate(0, &error))
    }

    fn rod(&self, at: usize, radius: f64, [modulus, nu]: [f64; 2], strength: Option<f64>) -> Result<Rod, SpecError> {
        let rod = Rod::solid_round(radius, modulus, nu);
        let rod = rod.and_then(|rod| strength.map_or(Ok(rod), |strength| rod.of_strength(strength)));
        rod.map_err(|error| self.locate(at, &error))
    }

    fn rod_of(&self, strand: &Construction) -> Result<Rod, SpecError> {
        self.cable_of(strand)?.as_rod().map_err(|error| self.locate(0, &error))
    }

    fn known(&self, layer: Option<usize>, value: Option<f64>, datum: Datum) -> Result<f64, SpecError> {
        value.ok_or_else(|| {
            let what = match datum {
                Datum::StrandCoreYoungsModulus => "Young's modulus of the core (a small one for a fibre core)",
                Datum::StrandCorePoissonsRatio => "Poisson's ratio of the core",
                Datum::LayerYoungsModulus => "Young's modulus of the wires",
                _ => "Poisson's ratio of the wires",
            };
            let which = match layer {
                Some(layer) if self.layers.len() > 1 => format!(" of layer {}", layer + 1),
                _ => String::new(),
            };
            let entries =
                layer.map_or(&self.head, |layer| self.layers.get(layer).map_or(&self.head, |part| &part.entries));
            let material = entries.iter().find(|entry| {
                matches!(entry.key.datum, Datum::StrandCoreMaterial if layer.is_none())
                    || matches!(entry.key.datum, Datum::LayerMaterial if layer.is_some())
            });
            let aside = material.map_or(String::new(), |entry| format!(" ({} tells the density alone)", entry.said()));
            self.missing(layer, datum, format!("{what}{which} is missing{aside}: give {}", self.ask_for(datum)))
        })
    }

    /// A refusal of the theory under the loads of a case, at the load it is about.
    #[must_use]
    pub fn locate_load(&self, case: &CableCase, error: &DomainError) -> SpecError {
        if let (Some(entry), Some(CableGrips::Turned { turning, .. })) = (self.head(Datum::CableTurning), case.grips)
            && let Some((layer, straight)) = Construction::unlaid_by(&case.cable, turning)
        {
            let construction = &case.construction;
            let turns = match construction.measured {
                true => construction.units.format(Dimension::ANGLE_PER_LENGTH, straight),
                false => six_digits(straight / TAU),
            };
            let message = format!(
                "{}: layer {} would be unlaid; its wires are straight at {turns}, one turn a lay length against their hand",
                entry.said(),
                layer + 1
            );
            return entry.error(ErrorKind::Domain, message);
        }
        let datum = match error.quantity {
            "moment" => Datum::CableMoment,
            "turning" => Datum::CableTurning,
            _ => Datum::CableForce,
        };
        // of several loads that together are too much, the one that was laid over the file
        let loads = [Datum::CableForce, Datum::CableMoment, Datum::CableTurning];
        let over = self.head.iter().filter(|entry| loads.contains(&entry.key.datum));
        let mut over = over.filter(|entry| matches!(entry.place, crate::Place::Flag(_)));
        let entry = over
            .next()
            .or_else(|| self.head(datum))
            .or_else(|| self.head(Datum::CableForce))
            .or_else(|| self.head.iter().find(|e| e.key.group == Some(Group::Ends)));
        let message = format!("it must be {}", error.allowed);
        match entry {
            Some(entry) => entry.error(ErrorKind::Domain, format!("{}: {message}", entry.said())),
            None => {
                let name = Key::of(datum).map_or("", |key| key.name);
                self.missing(None, datum, format!("{name}: {message}"))
            }
        }
    }
}

/// How the sections of wires are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cut {
    /// Each square to its own wire, as strength tables count.
    Square,
    /// All in one plane across: what the wires' length makes of it, strand in rope and wire in strand alike.
    Across,
}

impl Cut {
    /// Sections of the rods of a layer, each full of wire.
    pub(crate) fn area(self, layer: &WireLayer) -> f64 {
        match self {
            Self::Square => f64::from(layer.wires()) * PI * layer.wire_radius() * layer.wire_radius(),
            Self::Across => layer.metal_area(),
        }
    }

    /// How much of such a rod's own section is wire: all of a solid one.
    pub(crate) fn share(self, strand: Option<&Construction>) -> f64 {
        strand.map_or(1.0, |strand| strand.solid_share(self))
    }
}

impl Core {
    /// How much of its outline is metal: 0 of fibre, 1 of a king wire.
    pub(crate) fn metal_share(&self, cut: Cut) -> f64 {
        if self.fibre { 0.0 } else { cut.share(self.strand.as_deref()) }
    }
}

impl Construction {
    /// The geometry of the strand as laid.
    ///
    /// # Errors
    /// [`DomainError`] where no wires can be laid so.
    pub fn laid(&self) -> Result<WireStrand, DomainError> {
        let mut strand = WireStrand::on_core(self.core.as_ref().map(|core| 0.5 * core.diameter))?;
        for layer in &self.layers {
            strand.lay(layer.wires, 0.5 * layer.wire_diameter, layer.lay)?;
        }
        Ok(strand)
    }

    /// Of the strands within whose wires do not fit beside each other on what is below, a sentence each; `length` says a length.
    pub(crate) fn crowded_within(&self, length: &dyn Fn(f64) -> String) -> Vec<String> {
        let core = self.core.iter().filter_map(|core| Some(("the core".to_owned(), core.strand.as_deref()?)));
        let layers = self.layers.iter().enumerate();
        let layers = layers
            .filter_map(|(at, layer)| Some((format!("the strands of layer {}", at + 1), layer.strand.as_deref()?)));
        core.chain(layers).flat_map(|(whose, strand)| strand.crowded(&whose, length)).collect()
    }

    /// The same of this strand itself.
    pub(crate) fn crowded(&self, whose: &str, length: &dyn Fn(f64) -> String) -> Vec<String> {
        let Ok(laid) = self.laid() else { return Vec::new() };
        let off = |layer: &&WireLayer| layer.contact() == LayerContact::Neighbours && layer.core_radius() > 0.0;
        let core = self.core.as_ref().map_or(0.0, |core| core.diameter);
        let drawn = self.layers.iter().fold(core, |sum, layer| sum + 2.0 * layer.wire_diameter);
        let sentence = |layer: &WireLayer| {
            format!(
                "In {whose}, {} wires do not fit beside each other on what is below: laid on it they would overlap by {}. They touch each other instead, so that the strand \
                 is {} thick, not {}.",
                layer.wires(),
                length(-layer.gap()),
                length(2.0 * laid.outer_radius()),
                length(drawn)
            )
        };
        laid.layers().iter().filter(off).map(sentence).collect()
    }

    /// The first layer that so many turns would lay straight, and more turn the other way round: its number from 0, with the turning (rad per
    /// length) that does, one turn a lay length.
    fn unlaid_by(cable: &Cable, turning: f64) -> Option<(usize, f64)> {
        let straight = |at: usize, layer: &Laid| Some(-layer.handedness.sign() * TAU / cable.lay_length(at).ok()?);
        let of_layers = cable.layers().enumerate().filter_map(|(at, layer)| Some((at, straight(at, layer)?)));
        let passed = of_layers.filter(|(_, straight)| turning / straight >= 1.0);
        passed.min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
    }

    /// How much of the outline's area is wire, in a plane across the strand or with each section counted square to its wire.
    pub(crate) fn solid_share(&self, cut: Cut) -> f64 {
        let Ok(laid) = self.laid() else { return f64::NAN };
        let core =
            self.core.as_ref().map_or(0.0, |core| 0.25 * PI * core.diameter * core.diameter * core.metal_share(cut));
        let layers = self.layers.iter().zip(laid.layers());
        let wires = layers.map(|(layer, on)| cut.area(on) * cut.share(layer.strand.as_deref()));
        wires.fold(core, |sum, area| sum + area) / (PI * laid.outer_radius() * laid.outer_radius())
    }

    /// Mass per length over the area of the outline; `None` where a density is missing.
    pub(super) fn mean_density(&self) -> Option<f64> {
        let laid = self.laid().ok()?;
        let mut mass = match &self.core {
            Some(core) => 0.25 * PI * core.diameter * core.diameter * core.density?,
            None => 0.0,
        };
        for (layer, on) in self.layers.iter().zip(laid.layers()) {
            let r = on.wire_radius();
            mass += f64::from(layer.wires) * PI * r * r / on.taken_angle().cos() * layer.density?;
        }
        Some(mass / (PI * laid.outer_radius() * laid.outer_radius()))
    }
}
