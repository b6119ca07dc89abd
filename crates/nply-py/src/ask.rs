//! One question each, as the commands ask them.

use nply_sheet::regression::{Measurements, RegressionQuestion, RegressionReport};
use nply_sheet::{
    FitReport, LaysReport, LocusReport, PRESETS, PlyingReport, Preset, Report, ShapeReport, StiffnessReport,
    StringsGoal, StringsReport, TraceReport, Walk, list_presets,
};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answer::{Answer, Written};
use crate::document::{self, Input, Said};
use crate::error;
use crate::work::alone;

type Document<'a, 'py> = Option<&'a Bound<'py, PyAny>>;
type Data<'a, 'py> = Option<&'a Bound<'py, PyDict>>;

/// Works an answer out without Python's lock.
macro_rules! answered {
    ($py:expr, $input:expr, $work:expr) => {{
        let input = $input;
        let report = alone($py, || $work(&input.spec))?;
        Ok(Answer::of(report.map_err(|error| input.refused(&error))?))
    }};
}

#[pyfunction]
pub fn solve(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check().and_then(Report::of))
}

#[pyfunction]
pub fn support(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check_supports().and_then(Report::of))
}

#[pyfunction]
pub fn shape(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>, branches: usize) -> PyResult<Answer> {
    let of = |shape| ShapeReport::of(shape, branches);
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check_shape().and_then(of))
}

#[pyfunction]
pub fn lays(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check_strands().map(LaysReport::of))
}

#[pyfunction]
pub fn locus(
    py: Python<'_>,
    document: Document<'_, '_>,
    data: Data<'_, '_>,
    points: Option<usize>,
) -> PyResult<Answer> {
    let of = |case| LocusReport::of(&case, points.unwrap_or(LocusReport::POINTS));
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check().and_then(of))
}

#[pyfunction]
pub fn spin(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| {
        spec.check_plying().and_then(PlyingReport::of)
    })
}

#[pyfunction]
pub fn actuator(
    py: Python<'_>,
    document: Document<'_, '_>,
    data: Data<'_, '_>,
    steps: Option<usize>,
    goal: Option<(String, Said)>,
) -> PyResult<Answer> {
    let steps = steps.unwrap_or(StringsReport::STEPS);
    let of = |strings| match &goal {
        Some((name, Said(text))) => {
            StringsGoal::read(name, text).and_then(|goal| StringsReport::up_to(strings, goal, steps))
        }
        None => StringsReport::of(strings, steps),
    };
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| spec.check_strings().and_then(of))
}

#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "as many as the command has flags")]
pub fn trace(
    py: Python<'_>,
    document: Document<'_, '_>,
    data: Data<'_, '_>,
    to: Data<'_, '_>,
    start: Option<usize>,
    kept: bool,
    curvature_limit: Option<f64>,
    strain_limit: Option<f64>,
) -> PyResult<Answer> {
    let leg = document::corner("to-", to)?;
    let walk = Walk { start, kept, curvature_limit, strain_limit };
    answered!(py, document::ply(document, data)?, |spec: &nply_sheet::Spec| {
        spec.check_path(leg.as_ref()).and_then(|cases| TraceReport::of(cases, walk))
    })
}

#[pyfunction]
pub fn fit_check(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    let input = document::construction(document, data)?;
    let report = alone(py, || input.spec.check_fit().map(FitReport::of))?;
    Ok(Answer::of(report.map_err(|error| input.refused(&error))?))
}

#[pyfunction]
pub fn stiffness(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>) -> PyResult<Answer> {
    let input = document::construction(document, data)?;
    let Input { spec, .. } = &input;
    let report = alone(py, || spec.check_cable().and_then(|case| StiffnessReport::of(spec, case)))?;
    Ok(Answer::of(report.map_err(|error| input.refused(&error))?))
}

/// What is estimated from which measurements.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Estimating {
    name: String,
    measurements: Vec<u8>,
    estimate: Vec<String>,
    measured: Vec<String>,
    held: Vec<String>,
    errors: Vec<String>,
    starts: Option<usize>,
}

#[pyfunction]
pub fn fit(py: Python<'_>, document: Document<'_, '_>, data: Data<'_, '_>, estimating: Estimating) -> PyResult<Answer> {
    let input = document::ply(document, data)?;
    let Estimating { name, measurements, estimate, measured, held, errors, starts } = estimating;
    let text = String::from_utf8_lossy(&measurements);
    let found = Measurements::read(&name, &measurements).map_err(|refused| error::of_spec(&refused, Some(&text)))?;
    let question = RegressionQuestion { estimate, measured, held, errors, starts };
    let report = alone(py, || RegressionReport::of(&input.spec, &found, &question))?;
    Ok(Answer::of(report.map_err(|refused| input.refused_beside(&refused, &name, found.text()))?))
}

/// The list of what comes with the program.
struct Presets;

impl Written for Presets {
    fn text(&self) -> String {
        list_presets(false)
    }

    fn json(&self) -> String {
        list_presets(true)
    }
}

#[pyfunction]
pub fn presets() -> Answer {
    Answer::of(Presets)
}

#[pyfunction]
pub fn preset(name: &str) -> PyResult<&'static str> {
    Preset::named(name).map(|preset| preset.text).ok_or_else(|| {
        let known: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        PyKeyError::new_err(format!("there is no preset {name}; there are {}", known.join(", ")))
    })
}
