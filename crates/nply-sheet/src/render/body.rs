//! A ply as a body that can be asked how far away it is.

use core::f64::consts::TAU;

use nply::geometry::{Course, Tube, Vector};

use super::coil::Coil;
use crate::mesh::{Assembly, Wire};

/// Like strands, evenly round the axis: the one next to a point is told by its azimuth, and only that one is measured.
#[derive(Clone, Debug)]
struct Ring {
    first: Tube,
    /// numbers of the wires
    wires: Vec<usize>,
    /// cosine and sine of each one's turn
    turns: Vec<[f64; 2]>,
}

/// Where a point of a surface is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    /// The wire's number.
    pub(super) wire: usize,
    /// The outward normal.
    pub(super) normal: Vector,
    /// The material line μ there, rad.
    pub(super) mu: f64,
    /// On the cut across an end.
    pub(super) on_end: bool,
}

/// The wires of an assembly, cut off between two heights.
#[derive(Clone, Debug)]
pub(super) struct Body<'a> {
    pub(super) wires: &'a [Wire],
    rings: Vec<Ring>,
    coils: Vec<Coil>,
    low: f64,
    high: f64,
    pub(super) reach: f64,
}

/// A ray, its direction of length 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub(super) from: Vector,
    pub(super) along: Vector,
}

impl Ray {
    pub(super) fn at(&self, far: f64) -> Vector {
        core::array::from_fn(|i| self.from[i] + far * self.along[i])
    }
}

impl<'a> Body<'a> {
    pub(super) fn of(assembly: &'a Assembly) -> Self {
        let mut rings: Vec<Ring> = Vec::new();
        let mut coils: Vec<Coil> = Vec::new();
        for (number, wire) in assembly.wires.iter().enumerate() {
            if Coil::gather(&mut coils, number, &wire.tube) {
                continue;
            }
            let turn =
                rings.iter().enumerate().find_map(|(ring, known)| Some((ring, turned(&known.first, &wire.tube)?)));
            if let Some((ring, (sin, cos))) = turn {
                rings[ring].wires.push(number);
                rings[ring].turns.push([cos, sin]);
            } else {
                rings.push(Ring { first: wire.tube, wires: vec![number], turns: vec![[1.0, 0.0]] });
            }
        }
        let rings = rings.into_iter().flat_map(even).collect();
        let [low, high] = assembly.heights();
        Self { wires: &assembly.wires, rings, coils, low, high, reach: assembly.reach() }
    }

    pub(super) const fn heights(&self) -> [f64; 2] {
        [self.low, self.high]
    }

    /// How far a point is from the wires' surfaces, as if they had no ends, or from tubes that enclose strands, where these are far off;
    /// negative inside.
    fn outside_by(&self, point: Vector) -> f64 {
        const FAR: f64 = 2.0;
        let off_axis = libm::hypot(point[0], point[1]);
        let mut least = f64::INFINITY;
        for ring in &self.rings {
            // no nearer than the cylinder its centrelines lie on
            let bound = (off_axis - ring.first.course().outermost()).abs() - ring.first.radius();
            if bound < least {
                least = least.min(ring.first.distance(ring.unturned(point).0));
            }
        }
        for (bound, level, coil) in self.coils_by_bound(point) {
            if bound >= least {
                break;
            }
            let off = if bound > FAR { None } else { coil.nearest(point, level) };
            least = least.min(off.map_or(bound, |foot| foot.distance - coil.radius()));
        }
        least
    }

    /// The strands, the nearest first: how near their wires can be, and where the point stands beside them.
    fn coils_by_bound(&self, point: Vector) -> Vec<(f64, f64, &Coil)> {
        let bound = |coil| {
            let (bound, level) = Coil::bound(coil, point);
            (bound, level, coil)
        };
        let mut coils: Vec<(f64, f64, &Coil)> = self.coils.iter().map(bound).collect();
        coils.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        coils
    }

    /// How far a point is from the body, ends included; 0 or less inside. Beyond an end it is near enough for shadows.
    pub(super) fn distance(&self, point: Vector) -> f64 {
        const FAR: f64 = 12.0;
        let beyond = (self.low - point[2]).max(point[2] - self.high);
        let around = libm::hypot(point[0], point[1]) - self.reach;
        let surface = if around > FAR { around } else { self.outside_by(point) };
        if surface > 0.0 && beyond > 0.0 { libm::hypot(surface, beyond) } else { surface.max(beyond) }
    }

    /// Where a ray first meets the body, and what is there.
    ///
    /// It goes on by the distance that is free, and along a surface, where that is next to nothing, by a least step: what it could pass over so is
    /// sunk into it by 1e-5 of r.
    pub(super) fn hit(&self, ray: &Ray) -> Option<(f64, Spot)> {
        const STEPS: u32 = 5000;
        const NEAR: f64 = 1e-5;
        const LEAST: f64 = 0.01;
        let (mut far, end, through_plane) = self.span(ray)?;
        if through_plane {
            let point = ray.at(far);
            if self.outside_by(point) < 0.0 {
                let (_, mut spot) = self.spot(point);
                spot.normal = [0.0, 0.0, if ray.along[2] > 0.0 { -1.0 } else { 1.0 }];
                spot.on_end = true;
                return Some((far, spot));
            }
        }
        let mut before = far;
        for _ in 0..STEPS {
            let free = self.outside_by(ray.at(far));
            if free < NEAR {
                let far = self.surface(ray, before, far);
                return Some((far, self.spot(ray.at(far)).1));
            }
            before = far;
            far += free.max(LEAST);
            if far > end {
                return None;
            }
        }
        None
    }

    /// Where a ray that is outside at `before` and no more at `far` comes to the surface.
    fn surface(&self, ray: &Ray, mut before: f64, mut far: f64) -> f64 {
        for _ in 0..12 {
            let middle = 0.5 * (before + far);
            if self.outside_by(ray.at(middle)) > 0.0 { before = middle } else { far = middle }
        }
        before
    }

    /// The stretch of a ray within the enclosing cylinder and between the ends; whether it enters through the plane of an end.
    fn span(&self, ray: &Ray) -> Option<(f64, f64, bool)> {
        let ([x, y, z], [u, v, w]) = (ray.from, ray.along);
        let (a, b) = (u * u + v * v, x * u + y * v);
        let c = x * x + y * y - self.reach * self.reach;
        let (mut enter, mut leave) = (0.0, f64::INFINITY);
        if a > 1e-18 {
            let root = b * b - a * c;
            if root < 0.0 {
                return None;
            }
            let root = libm::sqrt(root);
            (enter, leave) = (((-b - root) / a).max(0.0), (-b + root) / a);
        } else if c > 0.0 {
            return None;
        }
        let mut through_plane = false;
        if w.abs() > 1e-12 {
            let (one, other) = ((self.low - z) / w, (self.high - z) / w);
            if one.min(other) > enter {
                (enter, through_plane) = (one.min(other), true);
            }
            leave = leave.min(one.max(other));
        } else if z < self.low || z > self.high {
            return None;
        }
        (enter < leave).then_some((enter, leave, through_plane))
    }

    /// The wire whose surface is nearest to a point, and what is there.
    fn spot(&self, point: Vector) -> (f64, Spot) {
        let mut best: Option<(f64, Spot)> = None;
        for ring in &self.rings {
            let (local, place) = ring.unturned(point);
            let (t, distance) = ring.first.course().nearest(local);
            let off = distance - ring.first.radius();
            if best.is_some_and(|(least, _)| least <= off) {
                continue;
            }
            let foot = ring.first.course().place(t);
            let out: Vector = core::array::from_fn(|i| (local[i] - foot.position[i]) / distance.max(1e-12));
            let dot = |a: Vector| a[0] * out[0] + a[1] * out[1] + a[2] * out[2];
            let alpha = libm::atan2(dot(foot.inward), dot(foot.binormal));
            let [cos, sin] = ring.turns[place];
            let normal = [cos * out[0] - sin * out[1], sin * out[0] + cos * out[1], out[2]];
            let mu = alpha + ring.first.twist() * t;
            best = Some((off, Spot { wire: ring.wires[place], normal, mu, on_end: false }));
        }
        for (bound, level, coil) in self.coils_by_bound(point) {
            if best.is_some_and(|(least, _)| least <= bound) {
                break;
            }
            let Some(foot) = coil.nearest(point, level) else { continue };
            let off = foot.distance - coil.radius();
            let Some(course) = coil.course(foot.wire).filter(|_| best.is_none_or(|(least, _)| off < least)) else {
                continue;
            };
            let place = course.place(foot.t);
            let normal: Vector = core::array::from_fn(|i| (point[i] - place.position[i]) / foot.distance.max(1e-12));
            let dot = |a: Vector| a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2];
            let mu = libm::atan2(dot(place.inward), dot(place.binormal)) + self.wires[foot.wire].tube.twist() * foot.t;
            best = Some((off, Spot { wire: foot.wire, normal, mu, on_end: false }));
        }
        best.unwrap_or((f64::INFINITY, Spot { wire: 0, normal: [0.0, 0.0, 1.0], mu: 0.0, on_end: false }))
    }
}

impl Ring {
    /// The point as the first strand sees it, where the strand next to it stands; and that strand's place.
    fn unturned(&self, point: Vector) -> (Vector, usize) {
        let count = self.wires.len();
        let back = |place: usize| {
            let [cos, sin] = self.turns[place];
            ([cos * point[0] + sin * point[1], cos * point[1] - sin * point[0], point[2]], place)
        };
        let (true, Course::Helix(helix)) = (count > 1, self.first.course()) else { return back(0) };
        // the first strand's azimuth at this height, as an angle from the x axis
        let at = helix.position(point[2] / helix.rise());
        let behind = libm::atan2(point[1], point[0]) - libm::atan2(at[1], at[0]);
        let share = behind / TAU;
        let places = libm::floor((share - libm::floor(share)) * count as f64 + 0.5);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the count")]
        let place = places as usize % count;
        back(place)
    }
}

/// Sine and cosine of the turn about the axis that takes one tube to another, if one does.
fn turned(first: &Tube, other: &Tube) -> Option<(f64, f64)> {
    let (Course::Helix(a), Course::Helix(b)) = (first.course(), other.course()) else { return None };
    let same = |x: f64, y: f64| x.to_bits() == y.to_bits();
    let like = same(a.radius(), b.radius())
        && same(a.azimuth_rate(), b.azimuth_rate())
        && same(first.radius(), other.radius())
        && same(first.twist(), other.twist());
    (like && a.radius() > 0.0).then(|| libm::sincos(b.azimuth(0.0) - a.azimuth(0.0)))
}

/// A ring whose strands stand evenly, or else one for each of them.
fn even(ring: Ring) -> Vec<Ring> {
    let count = ring.wires.len();
    let evenly = ring.turns.iter().enumerate().all(|(i, [cos, sin])| {
        let (s, c) = libm::sincos(TAU * i as f64 / count as f64);
        (s - sin).abs() < 1e-9 && (c - cos).abs() < 1e-9
    });
    if evenly {
        return vec![ring];
    }
    let Ring { first, wires, turns } = ring;
    // a single strand, turned: the point is turned back instead
    wires.into_iter().zip(turns).map(|(wire, turn)| Ring { first, wires: vec![wire], turns: vec![turn] }).collect()
}
