//! The certified scan: every root of a case's balance along the branch, each in a bracket of its own, and what stays open.

use nply::Handedness;

use crate::case::Case;
use crate::interval::Interval;
use crate::jet::Jet;
use crate::sheet::{Division, Sheet, TERMS};
use crate::table::{PANELS, Panel, Table, Tables};

/// Pieces of one hand after which nothing is halved any more.
const MOST_PIECES: usize = 4000;

/// A stretch of a sheet, by its coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// which sheet from straight strands on
    pub place: usize,
    pub from: f64,
    pub to: f64,
}

/// Why nothing is certain about a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Why {
    /// two roots meet, or nearly, so near that rounding decides
    Fold,
    /// next to straight strands, where the balance vanishes to rounding
    Straight,
    /// next to flat rings, likewise
    Flat,
    /// a root within rounding of the border of two sheets
    Border,
}

/// What is known of one hand.
#[derive(Clone, Debug, Default)]
pub struct Known {
    /// exactly one root in each
    pub roots: Vec<Stretch>,
    /// nothing known of these
    pub open: Vec<(Stretch, Why)>,
    /// pieces beyond the table's panels that were looked at
    pub pieces: usize,
}

/// Consecutive panels or pieces of one kind, by coordinate.
#[derive(Clone, Copy, Debug)]
struct Run {
    from: f64,
    to: f64,
    kind: Panel,
}

/// The tables of a case, sheet by sheet.
pub struct Scan<'a> {
    tables: Vec<&'a Table>,
    case: Case,
}

/// Which tables a case needs.
#[must_use]
pub fn divisions(case: &Case) -> Vec<Division> {
    let held = case.is_held();
    let mut weights = case.weights();
    Sheet::all(case.strands)
        .iter()
        .map(|sheet| {
            let held = held && matches!(sheet, Sheet::Line | Sheet::Steep);
            weights[4] = if held { 0.0 } else { case.load.moment };
            let powers = sheet.powers(case.balance, held);
            let power = powers.iter().zip(weights).filter(|&(_, weight)| weight != 0.0).map(|(&power, _)| power).min();
            Division { power: power.unwrap_or(0), held }
        })
        .collect()
}

impl<'a> Scan<'a> {
    /// Over tables that [`Self::prepare`] has made for the case's [`divisions`].
    #[must_use]
    pub fn new(case: Case, tables: Vec<&'a Table>) -> Self {
        Self { tables, case }
    }

    /// Makes what is missing among the tables.
    pub fn prepare(case: &Case, tables: &mut Tables) {
        for (place, division) in divisions(case).into_iter().enumerate() {
            tables.prepare(case.strands, case.balance, place, division);
        }
    }

    /// Both hands: right, left.
    #[must_use]
    pub fn run(&self) -> [Known; 2] {
        let mut known = [Known::default(), Known::default()];
        let weights = self.case.weights();
        let mut judged = [[Panel::Open; PANELS]; 2];
        for (place, table) in self.tables.iter().enumerate() {
            let mut weights = weights;
            if table.division.held {
                weights[4] = 0.0;
            }
            table.judge(&weights, &mut judged);
            for ((known, panels), hand) in known.iter_mut().zip(&judged).zip(Handedness::BOTH) {
                let line = Line { place, table, weights: self.exact(place, hand) };
                let mut runs: Vec<Run> = Vec::with_capacity(8);
                for (i, &kind) in panels.iter().enumerate() {
                    let (from, to) = (table.borders[i], table.borders[i + 1]);
                    if kind == Panel::Open {
                        line.split(from, to, &mut runs, &mut known.pieces);
                    } else {
                        join(&mut runs, Run { from, to, kind });
                    }
                }
                line.conclude(&runs, known);
            }
        }
        known
    }

    fn exact(&self, place: usize, hand: Handedness) -> [Interval; TERMS] {
        let mut weights = self.case.exact_weights(hand);
        if self.tables[place].division.held {
            weights[4] = Interval::ZERO;
        }
        weights
    }

    /// The balance at a coordinate, over a positive factor.
    #[must_use]
    pub fn balance(&self, place: usize, t: Interval, hand: Handedness) -> Jet {
        Line { place, table: self.tables[place], weights: self.exact(place, hand) }.jet(t)
    }

    /// How far interval arithmetic leaves the balance uncertain there: as the sum of its five terms, over the same factor.
    #[must_use]
    pub fn rounding(&self, place: usize, t: f64, hand: Handedness) -> f64 {
        let table = self.tables[place];
        let at = Interval::point(t);
        if !table.division.held {
            return self.balance(place, at, hand).value.middle_and_radius().1;
        }
        // solvers do not know that two terms cancel
        let whole = Division { power: 0, held: false };
        let terms = table.sheet.terms(table.strands, table.balance, whole, at);
        let weights = self.case.exact_weights(hand);
        let sum = weights.iter().zip(terms).fold(Interval::ZERO, |sum, (weight, term)| sum + *weight * term);
        (0..table.division.power).fold(sum.middle_and_radius().1, |rounding, _| rounding / t)
    }

    /// The sign of the balance there.
    #[must_use]
    pub fn sign(&self, place: usize, t: f64, hand: Handedness) -> Option<bool> {
        Line { place, table: self.tables[place], weights: self.exact(place, hand) }.sign(Interval::point(t))
    }

    /// The greatest coordinate of a sheet.
    #[must_use]
    pub fn end(&self, place: usize) -> f64 {
        self.sheet(place).end(self.case.strands)
    }

    #[must_use]
    pub fn sheet(&self, place: usize) -> Sheet {
        self.tables[place].sheet
    }
}

/// One hand's balance on one sheet.
struct Line<'a> {
    place: usize,
    table: &'a Table,
    weights: [Interval; TERMS],
}

impl Line<'_> {
    fn jet(&self, t: Interval) -> Jet {
        let terms = self.table.jets(t);
        let sum = |part: fn(&Jet) -> Interval| {
            self.weights.iter().zip(&terms).fold(Interval::ZERO, |sum, (weight, term)| sum + *weight * part(term))
        };
        Jet { value: sum(|jet| jet.value), slope: sum(|jet| jet.slope), curve: sum(|jet| jet.curve) }
    }

    fn sign(&self, t: Interval) -> Option<bool> {
        let terms = self.table.values(t);
        let sum = self.weights.iter().zip(terms).fold(Interval::ZERO, |sum, (weight, term)| sum + *weight * term);
        sum.sign()
    }

    /// Halves until each piece is free of roots or monotone, or rounding hides what it is.
    fn split(&self, from: f64, to: f64, runs: &mut Vec<Run>, pieces: &mut usize) {
        *pieces += 1;
        let middle = 0.5 * (from + to);
        let (at, over) = (self.jet(Interval::point(middle)), self.jet(Interval::between(from, to)));
        let off = Interval::between(from, to) - Interval::point(middle);
        let slope = at.slope + over.curve * off;
        let half = Interval::between(0.0, 0.5);
        let rise = at.slope * off + half * over.curve * off.square();
        let value = at.value + rise;
        let kind = match (value.sign(), slope.sign()) {
            (Some(positive), _) => Panel::Free(positive),
            (None, Some(rises)) => Panel::Monotone(rises),
            (None, None) => Panel::Open,
        };
        let hidden = rise.size() <= 4.0 * at.value.middle_and_radius().1 || middle <= from || middle >= to;
        if kind != Panel::Open || hidden || *pieces >= MOST_PIECES {
            join(runs, Run { from, to, kind });
        } else {
            self.split(from, middle, runs, pieces);
            self.split(middle, to, runs, pieces);
        }
    }

    /// Roots and open stretches from runs that cover the sheet.
    fn conclude(&self, runs: &[Run], known: &mut Known) {
        let strands = self.table.strands;
        let end = self.table.sheet.end(strands);
        // the border with the next sheet, as seen by either
        let seam = match self.table.sheet {
            Sheet::Flat => Interval::point(end),
            sheet => sheet.seam(strands),
        };
        let border = self.sign(seam);
        let free = |run: Option<&Run>| match run.map(|run| run.kind) {
            Some(Panel::Free(positive)) => Some(positive),
            _ => None,
        };
        let mut open: Vec<(Stretch, Why)> = Vec::new();
        let mut stay_open = |from: f64, to: f64, why: Why| {
            let place = self.place;
            match open.last_mut() {
                Some((last, _)) if last.to == from => last.to = to,
                _ => open.push((Stretch { place, from, to }, why)),
            }
        };
        for (i, run) in runs.iter().enumerate() {
            let before = i.checked_sub(1).and_then(|i| runs.get(i));
            let after = runs.get(i + 1);
            match run.kind {
                Panel::Free(positive) => {
                    // two free runs side by side have one sign, or a range is wrong
                    assert!(free(after).is_none_or(|other| other == positive), "{:?} {run:?}", self.table.sheet);
                }
                Panel::Open => stay_open(run.from, run.to, self.why(run.from, run.to)),
                Panel::Monotone(rises) => {
                    let (mut from, mut to) = (run.from, run.to);
                    let mut low = free(before).or_else(|| self.sign(Interval::point(from)));
                    let mut high = free(after).or_else(|| match after {
                        Some(_) => self.sign(Interval::point(to)),
                        None => border.and(self.sign(Interval::point(to))),
                    });
                    if low.is_none() {
                        if let Some((inner, sign)) = self.nearest_sure(run.from, run.to) {
                            stay_open(from, inner, self.why(from, inner));
                            (from, low) = (inner, Some(sign));
                        }
                    }
                    let mut later = None;
                    if high.is_none() {
                        if let Some((inner, sign)) = self.nearest_sure(to, from) {
                            later = Some((inner, to));
                            (to, high) = (inner, Some(sign));
                        }
                    }
                    match (low, high) {
                        (Some(low), Some(high)) if from < to => {
                            if low != high {
                                assert_eq!(high, rises, "{:?} {run:?} rises to below zero", self.table.sheet);
                                known.roots.push(Stretch { place: self.place, from, to });
                            }
                        }
                        _ => stay_open(from, to, self.why(from, to)),
                    }
                    if let Some((from, to)) = later {
                        stay_open(from, to, self.why(from, to));
                    }
                }
            }
        }
        known.open.extend(open);
    }

    /// Next to `end` the sign is not sure: the nearest place to it, by halves towards `other`, where it is.
    fn nearest_sure(&self, end: f64, other: f64) -> Option<(f64, bool)> {
        let mut best = None;
        let mut part = 1.0;
        for _ in 0..1100 {
            let at = end + (other - end) * part;
            if at == end {
                break;
            }
            match self.sign(Interval::point(at)) {
                Some(sign) => best = Some((at, sign)),
                None => break,
            }
            part *= 0.5;
        }
        best
    }

    fn why(&self, from: f64, to: f64) -> Why {
        let end = self.table.sheet.end(self.table.strands);
        match self.table.sheet {
            Sheet::Line | Sheet::Steep if from == 0.0 => Why::Straight,
            Sheet::Flat if from == 0.0 => Why::Flat,
            Sheet::Fork if from == 0.0 => Why::Border,
            _ if to == end => Why::Border,
            _ => Why::Fold,
        }
    }
}

fn join(runs: &mut Vec<Run>, run: Run) {
    match runs.last_mut() {
        Some(last) if last.kind == run.kind => last.to = run.to,
        _ => runs.push(run),
    }
}
