//! How near wires come to each other: what `nply clearance` says.

use core::fmt::Write as _;

use nply::DomainError;
use nply::geometry::{Approach, Clearance, Wire, Wires};
use serde_json::{Map, Value, json};

use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use crate::curves::{CurveSet, counted};
use crate::preferred::six_digits;
use crate::{ErrorKind, Place, SpecError};

/// Heights above chords are those of circles through three points; a smooth wire may have a little more.
const HEIGHT_SLACK: f64 = 1.25;
/// Pairs that overlap are listed for a reader up to this many.
const LISTED: usize = 20;

/// Wires with their diameters, ready to be searched, and what the search has found.
///
/// ```
/// use nply_sheet::ClearanceReport;
/// use nply_sheet::curves::{Closing, Curves, CurveSet};
/// let file = Curves::read("a.csv", b"-9,0,0\n9,0,0\n\n0,-9,3\n0,9,3\n", None)?;
/// let set = CurveSet::of(vec![("a.csv".into(), file)], None, Closing::AsWritten)?;
/// let mut report = ClearanceReport::new(set, &["4"])?;
/// report.found = report.wires.search(0..report.wires.segments(), &report.found);
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!((json["least_distance"].as_f64(), json["clearance"].as_f64()), (Some(3.0), Some(-1.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ClearanceReport {
    /// The curves.
    pub set: CurveSet,
    /// The diameter of each, in the set's unit; `None` where none is known.
    pub diameters: Option<Vec<f64>>,
    /// The same as an index to search.
    pub wires: Wires,
    /// What was found in it.
    pub found: Clearance,
}

impl ClearanceReport {
    /// Curves with the diameters of flags (one for all, or one each), else with those of the files.
    ///
    /// # Errors
    /// [`SpecError`] for a diameter that is none, for another number of diameters than curves, where some curves of the files have a diameter
    /// and others none, and where the theory refuses a curve.
    pub fn new(set: CurveSet, diameters: &[&str]) -> Result<Self, SpecError> {
        let given = diameters.iter().map(|text| set.length("diameter", text)).collect::<Result<Vec<_>, _>>()?;
        let refused = |kind, message: String| SpecError::new(kind, Place::Flag("diameter".to_owned()), message);
        let count = set.members.len();
        let diameters = match given[..] {
            [] => {
                let own: Vec<f64> = set.members.iter().filter_map(|member| member.diameter).collect();
                if !own.is_empty() && own.len() < count {
                    let message =
                        format!("{} of {} have a diameter: give one for all", own.len(), counted(count, "curve"));
                    return Err(refused(ErrorKind::Missing, message));
                }
                Some(own).filter(|own| !own.is_empty())
            }
            [diameter] => Some(vec![diameter; count]),
            _ if given.len() == count => Some(given),
            _ => {
                let message = format!(
                    "{} for {}: give one for all, or one each in their order",
                    counted(given.len(), "diameter"),
                    counted(count, "curve")
                );
                return Err(refused(ErrorKind::Contradiction, message));
            }
        };
        let wires: Vec<Wire<'_>> = set
            .members
            .iter()
            .enumerate()
            .map(|(i, member)| Wire {
                points: &member.points,
                closed: member.closed,
                diameter: diameters.as_ref().map_or(0.0, |diameters| diameters[i]),
            })
            .collect();
        let wires = Wires::new(&wires).map_err(|error: DomainError| refused(ErrorKind::Domain, error.to_string()))?;
        Ok(Self { set, diameters, wires, found: Clearance::default() })
    }

    /// What the chords of both wires can account for.
    fn chords(&self, approach: &Approach) -> f64 {
        HEIGHT_SLACK * approach.wires.iter().map(|wire| self.wires.sagitta(*wire)).sum::<f64>()
    }

    fn beyond_chords<'a>(&'a self, pairs: impl Iterator<Item = &'a Approach>) -> usize {
        pairs.filter(|pair| pair.gap < -self.chords(pair)).count()
    }

    /// The wires whose inner side folds over.
    fn too_sharp(&self) -> Vec<usize> {
        let Some(diameters) = &self.diameters else { return Vec::new() };
        // three points a hair's breadth off tell a radius only to so much
        let sharp =
            |(i, diameter): (usize, &f64)| (self.wires.bend_radius(i) < 0.5 * diameter * (1.0 - 1e-9)).then_some(i);
        diameters.iter().enumerate().filter_map(sharp).collect()
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = self.set.notes.clone();
        if self.set.members.len() == 1 {
            notes.push("There is one wire: it can only be near itself.".to_owned());
        }
        if self.diameters.is_none() {
            notes.push(
                "Without a diameter there is no clearance, and nothing is said of a wire near itself.".to_owned(),
            );
        }
        let sharp = self.too_sharp();
        if let Some(first) = sharp.first() {
            notes.push(format!(
                "{} bent more sharply than its radius, first {}: its inner side folds over.",
                if sharp.len() == 1 { "1 wire is".to_owned() } else { format!("{} wires are", sharp.len()) },
                crate::quoted(&self.set.members[*first].name)
            ));
        }
        let sagitta = (0..self.set.members.len()).fold(0.0_f64, |most, wire| most.max(self.wires.sagitta(wire)));
        if sagitta > 0.0 {
            notes.push(format!(
                "Distances are those of the polylines. Smooth wires lie up to {}{} off their chords, so that an overlap of two \
                 wires within both heights together may be the chords' alone.",
                six_digits(sagitta),
                self.set.unit.as_ref().map_or_else(String::new, |unit| format!(" {unit}"))
            ));
        }
        notes
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let unit = self.set.unit.clone().unwrap_or_default();
        let wires = counted(self.set.members.len(), "wire");
        let title = format!("Clearance: {wires}, {}", counted(self.wires.segments(), "segment"));
        let _ = writeln!(out, "{}", emphasis.heading(&title));
        let number = |label: &str, value: Option<f64>| {
            let cells = vec![value.map_or_else(|| "–".to_owned(), six_digits)];
            Row { label: label.to_owned(), unit: unit.clone(), cells }
        };
        let count = |label: &str, value: usize| Row {
            label: label.to_owned(),
            unit: String::new(),
            cells: vec![value.to_string()],
        };
        let mut head = vec![number("least distance", self.found.nearest().map(|nearest| nearest.distance))];
        let mut own = Vec::new();
        if let Some(diameters) = &self.diameters {
            let same = diameters.iter().all(|diameter| diameter.to_bits() == diameters[0].to_bits());
            if same {
                head.insert(0, number("diameter", diameters.first().copied()));
            }
            let what =
                if same { "clearance (least distance − diameter)" } else { "clearance (least gap of two surfaces)" };
            head.push(number(what, self.found.tightest().map(|tightest| tightest.gap)));
            head.push(count("overlapping pairs", self.found.overlaps().count()));
            head.push(count("of these by more than chords explain", self.beyond_chords(self.found.overlaps())));
            own.push(number("least distance", self.found.own_nearest().map(|nearest| nearest.distance)));
            own.push(number("clearance", self.found.own_tightest().map(|tightest| tightest.gap)));
            own.push(count("wires that overlap with themselves", self.found.own_overlaps().count()));
            own.push(count("of these by more than chords explain", self.beyond_chords(self.found.own_overlaps())));
        }
        let heading = "A wire with itself, farther along it than half a turn of its sharpest bend";
        let parts: Vec<_> = [("", head), (heading, own)].into_iter().filter(|(_, rows)| !rows.is_empty()).collect();
        lay_out(&mut out, &parts, &emphasis);
        self.list(&mut out, &emphasis);
        for note in self.notes() {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// Where: the pairs that overlap, the worst first; else the nearest.
    fn list(&self, out: &mut String, emphasis: &Emphasis) {
        let mut pairs: Vec<&Approach> = self.found.overlaps().chain(self.found.own_overlaps()).collect();
        pairs.sort_by(|a, b| a.gap.total_cmp(&b.gap));
        let (heading, more) = if pairs.is_empty() {
            pairs.extend(self.found.tightest().or_else(|| self.found.own_tightest()));
            let own = self.found.tightest().is_none();
            (if own { "Nearest, beyond its neighbourhood along the wire" } else { "Nearest" }, 0)
        } else {
            ("Overlaps, the deepest first", pairs.len().saturating_sub(LISTED))
        };
        if pairs.is_empty() {
            return;
        }
        let _ = writeln!(out, "\n{}", emphasis.heading(heading));
        let unit = self.set.unit.clone().unwrap_or_default();
        // of wires whose size is not known nothing is said of gaps
        let told = |place: usize| place != 1 || self.diameters.is_some();
        let only = |cells: [String; 7]| {
            cells.into_iter().enumerate().filter(|(at, _)| told(*at)).map(|(_, cell)| cell).collect()
        };
        let head = only(["distance", "gap", "at", "and at", "x", "y", "z"].map(str::to_owned));
        let mut rows = vec![Row { label: "wires".to_owned(), unit: String::new(), cells: head }];
        for pair in pairs.iter().take(LISTED) {
            let names = pair.wires.map(|wire| crate::quoted(&self.set.members[wire].name));
            let label = if pair.wires[0] == pair.wires[1] {
                format!("{} and itself", names[0])
            } else {
                format!("{} and {}", names[0], names[1])
            };
            let [a, b] = pair.points;
            let middle = [0, 1, 2].map(|axis| 0.5 * a[axis] + 0.5 * b[axis]);
            let arcs = self.arclengths(pair);
            let cells = [pair.distance, pair.gap, arcs[0], arcs[1], middle[0], middle[1], middle[2]];
            rows.push(Row { label, unit: unit.clone(), cells: only(cells.map(six_digits)) });
        }
        let mut table = String::new();
        lay_out(&mut table, &[("", rows)], emphasis);
        out.push_str(table.trim_start_matches('\n'));
        if more > 0 {
            let _ = writeln!(out, "\nand {more} more: --json and --format csv have them all.");
        }
    }

    /// How far along either wire.
    fn arclengths(&self, pair: &Approach) -> [f64; 2] {
        [0, 1].map(|k| self.set.members[pair.wires[k]].arclength(pair.segments[k], pair.fractions[k]))
    }

    fn place(&self, pair: &Approach) -> Value {
        json!({
            "curves": pair.wires.map(|wire| &self.set.members[wire].name),
            "curve_numbers": pair.wires.map(|wire| wire + 1),
            "segments": pair.segments,
            "arclengths": self.arclengths(pair),
            "points": pair.points,
            "distance": pair.distance,
            "gap": self.diameters.as_ref().map(|_| pair.gap),
        })
    }

    /// As JSON. Lengths are in the unit of the coordinates; segments count from 0, segment i running from point i to the next.
    #[must_use]
    pub fn json(&self) -> String {
        let found = &self.found;
        let place = |pair: Option<&Approach>| pair.map(|pair| self.place(pair));
        let places =
            |pairs: &mut dyn Iterator<Item = &Approach>| -> Vec<Value> { pairs.map(|pair| self.place(pair)).collect() };
        let known = self.diameters.is_some();
        let mut top = header();
        top.insert("unit".into(), json!(self.set.unit));
        let curves = self.set.members.iter().enumerate().map(|(i, member)| {
            let mut curve = super::curve::described(member);
            curve.insert("diameter".into(), json!(self.diameters.as_ref().map(|diameters| diameters[i])));
            curve.insert("chord_sagitta".into(), json!(self.wires.sagitta(i)));
            let radius = self.wires.bend_radius(i);
            curve.insert("least_bend_radius".into(), json!(Some(radius).filter(|radius| radius.is_finite())));
            Value::Object(curve)
        });
        top.insert("curves".into(), curves.collect());
        top.insert("least_distance".into(), json!(found.nearest().map(|nearest| nearest.distance)));
        top.insert("clearance".into(), json!(found.tightest().filter(|_| known).map(|tightest| tightest.gap)));
        top.insert("overlapping_pairs".into(), json!(known.then(|| found.overlaps().count())));
        top.insert(
            "overlapping_pairs_beyond_chords".into(),
            json!(known.then(|| self.beyond_chords(found.overlaps()))),
        );
        top.insert("where".into(), json!(place(found.tightest())));
        top.insert("nearest".into(), json!(place(found.nearest())));
        top.insert("overlaps".into(), json!(places(&mut found.overlaps())));
        let mut own = Map::new();
        own.insert("least_distance".into(), json!(found.own_nearest().map(|nearest| nearest.distance)));
        own.insert("clearance".into(), json!(found.own_tightest().map(|tightest| tightest.gap)));
        own.insert("overlapping_curves".into(), json!(known.then(|| found.own_overlaps().count())));
        own.insert(
            "overlapping_curves_beyond_chords".into(),
            json!(known.then(|| self.beyond_chords(found.own_overlaps()))),
        );
        own.insert("where".into(), json!(place(found.own_tightest())));
        own.insert("overlaps".into(), json!(places(&mut found.own_overlaps())));
        top.insert("itself".into(), Value::Object(own));
        top.insert("notes".into(), json!(self.notes()));
        format!("{:#}\n", Value::Object(top))
    }

    /// A header and one row for each pair that overlaps, wires with themselves included; where none does, for the nearest pair.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut pairs: Vec<&Approach> = self.found.overlaps().chain(self.found.own_overlaps()).collect();
        let overlap = !pairs.is_empty();
        if !overlap {
            pairs.extend(self.found.tightest().or_else(|| self.found.own_tightest()));
        }
        let mut rows = vec![
            [
                "curve_1",
                "curve_2",
                "overlap",
                "distance",
                "gap",
                "segment_1",
                "segment_2",
                "arclength_1",
                "arclength_2",
            ]
            .iter()
            .chain(&["x_1", "y_1", "z_1", "x_2", "y_2", "z_2"])
            .map(|name| (*name).to_owned())
            .collect::<Vec<_>>(),
        ];
        for pair in pairs {
            let mut row: Vec<String> = pair.wires.map(|wire| self.set.members[wire].name.clone()).into();
            row.extend([overlap.to_string(), format!("{:?}", pair.distance)]);
            row.push(self.diameters.as_ref().map_or_else(String::new, |_| format!("{:?}", pair.gap)));
            row.extend(pair.segments.map(|segment| segment.to_string()));
            row.extend(self.arclengths(pair).map(|arc| format!("{arc:?}")));
            row.extend(pair.points.as_flattened().iter().map(|x| format!("{x:?}")));
            rows.push(row);
        }
        super::curve::csv(&rows)
    }
}
