//! A path as a table, as CSV and as JSON.

use core::fmt::Write as _;

use nply::mechanics::{Contacts, End, Event, Stability, Twist};
use serde_json::{Map, Value, json};

use super::stop::Stop;
use super::words::{carried_by, ended, what};
use super::{Walked, held_name, twist_of};
use crate::Case;
use crate::report::csv::unit_suffix;
use crate::report::item::{Item, Reader, numbers, of_hand, units};
use crate::report::json::header;
use crate::report::text::{Emphasis, Row, hand, lay_out, title};
use crate::report::{Known, Measure};

impl<S: Stop> Walked<S> {
    /// The path as a table: its start, what happens on the way, its end.
    pub(super) fn text(&self, emphasis: bool) -> String {
        let Some(case) = self.cases.first() else { return String::new() };
        let emphasis = &Emphasis(emphasis);
        let reader = Reader { known: self.known(), units: &case.units, emphasis };
        let mut out = String::new();
        let contacts = match self.contacts {
            Contacts::Unilateral => "contacts push only".to_owned(),
            Contacts::Kept(balance) => format!("neighbours kept together, {} balance", balance.name()),
        };
        let _ = writeln!(out, "{}", emphasis.heading(&format!("{}{} strands, {contacts}", title(case), case.strands)));
        let shown = self.shown();
        if !shown.is_empty() {
            lay_out(&mut out, &[("", self.table(&shown, &reader))], emphasis);
        }
        for note in &self.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// One line for each of the stations shown; of the numbers those that change on the way.
    fn table(&self, shown: &[(String, S)], reader: &Reader<'_>) -> Vec<Row> {
        let all: Vec<S> = shown.iter().map(|(_, station)| *station).collect();
        let changes = |item: &Item<S>| all.iter().any(|station| item.of(station) != item.of(&all[0]));
        let of_core = |item: &Item<S>| item.name == "core_pressure" && all[0].has_core();
        let kept = |item: &&Item<S>| {
            let name = item.name;
            !item.label.is_empty()
                && (S::ALWAYS.contains(&name)
                    || of_core(item)
                    || self.given(name) && changes(item)
                    || name == "extension" && self.legs.iter().any(|leg| leg.held.length)
                    || name == "turns_per_strand_length" && self.legs.iter().any(|leg| leg.held.rotation))
        };
        let columns: Vec<(&str, Row)> =
            S::NUMBERS.iter().filter(kept).filter_map(|item| Some((item.label, column(item, reader, &all)?))).collect();
        let row = |label: String, first: [&str; 4], cells: &dyn Fn(&(&str, Row)) -> String| Row {
            label,
            unit: first[0].to_owned(),
            cells: first[1..].iter().map(|word| (*word).to_owned()).chain(columns.iter().map(cells)).collect(),
        };
        let mut rows = vec![
            row("leg".to_owned(), ["share", "hand", "carried by", "stability"], &|(label, _)| (*label).to_owned()),
            row(String::new(), [""; 4], &|(_, column)| column.unit.clone()),
        ];
        for (i, (label, station)) in shown.iter().enumerate() {
            // back at the start, rounding may leave a little less than nothing
            let share = format!("{:.4}", libm::round(station.along() * 1e4) / 1e4 + 0.0);
            let verdict = station.verdict().map_or("–", Stability::name);
            let first = [share.as_str(), hand(station.hand()), carried_by(station), verdict];
            rows.push(row(label.clone(), first, &|(_, column)| column.cells[i].clone()));
        }
        rows
    }

    /// Whether a number is one of the data besides the ends', and not found; a twist as turns per length where the strand has a size.
    fn given(&self, name: &str) -> bool {
        let held = |case: &Case| matches!(twist_of(case), Some(Twist::StrandTwist(_)));
        let strand_twist = self.cases.first().is_some_and(held);
        let per_length = self.known().strand_radius.is_some();
        match name {
            "pretwist" => !strand_twist && !per_length,
            "pretwist_per_length" => !strand_twist && per_length,
            "strand_twist" => strand_twist && !per_length,
            "strand_twist_per_length" => strand_twist && per_length,
            "stiffness_ratio" | "core_radius" => true,
            _ => false,
        }
    }

    /// Start, events and end, each with its leg and a word for it.
    fn shown(&self) -> Vec<(String, S)> {
        let mut shown = Vec::new();
        for (i, leg) in self.legs.iter().enumerate() {
            let number = i + 1;
            if let (0, Some(start)) = (i, leg.trace.stations.first()) {
                shown.push((format!("{number} start"), *start));
            }
            shown.extend(leg.trace.events.iter().map(|event| (format!("{number} {}", what(event)), event.station)));
            if let (true, Some(last)) = (leg.trace.end != End::Arrival, leg.trace.stations.last()) {
                shown.push((format!("{number} {}", ended(leg.trace.end)), *last));
            }
        }
        shown
    }

    /// Every station as CSV.
    pub(super) fn csv(&self) -> String {
        let known = self.known();
        let si: Vec<_> = S::NUMBERS.iter().filter_map(|item| Some((item, item.measure.si(known)?))).collect();
        let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
        let mut head: Vec<String> =
            ["leg", "along", "handedness", "lay", "support", "stability"].map(String::from).into();
        head.extend(S::NUMBERS.iter().map(|item| item.name.to_owned()));
        head.extend(si.iter().map(|(item, (_, unit))| format!("{}_{}", item.name, unit_suffix(unit))));
        let mut out = head.join(",") + "\n";
        for (leg, station) in self.stations() {
            let mut cells = vec![
                leg.to_string(),
                number(Some(station.along())),
                station.hand().sign().to_string(),
                station.hand().lay_letter().to_string(),
                station.carried().name().to_owned(),
                station.verdict().map_or("", Stability::name).to_owned(),
            ];
            cells.extend(S::NUMBERS.iter().map(|item| number(item.of(station))));
            cells.extend(si.iter().map(|(item, (factor, _))| number(item.of(station).map(|value| value * factor))));
            out += &(cells.join(",") + "\n");
        }
        out
    }

    /// Every station and event as JSON.
    pub(super) fn json(&self) -> String {
        let known = self.known();
        let mut top = header();
        if let Some(case) = self.cases.first() {
            if let Some(title) = &case.title {
                top.insert("title".into(), json!(title));
            }
            top.insert("strands".into(), json!(case.strands));
            top.insert("balance".into(), json!(case.balance.name()));
        }
        top.insert("contacts".into(), json!(if self.contacts == Contacts::Unilateral { "unilateral" } else { "kept" }));
        let units: Map<String, Value> = units(S::NUMBERS, known).collect();
        if !units.is_empty() {
            top.insert("si_units".into(), Value::Object(units));
        }
        let station = |station: &S| object(station, known);
        top.insert("starts".into(), self.starts.iter().map(station).collect());
        top.insert("start".into(), json!(self.starts.get(self.chosen).map(|_| self.chosen + 1)));
        let legs = self.legs.iter().map(|leg| {
            let event = |event: &Event<S>| {
                let mut object = Map::new();
                object.insert("event".into(), json!(event.mark.name()));
                object.insert("before_station".into(), json!(event.before));
                object.insert("station".into(), station(&event.station));
                let jump = event.jump.as_ref().map(|to| to.iter().map(station).collect::<Vec<_>>());
                object.insert("jump".into(), json!(jump));
                Value::Object(object)
            };
            json!({
                "holding": held_name(leg.held),
                "end": leg.trace.end.name(),
                "events": leg.trace.events.iter().map(event).collect::<Vec<_>>(),
                "stations": leg.trace.stations.iter().map(station).collect::<Vec<_>>(),
            })
        });
        top.insert("legs".into(), legs.collect());
        top.insert("notes".into(), json!(self.notes));
        format!("{:#}\n", Value::Object(top))
    }
}

/// The numbers of a column; what is nothing beside the largest of them is 0, as where a contact opens or strands run straight. A walk ends
/// just before flat rings: what is there beyond all the others, or nothing beside them, is on its way to ∞ or to 0.
fn column<S: Stop>(item: &Item<S>, reader: &Reader<'_>, all: &[S]) -> Option<Row> {
    const NOTHING: f64 = 1e-13;
    const NEXT_TO_RINGS: f64 = 1e-7;
    let mut row = reader.row(item, "", all, &[])?;
    let largest = |of: &dyn Fn(&S) -> bool| {
        all.iter().filter(|s| of(s)).filter_map(|s| item.of(s)).fold(0.0, |most: f64, v| most.max(v.abs()))
    };
    let flat = |station: &S| station.lay_angle().pitch_angle() < NEXT_TO_RINGS;
    let (of_all, of_others) = (largest(&|_| true), largest(&|station| !flat(station)));
    for (cell, station) in row.cells.iter_mut().zip(all) {
        let Some(value) = item.of(station) else { continue };
        let size = value.abs();
        if flat(station) && of_others > 0.0 && size > of_others / NEXT_TO_RINGS {
            if value < 0.0 { "-∞" } else { "∞" }.clone_into(cell);
        } else if flat(station) && size < NEXT_TO_RINGS * of_others
            // a radius is never nothing, however far free helices open
            || item.measure != Measure::Number && size < NOTHING * of_all
        {
            "0".clone_into(cell);
        }
    }
    Some(row)
}

fn object<S: Stop>(station: &S, known: Known) -> Value {
    let mut object = Map::new();
    object.insert("along".into(), json!(station.along()));
    object.extend(of_hand(station.hand()));
    object.insert("support".into(), json!(station.carried().name()));
    object.insert("separated".into(), json!(station.separated()));
    object.insert("stability".into(), json!(station.verdict().map(Stability::name)));
    object.insert("helical_angle".into(), json!(station.lay_angle().radians()));
    Value::Object(numbers(object, S::NUMBERS, station, known))
}
