//! What a closed centreline is made of: helices, arcs, straight lines, each run through by its arclength.

use core::f64::consts::FRAC_PI_4;

use crate::geometry::Vector;
use crate::numerics::vector::{add, dot, norm, sub, times};

/// Which part of the closed centreline a piece belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// H⁺: a helical strand from the near to the far end of the ply, counted from 0.
    Forward(u32),
    /// H⁻: a helical strand run back.
    Backward(u32),
    /// E: between two strands, or between a strand and the closure.
    End,
    /// The helix that lines the closure up, of length L_i.
    Insert,
    /// C: the straight line of length L_c with its two semicircles, in one plane.
    Closure,
}

/// A piece of one curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    part: Part,
    length: f64,
    shape: Shape,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Straight {
        from: Vector,
        tangent: Vector,
    },
    /// centre + radius (tangent sin φ − normal cos φ), both at the start
    Arc {
        centre: Vector,
        radius: f64,
        tangent: Vector,
        normal: Vector,
    },
    Helix(Helix),
}

/// (1), from an azimuth and a height on, upwards or downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Helix {
    pub(super) radius: f64,
    pub(super) sin: f64,
    pub(super) cos: f64,
    pub(super) eps: f64,
    /// ψ and z where it starts
    pub(super) azimuth: f64,
    pub(super) height: f64,
    /// +1 upwards, −1 downwards
    pub(super) sense: f64,
}

impl Helix {
    fn at(&self, s: f64) -> [Vector; 2] {
        let s = self.sense * s;
        let (sin_psi, cos_psi) = libm::sincos(self.azimuth + self.eps * s * self.sin / self.radius);
        let position =
            [self.eps * self.radius * sin_psi, -self.eps * self.radius * cos_psi, self.height + s * self.cos];
        [position, times(self.sense, [self.sin * cos_psi, self.sin * sin_psi, self.cos])]
    }
}

impl Piece {
    pub(super) const fn straight(part: Part, from: Vector, tangent: Vector, length: f64) -> Self {
        Self { part, length, shape: Shape::Straight { from, tangent } }
    }

    pub(super) const fn helix(part: Part, helix: Helix, length: f64) -> Self {
        Self { part, length, shape: Shape::Helix(helix) }
    }

    /// An arc that leaves along `tangent`, bends towards the unit vector `normal` and turns by `angle`.
    pub(super) fn arc(part: Part, from: Vector, tangent: Vector, normal: Vector, radius: f64, angle: f64) -> Self {
        let centre = add(from, times(radius, normal));
        Self { part, length: radius * angle, shape: Shape::Arc { centre, radius, tangent, normal } }
    }

    /// The part it belongs to.
    #[must_use]
    pub const fn part(&self) -> Part {
        self.part
    }

    /// Its length, in units of r.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// Its curvature times r.
    #[must_use]
    pub fn curvature(&self) -> f64 {
        match self.shape {
            Shape::Straight { .. } => 0.0,
            Shape::Arc { radius, .. } => 1.0 / radius,
            Shape::Helix(helix) => helix.sin * helix.sin / helix.radius,
        }
    }

    /// Position and unit tangent at the arclength s from its start, in units of r.
    #[must_use]
    pub fn at(&self, s: f64) -> [Vector; 2] {
        match self.shape {
            Shape::Straight { from, tangent } => [add(from, times(s, tangent)), tangent],
            Shape::Arc { centre, radius, tangent, normal } => {
                let (sin, cos) = libm::sincos(s / radius);
                let outward = sub(times(sin, tangent), times(cos, normal));
                [add(centre, times(radius, outward)), add(times(cos, tangent), times(sin, normal))]
            }
            Shape::Helix(helix) => helix.at(s),
        }
    }

    /// The number of equal chords that stay within `tolerance` of it and turn by 45° at most.
    pub(super) fn chords(&self, tolerance: f64) -> f64 {
        // a chord over the arclength h is at most κh²/8 away
        let kappa = self.curvature();
        let far = self.length * libm::sqrt(0.125 * kappa / tolerance);
        libm::ceil(far.max(self.length * kappa / FRAC_PI_4)).max(1.0)
    }
}

/// The unit vector across the unit vector `tangent` in the direction of the unit vector `aim`, and the angle between the two.
pub(super) fn bend(tangent: Vector, aim: Vector) -> (Vector, f64) {
    let cos = dot(tangent, aim);
    let across = sub(aim, times(cos, tangent));
    let sin = norm(across);
    (times(1.0 / sin, across), libm::atan2(sin, cos))
}
