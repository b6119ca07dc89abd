//! The picture: what the eye sees, row by row.

use nply::geometry::Vector;

use super::body::{Body, Ray, Spot};
use super::light::{HARD, Reach, SOFT, Surface, byte, dot, linear, reach, shown};
use crate::mesh::Assembly;

/// What is behind the ply.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Ground {
    /// A warm white.
    #[default]
    Light,
    /// Nearly black.
    Dark,
    /// Nothing: the picture can be laid over any other; shadows are kept.
    Transparent,
}

/// From where, how large, on what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Pixels across, 16 to 16384.
    pub width: u32,
    /// Pixels up; fitted to what is shown, if none is said.
    pub height: Option<u32>,
    /// How far the ply is turned about its own axis, rad.
    pub turn: f64,
    /// How far its near end is turned towards the eye, rad: 0 from the side, π/2 along the axis.
    pub tilt: f64,
    /// How far its axis is turned in the picture from lying across, rad.
    pub roll: f64,
    /// What is behind.
    pub ground: Ground,
    /// Whether it throws a shadow on what is behind.
    pub shadow: bool,
}

impl Default for View {
    fn default() -> Self {
        Self { width: 1200, height: None, turn: 0.0, tilt: 0.35, roll: 0.0, ground: Ground::Light, shadow: true }
    }
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// Larger or smaller than a picture can be.
    #[error("a picture is 16 to 16384 pixels wide and high, not {width} by {height}")]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels up.
        height: u32,
    },
    /// An angle that is none.
    #[error("the angles of a view are finite numbers")]
    Angle,
    /// Nothing to be seen.
    #[error("there is nothing to be seen")]
    Empty,
    /// The encoder refused.
    #[error("the picture cannot be encoded: {0}")]
    Encode(String),
}

/// A body, and where it stands in the picture.
struct Placed<'a> {
    body: Body<'a>,
    /// the middle of the body, in the picture's frame
    middle: Vector,
    height: f64,
}

/// A picture that can be asked for its rows, in any order and by any number of threads.
pub struct Picture<'a> {
    bodies: Vec<Placed<'a>>,
    /// rows: right, up and towards the eye, in the ply's frame
    frame: [Vector; 3],
    view: View,
    height: u32,
    /// units of r per pixel
    pixel: f64,
    centre: [f64; 2],
    /// the plane behind
    back: f64,
    farthest: f64,
}

/// What a ray found.
struct Seen {
    body: usize,
    spot: Spot,
    place: Vector,
}

/// A wire of a body, or its cut end.
type Face = (usize, usize, bool);

/// How much a shadow darkens what is behind.
const SHADOW: f64 = 0.36;
/// The finest picture.
const LARGEST: u32 = 16_384;

impl<'a> Picture<'a> {
    /// Of assemblies, each with its middle at a place (units of r; across, up and towards the eye), all seen from the same side.
    ///
    /// # Errors
    /// [`RenderError`] for a view that has no size or no angle, and where there is nothing to be seen.
    pub fn of(assemblies: &[(&'a Assembly, Vector)], view: View) -> Result<Self, RenderError> {
        const MARGIN: f64 = 1.2; // in units of r
        if ![view.turn, view.tilt, view.roll].iter().all(|angle| angle.is_finite()) {
            return Err(RenderError::Angle);
        }
        let frame = frame(view);
        let bodies: Vec<Placed<'a>> = assemblies
            .iter()
            .filter(|(assembly, _)| !assembly.wires.is_empty())
            .map(|(assembly, middle)| {
                let body = Body::of(assembly);
                let [low, high] = body.heights();
                Placed { body, middle: *middle, height: 0.5 * (low + high) }
            })
            .collect();
        if bodies.is_empty() {
            return Err(RenderError::Empty);
        }
        // the box in the picture's frame: discs at both ends, swept along the axis
        let mut limits = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for placed in &bodies {
            let [low, high] = placed.body.heights();
            for (i, limit) in limits.iter_mut().enumerate() {
                let along = frame[i][2];
                let across = placed.body.reach * libm::sqrt((1.0 - along * along).max(0.0));
                let ends = 0.5 * (high - low) * along.abs();
                limit[0] = limit[0].min(placed.middle[i] - ends - across);
                limit[1] = limit[1].max(placed.middle[i] + ends + across);
            }
        }
        let size = |i: usize| limits[i][1] - limits[i][0] + 2.0 * MARGIN;
        let width = f64::from(view.width);
        let (pixel, height) = match view.height {
            Some(height) => ((size(0) / width).max(size(1) / f64::from(height)), height),
            None => {
                let pixel = size(0) / width;
                #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
                let height = libm::ceil(size(1) / pixel).clamp(16.0, f64::from(u32::MAX)) as u32;
                (pixel, height)
            }
        };
        if ![view.width, height].iter().all(|size| (16..=LARGEST).contains(size)) {
            return Err(RenderError::Size { width: view.width, height });
        }
        let centre = [0, 1].map(|i| 0.5 * (limits[i][0] + limits[i][1]));
        let reach = bodies.iter().map(|placed| placed.body.reach).fold(0.0, f64::max);
        let farthest = limits.iter().map(|[low, high]| high - low).sum::<f64>() + 10.0;
        Ok(Self { bodies, frame, view, height, pixel, centre, back: limits[2][0] - 0.1 * reach, farthest })
    }

    /// Pixels across.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.view.width
    }

    /// Pixels up.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.height
    }

    /// A row of pixels from the top: red, green, blue, cover.
    #[must_use]
    pub fn row(&self, row: u32) -> Vec<[u8; 4]> {
        (0..self.view.width).map(|column| self.pixel(column, row)).collect()
    }

    /// The rows as a PNG.
    ///
    /// # Errors
    /// [`RenderError::Encode`] where there are not as many rows as the picture has.
    pub fn png(&self, rows: &[Vec<[u8; 4]>]) -> Result<Vec<u8>, RenderError> {
        let refused = |error: png::EncodingError| RenderError::Encode(error.to_string());
        let transparent = self.view.ground == Ground::Transparent;
        let bytes: Vec<u8> =
            rows.iter().flatten().flat_map(|p| p[..if transparent { 4 } else { 3 }].to_vec()).collect();
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.view.width, self.height);
        encoder.set_color(if transparent { png::ColorType::Rgba } else { png::ColorType::Rgb });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let mut writer = encoder.write_header().map_err(refused)?;
        writer.write_image_data(&bytes).map_err(refused)?;
        writer.finish().map_err(refused)?;
        Ok(file)
    }

    /// A pixel: four rays, and where they see different things, sixteen.
    fn pixel(&self, column: u32, row: u32) -> [u8; 4] {
        let ray = |x: f64, y: f64| {
            let right = self.centre[0] + (f64::from(column) + x - 0.5 * f64::from(self.view.width)) * self.pixel;
            let up = self.centre[1] - (f64::from(row) + y - 0.5 * f64::from(self.height)) * self.pixel;
            self.seen(right, up)
        };
        const FOUR: [[f64; 2]; 4] = [[0.375, 0.125], [0.875, 0.375], [0.125, 0.625], [0.625, 0.875]];
        let mut seen: Vec<(Option<Seen>, [f64; 2])> = FOUR.iter().map(|[x, y]| ray(*x, *y)).collect();
        let kind = |found: &Option<Seen>| {
            found.as_ref().map(|seen| (seen.body, seen.spot.wire, seen.spot.on_end, self.striped(seen)))
        };
        let first = kind(&seen[0].0);
        if seen.iter().any(|(found, _)| kind(found) != first) {
            let sixteen = (0..16).map(|k| ray((f64::from(k % 4) + 0.5) / 4.0, (f64::from(k / 4) + 0.5) / 4.0));
            seen = sixteen.collect();
        }
        // what of the light reaches a surface is found once for each that is seen
        let mut known: Vec<(Option<Face>, Reach)> = Vec::new();
        let mut sum = [0.0; 4];
        for (found, place) in &seen {
            let surface = found.as_ref().map(|seen| (seen.body, seen.spot.wire, seen.spot.on_end));
            let reached = match known.iter().find(|(other, _)| *other == surface) {
                Some((_, reached)) => *reached,
                None => {
                    let reached = self.reached(found.as_ref(), *place);
                    known.push((surface, reached));
                    reached
                }
            };
            let colour = self.colour(found.as_ref(), reached);
            (0..4).for_each(|i| sum[i] += colour[i]);
        }
        let count = seen.len() as f64;
        let cover = sum[3] / count;
        // colours are weighed by their cover
        let of = |i: usize| byte(if cover > 0.0 { sum[i] / sum[3] } else { 0.0 });
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
        let cover = (cover * 255.0 + 0.5).clamp(0.0, 255.0) as u8;
        [of(0), of(1), of(2), cover]
    }

    /// What is seen at a place of the picture.
    fn seen(&self, right: f64, up: f64) -> (Option<Seen>, [f64; 2]) {
        let from = [right, up, self.farthest];
        let mut nearest: Option<(f64, Seen)> = None;
        for (body, placed) in self.bodies.iter().enumerate() {
            let ray = Ray { from: self.local(placed, from), along: self.frame[2].map(|x| -x) };
            if let Some((far, spot)) = placed.body.hit(&ray)
                && nearest.as_ref().is_none_or(|(least, _)| far < *least)
            {
                nearest = Some((far, Seen { body, spot, place: [right, up, self.farthest - far] }));
            }
        }
        (nearest.map(|(_, seen)| seen), [right, up])
    }

    /// A point of the picture's frame as a body sees it.
    fn local(&self, placed: &Placed<'_>, point: Vector) -> Vector {
        let off: Vector = core::array::from_fn(|i| point[i] - placed.middle[i]);
        let mut local: Vector =
            core::array::from_fn(|i| self.frame[0][i] * off[0] + self.frame[1][i] * off[1] + self.frame[2][i] * off[2]);
        local[2] += placed.height;
        local
    }

    fn distance(&self, point: Vector) -> f64 {
        let of = |placed: &Placed<'_>| placed.body.distance(self.local(placed, point));
        self.bodies.iter().map(of).fold(f64::INFINITY, f64::min)
    }

    fn normal(&self, seen: &Seen) -> Vector {
        self.frame.map(|axis| dot(axis, seen.spot.normal))
    }

    fn reached(&self, seen: Option<&Seen>, [right, up]: [f64; 2]) -> Reach {
        match seen {
            Some(seen) => reach(|point| self.distance(point), seen.place, self.normal(seen), self.farthest, HARD),
            None if self.view.shadow => {
                reach(|point| self.distance(point), [right, up, self.back], [0.0, 0.0, 1.0], self.farthest, SOFT)
            }
            None => Reach { lamp: 1.0, sky: 1.0 },
        }
    }

    /// Whether a painted line runs there: a quarter of its share of the circumference.
    fn striped(&self, seen: &Seen) -> bool {
        let wire = &self.bodies[seen.body].body.wires[seen.spot.wire];
        if wire.stripes == 0 || seen.spot.on_end {
            return false;
        }
        let share = seen.spot.mu / core::f64::consts::TAU * f64::from(wire.stripes);
        share - libm::floor(share) < 0.25
    }

    /// Linear red, green and blue, times cover, and cover.
    fn colour(&self, seen: Option<&Seen>, reached: Reach) -> [f64; 4] {
        let Some(seen) = seen else {
            let dim = SHADOW * (1.0 - (0.62 * reached.lamp + 0.38 * reached.sky));
            return match self.view.ground {
                Ground::Transparent => [0.0, 0.0, 0.0, dim],
                Ground::Light => opaque([0xfb, 0xfa, 0xf7].map(|x| linear(x) * (1.0 - dim))),
                Ground::Dark => opaque([0x16, 0x18, 0x1d].map(|x| linear(x) * (1.0 - dim))),
            };
        };
        let wire = &self.bodies[seen.body].body.wires[seen.spot.wire];
        let own = if self.striped(seen) { crate::mesh::pale(wire.colour) } else { wire.colour };
        let mut colour = own.map(linear);
        if seen.spot.on_end {
            // where it was cut it is paler, as fresh ends are
            colour = colour.map(|x| 0.24 + 0.76 * x);
        }
        opaque(shown(&Surface { normal: self.normal(seen), colour, glossy: !seen.spot.on_end }, reached))
    }
}

const fn opaque([red, green, blue]: [f64; 3]) -> [f64; 4] {
    [red, green, blue, 1.0]
}

/// Right, up and towards the eye, in the ply's frame.
fn frame(view: View) -> [Vector; 3] {
    let [(st, ct), (se, ce), (sr, cr)] = [view.turn, view.tilt, view.roll].map(libm::sincos);
    // lying across: the ply's z to the right, its x up, its y towards the eye; turned about z first
    let (x, y, z) = ([ct, st, 0.0], [-st, ct, 0.0], [0.0, 0.0, 1.0]);
    // then its upper end, on the right, towards the eye
    let right: Vector = core::array::from_fn(|i| ce * z[i] - se * y[i]);
    let eye: Vector = core::array::from_fn(|i| se * z[i] + ce * y[i]);
    let rolled = |a: f64, b: f64| -> Vector { core::array::from_fn(|i| a * right[i] + b * x[i]) };
    [rolled(cr, -sr), rolled(sr, cr), eye]
}
