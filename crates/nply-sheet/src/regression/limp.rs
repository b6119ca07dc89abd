//! Strings of which shapes alone are known: no stiffness has a bearing on these, and none need be given.

use super::columns::Roles;
use super::{DataColumn, Given, Measurements, Observable, Parameter, Role};
use crate::Datum;
use crate::key::Group;
use crate::spec::Spec;

/// What is said where no stiffness was given.
pub(super) const NOTE: &str = "No stiffness is given, and the estimates do not depend on it: shapes of strands that do not stretch are held and \
                               measured here. Moments and pressures are those of limp strands.";

/// The description of limp strands, where it leaves their stiffness out and that does not matter; else `None`.
pub(super) fn described(spec: &Spec, data: &Measurements, roles: &Roles, asked: &[Parameter]) -> Option<Spec> {
    let given = |group| spec.entries.iter().any(|entry| entry.key.group == Some(group));
    let columns = data.with_roles(roles).ok()?;
    if given(Group::Torsion) || !of_size(asked) || spec.stretches() || spec.get(Datum::Moment).is_some() {
        return None;
    }
    if !shapes_alone(&columns) {
        return None;
    }
    let twisted = given(Group::Twist) || columns.iter().any(|column| matches!(column.given, Given::Twist(_)));
    let more = [
        ("stiffness-ratio", "1", true),
        // as good as none beside any load
        ("bending-stiffness", "1e-6 N mm^2", given(Group::Size) && !given(Group::Bending)),
        ("strand-twist", "0", !twisted),
    ];
    let more = more.into_iter().filter(|(_, _, missing)| *missing).map(|(key, value, _)| (key, value));
    let mut spec = spec.clone();
    spec.entries.extend(Spec::from_flags(more).ok()?.entries);
    Some(spec)
}

fn of_size(asked: &[Parameter]) -> bool {
    asked.iter().all(|parameter| matches!(parameter, Parameter::Radius | Parameter::Diameter))
}

/// Whether turns are held, nothing but shapes is measured, and no moment is known.
fn shapes_alone(columns: &[DataColumn]) -> bool {
    let observable = |column: &DataColumn| match column.given {
        Given::State(observable) => Some(observable),
        Given::Twist(_) => None,
    };
    let held = |column: &DataColumn| column.role == Role::Held;
    let turns = |column: &DataColumn| observable(column).is_some_and(Observable::is_signed);
    let load = |column: &DataColumn| observable(column).is_some_and(Observable::is_load);
    columns.iter().any(|column| held(column) && turns(column))
        && columns.iter().all(|column| held(column) || !load(column))
        && columns.iter().all(|column| observable(column) != Some(Observable::Moment))
}
