//! Start geometry for finite elements: wires of straight elements that do not overlap.

mod layer;

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nply::geometry::{ChordLay, Chords};
use nply::{DomainError, Handedness};
use serde_json::{Map, Value, json};

use super::size::{length_of, positive_length};
use super::subject::flag;
use super::{Chain, Element, FileUnit, Layered, Subject};
use crate::construction::ConstructionSpec;
use crate::preferred::six_digits;
use crate::report::header;
use crate::{ErrorKind, Lay, Spec, SpecError};
use layer::{Below, StartLayer};

/// What is asked of the nodes. Lengths as they are written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StartWanted<'w> {
    /// Elements per lay length, of a layered strand per lay length of the layer that has the shortest: 24, if nothing is said.
    pub elements: Option<u32>,
    /// Of how many nodes they are.
    pub element: Element,
    /// Thickness of a coating on every wire, core included.
    pub coating: Option<&'w str>,
    /// A core wire along the axis; with an empty text, one as thick as the others.
    pub core: Option<&'w str>,
    /// By how many elements each wire's nodes stand farther along than those of the one before; none: at the same heights.
    pub stagger: Option<f64>,
    /// Whether the wires are to be clear at any stagger.
    pub any_stagger: bool,
    /// A helix radius that is held, clear or not.
    pub helix_radius: Option<&'w str>,
    /// The length along the axis; else `lay_lengths` tell it.
    pub length: Option<&'w str>,
    /// Lay lengths: 3, if neither is said.
    pub lay_lengths: Option<f64>,
}

/// The narrowest lay of straight elements that are clear of each other, its nodes, and how much chords took.
///
/// What is clear are the chords between neighbouring nodes: of elements of three nodes these are two an element. Such elements bend away from
/// their chords, towards the helix.
#[derive(Clone, Debug, PartialEq)]
pub struct StartGeometry {
    ply: Subject,
    /// Whether the lay length was held, and not the angle.
    by_length: bool,
    /// From the inside; of a ply one.
    layers: Vec<StartLayer>,
    /// A core along the axis, in units of r.
    core: Option<f64>,
    elements: u32,
    element: Element,
    stagger: f64,
    any_stagger: bool,
    /// The height of an element, in units of r.
    rise: f64,
    /// The length along the axis, in units of r.
    length: f64,
}

const ELEMENTS: u32 = 24;
const TURNS: f64 = 3.0;

impl StartGeometry {
    /// Finds the lay of a ply.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check_shape`], and at the flag that cannot be followed.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::{StartGeometry, StartWanted};
    /// let spec = Spec::from_flags([("strands", "6"), ("helical-angle", "17.44 deg")])?;
    /// let start = StartGeometry::of(&spec, &StartWanted { core: Some(""), ..StartWanted::default() })?;
    /// let lay = start.lays().next().unwrap();
    /// assert!(lay.radius_ratio > 2.0 && lay.least_distance >= 2.0);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(spec: &Spec, wanted: &StartWanted<'_>) -> Result<Self, SpecError> {
        let shape = spec.check_shape()?;
        let ply = Subject::of_lay(spec)?;
        let radius = ply.strand_radius;
        let (coating, stagger) = (coating(&ply, wanted)?, stagger(wanted)?);
        let core = match wanted.core {
            None => ply.core_radius,
            Some("") => Some(1.0),
            Some(text) => Some(positive_length("core", text, radius, false)?),
        };
        let distance = 2.0 + 2.0 * coating;
        let from_core = core.map_or(0.0, |core| 1.0 + core + 2.0 * coating);
        let elements = wanted.elements.unwrap_or(ELEMENTS);
        let chords_per_turn = f64::from(elements) * f64::from(wanted.element.chords());
        let located = |error: DomainError| match error.quantity {
            "elements" => elements_refused(&error),
            _ => shape.locate(&error),
        };
        let lay_length = match shape.lay {
            Some(Lay::LayLength(length)) => Some(length),
            _ => None,
        };
        let narrowest = |stagger: Option<f64>| {
            let lay = match lay_length {
                Some(length) => {
                    Chords::narrowest_of_lay_length(ply.strands, length, chords_per_turn, distance, from_core, stagger)
                }
                None => Chords::new(ply.strands, ply.angle, chords_per_turn)
                    .and_then(|chords| chords.narrowest(distance, from_core, stagger)),
            };
            lay.map_err(located)
        };
        let at_any = narrowest(None)?;
        let as_asked = (!wanted.any_stagger).then(|| stagger * f64::from(wanted.element.chords()));
        let clear = if wanted.any_stagger { at_any } else { narrowest(as_asked)? };
        let held = match wanted.helix_radius {
            None => None,
            Some(text) => {
                let radius = positive_length("lay-radius", text, radius, false)?;
                let chords = match lay_length {
                    // the lay length is held, and the angle follows
                    Some(length) => nply::geometry::HelicalAngle::new(libm::atan(TAU * radius / length))
                        .and_then(|angle| Chords::new(ply.strands, angle, chords_per_turn)),
                    None => Chords::new(ply.strands, ply.angle, chords_per_turn),
                };
                Some(chords.map_err(located)?.laid(radius, as_asked))
            }
        };
        let layer = StartLayer {
            wire_radius: 1.0,
            hand: ply.handedness,
            lay: held.unwrap_or(clear),
            clear: held.map(|_| clear),
            at_any,
            laid: None,
            wanted: distance,
            coating,
            core,
        };
        Ok(Self {
            by_length: lay_length.is_some(),
            core,
            elements,
            element: wanted.element,
            stagger,
            any_stagger: wanted.any_stagger,
            rise: layer.lay_length() / f64::from(elements),
            length: long(&ply, wanted, layer.lay_length())?,
            layers: vec![layer],
            ply,
        })
    }

    /// Finds the lays of a strand of layers: from the inside, each the narrowest whose elements are clear of each other and, wherever its
    /// nodes stand, of all that lies below it. Lay lengths are held; of all wires the nodes stand at the same heights.
    ///
    /// # Errors
    /// [`SpecError`] as for [`ConstructionSpec::check_fit`], for a rope, and at the flag that cannot be followed.
    ///
    /// ```
    /// use nply_sheet::construction::ConstructionSpec;
    /// use nply_sheet::mesh::{StartGeometry, StartWanted};
    /// let flags = [("core-diameter", "4.3 mm"), ("strands", "6"), ("wire-diameter", "4.2 mm"), ("lay-length", "177.8 mm")];
    /// let start = StartGeometry::of_layers(&ConstructionSpec::from_flags(flags)?, &StartWanted::default())?;
    /// // the middles of the chords lie on the king wire, the nodes a chord's height farther out
    /// let lay = start.lays().next().unwrap();
    /// assert!((2.1 * lay.radius_ratio - 4.25 / (core::f64::consts::PI / 24.0).cos()).abs() < 1e-9);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of_layers(spec: &ConstructionSpec, wanted: &StartWanted<'_>) -> Result<Self, SpecError> {
        for (name, is_given, why) in [
            ("core", wanted.core.is_some(), "the core of a layered strand stands in its description"),
            ("lay-radius", wanted.helix_radius.is_some(), "each layer has a radius of its own"),
        ] {
            if is_given {
                return Err(flag(name, ErrorKind::Contradiction, format!("{why}: leave it out")));
            }
        }
        let strand = Layered::of(spec)?;
        let Some((core, laid)) = strand.wires_about_the_axis()? else {
            let message = "this describes a rope, and clear elements are found for wires that are helices: `nodes` takes one of its \
                           strands, and `mesh --centrelines` writes the nodes of all its wires, as they lie";
            return Err(spec.not_taken(message));
        };
        let ply = strand.subject().clone();
        let (coating, stagger) = (coating(&ply, wanted)?, stagger(wanted)?);
        let elements = wanted.elements.unwrap_or(ELEMENTS);
        let chords = f64::from(wanted.element.chords());
        let shortest = laid.iter().map(|(layer, _)| layer.lay_length()).fold(f64::INFINITY, f64::min);
        let per_radius = strand.unit();
        // the flags count layers of the description, and a strand within has its own
        let within = laid.len() - ply.layers.len();
        let mut below = core;
        let mut layers: Vec<StartLayer> = Vec::new();
        for (at, (layer, hand)) in laid.iter().enumerate() {
            let radius = layer.wire_radius() / per_radius;
            let (core, coating) = (below.map(|below| below / radius), coating / radius);
            let (distance, from_core) = (2.0 + 2.0 * coating, core.map_or(0.0, |core| 1.0 + core + 2.0 * coating));
            let lay_length = layer.lay_length() / layer.wire_radius();
            let per_turn = f64::from(elements) * chords * layer.lay_length() / shortest;
            let narrowest = |stagger: Option<f64>| {
                Chords::narrowest_of_lay_length(layer.wires(), lay_length, per_turn, distance, from_core, stagger)
                    .map_err(|error| match error.quantity {
                        "elements" => elements_refused(&error),
                        _ => {
                            let value = error.value * layer.wire_radius();
                            spec.locate(at.saturating_sub(within), &DomainError { value, ..error })
                        }
                    })
            };
            let at_any = narrowest(None)?;
            let lay = if wanted.any_stagger { at_any } else { narrowest(Some(stagger * chords))? };
            let outer = radius * (1.0 + lay.radius_ratio);
            below = Some(below.map_or(outer, |below| below.max(outer)));
            layers.push(StartLayer {
                wire_radius: radius,
                hand: *hand,
                lay,
                clear: None,
                at_any,
                laid: Some(layer.taken_radius() / layer.wire_radius()),
                wanted: distance,
                coating,
                core,
            });
        }
        Ok(Self {
            by_length: true,
            core,
            elements,
            element: wanted.element,
            stagger,
            any_stagger: wanted.any_stagger,
            rise: shortest / per_radius / f64::from(elements),
            length: long(&ply, wanted, ply.lay_length())?,
            layers,
            ply,
        })
    }

    /// The lays whose nodes are given, from the inside: of a ply one. Each in units of its wires' radius.
    pub fn lays(&self) -> impl Iterator<Item = &ChordLay> {
        self.layers.iter().map(|layer| &layer.lay)
    }

    /// The ply or strand, as it was described.
    #[must_use]
    pub const fn ply(&self) -> &Subject {
        &self.ply
    }

    /// What a file of its nodes is called.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{} wires of straight elements", self.wires())
    }

    /// Wires in layers; a core is none of them.
    fn wires(&self) -> u32 {
        self.lays().map(|lay| lay.chords.strands()).sum()
    }

    /// Whether this is a strand of layers, and not a ply.
    fn is_layered(&self) -> bool {
        !self.ply.layers.is_empty()
    }

    /// How many elements make up the length; what is less than rounding is no element more.
    fn whole_elements(&self) -> f64 {
        libm::ceil(self.length / self.rise - 1e-9).max(1.0)
    }

    /// That the wires are longer than was wanted, where whole elements make them so: these keep their length, for which the lay was found.
    fn rounded_up(&self, unit: &FileUnit, name: &str) -> Option<String> {
        let whole = self.whole_elements();
        let reached = whole * self.rise;
        let told = |length: f64| six_digits(length * unit.per_radius);
        let elements = if whole > 1.0 { "whole elements" } else { "whole element" };
        (reached > self.length * (1.0 + 1e-9)).then(|| {
            format!(
                "The nodes reach {} {name}, {whole} {elements}: {} {name} would end within one.",
                told(reached),
                told(self.length)
            )
        })
    }

    /// The nodes: of each wire as many elements as make up the length, rounded up to a whole one.
    ///
    /// # Errors
    /// [`SpecError`] for too many nodes.
    pub fn chains(&self) -> Result<Vec<Chain>, SpecError> {
        const MOST_NODES: f64 = 20_000_000.0;
        let chords = self.element.chords();
        let count = self.whole_elements() * f64::from(chords);
        if count * f64::from(self.wires() + 1) > MOST_NODES {
            let message =
                format!("more than {MOST_NODES} nodes would be needed: give a shorter length, or fewer elements");
            return Err(flag("elements-per-pitch", ErrorKind::Domain, message));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held below twenty million")]
        let count = count as u32;
        let mut chains = Vec::new();
        for (at, layer) in self.layers.iter().enumerate() {
            for i in 0..layer.lay.chords.strands() {
                let name = match self.is_layered() {
                    true => format!("layer{}-wire{}", at + 1, i + 1),
                    false => format!("strand-{}", i + 1),
                };
                let number = u32::try_from(chains.len()).unwrap_or(u32::MAX).saturating_add(1);
                chains.push(self.chain(layer, i, count, name, number));
            }
        }
        if let Some(radius) = self.core {
            let step = self.rise / f64::from(chords);
            let heights: Vec<f64> = (0..=count).map(|k| step * f64::from(k)).collect();
            chains.push(Chain {
                name: "core".to_owned(),
                number: 0,
                radius,
                points: heights.iter().map(|z| [0.0, 0.0, *z]).collect(),
                tangents: vec![[0.0, 0.0, 1.0]; heights.len()],
                arclengths: heights,
                element: self.element,
            });
        }
        Ok(chains)
    }

    /// The nodes of the wire i of a layer, so many chords long.
    fn chain(&self, layer: &StartLayer, i: u32, count: u32, name: String, number: u32) -> Chain {
        let chords = &layer.lay.chords;
        let (rho, angle) = (layer.lay.radius_ratio * layer.wire_radius, chords.angle());
        let mirror = layer.hand.sign();
        let step = rho * chords.rise() / angle.cos();
        let turned = TAU * f64::from(i) / f64::from(chords.strands());
        // elements farther along, of which whole ones make no difference
        let shift = self.stagger * f64::from(i);
        let shift = f64::from(self.element.chords()) * (shift - libm::floor(shift));
        let along = |k: u32| f64::from(k) + shift;
        let points: Vec<_> = (0..=count)
            .map(|k| {
                let [x, y, z] = chords.node(turned, along(k));
                [mirror * rho * x, rho * y, rho * z]
            })
            .collect();
        // round the axis, and up
        let tangents = points.iter().map(|[x, y, _]| {
            let (round, up) = (mirror * angle.sin() / rho, angle.cos());
            [-round * y, round * x, up]
        });
        Chain {
            name,
            number,
            radius: layer.wire_radius,
            tangents: tangents.collect(),
            arclengths: (0..=count).map(|k| step * along(k)).collect(),
            points,
            element: self.element,
        }
    }

    /// Whether the elements are as far apart as is wanted, to rounding.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        self.layers.iter().all(StartLayer::is_clear)
    }

    /// As a table.
    #[must_use]
    pub fn text(&self, unit: &FileUnit) -> String {
        let mut out = String::new();
        let each = match self.element.chords() {
            1 => "",
            _ => " of two chords each",
        };
        if self.is_layered() {
            let core = if self.core.is_some() { "A core and " } else { "" };
            let _ = writeln!(
                out,
                "{core}{} wires of straight elements, {}{each} to the shortest lay length",
                self.wires(),
                self.elements,
            );
        }
        let name = if unit.name == "r" { "strand radii" } else { &unit.name };
        for (at, layer) in self.layers.iter().enumerate() {
            let chords = &layer.lay.chords;
            let hand = if layer.hand == Handedness::Right { "right-handed (Z)" } else { "left-handed (S)" };
            let angle = six_digits(chords.angle().degrees());
            let _ = match self.is_layered() {
                true => writeln!(
                    out,
                    "\nlayer {}: {} wires, {hand}, helical angle {angle}°, {} elements to its lay length\n",
                    at + 1,
                    chords.strands(),
                    six_digits(chords.elements() / f64::from(self.element.chords())),
                ),
                false => writeln!(
                    out,
                    "{} wires of straight elements, {}{each} to a lay length: {hand}, helical angle {angle}°{}\n",
                    chords.strands(),
                    self.elements,
                    if self.by_length { " at the lay length given" } else { "" },
                ),
            };
            let below = if self.is_layered() && at > 0 { Below::Layer } else { Below::Core };
            for (_, label, value, is_length) in layer.items(below).into_iter().filter(|item| item.2.is_finite()) {
                // what is nothing but rounding is nothing
                let value = if value.abs() < 1e-12 { 0.0 } else { value };
                let scale = layer.wire_radius * unit.per_radius;
                let (value, name) = if is_length { (value * scale, name) } else { (value, "") };
                let _ = writeln!(out, "  {label:42}{:>13} {name}", six_digits(value));
            }
        }
        let stand = if self.any_stagger {
            "The elements are clear wherever the nodes of one wire stand beside those of another.".to_owned()
        } else if self.stagger == 0.0 {
            "The nodes of all wires stand at the same heights.".to_owned()
        } else {
            format!("Each wire's nodes stand {} elements farther along than those of the one before.", self.stagger)
        };
        let _ = writeln!(out, "\n{stand}");
        if let Some(sentence) = self.rounded_up(unit, name) {
            let _ = writeln!(out, "{sentence}");
        }
        for sentence in self.ply.found_lays() {
            let _ = writeln!(out, "{sentence}");
        }
        let loose = self.layers.iter().enumerate().filter(|(_, layer)| layer.is_loose());
        for (at, layer) in loose {
            let gap = six_digits(layer.core_gap().unwrap_or(0.0) * layer.wire_radius * unit.per_radius);
            let wires =
                if self.is_layered() { format!("The wires of layer {}", at + 1) } else { "The wires".to_owned() };
            let below = if self.is_layered() && at > 0 { "layer below" } else { "core" };
            let _ = writeln!(
                out,
                "{wires} carry each other and do not reach the {below}: their elements stand {gap} {name} off it."
            );
        }
        if !self.is_clear() {
            let _ = writeln!(out, "The elements overlap: the helix radius must be at least that which clears.");
        }
        out
    }

    /// As JSON, lengths in units of r; where r is known, in m too under `si`. Of a layered strand layer by layer.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        let stagger = if self.any_stagger { Value::Null } else { json!(self.stagger) };
        let kept =
            [("stagger", stagger), ("element_type", json!(self.element.name())), ("clear", json!(self.is_clear()))];
        let radius = self.ply.strand_radius;
        if self.is_layered() {
            top.insert("elements_per_shortest_lay_length".into(), json!(self.elements));
            top.extend(kept.map(|(name, value)| (name.to_owned(), value)));
            let layer = |(at, layer): (usize, &StartLayer)| {
                let mut object = Map::new();
                let per_turn = layer.lay.chords.elements() / f64::from(self.element.chords());
                layer.head(&mut object, json!(per_turn));
                let below = if at > 0 { Below::Layer } else { Below::Core };
                layer.lengths(&mut object, below, radius);
                Value::Object(object)
            };
            top.insert("layers".into(), self.layers.iter().enumerate().map(layer).collect());
            top.insert("notes".into(), json!(self.ply.found_lays()));
        } else {
            for layer in &self.layers {
                layer.head(&mut top, json!(self.elements));
                top.extend(kept.clone().map(|(name, value)| (name.to_owned(), value)));
                layer.lengths(&mut top, Below::Core, radius);
            }
        }
        format!("{:#}\n", Value::Object(top))
    }
}

/// The coating's thickness, in units of r.
fn coating(ply: &Subject, wanted: &StartWanted<'_>) -> Result<f64, SpecError> {
    let coating = wanted.coating.map_or(Ok(0.0), |text| length_of("coating", text, ply))?;
    if (0.0..f64::INFINITY).contains(&coating) {
        return Ok(coating);
    }
    Err(flag("coating", ErrorKind::Domain, "a coating must have a thickness of at least 0"))
}

fn stagger(wanted: &StartWanted<'_>) -> Result<f64, SpecError> {
    let stagger = wanted.stagger.unwrap_or(0.0);
    if stagger.is_finite() {
        return Ok(stagger);
    }
    Err(flag("stagger", ErrorKind::Domain, "a stagger must be a finite number of elements"))
}

/// How much of the ply, in units of r.
fn long(ply: &Subject, wanted: &StartWanted<'_>, lay_length: f64) -> Result<f64, SpecError> {
    match (wanted.length, wanted.lay_lengths) {
        (Some(_), Some(_)) => {
            let message = "--length and --lay-lengths both say how much of the ply: remove one of them";
            Err(flag("length", ErrorKind::Contradiction, message))
        }
        (Some(text), None) => {
            let length = length_of("length", text, ply)?;
            if length > 0.0 && length < f64::INFINITY {
                return Ok(length);
            }
            Err(flag("length", ErrorKind::Domain, format!("{}: it must be greater than 0", crate::quoted(text))))
        }
        (None, Some(turns)) if turns > 0.0 && turns < f64::INFINITY => Ok(turns * lay_length),
        (None, Some(_)) => Err(flag("lay-lengths", ErrorKind::Domain, "it must be a number greater than 0")),
        (None, None) => Ok(TURNS * lay_length),
    }
}

fn elements_refused(error: &DomainError) -> SpecError {
    flag("elements-per-pitch", ErrorKind::Domain, error.to_string())
}
