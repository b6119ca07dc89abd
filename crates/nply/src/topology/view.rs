//! Directions to look along.

use crate::numerics::vector::{Vector, add, cross, dot, norm, sub, times, unit};

/// A direction d to look along, with the right and the upward direction of what is seen: a right-handed frame, to rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    pub(crate) u: Vector,
    pub(crate) v: Vector,
    pub(crate) d: Vector,
}

impl View {
    /// A vector in the frame of the view.
    #[inline(always)]
    pub(crate) fn seen(&self, a: Vector) -> Vector {
        [dot(self.u, a), dot(self.v, a), dot(self.d, a)]
    }
}

/// How far the views are turned from across the flattest side of a curve: towards its length and towards its breadth. Plain numbers
/// of no pattern, so that what is regular in a curve does not meet what is regular in them.
const TILTS: [[[f64; 2]; 2]; 5] = [
    [[0.057_31, 0.213_77], [-0.083_19, -0.331_43]],
    [[0.129_07, 0.711_29], [-0.171_53, -0.947_71]],
    [[0.311_87, 0.097_23], [-0.441_01, 0.517_39]],
    [[0.613_57, -0.373_91], [-0.877_13, -0.134_69]],
    [[1.219_93, 0.823_81], [-1.733_21, 1.391_17]],
];

/// Points that are looked at for the choice of directions.
const SAMPLE: usize = 512;

/// Views of curves, the best guess first: across their length and, if they are flat, on to the flat side, where they are seen to cross least.
/// They come in pairs.
pub(crate) fn views(points: &[&[Vector]]) -> [[View; 2]; TILTS.len()] {
    let [long, broad, flat] = principal_axes(points);
    TILTS.map(|pair| {
        pair.map(|[along, across]| {
            let d = unit(add(flat, add(times(along, long), times(across, broad))));
            let u = unit(sub(long, times(dot(long, d), d)));
            View { u, v: cross(d, u), d }
        })
    })
}

/// Longest, middle and shortest principal axis of a sample of the points; only ever a choice, so that no digit depends on it.
fn principal_axes(curves: &[&[Vector]]) -> [Vector; 3] {
    let mut sample = Vec::with_capacity(curves.len() * SAMPLE);
    for points in curves {
        sample.extend(points.iter().step_by(points.len().div_ceil(SAMPLE)));
    }
    let share = 1.0 / sample.len() as f64;
    let centre = sample.iter().fold([0.0; 3], |sum, &p| add(sum, times(share, p)));
    let mut spread = [[0.0; 3]; 3];
    for p in &sample {
        let r = sub(*p, centre);
        for (row, x) in spread.iter_mut().zip(r) {
            *row = add(*row, times(x * share, r));
        }
    }
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    // Jacobi's rotations of the matrix, each of them carried over to the axes
    for _ in 0..6 {
        for [i, j] in [[0, 1], [1, 2], [0, 2]] {
            let (diagonal, off) = (0.5 * (spread[j][j] - spread[i][i]), spread[i][j]);
            let length = libm::hypot(diagonal, off);
            if length > 0.0 {
                let tan = off / (diagonal.abs() + length) * if diagonal < 0.0 { -1.0 } else { 1.0 };
                let cos = 1.0 / (1.0 + tan * tan).sqrt();
                let sin = tan * cos;
                let turned =
                    |a: Vector, b: Vector| (sub(times(cos, a), times(sin, b)), add(times(sin, a), times(cos, b)));
                (spread[i], spread[j]) = turned(spread[i], spread[j]);
                for row in &mut spread {
                    (row[i], row[j]) = (cos * row[i] - sin * row[j], sin * row[i] + cos * row[j]);
                }
                (axes[i], axes[j]) = turned(axes[i], axes[j]);
            }
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| spread[j][j].total_cmp(&spread[i][i]));
    let [long, broad, flat] = order.map(|k| axes[k]);
    if [long, broad, flat].iter().all(|axis| (0.5..2.0).contains(&norm(*axis))) {
        [long, broad, flat]
    } else {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    }
}
