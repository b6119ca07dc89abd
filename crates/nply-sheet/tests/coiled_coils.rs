//! Radius, pitch and helix diameter: two of them give the third.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

use nply_sheet::{ErrorKind, Shape, ShapeReport, Spec};

fn shape(flags: &[(&str, &str)]) -> Shape {
    Spec::from_flags(flags.iter().copied()).and_then(|spec| spec.check_shape()).unwrap_or_else(|e| panic!("{e}"))
}

fn number(flags: &[(&str, &str)], name: &str) -> f64 {
    let report = ShapeReport::of(shape(flags), 0).unwrap();
    let json: serde_json::Value = serde_json::from_str(&report.json()).unwrap();
    let found = if name == "strand_radius_m" { &json[name] } else { &json["si"][name] };
    found.as_f64().unwrap_or_else(|| panic!("{name}: {json}"))
}

/// Radius and pitch in Å of the basis set of coiled coils in the open program ISAMBARD, and the radius of
/// touching helices worked out by hand: of the squared distance between the first centreline and the next the least, by a fine
/// search.
#[test]
fn superhelix_radius_and_pitch_give_the_radius_of_a_helix() {
    for (strands, radius, pitch) in
        [(2, 5.07, 225.8), (3, 6.34, 194.0), (4, 6.81, 213.2), (5, 8.62, 182.8), (6, 9.13, 228.4), (7, 9.80, 328.6)]
    {
        let (n, r, p) = (f64::from(strands), radius, pitch);
        let turn = core::f64::consts::TAU;
        let distance = |height: f64| {
            let angle = turn / n + turn * height / p;
            libm::hypot(2.0 * r * libm::sin(0.5 * angle), height)
        };
        // by halves: the distance has one minimum near the height 0
        let (mut low, mut high) = (-0.25 * p, 0.25 * p);
        for _ in 0..200 {
            let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
            if distance(a) < distance(b) { high = b } else { low = a }
        }
        let least = 0.5 * distance(low);
        let [count, radius, pitch] = [strands.to_string(), format!("{r} Å"), format!("{p} Å")];
        let given = [("strands", count.as_str()), ("helix-radius", &radius), ("lay-length", &pitch)];
        let found = number(&given, "strand_radius_m") * 1e10;
        assert!((found - least).abs() < 1e-6, "{strands}: {found} Å, {least} Å");
        // and each two of the three the third
        let helix = format!("{found} Å");
        let of = [("strands", count.as_str()), ("radius", &helix), ("lay-length", &pitch)];
        let json: serde_json::Value = serde_json::from_str(&ShapeReport::of(shape(&of), 0).unwrap().json()).unwrap();
        let ratio = json["radius_ratio"].as_f64().unwrap();
        assert!((ratio * found - r).abs() < 1e-9);
        if strands > 2 {
            let of = [("strands", count.as_str()), ("radius", &helix), ("helix-radius", &radius)];
            assert!((number(&of, "lay_length") * 1e10 / p - 1.0).abs() < 1e-9);
        }
    }
}

/// The same size whichever datum gives the lay.
#[test]
fn any_lay_goes_with_a_helix_radius() {
    let base = [("strands", "3"), ("helix-radius", "6.34 Å"), ("lay-length", "194 Å")];
    let radius = number(&base, "strand_radius_m");
    let report: serde_json::Value = serde_json::from_str(&ShapeReport::of(shape(&base), 0).unwrap().json()).unwrap();
    let of = |name: &str| report[name].as_f64().unwrap();
    let core = format!("{} Å", (of("radius_ratio") - 1.0) * radius * 1e10);
    for (flag, value) in [
        ("helical-angle", format!("{} deg", of("helical_angle_deg"))),
        ("pitch-angle", format!("{} deg", of("pitch_angle_deg"))),
        ("lay-ratio", of("lay_ratio").to_string()),
        ("radius-ratio", of("radius_ratio").to_string()),
        ("core-radius", core),
        ("ply-turns-per-length", format!("{} turns/m S", 1.0 / 194e-10)),
    ] {
        let found = number(&[base[0], base[1], (flag, &value)], "strand_radius_m");
        assert!((found / radius - 1.0).abs() < 1e-12, "{flag}: {found:e}");
    }
}

#[test]
fn too_many_data_are_refused() {
    let base = [("strands", "3"), ("helix-radius", "6.34 Å"), ("lay-length", "194 Å")];
    let refused = |flags: &[(&str, &str)]| {
        Spec::from_flags(flags.iter().copied()).and_then(|spec| spec.check_shape()).unwrap_err()
    };
    assert_eq!(refused(&[&base[..], &[("radius", "5.4 Å")]].concat()).kind(), ErrorKind::Contradiction);
    assert_eq!(refused(&[base[0], ("helix-radius", "1.3"), ("lay-length", "40")]).kind(), ErrorKind::Contradiction);
    assert_eq!(refused(&[base[0], base[1], ("core-radius", "7 Å")]).kind(), ErrorKind::Domain);
    assert_eq!(refused(&[base[0], base[1]]).kind(), ErrorKind::Missing);
    // a bare pair lacks units, and no datum
    let bare = refused(&[base[0], ("helix-radius", "6.34"), ("lay-length", "194")]).to_string();
    assert!(bare.contains("bare numbers are in strand radii") && bare.contains("\"6.34 Å\""), "{bare}");
    // three straight strands that touch: R = r/sin 60°
    let no_room = |flags: &[(&str, &str)]| ShapeReport::of(shape(flags), 0).unwrap_err();
    let narrow = no_room(&[base[0], ("radius", "5 Å"), ("helix-radius", "5.5 Å")]);
    assert_eq!(narrow.kind(), ErrorKind::Domain);
    let narrow = narrow.to_string();
    assert!(narrow.contains("R/r is 1.1, and 3 touching") && narrow.contains("1.1547, here 5.7735 Å"), "{narrow}");
    let core = no_room(&[("strands", "7"), ("radius", "5 Å"), ("core-radius", "5.5 Å")]).to_string();
    assert!(core.contains("R/r is 2.1") && core.contains("here 6.52382 Å"), "{core}"); // 5 Å · (1/sin(180°/7) − 1)
    // bare, it is the radius ratio
    let bare = shape(&[("strands", "6"), ("helix-radius", "2.1")]);
    assert!((bare.lay.unwrap().contact(6).unwrap().angle().degrees() - 20.0).abs() < 0.05);
}
