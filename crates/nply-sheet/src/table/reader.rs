//! Tables of others, read chunk by chunk.

use std::io::{BufReader, Read, Seek};

use super::{Column, Format, Kind, TableError, Values};

/// Reads a table chunk by chunk; memory does not grow with the number of rows.
pub struct TableReader<R: Read + Seek + Send + 'static> {
    columns: Vec<Column>,
    rows: Option<u64>,
    chunk: usize,
    content: Reading<R>,
}

enum Reading<R> {
    Csv(Box<csv::Reader<BufReader<R>>>),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::arrow::arrow_reader::ParquetRecordBatchReader>),
}

impl<R: Read + Seek + Send + 'static> TableReader<R> {
    /// A table in CSV (with a line of names; all its cells are texts) or Parquet; `chunk` rows are read at a time, and the first `skipped`
    /// left out.
    ///
    /// # Errors
    /// [`TableError`] where it cannot be read, is none, or has columns that are neither numbers, truth values nor texts.
    ///
    /// ```
    /// use nply_sheet::table::{Format, TableReader, Values};
    /// let mut table = TableReader::open(Format::Csv, std::io::Cursor::new("pretwist,note\n-1,a\n0.5,\n"), 100, 1)?;
    /// assert_eq!(table.columns()[0].name, "pretwist");
    /// let Some(chunk) = table.next_chunk()? else { unreachable!() };
    /// assert_eq!(chunk, [Values::Text(vec![Some("0.5".into())]), Values::Text(vec![None])]);
    /// assert!(table.next_chunk()?.is_none());
    /// # Ok::<(), nply_sheet::table::TableError>(())
    /// ```
    pub fn open(format: Format, read: R, chunk: usize, skipped: u64) -> Result<Self, TableError> {
        let chunk = chunk.max(1);
        match format {
            Format::Csv => {
                let mut csv = csv::ReaderBuilder::new().flexible(true).from_reader(BufReader::new(read));
                let names = csv.headers().map_err(unreadable)?.clone();
                if names.iter().all(str::is_empty) {
                    let message = "it is empty: what is wanted is a line of names, and below it a line for each row";
                    return Err(TableError::Unreadable(message.to_owned()));
                }
                // some programs put the mark of byte order before a text
                let name = |name: &str| Column::new(name.trim_start_matches('\u{feff}').trim(), Kind::Text);
                let columns: Vec<Column> = names.iter().map(name).collect();
                super::writer::check_names(&columns)?;
                let mut reader = Self { columns, rows: None, chunk, content: Reading::Csv(Box::new(csv)) };
                let mut left = skipped;
                while left > 0 {
                    reader.chunk = usize::try_from(left).unwrap_or(usize::MAX).min(chunk);
                    let Some(cells) = reader.next_chunk()? else { break };
                    left -= cells.first().map_or(0, Values::len) as u64;
                }
                reader.chunk = chunk;
                Ok(reader)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => {
                let (columns, rows, batches) = super::arrow::open(read, chunk, skipped)?;
                super::writer::check_names(&columns)?;
                Ok(Self { columns, rows: Some(rows), chunk, content: Reading::Parquet(Box::new(batches)) })
            }
            #[cfg(feature = "parquet")]
            Format::Arrow => Err(TableError::Unreadable("rows are read from CSV and Parquet".to_owned())),
        }
    }

    /// Its columns.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// How many rows it has, skipped ones included, where it says so.
    #[must_use]
    pub const fn rows(&self) -> Option<u64> {
        self.rows
    }

    /// The next rows, a column each; none behind the last.
    ///
    /// # Errors
    /// [`TableError`] where reading fails, and for a line of CSV with more or fewer cells than there are names.
    pub fn next_chunk(&mut self) -> Result<Option<Vec<Values>>, TableError> {
        match &mut self.content {
            Reading::Csv(csv) => {
                let mut cells = vec![Vec::new(); self.columns.len()];
                let mut record = csv::StringRecord::new();
                let mut rows = 0;
                while rows < self.chunk && csv.read_record(&mut record).map_err(unreadable)? {
                    if record.len() != cells.len() {
                        let line = record.position().map_or(0, csv::Position::line);
                        return Err(TableError::Unreadable(format!(
                            "line {line} has {} cells, and the line of names {}",
                            record.len(),
                            cells.len()
                        )));
                    }
                    for (cells, cell) in cells.iter_mut().zip(&record) {
                        cells.push((!cell.is_empty()).then(|| cell.to_owned()));
                    }
                    rows += 1;
                }
                Ok((rows > 0).then(|| cells.into_iter().map(Values::Text).collect()))
            }
            #[cfg(feature = "parquet")]
            Reading::Parquet(batches) => batches.next().map(|batch| super::arrow::cells(&batch)).transpose(),
        }
    }
}

fn unreadable(error: csv::Error) -> TableError {
    let line = error.position().map_or(0, csv::Position::line);
    match error.into_kind() {
        csv::ErrorKind::Io(error) => TableError::Write(error),
        csv::ErrorKind::Utf8 { .. } => {
            TableError::Unreadable(format!("line {line} is not UTF-8 text: save the file as UTF-8 and try again"))
        }
        other => TableError::Unreadable(format!("{other:?}")),
    }
}
