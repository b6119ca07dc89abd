//! What changes: the legs of a path, the rectangle of a map.

use crate::key::Group;
use crate::spec::{Entry, Spec};
use crate::{Case, Datum, ErrorKind, Place, SpecError};

impl Spec {
    /// The beginning of a path and the end of each of its legs: `[[path]]` of the file, or `leg` alone where it is given.
    ///
    /// A leg changes what it names; what it does not name stays as it is. A rotation that is held takes the place of the moment, a
    /// length that of the force, and the other way round.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`], and where there is no leg.
    ///
    /// ```
    /// use nply_sheet::{Question, Spec};
    /// let text = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -0.2\n\
    ///     [[path]]\nload.force = 1\n[[path]]\nload.moment = -3\n";
    /// let cases = Spec::from_toml("ply.toml", text)?.check_path(None)?;
    /// let Question::States { load, .. } = cases[2].question else { unreachable!() };
    /// assert_eq!((cases.len(), load.force, load.moment), (3, 1.0, -3.0));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn check_path(&self, leg: Option<&Self>) -> Result<Vec<Case>, SpecError> {
        let legs: Vec<&Self> = match leg {
            Some(leg) => vec![leg],
            None => self.legs.iter().collect(),
        };
        if legs.is_empty() {
            let message = "the path is missing: say where it leads, by --to-force, --to-moment, --to-pretwist and the like, or by \
                           [[path]] in the file";
            return Err(SpecError::new(ErrorKind::Missing, self.head(), message));
        }
        let mut here = self.clone();
        here.legs.clear(); // each leg would carry all of them on
        let mut cases = vec![here.check()?];
        for leg in legs {
            here = here.onward(leg);
            cases.push(here.check()?);
        }
        Ok(cases)
    }

    /// Refuses a flag of which a study's own datum takes the place: one of the two would be dropped without a word. What a file says may be
    /// overridden, a flag not.
    pub(crate) fn keeps_flags_beside(&self, corner: &Self) -> Result<(), SpecError> {
        let kept = self.onward(corner);
        let is_lost = |entry: &&Entry| {
            matches!(entry.place, Place::Flag(_)) && kept.entries.iter().all(|other| other.place != entry.place)
        };
        let Some(lost) = self.entries.iter().find(is_lost) else { return Ok(()) };
        let same = |other: &&Entry| {
            other.key.datum == lost.key.datum || other.key.group.is_some() && other.key.group == lost.key.group
        };
        let Some(varies) = corner.entries.iter().find(same).or(corner.entries.first()) else { return Ok(()) };
        let message = format!(
            "{} is given, and what varies, `{}`, takes its place: leave one of the two out",
            lost.said(),
            varies.key.name
        );
        Err(lost.error(ErrorKind::Contradiction, message))
    }

    /// This description with a corner of a study laid over it.
    pub(crate) fn onward(&self, corner: &Self) -> Self {
        let mut merged = self.overridden_by(corner);
        let named = |datum| corner.get(datum).is_some();
        // of load and displacement, around and along, the one that is named last is given, and the other found
        for (around, found) in [(true, Datum::Moment), (false, Datum::Force)] {
            let holds = |entry: &Entry| entry.key.group == Some(Group::Ends) && entry.turns_ends() == around;
            if corner.entries.iter().any(holds) {
                merged.entries.retain(|entry| entry.key.datum != found || named(found));
            } else if named(found) {
                merged.entries.retain(|entry| !holds(entry));
            }
        }
        merged
    }
}
