//! A report, in every form in which it can be written.

use nply_sheet::plot::{Theme, png};
use nply_sheet::regression::RegressionReport;
use nply_sheet::{
    ClearanceReport, FitReport, LaysReport, LinkReport, LocusReport, PlyingReport, Report, ShapeReport,
    StiffnessReport, StringsReport, TraceReport, WritheReport,
};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// What can be written as text, JSON, CSV or a picture. `None` where a report has no such form.
pub trait Written: Send + Sync {
    fn text(&self) -> String;
    fn json(&self) -> String;
    fn csv(&self) -> Option<String> {
        None
    }
    fn svg(&self, _theme: Theme) -> Option<String> {
        None
    }
}

macro_rules! written {
    ($($report:ty $(, $csv:ident)?;)*) => { $(
        impl Written for $report {
            fn text(&self) -> String {
                <$report>::text(self, false)
            }

            fn json(&self) -> String {
                <$report>::json(self)
            }

            $(fn csv(&self) -> Option<String> {
                Some(<$report>::$csv(self))
            })?
        }
    )* };
}

written! {
    Report, csv;
    FitReport, csv;
    StiffnessReport, csv;
    StringsReport, csv;
    WritheReport, csv;
    LinkReport, csv;
    ClearanceReport, csv;
    ShapeReport;
    LaysReport;
    PlyingReport, csv;
}

impl Written for TraceReport {
    fn text(&self) -> String {
        Self::text(self, false)
    }

    fn json(&self) -> String {
        Self::json(self)
    }

    fn csv(&self) -> Option<String> {
        Some(Self::csv(self))
    }

    fn svg(&self, theme: Theme) -> Option<String> {
        Some(self.picture().svg_in(theme))
    }
}

impl Written for RegressionReport {
    fn text(&self) -> String {
        Self::text(self, false)
    }

    fn json(&self) -> String {
        Self::json(self)
    }

    fn csv(&self) -> Option<String> {
        Some(Self::csv(self))
    }

    fn svg(&self, theme: Theme) -> Option<String> {
        Some(self.picture().svg_in(theme))
    }
}

impl Written for LocusReport {
    fn text(&self) -> String {
        Self::text(self, false)
    }

    fn json(&self) -> String {
        Self::json(self)
    }

    fn csv(&self) -> Option<String> {
        Some(Self::csv(self))
    }

    fn svg(&self, theme: Theme) -> Option<String> {
        Some(self.picture().svg_in(theme))
    }
}

/// A report, still to be written.
#[pyclass(frozen, module = "nply._nply")]
pub struct Answer(Box<dyn Written>);

impl Answer {
    pub fn of(report: impl Written + 'static) -> Self {
        Self(Box::new(report))
    }
}

#[pymethods]
impl Answer {
    /// A table for a person.
    fn text(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.text())
    }

    /// JSON, the bytes of `nply … --json`.
    fn json(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.json())
    }

    /// CSV, the bytes of `nply … --format csv`.
    fn csv(&self, py: Python<'_>) -> Option<String> {
        py.detach(|| self.0.csv())
    }

    /// A picture.
    #[pyo3(signature = (dark = false))]
    fn svg(&self, py: Python<'_>, dark: bool) -> Option<String> {
        py.detach(|| self.0.svg(theme(dark)))
    }
}

pub fn theme(dark: bool) -> Theme {
    if dark { Theme::Dark } else { Theme::Light }
}

/// An SVG picture as PNG, `zoom` pixels to each of its own.
#[pyfunction]
pub fn rasterise<'py>(py: Python<'py>, svg: &str, zoom: f64) -> PyResult<Bound<'py, PyBytes>> {
    let pixels = py.detach(|| png(svg, zoom)).map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
    Ok(PyBytes::new(py, &pixels))
}
