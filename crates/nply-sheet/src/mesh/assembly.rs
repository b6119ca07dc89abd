//! Strands, core and lines on them, put together.

use core::f64::consts::TAU;

use nply::geometry::{Centreline, ContactLine, Ends, Tube, Vector};

use super::size::{length_of, positive_length};
use super::subject::{Subject, flag};
use crate::plot::STRANDS;
use crate::{ErrorKind, SpecError};

/// A strand, wire or core: a tube with a name, a colour and what is known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Wire {
    /// Its name: `strand-1`, `core`.
    pub name: String,
    /// Red, green, blue.
    pub colour: [u8; 3],
    /// Its body; lengths in units of r.
    pub tube: Tube,
    /// How many lines are painted along its material, each a quarter of its share of the surface.
    pub stripes: u32,
    /// Name, dimension and value of what is the same all over it, dimensionless.
    pub values: Vec<(&'static str, crate::Measure, f64)>,
}

/// What a line is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineKind {
    /// Where two surfaces touch.
    Contact,
    /// The outline of a strand in a plane across the axis.
    Cut,
}

/// A line in space, of points in units of r.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it is.
    pub kind: LineKind,
    /// Its name: `contact-1-2`, `cut-1-strand-3`.
    pub name: String,
    /// Its points; a closed one ends with the first again.
    pub points: Vec<Vector>,
}

/// What stands in a file of shapes: wires of any lay, and lines. Nothing in it is in triangles yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// Its name.
    pub title: String,
    /// Strands first, then a core.
    pub wires: Vec<Wire>,
    /// Lines on them.
    pub lines: Vec<Line>,
}

/// How much of a ply, with what on it. Lengths as they are written: `"20 mm"`, or in strand radii where a strand has no size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Wanted<'w> {
    /// The length of ply; else `lay_lengths` tell it.
    pub length: Option<&'w str>,
    /// Turns of a strand: 3, if neither is said.
    pub lay_lengths: Option<f64>,
    /// A core; with an empty text, one that fills the hole.
    pub core: Option<&'w str>,
    /// How the wires end.
    pub ends: Ends,
    /// Lines painted along the material of each strand.
    pub stripes: u32,
    /// Whether to draw the lines along which neighbours touch.
    pub contact_lines: bool,
    /// Heights at which the ply is cut across.
    pub cuts: Vec<&'w str>,
}

/// The colour of a core.
pub const CORE_COLOUR: [u8; 3] = [0x99, 0x99, 0x99];
/// The most wires of which a file is made.
pub(super) const MOST_WIRES: u32 = 10_000;

impl Assembly {
    /// The strands of a ply, its core, and what is wanted on them.
    ///
    /// # Errors
    /// [`SpecError`] at the flag that cannot be followed.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::{Assembly, Subject, Wanted};
    /// let rope = Subject::of(&Spec::from_flags([("strands", "6"), ("helical-angle", "20 deg")])?, None)?;
    /// let wanted = Wanted { length: Some("30"), core: Some(""), contact_lines: true, ..Wanted::default() };
    /// let rope = Assembly::of(&rope, &wanted)?;
    /// assert_eq!((rope.wires.len(), rope.lines.len()), (7, 12)); // neighbours touch, and all the core
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(ply: &Subject, wanted: &Wanted<'_>) -> Result<Self, SpecError> {
        const TURNS: f64 = 3.0;
        if ply.strands > MOST_WIRES {
            let message = format!("{} strands are too many to be drawn: at most {MOST_WIRES} are", ply.strands);
            return Err(flag("strands", ErrorKind::Domain, message));
        }
        let top = ply_length(ply, wanted, TURNS)?;
        let refused = |error: nply::DomainError| flag("length", ErrorKind::Domain, error.to_string());
        let mut wires = Vec::new();
        for i in 0..ply.strands {
            let azimuth = TAU * f64::from(i) / f64::from(ply.strands);
            let course = Centreline::helix(ply.radius_ratio, ply.angle, ply.handedness, azimuth).map_err(refused)?;
            let tube = Tube::new(course, 1.0, 0.0, top).and_then(|tube| tube.twisted(ply.pretwist)).map_err(refused)?;
            wires.push(Wire {
                name: format!("strand-{}", i + 1),
                colour: STRANDS[i as usize % STRANDS.len()],
                tube: tube.with_ends(wanted.ends),
                stripes: wanted.stripes,
                values: ply.values.clone(),
            });
        }
        let core = core_radius(ply, wanted)?;
        if let Some(radius) = core {
            wires.push(Wire {
                name: "core".to_owned(),
                colour: CORE_COLOUR,
                tube: Tube::new(Centreline::axis(), radius, 0.0, top).map_err(refused)?,
                stripes: 0,
                values: Vec::new(),
            });
        }
        let mut lines = Vec::new();
        if wanted.contact_lines {
            lines.extend(contact_lines(ply, core, top)?);
        }
        lines.extend(outlines(&wires, wanted, ply, top)?);
        Ok(Self { title: ply.title.clone(), wires, lines })
    }

    /// The heights between which its wires reach, in units of r.
    #[must_use]
    pub fn heights(&self) -> [f64; 2] {
        let heights = self.wires.iter().map(|wire| wire.tube.heights());
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |all, [low, high]| [all[0].min(low), all[1].max(high)])
    }

    /// The radius of the cylinder about the axis that encloses it, in units of r.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.wires.iter().map(|wire| wire.tube.course().outermost() + wire.tube.radius()).fold(0.0, f64::max)
    }
}

/// The length of ply that is wanted, in units of r; so many turns, if none is said.
pub(super) fn ply_length(ply: &Subject, wanted: &Wanted<'_>, otherwise: f64) -> Result<f64, SpecError> {
    if let (Some(_), Some(_)) = (wanted.length, wanted.lay_lengths) {
        let message = "--length and --lay-lengths both say how much of the ply: remove one of them";
        return Err(flag("length", ErrorKind::Contradiction, message));
    }
    if let Some(text) = wanted.length {
        let length = length_of("length", text, ply)?;
        if length > 0.0 && length < f64::INFINITY {
            return Ok(length);
        }
        return Err(flag("length", ErrorKind::Domain, format!("{}: it must be greater than 0", crate::quoted(text))));
    }
    let turns = wanted.lay_lengths.unwrap_or(otherwise);
    let length = turns * ply.lay_length();
    if length > 0.0 && length < f64::INFINITY {
        return Ok(length);
    }
    let message = if ply.angle.sin() == 0.0 {
        "straight strands have no lay length: give --length"
    } else if turns > 0.0 && length > 0.0 {
        "so many lay lengths are longer than any number: give fewer"
    } else {
        "it must be a number greater than 0"
    };
    Err(flag("lay-lengths", ErrorKind::Domain, message))
}

/// Cores thinner than this, in units of r, are lost among the roundings of their strands.
const THINNEST_CORE: f64 = 1e-6;

/// As many digits as a reader has use for.
fn round(number: f64) -> String {
    if number < 1e6 { format!("{number:.6}") } else { format!("{number:.3e}") }
}

/// The core's radius, in units of r, if there is one.
fn core_radius(ply: &Subject, wanted: &Wanted<'_>) -> Result<Option<f64>, SpecError> {
    let hole = ply.radius_ratio - 1.0;
    let Some(text) = wanted.core else { return Ok(ply.core_radius) };
    let radius = match text {
        "" => ply.core_radius.unwrap_or(hole),
        text => positive_length("core", text, ply.strand_radius, false)?,
    };
    if radius <= 0.0 {
        return Err(flag("core", ErrorKind::Domain, "these strands leave no hole for a core: leave it out"));
    }
    if radius < THINNEST_CORE {
        let message = format!("a core of {radius:e} strand radii is too thin to be drawn: {THINNEST_CORE:e} at least");
        return Err(flag("core", ErrorKind::Domain, message));
    }
    // a core that was given and lies against the strands does so to rounding
    if radius > hole * (1.0 + 1e-9) {
        let said = |value: f64| match ply.strand_radius {
            Some(r) => ply.units.format(crate::Dimension::LENGTH, value * r),
            None => format!("{} strand radii", round(value)),
        };
        let message = format!(
            "a core of radius {} overlaps the strands, which touch each other and leave a hole of radius {}; strands that lie on a thicker \
             core are described in a file, with [core] and [[layer]] as for `nply fit-check`",
            said(radius),
            said(hole)
        );
        return Err(flag("core", ErrorKind::Domain, message));
    }
    Ok(Some(radius))
}

/// The helices along which neighbours touch each other, and the core.
fn contact_lines(ply: &Subject, core: Option<f64>, top: f64) -> Result<Vec<Line>, SpecError> {
    const SEGMENTS_PER_TURN: f64 = 96.0;
    let turns = top / ply.lay_length();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "held below 2^20")]
    let segments = (turns * SEGMENTS_PER_TURN).clamp(1.0, 1_048_576.0) as u32;
    let heights = || (0..=segments).map(move |k| top * f64::from(k) / f64::from(segments));
    let mut lines = Vec::new();
    if let Some(contact) = ply.contact {
        let line = ContactLine::new(&contact, ply.handedness);
        // two strands in line contact touch along the axis, and there is one line
        let count = if ply.strands == 2 && line.radius() == 0.0 { 1 } else { ply.strands };
        for i in 0..count {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(ply.strands));
            let turned = |[x, y, z]: Vector| [cos * x - sin * y, sin * x + cos * y, z];
            let points = heights().map(|z| turned(line.position(z / ply.angle.cos()))).collect();
            let name = format!("contact-{}-{}", i + 1, (i + 1) % ply.strands + 1);
            lines.push(Line { kind: LineKind::Contact, name, points });
        }
    }
    if let Some(radius) = core.filter(|radius| ply.radius_ratio - 1.0 - radius <= 1e-9 * ply.radius_ratio) {
        for i in 0..ply.strands {
            let azimuth = TAU * f64::from(i) / f64::from(ply.strands);
            let line = Centreline::helix(ply.radius_ratio, ply.angle, ply.handedness, azimuth)
                .map_err(|error| flag("contact-lines", ErrorKind::Domain, error.to_string()))?;
            let inward = radius / ply.radius_ratio;
            let points = heights().map(|z| {
                let [x, y, _] = line.position(z / ply.angle.cos());
                [inward * x, inward * y, z]
            });
            lines.push(Line {
                kind: LineKind::Contact,
                name: format!("contact-{}-core", i + 1),
                points: points.collect(),
            });
        }
    }
    if lines.is_empty() {
        let message = "no two surfaces touch in this ply: leave it out";
        return Err(flag("contact-lines", ErrorKind::Domain, message));
    }
    Ok(lines)
}

/// The outlines of all wires in the planes that are wanted.
pub(super) fn outlines(wires: &[Wire], wanted: &Wanted<'_>, ply: &Subject, top: f64) -> Result<Vec<Line>, SpecError> {
    let mut lines = Vec::new();
    for (number, cut) in wanted.cuts.iter().enumerate() {
        let height = length_of("cut", cut, ply)?;
        if !(0.0..=top).contains(&height) {
            let message = format!("the plane at {cut} passes by the ply, which reaches from 0 to its length");
            return Err(flag("cut", ErrorKind::Domain, message));
        }
        lines.extend(wires.iter().map(|wire| outline(wire, height, number + 1)));
    }
    Ok(lines)
}

/// The outline of a wire in the plane at a height.
fn outline(wire: &Wire, height: f64, number: usize) -> Line {
    const CORNERS: u32 = 96;
    let points = (0..=CORNERS).map(|k| wire.tube.cut(height, TAU * f64::from(k % CORNERS) / f64::from(CORNERS)));
    Line { kind: LineKind::Cut, name: format!("cut-{number}-{}", wire.name), points: points.collect() }
}
