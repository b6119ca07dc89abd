//! The helix radius R: a lay where the strand's size is known, and the size where another datum gives the lay.

use core::f64::consts::TAU;

use nply::DomainError;
use nply::geometry::Contact;

use super::{Lay, only_one, strands};
use crate::key::Group;
use crate::spec::{Entry, Spec};
use crate::{Datum, ErrorKind, SpecError};

/// r in m, of touching strands on a helix of given radius: r = R/ρ(θ), and θ from the lay; with a lay length P,
/// tan θ = 2πR/P.
pub(super) fn strand_radius(spec: &Spec) -> Result<Option<f64>, SpecError> {
    let Some(helix) = spec.get(Datum::HelixRadius).filter(|entry| entry.is_measured()) else { return Ok(None) };
    let Some(lay) = only_one(spec, Group::Lay, "the lay of the ply")? else { return Ok(None) };
    let radius = helix.positive(helix.number())?;
    let count = strands(spec, 2)?;
    let given = lay.number();
    let by_pitch = |pitch: f64| Contact::new(count, libm::atan(TAU * radius / pitch));
    let contact = match lay.key.datum {
        Datum::CoreRadius | Datum::CoreDiameter if lay.is_measured() => {
            let core = if lay.key.datum == Datum::CoreDiameter { given / 2.0 } else { given };
            let refused = || {
                let message = format!("{} leaves no strand of {}: it must be smaller", lay.said(), helix.said());
                lay.error(ErrorKind::Domain, message)
            };
            return if core < radius { Ok(Some(radius - core)) } else { Err(refused()) };
        }
        Datum::LayLength if lay.is_measured() => by_pitch(lay.positive(given)?),
        // in rad/m, of either hand; 0 is refused with the lay
        Datum::PlyTurnsPerLength if lay.is_measured() => by_pitch(TAU / given.abs()),
        Datum::HelicalAngle | Datum::LayAngle => Lay::HelicalAngle(given).contact(count),
        Datum::PitchAngle => Lay::PitchAngle(given).contact(count),
        Datum::LayRatio => Lay::LayRatio(given).contact(count),
        Datum::RadiusRatio => return helix.positive(radius / lay.positive(given)?).map(Some),
        _ => return Err(without_units(helix, lay)),
    };
    let refused = |error: DomainError| {
        lay.error(ErrorKind::Domain, format!("{}, and no ply of {count} strands has it: {error}", lay.said()))
    };
    helix.positive(radius / contact.map_err(refused)?.radius_ratio()).map(Some)
}

/// Refuses a helix radius beside a lay where the strand's size, or the absence of any, leaves nothing to be found by it.
pub(super) fn check(spec: &Spec, lay: Option<&Entry>) -> Result<(), SpecError> {
    let (Some(helix), Some(lay)) = (spec.get(Datum::HelixRadius), lay) else { return Ok(()) };
    let sized = spec.entries.iter().any(|entry| entry.key.group == Some(Group::Size))
        || spec.get(Datum::LinearDensity).is_some();
    match (sized, helix.is_measured()) {
        (true, _) => Err(overdetermined(helix, lay)),
        (false, false) => Err(without_units(helix, lay)),
        (false, true) => Ok(()),
    }
}

fn overdetermined(helix: &Entry, lay: &Entry) -> SpecError {
    let message = format!(
        "of {}, {} and the size of the strand two determine the third: remove one of them",
        helix.said(),
        lay.said()
    );
    helix.error(ErrorKind::Contradiction, message)
}

/// Helix radius and lay give the strand's size, which bare numbers have already: they are in strand radii.
fn without_units(helix: &Entry, lay: &Entry) -> SpecError {
    let message = format!(
        "{} and {} give the size of a strand, and bare numbers are in strand radii: write both lengths with a unit, such as \"{} Å\"",
        helix.said(),
        lay.said(),
        crate::preferred::six_digits(if helix.is_measured() { lay.number() } else { helix.number() })
    );
    helix.error(ErrorKind::Contradiction, message)
}
