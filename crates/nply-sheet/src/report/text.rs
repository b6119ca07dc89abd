//! The table people read in a terminal: quantities down, states across.

use core::fmt::Write as _;

use super::column::{Entry, OF_SOLID_STRANDS};
use super::verdict::Verdicts;
use super::{Known, Measure, Report, Section, found, margin};
use crate::preferred::six_digits;
use crate::{Case, PreferredUnits};
use nply::Handedness;
use nply::mechanics::{Equilibrium, Stability};

/// Headings stand out where a terminal can show it.
pub(crate) struct Emphasis(pub(crate) bool);

impl Emphasis {
    pub(crate) fn heading(&self, text: &str) -> String {
        if self.0 { format!("\u{1b}[1m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

/// A row before it is laid out: label, unit, one cell a state.
pub(crate) struct Row {
    pub(crate) label: String,
    pub(crate) unit: String,
    pub(crate) cells: Vec<String>,
}

impl Report {
    /// The report as an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        if let Some(supported) = &self.solution.supported {
            return super::support::text(self, supported, emphasis);
        }
        if let Some(stretched) = &self.solution.stretched {
            return super::support::text(self, stretched, emphasis);
        }
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let _ = writeln!(out, "{}", emphasis.heading(&headline(&self.case)));
        let states = &self.solution.states;
        if !states.is_empty() {
            let mut head = vec![
                row("state", "", (1..=states.len()).map(|i| i.to_string())),
                row("hand", "", states.iter().map(|s| hand(s.handedness()).to_owned())),
                row("strands", "", states.iter().map(|s| self.touch(s).to_owned())),
            ];
            let verdicts: Vec<_> = states.iter().map(|state| Verdicts::of(state).named()).collect();
            for (i, (_, label, _)) in Verdicts::default().named().into_iter().enumerate() {
                if verdicts.iter().any(|named| named[i].2.is_some()) {
                    let word = |verdict: Option<Stability>| verdict.map_or("–", Stability::name).to_owned();
                    head.push(row(label, "", verdicts.iter().map(|named| word(named[i].2))));
                }
            }
            let mut parts = vec![("", head)];
            for section in Section::ALL {
                let rows = self.section(section);
                if !rows.is_empty() {
                    parts.push((section.heading(), rows));
                }
            }
            lay_out(&mut out, &parts, &emphasis);
        }
        for note in &self.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// The rows below a heading.
    fn section(&self, section: Section) -> Vec<Row> {
        let states = &self.solution.states;
        if section == Section::Margin {
            let margins: Vec<_> = states.iter().map(|state| self.margins(state)).collect();
            return margin::rows(states, &margins, self.known(), &self.case.units, self.case.strand_length);
        }
        if section == Section::Buckling && self.case.strand_length.is_none() {
            return Vec::new();
        }
        let entries = self.entries();
        let shown: Vec<&Entry> =
            entries.iter().filter(|entry| entry.section == section && !entry.label.is_empty()).collect();
        let sizes: Vec<(Measure, f64)> = shown.iter().map(|entry| (entry.measure, largest(&entry.values))).collect();
        shown
            .iter()
            .zip(&sizes)
            .filter_map(|(entry, (measure, own))| self.row(entry, measure.size_among(*own, &sizes)))
            .collect()
    }

    /// The row of a quantity; none for lengths per strand radius that repeat a pure number, for bounds that hold for other strands, or where
    /// no state has a value.
    fn row(&self, entry: &Entry, size: f64) -> Option<Row> {
        if OF_SOLID_STRANDS.contains(&entry.name) && !self.case.may_be_solid() {
            return None;
        }
        let repeats = matches!(entry.name, "ply_radius" | "pretwist_per_length" | "strand_twist_per_length");
        if repeats && entry.measure.si(self.known()).is_none() {
            return None;
        }
        let mark = if found(self.case.question) == Some(entry.name) { " (found)" } else { "" };
        of_values(&format!("{}{mark}", entry.label), entry, self.known(), &self.case.units, size)
    }

    fn touch(&self, state: &Equilibrium) -> &'static str {
        if super::at_separation(&self.case) {
            "just touching"
        } else if state.is_separated() {
            "separated"
        } else {
            "touching"
        }
    }
}

fn row(label: &str, unit: &str, cells: impl Iterator<Item = String>) -> Row {
    Row { label: label.to_owned(), unit: unit.to_owned(), cells: cells.collect() }
}

/// The largest of finite values by size; 0 where there is none.
pub(super) fn largest(values: &[Option<f64>]) -> f64 {
    values.iter().flatten().filter(|value| value.is_finite()).fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// A row of values in the reader's units, chosen for a value of this size; none if there is no value at all.
fn of_values(label: &str, entry: &Entry, known: Known, units: &PreferredUnits, size: f64) -> Option<Row> {
    let values = &entry.values;
    let reading = entry.measure.reading(known, units, size);
    let cell = |value: &Option<f64>| value.map_or_else(|| "–".to_owned(), |v| six_digits(v * reading.factor));
    values.iter().any(Option::is_some).then(|| Row {
        label: label.to_owned(),
        unit: reading.unit.clone(),
        cells: values.iter().map(cell).collect(),
    })
}

/// Stable or not, where that can be said.
pub(super) fn verdict(state: &Equilibrium) -> &'static str {
    match state.stability() {
        Some(Stability::Stable) => "stable",
        Some(Stability::Unstable) => "unstable",
        Some(Stability::Marginal) => "marginal",
        None => "–",
    }
}

pub(super) const fn hand(handedness: Handedness) -> &'static str {
    match handedness {
        Handedness::Right => "right (Z)",
        Handedness::Left => "left (S)",
    }
}

/// Title, and what the whole report holds for.
fn headline(case: &Case) -> String {
    let gamma = six_digits(case.stiffness_ratio);
    format!("{}{} strands, stiffness ratio {gamma}, {} balance", title(case), case.strands, case.balance.name())
}

/// The title in front of a headline, if there is one.
pub(super) fn title(case: &Case) -> String {
    // one line, and no say in what the terminal does
    let plain = |title: &String| title.replace(|c: char| c.is_control(), " ");
    case.title.as_ref().map_or(String::new(), |title| format!("{}: ", plain(title)))
}

/// Labels to the left, numbers to the right, units between.
pub(crate) fn lay_out(out: &mut String, parts: &[(&str, Vec<Row>)], emphasis: &Emphasis) {
    let rows = || parts.iter().flat_map(|(_, rows)| rows);
    let width = |text: &str| text.chars().count();
    let label = rows().map(|r| width(&r.label)).max().unwrap_or(0);
    let unit = rows().map(|r| width(&r.unit)).max().unwrap_or(0);
    let cell = rows().flat_map(|r| &r.cells).map(|c| width(c)).max().unwrap_or(0);
    for (heading, rows) in parts {
        let _ = writeln!(out);
        if !heading.is_empty() {
            let _ = writeln!(out, "{}", emphasis.heading(heading));
        }
        for row in rows {
            let _ = write!(out, "  {:label$}  {:unit$}", row.label, row.unit);
            for text in &row.cells {
                let _ = write!(out, "  {text:>cell$}");
            }
            let _ = writeln!(out);
        }
    }
}
