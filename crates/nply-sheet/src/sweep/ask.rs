//! What is asked of every state, by name and unit.

use super::Question;
use crate::key::{Group, nearest};
use crate::report::{Find, Known, Listed, Measure, StateKind, unit_suffix};
use crate::spec::Spec;
use crate::spec::sweep::{refused_at, unit_of};
use crate::table::Column;
use crate::{Datum, ErrorKind, Key, Place, SpecError, Unit, quoted};

/// One column of answers.
#[derive(Clone, Debug)]
pub(super) struct Output {
    name: &'static str,
    pub(super) column: Column,
    pub(super) measure: Measure,
    pub(super) find: Find,
    unit: InUnit,
}

/// What its numbers are written in.
#[derive(Clone, Debug)]
enum InUnit {
    Dimensionless,
    Si,
    Of(Unit),
}

impl Output {
    /// Its name without a unit of its own.
    pub(super) const fn name(&self) -> &'static str {
        self.name
    }

    /// The factor from the dimensionless number; none where the sizes it takes are not known.
    pub(super) fn factor(&self, known: Known) -> Option<f64> {
        match &self.unit {
            InUnit::Dimensionless => Some(1.0),
            InUnit::Si => self.measure.si(known).map(|(factor, _)| factor),
            InUnit::Of(unit) => self.measure.factor(known, unit),
        }
    }

    fn new(listed: Listed, unit: InUnit) -> Self {
        let Listed { name, measure, find } = listed;
        let kind = find.kind();
        let column = match &unit {
            InUnit::Dimensionless => match measure {
                Measure::Degrees => Column::new(name, kind).with_unit("deg"),
                Measure::Percent => Column::new(name, kind).with_unit("%"),
                Measure::Turns => Column::new(name, kind).with_unit("turns"),
                _ => Column::new(name, kind),
            },
            InUnit::Si => {
                let unit = measure.si(Known::sample(true, true)).map_or("", |(_, unit)| unit);
                Column::new(format!("{name}_{}", unit_suffix(unit)), kind).with_unit(unit)
            }
            InUnit::Of(unit) => {
                Column::new(format!("{name}_{}", unit_suffix(unit.as_str())), kind).with_unit(unit.as_str())
            }
        };
        Self { name, column, measure, find, unit }
    }
}

/// A name without the unit that some have always.
fn bare(name: &str) -> &str {
    name.trim_end_matches("_deg").trim_end_matches("_percent")
}

/// The output of a name, among those of a kind of state.
fn find(list: &[Listed], written: &str) -> Option<Output> {
    let written = written.trim().replace('-', "_");
    if let Some(listed) =
        list.iter().find(|one| one.name == written).or_else(|| list.iter().find(|one| bare(one.name) == written))
    {
        return Some(Output::new(*listed, InUnit::Dimensionless));
    }
    list.iter().find_map(|listed| {
        let suffix = written.strip_prefix(listed.name)?.strip_prefix('_')?;
        let (_, si) = listed.measure.si(Known::sample(true, true))?;
        if unit_suffix(si) == suffix {
            return Some(Output::new(*listed, InUnit::Si));
        }
        let unit = unit_of(suffix)?;
        (listed.measure.dimension() == Some(unit.dimension())).then(|| Output::new(*listed, InUnit::Of(unit)))
    })
}

/// What the ply is measured by, and how its shape is given: from the description and from what varies.
pub(super) struct Base<'s> {
    pub(super) spec: &'s Spec,
    pub(super) keys: &'s [&'static Key],
}

impl Base<'_> {
    fn every(&self) -> impl Iterator<Item = &'static Key> {
        self.spec.entries.iter().map(|entry| entry.key).chain(self.keys.iter().copied())
    }

    fn has(&self, group: Group) -> bool {
        self.every().any(|key| key.group == Some(group))
    }

    fn gives_lay(&self) -> bool {
        self.has(Group::Lay) || self.every().any(|key| key.datum == Datum::HelixRadius)
    }

    /// Whether r is known, as far as can be told without a row.
    fn is_sized(&self) -> bool {
        let titre = || self.every().any(|key| key.datum == Datum::LinearDensity);
        let helix = || self.every().any(|key| key.datum == Datum::HelixRadius) && self.has(Group::Lay);
        self.has(Group::Size) || titre() || helix()
    }

    fn is_scaled(&self) -> bool {
        self.is_sized() && self.has(Group::Bending)
    }

    /// What sort of state is looked for.
    pub(super) fn kind(&self, question: Option<Question>, outputs: Option<&[(String, Place)]>) -> StateKind {
        if self.spec.stretches() && question != Some(Question::Contact) {
            return StateKind::Stretched;
        }
        match question {
            Some(Question::Contact) => return StateKind::Contact,
            Some(Question::States) if !self.has(Group::Support) => return StateKind::Touching,
            Some(Question::States | Question::Supports) => return StateKind::Supported,
            None => {}
        }
        let all = |kind: StateKind| {
            let list = kind.listed();
            outputs.is_some_and(|names| names.iter().all(|(name, _)| find(&list, name).is_some()))
        };
        if self.has(Group::Support) {
            StateKind::Supported
        } else if self.gives_lay() {
            let shape = match outputs {
                Some(_) => all(StateKind::Contact),
                None => !self.has(Group::Torsion),
            };
            if shape { StateKind::Contact } else { StateKind::Touching }
        } else if !all(StateKind::Touching) && all(StateKind::Supported) {
            StateKind::Supported
        } else {
            StateKind::Touching
        }
    }

    /// The outputs asked, or what is told of such a state if nobody asks.
    pub(super) fn outputs(&self, kind: StateKind, asked: Option<&[(String, Place)]>) -> Result<Vec<Output>, SpecError> {
        let list = kind.listed();
        let Some(asked) = asked else { return Ok(self.usual(kind, &list)) };
        let mut outputs: Vec<Output> = Vec::new();
        for (name, place) in asked {
            let Some(output) = find(&list, name) else { return Err(self.unknown(kind, &list, name, place)) };
            let missing = match output.unit {
                InUnit::Dimensionless => false,
                _ => output.measure.si(Known::sample(self.is_scaled(), self.is_sized())).is_none(),
            };
            if missing {
                let message = format!(
                    "{} has a unit, but the strand has none to measure it by: give its size (and its stiffness), or ask without unit",
                    quoted(name)
                );
                return Err(refused_at(ErrorKind::Missing, place, message));
            }
            if !outputs.iter().any(|other| other.column.name == output.column.name) {
                outputs.push(output);
            }
        }
        if outputs.is_empty() {
            let place = asked.first().map_or_else(|| self.spec.head(), |(_, place)| place.clone());
            return Err(refused_at(
                ErrorKind::Missing,
                &place,
                "nothing is asked: name an output, such as helical_angle",
            ));
        }
        Ok(outputs)
    }

    fn usual(&self, kind: StateKind, list: &[Listed]) -> Vec<Output> {
        const CONTACT: &[&str] = &[
            "helical_angle_deg",
            "lay_length",
            "radius_ratio",
            "outer_diameter",
            "hole_radius",
            "contact_line_radius",
            "arclength_shift",
        ];
        const TOUCHING: &[&str] = &[
            "handedness",
            "separated",
            "stability",
            "helical_angle_deg",
            "lay_length",
            "radius_ratio",
            "extension",
            "pretwist",
            "force",
            "moment",
            "resultant_pressure",
            "interstrand_pressure",
            "total_energy",
        ];
        const SUPPORTED: &[&str] = &[
            "handedness",
            "support",
            "stability",
            "helical_angle_deg",
            "lay_length",
            "radius_ratio",
            "extension",
            "force",
            "moment",
            "interstrand_pressure",
            "core_pressure",
            "total_energy",
        ];
        const STRETCHED: &[&str] = &[
            "handedness",
            "support",
            "stability",
            "helical_angle_deg",
            "lay_length",
            "radius_ratio",
            "extension",
            "strain",
            "force",
            "moment",
            "interstrand_pressure",
            "core_pressure",
            "axial_stiffness",
        ];
        let names = match kind {
            StateKind::Contact => CONTACT,
            StateKind::Touching => TOUCHING,
            StateKind::Supported => SUPPORTED,
            StateKind::Stretched => STRETCHED,
        };
        let known = Known::sample(self.is_scaled(), self.is_sized());
        let named = |name: &&str| list.iter().find(|listed| listed.name == *name);
        names
            .iter()
            .filter_map(named)
            .map(|listed| {
                // with a unit, where there is one
                let unit = if listed.measure.si(known).is_some() { InUnit::Si } else { InUnit::Dimensionless };
                Output::new(*listed, unit)
            })
            .collect()
    }

    fn unknown(&self, kind: StateKind, list: &[Listed], name: &str, place: &Place) -> SpecError {
        let of = match kind {
            StateKind::Contact => "the shape of a lay",
            StateKind::Touching => "a state of touching strands",
            StateKind::Supported => "a state on its supports",
            StateKind::Stretched => "a state of strands that stretch",
        };
        let others =
            [StateKind::Touching, StateKind::Supported, StateKind::Contact].into_iter().filter(|other| *other != kind);
        let elsewhere = others.filter(|other| find(&other.listed(), name).is_some()).map(|other| match other {
            StateKind::Contact => "`question = \"contact\"` has it",
            StateKind::Touching => "`question = \"states\"` has it",
            _ => "`question = \"supports\"` has it",
        });
        let near = || {
            let written = name.trim().replace('-', "_");
            nearest(&written, list.iter().map(|listed| bare(listed.name))).map(|name| format!("did you mean `{name}`?"))
        };
        let help = elsewhere.map(str::to_owned).next().or_else(near).or_else(|| {
            Some("the names are those of `nply solve --format csv`, with a unit behind them if you like".to_owned())
        });
        refused_at(ErrorKind::UnknownKey, place, format!("{} is nothing that is known of {of}", quoted(name)))
            .with_help(help)
    }
}
