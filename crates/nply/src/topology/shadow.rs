//! A curve as it is seen along a direction: boxes round its pieces, and the twist of the direction along it.
#![allow(clippy::needless_range_loop, reason = "lanes and steps are places in several arrays at once")]

use super::view::View;
use crate::numerics::vector::{Vector, cross, dot, norm, sub, unit};

/// Segments of the least piece, and pieces that are worked out side by side.
pub(crate) const PIECE: usize = 8;
const WIDTH: usize = 8;
const CHUNK: usize = PIECE * WIDTH;
type Lanes = [f64; WIDTH];

/// A piece of a curve as it is seen: a box round it, and which way it runs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) low: [f64; 2],
    pub(crate) high: [f64; 2],
    /// One bit for each of eight directions, a set one where all segments run along it: such a piece cannot cross itself.
    pub(crate) ways: u8,
}

impl Piece {
    fn join(self, other: Self) -> Self {
        Self {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
            ways: self.ways & other.ways,
        }
    }

    #[inline(always)]
    pub(crate) fn apart(&self, other: &Self) -> bool {
        // all four at once: which of them holds cannot be foreseen, and a wrong guess costs more than all
        (self.low[0] > other.high[0])
            | (other.low[0] > self.high[0])
            | (self.low[1] > other.high[1])
            | (other.low[1] > self.high[1])
    }
}

/// The pieces of a curve: eight segments each, then twice as many, up to the whole.
pub(crate) struct Shadow {
    /// all levels, the finest first
    pieces: Vec<Piece>,
    /// where each level starts
    starts: Vec<usize>,
    /// how far a place in the shadow may be off
    blur: f64,
}

impl Shadow {
    pub(crate) fn levels(&self) -> usize {
        self.starts.len() - 1
    }

    pub(crate) fn level(&self, level: usize) -> &[Piece] {
        &self.pieces[self.starts[level]..self.starts[level + 1]]
    }

    pub(crate) fn blur(&self) -> f64 {
        self.blur
    }

    fn over(mut pieces: Vec<Piece>, blur: f64) -> Self {
        let mut starts = vec![0, pieces.len()];
        let mut last = 0;
        while pieces.len() - last > 1 {
            let end = pieces.len();
            for k in (last..end).step_by(2) {
                let piece = if k + 1 < end { pieces[k].join(pieces[k + 1]) } else { pieces[k] };
                pieces.push(piece);
            }
            last = end;
            starts.push(pieces.len());
        }
        Self { pieces, starts, blur }
    }
}

/// How often the direction one looks along turns round the curve, as a field carried along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FramingTwist {
    /// in turns
    pub(crate) turns: f64,
    /// what rounding can have done to it
    pub(crate) bound: f64,
}

/// A curve as it is seen along one direction: boxes round all its pieces, and how often the direction turns about it.
pub(crate) struct Sight {
    pub(crate) view: View,
    pub(crate) shadow: Shadow,
    /// of closed curves, where it was asked for
    pub(crate) twist: FramingTwist,
    /// whether the shadow of a corner turns back on itself, to neither side
    degenerate: bool,
}

impl Sight {
    /// Nothing, where the direction shows a corner from neither side.
    pub(crate) fn clear(self) -> Option<Self> {
        (!self.degenerate).then_some(self)
    }
}

/// Looks at a polygon along two directions at once.
pub(crate) fn look<const TWIST: bool>(points: &[Vector], segments: usize, views: [View; 2]) -> [Sight; 2] {
    let blur = BLUR * reach_of(points);
    let mut gauge = Gauge { points, segments, blur, tallies: views.map(|view| Tally::new(view, segments)) };
    gauge.measure::<TWIST>();
    gauge.tallies.map(|tally| {
        let turns = tally.angle / core::f64::consts::TAU;
        let bound = 16.0 * f64::EPSILON * tally.worst + 4.0 * f64::EPSILON * turns.abs();
        Sight {
            view: tally.view,
            shadow: Shadow::over(tally.pieces, blur),
            twist: FramingTwist { turns, bound },
            degenerate: tally.degenerate,
        }
    })
}

/// What rounding can do to the place of a shadow, times the greatest coordinate.
const BLUR: f64 = 32.0 * f64::EPSILON;
/// A part of a unit vector that is surely not zero.
const SURE: f64 = 16.0 * f64::EPSILON;

/// One unit vector per lane.
type Units = [Lanes; 3];

struct Gauge<'a> {
    points: &'a [Vector],
    segments: usize,
    blur: f64,
    tallies: [Tally; 2],
}

/// What is kept of one direction.
struct Tally {
    view: View,
    pieces: Vec<Piece>,
    degenerate: bool,
    angle: f64,
    worst: f64,
    /// the direction of the segment before, in the frame of the view
    before: Vector,
}

impl Gauge<'_> {
    /// With as wide registers as the processor has: the same products and sums, and so the same bits.
    fn measure<const TWIST: bool>(&mut self) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            #[expect(unsafe_code, reason = "the processor was just asked for what the function needs")]
            // SAFETY: AVX2 is there.
            unsafe {
                self.measure_wide::<TWIST>();
            }
            return;
        }
        self.run::<TWIST>();
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn measure_wide<const TWIST: bool>(&mut self) {
        self.run::<TWIST>();
    }

    #[inline(always)]
    fn run<const TWIST: bool>(&mut self) {
        let n = self.points.len();
        let last = unit(sub(self.points[self.segments % n], self.points[self.segments - 1]));
        for tally in &mut self.tallies {
            tally.before = tally.view.seen(last);
        }
        for start in (0..self.segments).step_by(CHUNK) {
            let count = CHUNK.min(self.segments - start);
            // steps down, pieces across; the last point is repeated at the end
            let mut p = [[[0.0; WIDTH]; PIECE + 1]; 3];
            if let Some(points) = self.points.get(start..=start + CHUNK) {
                for lane in 0..WIDTH {
                    for step in 0..=PIECE {
                        for k in 0..3 {
                            p[k][step][lane] = points[lane * PIECE + step][k];
                        }
                    }
                }
            } else {
                for lane in 0..WIDTH {
                    for step in 0..=PIECE {
                        let point = self.points[(start + (lane * PIECE + step).min(count)) % n];
                        for k in 0..3 {
                            p[k][step][lane] = point[k];
                        }
                    }
                }
            }
            let units = directions(&p);
            for tally in &mut self.tallies {
                let seen = tally.box_in(&p, &units, count, self.blur);
                if TWIST {
                    tally.turn(&seen, self.points, start, count);
                }
            }
        }
    }
}

/// The directions of the segments of a chunk; no numbers past the end.
#[inline(always)]
fn directions(p: &[[Lanes; PIECE + 1]; 3]) -> [Units; PIECE] {
    let mut units = [[[0.0; WIDTH]; 3]; PIECE];
    for step in 0..PIECE {
        for lane in 0..WIDTH {
            let [x, y, z] = [0, 1, 2].map(|k| p[k][step + 1][lane] - p[k][step][lane]);
            let inverse = 1.0 / (x * x + y * y + z * z).sqrt();
            units[step][0][lane] = x * inverse;
            units[step][1][lane] = y * inverse;
            units[step][2][lane] = z * inverse;
        }
    }
    units
}

impl Tally {
    fn new(view: View, segments: usize) -> Self {
        let pieces = Vec::with_capacity(2 * segments.div_ceil(PIECE) + 64);
        Self { view, pieces, degenerate: false, angle: 0.0, worst: 0.0, before: [0.0; 3] }
    }

    /// Boxes of the pieces of a chunk, and their segments' directions in the frame of the view.
    #[inline(always)]
    fn box_in(
        &mut self,
        p: &[[Lanes; PIECE + 1]; 3],
        units: &[Units; PIECE],
        count: usize,
        blur: f64,
    ) -> [Units; PIECE] {
        let View { u, v, .. } = self.view;
        let mut low = [[f64::INFINITY; WIDTH]; 2];
        let mut high = [[f64::NEG_INFINITY; WIDTH]; 2];
        for step in 0..=PIECE {
            for lane in 0..WIDTH {
                let q = [p[0][step][lane], p[1][step][lane], p[2][step][lane]];
                let (x, y) = (dot(u, q), dot(v, q));
                low[0][lane] = least(low[0][lane], x);
                low[1][lane] = least(low[1][lane], y);
                high[0][lane] = most(high[0][lane], x);
                high[1][lane] = most(high[1][lane], y);
            }
        }
        let mut seen = [[[0.0; WIDTH]; 3]; PIECE];
        // least and greatest part along x, y, x + y and x − y; no number past the end, which is passed over
        let mut run = [[[f64::INFINITY; WIDTH]; 4], [[f64::NEG_INFINITY; WIDTH]; 4]];
        for step in 0..PIECE {
            for lane in 0..WIDTH {
                let q = [units[step][0][lane], units[step][1][lane], units[step][2][lane]];
                let [x, y, z] = self.view.seen(q);
                seen[step][0][lane] = x;
                seen[step][1][lane] = y;
                seen[step][2][lane] = z;
                for (k, way) in [x, y, x + y, x - y].into_iter().enumerate() {
                    run[0][k][lane] = least(run[0][k][lane], way);
                    run[1][k][lane] = most(run[1][k][lane], way);
                }
            }
        }
        for lane in 0..count.div_ceil(PIECE) {
            let mut ways = 0;
            for k in 0..4 {
                ways |= u8::from(run[0][k][lane] > SURE) << k;
                ways |= u8::from(run[1][k][lane] < -SURE) << (k + 4);
            }
            self.pieces.push(Piece {
                low: [low[0][lane] - blur, low[1][lane] - blur],
                high: [high[0][lane] + blur, high[1][lane] + blur],
                ways,
            });
        }
        seen
    }

    /// Adds up the turns of d at the corners of a chunk: at the beginning of each of its segments.
    #[inline(always)]
    fn turn(&mut self, units: &[Units; PIECE], points: &[Vector], start: usize, count: usize) {
        let mut first = [[0.0; WIDTH]; 3];
        for k in 0..3 {
            first[k][0] = self.before[k];
            for lane in 1..WIDTH {
                first[k][lane] = units[PIECE - 1][k][lane - 1];
            }
        }
        let (mut re, mut im) = ([[0.0; WIDTH]; PIECE], [[0.0; WIDTH]; PIECE]);
        let (mut product, mut rest) = ([1.0; WIDTH], [0.0; WIDTH]);
        let (mut narrow, mut smallest, mut greatest) = ([f64::INFINITY; WIDTH], [f64::INFINITY; WIDTH], [0.0; WIDTH]);
        for step in 0..PIECE {
            let from = if step == 0 { &first } else { &units[step - 1] };
            for lane in 0..WIDTH {
                let a = [from[0][lane], from[1][lane], from[2][lane]];
                let b = [units[step][0][lane], units[step][1][lane], units[step][2][lane]];
                let (x, y, across) = corner(a, b);
                re[step][lane] = x;
                im[step][lane] = y;
                (product[lane], rest[lane]) = (product[lane] * x - rest[lane] * y, product[lane] * y + rest[lane] * x);
                narrow[lane] = lesser(narrow[lane], x - 32.0 * y.abs());
                smallest[lane] = lesser(smallest[lane], x);
                greatest[lane] = most(greatest[lane], across);
            }
        }
        let all_narrow = narrow.iter().all(|&x| x > 0.0) && smallest.iter().all(|&x| x > 1e-3);
        if count == CHUNK && all_narrow {
            // 64 corners of less than 1/32 rad each
            let (mut x, mut y) = (1.0, 0.0);
            for lane in 0..WIDTH {
                (x, y) = (x * product[lane] - y * rest[lane], x * rest[lane] + y * product[lane]);
                self.worst += PIECE as f64 * (greatest[lane] / (smallest[lane] * smallest[lane])).sqrt();
            }
            self.angle += libm::atan2(y, x);
        } else {
            for at in 0..count {
                let (step, lane) = (at % PIECE, at / PIECE);
                let from = if step == 0 { &first } else { &units[step - 1] };
                let a = [from[0][lane], from[1][lane], from[2][lane]];
                let b = [units[step][0][lane], units[step][1][lane], units[step][2][lane]];
                self.turn_at(points, start + at, a, b, re[step][lane], im[step][lane]);
            }
        }
        let (step, lane) = ((count - 1) % PIECE, (count - 1) / PIECE);
        self.before = [units[step][0][lane], units[step][1][lane], units[step][2][lane]];
    }

    /// One corner by itself.
    fn turn_at(&mut self, points: &[Vector], point: usize, a: Vector, b: Vector, re: f64, im: f64) {
        let n = points.len();
        let [before, at, after] = [points[(point + n - 1) % n], points[point], points[(point + 1) % n]];
        let (mut re, mut im) = (re, im);
        if dot(a, b) < -0.5 {
            // a hairpin: its axis a × b decides, and has more digits formed from the points than from their directions
            let (e, f) = (sub(at, before), sub(after, at));
            let axis = cross(e, f);
            let sin = norm(axis) / (norm(e) * norm(f));
            let axis = unit(axis);
            let d = self.view.d;
            let (up, from, to) = (dot(d, axis), dot(d, cross(unit(e), axis)), dot(d, cross(unit(f), axis)));
            (re, im) = (up * up + from * to, up * (to - from));
            self.worst += (1.0 + 1.0 / sin) / re.abs().max(im.abs());
        } else {
            let across = (a[0] * a[0] + a[1] * a[1]).max(b[0] * b[0] + b[1] * b[1]);
            self.worst += across.sqrt() / re.abs().max(im.abs());
        }
        if re <= 64.0 * f64::EPSILON {
            // the shadow turns back: which way round is as exact as the crossings next to it
            let side = super::orientation::turn(before, at, after, self.view.d);
            self.degenerate |= side == 0;
            im = im.abs() * f64::from(side) * (a[2] + b[2]).signum();
        }
        self.angle += libm::atan2(im, re);
    }
}

/// A complex number whose angle is that by which d turns about the curve at a corner from unit direction a to b, both in the frame of the view:
/// the angle of d's part across the curve against the axis of the corner, after less before. It stays within (−π, π). And the greater of |a × d|², |b × d|².
#[inline(always)]
fn corner(a: Vector, b: Vector) -> (f64, f64, f64) {
    let (aa, bb) = (a[0] * a[0] + a[1] * a[1], b[0] * b[0] + b[1] * b[1]);
    let along = a[0] * b[0] + a[1] * b[1];
    let side = a[0] * b[1] - a[1] * b[0];
    (along * (1.0 + a[2] * b[2]) + aa * bb, side * (a[2] + b[2]), most(aa, bb))
}

/// The greatest coordinate, either sign; eight side by side, for a chain of comparisons waits on itself.
pub(crate) fn reach_of(points: &[Vector]) -> f64 {
    let mut reach = [0.0; 24];
    let chunks = points.chunks_exact(8);
    let rest = chunks.remainder();
    for chunk in chunks {
        for (k, x) in chunk.as_flattened().iter().enumerate() {
            reach[k] = most(reach[k], x.abs());
        }
    }
    rest.iter().flatten().map(|x| x.abs()).chain(reach).fold(0.0, most)
}

/// The lesser, and x where y is no number.
#[inline(always)]
pub(crate) fn least(x: f64, y: f64) -> f64 {
    if y < x { y } else { x }
}

/// The greater, and x where y is no number.
#[inline(always)]
pub(crate) fn most(x: f64, y: f64) -> f64 {
    if y > x { y } else { x }
}

/// The lesser, and no number where y is none.
#[inline(always)]
fn lesser(x: f64, y: f64) -> f64 {
    if x < y { x } else { y }
}
