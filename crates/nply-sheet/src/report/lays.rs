//! The distinguished lays of n strands: what `nply lays` says.

use core::fmt::Write as _;

use nply::geometry::{Contact, DensestHelix, SpecialLays, packing_fraction};
use serde_json::{Map, Value, json};

use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use crate::preferred::six_digits;

/// Zero twist, most torsion, most curvature, close packed, non-convex cut, lock-up; for n = 1 the densest helix.
///
/// ```
/// use nply_sheet::LaysReport;
/// let json: serde_json::Value = serde_json::from_str(&LaysReport::of(3).json())?;
/// let angle = json["zero_twist"]["helical_angle_deg"].as_f64().unwrap_or(0.0);
/// assert!((90.0 - angle - 42.8).abs() < 0.05); // pitch angle 42.8°, Bohr & Olsen, EPL 93 (2011) 60004
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LaysReport {
    strands: u32,
    lays: Vec<Lay>,
}

/// One lay, and the quantity that is extreme there.
#[derive(Clone, Debug, PartialEq)]
struct Lay {
    name: &'static str,
    label: &'static str,
    /// angle in degrees, ρ
    shape: Option<(f64, f64)>,
    extreme: Option<(&'static str, &'static str, f64)>,
}

impl LaysReport {
    /// Of n ≥ 1 strands; fewer than two are a single tube.
    #[must_use]
    pub fn of(strands: u32) -> Self {
        let Ok(special) = SpecialLays::of(strands) else {
            let helix = DensestHelix::new();
            let lay = Lay {
                name: "densest",
                label: "densest helix",
                shape: Some((helix.angle().degrees(), helix.radius_ratio())),
                extreme: Some(("pitch_over_diameter", "pitch/diameter", 0.5 * helix.pitch())),
            };
            return Self { strands: 1, lays: vec![lay] };
        };
        let lay = |name, label, contact: Option<Contact>, extreme: Option<Extreme>| Lay {
            name,
            label,
            shape: contact.map(|c| (c.angle().degrees(), c.radius_ratio())),
            extreme: contact.and_then(|c| extreme.map(|(name, words, value)| (name, words, value(&c)))),
        };
        let lays = vec![
            lay(
                "zero_twist",
                "zero twist (most turns)",
                Some(special.zero_twist()),
                // turns per strand length sin θ/(2πρ), the length in diameters
                Some(("turns_per_strand_length", "turns per diameter of strand", |c| {
                    c.angle().sin() / (core::f64::consts::PI * c.radius_ratio())
                })),
            ),
            lay(
                "most_torsion",
                "most torsion",
                Some(special.most_torsion()),
                Some(("torsion", "r τ", Contact::torsion)),
            ),
            lay(
                "most_curvature",
                "most curvature",
                Some(special.most_curvature()),
                Some(("curvature", "r κ", Contact::curvature)),
            ),
            lay(
                "close_packed",
                "close packed",
                special.close_packed(),
                Some(("packing_fraction", "share of the enclosing cylinder", packing_fraction)),
            ),
            lay("non_convex_cut", "cut turns non-convex", Some(special.non_convex_cut()), None),
            lay("lock_up", "lock-up of line contact", special.lock_up(), None),
        ];
        Self { strands, lays }
    }

    /// Names and words of the lays, with those of what is extreme there.
    pub(super) fn named(&self) -> Vec<NamedLay> {
        let extreme = |lay: &Lay| lay.extreme.map(|(name, words, _)| (name, words));
        self.lays.iter().map(|lay| (lay.name, lay.label, extreme(lay))).collect()
    }

    /// As an aligned table, with a bold heading if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let strands =
            if self.strands == 1 { "A single tube".to_owned() } else { format!("{} touching strands", self.strands) };
        let _ = writeln!(out, "{}", emphasis.heading(&strands));
        let none = || "none".to_owned();
        let row = |lay: &Lay| Row {
            label: lay.label.to_owned(),
            unit: lay.extreme.map_or_else(String::new, |(_, words, value)| format!("{words} {}", six_digits(value))),
            cells: vec![
                lay.shape.map_or_else(none, |(angle, _)| format!("{angle:.4}")),
                lay.shape.map_or_else(none, |(angle, _)| format!("{:.4}", 90.0 - angle)),
                lay.shape.map_or_else(none, |(_, rho)| six_digits(rho)),
            ],
        };
        let head = Row {
            label: String::new(),
            unit: "greatest".to_owned(),
            cells: ["helical °", "pitch °", "R/r"].map(String::from).into(),
        };
        let rows = core::iter::once(head).chain(self.lays.iter().map(row)).collect();
        lay_out(&mut out, &[("", rows)], &emphasis);
        out
    }

    /// As JSON; a lay that these strands do not have is null.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        top.insert("strands".into(), json!(self.strands));
        for lay in &self.lays {
            let object = lay.shape.map(|(angle, rho)| {
                let mut object = Map::new();
                object.insert("helical_angle_deg".into(), json!(angle));
                object.insert("radius_ratio".into(), json!(rho));
                if let Some((name, _, value)) = lay.extreme {
                    object.insert(name.into(), json!(value));
                }
                Value::Object(object)
            });
            top.insert(lay.name.into(), object.unwrap_or(Value::Null));
        }
        format!("{:#}\n", Value::Object(top))
    }
}

/// Name and words of a lay, and of what is extreme there.
pub(crate) type NamedLay = (&'static str, &'static str, Option<(&'static str, &'static str)>);

type Extreme = (&'static str, &'static str, fn(&Contact) -> f64);
