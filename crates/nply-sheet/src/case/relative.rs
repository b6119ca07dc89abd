//! Quantities said by another one: energies in kT, forces in cN/tex.

use std::borrow::Cow;

use super::strand;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, Dimension, ErrorKind, Kind, Quantity, SpecError};

impl Kind {
    /// Whether a unit of this dimension is the one wanted once the temperature (kT) or the linear density (cN/tex) is known.
    pub(crate) fn is_relative(self, found: Dimension) -> bool {
        match self {
            Self::Stiffness | Self::Force | Self::Moment | Self::ForcePerLength | Self::Pressure => {
                self.dimension().and_then(|wanted| wanted.times(Dimension::TEMPERATURE, -1)) == Some(found)
                    || (self == Self::Force && found == Dimension::SPECIFIC_STRESS)
            }
            _ => false,
        }
    }
}

/// The dimension of what a datum is said by, if it is said by another quantity.
fn relative(entry: &Entry) -> Option<(f64, Dimension)> {
    match &entry.value {
        Value::Quantity(Quantity::Measured { si, unit }) if entry.key.kind.is_relative(unit.dimension()) => {
            Some((*si, unit.dimension()))
        }
        _ => None,
    }
}

/// Whether any datum is said in kT.
pub(crate) fn any_thermal(spec: &Spec) -> bool {
    spec.entries.iter().filter_map(relative).any(|(_, dimension)| dimension != Dimension::SPECIFIC_STRESS)
}

/// The description with every such quantity in SI.
pub(super) fn resolved(spec: &Spec) -> Result<Cow<'_, Spec>, SpecError> {
    if !spec.entries.iter().any(|entry| relative(entry).is_some()) {
        return Ok(Cow::Borrowed(spec));
    }
    let mut whole = spec.clone();
    for entry in &mut whole.entries {
        let Some((said, dimension)) = relative(entry) else { continue };
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
