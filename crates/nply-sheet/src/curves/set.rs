//! The curves of one or several files together, each closed or open.

use nply::geometry::Vector;

use super::{Curves, Polyline};
use crate::{Dimension, ErrorKind, Place, Quantity, SpecError, Unit, quoted};

/// Which curves are closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Closing {
    /// Those whose last point repeats the first.
    #[default]
    AsWritten,
    /// All: the last point is joined to the first.
    Closed,
    /// None, even where the last point repeats the first.
    Open,
}

/// A curve of a set.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Member {
    /// The file it comes from.
    pub file: String,
    /// What it is called in a report: its own name, with the file's in front where there are several files.
    pub name: String,
    /// Its points; of a closed curve each once.
    pub points: Vec<Vector>,
    /// Whether it is closed.
    pub closed: bool,
    /// Its diameter, where the file has one.
    pub diameter: Option<f64>,
    /// The line of its first point, in a text.
    pub line: Option<usize>,
}

/// The curves of one or several files together.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurveSet {
    /// All curves, file by file; at least one.
    pub members: Vec<Member>,
    /// The unit of length, as it is called in a report.
    pub unit: Option<String>,
    /// How it was found out which are closed.
    pub closing: Closing,
    /// What is to be said of the files, a sentence each.
    pub notes: Vec<String>,
}

impl Member {
    fn of(file: &str, name: String, polyline: Polyline, closing: Closing) -> Self {
        let ring = polyline.ring().map(<[Vector]>::len);
        let closed = match closing {
            Closing::AsWritten => ring.is_some(),
            Closing::Closed => true,
            Closing::Open => false,
        };
        let Polyline { mut points, diameter, line, .. } = polyline;
        if let Some(ring) = ring.filter(|_| closed) {
            points.truncate(ring);
        }
        Self { file: file.to_owned(), name, points, closed, diameter, line }
    }

    /// How many segments it has.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.points.len() - usize::from(!self.closed)
    }

    /// Its length up to a place on one of its segments, counted from 0.
    #[must_use]
    pub fn arclength(&self, segment: usize, fraction: f64) -> f64 {
        let length = |i: usize| {
            let (a, b) = (self.points[i % self.points.len()], self.points[(i + 1) % self.points.len()]);
            let [x, y, z] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
            // neither overflows nor vanishes
            libm::hypot(libm::hypot(x, y), z)
        };
        let before: f64 = (0..segment).map(length).sum();
        if fraction == 0.0 { before } else { before + fraction * length(segment) }
    }

    /// Its length.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.arclength(self.segments(), 0.0)
    }
}

impl CurveSet {
    /// Of files by their names, at least one of them. A unit that is given is that of all coordinates; else the files' own.
    ///
    /// # Errors
    /// [`SpecError`] for no file, and where files say different units, or another than is given.
    ///
    /// ```
    /// use nply_sheet::curves::{Closing, CurveSet, Curves};
    /// let ring = Curves::read("ring.txt", b"0 0 0\n1 0 0\n0 1 0\n0 0 0\n", None)?;
    /// let set = CurveSet::of(vec![("ring.txt".into(), ring)], None, Closing::AsWritten)?;
    /// assert!(set.members[0].closed && set.members[0].points.len() == 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[allow(clippy::float_cmp, reason = "two names of one unit have one size, to the last bit")]
    pub fn of(files: Vec<(String, Curves)>, unit: Option<&str>, closing: Closing) -> Result<Self, SpecError> {
        let flag = |name: &str| Place::Flag(name.to_owned());
        let several = files.len() > 1;
        let mut set = Self { members: Vec::new(), unit: unit.map(str::to_owned), closing, notes: Vec::new() };
        let mut first: Option<(String, Option<String>)> = None;
        for (file, curves) in files {
            if let (Some(given), Some(own)) = (unit, &curves.unit)
                && given != own
                && Unit::parse(given).ok().zip(Unit::parse(own).ok()).is_none_or(|(a, b)| a.to_si(1.0) != b.to_si(1.0))
            {
                let message = format!(
                    "{} has coordinates in {own}, and they are taken as they are: leave --unit out, or convert them first",
                    quoted(&file)
                );
                return Err(SpecError::new(ErrorKind::Contradiction, flag("unit"), message));
            }
            match &first {
                None => first = Some((file.clone(), curves.unit.clone())),
                Some((other, own)) if unit.is_none() && *own != curves.unit => {
                    let said = |unit: &Option<String>| unit.as_deref().map_or_else(|| "no unit".to_owned(), quoted);
                    let message = format!(
                        "{} says {} and {} {}: say the one unit of all coordinates",
                        quoted(other),
                        said(own),
                        quoted(&file),
                        said(&curves.unit)
                    );
                    return Err(SpecError::new(ErrorKind::Contradiction, flag("unit"), message));
                }
                Some(_) => {}
            }
            let single = curves.curves.len() == 1;
            for polyline in curves.curves {
                let name = match (several, single) {
                    (false, _) => polyline.name.clone(),
                    (true, true) => file.clone(),
                    (true, false) => format!("{file}: {}", polyline.name),
                };
                set.members.push(Member::of(&file, name, polyline, closing));
            }
            let of_file = |note: String| if several { format!("{file}: {note}") } else { note };
            set.notes.extend(curves.notes.into_iter().map(of_file));
        }
        let Some((_, own)) = first else {
            return Err(SpecError::new(ErrorKind::Missing, flag("read-as"), "no file with curves is named"));
        };
        set.unit = set.unit.or(own);
        Ok(set)
    }

    /// The same curves, those of these names read from their last point to their first, as strands of a duplex are where both are to run the same way.
    ///
    /// # Errors
    /// [`SpecError`] at `reverse` for a name that is none of the curves'.
    ///
    /// ```
    /// use nply_sheet::curves::{Closing, CurveSet, Curves};
    /// let file = Curves::read("two.csv", b"chain,x,y,z\nA,0,0,0\nA,0,0,1\nB,2,0,1\nB,2,0,0\n", None)?;
    /// let set = CurveSet::of(vec![("two.csv".into(), file)], None, Closing::AsWritten)?.reversed(&["B"])?;
    /// assert_eq!(set.members[1].points, [[2.0, 0.0, 0.0], [2.0, 0.0, 1.0]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn reversed(mut self, names: &[&str]) -> Result<Self, SpecError> {
        for (at, name) in names.iter().enumerate() {
            let Some(member) = self.members.iter_mut().find(|member| member.name == *name) else {
                const LISTED: usize = 8;
                let listed: Vec<String> = self.members.iter().take(LISTED).map(|member| quoted(&member.name)).collect();
                let more = if self.members.len() > LISTED { ", …" } else { "" };
                let message = format!("{} is none of the curves, which are {}{more}", quoted(name), listed.join(", "));
                return Err(SpecError::new(ErrorKind::UnknownKey, Place::Flag("reverse".to_owned()), message));
            };
            if names[..at].contains(name) {
                continue;
            }
            member.points.reverse();
            self.notes.push(format!("Curve {} is read from its last point to its first.", quoted(name)));
        }
        Ok(self)
    }

    /// A length given by a flag, in the unit of the coordinates: a bare number is in it already.
    ///
    /// # Errors
    /// [`SpecError`] at the flag where it is no length greater than 0, or has a unit and the coordinates have none.
    pub fn length(&self, flag: &str, text: &str) -> Result<f64, SpecError> {
        let place = || Place::Flag(flag.to_owned());
        let wrong = |kind, message: String| SpecError::new(kind, place(), message);
        let read = Quantity::parse(text).map_err(|error| wrong(ErrorKind::Syntax, error.to_string()))?;
        let value = match &read {
            Quantity::Bare(value) => *value,
            Quantity::Measured { si, unit } => {
                if unit.dimension() != Dimension::LENGTH {
                    let message = format!("{} is {}; a length is wanted", quoted(text), unit.dimension());
                    return Err(wrong(ErrorKind::WrongUnit, message));
                }
                let own = self.unit.as_deref().and_then(|own| Unit::parse(own).ok());
                let own = own.filter(|own| own.dimension() == Dimension::LENGTH).ok_or_else(|| {
                    let message = format!(
                        "{} has a unit and the coordinates have none: say theirs with --unit, or give a number alone",
                        quoted(text)
                    );
                    wrong(ErrorKind::WrongUnit, message)
                })?;
                own.of_si(*si)
            }
        };
        if value > 0.0 && value.is_finite() {
            Ok(value)
        } else {
            Err(wrong(ErrorKind::Domain, format!("{} is no length greater than 0", quoted(text))))
        }
    }
}
