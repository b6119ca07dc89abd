//! Curves, from files or arrays: writhe, link, clearance.

use nply::geometry::Clearance;
use nply::topology::{Along, AverageCrossings, CrossingShare};
use nply_sheet::curves::{Closing, CurveSet, Curves, Format};
use nply_sheet::{ClearanceReport, ErrorKind, Extension, LinkReport, Place, SpecError, WritheQuestion, WritheReport};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::answer::Answer;
use crate::document::Said;
use crate::error;
use crate::work::{alone, each};

/// Which curves, and how they are to be taken.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Given {
    /// Name and bytes of each file; arrays come as NumPy's own files.
    files: Vec<(String, Vec<u8>)>,
    read_as: Option<String>,
    unit: Option<String>,
    /// `None`: as it is written.
    closed: Option<bool>,
    extend: Option<Said>,
    extend_along: String,
    /// Names of curves that are read backwards.
    reverse: Vec<String>,
}

impl Given {
    fn set(&self, py: Python<'_>) -> PyResult<CurveSet> {
        let format = match &self.read_as {
            None => None,
            Some(name) => Some(Format::named(name).ok_or_else(|| {
                let known = Format::ALL.map(Format::name).join(", ");
                PyValueError::new_err(format!("read_as: {name:?} is no format of curves; there are {known}"))
            })?),
        };
        let mut files = Vec::new();
        for (name, bytes) in &self.files {
            let read = alone(py, || Curves::read(name, bytes, format))?;
            files.push((name.clone(), read.map_err(|refused| error::of_reading(&refused))?));
        }
        let closing = match self.closed {
            None => Closing::AsWritten,
            Some(true) => Closing::Closed,
            Some(false) => Closing::Open,
        };
        let backwards: Vec<&str> = self.reverse.iter().map(String::as_str).collect();
        let set = CurveSet::of(files, self.unit.as_deref(), closing).and_then(|set| set.reversed(&backwards));
        set.map_err(|refused| error::of_spec(&refused, None))
    }

    fn extension(&self, set: &CurveSet) -> PyResult<Option<Extension>> {
        let along = match self.extend_along.as_str() {
            "tangents" => Along::Tangents,
            "chord" => Along::Chord,
            other => {
                let message = format!("extend_along is \"tangents\" or \"chord\", not {other:?}");
                return Err(PyValueError::new_err(message));
            }
        };
        let Some(Said(text)) = &self.extend else { return Ok(None) };
        let length = set.length("extend", text).map_err(|refused| error::of_spec(&refused, None))?;
        Ok(Some(Extension { length, along }))
    }
}

fn premise(sentence: String) -> PyErr {
    error::of_curves(&sentence)
}

#[pyfunction]
pub fn writhe(
    py: Python<'_>,
    curves: Given,
    axis: Option<[f64; 3]>,
    ribbon: bool,
    average_crossings: bool,
    tolerance: Option<f64>,
) -> PyResult<Answer> {
    /// Curves worked out between two looks at Ctrl-C, and parts of a sum by segments.
    const ROUND: usize = 64;
    const PARTS: usize = 16;
    if let Some(axis) = axis
        && !axis.iter().all(|x| x.is_finite())
    {
        return Err(PyValueError::new_err("axis: three finite numbers are wanted, such as [0, 0, 1]"));
    }
    let set = curves.set(py)?;
    let question = WritheQuestion { extension: curves.extension(&set)?, axis, ribbon, tolerance };
    if ribbon && question.extension.is_some() {
        let refused =
            SpecError::new(ErrorKind::Contradiction, Place::Flag("ribbon".to_owned()), "ribbons are not prolonged");
        return Err(error::of_spec(&refused, None));
    }
    let mut report = alone(py, || WritheReport::new(set, question))?.map_err(premise)?;
    let all: Vec<usize> = (0..report.len()).collect();
    report.found = match tolerance {
        None => each(py, &all, ROUND, premise, |curve| report.writhing(*curve, None))?,
        Some(tolerance) => {
            let mut found = Vec::new();
            for &number in &all {
                let map = alone(py, || report.map(number, tolerance))?.map_err(premise)?;
                let parts: Vec<usize> = (0..map.parts()).collect();
                let shares = each(py, &parts, PARTS, premise, |part| Ok(map.part(*part)))?;
                found.push(alone(py, || report.writhing(number, Some(shares)))?.map_err(premise)?);
            }
            found
        }
    };
    if average_crossings {
        for number in all {
            report.found[number].average_crossings = Some(average(py, &report.average_crossings(number))?);
        }
    }
    Ok(Answer::of(report))
}

/// All pairs of a curve's segments; added up in one order, however many threads there are.
fn average(py: Python<'_>, work: &AverageCrossings) -> PyResult<CrossingShare> {
    const COLUMNS: usize = 16;
    let columns: Vec<usize> = (0..work.columns()).collect();
    let shares = each(py, &columns, COLUMNS, premise, |k| Ok(work.share(*k..k + 1)))?;
    Ok(shares.into_iter().fold(CrossingShare::default(), |sum, share| sum + share))
}

#[pyfunction]
pub fn link(py: Python<'_>, curves: Given) -> PyResult<Answer> {
    /// Pairs worked out between two looks at Ctrl-C.
    const ROUND: usize = 256;
    let set = curves.set(py)?;
    let extension = curves.extension(&set)?;
    let mut report = alone(py, || LinkReport::new(set, extension))?.map_err(premise)?;
    let pairs: Vec<[usize; 2]> = report.pairs().collect();
    report.links = each(py, &pairs, ROUND, premise, |pair| report.link(*pair))?;
    Ok(Answer::of(report))
}

#[pyfunction]
pub fn clearance(py: Python<'_>, curves: Given, diameters: Vec<Said>) -> PyResult<Answer> {
    /// Segments that one thread looks at before it takes more, and stretches between two looks at Ctrl-C.
    const STRETCH: usize = 256;
    const ROUND: usize = 32;
    let set = curves.set(py)?;
    let diameters: Vec<&str> = diameters.iter().map(|said| said.0.as_str()).collect();
    let report = alone(py, || ClearanceReport::new(set, &diameters))?;
    let mut report = report.map_err(|refused| error::of_spec(&refused, None))?;
    let all = report.wires.segments();
    let mut found = Clearance::default();
    let mut first = 0;
    while first < all {
        // the first round is one stretch alone: what it finds spares the others much
        let last = if first == 0 { STRETCH } else { first + ROUND * STRETCH }.min(all);
        let stretches: Vec<usize> = (first..last).step_by(STRETCH).collect();
        let more = each(py, &stretches, ROUND, premise, |first| {
            Ok(report.wires.search(*first..(first + STRETCH).min(last), &found))
        })?;
        more.into_iter().for_each(|more| found.merge(more));
        first = last;
    }
    report.found = found;
    Ok(Answer::of(report))
}
