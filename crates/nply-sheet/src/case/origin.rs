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
            let message = format!("no ply can be like this: {quantity} = {value}{unit} must be {allowed}");
            return SpecError::new(ErrorKind::Domain, self.head.clone(), message).of_key(quantity);
        };
        let said = entry.said();
        let message = format!("{said} is {quantity} = {value}{unit}, and no ply has it: it must be {allowed}");
        entry.error(ErrorKind::Domain, message)
    }
}
