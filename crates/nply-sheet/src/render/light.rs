//! Light, shadow and colour.

use nply::geometry::Vector;

/// Towards the lamp, in the picture's frame: right, up, towards the eye. From the upper left, along the ply's flank.
const LAMP: Vector = [-0.452, 0.652, 0.609];
/// Towards a weaker lamp, which throws no shadow: from the right, where the near end looks.
const FILL: Vector = [0.728, 0.243, 0.641];
/// How small the lamp is: the larger, the harder the shadows on the ply itself.
pub(super) const HARD: f64 = 7.0;
/// The same of the shadow on what is behind.
pub(super) const SOFT: f64 = 2.2;

/// What is known of a surface where it is to be coloured; vectors in the picture's frame.
pub(super) struct Surface {
    pub(super) normal: Vector,
    /// linear red, green, blue
    pub(super) colour: Vector,
    pub(super) glossy: bool,
}

/// What of the lamp and of the sky reaches a place, from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    pub(super) lamp: f64,
    pub(super) sky: f64,
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// What reaches a place on a surface, by the distances found on the way: the narrower the gap the lamp's ray passes, the less comes through,
/// and the nearer other surfaces are along the normal, the less of the sky is seen.
pub(super) fn reach(
    distance: impl Fn(Vector) -> f64,
    place: Vector,
    normal: Vector,
    largest: f64,
    hardness: f64,
) -> Reach {
    const STEPS: u32 = 48;
    const TAPS: u32 = 6;
    let off = |start: Vector, way: Vector, far: f64| -> Vector { core::array::from_fn(|i| start[i] + far * way[i]) };
    let facing = dot(normal, LAMP);
    let mut lamp: f64 = if facing > 0.0 { 1.0 } else { 0.0 };
    let mut far = 0.03;
    for _ in 0..STEPS {
        if lamp < 0.01 || far > largest {
            break;
        }
        let gap = distance(off(off(place, normal, 0.01), LAMP, far));
        lamp = lamp.min(hardness * gap / far + 0.02);
        far += gap.clamp(0.05, 2.0);
    }
    let (mut hidden, mut weight) = (0.0, 1.0);
    let mut height = 0.08;
    for _ in 0..TAPS {
        let gap = distance(off(place, normal, height));
        hidden += weight * (1.0 - gap / height).clamp(0.0, 1.0);
        weight *= 0.72;
        height *= 1.75;
    }
    let lamp = lamp.clamp(0.0, 1.0);
    Reach { lamp: lamp * lamp * (3.0 - 2.0 * lamp), sky: (1.0 - 0.42 * hidden).clamp(0.08, 1.0) }
}

/// The colour that a surface shows, linear.
pub(super) fn shown(surface: &Surface, reach: Reach) -> Vector {
    const LAMP_COLOUR: Vector = [1.0, 0.965, 0.91];
    const SKY: Vector = [0.86, 0.93, 1.0];
    const FLOOR: Vector = [1.0, 0.95, 0.88];
    let n = surface.normal;
    let lit = dot(n, LAMP).max(0.0) * reach.lamp;
    let fill = if surface.glossy { 0.30 } else { 0.75 } * dot(n, FILL).max(0.0) * reach.sky;
    let up = 0.5 + 0.5 * n[1];
    // half way between lamp and eye
    let half: Vector = {
        let h = [LAMP[0], LAMP[1], LAMP[2] + 1.0];
        let size = libm::sqrt(dot(h, h));
        h.map(|x| x / size)
    };
    let gloss = if surface.glossy { dot(n, half).max(0.0) } else { 0.0 };
    let shine = reach.lamp * (0.16 * libm::pow(gloss, 38.0) + 0.10 * libm::pow(gloss, 9.0));
    let edge = 1.0 - n[2].max(0.0);
    let rim = if surface.glossy { 0.10 * edge * edge * edge * reach.sky } else { 0.0 };
    core::array::from_fn(|i| {
        let ambient = reach.sky * (0.40 * SKY[i] * up + 0.20 * FLOOR[i] * (1.0 - up));
        surface.colour[i] * (0.84 * LAMP_COLOUR[i] * lit + fill + ambient) + shine * LAMP_COLOUR[i] + rim * SKY[i]
    })
}

/// From a byte of sRGB to light (IEC 61966-2-1).
pub(super) fn linear(byte: u8) -> f64 {
    let x = f64::from(byte) / 255.0;
    if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) }
}

/// From light to a byte of sRGB; what is too bright is rolled off towards white.
pub(super) fn byte(light: f64) -> u8 {
    const KNEE: f64 = 0.8;
    let x = if light > KNEE { KNEE + (1.0 - KNEE) * (1.0 - libm::exp(-(light - KNEE) / (1.0 - KNEE))) } else { light };
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 255")]
    let byte = (encoded * 255.0 + 0.5).clamp(0.0, 255.0) as u8;
    byte
}
