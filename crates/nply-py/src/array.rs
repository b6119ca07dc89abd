//! Arrays of contacts and of equilibria, a stretch at a time.

use std::borrow::Cow;
use std::ops::Range;

use nply::geometry::contact_batch;
use nply::mechanics::{Balance, Plies, States, Twists};
use nply::{DomainError, Handedness};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error;
use crate::refusal::Refusals;
use crate::work::{alone, each};

/// Rows worked out between two looks at Ctrl-C.
const LONG: usize = 1 << 18;
/// Rows that one thread takes at a time.
const STRETCH: usize = 1 << 14;
/// Stretches between two looks at Ctrl-C.
const ROUND: usize = 64;

/// A column of an array of rows: a value for each, or one for all.
#[derive(Clone, Copy)]
struct Column<'a, T>(&'a [T]);

impl<'a, T: Copy> Column<'a, T> {
    fn of(array: &'a PyReadonlyArray1<'_, T>, rows: usize, name: &str) -> PyResult<Self>
    where
        T: numpy::Element,
    {
        let values = array.as_slice()?;
        if values.len() == rows || values.len() == 1 {
            Ok(Self(values))
        } else {
            Err(PyValueError::new_err(format!("{name} has {} elements where {rows} are wanted", values.len())))
        }
    }

    fn stretch(self, rows: &Range<usize>, all: usize) -> Cow<'a, [T]> {
        match self.0 {
            values if values.len() == all => Cow::Borrowed(&values[rows.clone()]),
            values => Cow::Owned(vec![values[0]; rows.len()]),
        }
    }
}

impl Column<'_, i64> {
    /// Numbers of strands; what is none is 0, which is refused.
    fn counted(self, rows: &Range<usize>, all: usize) -> Vec<u32> {
        match self.0 {
            values if values.len() == all => values[rows.clone()].iter().map(|n| counted(*n)).collect(),
            values => vec![counted(values[0]); rows.len()],
        }
    }

    /// A refusal, with the number as it was given.
    fn as_given(self, row: usize, mut error: DomainError) -> (usize, DomainError) {
        if error.quantity == "strands" {
            error.value = self.0[if self.0.len() == 1 { 0 } else { row }] as f64;
        }
        (row, error)
    }
}

fn counted(strands: i64) -> u32 {
    u32::try_from(strands).unwrap_or(0)
}

type Shapes<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Refusals);

/// x and ρ of touching strands, row by row; and which rows are refused.
#[pyfunction]
pub fn contact<'py>(
    py: Python<'py>,
    rows: usize,
    strands: PyReadonlyArray1<'py, i64>,
    helical_angle: PyReadonlyArray1<'py, f64>,
) -> PyResult<Shapes<'py>> {
    let n = Column::of(&strands, rows, "strands")?;
    let theta = Column::of(&helical_angle, rows, "helical_angle")?;
    let (shift, radius) = (PyArray1::zeros(py, rows, false), PyArray1::zeros(py, rows, false));
    let mut refused = Vec::new();
    {
        let (mut shift, mut radius) = (shift.readwrite(), radius.readwrite());
        let (shift, radius) = (shift.as_slice_mut()?, radius.as_slice_mut()?);
        for (k, (shift, radius)) in shift.chunks_mut(LONG).zip(radius.chunks_mut(LONG)).enumerate() {
            let first = k * LONG;
            let done: Result<(), DomainError> = alone(py, || {
                // short stretches, so that what is the same in all rows stays at hand
                for (j, (shift, radius)) in shift.chunks_mut(STRETCH).zip(radius.chunks_mut(STRETCH)).enumerate() {
                    let first = first + j * STRETCH;
                    let here = first..first + shift.len();
                    let (numbers, theta) = (n.counted(&here, rows), theta.stretch(&here, rows));
                    let refuse = |row, error| refused.push(n.as_given(first + row, error));
                    contact_batch(&numbers, &theta, shift, radius, refuse)?;
                }
                Ok(())
            })?;
            done.map_err(|error| error::of_domain(&error, None))?;
        }
    }
    Ok((shift, radius, Refusals(refused)))
}

type Columns<'py> = (
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<bool>>,
    Refusals,
);

/// Every state of every row: offsets, hands, θ, π/2 − θ, folds; and which rows are refused.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the data of a ply")]
pub fn equilibria<'py>(
    py: Python<'py>,
    rows: usize,
    strands: PyReadonlyArray1<'py, i64>,
    stiffness_ratio: PyReadonlyArray1<'py, f64>,
    twist: PyReadonlyArray1<'py, f64>,
    of_strand: bool,
    force: PyReadonlyArray1<'py, f64>,
    moment: PyReadonlyArray1<'py, f64>,
    balance: &str,
) -> PyResult<Columns<'py>> {
    let Some(balance) = Balance::BOTH.into_iter().find(|known| known.name() == balance) else {
        return Err(PyValueError::new_err(format!("balance is \"contact\" or \"radial\", not {balance:?}")));
    };
    let n = Column::of(&strands, rows, "strands")?;
    let gamma = Column::of(&stiffness_ratio, rows, "stiffness_ratio")?;
    let given = Column::of(&twist, rows, if of_strand { "strand_twist" } else { "pretwist" })?;
    let force = Column::of(&force, rows, "force")?;
    let moment = Column::of(&moment, rows, "moment")?;
    let stretches: Vec<Range<usize>> =
        (0..rows).step_by(STRETCH).map(|first| first..rows.min(first + STRETCH)).collect();
    let refused = |error: DomainError| error::of_domain(&error, None);
    let found = each(py, &stretches, ROUND, refused, |here| {
        let (numbers, gamma) = (n.counted(here, rows), gamma.stretch(here, rows));
        let (given, force, moment) = (given.stretch(here, rows), force.stretch(here, rows), moment.stretch(here, rows));
        let twist = if of_strand { Twists::StrandTwist(&given) } else { Twists::Pretwist(&given) };
        let plies = Plies { strands: &numbers, stiffness_ratio: &gamma, twist, force: &force, moment: &moment };
        let mut states = States::new();
        plies.equilibria(balance, &mut states).map(|()| states)
    })?;
    let joined = alone(py, || joined(n, &stretches, &found))?;
    let Joined { offsets, handedness, helical_angle, pitch_angle, fold, refused } = joined;
    Ok((
        offsets.into_pyarray(py),
        handedness.into_pyarray(py),
        helical_angle.into_pyarray(py),
        pitch_angle.into_pyarray(py),
        fold.into_pyarray(py),
        Refusals(refused),
    ))
}

struct Joined {
    offsets: Vec<i64>,
    handedness: Vec<i8>,
    helical_angle: Vec<f64>,
    pitch_angle: Vec<f64>,
    fold: Vec<bool>,
    refused: Vec<(usize, DomainError)>,
}

/// The states of all stretches, one after the other.
fn joined(n: Column<'_, i64>, stretches: &[Range<usize>], found: &[States]) -> Joined {
    let rows = stretches.last().map_or(0, |last| last.end);
    let all = found.iter().map(States::len).sum();
    let mut joined = Joined {
        offsets: Vec::with_capacity(rows + 1),
        handedness: Vec::with_capacity(all),
        helical_angle: Vec::with_capacity(all),
        pitch_angle: Vec::with_capacity(all),
        fold: Vec::with_capacity(all),
        refused: Vec::new(),
    };
    joined.offsets.push(0);
    for (here, states) in stretches.iter().zip(found) {
        let before = joined.helical_angle.len();
        joined.offsets.extend(states.offsets().iter().skip(1).map(|end| (before + end) as i64));
        joined
            .handedness
            .extend(states.handedness().iter().map(|hand| if *hand == Handedness::Right { 1 } else { -1 }));
        joined.helical_angle.extend_from_slice(states.helical_angle());
        joined.pitch_angle.extend_from_slice(states.pitch_angle());
        joined.fold.extend_from_slice(states.fold());
        let refused = states.refused().iter().map(|(row, error)| n.as_given(here.start + row, error.clone()));
        joined.refused.extend(refused);
    }
    joined
}
