//! The strand's size and stiffnesses, from whichever data give them.

use core::f64::consts::PI;

use nply::Scale;

use super::measure::Measure;
use super::{fibre, helix, only_one};
use crate::key::Group;
use crate::spec::{Entry, Spec};
use crate::{Datum, ErrorKind, SpecError};

/// Boltzmann's constant in J/K, exact by definition of the kelvin.
const BOLTZMANN: f64 = 1.380_649e-23;

/// r, B and γ, as far as they are given.
pub(super) struct Strand {
    /// r in m.
    pub(super) radius: Option<f64>,
    /// r and B.
    pub(super) scale: Option<Scale>,
    /// γ = C/B.
    pub(super) stiffness_ratio: f64,
}

impl Strand {
    pub(super) fn of(spec: &Spec) -> Result<Self, SpecError> {
        let radius = radius(spec)?;
        let bending_entry = only_one(spec, Group::Bending, "the bending stiffness of the strand")?;
        let torsion_entry = only_one(spec, Group::Torsion, "the torsional stiffness of the strand")?;
        if let (Some(temperature), false) = (spec.get(Datum::Temperature), any_persistence(spec) || spec.is_thermal()) {
            let message = format!(
                "a temperature is of use only with persistence lengths and kT: remove it, or give {}",
                spec.call(Datum::BendingPersistenceLength)
            );
            return Err(temperature.error(ErrorKind::Contradiction, message));
        }
        let bending = match bending_entry {
            Some(entry) => {
                let Some(radius) = radius else {
                    let message = format!(
                        "the strand radius is missing, without which {} has no scale: give {} or {}",
                        entry.said(),
                        spec.ask_for(Datum::Radius),
                        spec.call(Datum::Diameter),
                    );
                    return Err(spec.missing(Datum::Radius, message));
                };
                Some(bending_stiffness(spec, entry, radius)?)
            }
            None => None,
        };
        let Some(torsion_entry) = torsion_entry else { return Err(torsion_missing(spec, bending_entry)) };
        let stiffness_ratio = stiffness_ratio(spec, torsion_entry, radius, bending)?;
        let scale = match (radius, bending, bending_entry) {
            (Some(radius), Some(bending), Some(entry)) => {
                let scale = Scale::new(radius, bending).map_err(|refused| {
                    entry.error(ErrorKind::Domain, format!("{} cannot be calculated with: {refused}", entry.said()))
                })?;
                if !measures(scale) {
                    let message = format!(
                        "{} makes a bending stiffness of {bending:e} N m^2, and with a strand radius of {radius:e} m loads and stresses would \
                         be no numbers: both are far from those of any strand",
                        entry.said()
                    );
                    return Err(entry.error(ErrorKind::Domain, message));
                }
                Some(scale)
            }
            _ => None,
        };
        Ok(Self { radius, scale, stiffness_ratio })
    }

    pub(super) fn measure<'s>(&self, spec: &'s Spec) -> Measure<'s> {
        Measure { spec, radius: self.radius, scale: self.scale }
    }
}

fn any_persistence(spec: &Spec) -> bool {
    spec.get(Datum::BendingPersistenceLength).is_some() || spec.get(Datum::TwistPersistenceLength).is_some()
}

/// Radii in m whose powers, and the loads that are measured by them, stay numbers.
const RADII: core::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// r in m, if it is given.
pub(super) fn radius(spec: &Spec) -> Result<Option<f64>, SpecError> {
    let Some(radius) = given_radius(spec)? else { return Ok(None) };
    if RADII.contains(&radius) {
        return Ok(Some(radius));
    }
    let of_size = |entry: &&Entry| {
        entry.key.group == Some(Group::Size) || [Datum::LinearDensity, Datum::HelixRadius].contains(&entry.key.datum)
    };
    let message = |said: &str| {
        let [least, most] = [RADII.start(), RADII.end()];
        format!(
            "{said} makes a strand radius of {radius:e} m, and one of {least:e} m to {most:e} m can be calculated with"
        )
    };
    Err(match spec.entries.iter().find(of_size) {
        Some(entry) => entry.error(ErrorKind::Domain, message(&entry.said())),
        None => SpecError::new(ErrorKind::Domain, spec.head(), message("the size that is given")),
    })
}

/// Whether what B and r measure stays a number: forces, moments, forces per length, stresses and angles per load of ordinary plies.
fn measures(scale: Scale) -> bool {
    const SIZES: core::ops::RangeInclusive<f64> = 1e-250..=1e250;
    let stress = scale.force_per_length(1.0) / scale.strand_radius();
    [scale.stiffness(1.0), scale.force(1.0), scale.moment(1.0), scale.force_per_length(1.0), stress]
        .iter()
        .all(|unit| SIZES.contains(unit))
}

fn given_radius(spec: &Spec) -> Result<Option<f64>, SpecError> {
    let Some(entry) = only_one(spec, Group::Size, "the size of the strand")? else {
        return fibre::radius(spec)?.map_or_else(|| helix::strand_radius(spec), |radius| Ok(Some(radius)));
    };
    fibre::refuse_beside(spec, entry)?;
    if !entry.is_measured() {
        let message = format!(
            "{} has no unit: write it as in \"0.5 mm\", or remove it where all is dimensionless (lengths are in strand radii then)",
            entry.said()
        );
        return Err(entry.error(ErrorKind::WrongUnit, message));
    }
    let given = entry.positive(entry.number())?;
    entry.positive(if entry.key.datum == Datum::Diameter { given / 2.0 } else { given }).map(Some)
}

/// kT in J.
fn thermal_energy(spec: &Spec, asks: &Entry) -> Result<f64, SpecError> {
    let Some(entry) = spec.get(Datum::Temperature) else {
        let message = format!(
            "the temperature is missing, without which {} gives no stiffness: give {}, such as \"298 K\"",
            asks.said(),
            spec.ask_for(Datum::Temperature),
        );
        return Err(spec.missing(Datum::Temperature, message));
    };
    Ok(BOLTZMANN * absolute(entry)?)
}

/// T in K.
pub(super) fn absolute(entry: &Entry) -> Result<f64, SpecError> {
    entry.positive(entry.number())
}

/// A persistence length in m.
fn persistence(entry: &Entry) -> Result<f64, SpecError> {
    if entry.is_measured() {
        return entry.positive(entry.number());
    }
    Err(entry.error(ErrorKind::WrongUnit, format!("{} has no unit: write it as in \"50 nm\"", entry.said())))
}

/// B in N m².
fn bending_stiffness(spec: &Spec, entry: &Entry, radius: f64) -> Result<f64, SpecError> {
    let stiffness = match entry.key.datum {
        Datum::YoungsModulus => {
            let area_squared = radius * radius * (radius * radius);
            PI * entry.positive(entry.number())? * area_squared / 4.0
        }
        Datum::BendingPersistenceLength => {
            let length = persistence(entry)?;
            thermal_energy(spec, entry)? * length
        }
        _ => entry.positive(entry.number())?,
    };
    entry.positive(stiffness)
}

/// γ = C/B.
fn stiffness_ratio(spec: &Spec, entry: &Entry, radius: Option<f64>, bending: Option<f64>) -> Result<f64, SpecError> {
    let given = entry.number();
    let without_bending = || {
        let other = match entry.key.datum {
            Datum::ShearModulus => Datum::YoungsModulus,
            Datum::TwistPersistenceLength => Datum::BendingPersistenceLength,
            _ => Datum::BendingStiffness,
        };
        let message = format!("the bending stiffness to {} is missing: give {}", entry.said(), spec.ask_for(other));
        spec.missing(other, message)
    };
    let ratio = match entry.key.datum {
        Datum::PoissonsRatio => {
            if !(given > -1.0 && given <= 0.5) {
                let message = format!("{}: Poisson's ratio must be greater than -1 and at most 0.5", entry.said());
                return Err(entry.error(ErrorKind::Domain, message));
            }
            1.0 / (1.0 + given)
        }
        Datum::ShearModulus => {
            let modulus = entry.positive(given)?;
            match (spec.get(Datum::YoungsModulus), radius, bending) {
                (Some(youngs), _, _) => 2.0 * modulus / youngs.positive(youngs.number())?, // C/B, the radius drops out
                (None, Some(radius), Some(bending)) => {
                    PI * modulus * (radius * radius * (radius * radius)) / 2.0 / bending
                }
                _ => return Err(without_bending()),
            }
        }
        Datum::TwistPersistenceLength => {
            let length = persistence(entry)?;
            match (spec.get(Datum::BendingPersistenceLength), bending) {
                (Some(other), _) => length / persistence(other)?, // kT drops out
                (None, Some(bending)) => thermal_energy(spec, entry)? * length / bending,
                _ => return Err(without_bending()),
            }
        }
        Datum::TorsionalStiffness => {
            let stiffness = entry.positive(given)?;
            let Some(bending) = bending else { return Err(without_bending()) };
            stiffness / bending
        }
        _ => given,
    };
    let ratio = entry.positive(ratio)?;
    if radius.is_some() { entry.measurable(ratio) } else { Ok(ratio) }
}

/// What the torsional stiffness can be given by, beside what is given already.
fn torsion_missing(spec: &Spec, bending: Option<&Entry>) -> SpecError {
    let [one, other] = match bending.map(|entry| entry.key.datum) {
        Some(Datum::YoungsModulus) => [Datum::PoissonsRatio, Datum::ShearModulus],
        Some(Datum::BendingPersistenceLength) => [Datum::TwistPersistenceLength, Datum::StiffnessRatio],
        Some(_) => [Datum::TorsionalStiffness, Datum::StiffnessRatio],
        None => {
            let message = format!(
                "the strand's stiffness ratio C/B is missing: give {}, such as 0.75",
                spec.ask_for(Datum::StiffnessRatio)
            );
            return spec.missing(Datum::StiffnessRatio, message);
        }
    };
    let said = bending.map(Entry::said).unwrap_or_default();
    spec.missing(
        Datum::StiffnessRatio,
        format!(
            "the torsional stiffness that goes with {said} is missing: give {} or {} as well",
            spec.call(one),
            spec.call(other)
        ),
    )
}
