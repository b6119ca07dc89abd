//! Geometry alone: what `nply contact` says.

use core::fmt::Write as _;

use nply::geometry::{Branch, BranchKind, Contact, DensestHelix, Section, branches};
use serde_json::{Map, Value, json};

use super::json::header;
use super::measure::{Known, Measure};
use super::text::{Emphasis, Row, lay_out};
use crate::preferred::six_digits;
use crate::{Shape, SpecError};

/// The contact of neighbours at a given lay, or for n = 1 the densest helix.
///
/// ```
/// use nply_sheet::{ShapeReport, Spec};
/// let shape = Spec::from_flags([("strands", "6"), ("helical-angle", "20 deg")])?.check_shape()?;
/// let report = ShapeReport::of(shape, 0)?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert!((json["radius_ratio"].as_f64().unwrap_or(0.0) - 2.0998).abs() < 5e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeReport {
    shape: Shape,
    geometry: Geometry,
    branches: Vec<Branch>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Geometry {
    Ply { contact: Contact, convex: bool },
    Single(DensestHelix),
}

/// A reported length, angle or ratio: name in JSON, words, kind, value.
pub(super) type Item = (&'static str, &'static str, Measure, f64);

/// Name, words, kind, dimensionless value.
pub(super) type ContactItem = (&'static str, &'static str, Measure, fn(&Contact) -> f64);

/// Every number of the contact of neighbours.
pub(super) const CONTACT: &[ContactItem] = {
    use Measure::{Degrees, Length, Number, PerLength, TurnsPerLength};
    &[
        ("helical_angle_deg", "helical angle (lay angle)", Degrees, |c| c.angle().degrees()),
        ("pitch_angle_deg", "pitch angle", Degrees, |c| c.pitch_angle().to_degrees()),
        ("lay_length", "lay length", Length, Contact::lay_length),
        ("lay_ratio", "lay ratio (lay length/outer diameter)", Number, Contact::lay_ratio),
        ("turns_per_ply_length", "turns per ply length", TurnsPerLength, |c| 1.0 / c.lay_length()),
        ("radius_ratio", "helix radius/strand radius", Number, Contact::radius_ratio),
        ("radius_ratio_slope", "its slope by helical angle, per rad", Number, Contact::radius_ratio_slope),
        ("outer_diameter", "outer diameter", Length, |c| 2.0 * c.outer_radius()),
        ("hole_radius", "hole radius", Length, Contact::hole_radius),
        ("contact_line_radius", "contact line radius", Length, Contact::contact_line_radius),
        ("arclength_shift", "arclength shift/helix radius", Number, Contact::arclength_shift),
        ("shift_ratio_squared", "(arclength shift/strand diameter)²", Number, Contact::shift_ratio_squared),
        ("curvature", "curvature of a strand", PerLength, Contact::curvature),
        ("torsion", "torsion of a strand", PerLength, Contact::torsion),
        ("non_convex_angle_deg", "cut not convex above", Degrees, |c| {
            Section::non_convex_angle(c.strands()).map_or(f64::NAN, |angle| angle.degrees())
        }),
    ]
};

/// Every number of the densest helix of a single tube.
pub(super) fn single() -> Vec<Item> {
    of_helix(&DensestHelix::new())
}

fn of_helix(helix: &DensestHelix) -> Vec<Item> {
    use Measure::{Degrees, Length, Number, PerLength};
    vec![
        ("helical_angle_deg", "helical angle (lay angle)", Degrees, helix.angle().degrees()),
        ("pitch_angle_deg", "pitch angle", Degrees, helix.angle().pitch_angle().to_degrees()),
        ("radius_ratio", "helix radius/tube radius", Number, helix.radius_ratio()),
        ("arclength_shift", "arclength shift/helix radius", Number, helix.arclength_shift()),
        ("lay_length", "pitch", Length, helix.pitch()),
        ("curvature", "curvature", PerLength, 1.0),
    ]
}

impl ShapeReport {
    /// Finds the contact, and up to `most` solutions of the contact condition, satellites included.
    ///
    /// # Errors
    /// [`SpecError`] for a lay that no ply of so many strands can have.
    pub fn of(shape: Shape, most: usize) -> Result<Self, SpecError> {
        let Some(lay) = shape.lay else {
            return Ok(Self { shape, geometry: Geometry::Single(DensestHelix::new()), branches: Vec::new() });
        };
        let located = |error| shape.locate(&error);
        let contact = lay.contact(shape.strands).map_err(located)?;
        let convex = Section::new(&contact, nply::Handedness::Right).is_convex();
        let found =
            if most > 0 { branches(shape.strands, contact.angle(), most).map_err(located)? } else { Vec::new() };
        Ok(Self { shape, geometry: Geometry::Ply { contact, convex }, branches: found })
    }

    fn items(&self) -> Vec<Item> {
        match &self.geometry {
            Geometry::Single(helix) => of_helix(helix),
            Geometry::Ply { contact, .. } => {
                let value = |of: fn(&Contact) -> f64| of(contact);
                CONTACT.iter().map(|(name, label, measure, of)| (*name, *label, *measure, value(*of))).collect()
            }
        }
    }

    fn known(&self) -> Known {
        Known { scale: None, strand_radius: self.shape.strand_radius }
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let headline = match self.geometry {
            Geometry::Single(_) => "A single tube, touching its own next turn: the densest helix".to_owned(),
            Geometry::Ply { .. } => format!("{} touching strands", self.shape.strands),
        };
        let _ = writeln!(out, "{}", emphasis.heading(&headline));
        let mut rows = Vec::new();
        if self.shape.strand_radius.is_some() {
            let reading = Measure::Length.reading(self.known(), &self.shape.units, 1.0);
            let cells = vec![six_digits(reading.factor)];
            rows.push(Row { label: "strand radius".to_owned(), unit: reading.unit, cells });
        }
        for (name, label, measure, value) in self.items() {
            let reading = measure.reading(self.known(), &self.shape.units, value);
            let text = if value.is_finite() { six_digits(value * reading.factor) } else { "unbounded".to_owned() };
            rows.push(Row { label: label.to_owned(), unit: reading.unit, cells: vec![text] });
            if name == "radius_ratio" && self.shape.strand_radius.is_some() {
                let reading = Measure::Length.reading(self.known(), &self.shape.units, value);
                let cells = vec![six_digits(value * reading.factor)];
                rows.push(Row { label: "helix radius".to_owned(), unit: reading.unit, cells });
            }
        }
        if let Geometry::Ply { convex, .. } = self.geometry {
            let cells = vec![if convex { "convex" } else { "not convex" }.to_owned()];
            rows.push(Row { label: "cut across the ply".to_owned(), unit: String::new(), cells });
        }
        lay_out(&mut out, &[("", rows)], &emphasis);
        if let Some(share) = self.shape.packing_fraction {
            let _ = writeln!(out, "\n{}", super::packing_of(share));
        }
        if !self.branches.is_empty() {
            let _ = writeln!(out, "\n{}", emphasis.heading("Solutions of the contact condition, nearest first"));
            for branch in &self.branches {
                let _ = writeln!(
                    out,
                    "  {:9}  shift {:>9}  helix radius/strand radius {:>9}  {}, {}",
                    name(branch.kind),
                    six_digits(branch.arclength_shift),
                    six_digits(branch.radius_ratio),
                    if branch.self_penetrating() { "self-penetrating" } else { "least distance" },
                    if branch.keeps_curvature() {
                        "curvature kept (rκ ≤ 1)"
                    } else {
                        "curved too sharply (rκ > 1)"
                    },
                );
            }
        }
        out
    }

    /// As JSON, lengths in units of r; where r is known, in m too under `si`.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        top.insert("strands".into(), json!(self.shape.strands));
        if let Some(radius) = self.shape.strand_radius {
            top.insert("strand_radius_m".into(), json!(radius));
        }
        if let Some(share) = self.shape.packing_fraction {
            top.insert("packing_fraction".into(), json!(share));
        }
        let (mut si, mut units) = (Map::new(), Map::new());
        for (name, _, measure, value) in self.items() {
            let value = Some(value).filter(|v| v.is_finite());
            top.insert(name.into(), json!(value));
            if let Some((factor, unit)) = measure.si(self.known()) {
                si.insert(name.into(), json!(value.map(|v| v * factor)));
                units.insert(name.into(), json!(unit));
            }
        }
        if let Geometry::Ply { convex, .. } = self.geometry {
            top.insert("convex_cut".into(), json!(convex));
        }
        if !self.branches.is_empty() {
            let branches: Vec<Value> = self
                .branches
                .iter()
                .map(|b| {
                    json!({
                        "kind": name(b.kind),
                        "arclength_shift": b.arclength_shift,
                        "radius_ratio": b.radius_ratio,
                        "local_minimum": b.local_minimum,
                        "self_penetrating": b.self_penetrating(),
                        "curvature": b.curvature,
                        "keeps_curvature": b.keeps_curvature(),
                    })
                })
                .collect();
            top.insert("branches".into(), json!(branches));
        }
        if !si.is_empty() {
            top.insert("si".into(), Value::Object(si));
            top.insert("si_units".into(), Value::Object(units));
        }
        format!("{:#}\n", Value::Object(top))
    }
}

const fn name(kind: BranchKind) -> &'static str {
    match kind {
        BranchKind::Main => "main",
        BranchKind::Trivial => "trivial",
        BranchKind::Satellite => "satellite",
    }
}
