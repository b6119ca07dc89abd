//! The lists that reports are made from, as names with their words and units alone: what a schema is made from.

use nply::mechanics::{Change, ExtensibleState, Station, StretchStation, SupportedState};

use super::column::{COLUMNS, LENGTH_COLUMNS};
use super::item::Item;
use super::lays::NamedLay;
use super::support::{Carried, OPENING, WEDGE};
use super::trace::Stop;
use super::{LaysReport, Measure, fit, plying, shape, stiffness, strings, writhe};

/// One number of a report: its name, its words (none: a reader's table leaves it out), its kind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Named {
    pub(crate) name: &'static str,
    pub(crate) label: &'static str,
    pub(crate) measure: Measure,
}

/// One number of a report of layers, under a name that ends in its unit where it is in SI.
#[derive(Clone, Debug)]
pub(crate) struct Sized {
    pub(crate) name: String,
    pub(crate) label: String,
    /// `None`: the unit of what was written
    pub(crate) unit: Option<&'static str>,
    /// whether it stands there only where the input has units
    pub(crate) measured_only: bool,
    /// whether it stands there only where the input has none
    pub(crate) bare_only: bool,
}

/// What the numbers are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Of {
    Touching,
    Supported,
    Stretched,
    Wedge,
    Opening,
    Station,
    StretchStation,
    Contact,
    Single,
    Plied,
    Step,
}

impl Of {
    /// All its numbers, in the order of the report.
    pub(crate) fn numbers(self) -> Vec<Named> {
        match self {
            Self::Touching => {
                let of_state = COLUMNS.iter().map(|column| (column.name, column.label, column.measure));
                let of_length = LENGTH_COLUMNS.iter().map(|column| (column.name, column.label, column.measure));
                of_state.chain(of_length).map(named).collect()
            }
            Self::Supported => of_items(SupportedState::NUMBERS),
            Self::Stretched => of_items(ExtensibleState::NUMBERS),
            Self::Wedge => of_items(WEDGE),
            Self::Opening => of_items(OPENING),
            Self::Station => of_items(<Station as Stop>::NUMBERS),
            Self::StretchStation => of_items(<StretchStation as Stop>::NUMBERS),
            Self::Contact => {
                shape::CONTACT.iter().map(|(name, label, measure, _)| named((name, label, *measure))).collect()
            }
            Self::Single => {
                shape::single().into_iter().map(|(name, label, measure, _)| named((name, label, measure))).collect()
            }
            Self::Plied => of_items(plying::PLIED),
            Self::Step => of_items(strings::STEP),
        }
    }
}

const fn named((name, label, measure): (&'static str, &'static str, Measure)) -> Named {
    Named { name, label, measure }
}

fn of_items<T>(items: &[Item<T>]) -> Vec<Named> {
    items.iter().map(|item| named((item.name, item.label, item.measure))).collect()
}

/// What may be held while a state is disturbed, by name and in words, of strands that keep their length and of those that stretch.
pub(crate) fn holdings(stretched: bool) -> Vec<(&'static str, &'static str)> {
    if stretched {
        return ExtensibleState::VERDICTS.iter().map(|(name, words, _)| (*name, *words)).collect();
    }
    SupportedState::VERDICTS.iter().map(|(name, words, _)| (*name, *words)).collect()
}

/// What kind of number a margin is.
pub(crate) const fn margin(change: Change) -> Measure {
    super::margin::measure(change)
}

/// The distinguished lays of several strands and of one, with what is extreme there.
pub(crate) fn lays() -> Vec<NamedLay> {
    const SOME: u32 = 3;
    [LaysReport::of(SOME), LaysReport::of(1)].iter().flat_map(LaysReport::named).collect()
}

/// Every number of curves: name, words, whether it is a whole number.
pub(crate) fn of_curves() -> Vec<(&'static str, &'static str, bool)> {
    writhe::QUANTITIES.iter().map(|quantity| (quantity.name, quantity.label, quantity.whole)).collect()
}

pub(crate) use fit::listed::{of_layer, of_strand};
pub(crate) use stiffness::listed::{of_cable, of_member};
