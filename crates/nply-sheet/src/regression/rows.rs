//! Columns made into rows: what each holds and measures, loads that nobody gave, and rows that are left out.

use super::parameter::Slot;
use super::row::{Datum, Row};
use super::state::Model;
use super::{DataColumn, Given, Observable, Parameter, RegressionError, Role};

/// A row that is not fitted: its line, and why.
pub(super) type LeftOut = (usize, String);

const LOADS: [Observable; 2] = [Observable::Force, Observable::Moment];

/// Loads in no column, which are 0: but for the moment where turns are held, since it takes one to hold them.
pub(super) fn taken_as_zero(columns: &[DataColumn]) -> Vec<Observable> {
    let gives = |load: Observable| columns.iter().any(|column| column.given == Given::State(load));
    let holds_turns = columns.iter().any(|column| column.role == Role::Held && is_turns(column.given));
    let free = |load: Observable| holds_turns && load == Observable::Moment;
    LOADS.into_iter().filter(|load| !gives(*load) && !free(*load)).collect()
}

/// Loads that nothing is known of: what they are is found with each row's state.
pub(super) fn free_loads(columns: &[DataColumn]) -> Vec<Observable> {
    let zero = taken_as_zero(columns);
    let known =
        |load: Observable| columns.iter().any(|column| column.given == Given::State(load) && column.has_values());
    LOADS.into_iter().filter(|load| !zero.contains(load) && !known(*load)).collect()
}

const fn is_turns(given: Given) -> bool {
    matches!(given, Given::State(observable) if observable.is_signed())
}

/// Where errors are not known: a thousandth of the greatest number, so that sums are of a sensible size.
fn unweighted_unit(column: &DataColumn) -> f64 {
    let greatest =
        column.values.iter().filter(|value| value.is_finite()).fold(0.0_f64, |most, value| most.max(value.abs()));
    if greatest > 0.0 { 1e-3 * greatest } else { 1.0 }
}

/// Every row that can be fitted, and those that cannot.
pub(super) fn of(
    model: &Model,
    asked: &[Parameter],
    columns: &[DataColumn],
    lines: &[usize],
) -> Result<(Vec<Row>, Vec<LeftOut>), RegressionError> {
    let absent = taken_as_zero(columns);
    let mut rows = Vec::with_capacity(lines.len());
    let mut left_out = Vec::new();
    let twist_column = columns.iter().find(|column| matches!(column.given, Given::Twist(_)));
    let units: Vec<f64> = columns.iter().map(unweighted_unit).collect();
    // a twist that is sought is not 0 for long
    let sought = asked.iter().any(|parameter| parameter.slot() == Slot::Twist);
    let untwisted = !sought && model.slots()[Slot::Twist as usize] == 0.0;
    for (i, &line) in lines.iter().enumerate() {
        let held = absent.iter().map(|load| (*load, 0.0)).collect();
        let mut row = Row { line, held, measured: Vec::new(), twist: None, straight: false };
        for (at, column) in columns.iter().enumerate() {
            let value = column.values[i];
            if !value.is_finite() {
                continue;
            }
            match (column.given, &column.role) {
                (Given::Twist(form), _) => row.twist = Some((form, value)),
                (Given::State(observable), Role::Held) => row.held.push((observable, value)),
                (Given::State(observable), Role::Measured(errors)) => {
                    row.measured.push(Datum { column: at, observable, value, error: errors[i] });
                }
                (Given::State(observable), Role::Unweighted) => {
                    row.measured.push(Datum { column: at, observable, value, error: units[at] });
                }
            }
        }
        // a row that says nothing
        let missing = match twist_column {
            _ if row.measured.is_empty() => Some("measured number"),
            Some(column) if row.twist.is_none() => Some(column.given.name()),
            _ => None,
        };
        if let Some(missing) = missing {
            left_out.push((line, format!("no {missing}")));
            continue;
        }
        let shapes = row.held.iter().filter(|(observable, _)| !observable.is_load()).count();
        let shapes = shapes > 1 && !model.stretches();
        if row.held.len() > 2 || shapes {
            let held = row.held.iter().map(|(observable, _)| observable.name()).collect();
            return Err(RegressionError::Overheld { line, held, shapes });
        }
        let found = row.held.len() + row.measured.len();
        if found < 2 {
            return Err(RegressionError::Underfixed { line, found });
        }
        row.straight = row.may_lie_straight(model, row.twist.map_or(untwisted, |(_, twist)| twist == 0.0));
        if row.holds_no_turns() && !row.straight {
            let others = row.held.iter().filter(|(observable, value)| !(observable.is_signed() && *value == 0.0));
            let others: Vec<&str> = others.map(|(observable, _)| observable.name()).collect();
            left_out.push((line, format!("no turns, and straight strands do not keep {},", others.join(" and "))));
            continue;
        }
        rows.push(row);
    }
    if rows.is_empty() { Err(RegressionError::NoRows) } else { Ok((rows, left_out)) }
}
