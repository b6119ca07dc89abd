//! Strings that a motor twists together under a load: what `nply actuator` needs.

use core::f64::consts::TAU;

use nply::mechanics::{Twist, TwistedStrings};
use nply::{Handedness, Scale};

use super::ends::as_written;
use super::origin::Origins;
use super::{ends, fibre, measure::Measure, relative, strand, strands, twist};
use crate::key::Group;
use crate::preferred::six_digits;
use crate::spec::{Entry, Spec, Value};
use crate::{Datum, ErrorKind, PreferredUnits, SpecError, Table};

/// Strings of known size and length under a known pull; limp, or with stiffnesses.
///
/// ```
/// use nply_sheet::Spec;
/// let flags = [("strands", "2"), ("diameter", "1 mm"), ("strand-length", "0.5 m"), ("force", "20 N"), ("ply-turns", "30")];
/// let strings = Spec::from_flags(flags)?.check_strings()?;
/// assert!((strings.rotation.unwrap_or(0.0) - 60.0 * core::f64::consts::PI * 1e-3).abs() < 1e-15); // rad per length, times r
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Strings {
    /// The name given to them, for the report.
    pub title: Option<String>,
    /// n, 2 to a million.
    pub strands: u32,
    /// r in m.
    pub strand_radius: f64,
    /// L/r.
    pub strand_length: f64,
    /// F in N, greater than 0.
    pub force: f64,
    /// Which way the motor turns.
    pub handedness: Handedness,
    /// How far: rad per string length, times r, from 0 up to the most turns; `None` for as far as it goes.
    pub rotation: Option<f64>,
    /// The turns of the motor that this is, as they were given where turns were.
    pub turns: Option<f64>,
    /// γ, r and B, and the twist put into each string before they are wound; `None` for limp strings.
    pub stiffness: Option<StringStiffness>,
    /// Share of a string's cross-section that is fibre, where its titre gives its size.
    pub packing_fraction: Option<f64>,
    /// The units the input was written in.
    pub units: PreferredUnits,
    origins: Origins,
}

/// What strings that are not limp resist with.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct StringStiffness {
    /// γ = C/B.
    pub stiffness_ratio: f64,
    /// r and B.
    pub scale: Scale,
    /// What their ends do: clamped in the motor with this pretwist (0 if none is given), or swivelling, with this strand twist kept.
    pub twist: Twist,
}

impl Strings {
    pub(crate) fn of(spec: &Spec) -> Result<Self, SpecError> {
        super::stretch::refuse(spec, "strings on a motor")?;
        let spec = relative::resolved(spec)?;
        let spec = spec.as_ref();
        refuse_others(spec)?;
        let strands = strands(spec, 2)?;
        let stiff = |entry: &Entry| matches!(entry.key.group, Some(Group::Bending | Group::Torsion));
        let (radius, strand) = if spec.entries.iter().any(stiff) {
            let strand = strand::Strand::of(spec)?;
            (strand.radius, Some(strand))
        } else {
            (strand::radius(spec)?, None)
        };
        let Some(radius) = radius else {
            let message = format!(
                "the size of the strings is missing: give {} or {}",
                spec.ask_for(Datum::Diameter),
                spec.call(Datum::Radius)
            );
            return Err(spec.missing(Datum::Diameter, message));
        };
        let measure = Measure { spec, radius: Some(radius), scale: strand.as_ref().and_then(|strand| strand.scale) };
        let Some(strand_length) = measure.strand_length()? else {
            let give = spec.ask_for(Datum::StrandLength);
            return Err(spec.missing(Datum::StrandLength, format!("the length of the strings is missing: give {give}")));
        };
        let twist = twist::of(&measure, Some(strand_length))?;
        let stiffness = match strand {
            Some(strand) => {
                let Some(scale) = strand.scale else {
                    let give = spec.ask_for(Datum::BendingStiffness);
                    let message = format!(
                        "the bending stiffness of the strings is missing: give {give}, or no stiffness at all for limp strings"
                    );
                    return Err(spec.missing(Datum::BendingStiffness, message));
                };
                let twist = twist.unwrap_or(Twist::Pretwist(0.0));
                Some(StringStiffness { stiffness_ratio: strand.stiffness_ratio, scale, twist })
            }
            None => match spec.first_of(Table::Twist) {
                Some(entry) => {
                    let message = format!(
                        "{}: limp strings hold no twist; remove it, or give their stiffness by {} and {}",
                        entry.said(),
                        spec.call(Datum::BendingStiffness),
                        spec.call(Datum::StiffnessRatio)
                    );
                    return Err(entry.error(ErrorKind::Contradiction, message));
                }
                None => None,
            },
        };
        let turned = ends::of(&measure, Some(strand_length))?.and_then(|ends| Some((ends.rotation()?, ends.entry)));
        if let Some((rotation, entry)) = turned {
            within(entry, rotation, strands, radius, strand_length)?;
        }
        let title = match spec.get(Datum::Title) {
            Some(Entry { value: Value::Text(title), .. }) => Some(title.clone()),
            _ => None,
        };
        // a number of turns is told as it was written, and not as its way through radians leaves it
        let turns = turned.map(|(rotation, entry)| match entry.key.datum {
            Datum::PlyTurns if !entry.is_measured() => entry.number().abs(),
            Datum::PlyTurns => entry.number().abs() / TAU,
            _ => rotation.abs() * strand_length / TAU,
        });
        let left = turned.is_some_and(|(rotation, _)| rotation < 0.0);
        Ok(Self {
            title,
            strands,
            strand_radius: radius,
            strand_length,
            force: force(spec)?,
            handedness: if left { Handedness::Left } else { Handedness::Right },
            rotation: turned.map(|(rotation, _)| rotation.abs()),
            turns,
            stiffness,
            packing_fraction: fibre::given_packing(spec)?,
            units: PreferredUnits::of(spec),
            origins: Origins::of(spec),
        })
    }

    /// As [`Case::locate`](crate::Case::locate).
    #[must_use]
    pub fn locate(&self, error: &nply::DomainError) -> SpecError {
        self.origins.locate(error)
    }
}

/// What strings on a motor do not have.
fn refuse_others(spec: &Spec) -> Result<(), SpecError> {
    let other = |entry: &&Entry| {
        matches!(entry.key.table, Table::Lay | Table::Support)
            || matches!(
                entry.key.datum,
                Datum::Hand
                    | Datum::Balance
                    | Datum::Moment
                    | Datum::ExternalPressure
                    | Datum::Separation
                    | Datum::PlyLength
                    | Datum::LengthRatio
            )
    };
    let Some(entry) = spec.entries.iter().find(other) else { return Ok(()) };
    let message = format!(
        "{}: strings on a motor are given by size, length, pull and turns, and all else is found: remove it",
        entry.said()
    );
    Err(entry.error(ErrorKind::Contradiction, message))
}

/// F in N.
fn force(spec: &Spec) -> Result<f64, SpecError> {
    let Some(entry) = spec.get(Datum::Force) else {
        let give = spec.ask_for(Datum::Force);
        let message = format!("the load is missing: give {give}, such as \"20 N\"");
        return Err(spec.missing(Datum::Force, message));
    };
    if !entry.is_measured() {
        let message = format!("{} has no unit: what is wanted is {}", entry.said(), entry.key.kind.wanted());
        return Err(entry.error(ErrorKind::WrongUnit, message));
    }
    let force = entry.number();
    if force > 0.0 {
        return Ok(force);
    }
    let message = format!("{}: strings are pulled: the load must be greater than 0", entry.said());
    Err(entry.error(ErrorKind::Domain, message))
}

/// Refuses turns that the strings cannot take.
fn within(entry: &Entry, rotation: f64, strands: u32, radius: f64, length: f64) -> Result<(), SpecError> {
    let refuse = |why: String| Err(entry.error(ErrorKind::Domain, format!("{}: {why}", entry.said())));
    let Ok(most) = TwistedStrings::most_turns(strands) else { return Ok(()) };
    if rotation == 0.0 {
        return refuse("a motor that does not turn does nothing: give some turns".to_owned());
    }
    if rotation.abs() > most.rotation() {
        let written = as_written(entry, most.rotation(), Some(radius), Some(length));
        return refuse(format!(
            "these strings cannot take so many turns; the most that {strands} of them can take is {written}, at a helical angle of {} deg",
            six_digits(most.contact().angle().degrees())
        ));
    }
    Ok(())
}
