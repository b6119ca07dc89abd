//! Curves in files: writhe, link and clearance of shapes whose values are known by other routes.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::disallowed_methods, reason = "an independent route")]

mod command;

use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::fs;

use command::{call, call_with, json, number, out};
use nply::Handedness::{Left, Right};
use nply::geometry::{Centreline, Contact};

type Points = Vec<[f64; 3]>;

/// A file for one test, with its path.
fn file(name: &str, text: &str) -> String {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("curves");
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn rows(curves: &[Points]) -> String {
    let mut text = String::new();
    for points in curves {
        for [x, y, z] in points {
            writeln!(text, "{x:?} {y:?} {z:?}").unwrap();
        }
        text.push('\n');
    }
    text
}

fn closed(mut points: Points) -> Points {
    points.push(points[0]);
    points
}

fn sampled(count: u32, at: impl Fn(f64) -> [f64; 3]) -> Points {
    (0..count).map(|k| at(f64::from(k) / f64::from(count))).collect()
}

fn trefoil(hand: f64) -> Points {
    sampled(240, |u| {
        let t = TAU * u;
        [t.sin() + 2.0 * (2.0 * t).sin(), t.cos() - 2.0 * (2.0 * t).cos(), -hand * (3.0 * t).sin()]
    })
}

/// `turns` of a strand of a ply, from end to end.
fn strand(contact: &Contact, hand: nply::Handedness, strand: u32, turns: u32) -> Points {
    let line = Centreline::new(contact, hand, strand);
    let turn = contact.lay_length() / contact.angle().cos();
    (0..=60 * turns).map(|k| line.position(turn * f64::from(k) / 60.0)).collect()
}

/// The Gauss integral of a closed polygon with itself by its points: half that of Wr's definition is counted twice, (A.4).
fn gauss(points: &[[f64; 3]]) -> f64 {
    let n = points.len();
    let sub = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let middle = |i: usize| [0, 1, 2].map(|k| 0.5 * (points[i][k] + points[(i + 1) % n][k]));
    let edge = |i: usize| sub(points[(i + 1) % n], points[i]);
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..i {
            let (r, u, v) = (sub(middle(i), middle(j)), edge(i), edge(j));
            let volume = r[0] * (u[1] * v[2] - u[2] * v[1])
                + r[1] * (u[2] * v[0] - u[0] * v[2])
                + r[2] * (u[0] * v[1] - u[1] * v[0]);
            sum += volume / (r[0] * r[0] + r[1] * r[1] + r[2] * r[2]).powf(1.5);
        }
    }
    sum / TAU
}

fn writhe(path: &str, more: &[&str]) -> f64 {
    let report = json(&[&["writhe", path, "--json", "--quiet"], more].concat());
    assert!(number(&report, "error_bound") < 1e-9);
    assert_eq!(report["writhe"], report["curves"][0]["writhe"]);
    number(&report, "writhe")
}

#[test]
fn a_knot_has_its_writhe_and_its_mirror_image_the_opposite() {
    let knot = |hand| file(&format!("trefoil {hand}.txt"), &rows(&[closed(trefoil(hand))]));
    let (one, other) = (writhe(&knot(1.0), &[]), writhe(&knot(-1.0), &[]));
    assert!((one + other).abs() < 1e-12, "{one} {other}");
    let expected = gauss(&trefoil(1.0));
    assert!((one - expected).abs() < 2e-3 * expected.abs(), "{one} {expected}");
    // seen from anywhere, a knot crosses itself at least as often as its writhe says; the mirror image as often
    let average =
        |hand| number(&json(&["writhe", &knot(hand), "--average-crossings", "--json"]), "average_crossing_number");
    assert!((average(1.0) - average(-1.0)).abs() < 1e-11 && average(1.0) >= one.abs() && average(1.0) < 5.0);
    // by segments: shares that make the whole, the same for each third of a knot that has a threefold axis
    let tree = json(&["writhe", &knot(1.0), "--method", "tree", "--tolerance", "1e-9", "--json"]);
    let shares: Vec<f64> =
        tree["curves"][0]["shares"].as_array().unwrap().iter().map(|share| share.as_f64().unwrap()).collect();
    assert!((number(&tree, "writhe") - one).abs() < 1e-9 && shares.len() == 240 && tree["method"] == "tree");
    for third in shares.chunks(80) {
        assert!((third.iter().sum::<f64>() - one / 3.0).abs() < 1e-9);
    }
    // a trefoil that is nearly flat is seen with three crossings of one sign
    let flat: Points = trefoil(1.0).into_iter().map(|[x, y, z]| [x, y, 1e-3 * z]).collect();
    let flat = writhe(&file("flat.txt", &rows(&[closed(flat)])), &[]);
    assert!((flat - 3.0 * one.signum()).abs() < 1e-2, "{flat}");
}

#[test]
fn a_plane_curve_has_no_writhe() {
    let circle = closed(sampled(100, |u| [3.0 * (TAU * u).cos(), 3.0 * (TAU * u).sin(), 7.0]));
    assert!(writhe(&file("circle.csv", &rows(&[circle])), &[]).abs() < 1e-13);
    let wave: Points = (0..200).map(|k| 0.1 * f64::from(k)).map(|t| [t, t.sin(), 0.5 * t]).collect();
    let path = file("wave.csv", &rows(&[wave]));
    assert!(writhe(&path, &[]).abs() < 1e-12);
    assert!(writhe(&path, &["--extend", "40"]).abs() < 1e-12);
}

#[test]
fn rings_are_linked_once_and_the_sign_turns_with_a_direction() {
    let ring = |u: f64| [(TAU * u).cos(), (TAU * u).sin(), 0.0];
    let flat = sampled(48, ring);
    // through its middle, upwards: right-handed with a ring that runs anticlockwise
    let upright = sampled(48, |u| [1.0 - (TAU * u).cos(), 0.0, (TAU * u).sin()]);
    let reversed: Points = upright.iter().rev().copied().collect();
    let far: Points = upright.iter().map(|p| [p[0] + 9.0, p[1], p[2]]).collect();
    let all = [flat, upright, reversed, far].map(closed);
    let pair = |name: &str, i: usize, j: usize| {
        let report = json(&["link", &file(name, &rows(&[all[i].clone(), all[j].clone()])), "--json"]);
        let matrix = &report["linking_numbers"];
        assert_eq!(matrix[0][1], matrix[1][0]);
        assert_eq!((&matrix[0][0], &report["error_bounds"][0][1]), (&serde_json::json!(0), &serde_json::json!(0.0)));
        matrix[0][1].as_i64().expect("an integer")
    };
    // z of the upright ring rises where it starts, outside at x = 0: there it passes through the flat ring's middle
    assert_eq!((pair("hopf.txt", 0, 1), pair("hopf back.txt", 0, 2), pair("apart.txt", 0, 3)), (1, -1, 0));
    // and from files of their own, with names to tell them by
    let paths = [file("a.txt", &rows(&[all[0].clone()])), file("b.txt", &rows(&[all[1].clone()]))];
    let report = json(&["link", &paths[0], &paths[1], "--json"]);
    assert_eq!(report["linking_numbers"][1][0], 1);
    assert_eq!(report["curves"][1]["name"], paths[1].as_str());
    let csv = out(&["link", &paths[0], &paths[1], "--format", "csv"]);
    assert_eq!(csv.lines().nth(1).unwrap().split(',').skip(2).collect::<Vec<_>>(), ["1", "0"]);
    // open, the same points have no linking number but an integral
    let open = json(&["link", &file("hopf.txt", &rows(&[all[0].clone(), all[1].clone()])), "--open", "--json"]);
    let integral = open["linking_numbers"][0][1].as_f64().unwrap();
    assert!(open["linking_numbers"][0][1].is_f64() && (integral - 1.0).abs() < 1e-12, "{integral}");
}

/// Long plies, per turn: a strand with itself 1 − cos θ, two that run the same way 1 (Appendix, limits of (A.10) and (A.21)).
#[test]
fn strands_of_a_ply_have_the_writhe_and_link_of_the_appendix() {
    let contact = Contact::new(2, 0.5).unwrap();
    for (hand, sign) in [(Right, 1.0), (Left, -1.0)] {
        let path = |turns| {
            let curves = [0, 1].map(|i| strand(&contact, hand, i, turns));
            (
                file(&format!("one {sign} {turns}.txt"), &rows(&curves[..1])),
                file(&format!("two {sign} {turns}.txt"), &rows(&curves)),
            )
        };
        let ((one, two), (longer, both)) = (path(20), path(60));
        let self_writhe = (writhe(&longer, &[]) - writhe(&one, &[])) / 40.0;
        // the chords of 60 a turn cut off some of it
        assert!((self_writhe - sign * (1.0 - contact.angle().cos())).abs() < 2e-3, "{self_writhe}");
        let link = |path: &str| json(&["link", path, "--json"])["linking_numbers"][0][1].as_f64().unwrap();
        let pair = (link(&both) - link(&two)) / 40.0;
        assert!((pair - sign).abs() < 2e-3, "{pair}");
    }
}

/// A right-handed plectoneme, its strands in opposite directions and joined at both ends, has negative writhe: −2 cos θ a turn, (A.27).
#[test]
fn a_right_handed_plectoneme_has_negative_writhe() {
    let contact = Contact::new(2, 0.6).unwrap();
    let loop_of = |turns: u32| {
        let up = strand(&contact, Right, 0, turns);
        let mut down = strand(&contact, Right, 1, turns);
        down.reverse();
        closed([up, down].concat())
    };
    let [short, long] =
        [20, 60].map(|turns| writhe(&file(&format!("plectoneme {turns}.txt"), &rows(&[loop_of(turns)])), &[]));
    assert!(short < -20.0, "{short}");
    let turn = (long - short) / 40.0;
    assert!((turn + 2.0 * contact.angle().cos()).abs() < 4e-3, "{turn}");
}

#[test]
fn ends_are_prolonged_as_if_the_file_had_them() {
    let contact = Contact::new(3, 0.8).unwrap();
    let points = strand(&contact, Right, 0, 3);
    let path = file("helix.txt", &rows(std::slice::from_ref(&points)));
    let add = |a: [f64; 3], b: [f64; 3], k: f64| {
        let d = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
        [0, 1, 2].map(|i| b[i] + k * d[i] / length)
    };
    let (first, last) = (points[0], points[points.len() - 1]);
    let tangents =
        [vec![add(points[1], first, 5.0)], points.clone(), vec![add(points[points.len() - 2], last, 5.0)]].concat();
    let chord = [vec![add(last, first, 5.0)], points, vec![add(first, last, 5.0)]].concat();
    for (more, curve) in [(&["--extend", "5"][..], tangents), (&["--extend", "5", "--extend-along", "chord"], chord)] {
        let expected = writhe(&file("prolonged.txt", &rows(&[curve])), &[]);
        let found = writhe(&path, more);
        assert!((found - expected).abs() < 1e-12, "{more:?} {found} {expected}");
        assert!((found - writhe(&path, &[])).abs() > 1e-3);
    }
    // a length with a unit is taken in that of the file
    assert!(
        (writhe(&path, &["--extend", "5 mm", "--unit", "mm"]) - writhe(&path, &["--extend", "0.5 cm", "--unit", "mm"]))
            .abs()
            < 1e-13
    );
    let told = call(&["writhe", &path, "--extend", "5 mm"]);
    assert_eq!(told.code, 2);
    assert!(told.err.contains("--unit"), "{}", told.err);
}

/// An ideal alpha helix, 3.6 residues a turn, 1.5 Å a residue, Cα at 2.3 Å, as PDB and as rows.
#[test]
fn a_protein_and_its_coordinates_are_one_curve() {
    let point = |k: i32| {
        let t = TAU * f64::from(k) / 3.6;
        [2.3 * t.cos(), 2.3 * t.sin(), 1.5 * f64::from(k)].map(|x| (x * 1000.0).round() / 1000.0)
    };
    let (mut pdb, mut plain) = ("HEADER    IDEAL HELIX\n".to_owned(), String::new());
    for k in 0..36 {
        let [x, y, z] = point(k);
        writeln!(pdb, "ATOM  {:>5}  CA  ALA H{:>4}    {x:8.3}{y:8.3}{z:8.3}  1.00  0.00           C", k + 1, k + 1)
            .unwrap();
        writeln!(plain, "{x:.3},{y:.3},{z:.3}").unwrap();
    }
    let (pdb, plain) = (file("helix.pdb", &(pdb + "TER\nEND\n")), file("helix.csv", &plain));
    let report = json(&["writhe", &pdb, "--json"]);
    assert_eq!((report["curves"][0]["name"].as_str(), report["unit"].as_str()), (Some("H"), Some("Å")));
    assert_eq!(report["writhe"], json(&["writhe", &plain, "--json"])["writhe"]);
    assert!(number(&report, "writhe") > 0.0); // right-handed
}

/// Six wires on a king wire at 17.44°: R = 2r is too little for their obliquity.
#[test]
fn a_strand_laid_as_if_its_wires_stood_upright_overlaps() {
    let contact = Contact::new(6, 17.44_f64.to_radians()).unwrap();
    let strand = |radius: f64| {
        let pitch = TAU * radius / contact.angle().tan();
        let mut text = "wire,x [mm],y [mm],z [mm],diameter [mm]\n".to_owned();
        for k in 0..=1 {
            writeln!(text, "king,0,0,{:?},2", f64::from(k) * pitch).unwrap();
        }
        for i in 0..6 {
            for k in 0..=180 {
                let (turn, phase) = (f64::from(k) / 180.0, f64::from(i) * PI / 3.0);
                let (sin, cos) = (TAU * turn + phase).sin_cos();
                writeln!(text, "{i},{:?},{:?},{:?},2", radius * cos, radius * sin, pitch * turn).unwrap();
            }
        }
        text
    };
    let paths = [2.0, contact.radius_ratio()].map(|radius| file(&format!("strand {radius:.3}.csv"), &strand(radius)));
    let [tight, right] = [0, 1].map(|i| json(&["clearance", &paths[i], "--json"]));
    assert_eq!(tight["unit"], "mm");
    // six neighbours overlap by far more than chords explain; the king wire is touched, but for the chords
    assert_eq!(
        (tight["overlapping_pairs"].as_u64(), tight["overlapping_pairs_beyond_chords"].as_u64()),
        (Some(12), Some(6))
    );
    assert!(number(&tight, "clearance") < -0.07);
    let where_ = tight["where"]["curves"].as_array().unwrap();
    assert!(where_.iter().all(|name| name != "king"), "{where_:?}");
    // laid as touching wires lie, they clear each other within the height of two chords, and the king wire is loose
    assert_eq!(right["overlapping_pairs_beyond_chords"], 0);
    let height = number(&right["curves"][1], "chord_sagitta");
    assert!(number(&right, "least_distance") > 2.0 - 2.0 * height && height < 1e-3);
    assert!((number(&right, "least_distance") - 2.0 - number(&right, "clearance")).abs() < 1e-12);
    assert_eq!(right["itself"]["overlapping_curves"], 0);
    // a diameter on the command line goes before the file's; thinner wires do not touch
    let thin = json(&["clearance", &paths[0], "--diameter", "1.9 mm", "--json"]);
    assert_eq!(
        (thin["overlapping_pairs"].as_u64(), thin["least_distance"] == tight["least_distance"]),
        (Some(0), true)
    );
    // the answer is the same on one thread and on two
    let on = |jobs| out(&["clearance", &paths[0], "--jobs", jobs, "--json"]);
    assert_eq!(on("1"), on("2"));
    let text = out(&["clearance", &paths[0]]);
    assert!(text.contains("overlapping pairs") && text.contains("\"king\" and"), "{text}");
    let csv = out(&["clearance", &paths[0], "--format", "csv"]);
    assert_eq!(csv.lines().count(), 13, "{csv}");
}

/// A band round a circle, twisted three times: Lk = Tw + Wr; and the polar writhe of a closed curve, which is its writhe along any axis.
#[test]
fn twist_and_writhe_of_a_ribbon_make_its_link() {
    let band = |turns: f64| {
        let axis = sampled(90, |u| [4.0 * (TAU * u).cos(), 4.0 * (TAU * u).sin(), (2.0 * TAU * u).sin()]);
        let edge = (0..90).map(|k| (TAU * f64::from(k) / 90.0, axis[k as usize])).map(|(t, [x, y, z])| {
            let (up, out) = (turns * t).sin_cos();
            [x + 0.3 * out * t.cos(), y + 0.3 * out * t.sin(), z - 0.3 * up]
        });
        [closed(axis.clone()), closed(edge.collect())]
    };
    for turns in [3, -2, 0] {
        let path = file(&format!("band {turns}.txt"), &rows(&band(f64::from(turns))));
        let report = json(&["writhe", &path, "--ribbon", "--axis", "0.3,-1,0.2", "--json"]);
        assert_eq!(report["linking_number"], turns);
        assert!((number(&report, "twist") + number(&report, "writhe") - f64::from(turns)).abs() < 1e-12);
        assert!((number(&report, "twist_plus_writhe") - f64::from(turns)).abs() < 1e-12);
        assert!((number(&report, "polar_writhe") - number(&report, "writhe")).abs() < 1e-11);
        assert_eq!(report["curves"].as_array().unwrap().len(), 1);
        assert_eq!(json(&["link", &path, "--json"])["linking_numbers"][0][1], turns);
    }
    let uneven = file("uneven.txt", "0 0 0\n1 0 0\n2 0 0\n\n0 1 0\n1 1 0\n");
    let found = call(&["writhe", &uneven, "--ribbon"]);
    assert!(found.code == 1 && found.err.contains("make no ribbon"), "{}", found.err);
}

/// A circle of B-DNA: two right-handed strands of 10 Å about a ring of 336 base pairs with 32 turns. Its link is 32 where both strands run the same way,
/// and −32 as a PDB file has them, each from 5′ to 3′.
#[test]
fn strands_of_a_duplex_run_against_each_other() {
    let (pairs, turns, ring) = (336, 32.0, 336.0 * 3.4 / TAU);
    let strand = |offset: f64| {
        sampled(pairs, |u| {
            let (s, t) = (TAU * u, TAU * turns * u + offset);
            let out = ring + 10.0 * t.sin();
            [out * s.cos(), out * s.sin(), 10.0 * t.cos()]
        })
    };
    let mut lines = String::new();
    let mut other = strand(2.5);
    other.reverse();
    for (chain, points) in [('A', strand(0.0)), ('B', other)] {
        for (k, [x, y, z]) in points.iter().enumerate() {
            lines += &format!("ATOM  {:5}  P    DA {chain}{:4}    {x:8.3}{y:8.3}{z:8.3}  1.00\n", k + 1, k + 1);
        }
        lines += "TER\n";
    }
    let path = file("minicircle.pdb", &lines);
    let link =
        |more: &[&str]| json(&[&["link", &path, "--closed", "--json"], more].concat())["linking_numbers"][0][1].clone();
    assert_eq!((link(&[]), link(&["--reverse", "B"])), ((-32).into(), 32.into()));
    assert_eq!(link(&["--reverse", "A", "--reverse", "B"]), -32);
    // as a ribbon the strands that run against each other are none, which is said; else its sum holds
    let said = |more: &[&str]| {
        let report = json(&[&["writhe", &path, "--ribbon", "--closed", "--json"], more].concat());
        let notes = report["notes"].to_string();
        (number(&report, "twist_plus_writhe"), report["linking_number"].as_i64().unwrap(), notes)
    };
    let (sum, link, notes) = said(&[]);
    assert!((sum - link as f64).abs() > 0.5, "{sum} {link}");
    assert!(notes.contains("bound no ribbon") && !notes.contains("is the sum of its"), "{notes}");
    assert!(notes.contains("--reverse \\\"B\\\""), "{notes}");
    let (sum, link, notes) = said(&["--reverse", "B"]);
    assert!((sum - 32.0).abs() < 1e-9 && link == 32, "{sum} {link}");
    assert!(notes.contains("is the sum of its") && !notes.contains("bound no ribbon"), "{notes}");
    assert!(notes.contains("from its last point to its first"), "{notes}");
    let wrong = call(&["link", &path, "--reverse", "C"]);
    assert!(wrong.code == 2 && wrong.err.contains("none of the curves, which are \"A\", \"B\""), "{}", wrong.err);
}

#[test]
fn closed_or_open_is_said() {
    let triangle = "0 0 0\n1 0 0\n0 1 0\n";
    let says = |text: &str, more: &[&str]| {
        let report = json(&[&["writhe", &file("triangle.txt", text), "--json"], more].concat());
        let curve = &report["curves"][0];
        (
            curve["closed"].as_bool().unwrap(),
            curve["points"].as_u64().unwrap(),
            report["notes"][0].as_str().unwrap().to_owned(),
        )
    };
    let ring = format!("{triangle}0 0 0\n");
    assert!(!says(triangle, &[]).0);
    assert!(says(triangle, &[]).2.contains("taken as open"));
    assert_eq!((says(triangle, &["--closed"]).0, says(triangle, &["--closed"]).1), (true, 3));
    assert_eq!((says(&ring, &[]).0, says(&ring, &[]).1), (true, 3));
    assert!(says(&ring, &[]).2.contains("the last point repeats the first"));
    assert_eq!((says(&ring, &["--closed"]).1, says(&ring, &["--open"]).1), (3, 4));
    let found = call_with(&["writhe", "-", "--format", "csv"], ring.as_bytes());
    assert!(found.out.starts_with("curve,file,points,closed,length,writhe,error_bound,polar_writhe,"), "{}", found.out);
}

#[test]
fn what_has_no_answer_is_refused_in_one_sentence() {
    let cross = "0 0 0\n2 2 0\n\n0 2 0\n2 0 0\n";
    for (verb, text, more, code, said) in [
        ("writhe", "0 0 0\n0 0 0\n1 1 1\n", &[][..], 1, "repeats the one before it"),
        ("writhe", "0 0 0\n2 2 0\n0 2 0\n2 0 0\n", &[], 1, "touch or cross"),
        ("writhe", "0 0 0\n1 0 0\n0 1 0\n0 0 0\n", &["--extend", "1"], 1, "has no ends to prolong"),
        ("writhe", "0 0 0\n1 0 0\n", &["--extend", "-1"], 1, "no length greater than 0"),
        ("writhe", "0 0 0\n1 0 NaN\n", &[], 2, ":2:5: \"NaN\" is not finite"),
        ("writhe", "0 0 0\n1 0 0\n", &["--tolerance", "1e-3"], 2, "it goes with --method tree"),
        ("writhe", "0 0 0\n1 0 0\n", &["--method", "tree", "--tolerance", "-1"], 1, "above 0 and finite"),
        ("link", "0 0 0\n1 0 0\n", &[], 1, "two or more are wanted"),
        ("link", cross, &[], 1, "touch or cross"),
        ("clearance", cross, &["-d", "0"], 1, "no length greater than 0"),
        ("clearance", cross, &["-d", "1", "-d", "2", "-d", "3"], 2, "3 diameters for 2 curves"),
        ("clearance", "x_mm y_mm z_mm\n0 0 0\n1 0 0\n", &["--unit", "m"], 2, "has coordinates in mm"),
        ("clearance", cross, &["-d", "1 N"], 2, "is a force; a length is wanted"),
    ] {
        let path = file("refused.txt", text);
        let found = call(&[&[verb, &path], more].concat());
        assert_eq!((found.code, found.out.as_str()), (code, ""), "{verb} {text} {}", found.err);
        assert!(found.err.contains(said) && found.err.trim_end().lines().count() == 1, "{}", found.err);
    }
    assert_eq!(call(&["link", "no such file.csv"]).code, 3);
    assert_eq!(call(&["clearance"]).code, 2);
    // wires that cross have no distance: an answer
    let found = json(&["clearance", &file("cross.txt", cross), "-d", "1", "--json"]);
    assert_eq!((number(&found, "least_distance"), number(&found, "clearance")), (0.0, -1.0));
}
