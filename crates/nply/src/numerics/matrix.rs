//! Inverses that the compiler works out.

/// By Gauss and Jordan, without pivoting: for matrices of which no leading minor vanishes, such as those of basis polynomials at their
/// nodes.
pub(crate) const fn inverse<const N: usize>(mut a: [[f64; N]; N]) -> [[f64; N]; N] {
    let mut b = [[0.0; N]; N];
    let mut p = 0;
    while p < N {
        b[p][p] = 1.0;
        p += 1;
    }
    p = 0;
    while p < N {
        let pivot = 1.0 / a[p][p];
        let mut j = 0;
        while j < N {
            a[p][j] *= pivot;
            b[p][j] *= pivot;
            j += 1;
        }
        let mut i = 0;
        while i < N {
            let factor = if i == p { 0.0 } else { a[i][p] };
            j = 0;
            while j < N {
                a[i][j] -= factor * a[p][j];
                b[i][j] -= factor * b[p][j];
                j += 1;
            }
            i += 1;
        }
        p += 1;
    }
    b
}

#[cfg(test)]
mod tests {
    use super::inverse;

    #[test]
    fn times_the_matrix_it_is_one() {
        let a = [[4.0, 1.0, 0.5], [1.0, 3.0, -1.0], [0.0, 2.0, 5.0]];
        let b = inverse(a);
        for (i, row) in a.iter().enumerate() {
            for j in 0..3 {
                let sum: f64 = row.iter().zip(&b).map(|(x, other)| x * other[j]).sum();
                assert!((sum - f64::from(u8::from(i == j))).abs() < 1e-15);
            }
        }
    }
}
