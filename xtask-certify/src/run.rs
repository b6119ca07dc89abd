//! Many plies, and what came of them.

use std::collections::BTreeMap;
use std::fmt;
use std::time::{Duration, Instant};

use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Plies, Ply, States, Twist, Twists};

use crate::case::Case;
use crate::dice::Dice;
use crate::scan::{Scan, Why, divisions};
use crate::table::Tables;
use crate::verdict::{Allowed, State, Verdict};

/// Plies worked on together.
const CHUNK: usize = 20_000;
/// Complaints told in full.
const TOLD: usize = 20;

/// The solver of one ply: as near as rounding of the balance.
const ALONE: Allowed = Allowed { relative: 1e-12, rounding: 8.0 };
/// Arrays promise 1e-12 rad.
const ARRAYS: Allowed = Allowed { relative: 1e-11, rounding: 16.0 };

/// Counts over all plies so far.
#[derive(Debug, Default)]
pub struct Report {
    pub plies: u64,
    /// certified roots
    pub roots: u64,
    /// cases in which neither hand left anything open
    pub closed: u64,
    /// open stretches by reason
    pub open: BTreeMap<Why, u64>,
    /// pieces beyond the panels of the tables
    pub pieces: u64,
    pub alone: Verdict,
    pub arrays: Verdict,
    /// plies that the solver refused
    pub refused: u64,
    /// what went wrong, the first of it in full
    pub complaints: Vec<String>,
    /// the first plies of which a state is told that is none, in full
    pub made_up: Vec<String>,
    /// the first stretches that stayed open
    pub left_open: Vec<String>,
    scanning: Duration,
    solving: Duration,
}

impl Report {
    #[must_use]
    pub fn holds(&self) -> bool {
        self.alone.holds() && self.arrays.holds() && self.refused == 0
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "plies                {}, of which certified throughout {}", self.plies, self.closed)?;
        writeln!(f, "certified roots      {}", self.roots)?;
        for (name, verdict) in [("solver", &self.alone), ("arrays", &self.arrays)] {
            writeln!(
                f,
                "{name}               matched {}, missed {}, extra {}, misplaced {}, in open stretches {}",
                verdict.matched, verdict.missed, verdict.extra, verdict.misplaced, verdict.open
            )?;
        }
        writeln!(f, "refused              {}", self.refused)?;
        let open: Vec<String> = self.open.iter().map(|(why, count)| format!("{why:?} {count}")).collect();
        writeln!(f, "open stretches       {}", if open.is_empty() { "none".to_owned() } else { open.join(", ") })?;
        writeln!(f, "pieces beyond panels {}", self.pieces)?;
        let each = |time: Duration| time.as_secs_f64() / self.plies.max(1) as f64 * 1e6;
        write!(
            f,
            "time a ply           scan and verdict {:.1} µs, solver and arrays {:.1} µs",
            each(self.scanning),
            each(self.solving)
        )
    }
}

/// The certifying of random plies.
pub struct Run {
    dice: Dice,
    tables: Tables,
    pub report: Report,
}

impl Run {
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { dice: Dice::new(seed), tables: Tables::default(), report: Report::default() }
    }

    /// So many more plies.
    pub fn go_on(&mut self, plies: usize) {
        let mut left = plies;
        while left > 0 {
            let count = left.min(CHUNK);
            let mut cases: Vec<Case> = (0..count).map(|_| self.dice.case()).collect();
            cases.sort_by_key(|case| (case.strands, case.balance == Balance::Radial));
            self.chunk(&cases);
            self.tables.forget_many_strands();
            self.dice.change_many();
            left -= count;
        }
    }

    fn chunk(&mut self, cases: &[Case]) {
        let start = Instant::now();
        let arrays = Arrays::solve(cases);
        let alone: Vec<Option<Vec<State>>> = cases.iter().map(solve).collect();
        self.report.solving += start.elapsed();
        let start = Instant::now();
        let mut strands = 0;
        for (row, (case, alone)) in cases.iter().zip(&alone).enumerate() {
            if case.strands != strands {
                self.tables.forget_many_strands();
                strands = case.strands;
            }
            self.certify(case, alone.as_deref(), arrays.states(row).as_deref());
        }
        self.report.scanning += start.elapsed();
    }

    /// One ply; states of either door, none where it was refused.
    pub fn certify(&mut self, case: &Case, alone: Option<&[State]>, arrays: Option<&[State]>) {
        let report = &mut self.report;
        report.plies += 1;
        let (Some(alone), Some(arrays)) = (alone, arrays) else {
            report.refused += 1;
            tell(&mut report.complaints, || format!("refused: {case:?}"));
            return;
        };
        Scan::prepare(case, &mut self.tables);
        let tables = divisions(case).into_iter().enumerate();
        let tables =
            tables.filter_map(|(place, division)| self.tables.made(case.strands, case.balance, place, division));
        let scan = Scan::new(*case, tables.collect());
        let known = scan.run();
        for (known, hand) in known.iter().zip(Handedness::BOTH) {
            report.roots += known.roots.len() as u64;
            report.pieces += known.pieces as u64;
            for (open, why) in &known.open {
                *report.open.entry(*why).or_default() += 1;
                tell(&mut report.left_open, || {
                    let sheet = scan.sheet(open.place);
                    format!("{why:?}: {sheet:?} from {:e} to {:e}, {hand:?}, {case:?}", open.from, open.to)
                });
            }
        }
        report.closed += u64::from(known.iter().all(|known| known.open.is_empty()));
        for (name, states, allowed, sum) in
            [("solver", alone, ALONE, &mut report.alone), ("arrays", arrays, ARRAYS, &mut report.arrays)]
        {
            let verdict = scan.verdict(case, &known, states, allowed);
            if !verdict.holds() {
                // states that are none are told before those that are missed
                let list_of = if verdict.extra > 0 { &mut report.made_up } else { &mut report.complaints };
                tell(list_of, || format!("{name}: {verdict:?}\n  {case:?}\n  {}\n  {known:?}", list(states)));
            }
            sum.add(verdict);
        }
    }
}

fn tell(list: &mut Vec<String>, line: impl FnOnce() -> String) {
    if list.len() < TOLD {
        list.push(line());
    }
}

fn list(states: &[State]) -> String {
    let state = |state: &State| {
        let fold = if state.fold { ", fold" } else { "" };
        format!("{:?} {:e} (π/2 − {:e}){fold}", state.hand, state.angle.radians(), state.angle.pitch_angle())
    };
    states.iter().map(state).collect::<Vec<_>>().join("; ")
}

/// The states by the solver of one ply.
#[must_use]
pub fn solve(case: &Case) -> Option<Vec<State>> {
    let ply = Ply::with_balance(case.strands, case.stiffness_ratio, case.balance).ok()?;
    let states = ply.equilibria(case.twist, case.load).ok()?;
    let told = states.iter().map(|state| State {
        hand: state.handedness(),
        angle: state.contact().angle(),
        fold: state.is_fold(),
    });
    Some(told.collect())
}

/// The states of all cases of either balance and either kind of twist, by the arrays' door.
struct Arrays {
    found: [Option<States>; 4],
    /// which of the four, and the row there
    rows: Vec<(usize, usize)>,
}

impl Arrays {
    fn solve(cases: &[Case]) -> Self {
        let kind = |case: &Case| {
            2 * usize::from(case.balance == Balance::Radial) + usize::from(matches!(case.twist, Twist::StrandTwist(_)))
        };
        let mut counts = [0; 4];
        let rows = cases.iter().map(|case| {
            let kind = kind(case);
            counts[kind] += 1;
            (kind, counts[kind] - 1)
        });
        let rows: Vec<_> = rows.collect();
        let found = std::array::from_fn(|wanted| {
            let cases: Vec<&Case> = cases.iter().filter(|case| kind(case) == wanted).collect();
            let column = |of: fn(&Case) -> f64| cases.iter().map(|case| of(case)).collect::<Vec<f64>>();
            let twist = column(|case| {
                let (Twist::Pretwist(twist) | Twist::StrandTwist(twist)) = case.twist;
                twist
            });
            let plies = Plies {
                strands: &cases.iter().map(|case| case.strands).collect::<Vec<_>>(),
                stiffness_ratio: &column(|case| case.stiffness_ratio),
                twist: if wanted % 2 == 0 { Twists::Pretwist(&twist) } else { Twists::StrandTwist(&twist) },
                force: &column(|case| case.load.force),
                moment: &column(|case| case.load.moment),
            };
            let mut states = States::new();
            let balance = if wanted < 2 { Balance::Contact } else { Balance::Radial };
            plies.equilibria(balance, &mut states).ok().map(|()| states)
        });
        Self { found, rows }
    }

    fn states(&self, row: usize) -> Option<Vec<State>> {
        let (kind, row) = self.rows[row];
        let states = self.found[kind].as_ref()?;
        if states.refused().iter().any(|(refused, _)| *refused == row) {
            return None;
        }
        let state = |at: usize| {
            let (helical, pitch) = (states.helical_angle()[at], states.pitch_angle()[at]);
            let angle =
                if helical < pitch { HelicalAngle::new(helical) } else { HelicalAngle::from_pitch_angle(pitch) };
            angle.ok().map(|angle| State { hand: states.handedness()[at], angle, fold: states.fold()[at] })
        };
        states.row(row).map(state).collect()
    }
}
