//! The twist of a ribbon, or of a frame, along a curve.

use core::f64::consts::TAU;

use super::{Curve, CurveError};
use crate::geometry::Vector;
use crate::numerics::vector::{cross, dot, norm, sub, times, unit};

/// A direction carried along a curve: the edge of a ribbon, or one vector of a material frame.
///
/// Its part across the curve counts alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frame<'a> {
    /// One vector at each point; between points it changes evenly.
    AtPoints(&'a [Vector]),
    /// One vector on each segment, along which it does not turn.
    OnSegments(&'a [Vector]),
    /// The other edge of a ribbon: a second curve, point by point beside this one.
    Edge(&'a [Vector]),
}

/// Twist, with a bound for its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// Tw in turns, right-handed ones positive.
    pub value: f64,
    /// What rounding can have done to it, to first order.
    pub bound: f64,
}

impl Curve {
    #[doc = include_str!("../equations/eqA03.md")]
    ///
    /// Here u₃ is the rate at which the frame turns about the curve. Of a polygon it is exact: along each segment the frame turns by the angle between
    /// its parts across the segment, and at each corner by how it turns against the axis of the corner while the tangent goes round by the shortest way
    /// and the frame stays. No single step is taken for more than half a turn.
    ///
    #[doc = include_str!("../equations/eqA02.md")]
    ///
    /// That holds to rounding for every closed ribbon whose edges do not pass through each other:
    ///
    /// ```
    /// use nply::topology::{Curve, Frame, linking_number};
    /// use std::f64::consts::TAU;
    /// // a band of 40 pieces round a circle, twisted three times, right-handed
    /// let turn = |k: usize| libm::sincos(TAU * k as f64 / 40.0);
    /// let axis: Vec<_> = (0..40).map(turn).map(|(sin, cos)| [4.0 * cos, 4.0 * sin, 0.0]).collect();
    /// let edge: Vec<_> = (0..40)
    ///     .map(|k| {
    ///         let ((sin, cos), (up, out)) = (turn(k), turn(3 * k));
    ///         [(4.0 + out) * cos, (4.0 + out) * sin, -up]
    ///     })
    ///     .collect();
    /// let curve = Curve::closed(axis)?;
    /// let (twist, writhe) = (curve.twist(Frame::Edge(&edge))?, curve.writhe()?);
    /// assert_eq!(linking_number(&curve, &Curve::closed(edge.clone())?)?.value, 3);
    /// assert!((twist.value + writhe.value - 3.0).abs() < 1e-13);
    /// # Ok::<(), nply::topology::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::FrameLength`] unless there are as many vectors as points, or as segments; [`CurveError::FrameAlong`] where a vector has no part across
    /// the curve.
    pub fn twist(&self, frame: Frame<'_>) -> Result<Twist, CurveError> {
        let (given, needed) = match frame {
            Frame::AtPoints(vectors) | Frame::Edge(vectors) => (vectors, self.points().len()),
            Frame::OnSegments(vectors) => (vectors, self.segments()),
        };
        if given.len() != needed {
            return Err(CurveError::FrameLength { vectors: given.len(), needed });
        }
        let points = self.scaled();
        let next = |i: usize| if i + 1 < points.len() { i + 1 } else { 0 };
        let tangent = |i: usize| unit(sub(points[next(i)], points[i]));
        // as a unit vector, so that any length will do; of no direction, no numbers
        let vector = |i: usize| match frame {
            Frame::AtPoints(vectors) | Frame::OnSegments(vectors) => direction(vectors[i]),
            Frame::Edge(edge) => direction(sub(edge[i], self.points()[i])),
        };
        let mut turn = Turn::default();
        let corner = |turn: &mut Turn, i: usize, before: usize| match frame {
            Frame::OnSegments(_) => turn.carried(before, i, [vector(before), vector(i)], [tangent(before), tangent(i)]),
            _ => turn.still(i, vector(i), [tangent(before), tangent(i)]),
        };
        for i in 0..self.segments() {
            if i > 0 {
                corner(&mut turn, i, i - 1)?;
            } else if self.is_closed() {
                corner(&mut turn, 0, self.segments() - 1)?;
            }
            match frame {
                Frame::OnSegments(_) => {}
                _ => turn.between([i, next(i)], [vector(i), vector(next(i))], tangent(i))?,
            }
        }
        Ok(Twist { value: turn.angle / TAU, bound: turn.errors / TAU })
    }
}

fn direction(v: Vector) -> Vector {
    let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
    unit(times(1.0 / largest, v))
}

/// The part of a frame that still counts as across the curve: below, rounding would choose its direction.
const LEAST: f64 = 1e-12;

#[derive(Default)]
struct Turn {
    angle: f64,
    errors: f64,
}

impl Turn {
    /// Adds the angle from p to q about t, both of them at least nearly across t.
    fn add(&mut self, p: Vector, q: Vector, t: Vector, least: f64) {
        let (re, im) = (dot(p, q), dot(t, cross(p, q)));
        let angle = libm::atan2(im, re);
        self.angle += angle;
        self.errors += f64::EPSILON * (16.0 / least + self.angle.abs());
    }

    /// Along a segment from one vector to the other.
    fn between(&mut self, at: [usize; 2], [p, q]: [Vector; 2], t: Vector) -> Result<(), CurveError> {
        let (p, q) = (across(at[0], p, t)?, across(at[1], q, t)?);
        self.add(p, q, t, norm(p).min(norm(q)));
        Ok(())
    }

    /// At a corner, the vector staying as it is: its part across the tangent turns against the corner's axis, a × b.
    fn still(&mut self, at: usize, p: Vector, [a, b]: [Vector; 2]) -> Result<(), CurveError> {
        let (from, to) = (across(at, p, a)?, across(at, p, b)?);
        self.add(transported(from, a, b), to, b, norm(from).min(norm(to)));
        Ok(())
    }

    /// At a corner, from one vector to the next.
    fn carried(
        &mut self,
        one: usize,
        other: usize,
        [p, q]: [Vector; 2],
        [a, b]: [Vector; 2],
    ) -> Result<(), CurveError> {
        let (from, to) = (across(one, p, a)?, across(other, q, b)?);
        self.add(transported(from, a, b), to, b, norm(from).min(norm(to)));
        Ok(())
    }
}

/// The part of a vector across t.
fn across(vector: usize, p: Vector, t: Vector) -> Result<Vector, CurveError> {
    let part = sub(p, times(dot(p, t), t));
    if norm(part) > LEAST { Ok(part) } else { Err(CurveError::FrameAlong { vector }) }
}

/// A vector across a, turned as a is turned to b by the shortest way.
fn transported(p: Vector, a: Vector, b: Vector) -> Vector {
    // p − (b·p)/(1 + a·b) (a + b), for p·a = 0
    let k = dot(b, p) / (1.0 + dot(a, b));
    [p[0] - k * (a[0] + b[0]), p[1] - k * (a[1] + b[1]), p[2] - k * (a[2] + b[2])]
}
