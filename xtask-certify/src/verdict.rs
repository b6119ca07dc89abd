//! The solver's states held against what the scan knows.
#![allow(clippy::disallowed_methods)] // an independent route

use std::f64::consts::{PI, TAU};

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};

use crate::case::Case;
use crate::dice::HALF;
use crate::interval::Interval;
use crate::scan::{Known, Scan, Stretch, Why};
use crate::sheet::Sheet;

/// A state as either door of the solver gives it.
#[derive(Clone, Copy, Debug)]
pub struct State {
    pub hand: Handedness,
    pub angle: HelicalAngle,
    pub fold: bool,
}

/// What was found, added up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Verdict {
    /// states that are each the only one in a certified bracket
    pub matched: u64,
    /// certified roots without a state
    pub missed: u64,
    /// states where the scan knows that there is no root
    pub extra: u64,
    /// states further from a root than rounding allows
    pub misplaced: u64,
    /// states in stretches that stay open
    pub open: u64,
}

impl Verdict {
    #[must_use]
    pub const fn holds(&self) -> bool {
        self.missed == 0 && self.extra == 0 && self.misplaced == 0
    }

    pub fn add(&mut self, other: Self) {
        self.matched += other.matched;
        self.missed += other.missed;
        self.extra += other.extra;
        self.misplaced += other.misplaced;
        self.open += other.open;
    }
}

/// How far a state may be from its root: relative to its coordinate, and in what rounding makes of the balance in interval arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Allowed {
    pub relative: f64,
    pub rounding: f64,
}

impl Scan<'_> {
    /// Judges the states of one solver.
    #[must_use]
    pub fn verdict(&self, case: &Case, known: &[Known; 2], states: &[State], allowed: Allowed) -> Verdict {
        let mut verdict = Verdict::default();
        for (known, hand) in known.iter().zip(Handedness::BOTH) {
            let mut brackets: Vec<(usize, f64, f64)> = Vec::with_capacity(4);
            let mut inside = 0;
            for state in states.iter().filter(|state| state.hand == hand) {
                let (place, t) = locate(case.strands, state.angle);
                if state.fold && is_within(&known.open, place, t) {
                    inside += 1;
                    continue;
                }
                match self.bracket(place, t, hand, allowed) {
                    Some((from, to)) => brackets.push((place, from, to)),
                    None if is_within(&known.open, place, t) => inside += 1,
                    None if known.roots.is_empty() => verdict.extra += 1,
                    None => verdict.misplaced += 1,
                }
            }
            brackets.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            let touches = |bracket: &(usize, f64, f64)| overlaps(&known.open, bracket.0, bracket.1, bracket.2);
            // brackets that overlap and reach but one root would be that root told twice
            let twice = brackets.windows(2).filter(|pair| {
                let (one, other) = (pair[0], pair[1]);
                let reached =
                    |root: &&Stretch| root.place == one.0 && root.from <= one.2.max(other.2) && one.1 <= root.to;
                let apart = one.0 != other.0 || other.1 >= one.2 || known.roots.iter().filter(reached).count() > 1;
                !apart && !touches(&one) && !touches(&other)
            });
            let twice = twice.count();
            let touching = brackets.iter().filter(|bracket| touches(bracket)).count() as u64;
            // a bracket that reaches into an open stretch may be that of a root beside it, or of one inside; so may a state inside
            let beside = known.roots.iter().any(|root| overlaps(&known.open, root.place, root.from, root.to));
            let (clear, roots) = ((brackets.len() - twice) as u64 - touching, known.roots.len() as u64);
            let unsure = touching + if beside { inside } else { 0 };
            let used = roots.saturating_sub(clear).min(unsure);
            verdict.extra += twice as u64 + clear.saturating_sub(roots);
            verdict.missed += roots.saturating_sub(clear + unsure);
            verdict.matched += roots.min(clear + unsure);
            verdict.open += inside + touching - used;
        }
        verdict
    }

    /// The narrowest of some brackets about a coordinate at whose ends the balance has different signs for sure; none within what is allowed.
    fn bracket(&self, place: usize, t: f64, hand: Handedness, allowed: Allowed) -> Option<(f64, f64)> {
        let slope = self.balance(place, Interval::point(t), hand).slope.middle_and_radius().0.abs();
        // what rounding of the angle does to the square at 45°
        let border = if self.sheet(place) == Sheet::Fork { 1e-13 } else { 0.0 };
        let rounding = (allowed.rounding * self.rounding(place, t, hand) / slope).min(self.end(place));
        let most = border + allowed.relative * t + rounding;
        // of a fold two roots are near each other: begin with little
        let parts = std::iter::successors(Some(LEAST), |part| Some(4.0 * part)).take_while(|part| *part <= 1.0);
        let aways = parts.map(|part| part * most);
        for away in aways.clone() {
            let [before, after] = [t - away, t + away].map(|t| self.sign_beside(place, t, hand));
            if let (Some(before), Some(after)) = (before, after)
                && before != after
            {
                return Some((t - away, t + away));
            }
        }
        // next to 45° of two strands the sign may be sure nearer on one side than on the other, and on the border at the last
        let nearest = |side: f64| {
            let border = match self.sheet(place) {
                Sheet::Line if side > 0.0 => 1.0 - t,
                Sheet::Fork if side < 0.0 => t,
                _ => f64::INFINITY,
            };
            let here = aways.clone().filter(|away| *away < border).chain((border <= most).then_some(border));
            here.map(|away| t + side * away).find_map(|t| Some((t, self.sign_beside(place, t, hand)?)))
        };
        let ((from, before), (to, after)) = (nearest(-1.0)?, nearest(1.0)?);
        (before != after).then_some((from, to))
    }

    /// The sign at a coordinate that may lie beyond a border.
    fn sign_beside(&self, place: usize, t: f64, hand: Handedness) -> Option<bool> {
        let sheet = self.sheet(place);
        // at 45° of two strands dy = dz²/12
        match sheet {
            Sheet::Line if t > 1.0 => self.sign(place + 1, (12.0 * (t - 1.0)).min(4.0), hand),
            Sheet::Fork if t < 0.0 => self.sign(place - 1, (1.0 + t / 12.0).max(0.0), hand),
            _ => self.sign(place, t.clamp(0.0, self.end(place)), hand),
        }
    }
}

/// Parts of what is allowed that are tried first, by fours.
const LEAST: f64 = 1.0 / 65_536.0;

/// Whether a bracket shares a coordinate with a stretch that stays open, on its own sheet or beyond a border at 45°.
fn overlaps(open: &[(Stretch, Why)], place: usize, from: f64, to: f64) -> bool {
    open.iter().any(|(open, why)| {
        let beyond = *why == Why::Border && open.place != place;
        beyond || (open.place == place && open.from <= to && from <= open.to)
    })
}

/// Whether a coordinate lies in a stretch that stays open, or beside it by less than its width.
fn is_within(open: &[(Stretch, Why)], place: usize, t: f64) -> bool {
    open.iter().any(|(open, _)| {
        let pad = (open.to - open.from) + 1e-12 * t;
        open.place == place && open.from - pad <= t && t <= open.to + pad
    })
}

/// The sheet and the coordinate of an angle on the main branch.
#[must_use]
pub fn locate(strands: u32, angle: HelicalAngle) -> (usize, f64) {
    let (s, c) = (angle.sin(), angle.cos());
    let lambda = TAU / f64::from(strands);
    if strands == 2 && angle.radians() <= HALF {
        return (0, (s / c).min(1.0));
    }
    // E from the library, improved by Newton's steps that know nothing of it
    let mut anomaly = Contact::at_angle(strands, angle).map_or(0.5 * lambda, |contact| contact.anomaly());
    if strands == 2 {
        let z = PI - anomaly;
        if z <= 2.0 {
            // cos 2θ + s² (1 − sin z/z) = 0
            let mut square = z * z;
            for _ in 0..4 {
                let (value, slope) = lacking(square);
                square = (square - (angle.cos_double() + s * s * value) / (s * s * slope)).max(0.0);
            }
            return (1, square.min(4.0));
        }
    }
    let flat = strands == 2 || anomaly.sqrt() < Sheet::Flat.end(strands);
    if flat {
        for _ in 0..2 {
            let (sin, cos) = anomaly.sin_cos();
            anomaly -= ((anomaly - lambda) * c * c + s * s * sin) / (c * c + s * s * cos);
        }
        (Sheet::all(strands).len() - 1, anomaly.sqrt())
    } else {
        // V = λ − E: V cos²θ = sin²θ sin(λ − V)
        let mut rest = (lambda - anomaly).max(0.0);
        for _ in 0..3 {
            let (sin, cos) = (lambda - rest).sin_cos();
            rest = (rest - (rest * c * c - s * s * sin) / (c * c + s * s * cos)).max(0.0);
        }
        (0, rest.sqrt().min(Sheet::Steep.end(strands)))
    }
}

/// 1 − sin z/z and its slope, by z².
fn lacking(square: f64) -> (f64, f64) {
    let (mut value, mut slope, mut term) = (0.0, 0.0, 1.0);
    for k in 1..12_u32 {
        // −(−z²)ᵏ/(2k + 1)!
        let k = f64::from(k);
        slope += k * term / ((2.0 * k) * (2.0 * k + 1.0));
        term *= square / ((2.0 * k) * (2.0 * k + 1.0));
        value += term;
        term = -term;
    }
    (value, slope)
}
