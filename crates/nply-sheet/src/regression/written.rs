//! The ply of a regression, as it is written in a document and in flags.

use nply::mechanics::Twist;

use super::{DataColumn, Given, Model, Observable, Parameter, Role};
use crate::case::EstimatedPly;
use crate::spec::Spec;
use crate::{Datum, Dimension, ErrorKind, Place, PreferredUnits, Quantity, SpecError};

/// A ply with the starts of its estimates, and what else the document says.
#[derive(Clone, Debug)]
pub(super) struct Written {
    pub(super) title: Option<String>,
    pub(super) model: Model,
    /// loads that the document holds in every row
    pub(super) loads: Vec<(Observable, f64)>,
    /// whether lengths have units, and whether loads have
    pub(super) sized: bool,
    pub(super) scaled: bool,
    pub(super) units: PreferredUnits,
}

impl Written {
    pub(super) fn of(spec: &Spec, asked: &[Parameter]) -> Result<Self, SpecError> {
        let ply = EstimatedPly::of(spec)?;
        let refused = |error: nply::DomainError| SpecError::new(ErrorKind::Domain, spec.head(), error.to_string());
        let radius = ply.radius.unwrap_or(1.0);
        let bending = ply.scale.map_or(1.0, |scale| scale.bending_stiffness());
        let mut model = Model::new(ply.strands, ply.balance).map_err(refused)?;
        model.hand = ply.hand;
        model.strand_length = ply.strand_length.map(|length| length * radius);
        let mut give = |parameter, value| {
            model = model.clone().with(parameter, value).map_err(refused)?;
            Ok::<(), SpecError>(())
        };
        give(Parameter::Radius, radius)?;
        match ply.bending {
            // E of a solid strand: B follows its radius
            Some(Datum::YoungsModulus) => {
                give(Parameter::BendingStiffness, bending)?;
                model = model.in_form(Parameter::YoungsModulus).ok_or_else(|| beyond(spec))?;
            }
            _ => give(Parameter::BendingStiffness, bending)?,
        }
        let mut give = |parameter, value| {
            model = model.clone().with(parameter, value).map_err(refused)?;
            Ok::<(), SpecError>(())
        };
        give(Parameter::StiffnessRatio, ply.stiffness_ratio)?;
        let torsion = match ply.torsion {
            Some(Datum::TorsionalStiffness | Datum::TwistPersistenceLength) => Parameter::TorsionalStiffness,
            Some(Datum::ShearModulus) => Parameter::ShearModulus,
            _ => Parameter::StiffnessRatio,
        };
        if let Some((twist, datum)) = ply.twist {
            match (twist, datum) {
                (Twist::StrandTwist(value), _) => give(Parameter::StrandTwist, value / radius)?,
                (Twist::Pretwist(value), Datum::Pretwist | Datum::SurfaceAngle) => give(Parameter::Pretwist, value)?,
                (Twist::Pretwist(value), _) => give(Parameter::TurnsPerLength, value / radius)?,
            }
        }
        if let Some((alpha, nu, solid)) = ply.stretch {
            give(Parameter::AxialStiffness, alpha * bending / radius / radius)?;
            model.thinning = nu;
            if solid {
                model = model.solid();
            }
        }
        model = model.in_form(torsion).ok_or_else(|| beyond(spec))?;
        needed(spec, asked, &ply)?;
        let (sized, scaled) = (ply.radius.is_some(), ply.scale.is_some());
        let units = [bending / radius / radius, bending / radius];
        let loads = [(Observable::Force, ply.force, units[0]), (Observable::Moment, ply.moment, units[1])];
        let loads = loads.into_iter().filter_map(|(load, value, unit)| Some((load, value? * unit))).collect();
        Ok(Self { title: ply.title, model, loads, sized, scaled, units: ply.units })
    }

    /// The error to which a number is known beforehand: with its unit, bare where the strand has no size, or in % of it.
    pub(super) fn error(&self, model: &Model, parameter: Parameter, text: &str) -> Result<f64, SpecError> {
        let name = parameter.name();
        let refuse = |kind, message: String| SpecError::new(kind, Place::Flag("error".to_owned()), message);
        let read = |text| Quantity::parse(text).map_err(|why| refuse(ErrorKind::Syntax, format!("{name}: {why}")));
        if let Some(share) = text.trim().strip_suffix('%') {
            return Ok(read(share)?.si() / 100.0 * model.value(parameter).unwrap_or(0.0).abs());
        }
        let wanted = parameter.dimension();
        let measured = match wanted {
            Dimension::NUMBER => false,
            Dimension::LENGTH | Dimension::ANGLE_PER_LENGTH => self.sized,
            _ => self.scaled,
        };
        match read(text)? {
            Quantity::Bare(value) if !measured => {
                Ok(if parameter == Parameter::TurnsPerLength { value * core::f64::consts::TAU } else { value })
            }
            Quantity::Measured { si, unit } if measured && unit.dimension() == wanted => Ok(si),
            _ => {
                let wanted = if measured { wanted } else { Dimension::NUMBER };
                let message = format!("{} is no error of {name}, which is {wanted}", crate::quoted(text));
                Err(refuse(ErrorKind::WrongUnit, message))
            }
        }
    }

    /// The loads of the document as columns, held; refused where the data have one too.
    pub(super) fn loads(&self, spec: &Spec, columns: &[DataColumn], rows: usize) -> Result<Vec<DataColumn>, SpecError> {
        let mut held = Vec::new();
        for (load, value) in &self.loads {
            if columns.iter().any(|column| column.given == Given::State(*load)) {
                let datum = if *load == Observable::Force { Datum::Force } else { Datum::Moment };
                let name = load.name();
                let message = format!("the {name} is given here and in a column of the data: remove one of them");
                let place = spec.get(datum).map_or_else(|| spec.head(), |entry| entry.place.clone());
                return Err(SpecError::new(ErrorKind::Contradiction, place, message).of_key(name));
            }
            held.push(DataColumn::new(*load, vec![*value; rows], Role::Held));
        }
        Ok(held)
    }
}

fn beyond(spec: &Spec) -> SpecError {
    SpecError::new(
        ErrorKind::Domain,
        spec.head(),
        "the strand's stiffness is too large or too small to be calculated with",
    )
}

/// The sizes without which a parameter has no unit, and the starts.
fn needed(spec: &Spec, asked: &[Parameter], ply: &EstimatedPly) -> Result<(), SpecError> {
    for parameter in asked {
        let size = matches!(
            parameter,
            Parameter::Radius | Parameter::Diameter | Parameter::TurnsPerLength | Parameter::StrandTwist
        );
        let stiffness = matches!(
            parameter,
            Parameter::BendingStiffness
                | Parameter::YoungsModulus
                | Parameter::TorsionalStiffness
                | Parameter::ShearModulus
                | Parameter::AxialStiffness
        );
        let missing = |datum, what: &str| {
            let message = format!(
                "{} is to be estimated, and {what} is missing: give {}, roughly where that is to be estimated too",
                parameter.name(),
                spec.ask_for(datum)
            );
            Err(spec.missing(datum, message))
        };
        if (size || stiffness) && ply.radius.is_none() && *parameter != Parameter::StrandTwist {
            return missing(Datum::Radius, "the size of the strand");
        }
        if stiffness && ply.scale.is_none() {
            return missing(Datum::BendingStiffness, "the bending stiffness");
        }
        if *parameter == Parameter::AxialStiffness && ply.stretch.is_none() {
            let message = format!(
                "axial_stiffness is that of strands that stretch: give {} as true, and {} as a start",
                spec.ask_for(Datum::Stretch),
                spec.ask_for(Datum::AxialStiffness)
            );
            return Err(spec.missing(Datum::Stretch, message));
        }
    }
    Ok(())
}
