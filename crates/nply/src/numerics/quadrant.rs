//! Sine and cosine together on the first quadrant.
//!
//! Twice as fast as the general routine, which must reduce any argument first. Products and sums alone: the same bits on
//! every machine.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// What π/2 as a double leaves out.
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;

/// (sin t, cos t) for 0 ≤ t ≤ π/2, each within one unit in the last place.
#[inline]
pub(crate) fn sincos(t: f64) -> (f64, f64) {
    let upper = t > FRAC_PI_4;
    let r = if upper { (FRAC_PI_2 - t) + FRAC_PI_2_REST } else { t };
    let (sin, cos) = octant(r);
    if upper { (cos, sin) } else { (sin, cos) }
}

/// For 0 ≤ r ≤ π/4, by Taylor's series: the first terms left out are r¹⁹/19! and r²⁰/20!, below 1e-19.
#[inline(always)]
pub(crate) fn octant(r: f64) -> (f64, f64) {
    const S: [f64; 8] = [
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5_040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
        -1.0 / 1_307_674_368_000.0,
        1.0 / 355_687_428_096_000.0,
    ];
    const C: [f64; 8] = [
        1.0 / 24.0,
        -1.0 / 720.0,
        1.0 / 40_320.0,
        -1.0 / 3_628_800.0,
        1.0 / 479_001_600.0,
        -1.0 / 87_178_291_200.0,
        1.0 / 20_922_789_888_000.0,
        -1.0 / 6_402_373_705_728_000.0,
    ];
    let y = r * r;
    let y2 = y * y;
    let y4 = y2 * y2;
    let series =
        |a: &[f64; 8]| ((a[0] + a[1] * y) + (a[2] + a[3] * y) * y2) + ((a[4] + a[5] * y) + (a[6] + a[7] * y) * y2) * y4;
    let half = 0.5 * y;
    let near = 1.0 - half;
    // what 1 − y/2 has rounded away is put back with the small terms
    (r + r * (y * series(&S)), near + (((1.0 - near) - half) + y2 * series(&C)))
}

#[cfg(test)]
mod tests {
    use super::{FRAC_PI_2, sincos};

    #[test]
    fn agrees_with_the_general_routine() {
        let units = |got: f64, want: f64| (got - want).abs() / (want * f64::EPSILON);
        for i in 0..=200_000 {
            let t = FRAC_PI_2 * f64::from(i) / 200_000.0;
            let ((s, c), (s0, c0)) = (sincos(t), libm::sincos(t));
            assert!(i == 0 || units(s, s0) <= 1.0, "sin {t}: {s} {s0}");
            assert!(units(c, c0) <= 1.0, "cos {t}: {c} {c0}");
        }
        assert_eq!(sincos(0.0), (0.0, 1.0));
        assert_eq!(sincos(1e-300), (1e-300, 1.0));
        assert!(sincos(FRAC_PI_2).1 > 0.0);
    }
}
