//! A layered strand understood as a whole.

use nply::Handedness;
use nply::geometry::WireLay;

use super::written::Part;
use super::{Construction, ConstructionSpec, Core, Layer, material};
use crate::key::Group;
use crate::spec::{Entry, Value};
use crate::{Datum, ErrorKind, Kind, PreferredUnits, SpecError, Table};

/// What is known of a strand, with what may still have to be found.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    pub(crate) title: Option<String>,
    pub(crate) outer_diameter: Option<f64>,
    /// Over that of the wires on it.
    pub(crate) core_ratio: Option<f64>,
    /// `None` where none is given; it may be 0.
    pub(crate) core_diameter: Option<f64>,
    pub(crate) core: Stuff,
    pub(crate) core_strand: Option<Construction>,
    pub(crate) layers: Vec<GivenLayer>,
    pub(crate) measured: bool,
    pub(crate) units: PreferredUnits,
    pub(crate) written: ConstructionSpec,
}

/// What core or wires are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Stuff {
    pub(crate) density: Option<f64>,
    pub(crate) youngs_modulus: Option<f64>,
    pub(crate) poissons_ratio: Option<f64>,
    pub(crate) tensile_strength: Option<f64>,
    /// Of a core alone.
    pub(crate) fibre: bool,
}

impl Stuff {
    /// A core of it.
    pub(super) fn core(self, diameter: f64, strand: Option<Construction>) -> Core {
        let Self { density, youngs_modulus, poissons_ratio, tensile_strength, fibre } = self;
        Core {
            diameter,
            density,
            youngs_modulus,
            poissons_ratio,
            tensile_strength,
            fibre,
            strand: strand.map(Box::new),
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GivenLayer {
    pub(crate) wires: u32,
    pub(crate) wire_diameter: Option<f64>,
    pub(crate) lay: Option<WireLay>,
    pub(crate) hand: Option<Handedness>,
    /// The gap that is wanted.
    pub(crate) gap: Option<f64>,
    pub(crate) stuff: Stuff,
    pub(crate) preforming: f64,
    pub(crate) pretwist: f64,
    pub(crate) strand: Option<Construction>,
}

impl ConstructionSpec {
    /// Understands the strand as a whole: every size is given.
    ///
    /// # Errors
    /// [`SpecError`]: a datum is missing, data contradict each other, units are mixed with bare numbers, or no strand has such a
    /// number. Whether the wires fit is not asked here.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// let flags = [("core-diameter", "5 mm"), ("strands", "6"), ("wire-diameter", "4"), ("lay-length", "60 mm")];
    /// let error = ConstructionSpec::from_flags(flags)?.check().unwrap_err();
    /// assert!(error.to_string().contains("has no unit"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check(&self) -> Result<Construction, SpecError> {
        let given = self.given()?;
        for (datum, is_given) in
            [(Datum::StrandOuterDiameter, given.outer_diameter), (Datum::StrandCoreDiameterRatio, given.core_ratio)]
        {
            if let (Some(_), Some(entry)) = (is_given, self.head(datum)) {
                let message = format!(
                    "{} is for finding sizes with `nply fit-check`: give the sizes themselves here, {} and {}",
                    entry.said(),
                    self.ask_for(Datum::StrandCoreDiameter),
                    self.ask_for(Datum::LayerWireDiameter)
                );
                return Err(entry.error(ErrorKind::Contradiction, message));
            }
        }
        let several = given.layers.len() > 1;
        let mut layers = Vec::new();
        for (at, layer) in given.layers.iter().enumerate() {
            let wire_diameter = layer.wire_diameter.ok_or_else(|| self.ask(at, Datum::LayerWireDiameter))?;
            let lay = layer.lay.ok_or_else(|| self.ask(at, Datum::LayerLayLength))?;
            let hand = match layer.hand {
                None if several => return Err(self.ask(at, Datum::LayerHand)),
                hand => hand.unwrap_or(Handedness::Right),
            };
            let Stuff { density, youngs_modulus, poissons_ratio, tensile_strength, .. } = layer.stuff;
            layers.push(Layer {
                wires: layer.wires,
                wire_diameter,
                lay,
                hand,
                density,
                youngs_modulus,
                poissons_ratio,
                tensile_strength,
                preforming: layer.preforming,
                pretwist: layer.pretwist,
                strand: layer.strand.clone().map(Box::new),
            });
        }
        let core = given.core_diameter.filter(|diameter| *diameter > 0.0);
        let core = core.map(|diameter| given.core.core(diameter, given.core_strand));
        let Given { title, measured, units, written, .. } = given;
        Ok(Construction { title, core, layers, measured, units, written })
    }

    /// Understands what is given; sizes may be missing.
    pub(crate) fn given(&self) -> Result<Given, SpecError> {
        let measured = self.measured()?;
        for entries in [&self.head].into_iter().chain(self.layers.iter().map(|part| &part.entries)) {
            one_of_each(entries)?;
        }
        if self.layers.is_empty() {
            let ask = self.ask_for(Datum::LayerWires);
            let message = format!("a strand needs a layer of wires: give {ask}, their number");
            return Err(self.missing(None, Datum::LayerWires, message));
        }
        let head = |datum| self.head(datum);
        let title = head(Datum::StrandTitle).and_then(|entry| match &entry.value {
            Value::Text(text) => Some(text.clone()),
            _ => None,
        });
        let core_strand = self.core_strand.as_ref().map(|strand| strand.check()).transpose()?;
        let core_diameter = match (head(Datum::StrandCoreDiameter), &core_strand) {
            (given, Some(strand)) => Some(self.diameter_of_strand(0, given, strand)?),
            (given, None) => match given {
                Some(entry) if entry.number() == 0.0 => Some(0.0),
                other => other.map(positive).transpose()?,
            },
        };
        let layers = self.layers.iter().enumerate().map(|(at, part)| self.layer(at, part)).collect::<Result<_, _>>()?;
        Ok(Given {
            title,
            outer_diameter: head(Datum::StrandOuterDiameter).map(positive).transpose()?,
            core_ratio: head(Datum::StrandCoreDiameterRatio).map(positive).transpose()?,
            core_diameter,
            core: self.stuff_of(&self.head, core_strand.as_ref())?,
            core_strand,
            layers,
            measured,
            units: PreferredUnits::first_written(self.all()),
            written: self.clone(),
        })
    }

    fn layer(&self, at: usize, part: &Part) -> Result<GivenLayer, SpecError> {
        let get = |datum| part.entries.iter().find(|entry| entry.key.datum == datum);
        let Some(wires) = get(Datum::LayerWires) else { return Err(self.ask(at, Datum::LayerWires)) };
        let lay = match part.entries.iter().find(|entry| entry.key.group == Some(Group::LayerLay)) {
            None => None,
            Some(entry) => Some(match entry.key.datum {
                Datum::LayerLayLength => WireLay::Length(positive(entry)?),
                Datum::LayerLayRatio => WireLay::Ratio(positive(entry)?),
                _ => {
                    let theta = entry.number();
                    if !(theta > 0.0 && theta < core::f64::consts::FRAC_PI_2) {
                        let message =
                            format!("{}: a lay angle must be greater than 0 and less than 90 degrees", entry.said());
                        return Err(entry.error(ErrorKind::Domain, message));
                    }
                    WireLay::Angle(theta)
                }
            }),
        };
        let gap = match get(Datum::LayerGap) {
            Some(entry) if entry.number() < 0.0 => {
                let message = format!("{}: a gap that is wanted must be at least 0", entry.said());
                return Err(entry.error(ErrorKind::Domain, message));
            }
            gap => gap.map(Entry::number),
        };
        let hand = get(Datum::LayerHand).and_then(|entry| match entry.value {
            Value::Hand(hand) => Some(hand),
            _ => None,
        });
        let strand = part.strand.as_ref().map(|strand| strand.check()).transpose()?;
        let wire_diameter = match (get(Datum::LayerWireDiameter), &strand) {
            (given, Some(strand)) => Some(self.diameter_of_strand(at, given, strand)?),
            (given, None) => given.map(positive).transpose()?,
        };
        let preforming = get(Datum::LayerPreforming).map_or(1.0, Entry::number);
        if let (Some(entry), false) = (get(Datum::LayerPreforming), (0.0..=1.0).contains(&preforming)) {
            let message =
                format!("{}: wires are preformed by 0 (straight) to 1 (free of stress in their lay)", entry.said());
            return Err(entry.error(ErrorKind::Domain, message));
        }
        Ok(GivenLayer {
            wires: whole(wires)?,
            wire_diameter,
            lay,
            hand,
            gap,
            stuff: self.stuff_of(&part.entries, strand.as_ref())?,
            preforming,
            pretwist: get(Datum::LayerPretwist).map_or(Ok(0.0), turning)?,
            strand,
        })
    }

    /// Whether the input has units. All that has a dimension has one, or nothing has; only 0 is 0 in every unit.
    fn measured(&self) -> Result<bool, SpecError> {
        let has_dimension = |entry: &&Entry| {
            let kinds = [Kind::Length, Kind::Density, Kind::Modulus, Kind::Force, Kind::Moment, Kind::TurnsPerLength];
            kinds.contains(&entry.key.kind) || is_material(entry.key.datum)
        };
        let is_measured = |entry: &Entry| entry.is_measured() || is_material(entry.key.datum);
        let with = self.all().filter(has_dimension).find(|entry| is_measured(entry));
        let without = self.all().filter(has_dimension).find(|entry| !is_measured(entry) && entry.number() != 0.0);
        if let (Some(with), Some(without)) = (with, without) {
            let has = if is_material(with.key.datum) { "stands for a density in kg/m³" } else { "has" };
            let message = format!(
                "{} has no unit, but {} {has}: write units everywhere, or nowhere; what is wanted is {}",
                without.said(),
                with.said(),
                without.key.kind.wanted()
            );
            return Err(without.error(ErrorKind::WrongUnit, message));
        }
        Ok(with.is_some())
    }

    /// The outer diameter of a strand within; its diameter cannot be given as well.
    fn diameter_of_strand(&self, at: usize, given: Option<&Entry>, strand: &Construction) -> Result<f64, SpecError> {
        if let Some(entry) = given {
            let message =
                format!("{} follows from the strand that is described below it: remove one of the two", entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        Ok(2.0 * strand.laid().map_err(|error| self.locate(at, &error))?.outer_radius())
    }

    /// What is said of a material, or of the strand within: its mass per length over its outline.
    fn stuff_of(&self, entries: &[Entry], strand: Option<&Construction>) -> Result<Stuff, SpecError> {
        let own = stuff(entries)?;
        let Some(strand) = strand else { return Ok(own) };
        let named = |kind| entries.iter().find(|entry| entry.key.kind == kind || is_material(entry.key.datum));
        let poisson = || entries.iter().find(|entry| entry.key.name == "poissons_ratio");
        if let Some(entry) = named(Kind::Density).or_else(|| named(Kind::Modulus)).or_else(poisson) {
            let of = if entry.key.table == Table::Core { "core" } else { "layer" };
            let message = format!(
                "{} belongs to the wires of the strand that is described below it: write `{}` in [{of}.strand.core] and [[{of}.strand.layer]]",
                entry.said(),
                entry.key.name
            );
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        Ok(Stuff { density: strand.mean_density(), fibre: own.fibre, ..Stuff::default() })
    }

    /// What a layer lacks.
    pub(crate) fn ask(&self, layer: usize, datum: Datum) -> SpecError {
        let what = match datum {
            Datum::LayerWires => "the number of wires",
            Datum::LayerWireDiameter => "the wire diameter",
            Datum::LayerHand => "the hand (layers of either hand differ)",
            _ => "the lay (its length, ratio or angle)",
        };
        let which = if self.layers.len() > 1 { format!(" of layer {}", layer + 1) } else { String::new() };
        let message = format!("{what}{which} is missing: give {}", self.ask_for(datum));
        self.missing(Some(layer), datum, message)
    }
}

const fn is_material(datum: Datum) -> bool {
    matches!(datum, Datum::StrandCoreMaterial | Datum::LayerMaterial)
}

/// Turns per length as rad per length; bare ones are turns too.
pub(super) fn turning(entry: &Entry) -> Result<f64, SpecError> {
    let rad = if entry.is_measured() { entry.number() } else { core::f64::consts::TAU * entry.number() };
    entry.finite(rad)
}

fn positive(entry: &Entry) -> Result<f64, SpecError> {
    entry.positive(entry.number())
}

/// n, 2 to a million.
fn whole(entry: &Entry) -> Result<u32, SpecError> {
    const MOST: f64 = 1e6;
    let number = entry.number();
    if libm::trunc(number) >= number && (2.0..=MOST).contains(&number) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole, from 2 to a million")]
        return Ok(number as u32);
    }
    let message = match number {
        1.0 => format!("{}: a single wire has no neighbour to fit beside; a layer has 2 or more", entry.said()),
        _ => format!("{}: a layer has a whole number of wires, from 2 to a million", entry.said()),
    };
    Err(entry.error(ErrorKind::Domain, message))
}

/// Density, E, ν and strength, as far as they are given.
fn stuff(entries: &[Entry]) -> Result<Stuff, SpecError> {
    let of_kind = |kind: Kind| entries.iter().find(|entry| entry.key.kind == kind);
    let named = |name: &str| entries.iter().find(|entry| entry.key.name == name);
    let fibre = named("fibre").filter(|entry| entry.value == Value::Switch(true));
    let metal = || entries.iter().find(|entry| entry.key.table == Table::Core && is_material(entry.key.datum));
    if let (Some(fibre), Some(metal)) = (fibre, metal()) {
        let message = format!("{} and {} contradict each other: remove one of the two", metal.said(), fibre.said());
        return Err(fibre.error(ErrorKind::Contradiction, message));
    }
    // its section counts not for the breaking load: a strength of it would go nowhere
    if let (Some(fibre), Some(strength)) = (fibre, named("tensile_strength")) {
        let message = format!(
            "{} goes nowhere beside {}: a core of fibre does not count for the breaking load; remove one of the two",
            strength.said(),
            fibre.said()
        );
        return Err(fibre.error(ErrorKind::Contradiction, message));
    }
    let poisson = entries.iter().find(|entry| entry.key.name == "poissons_ratio");
    let poissons_ratio = poisson.map(Entry::number);
    if let (Some(entry), Some(nu)) = (poisson, poissons_ratio)
        && !(nu > -1.0 && nu <= 0.5)
    {
        let message = format!("{}: Poisson's ratio must be greater than -1 and at most 0.5", entry.said());
        return Err(entry.error(ErrorKind::Domain, message));
    }
    let density = match entries.iter().find(|entry| is_material(entry.key.datum)) {
        Some(entry) => {
            let written = if let Value::Text(text) = &entry.value { text } else { "" };
            let Some(material) = material::named(written) else {
                let known: Vec<&str> = super::MATERIALS.iter().map(|material| material.name).collect();
                let message = format!(
                    "{} is no material known here: the materials are {}; give the density itself for others",
                    entry.said(),
                    known.join(", ")
                );
                return Err(entry.error(ErrorKind::WrongType, message));
            };
            Some(material.density)
        }
        None => of_kind(Kind::Density).map(positive).transpose()?,
    };
    Ok(Stuff {
        density,
        youngs_modulus: named("youngs_modulus").map(positive).transpose()?,
        poissons_ratio,
        tensile_strength: named("tensile_strength").map(positive).transpose()?,
        fibre: fibre.is_some(),
    })
}

/// Refuses two data of which only one can be given.
fn one_of_each(entries: &[Entry]) -> Result<(), SpecError> {
    for (at, entry) in entries.iter().enumerate() {
        let before = entries.iter().take(at);
        if let Some(first) =
            before.into_iter().find(|other| other.key.group.is_some() && other.key.group == entry.key.group)
        {
            let whose = if entry.key.table == Table::Core { "of the core" } else { "of a layer" };
            let what = match entry.key.group {
                Some(Group::CoreSize) => "the size",
                Some(Group::LayerLay) => "the lay",
                Some(Group::Ends) => "how the ends are held,",
                _ => "the density",
            };
            let whose = if entry.key.group == Some(Group::Ends) { "by moment or by turns" } else { whose };
            let message = format!("{} and {} both give {what} {whose}: give one of them", first.said(), entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
    }
    Ok(())
}
