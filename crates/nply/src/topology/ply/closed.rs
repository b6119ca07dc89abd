//! The n-ply joined into one closed curve: Figures 12, 14 and 15 for every n.

use core::f64::consts::{PI, TAU};

use super::check_strands;
use super::piece::{Helix, Part, Piece, bend};
use crate::geometry::{Contact, HelicalAngle, Vector};
use crate::numerics::vector::{norm, sub, times};
use crate::{DomainError, Handedness};

const UP: Vector = [0.0, 0.0, 1.0];
/// Most points of a polygon.
const MOST_POINTS: f64 = 1e9;

/// The centreline through all strands of a uniform ply, closed and with a continuous tangent.
///
/// Strand 0 is run through upwards, strand 1 back down, and so on. At either end the strands first turn parallel to the axis, along arcs of the
/// ply's radius; semicircles then join neighbours: 0 to 1, 2 to 3, … at the far end, 1 to 2, 3 to 4, … at the near one. For even n
/// the last one leads back to strand 0. For odd n the last strand goes on straight past the other end sections and
/// through the insert, a helix of less than one turn of the same angle, hand and radius; a semicircle, a straight line beside the ply and a
/// semicircle below it, all in one plane through the axis, lead back to strand 0. No end section crosses another one or a strand.
///
#[doc = include_str!("../../equations/eqA01.md")]
///
/// Lengths are in units of r.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::Contact;
/// use nply::topology::{ClosedPly, Curve, PlyWrithe};
/// let contact = Contact::new(3, 0.6)?;
/// let writhe = |length: f64| -> Result<f64, Box<dyn std::error::Error>> {
///     let points = ClosedPly::of_ply(&contact, Right, length)?.points(1e-3)?;
///     Ok(Curve::closed(points)?.writhe()?.value)
/// };
/// // over four more turns the writhe of the very curve grows by what (A.27) says, and by the change of what stays bounded
/// let turn = std::f64::consts::TAU * contact.radius_ratio() / contact.angle().sin();
/// let grown = writhe(6.3 * turn)? - writhe(2.3 * turn)?;
/// assert!((grown - 4.0 * (1.0 - 3.0 * contact.angle().cos())).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedPly {
    pieces: Vec<Piece>,
    /// the arclength at which each piece starts
    starts: Vec<f64>,
    length: f64,
}

impl ClosedPly {
    /// From the number of strands n ≥ 1, the helical angle, the hand, the helix radius and the length of each strand, both in units of r. The strands
    /// need not touch: writhe does not ask.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` if it is 0 or above a million, on `radius_ratio` unless it is between 1e-15 and 1e15, on
    /// `strand_length` unless it is greater than 0, at most 1e15 and no more than 1e9 turns, and on the helical angle where its cosine is below 1e-15, or its sine for an odd number of strands: no insert lines a closure up with straight strands.
    pub fn new(
        strands: u32,
        angle: HelicalAngle,
        handedness: Handedness,
        radius_ratio: f64,
        strand_length: f64,
    ) -> Result<Self, DomainError> {
        check_strands(strands)?;
        let radii = 1e-15..=1e15;
        DomainError::check(radii.contains(&radius_ratio), "radius_ratio", radius_ratio, "between 1e-15 and 1e15")?;
        let long = strand_length > 0.0 && strand_length <= 1e15;
        let few_turns = strand_length * angle.sin() <= TAU * radius_ratio * 1e9;
        let allowed = "greater than 0, at most 1e15 and no more than 1e9 turns";
        DomainError::check(long && few_turns, "strand_length", strand_length, allowed)?;
        let flat = "less than pi/2 by at least 1e-15";
        DomainError::check(angle.cos() >= 1e-15, "helical_angle", angle.radians(), flat)?;
        let aligned = strands.is_multiple_of(2) || angle.sin() >= 1e-15 || (strands == 1 && angle.radians() == 0.0);
        let straight = "at least 1e-15 for an odd number of strands, whose closure needs an insert that turns (or 0 for one strand)";
        DomainError::check(aligned, "helical_angle", angle.radians(), straight)?;
        let mut track = Track::new(strands, angle, handedness, radius_ratio, strand_length);
        track.run();
        let mut starts = Vec::with_capacity(track.pieces.len());
        let mut length = 0.0;
        for piece in &track.pieces {
            starts.push(length);
            length += piece.length();
        }
        Ok(Self { pieces: track.pieces, starts, length })
    }

    /// Of touching strands.
    ///
    /// # Errors
    /// [`DomainError`] as above.
    pub fn of_ply(contact: &Contact, handedness: Handedness, strand_length: f64) -> Result<Self, DomainError> {
        Self::new(contact.strands(), contact.angle(), handedness, contact.radius_ratio(), strand_length)
    }

    /// The pieces in the order in which they are run through.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// 𝓛, in units of r.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// Position and unit tangent at the arclength s from the start of strand 0, in units of r; s is taken modulo 𝓛.
    #[must_use]
    pub fn at(&self, s: f64) -> [Vector; 2] {
        let s = s - self.length * libm::floor(s / self.length);
        let i = self.starts.partition_point(|start| *start <= s).max(1) - 1;
        self.pieces[i].at(s - self.starts[i])
    }

    /// The corners of a closed polygon that stays within `tolerance` of the curve, in units of r, and turns by some 45° at most at a corner; the first is
    /// not repeated.
    ///
    /// # Errors
    /// [`DomainError`] on `tolerance` unless it is finite, greater than 0 and asks for no more than 1e9 points.
    pub fn points(&self, tolerance: f64) -> Result<Vec<Vector>, DomainError> {
        let count: f64 = self.pieces.iter().map(|piece| piece.chords(tolerance)).sum();
        let allowed = "finite, greater than 0 and so great that 1e9 points are enough";
        let possible = (0.0..f64::INFINITY).contains(&tolerance) && count <= MOST_POINTS;
        DomainError::check(possible, "tolerance", tolerance, allowed)?;
        let mut points = Vec::with_capacity(count as usize);
        for piece in &self.pieces {
            let chords = piece.chords(tolerance);
            points.extend((0..chords as u32).map(|i| piece.at(piece.length() * f64::from(i) / chords)[0]));
        }
        Ok(points)
    }
}

/// The curve as it is laid, piece by piece.
struct Track {
    strands: u32,
    helix: Helix,
    strand_length: f64,
    angle: f64,
    /// azimuth gained between a helix's end and the point above which its strand stands parallel to the axis, and that point's radius
    lead: f64,
    outer: f64,
    pieces: Vec<Piece>,
    position: Vector,
    tangent: Vector,
}

impl Track {
    fn new(strands: u32, angle: HelicalAngle, handedness: Handedness, radius: f64, strand_length: f64) -> Self {
        let (sin, cos) = (angle.sin(), angle.cos());
        let eps = handedness.sign();
        let helix = Helix { radius, sin, cos, eps, azimuth: 0.0, height: 0.0, sense: 1.0 };
        let aside = radius * sin * sin / (1.0 + cos); // of an arc of the ply's radius: R (1 − cos θ)
        Self {
            strands,
            helix,
            strand_length,
            angle: angle.radians(),
            lead: libm::atan2(aside, radius),
            outer: libm::hypot(aside, radius),
            pieces: Vec::new(),
            position: [0.0; 3],
            tangent: UP,
        }
    }

    fn run(&mut self) {
        for i in 0..self.strands {
            let upwards = i % 2 == 0;
            self.strand(i, upwards);
            self.turn(Part::End, if upwards { UP } else { times(-1.0, UP) });
            if i + 1 < self.strands || !upwards {
                self.join(i, (i + 1) % self.strands, upwards);
            } else {
                self.close();
            }
        }
    }

    /// ψ of a strand at the far end, or at the near one.
    fn azimuth(&self, strand: u32, far: bool) -> f64 {
        let phase = TAU * f64::from(strand) / f64::from(self.strands);
        if far { phase + self.helix.eps * self.strand_length * self.helix.sin / self.helix.radius } else { phase }
    }

    fn strand(&mut self, i: u32, upwards: bool) {
        let (sense, height) = if upwards { (1.0, 0.0) } else { (-1.0, self.strand_length * self.helix.cos) };
        let helix = Helix { azimuth: self.azimuth(i, !upwards), height, sense, ..self.helix };
        let part = if upwards { Part::Forward(i) } else { Part::Backward(i) };
        self.lay(Piece::helix(part, helix, self.strand_length));
    }

    /// The unit vector from the axis to a strand of azimuth ψ.
    fn radial(&self, psi: f64) -> Vector {
        let (sin, cos) = libm::sincos(psi);
        [self.helix.eps * sin, -self.helix.eps * cos, 0.0]
    }

    /// Where strand i stands parallel to the axis, beyond an end, as far as it is from the axis.
    fn post(&self, i: u32, far: bool) -> Vector {
        let lead = if far { self.helix.eps * self.lead } else { -self.helix.eps * self.lead };
        times(self.outer, self.radial(self.azimuth(i, far) + lead))
    }

    /// Half the distance of neighbouring posts.
    fn half_gap(&self) -> f64 {
        self.outer * libm::sin(PI / f64::from(self.strands))
    }

    /// A semicircle from a strand to its neighbour, and the arc on to the neighbour's helix.
    fn join(&mut self, from: u32, to: u32, far: bool) {
        let across = sub(self.post(to, far), self.post(from, far));
        let towards = times(1.0 / norm(across), across);
        self.lay(Piece::arc(Part::End, self.position, self.tangent, towards, self.half_gap(), PI));
        self.turn(Part::End, self.helix_tangent(to, far));
    }

    /// The tangent with which a strand's helix is entered from an end.
    fn helix_tangent(&self, i: u32, far: bool) -> Vector {
        let (sin, cos) = libm::sincos(self.azimuth(i, far));
        let sense = if far { -1.0 } else { 1.0 };
        times(sense, [self.helix.sin * cos, self.helix.sin * sin, self.helix.cos])
    }

    /// Past the other end sections, through the insert and round to strand 0.
    fn close(&mut self) {
        let eps = self.helix.eps;
        let past = if self.strands > 1 { self.half_gap() + 2.0 } else { 0.0 };
        self.ahead(Part::End, past);
        // the insert turns on until the strand stands above the post of strand 0: four arcs lead on, each by `lead`
        let top = self.azimuth(self.strands - 1, true);
        let turned = -eps * top - 4.0 * self.lead;
        let turned = turned - TAU * libm::floor(turned / TAU);
        let azimuth = top + 2.0 * eps * self.lead;
        let (sin, cos) = libm::sincos(azimuth);
        self.turn(Part::End, [self.helix.sin * cos, self.helix.sin * sin, self.helix.cos]);
        if self.helix.sin > 0.0 {
            let helix = Helix { azimuth, height: self.position[2], sense: 1.0, ..self.helix };
            self.lay(Piece::helix(Part::Insert, helix, turned * self.helix.radius / self.helix.sin));
        }
        self.turn(Part::End, UP);
        let outward = self.radial(-eps * self.lead);
        // two strand radii outside the ply, and as far again as the posts stand from the axis
        let half_width = self.outer + 1.0;
        self.lay(Piece::arc(Part::Closure, self.position, UP, outward, half_width, PI));
        let bottom = -self.helix.radius * self.helix.sin - past;
        self.ahead(Part::Closure, self.position[2] - bottom);
        self.lay(Piece::arc(Part::Closure, self.position, self.tangent, times(-1.0, outward), half_width, PI));
        self.ahead(Part::End, past);
        self.turn(Part::End, self.helix_tangent(0, false));
    }

    /// An arc of the ply's radius that ends along `aim`; none for straight strands.
    fn turn(&mut self, part: Part, aim: Vector) {
        if self.angle > 0.0 {
            let (normal, angle) = bend(self.tangent, aim);
            self.lay(Piece::arc(part, self.position, self.tangent, normal, self.helix.radius, angle));
        }
    }

    fn ahead(&mut self, part: Part, length: f64) {
        self.lay(Piece::straight(part, self.position, self.tangent, length));
    }

    fn lay(&mut self, piece: Piece) {
        if piece.length() > 0.0 {
            [self.position, self.tangent] = piece.at(piece.length());
            self.pieces.push(piece);
        }
    }
}
