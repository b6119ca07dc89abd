//! Half solid angles of one segment with sixty-four others at once.
//!
//! Every quantity but the determinant comes from squared distances between ends: the four of a pair, two of which are known from the segment
//! before along one curve and two from the segment before along the other, so that each pair takes one new distance and one root. The
//! tangents of eight pairs are multiplied as complex numbers before one arctangent is taken.
#![allow(clippy::needless_range_loop, reason = "lanes and steps are places in several arrays at once")]

use super::segments::half_solid_angle_with_bound;
use crate::numerics::vector::{Vector, dot, norm, sub};

/// Segments of one lane, and lanes.
const STEPS: usize = 8;
const LANES: usize = 8;
/// Segments of one block.
pub(crate) const BLOCK: usize = STEPS * LANES;
type Lanes = [f64; LANES];

/// A segment is far from a lane if the distance between their beginnings is this many times the longest segment of either: then the two
/// stay two lengths apart, and a half solid angle below 1/8.
const FAR: f64 = 4.0;
/// The least squared distance whose 48th power is still a number with a margin, where the curve's size is about one.
const FLOOR: f64 = 1e-10;

/// Sixty-four segments that follow each other, lane by lane. Wide loads that straddle two lines of the cache would take twice as long.
#[repr(C, align(64))]
pub(crate) struct Block<'a> {
    /// places, and twice the step to the next place, by coordinate
    p: [[Lanes; STEPS + 1]; 3],
    f: [[Lanes; STEPS]; 3],
    /// squared lengths
    ff: [Lanes; STEPS],
    /// squared distances, and distances, from the beginning of the row that is next
    square: [Lanes; STEPS + 1],
    root: [Lanes; STEPS + 1],
    longest: Lanes,
    /// all points that follow each other
    points: &'a [Vector],
    start: usize,
    segments: usize,
}

/// A sum of half solid angles.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Part {
    pub(crate) sum: f64,
    pub(crate) bound: f64,
}

impl<'a> Block<'a> {
    /// Segments `start` to `start` + 63, or to the last, of an open polygon given by its points.
    pub(crate) fn new(points: &'a [Vector], start: usize) -> Self {
        let segments = BLOCK.min(points.len() - 1 - start);
        let mut block = Self {
            points,
            start,
            segments,
            p: [[[0.0; LANES]; STEPS + 1]; 3],
            f: [[[0.0; LANES]; STEPS]; 3],
            ff: [[0.0; LANES]; STEPS],
            longest: [0.0; LANES],
            square: [[0.0; LANES]; STEPS + 1],
            root: [[0.0; LANES]; STEPS + 1],
        };
        for lane in 0..LANES {
            for step in 0..=STEPS {
                let at = points[start + (lane * STEPS + step).min(segments)];
                for k in 0..3 {
                    block.p[k][step][lane] = at[k];
                }
            }
            for step in 0..STEPS {
                let f = [0, 1, 2].map(|k| block.p[k][step + 1][lane] - block.p[k][step][lane]);
                for k in 0..3 {
                    block.f[k][step][lane] = 2.0 * f[k];
                }
                block.ff[step][lane] = dot(f, f);
                block.longest[lane] = block.longest[lane].max(norm(f));
            }
        }
        block
    }

    /// The segments of `rows`, one after the other, with each of the block's; `ABS` takes each half solid angle as positive. Neighbours,
    /// as `joined` tells them by row and segment, are left out, and so is every segment of the block before `first(row)`.
    /// What each row adds is added to its place in `each`, if it has one.
    pub(crate) fn sum<const ABS: bool>(
        &mut self,
        rows: &[Vector],
        first: impl Fn(usize) -> usize,
        joined: impl Fn(usize, usize) -> bool,
        each: &mut [f64],
    ) -> Part {
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx512f") {
                #[expect(unsafe_code, reason = "the processor was just asked for what the function needs")]
                // SAFETY: AVX-512 is there.
                return unsafe { self.sum_512::<ABS>(rows, first, joined, each) };
            }
            if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
                #[expect(unsafe_code, reason = "the processor was just asked for what the function needs")]
                // SAFETY: AVX2 and FMA are there.
                return unsafe { self.sum_256::<ABS>(rows, first, joined, each) };
            }
        }
        self.sum_of::<ABS, false>(rows, first, joined, each)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f")]
    fn sum_512<const ABS: bool>(
        &mut self,
        rows: &[Vector],
        first: impl Fn(usize) -> usize,
        joined: impl Fn(usize, usize) -> bool,
        each: &mut [f64],
    ) -> Part {
        self.sum_of::<ABS, true>(rows, first, joined, each)
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn sum_256<const ABS: bool>(
        &mut self,
        rows: &[Vector],
        first: impl Fn(usize) -> usize,
        joined: impl Fn(usize, usize) -> bool,
        each: &mut [f64],
    ) -> Part {
        self.sum_of::<ABS, true>(rows, first, joined, each)
    }

    #[inline(always)]
    fn sum_of<const ABS: bool, const FUSED: bool>(
        &mut self,
        rows: &[Vector],
        first: impl Fn(usize) -> usize,
        joined: impl Fn(usize, usize) -> bool,
        each: &mut [f64],
    ) -> Part {
        let mut part = Part::default();
        let mut far = ([0.0; LANES], [0.0; LANES]);
        self.stand_at(rows[0]);
        for (row, ends) in rows.windows(2).enumerate() {
            let (a, b) = (ends[0], ends[1]);
            let [square, angles] = self.row::<ABS, FUSED>(a, b);
            let length = norm(sub(b, a));
            let from = first(row);
            // as a rule all lanes are far, and all together add up side by side
            let mut all = self.segments == BLOCK && self.start >= from;
            let (mut sum, mut bound) = ([0.0; LANES], [0.0; LANES]);
            for lane in 0..LANES {
                let longest = if length > self.longest[lane] { length } else { self.longest[lane] };
                all &= square[lane] >= FAR * FAR * longest * longest && square[lane] >= FLOOR;
                sum[lane] = far.0[lane] + angles[lane];
                bound[lane] = far.1[lane] + error(length * self.longest[lane] / square[lane], angles[lane]);
            }
            if all {
                if let Some(own) = each.get_mut(row) {
                    *own += angles.iter().sum::<f64>();
                }
                far = (sum, bound);
                continue;
            }
            let before = part.sum;
            for lane in 0..LANES {
                let start = self.start + lane * STEPS;
                let end = (start + STEPS).min(self.start + self.segments);
                let longest = length.max(self.longest[lane]);
                let far = square[lane] >= (FAR * FAR * longest * longest).max(FLOOR);
                if far && start >= from && end == start + STEPS {
                    part.sum += angles[lane];
                    part.bound += error(length * self.longest[lane] / square[lane], angles[lane]);
                } else {
                    for segment in start.max(from)..end {
                        if !joined(row, segment) {
                            let other = [self.points[segment], self.points[segment + 1]];
                            let (angle, bound) = half_solid_angle_with_bound([a, b], other);
                            part.sum += if ABS { angle.abs() } else { angle };
                            part.bound += bound;
                        }
                    }
                }
            }
            if let Some(own) = each.get_mut(row) {
                *own += part.sum - before;
            }
            part.bound += f64::EPSILON * part.sum.abs();
        }
        for lane in 0..LANES {
            part.sum += far.0[lane];
            // and the additions: as many roundings as rows at most
            part.bound += far.1[lane] + rows.len() as f64 * f64::EPSILON * far.0[lane].abs();
        }
        part
    }

    /// Distances from the beginning of the first row.
    fn stand_at(&mut self, a: Vector) {
        for step in 0..=STEPS {
            for lane in 0..LANES {
                let u = [0, 1, 2].map(|k| self.p[k][step][lane] - a[k]);
                self.square[step][lane] = dot(u, u);
                self.root[step][lane] = self.square[step][lane].sqrt();
            }
        }
    }

    /// The least squared distance in each lane, and the sum of its half solid angles, which is right where that is great enough.
    ///
    /// Letters: u, v from the row's ends a, b to one point of the block, u′, v′ to the next; A, B, C, D their squares.
    #[inline(always)]
    fn row<const ABS: bool, const FUSED: bool>(&mut self, a: Vector, b: Vector) -> [Lanes; 2] {
        let e = sub(b, a);
        let ee = dot(e, e);
        let mut least = [f64::INFINITY; LANES];
        let (mut re, mut im) = ([1.0; LANES], [0.0; LANES]);
        let (mut bb, mut nb, mut vs) = ([0.0; LANES], [0.0; LANES], [[0.0; LANES]; 3]);
        let mut g = [0.0; LANES];
        for lane in 0..LANES {
            let v = [0, 1, 2].map(|k| self.p[k][0][lane] - b[k]);
            bb[lane] = mad::<FUSED>(v[0], v[0], mad::<FUSED>(v[1], v[1], v[2] * v[2]));
            nb[lane] = bb[lane].sqrt();
            for k in 0..3 {
                vs[k][lane] = v[k];
            }
            let (aa, na) = (self.square[0][lane], self.root[0][lane]);
            // 2(|u||v| + u·v)
            g[lane] = mad::<FUSED>(2.0 * na, nb[lane], aa + (bb[lane] - ee));
        }
        for step in 0..STEPS {
            for lane in 0..LANES {
                let (aa, na) = (self.square[step][lane], self.root[step][lane]);
                let (cc, nc) = (self.square[step + 1][lane], self.root[step + 1][lane]);
                let (b2, b1) = (bb[lane], nb[lane]);
                let v = [0, 1, 2].map(|k| self.p[k][step + 1][lane] - b[k]);
                let dd = mad::<FUSED>(v[0], v[0], mad::<FUSED>(v[1], v[1], v[2] * v[2]));
                let nd = dd.sqrt();
                let ff = self.ff[step][lane];
                // twice the determinant, v·(f × e) = u·(f × e)
                let f = [0, 1, 2].map(|k| self.f[k][step][lane]);
                let x = mad::<FUSED>(f[1], e[2], -(f[2] * e[1]));
                let y = mad::<FUSED>(f[2], e[0], -(f[0] * e[2]));
                let z = mad::<FUSED>(f[0], e[1], -(f[1] * e[0]));
                let det = mad::<FUSED>(vs[0][lane], x, mad::<FUSED>(vs[1][lane], y, vs[2][lane] * z));
                let det = if ABS { det.abs() } else { det };
                // twice the scalar products, by the law of cosines
                let (b_f, c_e) = (b2 - ff, cc - ee);
                let (diagonal, beside, across) = (b_f + c_e, b_f + dd, (cc - ff) + aa);
                let g_next = mad::<FUSED>(2.0 * nc, nd, c_e + dd);
                let first = mad::<FUSED>(nd, g[lane], mad::<FUSED>(diagonal, b1, beside * na));
                let second = mad::<FUSED>(na, g_next, mad::<FUSED>(diagonal, nc, across * nd));
                let (x, y) = (mad::<FUSED>(first, second, -(det * det)), det * (first + second));
                (re[lane], im[lane]) =
                    (mad::<FUSED>(re[lane], x, -(im[lane] * y)), mad::<FUSED>(re[lane], y, im[lane] * x));
                least[lane] = if aa < least[lane] { aa } else { least[lane] };
                // what is next to this row is next along it
                self.square[step][lane] = b2;
                self.root[step][lane] = b1;
                (bb[lane], nb[lane], g[lane]) = (dd, nd, g_next);
                for k in 0..3 {
                    vs[k][lane] = v[k];
                }
            }
        }
        self.square[STEPS] = bb;
        self.root[STEPS] = nb;
        [least, angles::<FUSED>(re, im)]
    }
}

/// What rounding can do to the angles of one lane: to each determinant some eight roundings of its greatest term, against denominators of 2 R³ and
/// more; and to their product.
#[inline(always)]
fn error(spread: f64, angle: f64) -> f64 {
    f64::EPSILON * (8.0 * STEPS as f64 * spread + 16.0 * angle.abs())
}

/// The angles of complex numbers.
#[inline(always)]
fn angles<const FUSED: bool>(re: Lanes, im: Lanes) -> Lanes {
    let mut angle = [0.0; LANES];
    let mut small = true;
    for lane in 0..LANES {
        let t = im[lane] / re[lane];
        let s = t * t;
        // the arctangent's series; below 1/10 its next term is beyond rounding
        let mut sum = -1.0 / 15.0;
        for odd in [13.0, -11.0, 9.0, -7.0, 5.0, -3.0] {
            sum = mad::<FUSED>(sum, s, 1.0 / odd);
        }
        angle[lane] = mad::<FUSED>(sum * s, t, t);
        small &= s < 0.01;
    }
    if !small {
        for lane in 0..LANES {
            angle[lane] = libm::atan2(im[lane], re[lane]);
        }
    }
    angle
}

/// xy + z, rounded once where the processor can.
#[inline(always)]
fn mad<const FUSED: bool>(x: f64, y: f64, z: f64) -> f64 {
    #[expect(
        clippy::disallowed_methods,
        reason = "only where the processor has the instruction; the accuracy stated holds either way"
    )]
    if FUSED { x.mul_add(y, z) } else { x * y + z }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whatever the width of the registers, and fused or not, the sum is one and the same within its bound.
    #[test]
    fn plain_and_wide_agree() {
        let at = |k: usize| {
            let (sin, cos) = libm::sincos(0.02 * k as f64);
            [cos, sin, 0.001 * k as f64]
        };
        let points: Vec<Vector> = (0..400).map(at).collect();
        let (first, joined) = (|row: usize| row + 2, |_: usize, _: usize| false);
        let mut own = [0.0; 300];
        let wide = Block::new(&points, 256).sum::<false>(&points[..301], first, joined, &mut own);
        let plain = Block::new(&points, 256).sum_of::<false, false>(&points[..301], first, joined, &mut []);
        let pairs = (0..300).flat_map(|i| (256.max(i + 2)..320).map(move |j| (i, j)));
        let by_pairs: f64 = pairs
            .map(|(i, j)| half_solid_angle_with_bound([points[i], points[i + 1]], [points[j], points[j + 1]]).0)
            .sum();
        for part in [wide, plain] {
            assert!((part.sum - by_pairs).abs() < part.bound && part.bound < 1e-10, "{part:?} {by_pairs}");
        }
        assert!((own.iter().sum::<f64>() - wide.sum).abs() < wide.bound);
    }
}
