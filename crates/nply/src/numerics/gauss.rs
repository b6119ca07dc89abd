//! Gauss's rule, and what it leaves where the integrand is known to be analytic.

/// Nodes in (0, 1) and weights of the rule of 24 points on (−1, 1); the other twelve mirror them.
pub(crate) const RULE: [(f64, f64); 12] = [
    (0.9951872199970213602, 0.01234122979998719955),
    (0.9747285559713094982, 0.02853138862893366318),
    (0.9382745520027327585, 0.04427743881741980617),
    (0.8864155270044010342, 0.05929858491543678075),
    (0.820001985973902922, 0.07334648141108030573),
    (0.7401241915785543642, 0.08619016153195327592),
    (0.6480936519369755693, 0.09761865210411388827),
    (0.5454214713888395357, 0.1074442701159656348),
    (0.4337935076260451385, 0.1155056680537256014),
    (0.3150426796961633744, 0.1216704729278033912),
    (0.1911188674736163092, 0.1258374563468282961),
    (0.06405689286260562609, 0.127938195346752157),
];

/// Half axes of Bernstein's ellipse with semi-axis sum ϱ = 2, in half lengths of the panel: along it and across.
pub(crate) const ALONG: f64 = 1.25;
pub(crate) const ACROSS: f64 = 0.75;

/// The rule's error on a panel of half length 1 is below this times the integrand's greatest modulus on that ellipse, if it is analytic
/// there: 64/15 ϱ⁻⁴⁸/(1 − ϱ⁻²) (L. N. Trefethen, *Approximation Theory and Approximation Practice*, theorem 19.3).
pub(crate) const LEFT: f64 = 64.0 / 15.0 / 0.75 / 281_474_976_710_656.0;

#[cfg(test)]
mod tests {
    use super::{LEFT, RULE};

    #[test]
    fn powers_are_exact_and_a_pole_stays_within_the_bound() {
        let sum = |f: &dyn Fn(f64) -> f64| RULE.iter().map(|&(x, w)| w * (f(x) + f(-x))).sum::<f64>();
        for degree in 0..48 {
            let got = sum(&|x: f64| (0..degree).fold(1.0, |p, _| p * x));
            let want = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((got - want).abs() < 1e-15, "x^{degree}: {got}");
        }
        // 1/(1.3 − x): at most 1/0.05 on the ellipse
        let got = sum(&|x: f64| 1.0 / (1.3 - x));
        assert!((got - libm::log(2.3 / 0.3)).abs() < LEFT / 0.05 + 4e-16, "{got}");
    }
}
