//! Paths: what the tracer meets on its way is what the solvers find without it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::disallowed_methods)]

mod common;

use common::table;
use nply::Handedness;
use nply::geometry::{HelicalAngle, SpecialLays};
use nply::mechanics::{
    Balance, Contacts, Data, End, Ends, Load, Mark, Path, Ply, Route, Stability, Station, Support, Trace, Twist,
};
use proptest::prelude::*;

fn data(gamma: f64, pretwist: f64, ends: impl Into<Ends>) -> Data {
    Data { stiffness_ratio: gamma, twist: Twist::Pretwist(pretwist), ends: ends.into(), core_radius: None }
}

fn loads(force: f64, moment: f64) -> Load {
    Load { force, moment }
}

/// The start of given hand whose angle is nearest to a given one.
fn start_near(path: &Path, hand: Handedness, angle: f64) -> Option<Station> {
    let mine = path.starts().unwrap().into_iter().filter(|s| s.handedness == hand);
    mine.min_by(|a, b| (a.angle.radians() - angle).abs().total_cmp(&(b.angle.radians() - angle).abs()))
}

fn marks(trace: &Trace) -> Vec<Mark> {
    trace.events.iter().map(|event| event.mark).collect()
}

/// Every root of the golden table is reached from another state: the ply at another angle, held there by another moment, whose moment
/// then goes to that of the table.
#[test]
fn every_state_is_reached_from_another() {
    let mut reached = 0;
    for name in ["loaded_plies", "loaded_plies_more"] {
        for row in table(name) {
            let (gamma, pretwist) = (row.number("gamma"), row.number("pretwist"));
            let (f, m, degrees) = (row.number("f"), row.number("m"), row.number("theta_deg"));
            let hand = if row.number("handedness") > 0.0 { Handedness::Right } else { Handedness::Left };
            let balance = if row.text("balance") == "radial" { Balance::Radial } else { Balance::Contact };
            let ply = Ply::with_balance(row.strands(), gamma, balance).unwrap();
            let arrives = |share: f64| {
                // nearer to straight, or nearer to flat, by a share of what is left
                let other = if share > 0.0 { degrees * (1.0 - share) } else { degrees - share * (90.0 - degrees) };
                let angle = HelicalAngle::new(other.to_radians()).unwrap();
                let held = ply.moment_at(angle, hand, Twist::Pretwist(pretwist), f).unwrap().load().moment;
                let from = data(gamma, pretwist, loads(f, held));
                let path = Path::new(row.strands(), from, data(gamma, pretwist, loads(f, m)), Contacts::Kept(balance))
                    .unwrap();
                let start = start_near(&path, hand, angle.radians()).unwrap();
                if (start.angle.degrees() - other).abs() > 1e-6 {
                    return false; // near a fold the angle is lost in the moment's rounding
                }
                let route = Route { stop_at_arrival: false, window: (-1.0, 2.0), ..Route::default() };
                let trace = path.trace(&start, &route).unwrap();
                trace.events.iter().any(|event| {
                    let station = &event.station;
                    event.mark == Mark::Arrival
                        && station.handedness == hand
                        && (station.angle.degrees() - degrees).abs() < 1e-7
                })
            };
            assert!(
                [0.5, 0.2, -0.2, 0.05, -0.05, 0.01, -0.01].into_iter().any(arrives),
                "n {} {gamma} {pretwist} f {f} m {m} at {degrees}",
                row.strands()
            );
            reached += 1;
        }
    }
    assert!(reached > 250, "{reached}");
}

/// Rods held straight, twisted, and let go: the moment falls from m = nγφ̄a to nothing, and the ply ends where the simulated one
/// does (three-dimensional rods with frictionless contact: 12.1369°, 23.2305°, 30.6130°, 34.5859°).
#[test]
fn letting_go_ends_in_the_simulated_ply() {
    for (pretwist, degrees) in [(-0.2, 12.1369), (-0.5, 23.2305), (-1.0, 30.6130), (-2.0, 34.5859)] {
        let held = data(0.75, pretwist, loads(0.0, 3.0 * 0.75 * pretwist));
        let path = Path::new(3, held, data(0.75, pretwist, Load::NONE), Contacts::Unilateral).unwrap();
        let straight = path.starts().unwrap().into_iter().find(|s| s.angle.radians() == 0.0).unwrap();
        let trace = path.trace(&straight, &Route::default()).unwrap();
        let last = trace.stations.last().unwrap();
        assert_eq!(
            (trace.end, last.handedness, last.stability),
            (End::Arrival, Handedness::Right, Some(Stability::Stable))
        );
        assert!((last.angle.degrees() - degrees).abs() < 6e-5, "{} for {degrees}", last.angle.degrees());
    }
}

/// A window that leaves out an end of the path, or that no path is long enough for, is refused.
#[test]
fn a_window_holds_the_path() {
    let twisted = |pretwist: f64| data(0.75, pretwist, loads(0.0, 0.0));
    let path = Path::new(3, twisted(-1.0), twisted(-0.5), Contacts::Kept(Balance::Contact)).unwrap();
    let start = path.starts().unwrap()[0];
    let refused = |window: (f64, f64)| {
        path.trace(&start, &Route { window, ..Route::default() }).map(drop).map_err(|error| error.quantity)
    };
    assert_eq!([(0.0, 1.0), (-0.5, 1.5)].map(refused), [Ok(()), Ok(())]);
    let nan = f64::NAN;
    for window in [(0.1, 1.0), (0.0, 0.9), (-1e9, 1.0), (0.0, 2e9), (nan, 1.0), (0.0, nan)] {
        assert_eq!(refused(window), Err("window"), "{window:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 150, failure_persistence: None, ..ProptestConfig::default() })]

    /// Folds, separation and the other marks lie where the direct solvers put them, to 1e-10.
    #[test]
    fn marks_lie_where_the_solvers_find_them(
        n in 2..9_u32, gamma in 0.5..1.3, pretwist in -1.5..1.5, f in -0.2..1.0, m in -3.0..3.0, kept in any::<bool>(),
        by_force in any::<bool>(), reach in -4.0..4.0,
    ) {
        let balance = if kept { Balance::Contact } else { Balance::Radial };
        let ply = Ply::with_balance(n, gamma, balance).unwrap();
        let twist = Twist::Pretwist(pretwist);
        let end = if by_force { loads(f + reach, m) } else { loads(f, m + reach) };
        let path = Path::new(n, data(gamma, pretwist, loads(f, m)), data(gamma, pretwist, end), Contacts::Kept(balance)).unwrap();
        let (folds, parted) = if by_force {
            (ply.folds_at_moment(twist, m).unwrap(), ply.separation_at_moment(twist, m).unwrap())
        } else {
            (ply.folds_at_force(twist, f).unwrap(), ply.separation_at_force(twist, f).unwrap())
        };
        for start in path.starts().unwrap() {
            let trace = path.trace(&start, &Route { window: (-2.0, 3.0), ..Route::default() }).unwrap();
            prop_assert!(trace.end != End::Stalled, "{start:?}");
            for event in &trace.events {
                let at = &event.station;
                let degrees = at.angle.degrees();
                let load = if by_force { at.load.force } else { at.load.moment };
                let among = |states: &[nply::mechanics::Equilibrium], angle: f64| states.iter().any(|s| {
                    let there = if by_force { s.load().force } else { s.load().moment };
                    s.handedness() == at.handedness && (there - load).abs() < 1e-10 * (1.0 + load.abs())
                        && (s.contact().angle().degrees() - degrees).abs() < angle
                });
                match event.mark {
                    // near two strands' corner at 45° the branch may turn without its slope vanishing
                    Mark::Fold => prop_assert!(among(&folds, 1e-4) || n == 2 && (degrees - 45.0).abs() < 1e-5, "{at:?} {folds:?}"),
                    Mark::Separation => prop_assert!(among(&parted, 1e-7) || at.angle.radians() < 1e-5, "{at:?} {parted:?}"),
                    Mark::Diagonal => prop_assert!((degrees - 45.0).abs() < 1e-10),
                    Mark::MostTurns => {
                        let most = SpecialLays::of(n).unwrap().zero_twist().angle().degrees();
                        prop_assert!((degrees - most).abs() < 1e-9);
                    }
                    Mark::Arrival => {
                        let states = ply.equilibria(twist, end).unwrap();
                        prop_assert!(among(&states, 1e-6) || !(1e-4..=89.9).contains(&degrees), "{at:?} {states:?}");
                    }
                    _ => {}
                }
            }
        }
    }

    /// With contacts that only push, every state on the way is one that the search among all supports finds, nothing overlaps and
    /// nothing pulls, whatever is held.
    #[test]
    fn on_the_way_contacts_push_and_nothing_overlaps(
        n in 2..9_u32, gamma in 0.5..1.3, twist in -1.5..1.5, f in -0.5..4.0, m in -3.0..6.0, core in 0.3..2.5, cored in any::<bool>(),
        df in -4.0..4.0, dm in -6.0..6.0, dtwist in -1.0..1.0, dcore in -0.2..0.5, dgamma in -0.3..0.5,
    ) {
        let core = cored.then_some(core);
        let from = Data { core_radius: core, ..data(gamma, twist, loads(f, m)) };
        let to = Data { core_radius: core.map(|c| c + dcore), ..data(gamma + dgamma, twist + dtwist, loads(f + df, m + dm)) };
        let path = Path::new(n, from, to, Contacts::Unilateral).unwrap();
        for start in path.starts().unwrap() {
            let trace = path.trace(&start, &Route::default()).unwrap();
            for (i, at) in trace.stations.iter().enumerate() {
                let size = 1e-9 * (1.0 + at.load.force.abs() + at.load.moment.abs());
                prop_assert!(at.interstrand_pressure > -size && at.core_pressure > -size, "{at:?}");
                // next to an event, and at the corner of two strands, either side may be meant
                let corner = n == 2 && (at.angle.degrees() - 45.0).abs() < 1e-3;
                let verge = corner || trace.events.iter().any(|event| event.before.abs_diff(i) <= 1);
                // strands that overlap would turn the ply further than those that touch
                let (s, turn) = (at.angle.sin(), at.rotation().abs());
                let touching = nply::geometry::Contact::at_angle(n, at.angle).unwrap().radius_ratio();
                // strands about to straighten, or just parting where two branches are nearly parallel, lose digits
                let lost = if s < 0.01 || verge { 1e-8 } else { 1e-10 };
                prop_assert!(turn <= s / touching + lost, "{at:?}");
                prop_assert!(at.core_radius.is_none_or(|c| turn <= s / (1.0 + c) + lost), "{at:?}");
                if i % 10 == 3 && !verge && at.angle.degrees() < 85.0 && at.angle.degrees() > 0.1 {
                    let data = path.data(at.along);
                    let states = Ply::new(n, data.stiffness_ratio).unwrap()
                        .supported_states(data.twist, data.ends, data.core_radius).unwrap();
                    prop_assert!(states.iter().any(|s| s.handedness() == at.handedness
                        && (s.angle().radians() - at.angle.radians()).abs() < 1e-5), "{at:?} {:?}", states.iter().map(|s| (s.support(), s.handedness(), s.angle().degrees(), s.radius_ratio(), s.neighbour_gap())).collect::<Vec<_>>());
                }
            }
        }
    }

    /// The same with a rotation or a length held, which each state keeps.
    #[test]
    fn on_the_way_held_ends_are_kept(
        n in 2..9_u32, gamma in 0.5..1.3, twist in -1.0..1.0, turns in any::<bool>(), first in 0.1..0.9, last in 0.1..0.9, load in -2.0..2.0,
        dload in -2.0..2.0, core in 0.3..2.5, cored in any::<bool>(), left in any::<bool>(),
    ) {
        let most = SpecialLays::of(n).unwrap().zero_twist();
        let limit = most.angle().sin() / most.radius_ratio() * if left { -1.0 } else { 1.0 };
        let ends = |share: f64, load: f64| if turns {
            Ends::Rotation { rotation: share * limit, force: load }
        } else {
            Ends::Length { extension: share, moment: load }
        };
        let core_radius = cored.then_some(core);
        let from = Data { core_radius, ..data(gamma, twist, ends(first, load)) };
        let to = Data { core_radius, ..data(gamma, twist, ends(last, load + dload)) };
        let path = Path::new(n, from, to, Contacts::Unilateral).unwrap();
        for start in path.starts().unwrap() {
            let trace = path.trace(&start, &Route::default()).unwrap();
            prop_assert!(trace.end != End::Stalled, "{start:?}");
            for (i, at) in trace.stations.iter().enumerate() {
                let data = path.data(at.along);
                match data.ends {
                    Ends::Rotation { rotation, .. } => prop_assert!((at.rotation() - rotation).abs() < 1e-12, "{at:?}"),
                    Ends::Length { extension, .. } => prop_assert!((at.extension() - extension).abs() < 1e-12, "{at:?}"),
                    Ends::Loads(_) => unreachable!(),
                }
                let size = 1e-9 * (1.0 + at.load.force.abs() + at.load.moment.abs());
                prop_assert!(at.interstrand_pressure > -size && at.core_pressure > -size, "{at:?}");
                let verge = trace.events.iter().any(|event| event.before.abs_diff(i) <= 1);
                if i % 10 == 3 && !verge && at.support != Support::Both && (0.1..85.0).contains(&at.angle.degrees()) {
                    let states = Ply::new(n, gamma).unwrap().supported_states(data.twist, data.ends, core_radius).unwrap();
                    prop_assert!(states.iter().any(|s| s.handedness() == at.handedness && s.support() == at.support
                        && (s.angle().radians() - at.angle.radians()).abs() < 1e-6), "{at:?} {states:?}");
                }
            }
        }
    }

    /// Turning ends that are held: each state holds the rotation asked for, and turning stops where no more turns fit in.
    #[test]
    fn no_more_turns_than_the_most(n in 2..9_u32, gamma in 0.5..1.3, twist in -0.5..0.5, f in 0.5..2.0, first in 0.05..0.3) {
        let most = SpecialLays::of(n).unwrap().zero_twist();
        let limit = most.angle().sin() / most.radius_ratio();
        let at = |rotation| data(gamma, twist, Ends::Rotation { rotation, force: f });
        let path = Path::new(n, at(first * limit), at(2.0 * limit), Contacts::Unilateral).unwrap();
        let Some(start) = path.starts().unwrap().into_iter().find(|s| s.support == Support::Neighbours) else { return Ok(()) };
        let trace = path.trace(&start, &Route::default()).unwrap();
        prop_assert_eq!(trace.end, End::UnboundedLoad);
        for station in &trace.stations {
            let Ends::Rotation { rotation, .. } = path.data(station.along).ends else { unreachable!() };
            prop_assert!((station.rotation() - rotation).abs() < 1e-12 && rotation < limit * (1.0 + 1e-12));
        }
        prop_assert!(trace.stations.last().unwrap().rotation() > 0.99 * limit);
    }
}

/// The paper's observation at the end of its section 4: balanced plies below and above π/4 are not joined by a change of pretwist, but
/// with end loads one gets from one to the other at the same pretwist. Here by way of straight strands, which is where the hand changes.
#[test]
fn end_loads_lead_past_45_degrees() {
    for balance in Balance::BOTH {
        let ply = Ply::with_balance(3, 0.75, balance).unwrap();
        let twist = Twist::Pretwist(-0.2);
        let balanced = ply.equilibria(twist, Load::NONE).unwrap();
        let goal = balanced.iter().find(|s| s.handedness() == Handedness::Left).unwrap();
        assert!(goal.contact().angle().degrees() > 45.0);
        // at the goal's angle loads lie on a straight line: the last leg keeps the angle
        let pulled = ply.moment_at(goal.contact().angle(), Handedness::Left, twist, 0.5).unwrap().load();
        let mut from = Load::NONE;
        let mut at: Option<Station> = None;
        let mut met = Vec::new();
        for to in [loads(0.5, 0.0), pulled, Load::NONE] {
            let path = Path::new(3, data(0.75, -0.2, from), data(0.75, -0.2, to), Contacts::Kept(balance)).unwrap();
            let start =
                at.map_or_else(|| start_near(&path, Handedness::Right, 0.2).unwrap(), |s| Station { along: 0.0, ..s });
            let trace = path.trace(&start, &Route::default()).unwrap();
            assert_eq!(trace.end, End::Arrival, "{balance:?}");
            met.extend(marks(&trace));
            (from, at) = (to, trace.stations.last().copied());
        }
        assert!(met.contains(&Mark::Straight) && met.contains(&Mark::Diagonal) && met.contains(&Mark::Separation));
        let end = at.unwrap();
        assert!(
            (end.angle.degrees() - goal.contact().angle().degrees()).abs() < 1e-9 && end.handedness == Handedness::Left
        );
    }
}

/// Unscrewing and pushing a ply until it opens: the stable branch ends there, and nothing uniform is left to jump to.
#[test]
fn an_opened_ply_under_dead_loads_runs_away() {
    let path =
        Path::new(3, data(0.75, -0.2, loads(1.0, 0.0)), data(0.75, -0.2, loads(-1.0, 0.0)), Contacts::Unilateral)
            .unwrap();
    let start = start_near(&path, Handedness::Right, 0.1).unwrap();
    let trace = path.trace(&start, &Route::default()).unwrap();
    let opened = trace.events.iter().find(|event| event.mark == Mark::ContactChange(Support::Free)).unwrap();
    let parted = Ply::new(3, 0.75).unwrap().separation_at_moment(Twist::Pretwist(-0.2), 0.0).unwrap();
    assert!(parted.iter().any(|s| (s.load().force - opened.station.load.force).abs() < 1e-10));
    assert_eq!(opened.jump.as_deref(), Some(&[][..]));
}

/// Two strands past 45°, pulled: the force rises to its greatest value at the corner where their radius begins to grow, and the branch turns
/// back there in a sharp point, on to line contact.
#[test]
fn two_strands_get_round_their_corner() {
    for (gamma, pretwist, f, m, reach) in [
        (0.5, -0.410_483_857_658_952_96, 0.527_430_471_786_031_1, 0.0, 1.643_732_577_936_022_6),
        (0.5, 0.316_882, 0.0, -0.033_924, 1.548_464),
    ] {
        let path = Path::new(
            2,
            data(gamma, pretwist, loads(f, m)),
            data(gamma, pretwist, loads(f + reach, m)),
            Contacts::Kept(Balance::Contact),
        )
        .unwrap();
        let mut turned = 0;
        for start in path.starts().unwrap() {
            let trace = path.trace(&start, &Route { window: (-2.0, 3.0), ..Route::default() }).unwrap();
            assert!(trace.end != End::Stalled, "{start:?}");
            let at_corner = |event: &&nply::mechanics::Event| (event.station.angle.degrees() - 45.0).abs() < 1e-9;
            turned += trace.events.iter().filter(at_corner).filter(|event| event.mark == Mark::Fold).count();
        }
        assert!(turned >= 1, "{gamma} {pretwist}");
    }
}
