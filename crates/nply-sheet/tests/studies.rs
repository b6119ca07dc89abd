//! Paths and maps: what a leg changes and keeps, what is told of a walk, what runs on a map.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "data are taken over as they are written")]

use nply::mechanics::{Ends, Load, Mark, Support, Twist};
use nply_sheet::map::{Cell, MapDatum, MapFlags, MapPicture, Tally, Verdict};
use nply_sheet::{Case, Question, Spec, SpecError, TraceReport, Walk};
use serde_json::Value;

const RODS: &str = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -0.2\n";
const STEEL: &str = "ply = { strands = 6, title = \"six\\nwires\" }\ntwist.strand_twist = 0\nsupport.core_diameter = \"3.15 mm\"\n\
    strand = { diameter = \"3 mm\", youngs_modulus = \"200 GPa\", poissons_ratio = 0.3, length = \"100 mm\" }\n";

fn spec(head: &str, rest: &str) -> Spec {
    Spec::from_toml("study.toml", &format!("{head}{rest}")).unwrap_or_else(|error| panic!("{error}"))
}

fn cases(head: &str, legs: &str) -> Vec<Case> {
    spec(head, legs).check_path(None).unwrap_or_else(|error| panic!("{error}"))
}

fn walked(head: &str, legs: &str, walk: Walk) -> TraceReport {
    TraceReport::of(cases(head, legs), walk).unwrap_or_else(|error| panic!("{error}"))
}

fn ends(case: &Case) -> Ends {
    match case.question {
        Question::States { load, .. } => Ends::Loads(load),
        Question::Held { ends, .. } | Question::Supported { ends, .. } => ends,
        ref other => panic!("{other:?}"),
    }
}

fn loads(force: f64, moment: f64) -> Ends {
    Ends::Loads(Load { force, moment })
}

#[test]
fn a_leg_changes_what_it_names_and_keeps_the_rest() {
    let legs = "load = { force = 0.25, moment = -0.5 }\n[[path]]\nload.force = 1\n[[path]]\ntwist.surface_angle = \"-45 deg\"\n\
        [[path]]\nload.moment = 2\n";
    let cases = cases(RODS, legs);
    let found: Vec<Ends> = cases.iter().map(ends).collect();
    assert_eq!(found, [loads(0.25, -0.5), loads(1.0, -0.5), loads(1.0, -0.5), loads(1.0, 2.0)]);
    let twist = |case: &Case| match case.question {
        Question::States { twist: Twist::Pretwist(twist), .. } => twist,
        ref other => panic!("{other:?}"),
    };
    assert_eq!(cases.iter().map(twist).map(|t| (t * 1e9).round() / 1e9).collect::<Vec<_>>(), [-0.2, -0.2, -1.0, -1.0]);
}

/// A displacement takes the place of its load, a load that of its displacement, and the other load stays.
#[test]
fn a_leg_holds_ends_and_lets_them_go() {
    let legs = "load = { force = 0.25, moment = -0.1 }\n[[path]]\nends.turns_per_strand_length = 0.03\n[[path]]\nload.force = 0.5\n\
        [[path]]\nload.moment = 0.1\n[[path]]\nends.length_ratio = 0.98\n[[path]]\nload.force = 0.3\n";
    let found: Vec<Ends> = cases(RODS, legs).iter().map(ends).collect();
    let rotation = 0.03 * core::f64::consts::TAU;
    let length = Ends::Length { extension: 0.98, moment: 0.1 };
    let held = |force| Ends::Rotation { rotation, force };
    assert_eq!(found, [loads(0.25, -0.1), held(0.25), held(0.5), loads(0.5, 0.1), length, loads(0.3, 0.1)]);
    // and walked: where a hold begins the ply is where it was
    let report = walked(RODS, legs, Walk::default());
    let stations: Vec<_> = report.stations().collect();
    for pair in stations.windows(2).filter(|pair| pair[0].0 != pair[1].0) {
        assert!((pair[0].1.angle.degrees() - pair[1].1.angle.degrees()).abs() < 1e-9, "{pair:?}");
        assert!((pair[0].1.load.moment - pair[1].1.load.moment).abs() < 1e-9, "{pair:?}");
    }
    let last = report.last().unwrap();
    assert!((last.load.force - 0.3).abs() < 1e-12 && (last.load.moment - 0.1).abs() < 1e-12);
}

/// From turns that are held to a length that is held: the moment that was found stays, on this leg and the next.
#[test]
fn a_load_that_was_found_stays_where_nobody_names_it() {
    let legs = "[[path]]\nends.turns_per_strand_length = 0.04\n[[path]]\nends.length_ratio = 0.95\n[[path]]\nends.length_ratio = 0.96\n\
        [[path]]\nends.turns_per_strand_length = 0.035\n";
    let report = walked(RODS, legs, Walk::default());
    let at_end = |leg: usize| report.stations().filter(|(of, _)| *of == leg).last().unwrap().1;
    let found = at_end(1).load.moment;
    assert!(found.abs() > 0.01, "{found}");
    for leg in [2, 3] {
        assert!((at_end(leg).load.moment - found).abs() < 1e-12, "{leg}: {:?}", at_end(leg).load);
    }
    assert!((at_end(4).load.force - at_end(3).load.force).abs() < 1e-12 && at_end(3).load.force.abs() > 0.01);
}

/// Flags are one leg, and take the place of the file's.
#[test]
fn a_leg_by_flags_replaces_those_of_the_file() {
    let spec = spec(RODS, "[[path]]\nload.force = 1\n[[path]]\nload.force = 2\n");
    let leg = Spec::from_prefixed_flags("to-", [("moment", "0.5")]).unwrap();
    let found: Vec<Ends> = spec.check_path(Some(&leg)).unwrap().iter().map(ends).collect();
    assert_eq!(found, [loads(0.0, 0.0), loads(0.0, 0.5)]);
    assert_eq!(spec.check_path(None).unwrap().len(), 3);
}

#[test]
fn what_is_told_of_a_walk_names_states_as_they_are_listed() {
    let report =
        walked(STEEL, "ends.turns = 0.7\nload.force = \"-3 kN\"\n[[path]]\nload.force = \"-20 kN\"\n", Walk::default());
    let notes = report.notes().join("\n");
    assert!(notes.contains("There are 3 states to start from (1 right 7.773° on the core, 2 right"), "{notes}");
    assert!(notes.contains("state 1 is followed."), "{notes}");
    assert!(
        notes.contains("end at right 7.773° on the core: there the ply opens, and it jumps. Stable there: right"),
        "{notes}"
    );
    assert!(notes.contains("The path is not walked to its end: "), "{notes}");
    let text = report.text(false);
    assert!(text.starts_with("six wires: 6 strands, contacts push only\n"), "{text}");
    // units of the input, turns because they are held, and what is nothing is 0
    for word in [" kN ", " kN mm ", " kN/mm", " turns/m ", " turns "] {
        assert!(text.contains(word), "{word}: {text}");
    }
    assert!(!text.contains("e-1") && !text.contains("-0 "), "{text}");
    // another start has another walk
    let other = walked(
        STEEL,
        "ends.turns = 0.7\nload.force = \"-3 kN\"\n[[path]]\nload.force = \"-2 kN\"\n",
        Walk { start: Some(3), ..Walk::default() },
    );
    assert!(other.last().unwrap().support == Support::Neighbours && other.notes()[0].ends_with("state 3 is followed."));
}

/// Flat rings are a limit: R/r grows beyond all bounds there, and a free helix carries nothing in the end.
#[test]
fn flat_rings_have_no_digits_of_their_own() {
    let report = walked(
        "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -1\n",
        "[[path]]\nload.force = -3\n",
        Walk::default(),
    );
    let text = report.text(false);
    let rings: Vec<&str> = text.lines().find(|line| line.contains("flat rings")).unwrap().split_whitespace().collect();
    // angle, R/r, force, moment, p₁
    assert_eq!(rings[rings.len() - 5..], ["90", "∞", "0", "0", "0"], "{text}");
    let opens = text.lines().find(|line| line.contains("opens")).unwrap();
    assert!(opens.contains("52.7826") && opens.contains("1.59494"), "{opens}");
}

#[test]
fn straight_strands_are_called_straight() {
    let legs = "load = { force = 0.5, moment = -0.45 }\n[[path]]\nload.moment = -0.1\n";
    let report = walked(RODS, legs, Walk::default());
    let json: Value = serde_json::from_str(&report.json()).unwrap();
    assert!(json["starts"][0]["helical_angle_deg"].as_f64().unwrap() < 1e-6, "{}", json["starts"]);
    let through = walked(RODS, "load.force = 0.5\n[[path]]\nload.moment = -1\n", Walk::default());
    let marks: Vec<Mark> = through.events().map(|(_, event)| event.mark).collect();
    assert_eq!(marks, [Mark::Straight, Mark::Arrival]);
    let text = through.text(false);
    let row = text.lines().find(|line| line.contains("1 straight")).unwrap();
    assert!(row.split_whitespace().any(|cell| cell == "0") && !row.contains("e-"), "{row}");
}

#[test]
fn a_curvature_limit_is_told_where_it_is_passed() {
    let walk = Walk { curvature_limit: Some(0.03), ..Walk::default() };
    let report = walked(RODS, "[[path]]\nload.force = 1\n", walk);
    let events: Vec<_> = report.events().collect();
    assert_eq!(events.iter().map(|(_, event)| event.mark).collect::<Vec<_>>(), [Mark::CurvatureLimit, Mark::Arrival]);
    assert!((events[0].1.station.curvature() - 0.03).abs() < 1e-12);
    assert!(report.picture().svg().contains("curvature limit"));
}

/// Which of the two corners begins, and which datum runs across, is as the input says.
#[test]
fn the_first_datum_runs_across_and_the_second_up() {
    let head = format!("{RODS}load.force = 5\n");
    let map =
        spec(&head, "[map]\nfrom.load.force = -1\nto.twist.pretwist = 3\nto.load.force = 2\ncolumns = 4\nrows = 7\n")
            .check_map(None)
            .unwrap();
    assert_eq!((map.x.datum, map.x.from, map.x.to, map.x.count), (MapDatum::Pretwist, -0.2, 3.0, 4));
    assert_eq!((map.y.datum, map.y.from, map.y.to, map.y.count), (MapDatum::Force, -1.0, 2.0, 7));
    assert_eq!(map.held(), [(MapDatum::Moment, 0.0), (MapDatum::StiffnessRatio, 0.75)]);
    assert_eq!((map.x.value(0), map.x.value(3), map.y.value(6)), (-0.2, 3.0, 2.0));
    // flags replace what the file says of the corners, and its numbers of points
    let flags = MapFlags {
        from: None,
        to: Some(Spec::from_prefixed_flags("to-", [("moment", "1"), ("force", "4")]).unwrap()),
        columns: Some(2),
        rows: None,
    };
    let file = spec(&head, "[map]\nfrom.load.force = -1\nto.load = { force = 2, moment = 7 }\ncolumns = 4\nrows = 7\n");
    let map = file.check_map(Some(&flags)).unwrap();
    assert_eq!((map.x.datum, map.x.to, map.x.count), (MapDatum::Moment, 1.0, 2));
    assert_eq!((map.y.datum, map.y.from, map.y.to, map.y.count), (MapDatum::Force, -1.0, 4.0, 7));
}

#[test]
fn a_map_counts_what_it_holds() {
    let map = spec(
        STEEL,
        "ends.turns = 0.7\n[map]\nto.ends.turns = 1.2\nto.load.force = \"-20 kN\"\ncolumns = 5\nrows = 4\n",
    )
    .check_map(None)
    .unwrap();
    let rows: Vec<Vec<Cell>> = (0..4).map(|row| map.row(row).unwrap()).collect();
    let (mut tally, mut picture) = (Tally::default(), MapPicture::new(&map));
    for (i, row) in rows.iter().enumerate() {
        tally.add(&map, row);
        picture.put(&map, i, row);
    }
    assert_eq!(tally.points(), 20);
    assert_eq!(tally.states() as usize, rows.iter().flatten().map(|cell| cell.states.len()).sum::<usize>());
    let text = tally.text(&map);
    for part in [
        "six wires: 6 strands, 5 × 4 points",
        "across  turns per strand length 7 to 12 turns/m",
        "up      end force 0 to -20 kN",
        "held    strand twist 0 turns/",
        "core radius 1.575 mm",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let share = |line: &str| line.split('%').next().unwrap().split_whitespace().last().unwrap().parse::<f64>().unwrap();
    let shares: f64 = text.lines().filter(|line| line.ends_with("of the points")).map(share).sum();
    assert!((shares - 100.0).abs() < 0.05, "{text}");
    let svg = picture.svg(&map);
    assert!(svg.contains("turns per strand length"));
    // four panels two and two: readable on a page
    let size = |name: &str| -> f64 {
        let from = svg.split_once(&format!(" {name}=\"")).unwrap().1;
        from.split_once('"').unwrap().0.parse().unwrap()
    };
    assert!(size("width") < 2.0 * size("height"), "{} {}", size("width"), size("height"));
    // a thrust too great for any wire on the king wire leaves the birdcage whose wires touch
    let verdicts: Vec<Verdict> = rows.iter().flatten().map(|cell| cell.verdict(map.case().balance)).collect();
    assert!(verdicts.contains(&Verdict::Several) && verdicts.contains(&Verdict::One), "{verdicts:?}");
}

fn refused<T>(result: Result<T, SpecError>) -> String {
    match result {
        Ok(_) => panic!("it is taken"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn what_goes_with_no_study_is_refused_at_its_place() {
    let pressed = format!("{RODS}load.external_pressure = 0.1\n");
    let path = spec(&pressed, "[[path]]\nload.force = 1\n").check_path(None).unwrap();
    let said = refused(TraceReport::of(path, Walk::default()));
    assert!(
        said.starts_with("study.toml:4:") && said.contains("`external_pressure = 0.1` cannot be taken into account"),
        "{said}"
    );
    let map = "[map]\nto.load = { force = 1, moment = 1 }\n";
    let said = refused(spec(&pressed, map).check_map(None));
    assert!(said.contains("`external_pressure = 0.1` cannot be taken into account"), "{said}");
    let laid = format!("{RODS}lay.helical_angle = \"20 deg\"\nload.moment = 0\n");
    let said = refused(spec(&laid, "[map]\nto = { twist.pretwist = 1, load.moment = 1 }\n").check_map(None));
    assert!(said.contains("`helical_angle = \"20 deg\"` goes with no path or map"), "{said}");
    let said = refused(spec(&format!("{RODS}load = {{ force = 1, separation = true }}\n"), map).check_map(None));
    assert!(said.contains("separation = true"), "{said}");
    let said = refused(TraceReport::of(Vec::new(), Walk::default()));
    assert!(said.contains("a path needs a beginning"), "{said}");
}
