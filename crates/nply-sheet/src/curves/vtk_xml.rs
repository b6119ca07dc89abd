//! VTK XML files: lines of `PolyData` (VTP) and of `UnstructuredGrid` (VTU); data inline or appended, as text, base64 or raw bytes, plain or
//! compressed by zlib.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use nply::geometry::Vector;
use roxmltree::{Document, Node, ParsingOptions};

use super::scalar::Scalar;
use super::text::{Source, counted, number, words};
use super::vtk::{Grid, by_ends};
use super::{Found, ReadError};
use crate::quoted;

/// More elements than this are no file of polylines.
const MOST_ELEMENTS: u32 = 1 << 20;
/// zlib packs by a factor of 1032 at most, so that more cannot come out of what is there.
const PACKED: usize = 1032;

/// The document, and the bytes behind it.
struct File<'s, 'b> {
    source: &'s Source<'b>,
    big_endian: bool,
    /// bytes of the numbers in a block's header
    header: Scalar,
    compressed: bool,
    appended: Option<Appended<'b>>,
}

/// What stands in `AppendedData`, behind the underscore.
struct Appended<'b> {
    bytes: &'b [u8],
    base64: bool,
}

/// Lines become curves; all else is left out.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let (text, raw) = take_apart(source)?;
    let document = parse(source, &text)?;
    let root = document.root_element();
    if root.tag_name().name() != "VTKFile" {
        return Err(at(source, root, "the outermost element is not `VTKFile`"));
    }
    let appended = root.children().find(|node| node.has_tag_name("AppendedData")).and_then(|node| {
        Some(Appended { bytes: raw?, base64: node.attribute("encoding").is_some_and(|encoding| encoding == "base64") })
    });
    let compressed = match root.attribute("compressor") {
        None | Some("") => false,
        Some("vtkZLibDataCompressor") => true,
        Some(other) => {
            let message = format!("its data are compressed by {}; zlib or none is read", quoted(other));
            return Err(at(source, root, message));
        }
    };
    let header = match root.attribute("header_type") {
        None | Some("UInt32") => Scalar::Unsigned(4),
        Some("UInt64") => Scalar::Unsigned(8),
        Some(other) => {
            return Err(at(source, root, format!("a header_type of {}; UInt32 or UInt64 are known", quoted(other))));
        }
    };
    let big_endian = root.attribute("byte_order") == Some("BigEndian");
    let file = File { source, big_endian, header, compressed, appended };
    let kind = root.attribute("type").unwrap_or("");
    if !["PolyData", "UnstructuredGrid"].contains(&kind) {
        return Err(at(
            source,
            root,
            format!("a file of type {}; PolyData or UnstructuredGrid are wanted", quoted(kind)),
        ));
    }
    let mut whole = Grid { types: (kind == "UnstructuredGrid").then(Vec::new), ..Grid::default() };
    for piece in root.descendants().filter(|node| node.has_tag_name("Piece")) {
        file.piece(piece, &mut whole)?;
    }
    whole.curves(source)
}

fn parse<'t>(source: &Source<'_>, text: &'t str) -> Result<Document<'t>, ReadError> {
    let options = ParsingOptions { nodes_limit: MOST_ELEMENTS, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let line = error.pos().row as usize;
        source.at_line(line, format!("this is not XML: {}", error.to_string().replace('\n', " ")))
    })
}

/// The XML without the raw bytes that may stand in its `AppendedData`, and those bytes.
fn take_apart<'b>(source: &Source<'b>) -> Result<(String, Option<&'b [u8]>), ReadError> {
    let bytes = source.bytes;
    let find = |from: usize, what: &[u8]| {
        let rest = bytes.get(from..)?;
        rest.windows(what.len()).position(|window| window == what).map(|at| from + at)
    };
    let as_text = |bytes: &[u8]| {
        core::str::from_utf8(bytes).map(str::to_owned).map_err(|error| {
            source.at_byte(error.valid_up_to(), "this is no text in UTF-8, as XML is outside of its appended data")
        })
    };
    let Some(opened) = find(0, b"<AppendedData") else { return Ok((as_text(bytes)?, None)) };
    let Some(inside) = find(opened, b">").map(|end| end + 1) else { return Ok((as_text(bytes)?, None)) };
    let blanks = bytes[inside..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    if bytes.get(inside + blanks) != Some(&b'_') {
        return Err(source.at_byte(inside, "the appended data do not begin with an underscore"));
    }
    let start = inside + blanks + 1;
    // the last such end: the bytes may hold anything
    let end = b"</AppendedData>";
    let closed = bytes[start..].windows(end.len()).rposition(|window| window == end).map(|at| start + at);
    let Some(closed) = closed else {
        return Err(source.at_byte(bytes.len(), "the file ends within its appended data"));
    };
    let mut text = as_text(&bytes[..inside])?;
    text.push_str(&as_text(&bytes[closed..])?);
    Ok((text, Some(&bytes[start..closed])))
}

/// At a node's line.
fn at(source: &Source<'_>, node: Node<'_, '_>, message: impl Into<String>) -> ReadError {
    let line = node.document().text_pos_at(node.range().start).row as usize;
    source.at_line(line, message)
}

impl File<'_, '_> {
    /// Adds a piece's points and lines.
    fn piece(&self, piece: Node<'_, '_>, whole: &mut Grid) -> Result<(), ReadError> {
        let part = |name: &str| piece.children().find(|node| node.has_tag_name(name));
        let count = |name: &str| -> Result<usize, ReadError> {
            let Some(text) = piece.attribute(name) else { return Ok(0) };
            text.trim()
                .parse()
                .map_err(|_| self.at(piece, format!("{name} is {}; a whole number is wanted", quoted(text))))
        };
        let points = count("NumberOfPoints")?;
        let base = whole.points.len();
        if let Some(array) = part("Points").and_then(|node| node.children().find(|node| node.has_tag_name("DataArray")))
        {
            whole.points.extend(self.points(array, points)?);
        }
        if whole.points.len() - base != points {
            let message =
                format!("the piece has {}; {points} are announced", counted(whole.points.len() - base, "point"));
            return Err(self.at(piece, message));
        }
        let (name, cells) = if whole.types.is_some() { ("Cells", "NumberOfCells") } else { ("Lines", "NumberOfLines") };
        let cells = count(cells)?;
        for other in ["NumberOfVerts", "NumberOfStrips", "NumberOfPolys"] {
            whole.left_out = whole.left_out.saturating_add(count(other)?);
        }
        let Some(node) = part(name).filter(|_| cells > 0) else { return Ok(()) };
        let array = |name: &str| -> Result<Vec<i128>, ReadError> {
            let found =
                node.children().find(|child| child.has_tag_name("DataArray") && child.attribute("Name") == Some(name));
            let found = found.ok_or_else(|| self.at(node, format!("it has no array {name}")))?;
            self.wholes(found)
        };
        let (connectivity, offsets) = (array("connectivity")?, array("offsets")?);
        if offsets.len() != cells {
            let message = format!("it has {}; {cells} are announced", counted(offsets.len(), "offset"));
            return Err(self.at(node, message));
        }
        let lists = by_ends(&offsets, &connectivity)
            .ok_or_else(|| self.at(node, "the offsets do not rise to the length of the connectivity"))?;
        // a piece counts its own points
        let own = |number: i128| (0..points as i128).contains(&number);
        if let Some(number) = lists.iter().flatten().find(|number| !own(**number)) {
            let message =
                format!("a cell has point {number}; the piece has {}, counted from 0", counted(points, "point"));
            return Err(self.at(node, message));
        }
        whole
            .cells
            .extend(lists.into_iter().map(|list| list.into_iter().map(|number| number + base as i128).collect()));
        if let Some(types) = &mut whole.types {
            let own = array("types")?;
            if own.len() != cells {
                return Err(self.at(node, format!("it has {}; {cells} are announced", counted(own.len(), "type"))));
            }
            types.extend(own);
        }
        Ok(())
    }

    fn at(&self, node: Node<'_, '_>, message: impl Into<String>) -> ReadError {
        at(self.source, node, message)
    }

    fn points(&self, array: Node<'_, '_>, points: usize) -> Result<Vec<Vector>, ReadError> {
        if array.attribute("NumberOfComponents").is_some_and(|components| components.trim() != "3") {
            return Err(self.at(array, "points have three components"));
        }
        let values: Vec<f64> = match self.data(array)? {
            Data::Text(text) => {
                let value =
                    |word: &str| number(word).map_err(|why| self.at(array, format!("{why}; a coordinate is wanted")));
                words(text).map(|word| value(word.text)).collect::<Result<_, _>>()?
            }
            Data::Binary(bytes, scalar) => {
                let value = |(i, bytes)| {
                    let wrong = || self.at(array, format!("point {} has a coordinate that is no finite number", i / 3));
                    scalar.double(bytes, self.big_endian).ok_or_else(wrong)
                };
                bytes.chunks_exact(scalar.size()).enumerate().map(value).collect::<Result<_, _>>()?
            }
        };
        if Some(values.len()) != points.checked_mul(3) {
            let message = format!(
                "{} for {}; three each are wanted",
                counted(values.len(), "coordinate"),
                counted(points, "point")
            );
            return Err(self.at(array, message));
        }
        Ok(values.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect())
    }

    fn wholes(&self, array: Node<'_, '_>) -> Result<Vec<i128>, ReadError> {
        match self.data(array)? {
            Data::Text(text) => words(text)
                .map(|word| {
                    word.text.parse().map_err(|_| self.at(array, format!("{} is no whole number", quoted(word.text))))
                })
                .collect(),
            Data::Binary(bytes, scalar) => bytes
                .chunks_exact(scalar.size())
                .map(|bytes| {
                    scalar.whole(bytes, self.big_endian).ok_or_else(|| self.at(array, "whole numbers are wanted"))
                })
                .collect(),
        }
    }

    /// An array's numbers, still as they are written.
    fn data<'n>(&self, array: Node<'n, '_>) -> Result<Data<'n>, ReadError> {
        let kind = array.attribute("type").unwrap_or("");
        let scalar = Scalar::of_xml(kind)
            .ok_or_else(|| self.at(array, format!("numbers of type {} are not known", quoted(kind))))?;
        let bytes = match array.attribute("format").unwrap_or("ascii") {
            "ascii" => return Ok(Data::Text(array.text().unwrap_or(""))),
            "binary" => {
                let text: Vec<u8> =
                    array.text().unwrap_or("").bytes().filter(|byte| !byte.is_ascii_whitespace()).collect();
                self.decode(array, &text, true)?
            }
            "appended" => {
                let appended = self
                    .appended
                    .as_ref()
                    .ok_or_else(|| self.at(array, "its data are appended, and the file has none"))?;
                let offset = array.attribute("offset").and_then(|text| text.trim().parse::<usize>().ok());
                let rest = offset.and_then(|offset| appended.bytes.get(offset..)).ok_or_else(|| {
                    let message = format!(
                        "its offset lies outside of the {} of appended data",
                        counted(appended.bytes.len(), "byte")
                    );
                    self.at(array, message)
                })?;
                self.decode(array, rest, appended.base64)?
            }
            other => {
                return Err(self
                    .at(array, format!("data in the format {}; ascii, binary or appended are known", quoted(other))));
            }
        };
        if bytes.len() % scalar.size() != 0 {
            let message = format!("{} are no whole number of {kind}", counted(bytes.len(), "byte"));
            return Err(self.at(array, message));
        }
        Ok(Data::Binary(bytes, scalar))
    }

    /// A block: its length and its bytes, or the lengths of its packed parts and these.
    fn decode(&self, array: Node<'_, '_>, block: &[u8], base64: bool) -> Result<Vec<u8>, ReadError> {
        let early = || self.at(array, "its data end before their announced length");
        let size = self.header.size();
        let header_numbers = |bytes: &[u8]| -> Option<Vec<usize>> {
            let number =
                |bytes| self.header.whole(bytes, self.big_endian).and_then(|number| usize::try_from(number).ok());
            bytes.chunks_exact(size).map(number).collect()
        };
        let mut rest = Block { bytes: block, base64 };
        if !self.compressed {
            // length and data are encoded as one
            let all = |length: usize| length.checked_add(size);
            let length = header_numbers(&rest.peek(size).ok_or_else(early)?).ok_or_else(early)?[0];
            let mut bytes = all(length).and_then(|all| rest.take(all)).ok_or_else(early)?;
            return Ok(bytes.split_off(size));
        }
        let first = header_numbers(&rest.peek(3 * size).ok_or_else(early)?).ok_or_else(early)?;
        let (blocks, full, last) = (first[0], first[1], first[2]);
        let header =
            blocks.checked_add(3).and_then(|numbers| numbers.checked_mul(size)).and_then(|bytes| rest.take(bytes));
        let packed = header_numbers(&header.ok_or_else(early)?).ok_or_else(early)?.split_off(3);
        let all = packed.iter().try_fold(0_usize, |all, size| all.checked_add(*size)).and_then(|all| rest.take(all));
        let data = all.ok_or_else(early)?;
        let mut bytes = Vec::new();
        let mut start = 0;
        for (i, packed) in packed.iter().enumerate() {
            let length = if i + 1 == blocks && last != 0 { last } else { full };
            let part = &data[start..start + packed];
            start += packed;
            if length > packed.saturating_mul(PACKED) {
                return Err(self.at(array, "its parts are announced longer than what is packed in them can be"));
            }
            let mut out = vec![0; length];
            let mut unpack = flate2::Decompress::new(true);
            let done = unpack.decompress(part, &mut out, flate2::FlushDecompress::Finish);
            if done.is_err() || unpack.total_out() != length as u64 {
                return Err(self.at(
                    array,
                    format!("part {} of its packed data cannot be unpacked to {}", i + 1, counted(length, "byte")),
                ));
            }
            bytes.append(&mut out);
        }
        Ok(bytes)
    }
}

enum Data<'n> {
    Text(&'n str),
    Binary(Vec<u8>, Scalar),
}

/// Bytes that stand as they are or in base64.
struct Block<'b> {
    bytes: &'b [u8],
    base64: bool,
}

impl Block<'_> {
    /// The first bytes, left where they are.
    fn peek(&self, count: usize) -> Option<Vec<u8>> {
        Block { bytes: self.bytes, base64: self.base64 }.take(count)
    }

    /// The first bytes; in base64 they were encoded together, up to the padding.
    fn take(&mut self, count: usize) -> Option<Vec<u8>> {
        let written = if self.base64 { count.div_ceil(3).checked_mul(4)? } else { count };
        let taken = self.bytes.get(..written)?;
        self.bytes = &self.bytes[written..];
        if !self.base64 {
            return Some(taken.to_vec());
        }
        let mut bytes = Vec::with_capacity(count.checked_add(3)?);
        for chunk in taken.chunks(4 << 10) {
            STANDARD.decode_vec(chunk, &mut bytes).ok()?;
        }
        // cut where more was encoded along, as the head of a longer stretch
        bytes.truncate(count);
        (bytes.len() == count).then_some(bytes)
    }
}
