//! Tables of Arrow, in and out by its C data interface: columns are handed over as they are, not copied.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::cast::AsArray;
use arrow_array::ffi_stream::{FFI_ArrowArrayStream, RecordBatchStreamReader};
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchIterator, RecordBatchReader,
};
use arrow_pyarrow::FromPyArrow;
use arrow_schema::{ArrowError, DataType, Field, Schema, SchemaRef};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyError, PyTypeError, PyValueError};
use pyo3::ffi::c_str;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict, PyList};

/// A table: stretches of rows, all with the same columns.
#[pyclass(frozen, module = "nply._nply")]
pub struct Batches {
    pub schema: SchemaRef,
    pub batches: Vec<RecordBatch>,
}

pub fn refused(error: ArrowError) -> PyErr {
    PyValueError::new_err(error.to_string())
}

#[pymethods]
impl Batches {
    /// A table of arrays of numbers: float64, int64, bool.
    #[staticmethod]
    fn of(columns: &Bound<'_, PyDict>, units: HashMap<String, String>) -> PyResult<Self> {
        let mut fields = Vec::new();
        let mut arrays: Vec<ArrayRef> = Vec::new();
        for (name, values) in columns.iter() {
            let name: String = name.extract()?;
            let array: ArrayRef = if let Ok(values) = values.extract::<PyReadonlyArray1<'_, f64>>() {
                Arc::new(Float64Array::from(values.as_slice()?.to_vec()))
            } else if let Ok(values) = values.extract::<PyReadonlyArray1<'_, i64>>() {
                Arc::new(Int64Array::from(values.as_slice()?.to_vec()))
            } else if let Ok(values) = values.extract::<PyReadonlyArray1<'_, bool>>() {
                Arc::new(BooleanArray::from(values.as_slice()?.to_vec()))
            } else {
                return Err(PyTypeError::new_err(format!(
                    "column {name:?} is no flat array of float64, int64 or bool"
                )));
            };
            let field = Field::new(&name, array.data_type().clone(), false);
            let unit = units.get(&name).map(|unit| HashMap::from([("unit".to_owned(), unit.clone())]));
            fields.push(field.with_metadata(unit.unwrap_or_default()));
            arrays.push(array);
        }
        let schema: SchemaRef = Arc::new(Schema::new(fields));
        let batch = RecordBatch::try_new(Arc::clone(&schema), arrays).map_err(refused)?;
        Ok(Self { schema, batches: vec![batch] })
    }

    /// A table of whatever has `__arrow_c_stream__` or `__arrow_c_array__`.
    #[staticmethod]
    fn read(table: &Bound<'_, PyAny>) -> PyResult<Self> {
        taken(table)
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }

    /// The columns' names.
    fn names(&self) -> Vec<String> {
        self.schema.fields().iter().map(|field| field.name().clone()).collect()
    }

    /// What the table says of itself.
    fn metadata(&self) -> HashMap<String, String> {
        self.schema.metadata().iter().map(|(key, value)| (key.to_string(), value.to_string())).collect()
    }

    /// The unit of a column's numbers, if it has one.
    fn unit(&self, name: &str) -> PyResult<Option<String>> {
        let field = self.schema.field_with_name(name).map_err(|_| no_column(name))?;
        Ok(field.metadata().get("unit").cloned())
    }

    /// A column as an array of NumPy's, or as a list where it holds texts or empty cells that are no numbers.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let place = self.schema.index_of(name).map_err(|_| no_column(name))?;
        let parts: Vec<&ArrayRef> = self.batches.iter().map(|batch| batch.column(place)).collect();
        let whole = parts.iter().all(|part| part.null_count() == 0);
        macro_rules! numbers {
            ($kind:ty) => {{
                let parts = parts.iter().map(|part| part.as_primitive::<$kind>());
                if whole {
                    let cells: Vec<_> = parts.flat_map(|part| part.values().iter().copied()).collect();
                    Ok(cells.into_pyarray(py).into_any())
                } else {
                    Ok(PyList::new(py, parts.flat_map(|part| part.iter()).collect::<Vec<_>>())?.into_any())
                }
            }};
        }
        macro_rules! texts {
            ($read:expr) => {{
                let cells: Vec<Option<&str>> = parts.iter().flat_map($read).collect();
                Ok(PyList::new(py, cells)?.into_any())
            }};
        }
        match self.schema.field(place).data_type() {
            DataType::Float64 => {
                let cells = parts.iter().flat_map(|part| part.as_primitive::<Float64Type>().iter());
                Ok(cells.map(|cell| cell.unwrap_or(f64::NAN)).collect::<Vec<_>>().into_pyarray(py).into_any())
            }
            DataType::Float32 => {
                let cells = parts.iter().flat_map(|part| part.as_primitive::<Float32Type>().iter());
                Ok(cells.map(|cell| cell.unwrap_or(f32::NAN)).collect::<Vec<_>>().into_pyarray(py).into_any())
            }
            DataType::Int8 => numbers!(Int8Type),
            DataType::Int16 => numbers!(Int16Type),
            DataType::Int32 => numbers!(Int32Type),
            DataType::Int64 => numbers!(Int64Type),
            DataType::UInt8 => numbers!(UInt8Type),
            DataType::UInt16 => numbers!(UInt16Type),
            DataType::UInt32 => numbers!(UInt32Type),
            DataType::UInt64 => numbers!(UInt64Type),
            DataType::Boolean => {
                let cells: Vec<Option<bool>> = parts.iter().flat_map(|part| part.as_boolean().iter()).collect();
                if whole {
                    Ok(cells.into_iter().flatten().collect::<Vec<_>>().into_pyarray(py).into_any())
                } else {
                    Ok(PyList::new(py, cells)?.into_any())
                }
            }
            DataType::Utf8 => texts!(|part| part.as_string::<i32>().iter()),
            DataType::LargeUtf8 => texts!(|part| part.as_string::<i64>().iter()),
            DataType::Utf8View => texts!(|part| part.as_string_view().iter()),
            other => Err(PyTypeError::new_err(format!("column {name:?} holds {other}, which is left to Arrow"))),
        }
    }

    /// Arrow's C data interface: the table's columns, handed over without a copy.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        let _ = requested_schema; // a wish that need not be granted
        let batches: Vec<Result<RecordBatch, ArrowError>> = self.batches.iter().cloned().map(Ok).collect();
        let reader: Box<dyn RecordBatchReader + Send> =
            Box::new(RecordBatchIterator::new(batches, Arc::clone(&self.schema)));
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(reader), c_str!("arrow_array_stream"))
    }
}

fn no_column(name: &str) -> PyErr {
    PyKeyError::new_err(name.to_owned())
}

/// Takes a table over from another library, without a copy.
pub fn taken(table: &Bound<'_, PyAny>) -> PyResult<Batches> {
    if table.hasattr("__arrow_c_stream__")? {
        let reader = RecordBatchStreamReader::from_pyarrow_bound(table)?;
        let schema = reader.schema();
        let batches = reader.collect::<Result<Vec<_>, _>>().map_err(refused)?;
        return Ok(Batches { schema, batches });
    }
    if table.hasattr("__arrow_c_array__")? {
        let batch = RecordBatch::from_pyarrow_bound(table)?;
        return Ok(Batches { schema: batch.schema(), batches: vec![batch] });
    }
    let kind = table.get_type().name()?;
    let message =
        format!("a table of Arrow is wanted, which has __arrow_c_stream__ or __arrow_c_array__; {kind} has neither");
    Err(PyTypeError::new_err(message))
}
