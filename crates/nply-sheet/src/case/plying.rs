//! What a spinner asks: a ply let go, of singles with a given twist, of a wanted lay, or of both.

use nply::mechanics::Load;

use super::{Case, Question};
use crate::spec::{Entry, Spec};
use crate::{Datum, ErrorKind, SpecError, Table};

impl Case {
    /// As [`Case::of`], with no loads; where twist and lay are both given, the moment that holds them is asked for.
    pub(crate) fn of_plying(spec: &Spec) -> Result<Self, SpecError> {
        super::stretch::refuse(spec, "plies that are spun")?;
        let tables = [Table::Load, Table::Ends, Table::Support];
        if let Some(entry) = spec.entries.iter().find(|entry| tables.contains(&entry.key.table)) {
            let message = format!("{}: a ply that is spun is let go and bears no load: remove it", entry.said());
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        if let Some(entry) = spec.get(Datum::StrandTwist) {
            let message = format!(
                "{} is the twist of a strand in the ply; here that before plying is wanted: give {}",
                entry.said(),
                spec.ask_for(Datum::TurnsPerLength)
            );
            return Err(entry.error(ErrorKind::Contradiction, message));
        }
        let both = spec.first_of(Table::Twist).is_some() && super::lay::is_given(spec);
        let case = if both {
            let free = Spec::from_flags([("force", "0")])?;
            Self::of(&spec.overridden_by(&free), false)?
        } else {
            Self::of(spec, false)?
        };
        match case.question {
            Question::MomentAt { lay: _, hand: None, .. } | Question::PretwistAt { lay: _, hand: None, .. } => {
                let message = format!(
                    "which way the ply winds is missing: give {}, \"S\" or \"Z\", or turns per length with that letter",
                    spec.ask_for(Datum::Hand)
                );
                Err(spec.missing(Datum::Hand, message))
            }
            Question::States { load: Load { force: 0.0, moment: 0.0 }, .. }
            | Question::MomentAt { .. }
            | Question::PretwistAt { .. } => Ok(case),
            _ => Err(case.refuse(|_: &Entry| true, |said| format!("{said} leaves no question of a ply let go"))),
        }
    }
}
