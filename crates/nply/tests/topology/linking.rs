//! Linking numbers and the Gauss integral.

use nply::topology::{linking_integral, linking_matrix, linking_number};
use proptest::prelude::*;

use crate::config;
use crate::curves::{Vector, closed, link_by_pairs, mirrored, open, tangle, torus_link, turned};

#[test]
fn curves_that_wind_round_each_other_are_linked_as_often() {
    for k in -6..=6 {
        for n in [40, 41, 500] {
            let [one, other] = torus_link(n, k).map(closed);
            assert_eq!(linking_number(&one, &other).unwrap().value, i64::from(k));
            assert_eq!(linking_number(&other, &one).unwrap().value, i64::from(k));
            assert_eq!(linking_number(&one, &other.reversed()).unwrap().value, -i64::from(k));
        }
    }
}

#[test]
fn three_rings_and_a_fourth_apart() {
    let ring = |centre: Vector, upright: bool| {
        let point = |k: i32| {
            let (sin, cos) = (f64::from(k) * 0.1 * std::f64::consts::TAU).sin_cos();
            let [x, y, z] = centre;
            if upright { [x + cos, y, z + sin] } else { [x + cos, y + sin, z] }
        };
        closed((0..10).map(point).collect())
    };
    let chain = [
        ring([0.0, 0.0, 0.0], false),
        ring([1.0, 0.0, 0.0], true),
        ring([2.0, 0.0, 0.01], false),
        ring([0.0, 0.0, 5.0], false),
    ];
    let matrix = linking_matrix(&chain).unwrap();
    for (i, row) in matrix.iter().enumerate() {
        for (j, link) in row.iter().enumerate() {
            let next = i.abs_diff(j) == 1 && i.max(j) < 3;
            assert_eq!(link.abs(), i64::from(next), "{i} {j}");
            assert_eq!(*link, matrix[j][i]);
        }
    }
}

proptest! {
    #![proptest_config(config(40))]

    #[test]
    fn the_integral_is_the_sum_over_pairs(seed in 1_u64..1000, n in 3_usize..60, m in 3_usize..60, closed_one: bool, closed_other: bool) {
        let make = |points: Vec<Vector>, is_closed| if is_closed { closed(points) } else { open(points) };
        let (one, other) = (make(tangle(n, seed), closed_one), make(tangle(m, seed + 7777), closed_other));
        let (got, want) = (linking_integral(&one, &other).unwrap(), link_by_pairs(&one, &other));
        prop_assert!((got.value - want).abs() < 1e-10, "{got:?} {want}");
        prop_assert!(got.bound < 1e-8);
        if closed_one && closed_other {
            let link = linking_number(&one, &other).unwrap();
            prop_assert_eq!(link.value as f64, want.round());
            // motion changes nothing, a mirror the sign
            let moved = |curve: &[Vector]| closed(turned(curve, seed));
            prop_assert_eq!(linking_number(&moved(one.points()), &moved(other.points())).unwrap().value, link.value);
            let seen = |curve: &[Vector]| closed(mirrored(curve));
            prop_assert_eq!(linking_number(&seen(one.points()), &seen(other.points())).unwrap().value, -link.value);
        }
    }
}
