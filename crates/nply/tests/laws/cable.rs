//! Cables: one layer is the ply of stretching strands, layers press as energy says, shares add up, matrices are symmetric slopes.

use std::f64::consts::TAU;

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle, WireLay, WireLayer};
use nply::mechanics::{
    Axial, Cable, CableGrips, CableState, ExtensiblePly, FormedLay, Grips, Layer, LayerSupport, Rod, StretchingStrand,
    Support, Turning, Twist, WorkingCore,
};
use proptest::prelude::*;

use crate::{config, hand};

fn clamped(strain: f64, turning: f64) -> CableGrips {
    CableGrips::Clamped { strain, turning }
}

/// One to three layers of solid round wires of sizes and lays at random, on a core.
fn any_cable() -> impl Strategy<Value = (f64, Vec<Layer>)> {
    let layer = (0.3..1.05, 0.5..1.5, hand(), 6.0..30.0, 0.0..=1.0, 0.0..0.45);
    (0.5..2.0, prop::collection::vec(layer, 1..=3)).prop_map(|(core, layers)| {
        let mut below: f64 = core;
        let layers = layers.into_iter().map(|(fill, radius, handedness, ratio, preforming, nu)| {
            // as many as would fit side by side on what is below, straight, or some less, or one too many
            let most = std::f64::consts::PI / f64::asin(radius / (below + radius));
            let strands = f64::max(f64::floor(fill * most), 2.0) as u32;
            below += 2.0 * radius;
            let rod = Rod::solid_round(radius, 100.0, nu).unwrap();
            Layer { strands, rod, handedness, lay: WireLay::Length(ratio * 2.0 * below), preforming, pretwist: 0.0 }
        });
        let layers: Vec<Layer> = layers.collect();
        (core, layers)
    })
}

/// Force and moment of core and layers together.
fn carried(state: &CableState) -> [f64; 2] {
    let sum = |of: fn(&nply::mechanics::LayerState) -> f64| state.layers().iter().map(of).sum::<f64>();
    [state.core_force().unwrap() + sum(|l| l.force), state.core_moment().unwrap() + sum(|l| l.moment)]
}

fn made(core: f64, layers: &[Layer]) -> Option<Cable> {
    Cable::new(Some(Rod::solid_round(core, 120.0, 0.3).unwrap()), layers).ok()
}

proptest! {
    #![proptest_config(config(200))]

    /// Force and moment are the slopes of the energy, the matrix that of the loads; shares of core and layers add up to the loads.
    #[test]
    fn slopes_and_shares((core, layers) in any_cable(), strain in -0.003..0.01, turning in -0.003..0.003) {
        let Some(cable) = made(core, &layers) else { return Ok(()) };
        let Ok(state) = cable.loaded(clamped(strain, turning)) else { return Ok(()) };
        let h = 1e-6;
        let at = |de: f64, dw: f64| cable.loaded(clamped(strain + de, turning + dw)).unwrap();
        let (a, b, c, d) = (at(h, 0.0), at(-h, 0.0), at(0.0, h), at(0.0, -h));
        let regime = |s: &CableState| s.layers().iter().map(|l| l.support).collect::<Vec<_>>();
        prop_assume!([&a, &b, &c, &d].iter().all(|s| regime(s) == regime(&state)));
        let slope = |x: f64, y: f64| (x - y) / (2.0 * h);
        if let Some(k) = state.stiffness() {
            let size = k.axial + k.torsional;
            for (got, want) in [
                (k.axial, slope(a.force(), b.force())),
                (k.coupling, slope(a.moment(), b.moment())),
                (k.coupling, slope(c.force(), d.force())),
                (k.torsional, slope(c.moment(), d.moment())),
            ] {
                prop_assert!((got - want).abs() < 1e-5 * size, "{got} {want}");
            }
        }
        let [force, moment] = carried(&state);
        let size = 1e-11 * (1.0 + state.force().abs() + state.moment().abs()) * cable.wire_section_area() * 100.0;
        prop_assert!((force - state.force()).abs() < size && (moment - state.moment()).abs() < size);
    }

    /// What the first layer presses with is what it takes to swell the core: the slope of the energy by the core's radius, which the
    /// forces found on a slightly thicker core integrate.
    #[test]
    fn layers_press_as_the_energy_says((core, layers) in any_cable(), strain in 0.0..0.01) {
        // layers made on one core, then the core's radius changed: its Poisson's ratio does that at a strain of its own
        let Some(_) = made(core, &layers) else { return Ok(()) };
        // a core that is but an outline: all stiffness but the least taken away
        let cored = |nu: f64| Cable::new(Some(Rod::new(core, 1e-9, 1.0, 1.0, nu).unwrap()), &layers).unwrap();
        let with = |nu: f64| cored(nu).loaded(clamped(strain, 0.0)).unwrap();
        let (state, thick, thin) = (with(0.2), with(0.2 - 1e-4), with(0.2 + 1e-4));
        prop_assume!(strain > 1e-3);
        // force at given ν differs by Q dr/dε, its integral over the strain by Q dr: the work done on the way, by Simpson's rule, where every
        // layer lies on what is below all the way
        let steps = 200;
        let work = |nu: f64| -> Option<f64> {
            let cable = cored(nu);
            let mut sum = 0.0;
            for i in 0..=steps {
                let weight = if i == 0 || i == steps { 1.0 } else if i % 2 == 1 { 4.0 } else { 2.0 };
                let there = cable.loaded(clamped(strain * f64::from(i) / f64::from(steps), 0.0)).ok()?;
                let below = there.layers().iter().all(|layer| layer.support == LayerSupport::Below);
                sum += weight * below.then(|| there.force())?;
            }
            Some(sum * strain / f64::from(steps) / 3.0)
        };
        let (Some(more), Some(less)) = (work(0.2 - 1e-4), work(0.2 + 1e-4)) else { return Ok(()) };
        let radius = |s: &CableState| s.core_radius().unwrap();
        let slope = (more - less) / (radius(&thick) - radius(&thin));
        let pressed = state.layers()[0].pressure_below * f64::from(layers[0].strands);
        prop_assert!((slope - pressed).abs() < 1e-4 * (pressed.abs() + 1e-2 * state.force().abs()), "{slope} {pressed}");
    }

    /// The loads of any state, given again, lead back to it.
    #[test]
    fn loads_lead_back((core, layers) in any_cable(), pull in -0.0005..0.003, turning in -0.002..0.002) {
        let Some(cable) = made(core, &layers) else { return Ok(()) };
        let Ok(state) = cable.loaded(clamped(pull, turning)) else { return Ok(()) };
        let Ok(laid) = cable.laid() else { return Ok(()) };
        let regime = |s: &CableState| s.layers().iter().map(|l| l.support).collect::<Vec<_>>();
        prop_assume!(state.stiffness().is_some() && regime(&state) == regime(&laid));
        let again = cable.loaded(CableGrips::Loads { force: state.force(), moment: state.moment() });
        // where contacts change there may be a second state under the same loads
        let Ok(again) = again else { return Err(TestCaseError::fail("no state found under its own loads")) };
        if regime(&again) == regime(&state) {
            prop_assert!((again.strain() - pull).abs() < 1e-9 && (again.turning() - turning).abs() < 1e-9);
        }
    }

    /// The mirror image of a cable: the same but for the sign of coupling and moment.
    #[test]
    fn mirror_images((core, layers) in any_cable(), strain in 0.0..0.01) {
        let Some(cable) = made(core, &layers) else { return Ok(()) };
        let mirrored: Vec<Layer> = layers.iter().map(|l| Layer { handedness: l.handedness.opposite(), ..*l }).collect();
        let (a, b) = (cable.loaded(clamped(strain, 0.001)), made(core, &mirrored).unwrap().loaded(clamped(strain, -0.001)));
        let (Ok(a), Ok(b)) = (a, b) else { return Ok(()) };
        prop_assert!((a.force() - b.force()).abs() < 1e-10 * (1.0 + a.force().abs()));
        prop_assert!((a.moment() + b.moment()).abs() < 1e-10 * (1.0 + a.moment().abs()));
    }

    /// What is given is met: core and layers together carry the loads.
    #[test]
    fn loads_are_met((core, layers) in any_cable(), pull in 0.0..0.005) {
        let Some(cable) = made(core, &layers) else { return Ok(()) };
        let force = pull * 100.0 * cable.wire_section_area();
        let ends = [CableGrips::Turned { force, turning: 0.0 }, CableGrips::Loads { force, moment: 0.0 }];
        for (free, grips) in ends.into_iter().enumerate() {
            match cable.loaded(grips) {
                Ok(state) => {
                    let [carried, turned] = carried(&state);
                    prop_assert!((carried - force).abs() < 1e-9 * (1.0 + force));
                    prop_assert!(free == 0 || turned.abs() < 1e-8 * (1.0 + force));
                    // and they are told as they were given, to the last digit
                    prop_assert!(state.force() == force && (free == 0 || state.moment() == 0.0));
                }
                Err(error) => prop_assert!(error.allowed.starts_with("such that a state near"), "{error}"),
            }
        }
    }

    /// A cable of preformed wires as laid holds nothing: not a force, not a strain, not a pressure that is left of rounding; nor does one
    /// under no load.
    #[test]
    fn nothing_is_nothing((core, layers) in any_cable()) {
        let preformed: Vec<Layer> = layers.iter().map(|layer| Layer { preforming: 1.0, ..*layer }).collect();
        let Some(cable) = made(core, &preformed) else { return Ok(()) };
        let free = CableGrips::Loads { force: 0.0, moment: 0.0 };
        for state in [cable.laid().unwrap(), cable.loaded(free).unwrap()] {
            prop_assert!(state.force() == 0.0 && state.moment() == 0.0 && state.strain() == 0.0 && state.turning() == 0.0);
            for layer in state.layers() {
                let all = [
                    layer.strain, layer.bending_strain, layer.twist_strain, layer.force, layer.moment, layer.pressure_below,
                    layer.interstrand_pressure,
                ];
                prop_assert!(all.iter().all(|value| *value == 0.0), "{all:?}");
            }
        }
    }
}

/// One layer of solid round wires on a core, or touching each other, is the ply of stretching strands, found by another way: loads,
/// pressures and matrix.
#[test]
fn one_layer_is_a_ply() {
    for (n, core, lay_length, preforming) in
        [(6, 1.1, 40.0, 1.0), (6, 1.1, 25.0, 0.5), (5, 1.4, 30.0, 0.0), (6, 0.5, 30.0, 1.0)]
    {
        for handedness in Handedness::BOTH {
            let (nu, nu_core) = (0.3, 0.25);
            let wire = Rod::solid_round(1.0, 4.0 / std::f64::consts::PI, nu).unwrap(); // B = 1
            let king = Rod::solid_round(core, 3.0 / std::f64::consts::PI, nu_core).unwrap();
            let layer = Layer {
                strands: n,
                rod: wire,
                handedness,
                lay: WireLay::Length(lay_length),
                preforming,
                pretwist: 0.0,
            };
            let cable = Cable::new(Some(king), &[layer]).unwrap();
            let (strain, turning) = (0.004, 0.0005);
            let state = cable.loaded(clamped(strain, turning)).unwrap();
            let one = state.layers()[0];

            let laid = cable.laid().unwrap().layers()[0];
            let formed = FormedLay { handedness, angle: laid.angle, radius_ratio: laid.radius, preforming };
            let strand = StretchingStrand::solid_round(nu).unwrap();
            let work = WorkingCore::new(core, king.axial_stiffness(), king.torsional_stiffness(), nu_core).unwrap();
            let ply = ExtensiblePly::new(n, strand).unwrap().with_core(work).unwrap().formed_in(formed).unwrap();
            let c0 = laid.angle.cos();
            let grips = Grips {
                axial: Axial::Extension(c0 * (1.0 + strain)),
                turning: Turning::Rotation(formed.rotation() + c0 * turning),
            };
            let support = match one.support {
                LayerSupport::Below => Support::Core,
                LayerSupport::Neighbours => Support::Neighbours,
                LayerSupport::Both => Support::Both,
            };
            let states = ply.states(Twist::Pretwist(0.0), grips).unwrap();
            let twin = states.iter().find(|s| s.support() == support).unwrap();
            let close =
                |a: f64, b: f64, what: &str| assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{what} n {n}: {a} {b}");
            close(one.angle.radians(), twin.angle().radians(), "angle");
            close(one.radius, twin.radius_ratio(), "radius");
            close(state.force(), twin.load().force, "force");
            close(state.moment(), twin.load().moment, "moment");
            // per cable length against per rod length
            close(one.pressure_below * c0, twin.core_pressure(), "pressure on the core");
            close(one.interstrand_pressure * c0, twin.interstrand_pressure(), "pressure between neighbours");
            // in units of E: 4/π of these wires
            let in_modulus = |p: Option<f64>| p.map(|p| p * std::f64::consts::FRAC_PI_4);
            assert_eq!(one.neighbour_hertz_pressure.is_some(), twin.neighbour_hertz_pressure().is_some());
            if let (Some(a), Some(b)) = (in_modulus(one.neighbour_hertz_pressure), twin.neighbour_hertz_pressure()) {
                close(a, b, "Hertz");
            }
            close(one.core_line_load.unwrap_or(0.0), twin.core_line_load(), "line load");
            let (k, own) = (state.stiffness().unwrap(), twin.stiffness().unwrap());
            close(k.axial, own.axial / (1.0 + strain), "EA"); // per present length
            close(k.coupling, own.coupling / (1.0 + strain), "coupling");
            close(k.torsional, own.torsional / (1.0 + strain), "GJ");
        }
    }
}

/// Two layers of opposite hand can be balanced: with turns that make the torques equal and opposite a pull asks for no moment.
#[test]
fn opposite_layers_balance() {
    let wire = Rod::solid_round(1.0, 100.0, 0.0).unwrap();
    let torque = |lay_length: f64| {
        let inner = Layer {
            strands: 6,
            rod: wire,
            handedness: Handedness::Left,
            lay: WireLay::Length(60.0),
            preforming: 1.0,
            pretwist: 0.0,
        };
        let outer = Layer {
            strands: 12,
            rod: wire,
            handedness: Handedness::Right,
            lay: WireLay::Length(lay_length),
            preforming: 1.0,
            pretwist: 0.0,
        };
        let cable = Cable::new(Some(Rod::solid_round(1.05, 100.0, 0.0).unwrap()), &[inner, outer]).unwrap();
        cable.laid().unwrap().torque_factor().unwrap()
    };
    let (mut short, mut long) = (60.0, 3000.0);
    assert!(torque(short) > 0.0 && torque(long) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (short + long);
        if torque(middle) > 0.0 { short = middle } else { long = middle }
    }
    assert!(torque(short).abs() < 1e-12);
    // small angles: torque is n r tan θ times EA cos³θ, so that the outer angle is about 6·R₁ tan θ₁/(12·R₂)
    let (inner, outer): (f64, f64) = (TAU * 2.05 / 60.0, TAU * 4.05 / short);
    assert!((outer / (6.0 * 2.05 * inner / (12.0 * 4.05)) - 1.0).abs() < 0.1);
}

/// A strand as one rod: straight, it is what it is made of; laid into a rope of ordinary lay it carries the torque of its own wires against that
/// of the rope's lay.
#[test]
fn a_strand_is_a_rod() {
    let wire = Rod::solid_round(0.5, 200e3, 0.3).unwrap();
    let king = Rod::solid_round(0.53, 200e3, 0.3).unwrap();
    let strand = |handedness| {
        let six =
            Layer { strands: 6, rod: wire, handedness, lay: WireLay::Length(25.0), preforming: 1.0, pretwist: 0.0 };
        Cable::new(Some(king), &[six]).unwrap()
    };
    let rod = strand(Handedness::Left).as_rod().unwrap();
    let k = strand(Handedness::Left).laid().unwrap().stiffness().unwrap();
    assert!(
        (rod.axial_stiffness() - k.axial).abs() < 1e-9 * k.axial
            && (rod.coupling() - k.coupling).abs() < 1e-9 * k.axial
    );
    assert!(rod.coupling() < 0.0 && (rod.radius() - 1.53).abs() < 1e-12);
    let rope = |hand| {
        let outer = Layer {
            strands: 6,
            rod: strand(hand).as_rod().unwrap(),
            handedness: Handedness::Right,
            lay: WireLay::Length(70.0),
            preforming: 1.0,
            pretwist: 0.0,
        };
        Cable::new(Some(Rod::new(1.7, 1e3, 1e3, 1e3, 0.3).unwrap()), &[outer]).unwrap().laid().unwrap()
    };
    let (ordinary, lang) = (rope(Handedness::Left), rope(Handedness::Right));
    // Lang's lay turns harder under a pull than ordinary lay, as rope makers know
    assert!(lang.torque_factor() > ordinary.torque_factor() && ordinary.torque_factor().unwrap() > 0.0);
}

/// A layer too crowded for its core rides on its neighbours; a lay that no wire can take is refused.
#[test]
fn regimes_and_refusals() {
    let wire = Rod::solid_round(1.0, 100.0, 0.3).unwrap();
    let layer = |lay_length: f64| Layer {
        strands: 6,
        rod: wire,
        handedness: Handedness::Right,
        lay: WireLay::Length(lay_length),
        preforming: 1.0,
        pretwist: 0.0,
    };
    let on = |core: f64, lay_length: f64| {
        Cable::new(Some(Rod::solid_round(core, 100.0, 0.3).unwrap()), &[layer(lay_length)]).unwrap().laid().unwrap()
    };
    let at = HelicalAngle::new(17.44_f64.to_radians()).unwrap();
    let lay = TAU * 2.0 / at.tan();
    assert_eq!(on(1.0, lay).layers()[0].support, LayerSupport::Neighbours); // R = 2r overlaps at 17.44°
    assert_eq!(on(1.1, lay).layers()[0].support, LayerSupport::Below);
    assert!(on(1.1, lay).layers()[0].gap > 0.0);
    assert!(Cable::new(None, &[layer(11.9)]).is_err()); // shorter than six flat rings
    assert!(Cable::new(None, &[]).is_err());
    assert!(on(1.1, lay).cable().loaded(CableGrips::Turned { force: f64::NAN, turning: 0.0 }).is_err());
    assert!(on(1.1, lay).cable().loaded(CableGrips::Turned { force: 1e9, turning: 0.0 }).is_err());
    assert!(Layer { preforming: 1.5, ..layer(lay) }.preforming > 1.0);
    assert!(Cable::new(None, &[Layer { preforming: 1.5, ..layer(lay) }]).is_err());
}

/// A lay a little longer than that at which n wires of r = 1 on this core touch each other.
fn close_lay(n: u32, core: f64) -> WireLay {
    WireLay::Length(1.02 * Contact::from_radius_ratio(n, 1.0 + core).unwrap().lay_length())
}

/// Where wires lie on their core and on each other, both push, and no strain or turning nearby is held by less: against every direction the loads
/// there do no work. Wires that were not preformed, wound up
/// as they are pulled.
#[test]
fn shared_loads_hold_the_least_energy() {
    let mut shared = [0; 2];
    let wire = |nu| Rod::solid_round(1.0, 100.0, nu).unwrap();
    for (king, nu, two) in [(1.1, 0.3, false), (1.2, 0.2, false), (1.2, 0.2, true)] {
        let layer = |strands, handedness, lay| Layer {
            strands,
            rod: wire(nu),
            handedness,
            lay,
            preforming: 0.0,
            pretwist: 0.0,
        };
        // laid with little room
        let mut layers = vec![layer(6, Handedness::Left, close_lay(6, king))];
        if two {
            layers.push(layer(12, Handedness::Right, close_lay(12, 2.0 + king)));
        }
        let Ok(cable) = Cable::new(Some(Rod::solid_round(king, 100.0, 0.45).unwrap()), &layers) else {
            panic!("{king}")
        };
        let ea = 100.0 * cable.wire_section_area();
        for (i, turned) in (0..320).flat_map(|i| [(i, false), (i, true)]) {
            let force = ea * 1e-3 * f64::from(i);
            let moment = if two { -0.3 } else { -1.0 } * force;
            let grips = if turned {
                CableGrips::Turned { force, turning: -0.012 }
            } else {
                CableGrips::Loads { force, moment }
            };
            let state = match cable.loaded(grips) {
                Ok(state) if state.shares() => state,
                Ok(_) => continue,
                Err(error) => panic!("{error} at {king} {nu} {force} {turned}"),
            };
            shared[usize::from(two)] += 1;
            let both: Vec<_> = state.layers().iter().filter(|l| l.support == LayerSupport::Both).collect();
            assert!(both.iter().all(|l| l.pressure_below >= 0.0 && l.interstrand_pressure >= 0.0));
            let [pulls, turns] = carried(&state);
            assert!((pulls - force).abs() < 1e-9 * ea, "{pulls} {force}");
            assert!(turned || (turns - moment).abs() < 1e-9 * ea, "{turns} {moment}");
            for k in 0..16 {
                let (s, c) = (f64::from(k) * TAU / 16.0).sin_cos();
                let h = 1e-6;
                let there = cable.loaded(clamped(state.strain() + h * c, state.turning() + h * s)).unwrap();
                let work = (there.force() - state.force()) * c + (there.moment() - state.moment()) * s;
                assert!(work > 0.0, "{work} towards {k} at {king} {force} {turned}");
            }
        }
    }
    assert!(shared[0] > 10 && shared[1] > 0, "{shared:?}");
}

/// The same loads shared in a single layer are those of the ply of stretching strands on neighbours and core, found by another way.
#[test]
fn one_layer_that_shares_is_a_ply() {
    let mut met = 0;
    let (nu, nu_core, core) = (0.2, 0.45, 1.2);
    let king = Rod::solid_round(core, 3.0 / std::f64::consts::PI, nu_core).unwrap();
    let handedness = Handedness::Left;
    let layer = Layer {
        strands: 6,
        rod: Rod::solid_round(1.0, 4.0 / std::f64::consts::PI, nu).unwrap(), // B = 1
        handedness,
        lay: close_lay(6, core),
        preforming: 0.0,
        pretwist: 0.0,
    };
    let cable = Cable::new(Some(king), &[layer]).unwrap();
    let laid = cable.laid().unwrap().layers()[0];
    let formed = FormedLay { handedness, angle: laid.angle, radius_ratio: laid.radius, preforming: 0.0 };
    let work = WorkingCore::new(core, king.axial_stiffness(), king.torsional_stiffness(), nu_core).unwrap();
    let ply = ExtensiblePly::new(6, StretchingStrand::solid_round(nu).unwrap()).unwrap();
    let ply = ply.with_core(work).unwrap().formed_in(formed).unwrap();
    for i in 0..100 {
        let (force, moment) = (0.05 * f64::from(i), -0.05 * f64::from(i));
        let Ok(state) = cable.loaded(CableGrips::Loads { force, moment }) else { panic!("{force}") };
        if !state.shares() {
            continue;
        }
        met += 1;
        let grips = Grips { axial: Axial::Force(force), turning: Turning::Moment(moment) };
        let states = ply.states(Twist::Pretwist(0.0), grips).unwrap();
        let twin = states.iter().find(|s| s.support() == Support::Both && s.handedness() == handedness).unwrap();
        let one = state.layers()[0];
        let close =
            |a: f64, b: f64, what: &str| assert!((a - b).abs() < 1e-8 * (1.0 + b.abs()), "{what} at {force}: {a} {b}");
        close(one.angle.radians(), twin.angle().radians(), "angle");
        close(one.strain, twin.strain(), "strain");
        close(one.pressure_below * laid.angle.cos(), twin.core_pressure(), "pressure on the core");
        close(one.interstrand_pressure * laid.angle.cos(), twin.interstrand_pressure(), "pressure between neighbours");
    }
    assert!(met > 3, "{met}");
}

/// A lay at which the torque factor is as wanted fits where the wires leave a gap on what is below, told by their distance in space alone.
#[test]
fn a_balanced_lay_says_whether_it_fits() {
    let wire = |radius: f64| Rod::solid_round(radius, 200e3, 0.3).unwrap();
    let layer = |strands, handedness, lay_length| Layer {
        strands,
        rod: wire(1.0),
        handedness,
        lay: WireLay::Length(lay_length),
        preforming: 1.0,
        pretwist: 0.0,
    };
    let inner = layer(6, Handedness::Left, 60.0);
    let cable = Cable::new(Some(wire(1.05)), &[inner, layer(12, Handedness::Right, 110.0)]).unwrap();
    let lays = cable.lays_for_torque_factor(1, 0.0).unwrap();
    assert!(lays.iter().any(|lay| lay.fits) && lays.iter().any(|lay| !lay.fits), "{lays:?}");
    for lay in &lays {
        assert!(lay.laid.torque_factor().unwrap().abs() < 1e-12);
        let drawn = WireLayer::on_core(12, 1.0, 3.05, WireLay::Length(lay.lay_length)).unwrap();
        assert_eq!(lay.fits, drawn.gap() >= 0.0, "{}", lay.lay_length);
        assert!(lay.fits == (lay.laid.layers()[1].radius < 4.05 + 1e-9));
    }
}

/// Where rods resist nothing but stretch and keep their thickness, a layer's force is n T cos θ; a strand's tension and twist in a rope hold the
/// strand alone in the same strain.
#[test]
fn tension_of_one_rod() {
    let string = Rod::new(1.0, 100.0, 1e-12, 1e-12, 0.0).unwrap();
    let six = |rod, handedness, lay| Layer {
        strands: 6,
        rod,
        handedness,
        lay: WireLay::Length(lay),
        preforming: 1.0,
        pretwist: 0.0,
    };
    let cable = Cable::new(Some(Rod::new(1.1, 1.0, 1.0, 1.0, 0.0).unwrap()), &[six(string, Handedness::Left, 60.0)]);
    let state = cable.unwrap().loaded(clamped(0.004, 0.01)).unwrap();
    let layer = state.layers()[0];
    assert_eq!(layer.support, LayerSupport::Below);
    assert!((6.0 * layer.tension() * layer.angle.cos() / layer.force - 1.0).abs() < 1e-9);

    let wire = Rod::solid_round(0.5, 200e3, 0.3).unwrap();
    let strand = Cable::new(Some(Rod::solid_round(0.53, 200e3, 0.3).unwrap()), &[six(wire, Handedness::Left, 25.0)]);
    let strand = strand.unwrap();
    let rod = strand.as_rod().unwrap();
    let core = Rod::new(1.7, 1e3, 1e3, 1e3, 0.0).unwrap();
    let rope = Cable::new(Some(core), &[six(rod, Handedness::Right, 70.0)]).unwrap();
    let small = rope.loaded(clamped(1e-5, -1e-5)).unwrap().layers()[0];
    let alone = CableGrips::Turned { force: small.tension(), turning: small.twist() };
    let alone = strand.loaded(alone).unwrap();
    assert!((alone.strain() / small.strain - 1.0).abs() < 1e-4, "{} {}", alone.strain(), small.strain);
    assert!(small.twist() != 0.0);
}

/// How much a core gives against the same by hand, for strings on it: p from T κ, the core's radius from Lamé (plane strain), and no more.
#[test]
fn what_a_soft_core_gives() {
    let (n, lay, r, core, axial) = (6.0, 75.0, 1.9, 2.1, 1.5e6);
    let layer = Layer {
        strands: 6,
        rod: Rod::new(r, axial, 1e-6, 1e-6, 0.0).unwrap(),
        handedness: Handedness::Right,
        lay: WireLay::Length(lay),
        preforming: 1.0,
        pretwist: 0.0,
    };
    let on = |radius: f64, modulus: f64, nu: f64| {
        Cable::new(Some(Rod::solid_round(radius, modulus, nu).unwrap()), &[layer]).unwrap()
    };
    let radius = r + core;
    let tan: f64 = TAU * radius / lay;
    let (cos2, sin2) = (1.0 / (1.0 + tan * tan), tan * tan / (1.0 + tan * tan));
    let by_hand = |modulus: f64, nu: f64| {
        // per strain of the cable, the core thinning as it is stretched
        let tension = axial * (cos2 - nu * core / radius * sin2);
        // Tκ per rod length, which is 1/cos θ per cable length
        let pressure = n * tension * sin2 / radius / cos2.sqrt() / (TAU * core);
        (1.0 + nu) * (1.0 - 2.0 * nu) * pressure / modulus * core / radius * tan * tan
    };
    for (modulus, nu) in [(500.0, 0.0), (1500.0, 0.0), (500.0, 0.3)] {
        let give = on(core, modulus, nu).core_give().unwrap();
        assert!((give / by_hand(modulus, nu) - 1.0).abs() < 1e-4, "{give} {}", by_hand(modulus, nu));
    }
    assert!(on(core, 500.0, 0.0).core_give().unwrap() > 1.0);
    // strands that carry each other do not lie on it
    assert_eq!(on(1.0, 1.0, 0.0).core_give(), None);
}

/// What a core of fibre is left out of, and how strengths add up: by hand.
#[test]
fn metallic_section_and_breaking_load() {
    let wire =
        |radius: f64, strength: f64| Rod::solid_round(radius, 200e3, 0.3).unwrap().of_strength(strength).unwrap();
    let six = |rod, lay| Layer {
        strands: 6,
        rod,
        handedness: Handedness::Left,
        lay: WireLay::Length(lay),
        preforming: 1.0,
        pretwist: 0.0,
    };
    let strand = Cable::new(Some(wire(0.65, 1770.0)), &[six(wire(0.625, 1960.0), 32.0)]).unwrap();
    let pi = std::f64::consts::PI;
    let (area, load) =
        (pi * (0.65 * 0.65 + 6.0 * 0.625 * 0.625), pi * (0.65 * 0.65 * 1770.0 + 6.0 * 0.625 * 0.625 * 1960.0));
    let fibre = Rod::solid_round(2.1, 500.0, 0.0).unwrap();
    let rope = |core| Cable::new(Some(core), &[six(strand.as_rod().unwrap(), 75.0)]).unwrap();
    let on_fibre = rope(fibre.uncounted());
    assert!((on_fibre.wire_section_area() / (6.0 * area) - 1.0).abs() < 1e-12);
    assert!((on_fibre.metallic_breaking_load().unwrap() / (6.0 * load) - 1.0).abs() < 1e-12);
    // a core that counts, of no known strength
    assert_eq!(rope(fibre).metallic_breaking_load(), None);
}
