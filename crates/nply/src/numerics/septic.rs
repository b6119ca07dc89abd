//! Polynomials of degree 7 on [−1, 1]: as powers to be evaluated, in Bernstein form to be judged by their signs.

use super::matrix::inverse;

/// Number of coefficients; the degree is one less.
pub(crate) const ORDER: usize = 8;

/// Coefficients, lowest power or left end first.
pub(crate) type Coefficients = [f64; ORDER];

/// Chebyshev–Lobatto points −cos(πi/7); the ends are among them.
pub(crate) const NODES: Coefficients = [
    -1.0,
    -0.900_968_867_902_419_1,
    -0.623_489_801_858_733_6,
    -0.222_520_933_956_314_4,
    0.222_520_933_956_314_4,
    0.623_489_801_858_733_6,
    0.900_968_867_902_419_1,
    1.0,
];

const BINOMIAL: Coefficients = [1.0, 7.0, 21.0, 35.0, 35.0, 21.0, 7.0, 1.0];

/// Takes values on [`NODES`] to powers.
const POWERS: [Coefficients; ORDER] = inverse(powers_at_nodes());

/// Takes values on [`NODES`] to Bernstein coefficients.
const BERNSTEIN: [Coefficients; ORDER] = inverse(bernstein_at_nodes());

const fn powers_at_nodes() -> [Coefficients; ORDER] {
    let mut matrix = [[1.0; ORDER]; ORDER];
    let mut i = 0;
    while i < ORDER {
        let mut j = 1;
        while j < ORDER {
            matrix[i][j] = matrix[i][j - 1] * NODES[i];
            j += 1;
        }
        i += 1;
    }
    matrix
}

const fn bernstein_at_nodes() -> [Coefficients; ORDER] {
    let mut matrix = [[0.0; ORDER]; ORDER];
    let mut i = 0;
    while i < ORDER {
        let (t, u) = (0.5 * (1.0 + NODES[i]), 0.5 * (1.0 - NODES[i]));
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

/// The polynomial through `values` at [`NODES`], as powers.
///
/// The chord is taken off first: what is left is small, and so is what rounding does to its coefficients.
pub(crate) fn powers(values: &Coefficients) -> Coefficients {
    let (mean, half) = (0.5 * (values[0] + values[ORDER - 1]), 0.5 * (values[ORDER - 1] - values[0]));
    let mut coefficients = product(&POWERS, &above_chord(values, mean, half));
    coefficients[0] += mean;
    coefficients[1] += half;
    coefficients
}

/// The polynomial through `values` at [`NODES`], in Bernstein form; the end values are kept to the bit.
pub(crate) fn bernstein(values: &Coefficients) -> Coefficients {
    let (mean, half) = (0.5 * (values[0] + values[ORDER - 1]), 0.5 * (values[ORDER - 1] - values[0]));
    let mut coefficients = product(&BERNSTEIN, &above_chord(values, mean, half));
    for (i, coefficient) in coefficients.iter_mut().enumerate() {
        *coefficient += mean + half * (2.0 * i as f64 / (ORDER - 1) as f64 - 1.0);
    }
    coefficients[0] = values[0];
    coefficients[ORDER - 1] = values[ORDER - 1];
    coefficients
}

fn above_chord(values: &Coefficients, mean: f64, half: f64) -> Coefficients {
    core::array::from_fn(|i| values[i] - (mean + half * NODES[i]))
}

fn product(matrix: &[Coefficients; ORDER], values: &Coefficients) -> Coefficients {
    core::array::from_fn(|i| matrix[i].iter().zip(values).map(|(a, v)| a * v).sum())
}

/// Value of powers at u in [−1, 1].
#[inline(always)]
pub(crate) fn value(powers: &Coefficients, u: f64) -> f64 {
    let mut sum = powers[ORDER - 1];
    for i in (0..ORDER - 1).rev() {
        sum = sum * u + powers[i];
    }
    sum
}

/// Both halves of a polynomial in Bernstein form, by de Casteljau; they share the value in the middle to the bit.
pub(crate) fn halves(b: &Coefficients) -> [Coefficients; 2] {
    let (mut left, mut right) = ([0.0; ORDER], *b);
    for (i, kept) in left.iter_mut().enumerate() {
        *kept = right[0];
        for j in 0..ORDER - 1 - i {
            right[j] = 0.5 * (right[j] + right[j + 1]);
        }
    }
    [left, right]
}

/// Adds a multiple.
#[inline]
pub(crate) fn add(sum: &mut Coefficients, weight: f64, b: &Coefficients) {
    for (total, coefficient) in sum.iter_mut().zip(b) {
        *total += weight * coefficient;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_forms_pass_through_the_values() {
        let f = |u: f64| 1.0 / (3.0 + u * (1.0 - 0.2 * u * u));
        let values = NODES.map(f);
        let (p, b) = (powers(&values), bernstein(&values));
        let mut halved = halves(&b);
        assert!((halved[0][ORDER - 1] - value(&p, 0.0)).abs() < 2e-16);
        assert_eq!(halved[0][ORDER - 1].to_bits(), halved[1][0].to_bits());
        for (u, expected) in NODES.iter().zip(values) {
            assert!((value(&p, *u) - expected).abs() < 2e-16);
        }
        for _ in 0..60 {
            halved = halves(&halved[1]); // towards the right end, which stays as it was
        }
        assert!((halved[1][0] - values[ORDER - 1]).abs() < 1e-15);
    }
}
