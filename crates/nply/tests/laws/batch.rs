//! Arrays of plies at once, held against one ply at a time.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use nply::geometry::{Contact, contact_batch};
use proptest::prelude::*;

use super::config;

fn contacts(strands: &[u32], angles: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<usize>) {
    let (mut shift, mut radius) = (vec![0.0; strands.len()], vec![0.0; strands.len()]);
    let mut refused = Vec::new();
    contact_batch(strands, angles, &mut shift, &mut radius, |row, _| refused.push(row)).unwrap();
    (shift, radius, refused)
}

/// Units in the last place between two numbers of one sign.
fn units(got: f64, want: f64) -> u64 {
    got.to_bits().abs_diff(want.to_bits())
}

/// Both ends, π/4 and the doubles next to it, borders of any halving of the range, and what lies between.
fn angles() -> impl Strategy<Value = f64> {
    let ulps = |from: f64| (-40..=40_i64).prop_map(move |k| f64::from_bits(from.to_bits().wrapping_add_signed(k)));
    prop_oneof![
        4 => 0.0..FRAC_PI_2,
        1 => (-300.0..0.0_f64).prop_map(|e| 10_f64.powf(e)),
        1 => (-15.0..0.0_f64).prop_map(|e| FRAC_PI_2 - 10_f64.powf(e)),
        1 => (-16.0..-1.0_f64).prop_map(|e| FRAC_PI_4 + 10_f64.powf(e)),
        1 => ulps(FRAC_PI_4),
        1 => (0..=96_i32).prop_map(|k| FRAC_PI_2 * f64::from(k) / 96.0),
        1 => (1..=40_u64).prop_map(|k| f64::from_bits(FRAC_PI_2.to_bits() - k)),
    ]
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn contacts_of_an_array_are_those_of_its_rows(
        rows in prop::collection::vec((prop_oneof![2 => Just(2_u32), 6 => 2..=12_u32, 1 => 13..=1000_u32], angles()), 0..150),
    ) {
        let (strands, angles): (Vec<u32>, Vec<f64>) = rows.into_iter().unzip();
        let (shift, radius, refused) = contacts(&strands, &angles);
        prop_assert!(refused.is_empty());
        for (i, (&n, &theta)) in strands.iter().zip(&angles).enumerate() {
            let one = Contact::new(n, theta).unwrap();
            let (x, rho) = (one.arclength_shift(), one.radius_ratio());
            prop_assert!(units(shift[i], x) <= 8, "n = {n} at {theta:e}: x {:e}, alone {x:e}", shift[i]);
            prop_assert!(units(radius[i], rho) <= 8, "n = {n} at {theta:e}: ρ {:e}, alone {rho:e}", radius[i]);
        }
    }
}

#[test]
fn a_refused_row_touches_no_other() {
    let count = 100;
    let strands: Vec<u32> = (0..count).map(|i| 2 + i % 12).collect(); // up to thirteen
    let angles: Vec<f64> = (0..count).map(|i| 0.015 * f64::from(i)).collect();
    let (shift, radius, _) = contacts(&strands, &angles);
    let bad = [
        (0, 1, 0.3),
        (7, 0, 0.3),
        (33, 3, f64::NAN),
        (34, 3, -1e-300),
        (35, 3, 1.571),
        (63, 40, f64::INFINITY),
        (99, u32::MAX, -0.1),
    ];
    let (mut n, mut theta) = (strands, angles);
    for (row, strands, angle) in bad {
        (n[row], theta[row]) = (strands, angle);
    }
    let (mut x, mut rho) = (vec![0.0; n.len()], vec![0.0; n.len()]);
    let mut reasons = Vec::new();
    contact_batch(&n, &theta, &mut x, &mut rho, |row, error| reasons.push((row, error.quantity))).unwrap();
    let angle = "helical_angle";
    let want = [(0, "strands"), (7, "strands"), (33, angle), (34, angle), (35, angle), (63, angle), (99, angle)];
    assert_eq!(reasons, want);
    for row in 0..n.len() {
        if bad.iter().any(|b| b.0 == row) {
            assert!(x[row].is_nan() && rho[row].is_nan());
        } else {
            assert_eq!(
                (x[row].to_bits(), rho[row].to_bits()),
                (shift[row].to_bits(), radius[row].to_bits()),
                "row {row}"
            );
        }
    }
    assert_eq!(contact_batch(&n, &theta[1..], &mut x, &mut rho, |_, _| ()).unwrap_err().quantity, "helical_angles");
}

#[test]
fn a_row_is_the_same_wherever_it_stands() {
    let strands: Vec<u32> = (0..77).map(|i| 2 + (i * 5) % 11).collect();
    let angles: Vec<f64> = (0..77).map(|i| 0.02 * f64::from(i)).collect();
    let (shift, radius, _) = contacts(&strands, &angles);
    for start in 0..77 {
        let (x, rho, _) = contacts(&strands[start..], &angles[start..]);
        assert_eq!((&x[..], &rho[..]), (&shift[start..], &radius[start..]));
    }
}
