//! A quadratic form of three variables on what linear constraints leave free.

/// Three variables, or a direction among them.
pub(crate) type Vector3 = [f64; 3];

/// A symmetric matrix, by rows.
pub(crate) type Matrix3 = [Vector3; 3];

fn dot(a: &Vector3, b: &Vector3) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// What of a row others leave, over its length, below which rounding may have made it all.
const DEPENDENT: f64 = 1e-12;

/// What is left of a row square to unit vectors. Twice is enough for round-off.
fn square_to(units: &[Vector3], row: Vector3) -> Vector3 {
    let once = |row: Vector3| {
        units.iter().fold(row, |rest, unit| {
            let share = dot(&rest, unit);
            core::array::from_fn(|i| rest[i] - share * unit[i])
        })
    };
    once(once(row))
}

/// The form between directions that constraints leave free.
#[derive(Clone, Debug)]
pub(crate) struct Restricted {
    /// orthonormal directions
    free: Vec<Vector3>,
    /// the form between them
    form: Vec<Vec<f64>>,
    /// the size of the form's entries, for rounding
    size: f64,
}

impl Restricted {
    /// A form where the rows vanish. Rows that depend on others count once.
    pub(crate) fn new(form: &Matrix3, rows: &[Vector3]) -> Self {
        let mut taken: Vec<Vector3> = Vec::new();
        for row in rows {
            let rest = square_to(&taken, *row);
            let (left, length) = (libm::sqrt(dot(&rest, &rest)), libm::sqrt(dot(row, row)));
            if left > DEPENDENT * length {
                taken.push(rest.map(|x| x / left));
            }
        }
        let held = taken.len();
        // of the axes those complete the basis that stand out most
        for _ in held..3 {
            let gap = |axis: usize| 1.0 - taken.iter().map(|unit| unit[axis] * unit[axis]).sum::<f64>();
            let axis = (0..3).max_by(|&i, &j| gap(i).total_cmp(&gap(j))).unwrap_or(0);
            let mut row = [0.0; 3];
            row[axis] = 1.0;
            let rest = square_to(&taken, row);
            let length = libm::sqrt(dot(&rest, &rest));
            taken.push(rest.map(|x| x / length));
        }
        let free: Vec<Vector3> = taken.split_off(held.min(3));
        let apply = |v: &Vector3| [0, 1, 2].map(|i| dot(&form[i], v));
        let matrix = free.iter().map(|u| free.iter().map(|v| dot(u, &apply(v))).collect()).collect();
        let size = form.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        Self { free, form: matrix, size }
    }

    /// How many directions are free.
    pub(crate) fn freedom(&self) -> usize {
        self.free.len()
    }

    /// The size of the entries of the whole form.
    pub(crate) const fn size(&self) -> f64 {
        self.size
    }

    /// The least eigenvalue; `None` where nothing is free.
    pub(crate) fn least(&self) -> Option<f64> {
        let mut a = self.form.clone();
        let n = a.len();
        // Jacobi's rotations: three by three at most
        for _ in 0..24 {
            for p in 0..n {
                for q in p + 1..n {
                    let off = a[p][q];
                    if off == 0.0 {
                        continue;
                    }
                    let tau = (a[q][q] - a[p][p]) / (2.0 * off);
                    let t = f64::copysign(1.0, tau) / (tau.abs() + libm::sqrt(1.0 + tau * tau));
                    let c = 1.0 / libm::sqrt(1.0 + t * t);
                    let s = t * c;
                    for row in &mut a {
                        let (x, y) = (row[p], row[q]);
                        (row[p], row[q]) = (c * x - s * y, s * x + c * y);
                    }
                    let (upper, lower) = (a[p].clone(), a[q].clone());
                    a[p] = upper.iter().zip(&lower).map(|(x, y)| c * x - s * y).collect();
                    a[q] = upper.iter().zip(&lower).map(|(x, y)| s * x + c * y).collect();
                }
            }
        }
        (0..n).map(|i| a[i][i]).reduce(f64::min)
    }

    /// Where the form's slope is `right`, on what is free: the response to a small load. `None` where the form is singular there.
    pub(crate) fn solve(&self, right: &Vector3) -> Option<Vector3> {
        let n = self.free.len();
        let mut a = self.form.clone();
        let mut b: Vec<f64> = self.free.iter().map(|u| dot(u, right)).collect();
        for k in 0..n {
            let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
            a.swap(k, pivot);
            b.swap(k, pivot);
            if a[k][k].abs() <= 64.0 * f64::EPSILON * self.size {
                return None;
            }
            let upper = a[k].clone();
            for i in k + 1..n {
                let factor = a[i][k] / upper[k];
                for (x, y) in a[i].iter_mut().zip(&upper) {
                    *x -= factor * y;
                }
                b[i] -= factor * b[k];
            }
        }
        for k in (0..n).rev() {
            let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
            b[k] = (b[k] - known) / a[k][k];
        }
        Some([0, 1, 2].map(|i| self.free.iter().zip(&b).map(|(u, x)| u[i] * x).sum()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORM: Matrix3 = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.2], [0.5, -0.2, 5.0]];

    #[test]
    fn a_constraint_takes_a_freedom_and_the_solution_keeps_to_it() {
        let row = [1.0, -2.0, 0.3];
        let one = Restricted::new(&FORM, &[row, row]);
        assert_eq!(one.freedom(), 2);
        let right = [0.3, 0.7, -0.1];
        let x = one.solve(&right).expect("not singular");
        assert!(dot(&x, &row).abs() < 1e-15);
        // what is left of the slope is square to what is free
        let rest = [0, 1, 2].map(|i| dot(&FORM[i], &x) - right[i]);
        let share = dot(&rest, &row) / dot(&row, &row);
        assert!(rest.iter().zip(&row).all(|(r, k)| (r - share * k).abs() < 1e-14));
        assert_eq!(Restricted::new(&FORM, &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]).least(), None);
    }

    #[test]
    fn the_least_eigenvalue_is_that_of_the_characteristic_polynomial() {
        let least = Restricted::new(&FORM, &[]).least().expect("three are free");
        let [[a, b, c], [_, d, e], [_, _, f]] = FORM.map(|row| row);
        let (a, d, f) = (a - least, d - least, f - least);
        let determinant = a * (d * f - e * e) - b * (b * f - e * c) + c * (b * e - d * c);
        assert!(determinant.abs() < 1e-12 && least > 0.0 && least < 3.0);
        let bound = Restricted::new(&FORM, &[[0.0, 1.0, 0.0]]).least().expect("two are free");
        assert!((bound - 4.5 + libm::sqrt(0.5)).abs() < 1e-14 && bound > least, "{bound}");
    }
}
