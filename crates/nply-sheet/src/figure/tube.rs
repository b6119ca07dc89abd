//! Tubes drawn as they are seen: each pixel shows what lies nearest to the eye.

use nply::geometry::Vector;

/// A tube round a line.
pub(super) struct Tube {
    /// Points of the line, close together (some hundredths of the radius), each with a direction on the tube's surface and the line's own.
    pub(super) stations: Vec<Station>,
    pub(super) radius: f64,
    pub(super) colour: [u8; 3],
}

/// A point of a tube's line.
#[derive(Clone, Copy)]
pub(super) struct Station {
    pub(super) place: Vector,
    pub(super) tangent: Vector,
    /// Where a stripe is painted; `None` for none.
    pub(super) stripe: Option<Vector>,
}

/// What is seen and from where.
pub(super) struct View {
    /// What points right, up and towards the eye.
    pub(super) right: Vector,
    pub(super) up: Vector,
    pub(super) eye: Vector,
    /// What stands in the middle of the picture.
    pub(super) centre: Vector,
    /// Pixels across and up, and pixels a unit of length.
    pub(super) size: (u32, u32),
    pub(super) zoom: f64,
    /// Tubes are cut off below and above these heights along z.
    pub(super) cut: (f64, f64),
}

/// Pixels are divided so finely before they are drawn, so that edges are smooth.
const FINE: u32 = 2;
/// How far, in radii, a ball's surface is taken for the tube's, along the line from its middle. Stations are closer than that.
const SLICE: f64 = 0.12;

/// What one fine pixel shows: how near it is, and whose it is; its colour is only found once nothing nearer can come.
#[derive(Clone, Copy)]
struct Spot {
    near: f64,
    tube: u16,
    station: u32,
    /// From the station to the surface; `None` on a cut.
    out: Option<Vector>,
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Vector) -> Vector {
    let length = libm::sqrt(dot(a, a)).max(f64::MIN_POSITIVE);
    a.map(|v| v / length)
}

impl View {
    /// The tubes as RGBA, row by row from the top; nothing where there is none.
    pub(super) fn draw(&self, tubes: &[Tube]) -> Vec<u8> {
        let (width, height) = ((self.size.0 * FINE) as usize, (self.size.1 * FINE) as usize);
        let mut spots: Vec<Option<Spot>> = vec![None; width * height];
        for (i, tube) in (0..).zip(tubes) {
            for (j, station) in (0..).zip(&tube.stations) {
                let blank = Spot { near: 0.0, tube: i, station: j, out: None };
                self.ball(&mut spots, (width, height), tube.radius, station, blank);
                for plane in [self.cut.0, self.cut.1] {
                    self.cap(&mut spots, (width, height), tube.radius, station, plane, blank);
                }
            }
        }
        let colours = spots.into_iter().map(|spot| Some(self.colour(tubes, spot?)));
        self.averaged(&colours.collect::<Vec<_>>())
    }

    /// Where a point stands in the picture, in fine pixels, and how near it is.
    fn seen(&self, place: Vector) -> (f64, f64, f64) {
        let from = [0, 1, 2].map(|i| place[i] - self.centre[i]);
        let zoom = self.zoom * f64::from(FINE);
        let middle = |side: u32| 0.5 * f64::from(side * FINE);
        (
            middle(self.size.0) + zoom * dot(from, self.right),
            middle(self.size.1) - zoom * dot(from, self.up),
            dot(from, self.eye),
        )
    }

    /// A ball of the tube's radius: the tube is all of them.
    fn ball(&self, spots: &mut [Option<Spot>], size: (usize, usize), r: f64, station: &Station, blank: Spot) {
        let (x, y, near) = self.seen(station.place);
        let zoom = self.zoom * f64::from(FINE);
        for (column, row, dx, dy) in pixels(x, y, zoom * r, size) {
            let (right, up) = (dx / zoom, -dy / zoom);
            let rest = r * r - right * right - up * up;
            if rest < 0.0 {
                continue;
            }
            let front = libm::sqrt(rest);
            let out = [0, 1, 2].map(|i| right * self.right[i] + up * self.up[i] + front * self.eye[i]);
            let z = station.place[2] + out[2];
            let spot = &mut spots[row * size.0 + column];
            let hidden = spot.is_some_and(|spot| spot.near >= near + front);
            if hidden || z < self.cut.0 || z > self.cut.1 || dot(out, station.tangent).abs() > SLICE * r {
                continue;
            }
            *spot = Some(Spot { near: near + front, out: Some(out), ..blank });
        }
    }

    /// What a plane across the axis cuts of a ball, if it looks at the eye.
    fn cap(
        &self,
        spots: &mut [Option<Spot>],
        size: (usize, usize),
        r: f64,
        station: &Station,
        plane: f64,
        blank: Spot,
    ) {
        let towards = if plane >= self.cut.1 { 1.0 } else { -1.0 };
        let slope = self.eye[2];
        let above = plane - station.place[2];
        let rest = r * r - above * above;
        if slope * towards <= 1e-6 || rest <= 0.0 {
            return;
        }
        let foot = [station.place[0], station.place[1], plane];
        let (x, y, near) = self.seen(foot);
        let zoom = self.zoom * f64::from(FINE);
        for (column, row, dx, dy) in pixels(x, y, zoom * libm::sqrt(rest), size) {
            let (right, up) = (dx / zoom, -dy / zoom);
            // on the plane: the part of the way along the eye's direction that brings z back
            let rise = right * self.right[2] + up * self.up[2];
            let front = -rise / slope;
            let out = [0, 1].map(|i| right * self.right[i] + up * self.up[i] + front * self.eye[i]);
            let spot = &mut spots[row * size.0 + column];
            if out[0] * out[0] + out[1] * out[1] > rest || spot.is_some_and(|spot| spot.near >= near + front) {
                continue;
            }
            *spot = Some(Spot { near: near + front, ..blank });
        }
    }

    fn colour(&self, tubes: &[Tube], spot: Spot) -> [f64; 3] {
        let tube = &tubes[usize::from(spot.tube)];
        let Some(out) = spot.out else { return tube.colour.map(|c| 0.45 * f64::from(c) + 0.55 * 245.0) };
        let station = &tube.stations[spot.station as usize];
        // the tube's normal, not the ball's: without its part along the line
        let along = dot(out, station.tangent);
        let normal = unit([0, 1, 2].map(|i| out[i] - along * station.tangent[i]));
        let striped = station.stripe.is_some_and(|stripe| dot(normal, stripe) > 0.96);
        self.lit(normal, tube.colour, striped)
    }

    /// The colour of a surface in a light from above on the left, a little darker where it turns away from the eye.
    fn lit(&self, normal: Vector, colour: [u8; 3], striped: bool) -> [f64; 3] {
        let light = unit([0, 1, 2].map(|i| -0.45 * self.right[i] + 0.7 * self.up[i] + 0.75 * self.eye[i]));
        let half = unit([0, 1, 2].map(|i| light[i] + self.eye[i]));
        let facing = dot(normal, self.eye).max(0.0);
        let bright = (0.5 + 0.5 * dot(normal, light).max(0.0)) * (0.55 + 0.45 * libm::sqrt(facing));
        let gloss = 70.0 * libm::pow(dot(normal, half).max(0.0), 28.0);
        colour.map(|c| {
            let own = if striped { 0.15 * f64::from(c) + 0.85 * 250.0 } else { f64::from(c) };
            (bright * own * 1.08 + gloss).clamp(0.0, 255.0)
        })
    }

    /// Fine pixels made coarse.
    fn averaged(&self, spots: &[Option<[f64; 3]>]) -> Vec<u8> {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let fine = FINE as usize;
        let mut bytes = Vec::with_capacity(4 * width * height);
        for row in 0..height {
            for column in 0..width {
                let mut sum = [0.0; 4];
                for (i, j) in (0..fine).flat_map(|i| (0..fine).map(move |j| (i, j))) {
                    if let Some(colour) = spots[(row * fine + i) * width * fine + column * fine + j] {
                        for (total, c) in sum.iter_mut().zip(colour) {
                            *total += c;
                        }
                        sum[3] += 1.0;
                    }
                }
                let count: f64 = if sum[3] > 0.0 { sum[3] } else { 1.0 };
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
                let byte = |v: f64| libm::round(v) as u8;
                bytes.extend([sum[0], sum[1], sum[2]].map(|v| byte(v / count)));
                bytes.push(byte(255.0 * sum[3] / f64::from(FINE * FINE)));
            }
        }
        bytes
    }

    /// The same as PNG.
    pub(super) fn png(&self, tubes: &[Tube]) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.size.0.max(1), self.size.1.max(1));
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        let written = encoder.write_header().and_then(|mut writer| {
            writer.write_image_data(&self.draw(tubes))?;
            writer.finish()
        });
        match written {
            Ok(()) => file,
            Err(_) => Vec::new(), // writing to memory does not fail
        }
    }
}

/// The fine pixels of a disc's square: column, row, and how far right of and below the disc's middle.
fn pixels(x: f64, y: f64, r: f64, (width, height): (usize, usize)) -> impl Iterator<Item = (usize, usize, f64, f64)> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "cut to the picture")]
    let range = |middle: f64, side: usize| {
        let first = libm::ceil(middle - r - 0.5).clamp(0.0, side as f64) as usize;
        let last = libm::floor(middle + r + 0.5).clamp(0.0, side as f64) as usize;
        first..last
    };
    let columns = range(x, width);
    range(y, height).flat_map(move |row| {
        columns.clone().map(move |column| (column, row, column as f64 + 0.5 - x, row as f64 + 0.5 - y))
    })
}
