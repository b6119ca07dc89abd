//! What may carry the strands: a core that they may lie on or lift off from.

use nply::mechanics::Balance;

use super::lay::GivenLay;
use super::measure::Measure;
use super::only_one;
use crate::key::Group;
use crate::spec::{Entry, Value};
use crate::{Datum, ErrorKind, SpecError};

/// Supports are asked for; with the core's radius over r where there is one.
#[derive(Clone, Copy)]
pub(super) struct GivenSupport<'s> {
    pub(super) core_radius: Option<f64>,
    entry: Option<&'s Entry>,
}

/// The supports, if they are `asked` for or a core is given.
pub(super) fn of<'s>(measure: &Measure<'s>, asked: bool) -> Result<Option<GivenSupport<'s>>, SpecError> {
    let Some(entry) = only_one(measure.spec, Group::Support, "the size of the core")? else {
        return Ok(asked.then_some(GivenSupport { core_radius: None, entry: None }));
    };
    let size = entry.positive(measure.dimensionless(entry)?)?;
    let radius = if entry.key.datum == Datum::SupportCoreDiameter { size / 2.0 } else { size };
    Ok(Some(GivenSupport { core_radius: Some(entry.positive(radius)?), entry: Some(entry) }))
}

impl GivenSupport<'_> {
    /// What cannot be given beside it.
    pub(super) fn check(self, measure: &Measure<'_>, lay: Option<GivenLay<'_>>) -> Result<(), SpecError> {
        let contradicts = |entry: &Entry, message: String| Err(entry.error(ErrorKind::Contradiction, message));
        let remove = match self.entry {
            _ if measure.spec.stretches() => {
                format!("remove it, or remove {}, which asks for that", measure.spec.call(Datum::Stretch))
            }
            Some(own) => format!("remove it, or remove {} in [support]", own.said()),
            None => "remove it, or ask `nply solve`".to_owned(),
        };
        if let Some(GivenLay { entry, .. }) = lay {
            let message = format!(
                "the lay {} says what shape the ply has, but what carries the strands is asked, and the shape follows from that: {remove}",
                entry.said()
            );
            return contradicts(entry, message);
        }
        if let Some(entry) = measure.spec.get(Datum::Balance)
            && entry.value == Value::Balance(Balance::Radial)
        {
            let message = format!(
                "{} says that a core carries the strands, but what carries them is asked here, and each state has the balance that goes with it: {remove}",
                entry.said()
            );
            return contradicts(entry, message);
        }
        if let Some(entry) = measure.spec.get(Datum::ExternalPressure) {
            let message = format!("{} cannot be taken into account where strands may lift off: {remove}", entry.said());
            return contradicts(entry, message);
        }
        if let Some(entry) = measure.spec.get(Datum::Separation)
            && entry.value == Value::Switch(true)
        {
            let message = format!(
                "{} is answered already where supports are asked: the loads at which the ply opens stand below the states; {remove}",
                entry.said()
            );
            return contradicts(entry, message);
        }
        Ok(())
    }
}
