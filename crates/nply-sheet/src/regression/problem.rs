//! What is to be estimated, and from which columns.

use core::cell::Cell;

use nply::mechanics::Ply;

use super::descent::{Bottom, Ground, Known};
use super::parameter::Slot;
use super::row::Row;
use super::rows::{self, LeftOut};
use super::sensed::SLOTS;
use super::state::Model;
use super::{Observable, Parameter, Regressed, RegressionError, answer, doubt};

/// What a column says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Given {
    /// Of the ply.
    State(Observable),
    /// A twist put into the strands, row by row: always held.
    Twist(Parameter),
}

impl Given {
    /// The column's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::State(observable) => observable.name(),
            Self::Twist(parameter) => parameter.name(),
        }
    }
}

impl From<Observable> for Given {
    fn from(observable: Observable) -> Self {
        Self::State(observable)
    }
}

impl From<Parameter> for Given {
    fn from(parameter: Parameter) -> Self {
        Self::Twist(parameter)
    }
}

/// How a column counts.
#[derive(Clone, Debug, PartialEq)]
pub enum Role {
    /// Exactly as given.
    Held,
    /// Measured, with one standard error for each row.
    Measured(Vec<f64>),
    /// Measured, its errors unknown and all alike: they are found from the residuals. One column only.
    Unweighted,
}

/// A column of data: SI, or the theory's units where the strand has no size; NaN where nothing is known.
#[derive(Clone, Debug, PartialEq)]
pub struct DataColumn {
    /// What it says.
    pub given: Given,
    /// A number a row.
    pub values: Vec<f64>,
    /// How it counts.
    pub role: Role,
}

impl DataColumn {
    /// A column.
    pub fn new(given: impl Into<Given>, values: Vec<f64>, role: Role) -> Self {
        Self { given: given.into(), values, role }
    }

    /// A column that is held.
    pub fn held(given: impl Into<Given>, values: Vec<f64>) -> Self {
        Self::new(given, values, Role::Held)
    }

    /// Whether any row has a number in it.
    pub(super) fn has_values(&self) -> bool {
        self.values.iter().any(|value| value.is_finite())
    }
}

/// Parameters to be estimated from rows.
///
/// A load in no column is 0, as elsewhere, but for the moment where turns are held: it takes one to hold them. That, and a load that is NaN
/// in a row, is unknown, and found with the row's state.
#[derive(Clone, Debug)]
pub struct Regression {
    pub(super) model: Model,
    pub(super) asked: Vec<Parameter>,
    pub(super) columns: Vec<DataColumn>,
    pub(super) rows: Vec<Row>,
    pub(super) weighed: bool,
    pub(super) charted: Ply,
    pub(super) known: Vec<Known>,
    pub(super) left_out: Vec<LeftOut>,
    starts: usize,
}

impl Regression {
    /// How many starts are tried if nothing else is said.
    pub const STARTS: usize = 12;

    /// Parameters of a model, which holds their starts, from columns; rows are counted from 1.
    ///
    /// # Errors
    /// [`RegressionError`]: what is missing, too much, or does not go together.
    pub fn new(model: Model, asked: &[Parameter], columns: Vec<DataColumn>) -> Result<Self, RegressionError> {
        let count = columns.first().map_or(0, |column| column.values.len());
        Self::with_lines(model, asked, columns, &(1..=count).collect::<Vec<_>>())
    }

    /// The same with the line of each row, for messages.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_lines(
        model: Model,
        asked: &[Parameter],
        columns: Vec<DataColumn>,
        lines: &[usize],
    ) -> Result<Self, RegressionError> {
        check_columns(&columns, lines)?;
        let model = check_asked(model, asked, &columns)?;
        let weighed = check_roles(&columns)?;
        for column in &columns {
            if let Given::State(observable) = column.given
                && observable.needs_length()
                && model.strand_length.is_none()
            {
                return Err(RegressionError::NoLength(observable.name()));
            }
        }
        let (rows, left_out) = rows::of(&model, asked, &columns, lines)?;
        let charted = Ply::with_balance(model.strands(), 1.0, model.balance())?;
        let asked = asked.to_vec();
        let known = Vec::new();
        Ok(Self { model, asked, columns, rows, weighed, charted, known, left_out, starts: Self::STARTS })
    }

    /// The same with the start of a number known to one standard error, in the number's own unit: it is estimated from the rows and from
    /// what is known of it, as from one measurement more. Held, it would count as exact.
    ///
    /// # Errors
    /// [`RegressionError`] unless the number is to be estimated, the error is greater than 0, and the measurements have errors too.
    ///
    /// ```
    /// use nply::mechanics::Balance;
    /// use nply_sheet::regression::{DataColumn, Model, Observable, Parameter, Regression, Role};
    /// let model = Model::new(3, Balance::Contact)?.with(Parameter::StiffnessRatio, 0.8)?.with(Parameter::Pretwist, -1.0)?;
    /// let angle = DataColumn::new(Observable::HelicalAngle, vec![0.534], Role::Measured(vec![0.002]));
    /// let fit = Regression::new(model, &[Parameter::StiffnessRatio, Parameter::Pretwist], vec![angle])?
    ///     .with_known(Parameter::StiffnessRatio, 0.05)?
    ///     .run()?;
    /// // one angle cannot give both: the ratio stays what it was known to be, the twist follows
    /// let ratio = &fit.estimates[0];
    /// assert!((ratio.value - 0.8).abs() < 1e-6 && ratio.standard_error.is_some_and(|error| (error - 0.05).abs() < 1e-6));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn with_known(mut self, parameter: Parameter, error: f64) -> Result<Self, RegressionError> {
        let name = parameter.name();
        let value = self.model.value(parameter).filter(|_| self.asked.contains(&parameter));
        let value = value.ok_or(RegressionError::KnownNotAsked(name))?;
        if !(error > 0.0 && error < f64::INFINITY) {
            return Err(RegressionError::KnownTo { name, value: error });
        }
        if !self.weighed {
            return Err(RegressionError::KnownUnweighed(name));
        }
        self.known.retain(|known| known.parameter != parameter);
        self.known.push(Known { parameter, value, error });
        Ok(self)
    }

    /// The same with so many starts, 1 at least: the given one, and others about it.
    #[must_use]
    pub fn with_starts(mut self, starts: usize) -> Self {
        self.starts = starts.max(1);
        self
    }

    /// Estimates.
    ///
    /// The sum of squared residuals, each over its error, is walked down from several starts: the given one, and others about it within
    /// a factor of four. In every one each row belongs to the state, among all in equilibrium, that is nearest to what was measured; it
    /// is followed while parameters change, and looked for anew at the end.
    ///
    /// # Errors
    /// [`RegressionError`] where rows have no state at any start, and where there are fewer data than parameters.
    pub fn run(&self) -> Result<Regressed, RegressionError> {
        self.run_while(&|_| true)
    }

    /// The same as long as it may go on: the function is told how many starts are behind, before every row of every step.
    ///
    /// # Errors
    /// As [`run`](Self::run), and [`RegressionError::Stopped`] soon after the function first says no.
    ///
    /// ```
    /// use nply::mechanics::Balance;
    /// use nply_sheet::regression::{DataColumn, Model, Observable, Parameter, Regression, RegressionError, Role};
    /// let model = Model::new(3, Balance::Contact)?.with(Parameter::StiffnessRatio, 1.0)?;
    /// let twist = DataColumn::held(Parameter::Pretwist, vec![-0.5, -1.0]);
    /// let angle = DataColumn::new(Observable::HelicalAngle, vec![0.405, 0.534], Role::Unweighted);
    /// let fit = Regression::new(model, &[Parameter::StiffnessRatio], vec![twist, angle])?;
    /// assert_eq!(fit.run_while(&|starts| starts < 1).unwrap_err(), RegressionError::Stopped);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run_while(&self, may_go_on: &dyn Fn(usize) -> bool) -> Result<Regressed, RegressionError> {
        doubt::of_signs(self, self.estimated(may_go_on), may_go_on)
    }

    pub(super) fn estimated(&self, may_go_on: &dyn Fn(usize) -> bool) -> Result<Regressed, RegressionError> {
        let behind = Cell::new(0);
        let may_go_on = &|| may_go_on(behind.get());
        let or_stopped = || if may_go_on() { Ok(()) } else { Err(RegressionError::Stopped) };
        let free: Vec<usize> = self.asked.iter().map(|parameter| parameter.slot() as usize).collect();
        let sizes = self.sizes(&free);
        let ground = Ground {
            model: &self.model,
            charted: &self.charted,
            rows: &self.rows,
            known: &self.known,
            free: &free,
            sizes: &sizes,
            may_go_on,
        };
        // scouts go over some of many rows
        const SCOUTED: usize = 200;
        let stride = self.rows.len().div_ceil(SCOUTED);
        let some: Vec<Row> = self.rows.iter().step_by(stride).cloned().collect();
        let scouts = Ground { rows: &some, ..ground };
        let mut lost = None;
        let mut bottoms: Vec<Bottom> = Vec::new();
        for start in 0..self.starts {
            match scouts.descend(self.start(start, &free, &sizes)) {
                Ok(bottom) if bottom.chi_squared.is_finite() => bottoms.push(bottom),
                Ok(_) => {}
                Err(lines) => lost = lost.or(Some(lines)),
            }
            behind.set(start + 1);
            or_stopped()?;
        }
        bottoms.sort_by(|a, b| a.chi_squared.total_cmp(&b.chi_squared));
        let mut best: Option<Bottom> = None;
        if stride > 1 {
            for bottom in bottoms.iter().take(2) {
                match ground.descend(bottom.slots) {
                    Ok(found) if best.as_ref().is_none_or(|best| found.chi_squared < best.chi_squared) => {
                        best = Some(found);
                    }
                    Ok(_) => {}
                    Err(lines) => lost = Some(lines),
                }
                or_stopped()?;
            }
        } else {
            best = bottoms.first().cloned();
        }
        let Some(best) = best else {
            return Err(RegressionError::NoState { lines: lost.unwrap_or_default() });
        };
        let answer = answer::of(self, &ground, best, &bottoms);
        or_stopped()?;
        answer
    }

    /// The same measurements with the ply's turns counted the other way; `None` where nothing has a sign.
    pub(super) fn mirrored(&self) -> Option<Self> {
        let mut other = self.clone();
        let mut turned = false;
        for row in &mut other.rows {
            let held = row.held.iter_mut().map(|(observable, value)| (*observable, value));
            let measured = row.measured.iter_mut().map(|datum| (datum.observable, &mut datum.value));
            for (_, value) in held.chain(measured).filter(|(observable, _)| observable.is_signed()) {
                *value = -*value;
                turned = true;
            }
        }
        turned.then_some(other)
    }

    /// The size of one step in each slot: 1 in a logarithm, a twist by its own size.
    fn sizes(&self, free: &[usize]) -> Vec<f64> {
        let strand = self.model.strand(self.model.slots(), None);
        let size = |k: &usize| {
            if *k != Slot::Twist as usize {
                return 1.0;
            }
            let given = self.model.slots()[*k].abs();
            let dimensionless = self.asked.contains(&Parameter::Pretwist);
            given.max(if dimensionless { 0.1 } else { 0.1 / strand.radius.value })
        };
        free.iter().map(size).collect()
    }

    /// Start number 0 is the given one; others are spread about it evenly (Halton's sequence), within a factor of four, a twist
    /// between twice its size either way.
    fn start(&self, number: usize, free: &[usize], sizes: &[f64]) -> [f64; SLOTS] {
        const BASES: [usize; SLOTS] = [2, 3, 5, 7, 11];
        let mut slots = *self.model.slots();
        if number == 0 {
            return slots;
        }
        for ((k, size), base) in free.iter().zip(sizes).zip(BASES) {
            let share = 2.0 * halton(number, base) - 1.0;
            slots[*k] =
                if *k == Slot::Twist as usize { 2.0 * share * size } else { slots[*k] + share * libm::log(4.0) };
        }
        slots
    }
}

/// The number'th of points spread evenly over 0 to 1.
fn halton(number: usize, base: usize) -> f64 {
    let (mut rest, mut share, mut sum) = (number, 1.0, 0.0);
    while rest > 0 {
        share /= base as f64;
        sum += share * (rest % base) as f64;
        rest /= base;
    }
    sum
}

fn check_columns(columns: &[DataColumn], lines: &[usize]) -> Result<(), RegressionError> {
    if lines.is_empty() {
        return Err(RegressionError::NoRows);
    }
    for (i, column) in columns.iter().enumerate() {
        let name = column.given.name();
        if columns[..i].iter().any(|other| other.given == column.given) {
            return Err(RegressionError::SameColumn(name));
        }
        let lengths =
            [column.values.len(), if let Role::Measured(errors) = &column.role { errors.len() } else { lines.len() }];
        if let Some(found) = lengths.into_iter().find(|found| *found != lines.len()) {
            return Err(RegressionError::Length { name, found, expected: lines.len() });
        }
        if let Role::Measured(errors) = &column.role {
            let bad = |i: &usize| column.values[*i].is_finite() && !(errors[*i] > 0.0 && errors[*i] < f64::INFINITY);
            if let Some(i) = (0..lines.len()).find(bad) {
                return Err(RegressionError::Uncertainty { line: lines[i], name, value: errors[i] });
            }
        }
    }
    Ok(())
}

/// The model with every number in the form in which it is asked for.
fn check_asked(model: Model, asked: &[Parameter], columns: &[DataColumn]) -> Result<Model, RegressionError> {
    if asked.is_empty() {
        return Err(RegressionError::NothingAsked);
    }
    let twisted = columns.iter().any(|column| matches!(column.given, Given::Twist(_)));
    for (i, parameter) in asked.iter().enumerate() {
        if let Some(other) = asked[..i].iter().find(|other| other.slot() == parameter.slot()) {
            return Err(RegressionError::Twice { first: other.name(), second: parameter.name() });
        }
        if parameter.slot() == Slot::Twist && twisted {
            return Err(RegressionError::Column(parameter.name()));
        }
    }
    for needed in [Parameter::StiffnessRatio, Parameter::Pretwist] {
        let by_column = needed == Parameter::Pretwist && twisted;
        if !model.gives(needed) && !by_column {
            let name = asked.iter().find(|parameter| parameter.slot() == needed.slot()).unwrap_or(&needed).name();
            return Err(RegressionError::Missing(name));
        }
    }
    asked.iter().try_fold(model, |model, parameter| {
        if !model.gives(*parameter) {
            return Err(RegressionError::Missing(parameter.name()));
        }
        model.in_form(*parameter).ok_or(RegressionError::Form(parameter.name()))
    })
}

/// Whether the measured columns have errors.
fn check_roles(columns: &[DataColumn]) -> Result<bool, RegressionError> {
    let names = |wanted: fn(&Role) -> bool| {
        columns.iter().filter(move |column| wanted(&column.role)).map(|column| column.given.name())
    };
    let mut without = names(|role| *role == Role::Unweighted);
    let mut with = names(|role| matches!(role, Role::Measured(_)));
    match (without.next(), with.next()) {
        (None, None) => {
            let shape = columns.iter().rev().map(|column| column.given.name()).next().unwrap_or("helical_angle");
            Err(RegressionError::NothingMeasured(shape))
        }
        (Some(without), Some(with)) => Err(RegressionError::HalfWeighed { without, with }),
        (Some(first), None) => match without.next() {
            Some(second) => Err(RegressionError::Unweighed { first, second }),
            None => Ok(false),
        },
        (None, Some(_)) => Ok(true),
    }
}
