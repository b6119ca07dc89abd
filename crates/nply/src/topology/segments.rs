//! Two segments: the solid angle of all directions along which they are seen to cross.

use crate::numerics::vector::{Vector, cross, dot, norm, sub};

/// Half the signed solid angle of the directions along which segment ab is seen to cross cd; positive where they cross right-handed.
///
/// In −π to π, and 0 where they have a point in common. The Gauss integral of the two is this over 2π.
///
/// Seen from one point of ab less those of cd the differences c − a, c − b, d − b, d − a span a quadrilateral on the sphere; it is cut into two
/// triangles, whose half angles have the tangent det/(|u||v||w| + (u·v)|w| + (u·w)|v| + (v·w)|u|).
pub(crate) fn half_solid_angle([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> f64 {
    let (u, v, w, t) = (sub(c, a), sub(c, b), sub(d, b), sub(d, a));
    let (nu, nv, nw, nt) = (norm(u), norm(v), norm(w), norm(t));
    let det = dot(u, cross(sub(b, a), sub(d, c)));
    let first = nu * nv * nw + dot(u, v) * nw + dot(u, w) * nv + dot(v, w) * nu;
    let second = nu * nt * nw + dot(u, t) * nw + dot(u, w) * nt + dot(t, w) * nu;
    if det == 0.0 { 0.0 } else { libm::atan2(det, first) + libm::atan2(det, second) }
}
