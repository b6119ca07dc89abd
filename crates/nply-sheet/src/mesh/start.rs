//! Start geometry for finite elements: wires of straight elements that do not overlap.

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nply::geometry::{ChordLay, Chords};
use nply::{DomainError, Handedness};
use serde_json::{Map, Value, json};

use super::size::{length, positive_length};
use super::subject::flag;
use super::{Chain, FileUnit, Subject};
use crate::preferred::six_digits;
use crate::report::header;
use crate::{ErrorKind, Lay, Spec, SpecError};

/// What is asked of the nodes. Lengths as they are written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StartWanted<'w> {
    /// Elements per lay length: 24, if nothing is said.
    pub elements: Option<u32>,
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
#[derive(Clone, Debug, PartialEq)]
pub struct StartGeometry {
    ply: Subject,
    /// Whether the lay length was held, and not the angle.
    by_length: bool,
    /// The lay that is written.
    lay: ChordLay,
    /// The narrowest lay that clears, where another radius was held.
    clear: Option<ChordLay>,
    /// The narrowest lay that is clear at any stagger.
    at_any: ChordLay,
    wanted: f64,
    coating: f64,
    core: Option<f64>,
    stagger: f64,
    any_stagger: bool,
    turns: f64,
}

impl StartGeometry {
    /// Finds the lay.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check_shape`], and at the flag that cannot be followed.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::{StartGeometry, StartWanted};
    /// let spec = Spec::from_flags([("strands", "6"), ("helical-angle", "17.44 deg")])?;
    /// let start = StartGeometry::of(&spec, &StartWanted { core: Some(""), ..StartWanted::default() })?;
    /// assert!(start.lay().radius_ratio > 2.0 && start.lay().least_distance >= 2.0);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(spec: &Spec, wanted: &StartWanted<'_>) -> Result<Self, SpecError> {
        const ELEMENTS: u32 = 24;
        let shape = spec.check_shape()?;
        let ply = Subject::of_lay(spec)?;
        let radius = ply.strand_radius;
        let coating = wanted.coating.map_or(Ok(0.0), |text| length("coating", text, radius, false))?;
        if !(0.0..f64::INFINITY).contains(&coating) {
            return Err(flag("coating", ErrorKind::Domain, "a coating must have a thickness of at least 0"));
        }
        let core = match wanted.core {
            None => ply.core_radius,
            Some("") => Some(1.0),
            Some(text) => Some(positive_length("core", text, radius, false)?),
        };
        let stagger = wanted.stagger.unwrap_or(0.0);
        if !stagger.is_finite() {
            return Err(flag("stagger", ErrorKind::Domain, "a stagger must be a finite number of elements"));
        }
        let distance = 2.0 + 2.0 * coating;
        let from_core = core.map_or(0.0, |core| 1.0 + core + 2.0 * coating);
        let elements = wanted.elements.unwrap_or(ELEMENTS);
        let located = |error: DomainError| match error.quantity {
            "elements" => flag("elements-per-pitch", ErrorKind::Domain, error.to_string()),
            _ => shape.locate(&error),
        };
        let lay_length = match shape.lay {
            Some(Lay::LayLength(length)) => Some(length),
            _ => None,
        };
        let narrowest = |stagger: Option<f64>| {
            let lay = match lay_length {
                Some(length) => {
                    Chords::narrowest_of_lay_length(ply.strands, length, elements, distance, from_core, stagger)
                }
                None => Chords::new(ply.strands, ply.angle, elements)
                    .and_then(|chords| chords.narrowest(distance, from_core, stagger)),
            };
            lay.map_err(located)
        };
        let at_any = narrowest(None)?;
        let as_asked = if wanted.any_stagger { None } else { Some(stagger) };
        let clear = if wanted.any_stagger { at_any } else { narrowest(as_asked)? };
        let held = match wanted.helix_radius {
            None => None,
            Some(text) => {
                let radius = positive_length("lay-radius", text, radius, false)?;
                let chords = match lay_length {
                    // the lay length is held, and the angle follows
                    Some(length) => nply::geometry::HelicalAngle::new(libm::atan(TAU * radius / length))
                        .and_then(|angle| Chords::new(ply.strands, angle, elements)),
                    None => Chords::new(ply.strands, ply.angle, elements),
                };
                Some(chords.map_err(located)?.laid(radius, as_asked))
            }
        };
        let lay = held.unwrap_or(clear);
        let pitch = TAU * lay.radius_ratio / lay.chords.angle().tan();
        let turns = match (wanted.length, wanted.lay_lengths) {
            (Some(_), Some(_)) => {
                let message = "--length and --lay-lengths both say how much of the ply: remove one of them";
                return Err(flag("length", ErrorKind::Contradiction, message));
            }
            (Some(text), None) => positive_length("length", text, radius, false)? / pitch,
            (None, Some(turns)) if turns > 0.0 && turns < f64::INFINITY => turns,
            (None, Some(_)) => {
                return Err(flag("lay-lengths", ErrorKind::Domain, "it must be a number greater than 0"));
            }
            (None, None) => 3.0,
        };
        Ok(Self {
            by_length: lay_length.is_some(),
            ply,
            lay,
            clear: held.map(|_| clear),
            at_any,
            wanted: distance,
            coating,
            core,
            stagger,
            any_stagger: wanted.any_stagger,
            turns,
        })
    }

    /// The lay whose nodes are given.
    #[must_use]
    pub const fn lay(&self) -> &ChordLay {
        &self.lay
    }

    /// The ply, as it was described.
    #[must_use]
    pub const fn ply(&self) -> &Subject {
        &self.ply
    }

    /// The nodes: of each wire as many elements as make up the length, rounded up to a whole one.
    ///
    /// # Errors
    /// [`SpecError`] for too many nodes.
    pub fn chains(&self) -> Result<Vec<Chain>, SpecError> {
        const MOST_NODES: f64 = 20_000_000.0;
        let chords = &self.lay.chords;
        let count = libm::ceil(self.turns * f64::from(chords.elements()) - 1e-9).max(1.0);
        if count * f64::from(self.ply.strands + 1) > MOST_NODES {
            let message =
                format!("more than {MOST_NODES} nodes would be needed: give a shorter length, or fewer elements");
            return Err(flag("elements-per-pitch", ErrorKind::Domain, message));
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held below twenty million")]
        let count = count as u32;
        let (rho, angle) = (self.lay.radius_ratio, chords.angle());
        let mirror = if self.ply.handedness == Handedness::Left { -1.0 } else { 1.0 };
        let step = rho * chords.rise() / angle.cos();
        let mut chains: Vec<Chain> = (0..self.ply.strands)
            .map(|i| {
                let turned = TAU * f64::from(i) / f64::from(self.ply.strands);
                let shift = self.stagger * f64::from(i);
                let along = |k: u32| f64::from(k) + shift - libm::floor(shift);
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
                    name: format!("strand-{}", i + 1),
                    number: i + 1,
                    radius: 1.0,
                    tangents: tangents.collect(),
                    arclengths: (0..=count).map(|k| step * along(k)).collect(),
                    points,
                }
            })
            .collect();
        if let Some(radius) = self.core {
            let heights: Vec<f64> = (0..=count).map(|k| rho * chords.rise() * f64::from(k)).collect();
            chains.push(Chain {
                name: "core".to_owned(),
                number: 0,
                radius,
                points: heights.iter().map(|z| [0.0, 0.0, *z]).collect(),
                tangents: vec![[0.0, 0.0, 1.0]; heights.len()],
                arclengths: heights,
            });
        }
        Ok(chains)
    }

    /// What is reported: name in JSON, words, value in units of r, or bare where it is no length.
    fn items(&self) -> Vec<(&'static str, &'static str, f64, bool)> {
        let lay = &self.lay;
        let mut items = vec![
            ("helix_radius", "helix radius", lay.radius_ratio, true),
            ("lay_length", "lay length", TAU * lay.radius_ratio / lay.chords.angle().tan(), true),
            ("wanted_distance", "distance wanted: diameter and coatings", self.wanted, true),
            ("smooth_distance", "least distance of the helices", lay.smooth_distance, true),
            ("element_distance", "least distance of the elements", lay.least_distance, true),
            ("geometric_gap", "gap of the helices", lay.smooth_distance - self.wanted, true),
            ("chord_share", "of this lost to chords", lay.smooth_distance - lay.least_distance, true),
            ("gap", "gap of the elements", lay.least_distance - self.wanted, true),
        ];
        if let Some(core) = self.core {
            let wanted = 1.0 + core + 2.0 * self.coating;
            let nearest = lay.radius_ratio * lay.chords.core_distance();
            items.extend([
                ("core_radius", "core radius", core, true),
                ("core_geometric_gap", "gap of the helices to the core", lay.radius_ratio - wanted, true),
                ("core_chord_share", "of this lost to chords", lay.radius_ratio - nearest, true),
                ("core_gap", "gap of the elements to the core", nearest - wanted, true),
            ]);
        }
        if let Some(clear) = &self.clear {
            items.push(("least_helix_radius", "least helix radius that clears", clear.radius_ratio, true));
        }
        items.push((
            "any_stagger_helix_radius",
            "least helix radius, nodes at any stagger",
            self.at_any.radius_ratio,
            true,
        ));
        items
    }

    /// Whether the elements are as far apart as is wanted, to rounding.
    #[must_use]
    pub fn is_clear(&self) -> bool {
        const ROUNDING: f64 = 1e-9;
        let core = self.core.is_none_or(|core| {
            self.lay.radius_ratio * self.lay.chords.core_distance()
                >= (1.0 + core + 2.0 * self.coating) * (1.0 - ROUNDING)
        });
        core && self.lay.least_distance >= self.wanted * (1.0 - ROUNDING)
    }

    /// As a table.
    #[must_use]
    pub fn text(&self, unit: &FileUnit) -> String {
        let chords = &self.lay.chords;
        let hand = if self.ply.handedness == Handedness::Right { "right-handed (Z)" } else { "left-handed (S)" };
        let mut out = format!(
            "{} wires of straight elements, {} to a lay length: {hand}, helical angle {}°{}\n\n",
            self.ply.strands,
            chords.elements(),
            six_digits(chords.angle().degrees()),
            if self.by_length { " at the lay length given" } else { "" },
        );
        let name = if unit.name == "r" { "strand radii" } else { &unit.name };
        for (_, label, value, is_length) in self.items().into_iter().filter(|item| item.2.is_finite()) {
            // what is nothing but rounding is nothing
            let value = if value.abs() < 1e-12 { 0.0 } else { value };
            let (value, name) = if is_length { (value * unit.per_radius, name) } else { (value, "") };
            let _ = writeln!(out, "  {label:42}{:>13} {name}", six_digits(value));
        }
        let stand = if self.any_stagger {
            "The elements are clear wherever the nodes of one wire stand beside those of another.".to_owned()
        } else if self.stagger == 0.0 {
            "The nodes of all wires stand at the same heights.".to_owned()
        } else {
            format!("Each wire's nodes stand {} elements farther along than those of the one before.", self.stagger)
        };
        let _ = writeln!(out, "\n{stand}");
        if !self.is_clear() {
            let _ = writeln!(out, "The elements overlap: the helix radius must be at least that which clears.");
        }
        out
    }

    /// As JSON, lengths in units of r; where r is known, in m too under `si`.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        top.insert("strands".into(), json!(self.ply.strands));
        top.insert("handedness".into(), json!(if self.ply.handedness == Handedness::Right { 1 } else { -1 }));
        top.insert("elements_per_lay_length".into(), json!(self.lay.chords.elements()));
        top.insert("helical_angle_deg".into(), json!(self.lay.chords.angle().degrees()));
        let stagger = if self.any_stagger { Value::Null } else { json!(self.stagger) };
        top.insert("stagger".into(), stagger);
        top.insert("clear".into(), json!(self.is_clear()));
        let mut si = Map::new();
        for (name, _, value, is_length) in self.items() {
            top.insert(name.into(), json!(value));
            if let (true, Some(radius)) = (is_length, self.ply.strand_radius) {
                si.insert(name.into(), json!(value * radius));
            }
        }
        if !si.is_empty() {
            top.insert("si".into(), Value::Object(si));
        }
        format!("{:#}\n", Value::Object(top))
    }
}
