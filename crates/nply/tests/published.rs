//! Numbers that others have published, each with its source.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

use std::f64::consts::PI;

use nply::geometry::{
    BranchKind, Contact, DensestHelix, FitFormula, HelicalAngle, LayerContact, Section, WireLay, WireLayer, WireStrand,
    branches,
};
use nply::mechanics::{Balance, Load, Ply, Twist};

#[track_caller]
fn about(got: f64, want: f64, slack: f64, what: &str) {
    assert!((got - want).abs() <= slack, "{what}: {got}, published {want}");
}

/// Neukirch & van der Heijden 2002, (8), section 2.2 and the caption of Figure 11.
#[test]
fn geometry_of_the_paper() {
    let helix = DensestHelix::new();
    about(helix.angle().degrees(), 68.2082, 5e-5, "densest helix");
    about(helix.arclength_shift(), 5.685134, 5e-7, "its shift");
    about(helix.radius_ratio(), 0.862185, 5e-7, "its radius");
    about(Section::non_convex_angle(3).unwrap().degrees(), 51.2, 0.05, "the cut of a 3-ply turns non-convex");
    about(Contact::new(6, 20_f64.to_radians()).unwrap().radius_ratio(), 2.1, 5e-4, "six strands at 20 degrees");
}

/// Section 3 of the paper: where p₁ and p of the balanced 2-ply end at θ = π/2.
#[test]
fn pressure_of_flat_balanced_rings() {
    let angle = HelicalAngle::from_pitch_angle(1e-7).unwrap();
    let ply = Ply::with_balance(2, 0.75, Balance::Radial).unwrap();
    let state = ply.pretwist_at(angle, nply::Handedness::Right, Load::NONE).unwrap();
    about(state.interstrand_pressure(), -PI * PI / 8.0, 1e-6, "p1 on the nontrivial branch");
    about(state.resultant_pressure(), 0.0, 1e-6, "p on the nontrivial branch");
    let trivial = branches(2, HelicalAngle::from_pitch_angle(0.02).unwrap(), 1).unwrap()[0];
    assert_eq!((trivial.kind, trivial.radius_ratio), (BranchKind::Trivial, 1.0));
    let p = angle.sin().powi(4) / (trivial.radius_ratio.powi(3) * angle.cos_double()); // (43)
    about(p, -1.0, 1e-6, "p on the trivial branch");
    about(p / (2.0 * trivial.radius_ratio), -0.5, 1e-6, "p1 on the trivial branch, (38)");
}

/// The angle of the most turns: greatest sin θ/ρ, by golden section.
fn most_turns(strands: u32) -> Contact {
    let turns = |theta: f64| {
        let contact = Contact::new(strands, theta).unwrap();
        contact.angle().sin() / contact.radius_ratio()
    };
    let (mut a, mut b) = (0.1, 1.5);
    for _ in 0..200 {
        let (p, q) = (a + (b - a) * 0.382, a + (b - a) * 0.618);
        if turns(p) < turns(q) { a = p } else { b = q }
    }
    Contact::new(strands, a).unwrap()
}

/// Olsen & Bohr, arXiv:1003.5358: zero-twist pitch angle 39.4° of two strands. Press reports on Bohr & Olsen, EPL 93 (2011)
/// 60004: a zero-twist rope of three strands is 68 % as long as its strands.
#[test]
fn zero_twist_ropes() {
    let two = most_turns(2);
    about(two.pitch_angle().to_degrees(), 39.4, 0.05, "two strands");
    about(two.pitch_angle().to_degrees(), 39.3771, 1e-3, "two strands, more digits by this theory");
    about(two.shift_ratio_squared(), 1.0, 1e-6, "a shift of one diameter");
    about(100.0 * most_turns(3).angle().cos(), 68.0, 0.5, "three strands");
    about(100.0 * most_turns(3).angle().cos(), 67.989, 1e-3, "three strands, more digits by this theory");
    // Würtz et al. 2010 let two twisted strings go to arctan(π/2), beyond what strings of finite radius allow
    assert!((PI / 2.0).atan() > two.helical_angle());
}

/// A three-dimensional simulation of rods with frictionless contact, no helix assumed: n = 3, γ = 3/4, released.
#[test]
fn simulated_three_plies() {
    let of = |balance, pretwist| {
        let ply = Ply::with_balance(3, 0.75, balance).unwrap();
        ply.equilibria(Twist::Pretwist(pretwist), Load::NONE).unwrap()[0].contact().angle().degrees()
    };
    for (pretwist, simulated, radial) in
        [(-0.2, 12.1369, 12.1454), (-0.5, 23.2305, 23.4964), (-1.0, 30.6130, 32.0903), (-2.0, 34.5859, 38.1318)]
    {
        about(of(Balance::Contact, pretwist), simulated, 6e-5, "contact balance");
        about(of(Balance::Radial, pretwist), radial, 6e-5, "radial balance");
    }
}

/// The limiting angle of large pretwist: π/4 in the paper for every n, that of greatest torsion in contact balance.
#[test]
fn limiting_angles() {
    for (n, degrees) in [(2, 45.0), (3, 37.8756), (4, 36.6158), (5, 36.1000), (6, 35.8344)] {
        for (balance, limit) in [(Balance::Contact, degrees), (Balance::Radial, 45.0)] {
            let ply = Ply::with_balance(n, 0.75, balance).unwrap();
            let states = ply.equilibria(Twist::Pretwist(-1e7), Load::NONE).unwrap();
            let right = states.iter().find(|s| s.handedness() == nply::Handedness::Right).unwrap();
            about(right.contact().angle().degrees(), limit, 6e-5, balance.name());
        }
    }
}

/// Areas of seven-wire strand from the CPCI manual's table, at the 14 diameters between the 12 and 16 of ASTM A416-12a:
/// 12.70 mm has 98.7 mm². Three-wire strand of 8.6 mm has 37.4 mm² in a maker's table after FprEN 10138-3.
#[test]
fn areas_of_prestressing_strand() {
    let area = |wires: u32, lay_ratio: f64, diameter: f64, cored: bool| {
        let contact = Contact::from_lay_ratio(wires, lay_ratio).unwrap();
        let r = 0.5 * diameter / contact.outer_radius();
        let core = if cored { contact.hole_radius() * r } else { 0.0 };
        PI * core * core + f64::from(wires) * PI * r * r / contact.angle().cos()
    };
    about(area(6, 14.0, 12.70, true), 98.7, 0.2, "12.70 mm");
    about(area(6, 14.0, 9.53, true), 54.8, 0.02 * 54.8, "9.53 mm");
    about(area(6, 14.0, 15.24, true), 140.0, 0.02 * 140.0, "15.24 mm");
    about(area(3, 16.0, 8.6, false), 37.4, 0.01 * 37.4, "three wires, at 16 diameters");
}

/// Utting & Jones, Int. J. Mech. Sci. 29 (1987) 605: core 3.94 mm, six wires of 3.73 mm, lay angles from 9.2° to 17.0°:
/// somewhere between, the wires touch each other as well as the core.
#[test]
fn wires_on_a_core() {
    let contact = Contact::from_radius_ratio(6, (3.94 + 3.73) / 3.73).unwrap();
    assert!((9.2..17.0).contains(&contact.angle().degrees()), "{}", contact.angle().degrees());
}

/// Product tables of a tyre-cord maker (Formosa Taffeta), nylon 6: cable twist in turns per metre and gauge in mm. The angles
/// are this theory's.
#[test]
fn tyre_cords() {
    for (turns, gauge, degrees) in [(460.0, 0.55e-3, 21.67), (370.0, 0.66e-3, 20.99), (320.0, 0.76e-3, 20.91)] {
        let cord = Contact::from_lay_ratio(2, 1.0 / (turns * gauge)).unwrap();
        about(cord.angle().degrees(), degrees, 6e-3, "cord");
    }
}

/// Hand spinners' rule, from their blogs: ply twist is two thirds of the singles' twist. In radial balance a 2-ply keeps it at
/// 30° for γ = 1 and at 26.366° for γ = 3/4.
#[test]
fn two_thirds() {
    for (gamma, degrees) in [(1.0, 30.0), (0.75, 26.366)] {
        let ply = Ply::with_balance(2, gamma, Balance::Radial).unwrap();
        let angle = HelicalAngle::new(f64::to_radians(degrees)).unwrap();
        let state = ply.pretwist_at(angle, nply::Handedness::Left, Load::NONE).unwrap();
        about((state.ply_twist() / state.pretwist()).abs(), 2.0 / 3.0, 2e-5, "turns of ply over turns of strand");
    }
}

/// Coiled coils of the ISAMBARD basis set, radius and pitch in ångström. The radius of the touching helices is this theory's:
/// about 4.2 to 5.5 Å for all of them.
#[test]
fn coiled_coils() {
    for (n, radius, pitch, helix) in [
        (2, 5.07, 225.8, 5.07),
        (3, 6.34, 194.0, 5.461),
        (4, 6.81, 213.2, 4.767),
        (5, 8.62, 182.8, 4.923),
        (6, 9.13, 228.4, 4.459),
        (7, 9.80, 328.6, 4.192),
    ] {
        let contact = Contact::new(n, (2.0 * PI * radius / pitch).atan()).unwrap();
        about(radius / contact.radius_ratio(), helix, 6e-4, "strand radius");
    }
}

/// Utting & Jones, Int. J. Mech. Sci. 29 (1987) 605: six wires of 3.73 mm on a core of 3.94 mm, tested at lay angles from 9.2°
/// to 17.0°. At the least of them there is a gap, at the greatest the wires would overlap; at 15.296° they just touch.
#[test]
fn strand_of_utting_and_jones() {
    let at = |degrees: f64| WireLayer::on_core(6, 1.865, 1.97, WireLay::Angle(degrees.to_radians())).unwrap();
    assert_eq!((at(9.2).contact(), at(17.0).contact()), (LayerContact::Core, LayerContact::Neighbours));
    let touching = WireLayer::with_gap(6, 1.865, 1.97, 0.0).unwrap();
    let (mut low, mut high) = (9.2, 17.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if at(middle).gap() > 0.0 { low = middle } else { high = middle }
    }
    about(touching.angle().degrees(), low, 1e-9, "the angle by bisection");
    assert!((9.2..17.0).contains(&low));
    // the flat formula sees a gap of a tenth of a millimetre at every angle
    about(FitFormula::Flat.gap(&at(17.0)), 0.105, 1e-12, "flat");
}

/// Seven wires alike overlap at any lay: of 4 mm, at a lay length of 80 mm (tan θ = 2πR/P = π/10), by 0.14 mm. The flat formula sees none
/// of it.
#[test]
fn seven_wires_alike_overlap() {
    let layer = WireLayer::on_core(6, 2.0, 2.0, WireLay::Length(80.0)).unwrap();
    about(layer.angle().degrees(), 17.4406, 5e-5, "2πR/P = π/10");
    assert!(layer.gap() < -0.14 && layer.contact() == LayerContact::Neighbours);
    assert!(FitFormula::Flat.gap(&layer).abs() < 1e-14);
}

/// ASTM A416 strand, pitch 14 nominal diameters, outer wires just touching (the standard fixes neither): areas against those of
/// the CPCI manual's table, mm². They are met to 0.2 % for 12.70 mm only; 9.53 and 15.24 mm come out 1.6 % larger, as strands
/// of that diameter without any gap must: the listed areas are nominal, for wires somewhat thinner.
#[test]
fn prestressing_strand() {
    for (outer, listed, computed, slack) in
        [(12.70, 98.7, 98.83, 0.002), (9.53, 54.8, 55.65, 0.017), (15.24, 140.0, 142.32, 0.017)]
    {
        let layer = WireLayer::in_outer_radius(6, outer / 2.0, 0.0, WireLay::Ratio(14.0)).unwrap();
        let mut strand = WireStrand::on_core(Some(layer.core_radius())).unwrap();
        strand.lay(6, layer.wire_radius(), WireLay::Length(layer.lay_length())).unwrap();
        about(strand.metal_area(), computed, 0.006, "by bisection apart from the library");
        about(strand.metal_area() / listed, 1.0, slack, "listed");
        about(2.0 * strand.outer_radius(), outer, 1e-12, "diameter");
        about(layer.core_radius() / layer.wire_radius(), 1.016_901_17, 1e-8, "king wire over wire");
    }
}

/// Three-wire strand of 8.6 mm, a maker's table after FprEN 10138-3: 37.4 mm². Across each wire the three that fill that circle at a pitch of
/// 16 diameters have 37.48, in a plane across the strand 37.69 (1/cos θ more). Neither rounds to 37.4; the first is 0.2 % from it.
#[test]
fn three_wire_strand() {
    let layer = WireLayer::in_outer_radius(3, 4.3, 0.0, WireLay::Ratio(16.0)).unwrap();
    let across_wires = 3.0 * PI * layer.wire_radius() * layer.wire_radius();
    about(across_wires, 37.478_69, 5e-6, "across each wire");
    about(across_wires / layer.angle().cos(), 37.685_87, 5e-6, "in a plane across");
    about(across_wires, 37.4, 0.1, "listed");
}

/// The conductor CARDINAL after EN 50182, 1.770510 kg/m in the data set of rte-france/pallas-stranded-cable: steel 1 + 6 × 3.34 mm
/// (7.78 g/cm³), aluminium 12 + 18 + 24 × 3.32 mm (2.70 g/cm³), lay ratios in the middle of the standard's ranges. Each layer on the sum of
/// the diameters below has that mass; with the six steel wires where they really are, 12.6 µm off their king wire, it is 25 mg/m more.
#[test]
fn cardinal() {
    let layers = [(6, 3.34, 7.78, 21.0), (12, 3.32, 2.70, 13.0), (18, 3.32, 2.70, 13.0), (24, 3.32, 2.70, 12.0)];
    let section = |d: f64| PI * d * d / 4.0 * 1e-3; // times g/cm³: kg/m
    let (mut drawn, mut real) = (section(3.34) * 7.78, section(3.34) * 7.78);
    let mut below = 3.34 / 2.0;
    let mut strand = WireStrand::on_core(Some(below)).unwrap();
    for (wires, d, density, ratio) in layers {
        let layer = WireLayer::on_core(wires, d / 2.0, below, WireLay::Ratio(ratio)).unwrap();
        below += d;
        drawn += f64::from(wires) * section(d) * density / layer.angle().cos();
        let laid = strand.lay(wires, d / 2.0, WireLay::Ratio(ratio)).unwrap();
        real += laid.metal_area() * 1e-3 * density;
    }
    about(drawn, 1.770_510, 5e-7, "sums of diameters");
    about(real - drawn, 25e-6, 1e-6, "wires where they are");
    about(2.0 * below, 29.94, 1e-9, "diameter");
    let contacts: Vec<_> = strand.layers().iter().map(WireLayer::contact).collect();
    assert_eq!(contacts, [LayerContact::Neighbours, LayerContact::Core, LayerContact::Core, LayerContact::Core]);
}
