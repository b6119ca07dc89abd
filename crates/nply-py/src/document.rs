//! Documents as Python has them: a dictionary, TOML text, or a path; and single data as keyword arguments.

use nply_sheet::construction::{CONSTRUCTION_KEYS, ConstructionSpec, is_layered};
use nply_sheet::{ErrorKind, KEYS, Key, Place, Spec, SpecError};
use pyo3::exceptions::{PyOSError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyBytes, PyDict, PyFloat, PyInt, PyList, PyMapping, PySequence, PyString};
use toml::{Table, Value};

use crate::error;

/// A value as a person would write it.
pub struct Said(pub String);

impl<'py> FromPyObject<'_, 'py> for Said {
    type Error = PyErr;

    fn extract(value: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        said(&value).map(Self)
    }
}

/// What was written.
pub struct Input<S> {
    pub spec: S,
    /// The text of the document, if the user has seen it.
    text: Option<String>,
}

impl<S> Input<S> {
    pub fn refused(&self, error: &SpecError) -> PyErr {
        error::of_spec(error, self.text.as_deref())
    }

    /// As [`Self::refused`], of something that is read beside the document.
    pub fn refused_beside(&self, error: &SpecError, name: &str, text: &str) -> PyErr {
        match error.place() {
            Place::File { name: file, .. } if **file == *name => error::of_spec(error, Some(text)),
            _ => self.refused(error),
        }
    }
}

/// The description of a shape: of a ply, or of a layered strand.
pub enum Described {
    Ply(Spec),
    Layered(ConstructionSpec),
}

/// A document's name, its bytes, and whether they are the user's own.
struct Document {
    name: String,
    bytes: Vec<u8>,
    own: bool,
}

impl Document {
    fn refused(&self, error: &SpecError) -> PyErr {
        error::of_spec(error, self.text().as_deref())
    }

    fn text(&self) -> Option<String> {
        self.own.then(|| String::from_utf8_lossy(&self.bytes).into_owned())
    }
}

/// A ply: the document, with keyword arguments laid over it.
pub fn ply(document: Option<&Bound<'_, PyAny>>, data: Option<&Bound<'_, PyDict>>) -> PyResult<Input<Spec>> {
    over(document.map(read).transpose()?.as_ref(), &flags(data)?)
}

/// As [`ply`], or a layered strand, if the document describes one; data of a ply have no place there.
pub fn described(document: Option<&Bound<'_, PyAny>>, data: Option<&Bound<'_, PyDict>>) -> PyResult<Input<Described>> {
    let document = document.map(read).transpose()?;
    let flags = flags(data)?;
    if let Some(document) = &document
        && is_layered(&String::from_utf8_lossy(&document.bytes))
    {
        if let Some((flag, _)) = flags.first() {
            let message =
                "it says something of a ply of one layer, and the document describes a layered strand: change it there";
            let refused = SpecError::new(ErrorKind::Contradiction, Place::Flag(flag.clone()), message);
            return Err(document.refused(&refused));
        }
        let spec = ConstructionSpec::from_bytes(&document.name, &document.bytes);
        let spec = spec.map_err(|error| document.refused(&error))?;
        return Ok(Input { spec: Described::Layered(spec), text: document.text() });
    }
    let Input { spec, text } = over(document.as_ref(), &flags)?;
    Ok(Input { spec: Described::Ply(spec), text })
}

/// A layered strand: the document, with keyword arguments laid over it; those of a layer may be lists, one value for each layer.
pub fn construction(
    document: Option<&Bound<'_, PyAny>>,
    data: Option<&Bound<'_, PyDict>>,
) -> PyResult<Input<ConstructionSpec>> {
    let mut flags = Vec::new();
    for (name, value) in data.into_iter().flat_map(|data| data.iter()) {
        let flag = flag(&name)?;
        match value.cast::<PyList>() {
            Ok(list) if CONSTRUCTION_KEYS.iter().any(|key| key.flag == flag) => {
                for value in list.iter() {
                    flags.push((flag.clone(), said(&value)?));
                }
            }
            _ => flags.push((flag, said(&value)?)),
        }
    }
    let given = ConstructionSpec::from_flags(flags.iter().map(|(flag, value)| (flag.as_str(), value.as_str())));
    let given = given.map_err(|error| error::of_spec(&error, None))?;
    let Some(document) = document.map(read).transpose()? else {
        return Ok(Input { spec: given, text: None });
    };
    let spec = ConstructionSpec::from_bytes(&document.name, &document.bytes);
    let spec = spec.and_then(|spec| spec.overridden_by(&given)).map_err(|error| document.refused(&error))?;
    Ok(Input { spec, text: document.text() })
}

/// What changes at a corner of a study: `{"force": "2 kN"}`, in its order.
pub fn corner(prefix: &str, data: Option<&Bound<'_, PyDict>>) -> PyResult<Option<Spec>> {
    let flags = flags(data)?;
    if flags.is_empty() {
        return Ok(None);
    }
    let spec = Spec::from_prefixed_flags(prefix, flags.iter().map(|(flag, value)| (flag.as_str(), value.as_str())));
    spec.map(Some).map_err(|error| error::of_spec(&error, None))
}

/// Data laid over a document.
fn over(document: Option<&Document>, flags: &[(String, String)]) -> PyResult<Input<Spec>> {
    let flags = Spec::from_flags(flags.iter().map(|(flag, value)| (flag.as_str(), value.as_str())));
    let flags = flags.map_err(|error| error::of_spec(&error, None))?;
    let Some(document) = document else {
        return Ok(Input { spec: flags, text: None });
    };
    let spec = Spec::from_bytes(&document.name, &document.bytes).map_err(|error| document.refused(&error))?;
    Ok(Input { spec: spec.overridden_by(&flags), text: document.text() })
}

fn flag(name: &Bound<'_, PyAny>) -> PyResult<String> {
    Ok(name.cast::<PyString>()?.to_str()?.replace('_', "-"))
}

/// Keyword arguments as the flags of the command; what is None is not given.
fn flags(data: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<(String, String)>> {
    let all = data.into_iter().flat_map(|data| data.iter());
    all.filter(|(_, value)| !value.is_none()).map(|(name, value)| Ok((flag(&name)?, said(&value)?))).collect()
}

/// A value as a person would write it: numbers to their last digit, quantities of pint with their unit.
fn said(value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(text.to_str()?.to_owned());
    }
    if value.is_instance_of::<PyBool>() {
        return Ok(if value.is_truthy()? { "true" } else { "false" }.to_owned());
    }
    if let Some(quantity) = quantity(value)? {
        return Ok(quantity);
    }
    if let Ok(value) = value.getattr("item").and_then(|item| item.call0()) {
        return said(&value); // a number of NumPy's
    }
    if value.is_instance_of::<PyInt>() || value.is_instance_of::<PyFloat>() {
        return Ok(value.repr()?.to_str()?.to_owned());
    }
    let kind = value.get_type().name()?;
    Err(PyTypeError::new_err(format!(
        "a value is a number, a text such as \"0.5 mm\" or true or false; {kind} is none"
    )))
}

/// A number with its unit, as pint has them.
fn quantity(value: &Bound<'_, PyAny>) -> PyResult<Option<String>> {
    let (Ok(magnitude), Ok(_)) = (value.getattr("magnitude"), value.getattr("units")) else { return Ok(None) };
    let unit = value.getattr("units")?.call_method1("__format__", ("~P",))?;
    Ok(Some(format!("{} {}", said(&magnitude)?, unit.str()?.to_str()?)))
}

/// Reads a document.
fn read(document: &Bound<'_, PyAny>) -> PyResult<Document> {
    if let Ok(mapping) = document.cast::<PyMapping>() {
        let text = table(mapping, 0)?.to_string();
        return Ok(Document { name: "document".to_owned(), bytes: text.into_bytes(), own: false });
    }
    if let Ok(bytes) = document.cast::<PyBytes>() {
        return Ok(Document { name: "document".to_owned(), bytes: bytes.as_bytes().to_vec(), own: true });
    }
    if let Ok(text) = document.cast::<PyString>() {
        let text = text.to_str()?;
        // no path has a line's end in it, and hardly one a key with its value
        if text.contains(['\n', '=']) || text.trim().is_empty() {
            return Ok(Document { name: "document".to_owned(), bytes: text.as_bytes().to_vec(), own: true });
        }
    }
    file(document)
}

/// Reads a file, with Python's own exceptions where it cannot be read.
fn file(path: &Bound<'_, PyAny>) -> PyResult<Document> {
    /// A ply is some lines; what is larger than this (1 MiB) is some other file.
    const LARGEST: usize = 1 << 20;
    let py = path.py();
    let name = match py.import("os")?.call_method1("fspath", (path,)) {
        Ok(name) => name.str()?.to_str()?.to_owned(),
        Err(_) => {
            let kind = path.get_type().name()?;
            let message = format!("a document is a dictionary, a text in TOML or a path; {kind} is none");
            return Err(PyTypeError::new_err(message));
        }
    };
    let open = py.import("io")?.call_method1("open", (path, "rb"))?;
    let bytes = open.call_method1("read", (LARGEST + 1,));
    open.call_method0("close")?;
    let bytes: Vec<u8> = bytes?.cast::<PyBytes>()?.as_bytes().to_vec();
    if bytes.len() > LARGEST {
        let message = format!("{name} is larger than 1 MiB and can hardly be the description of a ply");
        return Err(PyOSError::new_err(message));
    }
    Ok(Document { name, bytes, own: true })
}

/// Dictionaries deeper than this hold themselves.
const DEEPEST: usize = 8;

fn table(mapping: &Bound<'_, PyMapping>, depth: usize) -> PyResult<Table> {
    if depth > DEEPEST {
        return Err(PyTypeError::new_err("a document is a dictionary of tables; this one goes deeper than any"));
    }
    let mut table = Table::new();
    for item in mapping.items()?.iter() {
        let (key, item): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let Ok(key) = key.cast::<PyString>() else {
            return Err(PyTypeError::new_err(format!("a document's keys are texts; {} is none", key.repr()?)));
        };
        if !item.is_none() {
            table.insert(key.to_str()?.to_owned(), value(&item, depth)?);
        }
    }
    Ok(table)
}

fn value(item: &Bound<'_, PyAny>, depth: usize) -> PyResult<Value> {
    if let Ok(mapping) = item.cast::<PyMapping>() {
        return Ok(Value::Table(table(mapping, depth + 1)?));
    }
    if let Ok(text) = item.cast::<PyString>() {
        return Ok(Value::String(text.to_str()?.to_owned()));
    }
    if item.is_instance_of::<PyBool>() {
        return Ok(Value::Boolean(item.is_truthy()?));
    }
    if let Some(quantity) = quantity(item)? {
        return Ok(Value::String(quantity));
    }
    if let Ok(list) = item.cast::<PySequence>() {
        let items = list.to_list()?;
        return items.iter().map(|item| value(&item, depth + 1)).collect::<PyResult<_>>().map(Value::Array);
    }
    if let Ok(number) = item.getattr("item").and_then(|item| item.call0()) {
        return value(&number, depth + 1);
    }
    if item.is_instance_of::<PyInt>() {
        return item.extract().map(Value::Integer);
    }
    if item.is_instance_of::<PyFloat>() {
        return item.extract().map(Value::Float);
    }
    Err(PyTypeError::new_err(format!("{} has no place in a document", item.repr()?)))
}

/// Every datum that can be a keyword argument: its name, what is wanted, what it is; of a ply, or of a layered strand.
#[pyfunction]
pub fn keys(layered: bool) -> Vec<(String, &'static str, &'static str)> {
    let keys: Vec<&Key> = if layered { CONSTRUCTION_KEYS.iter().collect() } else { KEYS.iter().collect() };
    keys.into_iter().map(|key| (key.flag.replace('-', "_"), key.kind.wanted(), key.help)).collect()
}
