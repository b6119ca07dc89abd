//! Polynomials of degree 11 on [0, 1] in Bernstein form, whose coefficients' signs bound the number of roots.
//!
//! Descartes' rule in this form: a polynomial has at most as many roots in (0, 1) as its coefficients change sign, and
//! as many but for an even number. No change: no root. One change: exactly one root.

use super::matrix::inverse;

/// Number of coefficients; the degree is one less.
pub(crate) const ORDER: usize = 12;

/// Coefficients b₀ … b₁₁; b₀ and b₁₁ are the values at the ends.
pub(crate) type Bernstein = [f64; ORDER];

/// Chebyshev–Lobatto points on [0, 1], (1 − cos(πi/11))/2; the ends are among them.
pub(crate) const NODES: [f64; ORDER] = {
    let half = [
        0.0,
        0.020_253_513_192_751_305,
        0.079_373_233_584_409_4,
        0.172_569_633_027_357_42,
        0.292_292_493_499_056_8,
        0.428_842_580_863_357_47,
    ];
    let mut nodes = [0.0; ORDER];
    let mut i = 0;
    while i < 6 {
        nodes[i] = half[i];
        nodes[ORDER - 1 - i] = 1.0 - half[i];
        i += 1;
    }
    nodes
};

/// Binomial coefficients of degree 11.
pub(crate) const BINOMIAL: Bernstein = [1.0, 11.0, 55.0, 165.0, 330.0, 462.0, 462.0, 330.0, 165.0, 55.0, 11.0, 1.0];

/// Takes values on [`NODES`] to coefficients: the inverse of the matrix of basis polynomials at the nodes.
const FIT: [[f64; ORDER]; ORDER] = inverse(basis_at_nodes());

const fn basis_at_nodes() -> [[f64; ORDER]; ORDER] {
    let mut matrix = [[0.0; ORDER]; ORDER];
    let mut i = 0;
    while i < ORDER {
        let (t, u) = (NODES[i], NODES[ORDER - 1 - i]);
        let mut j = 0;
        while j < ORDER {
            let mut product = BINOMIAL[j];
            let mut k = 0;
            while k < ORDER - 1 {
                product *= if k < j { t } else { u };
                k += 1;
            }
            matrix[i][j] = product;
            j += 1;
        }
        i += 1;
    }
    matrix
}

/// The polynomial through `values` at [`NODES`]; the end values are kept to the bit.
pub(crate) fn fit(values: &Bernstein) -> Bernstein {
    let mut coefficients = [0.0; ORDER];
    for (coefficient, row) in coefficients.iter_mut().zip(&FIT) {
        *coefficient = row.iter().zip(values).map(|(a, v)| a * v).sum();
    }
    coefficients[0] = values[0];
    coefficients[ORDER - 1] = values[ORDER - 1];
    coefficients
}

/// Value at t in [0, 1].
pub(crate) fn value(b: &Bernstein, t: f64) -> f64 {
    let (odds, far) = odds(t);
    let [value, _, _] = horner(&toward(b, t), odds);
    let far2 = far * far;
    let far4 = far2 * far2;
    value * (far4 * far4 * far2 * far)
}

/// A root's guess t in (0, 1) after two of Halley's steps, if they stay inside.
#[inline]
pub(crate) fn polish(b: &Bernstein, t: f64) -> f64 {
    // in the odds t : (1 − t) from the nearer end, where the coefficients are those of a plain polynomial
    let plain = toward(b, t);
    let (mut odds, _) = odds(t);
    for _ in 0..2 {
        let [p, dp, half_d2p] = horner(&plain, odds);
        odds -= p * dp / (dp * dp - p * half_d2p);
    }
    let share = odds / (1.0 + odds);
    match (share > 0.0 && share < 1.0, t <= 0.5) {
        (true, true) => share,
        (true, false) => 1.0 - share,
        (false, _) => t,
    }
}

/// The odds of t from the nearer end of [0, 1], at most 1, and how far the other end is.
#[inline]
fn odds(t: f64) -> (f64, f64) {
    if t <= 0.5 { (t / (1.0 - t), 1.0 - t) } else { ((1.0 - t) / t, t) }
}

/// Coefficients of the plain polynomial in the odds from the end nearer to t.
#[inline]
fn toward(b: &Bernstein, t: f64) -> Bernstein {
    if t <= 0.5 {
        core::array::from_fn(|i| BINOMIAL[i] * b[i])
    } else {
        core::array::from_fn(|i| BINOMIAL[i] * b[ORDER - 1 - i])
    }
}

/// Value, slope and half the second derivative of a plain polynomial.
#[inline]
fn horner(a: &Bernstein, x: f64) -> [f64; 3] {
    let [mut p, mut dp, mut half_d2p] = [0.0; 3];
    for coefficient in a.iter().rev() {
        half_d2p = half_d2p * x + dp;
        dp = dp * x + p;
        p = p * x + coefficient;
    }
    [p, dp, half_d2p]
}

/// Σ bᵢ Bᵢ over tᵖ, of a polynomial that vanishes so at 0: the first 12 − p coefficients, of a degree less by p.
pub(crate) fn over_power(b: &Bernstein, power: usize) -> Bernstein {
    let degree = ORDER - 1 - power;
    let mut quotient = [0.0; ORDER];
    let mut binomial = 1.0; // of `degree` over i
    for i in 0..=degree {
        quotient[i] = b[i + power] * (BINOMIAL[i + power] / binomial);
        binomial *= (degree - i) as f64 / (i + 1) as f64;
    }
    quotient
}

/// How many times what a polynomial of degree 11 may be on [0, 1] it may be over tᵖ, if it vanishes so at 0: the greatest p-th derivative over p! (V. A. Markov).
pub(crate) fn growth(power: usize) -> f64 {
    let square = ((ORDER - 1) * (ORDER - 1)) as f64;
    (0..power).map(|j| 2.0 * (square - (j * j) as f64) / ((2 * j + 1) * (j + 1)) as f64).product()
}

/// Whether all coefficients are beyond `tolerance` on one side of zero.
#[inline]
pub(crate) fn one_sign<const N: usize>(b: &[f64; N], tolerance: f64) -> bool {
    let (mut least, mut greatest) = (b[0], b[0]);
    for &value in b {
        least = if value < least { value } else { least };
        greatest = if value > greatest { value } else { greatest };
    }
    least > tolerance || greatest < -tolerance
}

/// How often the signs change at the most when coefficients within `tolerance` of zero may have any sign. The ends are
/// sure: zero counts as positive there.
#[inline]
pub(crate) fn sign_changes(b: &[f64], tolerance: f64) -> usize {
    let last = b.len() - 1;
    let mut sure = b[0] >= 0.0; // the last sure sign
    let mut most = 0;
    let mut unsure = 0; // coefficients of unknown sign since then
    for (i, &value) in b.iter().enumerate().skip(1) {
        if i < last && value.abs() <= tolerance {
            unsure += 1;
            continue;
        }
        let sign = value >= 0.0;
        let changed = usize::from(sign != sure);
        // k unknown signs between two sure ones: k + 1 places for a change, of the parity of the ends
        most += if unsure % 2 == 0 { unsure + changed } else { unsure + 1 - changed };
        (sure, unsure) = (sign, 0);
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fit_and_value_are_inverse() {
        let f = |t: f64| 3.0 - t + 5.0 * t * t * t - 2.0 * t * t * t * t * t * t * t;
        let b = fit(&NODES.map(f));
        for i in 0..=50 {
            let t = f64::from(i) / 50.0;
            assert!((value(&b, t) - f(t)).abs() < 1e-13, "t = {t}");
        }
    }

    #[test]
    fn polish_finds_the_root() {
        for root in [0.02, 0.3, 0.5, 0.7, 0.99] {
            let b = fit(&NODES.map(|t| (t - root) * (2.0 + t * t * t)));
            let got = polish(&b, root + if root < 0.5 { 0.003 } else { -0.003 }); // as far as the control polygon is
            assert!((got - root).abs() < 1e-9, "{got} for {root}");
        }
    }

    #[test]
    fn a_power_is_divided_out() {
        for power in 1..=3 {
            let f = |t: f64| 1.0 - 3.0 * t + t * t * t * t;
            let product = fit(&NODES.map(|t| [t, t, t][..power].iter().product::<f64>() * f(t)));
            let quotient = over_power(&product, power);
            // the control points at the ends are the values there
            let last = ORDER - 1 - power;
            assert!((quotient[0] - f(0.0)).abs() < 1e-12 && (quotient[last] - f(1.0)).abs() < 1e-12, "{quotient:?}");
        }
        // Chebyshev's polynomial of degree 11 is the one that grows most: its slope at an end is 2·11², its bend 4·121·120/3
        assert!((growth(1) - 242.0).abs() < 1e-9 && (growth(2) - 0.5 * 4.0 * 121.0 * 40.0).abs() < 1e-9);
    }

    #[test]
    fn changes_of_unsure_signs() {
        assert_eq!(sign_changes(&[1.0, 2.0, 3.0], 0.1), 0);
        assert_eq!(sign_changes(&[1.0, 0.01, -3.0], 0.1), 1); // wherever the unsure one falls
        assert_eq!(sign_changes(&[1.0, 0.01, 3.0], 0.1), 2);
        assert_eq!(sign_changes(&[1.0, 0.01, 0.01, -3.0], 0.1), 3);
        assert_eq!(sign_changes(&[1.0, 0.01, 0.01, 3.0], 0.1), 2);
        assert_eq!(sign_changes(&[1e-9, 2.0, -1e-9], 0.1), 1); // the ends are sure
        let all = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 1.0, 2.0, 3.0];
        assert!(one_sign(&all, 0.9) && !one_sign(&all, 1.0) && one_sign(&all.map(|v| -v), 0.9));
    }
}
