//! Units and conventions of the trades: titre, count, S and Z, kT, cN/tex.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use nply::mechanics::{Load, Twist};
use nply_sheet::construction::ConstructionSpec;
use nply_sheet::{ErrorKind, Quantity, Question, Spec, SpecError};

fn spec(flags: &[(&str, &str)]) -> Spec {
    Spec::from_flags(flags.iter().copied()).unwrap_or_else(|error| panic!("{flags:?}: {error}"))
}

fn refused(flags: &[(&str, &str)]) -> SpecError {
    match Spec::from_flags(flags.iter().copied()).and_then(|spec| spec.check()) {
        Ok(_) => panic!("{flags:?} is accepted"),
        Err(error) => error,
    }
}

#[track_caller]
fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(), "{found:e} is not {expected:e}");
}

/// By definition: tex is g/km, denier g per 9 km, Nm km/kg, Ne hanks of 840 yards per pound.
#[test]
fn a_titre_is_mass_per_length_and_a_count_length_per_mass() {
    let titre = |text: &str| Quantity::parse_linear_density(text).unwrap().si();
    near(titre("94 tex"), 94e-6);
    near(titre("940 dtex"), 94e-6);
    near(titre("1.5 ktex"), 1.5e-3);
    near(titre("840 den"), 840.0 / 9e6);
    near(titre("840 denier"), 840.0 / 9e6);
    near(titre("840 D"), 840.0 / 9e6);
    near(titre("840D"), 840.0 / 9e6);
    near(titre("70d"), 70.0 / 9e6);
    let pound_per_hank = 0.453_592_37 / (840.0 * 3.0 * 12.0 * 0.0254);
    for (text, kilograms_per_metre) in [
        ("Nm 40", 1e-3 / 40.0),
        ("40 Nm", 1e-3 / 40.0),
        ("Ne 30", pound_per_hank / 30.0),
        ("30 Ne", pound_per_hank / 30.0),
        ("Ne30", pound_per_hank / 30.0),
        ("NeC 30", pound_per_hank / 30.0),
        ("30Ne", pound_per_hank / 30.0),
        ("Ne 30/1", pound_per_hank / 30.0),
        ("Nm 1/40", 1e-3 / 40.0),
        ("Ne 1/30", pound_per_hank / 30.0),
    ] {
        near(titre(text), kilograms_per_metre);
    }
    // a yarn of which 590.54 is the constant between tex and Ne in every table of counts
    assert!((titre("Ne 1") * 1e6 - 590.54).abs() < 5e-3);
    for (text, part) in [
        ("Ne 30/2", "\"Ne 30\", and 2 strands"),
        ("Nm 2/28", "\"Nm 28\", and 2 strands"),
        ("Ne 40/3", "\"Ne 40\", and 3 strands"),
        ("R 74 tex/2", "folded count, that of a ply: give the count of one strand, \"37 tex\" less"),
        ("R74 tex / 2", "and 2 strands"),
        ("R 74 N/0", "number"),
        ("30/2", "\"Ne 30\" (cotton, hanks of 840 yards per pound) or \"Nm 30\" (metric, km per kg), and 2 strands"),
        ("30/1", "in which system"),
        // a weaver's 2/30 is two of 30, whatever system it is counted in
        ("2/30 Ne", "\"Ne 30\", and 2 strands"),
        ("Ne 2/30", "\"Ne 30\", and 2 strands"),
        ("Ne 0", "too large"),
        ("Ne", "number"),
        ("Ne x", "number"),
    ] {
        let said = Quantity::parse_linear_density(text).unwrap_err().to_string();
        assert!(said.contains(part), "{text}: {said}");
    }
    for (text, part) in [("30/1", "folded"), ("30/1", " strand"), ("Ne 30/0", "0 strands"), ("Ne 30/0", "Ne 0")] {
        let said = Quantity::parse_linear_density(text).unwrap_err().to_string();
        assert!(!said.contains(part), "{text}: {said}");
    }
    // elsewhere Nm is a moment
    assert_eq!(Quantity::parse("40 Nm").unwrap().dimension(), nply_sheet::Dimension::MOMENT);
}

/// What is written on cones, in handbooks and on spindles, and what to write here.
#[test]
fn what_the_trade_writes_is_answered_with_what_is_read() {
    let base = [("strands", "2")];
    for (flag, written, hint) in [
        ("turns-per-length", "1100 T/m", "`tpm`"),
        ("turns-per-length", "1100 t/m Z", "`tpm`"),
        ("turns-per-length", "8 turns per inch", "`tpi`"),
        ("diameter", "33 wpi", "\"0.0303 inch\""),
        ("diameter", "1/33 inch", "\"0.030303 inch\""),
        ("diameter", "5/32 in", "\"0.15625 in\""),
        ("diameter", "1 1/4in", "\"1.25 in\""),
        ("diameter", "-1 1/4 in", "\"-1.25 in\""),
        ("stiffness-ratio", "3/4", "\"0.75\""),
        ("density", "1.38 g/cc", "`g/cm^3`"),
        ("diameter", "12 D", "`lay_ratio`"),
    ] {
        let said = Spec::from_flags([&base[..], &[(flag, written)]].concat()).unwrap_err().to_string();
        assert!(said.contains(hint), "{written}: {said}");
    }
    // what is written in place of them is read
    for text in ["1100 tpm", "8 tpi", "0.0303 inch", "1.38 g/cm^3"] {
        assert!(Quantity::parse(text).is_ok(), "{text}");
    }
}

/// The mass of a round strand of the diameter found is its titre.
#[test]
fn a_titre_and_a_density_give_the_diameter() {
    let base = [("strands", "2"), ("stiffness-ratio", "1"), ("pretwist", "-0.3")];
    for (titre, density, packing) in [("93.3333 tex", 1140.0, None), ("Ne 20", 1540.0, Some(0.6))] {
        let density_text = format!("{density} kg/m^3");
        let mut flags = base.to_vec();
        flags.extend([("linear-density", titre), ("density", density_text.as_str())]);
        let packing_text = packing.map(|share: f64| share.to_string());
        flags.extend(packing_text.as_deref().map(|text| ("packing-fraction", text)));
        let case = spec(&flags).check().unwrap();
        let radius = case.strand_radius.unwrap();
        let mass = core::f64::consts::PI * radius * radius * density * packing.unwrap_or(1.0);
        let si = Quantity::parse_linear_density(titre).unwrap().si();
        assert!((mass / si - 1.0).abs() < 1e-15);
        assert_eq!(case.packing_fraction, Some(packing.unwrap_or(1.0)));
    }
    let with = |more: &[(&'static str, &'static str)]| refused(&[&base[..], more].concat());
    let titre = ("linear-density", "94 tex");
    let density = ("density", "1.14 g/cm^3");
    assert!(with(&[titre]).to_string().contains("density of the fibre is missing"));
    assert!(with(&[density]).to_string().contains("only with a linear density"));
    assert!(with(&[titre, density, ("diameter", "1 mm")]).to_string().contains("both give the size"));
    for share in ["0", "1.01", "-0.5"] {
        let share = ("packing-fraction", share);
        assert_eq!(refused(&[&base[..], &[titre, density, share]].concat()).kind(), ErrorKind::Domain);
    }
    assert_eq!(with(&[("linear-density", "-94 tex"), density]).kind(), ErrorKind::Domain);
    // a flag takes the place of what the file says of the size, either way
    let file = "ply.strands = 2\ntwist.pretwist = -1\n[strand]\nstiffness_ratio = 1\n";
    let over = |size: &str, flags: &[(&str, &str)]| {
        let file = Spec::from_toml("ply.toml", &format!("{file}{size}")).unwrap();
        file.overridden_by(&spec(flags)).check().unwrap().strand_radius.unwrap()
    };
    near(over("linear_density = \"94 tex\"\ndensity = \"1 g/cm^3\"\n", &[("radius", "1 mm")]), 1e-3);
    let radius = over("radius = \"1 mm\"\n", &[titre, ("density", "1 g/cm^3")]);
    near(radius * radius * core::f64::consts::PI * 1e3, 94e-6);
}

#[test]
fn z_is_right_handed_and_positive_and_s_left_handed() {
    let twist = |text: &str| {
        let flags = [("strands", "2"), ("stiffness-ratio", "1"), ("radius", "1 mm"), ("turns-per-length", text)];
        match spec(&flags).check().unwrap().question {
            Question::States { twist: Twist::Pretwist(value), load: Load::NONE } => value,
            other => panic!("{other:?}"),
        }
    };
    let positive = twist("470 turns/m");
    for text in ["470 turns/m Z", "Z 470 turns/m", "Z470 tpm", "470 tpm Z", "+470 tpm Z", " 470 tpm  Z "] {
        assert!((twist(text) - positive).abs() < 1e-15, "{text}");
    }
    for text in ["470 turns/m S", "S 470 tpm", "S470 tpm", "-470 tpm", "-470 tpm S", "S -470 tpm", "470 tpm S"] {
        assert!((twist(text) + positive).abs() < 1e-15, "{text}");
    }
    let base = [("strands", "2"), ("stiffness-ratio", "1"), ("radius", "1 mm")];
    for text in ["-470 tpm Z", "\u{2212}470 tpm Z", "+470 tpm S", "Z -470 tpm"] {
        let error = refused(&[&base[..], &[("turns-per-length", text)]].concat());
        assert!(error.kind() == ErrorKind::Contradiction && error.to_string().contains("opposite hands"), "{error}");
    }
    // pure numbers, angles and turns take the letter too
    for (flag, text) in [("pretwist", "0.4 S"), ("surface-angle", "20 deg S"), ("strand-twist", "0.3 S")] {
        let Question::States { twist, .. } = spec(&[&base[..], &[(flag, text)]].concat()).check().unwrap().question
        else {
            panic!()
        };
        let (Twist::Pretwist(value) | Twist::StrandTwist(value)) = twist;
        assert!(value < 0.0, "{text}");
    }
    // a ply's turns say its hand, and must agree with it
    let lay = [("ply-turns-per-length", "460 turns/m S")];
    let shape = spec(&[&base[..], &lay].concat()).check_shape().unwrap();
    assert_eq!(shape.hand, Some(nply::Handedness::Left));
    let error = refused(&[&base[..], &lay, &[("hand", "Z")]].concat());
    assert_eq!(error.kind(), ErrorKind::Contradiction);
    // no hand where none is meant
    let error = refused(&[&base[..], &[("pretwist", "-1"), ("moment", "3 N mm S")]].concat());
    assert_eq!(error.exit_code(), 2);
}

/// kT at 298 K is 4.11 pN nm.
#[test]
fn energies_in_kt_go_by_the_temperature() {
    let dna = [
        ("strands", "2"),
        ("radius", "1 nm"),
        ("temperature", "298 K"),
        ("bending-stiffness", "50 kT nm"),
        ("torsional-stiffness", "120 kT nm"),
        ("pretwist", "0.1 Z"),
        ("moment", "2.5 kT"),
        ("force", "0.5 kT/nm"),
    ];
    let case = spec(&dna).check().unwrap();
    let kt = 1.380_649e-23 * 298.0;
    near(case.scale.unwrap().bending_stiffness(), 50e-9 * kt);
    near(case.stiffness_ratio, 2.4);
    assert!((kt / 4.11e-21 - 1.0).abs() < 2e-3);
    let Question::States { load, .. } = case.question else { panic!() };
    near(load.moment, 2.5 / 50.0);
    near(load.force, 0.5 / 50.0);
    let cold: Vec<_> = dna.iter().copied().filter(|(flag, _)| *flag != "temperature").collect();
    assert!(refused(&cold).to_string().contains("temperature is missing"));
    // as by persistence lengths
    let lengths = [("bending-persistence-length", "50 nm"), ("twist-persistence-length", "120 nm")];
    let other = [&dna[..3], &lengths, &dna[5..]].concat();
    assert_eq!(spec(&other).check().unwrap().question, case.question);
}

/// A force on the ply is shared by the titre of all its strands.
#[test]
fn a_force_in_cn_per_tex_goes_by_the_titre_of_the_ply() {
    let cord = [
        ("strands", "3"),
        ("diameter", "0.3 mm"),
        ("linear-density", "94 tex"),
        ("bending-stiffness", "1 N mm^2"),
        ("stiffness-ratio", "1"),
        ("pretwist", "-0.3"),
        ("force", "2 cN/tex"),
    ];
    let case = spec(&cord).check().unwrap();
    let Question::States { load, .. } = case.question else { panic!() };
    let newton = 2e-2 * 94.0 * 3.0;
    assert!((case.scale.unwrap().force(load.force) / newton - 1.0).abs() < 1e-14);
    let bare: Vec<_> = cord.iter().copied().filter(|(flag, _)| *flag != "linear-density").collect();
    assert!(refused(&bare).to_string().contains("linear density of a strand is missing"));
}

#[test]
fn what_people_of_a_trade_write_is_read_or_answered() {
    let value = |text: &str| Quantity::parse(text).unwrap_or_else(|error| panic!("{text}: {error}")).si();
    near(value("205000 N/mm2"), 205e9);
    near(value("7.85 t/m3"), 7850.0);
    let share = spec(&[("strands", "3"), ("stiffness-ratio", "75%"), ("pretwist", "-1")]).check().unwrap();
    near(share.stiffness_ratio, 0.75);
    for (flag, text, part) in [
        ("force", "13 tonne", "for a weight write kgf, tf or lbf"),
        ("lay-length", "194 A", "did you mean `Å`?"),
        ("lay-length", "194 Ang", "did you mean `Å`?"),
        ("lay-length", "194 xyz", "what is wanted is a length, such as"),
        ("lay-length", "14d", "`lay_ratio`"),
        ("strand-length", "147 bp", "0.34 nm for each"),
        ("temperature", "25 C", "did you mean `°C`?"),
        ("strands", "6,12", "is a list, and one number is wanted; what is wanted is a whole number, such as 3"),
        ("lay-length", "60 mm, 34 mm", "is a list"),
        ("lay-length", "0,5 mm", "decimal point"),
        ("turns-per-length", "5 turns/100m", "\"0.05 turns/m\""),
        ("moment", "0 kN", "such as \"12 N m\""),
        ("radius", "5%", "what is wanted is a length"),
    ] {
        let message = Spec::from_flags([(flag, text)]).unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
    let list = ConstructionSpec::from_flags([("strands", "6,12")]).unwrap_err().to_string();
    assert!(list.contains("a whole number, such as 3, once for each layer"), "{list}");
}

/// Flat rings on top of each other lie a strand diameter apart: n diameters in a turn, 1/(3 · 0.3 mm) = 1111.1 turns/m.
#[test]
fn turns_that_cannot_lie_so_closely_are_told_their_limit_as_turns() {
    let base = [("strands", "3"), ("stiffness-ratio", "1")];
    let said = |more: &[(&'static str, &'static str)]| {
        let case = spec(&[&base[..], more].concat()).check_plying().unwrap();
        nply_sheet::PlyingReport::of(case).unwrap_err().to_string()
    };
    let sized = [("diameter", "0.3 mm"), ("turns-per-length", "1000 tpm Z")];
    for (written, limit) in
        [("1200 tpm S", "1111.11 tpm"), ("30 tpi S", "28.2222 tpi"), ("2 turns/mm Z", "1.11111 turns/mm")]
    {
        let said = said(&[&sized[..], &[("ply-turns-per-length", written)]].concat());
        assert!(said.contains(&format!("less than {limit},")) && !said.contains("lay_length"), "{said}");
    }
    // 1/(2 · 3) in turns per strand radius
    let said = said(&[("pretwist", "1"), ("ply-turns-per-length", "0.5 S")]);
    assert!(said.contains("less than 0.166666 turns per strand radius"), "{said}");
}
