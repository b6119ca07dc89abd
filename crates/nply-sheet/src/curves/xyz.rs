//! XYZ: how many, a comment, then `label x y z` a line; frame after frame.

use super::text::{Line, Source, counted, words};
use super::{Draft, Found, ReadError};
use crate::quoted;

/// Comments that are longer are no names.
const LONGEST_NAME: usize = 40;

/// Each frame is a curve, in the order of its lines.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut found = Found::default();
    let mut lines = source.lines();
    while let Some(first) = lines.find(|line| !line.bytes.trim_ascii().is_empty()) {
        let text = source.text(first)?.trim();
        let count: usize = text.parse().map_err(|_| {
            source.at_line(
                first.number,
                format!("{} is no count; the number of points that follow is wanted here", quoted(text)),
            )
        })?;
        let comment = match lines.next() {
            Some(line) => source.text(line)?.trim(),
            None => return Err(ends_early(source, first, count, 0)),
        };
        if let Some(at) = comment.find("Properties=") {
            let properties = &comment[at + "Properties=".len()..];
            if !properties.trim_start_matches('"').to_ascii_lowercase().starts_with("species:s:1:pos:r:3") {
                let message = "its columns are not label, x, y, z; `Properties=species:S:1:pos:R:3…` is wanted";
                return Err(source.at_line(first.number + 1, message));
            }
        }
        let name = (comment.chars().count() <= LONGEST_NAME && !comment.contains('=')).then(|| comment.to_owned());
        // what a count announces is not believed before it is there
        let mut frame = Draft { name, line: Some(first.number + 2), ..Draft::default() };
        for done in 0..count {
            let line = lines.next().ok_or_else(|| ends_early(source, first, count, done))?;
            frame.points.push(point(source, line)?);
        }
        found.drafts.push(frame);
    }
    if found.drafts.len() > 1 {
        found.notes.push(format!("Each of the {} is taken as a curve.", counted(found.drafts.len(), "frame")));
    }
    Ok(found)
}

fn point(source: &Source<'_>, line: Line<'_>) -> Result<[f64; 3], ReadError> {
    let text = source.text(line)?;
    let mut words = words(text).skip(1);
    let mut point = [0.0; 3];
    for (value, name) in point.iter_mut().zip(["x", "y", "z"]) {
        let word = words.next().ok_or_else(|| {
            source.at_line(line.number, format!("{} has no {name}; `label x y z` is wanted", quoted(text.trim())))
        })?;
        *value = source.number(line, word, name)?;
    }
    Ok(point)
}

fn ends_early(source: &Source<'_>, first: Line<'_>, count: usize, done: usize) -> ReadError {
    let message = format!("{} are announced here, and the file ends after {done}", counted(count, "point"));
    source.at_line(first.number, message)
}
