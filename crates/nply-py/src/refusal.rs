//! The rows of an array that the theory refuses, each with its reason.

use nply::DomainError;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

use crate::error;

/// Rows that are refused, in ascending order.
#[pyclass(frozen, module = "nply._nply")]
pub struct Refusals(pub Vec<(usize, DomainError)>);

#[pymethods]
impl Refusals {
    fn __len__(&self) -> usize {
        self.0.len()
    }

    /// The flat places of the rows.
    fn rows(&self) -> Vec<usize> {
        self.0.iter().map(|(row, _)| *row).collect()
    }

    /// The exception that a refusal would raise.
    fn error(&self, place: usize) -> PyResult<Py<PyAny>> {
        let (row, refused) =
            self.0.get(place).ok_or_else(|| PyIndexError::new_err("there are not so many refusals"))?;
        Python::attach(|py| Ok(error::of_domain(refused, Some(*row)).into_value(py).into_any()))
    }
}
