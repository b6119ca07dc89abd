//! On which side: signs that rounding cannot turn.

use super::curve::collinear;
use crate::numerics::vector::{Vector, cross, dot, sub};

/// The sign of det(b − a, c − a, d), exactly: whether the shadows of a, b, c along d run round anticlockwise (1), clockwise (−1) or lie on a line.
#[inline]
pub(crate) fn turn(a: Vector, b: Vector, c: Vector, d: Vector) -> i32 {
    let (e, f) = (sub(b, a), sub(c, a));
    let det = dot(d, cross(e, f));
    let magnitude = [[0, 1, 2], [1, 2, 0], [2, 0, 1]]
        .iter()
        .map(|&[i, j, k]| d[k].abs() * ((e[i] * f[j]).abs() + (e[j] * f[i]).abs()))
        .sum::<f64>();
    // differences, products and sums: seven roundings at most on the way of any term
    if det.abs() > 10.0 * f64::EPSILON * magnitude { if det > 0.0 { 1 } else { -1 } } else { exact_turn(a, b, c, d) }
}

/// The same from d·(a × b + b × c + c × a), whose terms are products of three coordinates, four numbers each without any rounding.
#[cold]
fn exact_turn(a: Vector, b: Vector, c: Vector, d: Vector) -> i32 {
    let mut terms = Vec::with_capacity(72);
    for [p, q] in [[a, b], [b, c], [c, a]] {
        for [i, j, k] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
            for (x, y) in [(p[i], q[j]), (-p[j], q[i])] {
                for half in two_product(x, y) {
                    terms.extend(two_product(half, d[k]));
                }
            }
        }
    }
    sign_of_sum(&terms)
}

/// xy as a double and what it leaves out.
fn two_product(x: f64, y: f64) -> [f64; 2] {
    let product = x * y;
    [product, libm::fma(x, y, -product)]
}

/// The sign of a sum without rounding: the sum is kept as doubles that do not overlap (Shewchuk, doi:10.1007/PL00009321, grow-expansion).
fn sign_of_sum(terms: &[f64]) -> i32 {
    let mut sum: Vec<f64> = Vec::with_capacity(terms.len());
    for &term in terms {
        let mut carry = term;
        for part in &mut sum {
            let total = carry + *part;
            let share = total - carry;
            let rest = (carry - (total - share)) + (*part - share);
            (*part, carry) = (rest, total);
        }
        sum.push(carry);
    }
    // the last part that is not zero outweighs all before it
    match sum.iter().rev().find(|&&part| part != 0.0) {
        Some(&part) => {
            if part > 0.0 {
                1
            } else {
                -1
            }
        }
        None => 0,
    }
}

/// The sign of (a − c)·((b − a) × (d − c)), exactly: 1 where ab passes cd right-handed, 0 where all four lie in a plane.
#[inline]
pub(crate) fn hand(a: Vector, b: Vector, c: Vector, d: Vector) -> i32 {
    let point = |p: Vector| robust::Coord3D { x: p[0], y: p[1], z: p[2] };
    let det = robust::orient3d(point(a), point(b), point(c), point(d));
    i32::from(det < 0.0) - i32::from(det > 0.0)
}

/// Whether two segments that lie in one plane, or nearly so, have a point in common, exactly.
pub(crate) fn touch([a, b]: [Vector; 2], [c, d]: [Vector; 2]) -> bool {
    if hand(a, b, c, d) != 0 {
        return false;
    }
    let on = |p: Vector, a: Vector, b: Vector| {
        collinear(a, b, p) && (0..3).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]))
    };
    if on(c, a, b) || on(d, a, b) || on(a, c, d) || on(b, c, d) {
        return true;
    }
    // in one plane, no end on the other: they cross in every shadow or in none
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .iter()
        .any(|&axis| turn(a, b, c, axis) * turn(a, b, d, axis) < 0 && turn(c, d, a, axis) * turn(c, d, b, axis) < 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_turn_that_rounding_loses_is_found() {
        let d = [0.0, 0.0, 1.0];
        let (a, b) = ([0.1, 0.1, 0.0], [0.3, 0.3, 0.5]);
        let c = [0.2, 0.2, 0.7];
        assert_eq!(turn(a, b, c, d), 0);
        assert_eq!(turn(a, b, [0.2, 0.2_f64.next_up(), 0.7], d), 1);
        assert_eq!(turn(a, b, [0.2_f64.next_up(), 0.2, 0.7], d), -1);
    }

    #[test]
    fn segments_in_one_plane_touch_where_each_passes_the_other() {
        let flat = |[x, y]: [f64; 2]| [x, y, 1.0 + 2.0 * x - y]; // in a plane that no axis lies in
        let (a, b) = (flat([0.0, 0.0]), flat([1.0, 0.0]));
        let touches = |c, d| touch([a, b], [flat(c), flat(d)]);
        assert!(touches([0.25, -1.0], [0.5, 1.0]) && touches([1.0, 0.0], [2.0, 3.0]));
        // the line through ab passes between c and d, but beyond b; and the other way round
        assert!(!touches([2.0, -1.0], [2.0, 1.0]) && !touches([0.5, 1.0], [0.5, 2.0]));
        assert!(!touches([2.0, 0.0], [3.0, 0.0]) && touches([0.5, 0.0], [3.0, 0.0])); // along one line
    }

    #[test]
    fn a_sum_is_taken_without_rounding() {
        assert_eq!(sign_of_sum(&[1e300, 1.0, -1e300, -1.0, 1e-300]), 1);
        assert_eq!(sign_of_sum(&[1e300, 1e-300, -1e300, -1e-300]), 0);
        assert_eq!(sign_of_sum(&[1.0, -1e-40, -1.0]), -1);
    }
}
