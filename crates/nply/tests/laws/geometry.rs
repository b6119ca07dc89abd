//! Contact, its limits, its inverses and its other branches.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use nply::Handedness;
use nply::geometry::{
    BranchKind, Centreline, Contact, ContactLine, HelicalAngle, SpecialLays, branch_at_anomaly, branches,
    packing_fraction,
};
use proptest::prelude::*;

use crate::common::touch::{slope, touch_at};
use crate::common::vector::{norm, sub};
use crate::{config, hand, strands};

/// Local minima of a distance over [−reach, reach]: where and how much.
fn minima(distance: impl Fn(f64) -> f64, reach: f64) -> Vec<(f64, f64)> {
    const STEPS: usize = 1500;
    let at = |i: usize| reach * (2.0 * i as f64 / STEPS as f64 - 1.0);
    let values: Vec<f64> = (0..=STEPS).map(|i| distance(at(i))).collect();
    let mut found = Vec::new();
    for i in 1..STEPS {
        if values[i] <= values[i - 1] && values[i] <= values[i + 1] && values[i] < 3.0 {
            let (mut a, mut b) = (at(i - 1), at(i + 1));
            for _ in 0..60 {
                let (p, q) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
                if distance(p) < distance(q) { b = q } else { a = p }
            }
            found.push((0.5 * (a + b), distance(0.5 * (a + b))));
        }
    }
    found
}

proptest! {
    #![proptest_config(config(120))]

    /// No two strands, nor two turns of one, come closer than two radii; neighbours do, where the contact line says.
    #[test]
    fn contact_is_the_least_distance(n in strands(), degrees in 0.5..88.0_f64, hand in hand()) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let (line, start) = (ContactLine::new(&contact, hand), Centreline::new(&contact, hand, 0).position(0.0));
        let reach = 4.0 / contact.angle().cos(); // beyond, strands are more than four radii higher
        let mut touching = 0;
        for strand in 0..n {
            let other = Centreline::new(&contact, hand, strand);
            for (s, d) in minima(|s| norm(sub(other.position(s), start)), reach) {
                if strand == 0 && s.abs() < 1.0 {
                    continue; // the point itself
                }
                prop_assert!(d > 2.0 - 1e-9, "strand {strand} at {s}: {d}");
                if d < 2.0 + 1e-9 {
                    touching += 1;
                    let next = strand == 1 && (s - line.shift()).abs() < 1e-4 * reach;
                    let last = strand == n - 1 && (s + line.shift()).abs() < 1e-4 * reach;
                    prop_assert!(next || last, "strand {strand} touches at {s}, not at {}", line.shift());
                }
            }
        }
        let wanted = if n == 2 && degrees <= 45.0 { 1 } else { 2 };
        // just above 45 degrees the two places of a 2-ply are nearly one
        prop_assert!(touching == wanted || n == 2 && (degrees - 45.0).abs() < 0.1, "{touching} places");
    }

    /// The tubes leave the hole free and touch it; points of the contact line are on both surfaces.
    #[test]
    fn hole_and_contact_line(n in strands(), degrees in 0.5..88.0_f64, hand in hand(), s in -5.0..5.0_f64) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let line = ContactLine::new(&contact, hand);
        let point = line.position(s);
        for (strand, at) in [(0, s - 0.5 * line.shift()), (1, s + 0.5 * line.shift())] {
            let centre = Centreline::new(&contact, hand, strand).position(at);
            prop_assert!((norm(sub(point, centre)) - 1.0).abs() < 1e-12 * contact.radius_ratio());
        }
        prop_assert!((point[0].hypot(point[1]) - line.radius()).abs() < 1e-12 * contact.radius_ratio());
        let hole = contact.hole_radius();
        prop_assert!((hole - (contact.radius_ratio() - 1.0)).abs() < 1e-14 * contact.radius_ratio());
        prop_assert!((contact.outer_radius() - hole - 2.0).abs() < 1e-14 * contact.radius_ratio());
        let centre = Centreline::new(&contact, hand, 0).position(s);
        let axis = [0.0, 0.0, centre[2]];
        prop_assert!((norm(sub(centre, axis)) - 1.0 - hole).abs() < 1e-13 * contact.radius_ratio());
    }

    #[test]
    fn mirror_image(n in strands(), degrees in 0.5..88.0_f64, s in -5.0..5.0_f64, strand in 0..40_u32) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let strand = strand % n;
        let [right, left] = Handedness::BOTH.map(|hand| Centreline::new(&contact, hand, strand));
        let (p, q) = (right.frame(s), left.frame(s));
        if strand == 0 {
            // in the plane x = 0 through the axis: the hands' strands 0 both start at ∓R e₂, turned by π
            let (a, b) = (right.position(s), left.position(s));
            prop_assert!((a[0] - b[0]).abs() < 1e-13 && (a[1] + b[1]).abs() < 1e-12 * contact.radius_ratio());
            prop_assert!((p.tangent[0] - q.tangent[0]).abs() < 1e-14 && (p.tangent[1] + q.tangent[1]).abs() < 1e-14);
        }
        prop_assert_eq!(p.tangent[2], q.tangent[2]);
        let [right, left] = Handedness::BOTH.map(|hand| ContactLine::new(&contact, hand));
        prop_assert_eq!(right.shift(), -left.shift());
        prop_assert_eq!(right.radius(), left.radius());
    }

    #[test]
    fn limits(n in strands(), exponent in 4.0..9.0_f64) {
        let small = 10_f64.powf(-exponent);
        let (nf, order) = (f64::from(n), 10.0 * small * small * f64::from(n * n) + 1e-14);
        let steep = Contact::new(n, small).unwrap();
        prop_assert!((steep.radius_ratio() * (PI / nf).sin() - 1.0).abs() < order);
        prop_assert!((steep.arclength_shift() / small - (TAU / nf).sin()).abs() < order);
        let cos = (PI / nf).cos();
        prop_assert!((steep.shift_ratio_squared() / (small * small) - cos * cos).abs() < order);
        let flat = Contact::at_angle(n, HelicalAngle::from_pitch_angle(small).unwrap()).unwrap();
        prop_assert!((flat.arclength_shift() - TAU / nf).abs() < order);
        prop_assert!((flat.radius_ratio() * flat.angle().cos() * PI / nf - 1.0).abs() < order);
        prop_assert!((flat.lay_length() / (2.0 * nf) - 1.0).abs() < order);
    }

    /// By bisection of (5), and the slopes by differences of it.
    #[test]
    fn bisection_agrees(n in strands(), degrees in 0.1..89.0_f64) {
        let contact = Contact::new(n, degrees.to_radians()).unwrap();
        let (theta, t) = (contact.helical_angle(), touch_at(n, contact.helical_angle()));
        prop_assert!((contact.radius_ratio() / t.rho - 1.0).abs() < 1e-13);
        prop_assert!((contact.arclength_shift() - t.x).abs() < 1e-13 || n == 2 && (degrees - 45.0).abs() < 0.01);
        let q = (t.x * t.rho / 2.0).powi(2);
        prop_assert!((contact.shift_ratio_squared() - q).abs() < 1e-12 * (1.0 + q));
        prop_assert!((contact.radius_ratio_slope() - t.rho * q * t.c / t.s).abs() < 1e-12 * (1.0 + t.rho * q));
        let corner = (theta - FRAC_PI_4).abs();
        if corner > 1e-3 {
            let h = 0.02 * corner.min(theta).min(FRAC_PI_2 - theta);
            let q_at = |theta| {
                let t = touch_at(n, theta);
                (t.x * t.rho / 2.0).powi(2)
            };
            let got = contact.shift_ratio_squared_slope();
            let want = slope(q_at, theta, h);
            prop_assert!((got - want).abs() < 1e-6 * (want.abs() + q / theta) + 1e-12 / h, "{got} {want}");
        }
        let lay = TAU * t.rho * t.c / t.s;
        prop_assert!((contact.lay_length() / lay - 1.0).abs() < 1e-12);
        prop_assert!((contact.lay_ratio() / (lay / (2.0 * (t.rho + 1.0))) - 1.0).abs() < 1e-12);
    }

    /// Both ways to give an angle are one angle.
    #[test]
    fn angle_and_complement(n in strands(), theta in 1e-3..1.57_f64) {
        let by_angle = HelicalAngle::new(theta).unwrap();
        let by_pitch = HelicalAngle::from_pitch_angle(by_angle.pitch_angle()).unwrap();
        prop_assert!((by_pitch.radians() - theta).abs() <= 3e-16);
        prop_assert!((by_pitch.cos_double() - by_angle.cos_double()).abs() < 1e-15);
        prop_assert!((by_angle.cos_double() - (2.0 * theta).cos()).abs() < 1e-15);
        prop_assert!((by_angle.degrees() - theta.to_degrees()).abs() < 3e-14);
        let [a, b] = [by_angle, by_pitch].map(|angle| Contact::at_angle(n, angle).unwrap());
        prop_assert!((a.radius_ratio() / b.radius_ratio() - 1.0).abs() < 2e-15 / by_angle.cos());
    }

    /// Inverse to the quantities themselves, from almost straight strands to almost flat rings.
    #[test]
    fn lays_and_radii_are_inverse(n in strands(), part in -9.0..9.0_f64) {
        // an angle as close to 0 or π/2 as 1e-9
        let t = 10_f64.powf(-part.abs()) * FRAC_PI_4;
        let angle = if part < 0.0 { HelicalAngle::new(t) } else { HelicalAngle::from_pitch_angle(t) }.unwrap();
        let contact = Contact::at_angle(n, angle).unwrap();
        let found = Contact::from_lay_ratio(n, contact.lay_ratio()).unwrap();
        prop_assert!((found.lay_ratio() / contact.lay_ratio() - 1.0).abs() < 1e-14);
        prop_assert!(((found.angle().sin() / angle.sin() - 1.0).abs() + (found.angle().cos() / angle.cos() - 1.0).abs()) < 1e-13);
        if contact.lay_length() > 2.0 * f64::from(n) * (1.0 + 1e-13) { // nearer to 2n the pitch is lost in rounding
            let found = Contact::from_lay_length(n, contact.lay_length()).unwrap();
            prop_assert!((found.lay_length() / contact.lay_length() - 1.0).abs() < 1e-14);
        }
        if contact.radius_ratio() > 1.0 {
            let found = Contact::from_radius_ratio(n, contact.radius_ratio()).unwrap();
            prop_assert!((found.radius_ratio() / contact.radius_ratio() - 1.0).abs() < 1e-14);
            prop_assert!((found.angle().cos() / angle.cos() - 1.0).abs() < 1e-13 || angle.radians() < 0.8);
        }
    }

    /// All solutions of (5), by a dense scan of it; the main one is the least of Δ.
    #[test]
    fn branches_are_all_solutions(n in 2..=12_u32, degrees in 1.0..84.0_f64) {
        prop_assume!((degrees - 45.0).abs() > 0.5); // the pair of two strands is too close for the scan
        let angle = HelicalAngle::new(degrees.to_radians()).unwrap();
        let (s, c, lambda) = (angle.sin(), angle.cos(), TAU / f64::from(n));
        let five = |x: f64| x * c * c + s * (x * s - lambda).sin();
        let delta = |x: f64| 2.0 + x * x * c * c - 2.0 * (x * s - lambda).cos();
        let found = branches(n, angle, 10_000).unwrap();
        for branch in &found {
            let x = branch.arclength_shift;
            prop_assert!(five(x).abs() < 1e-13 * (1.0 + x.abs()), "(5): {branch:?}");
            prop_assert!((delta(x) - 4.0 / branch.radius_ratio.powi(2)).abs() < 1e-13 * (4.0 + x * x * c * c), "(4)");
            prop_assert!((branch.curvature - s * s / branch.radius_ratio).abs() < 1e-14 * (1.0 + branch.curvature));
            prop_assert_eq!(branch.keeps_curvature(), branch.curvature <= 1.0);
            prop_assert_eq!(branch.self_penetrating(), branch.kind != BranchKind::Main);
            let bend = c * c + s * s * (x * s - lambda).cos();
            if bend.abs() > 1e-9 {
                prop_assert_eq!(branch.local_minimum, bend > 0.0, "{:?}", branch);
            }
        }
        // by its anomaly each is found again
        for branch in found.iter().filter(|b| b.kind != BranchKind::Trivial && b.arclength_shift != 0.0) {
            let (again, same) = branch_at_anomaly(n, lambda - branch.arclength_shift * s).unwrap().unwrap();
            prop_assert!((again.radians() - angle.radians()).abs() < 1e-9, "{branch:?}: {again:?}");
            prop_assert_eq!(same.kind, branch.kind);
            prop_assert!((same.arclength_shift / branch.arclength_shift - 1.0).abs() < 1e-8);
        }
        for pair in found.windows(2) {
            prop_assert!(pair[0].arclength_shift.abs() <= pair[1].arclength_shift.abs());
        }
        // solutions lie where |x| cos²θ ≤ sin θ
        let reach = s / (c * c) + 0.1;
        let steps = (reach / 2e-4) as i32 + 10;
        let (mut count, mut least, mut near_fold) = (0, f64::MAX, false);
        let offset = 0.37;
        let mut before = five(-reach);
        for i in 1..=steps {
            let x = reach * (2.0 * (f64::from(i) - offset) / f64::from(steps) - 1.0);
            let here = five(x);
            count += usize::from((here > 0.0) != (before > 0.0));
            near_fold |= here.abs() < 1e-5 && (c * c + s * s * (x * s - lambda).cos()).abs() < 1e-2;
            least = least.min(delta(x));
            before = here;
        }
        prop_assert!(count == found.len() || near_fold, "{count} by scan, {found:?}");
        let main = found.iter().find(|b| b.kind == BranchKind::Main).unwrap();
        prop_assert!(delta(main.arclength_shift) <= least + 1e-13);
        prop_assert!(least - delta(main.arclength_shift) < 1e-6);
        for few in [1, 2, 3, 6] {
            let some = branches(n, angle, few).unwrap();
            prop_assert_eq!(some.len(), few.min(found.len()));
            prop_assert!(some.iter().all(|b| found.contains(b)));
        }
    }
}

/// As the documentation has it: a limit keeps those nearest to x = 0.
#[test]
fn a_limit_keeps_the_nearest_branches() {
    let angle = HelicalAngle::new(74.25_f64.to_radians()).unwrap();
    let all = branches(3, angle, 100).unwrap();
    for few in 1..all.len() {
        assert_eq!(branches(3, angle, few).unwrap(), all[..few], "{few} of {}", all.len());
    }
}

/// Two strands just above 45°, δ past it: with z² = 24δ − 19.2δ² + …, x = √(48δ)(1 − 1.4δ), R − r = 6δ², dρ/dθ = 12δ.
#[test]
fn pitchfork_of_two_strands() {
    for exponent in 3..=12 {
        let theta = FRAC_PI_4 + 10_f64.powi(-exponent);
        let delta = (theta - FRAC_PI_4) - 3.061_616_997_868_383e-17;
        let contact = Contact::new(2, theta).unwrap();
        let x = contact.arclength_shift() / (48.0 * delta).sqrt() / (1.0 - 1.4 * delta) - 1.0;
        assert!(x.abs() < 20.0 * delta * delta + 1e-15, "x is off by {x:e} at {delta:e}");
        let hole = contact.hole_radius() / (6.0 * delta * delta) - 1.0;
        assert!(hole.abs() < 10.0 * delta + 4e-15, "the hole is off by {hole:e} at {delta:e}");
        let slope = contact.radius_ratio_slope() / (12.0 * delta) - 1.0;
        assert!(slope.abs() < 10.0 * delta + 4e-15, "the slope is off by {slope:e} at {delta:e}");
        let q = contact.shift_ratio_squared() / (12.0 * delta) - 1.0;
        assert!(q.abs() < 10.0 * delta + 4e-15, "q is off by {q:e} at {delta:e}");
    }
    let diagonal = Contact::new(2, FRAC_PI_4).unwrap();
    assert_eq!((diagonal.arclength_shift(), diagonal.hole_radius(), diagonal.radius_ratio()), (0.0, 0.0, 1.0));
}

/// Each special lay has more of its quantity than any other of the branch; the densest packing of six and more is that of straight strands.
#[test]
fn special_lays_are_greatest() {
    let branch = |n: u32| (1..2000).map(move |k| Contact::new(n, FRAC_PI_2 * f64::from(k) / 2000.0).unwrap());
    let sin_cos = |contact: &Contact| contact.helical_angle().sin_cos();
    for n in 2..=12 {
        let lays = SpecialLays::of(n).unwrap();
        let turns = |contact: &Contact| sin_cos(contact).0 / contact.radius_ratio();
        let torsion = |contact: &Contact| turns(contact) * sin_cos(contact).1;
        let curvature = |contact: &Contact| turns(contact) * sin_cos(contact).0;
        let greatest = |quantity: &dyn Fn(&Contact) -> f64| branch(n).map(|lay| quantity(&lay)).fold(0.0, f64::max);
        for (lay, quantity) in [
            (lays.zero_twist(), &turns as &dyn Fn(&Contact) -> f64),
            (lays.most_torsion(), &torsion),
            (lays.most_curvature(), &curvature),
        ] {
            let (here, most) = (quantity(&lay), greatest(quantity));
            assert!(here >= most * (1.0 - 1e-14) && here < most * (1.0 + 1e-5), "{n} strands: {here}, not {most}");
        }
        let packing = greatest(&packing_fraction);
        let densest = lays.close_packed();
        assert_eq!(densest.is_some(), n < 6, "{n} strands");
        let here =
            densest.map_or_else(|| packing_fraction(&Contact::new(n, 0.0).unwrap()), |lay| packing_fraction(&lay));
        assert!(here >= packing * (1.0 - 1e-14) && here < packing * (1.0 + 1e-5), "{n} strands: {here}, not {packing}");
    }
}
