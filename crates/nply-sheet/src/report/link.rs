//! How curves are linked with each other: what `nply link` says.

use core::fmt::Write as _;

use nply::topology::{Curve, linking_integral, linking_number};
use serde_json::{Value, json};

use super::curve::{Extension, closed, closing_note, described, extension_json, extension_note, refusal, theory};
use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use crate::curves::{CurveSet, counted};
use crate::preferred::six_digits;

/// A matrix for a reader has at most so many columns.
const WIDEST: usize = 12;

/// What two curves have to do with each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Link {
    /// Two closed curves: an integer, without error.
    Number(
        /// Lk.
        i64,
    ),
    /// One or two open ones: the Gauss integral, no integer.
    Integral {
        /// The integral.
        value: f64,
        /// What rounding can have done to it at most.
        bound: f64,
    },
}

/// Curves, and how each is linked with each other.
///
/// ```
/// use nply_sheet::LinkReport;
/// use nply_sheet::curves::{Closing, Curves, CurveSet};
/// let rings = b"0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 0\n\n1 1 -1\n1 1 1\n1 5 0\n1 1 -1\n";
/// let file = Curves::read("rings.txt", rings, None)?;
/// let set = CurveSet::of(vec![("rings.txt".into(), file)], None, Closing::AsWritten)?;
/// let mut report = LinkReport::new(set, None)?;
/// report.links = report.pairs().map(|pair| report.link(pair)).collect::<Result<_, _>>()?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!(json["linking_numbers"], serde_json::json!([[0, 1], [1, 0]]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct LinkReport {
    /// The curves, two or more.
    pub set: CurveSet,
    /// By how much their ends were prolonged.
    pub extension: Option<Extension>,
    curves: Vec<Curve>,
    /// One for each of [`pairs`](Self::pairs), once they are known.
    pub links: Vec<Link>,
}

impl LinkReport {
    /// Curves whose links are not known yet.
    ///
    /// # Errors
    /// A sentence where there is one curve alone, and where the theory refuses one.
    pub fn new(set: CurveSet, extension: Option<Extension>) -> Result<Self, String> {
        if let [one] = &set.members[..] {
            return Err(format!("{}: there is one curve; two or more are wanted, in one file or in several", one.file));
        }
        let curves = theory(&set, extension)?;
        Ok(Self { set, extension, curves, links: Vec::new() })
    }

    /// Each two curves once, by their places: [0, 1], [0, 2], [1, 2], …
    pub fn pairs(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let count = self.curves.len();
        (1..count).flat_map(|j| (0..j).map(move |i| [i, j]))
    }

    /// How two of the curves are linked.
    ///
    /// # Errors
    /// A sentence where they meet.
    pub fn link(&self, pair: [usize; 2]) -> Result<Link, String> {
        let [one, other] = pair.map(|i| &self.curves[i]);
        let found = if one.is_closed() && other.is_closed() {
            linking_number(one, other).map(|link| Link::Number(link.value))
        } else {
            linking_integral(one, other).map(|link| Link::Integral { value: link.value, bound: link.bound })
        };
        found.map_err(|error| refusal(&self.set, self.extension, &error, pair))
    }

    fn at(&self, i: usize, j: usize) -> Option<&Link> {
        let (low, high) = (i.min(j), i.max(j));
        if low == high { None } else { self.links.get(high * (high - 1) / 2 + low) }
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = self.set.notes.clone();
        notes.push(closing_note(&self.set));
        notes.extend(extension_note(self.extension, self.set.unit.as_deref()));
        notes.push(
            "Each curve runs from its first point to its last: read the other way (--reverse NAME) its links have the other sign."
                .to_owned(),
        );
        let whole = self.links.iter().filter(|link| matches!(link, Link::Number(_))).count();
        if whole > 0 {
            notes.push(
                "Linking numbers of closed curves are counted: half the crossings, right-handed less left-handed, the same along two \
                 directions."
                    .to_owned(),
            );
        }
        if whole < self.links.len() {
            let bound = self.links.iter().fold(0.0_f64, |most, link| match link {
                Link::Integral { bound, .. } => most.max(*bound),
                Link::Number(_) => most,
            });
            notes.push(format!(
                "With an open curve it is the Gauss integral, which is no integer; rounding can have done {bound:.0e} to it at most."
            ));
        }
        notes
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let count = self.set.members.len();
        let _ = writeln!(out, "{}", emphasis.heading(&format!("Link: {}", counted(count, "curve"))));
        let shown = count.min(WIDEST);
        let mut head = vec!["ends".to_owned(), "length".to_owned()];
        head.extend((1..=shown).map(|number| format!("with {number}")));
        let mut rows = vec![Row { label: "curve".to_owned(), unit: String::new(), cells: head }];
        for (i, member) in self.set.members.iter().enumerate().take(shown) {
            let mut cells = vec![closed(member).to_owned(), six_digits(member.length())];
            cells.extend((0..shown).map(|j| match self.at(i, j) {
                None => "–".to_owned(),
                Some(Link::Number(number)) => number.to_string(),
                Some(Link::Integral { value, .. }) => six_digits(*value),
            }));
            let label = format!("{} {}", i + 1, crate::quoted(&member.name));
            rows.push(Row { label, unit: self.set.unit.clone().unwrap_or_default(), cells });
        }
        lay_out(&mut out, &[("", rows)], &emphasis);
        if count > shown {
            let _ = writeln!(out, "\nThe first {shown} of {count} curves: --json and --format csv have them all.");
        }
        for note in self.notes() {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// As JSON: a square matrix, 0 on its diagonal; integers for two closed curves, Gauss integrals where one is open.
    #[must_use]
    pub fn json(&self) -> String {
        let count = self.set.members.len();
        let matrix = |of: &dyn Fn(Option<&Link>) -> Value| -> Value {
            (0..count).map(|i| (0..count).map(|j| of(self.at(i, j))).collect::<Value>()).collect()
        };
        let mut top = header();
        top.insert("unit".into(), json!(self.set.unit));
        top.insert("method".into(), json!("crossings"));
        top.insert("extension".into(), extension_json(self.extension));
        let value = |link: Option<&Link>| match link {
            None => json!(0),
            Some(Link::Number(number)) => json!(number),
            Some(Link::Integral { value, .. }) => json!(value),
        };
        top.insert("linking_numbers".into(), matrix(&value));
        let bound = |link: Option<&Link>| match link {
            Some(Link::Integral { bound, .. }) => json!(bound),
            _ => json!(0.0),
        };
        top.insert("error_bounds".into(), matrix(&bound));
        top.insert("curves".into(), self.set.members.iter().map(|member| Value::Object(described(member))).collect());
        top.insert("notes".into(), json!(self.notes()));
        format!("{:#}\n", Value::Object(top))
    }

    /// A header and one row for each two curves.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut rows = vec![["curve_1", "curve_2", "linking_number", "error_bound"].map(str::to_owned).to_vec()];
        for ([i, j], link) in self.pairs().zip(&self.links) {
            let (value, bound) = match link {
                Link::Number(number) => (number.to_string(), "0".to_owned()),
                Link::Integral { value, bound } => (format!("{value:?}"), format!("{bound:?}")),
            };
            rows.push(vec![self.set.members[i].name.clone(), self.set.members[j].name.clone(), value, bound]);
        }
        super::curve::csv(&rows)
    }
}
