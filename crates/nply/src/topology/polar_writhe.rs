//! Polar writhe: the writhe of open curves between two planes.

use core::f64::consts::{PI, TAU};

use super::{Curve, CurveError};
use crate::DomainError;
use crate::geometry::Vector;
use crate::numerics::vector::{cross, dot, norm, sub, times, unit};

/// The polar writhe of a curve along an axis, in turns: `local` + `nonlocal`.
///
/// M. A. Berger & C. Prior, *The writhe of open and closed curves*, J. Phys. A 39 (2006) 8321. Of closed curves it is the writhe, whatever the
/// axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolarWrithe {
    /// Of each piece between turning points by itself: the area its tangent sweeps round the axis.
    pub local: f64,
    /// Of each piece with each other one: how they turn round each other.
    pub nonlocal: f64,
}

impl PolarWrithe {
    /// Both together.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.local + self.nonlocal
    }
}

impl Curve {
    /// The polar writhe along `axis`, a vector of any length.
    ///
    /// The curve is cut where it turns back along the axis. Each piece has a local part; pieces i and j at the same height z turn round each other by an
    /// angle Θ, with
    ///
    /// ```text
    ///          1      σ ẑ·(T × T′)            σᵢ σⱼ
    /// W_p  =  ───  ∫  ────────────  ds  +  Σ  ─────  ∫ dΘᵢⱼ ,     σ = +1 up, −1 down
    ///         2π       1 + |T_z|          i≠j  2π
    /// ```
    ///
    /// Both are exact for the polygon.
    ///
    /// ```
    /// use nply::topology::Curve;
    /// // two upright pieces, joined above, the second a quarter of a turn round the first
    /// let hook = Curve::open(vec![[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [1.0, 0.0, 1.0], [0.0, -1.0, 0.0]])?;
    /// let polar = hook.polar_writhe([0.0, 0.0, 1.0])?;
    /// assert!((polar.nonlocal + 0.5).abs() < 1e-15); // a right-handed quarter, in opposite directions, of each round the other
    /// # Ok::<(), nply::topology::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Domain`] for an axis without direction; [`CurveError::Level`] for a segment across the axis, which turns round others at no height:
    /// turn the axis a little; [`CurveError::Touch`] where two segments meet.
    pub fn polar_writhe(&self, axis: Vector) -> Result<PolarWrithe, CurveError> {
        let length = norm(axis);
        DomainError::check(length > 0.0 && length.is_finite(), "axis length", length, "above 0 and finite")?;
        let axis = times(1.0 / length, axis);
        // a frame whose third vector is the axis
        let aside = if axis[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let u = unit(cross(aside, axis));
        let v = cross(axis, u);
        let mut places: Vec<Vector> = self.scaled().iter().map(|&p| [dot(u, p), dot(v, p), dot(axis, p)]).collect();
        if self.is_closed() {
            places.push(places[0]);
        }
        Ok(PolarWrithe { local: local(&places, self.is_closed()), nonlocal: nonlocal(&places)? })
    }
}

/// What the corners sweep round the axis, in turns.
fn local(places: &[Vector], closed: bool) -> f64 {
    let tangents: Vec<Vector> = places.windows(2).map(|ends| unit(sub(ends[1], ends[0]))).collect();
    let round = closed.then(|| [tangents[tangents.len() - 1], tangents[0]]);
    let corners = tangents.windows(2).map(|pair| [pair[0], pair[1]]).chain(round);
    corners.map(|[a, b]| swept(a, b)).sum::<f64>() / TAU
}

/// ∫ σ ẑ·(T × dT)/(1 + |T_z|) along the shortest way from a to b: the area swept round the pole on whose side both are.
fn swept(a: Vector, b: Vector) -> f64 {
    if (a[2] > 0.0 && b[2] < 0.0) || (a[2] < 0.0 && b[2] > 0.0) {
        let level = unit([0, 1, 2].map(|k| a[k] * b[2].abs() + b[k] * a[2].abs()));
        let level = [level[0], level[1], 0.0];
        return swept(a, level) + swept(level, b);
    }
    // twice the half angle of the triangle of the nearer pole, a and b
    let det = a[0] * b[1] - a[1] * b[0];
    2.0 * libm::atan2(if a[2] + b[2] < 0.0 { -det } else { det }, 1.0 + (a[2] + b[2]).abs() + dot(a, b))
}

/// How the segments turn round each other where they are at one height, in turns.
fn nonlocal(places: &[Vector]) -> Result<f64, CurveError> {
    let segments = places.len() - 1;
    let ends = |k: usize| [places[k], places[k + 1]];
    let height = |k: usize| (places[k][2].min(places[k + 1][2]), places[k][2].max(places[k + 1][2]));
    if let Some(segment) = (0..segments).find(|&k| height(k).1 <= height(k).0) {
        return Err(CurveError::Level { segment });
    }
    let mut order: Vec<usize> = (0..segments).collect();
    order.sort_by(|&i, &j| height(i).0.total_cmp(&height(j).0));
    #[expect(clippy::float_cmp, reason = "the first point repeated, or not")]
    let round = places[0] == places[segments];
    let mut reached: Vec<usize> = Vec::new();
    let mut angle = 0.0;
    for k in order {
        let (low, high) = height(k);
        // those that end below are done with
        reached.retain(|&other| height(other).1 > low);
        for &other in &reached {
            let next = k.abs_diff(other);
            let joined = next == 1 || (round && next + 1 == segments);
            if !joined {
                let turn = turned(ends(k), ends(other), low, high.min(height(other).1));
                angle += turn.ok_or(CurveError::Touch { curves: [0, 0], segments: [k.min(other), k.max(other)] })?;
            }
        }
        reached.push(k);
    }
    Ok(angle / PI)
}

/// σσ times the angle by which one segment turns round another between two heights; nothing where they meet.
fn turned(one: [Vector; 2], other: [Vector; 2], low: f64, high: f64) -> Option<f64> {
    let between = |z: f64| {
        let [p, q] = [one, other].map(|[a, b]| {
            let share = (z - a[2]) / (b[2] - a[2]);
            [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
        });
        [p[0] - q[0], p[1] - q[1]]
    };
    let (from, to) = (between(low), between(high));
    let (im, re) = (from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    let up = |[a, b]: [Vector; 2]| b[2] > a[2];
    let angle = if up(one) == up(other) { libm::atan2(im, re) } else { -libm::atan2(im, re) };
    // through each other: straight on to the other side, or to nothing
    (im != 0.0 || re > 0.0).then_some(angle)
}
