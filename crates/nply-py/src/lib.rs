//! The door for Python: NumPy and Arrow in and out, documents as dictionaries, exceptions in place of errors.
//!
//! What a user sees is the package in `python/nply`; this module, `nply._nply`, is what it stands on. Arrays come here flat, of one length
//! or of length one, and go back flat; broadcasting is the package's.
#![allow(unreachable_pub, reason = "what Python sees is decided by the module below")]

mod answer;
mod array;
mod ask;
mod curves;
mod document;
mod error;
mod refusal;
mod shape;
mod study;
mod sweep;
mod table;
mod work;

use pyo3::prelude::*;

/// What `nply` stands on.
#[pymodule]
mod _nply {
    #[pymodule_export]
    use super::answer::{Answer, rasterise};
    #[pymodule_export]
    use super::array::{contact, equilibria};
    #[pymodule_export]
    use super::ask::{
        actuator, fit, fit_check, lays, locus, preset, presets, shape, solve, spin, stiffness, support, trace,
    };
    #[pymodule_export]
    use super::curves::{clearance, link, writhe};
    #[pymodule_export]
    use super::document::keys;
    #[pymodule_export]
    use super::refusal::Refusals;
    #[pymodule_export]
    use super::shape::{Chains, Mesh, centrelines, mesh, nodes, render};
    #[pymodule_export]
    use super::study::{PaperFigure, Plot, figure, figures, map, plot};
    #[pymodule_export]
    use super::sweep::{Sweeping, study};
    #[pymodule_export]
    use super::table::Batches;
    #[pymodule_export]
    use super::work::{jobs, set_jobs};
    use super::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
