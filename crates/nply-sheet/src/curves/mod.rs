//! Curves that people have: centrelines of wires, traces of molecules, polylines, from the files they come in.
//!
//! Rows of numbers, XYZ, PDB, VTK (legacy and XML), OBJ, INP and NumPy files are read, several curves in one file. Bytes in, values out: a
//! door opens the file. Coordinates are taken as they are, in the file's own unit. What is left out or chosen on the way is said in
//! [`Curves::notes`]; what cannot be taken for certain is refused in a sentence with its place ([`ReadError`]).
//!
//! ```
//! use nply_sheet::curves::Curves;
//! let file = b"curve,x,y,z\ncore,0,0,0\ncore,0,0,9\nouter,2,0,0\nouter,0,2,9\n";
//! let read = Curves::read("strand.csv", file, None)?;
//! assert_eq!(read.curves.len(), 2);
//! assert_eq!((read.curves[1].name.as_str(), read.curves[1].points[1]), ("outer", [0.0, 2.0, 9.0]));
//! # Ok::<(), nply_sheet::curves::ReadError>(())
//! ```

mod cells;
mod error;
mod format;
mod inp;
mod npy;
mod obj;
mod pdb;
mod rows;
mod scalar;
mod set;
mod text;
mod vtk;
mod vtk_xml;
mod xyz;

use std::collections::BTreeMap;
use std::sync::Arc;

use nply::geometry::Vector;

pub use error::{ReadError, Spot};
pub use format::Format;
pub use set::{Closing, CurveSet, Member};

use text::Source;
pub(crate) use text::counted;

/// One curve as it was read: a polyline.
#[derive(Clone, Debug, PartialEq)]
pub struct Polyline {
    /// Its name in the file (a chain's letter, a column's word, an object's name), made unique; else its number, from 1.
    pub name: String,
    /// Its points in order, at least two, in the file's unit; all finite. A closed curve may repeat its first point at the end.
    pub points: Vec<Vector>,
    /// Its diameter, where the file has one.
    pub diameter: Option<f64>,
    /// The line on which its first point stands, counted from 1, in a text.
    pub line: Option<usize>,
}

/// All curves of a file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Curves {
    /// What it was read as.
    pub format: Format,
    /// In the file's order; at least one.
    pub curves: Vec<Polyline>,
    /// The unit of the coordinates, where the file says one.
    pub unit: Option<String>,
    /// What was left out or chosen on the way, a sentence each.
    pub notes: Vec<String>,
}

/// A curve on its way in: its name may be missing or not unique.
#[derive(Clone, Debug, Default)]
struct Draft {
    name: Option<String>,
    points: Vec<Vector>,
    diameter: Option<f64>,
    line: Option<usize>,
}

/// What a reader finds.
#[derive(Default)]
struct Found {
    drafts: Vec<Draft>,
    unit: Option<String>,
    notes: Vec<String>,
}

impl Polyline {
    /// The points of a ring, each once, where the last repeats the first; `None` for an open curve.
    ///
    /// ```
    /// use nply_sheet::curves::Curves;
    /// let file = b"0 0 0\n1 0 0\n0 1 0\n0 0 0\n";
    /// assert_eq!(Curves::read("ring.txt", file, None)?.curves[0].ring().map(<[_]>::len), Some(3));
    /// # Ok::<(), nply_sheet::curves::ReadError>(())
    /// ```
    #[must_use]
    #[allow(clippy::float_cmp, reason = "a point that is repeated is repeated to the last bit")]
    pub fn ring(&self) -> Option<&[Vector]> {
        match self.points.as_slice() {
            [first, between @ .., last] if first == last && between.len() > 1 => {
                self.points.get(..self.points.len() - 1)
            }
            _ => None,
        }
    }
}

impl Curves {
    /// Reads a file's bytes, as `format` or as what its name and its beginning say.
    ///
    /// # Errors
    /// [`ReadError`] with line or byte: not the format, a number that is none or is not finite, fewer points than were announced, a
    /// curve of fewer than two points, no curve at all.
    ///
    /// ```
    /// use nply_sheet::curves::{Curves, Format};
    /// let read = Curves::read("a.xyz", b"2\nhelix\nC 0 0 0\nC 0 0 1.5\n", None)?;
    /// assert_eq!((read.format, read.curves[0].name.as_str()), (Format::Xyz, "helix"));
    /// # Ok::<(), nply_sheet::curves::ReadError>(())
    /// ```
    pub fn read(file_name: &str, bytes: &[u8], format: Option<Format>) -> Result<Self, ReadError> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let source = Source { name: Arc::from(file_name), bytes };
        if bytes.iter().all(u8::is_ascii_whitespace) {
            return Err(source.whole("nothing is in it; rows x y z, or one of the other formats, are wanted"));
        }
        if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
            return Err(source.whole("it is text in UTF-16; save it as UTF-8 or plain ASCII"));
        }
        let format = match format {
            Some(format) => format,
            None => Format::guess(file_name, bytes).map_err(|what| source.whole(format!("it is {what}")))?,
        };
        let found = match format {
            Format::Rows => rows::read(&source),
            Format::Xyz => xyz::read(&source),
            Format::Pdb => pdb::read(&source),
            Format::Vtk => vtk::read(&source),
            Format::VtkXml => vtk_xml::read(&source),
            Format::Obj => obj::read(&source),
            Format::Inp => inp::read(&source),
            Format::Npy => npy::read(&source),
        }?;
        let curves = finish(&source, found.drafts)?;
        let mut notes = found.notes;
        notes.extend(curves.iter().find_map(|curve| Some((curve, leap(&curve.points)?))).map(
            |(curve, (point, times))| {
                format!(
                    "Curve {}: the step behind point {} is {times:.0} times the usual one; are these two curves?",
                    crate::quoted(&curve.name),
                    point + 1
                )
            },
        ));
        Ok(Self { format, curves, unit: found.unit, notes })
    }

    /// The number of points of all curves together.
    #[must_use]
    pub fn points(&self) -> usize {
        self.curves.iter().map(|curve| curve.points.len()).sum()
    }
}

/// Squares and products of coordinates are formed, after scaling; this leaves room for differences.
const FARTHEST: f64 = 1e300;

/// A step that stands out from a curve's evenly spaced others as one between two curves would: the point before it, counted from 0, and how many
/// times the median it is.
fn leap(points: &[Vector]) -> Option<(usize, f64)> {
    const OUTSTANDING: f64 = 8.0;
    const ENOUGH: usize = 6;
    let step = |pair: &[Vector]| {
        let [x, y, z] = [0, 1, 2].map(|k| pair[1][k] - pair[0][k]);
        libm::hypot(libm::hypot(x, y), z)
    };
    let steps: Vec<f64> = points.windows(2).map(step).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let (median, wide) = (sorted.get(sorted.len() / 2)?, sorted.get(sorted.len() * 9 / 10)?);
    // curves that are sampled unevenly throughout have steps of all sizes
    let even = *wide < 2.0 * median && steps.len() >= ENOUGH;
    let at = steps.iter().position(|step| *step > OUTSTANDING * median).filter(|_| even)?;
    Some((at, steps[at] / median))
}

/// Names are made unique, and curves of one point are refused.
fn finish(source: &Source<'_>, drafts: Vec<Draft>) -> Result<Vec<Polyline>, ReadError> {
    if drafts.is_empty() {
        return Err(source.whole("no curve is in it"));
    }
    let mut taken: BTreeMap<String, usize> = BTreeMap::new();
    let mut curves = Vec::with_capacity(drafts.len());
    for (i, draft) in drafts.into_iter().enumerate() {
        let named = draft.name.filter(|name| !name.is_empty()).unwrap_or_else(|| (i + 1).to_string());
        if draft.points.len() < 2 {
            let points = counted(draft.points.len(), "point");
            let message = format!("curve {} has {points}; a curve has at least 2", crate::quoted(&named));
            return Err(match draft.line {
                Some(line) => source.at_line(line, message),
                None => source.whole(message),
            });
        }
        if draft.points.iter().flatten().any(|x| x.abs() > FARTHEST) {
            let message = format!(
                "curve {} has a coordinate beyond {FARTHEST:e}, which cannot be calculated with",
                crate::quoted(&named)
            );
            return Err(source.whole(message));
        }
        let mut name = named.clone();
        while let Some(times) = taken.get_mut(&name) {
            *times += 1;
            name = format!("{named} ({times})");
        }
        taken.insert(name.clone(), 1);
        curves.push(Polyline { name, points: draft.points, diameter: draft.diameter, line: draft.line });
    }
    Ok(curves)
}
