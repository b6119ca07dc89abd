//! Wires in triangles.

use nply::geometry::{Facets, Fit, TubeMesh};

use super::assembly::{Assembly, Wire};
use super::size::positive_length;
use super::subject::{Subject, flag};
use crate::{ErrorKind, SpecError};

/// How fine, and where the triangles lie.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Fineness<'f> {
    /// How far triangles may lie off, as a length, or bare as a share of the strand radius: 0.01, if nothing is said.
    pub chord_error: Option<&'f str>,
    /// Facets round a wire, instead.
    pub around: Option<u32>,
    /// Segments per lay length, instead.
    pub segments: Option<u32>,
    /// On, in, around or through the tube.
    pub fit: Fit,
}

/// A wire in triangles, and which of its sides are painted.
#[derive(Clone, Debug, PartialEq)]
pub struct Part<'a> {
    /// The wire.
    pub wire: &'a Wire,
    /// Its triangles; lengths in units of r.
    pub mesh: TubeMesh,
    /// The facets round it.
    pub around: u32,
}

impl Part<'_> {
    /// Whether a triangle is painted.
    #[must_use]
    pub fn is_striped(&self, triangle: usize) -> bool {
        let stripes = self.wire.stripes as usize;
        if stripes == 0 || triangle >= self.mesh.sides {
            return false;
        }
        let sector = self.around as usize / stripes;
        (triangle / 2 % self.around as usize) % sector < sector / 4
    }

    /// The colour of a triangle: the wire's, or a pale one of it on a stripe.
    #[must_use]
    pub fn colour(&self, triangle: usize) -> [u8; 3] {
        if self.is_striped(triangle) { pale(self.wire.colour) } else { self.wire.colour }
    }
}

/// Three quarters of the way to white.
pub(crate) fn pale(colour: [u8; 3]) -> [u8; 3] {
    colour.map(|x| 255 - (255 - x) / 4)
}

/// An assembly in triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface<'a> {
    /// r and B, where both are known.
    pub scale: Option<nply::Scale>,
    /// What it is of.
    pub assembly: &'a Assembly,
    /// Wire by wire.
    pub parts: Vec<Part<'a>>,
}

/// More triangles than this are refused: a file of a gigabyte.
const MOST_TRIANGLES: u64 = 20_000_000;

impl<'a> Surface<'a> {
    /// Every wire in triangles, as fine as is asked.
    ///
    /// # Errors
    /// [`SpecError`] at the flag that cannot be followed.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::mesh::{Assembly, Fineness, Subject, Surface, Wanted};
    /// let ply = Subject::of(&Spec::from_flags([("strands", "2"), ("helical-angle", "30 deg")])?, None)?;
    /// let assembly = Assembly::of(&ply, &Wanted { length: Some("20"), ..Wanted::default() })?;
    /// let surface = Surface::of(&ply, &assembly, Fineness { chord_error: Some("0.001"), ..Fineness::default() })?;
    /// // πr²L of each strand, within the chord error
    /// let expected = 2.0 * std::f64::consts::PI * 20.0 / 30_f64.to_radians().cos();
    /// assert!((surface.volume() / expected - 1.0).abs() < 0.002);
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    pub fn of(ply: &Subject, assembly: &'a Assembly, fineness: Fineness<'_>) -> Result<Self, SpecError> {
        const CHORD_ERROR: f64 = 0.01;
        let by_count = fineness.around.is_some() || fineness.segments.is_some();
        let error = match fineness.chord_error {
            Some(_) if by_count => {
                let message = "--chord-error and --facets or --segments both say how fine: remove one of them";
                return Err(flag("chord-error", ErrorKind::Contradiction, message));
            }
            Some(text) => positive_length("chord-error", text, ply.strand_radius, true)?,
            None => CHORD_ERROR,
        };
        if let Some(around @ ..3) = fineness.around {
            let message = format!("{around} facets round a strand make no body: at least 3 do");
            return Err(flag("facets", ErrorKind::Domain, message));
        }
        let refused = |error: nply::DomainError| {
            let name = match error.quantity {
                "facets" => return too_fine_or_coarse(&fineness, &error),
                "chord_error" => "chord-error",
                "pretwist" => "ends",
                _ => "length",
            };
            flag(name, ErrorKind::Domain, error.to_string())
        };
        let mut parts = Vec::new();
        // what is not alike all along is measured at some places only
        const SPARE: f64 = 0.98;
        let (mut known, mut triangles): (Vec<(&Wire, Facets)>, u64) = (Vec::new(), 0);
        for wire in &assembly.wires {
            // wires that differ in where they stand alone are cut alike
            let alike = known.iter().find(|(other, _)| {
                let [a, b] = [wire, *other].map(|wire| (wire.tube.radius(), wire.tube.twist(), wire.tube.course()));
                a.0.to_bits() == b.0.to_bits()
                    && a.1.to_bits() == b.1.to_bits()
                    && a.2.is_like(b.2)
                    && wire.stripes == other.stripes
            });
            let facets = match alike {
                Some((_, facets)) => *facets,
                None => {
                    let error = if wire.tube.course().is_uniform() { error } else { SPARE * error };
                    let facets = facets(wire, ply, &fineness, error.min(wire.tube.radius())).map_err(refused)?;
                    known.push((wire, facets));
                    facets
                }
            };
            triangles += 2 * u64::from(facets.around) * (u64::from(facets.along) + 1);
            if triangles > MOST_TRIANGLES {
                let message = format!(
                    "more than {MOST_TRIANGLES} triangles would be needed: allow a greater --chord-error, or a shorter --length"
                );
                return Err(flag("chord-error", ErrorKind::Domain, message));
            }
            let mesh = wire.tube.mesh(facets, fineness.fit).map_err(refused)?;
            parts.push(Part { wire, mesh, around: facets.around });
        }
        Ok(Self { scale: ply.scale, assembly, parts })
    }

    /// The volume enclosed, in units of r³.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.parts.iter().map(|part| part.mesh.volume()).sum()
    }

    /// How far triangles lie inside (≤ 0) and outside (≥ 0) of their tubes at most, in units of r.
    #[must_use]
    pub fn deviation(&self) -> [f64; 2] {
        let off = self.parts.iter().map(|part| part.mesh.deviation);
        off.fold([0.0_f64; 2], |all, off| [all[0].min(off[0]), all[1].max(off[1])])
    }

    /// Number of corners and of triangles.
    #[must_use]
    pub fn counts(&self) -> [usize; 2] {
        let of = |count: fn(&TubeMesh) -> usize| self.parts.iter().map(|part| count(&part.mesh)).sum();
        [of(|mesh| mesh.positions.len()), of(|mesh| mesh.triangles.len())]
    }
}

/// Facets that make no body, or too many: said of what asks for them.
fn too_fine_or_coarse(fineness: &Fineness<'_>, error: &nply::DomainError) -> SpecError {
    let (name, asks) = match *fineness {
        Fineness { around: Some(around), segments: Some(segments), .. } => {
            ("facets", format!("{around} facets round and {segments} segments"))
        }
        Fineness { around: Some(around), .. } => ("facets", format!("{around} facets round")),
        Fineness { segments: Some(segments), .. } => ("segments", format!("{segments} segments")),
        Fineness { chord_error: Some(text), .. } => {
            ("chord-error", format!("a chord error of {}", crate::quoted(text)))
        }
        Fineness { .. } => ("chord-error", "the usual chord error".to_owned()),
    };
    let found = if error.value < 1e9 { error.value.to_string() } else { "more than 1e9".to_owned() };
    let message = format!("with {asks} there would be {found} facets; they must be {}", error.allowed);
    flag(name, ErrorKind::Domain, message)
}

/// The facets of a wire, so many round it that stripes have straight borders.
fn facets(wire: &Wire, ply: &Subject, fineness: &Fineness<'_>, error: f64) -> Result<Facets, nply::DomainError> {
    const AROUND: u32 = 32;
    const SEGMENTS: u32 = 48;
    let [low, high] = wire.tube.heights();
    let mut facets = if fineness.around.is_some() || fineness.segments.is_some() {
        let turns = (high - low) / ply.lay_length();
        let along =
            libm::ceil(turns * f64::from(fineness.segments.unwrap_or(SEGMENTS))).clamp(1.0, f64::from(u32::MAX));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
        Facets { around: fineness.around.unwrap_or(AROUND), along: along as u32 }
    } else {
        wire.tube.facets(error, fineness.fit)?
    };
    let step = 4 * wire.stripes;
    if step > 0 {
        facets.around = facets.around.div_ceil(step) * step;
    }
    Ok(facets)
}
