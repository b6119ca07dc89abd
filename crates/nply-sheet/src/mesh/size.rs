//! Lengths on the way in and out of a mesh: what a flag says in units of r, what a file says in its unit.

use super::subject::{Subject, flag};
use crate::{Dimension, ErrorKind, Quantity, SpecError, Unit};

/// The unit of a file's coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct FileUnit {
    /// Its name: `mm`; `r` for strand radii.
    pub name: String,
    /// How many of it make a strand radius.
    pub per_radius: f64,
}

impl FileUnit {
    /// The unit asked for; else the format's own, where the strand has a size; else the one the input was written in, or one that suits
    /// the size; strand radii for a strand without a size.
    ///
    /// # Errors
    /// [`SpecError`] for what is no unit of length, and for one where the strand has no size.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::{FileUnit, Subject};
    /// let flags = [("strands", "3"), ("helical-angle", "20 deg"), ("diameter", "0.5 mm")];
    /// let ply = Subject::of(&Spec::from_flags(flags)?, None)?;
    /// let unit = FileUnit::of(&ply, None, None)?;
    /// assert_eq!((unit.name.as_str(), unit.per_radius), ("mm", 0.25));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(ply: &Subject, asked: Option<&str>, own: Option<&str>) -> Result<Self, SpecError> {
        let Some(radius) = ply.strand_radius else {
            return match asked {
                None if !ply.layers.is_empty() => Ok(Self { name: "units".to_owned(), per_radius: ply.bare_radius }),
                Some(unit) if unit != "r" && !ply.layers.is_empty() => {
                    let message = "the strand is described without units: its lengths are in the one it was written in";
                    Err(flag("unit", ErrorKind::Missing, message))
                }
                None | Some("r") => Ok(Self { name: "r".to_owned(), per_radius: 1.0 }),
                Some(_) => {
                    let message = "the strand has no size to be given in a unit: give --radius or --diameter";
                    Err(flag("unit", ErrorKind::Missing, message))
                }
            };
        };
        if asked == Some("r") {
            return Ok(Self { name: "r".to_owned(), per_radius: 1.0 });
        }
        let unit = match asked.or(own) {
            Some(text) => {
                let read = Unit::parse(text).ok().filter(|unit| unit.dimension() == Dimension::LENGTH);
                read.ok_or_else(|| {
                    let message =
                        format!("{} is no unit of length, such as mm, or r for strand radii", crate::quoted(text));
                    flag("unit", ErrorKind::WrongUnit, message)
                })?
            }
            None => ply.units.unit(Dimension::LENGTH, radius),
        };
        Ok(Self { name: unit.to_string(), per_radius: unit.of_si(radius) })
    }

    /// Coordinates in this unit.
    #[must_use]
    pub fn point(&self, point: [f64; 3]) -> [f64; 3] {
        point.map(|x| x * self.per_radius + 0.0) // no −0
    }
}

/// A length that a flag says, in units of r. Bare, it is in strand radii, which a strand with a size takes only where `relative`.
///
/// # Errors
/// [`SpecError`] for what is no length.
pub(super) fn length(name: &str, text: &str, radius: Option<f64>, relative: bool) -> Result<f64, SpecError> {
    let quantity = Quantity::parse(text).map_err(|error| flag(name, ErrorKind::Syntax, error.to_string()))?;
    let wrong = |message: String| Err(flag(name, ErrorKind::WrongUnit, message));
    match (&quantity, radius) {
        (Quantity::Bare(value), None) => Ok(*value),
        (Quantity::Bare(value), Some(_)) if relative || *value == 0.0 => Ok(*value),
        (Quantity::Bare(_), Some(_)) => {
            wrong(format!("{} has no unit, but the strand has: give a length, such as \"20 mm\"", crate::quoted(text)))
        }
        (Quantity::Measured { si, unit }, radius) if unit.dimension() == Dimension::LENGTH => match radius {
            Some(radius) => Ok(si / radius),
            None => {
                let message = "it has a unit, but the strand has no size to measure it by: give --radius or --diameter, or a bare \
                               number in strand radii";
                Err(flag(name, ErrorKind::Missing, message))
            }
        },
        (Quantity::Measured { unit, .. }, _) => wrong(format!(
            "{} is {}; what is wanted is a length, such as \"20 mm\"",
            crate::quoted(text),
            unit.dimension()
        )),
    }
}

/// A length that a flag says of a ply or a layered strand, in units of r.
///
/// # Errors
/// [`SpecError`] for what is no length.
pub(super) fn length_of(name: &str, text: &str, ply: &Subject) -> Result<f64, SpecError> {
    if ply.layers.is_empty() || ply.strand_radius.is_some() {
        return length(name, text, ply.strand_radius, false);
    }
    // bare lengths are in the unit of the description, and others cannot be told in it
    match Quantity::parse(text) {
        Ok(Quantity::Measured { unit, .. }) if unit.dimension() == Dimension::LENGTH => {
            let message = "it has a unit, but the strand is described without units: give a bare number";
            Err(flag(name, ErrorKind::WrongUnit, message))
        }
        _ => Ok(length(name, text, None, false)? / ply.bare_radius),
    }
}

/// As [`length`], greater than 0.
pub(super) fn positive_length(name: &str, text: &str, radius: Option<f64>, relative: bool) -> Result<f64, SpecError> {
    let value = length(name, text, radius, relative)?;
    if value > 0.0 && value < f64::INFINITY {
        return Ok(value);
    }
    Err(flag(name, ErrorKind::Domain, format!("{}: it must be greater than 0", crate::quoted(text))))
}
