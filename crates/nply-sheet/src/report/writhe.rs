//! The writhe of curves, and the twist of ribbons: what `nply writhe` says.

use core::fmt::Write as _;

use nply::geometry::Vector;
use nply::topology::{
    AverageCrossings, CrossingShare, Curve, CurveError, Frame, PolarWrithe, Twist, WritheMap, WritheShares,
    linking_number,
};
use serde_json::{Map, Value, json};

use super::curve::{Extension, closed, closing_note, described, extension_json, extension_note, refusal, theory};
use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use crate::curves::{CurveSet, Member, counted};
use crate::preferred::six_digits;
use crate::quoted;

/// What is asked of curves besides their writhe.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WritheQuestion {
    /// By how much open curves are prolonged.
    pub extension: Option<Extension>,
    /// An axis along which the polar writhe is wanted.
    pub axis: Option<Vector>,
    /// Whether the curves come in twos, a centreline and the edge of its ribbon, whose twist is wanted.
    pub ribbon: bool,
    /// What a sum by segments may be wrong by, where such a sum is wanted instead of a count of crossings.
    pub tolerance: Option<f64>,
}

/// What is said of one curve.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Writhing {
    /// Its writhe.
    pub writhe: f64,
    /// What can be wrong with it at most.
    pub bound: f64,
    /// How often it is seen to cross itself along each of two directions, and by how much the values found along them differ.
    pub seen: Option<([u64; 2], f64)>,
    /// What each segment has of the writhe, where it was summed by segments.
    pub shares: Option<Vec<f64>>,
    /// Its polar writhe, where an axis was given.
    pub polar: Option<PolarWrithe>,
    /// The twist of its ribbon, where it has one.
    pub twist: Option<Twist>,
    /// How often the edge of a closed ribbon runs round it: twist + writhe, but counted.
    pub link: Option<i64>,
    /// How often it is seen to cross itself, as a mean over all directions, where that is wanted.
    pub average_crossings: Option<CrossingShare>,
}

/// Curves, and the writhe of each.
///
/// ```
/// use nply_sheet::{WritheQuestion, WritheReport};
/// use nply_sheet::curves::{Closing, Curves, CurveSet};
/// // a bent piece in a plane
/// let file = Curves::read("a.csv", b"0,0,0\n1,0,0\n1,2,0\n4,4,0\n", None)?;
/// let set = CurveSet::of(vec![("a.csv".into(), file)], None, Closing::AsWritten)?;
/// let mut report = WritheReport::new(set, WritheQuestion::default())?;
/// report.found = (0..report.len()).map(|curve| report.writhing(curve, None)).collect::<Result<_, _>>()?;
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
    /// What is asked of them.
    pub question: WritheQuestion,
    curves: Vec<Curve>,
    /// What is found of each, once it is known; of ribbons, of each centreline.
    pub found: Vec<Writhing>,
}

impl WritheReport {
    /// Curves of which nothing is known yet.
    ///
    /// # Errors
    /// A sentence where the theory refuses a curve, such as one with a point repeated, and where ribbons lack an edge or one that goes with the
    /// centreline point by point.
    pub fn new(set: CurveSet, question: WritheQuestion) -> Result<Self, String> {
        if question.ribbon {
            if set.members.len() % 2 == 1 {
                let count = counted(set.members.len(), "curve");
                return Err(format!(
                    "{count} make no ribbons: a centreline and an edge each are wanted, one after the other"
                ));
            }
            let differ =
                |pair: &&[Member]| (pair[0].points.len(), pair[0].closed) != (pair[1].points.len(), pair[1].closed);
            if let Some([one, other]) = set.members.chunks_exact(2).find(differ) {
                let what = |member: &Member| {
                    format!("{} ({}, {})", quoted(&member.name), counted(member.points.len(), "point"), closed(member))
                };
                return Err(format!(
                    "{} and {} make no ribbon: an edge goes with its centreline point by point",
                    what(one),
                    what(other)
                ));
            }
        }
        let curves = theory(&set, question.extension)?;
        Ok(Self { set, question, curves, found: Vec::new() })
    }

    /// How many curves are looked at: of ribbons the centrelines alone.
    #[must_use]
    #[allow(clippy::len_without_is_empty, reason = "there is at least one")]
    pub fn len(&self) -> usize {
        self.curves.len() / self.step()
    }

    const fn step(&self) -> usize {
        if self.question.ribbon { 2 } else { 1 }
    }

    /// The work for a sum by segments of one of them, which a door may share out.
    ///
    /// # Errors
    /// A sentence where the tolerance is none.
    pub fn map(&self, number: usize, tolerance: f64) -> Result<WritheMap, String> {
        WritheMap::new(&self.curves[number * self.step()], tolerance).map_err(|error| error.to_string())
    }

    /// What is to be said of one of them; `shares` are all parts of its [`map`](Self::map), or its writhe is counted.
    ///
    /// # Errors
    /// A sentence where the curve meets itself or its edge, or has no polar writhe along the axis.
    pub fn writhing(&self, number: usize, shares: Option<Vec<WritheShares>>) -> Result<Writhing, String> {
        let at = number * self.step();
        let curve = &self.curves[at];
        let refused = |error: CurveError| refusal(&self.set, self.question.extension, &error, [at, at]);
        let polar = self.question.axis.map(|axis| curve.polar_writhe(axis)).transpose().map_err(refused)?;
        let (mut twist, mut link) = (None, None);
        if self.question.ribbon {
            let edge = &self.curves[at + 1];
            twist = Some(curve.twist(Frame::Edge(edge.points())).map_err(refused)?);
            if curve.is_closed() {
                let both = |error: CurveError| refusal(&self.set, None, &error, [at, at + 1]);
                link = Some(linking_number(curve, edge).map_err(both)?.value);
            }
        }
        let empty =
            Writhing { writhe: 0.0, bound: 0.0, seen: None, shares: None, polar, twist, link, average_crossings: None };
        let Some(parts) = shares else {
            let found = curve.writhe().map_err(refused)?;
            let seen = Some((found.crossings, found.discrepancy));
            return Ok(Writhing { writhe: found.value, bound: found.bound, seen, ..empty });
        };
        let bound = parts.iter().map(|part| part.bound).sum();
        let shares: Vec<f64> = parts.into_iter().flat_map(|part| part.shares).collect();
        Ok(Writhing { writhe: shares.iter().sum(), bound, shares: Some(shares), ..empty })
    }

    /// The work for the average crossing number of one of them, a sum over all pairs of segments that a door may share out.
    #[must_use]
    pub fn average_crossings(&self, number: usize) -> AverageCrossings {
        AverageCrossings::new(&self.curves[number * self.step()])
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = self.set.notes.clone();
        notes.push(closing_note(&self.set));
        notes.extend(extension_note(self.question.extension, self.set.unit.as_deref()));
        notes.extend(self.ribbon_notes());
        if let Some(tolerance) = self.question.tolerance {
            notes.push(format!(
                "Summed by segments, far ones by expansions, to a tolerance of {tolerance:e}: --json has the share of each segment."
            ));
            return notes;
        }
        notes.push(
            "Exact for the polygons: crossings seen along two directions, right-handed less left-handed, less the turns of each direction \
             about the curve. The error is what rounding can have done."
                .to_owned(),
        );
        notes
    }

    /// What is to be said of ribbons: whether link is the sum of twist and writhe, and whether an edge seems to run backwards.
    fn ribbon_notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        let linked: Vec<(&[Member], f64, i64)> = (self.set.members.chunks_exact(self.step()).zip(&self.found))
            .filter_map(|(pair, found)| Some((pair, found.twist?.value + found.writhe, found.link?)))
            .collect();
        // both are integers but for rounding; the links of a curve and of the ribbon along the rungs differ where a rung goes through the curve
        let bounds_none = |sum: f64, link: i64| (sum - link as f64).abs() > 0.5;
        if linked.iter().any(|(_, sum, link)| !bounds_none(*sum, *link)) {
            notes.push("The link of a closed ribbon is counted, and is the sum of its twist and writhe.".to_owned());
        }
        for (pair, sum, link) in linked.iter().filter(|(_, sum, link)| bounds_none(*sum, *link)) {
            let [centre, edge] = [0, 1].map(|i| quoted(&pair[i].name));
            notes.push(format!(
                "{centre} and {edge} bound no ribbon: they are linked {link} times, and twist + writhe along the lines from point to point is {}, \
                 so that some of these lines pass through {centre}. Points go together in their order.",
                six_digits(*sum)
            ));
        }
        if self.question.ribbon {
            for pair in self.set.members.chunks_exact(2).filter(|pair| runs_backwards(&pair[0], &pair[1])) {
                let [centre, edge] = [0, 1].map(|i| quoted(&pair[i].name));
                notes.push(format!(
                    "Read backwards {edge} lies far nearer to {centre}, point by point: --reverse {edge} does so, as for strands of a duplex, which run \
                     against each other."
                ));
            }
        }
        notes
    }

    fn members(&self) -> impl Iterator<Item = (&Member, &Writhing)> {
        self.set.members.iter().step_by(self.step()).zip(&self.found)
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let what = if self.question.ribbon { "ribbon" } else { "curve" };
        let _ = writeln!(out, "{}", emphasis.heading(&format!("Writhe: {}", counted(self.len(), what))));
        let unit = self.set.unit.clone().unwrap_or_default();
        let columns: Vec<&Quantity> = QUANTITIES.iter().filter(|quantity| self.has(quantity)).collect();
        let mut head = ["points", "ends", "length"].map(str::to_owned).to_vec();
        head.extend(columns.iter().map(|quantity| quantity.label.to_owned()));
        let mut rows = vec![Row { label: what.to_owned(), unit: String::new(), cells: head }];
        let mut edges =
            self.set.members.iter().skip(1).step_by(2).take(if self.question.ribbon { self.len() } else { 0 });
        for (member, found) in self.members() {
            let mut cells =
                vec![member.points.len().to_string(), closed(member).to_owned(), six_digits(member.length())];
            cells.extend(columns.iter().map(|quantity| match (quantity.value)(found) {
                None => "–".to_owned(),
                Some(value) if quantity.name.ends_with("error_bound") => format!("{value:.0e}"),
                Some(value) => six_digits(value),
            }));
            let edge = edges.next().map_or_else(String::new, |edge| format!(", edge {}", quoted(&edge.name)));
            rows.push(Row { label: format!("{}{edge}", quoted(&member.name)), unit: unit.clone(), cells });
        }
        lay_out(&mut out, &[("", rows)], &emphasis);
        for note in self.notes() {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    fn has(&self, quantity: &Quantity) -> bool {
        !quantity.label.is_empty() && self.found.iter().any(|found| (quantity.value)(found).is_some())
    }

    /// As JSON. What stands at the top is that of the one curve or ribbon, or null where there are several.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        let one = if let [one] = &self.found[..] { Some(one) } else { None };
        top.insert("unit".into(), json!(self.set.unit));
        top.insert(
            "method".into(),
            json!(if self.question.tolerance.is_some() { "tree" } else { "crossings and twist" }),
        );
        top.insert("extension".into(), extension_json(self.question.extension));
        top.insert("axis".into(), json!(self.question.axis));
        for quantity in QUANTITIES {
            top.insert(quantity.name.into(), quantity.json(one));
        }
        let curves = self.members().map(|(member, found)| {
            let mut curve: Map<String, Value> = described(member);
            for quantity in QUANTITIES {
                curve.insert(quantity.name.into(), quantity.json(Some(found)));
            }
            curve.insert("crossings".into(), json!(found.seen.map(|(crossings, _)| crossings)));
            curve.insert("discrepancy".into(), json!(found.seen.map(|(_, discrepancy)| discrepancy)));
            if let Some(shares) = &found.shares {
                curve.insert("shares".into(), json!(shares));
            }
            Value::Object(curve)
        });
        top.insert("curves".into(), curves.collect());
        top.insert("notes".into(), json!(self.notes()));
        format!("{:#}\n", Value::Object(top))
    }

    /// A header and one row a curve.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut head = ["curve", "file", "points", "closed", "length"].map(str::to_owned).to_vec();
        head.extend(QUANTITIES.iter().map(|quantity| quantity.name.to_owned()));
        let mut rows = vec![head];
        for (member, found) in self.members() {
            let mut row = vec![
                member.name.clone(),
                member.file.clone(),
                member.points.len().to_string(),
                member.closed.to_string(),
                format!("{:?}", member.length()),
            ];
            let cell = |quantity: &Quantity| match quantity.json(Some(found)) {
                Value::Null => String::new(),
                value => value.to_string(),
            };
            row.extend(QUANTITIES.iter().map(cell));
            rows.push(row);
        }
        super::curve::csv(&rows)
    }
}

/// Whether an edge read from its last point to its first is less than half as far from its centreline, point by point.
fn runs_backwards(centre: &Member, edge: &Member) -> bool {
    let far = |a: &Vector, b: &Vector| {
        let [x, y, z] = [0, 1, 2].map(|k| a[k] - b[k]);
        libm::hypot(libm::hypot(x, y), z)
    };
    let as_read: f64 = centre.points.iter().zip(&edge.points).map(|(a, b)| far(a, b)).sum();
    let backwards: f64 = centre.points.iter().zip(edge.points.iter().rev()).map(|(a, b)| far(a, b)).sum();
    backwards < 0.5 * as_read
}

/// One number of a curve: its name in JSON and CSV, the words above its column (none: not in a reader's table).
pub(super) struct Quantity {
    pub(super) name: &'static str,
    pub(super) label: &'static str,
    pub(super) whole: bool,
    value: fn(&Writhing) -> Option<f64>,
}

const fn quantity(name: &'static str, label: &'static str, value: fn(&Writhing) -> Option<f64>) -> Quantity {
    Quantity { name, label, whole: false, value }
}

pub(super) const QUANTITIES: &[Quantity] = &[
    quantity("writhe", "writhe", |found| Some(found.writhe)),
    quantity("error_bound", "error at most", |found| Some(found.bound)),
    quantity("polar_writhe", "polar writhe", |found| found.polar.map(|polar| polar.value())),
    quantity("polar_writhe_local", "", |found| found.polar.map(|polar| polar.local)),
    quantity("polar_writhe_nonlocal", "", |found| found.polar.map(|polar| polar.nonlocal)),
    quantity("average_crossing_number", "average crossings", |found| found.average_crossings.map(|share| share.value)),
    quantity("average_crossing_error_bound", "", |found| found.average_crossings.map(|share| share.bound)),
    quantity("twist", "twist", |found| found.twist.map(|twist| twist.value)),
    quantity("twist_error_bound", "", |found| found.twist.map(|twist| twist.bound)),
    quantity("twist_plus_writhe", "twist + writhe", |found| found.twist.map(|twist| twist.value + found.writhe)),
    // a count of crossings, far below 2^53
    Quantity { name: "linking_number", label: "link", whole: true, value: |found| found.link.map(|link| link as f64) },
];

impl Quantity {
    fn json(&self, of: Option<&Writhing>) -> Value {
        // adding 0 takes the sign from a negative zero
        let value = of.and_then(self.value).filter(|value| value.is_finite()).map(|value| value + 0.0);
        match value {
            Some(value) if self.whole => json!(value as i64),
            value => json!(value),
        }
    }
}
