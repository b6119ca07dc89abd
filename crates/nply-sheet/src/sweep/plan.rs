//! How the rows of a study are worked out.

use std::sync::Arc;

use nply::geometry::Contact;

use super::ask::{Base, Output};
use super::fast::Fast;
use super::run::quantity;
use super::sink::{Answers, Sink};

use super::States;
use crate::report::{Found, Given, Known, StateKind};
use crate::solve;
use crate::spec::sweep::{Run, SweepSpec, find_key, may_vary, refused, refused_at, unit_behind};
use crate::spec::{Entry, Spec, Value, read_text};
use crate::table::{Column, Kind as Cells, Values};
use crate::{ErrorKind, Key, Kind, Place, SpecError, Unit, quoted};

/// A datum that a column gives.
#[derive(Clone, Debug)]
pub(super) struct GivenKey {
    pub(super) key: &'static Key,
    pub(super) unit: Option<Unit>,
    pub(super) column: Column,
}

impl GivenKey {
    pub(super) fn of_run(run: &Run) -> Self {
        Self { key: run.key, unit: run.unit.clone(), column: run.column() }
    }

    /// The datum of a column from outside, if it is one.
    pub(super) fn of_column(column: &Column) -> Result<Option<Self>, SpecError> {
        let name = column.name.trim();
        let refuse = |kind, why: String| Err(refused(kind, "rows", format!("column {}: {why}", quoted(name))));
        let by_unit = || {
            // the longest name that leaves a unit
            let cuts = name.match_indices('_').map(|(at, _)| at).rev();
            cuts.filter_map(|at| {
                let key = find_key(&name[..at])?;
                Some((key, Some(unit_behind(key, &name[at + 1..])?)))
            })
            .next()
        };
        let Some((key, behind)) = find_key(name).map(|key| (key, None)).or_else(by_unit) else { return Ok(None) };
        let place = Place::Flag("rows".to_owned());
        may_vary(key, &place)?;
        let beside = match column.unit.trim() {
            "" => None,
            unit => match Unit::parse(unit) {
                Ok(unit) => Some(unit),
                Err(error) => return refuse(ErrorKind::WrongUnit, error.to_string()),
            },
        };
        let unit = match (behind, beside) {
            (Some(a), Some(b))
                if a.dimension() != b.dimension() || a.to_si(1.0).to_bits() != b.to_si(1.0).to_bits() =>
            {
                return refuse(ErrorKind::Contradiction, format!("its name says {a}, and its unit is {b}"));
            }
            (behind, beside) => behind.or(beside),
        };
        match &unit {
            Some(unit) => {
                let dimension = unit.dimension();
                if key.kind.dimension() != Some(dimension) && !key.kind.is_relative(dimension) {
                    return refuse(
                        ErrorKind::WrongUnit,
                        format!("{unit} is {dimension}; what is wanted is {}", key.kind.wanted()),
                    );
                }
            }
            None if !key.is_word() && !key.kind.may_be_bare() && column.kind != Cells::Text => {
                return refuse(
                    ErrorKind::WrongUnit,
                    format!("its unit is missing: name it with its unit, such as `{name}_{}`", an_example(key)),
                );
            }
            None => {}
        }
        Ok(Some(Self { key, unit, column: column.clone() }))
    }

    /// What a cell says, without the text for messages.
    fn value(&self, cells: &Values, row: usize, place: &Place) -> Result<Option<Value>, SpecError> {
        let text = |text: &str| -> Result<Option<Value>, SpecError> {
            if text.trim().is_empty() {
                return Ok(None);
            }
            match (&self.unit, text.trim().parse::<f64>()) {
                (Some(_), Ok(number)) => self.number(number, place).map(Some),
                _ => read_text(self.key, text, place).map(Some),
            }
        };
        match cells {
            Values::Dense(cells) => cells.get(row).map(|value| self.number(*value, place)).transpose(),
            Values::Float(cells) => {
                cells.get(row).copied().flatten().map(|value| self.number(value, place)).transpose()
            }
            Values::Counts(cells) => cells.get(row).map(|value| self.number(*value as f64, place)).transpose(),
            Values::Integer(cells) => {
                cells.get(row).copied().flatten().map(|value| self.number(value as f64, place)).transpose()
            }
            Values::Boolean(cells) => match cells.get(row).copied().flatten() {
                Some(switch) if self.key.kind == Kind::Switch => Ok(Some(Value::Switch(switch))),
                Some(switch) => text(&switch.to_string()),
                None => Ok(None),
            },
            Values::Text(cells) => cells.get(row).and_then(Option::as_deref).map_or(Ok(None), text),
            Values::Words(cells) => cells.get(row).copied().flatten().map_or(Ok(None), text),
            Values::Nothing(..) => Ok(None),
        }
    }

    fn number(&self, value: f64, place: &Place) -> Result<Value, SpecError> {
        if self.key.is_word() {
            return read_text(self.key, &format!("{value}"), place);
        }
        let quantity = quantity(value, self.unit.as_ref());
        if value.is_finite() && quantity.si().is_finite() {
            return Ok(Value::Quantity(quantity));
        }
        let message = format!("`{} = {value}`: it is not a finite number; no ply has it", self.key.name);
        Err(SpecError::new(ErrorKind::Domain, place.clone(), message))
    }

    /// The cell for messages.
    fn written(&self, value: &Value) -> String {
        match value {
            Value::Quantity(quantity) => match &self.unit {
                Some(unit) => format!("{} {unit}", crate::preferred::six_digits(unit.of_si(quantity.si()))),
                None => quantity.si().to_string(),
            },
            Value::Balance(balance) => balance.name().to_owned(),
            Value::Hand(hand) => if hand.sign() > 0.0 { "right" } else { "left" }.to_owned(),
            Value::Text(text) => quoted(text),
            Value::Switch(switch) => switch.to_string(),
        }
    }
}

/// A unit that a column of a datum may have.
fn an_example(key: &Key) -> &'static str {
    match key.kind {
        Kind::Angle => "deg",
        Kind::Stiffness => "N_m2",
        Kind::Pressure | Kind::Modulus => "GPa",
        Kind::LinearDensity => "tex",
        Kind::Temperature => "K",
        _ => "mm",
    }
}

/// All that is the same for every row.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub(super) kind: StateKind,
    pub(super) states: States,
    pub(super) outputs: Vec<Output>,
    pub(super) given: Vec<GivenKey>,
    /// `row`, what is given, `state`, what is asked, `reason`.
    pub(super) columns: Vec<Column>,
    base: Spec,
    /// the description without what the given data take the place of
    rest: Spec,
    place: Place,
    fast: Fast,
}

/// States of one row, and what is known of its ply.
pub(super) struct RowStates {
    pub(super) given: Given,
    pub(super) known: Known,
    pub(super) states: RowFound,
}

pub(super) enum RowFound {
    Contact(Contact),
    States(solve::States),
}

impl RowStates {
    /// One after the other.
    pub(super) fn each(&self) -> Vec<Found<'_>> {
        match &self.states {
            RowFound::Contact(contact) => vec![Found::Contact(contact)],
            RowFound::States(solve::States::Touching(list)) => list.iter().map(Found::Touching).collect(),
            RowFound::States(solve::States::Supported(list)) => list.iter().map(Found::Supported).collect(),
            RowFound::States(solve::States::Stretched(list)) => list.iter().map(Found::Stretched).collect(),
        }
    }
}

impl Plan {
    pub(super) fn new(
        base: &Spec,
        written: &SweepSpec,
        given: Vec<GivenKey>,
        states: States,
    ) -> Result<Self, SpecError> {
        let keys: Vec<&'static Key> = given.iter().map(|given| given.key).collect();
        let described = Base { spec: base, keys: &keys };
        let asked = written.outputs.as_deref();
        let question = written.question.as_ref().map(|(question, _)| *question);
        let kind = described.kind(question, asked);
        let place = written.place.clone().unwrap_or_else(|| base.head());
        if let (StateKind::Contact, States::Stable | States::Continued) = (kind, states) {
            let place = written.states.as_ref().map_or(&place, |(_, place)| place);
            let message =
                "the shape of a lay is no equilibrium: no state of it is stable or continued; leave `states` out";
            return Err(refused_at(ErrorKind::Contradiction, place, message));
        }
        let mut outputs = described.outputs(kind, asked)?;
        // what is given stands in its own column
        outputs.retain(|output| given.iter().all(|given| given.column.name != output.column.name));
        let mut columns = vec![Column::new("row", Cells::Integer)];
        columns.extend(given.iter().map(|given| given.column.clone()));
        if kind != StateKind::Contact {
            columns.push(Column::new("state", Cells::Integer));
        }
        columns.extend(outputs.iter().map(|output| output.column.clone()));
        columns.push(Column::new("reason", Cells::Text));
        let place = Place::in_file(&Arc::from("row"), "", 0..0);
        let rest = without(base, &keys, &place);
        let fast = Fast::of(kind, states, &given, &rest, &outputs);
        Ok(Self { kind, states, outputs, given, columns, base: base.clone(), rest, place, fast })
    }

    pub(super) const fn is_fast(&self) -> bool {
        !matches!(self.fast, Fast::None)
    }

    /// Answers to some rows, all states or the stable ones.
    pub(super) fn solve(&self, cells: &[Values], rows: usize) -> Answers {
        match &self.fast {
            Fast::Contact(contact) if contact.is_kernel() => contact.solve(self, cells, rows),
            fast => {
                let mut sink = Sink::new(&self.outputs, rows);
                match fast {
                    Fast::Contact(contact) => contact.each(self, cells, rows, &mut sink),
                    Fast::Touching(touching) => touching.solve(self, cells, rows, &mut sink),
                    Fast::None => (0..rows).for_each(|row| self.one(cells, row, &mut sink)),
                }
                sink.finish(self.kind != StateKind::Contact)
            }
        }
    }

    /// One row by itself.
    pub(super) fn one(&self, cells: &[Values], row: usize, sink: &mut Sink<'_>) {
        match self.row_states(cells, row) {
            Ok(found) => self.tell(row, &found.each(), &found.given, found.known, sink),
            Err(reason) => sink.refuse(row, reason),
        }
    }

    /// The states of a row that are asked for.
    pub(super) fn tell(&self, row: usize, states: &[Found<'_>], given: &Given, known: Known, sink: &mut Sink<'_>) {
        let mut told = false;
        for (number, found) in (1_i64..).zip(states) {
            if self.states == States::All || found.is_stable() {
                sink.push(row, (self.kind != StateKind::Contact).then_some(number), *found, given, known);
                told = true;
            }
        }
        if !told {
            sink.refuse(row, if states.is_empty() { NO_STATE } else { NO_STABLE_STATE }.to_owned());
        }
    }

    /// Every state of a row, or why there is no such ply.
    pub(super) fn row_states(&self, cells: &[Values], row: usize) -> Result<RowStates, String> {
        let values = |key: usize| self.given[key].value(&cells[key], row, &self.place);
        self.states_of(&values)
    }

    /// The same of given numbers, each in the unit of its datum; a number that is none leaves the row's own.
    pub(super) fn states_between(&self, cells: &[Values], row: usize, numbers: &[Option<f64>]) -> Option<RowStates> {
        let values = |key: usize| match numbers.get(key).copied().flatten() {
            Some(number) if number.is_finite() => self.given[key].number(number, &self.place).map(Some),
            _ => self.given[key].value(&cells[key], row, &self.place),
        };
        self.states_of(&values).ok()
    }

    fn states_of(&self, value: &dyn Fn(usize) -> Result<Option<Value>, SpecError>) -> Result<RowStates, String> {
        // words for a message are made only where there is one
        self.spec(value, false).and_then(|spec| self.found(&spec)).or_else(|error| {
            let explained = self.spec(value, true).and_then(|spec| self.found(&spec));
            explained.map_err(|again| sentence(if again.kind() == error.kind() { &again } else { &error }))
        })
    }

    fn spec(
        &self,
        value: &dyn Fn(usize) -> Result<Option<Value>, SpecError>,
        explain: bool,
    ) -> Result<Spec, SpecError> {
        let mut entries = Vec::with_capacity(self.given.len());
        for (at, given) in self.given.iter().enumerate() {
            let Some(value) = value(at)? else { continue };
            let written = if explain { given.written(&value) } else { String::new() };
            entries.push(Entry { key: given.key, value, place: self.place.clone(), written });
        }
        if entries.len() == self.given.len() {
            let mut spec = self.rest.clone();
            spec.entries.extend(entries);
            return Ok(spec);
        }
        let mut row = self.base.nothing_given();
        row.entries = entries;
        Ok(self.base.onward(&row))
    }

    fn found(&self, spec: &Spec) -> Result<RowStates, SpecError> {
        if self.kind == StateKind::Contact {
            let shape = spec.check_shape()?;
            let Some(lay) = shape.lay else {
                let message = "a single strand has no neighbours to touch: give 2 strands or more";
                return Err(SpecError::new(ErrorKind::Domain, self.place.clone(), message));
            };
            let contact = lay.contact(shape.strands).map_err(|error| shape.locate(&error))?;
            return Ok(RowStates {
                given: Given { strands: shape.strands, stiffness_ratio: f64::NAN, strand_length: None, parts: false },
                known: Known { scale: None, strand_radius: shape.strand_radius },
                states: RowFound::Contact(contact),
            });
        }
        let case = if self.kind == StateKind::Supported { spec.check_supports()? } else { spec.check()? };
        let states = case.states().map_err(|error| case.locate(&error))?;
        let fits = matches!(
            (self.kind, &states),
            (StateKind::Touching, solve::States::Touching(_))
                | (StateKind::Supported, solve::States::Supported(_))
                | (StateKind::Stretched, solve::States::Stretched(_))
        );
        if !fits {
            let message = "this row asks for states of another kind than the others";
            return Err(SpecError::new(ErrorKind::Contradiction, self.place.clone(), message));
        }
        Ok(RowStates { given: Given::of(&case), known: Known::of(&case), states: RowFound::States(states) })
    }
}

/// A row that gives these data, whatever their values.
pub(super) fn placeholders(base: &Spec, keys: &[&'static Key], place: &Place) -> Spec {
    let mut row = base.nothing_given();
    row.entries = keys
        .iter()
        .map(|key| Entry {
            key,
            value: Value::Quantity(crate::Quantity::Bare(0.0)),
            place: place.clone(),
            written: String::new(),
        })
        .collect();
    row
}

/// A description without what these data take the place of.
fn without(base: &Spec, keys: &[&'static Key], place: &Place) -> Spec {
    let mut rest = base.onward(&placeholders(base, keys, place));
    rest.entries.retain(|entry| keys.iter().all(|key| key.datum != entry.key.datum));
    rest
}

/// An error without its place: a row is no place in a file.
fn sentence(error: &SpecError) -> String {
    match error.help() {
        Some(help) => format!("{}; {help}", error.message()),
        None => error.message().to_owned(),
    }
}

pub(super) const NO_STATE: &str = "no state is in equilibrium with these data";
pub(super) const NO_STABLE_STATE: &str = "no state is stable with these data";
