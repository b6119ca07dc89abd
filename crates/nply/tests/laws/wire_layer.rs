//! Wires laid on a core: gaps in space by brute force, the inverses, the formulas in use.

use std::f64::consts::{PI, TAU};

use nply::geometry::{Contact, FitFormula, LayerContact, Section, WireLay, WireLayer, WireStrand};
use proptest::prelude::*;

use crate::config;

/// The least distance between centrelines of lay radius R and lay length P that are turned by `turn` about the axis, less 2r: by a
/// scan of one turn either way and golden sections round the lowest points.
fn brute_gap(lay_radius: f64, lay_length: f64, turn: f64, wire_radius: f64) -> f64 {
    let distance = |phi: f64| {
        let rise = lay_length * (phi - turn) / TAU;
        (lay_radius * lay_radius * (2.0 * (phi / 2.0).sin()).powi(2) + rise * rise).sqrt()
    };
    let steps = 2000;
    let at = |i: i32| turn - 1.5 * TAU + 3.0 * TAU * f64::from(i) / f64::from(steps);
    let mut least = f64::MAX;
    for i in 1..steps {
        let (before, here, after) = (distance(at(i - 1)), distance(at(i)), distance(at(i + 1)));
        if here <= before && here <= after {
            let (mut low, mut high) = (at(i - 1), at(i + 1));
            for _ in 0..90 {
                let (p, q) = (low + 0.382 * (high - low), low + 0.618 * (high - low));
                if distance(p) < distance(q) { high = q } else { low = p }
            }
            least = least.min(distance(0.5 * (low + high)));
        }
    }
    least - 2.0 * wire_radius
}

/// n, r, core radius from 0.8 to 1.6 of that for straight wires, P from little more than flat rings to almost straight.
fn layer() -> impl Strategy<Value = WireLayer> {
    (2..=14_u32, 0.1..10.0_f64, 0.8..1.6_f64, 0.02..4.0_f64).prop_map(|(n, r, wide, log_lay)| {
        let core = (wide / (PI / f64::from(n)).sin() * r - r).max(0.05 * r);
        let lay = 2.0 * f64::from(n) * r * log_lay.exp();
        WireLayer::on_core(n, r, core, WireLay::Length(lay)).unwrap()
    })
}

fn again(of: &WireLayer, core_radius: f64) -> WireLayer {
    WireLayer::on_core(of.wires(), of.wire_radius(), core_radius, WireLay::Length(of.lay_length())).unwrap()
}

proptest! {
    #![proptest_config(config(96))]

    /// The gap is the least distance in space, to the next wire as to any other.
    #[test]
    fn gap_is_the_least_distance(layer in layer()) {
        let (r, radius, lay) = (layer.wire_radius(), layer.lay_radius(), layer.lay_length());
        let next = TAU / f64::from(layer.wires());
        let found = brute_gap(radius, lay, next, r);
        prop_assert!((found - layer.gap()).abs() < 1e-9 * radius, "{found} {layer:?}");
        for k in 2..layer.wires() {
            prop_assert!(brute_gap(radius, lay, next * f64::from(k), r) > layer.gap() - 1e-9 * radius);
        }
    }

    /// At a given lay length a larger core has the larger gap; on the king wire the gap is zero, beside it has a sign.
    #[test]
    fn one_king_wire(layer in layer(), more in 1e-6..0.5_f64, wanted in 0.0..1.0_f64) {
        let king = layer.king_wire_radius();
        prop_assert!(again(&layer, layer.core_radius() * (1.0 + more)).gap() > layer.gap());
        if king > 1e-3 * layer.wire_radius() {
            prop_assert_eq!(again(&layer, king).contact(), LayerContact::Both);
            prop_assert_eq!(again(&layer, king * (1.0 + 1e-6)).contact(), LayerContact::Core);
            prop_assert_eq!(again(&layer, king * (1.0 - 1e-6)).contact(), LayerContact::Neighbours);
            prop_assert!((king + layer.wire_radius() - layer.touching_radius()).abs() < 1e-13 * layer.touching_radius());
        }
        // a gap of any size below that of flat rings, and none above
        let most = layer.lay_length() / f64::from(layer.wires()) - 2.0 * layer.wire_radius();
        let gap = 0.999 * wanted * most;
        let core = layer.king_wire_radius_for(gap).unwrap();
        if core > 0.0 {
            let found = again(&layer, core).gap();
            prop_assert!((found - gap).abs() < 1e-11 * (core + layer.wire_radius()), "{found} for {gap}");
        }
        prop_assert!(layer.king_wire_radius_for(1.001 * most).is_err());
        prop_assert!(layer.gap() < most);
    }

    /// Wires that overlap take the lay radius at which they touch, at the same lay length; others stay where they are.
    #[test]
    fn what_the_wires_take(layer in layer()) {
        let taken = again(&layer, layer.taken_radius() - layer.wire_radius());
        if layer.gap() > 0.0 {
            prop_assert_eq!(taken.gap(), layer.gap());
            prop_assert_eq!(layer.core_gap(), 0.0);
        } else if layer.wires() > 2 {
            prop_assert!(taken.gap().abs() < 1e-13 * taken.lay_radius());
            prop_assert!((layer.core_gap() - (layer.king_wire_radius() - layer.core_radius())).abs() < 1e-15 * layer.lay_radius());
        }
        prop_assert!((layer.taken_angle().tan() * layer.lay_length() / (TAU * layer.taken_radius()) - 1.0).abs() < 1e-12);
    }

    /// The lay found for a gap has that gap, and the wires found for an outer diameter have both.
    #[test]
    fn inverses(n in 2..=14_u32, r in 0.1..10.0_f64, gap in 0.0..0.3_f64, wide in 1.001..2.0_f64, log_lay in 0.3..4.0_f64, which in 0..3_usize) {
        let core = wide * (r + 0.5 * gap) / (PI / f64::from(n)).sin() - r;
        let layer = WireLayer::with_gap(n, r, core, gap).unwrap();
        prop_assert!((layer.gap() - gap).abs() < 1e-12 * layer.lay_radius(), "{layer:?}");
        prop_assert_eq!(layer.core_radius(), core);

        // the core for a gap, by any lay
        let lay = [WireLay::Length(2.0 * f64::from(n) * (r + gap) * log_lay.exp()), WireLay::Ratio(log_lay.exp()), WireLay::Angle(0.3 * log_lay)][which];
        let layer = WireLayer::on_king_wire(n, r, gap, lay).unwrap();
        prop_assert!((layer.gap() - gap).abs() < 1e-12 * layer.lay_radius(), "{layer:?}");
        prop_assert!((lay.length(layer.lay_radius(), r).unwrap() / layer.lay_length() - 1.0).abs() < 1e-12);

        let outer = f64::from(n) * 0.1 * r + gap;
        let lay = match which {
            0 => WireLay::Length(outer * log_lay.exp()),
            1 => WireLay::Ratio(0.5 * log_lay.exp()),
            _ => WireLay::Angle(0.3 * log_lay),
        };
        if let Ok(layer) = WireLayer::in_outer_radius(n, outer, gap, lay) {
            prop_assert!((layer.lay_radius() + layer.wire_radius() - outer).abs() < 1e-12 * outer);
            prop_assert!((layer.gap() - gap).abs() < 1e-11 * outer, "{layer:?} {gap}");
            let (found, given) = match lay {
                WireLay::Length(length) => (layer.lay_length(), length),
                WireLay::Ratio(ratio) => (layer.lay_length() / (2.0 * outer), ratio),
                WireLay::Angle(theta) => (layer.angle().radians(), theta),
            };
            prop_assert!((found / given - 1.0).abs() < 1e-11, "{found} {given}");
        }
    }

    /// All lengths of a strand grow with its size, areas with its square; angles stay.
    #[test]
    fn size(layer in layer(), k in 1e-3..1e3_f64) {
        let large = WireLayer::on_core(layer.wires(), k * layer.wire_radius(), k * layer.core_radius(), WireLay::Length(k * layer.lay_length())).unwrap();
        let same = |a: f64, b: f64| (a - b).abs() < 1e-12 * (k * layer.lay_radius());
        prop_assert!(same(large.gap(), k * layer.gap()) && same(large.touching_radius(), k * layer.touching_radius()));
        prop_assert!((large.metal_area() / layer.metal_area() / (k * k) - 1.0).abs() < 1e-12);
        prop_assert!((large.taken_angle().radians() - layer.taken_angle().radians()).abs() < 1e-12);
    }

    /// The wires' section in a plane across, πr²/cos θ, is the area that the outline (9)–(11) encloses.
    #[test]
    fn true_sections(n in 2..=12_u32, theta in 0.01..1.2_f64) {
        let contact = Contact::new(n, theta).unwrap();
        let section = Section::new(&contact, nply::Handedness::Right);
        let steps = 400;
        let point = |i: u32| section.outline(0, 0.0, TAU * f64::from(i) / f64::from(steps));
        let area: f64 = (0..steps)
            .map(|i| 0.5 * point(i)[0] * (point(i + 1)[1] - point((i + steps - 1) % steps)[1]))
            .sum();
        let layer = WireLayer::without_core(n, 1.0, WireLay::Angle(theta)).unwrap();
        prop_assert!((area.abs() * f64::from(n) / layer.metal_area() - 1.0).abs() < 1e-3, "{area} {layer:?}");
    }

    /// Whatever the bits, a layer is refused or all its numbers are numbers.
    #[test]
    fn any_bits(n in any::<u32>(), bits in prop::array::uniform3(any::<u64>()), which in 0..3_usize) {
        let [r, core, lay] = bits.map(f64::from_bits);
        let lay = [WireLay::Length(lay), WireLay::Ratio(lay), WireLay::Angle(lay)][which];
        for layer in [WireLayer::on_core(n, r, core, lay), WireLayer::without_core(n, r, lay)].into_iter().flatten() {
            for number in [layer.gap(), layer.touching_radius(), layer.taken_outer_radius(), layer.metal_area(), layer.core_gap(), layer.angle().radians()] {
                prop_assert!(number.is_finite(), "{layer:?}");
            }
        }
    }
}

#[test]
fn what_cannot_be_laid_is_refused_by_name() {
    let on = |n, r, core, lay| WireLayer::on_core(n, r, core, lay).map(drop).map_err(|error| error.quantity);
    let length = WireLay::Length(40.0);
    assert_eq!(on(6, 1.0, 1.0, length), Ok(()));
    assert_eq!(on(1, 1.0, 1.0, length), Err("strands"));
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(on(6, bad, 1.0, length), Err("wire_radius"));
        assert_eq!(on(6, 1.0, 1.0, WireLay::Length(bad)), Err("lay_length"));
        assert_eq!(on(6, 1.0, 1.0, WireLay::Ratio(bad)), Err("lay_ratio"));
        assert_eq!(on(6, 1.0, 1.0, WireLay::Angle(bad)), Err("lay_angle"));
    }
    for bad in [-1e-9, f64::NAN, f64::INFINITY] {
        assert_eq!(on(6, 1.0, bad, length), Err("core_radius"));
        assert!(WireStrand::on_core(Some(bad)).is_err());
    }
    // six flat rings need twelve radii
    assert_eq!(on(6, 1.0, 1.0, WireLay::Length(12.0)), Err("lay_length"));
    assert_eq!(on(6, 1.0, 1.0, WireLay::Length(12.0 * (1.0 + 1e-12))), Ok(()));
    assert_eq!(on(6, 1.0, 1.0, WireLay::Angle(PI / 2.0)), Err("lay_angle"));
    assert_eq!(WireLayer::with_gap(6, 1.0, 1.0, 0.0).unwrap_err().quantity, "core_radius");
    assert_eq!(WireLayer::in_outer_radius(6, 3.0, 40.0, WireLay::Angle(0.1)).unwrap_err().quantity, "gap");
}

/// Flat: off by θ² cos²(π/n)/2 of the radius. Ellipse: by a fourth power of θ.
#[test]
fn order_of_the_formulas() {
    for n in 3..=12 {
        let off = |formula: FitFormula, theta: f64| {
            // wires that just touch: the formula's gap is its error
            let layer = WireLayer::without_core(n, 1.0, WireLay::Angle(theta)).unwrap();
            formula.gap(&layer) / 2.0
        };
        let cos = (PI / f64::from(n)).cos();
        let second = off(FitFormula::Flat, 0.01) / 1e-4;
        assert!((second - 0.5 * cos * cos).abs() < 1e-3, "{n}: {second}");
        let fall = off(FitFormula::Ellipse, 0.1) / off(FitFormula::Ellipse, 0.05);
        assert!((fall - 16.0).abs() < 0.5, "{n}: {fall}");
    }
    // two wires touch along a line up to 45 degrees, and all three know it
    let two = WireLayer::without_core(2, 1.0, WireLay::Angle(0.7)).unwrap();
    assert!(FitFormula::BOTH.iter().all(|formula| formula.gap(&two).abs() < 1e-15));
}

/// The ellipse formula against ellipses: sampled, the nearest point of one lies on the plane midway to the next.
#[test]
fn ellipses_that_touch() {
    for n in [3_u32, 4, 6, 11] {
        for lay in [20.0, 35.0, 80.0] {
            let r = 0.7;
            let layer = WireLayer::on_core(n, r, 1.0, WireLay::Length(lay)).unwrap();
            let radius = FitFormula::Ellipse.touching_radius(&layer).unwrap();
            let cos = (TAU * radius / lay).atan().cos();
            let (sin_half, cos_half) = (PI / f64::from(n)).sin_cos();
            let away = |t: f64| (radius + r * t.sin()) * sin_half - r / cos * t.cos() * cos_half;
            let least = (0..200_000).map(|i| away(TAU * f64::from(i) / 200_000.0)).fold(f64::MAX, f64::min);
            assert!(least.abs() < 1e-9, "n {n}, lay {lay}: {least}");
        }
    }
}

/// 1 + 6 + 12 + 18 of one wire: each layer lies on what the one below takes.
#[test]
fn layers_on_layers() {
    assert_eq!(WireStrand::on_core(None).unwrap().core_radius(), None);
    let mut strand = WireStrand::on_core(Some(1.0)).unwrap();
    assert_eq!(strand.core_radius(), Some(1.0));
    for (layers, wires) in [(1, 6), (2, 12), (3, 18)] {
        strand.lay(wires, 1.0, WireLay::Ratio(15.0)).unwrap();
        assert_eq!(strand.layers().len(), layers);
    }
    let mut below = 1.0;
    let mut area = PI;
    for layer in strand.layers() {
        assert_eq!(layer.core_radius(), below);
        below = layer.taken_outer_radius();
        area += layer.metal_area();
    }
    assert_eq!(strand.outer_radius(), below);
    assert!((strand.metal_area() - area).abs() < 1e-12);
    // the standard's fill factor: 37 sections across each wire over the circle round them
    assert!((strand.fill_factor() - 37.0 / (below * below)).abs() < 1e-15);
    // six on one alike overlap; twelve on seven, and eighteen on nineteen have room: 2R sin(π/12) is 2.07 wire diameters at R = 4
    let contacts: Vec<_> = strand.layers().iter().map(WireLayer::contact).collect();
    assert_eq!(contacts, [LayerContact::Neighbours, LayerContact::Core, LayerContact::Core]);
}
