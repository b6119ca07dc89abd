//! Two segments: the solid angle of all directions along which they are seen to cross.

use crate::numerics::vector::{Vector, cross, dot, norm, sub};

/// Half the signed solid angle of the directions along which segment ab is seen to cross cd; positive where they cross right-handed.
///
/// In −π to π, and 0 where they have a point in common. The Gauss integral of the two is this over 2π.
///
/// Seen from one point of ab less those of cd the differences c − a, c − b, d − b, d − a span a quadrilateral on the sphere; it is cut into two
/// triangles, whose half angles have the tangent det/(|u||v||w| + (u·v)|w| + (u·w)|v| + (v·w)|u|).
///
/// And what rounding can have done to it, to first order.
pub(crate) fn half_solid_angle_with_bound(one: [Vector; 2], other: [Vector; 2]) -> (f64, f64) {
    let Tangents { det, first, second, scale } = Tangents::of(one, other);
    let angle = if det == 0.0 { 0.0 } else { libm::atan2(det, first) + libm::atan2(det, second) };
    // a determinant of three differences: some eight roundings of its greatest term; denominators, of their greatest
    let share = scale / first.abs().max(det.abs()) + scale / second.abs().max(det.abs());
    (angle, 8.0 * f64::EPSILON * (share + angle.abs()))
}

/// Half solid angles, added up.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct AngleSum {
    pub(crate) angle: f64,
    errors: f64,
    /// of the sum so far, and how often it was added to
    greatest: f64,
    count: u64,
}

impl AngleSum {
    /// All segments of a polygon, given by its points, with one other.
    pub(crate) fn rows(&mut self, points: &[Vector], other: [Vector; 2]) {
        for ends in points.windows(2) {
            self.pair([ends[0], ends[1]], other);
        }
    }

    pub(crate) fn pair(&mut self, one: [Vector; 2], other: [Vector; 2]) {
        let (angle, bound) = half_solid_angle_with_bound(one, other);
        self.angle += angle;
        self.errors += bound;
        self.greatest = self.greatest.max(self.angle.abs());
        self.count += 1;
    }

    /// What rounding can have done to the sum, to first order.
    pub(crate) fn bound(&self) -> f64 {
        self.errors + self.count as f64 * f64::EPSILON * self.greatest
    }
}

/// Numerator and denominators of the two tangents.
struct Tangents {
    det: f64,
    first: f64,
    second: f64,
    /// the product of the three lengths in the determinant
    scale: f64,
}

impl Tangents {
    #[inline]
    fn of([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> Self {
        let (u, v, w, t) = (sub(c, a), sub(c, b), sub(d, b), sub(d, a));
        let (nu, nv, nw, nt) = (norm(u), norm(v), norm(w), norm(t));
        let (e, f) = (sub(b, a), sub(d, c));
        Self {
            det: dot(u, cross(f, e)),
            first: nu * nv * nw + dot(u, v) * nw + dot(u, w) * nv + dot(v, w) * nu,
            second: nu * nt * nw + dot(u, t) * nw + dot(u, w) * nt + dot(t, w) * nu,
            scale: nu.min(nw) * norm(e) * norm(f),
        }
    }
}
