//! All solutions of the contact condition (5): the main branch, the trivial one, the satellites of Figures 1 and 3.

use core::f64::consts::PI;

use super::{Contact, HelicalAngle, check_strands};
use crate::DomainError;
use crate::numerics::dual::Dual;
use crate::numerics::root::bracketed;

/// Which curve of Figure 1 or 3 a solution lies on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BranchKind {
    /// The curve through the origin for n ≥ 3, and for n = 2 the trivial one up to π/4, the pair of nontrivial ones above:
    /// the global minimum of the distance between neighbours.
    Main,
    /// n = 2 above π/4: x = 0, a maximum of the distance where the strands overlap.
    Trivial,
    /// Any other solution: the strands overlap elsewhere.
    Satellite,
}

/// One solution of (5) at a given angle, with the radius that (4) would give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// The curve it lies on.
    pub kind: BranchKind,
    /// x, dimensionless; of either sign.
    pub arclength_shift: f64,
    /// ρ = R/r.
    pub radius_ratio: f64,
    /// Whether the distance between neighbours is a local minimum here (else a local maximum).
    pub local_minimum: bool,
    /// r κ = sin²θ/ρ.
    pub curvature: f64,
}

impl Branch {
    /// Whether tubes at this radius penetrate each other: everywhere but on the main branch.
    #[must_use]
    pub fn self_penetrating(&self) -> bool {
        self.kind != BranchKind::Main
    }

    /// Whether the tube's own curvature stays within 1/r.
    #[must_use]
    pub fn keeps_curvature(&self) -> bool {
        self.curvature <= 1.0
    }
}

/// The solutions of (5) at an angle, nearest to x = 0 first, at most `most` of them: their number grows as tan²θ.
///
/// E + e sin E = 2π/n with e = tan²θ is monotone between the points where cos E = −1/e: each such piece holds one
/// solution or none, as the values at its ends say, and pieces with a solution follow on each other.
///
/// # Errors
/// [`DomainError`] on `strands`.
///
/// ```
/// use nply::geometry::{BranchKind, HelicalAngle, branches};
/// let found = branches(2, HelicalAngle::new(60_f64.to_radians())?, 100)?;
/// let main = found.iter().filter(|b| b.kind == BranchKind::Main).count();
/// assert_eq!((found.len(), main), (3, 2)); // x = 0 and the pair that left it at 45°
/// # Ok::<(), nply::DomainError>(())
/// ```
pub fn branches(strands: u32, angle: HelicalAngle, most: usize) -> Result<Vec<Branch>, DomainError> {
    let main = Contact::at_angle(strands, angle)?;
    let mut found = vec![Branch {
        kind: BranchKind::Main,
        arclength_shift: main.arclength_shift(),
        radius_ratio: main.radius_ratio(),
        local_minimum: true,
        curvature: main.curvature(),
    }];
    let fold = angle.tan() * angle.tan();
    if fold > 1.0 {
        let pieces = Pieces { strands, angle, eccentricity: fold, turn: libm::acos(-1.0 / fold) };
        if strands == 2 {
            found.push(Branch { arclength_shift: -main.arclength_shift(), ..found[0] });
            found.push(pieces.branch(PI, BranchKind::Trivial, false));
        }
        // piece 0 holds the main branch; for two strands piece 1 the trivial one and piece 2 the other main one
        // on either side they follow each other outwards, so that the nearest `most` are among the first `most` of each
        let first = if strands == 2 { 3 } else { 1 };
        found.extend((first..).map_while(|piece| pieces.solution(piece)).take(most));
        found.extend((1..).map_while(|piece| pieces.solution(-piece)).take(most));
        found.sort_by(|a, b| a.arclength_shift.abs().total_cmp(&b.arclength_shift.abs()));
    }
    found.truncate(most);
    Ok(found)
}

/// The solution of (5) at an anomaly E = 2π/n − x sin θ, with its angle: tan²θ = (2π/n − E)/sin E. `None` where that is not a number
/// greater than 0.
///
/// Between neighbouring multiples of π each curve of Figures 1 and 3 runs through once: the main branch in 0 < E < 2π/n, its mirror image
/// for two strands in π < E < 2π, and the satellites, which come from flat rings, turn and go back to them.
///
/// # Errors
/// [`DomainError`] on `strands`, and unless the anomaly is finite.
///
/// ```
/// use nply::geometry::{Contact, branch_at_anomaly};
/// let contact = Contact::new(3, 1.0)?;
/// let (angle, branch) = branch_at_anomaly(3, contact.anomaly())?.expect("on the main branch");
/// assert!((angle.radians() - 1.0).abs() < 1e-14);
/// assert!((branch.arclength_shift - contact.arclength_shift()).abs() < 1e-13);
/// # Ok::<(), nply::DomainError>(())
/// ```
pub fn branch_at_anomaly(strands: u32, anomaly: f64) -> Result<Option<(HelicalAngle, Branch)>, DomainError> {
    check_strands(strands)?;
    DomainError::check(anomaly.is_finite(), "anomaly", anomaly, "finite")?;
    let lambda = 2.0 * PI / f64::from(strands);
    let (sin, cos) = libm::sincos(anomaly);
    let tan_squared = (lambda - anomaly) / sin;
    if !(tan_squared > 0.0 && tan_squared < 1.0 / (HelicalAngle::FLATTEST * HelicalAngle::FLATTEST)) {
        return Ok(None);
    }
    let angle = HelicalAngle::flat(libm::atan(1.0 / libm::sqrt(tan_squared)).max(HelicalAngle::FLATTEST));
    let is_main = (0.0..lambda).contains(&anomaly) || (strands == 2 && (PI..2.0 * PI).contains(&anomaly));
    let kind = if is_main { BranchKind::Main } else { BranchKind::Satellite };
    Ok(Some((angle, solution(angle, anomaly, kind, 1.0 + tan_squared * cos > 0.0))))
}

/// What (4) makes of an anomaly.
fn solution(angle: HelicalAngle, anomaly: f64, kind: BranchKind, local_minimum: bool) -> Branch {
    let (s, c) = (angle.sin(), angle.cos());
    let (sh, ch) = if kind == BranchKind::Trivial { (1.0, 0.0) } else { libm::sincos(0.5 * anomaly) };
    let radius_ratio = c / (sh.abs() * libm::sqrt(c * c + s * s * ch * ch));
    Branch {
        kind,
        arclength_shift: 2.0 * s * sh * ch / (c * c),
        radius_ratio,
        local_minimum,
        curvature: s * s / radius_ratio,
    }
}

/// The monotone pieces of E + e sin E for e > 1: even ones rise about E = πi, odd ones fall.
struct Pieces {
    strands: u32,
    angle: HelicalAngle,
    eccentricity: f64,
    /// arccos(−1/e), where the first piece turns
    turn: f64,
}

impl Pieces {
    /// The solution on piece `i`, if it has one.
    fn solution(&self, i: i64) -> Option<Branch> {
        let lambda = 2.0 * PI / f64::from(self.strands);
        let rising = i % 2 == 0;
        let middle = PI * i as f64;
        let half = if rising { self.turn } else { PI - self.turn };
        let e = self.eccentricity;
        // by the distance from the middle, and from below so that a bracket's coordinate is not negative
        let f = |t: f64| {
            let (sin, cos) = libm::sincos(t - half);
            let sign = if rising { 1.0 } else { -1.0 };
            Dual::new((middle - lambda) + (t - half) + sign * e * sin, 1.0 + sign * e * cos)
        };
        let (low, high) = (f(0.0).value >= 0.0, f(2.0 * half).value >= 0.0);
        if low == high {
            return None;
        }
        let (at, _) = bracketed(f, 0.0, 2.0 * half, low, half);
        Some(self.branch(middle + (at - half), BranchKind::Satellite, rising))
    }

    fn branch(&self, anomaly: f64, kind: BranchKind, local_minimum: bool) -> Branch {
        solution(self.angle, anomaly, kind, local_minimum)
    }
}
