//! Columns as Arrow has them, for doors that hand tables on.

use std::collections::{BTreeSet, HashMap};
use std::fmt::Display;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::sync::{Arc, Mutex, PoisonError};

use arrow_array::cast::AsArray;
use arrow_array::types::{
    Float32Type, Float64Type, Int8Type, Int16Type, Int32Type, Int64Type, UInt8Type, UInt16Type, UInt32Type, UInt64Type,
};
use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchOptions, StringArray,
    new_null_array,
};
use arrow_schema::{DataType, Field, Schema, SchemaRef};

use arrow_ipc::writer::FileWriter;
use bytes::Bytes;
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::{ParquetRecordBatchReader, ParquetRecordBatchReaderBuilder};
use parquet::arrow::arrow_writer::{ArrowColumnChunk, ArrowRowGroupWriterFactory, compute_leaves};
use parquet::basic::{Compression, Encoding as Packing};
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::ParquetError;
use parquet::file::metadata::{
    FileMetaData, KeyValue, ParquetMetaDataBuilder, ParquetMetaDataReader, ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::{ChunkReader, Length};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{ColumnPath, SchemaDescriptor};

use super::block::Counted;
use super::parquet::refused;
use super::{Column, Kind, Mark, TableError, Values};

/// How rows become blocks.
#[derive(Clone, Debug)]
pub(super) struct Encoding {
    pub(super) schema: SchemaRef,
    bare: SchemaRef,
    /// for columns whose numbers repeat, and for those whose numbers do not
    factories: [Arc<ArrowRowGroupWriterFactory>; 2],
    descriptor: Arc<SchemaDescriptor>,
}

impl Encoding {
    pub(super) fn new(columns: &[Column], metadata: &[(String, String)]) -> Result<Self, TableError> {
        let bare = schema(columns, &[]);
        let factory = |properties: WriterProperties| {
            let writer = ArrowWriter::try_new(io::sink(), bare.clone(), Some(properties)).map_err(refused)?;
            let (writer, factory) = writer.into_serialized_writer().map_err(refused)?;
            Ok::<_, TableError>((Arc::new(factory), Arc::new(writer.schema_descr().clone())))
        };
        let ((repeating, descriptor), (plain, _)) = (factory(properties(&[]))?, factory(plain_properties(columns))?);
        Ok(Self { schema: schema(columns, metadata), bare, factories: [repeating, plain], descriptor })
    }

    pub(super) fn batch(&self, chunk: &[Values]) -> Result<RecordBatch, TableError> {
        batch(&self.schema, chunk)
    }

    /// Every column of a row group, encoded.
    pub(super) fn columns(&self, chunk: &[Values]) -> Result<Vec<ArrowColumnChunk>, TableError> {
        let [repeating, plain] = &self.factories;
        let repeating = repeating.create_column_writers(0).map_err(refused)?;
        let plain = plain.create_column_writers(0).map_err(refused)?;
        let mut done = Vec::with_capacity(chunk.len());
        // every column is one leaf
        for ((field, values), writers) in self.bare.fields().iter().zip(chunk).zip(repeating.into_iter().zip(plain)) {
            let mut writer = if repeats(values) { writers.0 } else { writers.1 };
            for leaf in compute_leaves(field, &array(values)).map_err(refused)? {
                writer.write(&leaf).map_err(refused)?;
            }
            done.push(writer.close().map_err(refused)?);
        }
        self.as_read(&mut done)?;
        Ok(done)
    }

    /// What is known of the columns, as it would be read from a footer: a block that is copied says then what it said when it was new.
    fn as_read(&self, columns: &mut [ArrowColumnChunk]) -> Result<(), TableError> {
        let Some(rows) = columns.first().map(|column| column.close().rows_written) else { return Ok(()) };
        let group = RowGroupMetaData::builder(self.descriptor.clone())
            .set_num_rows(i64::try_from(rows).unwrap_or(i64::MAX))
            .set_column_metadata(columns.iter().map(|column| column.close().metadata.clone()).collect())
            .build()
            .map_err(refused)?;
        let footer = ParquetMetaDataReader::decode_metadata(&footer_of(&self.descriptor, group)?).map_err(refused)?;
        let Some(read) = footer.row_groups().first() else { return Ok(()) };
        for (column, read) in columns.iter_mut().zip(read.columns()) {
            column.close_mut().metadata = read.clone();
        }
        Ok(())
    }
}

/// How Parquet is written: no indexes of pages, so that a row group is all in one place and can be copied as it is.
fn properties(metadata: &[(String, String)]) -> WriterProperties {
    let pairs = metadata.iter().map(|(key, value)| KeyValue::new(key.clone(), value.clone())).collect();
    WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true)
        .set_max_row_group_row_count(None)
        .set_key_value_metadata(Some(pairs))
        .build()
}

/// The same for numbers that do not repeat: a dictionary of them would be as long as they are, and take most of the time.
fn plain_properties(columns: &[Column]) -> WriterProperties {
    let whole = columns.iter().filter(|column| column.kind == Kind::Integer);
    whole
        .fold(properties(&[]).into_builder().set_dictionary_enabled(false), |properties, column| {
            let path = ColumnPath::from(vec![column.name.clone()]);
            properties.set_column_encoding(path, Packing::DELTA_BINARY_PACKED)
        })
        .build()
}

/// Whether numbers repeat, as far as a look at some of them tells; texts and truth values always do.
fn repeats(values: &Values) -> bool {
    const LOOKS: usize = 256;
    let bits: Vec<u64> = {
        let places = (0..values.len()).step_by((values.len() / LOOKS).max(1)).take(LOOKS);
        match values {
            Values::Dense(cells) => places.map(|at| cells[at].to_bits()).collect(),
            Values::Counts(cells) => places.map(|at| cells[at].cast_unsigned()).collect(),
            Values::Float(cells) => places.filter_map(|at| cells[at].map(f64::to_bits)).collect(),
            Values::Integer(cells) => places.filter_map(|at| cells[at].map(i64::cast_unsigned)).collect(),
            _ => return true,
        }
    };
    let looks = bits.len();
    let distinct: BTreeSet<u64> = bits.into_iter().collect();
    2 * distinct.len() <= looks
}

pub(super) fn parquet<W: Write + Send>(
    columns: &[Column],
    metadata: &[(String, String)],
    write: W,
) -> Result<SerializedFileWriter<W>, TableError> {
    let writer = ArrowWriter::try_new(write, schema(columns, &[]), Some(properties(metadata))).map_err(refused)?;
    writer.into_serialized_writer().map(|(writer, _)| writer).map_err(refused)
}

pub(super) fn append_row_group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    columns: Vec<ArrowColumnChunk>,
) -> Result<Mark, TableError> {
    let mut group = writer.next_row_group().map_err(refused)?;
    for column in columns {
        column.append_to_row_group(&mut group).map_err(refused)?;
    }
    group.close().map_err(refused)?;
    mark(writer)
}

/// The file up to its last row group; the tail is a footer of this row group alone.
fn mark<W: Write + Send>(writer: &SerializedFileWriter<W>) -> Result<Mark, TableError> {
    let Some(last) = writer.flushed_row_groups().last() else {
        return Ok(Mark { bytes: writer.bytes_written() as u64, tail: Vec::new() });
    };
    let tail = footer_of(&Arc::new(writer.schema_descr().clone()), last.clone())?;
    Ok(Mark { bytes: writer.bytes_written() as u64, tail })
}

/// A footer of one row group, without its length and the format's mark behind.
fn footer_of(descriptor: &Arc<SchemaDescriptor>, group: RowGroupMetaData) -> Result<Vec<u8>, TableError> {
    let file = FileMetaData::new(2, group.num_rows(), None, None, Arc::clone(descriptor), None);
    let footer = ParquetMetaDataBuilder::new(file).add_row_group(group).build();
    let mut bytes = Vec::new();
    ParquetMetaDataWriter::new(&mut bytes, &footer).finish().map_err(refused)?;
    bytes.truncate(bytes.len().saturating_sub(8));
    Ok(bytes)
}

/// Row groups as they are.
pub(super) fn copy_row_groups<W: Write + Send, R: Read + Seek + Send + 'static>(
    writer: &mut SerializedFileWriter<W>,
    old: R,
    marks: &[Mark],
) -> Result<(), TableError> {
    let old = Shared::new(old)?;
    for mark in marks {
        let footer = ParquetMetaDataReader::decode_metadata(&mark.tail).map_err(refused)?;
        for from in footer.row_groups() {
            let mut group = writer.next_row_group().map_err(refused)?;
            for column in from.columns() {
                let close = ColumnCloseResult {
                    bytes_written: column.compressed_size().unsigned_abs(),
                    rows_written: from.num_rows().unsigned_abs(),
                    metadata: column.clone(),
                    bloom_filter: None,
                    column_index: None,
                    offset_index: None,
                };
                group.append_column(&old, close).map_err(refused)?;
            }
            group.close().map_err(refused)?;
        }
    }
    Ok(())
}

pub(super) fn finish_parquet<W: Write + Send>(writer: SerializedFileWriter<W>) -> Result<W, TableError> {
    writer.into_inner().map_err(refused) // which ends it
}

pub(super) fn ipc<W: Write>(encoding: &Encoding, write: W) -> Result<FileWriter<W>, TableError> {
    FileWriter::try_new(write, &encoding.schema).map_err(not_arrow)
}

pub(super) fn append_batch<W: Write>(writer: &mut FileWriter<W>, batch: &RecordBatch) -> Result<(), TableError> {
    writer.write(batch).map_err(not_arrow)
}

/// Batches, read and written again.
pub(super) fn copy_batches<W: Write, R: Read + Seek>(
    writer: &mut FileWriter<Counted<W>>,
    mut old: R,
    marks: &[Mark],
) -> Result<(), TableError> {
    let Some(last) = marks.last() else { return Ok(()) };
    // a file is a stream behind some bytes of its own
    let mut head = [0; 64];
    old.read_exact(&mut head)?;
    let begins = if head[8..12] == [0xff; 4] { 8 } else { 64 };
    old.seek(SeekFrom::Start(begins))?;
    let stream = io::BufReader::new(old.take(last.bytes.saturating_sub(begins)));
    let batches = arrow_ipc::reader::StreamReader::try_new(stream, None).map_err(not_arrow)?;
    for batch in batches.take(marks.len()) {
        append_batch(writer, &batch.map_err(not_arrow)?)?;
    }
    Ok(())
}

pub(super) fn finish_ipc<W: Write>(mut writer: FileWriter<W>) -> Result<W, TableError> {
    writer.finish().map_err(not_arrow)?;
    writer.into_inner().map_err(not_arrow)
}

fn not_arrow(error: arrow_schema::ArrowError) -> TableError {
    match error {
        arrow_schema::ArrowError::IoError(_, error) => TableError::Write(error),
        other => TableError::Encode(other.into()),
    }
}

/// A file that is read in places.
pub(super) struct Shared<R> {
    file: Arc<Mutex<R>>,
    length: u64,
}

impl<R: Read + Seek> Shared<R> {
    pub(super) fn new(mut file: R) -> io::Result<Self> {
        let length = file.seek(SeekFrom::End(0))?;
        Ok(Self { file: Arc::new(Mutex::new(file)), length })
    }
}

/// From one place on, up to the file's end: to read beyond is an error, since what skips bytes by copying them away would take nothing for as
/// many bytes as it likes, and a damaged header can announce some 10⁹ of them, again and again.
pub(super) struct From<R> {
    file: Arc<Mutex<R>>,
    at: u64,
}

impl<R: Read + Seek> Read for From<R> {
    fn read(&mut self, room: &mut [u8]) -> io::Result<usize> {
        // a reader that panicked has left nothing that the next would rely on
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(self.at))?;
        let read = file.read(room)?;
        if read == 0 && !room.is_empty() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        self.at += read as u64;
        Ok(read)
    }
}

impl<R> Length for Shared<R> {
    fn len(&self) -> u64 {
        self.length
    }
}

impl<R: Read + Seek + Send> ChunkReader for Shared<R> {
    type T = io::BufReader<From<R>>;

    fn get_read(&self, start: u64) -> Result<Self::T, ParquetError> {
        Ok(io::BufReader::with_capacity(1 << 16, From { file: Arc::clone(&self.file), at: start }))
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes, ParquetError> {
        if start.checked_add(length as u64).is_none_or(|end| end > self.length) {
            return Err(ParquetError::EOF("the file ends before what it announces".to_owned()));
        }
        let mut bytes = vec![0; length];
        From { file: Arc::clone(&self.file), at: start }.read_exact(&mut bytes)?;
        Ok(bytes.into())
    }
}

/// The schema of a table; units stand in the metadata `unit` of the fields.
///
/// ```
/// use nply_sheet::table::{Column, Kind, arrow};
/// let columns = [Column::new("force", Kind::Float).with_unit("N")];
/// let schema = arrow::schema(&columns, &[("program".into(), "nply".into())]);
/// assert_eq!(schema.field(0).metadata()["unit"], "N");
/// assert_eq!(arrow::batch(&schema, &[vec![Some(0.5), None].into()])?.num_rows(), 2);
/// # Ok::<(), nply_sheet::table::TableError>(())
/// ```
#[must_use]
pub fn schema(columns: &[Column], metadata: &[(String, String)]) -> SchemaRef {
    let fields: Vec<Field> = columns.iter().map(field).collect();
    Arc::new(Schema::new_with_metadata(fields, metadata.iter().cloned().collect::<HashMap<String, String>>()))
}

/// A stretch of a table: as many columns as it has, all of one length.
///
/// # Errors
/// [`TableError`] where number, kinds or lengths of the columns do not fit.
pub fn batch(schema: &SchemaRef, chunk: &[Values]) -> Result<RecordBatch, TableError> {
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
        // where no cell is empty there is no list of empty cells: the same table gives the same bytes
        Values::Float(cells) => match cells.iter().copied().collect::<Option<Vec<f64>>>() {
            Some(dense) => Arc::new(Float64Array::from(dense)),
            None => Arc::new(cells.iter().copied().collect::<Float64Array>()),
        },
        Values::Integer(cells) => match cells.iter().copied().collect::<Option<Vec<i64>>>() {
            Some(dense) => Arc::new(Int64Array::from(dense)),
            None => Arc::new(cells.iter().copied().collect::<Int64Array>()),
        },
        Values::Boolean(cells) => Arc::new(cells.iter().copied().collect::<BooleanArray>()),
        Values::Text(cells) => Arc::new(cells.iter().map(Option::as_deref).collect::<StringArray>()),
        Values::Words(cells) => Arc::new(cells.iter().copied().collect::<StringArray>()),
        Values::Dense(cells) => Arc::new(Float64Array::from(cells.clone())),
        Values::Counts(cells) => Arc::new(Int64Array::from(cells.clone())),
        Values::Nothing(kind, length) => new_null_array(&data_type(*kind), *length),
    }
}

/// A Parquet file's columns, the number of its rows, and these in batches.
pub(super) fn open<R: Read + Seek + Send + 'static>(
    file: R,
    chunk: usize,
    skipped: u64,
) -> Result<(Vec<Column>, u64, ParquetRecordBatchReader), TableError> {
    let not_whole = |error: ParquetError| match refused(error) {
        TableError::Encode(error) => not_whole(&error),
        other => other,
    };
    let builder = ParquetRecordBatchReaderBuilder::try_new(Shared::new(file)?).map_err(not_whole)?;
    let columns = builder.schema().fields().iter().map(|field| {
        let unit = field.metadata().get("unit").map(String::as_str).unwrap_or_default();
        match values(&new_null_array(field.data_type(), 0)) {
            Some(none) => Ok(Column::new(field.name(), none.kind()).with_unit(unit)),
            None => Err(TableError::Unreadable(format!(
                "column {} holds {}, and what can be carried over are numbers, truth values and texts: leave it out",
                crate::quoted(field.name()),
                field.data_type()
            ))),
        }
    });
    let columns = columns.collect::<Result<Vec<Column>, TableError>>()?;
    let rows = builder.metadata().file_metadata().num_rows().unsigned_abs();
    let skipped = usize::try_from(skipped).unwrap_or(usize::MAX);
    let batches = builder.with_batch_size(chunk).with_offset(skipped).build().map_err(not_whole)?;
    Ok((columns, rows, batches))
}

/// What the library says of a damaged file may have the file's own bytes in it.
fn not_whole(error: &impl Display) -> TableError {
    let error = error.to_string().replace(|c: char| c.is_control(), "?");
    TableError::Unreadable(format!("it is no whole Parquet file ({error})"))
}

/// A batch's cells.
pub(super) fn cells(batch: &Result<RecordBatch, arrow_schema::ArrowError>) -> Result<Vec<Values>, TableError> {
    let batch = batch.as_ref().map_err(not_whole)?;
    let none = |array: &ArrayRef| Values::Nothing(Kind::Text, array.len());
    Ok(batch.columns().iter().map(|array| values(array).unwrap_or_else(|| none(array))).collect())
}

/// Numbers, truth values and texts of any width as ours.
pub(crate) fn values(array: &ArrayRef) -> Option<Values> {
    macro_rules! floats {
        ($kind:ty) => {{
            let array = array.as_primitive::<$kind>();
            if array.null_count() == 0 {
                Values::Dense(array.values().iter().map(|value| *value as f64).collect())
            } else {
                Values::Float(array.iter().map(|value| value.map(|value| value as f64)).collect())
            }
        }};
    }
    macro_rules! integers {
        ($kind:ty) => {
            Values::Integer(
                array
                    .as_primitive::<$kind>()
                    .iter()
                    .map(|value| value.and_then(|value| i64::try_from(value).ok()))
                    .collect(),
            )
        };
    }
    fn texts<'t>(texts: impl Iterator<Item = Option<&'t str>>) -> Values {
        Values::Text(texts.map(|text| text.map(str::to_owned)).collect())
    }
    Some(match array.data_type() {
        DataType::Float64 => floats!(Float64Type),
        DataType::Float32 => floats!(Float32Type),
        DataType::Int64 => integers!(Int64Type),
        DataType::Int32 => integers!(Int32Type),
        DataType::Int16 => integers!(Int16Type),
        DataType::Int8 => integers!(Int8Type),
        DataType::UInt64 => integers!(UInt64Type),
        DataType::UInt32 => integers!(UInt32Type),
        DataType::UInt16 => integers!(UInt16Type),
        DataType::UInt8 => integers!(UInt8Type),
        DataType::Boolean => Values::Boolean(array.as_boolean().iter().collect()),
        DataType::Utf8 => texts(array.as_string::<i32>().iter()),
        DataType::LargeUtf8 => texts(array.as_string::<i64>().iter()),
        DataType::Utf8View => texts(array.as_string_view().iter()),
        DataType::Null => Values::Nothing(Kind::Text, array.len()),
        _ => return None,
    })
}
