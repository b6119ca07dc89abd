//! CSV.

use std::io::Write;

use super::{Column, TableError, Values};

#[derive(Debug)]
pub(super) struct Writer<W: Write> {
    csv: csv::Writer<W>,
}

impl<W: Write> Writer<W> {
    pub(super) fn new(columns: &[Column], write: W) -> Result<Self, TableError> {
        let mut csv = csv::Writer::from_writer(write);
        csv.write_record(columns.iter().map(|column| column.name.as_bytes())).map_err(refused)?;
        Ok(Self { csv })
    }

    /// Rows alone.
    pub(super) fn headless(write: W) -> Self {
        Self { csv: csv::Writer::from_writer(write) }
    }

    pub(super) fn write(&mut self, chunk: &[Values]) -> Result<(), TableError> {
        let rows = chunk.first().map_or(0, Values::len);
        let mut cell = String::new();
        for row in 0..rows {
            for values in chunk {
                cell.clear();
                text(values, row, &mut cell);
                self.csv.write_field(&cell).map_err(refused)?;
            }
            self.csv.write_record(None::<&[u8]>).map_err(refused)?;
        }
        Ok(())
    }

    pub(super) fn finish(self) -> Result<W, TableError> {
        self.csv.into_inner().map_err(|error| error.into_error().into())
    }
}

/// The line of names.
pub(super) fn head(columns: &[Column]) -> Result<Vec<u8>, TableError> {
    Writer::new(columns, Vec::new())?.finish()
}

/// A cell's text, put behind what is there.
fn text(values: &Values, row: usize, cell: &mut String) {
    use std::fmt::Write as _;
    // Writing to a String cannot fail.
    let _ = match values {
        Values::Float(cells) => cells[row].map_or(Ok(()), |value| write!(cell, "{value:?}")),
        Values::Integer(cells) => cells[row].map_or(Ok(()), |value| write!(cell, "{value}")),
        Values::Boolean(cells) => cells[row].map_or(Ok(()), |value| write!(cell, "{value}")),
        Values::Text(cells) => cells[row].as_deref().map_or(Ok(()), |text| cell.write_str(text)),
        Values::Words(cells) => cells[row].map_or(Ok(()), |text| cell.write_str(text)),
        Values::Dense(cells) => write!(cell, "{:?}", cells[row]),
        Values::Counts(cells) => write!(cell, "{}", cells[row]),
        Values::Nothing(..) => Ok(()),
    };
}

fn refused(error: csv::Error) -> TableError {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => TableError::Write(error),
        other => TableError::Encode(format!("{other:?}").into()),
    }
}

#[cfg(test)]
mod tests {
    use crate::table::{Column, Kind, TableWriter, Values};

    #[test]
    fn what_is_written_reads_back() {
        let names = ["x", "count, of", "flag", "note"];
        let kinds = [Kind::Float, Kind::Integer, Kind::Boolean, Kind::Text];
        let columns = names.iter().zip(kinds).map(|(name, kind)| Column::new(*name, kind)).collect();
        let numbers = [0.1 + 0.2, -0.0, f64::MIN_POSITIVE / 3.0, f64::MAX, f64::NAN, f64::NEG_INFINITY];
        let mut table = TableWriter::csv(columns, Vec::new()).unwrap();
        for number in numbers {
            let chunk: [Values; 4] = [
                vec![Some(number), None].into(),
                vec![Some(i64::MIN), None].into(),
                vec![Some(true), None].into(),
                vec![Some("a \"b\",\nc".to_owned()), None].into(),
            ];
            table.write_chunk(&chunk).unwrap();
        }
        let bytes = table.finish().unwrap();
        let mut reader = csv::Reader::from_reader(bytes.as_slice());
        assert_eq!(reader.headers().unwrap(), names.to_vec());
        let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
        for (pair, number) in rows.chunks(2).zip(numbers) {
            let read: f64 = pair[0][0].parse().unwrap();
            assert!(read.to_bits() == number.to_bits() || (read.is_nan() && number.is_nan()), "{number}");
            assert_eq!((&pair[0][1], &pair[0][2], &pair[0][3]), ("-9223372036854775808", "true", "a \"b\",\nc"));
            assert_eq!(pair[1], ["", "", "", ""].to_vec());
        }
        assert_eq!(rows.len(), 2 * numbers.len());
    }
}
