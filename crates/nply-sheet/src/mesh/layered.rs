//! Layered strands and ropes: the wires of each layer, and where its rods are strands, the wires of these.

use core::f64::consts::TAU;

use nply::Handedness;
use nply::geometry::{Centreline, DoubleHelix, Tube, WireLayer};

use super::assembly::{Assembly, CORE_COLOUR, MOST_WIRES, Wanted, Wire, outlines};
use super::subject::{LayerLine, Subject, flag};
use crate::construction::{Construction, ConstructionSpec, Core, GivenLayer};
use crate::plot::STRANDS;
use crate::{Datum, ErrorKind, SpecError};

/// A layered strand or rope as a shape, as its wires lie: on the layer below, or where they would overlap at the radius at which they
/// touch.
///
/// The wires of a strand that is a rod of a layer stand about its centreline at their lay angle in the straight strand: the lay length of a
/// strand is the one it has in the rope, along its own centreline, of turns against a frame that does not twist with it.
///
/// ```
/// use nply_sheet::construction::ConstructionSpec;
/// use nply_sheet::mesh::{Layered, Wanted};
/// let text = r#"
/// [core]
/// diameter = "4.2 mm"
/// [[layer]]
/// wires = 6
/// lay_length = "75 mm"
/// hand = "right"
/// [layer.strand.core]
/// diameter = "1.3 mm"
/// [[layer.strand.layer]]
/// wires = 6
/// wire_diameter = "1.25 mm"
/// lay_length = "32 mm"
/// hand = "left"
/// "#;
/// let rope = Layered::of(&ConstructionSpec::from_toml("rope.toml", text)?)?;
/// let wires = rope.assembly(&Wanted::default())?.wires;
/// assert_eq!((wires.len(), wires[1].name.as_str()), (6 * 7 + 1, "layer1-strand1-wire2"));
/// assert!((rope.subject().lay_length() * 1.25e-3 / 2.0 - 75e-3).abs() < 1e-12); // in wire radii
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Layered {
    subject: Subject,
    core: Option<Core>,
    layers: Vec<Laid>,
}

/// A layer as its rods lie, in the construction's unit.
#[derive(Clone, Debug, PartialEq)]
struct Laid {
    layer: WireLayer,
    hand: Handedness,
    strand: Option<Construction>,
}

/// Layers of a strand or of one within, and what they lie on.
struct Strand<'s> {
    core: Option<&'s Core>,
    layers: Vec<(WireLayer, Handedness, Option<&'s Construction>)>,
}

impl Layered {
    /// Of a description in which every size is given or can be found.
    ///
    /// # Errors
    /// [`SpecError`] as for [`ConstructionSpec::check_fit`], and for strands of strands of strands.
    pub fn of(spec: &ConstructionSpec) -> Result<Self, SpecError> {
        let fit = spec.check_fit()?;
        let several = fit.layers.len() > 1;
        let mut layers = Vec::new();
        for (at, (given, layer)) in fit.layers.iter().zip(fit.strand.layers()).enumerate() {
            let hand = match given.hand {
                None if several => return Err(spec.ask(at, Datum::LayerHand)),
                hand => hand.unwrap_or(Handedness::Right),
            };
            layers.push(Laid { layer: *layer, hand, strand: given.strand.clone() });
        }
        let core = fit.core();
        let deep = layers.iter().position(|laid| laid.strand.as_ref().is_some_and(|strand| wound(strand) > 1));
        let core_deep = core.as_ref().and_then(|core| core.strand.as_ref()).is_some_and(|strand| wound(strand) > 2);
        if deep.is_some() || core_deep {
            return Err(spec.missing(deep, Datum::LayerWires, TOO_DEEP));
        }
        let Some(outer) = layers.last() else { return Err(spec.ask(0, Datum::LayerWires)) };
        let unit = match &outer.strand {
            Some(strand) => finest(strand),
            None => outer.layer.wire_radius(),
        };
        let line = |(laid, given): (&Laid, &GivenLayer)| LayerLine {
            rods: laid.layer.wires(),
            strands: laid.strand.is_some(),
            handedness: laid.hand,
            angle: laid.layer.taken_angle(),
            gap: if laid.layer.lies_on_core() { laid.layer.gap() / unit } else { 0.0 },
            lay_is_found: given.lay.is_none(),
        };
        let subject = Subject {
            title: fit.title.clone().unwrap_or_else(|| "a layered strand".to_owned()),
            strands: outer.layer.wires(),
            angle: outer.layer.taken_angle(),
            radius_ratio: outer.layer.taken_radius() / unit,
            handedness: outer.hand,
            contact: None,
            core_radius: core.as_ref().map(|core| 0.5 * core.diameter / unit),
            pretwist: 0.0,
            values: Vec::new(),
            state: None,
            strand_radius: fit.measured.then_some(unit),
            scale: None,
            units: fit.units.clone(),
            layers: layers.iter().zip(&fit.layers).map(line).collect(),
            bare_radius: if fit.measured { 1.0 } else { unit },
        };
        Ok(Self { subject, core, layers })
    }

    /// What it is, as other shapes say it: its outermost layer, and a line on each. r is the radius of the outermost wires.
    #[must_use]
    pub const fn subject(&self) -> &Subject {
        &self.subject
    }

    /// Its wires, layer by layer from the inside, and a core that is no strand last; one lay length of the outermost layer, if no length
    /// is said.
    ///
    /// # Errors
    /// [`SpecError`] at the flag that cannot be followed, and for strands of strands of strands.
    pub fn assembly(&self, wanted: &Wanted<'_>) -> Result<Assembly, SpecError> {
        for (name, is_given, why) in [
            ("core", wanted.core.is_some(), "the core of a layered strand stands in its description"),
            ("contact-lines", wanted.contact_lines, "they are drawn of plies of one layer only"),
            ("stripes", wanted.stripes > 0, "how wires of layered strands are twisted is not known here"),
        ] {
            if is_given {
                return Err(flag(name, ErrorKind::Contradiction, format!("{why}: leave it out")));
            }
        }
        let top = super::assembly::ply_length(&self.subject, wanted, 1.0)?;
        let layers = self.layers.iter().map(|laid| (laid.layer, laid.hand, laid.strand.as_ref())).collect();
        let mut laying = Laying { unit: self.unit(), top, wanted, wires: Vec::new() };
        laying.strand(&Strand { core: self.core.as_ref(), layers }, "", true)?;
        let wires = laying.wires;
        let lines = outlines(&wires, wanted, &self.subject, top)?;
        Ok(Assembly { title: self.subject.title.clone(), wires, lines })
    }

    /// The core along the axis and all layers of wires about it, those of a strand that is the core among them; none of a rope, some of whose
    /// wires are no helices.
    pub(super) fn wires_about_the_axis(&self) -> Result<Option<AboutTheAxis>, SpecError> {
        let mut outer: Vec<_> = self.layers.iter().map(|laid| (laid.layer, laid.hand)).collect();
        let mut is_rope = self.layers.iter().any(|laid| laid.strand.is_some());
        let mut core = self.core.clone();
        while let Some(strand) = core.as_ref().and_then(|core| core.strand.clone()) {
            let Strand { layers, .. } = within(&strand)?;
            is_rope |= layers.iter().any(|(.., rod)| rod.is_some());
            let layers = layers.iter().map(|(layer, hand, _)| (*layer, *hand));
            outer.splice(0..0, layers);
            core = strand.core.clone();
        }
        let radius = core.map(|core| 0.5 * core.diameter / self.unit());
        Ok((!is_rope).then_some((radius, outer)))
    }

    /// r, the radius of the outermost wires, in the construction's unit.
    pub(super) fn unit(&self) -> f64 {
        self.subject.strand_radius.unwrap_or(self.subject.bare_radius)
    }
}

/// A core's radius in units of r, and layers from the inside.
type AboutTheAxis = (Option<f64>, Vec<(WireLayer, Handedness)>);

const TOO_DEEP: &str =
    "the wires of strands in strands of a rope are helices wound three times, and these are not drawn";

/// How many times the wires of a strand are wound.
fn wound(strand: &Construction) -> u32 {
    let core = strand.core.as_ref().and_then(|core| core.strand.as_deref()).map_or(0, wound);
    let layers = strand.layers.iter().map(|layer| 1 + layer.strand.as_deref().map_or(0, wound));
    layers.fold(core, u32::max)
}

/// The radius of the outermost wires of a strand.
fn finest(strand: &Construction) -> f64 {
    match strand.layers.last() {
        Some(layer) => layer.strand.as_deref().map_or(0.5 * layer.wire_diameter, finest),
        None => 0.5 * strand.core.as_ref().map_or(1.0, |core| core.diameter),
    }
}

fn within(strand: &Construction) -> Result<Strand<'_>, SpecError> {
    let laid = strand.laid().map_err(|error| strand.locate(0, &error))?;
    let layers = laid.layers().iter().zip(&strand.layers);
    let layers = layers.map(|(layer, given)| (*layer, given.hand, given.strand.as_deref())).collect();
    Ok(Strand { core: strand.core.as_ref(), layers })
}

/// Wires as they are laid, one after another.
struct Laying<'w> {
    /// r, in the construction's unit
    unit: f64,
    top: f64,
    wanted: &'w Wanted<'w>,
    wires: Vec<Wire>,
}

/// A refusal of the theory of a wire of sizes that were all found to be good.
fn refused(error: nply::DomainError) -> SpecError {
    flag("length", ErrorKind::Domain, error.to_string())
}

impl Laying<'_> {
    /// A strand about the axis.
    fn strand(&mut self, strand: &Strand<'_>, name: &str, outermost: bool) -> Result<(), SpecError> {
        let numbered = outermost || strand.layers.len() > 1;
        for (at, (layer, hand, rod)) in strand.layers.iter().enumerate() {
            let name = if numbered { format!("{name}layer{}-", at + 1) } else { name.to_owned() };
            for i in 0..layer.wires() {
                let azimuth = TAU * f64::from(i) / f64::from(layer.wires());
                let (radius, angle) = (layer.taken_radius() / self.unit, layer.taken_angle());
                let line = Centreline::helix(radius, angle, *hand, azimuth).map_err(refused)?;
                match rod {
                    Some(rod) => {
                        let colour = STRANDS[i as usize % STRANDS.len()];
                        self.about(line, rod, &format!("{name}strand{}-", i + 1), colour)?;
                    }
                    None => {
                        let tube = self.tube(line, layer.wire_radius())?;
                        self.push(format!("{name}wire{}", i + 1), STRANDS[at % STRANDS.len()], tube)?;
                        if let Some(wire) = self.wires.last_mut() {
                            wire.values = vec![
                                ("curvature", crate::Measure::PerLength, line.curvature()),
                                ("torsion", crate::Measure::PerLength, line.torsion()),
                            ];
                        }
                    }
                }
            }
        }
        match strand.core {
            Some(Core { strand: Some(rod), .. }) => self.strand(&within(rod)?, &format!("{name}core-"), false),
            Some(core) => {
                let tube = self.tube(Centreline::axis(), 0.5 * core.diameter)?;
                self.push(format!("{name}core"), CORE_COLOUR, tube)
            }
            None => Ok(()),
        }
    }

    /// A strand about a helix.
    fn about(&mut self, axis: Centreline, strand: &Construction, name: &str, colour: [u8; 3]) -> Result<(), SpecError> {
        let Strand { core, layers } = within(strand)?;
        for (at, (layer, hand, rod)) in layers.iter().enumerate() {
            if rod.is_some() {
                return Err(flag("length", ErrorKind::Domain, TOO_DEEP));
            }
            // turns against a frame that does not twist, less those of Frenet's against it
            let rate = hand.sign() * TAU * self.unit / layer.lay_length() - axis.torsion();
            for i in 0..layer.wires() {
                let phase = TAU * f64::from(i) / f64::from(layer.wires());
                let line = DoubleHelix::new(axis, layer.taken_radius() / self.unit, rate, phase).map_err(refused)?;
                let tube = self.tube(line, layer.wire_radius())?;
                let numbered = if layers.len() > 1 { format!("layer{}-", at + 1) } else { String::new() };
                self.push(format!("{name}{numbered}wire{}", i + 1), colour, tube)?;
            }
        }
        match core {
            Some(Core { strand: Some(rod), .. }) => self.about(axis, rod, &format!("{name}core-"), colour),
            Some(core) => {
                let tube = self.tube(axis, 0.5 * core.diameter)?;
                self.push(format!("{name}core"), colour, tube)
            }
            None => Ok(()),
        }
    }

    fn tube(&self, course: impl Into<nply::geometry::Course>, radius: f64) -> Result<Tube, SpecError> {
        let tube = Tube::new(course, radius / self.unit, 0.0, self.top).map_err(refused)?;
        Ok(tube.with_ends(self.wanted.ends))
    }

    fn push(&mut self, name: String, colour: [u8; 3], tube: Tube) -> Result<(), SpecError> {
        if self.wires.len() >= MOST_WIRES as usize {
            let message = format!("it has more wires than the {MOST_WIRES} that can be drawn");
            return Err(flag("strands", ErrorKind::Domain, message));
        }
        self.wires.push(Wire { name, colour, tube, stripes: 0, values: Vec::new() });
        Ok(())
    }
}
