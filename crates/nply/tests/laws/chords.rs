//! Strands of straight elements: clear, and no wider than that takes.

use std::f64::consts::{PI, TAU};

use nply::geometry::{Chords, Clearance, Contact, HelicalAngle, Vector, Wire, Wires};
use proptest::prelude::*;

use crate::config;

fn angle(degrees: f64) -> HelicalAngle {
    HelicalAngle::new(degrees.to_radians()).unwrap()
}

/// The polylines of a ply of R/r = ρ over several lay lengths, typed out anew, and their least distance by the index of wires.
fn searched(n: u32, degrees: f64, elements: u32, rho: f64, shifts: impl Fn(u32) -> f64) -> f64 {
    let pitch = TAU * rho / degrees.to_radians().tan();
    let turns = 3 * elements;
    let strands: Vec<Vec<Vector>> = (0..n)
        .map(|i| {
            let node = |k: u32| {
                let count = (f64::from(k) + shifts(i)) / f64::from(elements);
                let psi = TAU * count + TAU * f64::from(i) / f64::from(n);
                [rho * psi.cos(), rho * psi.sin(), pitch * count]
            };
            (0..=turns).map(node).collect()
        })
        .collect();
    let wires: Vec<Wire<'_>> = strands.iter().map(|points| Wire { points, closed: false, diameter: 0.0 }).collect();
    let wires = Wires::new(&wires).unwrap();
    wires.search(0..wires.segments(), &Clearance::default()).nearest().unwrap().distance
}

proptest! {
    #![proptest_config(config(32))]

    #[test]
    fn the_least_distance_is_that_of_every_pair_of_elements(
        n in 2..=9_u32, degrees in 5.0..60.0_f64, elements in 4..=40_u32, rho in 1.0..5.0_f64, stagger in 0.0..1.0_f64,
    ) {
        let chords = Chords::new(n, angle(degrees), elements).unwrap();
        let here = rho * chords.least_distance(stagger);
        let found = searched(n, degrees, elements, rho, |i| f64::from(i) * stagger);
        prop_assert!((here / found - 1.0).abs() < 1e-10, "{here} {found}");
        // no stagger of two strands is nearer than the nearest
        let least = rho * chords.least_distance_at_any_stagger();
        prop_assert!(least <= here * (1.0 + 1e-12));
    }

    #[test]
    fn the_nearest_stagger_is_the_nearest(n in 2..=5_u32, degrees in 5.0..50.0_f64, elements in 4..=16_u32) {
        let chords = Chords::new(n, angle(degrees), elements).unwrap();
        let least = chords.least_distance_at_any_stagger();
        // two strands alone, by a scan: the others stand aside
        let scan = (0..60).map(|k| searched(n, degrees, elements, 1.0, |i| if i == 1 { f64::from(k) / 60.0 } else { 0.0 }));
        let scanned = scan.fold(f64::MAX, f64::min);
        prop_assert!(least <= scanned + 1e-12 && least > scanned - 0.02 * scanned, "{least} {scanned}");
    }

    /// Smaller elements, smaller loss: by the square, as chords' heights are.
    #[test]
    fn many_elements_are_a_helix(n in 2..=12_u32, degrees in 3.0..70.0_f64) {
        let loss = |elements| {
            let chords = Chords::new(n, angle(degrees), elements).unwrap();
            (chords.smooth_distance() - chords.least_distance_at_any_stagger()) / chords.smooth_distance()
        };
        let (coarse, fine) = (loss(200), loss(800));
        prop_assert!(fine < 1e-3 && fine > -1e-9);
        prop_assert!(coarse < 1e-7 || (coarse / fine - 16.0).abs() < 4.0, "{coarse} {fine}");
    }

    /// At the radius found the elements are the wanted distance apart, a little below it they are not.
    #[test]
    fn the_narrowest_lay_clears_and_no_narrower_does(
        n in 2..=9_u32, degrees in 5.0..50.0_f64, elements in 8..=40_u32, coating in 0.0..0.5_f64, stagger in 0.0..1.0_f64,
    ) {
        let wanted = 2.0 * (1.0 + coating);
        let chords = Chords::new(n, angle(degrees), elements).unwrap();
        let lay = chords.narrowest(wanted, 0.0, Some(stagger)).unwrap();
        let found = searched(n, degrees, elements, lay.radius_ratio, |i| f64::from(i) * stagger);
        prop_assert!((found / wanted - 1.0).abs() < 1e-10);
        prop_assert!((lay.least_distance / wanted - 1.0).abs() < 1e-12);
        // the helices themselves: (4), scaled
        let rho = Contact::new(n, degrees.to_radians()).unwrap().radius_ratio();
        prop_assert!((lay.smooth_distance - 2.0 * lay.radius_ratio / rho).abs() < 1e-12);
        // the same lay length gives the same lay, its angle found
        let length = TAU * lay.radius_ratio / degrees.to_radians().tan();
        let again = Chords::narrowest_of_lay_length(n, length, elements, wanted, 0.0, Some(stagger)).unwrap();
        prop_assert!(again.least_distance >= wanted * (1.0 - 1e-12) && again.radius_ratio <= lay.radius_ratio * (1.0 + 1e-9));
        let a_little_less = HelicalAngle::new(again.chords.angle().radians() * (1.0 - 1e-6)).unwrap();
        let narrower = Chords::new(n, a_little_less, elements).unwrap().laid(length * a_little_less.tan() / TAU, Some(stagger));
        prop_assert!(narrower.least_distance < wanted);
    }
}

/// Six wires on a king wire as thick, R = 2r at 17.44°: the helices overlap, elements more so; the corrected radius clears both wires and king.
#[test]
fn seven_wires_overlap_until_their_radius_is_corrected() {
    for elements in [6, 12, 24, 60] {
        let chords = Chords::new(6, angle(17.44), elements).unwrap();
        for stagger in [Some(0.0), Some(0.3), None] {
            let upright = chords.laid(2.0, stagger);
            assert!(upright.smooth_distance < 2.0 - 0.05, "{upright:?}");
            assert!(upright.least_distance < upright.smooth_distance);
            let king = 2.0 * (PI / f64::from(elements)).cos();
            assert!((2.0 * chords.core_distance() - king).abs() < 1e-15);
            let lay = chords.narrowest(2.0, 2.0, stagger).unwrap();
            assert!(lay.radius_ratio > 2.0 && lay.least_distance >= 2.0 - 1e-12);
            assert!(lay.radius_ratio * chords.core_distance() >= 2.0 - 1e-12);
            if let Some(stagger) = stagger {
                let found = searched(6, 17.44, elements, lay.radius_ratio, |i| f64::from(i) * stagger);
                assert!(found >= 2.0 - 1e-10, "{elements} {found}");
            }
        }
    }
}

#[test]
fn what_has_no_lay_is_refused() {
    assert_eq!(Chords::new(1, angle(20.0), 12).unwrap_err().quantity, "strands");
    assert_eq!(Chords::new(3, angle(0.0), 12).unwrap_err().quantity, "helical_angle");
    assert_eq!(Chords::new(3, angle(20.0), 2).unwrap_err().quantity, "elements");
    let chords = Chords::new(3, angle(20.0), 12).unwrap();
    assert_eq!(chords.narrowest(f64::NAN, 0.0, None).unwrap_err().quantity, "distance");
    // flat rings of n strands need 2n radii
    let short = Chords::narrowest_of_lay_length(6, 11.9, 48, 2.0, 0.0, Some(0.0)).unwrap_err();
    assert_eq!(short.quantity, "lay_length");
    assert!(Chords::narrowest_of_lay_length(6, 20.0, 48, 2.0, 0.0, Some(0.0)).is_ok());
}
