//! VTK legacy files, text or binary: `POLYDATA` with `LINES`, or `UNSTRUCTURED_GRID` with lines among its cells.

use nply::geometry::Vector;

use super::cells::{Cell, curves};
use super::scalar::Scalar;
use super::text::{Source, counted, counted_is, number};
use super::{Found, ReadError};
use crate::quoted;

/// VTK's numbers for a line and a polyline.
pub(super) const LINE: i128 = 3;
pub(super) const POLYLINE: i128 = 4;

/// A place in the file and how numbers stand in it.
struct Cursor<'s, 'b> {
    source: &'s Source<'b>,
    at: usize,
    binary: bool,
}

/// Lines become curves; faces, vertices and data are left out.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut cursor = Cursor { source, at: 0, binary: false };
    if !cursor.line().starts_with(b"# vtk DataFile Version") {
        return Err(source.at_byte(0, "it does not begin as a VTK file does, with `# vtk DataFile Version`"));
    }
    let _title = cursor.line();
    let start = cursor.at;
    cursor.binary = match cursor.word().to_ascii_uppercase().as_str() {
        "ASCII" => false,
        "BINARY" => true,
        _ => return Err(cursor.wants(start, "ASCII or BINARY")),
    };
    let mut grid = Grid::default();
    loop {
        let start = cursor.at;
        let keyword = cursor.word().to_ascii_uppercase();
        match keyword.as_str() {
            "" | "POINT_DATA" | "CELL_DATA" => break,
            "DATASET" => {
                let start = cursor.at;
                let kind = cursor.word().to_ascii_uppercase();
                if !["POLYDATA", "UNSTRUCTURED_GRID"].contains(&kind.as_str()) {
                    let message = format!("a dataset of {}; POLYDATA or UNSTRUCTURED_GRID are wanted", quoted(&kind));
                    return Err(source.at_byte(start, message));
                }
            }
            "POINTS" => grid.read_points(&mut cursor)?,
            "LINES" | "CELLS" => grid.cells = cursor.cells()?,
            "VERTICES" | "POLYGONS" | "TRIANGLE_STRIPS" => {
                grid.left_out += cursor.cells()?.len();
            }
            "CELL_TYPES" => {
                let count = cursor.count("the number of cells")?;
                cursor.end_line();
                grid.types = Some(cursor.wholes(count, Scalar::Signed(4))?);
            }
            "METADATA" => {
                cursor.end_line();
                while !cursor.line().trim_ascii().is_empty() {}
            }
            "FIELD" => cursor.skip_field()?,
            _ => return Err(cursor.wants(start, "POINTS, LINES or another keyword of the format")),
        }
    }
    grid.curves(source)
}

/// Points and lists of their numbers.
#[derive(Default)]
pub(super) struct Grid {
    pub(super) points: Vec<Vector>,
    pub(super) cells: Vec<Vec<i128>>,
    /// kinds of the cells, in an unstructured grid
    pub(super) types: Option<Vec<i128>>,
    pub(super) left_out: usize,
}

impl Grid {
    fn read_points(&mut self, cursor: &mut Cursor<'_, '_>) -> Result<(), ReadError> {
        let count = cursor.count("the number of points")?;
        let start = cursor.at;
        let name = cursor.word().to_ascii_lowercase();
        let Some(scalar) = Scalar::of_legacy(&name) else {
            return Err(cursor.wants(start, "the type of the coordinates, such as float or double"));
        };
        cursor.end_line();
        self.points = cursor.points(count, scalar)?;
        Ok(())
    }

    /// Cells that are lines, as curves.
    pub(super) fn curves(self, source: &Source<'_>) -> Result<Found, ReadError> {
        let Self { points, cells, types, mut left_out } = self;
        let line =
            |i: usize| types.as_ref().is_none_or(|types| [LINE, POLYLINE].map(Some).contains(&types.get(i).copied()));
        let mut lines = Vec::new();
        for (i, cell) in cells.iter().enumerate() {
            if !line(i) {
                left_out += 1;
                continue;
            }
            let at = |number: &i128| {
                usize::try_from(*number).ok().filter(|at| *at < points.len()).ok_or_else(|| {
                    let message = format!(
                        "cell {i} has point {number}; the file has {}, counted from 0",
                        counted(points.len(), "point")
                    );
                    source.whole(message)
                })
            };
            let numbers = cell.iter().map(at).collect::<Result<Vec<_>, _>>()?;
            if numbers.len() < 2 {
                return Err(source.whole(format!(
                    "cell {i} is a line of {}; two or more are wanted",
                    counted(numbers.len(), "point")
                )));
            }
            lines.push(Cell { points: numbers, name: None, line: None });
        }
        if lines.is_empty() {
            let besides = if left_out > 0 { "it has cells and no lines among them" } else { "it has no lines" };
            return Err(source.whole(format!("{besides}; polylines are wanted")));
        }
        let mut found = curves(&points, lines);
        if left_out > 0 {
            found.notes.push(format!("{} left out; only lines are read.", counted_is(left_out, "cell")));
        }
        Ok(found)
    }
}

impl<'b> Cursor<'_, 'b> {
    fn rest(&self) -> &'b [u8] {
        self.source.bytes.get(self.at..).unwrap_or(b"")
    }

    /// The rest of the line.
    fn line(&mut self) -> &'b [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|byte| *byte == b'\n');
        self.at += end.map_or(rest.len(), |end| end + 1);
        &rest[..end.unwrap_or(rest.len())]
    }

    /// To behind the end of a line whose last word was read: there binary data begin.
    fn end_line(&mut self) {
        self.line();
    }

    /// The next word, of whatever bytes; empty at the end.
    fn word(&mut self) -> String {
        let rest = self.rest();
        let start = rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
        let word = &rest[start..];
        let word = &word[..word.iter().position(u8::is_ascii_whitespace).unwrap_or(word.len())];
        self.at += start + word.len();
        String::from_utf8_lossy(word).into_owned()
    }

    /// What is wanted at a byte instead of what stands there.
    fn wants(&self, start: usize, what: &str) -> ReadError {
        let mut there = Cursor { source: self.source, at: start, binary: false };
        let word = there.word();
        let at = there.at - word.len().min(there.at);
        let read = if word.is_empty() { "the file ends".to_owned() } else { format!("{} stands", quoted(&word)) };
        self.source.at_byte(at, format!("{read} where {what} is wanted"))
    }

    fn count(&mut self, what: &str) -> Result<usize, ReadError> {
        let start = self.at;
        self.word().parse().map_err(|_| self.wants(start, what))
    }

    /// Binary data of so many numbers; checked before anything is set aside.
    fn take(&mut self, count: usize, scalar: Scalar) -> Result<&'b [u8], ReadError> {
        let rest = self.rest();
        let taken = count.checked_mul(scalar.size()).and_then(|size| rest.get(..size));
        let taken = taken.ok_or_else(|| {
            let message = format!(
                "{} of {} are announced here, and {} are left",
                counted(count, "number"),
                counted(scalar.size(), "byte"),
                counted(rest.len(), "byte")
            );
            self.source.at_byte(self.at, message)
        })?;
        self.at += taken.len();
        Ok(taken)
    }

    fn points(&mut self, count: usize, scalar: Scalar) -> Result<Vec<Vector>, ReadError> {
        let mut points = Vec::new();
        if self.binary {
            let start = self.at;
            let bytes = self.take(count.saturating_mul(3), scalar)?;
            for (i, point) in bytes.chunks_exact(3 * scalar.size()).enumerate() {
                let mut values = [0.0; 3];
                for (value, bytes) in values.iter_mut().zip(point.chunks_exact(scalar.size())) {
                    *value = scalar.double(bytes, true).ok_or_else(|| {
                        let at = start + i * 3 * scalar.size();
                        self.source.at_byte(at, format!("point {i} has a coordinate that is no finite number"))
                    })?;
                }
                points.push(values);
            }
        } else {
            for _ in 0..count {
                let mut values = [0.0; 3];
                for value in &mut values {
                    let start = self.at;
                    let word = self.word();
                    *value = number(&word).map_err(|why| {
                        if word.is_empty() {
                            self.wants(start, "a coordinate")
                        } else {
                            self.source.at_byte(start, format!("{why}; a coordinate is wanted here"))
                        }
                    })?;
                }
                points.push(values);
            }
        }
        Ok(points)
    }

    fn wholes(&mut self, count: usize, scalar: Scalar) -> Result<Vec<i128>, ReadError> {
        if self.binary {
            let bytes = self.take(count, scalar)?;
            return Ok(bytes.chunks_exact(scalar.size()).filter_map(|bytes| scalar.whole(bytes, true)).collect());
        }
        let mut numbers = Vec::new();
        for _ in 0..count {
            let start = self.at;
            numbers.push(self.word().parse().map_err(|_| self.wants(start, "a whole number"))?);
        }
        Ok(numbers)
    }

    /// Lists of points' numbers: counts and numbers in one row up to version 4, since version 5 offsets and numbers apart.
    fn cells(&mut self) -> Result<Vec<Vec<i128>>, ReadError> {
        let first = self.count("the number of cells")?;
        let size = self.count("the size of the list")?;
        self.end_line();
        let start = self.at;
        if !self.rest().trim_ascii_start().starts_with(b"OFFSETS") {
            let list = self.wholes(size, Scalar::Signed(4))?;
            return split(&list, first).ok_or_else(|| {
                let message =
                    format!("the list does not hold {}, each a count and so many numbers", counted(first, "cell"));
                self.source.at_byte(start, message)
            });
        }
        let offsets = self.array("OFFSETS", first)?;
        let connectivity = self.array("CONNECTIVITY", size)?;
        by_offsets(&offsets, &connectivity)
            .ok_or_else(|| self.source.at_byte(start, "the offsets do not rise from 0 to the end of the list"))
    }

    /// `OFFSETS vtktypeint64` and its numbers.
    fn array(&mut self, name: &str, count: usize) -> Result<Vec<i128>, ReadError> {
        let start = self.at;
        if self.word() != name {
            return Err(self.wants(start, name));
        }
        let start = self.at;
        let kind =
            Scalar::of_legacy(&self.word().to_ascii_lowercase()).filter(|kind| !matches!(kind, Scalar::Float(_)));
        let kind = kind.ok_or_else(|| self.wants(start, "a type of whole numbers"))?;
        self.end_line();
        self.wholes(count, kind)
    }

    /// Arrays that are not looked at.
    fn skip_field(&mut self) -> Result<(), ReadError> {
        let _name = self.word();
        for _ in 0..self.count("the number of arrays")? {
            let _name = self.word();
            let (components, tuples) = (self.count("the number of components")?, self.count("the number of tuples")?);
            let start = self.at;
            let kind = self.word().to_ascii_lowercase();
            self.end_line();
            let count = components.saturating_mul(tuples);
            match (self.binary, Scalar::of_legacy(&kind)) {
                (true, Some(scalar)) => drop(self.take(count, scalar)?),
                (true, None) => return Err(self.wants(start, "a type of numbers")),
                (false, _) => {
                    for _ in 0..count {
                        let start = self.at;
                        if self.word().is_empty() {
                            return Err(self.wants(start, "a number"));
                        }
                    }
                }
            }
        }
        Ok(())
    }
}

/// A count, so many numbers, a count, …
fn split(list: &[i128], cells: usize) -> Option<Vec<Vec<i128>>> {
    let mut found = Vec::new();
    let mut rest = list;
    while let Some((count, after)) = rest.split_first() {
        let count = usize::try_from(*count).ok()?;
        found.push(after.get(..count)?.to_vec());
        rest = &after[count..];
    }
    (found.len() == cells).then_some(found)
}

/// Cells between offsets, the first of which is 0.
fn by_offsets(offsets: &[i128], list: &[i128]) -> Option<Vec<Vec<i128>>> {
    if offsets.first().is_some_and(|first| *first != 0) {
        return None;
    }
    let ends = offsets.get(1..).unwrap_or(&[]);
    by_ends(ends, list)
}

/// Cells by where each ends in the list, as VTK XML has them.
pub(super) fn by_ends(ends: &[i128], list: &[i128]) -> Option<Vec<Vec<i128>>> {
    let mut start = 0;
    let mut found = Vec::new();
    for end in ends {
        let end = usize::try_from(*end).ok()?;
        found.push(list.get(start..end)?.to_vec());
        start = end;
    }
    (start == list.len()).then_some(found)
}
