//! Does it fit? The strand with every size known, given or found.

use nply::DomainError;
use nply::geometry::{WireLay, WireLayer, WireStrand};

use super::check::{Given, GivenLayer, Stuff};
use super::{Construction, ConstructionSpec, Core};
use crate::key::Group;
use crate::preferred::six_digits;
use crate::spec::Entry;
use crate::{Datum, Dimension, ErrorKind, PreferredUnits, SpecError, Table};

/// A layered strand laid, with what had to be found for it.
///
/// ```
/// use nply_sheet::construction::ConstructionSpec;
/// // which king wire leaves 0.05 mm between the wires?
/// let flags = [("strands", "6"), ("wire-diameter", "3.73 mm"), ("lay-length", "115 mm"), ("gap", "0.05 mm")];
/// let fit = ConstructionSpec::from_flags(flags)?.check_fit()?;
/// assert!((fit.strand.layers()[0].gap() - 5e-5).abs() < 1e-16);
/// assert!((2.0 * fit.strand.layers()[0].core_radius() - 3.95526e-3).abs() < 5e-9);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Fit {
    /// The name given to it, for the report.
    pub title: Option<String>,
    /// Core and layers, in SI or in the input's own bare unit.
    pub strand: WireStrand,
    /// The same as a drawing counts it: each layer on the sum of the nominal diameters below.
    pub nominal: Vec<WireLayer>,
    /// The data that were found, by their keys: `core_diameter`, `wire_diameter`, `lay_length`.
    pub found: Vec<&'static str>,
    /// Whether the input has units.
    pub measured: bool,
    /// The units the input was written in.
    pub units: PreferredUnits,
    pub(crate) core: Stuff,
    core_strand: Option<Construction>,
    pub(crate) layers: Vec<GivenLayer>,
}

impl ConstructionSpec {
    /// Lays the strand, and finds one size or more that are not given:
    ///
    /// - the core, where a gap is wanted (or anything else is said of it), or the outer diameter is;
    /// - the wires' diameter, where the outer diameter is wanted, of a single layer;
    /// - the lay length at which neighbours just touch, or have the gap that is wanted, where no lay is given.
    ///
    /// # Errors
    /// [`SpecError`] as for [`check`](Self::check), and where no wires can be laid so.
    pub fn check_fit(&self) -> Result<Fit, SpecError> {
        let given = self.given()?;
        let mut found = Vec::new();
        let (core_diameter, given) = sizes(self, given, &mut found)?;
        let mut strand = WireStrand::on_core(core_diameter.map(|diameter| 0.5 * diameter))
            .map_err(|error| self.locate(0, &error))?;
        let mut nominal = Vec::new();
        let mut below = core_diameter.map(|diameter| 0.5 * diameter).filter(|radius| *radius > 0.0);
        for (at, layer) in given.layers.iter().enumerate() {
            let radius = 0.5 * layer.wire_diameter.ok_or_else(|| self.ask(at, Datum::LayerWireDiameter))?;
            let refused = |error: DomainError| refusal(self, &given, at, radius, &error);
            let lay = match (layer.lay, strand.layers().last(), core_diameter) {
                (Some(lay), ..) => lay,
                (None, None, None) => return Err(self.ask(at, Datum::LayerLayLength)),
                (None, ..) => {
                    let gap = layer.gap.unwrap_or(0.0);
                    let touching = WireLayer::with_gap(layer.wires, radius, strand.outer_radius(), gap);
                    found.push("lay_length");
                    WireLay::Length(touching.map_err(refused)?.lay_length())
                }
            };
            let laid = strand.lay(layer.wires, radius, lay).map_err(refused)?;
            let drawn = match below {
                Some(below) => WireLayer::on_core(layer.wires, radius, below, lay).map_err(refused)?,
                None => {
                    WireLayer::without_core(layer.wires, radius, WireLay::Length(laid.lay_length())).map_err(refused)?
                }
            };
            below = Some(drawn.lay_radius() + radius);
            nominal.push(drawn);
        }
        let Given { title, measured, units, core, core_strand, layers, .. } = given;
        Ok(Fit { title, strand, nominal, found, measured, units, core, core_strand, layers })
    }
}

impl Fit {
    /// The core, if there is one.
    #[must_use]
    pub fn core(&self) -> Option<Core> {
        let diameter = self.strand.core_radius().map(|radius| 2.0 * radius).filter(|diameter| *diameter > 0.0)?;
        Some(self.core.core(diameter, self.core_strand.clone()))
    }
}

/// The refusal of a layer of wires of radius r, in the words of whoever wrote it.
fn refusal(spec: &ConstructionSpec, given: &Given, at: usize, radius: f64, error: &DomainError) -> SpecError {
    let length = |value: f64| match given.measured {
        true => given.units.format(Dimension::LENGTH, value),
        false => six_digits(value),
    };
    let Some(layer) = given.layers.get(at) else { return spec.locate(at, error) };
    let entry = |wanted: fn(&Entry) -> bool| {
        spec.layers.get(at).and_then(|part| part.entries.iter().find(|entry| wanted(entry)))
    };
    let wires = format!("{} wires of {}", layer.wires, length(2.0 * radius));
    let rings = 2.0 * radius * f64::from(layer.wires);
    let lay = entry(|entry| entry.key.group == Some(Group::LayerLay));
    match (error.quantity, lay) {
        ("lay_length", Some(lay)) if error.value <= 1.5 * rings => {
            let message = format!(
                "{} is too short a lay for {wires}: as flat rings on top of each other they need {}, and any lay more than that",
                lay.said(),
                length(rings)
            );
            lay.error(ErrorKind::Domain, message)
        }
        ("core_radius", None) => {
            let gap = match layer.gap {
                Some(gap) if gap > 0.0 => format!("leave no more than a gap of {}", length(gap)),
                _ => "leave no gap between each other".to_owned(),
            };
            let message = format!(
                "the lay is missing, and none can be found: {wires} {gap} on {} even where they are straight, and come closer the shorter their \
                 lay; give {}, or a larger core",
                length(2.0 * error.value),
                spec.ask_for(Datum::LayerLayLength)
            );
            let place = entry(|entry| entry.key.datum == Datum::LayerWires);
            match place {
                Some(entry) => entry.error(ErrorKind::Domain, message),
                None => spec.missing(Some(at), Datum::LayerLayLength, message),
            }
        }
        _ => spec.locate(at, error),
    }
}

/// The core's diameter, and the wires' filled in.
fn sizes(
    spec: &ConstructionSpec,
    mut given: Given,
    found: &mut Vec<&'static str>,
) -> Result<(Option<f64>, Given), SpecError> {
    let several = given.layers.len() > 1;
    let first = given.layers.first().cloned();
    let Some(first) = first else { return Err(spec.ask(0, Datum::LayerWires)) };
    let outer = given.outer_diameter;
    if let (Some(_), Some(entry)) = (outer, spec.head(Datum::StrandOuterDiameter)) {
        let sizes_known =
            first.wire_diameter.is_some() && (given.core_diameter.is_some() || given.core_ratio.is_some());
        if several || sizes_known {
            let why = if several {
                "of one layer alone can sizes be found from it"
            } else {
                "it follows from the sizes that are given"
            };
            let message = format!("{} is too much: {why}; remove it", entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
    }
    // anything said of a core, or a gap that only a core can hold, asks for one
    let wants_core = given.core_diameter != Some(0.0)
        && (spec.head.iter().any(|entry| entry.key.table == Table::Core) || first.gap.is_some_and(|gap| gap > 0.0));
    let core_given = match (given.core_ratio, first.wire_diameter) {
        (Some(ratio), Some(diameter)) => Some(ratio * diameter),
        _ => given.core_diameter,
    };
    let mut wire = first.wire_diameter;
    let mut core = core_given;
    match (outer, wire) {
        (Some(outer), None) => {
            found.push("wire_diameter");
            let diameter = match (given.core_ratio, core_given) {
                (Some(ratio), _) => {
                    let diameter = outer / (2.0 + ratio);
                    core = Some(ratio * diameter);
                    found.push("core_diameter");
                    diameter
                }
                (None, Some(diameter)) if diameter > 0.0 => 0.5 * (outer - room(spec, outer, diameter)?),
                _ => {
                    let lay = first.lay.ok_or_else(|| spec.ask(0, Datum::LayerLayLength))?;
                    let gap = if wants_core { first.gap.unwrap_or(0.0) } else { 0.0 };
                    let layer = WireLayer::in_outer_radius(first.wires, 0.5 * outer, gap, lay)
                        .map_err(|error| spec.locate(0, &error))?;
                    if wants_core {
                        core = Some(2.0 * layer.core_radius());
                        found.push("core_diameter");
                    } else {
                        core = None;
                        // a lay ratio or angle is that of the touching wires
                    }
                    2.0 * layer.wire_radius()
                }
            };
            wire = Some(diameter);
        }
        (Some(outer), Some(diameter)) => {
            let left = Some(outer - 2.0 * diameter).filter(|left| *left > 0.0);
            core = Some(left.ok_or_else(|| no_room(spec, "the wires alone are as wide"))?);
            found.push("core_diameter");
        }
        (None, Some(diameter)) if core.is_none() && wants_core => {
            core = Some(king_wire(spec, &first, diameter)?);
            found.push("core_diameter");
        }
        _ => {}
    }
    if let Some(layer) = given.layers.first_mut() {
        layer.wire_diameter = wire;
    }
    Ok((core, given))
}

/// The core that leaves the gap that is wanted, or none.
fn king_wire(spec: &ConstructionSpec, layer: &GivenLayer, wire_diameter: f64) -> Result<f64, SpecError> {
    let lay = layer.lay.ok_or_else(|| spec.ask(0, Datum::LayerLayLength))?;
    let (radius, gap) = (0.5 * wire_diameter, layer.gap.unwrap_or(0.0));
    let cored = WireLayer::on_king_wire(layer.wires, radius, gap, lay).map_err(|error| spec.locate(0, &error))?;
    if cored.core_radius() > 0.0 {
        return Ok(2.0 * cored.core_radius());
    }
    let message = "two wires in line contact leave no room for a core between them: give a gap, or no core";
    Err(spec.missing(Some(0), Datum::LayerGap, message))
}

/// A core's diameter, if it leaves room within the outer diameter.
fn room(spec: &ConstructionSpec, outer: f64, core: f64) -> Result<f64, SpecError> {
    if core < outer { Ok(core) } else { Err(no_room(spec, "the core alone is as wide")) }
}

fn no_room(spec: &ConstructionSpec, why: &str) -> SpecError {
    match spec.head(Datum::StrandOuterDiameter) {
        Some(entry) => entry.error(ErrorKind::Domain, format!("{} leaves no room: {why}", entry.said())),
        None => spec.missing(None, Datum::StrandOuterDiameter, why),
    }
}
