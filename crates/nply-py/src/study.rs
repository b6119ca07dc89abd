//! Data that run: maps, plots; and the paper's figures.

use nply::Handedness;
use nply::mechanics::Balance;
use nply_sheet::figure::Figure;
use nply_sheet::graph::{Graph, GraphCurve, GraphFlags, Scales};
use nply_sheet::map::{Cell, Map, MapFlags, MapPicture, Tally};
use nply_sheet::plot::Picture;
use nply_sheet::table::arrow;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answer::theme;
use crate::document;
use crate::error;
use crate::table::Batches;
use crate::work::{alone, each};

/// Points worked out between two looks at Ctrl-C, in whole rows, at most 64 of them.
const STRETCH: usize = 1 << 16;

/// A map that is worked out: its table, its picture, and what is said of it.
#[pyfunction]
pub fn map(
    py: Python<'_>,
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    from_: Option<&Bound<'_, PyDict>>,
    to: Option<&Bound<'_, PyDict>>,
    columns: Option<u32>,
    rows: Option<u32>,
) -> PyResult<(Batches, String, String)> {
    let input = document::ply(document, data)?;
    let flags = MapFlags { from: document::corner("from-", from_)?, to: document::corner("to-", to)?, columns, rows };
    let map = input.spec.check_map(Some(&flags)).map_err(|refused| input.refused(&refused))?;
    let schema = arrow::schema(&map.columns(), &metadata(&map));
    let (mut picture, mut tally, mut batches) = (MapPicture::new(&map), Tally::default(), Vec::new());
    let all: Vec<usize> = (0..map.y.count as usize).collect();
    let round = (STRETCH / map.x.count as usize).clamp(1, 64);
    for some in all.chunks(round) {
        let refused = |error: nply::DomainError| input.refused(&map.case().locate(&error));
        let cells: Vec<Vec<Cell>> = each(py, some, round, refused, |row| map.row(*row))?;
        let chunk = alone(py, || {
            for (row, cells) in some.iter().zip(&cells) {
                tally.add(&map, cells);
                picture.put(&map, *row, cells);
            }
            map.chunk(some[0], &cells)
        })?;
        batches.push(arrow::batch(&schema, &chunk).map_err(|error| PyValueError::new_err(error.to_string()))?);
    }
    let (svg, said) = alone(py, || (picture.svg(&map), tally.text(&map)))?;
    Ok((Batches { schema, batches }, svg, said))
}

/// What a table says of itself.
fn metadata(map: &Map) -> Vec<(String, String)> {
    let case = map.case();
    let mut said: Vec<(String, String)> = [
        ("program", "nply".to_owned()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("title", case.title.clone().unwrap_or_default()),
        ("strands", case.strands.to_string()),
        ("balance", case.balance.name().to_owned()),
    ]
    .map(|(name, value)| (name.to_owned(), value))
    .into();
    said.extend(map.held().into_iter().map(|(datum, value)| (datum.name().to_owned(), format!("{value:?}"))));
    said.extend(case.strand_radius.map(|radius| ("strand_radius_m".to_owned(), format!("{radius:?}"))));
    let stiffness = case.scale.map(|scale| format!("{:?}", scale.bending_stiffness()));
    said.extend(stiffness.map(|stiffness| ("bending_stiffness_N_m2".to_owned(), stiffness)));
    said
}

/// What runs, and what is asked.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Running {
    sweep: String,
    ask: Vec<String>,
    against: Option<String>,
    strands: Vec<u32>,
    balances: Vec<String>,
    hands: Vec<String>,
    touching: bool,
    log_x: bool,
    log_y: bool,
}

impl Running {
    fn flags(self) -> PyResult<GraphFlags> {
        let known = |name: &str, words: &[String], all: &[&str]| match words
            .iter()
            .find(|word| !all.contains(&word.as_str()) && *word != "both")
        {
            Some(word) => {
                Err(PyValueError::new_err(format!("{name} is one of {}, both; not {word:?}", all.join(", "))))
            }
            None => Ok(()),
        };
        known("balance", &self.balances, &["contact", "radial"])?;
        known("hand", &self.hands, &["right", "left", "Z", "S"])?;
        let named = |words: &[String], name: &str| words.iter().any(|word| word == name || word == "both");
        let hands = [(Handedness::Right, ["right", "Z"]), (Handedness::Left, ["left", "S"])];
        Ok(GraphFlags {
            balances: Balance::BOTH.into_iter().filter(|balance| named(&self.balances, balance.name())).collect(),
            hands: hands
                .into_iter()
                .filter(|(_, names)| names.iter().any(|name| named(&self.hands, name)))
                .map(|(hand, _)| hand)
                .collect(),
            sweep: self.sweep,
            ask: self.ask,
            against: self.against,
            strands: self.strands,
            touching: self.touching,
            scales: Scales { log_x: self.log_x, log_y: self.log_y },
        })
    }
}

/// Curves of every state while one datum runs.
#[pyclass(frozen, module = "nply._nply")]
pub struct Plot {
    graph: Graph,
    curves: Vec<GraphCurve>,
    picture: Picture,
}

#[pyfunction]
pub fn plot(
    py: Python<'_>,
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    running: Running,
) -> PyResult<Plot> {
    let input = document::ply(document, data)?;
    let flags = running.flags()?;
    let graph = input.spec.check_graph(&flags).map_err(|refused| input.refused(&refused))?;
    let (curves, picture) = alone(py, || {
        let curves = graph.curves();
        let picture = graph.picture(&curves);
        (curves, picture)
    })?;
    Ok(Plot { graph, curves, picture })
}

#[pymethods]
impl Plot {
    #[pyo3(signature = (dark = false))]
    fn svg(&self, py: Python<'_>, dark: bool) -> String {
        py.detach(|| self.picture.svg_in(theme(dark)))
    }

    fn csv(&self, py: Python<'_>) -> String {
        py.detach(|| self.graph.csv(&self.curves))
    }

    /// The picture in characters.
    fn text(&self, py: Python<'_>, width: usize, height: usize) -> String {
        py.detach(|| {
            let charts = self.graph.charts(&self.curves);
            let each = (height / charts.len().max(1)).max(12);
            charts.iter().map(|chart| chart.text(width, each)).collect::<Vec<_>>().join("\n")
        })
    }
}

/// A figure or table of the paper, worked out anew.
#[pyclass(frozen, module = "nply._nply", name = "Figure")]
pub struct PaperFigure(Figure);

#[pyfunction]
pub fn figure(py: Python<'_>, name: &str) -> PyResult<PaperFigure> {
    match alone(py, || Figure::named(name))? {
        Ok(Some(figure)) => Ok(PaperFigure(figure)),
        Ok(None) => {
            Err(PyKeyError::new_err(format!("{name}: there is no such figure; there are 1 to 15, table1, table2")))
        }
        Err(refused) => Err(error::of_domain(&refused, None)),
    }
}

/// The figures' names.
#[pyfunction]
pub fn figures() -> Vec<&'static str> {
    Figure::names().collect()
}

#[pymethods]
impl PaperFigure {
    fn heading(&self) -> String {
        self.0.heading()
    }

    #[pyo3(signature = (dark = false))]
    fn svg(&self, py: Python<'_>, dark: bool) -> String {
        py.detach(|| self.0.svg(theme(dark)))
    }

    fn csv(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.csv())
    }
}
