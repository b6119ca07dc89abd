//! How often chance alone makes residuals so large.

/// The chance that χ² of so many degrees of freedom is greater, by Wilson and Hilferty's cube root; good to some 0.01.
pub(super) fn chance_of_greater(chi_squared: f64, freedom: usize) -> Option<f64> {
    if freedom == 0 {
        return None;
    }
    let n = freedom as f64;
    let spread = 2.0 / (9.0 * n);
    let z = (libm::cbrt(chi_squared / n) - (1.0 - spread)) / libm::sqrt(spread);
    Some(0.5 * libm::erfc(z / core::f64::consts::SQRT_2))
}

#[cfg(test)]
mod tests {
    use super::chance_of_greater;

    /// From tables of the distribution.
    #[test]
    fn as_in_tables() {
        for (chi_squared, freedom, chance) in
            [(18.307, 10, 0.05), (9.342, 10, 0.5), (6.635, 1, 0.01), (124.342, 100, 0.05)]
        {
            let found = chance_of_greater(chi_squared, freedom).unwrap();
            assert!((found - chance).abs() < 0.01, "{chi_squared} {freedom}: {found}");
        }
        assert_eq!(chance_of_greater(1.0, 0), None);
    }
}
