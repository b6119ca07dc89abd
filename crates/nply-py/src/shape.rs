//! A ply as a shape: surfaces in triangles, centrelines in nodes, rendered pictures.

use nply::geometry::{Ends, Fit};
use nply_sheet::mesh::{
    Assembly, Chain, Element, FileUnit, Fineness, Layered, LineFormat, Spacing, StartGeometry, StartWanted, Subject,
    Surface, SurfaceFormat, Wanted, chain_summary, chains, surface_summary,
};
use nply_sheet::render::{Ground, Picture, View};
use nply_sheet::{Dimension, ErrorKind, Place, Quantity, SpecError};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::answer::{Answer, Written};
use crate::document::{self, Described, Said};
use crate::error;
use crate::work::{alone, each};

/// How much of which ply, with what on it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Shown {
    state: Option<usize>,
    length: Option<Said>,
    lay_lengths: Option<f64>,
    core: Option<Said>,
    stripes: u32,
    contact_lines: bool,
    cuts: Vec<Said>,
    ends: String,
}

fn text(said: Option<&Said>) -> Option<&str> {
    said.map(|said| said.0.as_str())
}

fn refusal(name: &str, kind: ErrorKind, message: impl Into<String>) -> SpecError {
    SpecError::new(kind, Place::Flag(name.to_owned()), message)
}

/// One of several words.
fn word<T: Copy>(name: &str, said: &str, known: &[(&str, T)]) -> PyResult<T> {
    known.iter().find(|(word, _)| *word == said).map(|(_, meant)| *meant).ok_or_else(|| {
        let words: Vec<String> = known.iter().map(|(word, _)| format!("{word:?}")).collect();
        PyValueError::new_err(format!("{name} is one of {}, not {said:?}", words.join(", ")))
    })
}

impl Shown {
    fn wanted(&self) -> PyResult<Wanted<'_>> {
        Ok(Wanted {
            length: text(self.length.as_ref()),
            lay_lengths: self.lay_lengths,
            core: text(self.core.as_ref()),
            ends: word("ends", &self.ends, &[("flush", Ends::Flush), ("square", Ends::Square)])?,
            stripes: self.stripes,
            contact_lines: self.contact_lines,
            cuts: self.cuts.iter().map(|said| said.0.as_str()).collect(),
        })
    }

    /// The ply or layered strand that is described, and as much of it as is wanted.
    fn shape(
        &self,
        py: Python<'_>,
        document: Option<&Bound<'_, PyAny>>,
        data: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<(Subject, Assembly)> {
        let input = document::described(document, data)?;
        let wanted = self.wanted()?;
        let made = alone(py, || match &input.spec {
            Described::Ply(spec) => {
                let ply = Subject::of(spec, self.state)?;
                let assembly = Assembly::of(&ply, &wanted)?;
                Ok((ply, assembly))
            }
            Described::Layered(_) if self.state.is_some() => {
                let message = "a layered strand is shown as it is laid, and has no states: leave it out";
                Err(refusal("state", ErrorKind::Contradiction, message))
            }
            Described::Layered(spec) => {
                let strand = Layered::of(spec)?;
                let assembly = strand.assembly(&wanted)?;
                Ok((strand.subject().clone(), assembly))
            }
        })?;
        made.map_err(|refused| input.refused(&refused))
    }
}

/// How fine, and where triangles lie.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Fine {
    chord_error: Option<Said>,
    facets: Option<u32>,
    segments: Option<u32>,
    fit: String,
}

impl Fine {
    fn fineness(&self) -> PyResult<Fineness<'_>> {
        let fits =
            [("surface", Fit::Surface), ("inside", Fit::Inside), ("outside", Fit::Outside), ("volume", Fit::Volume)];
        Ok(Fineness {
            chord_error: text(self.chord_error.as_ref()),
            around: self.facets,
            segments: self.segments,
            fit: word("fit", &self.fit, &fits)?,
        })
    }
}

fn coordinates<'py>(
    py: Python<'py>,
    unit: &FileUnit,
    points: impl Iterator<Item = [f64; 3]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let flat: Vec<f64> = points.flat_map(|point| unit.point(point)).collect();
    let rows = flat.len() / 3;
    flat.into_pyarray(py).reshape([rows, 3])
}

/// A ply's surfaces in triangles.
#[pyclass(frozen, module = "nply._nply")]
pub struct Mesh {
    ply: Subject,
    assembly: Assembly,
    fine: Fine,
    unit: Option<String>,
    shown: FileUnit,
    // of the lines and stripes that not every format takes
    lines: bool,
    stripes: bool,
}

impl Mesh {
    fn surface(&self) -> PyResult<Surface<'_>> {
        let fineness = self.fine.fineness()?;
        Surface::of(&self.ply, &self.assembly, fineness).map_err(|refused| error::of_spec(&refused, None))
    }
}

#[pyfunction]
pub fn mesh(
    py: Python<'_>,
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    shown: Shown,
    fine: &Bound<'_, PyAny>,
    unit: Option<String>,
) -> PyResult<Mesh> {
    let fine: Fine = fine.extract()?;
    let (ply, assembly) = shown.shape(py, document, data)?;
    let named = FileUnit::of(&ply, unit.as_deref(), None).map_err(|refused| error::of_spec(&refused, None))?;
    let lines = shown.contact_lines || !shown.cuts.is_empty();
    Ok(Mesh { ply, assembly, fine, unit, shown: named, lines, stripes: shown.stripes > 0 })
}

type Triangles<'py> = (
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray2<u8>>,
);

#[pymethods]
impl Mesh {
    /// Vertices, normals, faces, the wire of each face, the colour of each face.
    fn triangles<'py>(&self, py: Python<'py>) -> PyResult<Triangles<'py>> {
        let surface = alone(py, || self.surface())??;
        let positions = surface.parts.iter().flat_map(|part| part.mesh.positions.iter().copied());
        let vertices = coordinates(py, &self.shown, positions)?;
        let normals: Vec<f64> =
            surface.parts.iter().flat_map(|part| part.mesh.normals.as_flattened()).copied().collect();
        let (mut faces, mut wires, mut colours, mut before) = (Vec::new(), Vec::new(), Vec::new(), 0);
        for (number, part) in surface.parts.iter().enumerate() {
            for (i, triangle) in part.mesh.triangles.iter().enumerate() {
                faces.extend(triangle.map(|corner| before + i64::from(corner)));
                wires.push(number as i64);
                colours.extend(part.colour(i));
            }
            before += part.mesh.positions.len() as i64;
        }
        let [corners, triangles] = surface.counts();
        Ok((
            vertices,
            normals.into_pyarray(py).reshape([corners, 3])?,
            faces.into_pyarray(py).reshape([triangles, 3])?,
            wires.into_pyarray(py),
            colours.into_pyarray(py).reshape([triangles, 3])?,
        ))
    }

    /// The lines on it: contact lines and cuts.
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Vec<(String, Bound<'py, PyArray2<f64>>)>> {
        let line = |line: &nply_sheet::mesh::Line| {
            Ok((line.name.clone(), coordinates(py, &self.shown, line.points.iter().copied())?))
        };
        self.assembly.lines.iter().map(line).collect()
    }

    /// The wires' names, in order.
    fn wires(&self) -> Vec<String> {
        self.assembly.wires.iter().map(|wire| wire.name.clone()).collect()
    }

    /// The unit of the coordinates.
    fn unit(&self) -> &str {
        &self.shown.name
    }

    /// What the command says of it.
    fn summary(&self, py: Python<'_>) -> PyResult<String> {
        alone(py, || Ok(surface_summary(&self.ply, &self.surface()?, &self.shown)))?
    }

    /// A file of a format.
    fn write<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let able =
            |format: &SurfaceFormat| (format.takes_lines() || !self.lines) && (format.takes_stripes() || !self.stripes);
        let known: Vec<(&str, SurfaceFormat)> =
            SurfaceFormat::ALL.into_iter().filter(able).map(|format| (format.extension(), format)).collect();
        let format = word("the format", format, &known)?;
        let unit = FileUnit::of(&self.ply, self.unit.as_deref(), format.own_unit());
        let unit = unit.map_err(|refused| error::of_spec(&refused, None))?;
        let bytes = alone(py, || self.surface().map(|surface| format.write(&surface, &unit)))??;
        Ok(PyBytes::new(py, &bytes))
    }
}

/// Centrelines in nodes.
#[pyclass(frozen, module = "nply._nply")]
pub struct Chains {
    title: String,
    ply: Subject,
    chains: Vec<Chain>,
    unit: Option<String>,
    shown: FileUnit,
}

impl Chains {
    fn of(title: String, ply: Subject, chains: Vec<Chain>, unit: Option<String>) -> PyResult<Self> {
        let shown = FileUnit::of(&ply, unit.as_deref(), None).map_err(|refused| error::of_spec(&refused, None))?;
        Ok(Self { title, ply, chains, unit, shown })
    }
}

type OneChain<'py> = (String, f64, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>);

#[pymethods]
impl Chains {
    /// Name, wire radius, nodes, tangents and arclengths of each.
    fn chains<'py>(&self, py: Python<'py>) -> PyResult<Vec<OneChain<'py>>> {
        let one = |chain: &Chain| {
            let tangents: Vec<f64> = chain.tangents.as_flattened().to_vec();
            let arclengths: Vec<f64> = chain.arclengths.iter().map(|s| s * self.shown.per_radius).collect();
            Ok((
                chain.name.clone(),
                chain.radius * self.shown.per_radius,
                coordinates(py, &self.shown, chain.points.iter().copied())?,
                tangents.into_pyarray(py).reshape([chain.tangents.len(), 3])?,
                arclengths.into_pyarray(py),
            ))
        };
        self.chains.iter().map(one).collect()
    }

    fn unit(&self) -> &str {
        &self.shown.name
    }

    fn summary(&self) -> String {
        chain_summary(&self.ply, &self.chains, &self.shown)
    }

    fn write<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let known = LineFormat::ALL.map(|format| (format.extension(), format));
        let format = word("the format", format, &known)?;
        let unit = FileUnit::of(&self.ply, self.unit.as_deref(), format.own_unit());
        let bytes = unit.and_then(|unit| format.write(&self.title, &self.chains, &unit));
        Ok(PyBytes::new(py, &bytes.map_err(|refused| error::of_spec(&refused, None))?))
    }
}

#[pyfunction]
pub fn centrelines(
    py: Python<'_>,
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    shown: Shown,
    per_lay_length: Option<u32>,
    element_type: &str,
    unit: Option<String>,
) -> PyResult<Chains> {
    let element = element(element_type)?;
    let (ply, assembly) = shown.shape(py, document, data)?;
    let chains = alone(py, || chains(&ply, &assembly, Spacing { per_lay_length, element }))?;
    let chains = chains.map_err(|refused| error::of_spec(&refused, None))?;
    Chains::of(assembly.title, ply, chains, unit)
}

fn element(name: &str) -> PyResult<Element> {
    word("the element type", name, &Element::ALL.map(|element| (element.name(), element)))
}

/// What is asked of nodes for finite elements.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Start {
    elements_per_pitch: Option<u32>,
    element_type: String,
    coating: Option<Said>,
    core: Option<Said>,
    stagger: Option<f64>,
    any_stagger: bool,
    lay_radius: Option<Said>,
    length: Option<Said>,
    lay_lengths: Option<f64>,
}

/// Start geometry as a report.
struct Started(StartGeometry, FileUnit);

impl Written for Started {
    fn text(&self) -> String {
        self.0.text(&self.1)
    }

    fn json(&self) -> String {
        self.0.json()
    }
}

#[pyfunction]
pub fn nodes(
    py: Python<'_>,
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
    start: Start,
    unit: Option<String>,
) -> PyResult<(Answer, Chains)> {
    let input = document::described(document, data)?;
    let wanted = StartWanted {
        elements: start.elements_per_pitch,
        element: element(&start.element_type)?,
        coating: text(start.coating.as_ref()),
        core: text(start.core.as_ref()),
        stagger: start.stagger,
        any_stagger: start.any_stagger,
        helix_radius: text(start.lay_radius.as_ref()),
        length: text(start.length.as_ref()),
        lay_lengths: start.lay_lengths,
    };
    let find = || match &input.spec {
        Described::Ply(spec) => StartGeometry::of(spec, &wanted),
        Described::Layered(strand) => StartGeometry::of_layers(strand, &wanted),
    };
    let found = alone(py, find)?.map_err(|refused| input.refused(&refused))?;
    let chains = alone(py, || found.chains())?.map_err(|refused| input.refused(&refused))?;
    let ply = found.ply().clone();
    let chains = Chains::of(found.title(), ply, chains, unit)?;
    Ok((Answer::of(Started(found, chains.shown.clone())), chains))
}

/// From where a ply is seen.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Seen {
    width: u32,
    height: Option<u32>,
    turn: Option<Said>,
    tilt: Option<Said>,
    roll: Option<Said>,
    background: String,
    shadow: bool,
}

impl Seen {
    fn view(&self) -> PyResult<View> {
        let usual = View::default();
        let grounds = [("light", Ground::Light), ("dark", Ground::Dark), ("transparent", Ground::Transparent)];
        let angle = |name: &str, said: &Option<Said>, otherwise: f64| {
            angle(name, text(said.as_ref()), otherwise).map_err(|refused| error::of_spec(&refused, None))
        };
        Ok(View {
            width: self.width,
            height: self.height,
            turn: angle("turn", &self.turn, usual.turn)?,
            tilt: angle("tilt", &self.tilt, usual.tilt)?,
            roll: angle("roll", &self.roll, usual.roll)?,
            ground: word("background", &self.background, &grounds)?,
            shadow: self.shadow,
        })
    }
}

fn angle(name: &str, said: Option<&str>, otherwise: f64) -> Result<f64, SpecError> {
    let Some(said) = said else { return Ok(otherwise) };
    match Quantity::parse(said) {
        Ok(Quantity::Measured { si, unit }) if unit.dimension() == Dimension::ANGLE => Ok(si),
        Ok(quantity) if quantity.si() == 0.0 => Ok(0.0),
        Ok(_) => {
            let message = format!("what is wanted is an angle, such as \"{said} deg\"");
            Err(refusal(name, ErrorKind::WrongUnit, message))
        }
        Err(error) => Err(refusal(name, ErrorKind::Syntax, error.to_string())),
    }
}

#[pyfunction]
pub fn render<'py>(
    py: Python<'py>,
    document: Option<&Bound<'py, PyAny>>,
    data: Option<&Bound<'py, PyDict>>,
    shown: Shown,
    seen: Seen,
) -> PyResult<Bound<'py, PyBytes>> {
    /// Pixels drawn between two looks at Ctrl-C.
    const ROUND: usize = 1 << 16;
    let view = seen.view()?;
    let (_, assembly) = shown.shape(py, document, data)?;
    let no_picture = |error: nply_sheet::render::RenderError| {
        error::of_spec(&refusal("width", ErrorKind::Domain, error.to_string()), None)
    };
    let picture = alone(py, || Picture::of(&[(&assembly, [0.0; 3])], view))?.map_err(no_picture)?;
    let all: Vec<u32> = (0..picture.height()).collect();
    let rows = each(py, &all, ROUND / picture.width() as usize, no_picture, |row| Ok(picture.row(*row)))?;
    let bytes = alone(py, || picture.png(&rows))?.map_err(no_picture)?;
    Ok(PyBytes::new(py, &bytes))
}
