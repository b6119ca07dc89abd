//! Tables of blocks: encoded on any thread, put one after the other into a file, and taken up again where a file was left.

use std::io::{self, Read, Seek, SeekFrom, Write};
use std::sync::Arc;

use super::{Column, TableError, Values, comma};

/// What a table is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Comma-separated values. It has no place for units and metadata.
    Csv,
    /// Parquet, compressed with Snappy; a row group for each block.
    #[cfg(feature = "parquet")]
    Parquet,
    /// An Arrow IPC file (Feather), as it lies in memory; a record batch for each block.
    #[cfg(feature = "parquet")]
    Arrow,
}

impl Format {
    /// The format of a file's ending.
    ///
    /// ```
    /// use nply_sheet::table::Format;
    /// assert_eq!((Format::of_ending("CSV"), Format::of_ending("xlsx")), (Some(Format::Csv), None));
    /// ```
    #[must_use]
    pub fn of_ending(ending: &str) -> Option<Self> {
        match ending.to_ascii_lowercase().as_str() {
            "csv" => Some(Self::Csv),
            #[cfg(feature = "parquet")]
            "parquet" => Some(Self::Parquet),
            #[cfg(feature = "parquet")]
            "arrow" | "feather" | "ipc" => Some(Self::Arrow),
            _ => None,
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            #[cfg(feature = "parquet")]
            Self::Parquet => "parquet",
            #[cfg(feature = "parquet")]
            Self::Arrow => "arrow",
        }
    }
}

/// Makes blocks of a table. Threads may share it; the same rows give the same bytes on each.
///
/// ```
/// use nply_sheet::table::{BlockFile, Column, Encoder, Format, Kind};
/// let encoder = Encoder::new(Format::Csv, vec![Column::new("force", Kind::Float)], &[])?;
/// let blocks = [encoder.block(&[vec![1.5].into()])?, encoder.block(&[vec![2.5].into()])?];
/// let mut file = BlockFile::new(&encoder, Vec::new())?;
/// for block in blocks {
///     file.append(block)?;
/// }
/// assert_eq!(file.finish()?, b"force\n1.5\n2.5\n");
/// # Ok::<(), nply_sheet::table::TableError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Encoder {
    columns: Arc<[Column]>,
    metadata: Arc<[(String, String)]>,
    format: Format,
    #[cfg(feature = "parquet")]
    arrow: super::arrow::Encoding,
}

/// Some rows of a table, encoded.
#[derive(Debug)]
pub struct Block {
    rows: usize,
    content: Content,
}

#[derive(Debug)]
enum Content {
    Csv(Vec<u8>),
    #[cfg(feature = "parquet")]
    Parquet(Vec<parquet::arrow::arrow_writer::ArrowColumnChunk>),
    #[cfg(feature = "parquet")]
    Arrow(arrow_array::RecordBatch),
}

impl Block {
    /// How many rows it has.
    #[must_use]
    pub const fn rows(&self) -> usize {
        self.rows
    }
}

impl Encoder {
    /// Of a table with these columns; `metadata` are the file's key-value pairs, where it has a place for them.
    ///
    /// # Errors
    /// [`TableError`] for no columns, and for two of one name.
    pub fn new(format: Format, columns: Vec<Column>, metadata: &[(String, String)]) -> Result<Self, TableError> {
        super::writer::check_names(&columns)?;
        #[cfg(feature = "parquet")]
        let arrow = super::arrow::Encoding::new(&columns, metadata)?;
        Ok(Self {
            columns: columns.into(),
            metadata: metadata.into(),
            format,
            #[cfg(feature = "parquet")]
            arrow,
        })
    }

    /// What it writes.
    #[must_use]
    pub const fn format(&self) -> Format {
        self.format
    }

    /// Rows as a block.
    ///
    /// # Errors
    /// [`TableError`] where number, kinds or lengths of the columns do not fit.
    pub fn block(&self, chunk: &[Values]) -> Result<Block, TableError> {
        super::writer::check(&self.columns, chunk)?;
        let rows = chunk.first().map_or(0, Values::len);
        let content = match self.format {
            Format::Csv => {
                let mut writer = comma::Writer::headless(Vec::new());
                writer.write(chunk)?;
                Content::Csv(writer.finish()?)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => Content::Parquet(self.arrow.columns(chunk)?),
            #[cfg(feature = "parquet")]
            Format::Arrow => Content::Arrow(self.arrow.batch(chunk)?),
        };
        Ok(Block { rows, content })
    }
}

/// Where a file stands behind a block: enough to take it up again there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// How many bytes the file has up to there.
    pub bytes: u64,
    /// What a format's end has to know of the block.
    pub tail: Vec<u8>,
}

/// A file of blocks that is being written.
pub struct BlockFile<W: Write + Send> {
    content: Writing<W>,
}

enum Writing<W: Write + Send> {
    Csv(Counted<W>),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::file::writer::SerializedFileWriter<W>>),
    #[cfg(feature = "parquet")]
    Arrow(Box<arrow_ipc::writer::FileWriter<Counted<W>>>),
}

/// Counts the bytes that go through.
#[derive(Debug)]
pub(super) struct Counted<W> {
    write: W,
    bytes: u64,
}

impl<W: Write> Write for Counted<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.write.write(bytes)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.write.flush()
    }
}

impl<W: Write + Send> BlockFile<W> {
    /// An empty one.
    ///
    /// # Errors
    /// [`TableError`] where nothing can be written.
    pub fn new(encoder: &Encoder, write: W) -> Result<Self, TableError> {
        let counted = |write| Counted { write, bytes: 0 };
        let content = match encoder.format {
            Format::Csv => {
                let mut write = counted(write);
                write.write_all(&comma::head(&encoder.columns)?)?;
                Writing::Csv(write)
            }
            #[cfg(feature = "parquet")]
            Format::Parquet => {
                Writing::Parquet(Box::new(super::arrow::parquet(&encoder.columns, &encoder.metadata, write)?))
            }
            #[cfg(feature = "parquet")]
            Format::Arrow => Writing::Arrow(Box::new(super::arrow::ipc(&encoder.arrow, counted(write))?)),
        };
        Ok(Self { content })
    }

    /// A new one that begins with the blocks of an old one up to the last of its marks: what it writes on is what the old one would have.
    /// Marks beyond the old file's end, or of a block that is not whole, end it there; how many were taken is told.
    ///
    /// # Errors
    /// [`TableError`] where reading or writing fails, and where the old file is none of these.
    pub fn resumed<R: Read + Seek + Send + 'static>(
        encoder: &Encoder,
        write: W,
        mut old: R,
        marks: &[Mark],
    ) -> Result<(Self, usize), TableError> {
        let length = old.seek(SeekFrom::End(0))?;
        old.seek(SeekFrom::Start(0))?;
        let whole = marks.iter().take_while(|mark| mark.bytes <= length).count();
        let marks = &marks[..whole];
        let mut file = Self::new(encoder, write)?;
        match &mut file.content {
            Writing::Csv(write) => {
                let head = write.bytes;
                let end = marks.last().map_or(head, |mark| mark.bytes);
                old.seek(SeekFrom::Start(head))?;
                io::copy(&mut old.take(end.saturating_sub(head)), write)?;
            }
            #[cfg(feature = "parquet")]
            Writing::Parquet(writer) => super::arrow::copy_row_groups(writer, old, marks)?,
            #[cfg(feature = "parquet")]
            Writing::Arrow(writer) => super::arrow::copy_batches(writer, old, marks)?,
        }
        Ok((file, whole))
    }

    /// Puts a block behind the others.
    ///
    /// # Errors
    /// [`TableError`] where writing fails, or the block is of another format; the file is of no use then beyond the last mark.
    pub fn append(&mut self, block: Block) -> Result<Mark, TableError> {
        match (&mut self.content, block.content) {
            (Writing::Csv(write), Content::Csv(bytes)) => {
                write.write_all(&bytes)?;
                Ok(Mark { bytes: write.bytes, tail: Vec::new() })
            }
            #[cfg(feature = "parquet")]
            (Writing::Parquet(writer), Content::Parquet(columns)) => super::arrow::append_row_group(writer, columns),
            #[cfg(feature = "parquet")]
            (Writing::Arrow(writer), Content::Arrow(batch)) => {
                super::arrow::append_batch(writer, &batch)?;
                Ok(Mark { bytes: writer.get_ref().bytes, tail: Vec::new() })
            }
            #[cfg(feature = "parquet")]
            _ => Err(TableError::Encode("the block is of another format than its file".into())),
        }
    }

    /// Hands on all that was put in, so that it stands in the file up to the last mark.
    ///
    /// # Errors
    /// [`TableError`] where writing fails.
    pub fn flush(&mut self) -> Result<(), TableError> {
        match &mut self.content {
            Writing::Csv(write) => write.flush()?,
            #[cfg(feature = "parquet")]
            Writing::Parquet(writer) => writer.flush()?,
            #[cfg(feature = "parquet")]
            Writing::Arrow(writer) => writer.get_mut().flush()?,
        }
        Ok(())
    }

    /// Where it goes.
    pub fn get_mut(&mut self) -> &mut W {
        match &mut self.content {
            Writing::Csv(write) => &mut write.write,
            #[cfg(feature = "parquet")]
            Writing::Parquet(writer) => writer.inner_mut(),
            #[cfg(feature = "parquet")]
            Writing::Arrow(writer) => &mut writer.get_mut().write,
        }
    }

    /// Ends the file and gives back where it went, flushed.
    ///
    /// # Errors
    /// [`TableError`] where writing fails.
    pub fn finish(self) -> Result<W, TableError> {
        let mut write = match self.content {
            Writing::Csv(write) => write.write,
            #[cfg(feature = "parquet")]
            Writing::Parquet(writer) => super::arrow::finish_parquet(*writer)?,
            #[cfg(feature = "parquet")]
            Writing::Arrow(writer) => super::arrow::finish_ipc(*writer)?.write,
        };
        write.flush()?;
        Ok(write)
    }
}
