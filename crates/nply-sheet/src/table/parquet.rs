//! Parquet, through Arrow; neither is seen from outside.

use std::io::Write;

use arrow_schema::SchemaRef;
use parquet::arrow::ArrowWriter;
use parquet::basic::Compression;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;

use super::{Column, TableError, Values, arrow};

/// Rows are kept, encoded, until there are so many.
const ROW_GROUP: usize = 1 << 17;

#[derive(Debug)]
pub(super) struct Writer<W: Write + Send> {
    schema: SchemaRef,
    parquet: ArrowWriter<W>,
}

impl<W: Write + Send> Writer<W> {
    pub(super) fn new(columns: &[Column], metadata: &[(&str, &str)], write: W) -> Result<Self, TableError> {
        let schema = arrow::schema(columns, &[]);
        let pairs = metadata.iter().map(|&(key, value)| KeyValue::new(key.to_owned(), value.to_owned())).collect();
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_max_row_group_row_count(Some(ROW_GROUP))
            .set_key_value_metadata(Some(pairs))
            .build();
        let parquet = ArrowWriter::try_new(write, schema.clone(), Some(properties)).map_err(refused)?;
        Ok(Self { schema, parquet })
    }

    pub(super) fn write(&mut self, chunk: &[Values]) -> Result<(), TableError> {
        let batch = arrow::batch(&self.schema, chunk)?;
        self.parquet.write(&batch).map_err(refused)
    }

    pub(super) fn finish(self) -> Result<W, TableError> {
        let mut write = self.parquet.into_inner().map_err(refused)?;
        write.flush()?;
        Ok(write)
    }
}

pub(super) fn refused(error: ParquetError) -> TableError {
    match error {
        ParquetError::External(inner) => match inner.downcast::<std::io::Error>() {
            Ok(error) => TableError::Write(*error),
            Err(other) => TableError::Encode(other),
        },
        other => TableError::Encode(other.into()),
    }
}

#[cfg(test)]
mod tests {
    use arrow_array::Array;
    use arrow_array::cast::AsArray;
    use arrow_array::types::{Float64Type, Int64Type};
    use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

    use super::*;
    use crate::table::{Kind, TableWriter};

    #[test]
    fn what_is_written_in_chunks_reads_back() {
        let columns = vec![
            Column::new("moment", Kind::Float).with_unit("N m"),
            Column::new("states", Kind::Integer),
            Column::new("stable", Kind::Boolean),
            Column::new("note", Kind::Text),
        ];
        let numbers = [0.1 + 0.2, -0.0, f64::MIN_POSITIVE / 3.0, f64::MAX, f64::NAN, f64::NEG_INFINITY];
        let mut table = TableWriter::parquet(columns, &[("program", "nply"), ("case", "ß")], Vec::new()).unwrap();
        let rows = ROW_GROUP + 1;
        let cell = |row: usize| (!row.is_multiple_of(7)).then(|| numbers[row % numbers.len()]);
        for begin in [0, 5, rows - 3] {
            let end = if begin == 0 {
                5
            } else if begin == 5 {
                rows - 3
            } else {
                rows
            };
            let integers: Vec<Option<i64>> = (begin..end).map(|row| (row % 2 == 0).then_some(-(row as i64))).collect();
            let notes: Vec<String> = (begin..end).map(|row| format!("row {}", row % 10)).collect();
            let flags: Vec<bool> = (begin..end).map(|row| row % 3 == 0).collect();
            let numbers: Vec<Option<f64>> = (begin..end).map(cell).collect();
            table.write_chunk(&[numbers.into(), integers.into(), flags.into(), notes.into()]).unwrap();
        }
        let file = bytes::Bytes::from(table.finish().unwrap());
        let builder = ParquetRecordBatchReaderBuilder::try_new(file).unwrap();
        assert_eq!(builder.metadata().num_row_groups(), 2);
        assert_eq!(builder.schema().field(0).metadata()["unit"], "N m");
        let pairs = builder.metadata().file_metadata().key_value_metadata().unwrap();
        assert!(pairs.iter().any(|pair| pair.key == "case" && pair.value.as_deref() == Some("ß")));
        let mut row = 0;
        for batch in builder.build().unwrap() {
            let batch = batch.unwrap();
            let (numbers, integers) =
                (batch.column(0).as_primitive::<Float64Type>(), batch.column(1).as_primitive::<Int64Type>());
            for i in 0..batch.num_rows() {
                let read = numbers.is_valid(i).then(|| numbers.value(i).to_bits());
                assert_eq!(read, cell(row).map(f64::to_bits), "row {row}");
                assert_eq!(integers.is_valid(i).then(|| integers.value(i)), (row % 2 == 0).then_some(-(row as i64)));
                assert_eq!(batch.column(2).as_boolean().value(i), row % 3 == 0);
                assert_eq!(batch.column(3).as_string::<i32>().value(i), format!("row {}", row % 10));
                row += 1;
            }
        }
        assert_eq!(row, rows);
    }
}
