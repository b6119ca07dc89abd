//! Studies: tables of states, worked out stretch by stretch, or for rows that are handed in.

use nply_sheet::sweep::{States, Study, SweepFlags};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::document::{self, Said};
use crate::error;
use crate::table::{Batches, taken};
use crate::work::{alone, each};

/// Sets of data that a thread takes at a time, where each is a matter of nanoseconds and where it is one of microseconds.
const FAST: u64 = 1 << 14;
const SLOW: u64 = 1 << 9;
/// Stretches between two looks at Ctrl-C.
const ROUND: usize = 16;

/// What varies, and what is asked.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Asked {
    sweep: Vec<String>,
    order: Option<String>,
    sample: Option<String>,
    points: Option<u64>,
    seed: Option<u64>,
    outputs: Vec<Said>,
    states: Option<String>,
    question: Option<String>,
}

/// A study that is understood.
#[pyclass(frozen, module = "nply._nply", name = "Study")]
pub struct Sweeping(Study);

#[pyfunction]
pub fn study(
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    asked: Asked,
) -> PyResult<Sweeping> {
    let input = document::ply(document, data)?;
    let flags = SweepFlags {
        sweep: asked.sweep,
        order: asked.order,
        sample: asked.sample,
        points: asked.points,
        seed: asked.seed,
        rows: None,
        outputs: asked.outputs.into_iter().map(|said| said.0).collect(),
        states: asked.states,
        question: asked.question,
    };
    Study::from_spec(&input.spec, &flags).map(Sweeping).map_err(|refused| input.refused(&refused))
}

fn refused(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Sweeping {
    /// How many sets of data it has.
    fn rows(&self) -> u64 {
        self.0.rows()
    }

    /// The columns' names.
    fn names(&self) -> Vec<String> {
        self.0.columns().iter().map(|column| column.name.clone()).collect()
    }

    /// The study as a document.
    fn text(&self) -> String {
        self.0.text()
    }

    /// As many sets of data as are best worked out at once.
    fn stretch(&self) -> u64 {
        let usual = if self.0.is_fast() { FAST } else { SLOW };
        match self.0.states() {
            // what is continued is not cut
            States::Continued => usual.div_ceil(self.0.run_length()) * self.0.run_length(),
            _ => usual,
        }
    }

    /// The answers to so many sets of data from one on, in order, on all threads.
    fn solve(&self, py: Python<'_>, first: u64, count: u64) -> PyResult<Batches> {
        let last = first.saturating_add(count).min(self.0.rows());
        let stretch = self.stretch();
        let mut cuts = vec![first.min(last)];
        while let Some(&cut) = cuts.last().filter(|cut| **cut < last) {
            cuts.push(last.min((cut / stretch + 1) * stretch));
        }
        let pairs: Vec<(u64, usize)> =
            cuts.windows(2).map(|pair| (pair[0], usize::try_from(pair[1] - pair[0]).unwrap_or(usize::MAX))).collect();
        let batches = each(py, &pairs, ROUND, refused, |(first, count)| self.0.solve(*first, *count))?;
        Ok(Batches { schema: self.0.schema(), batches })
    }

    /// The answers to given rows.
    fn solve_rows(&self, py: Python<'_>, rows: &Bound<'_, PyAny>) -> PyResult<Batches> {
        let given = taken(rows)?;
        // empty tables have columns too
        let mut pieces = Vec::new();
        for batch in &given.batches {
            let stretch = usize::try_from(self.stretch()).unwrap_or(usize::MAX);
            pieces.extend(
                (0..batch.num_rows())
                    .step_by(stretch)
                    .map(|first| batch.slice(first, stretch.min(batch.num_rows() - first))),
            );
        }
        let spec = |error| error::of_spec(&error, None);
        let batches = each(py, &pieces, ROUND, spec, |piece| self.0.solve_rows(piece))?;
        let schema = match batches.first() {
            Some(first) => first.schema(),
            None => {
                let empty = arrow_array::RecordBatch::new_empty(given.schema);
                alone(py, || self.0.solve_rows(&empty))?.map_err(spec)?.schema()
            }
        };
        Ok(Batches { schema, batches })
    }
}
