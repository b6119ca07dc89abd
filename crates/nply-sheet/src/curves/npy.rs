//! NumPy's .npy: a header that is a Python dictionary, then numbers.

use super::scalar::Scalar;
use super::text::{Source, counted};
use super::{Draft, Found, ReadError};
use crate::quoted;

/// What the header says.
#[derive(Debug, PartialEq)]
struct Header {
    scalar: Scalar,
    big_endian: bool,
    fortran_order: bool,
    shape: Vec<usize>,
}

/// Shape (N, 3) is one curve, (K, N, 3) are K.
pub(super) fn read(source: &Source<'_>) -> Result<Found, ReadError> {
    let bytes = source.bytes;
    if !bytes.starts_with(b"\x93NUMPY") {
        return Err(source.at_byte(0, "it does not begin as a .npy file does, with \\x93NUMPY"));
    }
    let early = || source.at_byte(bytes.len(), "the file ends within its header");
    // versions 2 and 3 differ from the first in the length's size
    let (start, length) = match bytes.get(6) {
        Some(1) => (10, bytes.get(8..10).map(<[u8]>::to_vec)),
        Some(2 | 3) => (12, bytes.get(8..12).map(<[u8]>::to_vec)),
        Some(other) => {
            return Err(source.at_byte(6, format!("version {other} of the format is not known; 1, 2 or 3 are")));
        }
        None => return Err(early()),
    };
    let length = length.ok_or_else(early)?.iter().rev().fold(0_usize, |length, byte| length << 8 | usize::from(*byte));
    let data_start = start + length;
    let text = bytes.get(start..data_start).ok_or_else(early)?;
    let text = core::str::from_utf8(text).map_err(|_| source.at_byte(start, "its header is no text"))?;
    let Header { scalar, big_endian, fortran_order, shape } = header(text).map_err(|why| source.at_byte(start, why))?;
    let (curves, rows) = match shape[..] {
        [rows, 3] => (1, rows),
        [curves, rows, 3] => (curves, rows),
        _ => {
            let message =
                format!("its shape is {}; (N, 3) for a curve or (K, N, 3) for K curves are wanted", tuple(&shape));
            return Err(source.at_byte(start, message));
        }
    };
    let data = &bytes[data_start..];
    // compared before anything is set aside for it
    let numbers = curves.checked_mul(rows).and_then(|points| points.checked_mul(3));
    let wanted = numbers.and_then(|numbers| numbers.checked_mul(scalar.size()));
    if wanted != Some(data.len()) {
        let wanted = wanted.map_or("more than any machine's memory".to_owned(), |wanted| counted(wanted, "byte"));
        let message = format!("{} follow; the shape {} asks for {wanted}", counted(data.len(), "byte"), tuple(&shape));
        return Err(source.at_byte(data_start, message));
    }
    let value = |curve: usize, row: usize, axis: usize| {
        let index = if fortran_order { (axis * rows + row) * curves + curve } else { (curve * rows + row) * 3 + axis };
        let at = index * scalar.size();
        scalar.double(&data[at..at + scalar.size()], big_endian).ok_or_else(|| {
            let what = if matches!(scalar, Scalar::Float(_)) {
                "not finite"
            } else {
                "larger than 2^53 and no double equals it"
            };
            source.at_byte(data_start + at, format!("point {} has a coordinate that is {what}", row + 1))
        })
    };
    let mut found = Found::default();
    for curve in 0..curves {
        let point = |row| Ok([value(curve, row, 0)?, value(curve, row, 1)?, value(curve, row, 2)?]);
        let points = (0..rows).map(point).collect::<Result<Vec<_>, ReadError>>()?;
        found.drafts.push(Draft { points, ..Draft::default() });
        if rows < 2 {
            break; // refused, however many there are
        }
    }
    Ok(found)
}

fn tuple(shape: &[usize]) -> String {
    let numbers: Vec<String> = shape.iter().map(usize::to_string).collect();
    format!("({}{})", numbers.join(", "), if shape.len() == 1 { "," } else { "" })
}

/// `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 3), }`, in any order.
fn header(text: &str) -> Result<Header, String> {
    let wanted = "a dictionary with 'descr', 'fortran_order' and 'shape' is wanted";
    let no = || format!("its header is {}; {wanted}", quoted(text.trim()));
    let inside = text.trim().strip_prefix('{').and_then(|text| text.strip_suffix('}')).ok_or_else(no)?;
    let (mut descr, mut fortran_order, mut shape) = (None, None, None);
    let mut rest = inside.trim();
    while !rest.is_empty() {
        let (key, after) = string(rest).ok_or_else(no)?;
        let after = after.trim_start().strip_prefix(':').ok_or_else(no)?.trim_start();
        let after = match key {
            "descr" if after.starts_with('[') => {
                return Err("it has named fields (a structured array); plain numbers are wanted".to_owned());
            }
            "descr" => {
                let (value, after) = string(after).ok_or_else(no)?;
                descr = Some(value);
                after
            }
            "fortran_order" => {
                let (value, after) = match (after.strip_prefix("True"), after.strip_prefix("False")) {
                    (Some(after), _) => (true, after),
                    (_, Some(after)) => (false, after),
                    _ => return Err(no()),
                };
                fortran_order = Some(value);
                after
            }
            "shape" => {
                let (inside, after) = after.strip_prefix('(').and_then(|text| text.split_once(')')).ok_or_else(no)?;
                let numbers = inside.split(',').map(str::trim).filter(|number| !number.is_empty());
                shape = Some(numbers.map(str::parse).collect::<Result<Vec<usize>, _>>().map_err(|_| no())?);
                after
            }
            _ => return Err(no()),
        };
        rest = after.trim_start();
        rest = rest.strip_prefix(',').unwrap_or(rest).trim_start();
    }
    let (Some(descr), Some(fortran_order), Some(shape)) = (descr, fortran_order, shape) else { return Err(no()) };
    let (scalar, big_endian) = dtype(descr).ok_or_else(|| {
        format!(
            "its numbers are of type {}; floats of 4 or 8 bytes or integers are wanted (.astype('f8'))",
            quoted(descr)
        )
    })?;
    Ok(Header { scalar, big_endian, fortran_order, shape })
}

/// A string between quotation marks of either kind, and what follows.
fn string(text: &str) -> Option<(&str, &str)> {
    let mark = text.chars().next().filter(|c| ['\'', '"'].contains(c))?;
    text[1..].split_once(mark)
}

/// `<f8`, `>i4`, `|u1`.
fn dtype(descr: &str) -> Option<(Scalar, bool)> {
    let big_endian = match descr.get(..1)? {
        "<" | "|" => false,
        ">" => true,
        _ => return None, // `=`, the writing machine's own, is never written to a file
    };
    let scalar = match descr.get(1..)? {
        "f4" => Scalar::Float(4),
        "f8" => Scalar::Float(8),
        "i1" => Scalar::Signed(1),
        "i2" => Scalar::Signed(2),
        "i4" => Scalar::Signed(4),
        "i8" => Scalar::Signed(8),
        "u1" => Scalar::Unsigned(1),
        "u2" => Scalar::Unsigned(2),
        "u4" => Scalar::Unsigned(4),
        "u8" => Scalar::Unsigned(8),
        _ => return None,
    };
    Some((scalar, big_endian))
}
