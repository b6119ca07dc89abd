//! A tube's surface in triangles: closed, outward, as near to the tube as is asked.

use core::f64::consts::{PI, TAU};

use super::{Ends, Tube};
use crate::DomainError;
use crate::geometry::Vector;

/// Into how many facets a tube is cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facets {
    /// Round the section, at least 3.
    pub around: u32,
    /// From end to end, at least 1.
    pub along: u32,
}

/// Where the triangles lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fit {
    /// Their corners on the tube's surface.
    #[default]
    Surface,
    /// Within the tube: meshes of tubes that touch do not overlap.
    Inside,
    /// Around the tube.
    Outside,
    /// Through it, so that the volume is the tube's.
    Volume,
}

/// The triangles of a tube. One closed surface: every edge belongs to two of them, and corners stand once.
#[derive(Clone, Debug, PartialEq)]
pub struct TubeMesh {
    /// Corners, in units of r: rings from end to end, each starting at the material line μ = 0, then those within the ends.
    pub positions: Vec<Vector>,
    /// Unit normals of the tube at the corners; of its ends, within these.
    pub normals: Vec<Vector>,
    /// t and μ of each corner.
    pub parameters: Vec<[f64; 2]>,
    /// Corners by number, counter-clockwise from outside: first the sides, then the ends.
    pub triangles: Vec<[u32; 3]>,
    /// How many of the triangles are sides, two for each facet, ring by ring.
    pub sides: usize,
    /// Unit normals of the two ends, outward.
    pub end_normals: [Vector; 2],
    /// How far the triangles lie inside (≤ 0) and outside (≥ 0) the tube, in units of r, measured.
    pub deviation: [f64; 2],
}

impl TubeMesh {
    /// The volume enclosed, in units of r³; positive, as the triangles look outward.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let Some(&origin) = self.positions.first() else { return 0.0 };
        let corner = |i: u32| -> Vector { core::array::from_fn(|k| self.positions[i as usize][k] - origin[k]) };
        let six = self.triangles.iter().map(|t| {
            let [a, b, c] = t.map(corner);
            a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        });
        six.sum::<f64>() / 6.0
    }
}

/// How the corners are placed: the share of the radius they stand at, and which way facets are halved.
#[derive(Clone, Copy, Debug)]
struct Placing {
    share: f64,
    flipped: bool,
}

/// More corners than this are refused.
const MOST: u64 = 1 << 27;
/// A share of the radius next to nothing.
const NOTHING: f64 = 1e-12;

impl Tube {
    /// Facets so many that no triangle is farther than `chord_error` (units of r) from the tube, by [`Fit`].
    ///
    /// # Errors
    /// [`DomainError`] on `chord_error` unless it is greater than 0 and not more than the radius, on `facets` if it would take too many,
    /// and as for [`mesh`](Self::mesh).
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::{Centreline, Contact, Fit, Tube};
    /// let tube = Tube::new(Centreline::new(&Contact::new(3, 0.5)?, Right, 0), 1.0, 0.0, 10.0)?;
    /// let mesh = tube.mesh(tube.facets(0.01, Fit::Surface)?, Fit::Surface)?;
    /// assert!(mesh.deviation.iter().all(|off| off.abs() <= 0.01));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn facets(&self, chord_error: f64, fit: Fit) -> Result<Facets, DomainError> {
        const FINER: f64 = 1.06;
        const ROUNDS: u32 = 400;
        let holds = chord_error > 0.0 && chord_error <= self.radius;
        DomainError::check(holds, "chord_error", chord_error, "greater than 0 and at most the tube's radius")?;
        let [start, end] = self.parameters();
        // sagittas round the section and along the outermost line
        let round = PI / libm::acos(1.0 - chord_error / self.radius);
        let sagitta = 1.0 - chord_error / self.course.bend_reach(self.radius);
        let step = 2.0 * libm::acos(sagitta.max(0.0));
        let steps = (end - start) * (self.course.bend_turning() + self.twist.abs()) / step;
        let (mut around, mut along) = (round.max(6.0), steps.max(1.0));
        for _ in 0..ROUNDS {
            let facets = Facets { around: whole(around)?, along: whole(along)? };
            let (placing, deviation) = self.placed(facets, Fit::Surface)?;
            let near = |off: [f64; 2]| off.iter().all(|off| off.abs() <= chord_error);
            // a fit of facets too coarse leads nowhere, and the share that keeps the volume is only known of the whole
            let fitted = |fit: Fit| match fit {
                Fit::Surface => Ok(deviation),
                Fit::Inside | Fit::Outside => Ok(self.placed(facets, fit)?.1),
                Fit::Volume => Ok(self.mesh(facets, fit)?.deviation),
            };
            if near(deviation) && near(fitted(fit)?) {
                return Ok(facets);
            }
            let [across, on] = self.sagittas(facets, placing)?;
            if across >= on {
                around = f64::from(facets.around + 1).max(around * FINER)
            } else {
                along = f64::from(facets.along + 1).max(along * FINER)
            }
        }
        Err(too_many(around * along))
    }

    /// The closed surface in triangles.
    ///
    /// # Errors
    /// [`DomainError`] on `facets` for less than 3 round or 1 along, or for more than 134 million corners; on `pretwist` where flush ends
    /// would cut material lines more than once: then only square ends serve.
    ///
    /// ```
    /// use nply::Handedness::Right;
    /// use nply::geometry::{Centreline, Contact, Facets, Fit, Tube};
    /// let tube = Tube::new(Centreline::new(&Contact::new(3, 0.5)?, Right, 0), 1.0, 0.0, 10.0)?;
    /// let mesh = tube.mesh(Facets { around: 48, along: 30 }, Fit::Volume)?;
    /// assert!((mesh.volume() / tube.volume() - 1.0).abs() < 1e-9);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn mesh(&self, facets: Facets, fit: Fit) -> Result<TubeMesh, DomainError> {
        const ROUNDS: u32 = 30;
        const SETTLED: f64 = 1e-10;
        let (placing, deviation) = self.placed(facets, fit)?;
        let mut mesh = self.triangulated(facets, placing)?;
        mesh.deviation = deviation;
        if fit == Fit::Volume {
            let mut share = placing.share;
            for _ in 0..ROUNDS {
                let short = self.volume() / mesh.volume();
                if (short - 1.0).abs() <= SETTLED {
                    break;
                }
                share *= libm::sqrt(short);
                mesh = self.triangulated(facets, Placing { share, ..placing })?;
            }
            mesh.deviation = self.deviation(facets, Placing { share, ..placing })?;
        }
        // facets so few that the body is turned inside out
        let coarse = "many enough to make a body: more round and along, or a chord error";
        DomainError::check(mesh.volume() > 0.0, "facets", f64::from(facets.along), coarse)?;
        Ok(mesh)
    }

    /// The share of the radius that makes the fit, the better way of halving facets, and how far the triangles then lie off.
    fn placed(&self, facets: Facets, fit: Fit) -> Result<(Placing, [f64; 2]), DomainError> {
        const ROUNDS: u32 = 40;
        check(facets)?;
        let x = TAU / f64::from(facets.around);
        let share = match fit {
            Fit::Volume => libm::sqrt(x / libm::sin(x)),
            Fit::Surface | Fit::Inside | Fit::Outside => 1.0,
        };
        let ways = [false, true].map(|flipped| Placing { share, flipped });
        let [one, other] = ways.map(|placing| self.deviation(facets, placing));
        let (one, other) = (one?, other?);
        let worst = |off: [f64; 2]| off[1].max(-off[0]);
        let (mut placing, mut off) = if worst(other) < worst(one) { (ways[1], other) } else { (ways[0], one) };
        for _ in 0..ROUNDS {
            let amiss = match fit {
                Fit::Inside => off[1],
                Fit::Outside => off[0],
                Fit::Surface | Fit::Volume => 0.0,
            };
            if amiss.abs() <= NOTHING * self.radius {
                break;
            }
            placing.share -= amiss / self.radius;
            off = self.deviation(facets, placing)?;
        }
        Ok((placing, off))
    }

    /// The point at angle α of the outline in the plane at a height: what (10) and (11) say of a strand.
    ///
    /// ```
    /// use nply::Handedness::Left;
    /// use nply::geometry::{Centreline, Contact, Section, Tube};
    /// let contact = Contact::new(3, 0.9)?;
    /// let tube = Tube::new(Centreline::new(&contact, Left, 1), 1.0, 0.0, 20.0)?;
    /// let ([x, y, _], [a, b]) = (tube.cut(4.0, 0.8), Section::new(&contact, Left).outline(1, 4.0, 0.8));
    /// assert!((x - a).abs() < 1e-13 && (y - b).abs() < 1e-13);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn cut(&self, height: f64, alpha: f64) -> Vector {
        const ROUNDS: u32 = 60; // a helix takes one
        let mut t = height / self.course.rise();
        for _ in 0..ROUNDS {
            let place = self.course.place(t);
            let step = (height - self.surface(t, alpha)[2]) / (place.speed * place.tangent[2]);
            t += step;
            if step.abs() <= 3e-14 * (1.0 + t.abs()) {
                break;
            }
        }
        let [x, y, _] = self.surface(t, alpha);
        [x, y, height]
    }

    /// How far triangles lie inside and outside, at a lattice of points. Where the course is uniform and untwisted one ring of facets is like
    /// any other, and is measured the more closely; where it is twisted, rings differ in where their columns stand, and some of them are
    /// measured; else those of one period are, or as many of them as tell.
    fn deviation(&self, facets: Facets, placing: Placing) -> Result<[f64; 2], DomainError> {
        const TWISTED: u32 = 12;
        const TELLING: u32 = 24;
        let [start, end] = self.parameters();
        let period = self.course.period() * f64::from(facets.along) / (end - start);
        let (rings, most, order) = match (self.course.is_uniform(), self.twist == 0.0) {
            (true, true) => (1, 1, 6),
            (true, false) => (facets.along, TWISTED, 6),
            (false, _) => (least(period, facets.along), TELLING, 4),
        };
        let mut off = [0.0_f64.min(placing.share - 1.0), 0.0_f64.max(placing.share - 1.0)].map(|off| off * self.radius);
        for i in (0..rings).step_by(rings.div_ceil(most) as usize) {
            let [below, above] = [self.ring(facets, i, placing.share)?, self.ring(facets, i + 1, placing.share)?];
            for j in 0..below.len() {
                let k = (j + 1) % below.len();
                for corners in halves([below[j], above[j], above[k], below[k]], placing.flipped) {
                    let [a, b, c] = corners.map(|corner| corner.position);
                    let [at_a, at_b, at_c] = corners.map(|corner| corner.t);
                    for [u, v, w] in lattice(order) {
                        let point = core::array::from_fn(|i| u * a[i] + v * b[i] + w * c[i]);
                        let distance = self.distance_from(point, u * at_a + v * at_b + w * at_c);
                        off = [off[0].min(distance), off[1].max(distance)];
                    }
                }
            }
        }
        Ok(off)
    }

    /// The greatest sagittas of edges round the section and along the tube, in the first ring.
    fn sagittas(&self, facets: Facets, placing: Placing) -> Result<[f64; 2], DomainError> {
        let [below, above] = [self.ring(facets, 0, placing.share)?, self.ring(facets, 1, placing.share)?];
        let raise = (placing.share - 1.0) * self.radius;
        let mut greatest = [0.0_f64; 2];
        for j in 0..below.len() {
            let next = below[(j + 1) % below.len()].position;
            for (i, other) in [next, above[j].position].into_iter().enumerate() {
                let off = (self.distance(mean(&[below[j].position, other])) - raise).abs();
                greatest[i] = greatest[i].max(off);
            }
        }
        Ok(greatest)
    }

    /// The corners of ring i.
    fn ring(&self, facets: Facets, i: u32, share: f64) -> Result<Vec<Corner>, DomainError> {
        let up = f64::from(i) / f64::from(facets.along);
        let mu = |j: u32| TAU * f64::from(j) / f64::from(facets.around);
        (0..facets.around).map(|j| self.corner(up, mu(j), share)).collect()
    }

    /// The point of the material line μ at a share of the way up and of the radius.
    fn corner(&self, up: f64, mu: f64, share: f64) -> Result<Corner, DomainError> {
        const ROUNDS: u32 = 200;
        let [start, end] = self.parameters();
        let level = |from: f64, to: f64| if up < 1.0 { from + up * (to - from) } else { to };
        let mut t = level(start, end);
        if self.ends == Ends::Square {
            return Ok(Corner { position: self.inside(t, self.section_angle(t, mu), share), t, mu });
        }
        // flush rings lie in planes
        let z = level(self.from, self.to);
        for _ in 0..ROUNDS {
            let mut position = self.inside(t, self.section_angle(t, mu), share);
            let place = self.course.place(t);
            let step = (z - position[2]) / (place.speed * place.tangent[2]);
            t += step;
            if step.abs() <= 3e-14 * (1.0 + t.abs()) {
                position[2] = z;
                return Ok(Corner { position, t, mu });
            }
        }
        Err(DomainError {
            quantity: "pretwist",
            value: self.twist,
            allowed: "less for flush ends, which would cut material lines more than once: take square ends",
        })
    }

    fn triangulated(&self, facets: Facets, placing: Placing) -> Result<TubeMesh, DomainError> {
        let (m, rows) = (facets.around, facets.along);
        let mut corners = Vec::new();
        for i in 0..=rows {
            corners.extend(self.ring(facets, i, placing.share)?);
        }
        let mut triangles = Vec::new();
        for i in 0..rows {
            for j in 0..m {
                let k = (j + 1) % m;
                let [low, high] = [i * m, (i + 1) * m];
                triangles.extend(halves([low + j, high + j, high + k, low + k], placing.flipped));
            }
        }
        let sides = triangles.len();
        let normals = corners.iter().map(|corner| self.normal(corner.t, self.section_angle(corner.t, corner.mu)));
        let mut normals: Vec<Vector> = normals.collect();
        let [start, end] = self.parameters();
        let end_normals = match self.ends {
            Ends::Flush => [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]],
            Ends::Square => [self.course.place(start).tangent.map(|x| -x), self.course.place(end).tangent],
        };
        for (top, normal) in end_normals.into_iter().enumerate() {
            self.close(facets, placing, top == 1, &mut corners, &mut triangles)?;
            normals.resize(corners.len(), normal);
        }
        Ok(TubeMesh {
            positions: corners.iter().map(|corner| corner.position).collect(),
            parameters: corners.iter().map(|corner| [corner.t, corner.mu]).collect(),
            normals,
            triangles,
            sides,
            end_normals,
            deviation: [0.0; 2],
        })
    }

    /// Closes an end: rings of corners inwards, as many as keep every triangle's face outward, and one corner in the middle.
    fn close(
        &self,
        facets: Facets,
        placing: Placing,
        top: bool,
        corners: &mut Vec<Corner>,
        triangles: &mut Vec<[u32; 3]>,
    ) -> Result<(), DomainError> {
        const MOST_RINGS: u32 = 64;
        let m = facets.around;
        let (up, edge) = if top { (1.0, facets.along * m) } else { (0.0, 0) };
        let first = u32::try_from(corners.len()).map_err(|_| too_many(f64::INFINITY))?;
        let mut rings = 1;
        loop {
            let mut inner = Vec::new();
            for ring in (1..rings).rev() {
                let share = placing.share * f64::from(ring) / f64::from(rings);
                for j in 0..m {
                    inner.push(self.corner(up, TAU * f64::from(j) / f64::from(m), share)?);
                }
            }
            inner.push(self.corner(up, 0.0, 0.0)?);
            let middle = first + (rings - 1) * m;
            let number = |ring: u32, j: u32| if ring == 0 { edge + j } else { first + (ring - 1) * m + j };
            let mut faces = Vec::new();
            for j in 0..m {
                let k = (j + 1) % m;
                for ring in 0..rings - 1 {
                    faces.extend(halves(
                        [number(ring, j), number(ring + 1, j), number(ring + 1, k), number(ring, k)],
                        false,
                    ));
                }
                faces.push([number(rings - 1, j), middle, number(rings - 1, k)]);
            }
            if !top {
                // from below the other way round
                faces.iter_mut().for_each(|face| face.swap(1, 2));
            }
            let at = |i: u32| {
                if i < first { corners[i as usize].position } else { inner[(i - first) as usize].position }
            };
            let down = if top { 1.0 } else { -1.0 };
            let outward = self.ends == Ends::Square
                || faces.iter().all(|face| {
                    let [a, b, c] = face.map(at);
                    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) * down > 0.0
                });
            if outward || rings >= MOST_RINGS {
                corners.extend(inner);
                triangles.extend(faces);
                return Ok(());
            }
            rings *= 2;
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Corner {
    position: Vector,
    t: f64,
    mu: f64,
}

/// A facet in two triangles; its corners run below, above, above and next, below and next.
fn halves<T: Copy>([a, b, c, d]: [T; 4], flipped: bool) -> [[T; 3]; 2] {
    if flipped { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
}

/// Weights of the corners at the points of a triangle that part its edges into so many pieces, without the first corner.
fn lattice(order: u32) -> impl Iterator<Item = [f64; 3]> {
    let share = move |k: u32| f64::from(k) / f64::from(order);
    (0..=order).flat_map(move |i| (0..=order - i).map(move |j| [share(i), share(j), share(order - i - j)])).skip(1)
}

fn mean(points: &[Vector]) -> Vector {
    core::array::from_fn(|i| points.iter().map(|point| point[i]).sum::<f64>() / points.len() as f64)
}

fn check(facets: Facets) -> Result<(), DomainError> {
    let corners = u64::from(facets.around) * (u64::from(facets.along) + 1);
    if facets.around >= 3 && facets.along >= 1 && corners <= MOST { Ok(()) } else { Err(too_many(corners as f64)) }
}

fn too_many(corners: f64) -> DomainError {
    let allowed =
        "at least 3 round and 1 along, with at most 134217728 corners: allow a greater chord error or a shorter ply";
    DomainError { quantity: "facets", value: corners, allowed }
}

/// A number of rings, at least 1 and at most as many as there are.
fn least(rings: f64, most: u32) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
    let rings = libm::ceil(rings).clamp(1.0, f64::from(most)) as u32;
    rings
}

fn whole(count: f64) -> Result<u32, DomainError> {
    if count.is_nan() || count > MOST as f64 {
        return Err(too_many(count));
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive and less than 2^27")]
    Ok(libm::ceil(count) as u32)
}
