//! Each rule by which a description becomes a case, once.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]
#![allow(clippy::float_cmp, reason = "the values are exact, or said to be so")]

use core::f64::consts::{FRAC_PI_6, PI, TAU};

use nply::mechanics::{Balance, Load, Twist};
use nply::{DomainError, Handedness};
use nply_sheet::{Case, Dimension, ErrorKind, KEYS, Kind, Lay, Place, Question, Spec, SpecError};
use proptest::prelude::*;

type Flags<'f> = &'f [(&'f str, &'f str)];

/// A dimensionless ply of three strands, with more flags.
fn bare(more: Flags) -> Result<Case, SpecError> {
    let base = [("strands", "3"), ("stiffness-ratio", "0.75")];
    Spec::from_flags(base.iter().chain(more).copied())?.check()
}

/// A ply with r = 2 mm and B = 1 N mm², with more flags.
fn measured(more: Flags) -> Result<Case, SpecError> {
    let base = [
        ("strands", "3"),
        ("radius", "2 mm"),
        ("bending-stiffness", "1 N mm^2"),
        ("torsional-stiffness", "0.5 N mm^2"),
    ];
    Spec::from_flags(base.iter().chain(more).copied())?.check()
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-14 * b.abs(), "{a} is not {b}");
}

fn pretwist(case: &Case) -> f64 {
    let Question::States { twist: Twist::Pretwist(value), .. } = case.question else { panic!("{:?}", case.question) };
    value
}

fn refused(case: Result<Case, SpecError>, kind: ErrorKind, part: &str) {
    let error = case.expect_err(part);
    assert_eq!(error.kind(), kind, "{error}");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn what_is_not_said_has_its_default() {
    let case = bare(&[("pretwist", "-1")]).unwrap();
    assert_eq!((case.strands, case.stiffness_ratio, case.balance), (3, 0.75, Balance::Contact));
    assert_eq!(case.question, Question::States { twist: Twist::Pretwist(-1.0), load: Load::NONE });
    assert_eq!(
        (case.title, case.external_pressure, case.scale, case.strand_radius, case.strand_length),
        (None, None, None, None, None)
    );
}

#[test]
fn the_strand_by_each_of_its_data() {
    let strand = |flags: Flags| {
        let base = [("strands", "2"), ("pretwist", "-1"), ("radius", "1 mm")];
        let case = Spec::from_flags(base.iter().chain(flags).copied()).unwrap().check().unwrap();
        (case.scale.map(|scale| scale.bending_stiffness()), case.stiffness_ratio)
    };
    let round = PI * 1e9 * 1e-12 / 4.0;
    let close = |found: (Option<f64>, f64), b: f64, ratio: f64| {
        near(found.0.unwrap(), b);
        near(found.1, ratio);
    };
    close(strand(&[("bending-stiffness", "2 N mm^2"), ("torsional-stiffness", "1 N mm^2")]), 2e-6, 0.5);
    close(strand(&[("bending-stiffness", "2 N mm^2"), ("stiffness-ratio", "0.5")]), 2e-6, 0.5);
    close(strand(&[("youngs-modulus", "1 GPa"), ("poissons-ratio", "0.25")]), round, 0.8);
    close(strand(&[("youngs-modulus", "1 GPa"), ("shear-modulus", "0.4 GPa")]), round, 0.8);
    close(
        strand(&[("bending-stiffness", "2 N mm^2"), ("shear-modulus", "0.4 GPa")]),
        2e-6,
        PI * 4e8 * 1e-12 / 2.0 / 2e-6,
    );
    let thermal =
        [("bending-persistence-length", "50 nm"), ("twist-persistence-length", "75 nm"), ("temperature", "298 K")];
    close(strand(&thermal), 1.380_649e-23 * 298.0 * 50e-9, 1.5);
    let thermal = [("bending-persistence-length", "50 nm"), ("stiffness-ratio", "1.5"), ("temperature", "25 degC")];
    close(strand(&thermal), 1.380_649e-23 * 298.15 * 50e-9, 1.5);
    assert_eq!(strand(&[("stiffness-ratio", "0.9")]), (None, 0.9));
    assert_eq!(strand(&[("poissons-ratio", "-0.5")]), (None, 2.0));
    let diameter =
        Spec::from_flags([("strands", "2"), ("pretwist", "1"), ("diameter", "2 mm"), ("stiffness-ratio", "1")]);
    assert_eq!(diameter.unwrap().check().unwrap().strand_radius, Some(1e-3));
}

#[test]
fn the_twist_by_each_of_its_data() {
    near(pretwist(&bare(&[("surface-angle", "45 deg")]).unwrap()), 1.0);
    near(pretwist(&bare(&[("turns-per-length", "0.01")]).unwrap()), 0.01 * TAU);
    near(pretwist(&bare(&[("turns", "-3"), ("strand-length", "100")]).unwrap()), -0.03 * TAU);
    near(pretwist(&bare(&[("turns", "-3 turns"), ("strand-length", "100")]).unwrap()), -0.03 * TAU);
    near(pretwist(&bare(&[("end-rotation", "-1080 deg"), ("strand-length", "100")]).unwrap()), -0.03 * TAU);
    near(pretwist(&measured(&[("turns-per-length", "5 turns/m")]).unwrap()), 0.01 * TAU);
    near(pretwist(&measured(&[("turns", "3"), ("strand-length", "0.2 m")]).unwrap()), 0.03 * TAU);
    let strand_twist = |case: Case| match case.question {
        Question::States { twist: Twist::StrandTwist(value), .. } => value,
        other => panic!("{other:?}"),
    };
    assert_eq!(strand_twist(bare(&[("strand-twist", "0.3")]).unwrap()), 0.3);
    assert_eq!(strand_twist(measured(&[("strand-twist", "0.3")]).unwrap()), 0.3);
    near(strand_twist(measured(&[("strand-twist", "150 rad/m")]).unwrap()), 0.3);
    assert_eq!(measured(&[("pretwist", "1"), ("strand-length", "0.5 m")]).unwrap().strand_length, Some(250.0));
}

#[test]
fn the_lay_by_each_of_its_data() {
    let lay = |case: Result<Case, SpecError>| match case.unwrap().question {
        Question::PretwistAt { lay, hand, load: Load::NONE } => (lay, hand),
        other => panic!("{other:?}"),
    };
    let left = Some(Handedness::Left);
    assert_eq!(lay(bare(&[("helical-angle", "30 deg")])), (Lay::HelicalAngle(FRAC_PI_6), None));
    assert_eq!(lay(bare(&[("lay-angle", "0 deg"), ("hand", "s")])), (Lay::HelicalAngle(0.0), left));
    let (Lay::PitchAngle(pitch), hand) = lay(bare(&[("pitch-angle", "30°"), ("hand", "Left")])) else { panic!() };
    assert!((pitch - FRAC_PI_6).abs() < 1e-15 && hand == left);
    assert_eq!(lay(bare(&[("lay-length", "30"), ("hand", "Z")])), (Lay::LayLength(30.0), Some(Handedness::Right)));
    assert_eq!(lay(measured(&[("lay-length", "60 mm")])), (Lay::LayLength(30.0), None));
    assert_eq!(lay(bare(&[("lay-ratio", "6.5")])), (Lay::LayRatio(6.5), None));
    assert_eq!(lay(bare(&[("ply-turns-per-length", "-0.05")])), (Lay::LayLength(20.0), left));
    let (Lay::LayLength(length), hand) = lay(measured(&[("ply-turns-per-length", "20 turns/m")])) else { panic!() };
    near(length, 25.0);
    assert_eq!(hand, Some(Handedness::Right));
    assert_eq!(lay(bare(&[("radius-ratio", "2.1")])), (Lay::RadiusRatio(2.1), None));
    assert_eq!(lay(bare(&[("core-radius", "1.1")])), (Lay::RadiusRatio(2.1), None));
    assert_eq!(lay(measured(&[("core-diameter", "4.4 mm")])), (Lay::RadiusRatio(2.1), None));
}

#[test]
fn what_is_left_open_is_the_question() {
    let lay = Lay::LayLength(30.0);
    let with_lay = |more: Flags| {
        let flags: Vec<_> = [("lay-length", "30")].iter().chain(more).copied().collect();
        bare(&flags).map(|case| case.question)
    };
    let twist = Twist::Pretwist(-1.0);
    assert_eq!(
        with_lay(&[("pretwist", "-1"), ("force", "0.2")]),
        Ok(Question::MomentAt { lay, hand: None, twist, force: 0.2 })
    );
    assert_eq!(
        with_lay(&[("pretwist", "-1"), ("moment", "0.2")]),
        Ok(Question::ForceAt { lay, hand: None, twist, moment: 0.2 })
    );
    assert_eq!(
        with_lay(&[("force", "0.1"), ("moment", "0.2")]),
        Ok(Question::PretwistAt { lay, hand: None, load: Load { force: 0.1, moment: 0.2 } })
    );
    assert_eq!(with_lay(&[]), Ok(Question::PretwistAt { lay, hand: None, load: Load::NONE }));
    for only in [[("force", "0.1")], [("moment", "0.1")], [("pretwist", "0.1")]] {
        refused(bare(&[("lay-length", "30"), only[0]]), ErrorKind::Missing, only[0].0);
    }
    let all = [("lay-length", "30"), ("force", "0"), ("moment", "0"), ("turns-per-length", "0.1")];
    refused(bare(&all), ErrorKind::Contradiction, "too many data");
    assert_eq!(
        bare(&[("pretwist", "-1"), ("moment", "0.3")]).unwrap().question,
        Question::States { twist, load: Load { force: 0.0, moment: 0.3 } }
    );
    let parts = |more: Flags| {
        let flags: Vec<_> = [("separation", ""), ("pretwist", "-1")].iter().chain(more).copied().collect();
        bare(&flags)
    };
    assert_eq!(parts(&[("force", "1")]).unwrap().question, Question::SeparationAtForce { twist, force: 1.0 });
    assert_eq!(parts(&[("moment", "1")]).unwrap().question, Question::SeparationAtMoment { twist, moment: 1.0 });
    refused(parts(&[]), ErrorKind::Missing, "needs one load");
    refused(parts(&[("force", "1"), ("moment", "1")]), ErrorKind::Contradiction, "both are given");
    refused(parts(&[("force", "1"), ("lay-length", "20")]), ErrorKind::Contradiction, "asks for the shape");
    refused(parts(&[("force", "1"), ("external-pressure", "1")]), ErrorKind::Contradiction, "together");
    refused(bare(&[("separation", "true"), ("force", "1")]), ErrorKind::Missing, "twist is missing");
    assert!(matches!(bare(&[("separation", "false"), ("pretwist", "1")]).unwrap().question, Question::States { .. }));
}

#[test]
fn loads_are_measured_by_the_strand() {
    let case = measured(&[("pretwist", "1"), ("force", "3 N"), ("moment", "2 N mm"), ("external-pressure", "-4 N/mm")])
        .unwrap();
    let Question::States { load, .. } = case.question else { panic!() };
    near(load.force, 3.0 * 4.0); // r²/B = 4/N
    near(load.moment, 2.0 * 2.0); // r/B = 2/(N mm)
    near(case.external_pressure.unwrap(), -4.0 * 8.0); // r³/B = 8 mm/N
    let scale = case.scale.unwrap();
    near(scale.force(load.force), 3.0);
    assert_eq!(case.units.format(Dimension::FORCE, 12.0), "12 N");
    assert_eq!(case.units.format(Dimension::FORCE_PER_LENGTH, 500.0), "0.5 N/mm");
}

#[test]
fn a_bare_number_stands_only_where_the_strand_has_no_unit() {
    for (flag, value) in [("force", "1"), ("moment", "1"), ("external-pressure", "1"), ("strand-length", "9")] {
        refused(measured(&[("pretwist", "1"), (flag, value)]), ErrorKind::WrongUnit, "has no unit, but the strand has");
        bare(&[("pretwist", "1"), (flag, value)]).unwrap();
    }
    for (flag, value) in
        [("force", "1 N"), ("moment", "1 N m"), ("external-pressure", "1 N/m"), ("strand-length", "9 m")]
    {
        refused(bare(&[("pretwist", "1"), (flag, value)]), ErrorKind::Missing, "has a unit, but the strand has none");
    }
    refused(measured(&[("lay-length", "30")]), ErrorKind::WrongUnit, "has no unit");
    refused(measured(&[("core-radius", "3")]), ErrorKind::WrongUnit, "has no unit");
    refused(measured(&[("turns-per-length", "3")]), ErrorKind::WrongUnit, "has no unit");
    refused(bare(&[("turns-per-length", "3 tpi")]), ErrorKind::Missing, "turns per strand radius");
    // a radius alone measures lengths, but no forces
    let wire: Flags = &[("radius", "2 mm"), ("lay-length", "60 mm"), ("force", "0.1"), ("moment", "0")];
    let case = bare(wire).unwrap();
    assert_eq!((case.scale, case.strand_radius), (None, Some(2e-3)));
    assert!(matches!(case.question, Question::PretwistAt { lay: Lay::LayLength(30.0), .. }));
    refused(bare(&[("radius", "2 mm"), ("pretwist", "1"), ("force", "3 N")]), ErrorKind::Missing, "bending-stiffness");
    // nothing is nothing in every unit
    measured(&[("pretwist", "1"), ("force", "0")]).unwrap();
}

#[test]
fn what_no_ply_has_is_refused() {
    for strands in ["0", "-2", "2.5", "1", "1000001", "1e300", "-0.5"] {
        let flags = [("strands", strands), ("stiffness-ratio", "1"), ("pretwist", "1")];
        refused(Spec::from_flags(flags).unwrap().check(), ErrorKind::Domain, strands);
    }
    let flags = [("strands", "1000000"), ("stiffness-ratio", "1"), ("pretwist", "1")];
    assert_eq!(Spec::from_flags(flags).unwrap().check().unwrap().strands, 1_000_000);
    refused(Spec::from_flags([("strands", "1")]).unwrap().check(), ErrorKind::Domain, "nply contact");
    for (flag, value) in [
        ("helical-angle", "90 deg"),
        ("helical-angle", "-1 deg"),
        ("pitch-angle", "0 deg"),
        ("pitch-angle", "91 deg"),
        ("surface-angle", "90 deg"),
        ("lay-length", "-3"),
        ("lay-length", "0"),
        ("lay-ratio", "-3"),
        ("radius-ratio", "0"),
        ("core-radius", "-1"),
        ("ply-turns-per-length", "0"),
        ("pretwist", "nan"),
        ("pretwist", "-inf"),
        ("pretwist", "1e999"),
    ] {
        let error = bare(&[(flag, value)]).expect_err(value);
        assert_eq!((error.kind(), error.exit_code()), (ErrorKind::Domain, 1), "{error}");
        assert_eq!(error.place(), &Place::Flag(flag.to_owned()));
    }
    let ratio = |flags: Flags| {
        let base = [("strands", "3"), ("pretwist", "1"), ("radius", "1 mm")];
        Spec::from_flags(base.iter().chain(flags).copied())?.check()
    };
    for value in ["0", "-1", "nan", "inf"] {
        refused(ratio(&[("stiffness-ratio", value)]), ErrorKind::Domain, "stiffness-ratio");
    }
    for value in ["-1", "0.51", "-3"] {
        refused(ratio(&[("poissons-ratio", value)]), ErrorKind::Domain, "at most 0.5");
    }
    refused(ratio(&[("bending-stiffness", "0 N m^2"), ("stiffness-ratio", "1")]), ErrorKind::Domain, "greater than 0");
    refused(ratio(&[("youngs-modulus", "-1 GPa"), ("poissons-ratio", "0")]), ErrorKind::Domain, "greater than 0");
}

#[test]
fn too_many_data_name_each_other() {
    refused(
        measured(&[("diameter", "4 mm"), ("pretwist", "1")]),
        ErrorKind::Contradiction,
        "`--radius \"2 mm\"` and `--diameter \"4 mm\"`",
    );
    refused(measured(&[("youngs-modulus", "4 GPa"), ("pretwist", "1")]), ErrorKind::Contradiction, "bending stiffness");
    refused(measured(&[("stiffness-ratio", "1"), ("pretwist", "1")]), ErrorKind::Contradiction, "torsional stiffness");
    refused(bare(&[("pretwist", "1"), ("turns", "1")]), ErrorKind::Contradiction, "the twist");
    refused(bare(&[("lay-angle", "20 deg"), ("helical-angle", "20 deg")]), ErrorKind::Contradiction, "the lay");
    refused(bare(&[("pretwist", "1"), ("pretwist", "1")]), ErrorKind::Contradiction, "given twice");
    refused(bare(&[("pretwist", "1"), ("hand", "left")]), ErrorKind::Contradiction, "belongs to a given lay");
    refused(bare(&[("ply-turns-per-length", "0.1"), ("hand", "left")]), ErrorKind::Contradiction, "opposite hands");
    refused(
        bare(&[("pretwist", "1"), ("balance", "radial"), ("external-pressure", "1")]),
        ErrorKind::Contradiction,
        "contact balance",
    );
    refused(bare(&[("pretwist", "1"), ("temperature", "298 K")]), ErrorKind::Contradiction, "persistence");
}

#[test]
fn a_missing_datum_is_asked_for_in_the_language_of_the_input() {
    let by_flags = Spec::from_flags([("strands", "3")]).unwrap().check().unwrap_err();
    assert_eq!(
        by_flags.to_string(),
        "--stiffness-ratio: the strand's stiffness ratio C/B is missing: give `--stiffness-ratio`, such as 0.75"
    );
    let by_file = Spec::from_toml("a.toml", "\n[ply]\nstrands = 3\n\n[strand]\n").unwrap().check().unwrap_err();
    assert_eq!(
        by_file.to_string(),
        "a.toml:5:2: the strand's stiffness ratio C/B is missing: give `stiffness_ratio` in [strand], such as 0.75"
    );
    let empty = Spec::from_toml("a.toml", "").unwrap().check().unwrap_err();
    assert_eq!((empty.kind(), empty.line(), empty.column()), (ErrorKind::Missing, Some(1), Some(1)));
}

#[test]
fn flags_are_laid_over_the_file() {
    let file = Spec::from_toml(
        "a.toml",
        "[ply]\nstrands = 3\n[strand]\nradius = \"1 nm\"\nbending_persistence_length = \"50 nm\"\n\
         twist_persistence_length = \"75 nm\"\ntemperature = \"298 K\"\n[twist]\nturns_per_length = \"20 turns/µm\"\n[load]\nforce = \"2 pN\"\n",
    )
    .unwrap();
    let over = |flags: Flags| file.overridden_by(&Spec::from_flags(flags.iter().copied()).unwrap()).check();
    assert_eq!(pretwist(&over(&[("pretwist", "-0.25")]).unwrap()), -0.25);
    assert_eq!(over(&[("strands", "2")]).unwrap().strands, 2);
    assert_eq!(over(&[("diameter", "4 nm")]).unwrap().strand_radius, Some(2e-9));
    let stiff = over(&[("bending-stiffness", "200 pN nm^2"), ("stiffness-ratio", "1")]).unwrap();
    assert_eq!((stiff.scale.unwrap().bending_stiffness(), stiff.stiffness_ratio), (200e-30, 1.0));
    assert_eq!(over(&[]), file.check());
    // an error of a flag is said of the flag, one of the file of the file
    assert_eq!(over(&[("strands", "0")]).unwrap_err().place(), &Place::Flag("strands".to_owned()));
    refused(over(&[("lay-length", "40 nm"), ("moment", "0")]), ErrorKind::Contradiction, "too many data");
}

#[test]
fn file_and_flags_give_the_same_case() {
    let text = "ply.strands = 2\nply.balance = \"radial\"\nstrand = { radius = \"1 mm\", bending_stiffness = \"1 N mm^2\", stiffness_ratio = 0.7 }\n\
                twist.pretwist = -0.4\nload.force = \"3 N\"\n";
    let from_file = Spec::from_toml("a.toml", text).unwrap().check().unwrap();
    let flags = [
        ("--strands", "2"),
        ("--balance", "radial"),
        ("--radius", "1 mm"),
        ("--bending-stiffness", "1 N mm^2"),
        ("--stiffness-ratio", "0.7"),
        ("--pretwist", "-0.4"),
        ("--force", "3 N"),
    ];
    let from_flags = Spec::from_flags(flags).unwrap().check().unwrap();
    assert_eq!(from_file.question, from_flags.question);
    assert_eq!(from_file.scale, from_flags.scale);
    assert_eq!((from_file.strands, from_file.balance), (from_flags.strands, from_flags.balance));
}

#[test]
fn what_the_theory_refuses_is_said_at_its_datum() {
    let text = "[ply]\nstrands = 3\n[strand]\nradius = \"1 mm\"\nstiffness_ratio = 1\n[lay]\nlay_length = \"5 mm\"\n";
    let case = Spec::from_toml("rope.toml", text).unwrap().check().unwrap();
    let locate = |quantity| case.locate(&DomainError { quantity, value: 5.0, allowed: "greater than 2 n" });
    assert_eq!(
        locate("lay_length").to_string(),
        "rope.toml:7:14: `lay_length = \"5 mm\"` is lay_length = 5 strand radii, and no ply has it: it must be greater than 2 n"
    );
    for (quantity, line) in [
        ("helical_angle", 7),
        ("radius_ratio", 7),
        ("strands", 2),
        ("stiffness_ratio", 5),
        ("strand_radius", 4),
        ("else", 1),
    ] {
        assert_eq!((locate(quantity).line(), locate(quantity).exit_code()), (Some(line), 1), "{quantity}");
    }
}

#[test]
fn what_the_theory_refuses_is_said_once_and_shortly() {
    let refused = |flag, value| DomainError { quantity: flag, value, allowed: "greater than 6" };
    let ratio = bare(&[("radius-ratio", "1.3")]).unwrap();
    assert_eq!(
        ratio.locate(&refused("radius_ratio", 1.3)).to_string(),
        "`--radius-ratio \"1.3\"`: no ply has it; it must be greater than 6"
    );
    // where there is no room, what is needed is said instead
    let narrow = bare(&[("radius-ratio", "1.1")]).unwrap().locate(&refused("radius_ratio", 1.1)).to_string();
    assert!(narrow.contains("3 touching strands need at least 1.1547"), "{narrow}");
    let flat = bare(&[("pitch-angle", "1e-200 rad")]).unwrap().locate(&refused("pitch_angle", 1e-200)).to_string();
    assert!(flat.contains("is pitch_angle = 1e-200 rad, and"), "{flat}");
    let long = bare(&[("ply-turns-per-length", "1e-320")]);
    self::refused(long, ErrorKind::Domain, "too large or too small");
}

#[test]
fn the_shape_alone_needs_no_stiffness() {
    let shape = |flags: Flags| Spec::from_flags(flags.iter().copied()).unwrap().check_shape();
    let single = shape(&[("strands", "1")]).unwrap();
    assert_eq!((single.strands, single.lay, single.strand_radius), (1, None, None));
    let overdone = shape(&[("strands", "1"), ("helical-angle", "60 deg")]).unwrap_err();
    assert_eq!(overdone.kind(), ErrorKind::Contradiction);
    let rope =
        shape(&[("strands", "3"), ("diameter", "4 mm"), ("lay-length", "60 mm"), ("hand", "z"), ("pretwist", "1")])
            .unwrap();
    assert_eq!((rope.lay, rope.hand), (Some(Lay::LayLength(30.0)), Some(Handedness::Right)));
    assert_eq!(
        rope.locate(&DomainError { quantity: "lay_length", value: 30.0, allowed: "" }).place(),
        &Place::Flag("lay-length".into())
    );
    assert_eq!(shape(&[("strands", "0"), ("helical-angle", "60 deg")]).unwrap_err().exit_code(), 1);
    let missing = shape(&[("strands", "3")]).unwrap_err();
    assert_eq!(missing.kind(), ErrorKind::Missing);
    assert!(missing.to_string().starts_with("--helical-angle: the lay is missing"), "{missing}");
}

#[test]
fn a_value_without_quotation_marks_is_shown_with_them() {
    for (line, help) in [
        ("radius = 0.5 mm", "put the value in quotation marks: radius = \"0.5 mm\""),
        ("radius = 0.5mm # thin", "put the value in quotation marks: radius = \"0.5mm\""),
        ("balance = radial", "put the value in quotation marks: balance = \"radial\""),
    ] {
        let error = Spec::from_toml("a.toml", &format!("[strand]\n{line}\n")).unwrap_err();
        assert_eq!((error.kind(), error.line(), error.help()), (ErrorKind::Syntax, Some(2), Some(help)), "{error}");
    }
    let word_processor = Spec::from_toml("a.toml", "[strand]\nradius = \u{201c}0.5 mm\u{201d}\n").unwrap_err();
    assert_eq!(word_processor.help(), Some("put the value in quotation marks: radius = \"0.5 mm\""));
    // where something else is the matter, nothing of the kind is proposed
    let deep = ["a", &".a".repeat(3000), "=1"].concat();
    for text in
        ["[ply]\nstrands =\n", "[ply]\nstrands\u{0} = 3\n", "[ply]\rstrands = 3\r", "[ply]\nwhat = 3 mm\n", &deep]
    {
        assert_eq!(Spec::from_toml("a.toml", text).unwrap_err().help(), None, "{text}");
    }
}

#[test]
fn every_key_is_read_from_file_and_flag() {
    for key in &KEYS {
        let value = match key.kind {
            Kind::Count | Kind::Number | Kind::Turns => "2",
            Kind::Balance => "contact",
            Kind::Hand => "left",
            Kind::Text => "a name",
            Kind::Switch => "true",
            Kind::Length => "2 mm",
            Kind::Stiffness => "2 N m^2",
            Kind::Pressure => "2 MPa",
            Kind::LinearDensity => "2 tex",
            Kind::Density => "2 g/cm^3",
            Kind::Temperature => "2 K",
            Kind::Angle => "2 deg",
            Kind::TurnsPerLength | Kind::Twist => "2 turns/m",
            Kind::Force => "2 N",
            Kind::Moment => "2 N m",
            Kind::ForcePerLength => "2 N/m",
            other => panic!("{other:?}"),
        };
        let written = if key.kind == Kind::Switch { value.to_owned() } else { format!("{value:?}") };
        Spec::from_toml("a.toml", &format!("[{}]\n{} = {written}\n", key.table.name(), key.name)).unwrap();
        Spec::from_flags([(key.flag, value)]).unwrap();
        // and refused where it is of no use
        let wrong = Spec::from_toml("a.toml", &format!("[{}]\n{} = [1]\n", key.table.name(), key.name)).unwrap_err();
        assert_eq!((wrong.kind(), wrong.line()), (ErrorKind::WrongType, Some(2)));
        assert_eq!(wrong.column(), Some(key.name.len() + 4));
    }
}

proptest! {
    #[test]
    fn no_bytes_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        if let Err(error) = Spec::from_bytes("a.toml", &bytes).and_then(|spec| spec.check()) {
            let text = String::from_utf8_lossy(&bytes);
            prop_assert_eq!(error.to_string().lines().count(), 1);
            let _ = error.render(&text);
        }
    }

    #[test]
    fn no_text_panics(text in "(\\[(ply|strand|twist|lay|load|ends|support|x)\\]\n|[a-z_]{1,12} = |[0-9.e-]{1,6}|\"[^\"\n]{0,8}\"|\n|[ \\[\\]{},='#é\r\t\u{0}]){0,24}") {
        if let Err(error) = Spec::from_toml("a.toml", &text).and_then(|spec| spec.check()) {
            prop_assert_eq!(error.to_string().lines().count(), 1);
            let _ = error.render(&text);
            let _ = error.render_styled(&text);
        }
    }

    #[test]
    fn no_value_of_any_key_panics(picks in proptest::collection::vec((0..KEYS.len(), "(-?[0-9]{1,4}(e-?[0-9]{1,3})?)( ?(mm|N|N m|N/m|GPa|deg|turns/m|K|N m\\^2))?|true|left|radial|.{0,6}"), 0..9)) {
        let flags: Vec<_> = picks.iter().map(|(at, value)| (KEYS[*at].flag, value.as_str())).collect();
        let base = [("strands", "3"), ("stiffness-ratio", "1")];
        let all: Vec<_> = base.iter().copied().filter(|(flag, _)| flags.iter().all(|(other, _)| other != flag)).chain(flags.iter().copied()).collect();
        if let Err(error) = Spec::from_flags(all).and_then(|spec| spec.check()) {
            prop_assert_eq!(error.to_string().lines().count(), 1, "{}", error);
            prop_assert!(!error.render("").is_empty());
        }
    }
}
