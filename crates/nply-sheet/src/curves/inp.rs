//! Abaqus' and CalculiX' input: beams and trusses of `*ELEMENT` over the nodes of `*NODE`.

use std::collections::HashMap;

use nply::geometry::Vector;

use super::cells::{Cell, join};
use super::text::{Line, Source, Word, counted, counted_is};
use super::{Draft, Found, ReadError};
use crate::quoted;

/// What the lines below a keyword are.
enum Below {
    Nodes,
    /// The number of the block of line elements.
    Lines(usize),
    /// Elements that are no lines.
    Others,
    Nothing,
}

/// The elements below one `*ELEMENT`.
struct Block {
    name: Option<String>,
    diameter: Option<f64>,
    pieces: Vec<Cell>,
}

/// Curves are the chains of elements of each `*ELEMENT`, named by its set; a comment `** radius 2.1` just above it gives their radius, as in
/// the files that are written here. What `*BEAM SECTION` says is not taken: Abaqus means a radius by it, and CalculiX a diameter.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let mut found = Found::default();
    let mut at_number: HashMap<u64, usize> = HashMap::new();
    let mut points: Vec<Vector> = Vec::new();
    let mut blocks: Vec<Block> = Vec::new();
    let (mut below, mut radius, mut others) = (Below::Nothing, None, 0_usize);
    for line in source.lines() {
        let text = source.text(line)?;
        if let Some(comment) = text.strip_prefix("**") {
            radius = comment.trim().strip_prefix("radius ").and_then(|radius| super::text::number(radius.trim()).ok());
            continue;
        }
        if let Some(keyword) = text.strip_prefix('*') {
            let parameters: Vec<(String, &str)> = keyword.split(',').map(parameter).collect();
            let parameter = |name: &str| parameters.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
            let keyword = parameters.first().map_or("", |(keyword, _)| keyword.as_str());
            below = match keyword {
                "NODE" | "ELEMENT" if parameter("INPUT").is_some() => {
                    return Err(
                        source.at_line(line.number, "its lines are in another file, which is not read: put them here")
                    );
                }
                "NODE" => Below::Nodes,
                "ELEMENT" => match parameter("TYPE").unwrap_or("").to_ascii_uppercase() {
                    kind if kind.starts_with(['B', 'T']) => {
                        let name = parameter("ELSET").filter(|name| !name.is_empty()).map(str::to_owned);
                        let diameter = radius.filter(|radius| *radius > 0.0).map(|radius| 2.0 * radius);
                        blocks.push(Block { name, diameter, pieces: Vec::new() });
                        Below::Lines(blocks.len() - 1)
                    }
                    _ => Below::Others,
                },
                "INCLUDE" => {
                    return Err(source.at_line(line.number, "another file is included, which is not read: put it here"));
                }
                "INSTANCE" => {
                    let message = "parts are put together here; one flat list of nodes and elements is wanted";
                    return Err(source.at_line(line.number, message));
                }
                _ => Below::Nothing,
            };
            radius = None;
            continue;
        }
        if text.trim().is_empty() {
            continue;
        }
        match below {
            Below::Nodes => {
                let (number, point) = node(source, line, text)?;
                if at_number.insert(number, points.len()).is_some() {
                    return Err(source.at_line(line.number, format!("there is a node {number} above already")));
                }
                points.push(point);
            }
            Below::Lines(block) => {
                let nodes = element(source, line, text, &at_number)?;
                let piece = |pair: &[usize]| Cell { points: pair.to_vec(), name: None, line: Some(line.number) };
                blocks[block].pieces.extend(nodes.windows(2).map(piece));
            }
            Below::Others => others += 1,
            // what follows the first keyword is the heading
            Below::Nothing => {
                let unit = text.trim().strip_prefix("nply ").and_then(|said| said.rsplit_once("; coordinates in "));
                found.unit = found.unit.or_else(|| unit.map(|(_, unit)| unit.to_owned()));
            }
        }
    }
    // the files written here say so of what has no size
    found.unit = found.unit.filter(|unit| unit != "strand radii");
    for Block { name, diameter, pieces } in blocks {
        let draft = |cell: Cell| Draft {
            name: name.clone(),
            points: cell.points.iter().map(|at| points[*at]).collect(),
            diameter,
            line: cell.line,
        };
        found.drafts.extend(join(pieces).into_iter().map(draft));
    }
    if found.drafts.is_empty() {
        let besides = if points.is_empty() { "it has no `*NODE`" } else { "it has no beams or trusses" };
        return Err(source.whole(format!("{besides}; centrelines as `*NODE` and `*ELEMENT, TYPE=B31` are wanted")));
    }
    if others > 0 {
        found.notes.push(format!("{} left out.", counted_is(others, "other element")));
    }
    Ok(found)
}

/// `NAME=value`, the name in capitals without blanks.
fn parameter(text: &str) -> (String, &str) {
    let (name, value) = text.split_once('=').unwrap_or((text, ""));
    (name.trim().to_ascii_uppercase(), value.trim().trim_matches('"'))
}

/// The fields of a line, between commas, without a last one that is empty.
fn fields(text: &str) -> impl Iterator<Item = Word<'_>> {
    let text = text.trim_end().strip_suffix(',').unwrap_or(text);
    let mut at = 0;
    text.split(',').map(move |field| {
        let blanks = field.len() - field.trim_start().len();
        let word = Word { text: field.trim(), at: at + blanks };
        at += field.len() + 1;
        word
    })
}

/// A number and up to three coordinates; what is not written is 0.
fn node(source: &Source<'_>, line: Line<'_>, text: &str) -> Result<(u64, Vector), ReadError> {
    let mut words = fields(text);
    let number = label(source, line, words.next(), "the node's number")?;
    let mut point = [0.0; 3];
    for ((value, name), word) in point.iter_mut().zip(["x", "y", "z"]).zip(words) {
        *value = if word.text.is_empty() { 0.0 } else { source.number(line, word, name)? };
    }
    Ok((number, point))
}

/// The places of an element's nodes in their order along it: two, or three with the middle one.
fn element(
    source: &Source<'_>,
    line: Line<'_>,
    text: &str,
    at_number: &HashMap<u64, usize>,
) -> Result<Vec<usize>, ReadError> {
    let mut words = fields(text);
    let number = label(source, line, words.next(), "the element's number")?;
    let nodes = words.map(|word| {
        let node = label(source, line, Some(word), "a node's number")?;
        let missing = || source.at_column(line, word.at, format!("there is no node {node} above"));
        at_number.get(&node).copied().ok_or_else(missing)
    });
    let nodes = nodes.collect::<Result<Vec<usize>, _>>()?;
    if !matches!(nodes.len(), 2 | 3) {
        let message = format!("element {number} has {}; 2 or 3 are wanted", counted(nodes.len(), "node"));
        return Err(source.at_line(line.number, message));
    }
    Ok(nodes)
}

fn label(source: &Source<'_>, line: Line<'_>, word: Option<Word<'_>>, wanted: &str) -> Result<u64, ReadError> {
    let word = word.unwrap_or(Word { text: "", at: 0 });
    word.text.parse().map_err(|_| {
        source.at_column(line, word.at, format!("{} is no whole number; {wanted} is wanted here", quoted(word.text)))
    })
}
