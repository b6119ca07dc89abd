//! From a quantity of the theory back to the datum it came from.

use nply::DomainError;
use nply::geometry::SpecialLays;

use super::ends;
use crate::key::Group;
use crate::preferred::{six_digits, six_digits_within};
use crate::spec::{Entry, Spec, Value};
use crate::{Case, Datum, ErrorKind, Place, Quantity, Question, SpecError};

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
            "rotation" | "extension" => in_group(Group::Ends),
            "core_radius" => in_group(Group::Support),
            "helical_angle" | "pitch_angle" | "lay_length" | "lay_ratio" | "radius_ratio" | "turns_per_length" => {
                // the angle may be that of ends that are held
                in_group(Group::Lay).or_else(|| named(Datum::HelixRadius)).or_else(|| in_group(Group::Ends))
            }
            _ => None,
        };
        let unit = match quantity {
            "helical_angle" | "pitch_angle" => " rad",
            "lay_length" | "strand_length" | "core_radius" => " strand radii",
            _ => "",
        };
        let Some(entry) = origin else {
            let message = format!("no ply can be like this: {quantity} = {}{unit} must be {allowed}", short(value));
            return SpecError::new(ErrorKind::Domain, self.head.clone(), message).of_key(quantity);
        };
        if let Some(message) = self.too_narrow(entry, error).or_else(|| self.too_close(entry, error)) {
            return entry.error(ErrorKind::Domain, message);
        }
        let said = entry.said();
        // what was written need not be said again
        let message = if entry.key.name == quantity && entry.is_bare(value) {
            format!("{said}: no ply has it; it must be {allowed}")
        } else {
            format!("{said} is {quantity} = {}{unit}, and no ply has it: it must be {allowed}", short(value))
        };
        entry.error(ErrorKind::Domain, message)
    }

    /// What is to be said of a helix or core on which touching strands have no room: what they need at least, in the words of whoever wrote it.
    fn too_narrow(&self, entry: &Entry, error: &DomainError) -> Option<String> {
        let strands = self.entries.iter().find(|entry| entry.key.datum == Datum::Strands)?.number();
        // straight strands that touch: R/r = 1/sin(π/n)
        let least = 1.0 / libm::sin(core::f64::consts::PI / strands);
        if error.quantity != "radius_ratio" || !(error.value > 0.0 && error.value < least) {
            return None;
        }
        // what is written is proportional to R, or to R − r
        let below = match entry.key.datum {
            Datum::HelixRadius | Datum::RadiusRatio => 0.0,
            Datum::CoreRadius | Datum::CoreDiameter => 1.0,
            _ => return None,
        };
        let needed = entry.number() * (least - below) / (error.value - below);
        let needed = match &entry.value {
            Value::Quantity(Quantity::Measured { unit, .. }) => format!("{} {unit}", six_digits(unit.of_si(needed))),
            _ => six_digits(needed),
        };
        let ratio = six_digits(error.value);
        let room = if entry.key.datum == Datum::RadiusRatio && entry.is_bare(error.value) {
            format!("{strands} touching strands need at least {needed}, 1/sin(180°/{strands})")
        } else {
            let least = six_digits(least);
            format!("with it R/r is {ratio}, and {strands} touching strands need at least {least}, here {needed}")
        };
        Some(format!("{}: {room}", entry.said()))
    }

    /// What is to be said of turns that lie closer than strands are thick: the limit, in the words of whoever wrote it.
    fn too_close(&self, entry: &Entry, error: &DomainError) -> Option<String> {
        let strands = self.entries.iter().find(|entry| entry.key.datum == Datum::Strands)?.number();
        // flat rings on top of each other: the lay length is n strand diameters
        let least = 2.0 * strands;
        let of_turns = entry.key.datum == Datum::PlyTurnsPerLength && error.quantity == "lay_length";
        if !(of_turns && error.value > 0.0 && error.value < least) {
            return None;
        }
        let most = entry.number().abs() * (error.value / least);
        let most = match &entry.value {
            Value::Quantity(Quantity::Measured { unit, .. }) => {
                format!("{} {unit}", six_digits_within(unit.of_si(most)))
            }
            _ => format!("{} turns per strand radius", six_digits_within(most)),
        };
        Some(format!(
            "{}: {strands} touching strands cannot be laid so closely; it must be less than {most}, at which the lay length is {strands} strand diameters \
             and the strands are flat rings on top of each other",
            entry.said()
        ))
    }

    /// A refusal said at a datum, at another of its group, or at the head of the input.
    pub(super) fn refuse_domain(&self, datum: Datum, why: &str) -> SpecError {
        let group = crate::Key::of(datum).and_then(|key| key.group);
        let of = |entry: &&Entry| entry.key.datum == datum || (group.is_some() && entry.key.group == group);
        match self.entries.iter().find(of) {
            Some(entry) => entry.error(ErrorKind::Domain, format!("{}: {why}", entry.said())),
            None => SpecError::new(ErrorKind::Domain, self.head.clone(), why),
        }
    }

    /// Whether a datum was given, and not taken to be 0.
    pub(super) fn give(&self, datum: Datum) -> bool {
        self.entries.iter().any(|entry| entry.key.datum == datum)
    }

    /// A refusal said at the first datum of those wanted, or at the head of the input where there is none.
    pub(super) fn refuse(&self, wanted: impl Fn(&Entry) -> bool, message: impl FnOnce(&str) -> String) -> SpecError {
        match self.entries.iter().find(|entry| wanted(entry)) {
            Some(entry) => entry.error(ErrorKind::Contradiction, message(&entry.said())),
            None => SpecError::new(ErrorKind::Contradiction, self.head.clone(), message("the question")),
        }
    }

    /// The refusal of ends that are held where no ply can be, in the words of whoever wrote it.
    pub(super) fn displaced(&self, case: &Case, error: &DomainError) -> Option<SpecError> {
        let entry = self.entries.iter().find(|entry| entry.key.group == Some(Group::Ends))?;
        let most = SpecialLays::of(case.strands).ok()?.zero_twist();
        let limit = most.angle().sin() / most.radius_ratio();
        let said = entry.said();
        let message = match error.quantity {
            "rotation" if error.value.abs() > limit => {
                let written = ends::as_written(entry, limit, case.strand_radius, case.strand_length);
                format!(
                    "{said}: touching strands cannot take so many turns; the most that {} of them can take is {written}, either way",
                    case.strands
                )
            }
            "rotation" => format!(
                "{said}: strands without turns lie straight and are no ply; give more, positive for a right-handed ply and negative for a left-handed one"
            ),
            "extension" if error.value >= 1.0 && matches!(case.question, Question::Stretched { .. }) => {
                format!(
                    "{said}: strands are stretched to no more than double their length; give less than twice theirs"
                )
            }
            "extension" if error.value >= 1.0 => {
                format!("{said}: a ply is shorter than its strands; give a length less than theirs")
            }
            "extension" => format!("{said}: a ply of no length is none; give a length greater than 0"),
            _ => return None,
        };
        Some(entry.error(ErrorKind::Domain, message))
    }
}

/// A number as a person writes it: 1e-200 and not two hundred zeros.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-4..1e15).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}
