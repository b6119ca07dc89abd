//! Columns as Arrow has them.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchOptions, StringArray, new_null_array,
};
use arrow_schema::{DataType, Field, Schema, SchemaRef};

use super::{Column, Kind, TableError, Values};

/// The schema of a table; units stand in the metadata `unit` of the fields.
pub(crate) fn schema(columns: &[Column], metadata: &[(String, String)]) -> SchemaRef {
    let fields: Vec<Field> = columns.iter().map(field).collect();
    Arc::new(Schema::new_with_metadata(fields, metadata.iter().cloned().collect::<HashMap<String, String>>()))
}

/// A stretch of a table.
pub(crate) fn batch(schema: &SchemaRef, chunk: &[Values]) -> Result<RecordBatch, TableError> {
    let rows = RecordBatchOptions::new().with_row_count(Some(chunk.first().map_or(0, Values::len)));
    RecordBatch::try_new_with_options(schema.clone(), chunk.iter().map(array).collect(), &rows)
        .map_err(|error| TableError::Encode(error.into()))
}

pub(crate) fn field(column: &Column) -> Field {
    let field = Field::new(&column.name, data_type(column.kind), true);
    match column.unit.as_str() {
        "" => field,
        unit => field.with_metadata(HashMap::from([("unit".to_owned(), unit.to_owned())])),
    }
}

const fn data_type(kind: Kind) -> DataType {
    match kind {
        Kind::Float => DataType::Float64,
        Kind::Integer => DataType::Int64,
        Kind::Boolean => DataType::Boolean,
        Kind::Text => DataType::Utf8,
    }
}

pub(crate) fn array(values: &Values) -> ArrayRef {
    match values {
        Values::Float(cells) => Arc::new(cells.iter().copied().collect::<Float64Array>()),
        Values::Integer(cells) => Arc::new(cells.iter().copied().collect::<Int64Array>()),
        Values::Boolean(cells) => Arc::new(cells.iter().copied().collect::<BooleanArray>()),
        Values::Text(cells) => Arc::new(cells.iter().map(Option::as_deref).collect::<StringArray>()),
        Values::Words(cells) => Arc::new(cells.iter().copied().collect::<StringArray>()),
        Values::Dense(cells) => Arc::new(Float64Array::from(cells.clone())),
        Values::Counts(cells) => Arc::new(Int64Array::from(cells.clone())),
        Values::Nothing(kind, length) => new_null_array(&data_type(*kind), *length),
    }
}
