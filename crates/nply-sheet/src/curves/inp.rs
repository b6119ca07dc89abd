//! Abaqus' and CalculiX' input: beams and trusses of `*ELEMENT` over the nodes of `*NODE`.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use nply::geometry::Vector;

use super::cells::{Cell, join};
use super::text::{Line, Source, Word, counted, counted_is};
use super::{Draft, Found, ReadError};
use crate::quoted;

/// What the lines below a keyword are.
enum Below {
    Nodes,
    /// The number of the block of line elements, and of which kind they are.
    Lines(usize, Kind),
    /// Elements that are no lines.
    Others,
    /// Another system of coordinates, if there are numbers.
    System,
    Nothing,
}

/// Line elements by the beginning of their type, and how many nodes they have along them. What follows it (H, R, OS, …) says how they are
/// worked out, and changes none.
#[derive(Clone, Copy)]
struct Kind {
    name: &'static str,
    nodes: usize,
}

/// Linear and cubic beams and linear trusses have two nodes, quadratic ones three (Abaqus' library of beam elements; trusses from memory).
const KINDS: [Kind; 10] = [
    Kind { name: "B21", nodes: 2 },
    Kind { name: "B22", nodes: 3 },
    Kind { name: "B23", nodes: 2 },
    Kind { name: "B31", nodes: 2 },
    Kind { name: "B32", nodes: 3 },
    Kind { name: "B33", nodes: 2 },
    Kind { name: "T2D2", nodes: 2 },
    Kind { name: "T2D3", nodes: 3 },
    Kind { name: "T3D2", nodes: 2 },
    Kind { name: "T3D3", nodes: 3 },
];

/// Keywords that make or move nodes or elements, and what they do: the curves that are read without them are none of the model's.
const NOT_FOLLOWED: [(&str, &str); 6] = [
    ("NGEN", "makes nodes"),
    ("NFILL", "makes nodes"),
    ("NCOPY", "makes nodes"),
    ("NMAP", "moves nodes"),
    ("ELGEN", "makes elements"),
    ("ELCOPY", "makes elements"),
];

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
    let mut elements: HashSet<u64> = HashSet::new();
    let (mut below, mut radius, mut others, mut oriented) = (Below::Nothing, None, 0_usize, 0_usize);
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        let text = source.text(line)?;
        // the first letter that is no blank makes a keyword or a comment (Abaqus' syntax rules)
        let begin = text.trim_start();
        if let Some(comment) = begin.strip_prefix("**") {
            radius = comment.trim().strip_prefix("radius ").and_then(|radius| super::text::number(radius.trim()).ok());
            continue;
        }
        if let Some(keyword) = begin.strip_prefix('*') {
            let keyword = whole_keyword(source, keyword, &mut lines)?;
            let parameters: Vec<(String, &str)> = keyword.split(',').map(parameter).collect();
            let parameter = |name: &str| parameters.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
            let keyword = parameters.first().map_or("", |(keyword, _)| keyword.as_str());
            below = match keyword {
                "NODE" | "ELEMENT" if parameter("INPUT").is_some() => {
                    return Err(
                        source.at_line(line.number, "its lines are in another file, which is not read: put them here")
                    );
                }
                "NODE" if parameter("SYSTEM").is_some_and(|system| !system.starts_with(['R', 'r'])) => {
                    let message =
                        "its nodes are in cylindrical or spherical coordinates, which are not read: x, y, z are wanted";
                    return Err(source.at_line(line.number, message));
                }
                "NODE" => Below::Nodes,
                "SYSTEM" => Below::System,
                "ELEMENT" => match kind(parameter("TYPE").unwrap_or("")) {
                    Some(kind) => {
                        let name = parameter("ELSET").filter(|name| !name.is_empty()).map(str::to_owned);
                        let diameter = radius.map(|radius: f64| 2.0 * radius);
                        let diameter = diameter.filter(|diameter| *diameter > 0.0 && *diameter < f64::INFINITY);
                        blocks.push(Block { name, diameter, pieces: Vec::new() });
                        Below::Lines(blocks.len() - 1, kind)
                    }
                    None => Below::Others,
                },
                "INCLUDE" => {
                    return Err(source.at_line(line.number, "another file is included, which is not read: put it here"));
                }
                "INSTANCE" => {
                    let message = "parts are put together here; one flat list of nodes and elements is wanted";
                    return Err(source.at_line(line.number, message));
                }
                _ => match NOT_FOLLOWED.into_iter().find(|(known, _)| *known == keyword) {
                    Some((known, does)) => {
                        let message =
                            format!("`*{known}` {does}, which is not followed: write all nodes and elements out");
                        return Err(source.at_line(line.number, message));
                    }
                    None => Below::Nothing,
                },
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
            Below::Lines(block, kind) => {
                let Element { number, nodes, is_oriented } = element(source, line, text, kind, &at_number)?;
                if !elements.insert(number) {
                    return Err(source.at_line(line.number, format!("there is an element {number} above already")));
                }
                oriented += usize::from(is_oriented);
                let piece = |pair: &[usize]| Cell { points: pair.to_vec(), name: None, line: Some(line.number) };
                blocks[block].pieces.extend(nodes.windows(2).map(piece));
            }
            Below::Others => others += 1,
            Below::System => {
                let message =
                    "`*SYSTEM` moves the nodes below it, which is not followed: write them out where they are";
                return Err(source.at_line(line.number, message));
            }
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
    if oriented > 0 {
        let nodes = if oriented == 1 { "node" } else { "nodes" };
        let are = if oriented == 1 { "is" } else { "are" };
        found.notes.push(format!("The orientation {nodes} of {} {are} left out.", counted(oriented, "element")));
    }
    if others > 0 {
        found.notes.push(format!("{} left out.", counted_is(others, "other element")));
    }
    Ok(found)
}

/// A keyword line with all that it goes on with: behind a comma at its end stands the next line that is no comment, if it begins with a letter,
/// as parameters do, and coordinates and numbers do not.
fn whole_keyword<'b>(
    source: &Source<'b>,
    first: &'b str,
    lines: &mut (impl Iterator<Item = Line<'b>> + Clone),
) -> Result<Cow<'b, str>, ReadError> {
    let mut whole = Cow::Borrowed(first);
    while whole.trim_end().ends_with(',') {
        let mut ahead = lines.clone();
        let Some(next) = ahead.find(|line| !line.bytes.starts_with(b"**")) else { break };
        let next = source.text(next)?;
        if !next.trim_start().starts_with(|c: char| c.is_ascii_alphabetic()) {
            break;
        }
        whole.to_mut().push_str(next);
        *lines = ahead;
    }
    Ok(whole)
}

/// What kind of line elements a type is of, if of any.
fn kind(name: &str) -> Option<Kind> {
    let begins = |kind: &Kind| name.get(..kind.name.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(kind.name));
    KINDS.into_iter().find(begins)
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

/// A line element.
struct Element {
    number: u64,
    /// The places of its nodes in their order along it: two, or three with the middle one.
    nodes: Vec<usize>,
    /// Whether one more node stood behind them, which orients the section and does not lie on the wire.
    is_oriented: bool,
}

fn element(
    source: &Source<'_>,
    line: Line<'_>,
    text: &str,
    kind: Kind,
    at_number: &HashMap<u64, usize>,
) -> Result<Element, ReadError> {
    let mut words = fields(text);
    let number = label(source, line, words.next(), "the element's number")?;
    let nodes = words.map(|word| {
        let node = label(source, line, Some(word), "a node's number")?;
        let missing = || source.at_column(line, word.at, format!("there is no node {node} above"));
        at_number.get(&node).copied().ok_or_else(missing)
    });
    let mut nodes = nodes.collect::<Result<Vec<usize>, _>>()?;
    let is_oriented = nodes.len() == kind.nodes + 1;
    if is_oriented {
        nodes.pop();
    }
    if nodes.len() != kind.nodes {
        let Kind { name, nodes: wanted } = kind;
        let message = format!(
            "element {number} has {}; a {name} has {wanted}, and perhaps one more that orients it",
            counted(nodes.len(), "node")
        );
        return Err(source.at_line(line.number, message));
    }
    Ok(Element { number, nodes, is_oriented })
}

fn label(source: &Source<'_>, line: Line<'_>, word: Option<Word<'_>>, wanted: &str) -> Result<u64, ReadError> {
    let word = word.unwrap_or(Word { text: "", at: 0 });
    word.text.parse().map_err(|_| {
        source.at_column(line, word.at, format!("{} is no whole number; {wanted} is wanted here", quoted(word.text)))
    })
}
