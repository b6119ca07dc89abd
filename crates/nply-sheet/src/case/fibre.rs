//! The size of a strand from its titre: linear density, density of the fibre, and how closely the fibres are packed.

use core::f64::consts::PI;

use crate::spec::{Entry, Spec};
use crate::{Datum, ErrorKind, SpecError};

/// r in m, where a titre and a density give it: π r² ρ φ is the mass per length.
pub(super) fn radius(spec: &Spec) -> Result<Option<f64>, SpecError> {
    let Some(titre) = spec.get(Datum::LinearDensity) else {
        return match spec.get(Datum::Density).or_else(|| spec.get(Datum::PackingFraction)) {
            Some(entry) => Err(useless(spec, entry)),
            None => Ok(None),
        };
    };
    let Some(density) = spec.get(Datum::Density) else {
        let message = format!(
            "the density of the fibre is missing, without which {} gives no diameter: give {}, such as \"1.14 g/cm^3\"",
            titre.said(),
            spec.ask_for(Datum::Density),
        );
        return Err(spec.missing(Datum::Density, message));
    };
    if !density.is_measured() {
        let message = format!("{} has no unit: what is wanted is {}", density.said(), density.key.kind.wanted());
        return Err(density.error(ErrorKind::WrongUnit, message));
    }
    let area = titre.positive(titre.number())? / (density.positive(density.number())? * packing(spec)?);
    titre.positive(libm::sqrt(area / PI)).map(Some)
}

/// φ, where the titre gives the size.
pub(super) fn given_packing(spec: &Spec) -> Result<Option<f64>, SpecError> {
    spec.get(Datum::Density).map(|_| packing(spec)).transpose()
}

/// φ, the share of the cross-section that is fibre; 1 where none is given.
pub(super) fn packing(spec: &Spec) -> Result<f64, SpecError> {
    let Some(entry) = spec.get(Datum::PackingFraction) else { return Ok(1.0) };
    let share = entry.number();
    if share > 0.0 && share <= 1.0 {
        return Ok(share);
    }
    let message =
        format!("{}: the share of fibre in a cross-section must be greater than 0 and at most 1", entry.said());
    Err(entry.error(ErrorKind::Domain, message))
}

/// Refuses a density beside a size that is given already; a titre alone may stand there, for loads in cN/tex.
pub(super) fn refuse_beside(spec: &Spec, size: &Entry) -> Result<(), SpecError> {
    let Some(entry) = spec.get(Datum::Density).or_else(|| spec.get(Datum::PackingFraction)) else { return Ok(()) };
    if spec.get(Datum::LinearDensity).is_none() {
        return Err(useless(spec, entry));
    }
    let message = format!(
        "{} and the linear density with {} both give the size of the strand: remove one of them",
        size.said(),
        entry.said(),
    );
    Err(entry.error(ErrorKind::Contradiction, message))
}

fn useless(spec: &Spec, entry: &Entry) -> SpecError {
    let message = format!(
        "{} is of use only with a linear density: remove it, or give {}, such as \"94 tex\"",
        entry.said(),
        spec.ask_for(Datum::LinearDensity),
    );
    entry.error(ErrorKind::Contradiction, message)
}
