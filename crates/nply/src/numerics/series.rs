//! Differences that cancel, in forms that do not.

/// 1 − sin z/z for 0 ≤ z ≤ π, to a few units in the last place.
pub(crate) fn one_minus_sinc(z: f64) -> f64 {
    if z > 1.6 {
        return 1.0 - libm::sin(z) / z; // at most 0.63 is taken from 1: nothing is lost
    }
    // z²/3! − z⁴/5! + …, nested from (2k)(2k + 1) = 420 inwards; what is left out is below 2⁻⁵³ of the sum at z = 1.6
    let y = z * z;
    let nested =
        [420.0, 342.0, 272.0, 210.0, 156.0, 110.0, 72.0, 42.0, 20.0].iter().fold(1.0, |sum, d| 1.0 - y / d * sum);
    y / 6.0 * nested
}

#[cfg(test)]
mod tests {
    use super::one_minus_sinc;

    #[test]
    fn series_and_closed_form_meet() {
        // sin z/z by its product over cos(z/2^k), an independent route
        for i in 1..400 {
            let z = f64::from(i) * 0.00785;
            let product: f64 = (1..60).map(|k| libm::cos(z / libm::exp2(f64::from(k)))).product();
            assert!((one_minus_sinc(z) - (1.0 - product)).abs() < 2e-14, "z = {z}");
        }
        let z = 1e-8; // below the reach of the closed form: z²/6 to the last digit
        assert!((one_minus_sinc(z) / (z * z / 6.0) - 1.0).abs() < 1e-15);
    }
}
