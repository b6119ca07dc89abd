//! Wavefront OBJ: `l` lines over `v` points.

use nply::geometry::Vector;

use super::cells::{Cell, curves};
use super::text::{Line, Source, Word, words};
use super::{Found, ReadError};
use crate::quoted;

/// Curves are the `l` elements; an `o` or `g` above names them. Faces and all else are left out.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut points: Vec<Vector> = Vec::new();
    let mut cells = Vec::new();
    let mut name: Option<String> = None;
    let mut faces = 0_usize;
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        let mut text = source.text(line)?.to_owned();
        while text.ends_with('\\') {
            text.pop();
            match lines.next() {
                Some(more) => text.push_str(source.text(more)?),
                None => break,
            }
        }
        let mut fields = words(&text);
        match fields.next().map(|word| word.text) {
            Some("v") => points.push(point(source, line, &mut fields)?),
            Some("o" | "g") => {
                let words: Vec<&str> = fields.map(|word| word.text).collect();
                name = Some(words.join(" ")).filter(|name| !name.is_empty());
            }
            Some("l") => {
                let at = fields.map(|word| index(source, line, word, points.len())).collect::<Result<Vec<_>, _>>()?;
                if at.len() < 2 {
                    return Err(source.at_line(line.number, "a line of less than two points; `l 1 2 3 …` is wanted"));
                }
                cells.push(Cell { points: at, name: name.clone(), line: Some(line.number) });
            }
            Some("f") => faces += 1,
            _ => {}
        }
    }
    if cells.is_empty() {
        let besides = if faces > 0 { "it has faces and no `l` lines" } else { "it has no `l` lines" };
        return Err(source.whole(format!("{besides}; centrelines as `v x y z` and `l 1 2 3 …` are wanted")));
    }
    let mut found = curves(&points, cells);
    if faces > 0 {
        found.notes.push(format!("{} left out.", super::text::counted_is(faces, "face")));
    }
    Ok(found)
}

fn point<'t>(
    source: &Source<'_>,
    line: Line<'_>,
    fields: &mut impl Iterator<Item = Word<'t>>,
) -> Result<Vector, ReadError> {
    let mut point = [0.0; 3];
    for (value, name) in point.iter_mut().zip(["x", "y", "z"]) {
        let word = fields.next();
        let word =
            word.ok_or_else(|| source.at_line(line.number, format!("there is no {name}; `v x y z` is wanted")))?;
        *value = source.number(line, word, name)?;
    }
    Ok(point)
}

/// A point's number, from 1, or from the last one backwards; what stands behind a slash belongs to a texture.
fn index(source: &Source<'_>, line: Line<'_>, word: Word<'_>, points: usize) -> Result<usize, ReadError> {
    let text = word.text.split('/').next().unwrap_or("");
    let number: i64 = text.parse().map_err(|_| {
        source.at_column(line, word.at, format!("{} is no point's number; a whole number is wanted", quoted(text)))
    })?;
    let at = if number > 0 {
        usize::try_from(number - 1).ok()
    } else {
        usize::try_from(number.unsigned_abs()).ok().filter(|back| *back > 0).and_then(|back| points.checked_sub(back))
    };
    at.filter(|at| *at < points).ok_or_else(|| {
        let above = super::text::counted(points, "point");
        source.at_column(line, word.at, format!("there is no point {number}; {above} stand above"))
    })
}
