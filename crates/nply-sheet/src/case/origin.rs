//! From a quantity of the theory back to the datum it came from.

use nply::DomainError;

use crate::key::Group;
use crate::spec::{Entry, Spec};
use crate::{Datum, ErrorKind, Place, SpecError};

/// Where each datum of a case was written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Origins {
    entries: Vec<Entry>,
    head: Place,
}

impl Origins {
    pub(super) fn of(spec: &Spec) -> Self {
        Self { entries: spec.entries.clone(), head: spec.head() }
    }

    /// The refusal, said at the datum it is about, or at the head of the input where there is none.
    pub(super) fn locate(&self, error: &DomainError) -> SpecError {
        let DomainError { quantity, value, allowed } = *error;
        let in_group = |group| self.entries.iter().find(|entry| entry.key.group == Some(group));
        let named = |datum| self.entries.iter().find(|entry| entry.key.datum == datum);
        let origin = match quantity {
            "strands" => named(Datum::Strands),
            "stiffness_ratio" | "torsional_stiffness" => in_group(Group::Torsion),
            "bending_stiffness" => in_group(Group::Bending),
            "strand_radius" => in_group(Group::Size),
            "strand_length" => named(Datum::StrandLength),
            "pretwist" | "strand_twist" | "twist" => in_group(Group::Twist),
            "force" => named(Datum::Force),
            "moment" => named(Datum::Moment),
            "external_pressure" => named(Datum::ExternalPressure),
            "helical_angle" | "pitch_angle" | "lay_length" | "lay_ratio" | "radius_ratio" | "turns_per_length" => {
                in_group(Group::Lay)
            }
            _ => None,
        };
        let unit = match quantity {
            "helical_angle" | "pitch_angle" => " rad",
            "lay_length" | "strand_length" => " strand radii",
            _ => "",
        };
        let Some(entry) = origin else {
            let message = format!("no ply can be like this: {quantity} = {}{unit} must be {allowed}", short(value));
            return SpecError::new(ErrorKind::Domain, self.head.clone(), message).of_key(quantity);
        };
        let said = entry.said();
        // what was written need not be said again
        let message = if entry.key.name == quantity && entry.is_bare(value) {
            format!("{said}: no ply has it; it must be {allowed}")
        } else {
            format!("{said} is {quantity} = {}{unit}, and no ply has it: it must be {allowed}", short(value))
        };
        entry.error(ErrorKind::Domain, message)
    }
}

/// A number as a person writes it: 1e-200 and not two hundred zeros.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-4..1e15).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}
