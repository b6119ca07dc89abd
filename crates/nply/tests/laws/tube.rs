//! Strands as bodies: feet of perpendiculars, closed surfaces, what they enclose.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use nply::Handedness;
use nply::geometry::{Centreline, Contact, Course, DoubleHelix, Ends, Facets, Fit, HelicalAngle, Tube, TubeMesh};
use proptest::prelude::*;

use crate::common::vector::{cross, dot, norm, sub, times};
use crate::{config, hand, strands};

fn strand(n: u32, degrees: f64, hand: Handedness, i: u32) -> Centreline {
    Centreline::new(&Contact::new(n, degrees.to_radians()).unwrap(), hand, i)
}

/// The least distance of a point from a course near a parameter, by a dense scan refined around its least.
fn scanned(course: &Course, point: [f64; 3], around: f64, reach: f64) -> f64 {
    let distance = |t: f64| norm(sub(course.place(t).position, point));
    let (mut middle, mut half, mut least) = (around, reach, f64::MAX);
    let mut steps = 4000;
    for _ in 0..12 {
        let best = (0..=steps)
            .map(|k| middle + half * (2.0 * f64::from(k) / f64::from(steps) - 1.0))
            .min_by(|a, b| distance(*a).total_cmp(&distance(*b)))
            .unwrap();
        least = distance(best).min(least);
        (middle, half) = (best, half * 4.0 / f64::from(steps));
        steps = 40;
    }
    least
}

/// Closed and outward, without handles: every edge runs once each way, V − E + F = 2.
fn check_manifold(mesh: &TubeMesh) {
    let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
    for [a, b, c] in &mesh.triangles {
        for edge in [(*a, *b), (*b, *c), (*c, *a)] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    assert!(edges.iter().all(|(&(a, b), &count)| count == 1 && edges.contains_key(&(b, a))));
    let used: std::collections::HashSet<u32> = mesh.triangles.iter().flatten().copied().collect();
    assert_eq!(used.len(), mesh.positions.len());
    assert_eq!(mesh.positions.len() + mesh.triangles.len(), edges.len() / 2 + 2);
    assert_eq!((mesh.normals.len(), mesh.parameters.len()), (mesh.positions.len(), mesh.positions.len()));
    let corner = |i: u32| mesh.positions[i as usize];
    for (i, [a, b, c]) in mesh.triangles.iter().enumerate() {
        let face = cross(sub(corner(*b), corner(*a)), sub(corner(*c), corner(*a)));
        // sides look the way the tube's own normals look, ends the way of theirs
        let outward = if i < mesh.sides {
            mesh.normals[*a as usize]
        } else {
            mesh.end_normals[usize::from(i >= mesh.sides + (mesh.triangles.len() - mesh.sides) / 2)]
        };
        assert!(dot(face, outward) > 0.0, "triangle {i} looks inward");
    }
}

fn area(mesh: &TubeMesh) -> f64 {
    let corner = |i: u32| mesh.positions[i as usize];
    mesh.triangles
        .iter()
        .map(|t| 0.5 * norm(cross(sub(corner(t[1]), corner(t[0])), sub(corner(t[2]), corner(t[0])))))
        .sum()
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn the_foot_on_a_helix_is_the_nearest(
        rho in 0.3..8.0_f64, degrees in 0.0..85.0_f64, hand in hand(), phase in -7.0..7.0_f64,
        x in -9.0..9.0_f64, y in -9.0..9.0_f64, z in -20.0..20.0_f64,
    ) {
        let helix = Centreline::helix(rho, HelicalAngle::new(degrees.to_radians()).unwrap(), hand, phase).unwrap();
        let (s, distance) = helix.nearest([x, y, z]);
        prop_assert!((norm(sub(helix.position(s), [x, y, z])) - distance).abs() < 1e-11);
        // half a turn either way, and more than the height can make up for
        let reach = if degrees > 1.0 { 0.6 * TAU / helix.azimuth_rate().abs() } else { 20.0 };
        let least = scanned(&Course::from(helix), [x, y, z], z / helix.rise(), reach);
        prop_assert!(distance <= least + 1e-9, "{distance} {least}");
    }

    #[test]
    fn the_foot_on_a_double_helix_is_the_nearest(
        degrees in 0.0..35.0_f64, hand in hand(), ratio in 0.2..0.4_f64, rate in -0.6..0.6_f64, phase in -4.0..4.0_f64,
        t in -10.0..10.0_f64, alpha in 0.0..6.3_f64, share in 0.0..1.6_f64,
    ) {
        let strand = Centreline::helix(6.0, HelicalAngle::new(degrees.to_radians()).unwrap(), hand, 0.3).unwrap();
        let wire = DoubleHelix::new(strand, 6.0 * ratio, rate, phase).unwrap();
        // a frame of unit vectors at right angles, the tangent along the course
        let place = wire.place(t);
        let h = 1e-5;
        let chord = times(0.5 / h, sub(wire.place(t + h).position, wire.place(t - h).position));
        prop_assert!(norm(sub(chord, times(place.speed, place.tangent))) < 1e-8);
        prop_assert!(norm(sub(cross(place.tangent, place.inward), place.binormal)) < 1e-14);
        prop_assert!(dot(place.tangent, place.inward).abs() < 1e-14 && (norm(place.tangent) - 1.0).abs() < 1e-14);
        let point: [f64; 3] = std::array::from_fn(|i| {
            place.position[i] + share * (alpha.sin() * place.inward[i] + alpha.cos() * place.binormal[i])
        });
        let (_, distance) = wire.nearest(point);
        let reach = if rate.abs() > 0.1 { 0.7 * TAU / rate.abs() } else { 15.0 };
        let least = scanned(&Course::from(wire), point, t, reach.min(15.0));
        prop_assert!(distance <= least + 1e-7, "{distance} {least}");
        prop_assert!(distance >= least - 1e-9 || reach > 15.0, "{distance} {least}");
    }

    #[test]
    fn a_mesh_is_closed_and_near_its_tube(
        n in strands(), degrees in 0.0..75.0_f64, hand in hand(), twist in -0.4..0.4_f64, error in 0.004..0.05_f64,
        length in 2.0..12.0_f64, square in any::<bool>(),
    ) {
        let ends = if square { Ends::Square } else { Ends::Flush };
        let tube = Tube::new(strand(n, degrees, hand, 0), 1.0, -1.0, length).unwrap().with_ends(ends);
        // flush ends cut every material line once where it is steeper than the plane
        let tube = tube.twisted(if square { twist } else { twist / (1.0 + degrees.to_radians().tan()) }).unwrap();
        for fit in [Fit::Surface, Fit::Inside, Fit::Outside, Fit::Volume] {
            let facets = tube.facets(error, fit).unwrap();
            let mesh = tube.mesh(facets, fit).unwrap();
            check_manifold(&mesh);
            // Steiner: moving every face by the error changes the volume by no more than its area times that, to first order
            let off = mesh.volume() - tube.volume();
            prop_assert!(off.abs() < 1.1 * error * area(&mesh), "{fit:?} {off} {}", tube.volume());
            prop_assert!(mesh.deviation.iter().all(|off| off.abs() <= error * (1.0 + 1e-9)), "{fit:?} {:?}", mesh.deviation);
            // and nowhere between the points that were measured is a side much farther off
            let most = mesh.deviation[1].max(-mesh.deviation[0]);
            for [a, b, c] in mesh.triangles[..mesh.sides].iter().step_by(7) {
                let [a, b, c] = [a, b, c].map(|i| mesh.positions[*i as usize]);
                for (u, v) in [(0.1, 0.1), (0.4, 0.2), (0.2, 0.4), (0.4, 0.4), (0.25, 0.0), (0.0, 0.75), (0.6, 0.4)] {
                    let point: [f64; 3] = std::array::from_fn(|i| a[i] + u * (b[i] - a[i]) + v * (c[i] - a[i]));
                    prop_assert!(tube.distance(point).abs() < 1.05 * most + 1e-9, "{} {most}", tube.distance(point));
                }
            }
            match fit {
                Fit::Surface => for i in 0..(facets.around * (facets.along + 1)) as usize {
                    prop_assert!(tube.distance(mesh.positions[i]).abs() < 1e-12 * (1.0 + length / degrees.to_radians().cos()));
                },
                Fit::Inside => prop_assert!(off < 0.0 && mesh.deviation[1] < 1e-11),
                Fit::Outside => prop_assert!(off > 0.0 && mesh.deviation[0] > -1e-11),
                Fit::Volume => prop_assert!(off.abs() < 1e-8 * tube.volume()),
            }
            if !square {
                let heights: Vec<f64> = mesh.triangles[mesh.sides..].iter().flatten().map(|i| mesh.positions[*i as usize][2]).collect();
                prop_assert!(heights.iter().all(|z| *z == -1.0 || *z == length));
            }
        }
    }

    /// Meshes of neighbours come as close as the chord error and never farther into each other.
    #[test]
    fn meshes_of_touching_strands_touch(n in strands(), degrees in 2.0..70.0_f64, hand in hand(), error in 0.002..0.03_f64) {
        let tubes = [0, 1].map(|i| Tube::new(strand(n, degrees, hand, i), 1.0, 0.0, 8.0).unwrap());
        let meshes = tubes.map(|tube| tube.mesh(tube.facets(error, Fit::Surface).unwrap(), Fit::Surface).unwrap());
        let corners = |mesh: &TubeMesh| mesh.positions.clone();
        let least = corners(&meshes[0]).into_iter().map(|point| tubes[1].distance(point)).fold(f64::MAX, f64::min);
        prop_assert!(least > -1e-10, "{least}");
        // the corner next to the contact line is at most half a facet away from it
        let facet = PI / f64::from(tubes[0].facets(error, Fit::Surface).unwrap().around);
        prop_assert!(least < 40.0 * facet * facet + 0.02, "{least}");
        let inside = tubes[0].mesh(tubes[0].facets(error, Fit::Inside).unwrap(), Fit::Inside).unwrap();
        for [a, b, c] in &inside.triangles[..inside.sides] {
            let [a, b, c] = [a, b, c].map(|i| inside.positions[*i as usize]);
            let middle: [f64; 3] = std::array::from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
            prop_assert!(tubes[1].distance(middle) > -1e-11);
        }
    }
}

/// The ends of a flush tube are the true cut across the ply, πr²/cos θ in area: the volume over the length.
#[test]
fn flush_ends_have_the_area_of_the_cut() {
    for (n, degrees) in [(2, 30.0_f64), (3, 45.0), (3, 60.0), (4, 80.0), (6, 20.0)] {
        let tube = Tube::new(strand(n, degrees, Handedness::Left, 0), 1.0, 0.0, 3.0).unwrap();
        let mesh = tube.mesh(Facets { around: 720, along: 8 }, Fit::Surface).unwrap();
        let cut = PI / degrees.to_radians().cos();
        let found: f64 = mesh.triangles[mesh.sides..]
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
                0.5 * norm(cross(sub(b, a), sub(c, a)))
            })
            .sum();
        assert!((found / (2.0 * cut) - 1.0).abs() < 1e-4, "n {n} at {degrees}: {found} {cut}");
        check_manifold(&mesh);
    }
}

/// A painted line stays on its material: a strand twisted by its pretwist against the Frenet frame turns in space as (44) says.
#[test]
fn material_lines_turn_by_the_twist() {
    let (pretwist, line) = (-0.7, strand(3, 30.0, Handedness::Right, 0));
    let tube = Tube::new(line, 1.0, 0.0, 10.0).unwrap().with_ends(Ends::Square).twisted(pretwist).unwrap();
    let mesh = tube.mesh(Facets { around: 8, along: 4000 }, Fit::Surface).unwrap();
    // the twist of the ribbon between centreline and painted line: u₃ = (u × u′)·t, u across from one to the other
    let u = |i: usize| {
        let corner = i * 8;
        sub(mesh.positions[corner], line.position(mesh.parameters[corner][0]))
    };
    let h = mesh.parameters[8][0] - mesh.parameters[0][0];
    for i in [10, 1234, 3000] {
        let slope = times(0.5 / h, sub(u(i + 1), u(i - 1)));
        let t = line.frame(mesh.parameters[i * 8][0]).tangent;
        let twist = dot(cross(u(i), slope), t);
        assert!((twist - (pretwist + line.torsion())).abs() < 1e-5, "{twist}");
    }
}

/// A wire of a rope: square ends, Pappus' volume, closed.
#[test]
fn a_wire_of_a_rope_is_a_body_too() {
    let strand = Centreline::helix(6.0, HelicalAngle::new(0.3).unwrap(), Handedness::Right, 0.0).unwrap();
    for rate in [0.25, -0.25] {
        for ends in [Ends::Square, Ends::Flush] {
            let wire = DoubleHelix::new(strand, 2.0, rate, 0.4).unwrap();
            let tube = Tube::new(wire, 1.0, 0.0, 40.0).unwrap().with_ends(ends);
            let mesh = tube.mesh(tube.facets(0.01, Fit::Surface).unwrap(), Fit::Surface).unwrap();
            check_manifold(&mesh);
            assert!(mesh.deviation.iter().all(|off| off.abs() <= 0.01));
            assert!((mesh.volume() / tube.volume() - 1.0).abs() < 0.02, "{} {}", mesh.volume(), tube.volume());
            let length: f64 = (0..40_000)
                .map(|k| {
                    let [start, end] = tube.parameters();
                    let at = |k: f64| wire.place(start + (end - start) * k / 40_000.0).position;
                    norm(sub(at(f64::from(k) + 1.0), at(f64::from(k))))
                })
                .sum();
            assert!((length / tube.length() - 1.0).abs() < 1e-7);
        }
    }
}

#[test]
fn what_cannot_be_meshed_is_refused() {
    let tube = Tube::new(strand(3, 60.0, Handedness::Right, 0), 1.0, 0.0, 5.0).unwrap();
    assert_eq!(tube.facets(f64::NAN, Fit::Surface).unwrap_err().quantity, "chord_error");
    assert_eq!(tube.facets(1e-9, Fit::Surface).unwrap_err().quantity, "facets");
    assert_eq!(tube.mesh(Facets { around: 2, along: 5 }, Fit::Surface).unwrap_err().quantity, "facets");
    let wrung = tube.twisted(3.0).unwrap();
    assert_eq!(wrung.mesh(Facets { around: 24, along: 50 }, Fit::Surface).unwrap_err().quantity, "pretwist");
    assert!(wrung.with_ends(Ends::Square).mesh(Facets { around: 24, along: 50 }, Fit::Surface).is_ok());
    for (radius, from, to) in [(0.0, 0.0, 1.0), (1.0, 1.0, 1.0), (f64::NAN, 0.0, 1.0), (1.0, 0.0, f64::INFINITY)] {
        assert!(Tube::new(Centreline::axis(), radius, from, to).is_err());
    }
}
