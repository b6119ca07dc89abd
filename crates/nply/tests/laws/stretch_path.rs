//! Paths of strands that stretch: at rest all the way, over contacts that open and close, and the paper's where they hardly stretch.

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{
    Axial, Contacts, Data, End, ExtensiblePly, FormedLay, Grips, Load, Mark, Path, Route, Stability, StretchData,
    StretchPath, StretchStation, StretchingStrand, Support, Trace, Turning, Twist, WorkingCore,
};
use nply::{DomainError, Handedness};
use proptest::prelude::*;

use crate::config;
use crate::extensible::{Given, any_real};

/// The same kinds of data, moved by so much.
fn moved(data: StretchData, [twist, along, around]: [f64; 3]) -> StretchData {
    StretchData {
        twist: match data.twist {
            Twist::Pretwist(from) => Twist::Pretwist(from + twist),
            Twist::StrandTwist(from) => Twist::StrandTwist(from + twist),
        },
        grips: Grips {
            axial: match data.grips.axial {
                Axial::Force(from) => Axial::Force(from + along),
                Axial::Extension(from) => Axial::Extension((from + 0.3 * along).clamp(0.3, 1.2)),
            },
            turning: match data.grips.turning {
                Turning::Moment(from) => Turning::Moment(from + around),
                Turning::Rotation(from) => Turning::Rotation(from + 0.3 * around),
            },
        },
    }
}

fn loads(twist: f64, force: f64, moment: f64) -> StretchData {
    StretchData { twist: Twist::Pretwist(twist), grips: Load { force, moment }.into() }
}

fn marks(trace: &Trace<StretchStation>) -> Vec<Mark> {
    trace.events.iter().map(|event| event.mark).collect()
}

/// Whether the walk went on to an end, but where helices that parted are all but straight.
fn goes_on(trace: &Trace<StretchStation>) -> bool {
    let nearly_straight = |s: &StretchStation| s.state.angle().degrees() < 0.01;
    trace.end != End::Stalled || trace.stations.last().is_some_and(nearly_straight)
}

/// What a search without the path finds at a station's data.
fn found_there(given: &Given, path: &StretchPath, at: &StretchStation) -> bool {
    let data = path.data(at.along);
    // loads that stretch strands beyond what is looked at, at some other angle, are refused
    let Ok(states) = given.ply().states(data.twist, data.grips) else { return true };
    states.iter().any(|s| {
        s.handedness() == at.state.handedness()
            && s.support() == at.state.support()
            && (s.angle().radians() - at.state.angle().radians()).abs() < 1e-6
    })
}

proptest! {
    #![proptest_config(config(150))]

    /// Whatever changes, every state on the way is at rest: no small admissible change of shape lowers its energy, contacts push and do not
    /// overlap, what is held is held, and the search without a path finds the state.
    #[test]
    fn strands_are_at_rest_all_the_way(given in any_real(), by in [-0.5..0.5, -1.0..1.0, -1.0..1.0]) {
        let from = StretchData { twist: given.twist, grips: given.grips };
        let path = StretchPath::new(&given.ply(), from, moved(from, by)).unwrap();
        for start in path.starts().unwrap_or_default() {
            let trace = path.trace(&start, &Route::default()).unwrap();
            prop_assert!(goes_on(&trace), "{:?} {start:?}", marks(&trace));
            for (i, at) in trace.stations.iter().enumerate() {
                let state = &at.state;
                let size = 1e-9 * (1.0 + state.load().force.abs() + state.load().moment.abs());
                prop_assert!(state.interstrand_pressure() > -size && state.core_pressure() > -size, "{state:?}");
                // a radius is the quotient of what vanishes as strands straighten
                let lost = 1e-9 * state.radius_ratio() + 1e-11 / state.angle().sin();
                prop_assert!(state.neighbour_gap() > -lost && state.core_gap().is_none_or(|gap| gap > -lost), "{state:?}");
                let data = path.data(at.along);
                match data.grips.axial {
                    Axial::Force(force) => prop_assert_eq!(state.load().force, force),
                    Axial::Extension(extension) => prop_assert!((state.extension() - extension).abs() < 1e-12),
                }
                match data.grips.turning {
                    Turning::Moment(moment) => prop_assert_eq!(state.load().moment, moment),
                    Turning::Rotation(rotation) => prop_assert!((state.rotation() - rotation).abs() < 1e-12),
                }
                let straight = state.angle().degrees() < 0.5;
                let flat = state.angle().degrees() > 85.0;
                if !straight && !flat {
                    let (down, steep) = Given { twist: data.twist, ..given.clone() }.steepest(state);
                    prop_assert!(down > -1e-8 * steep, "{down:e} at {state:?}");
                }
                let verge = trace.events.iter().any(|event| event.before.abs_diff(i) <= 1);
                let inside = (-0.499..0.999).contains(&state.strain());
                if i % 10 == 3 && !verge && !straight && !flat && inside {
                    prop_assert!(found_there(&given, &path, at), "{at:?}");
                }
            }
        }
    }

    /// Contacts open where strands just stop pressing, folds lie where the ply answers without bound.
    #[test]
    fn events_lie_where_the_solvers_find_them(mut given in any_real(), by in -2.0..2.0) {
        given.grips.turning = Turning::Moment(0.3);
        given.grips.axial = Axial::Force(0.5);
        let from = StretchData { twist: given.twist, grips: given.grips };
        let path = StretchPath::new(&given.ply(), from, moved(from, [0.0, by, 0.0])).unwrap();
        for start in path.starts().unwrap_or_default() {
            let trace = path.trace(&start, &Route { window: (-1.0, 2.0), ..Route::default() }).unwrap();
            prop_assert!(goes_on(&trace), "{:?} {start:?}", marks(&trace));
            for event in &trace.events {
                let state = &event.station.state;
                let degrees = state.angle().degrees();
                match event.mark {
                    Mark::ContactChange(Support::Free) => {
                        let partings = given.ply().parting_at_moment(state.support(), given.twist, 0.3).unwrap();
                        let same = |s: &nply::mechanics::ExtensibleState| {
                            (s.load().force - state.load().force).abs() < 1e-8
                                && (s.angle().degrees() - degrees).abs() < 1e-5
                        };
                        prop_assert!(partings.iter().any(same) || degrees < 0.01, "{state:?} {partings:?}");
                    }
                    Mark::ContactChange(to) if state.support() == Support::Free => {
                        let gap = if to == Support::Core { state.core_gap().unwrap() } else { state.neighbour_gap() };
                        prop_assert!(gap.abs() < 1e-9, "{state:?}");
                    }
                    Mark::Fold => {
                        let corner = given.n == 2 && (degrees - 45.0).abs() < 1e-5;
                        let answers = state.flexibility().map_or(f64::INFINITY, |f| f.strain_by_force.abs());
                        prop_assert!(answers > 1e4 || corner, "{answers} {state:?}");
                    }
                    Mark::Diagonal => prop_assert!((degrees - 45.0).abs() < 1e-10),
                    _ => {}
                }
            }
        }
    }

    /// Strands that hardly stretch go the way of those that do not, and the same happens to them in the same places.
    #[test]
    fn stiff_strands_go_the_papers_way(
        n in 2..9_u32, gamma in 0.5..1.3, pretwist in -1.0..-0.1, f in 0.1..1.0, m in -1.0..1.0, df in -2.0..2.0, dm in -2.0..2.0,
    ) {
        let data = |load: Load| Data { stiffness_ratio: gamma, twist: Twist::Pretwist(pretwist), ends: load.into(), core_radius: None };
        let [from, to] = [[f, m], [f + df, m + dm]].map(|[force, moment]| Load { force, moment });
        let papers = Path::new(n, data(from), data(to), Contacts::Unilateral).unwrap();
        let ply = ExtensiblePly::new(n, StretchingStrand::new(gamma, 1e8, 0.3).unwrap()).unwrap();
        let ours = StretchPath::new(&ply, loads(pretwist, from.force, from.moment), loads(pretwist, to.force, to.moment)).unwrap();
        let starts = ours.starts().unwrap();
        for start in papers.starts().unwrap() {
            let near = |s: &&StretchStation| {
                s.state.handedness() == start.handedness && s.state.support() == start.support
                    && (s.state.angle().radians() - start.angle.radians()).abs() < 1e-5
            };
            let Some(same) = starts.iter().find(near) else { continue };
            let (paper, our) = (papers.trace(&start, &Route::default()).unwrap(), ours.trace(same, &Route::default()).unwrap());
            // where branches nearly meet, a little stretch decides which way it goes
            let tender = |event: &nply::mechanics::Event| event.station.angle.degrees() < 1.0 || event.station.angle.degrees() > 89.0;
            prop_assume!(!paper.events.iter().any(tender));
            prop_assert_eq!(our.end, paper.end);
            let told: Vec<Mark> = paper.events.iter().map(|event| event.mark).collect();
            prop_assert_eq!(marks(&our), told);
            for (a, b) in our.events.iter().zip(&paper.events) {
                prop_assert!((a.station.along - b.station.along).abs() < 1e-5, "{a:?} {b:?}");
                prop_assert!((a.station.state.angle().radians() - b.station.angle.radians()).abs() < 1e-3);
            }
        }
    }
}

/// A seven-wire strand, wires and king wire of one steel, the lay of the wires `preforming` laid in beforehand.
fn seven_wires(preforming: f64) -> ExtensiblePly {
    let lay = FormedLay {
        handedness: Handedness::Right,
        angle: HelicalAngle::new(0.25).unwrap(),
        radius_ratio: 2.1,
        preforming,
    };
    let king = WorkingCore::new(1.1, 4.0 * 1.1_f64.powi(2), 1.1_f64.powi(4) / 1.3, 0.3).unwrap();
    ExtensiblePly::new(6, StretchingStrand::solid_round(0.3).unwrap())
        .unwrap()
        .with_core(king)
        .unwrap()
        .formed_in(lay)
        .unwrap()
}

/// From tension to thrust: wires lift off the king wire, bird-caging, at the load at which they just stop pressing: wires that are not
/// wholly preformed while the strand is still pulled.
#[test]
fn a_strand_opens_where_its_wires_stop_pressing() {
    for preforming in [0.2, 0.5, 0.8] {
        let strand = seven_wires(preforming);
        let path = StretchPath::new(&strand, loads(0.0, 2.0, 0.0), loads(0.0, -0.3, 0.0)).unwrap();
        let start = path.starts().unwrap().into_iter().find(|s| s.state.support() == Support::Core).unwrap();
        let trace = path.trace(&start, &Route::default()).unwrap();
        let lifts = trace.events.iter().find(|e| e.mark == Mark::ContactChange(Support::Free)).unwrap();
        let verge = strand.parting_at_moment(Support::Core, Twist::Pretwist(0.0), 0.0).unwrap();
        let force = lifts.station.state.load().force;
        assert!(verge.iter().any(|s| (s.load().force - force).abs() < 1e-9), "{preforming}: {force} {verge:?}");
        assert!(force > 0.0);
        // from there on the cage opens
        let open = |s: &StretchStation| s.state.core_gap().unwrap();
        let behind = &trace.stations[lifts.before..];
        assert!(behind.iter().skip(1).all(|s| open(s) > 0.0), "{preforming}");
    }
}

/// Between clamps: length and rotation are what is asked for all the way, and the loads are those of a search at each place.
#[test]
fn clamped_ends_are_kept() {
    let strand = seven_wires(1.0);
    let lay = strand.formed().unwrap();
    let clamps = |strain: f64, turns: f64| StretchData {
        twist: Twist::Pretwist(0.0),
        grips: Grips {
            axial: Axial::Extension(lay.angle.cos() * (1.0 + strain)),
            turning: Turning::Rotation(lay.rotation() * turns),
        },
    };
    let path = StretchPath::new(&strand, clamps(0.01, 1.0), clamps(0.02, 1.05)).unwrap();
    let start = path.starts().unwrap().into_iter().find(|s| s.state.support() == Support::Core).unwrap();
    let trace = path.trace(&start, &Route::default()).unwrap();
    assert_eq!(trace.end, End::Arrival);
    let k = start.state.stiffness().unwrap();
    for at in &trace.stations {
        let data = path.data(at.along);
        let states = strand.states(data.twist, data.grips).unwrap();
        assert!(states.iter().any(|s| (s.load().force - at.state.load().force).abs() < 1e-9));
        assert_eq!(at.stability, Stability::Stable);
    }
    // and the force rises by about what the stiffness says
    let last = trace.stations.last().unwrap();
    let turned = (last.state.rotation() - start.state.rotation()) / start.state.extension();
    let strained = last.state.extension() / start.state.extension() - 1.0;
    let rise = last.state.load().force - start.state.load().force;
    assert!((rise / (k.axial * strained + k.coupling * turned) - 1.0).abs() < 0.05);
}

/// Turned at a length that is held, until no more turns fit in: the loads grow without bound, or strands stretch beyond what is looked at.
#[test]
fn clamps_turned_on_and_on_come_to_an_end() {
    let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3).unwrap()).unwrap();
    let clamps = |rotation: f64| StretchData {
        twist: Twist::Pretwist(-0.2),
        grips: Grips { axial: Axial::Extension(0.9), turning: Turning::Rotation(rotation) },
    };
    let path = StretchPath::new(&yarn, clamps(0.2), clamps(5.0)).unwrap();
    for start in path.starts().unwrap() {
        let trace = path.trace(&start, &Route::default()).unwrap();
        assert!(matches!(trace.end, End::UnboundedLoad | End::Overstretched), "{:?} {start:?}", trace.end);
        assert!(trace.stations.iter().all(|s| (s.state.extension() - 0.9).abs() < 1e-12));
        assert!(trace.stations.iter().all(|s| (-0.5 - 1e-9..=1.0 + 1e-9).contains(&s.state.strain())));
    }
}

/// Rods held straight, twisted, and let go end in a ply a little longer for it, whose strands are stretched by nothing but each other.
#[test]
fn letting_go_from_straight() {
    let yarn = ExtensiblePly::new(3, StretchingStrand::new(0.75, 1e9, 0.3).unwrap()).unwrap();
    // three-dimensional rods with frictionless contact
    for (pretwist, degrees) in [(-0.2, 12.1369), (-0.5, 23.2305), (-1.0, 30.6130), (-2.0, 34.5859)] {
        let held = 3.0 * 0.75 * pretwist;
        let path = StretchPath::new(&yarn, loads(pretwist, 0.0, held), loads(pretwist, 0.0, 0.0)).unwrap();
        let straight = path.starts().unwrap().into_iter().find(|s| s.state.angle().radians() == 0.0).unwrap();
        let trace = path.trace(&straight, &Route::default()).unwrap();
        let last = trace.stations.last().unwrap();
        assert_eq!((trace.end, last.stability), (End::Arrival, Stability::Stable));
        assert!(
            (last.state.angle().degrees() - degrees).abs() < 6e-5,
            "{} for {degrees}",
            last.state.angle().degrees()
        );
    }
}

/// Over straight strands to the other hand, past 45° and past a strain that was set.
#[test]
fn marks_on_the_way() {
    let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3).unwrap()).unwrap();
    let path = StretchPath::new(&yarn, loads(-0.2, 0.5, 0.0), loads(-0.2, 0.5, -4.0)).unwrap();
    let right = path
        .starts()
        .unwrap()
        .into_iter()
        .find(|s| s.state.handedness() == Handedness::Right && s.state.support() == Support::Neighbours);
    let trace = path.trace(&right.unwrap(), &Route { strain_limit: Some(0.2), ..Route::default() }).unwrap();
    let met = marks(&trace);
    assert!(met.contains(&Mark::Straight) && met.contains(&Mark::StrainLimit), "{met:?}");
    let straight = trace.events.iter().find(|e| e.mark == Mark::Straight).unwrap();
    // nothing but twist turns straight strands: m = nγφ̄a, whatever their stretch
    assert!((straight.station.state.load().moment - 3.0 / 1.3 * -0.2).abs() < 1e-10);
    let limit = trace.events.iter().find(|e| e.mark == Mark::StrainLimit).unwrap();
    let state = limit.station.state;
    let rho = state.thickness() * Contact::new(3, state.angle().radians()).unwrap().radius_ratio();
    let curvature = state.stretch() * state.angle().radians().sin().powi(2) / rho;
    assert!((state.strain().abs() + curvature - 0.2).abs() < 1e-10);
}

#[test]
fn paths_that_cannot_be_are_refused() {
    let named = |error: DomainError| error.quantity;
    let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3).unwrap()).unwrap();
    let stiff = ExtensiblePly::new(3, StretchingStrand::inextensible(0.75).unwrap()).unwrap();
    let (a, b) = (loads(-0.2, 0.0, 0.0), loads(-0.2, 1.0, 0.0));
    assert_eq!(named(StretchPath::new(&stiff, a, b).unwrap_err()), "axial_stiffness");
    let held = StretchData { grips: Grips { axial: Axial::Extension(0.9), ..a.grips }, ..a };
    assert_eq!(named(StretchPath::new(&yarn, a, held).unwrap_err()), "path");
    let twisted = StretchData { twist: Twist::StrandTwist(-0.2), ..a };
    assert_eq!(named(StretchPath::new(&yarn, a, twisted).unwrap_err()), "path");
    assert_eq!(named(StretchPath::new(&yarn, a, loads(f64::NAN, 0.0, 0.0)).unwrap_err()), "twist");
    let path = StretchPath::new(&yarn, a, b).unwrap();
    let start = path.starts().unwrap()[0];
    let nan = Route { strain_limit: Some(f64::NAN), ..Route::default() };
    assert_eq!(named(path.trace(&start, &nan).unwrap_err()), "strain_limit");
}
