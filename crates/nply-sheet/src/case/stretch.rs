//! Strands that stretch: what they and their core are made of, and the lay in which they were put together.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{ExtensiblePly, FormedLay, StretchingStrand, WorkingCore};
use nply::{DomainError, Handedness};

use super::measure::Measure;
use super::only_one;
use super::support::GivenSupport;
use crate::key::Group;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, SpecError, Table};

/// What only strands that stretch have.
fn is_of_stretch(entry: &Entry) -> bool {
    entry.key.table == Table::Formed
        || matches!(
            entry.key.datum,
            Datum::AxialStiffness
                | Datum::ThinningRatio
                | Datum::SupportCoreYoungsModulus
                | Datum::SupportCorePoissonsRatio
                | Datum::SupportCoreAxialStiffness
                | Datum::SupportCoreTorsionalStiffness
        )
}

/// Refuses what only strands that stretch have.
pub(super) fn none(spec: &Spec) -> Result<(), SpecError> {
    let Some(entry) = spec.entries.iter().find(|entry| is_of_stretch(entry)) else { return Ok(()) };
    let message = format!(
        "{} counts only where strands stretch: give {} as true, or remove it",
        entry.said(),
        spec.ask_for(Datum::Stretch)
    );
    Err(entry.error(ErrorKind::Contradiction, message))
}

/// Refuses strands that stretch, and what only they have, where a question knows none.
pub(super) fn refuse(spec: &Spec, whose: &str) -> Result<(), SpecError> {
    if let (true, Some(entry)) = (spec.stretches(), spec.get(Datum::Stretch)) {
        let message = format!(
            "{}: {whose} do not stretch here; `nply support` and `nply trace` know strands that do: remove it",
            entry.said()
        );
        return Err(entry.error(ErrorKind::Contradiction, message));
    }
    let Some(entry) = spec.entries.iter().find(|entry| is_of_stretch(entry)) else { return Ok(()) };
    let message = format!(
        "{} counts only where strands stretch, and {whose} do not stretch here; `nply support` and `nply trace` know strands that do, with {}: \
         remove it",
        entry.said(),
        spec.ask_for(Datum::Stretch)
    );
    Err(entry.error(ErrorKind::Contradiction, message))
}

/// A ply of strands that stretch.
pub(super) fn of(
    measure: &Measure<'_>,
    strands: u32,
    stiffness_ratio: f64,
    support: Option<GivenSupport<'_>>,
) -> Result<ExtensiblePly, SpecError> {
    let spec = measure.spec;
    let (nu, nu_entry) = thinning(spec)?;
    let (alpha, entry) = axial(measure)?;
    let head = |refused: DomainError| SpecError::new(ErrorKind::Domain, spec.head(), refused.to_string());
    // stiffer, strains are lost in rounding, and loads that follow from them with it
    const STIFFEST: f64 = 1e8;
    if alpha > STIFFEST {
        let message = format!(
            "{} makes EA r^2/B = {alpha:e}, against which a strain is rounding: at most {STIFFEST:e} is taken (a solid round strand has 4); strands \
             that hardly stretch are those without `stretch`",
            entry.said()
        );
        return Err(entry.error(ErrorKind::Domain, message));
    }
    let strand = StretchingStrand::new(stiffness_ratio, alpha, nu).map_err(|refused| match refused.quantity {
        "poissons_ratio" => ratio_refused(nu_entry.unwrap_or(entry)),
        _ => entry.error(ErrorKind::Domain, format!("{}: {refused}", entry.said())),
    })?;
    let mut ply = ExtensiblePly::new(strands, strand).map_err(head)?;
    let core_radius = support.and_then(|support| support.core_radius);
    let lay = formed(measure, strands, core_radius)?;
    if let Some(radius) = core_radius {
        let core = core(measure, radius, nu)?;
        if lay.is_none() && core.axial_stiffness() > 0.0 {
            let message = format!(
                "a core that works along is free of stress in the lay in which the ply was made, and that is missing: give {} or {}",
                spec.ask_for(Datum::FormedLayLength),
                spec.call(Datum::FormedHelicalAngle)
            );
            return Err(spec.missing(Datum::FormedLayLength, message));
        }
        ply = ply.with_core(core).map_err(head)?;
    } else if let Some(entry) =
        spec.entries.iter().find(|entry| entry.key.table == Table::Support && is_of_stretch(entry))
    {
        let message = format!(
            "{} says what a core is made of, but not how thick it is: give {} or {}",
            entry.said(),
            spec.ask_for(Datum::SupportCoreDiameter),
            spec.call(Datum::SupportCoreRadius)
        );
        return Err(spec.missing(Datum::SupportCoreDiameter, message));
    }
    let Some((lay, entry)) = lay else { return Ok(ply) };
    ply.formed_in(lay).map_err(|refused| refuse_lay(spec, entry, &refused, lay))
}

/// ν by which strands thin, and the datum that gives it.
pub(super) fn thinning(spec: &Spec) -> Result<(f64, Option<&Entry>), SpecError> {
    match (spec.get(Datum::PoissonsRatio), spec.get(Datum::ThinningRatio)) {
        (Some(one), Some(other)) => {
            let message = format!("{} and {} both say how strands thin: remove one of them", one.said(), other.said());
            Err(other.error(ErrorKind::Contradiction, message))
        }
        (Some(entry), None) | (None, Some(entry)) => Ok((entry.number(), Some(entry))),
        (None, None) => Ok((0.0, None)),
    }
}

fn ratio_refused(entry: &Entry) -> SpecError {
    let message = format!("{}: Poisson's ratio must be greater than -1 and at most 0.5", entry.said());
    entry.error(ErrorKind::Domain, message)
}

/// α = EA r²/B, and the datum that gives it.
pub(super) fn axial<'s>(measure: &Measure<'s>) -> Result<(f64, &'s Entry), SpecError> {
    // EA r²/B of a solid round strand: π r⁴ over π r⁴/4
    const SOLID: f64 = 4.0;
    let spec = measure.spec;
    match (spec.get(Datum::AxialStiffness), spec.get(Datum::YoungsModulus)) {
        (Some(entry), Some(other)) => {
            let message = format!(
                "{} is that of a solid round strand, from which EA follows, so that {} is too much: remove one of them",
                other.said(),
                entry.said()
            );
            Err(entry.error(ErrorKind::Contradiction, message))
        }
        (Some(entry), None) => Ok((entry.positive(measure.dimensionless(entry)?)?, entry)),
        (None, Some(entry)) => Ok((SOLID, entry)),
        (None, None) => {
            let message = format!(
                "the strand's stiffness against stretch is missing: give {}, or {} of a solid round strand; without stretch remove {}",
                spec.ask_for(Datum::AxialStiffness),
                spec.call(Datum::YoungsModulus),
                spec.call(Datum::Stretch)
            );
            Err(spec.missing(Datum::AxialStiffness, message))
        }
    }
}

/// The core, `radius` being its radius over r and `nu` the strands' ratio.
fn core(measure: &Measure<'_>, radius: f64, nu: f64) -> Result<WorkingCore, SpecError> {
    let spec = measure.spec;
    let ratio = spec.get(Datum::SupportCorePoissonsRatio);
    let nu = match ratio.map(|entry| (entry, entry.number())) {
        Some((entry, nu)) if !(nu > -1.0 && nu <= 0.5) => return Err(ratio_refused(entry)),
        Some((_, nu)) => nu,
        None => nu,
    };
    let torsional = spec.get(Datum::SupportCoreTorsionalStiffness);
    let axial = only_one(spec, Group::CoreAxial, "the core's stiffness against stretch")?;
    let (ea, gj, entry) = match axial {
        None => match torsional.or(ratio) {
            None => (0.0, 0.0, None),
            Some(entry) => {
                let message = format!(
                    "{} goes with a core that works along, whose stiffness is missing: give {} or {}",
                    entry.said(),
                    spec.ask_for(Datum::SupportCoreYoungsModulus),
                    spec.call(Datum::SupportCoreAxialStiffness)
                );
                return Err(spec.missing(Datum::SupportCoreYoungsModulus, message));
            }
        },
        Some(entry) if entry.key.datum == Datum::SupportCoreYoungsModulus => {
            if let Some(torsional) = torsional {
                let message = format!(
                    "{} is that of a solid round core, from which GJ follows, so that {} is too much: remove one of them",
                    entry.said(),
                    torsional.said()
                );
                return Err(torsional.error(ErrorKind::Contradiction, message));
            }
            let Some(scale) = measure.scale else { return Err(measure.no_measure(entry)) };
            let (r, modulus) = (scale.strand_radius(), entry.positive(entry.number())?);
            // E in B/r⁴
            let modulus = modulus * (r * r) / scale.force(1.0);
            let area = PI * radius * radius;
            let polar = 0.5 * area * radius * radius;
            (modulus * area, modulus / (2.0 * (1.0 + nu)) * polar, Some(entry))
        }
        Some(entry) => {
            let gj = match (torsional, measure.scale) {
                (None, _) => 0.0,
                (Some(entry), Some(scale)) => entry.positive(entry.number())? / scale.stiffness(1.0),
                (Some(entry), None) => return Err(measure.no_measure(entry)),
            };
            (entry.positive(measure.dimensionless(entry)?)?, gj, Some(entry))
        }
    };
    WorkingCore::new(radius, ea, gj, nu).map_err(|refused| {
        let message = |said: &str| format!("{said} cannot be calculated with: {refused}");
        match entry {
            Some(entry) => entry.error(ErrorKind::Domain, message(&entry.said())),
            None => SpecError::new(ErrorKind::Domain, spec.head(), message("the core")),
        }
    })
}

/// The lay in which the ply was made, and the datum that gives it.
fn formed<'s>(
    measure: &Measure<'s>,
    strands: u32,
    core_radius: Option<f64>,
) -> Result<Option<(FormedLay, &'s Entry)>, SpecError> {
    let spec = measure.spec;
    let Some(entry) = only_one(spec, Group::Formed, "the lay in which the ply was made")? else {
        return match spec.first_of(Table::Formed) {
            None => Ok(None),
            Some(entry) => {
                let message = format!(
                    "{} belongs to the lay in which the ply was made, and that is missing: give {} or {}",
                    entry.said(),
                    spec.ask_for(Datum::FormedLayLength),
                    spec.call(Datum::FormedHelicalAngle)
                );
                Err(spec.missing(Datum::FormedLayLength, message))
            }
        };
    };
    let refuse = |why: &str| Err(entry.error(ErrorKind::Domain, format!("{}: {why}", entry.said())));
    let given_radius = match spec.get(Datum::FormedRadiusRatio) {
        Some(entry) => Some(entry.positive(entry.number())?),
        None => None,
    };
    let on_core = core_radius.map(|radius| 1.0 + radius);
    let touching = |angle: HelicalAngle| Contact::at_angle(strands, angle).map(|contact| contact.radius_ratio());
    let (angle, radius) = if entry.key.datum == Datum::FormedHelicalAngle {
        let given = entry.number();
        if !(given > 0.0 && given < FRAC_PI_2) {
            return refuse("a lay in which a ply was made has an angle greater than 0 and less than 90 degrees");
        }
        let both = HelicalAngle::new(given).and_then(|angle| Ok((angle, touching(angle)?)));
        match both {
            Ok((angle, least)) => (angle, given_radius.unwrap_or_else(|| on_core.unwrap_or(least).max(least))),
            Err(_) => return refuse("it cannot be calculated with"),
        }
    } else {
        let length = entry.positive(measure.dimensionless(entry)?)?;
        let at = |radius: f64| HelicalAngle::new(libm::atan(TAU * radius / length)).map(|angle| (angle, radius));
        let lies = |radius: f64| {
            let (angle, radius) = at(radius).ok()?;
            touching(angle).is_ok_and(|least| least <= radius).then_some((angle, radius))
        };
        match (given_radius, on_core.and_then(lies)) {
            (Some(radius), _) => at(radius),
            (None, Some(lay)) => Ok(lay),
            (None, None) => Contact::from_lay_length(strands, length).map(|c| (c.angle(), c.radius_ratio())),
        }
        .map_err(|refused| {
            let message = format!(
                "{} is {} strand radii, and touching strands have no such lay: it must be {}",
                entry.said(),
                refused.value,
                refused.allowed
            );
            entry.error(ErrorKind::Domain, message)
        })?
    };
    let handedness = match spec.get(Datum::FormedHand) {
        Some(Entry { value: Value::Hand(hand), .. }) => *hand,
        _ => Handedness::Right,
    };
    let preforming = match spec.get(Datum::Preforming) {
        None => 0.0,
        Some(entry) if !(0.0..=1.0).contains(&entry.number()) => {
            let message = format!(
                "{}: strands are bent beforehand between 0 (left straight) and 1 (wholly, free of stress in the lay)",
                entry.said()
            );
            return Err(entry.error(ErrorKind::Domain, message));
        }
        Some(entry) => entry.number(),
    };
    Ok(Some((FormedLay { handedness, angle, radius_ratio: radius, preforming }, entry)))
}

/// A lay in which strands would overlap.
fn refuse_lay(spec: &Spec, entry: &Entry, refused: &DomainError, lay: FormedLay) -> SpecError {
    let entry = spec.get(Datum::FormedRadiusRatio).unwrap_or(entry);
    let message = format!(
        "{}: in this lay, {:.3} degrees at R/r = {:.4}, the strands would overlap; R/r must be {}",
        entry.said(),
        lay.angle.degrees(),
        lay.radius_ratio,
        refused.allowed
    );
    entry.error(ErrorKind::Domain, message)
}
