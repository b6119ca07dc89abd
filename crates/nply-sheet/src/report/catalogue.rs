//! Everything that can be asked of a state by name: the lists of the reports, one after the other.

use core::f64::consts::TAU;

use nply::geometry::{Contact, Section};
use nply::mechanics::{Change, Equilibrium, ExtensibleState, Stability, SupportedState};
use nply::{Handedness, Scale};

use super::column::{COLUMNS, LENGTH_COLUMNS, written};
use super::margin::{self, Margins};
use super::support::Carried;
use super::verdict::Verdicts;
use super::{Known, Measure, shape, text};
use crate::Case;
use crate::table::Kind;

/// What sort of state is looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum StateKind {
    /// The shape of a given lay, and no equilibrium.
    Contact,
    /// Equilibria of strands that touch their neighbours.
    Touching,
    /// Equilibria on neighbours, a core, both or free.
    Supported,
    /// The same of strands that stretch.
    Stretched,
}

/// One state that was found.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Found<'a> {
    Contact(&'a Contact),
    Touching(&'a Equilibrium),
    Supported(&'a SupportedState),
    Stretched(&'a ExtensibleState),
}

/// What is known of the ply besides its state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given {
    pub(crate) strands: u32,
    pub(crate) stiffness_ratio: f64,
    /// L/r.
    pub(crate) strand_length: Option<f64>,
    /// Whether strands are asked to part.
    pub(crate) parts: bool,
}

impl Given {
    pub(crate) fn of(case: &Case) -> Self {
        Self {
            strands: case.strands,
            stiffness_ratio: case.stiffness_ratio,
            strand_length: case.strand_length,
            parts: super::at_separation(case),
        }
    }
}

/// One thing that can be asked by name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Listed {
    pub(crate) name: &'static str,
    pub(crate) measure: Measure,
    pub(crate) find: Find,
}

/// How it is found.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Find {
    OfContact(fn(&Contact) -> f64),
    OfTouching(fn(&Equilibrium) -> Option<f64>),
    OfLength(fn(&Equilibrium, f64) -> Option<f64>),
    OfSupported(fn(&SupportedState) -> Option<f64>),
    OfStretched(fn(&ExtensibleState) -> Option<f64>),
    Margin(Change, bool),
    MarginCause(Change, bool),
    ConvexCut,
    Handedness,
    Lay,
    Separated,
    Fold,
    Support,
    Verdict(usize),
    Strands,
    StiffnessRatio,
    Balance,
}

/// The names of the limits of a change.
const LIMITS: [(&str, &str, Change, bool); 10] = [
    ("margin_force_below", "margin_force_below_cause", Change::Force, true),
    ("margin_force_above", "margin_force_above_cause", Change::Force, false),
    ("margin_moment_below", "margin_moment_below_cause", Change::Moment, true),
    ("margin_moment_above", "margin_moment_above_cause", Change::Moment, false),
    ("margin_force_ends_held_below", "margin_force_ends_held_below_cause", Change::ForceEndsHeld, true),
    ("margin_force_ends_held_above", "margin_force_ends_held_above_cause", Change::ForceEndsHeld, false),
    ("margin_turns_below", "margin_turns_below_cause", Change::Turns, true),
    ("margin_turns_above", "margin_turns_above_cause", Change::Turns, false),
    ("margin_pretwist_below", "margin_pretwist_below_cause", Change::Pretwist, true),
    ("margin_pretwist_above", "margin_pretwist_above_cause", Change::Pretwist, false),
];

const VERDICTS: [&str; 4] =
    ["stability", "stability_rotation_held", "stability_length_held", "stability_strand_twist_held"];
const STRETCHED_VERDICTS: [&str; 5] = [
    "stability",
    "stability_rotation_held",
    "stability_length_held",
    "stability_both_held",
    "stability_strand_twist_held",
];

impl StateKind {
    /// All that can be asked of such a state.
    pub(crate) fn listed(self) -> Vec<Listed> {
        let word = |name, find| Listed { name, measure: Measure::Number, find };
        let mut list = vec![word("strands", Find::Strands)];
        if self == Self::Contact {
            list.extend(shape::CONTACT.iter().map(|(name, _, measure, of)| Listed {
                name,
                measure: *measure,
                find: Find::OfContact(*of),
            }));
            let more = |name, measure, of| Listed { name, measure, find: Find::OfContact(of) };
            list.push(more("ply_radius", Measure::Length, Contact::radius_ratio));
            list.push(more("turns_per_strand_length", Measure::TurnsPerLength, |c| {
                c.angle().sin() / c.radius_ratio() / TAU
            }));
            list.push(more("extension", Measure::Number, |c| c.angle().cos()));
            list.push(word("convex_cut", Find::ConvexCut));
            return list;
        }
        list.push(word("stiffness_ratio", Find::StiffnessRatio));
        list.push(word("handedness", Find::Handedness));
        list.push(word("lay", Find::Lay));
        match self {
            Self::Contact => {}
            Self::Touching => {
                list.extend([
                    word("balance", Find::Balance),
                    word("separated", Find::Separated),
                    word("fold", Find::Fold),
                ]);
                list.extend(VERDICTS.iter().enumerate().map(|(at, name)| word(name, Find::Verdict(at))));
                list.extend(COLUMNS.iter().map(|column| Listed {
                    name: column.name,
                    measure: column.measure,
                    find: Find::OfTouching(column.value),
                }));
                list.extend(LENGTH_COLUMNS.iter().map(|column| Listed {
                    name: column.name,
                    measure: column.measure,
                    find: Find::OfLength(column.value),
                }));
                for (name, cause, change, below) in LIMITS {
                    list.push(Listed { name, measure: margin::measure(change), find: Find::Margin(change, below) });
                    list.push(word(cause, Find::MarginCause(change, below)));
                }
            }
            Self::Supported => {
                list.push(word("support", Find::Support));
                list.extend(VERDICTS.iter().enumerate().map(|(at, name)| word(name, Find::Verdict(at))));
                list.extend(SupportedState::NUMBERS.iter().map(|item| Listed {
                    name: item.name,
                    measure: item.measure,
                    find: Find::OfSupported(item.value),
                }));
            }
            Self::Stretched => {
                list.push(word("support", Find::Support));
                list.extend(STRETCHED_VERDICTS.iter().enumerate().map(|(at, name)| word(name, Find::Verdict(at))));
                list.extend(ExtensibleState::NUMBERS.iter().map(|item| Listed {
                    name: item.name,
                    measure: item.measure,
                    find: Find::OfStretched(item.value),
                }));
            }
        }
        list
    }
}

impl Find {
    /// What stands in its column.
    pub(crate) const fn kind(self) -> Kind {
        match self {
            Self::Handedness | Self::Strands => Kind::Integer,
            Self::Separated | Self::Fold | Self::ConvexCut => Kind::Boolean,
            Self::Lay | Self::Support | Self::Verdict(_) | Self::Balance | Self::MarginCause(..) => Kind::Text,
            _ => Kind::Float,
        }
    }

    /// The dimensionless number, where it is one and can be written.
    pub(crate) fn number(self, found: Found<'_>, given: &Given) -> Option<f64> {
        written(match (self, found) {
            (Self::OfContact(of), Found::Contact(contact)) => Some(of(contact)),
            (Self::OfTouching(of), Found::Touching(state)) => of(state),
            (Self::OfLength(of), Found::Touching(state)) => of(state, given.strand_length?),
            (Self::OfSupported(of), Found::Supported(state)) => of(state),
            (Self::OfStretched(of), Found::Stretched(state)) => of(state),
            // on the verge of separation a margin ends
            (Self::Margin(change, below), Found::Touching(state)) if !given.parts => {
                Margins::of(state).change(change, below)
            }
            (Self::StiffnessRatio, _) => Some(given.stiffness_ratio),
            _ => None,
        })
    }

    /// The whole number, where it is one.
    pub(crate) fn whole(self, found: Found<'_>, given: &Given) -> Option<i64> {
        match self {
            Self::Strands => Some(i64::from(given.strands)),
            Self::Handedness => found.handedness().map(|hand| if hand == Handedness::Right { 1 } else { -1 }),
            _ => None,
        }
    }

    /// Whether it holds, where that is asked.
    pub(crate) fn holds(self, found: Found<'_>, given: &Given) -> Option<bool> {
        match (self, found) {
            (Self::Separated, Found::Touching(state)) => Some(state.is_separated() && !given.parts),
            (Self::Fold, Found::Touching(state)) => Some(state.is_fold()),
            (Self::ConvexCut, Found::Contact(contact)) => Some(Section::new(contact, Handedness::Right).is_convex()),
            _ => None,
        }
    }

    /// The word, where it is one.
    pub(crate) fn word(self, found: Found<'_>, given: &Given) -> Option<&'static str> {
        match (self, found) {
            (Self::Lay, _) => found.handedness().map(|hand| if hand == Handedness::Right { "Z" } else { "S" }),
            (Self::Support, Found::Supported(state)) => Some(state.support().name()),
            (Self::Support, Found::Stretched(state)) => Some(state.support().name()),
            (Self::Verdict(at), _) => found.verdict(at),
            (Self::Balance, Found::Touching(state)) => Some(state.balance().name()),
            (Self::MarginCause(change, below), Found::Touching(state)) if !given.parts => {
                Margins::of(state).cause(change, below)
            }
            _ => None,
        }
    }
}

impl Found<'_> {
    /// Which way it winds; none of a shape.
    pub(crate) fn handedness(self) -> Option<Handedness> {
        match self {
            Self::Contact(_) => None,
            Self::Touching(state) => Some(state.handedness()),
            Self::Supported(state) => Some(state.handedness()),
            Self::Stretched(state) => Some(state.handedness()),
        }
    }

    fn verdict(self, at: usize) -> Option<&'static str> {
        match self {
            Self::Contact(_) => None,
            Self::Touching(state) if at == 0 => state.stability().map(|_| text::verdict(state)),
            Self::Touching(state) => Verdicts::of(state).named().get(at)?.2.map(Stability::name),
            Self::Supported(state) => (SupportedState::VERDICTS.get(at)?.2)(state).map(Stability::name),
            Self::Stretched(state) => (ExtensibleState::VERDICTS.get(at)?.2)(state).map(Stability::name),
        }
    }

    /// Whether it is stable as its ends are held.
    pub(crate) fn is_stable(self) -> bool {
        matches!(self.verdict(0), Some("stable"))
    }

    /// Where it lies: ±θ and the signed rotation of the ply, both in rad; states near each other are near in both.
    pub(crate) fn place(self) -> [f64; 2] {
        match self {
            Self::Contact(contact) => [contact.helical_angle(), 0.0],
            Self::Touching(state) => [state.handedness().sign() * state.contact().helical_angle(), state.rotation()],
            Self::Supported(state) => [state.handedness().sign() * state.angle().radians(), state.rotation()],
            Self::Stretched(state) => [state.handedness().sign() * state.angle().radians(), state.rotation()],
        }
    }
}

impl Known {
    /// The sizes of a case.
    pub(crate) fn of(case: &Case) -> Self {
        Self { scale: case.scale, strand_radius: case.strand_radius }
    }

    /// The sizes by which any number can be written in units.
    pub(crate) fn sample(scaled: bool, sized: bool) -> Self {
        Self { scale: Scale::new(1.0, 1.0).ok().filter(|_| scaled), strand_radius: sized.then_some(1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_and_verdicts_are_those_of_the_report() {
        let names: Vec<String> =
            LIMITS.iter().flat_map(|(name, cause, ..)| [(*name).to_owned(), (*cause).to_owned()]).collect();
        assert_eq!(names, margin::csv_head(Known::default()));
        let of = |named: Vec<&str>| -> Vec<String> {
            let rest = named[1..].iter().map(|name| format!("stability_{name}"));
            core::iter::once("stability".to_owned()).chain(rest).collect()
        };
        assert_eq!(of(Verdicts::default().named().iter().map(|(name, ..)| *name).collect()), VERDICTS);
        assert_eq!(of(SupportedState::VERDICTS.iter().map(|(name, ..)| *name).collect()), VERDICTS);
        assert_eq!(of(ExtensibleState::VERDICTS.iter().map(|(name, ..)| *name).collect()), STRETCHED_VERDICTS);
    }

    #[test]
    fn names_are_unique() {
        for kind in [StateKind::Contact, StateKind::Touching, StateKind::Supported, StateKind::Stretched] {
            let list = kind.listed();
            for (i, one) in list.iter().enumerate() {
                assert!(list[..i].iter().all(|other| other.name != one.name), "{kind:?} {}", one.name);
            }
        }
    }
}
