//! Measurements as people keep them: a header that names columns with their units, rows of numbers.

use std::sync::Arc;

use super::reader::Reader;
use super::{DataColumn, Given, Observable, Parameter, Role};
use crate::key::nearest;
use crate::{Dimension, ErrorKind, Place, Quantity, SpecError, Unit, quoted};

/// A file of measurements, read: columns of numbers in SI with the line of each row.
///
/// ```
/// use nply_sheet::regression::Measurements;
/// let text = "force [N],force_error,lay_length_mm,lay_length_error_mm\n1.0,0.01,9.1,0.1\n2.0,0.01,9.6,0.1\n";
/// let data = Measurements::read("pull.csv", text.as_bytes())?;
/// assert_eq!((data.lines(), data.names()), (&[2, 3][..], vec!["force", "lay_length"]));
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measurements {
    name: Arc<str>,
    text: String,
    columns: Vec<Column>,
    lines: Vec<usize>,
}

/// One column of numbers with its errors.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    pub(super) given: Given,
    pub(super) values: Vec<f64>,
    pub(super) errors: Option<Vec<f64>>,
    /// the unit it is written in; none for bare numbers
    pub(super) unit: Option<Unit>,
    /// whether a number other than 0 stands bare
    pub(super) bare: bool,
    pub(super) place: Place,
}

impl Measurements {
    /// Reads text with a header, separated by commas, semicolons or tabs; lines that begin with `#` are remarks. A cell that is empty, or
    /// `NA`, is a number that is not known. Where commas part no cells they are read as decimal points; S and Z stand in place of the sign
    /// of turns and twists.
    ///
    /// # Errors
    /// [`SpecError`] with line and column: a name that is not known, a unit of another kind, a cell that is no number.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, SpecError> {
        let name: Arc<str> = Arc::from(name);
        let text = match core::str::from_utf8(bytes) {
            Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(),
            Err(error) => {
                let valid = String::from_utf8_lossy(&bytes[..error.valid_up_to()]).into_owned();
                let place = Place::in_file(&name, &valid, valid.len()..valid.len());
                return Err(SpecError::new(ErrorKind::Syntax, place, "this is not text in UTF-8"));
            }
        };
        let (columns, lines) = Reader::new(&name, &text).read()?;
        Ok(Self { columns, lines, name: Arc::clone(&name), text })
    }

    /// The line of each row, counted from 1.
    #[must_use]
    pub fn lines(&self) -> &[usize] {
        &self.lines
    }

    /// The columns' names, errors apart.
    #[must_use]
    pub fn names(&self) -> Vec<&'static str> {
        self.columns.iter().map(|column| column.given.name()).collect()
    }

    /// The file's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The file's content.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The unit in which a column is written.
    pub(super) fn unit(&self, observable: Observable) -> Option<&Unit> {
        self.columns.iter().find(|column| column.given == Given::State(observable))?.unit.as_ref()
    }

    /// A refusal at a line of the file.
    pub(super) fn refuse(&self, line: Option<usize>, kind: ErrorKind, message: String) -> SpecError {
        let line = line.unwrap_or(1);
        let start = self.text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>();
        let length = self.text.get(start..).and_then(|rest| rest.lines().next()).map_or(0, str::len);
        SpecError::new(kind, Place::in_file(&self.name, &self.text, start..start + length), message)
    }

    /// Columns for a regression: errors from the file or from `errors`, roles from these or from `measured`.
    pub(super) fn columns(&self, flags: &Roles, sized: bool, scaled: bool) -> Result<Vec<DataColumn>, SpecError> {
        let known = |name: &str| self.columns.iter().any(|column| column.given.name() == name);
        for (flag, name) in flags.named() {
            if !known(name) {
                let help = nearest(name, self.names().into_iter()).map(|name| format!("did you mean `{name}`?"));
                let message = format!("{} is no column of the data", quoted(name));
                return Err(
                    SpecError::new(ErrorKind::UnknownKey, Place::Flag(flag.to_owned()), message).with_help(help)
                );
            }
        }
        for column in &self.columns {
            check_unit(column, sized, scaled)?;
        }
        self.with_roles(flags)
    }

    /// The same whatever their units.
    pub(super) fn with_roles(&self, flags: &Roles) -> Result<Vec<DataColumn>, SpecError> {
        let any_error = self.columns.iter().any(|column| column.errors.is_some()) || !flags.errors.is_empty();
        let roles: Vec<Role> = self.columns.iter().map(|column| flags.role(column)).collect::<Result<_, _>>()?;
        let mut columns: Vec<DataColumn> = self
            .columns
            .iter()
            .zip(roles)
            .map(|(column, role)| DataColumn { given: column.given, values: column.values.clone(), role })
            .collect();
        // without any errors, the only shape beside loads is what was measured
        if !any_error && flags.measured.is_empty() {
            let is_shape = |column: &&mut DataColumn| matches!(column.given, Given::State(shape) if !shape.is_load());
            let mut shapes: Vec<&mut DataColumn> = columns.iter_mut().filter(is_shape).collect();
            if let [only] = &mut shapes[..]
                && !flags.held.iter().any(|held| held == only.given.name())
            {
                only.role = Role::Unweighted;
            }
        }
        Ok(columns)
    }
}

/// What flags say of columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Roles {
    pub(super) measured: Vec<String>,
    pub(super) held: Vec<String>,
    /// `name=value`, taken apart
    pub(super) errors: Vec<(String, String)>,
}

impl Roles {
    fn named(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let errors = self.errors.iter().map(|(name, _)| ("error", name.as_str()));
        let measured = self.measured.iter().map(|name| ("measured", name.as_str()));
        measured.chain(self.held.iter().map(|name| ("held", name.as_str()))).chain(errors)
    }

    fn role(&self, column: &Column) -> Result<Role, SpecError> {
        let name = column.given.name();
        let listed = |list: &[String]| list.iter().any(|word| word == name);
        let refuse = |flag: &str, message: String| {
            Err(SpecError::new(ErrorKind::Contradiction, Place::Flag(flag.to_owned()), message))
        };
        let said = self.errors.iter().find(|(word, _)| word == name);
        if let (Given::Twist(_), true) =
            (column.given, said.is_some() || listed(&self.measured) || column.errors.is_some())
        {
            let message = format!("{name} is put into the strands and held: it has no errors here");
            return match said {
                Some(_) => refuse("error", message),
                None if listed(&self.measured) => refuse("measured", message),
                None => Err(SpecError::new(ErrorKind::Contradiction, column.place.clone(), message)),
            };
        }
        if listed(&self.held) {
            return if listed(&self.measured) || said.is_some() {
                refuse("held", format!("{name} is held or measured, not both"))
            } else {
                Ok(Role::Held)
            };
        }
        match (said, &column.errors) {
            (Some(_), Some(_)) => {
                refuse("error", format!("the data have a column of errors of {name} already: remove one of them"))
            }
            (Some((_, text)), None) => error_of(column, text).map(Role::Measured),
            (None, Some(errors)) => Ok(Role::Measured(errors.clone())),
            (None, None) if listed(&self.measured) => Ok(Role::Unweighted),
            (None, None) => Ok(Role::Held),
        }
    }
}

/// `0.5 deg` for every row, or `2 %` of each number.
fn error_of(column: &Column, text: &str) -> Result<Vec<f64>, SpecError> {
    let name = column.given.name();
    let refuse = |kind, message: String| SpecError::new(kind, Place::Flag("error".to_owned()), message);
    let positive = |error: f64| {
        if error > 0.0 && error < f64::INFINITY {
            Ok(error)
        } else {
            Err(refuse(
                ErrorKind::Domain,
                format!("an error of {} in {name}; one greater than 0 is wanted", quoted(text)),
            ))
        }
    };
    if let Some(share) = text.trim().strip_suffix('%') {
        let share = Quantity::parse(share).map_err(|why| refuse(ErrorKind::Syntax, why.to_string()))?.si();
        let share = positive(share)? / 100.0;
        if column.values.contains(&0.0) {
            let message = format!("{} of {name} is no error where {name} is 0: give a size", quoted(text));
            return Err(refuse(ErrorKind::Domain, message));
        }
        return Ok(column.values.iter().map(|value| share * value.abs()).collect());
    }
    let quantity = Quantity::parse(text).map_err(|why| refuse(ErrorKind::Syntax, why.to_string()))?;
    let error = match (&quantity, &column.unit) {
        (Quantity::Bare(value), Some(unit)) => unit.to_si(*value),
        (Quantity::Bare(value), None) => value * of_bare(column.given),
        (Quantity::Measured { si, unit }, _) => {
            let wanted = dimension(column.given);
            if unit.dimension() != wanted || column.unit.is_none() && wanted != Dimension::ANGLE {
                let message = format!("{} is {}; the error of {name} is {wanted}", quoted(text), unit.dimension());
                return Err(refuse(ErrorKind::WrongUnit, message));
            }
            *si
        }
    };
    Ok(vec![positive(error)?; column.values.len()])
}

pub(super) fn dimension(given: Given) -> Dimension {
    match given {
        Given::State(observable) => observable.dimension(),
        Given::Twist(parameter) => parameter.dimension(),
    }
}

pub(super) fn of_bare(given: Given) -> f64 {
    match given {
        Given::State(observable) => observable.of_bare(),
        Given::Twist(Parameter::TurnsPerLength) => core::f64::consts::TAU,
        Given::Twist(_) => 1.0,
    }
}

/// A unit where the strand has a size, none where it has none.
fn check_unit(column: &Column, sized: bool, scaled: bool) -> Result<(), SpecError> {
    let dimension = dimension(column.given);
    let name = column.given.name();
    let measured = match dimension {
        Dimension::NUMBER => return Ok(()),
        Dimension::ANGLE => {
            if column.bare && column.given != Given::State(Observable::PlyTurns) {
                let message = format!("{name} has no unit: write it as `{name}_deg` or `{name} [rad]`");
                return Err(SpecError::new(ErrorKind::WrongUnit, column.place.clone(), message));
            }
            return Ok(());
        }
        Dimension::FORCE | Dimension::MOMENT => scaled,
        _ => sized,
    };
    let load = matches!(dimension, Dimension::FORCE | Dimension::MOMENT);
    let message = match (measured, column.unit.is_some(), column.bare) {
        (true, false, true) => {
            format!("{name} has no unit, but the strand has: write it as `{name} [{}]`", example(dimension))
        }
        (false, true, _) if load && sized => {
            format!(
                "{name} has a unit, but the strand has no stiffness to measure it by: give bending_stiffness, roughly where it is to be estimated"
            )
        }
        (false, true, _) => {
            format!(
                "{name} has a unit, but the strand has no size to measure it by: give it, roughly where it is to be estimated, or write bare numbers in units of r = B = 1"
            )
        }
        (false, false, true) if load && sized => {
            format!("{name} has no unit, but the strand has a size: write its unit, and give bending_stiffness")
        }
        _ => return Ok(()),
    };
    Err(SpecError::new(ErrorKind::WrongUnit, column.place.clone(), message))
}

fn example(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::FORCE => "N",
        Dimension::MOMENT => "N mm",
        Dimension::LENGTH => "mm",
        _ => "turns/m",
    }
}
