//! What `nply fit` says.

mod json;
mod text;

use super::columns::Roles;
use super::error::{of_signs, out_of_reach};
use super::heading::column_named;
use super::limp;
use super::rows::taken_as_zero;
use super::written::Written;
use super::{DataColumn, Given, Measurements, Observable, Parameter, Regressed, Regression, RegressionError, Role};
use crate::plot::Picture;
use crate::preferred::six_digits;
use crate::report::unit_suffix;
use crate::spec::Spec;
use crate::{Dimension, ErrorKind, Place, PreferredUnits, SpecError, Unit};

pub(super) use text::percent;

/// What is asked of measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegressionQuestion {
    /// Names of the parameters to be estimated.
    pub estimate: Vec<String>,
    /// Columns measured without errors in the data.
    pub measured: Vec<String>,
    /// Columns held, though the data give errors with them.
    pub held: Vec<String>,
    /// `NAME=ERROR`: one standard error for all rows, in the column's unit, in its own, or in % of each number; or that of a number to be
    /// estimated whose start is known so well beforehand.
    pub errors: Vec<String>,
    /// How many starts are tried; [`Regression::STARTS`] if `None`.
    pub starts: Option<usize>,
}

/// Estimates with their errors, residuals, and what the data do not say: as text, JSON, CSV, and pictures.
///
/// ```
/// use nply_sheet::Spec;
/// use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};
/// // angles simulated for C/B = 3/4
/// let data = "pretwist,helical_angle_deg\n-0.2,12.1369\n-0.5,23.2305\n-1,30.6130\n-2,34.5859\n";
/// let data = Measurements::read("balance.csv", data.as_bytes())?;
/// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "1")])?;
/// let asked = RegressionQuestion { estimate: vec!["stiffness_ratio".to_owned()], ..RegressionQuestion::default() };
/// let report = RegressionReport::of(&ply, &data, &asked)?;
/// assert!((report.answer().estimates[0].value - 0.75).abs() < 1e-5);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug)]
pub struct RegressionReport {
    title: Option<String>,
    file: String,
    regression: Regression,
    answer: Regressed,
    sized: bool,
    scaled: bool,
    units: PreferredUnits,
    /// the unit each measured or held column is written in
    written: Vec<(Observable, Option<Unit>)>,
    lines: Vec<usize>,
    assumed: Vec<Observable>,
}

impl RegressionReport {
    /// Estimates of a ply's numbers from measurements; the description has their starts.
    ///
    /// # Errors
    /// [`SpecError`] with its place: in the description, in the data, or at the flag.
    pub fn of(spec: &Spec, data: &Measurements, question: &RegressionQuestion) -> Result<Self, SpecError> {
        Self::of_while(spec, data, question, &|_| true)
    }

    /// The same as long as it may go on: the function is told how many starts are behind, again and again.
    ///
    /// # Errors
    /// As [`of`](Self::of); and once the function says no, one that says so.
    pub fn of_while(
        spec: &Spec,
        data: &Measurements,
        question: &RegressionQuestion,
        may_go_on: &dyn Fn(usize) -> bool,
    ) -> Result<Self, SpecError> {
        let asked = asked(&question.estimate)?;
        let (known, errors): (Vec<_>, Vec<_>) = errors(data, question)?
            .into_iter()
            .partition(|(name, _)| Parameter::named(name).is_some() && !data.names().contains(&name.as_str()));
        let roles = roles(data, question, errors);
        let limp = limp::described(spec, data, &roles, &asked);
        let spec = limp.as_ref().unwrap_or(spec);
        let written = Written::of(spec, &asked)?;
        let mut columns = data.columns(&roles, written.sized, written.scaled)?;
        columns.extend(written.loads(spec, &columns, data.lines().len())?);
        let assumed = taken_as_zero(&columns);
        let refused = |error: RegressionError| refused(spec, data, &asked, &error);
        let regression =
            Regression::with_lines(written.model.clone(), &asked, columns, data.lines()).map_err(refused)?;
        let regression = known.iter().try_fold(regression, |regression, (name, text)| {
            let Some(parameter) = Parameter::named(name) else { return Ok(regression) };
            let error = written.error(&regression.model, parameter, text)?;
            regression.with_known(parameter, error).map_err(refused)
        })?;
        let regression = regression.with_starts(question.starts.unwrap_or(Regression::STARTS));
        let mut answer = regression.run_while(may_go_on).map_err(refused)?;
        answer.notes.extend(limp.is_some().then(|| limp::NOTE.to_owned()));
        let units = Observable::ALL.into_iter().map(|observable| (observable, data.unit(observable).cloned()));
        Ok(Self {
            title: written.title,
            file: data.name().to_owned(),
            answer,
            sized: written.sized,
            scaled: written.scaled,
            units: written.units,
            written: units.collect(),
            lines: data.lines().to_vec(),
            assumed,
            regression,
        })
    }

    /// The numbers.
    #[must_use]
    pub const fn answer(&self) -> &Regressed {
        &self.answer
    }

    pub(super) const fn columns(&self) -> &Vec<DataColumn> {
        &self.regression.columns
    }

    /// Which row of the data stands in a line.
    pub(super) fn place_of(&self, line: usize) -> Option<usize> {
        self.lines.binary_search(&line).ok()
    }

    /// The names of columns with numbers, those that are held or those that are measured.
    fn names(&self, held: bool) -> Vec<&'static str> {
        let of = |column: &&DataColumn| (column.role == Role::Held) == held && column.has_values();
        self.columns().iter().filter(of).map(|column| column.given.name()).collect()
    }

    /// Columns that were measured.
    pub(super) fn measured(&self) -> Vec<Observable> {
        self.columns().iter().filter(|column| column.role != Role::Held).filter_map(observable).collect()
    }

    /// Whether a dimension has a unit here.
    fn has_unit(&self, dimension: Dimension) -> bool {
        match dimension {
            Dimension::NUMBER => false,
            Dimension::ANGLE => true,
            Dimension::LENGTH | Dimension::ANGLE_PER_LENGTH => self.sized,
            _ => self.scaled,
        }
    }

    /// The unit in which programs read an observable, with the factor from what is held inside.
    fn si(&self, observable: Observable) -> (f64, &'static str) {
        let turns = 1.0 / core::f64::consts::TAU;
        match observable.dimension() {
            Dimension::ANGLE if observable == Observable::PlyTurns => (turns, "turns"),
            Dimension::ANGLE => (1_f64.to_degrees(), "deg"),
            Dimension::ANGLE_PER_LENGTH => (turns, if self.sized { "turns/m" } else { "" }),
            dimension => (1.0, if self.has_unit(dimension) { si_name(dimension) } else { "" }),
        }
    }

    /// The unit in which a person reads an observable: that of the data.
    pub(super) fn reading(&self, observable: Observable) -> (f64, String) {
        match self.written.iter().find(|(other, _)| *other == observable) {
            Some((_, Some(unit))) => (unit.of_si(1.0), unit.to_string()),
            _ => {
                let (factor, unit) = self.si(observable);
                (factor, unit.to_owned())
            }
        }
    }

    /// The same of a parameter, for programs.
    fn si_of(&self, parameter: Parameter) -> (f64, &'static str) {
        let turns = 1.0 / core::f64::consts::TAU;
        match parameter.dimension() {
            Dimension::ANGLE_PER_LENGTH if parameter == Parameter::StrandTwist && !self.sized => (1.0, ""),
            Dimension::ANGLE_PER_LENGTH => (turns, if self.sized { "turns/m" } else { "" }),
            dimension => (1.0, if self.has_unit(dimension) { si_name(dimension) } else { "" }),
        }
    }

    /// The same with a name of its own.
    pub(super) fn si_reading(&self, parameter: Parameter) -> (f64, String) {
        let (factor, unit) = self.si_of(parameter);
        (factor, unit.to_owned())
    }

    /// The same for a person.
    fn reading_of(&self, parameter: Parameter, value: f64) -> (f64, String) {
        let dimension = parameter.dimension();
        if !self.has_unit(dimension) {
            let (factor, unit) = self.si_of(parameter);
            return (factor, unit.to_owned());
        }
        let unit = self.units.unit(dimension, value.abs());
        (unit.of_si(1.0), unit.to_string())
    }
}

fn observable(column: &DataColumn) -> Option<Observable> {
    match column.given {
        Given::State(observable) => Some(observable),
        Given::Twist(_) => None,
    }
}

fn si_name(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::FORCE => "N",
        Dimension::MOMENT => "N m",
        Dimension::STIFFNESS => "N m^2",
        Dimension::PRESSURE => "Pa",
        Dimension::LENGTH => "m",
        _ => "",
    }
}

/// Names of parameters.
fn asked(names: &[String]) -> Result<Vec<Parameter>, SpecError> {
    let all = Parameter::ALL.map(Parameter::name);
    let place = || Place::Flag("estimate".to_owned());
    if names.is_empty() {
        let message = format!("nothing is to be estimated: name one or more of {}", all.join(", "));
        return Err(SpecError::new(ErrorKind::Missing, place(), message));
    }
    let named = |name: &String| {
        Parameter::named(name).ok_or_else(|| {
            let help = crate::key::nearest(name, all.into_iter()).map(|name| format!("did you mean `{name}`?"));
            let message = format!("{} cannot be estimated; what can is {}", crate::quoted(name), all.join(", "));
            SpecError::new(ErrorKind::UnknownKey, place(), message).with_help(help)
        })
    };
    names.iter().map(named).collect()
}

/// `name=error`, taken apart.
fn errors(data: &Measurements, question: &RegressionQuestion) -> Result<Vec<(String, String)>, SpecError> {
    let apart = |text: &String| {
        let wrong = || {
            let message = format!(
                "{} is no error; what is wanted is a column and its error, such as lay_length=0.1mm",
                crate::quoted(text)
            );
            SpecError::new(ErrorKind::Syntax, Place::Flag("error".to_owned()), message)
        };
        let (name, error) = text.split_once('=').ok_or_else(wrong)?;
        Ok((plain_name(data, name), error.trim().to_owned()))
    };
    let errors: Vec<(String, String)> = question.errors.iter().map(apart).collect::<Result<_, _>>()?;
    for (at, (name, error)) in errors.iter().enumerate() {
        if let Some((_, first)) = errors.iter().take(at).find(|(other, _)| other == name) {
            let message =
                format!("{name} has two errors, {} and {}: keep one", crate::quoted(first), crate::quoted(error));
            return Err(SpecError::new(ErrorKind::Contradiction, Place::Flag("error".to_owned()), message));
        }
    }
    Ok(errors)
}

/// A column of the data by its own name, however it is called; another word as it stands, joined as names are.
fn plain_name(data: &Measurements, word: &str) -> String {
    let there = column_named(word).filter(|given| data.names().contains(&given.name()));
    there.map_or_else(|| word.trim().replace('-', "_"), |given| given.name().to_owned())
}

fn roles(data: &Measurements, question: &RegressionQuestion, errors: Vec<(String, String)>) -> Roles {
    let plain = |names: &[String]| names.iter().map(|name| plain_name(data, name)).collect();
    Roles { measured: plain(&question.measured), held: plain(&question.held), errors }
}

/// The refusal at its place.
fn refused(spec: &Spec, data: &Measurements, asked: &[Parameter], error: &RegressionError) -> SpecError {
    let kind = if error.exit_code() == 1 { ErrorKind::Domain } else { ErrorKind::Contradiction };
    let message = error.to_string();
    let flag = |name: &str| Place::Flag(name.to_owned());
    match error {
        RegressionError::Twice { .. }
        | RegressionError::Column(_)
        | RegressionError::Form(_)
        | RegressionError::TooFew { .. } => SpecError::new(kind, flag("estimate"), message),
        RegressionError::Missing(name) => {
            let datum = asked.iter().find(|parameter| parameter.name() == *name);
            let key = match datum {
                Some(Parameter::TurnsPerLength) => crate::Datum::TurnsPerLength,
                Some(Parameter::StrandTwist) => crate::Datum::StrandTwist,
                _ => crate::Datum::Pretwist,
            };
            spec.missing(key, message)
        }
        RegressionError::KnownNotAsked(_) | RegressionError::KnownTo { .. } | RegressionError::KnownUnweighed(_) => {
            SpecError::new(kind, flag("error"), message)
        }
        RegressionError::OutOfReach { line, name, measured, limit, least } => {
            let unit = Observable::ALL.into_iter().find(|observable| observable.name() == *name);
            let unit = unit.and_then(|observable| data.unit(observable));
            let read = |value: f64| {
                unit.map_or_else(|| six_digits(value), |unit| format!("{} {unit}", six_digits(unit.of_si(value))))
            };
            data.refuse(Some(*line), kind, out_of_reach(name, &read(*measured), &read(*limit), *least))
        }
        RegressionError::Signs { columns, error } => {
            let inner = refused(spec, data, asked, error);
            data.refuse(error.line(), kind, format!("{}. {}", inner.message(), of_signs(columns)))
        }
        RegressionError::NoLength(_) => spec.missing(crate::Datum::StrandLength, message),
        _ => {
            // the place says the line already
            let line = error.line().map(|line| format!("line {line}: ")).unwrap_or_default();
            data.refuse(error.line(), kind, message.strip_prefix(&line).unwrap_or(&message).to_owned())
        }
    }
}

impl RegressionReport {
    /// Measured beside fitted, and residuals, above each other for every measured column.
    #[must_use]
    pub fn picture(&self) -> Picture {
        let pairs = self.data_charts().into_iter().zip(self.residual_charts());
        Picture::grid(pairs.flat_map(|(data, residuals)| [data, residuals]), 2)
    }

    /// One row of the data a row, for programs; units stand in the names.
    ///
    /// ```
    /// # use nply_sheet::Spec;
    /// # use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};
    /// # let data = Measurements::read("a.csv", b"pretwist,helical_angle_deg\n-0.2,12.1369\n-0.5,23.2305\n")?;
    /// # let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "1")])?;
    /// # let asked = RegressionQuestion { estimate: vec!["stiffness_ratio".to_owned()], ..RegressionQuestion::default() };
    /// let csv = RegressionReport::of(&ply, &data, &asked)?.csv();
    /// assert!(csv.starts_with("line,handedness,helical_angle_deg,force,moment,interstrand_pressure,separated,states,measured_helical_angle_deg,"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn csv(&self) -> String {
        let suffixed = |name: &str, unit: &str| {
            if unit.is_empty() { name.to_owned() } else { format!("{name}_{}", unit_suffix(unit)) }
        };
        let measured = self.measured();
        let [force, moment] =
            [Observable::Force, Observable::Moment].map(|load| suffixed(load.name(), self.si(load).1));
        let mut names: Vec<String> =
            ["line", "handedness", "helical_angle_deg", &force, &moment, "interstrand_pressure", "separated", "states"]
                .map(str::to_owned)
                .to_vec();
        for observable in &measured {
            let unit = self.si(*observable).1;
            for what in ["measured", "fitted", "residual", "error"] {
                names.push(suffixed(&format!("{what}_{}", observable.name()), unit));
            }
            names.push(format!("standardised_{}", observable.name()));
        }
        let mut out = names.join(",") + "\n";
        for fitted in &self.answer.rows {
            let mut cells = vec![
                fitted.line.to_string(),
                format!("{}", fitted.handedness.sign()),
                format!("{:?}", fitted.helical_angle.to_degrees()),
                format!("{:?}", fitted.force),
                format!("{:?}", fitted.moment),
                format!("{:?}", fitted.interstrand_pressure),
                (fitted.interstrand_pressure < 0.0).to_string(),
                fitted.states.to_string(),
            ];
            for observable in &measured {
                let factor = self.si(*observable).0;
                let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
                let compared = fitted.compared.iter().find(|compared| compared.observable == *observable);
                cells.push(number(compared.map(|c| c.measured * factor)));
                cells.push(number(compared.map(|c| c.fitted * factor)));
                cells.push(number(compared.map(|c| c.residual() * factor)));
                cells.push(number(compared.and_then(|c| Some(c.error? * factor))));
                cells.push(number(compared.and_then(|c| c.standardised())));
            }
            out += &(cells.join(",") + "\n");
        }
        out
    }
}

/// Without colours.
fn plain(text: &str) -> String {
    let mut out = String::new();
    for (i, piece) in text.split('\u{1b}').enumerate() {
        out += if i == 0 { piece } else { piece.split_once('m').map_or("", |(_, rest)| rest) };
    }
    out
}
