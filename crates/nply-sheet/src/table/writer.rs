//! One writer, whatever the format.

use std::collections::BTreeSet;
use std::io::Write;

use super::{Column, TableError, Values, comma};
use crate::quoted;

/// Writes a table chunk by chunk; memory does not grow with the number of rows.
#[derive(Debug)]
pub struct TableWriter<W: Write + Send> {
    columns: Vec<Column>,
    format: Format<W>,
}

#[derive(Debug)]
enum Format<W: Write + Send> {
    Csv(comma::Writer<W>),
    #[cfg(feature = "parquet")]
    Parquet(super::parquet::Writer<W>),
}

impl<W: Write + Send> TableWriter<W> {
    /// CSV: a line of names, then a line a row. Numbers are the shortest text that reads back as the same double (`NaN`,
    /// `inf`); an empty cell is empty, as is an empty text. CSV has no place for units and metadata.
    ///
    /// # Errors
    /// [`TableError`] for no columns, for two of one name, and where nothing can be written.
    pub fn csv(columns: Vec<Column>, write: W) -> Result<Self, TableError> {
        check_names(&columns)?;
        Ok(Self { format: Format::Csv(comma::Writer::new(&columns, write)?), columns })
    }

    /// Parquet: row groups of up to 131 072 rows, compressed with Snappy. `metadata` are the file's key-value pairs; a
    /// column's unit is the metadata `unit` of its field.
    ///
    /// ```
    /// use nply_sheet::table::{Column, Kind, TableWriter};
    /// let columns = vec![Column::new("moment", Kind::Float).with_unit("N m")];
    /// let mut table = TableWriter::parquet(columns, &[("program", "nply")], Vec::new())?;
    /// table.write_chunk(&[vec![1e-20, 2e-20].into()])?;
    /// assert!(table.finish()?.starts_with(b"PAR1"));
    /// # Ok::<(), nply_sheet::table::TableError>(())
    /// ```
    ///
    /// # Errors
    /// [`TableError`] for no columns, for two of one name, and where nothing can be written.
    #[cfg(feature = "parquet")]
    pub fn parquet(columns: Vec<Column>, metadata: &[(&str, &str)], write: W) -> Result<Self, TableError> {
        check_names(&columns)?;
        Ok(Self { format: Format::Parquet(super::parquet::Writer::new(&columns, metadata, write)?), columns })
    }

    /// Adds rows, given as one stretch of each column in the columns' order. A chunk that does not fit is refused as a
    /// whole.
    ///
    /// # Errors
    /// [`TableError`] where number, kinds or lengths of the columns do not fit, and where writing fails; after a failed
    /// write the table is of no use.
    pub fn write_chunk(&mut self, chunk: &[Values]) -> Result<(), TableError> {
        check(&self.columns, chunk)?;
        match &mut self.format {
            Format::Csv(writer) => writer.write(chunk),
            #[cfg(feature = "parquet")]
            Format::Parquet(writer) => writer.write(chunk),
        }
    }

    /// Ends the table and gives back where it went, flushed. A table that is dropped instead lacks its end.
    ///
    /// # Errors
    /// [`TableError`] where writing fails.
    pub fn finish(self) -> Result<W, TableError> {
        match self.format {
            Format::Csv(writer) => writer.finish(),
            #[cfg(feature = "parquet")]
            Format::Parquet(writer) => writer.finish(),
        }
    }
}

/// Whether a chunk has the table's columns.
pub(super) fn check(columns: &[Column], chunk: &[Values]) -> Result<(), TableError> {
    if chunk.len() != columns.len() {
        return Err(TableError::ColumnCount { expected: columns.len(), found: chunk.len() });
    }
    let expected = chunk.first().map_or(0, Values::len);
    for (column, values) in columns.iter().zip(chunk) {
        let name = || quoted(&column.name);
        if values.kind() != column.kind {
            let (expected, found) = (column.kind.name(), values.kind().name());
            return Err(TableError::WrongKind { name: name(), expected, found });
        }
        if values.len() != expected {
            return Err(TableError::Length { name: name(), expected, found: values.len() });
        }
    }
    Ok(())
}

pub(super) fn check_names(columns: &[Column]) -> Result<(), TableError> {
    if columns.is_empty() {
        return Err(TableError::NoColumns);
    }
    let mut names = BTreeSet::new();
    match columns.iter().find(|column| !names.insert(&column.name)) {
        Some(column) => Err(TableError::SameName { name: quoted(&column.name) }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Kind;

    #[test]
    fn a_chunk_that_does_not_fit_is_refused_as_a_whole() {
        let columns = vec![Column::new("a", Kind::Float), Column::new("b", Kind::Text)];
        let mut table = TableWriter::csv(columns.clone(), Vec::new()).unwrap();
        let texts = |n: usize| Values::from(vec!["x".to_owned(); n]);
        let refused =
            [vec![vec![1.0].into()], vec![vec![1.0].into(), vec![1.0].into()], vec![vec![1.0, 2.0].into(), texts(1)]];
        let said: Vec<String> = refused.iter().map(|c| table.write_chunk(c).unwrap_err().to_string()).collect();
        assert_eq!(said[0], "The table has 2 columns, the chunk 1.");
        assert_eq!(said[1], "Column \"b\" is for texts, not for floating-point numbers.");
        assert_eq!(said[2], "Column \"b\" has 1 cells in this chunk, the first column 2.");
        table.write_chunk(&[vec![1.0].into(), texts(1)]).unwrap();
        assert_eq!(table.finish().unwrap(), b"a,b\n1.0,x\n");
        let twice = vec![columns[0].clone(), columns[0].clone()];
        assert!(matches!(TableWriter::csv(twice, Vec::new()), Err(TableError::SameName { .. })));
        assert!(matches!(TableWriter::csv(Vec::new(), Vec::new()), Err(TableError::NoColumns)));
    }

    #[test]
    fn a_closed_pipe_is_an_error() {
        let mut room = [0_u8; 4];
        let table = TableWriter::csv(vec![Column::new("longer", Kind::Float)], &mut room[..]);
        let end = table.and_then(TableWriter::finish);
        assert!(matches!(end, Err(TableError::Write(_))), "{end:?}");
    }
}
