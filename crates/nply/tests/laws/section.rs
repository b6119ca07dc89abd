//! The cut across the ply.

use nply::geometry::{Centreline, Contact, Section};
use proptest::prelude::*;

use crate::common::vector::{dot, norm, sub};
use crate::{config, hand, strands};

/// The least signed curvature of the outline, times its speed cubed, by differences over a dense scan.
fn hollowest(section: &Section) -> f64 {
    let h = 1e-3;
    let mut areas = Vec::new();
    for i in 0..4000 {
        // dense where the outline turns hollow first: α = π/2
        let u = f64::from(i) / 4000.0 * 2.0 - 1.0;
        let alpha = std::f64::consts::FRAC_PI_2 + std::f64::consts::PI * u * u * u;
        let [p, o, q] = [-h, 0.0, h].map(|d| section.outline(0, 0.0, alpha + d));
        let first = [(q[0] - p[0]) / (2.0 * h), (q[1] - p[1]) / (2.0 * h)];
        let second = [(q[0] - 2.0 * o[0] + p[0]) / (h * h), (q[1] - 2.0 * o[1] + p[1]) / (h * h)];
        areas.push(first[0] * second[1] - first[1] * second[0]);
    }
    // counted positive the way round the outline runs
    let way = areas.iter().sum::<f64>().signum();
    areas.iter().fold(f64::MAX, |least, area| least.min(way * area))
}

proptest! {
    #![proptest_config(config(96))]

    #[test]
    fn outline_lies_on_the_tube(n in strands(), degrees in 0.5..85.0_f64, hand in hand(), z in -3.0..3.0_f64, alpha in 0.0..6.3_f64) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let section = Section::new(&contact, hand);
        for strand in 0..n {
            let [x, y] = section.outline(strand, z, alpha);
            let (line, s) = (Centreline::new(&contact, hand, strand), section.arclength(z, alpha));
            let radius = sub([x, y, z], line.position(s));
            let size = 1e-12 * (contact.radius_ratio() + s.abs());
            prop_assert!((norm(radius) - 1.0).abs() < size);
            prop_assert!(dot(radius, line.frame(s).tangent).abs() < size);
        }
    }

    #[test]
    fn convexity_is_that_of_the_outline(n in 2..=12_u32, degrees in 5.0..75.0_f64, hand in hand()) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let turns = Section::non_convex_angle(n).unwrap();
        prop_assume!((degrees - turns.degrees()).abs() > 0.2);
        let section = Section::new(&contact, hand);
        prop_assert_eq!(section.is_convex(), degrees < turns.degrees());
        let least = hollowest(&section);
        prop_assert_eq!(section.is_convex(), least > 0.0, "{}", least);
    }
}

#[test]
fn the_angle_at_which_it_turns() {
    for n in 2..=40 {
        let turns = Section::non_convex_angle(n).unwrap().radians();
        for (theta, convex) in [(turns - 1e-12, true), (turns + 1e-12, false)] {
            let contact = Contact::new(n, theta).unwrap();
            assert_eq!(Section::new(&contact, nply::Handedness::Left).is_convex(), convex, "n = {n}, {theta}");
        }
    }
}
