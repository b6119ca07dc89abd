//! The writhe of curves: what `nply writhe` says.

use core::fmt::Write as _;

use nply::topology::{Curve, CurveError, Writhe};
use serde_json::{Map, Value, json};

use super::curve::{Extension, closed, closing_note, described, extension_json, extension_note, refusal, theory};
use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use crate::curves::{CurveSet, counted};
use crate::preferred::six_digits;

/// Curves, and the writhe of each.
///
/// ```
/// use nply_sheet::WritheReport;
/// use nply_sheet::curves::{Closing, Curves, CurveSet};
/// // a bent piece in a plane
/// let file = Curves::read("a.csv", b"0,0,0\n1,0,0\n1,2,0\n4,4,0\n", None)?;
/// let set = CurveSet::of(vec![("a.csv".into(), file)], None, Closing::AsWritten)?;
/// let mut report = WritheReport::new(set, None)?;
/// report.writhes = (0..report.len()).map(|curve| report.writhe(curve)).collect::<Result<_, _>>()?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!(json["curves"][0]["closed"], false);
/// assert!(json["writhe"].as_f64().is_some_and(|writhe| writhe.abs() < 1e-14));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct WritheReport {
    /// The curves.
    pub set: CurveSet,
    /// By how much their ends were prolonged.
    pub extension: Option<Extension>,
    curves: Vec<Curve>,
    /// The writhe of each, once it is known.
    pub writhes: Vec<Writhe>,
}

impl WritheReport {
    /// Curves whose writhe is not known yet.
    ///
    /// # Errors
    /// A sentence where the theory refuses a curve, such as one with a point repeated.
    pub fn new(set: CurveSet, extension: Option<Extension>) -> Result<Self, String> {
        let curves = theory(&set, extension)?;
        Ok(Self { set, extension, curves, writhes: Vec::new() })
    }

    /// How many curves there are.
    #[must_use]
    #[allow(clippy::len_without_is_empty, reason = "there is at least one")]
    pub fn len(&self) -> usize {
        self.curves.len()
    }

    /// The writhe of one of the curves.
    ///
    /// # Errors
    /// A sentence where the curve meets itself.
    pub fn writhe(&self, curve: usize) -> Result<Writhe, String> {
        self.curves[curve].writhe().map_err(|error: CurveError| refusal(&self.set, &error, [curve, curve]))
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = self.set.notes.clone();
        notes.push(closing_note(&self.set));
        notes.extend(extension_note(self.extension, self.set.unit.as_deref()));
        notes.push(
            "Exact for the polygons: crossings seen along two directions, right-handed less left-handed, less the turns of each direction \
             about the curve. The error is what rounding can have done."
                .to_owned(),
        );
        notes
    }

    fn members(&self) -> impl Iterator<Item = (&crate::curves::Member, &Writhe)> {
        self.set.members.iter().zip(&self.writhes)
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let _ = writeln!(out, "{}", emphasis.heading(&format!("Writhe: {}", counted(self.len(), "curve"))));
        let unit = self.set.unit.clone().unwrap_or_default();
        let head = ["points", "ends", "length", "writhe", "error at most"].map(str::to_owned).to_vec();
        let mut rows = vec![Row { label: "curve".to_owned(), unit: String::new(), cells: head }];
        for (member, writhe) in self.members() {
            let cells = vec![
                member.points.len().to_string(),
                closed(member).to_owned(),
                six_digits(member.length()),
                six_digits(writhe.value),
                format!("{:.0e}", writhe.bound),
            ];
            rows.push(Row { label: crate::quoted(&member.name), unit: unit.clone(), cells });
        }
        lay_out(&mut out, &[("", rows)], &emphasis);
        for note in self.notes() {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// As JSON. `writhe` and `error_bound` are those of the one curve, or null where there are several.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        let one = if let [one] = self.writhes[..] { Some(one) } else { None };
        top.insert("unit".into(), json!(self.set.unit));
        top.insert("method".into(), json!("crossings and twist"));
        top.insert("extension".into(), extension_json(self.extension));
        top.insert("writhe".into(), json!(one.map(|writhe| writhe.value)));
        top.insert("error_bound".into(), json!(one.map(|writhe| writhe.bound)));
        let curves = self.members().map(|(member, writhe)| {
            let mut curve: Map<String, Value> = described(member);
            curve.insert("writhe".into(), json!(writhe.value));
            curve.insert("error_bound".into(), json!(writhe.bound));
            curve.insert("discrepancy".into(), json!(writhe.discrepancy));
            curve.insert("crossings".into(), json!(writhe.crossings));
            Value::Object(curve)
        });
        top.insert("curves".into(), curves.collect());
        top.insert("notes".into(), json!(self.notes()));
        format!("{:#}\n", Value::Object(top))
    }

    /// A header and one row a curve.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut rows =
            vec![["curve", "file", "points", "closed", "length", "writhe", "error_bound"].map(str::to_owned).to_vec()];
        for (member, writhe) in self.members() {
            rows.push(vec![
                member.name.clone(),
                member.file.clone(),
                member.points.len().to_string(),
                member.closed.to_string(),
                format!("{:?}", member.length()),
                format!("{:?}", writhe.value),
                format!("{:?}", writhe.bound),
            ]);
        }
        super::curve::csv(&rows)
    }
}
