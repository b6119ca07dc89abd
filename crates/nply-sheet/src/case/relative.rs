//! Quantities said by another one: energies in kT, forces in cN/tex.

use std::borrow::Cow;

use super::strand;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, Dimension, ErrorKind, Quantity, SpecError};

/// The description with every such quantity in SI.
pub(super) fn resolved(spec: &Spec) -> Result<Cow<'_, Spec>, SpecError> {
    if !spec.entries.iter().any(|entry| entry.relative().is_some()) {
        return Ok(Cow::Borrowed(spec));
    }
    let mut whole = spec.clone();
    for entry in &mut whole.entries {
        let Some((said, dimension)) = entry.relative() else { continue };
        let factor =
            if dimension == Dimension::SPECIFIC_STRESS { titre(spec, entry)? } else { temperature(spec, entry)? };
        let value = entry.finite(said * factor)?;
        if let Value::Quantity(Quantity::Measured { si, .. }) = &mut entry.value {
            *si = value;
        }
    }
    Ok(Cow::Owned(whole))
}

/// T in K; Boltzmann's constant is in the unit.
fn temperature(spec: &Spec, asks: &Entry) -> Result<f64, SpecError> {
    let Some(entry) = spec.get(Datum::Temperature) else {
        let message = format!(
            "the temperature is missing, without which {} is no energy: give {}, such as \"298 K\"",
            asks.said(),
            spec.ask_for(Datum::Temperature),
        );
        return Err(spec.missing(Datum::Temperature, message));
    };
    strand::absolute(entry)
}

/// Mass per length of all strands, in kg/m: a force on the ply in cN/tex is shared by all of them.
fn titre(spec: &Spec, asks: &Entry) -> Result<f64, SpecError> {
    let Some(entry) = spec.get(Datum::LinearDensity) else {
        let message = format!(
            "the linear density of a strand is missing, without which {} is no force: give {}, such as \"94 tex\"",
            asks.said(),
            spec.ask_for(Datum::LinearDensity),
        );
        return Err(spec.missing(Datum::LinearDensity, message));
    };
    let all = f64::from(super::strands(spec, 1)?) * entry.positive(entry.number())?;
    if all.is_finite() {
        return Ok(all);
    }
    Err(asks.error(ErrorKind::Domain, format!("{} is too large to be calculated with", entry.said())))
}
