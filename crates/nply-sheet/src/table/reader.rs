//! Tables of others, read chunk by chunk.

use std::io::{self, BufReader, Read, Seek};
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, AtomicU64, Ordering};

use super::{Column, Format, Kind, TableError, Values};

/// Reads a table chunk by chunk; memory does not grow with the number of rows.
pub struct TableReader<R: Read + Seek + Send + 'static> {
    columns: Vec<Column>,
    rows: Option<u64>,
    chunk: usize,
    content: Reading<R>,
}

enum Reading<R> {
    Csv {
        csv: Box<csv::Reader<BufReader<Rationed<R>>>>,
        ration: Ration,
        /// whether the last row so far ends in a cell of several lines
        ends_broken: bool,
    },
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::arrow::arrow_reader::ParquetRecordBatchReader>),
}

/// No row of a table is longer, in bytes (1 MiB): a quotation mark that nobody closes makes one row of all the rest.
const LONGEST_ROW: u64 = 1 << 20;
/// Rows that are read at once are not longer together (64 MiB), but for the last.
const LONGEST_CHUNK: u64 = 64 << 20;

/// How many bytes may still be read, and the last one that was and ends no line.
#[derive(Clone, Debug, Default)]
struct Ration {
    left: Arc<AtomicU64>,
    last: Arc<AtomicU8>,
}

impl Ration {
    fn renew(&self) {
        self.left.store(LONGEST_ROW, Ordering::Relaxed);
    }
}

/// Gives no more bytes than it has a ration of.
struct Rationed<R> {
    read: R,
    ration: Ration,
}

impl<R: Read> Read for Rationed<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let left = self.ration.left.load(Ordering::Relaxed);
        if left == 0 {
            return Err(io::Error::new(io::ErrorKind::FileTooLarge, "a row of more than 1 MiB is not taken"));
        }
        let given = self.read.read(bytes)?;
        self.ration.left.store(left.saturating_sub(given as u64), Ordering::Relaxed);
        if let Some(last) = bytes[..given].iter().rev().find(|byte| !b"\r\n".contains(byte)) {
            self.ration.last.store(*last, Ordering::Relaxed);
        }
        Ok(given)
    }
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
                let ration = Ration::default();
                ration.renew();
                let read = BufReader::new(Rationed { read, ration: ration.clone() });
                let mut csv = csv::ReaderBuilder::new().flexible(true).from_reader(read);
                let names = csv.headers().map_err(unreadable)?.clone();
                if names.iter().all(str::is_empty) {
                    let message = "it is empty: what is wanted is a line of names, and below it a line for each row";
                    return Err(TableError::Unreadable(message.to_owned()));
                }
                // some programs put the mark of byte order before a text
                let name = |name: &str| Column::new(name.trim_start_matches('\u{feff}').trim(), Kind::Text);
                let columns: Vec<Column> = names.iter().map(name).collect();
                super::writer::check_names(&columns)?;
                let mut reader = Self {
                    columns,
                    rows: None,
                    chunk,
                    content: Reading::Csv { csv: Box::new(csv), ration, ends_broken: false },
                };
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
                let (columns, rows, batches) = super::damaged::caught(|| super::arrow::open(read, chunk, skipped))?;
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

    /// The next rows, a column each; none behind the last. Of rows that are very long, fewer come at once than were asked for.
    ///
    /// # Errors
    /// [`TableError`] where reading fails, and for a line of CSV with more or fewer cells than there are names, or of more than 1 MiB.
    pub fn next_chunk(&mut self) -> Result<Option<Vec<Values>>, TableError> {
        match &mut self.content {
            Reading::Csv { csv, ration, ends_broken } => {
                let begin = csv.position().byte();
                let mut cells = vec![Vec::new(); self.columns.len()];
                let mut record = csv::StringRecord::new();
                let mut rows = 0;
                while rows < self.chunk && csv.position().byte() - begin < LONGEST_CHUNK {
                    ration.renew();
                    if !csv.read_record(&mut record).map_err(unreadable)? {
                        // a mark that nobody closed has made one cell of all that was left
                        if *ends_broken && ration.last.load(Ordering::Relaxed) != b'"' {
                            return Err(TableError::Unreadable("a quotation mark is not closed at its end".to_owned()));
                        }
                        break;
                    }
                    *ends_broken = record.iter().next_back().is_some_and(|cell| cell.contains('\n'));
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
            Reading::Parquet(batches) => super::damaged::caught(|| {
                // nothing is read on behind what cannot be read
                batches.next().map(|batch| super::arrow::cells(&batch)).transpose()
            }),
        }
    }
}

fn unreadable(error: csv::Error) -> TableError {
    let line = error.position().map_or(0, csv::Position::line);
    match error.into_kind() {
        csv::ErrorKind::Io(error) if error.kind() == io::ErrorKind::FileTooLarge => {
            TableError::Unreadable(format!("{error}; is a quotation mark not closed?"))
        }
        csv::ErrorKind::Io(error) => TableError::Write(error),
        csv::ErrorKind::Utf8 { .. } => {
            TableError::Unreadable(format!("line {line} is not UTF-8 text: save the file as UTF-8 and try again"))
        }
        other => TableError::Unreadable(format!("{other:?}")),
    }
}
