//! Polynomials in three variables, cut off at one degree, and the Taylor series of 1/|R + δ|.

use super::vector::{Vector, dot};

/// The greatest degree kept.
pub(crate) const DEGREE: usize = 8;
/// Monomials up to that degree: (8 + 3 choose 3).
pub(crate) const TERMS: usize = 165;

/// Three coefficients and a nought, so that four fit side by side.
pub(crate) type Coefficient = [f64; 4];
/// One coefficient per monomial.
pub(crate) type Polynomial = [Coefficient; TERMS];

/// The order of the monomials, and which of them multiply to which.
#[derive(Clone, Debug)]
pub(crate) struct Monomials {
    powers: Vec<[usize; 3]>,
    /// of x^α y^β z^γ: α!β!γ!
    factorial: Vec<f64>,
    /// (i, j, k): monomial i times monomial j is monomial k, of at most the greatest degree
    products: Vec<[u16; 3]>,
    /// for each monomial but the first: another one, a variable, and their product is it
    parent: Vec<(usize, usize)>,
    place: Vec<u16>,
}

const SIDE: usize = DEGREE + 1;

impl Monomials {
    pub(crate) fn new() -> Self {
        let mut powers = Vec::with_capacity(TERMS);
        for degree in 0..=DEGREE {
            for x in (0..=degree).rev() {
                for y in (0..=degree - x).rev() {
                    powers.push([x, y, degree - x - y]);
                }
            }
        }
        let key = |[x, y, z]: [usize; 3]| (x * SIDE + y) * SIDE + z;
        let mut place = vec![0; SIDE * SIDE * SIDE];
        for (k, &power) in (0..).zip(&powers) {
            place[key(power)] = k;
        }
        let mut products = Vec::new();
        for (i, p) in (0..).zip(&powers) {
            for (j, q) in (0..).zip(&powers) {
                let r = [0, 1, 2].map(|k| p[k] + q[k]);
                if r.iter().sum::<usize>() <= DEGREE {
                    products.push([i, j, place[key(r)]]);
                }
            }
        }
        let factorial = powers.iter().map(|p| p.map(|n| (1..=n).product::<usize>() as f64).iter().product()).collect();
        let parent = powers.iter().map(|&p| match p.iter().position(|&n| n > 0) {
            Some(k) => {
                let mut less = p;
                less[k] -= 1;
                (usize::from(place[key(less)]), k)
            }
            None => (0, 0),
        });
        let parent = parent.collect();
        Self { powers, factorial, products, parent, place }
    }

    /// All monomials of δ, each over its factorial.
    pub(crate) fn values(&self, delta: Vector) -> [f64; TERMS] {
        let mut values = [1.0; TERMS];
        for k in 1..TERMS {
            let (parent, variable) = self.parent[k];
            values[k] = values[parent] * delta[variable] / self.powers[k][variable] as f64;
        }
        values
    }

    /// The derivatives of 1/|R + δ| at δ = 0. With n the degree of α, and b the Taylor coefficients,
    /// n R² b(α) + (2n − 1) Σ Rᵢ b(α − eᵢ) + (n − 1) Σ b(α − 2eᵢ) = 0.
    pub(crate) fn inverse_distance(&self, r: Vector) -> [f64; TERMS] {
        let square = dot(r, r);
        let mut b = [0.0; TERMS];
        b[0] = 1.0 / square.sqrt();
        let at = |[x, y, z]: [usize; 3]| usize::from(self.place[(x * SIDE + y) * SIDE + z]);
        for k in 1..TERMS {
            let power = self.powers[k];
            let n = power.iter().sum::<usize>() as f64;
            let (mut one, mut two) = (0.0, 0.0);
            for i in 0..3 {
                let mut less = power;
                if power[i] >= 1 {
                    less[i] -= 1;
                    one += r[i] * b[at(less)];
                }
                if power[i] >= 2 {
                    less[i] -= 1;
                    two += b[at(less)];
                }
            }
            b[k] = -((2.0 * n - 1.0) * one + (n - 1.0) * two) / (n * square);
        }
        for (coefficient, factorial) in b.iter_mut().zip(&self.factorial) {
            *coefficient *= factorial;
        }
        b
    }

    /// Moments about a centre, each over its factorial, moved to one that lies at −s from it.
    pub(crate) fn move_moments(&self, moments: &Polynomial, s: Vector, sum: &mut Polynomial) {
        let shift = self.values(s);
        for &[i, j, k] in &self.products {
            add(&mut sum[usize::from(k)], shift[usize::from(j)], &moments[usize::from(i)]);
        }
    }

    /// Adds the series about a far centre at R: L(α) = Σ D(α + β) M(β), the moments with the sign of their degree.
    pub(crate) fn expand(&self, moments: &Polynomial, r: Vector, sum: &mut Polynomial) {
        let derivatives = self.inverse_distance(r);
        for &[i, j, k] in &self.products {
            add(&mut sum[usize::from(i)], derivatives[usize::from(k)], &moments[usize::from(j)]);
        }
    }

    /// A series about a centre, moved to one that lies at s from it.
    pub(crate) fn move_series(&self, series: &Polynomial, s: Vector) -> Polynomial {
        let shift = self.values(s);
        let mut sum = [[0.0; 4]; TERMS];
        for &[i, j, k] in &self.products {
            add(&mut sum[usize::from(i)], shift[usize::from(j)], &series[usize::from(k)]);
        }
        sum
    }

    /// The curl of a series at δ.
    pub(crate) fn curl(&self, series: &Polynomial, delta: Vector) -> Vector {
        let values = self.values(delta);
        // ∂ᵢ of coefficient k
        let mut slope = [[0.0; 3]; 3];
        for (p, k) in self.powers.iter().zip(0..) {
            for i in 0..3 {
                if p[i] > 0 {
                    let mut less = *p;
                    less[i] -= 1;
                    let value = values[usize::from(self.place[(less[0] * SIDE + less[1]) * SIDE + less[2]])];
                    let coefficient: &Coefficient = &series[k];
                    for component in 0..3 {
                        slope[i][component] += value * coefficient[component];
                    }
                }
            }
        }
        [slope[1][2] - slope[2][1], slope[2][0] - slope[0][2], slope[0][1] - slope[1][0]]
    }

    /// Turns the sign of all odd moments.
    pub(crate) fn alternate(&self, moments: &mut Polynomial) {
        for (moment, power) in moments.iter_mut().zip(&self.powers) {
            if power.iter().sum::<usize>() % 2 == 1 {
                *moment = moment.map(|x| -x);
            }
        }
    }
}

#[inline(always)]
fn add(sum: &mut Coefficient, weight: f64, term: &Coefficient) {
    for k in 0..4 {
        sum[k] += weight * term[k];
    }
}

/// What the gradient of the series of 1/|R + δ| leaves out beyond its greatest degree, at most, times R²; x = |δ|/R below 1.
///
/// The term of degree n is |δ|ⁿ Pₙ(cos)/Rⁿ⁺¹, and its gradient at most n |δ|ⁿ⁻¹/Rⁿ⁺¹ by Bernstein's inequality: Σ n xⁿ⁻¹ from the next
/// degree on.
pub(crate) fn rest(x: f64) -> f64 {
    let p = DEGREE as f64;
    let square = x * x;
    let power = square * square * square * square;
    power * ((p + 1.0) - p * x) / ((1.0 - x) * (1.0 - x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_the_inverse_distance_is_as_near_as_its_rest_says() {
        let monomials = Monomials::new();
        assert_eq!(monomials.powers.len(), TERMS);
        let r = [3.0, -1.0, 2.0];
        let delta = [0.3, 0.5, -0.2];
        let derivatives = monomials.inverse_distance(r);
        let sum: f64 = monomials.values(delta).iter().zip(derivatives).map(|(v, d)| v * d).sum();
        let at = [0, 1, 2].map(|k| r[k] + delta[k]);
        let x = (dot(delta, delta) / dot(r, r)).sqrt();
        assert!((sum - 1.0 / dot(at, at).sqrt()).abs() < rest(x));
        assert!(rest(x) < 1e-4 && (sum - 1.0 / dot(at, at).sqrt()).abs() > 1e-9 * rest(x));
    }
}
