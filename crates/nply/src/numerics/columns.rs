//! A few linear equations, solved by columns made square to each other.

/// The weights with which columns of `rows` numbers add up to the right side: as many equations as weights, or more that agree. `None`
/// where the columns are not independent.
pub(crate) fn combination(columns: &[[f64; 3]], right: [f64; 3], rows: usize) -> Option<Vec<f64>> {
    let k = columns.len();
    let dot = |a: &[f64; 3], b: &[f64; 3]| (0..rows).map(|i| a[i] * b[i]).sum::<f64>();
    // by orthogonal steps, which square no condition
    let mut q: Vec<[f64; 3]> = Vec::new();
    let mut r = vec![vec![0.0; k]; k];
    for (j, column) in columns.iter().enumerate() {
        let mut rest = *column;
        for _ in 0..2 {
            for (i, unit) in q.iter().enumerate() {
                let share = dot(unit, &rest);
                r[i][j] += share;
                rest = core::array::from_fn(|l| rest[l] - share * unit[l]);
            }
        }
        let length = libm::sqrt(dot(&rest, &rest));
        let lost = length <= 1e-13 * libm::sqrt(dot(column, column));
        if lost || length.is_nan() {
            return None;
        }
        r[j][j] = length;
        q.push(rest.map(|x| x / length));
    }
    let mut x: Vec<f64> = q.iter().map(|unit| dot(unit, &right)).collect();
    for i in (0..k).rev() {
        let known: f64 = (i + 1..k).map(|j| r[i][j] * x[j]).sum();
        x[i] = (x[i] - known) / r[i][i];
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::combination;

    #[test]
    fn weights_add_up_to_the_right_side() {
        let columns = [[1.0, 2.0, -1.0], [0.5, -1.0, 3.0]];
        let right = [0, 1, 2].map(|i| 0.25 * columns[0][i] - 4.0 * columns[1][i]);
        let weights = combination(&columns, right, 3).expect("independent columns");
        assert!((weights[0] - 0.25).abs() < 1e-15 && (weights[1] + 4.0).abs() < 1e-15);
        assert!(combination(&[columns[0], columns[0]], right, 3).is_none());
        assert!(combination(&[[0.0; 3]], right, 3).is_none());
    }
}
