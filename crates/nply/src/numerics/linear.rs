//! Four unknowns: three equations leave a direction, four leave a point.

/// Coordinates, or a direction among them.
pub(crate) type Vector = [f64; 4];

pub(crate) fn dot(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The solution of four equations by elimination with pivoting on scaled rows; `None` if they are singular.
pub(crate) fn solve(mut rows: [Vector; 4], mut right: Vector) -> Option<Vector> {
    for (row, value) in rows.iter_mut().zip(&mut right) {
        let size = row.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if !(size > 0.0 && size < f64::INFINITY) {
            return None;
        }
        row.iter_mut().for_each(|x| *x /= size);
        *value /= size;
    }
    for k in 0..4 {
        let pivot = (k..4).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        rows.swap(k, pivot);
        right.swap(k, pivot);
        let upper = rows[k];
        if upper[k].abs() < 1e-300 {
            return None;
        }
        for i in k + 1..4 {
            let factor = rows[i][k] / upper[k];
            for (x, y) in rows[i].iter_mut().zip(&upper) {
                *x -= factor * y;
            }
            right[i] -= factor * right[k];
        }
    }
    let mut x = [0.0; 4];
    for k in (0..4).rev() {
        let known: f64 = (k + 1..4).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (right[k] - known) / rows[k][k];
    }
    x.iter().all(|value| value.is_finite()).then_some(x)
}

/// The direction that three equations leave free, of length 1: the generalised cross product of their rows.
pub(crate) fn direction(rows: &[Vector; 3]) -> Option<Vector> {
    let rows = rows.map(|row| {
        let size = row.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        row.map(|x| if size > 0.0 { x / size } else { x })
    });
    let minor = |skip: usize| {
        let [i, j, k] = match skip {
            0 => [1, 2, 3],
            1 => [0, 2, 3],
            2 => [0, 1, 3],
            _ => [0, 1, 2],
        };
        let [a, b, c] = &rows;
        a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i]) + a[k] * (b[i] * c[j] - b[j] * c[i])
    };
    let free = [minor(0), -minor(1), minor(2), -minor(3)];
    let length = libm::sqrt(dot(&free, &free));
    (length > 0.0 && length < f64::INFINITY).then(|| free.map(|x| x / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_is_square_to_all_equations() {
        let rows = [[1.0, 2.0, -1.0, 0.5], [0.0, 1e-9, 3.0, 1.0], [4.0, -1.0, 0.0, 2.0]];
        let free = direction(&rows).expect("independent rows");
        for row in &rows {
            assert!(dot(row, &free).abs() < 1e-14);
        }
        let x = solve([rows[0], rows[1], rows[2], free], [1.0, 2.0, 3.0, 0.0]).expect("a point");
        assert!((dot(&rows[0], &x) - 1.0).abs() < 1e-14 && (dot(&rows[2], &x) - 3.0).abs() < 1e-14);
        assert!(dot(&free, &x).abs() < 1e-14);
        assert!(solve([rows[0], rows[0], rows[2], free], [1.0; 4]).is_none());
    }
}
