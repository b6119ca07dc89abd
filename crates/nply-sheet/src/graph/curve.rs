//! The curves of a graph, worked out.

use nply::Handedness;
use nply::mechanics::{Balance, Equilibrium};

use super::course::Place;
use super::window::{Window, weights};
use super::{Graph, Series};
use crate::plot::sample::sampled;
use crate::report::Column;

/// States in their order along one curve: all pressing, or all separated, or of a shape that knows neither.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GraphCurve {
    /// n.
    pub strands: u32,
    /// The balance in force.
    pub balance: Balance,
    /// Which way the ply winds.
    pub handedness: Handedness,
    /// Whether neighbours would have to pull on each other (p₁ < 0); false where nothing but the shape is asked.
    pub separated: bool,
    /// From one end to the other; two curves that part where p₁ vanishes share that point.
    pub points: Vec<GraphPoint>,
}

/// One state and the datum that holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct GraphPoint {
    /// The datum that runs, dimensionless; a lay angle in rad.
    pub x: f64,
    /// The state.
    pub state: Equilibrium,
}

/// Halvings that find a border to rounding.
const HALVINGS: u32 = 60;

impl Graph {
    /// Every state within the range, or every one that touches, as curves: no two states are joined that do not hang together.
    #[must_use]
    pub fn curves(&self) -> Vec<GraphCurve> {
        let mut curves = Vec::new();
        for series in &self.series {
            for &hand in &self.hands {
                for k in 0..series.course.curves(hand) {
                    self.follow(series, hand, k, &mut curves);
                }
            }
        }
        curves.retain(|curve| !(self.touching && curve.separated));
        curves
    }

    fn follow(&self, series: &Series, hand: Handedness, k: usize, curves: &mut Vec<GraphCurve>) {
        let course = &series.course;
        let at = |parameter: f64| course.at(hand, k, parameter);
        let parameters = course.parameters(self.scales.log_x);
        let (low, high) = self.range();
        let across = Window::from(low, if high > low { high } else { low + 1.0 }, self.scales.log_x);
        let inside = |x: f64| (low..=high).contains(&x);
        // how far what is asked reaches, from a first look
        let first: Vec<Place> =
            parameters.iter().filter_map(|&parameter| at(parameter)).filter(|(x, _)| inside(*x)).collect();
        let weights = weights(&first.iter().map(|(x, _)| across.share(*x)).collect::<Vec<_>>());
        let windows: Vec<(&Column, Window)> = self
            .shown()
            .map(|(column, logarithmic)| {
                let values = first.iter().zip(&weights).filter_map(|((_, state), w)| Some((column.of(state)?, *w)));
                (column, Window::around(&values.collect::<Vec<_>>(), logarithmic))
            })
            .collect();
        let place = |(x, state): &Place| {
            // where a scale has no such number there is no bend to follow
            let shares =
                windows.iter().map(|(column, window)| column.of(state).map_or(0.5, |value| window.share(value)));
            core::iter::once(across.share(*x))
                .chain(shares)
                .map(|share| if share.is_nan() { -2.0 } else { share })
                .collect()
        };
        for run in sampled(at, place, &parameters) {
            for piece in within(&run, &at, &inside) {
                let parts = if self.shape_alone { vec![(false, piece)] } else { parted(&piece, &at) };
                curves.extend(parts.into_iter().map(|(separated, points)| GraphCurve {
                    strands: series.strands,
                    balance: series.balance,
                    handedness: hand,
                    separated,
                    points: points.into_iter().map(|(_, (x, state))| GraphPoint { x, state }).collect(),
                }));
            }
        }
    }

    /// What is asked, and what stands on the axis, each with whether its scale is logarithmic.
    fn shown(&self) -> impl Iterator<Item = (&'static Column, bool)> {
        let asked = self.ask.iter().map(|&column| (column, self.scales.log_y));
        asked.chain(self.against.map(|column| (column, self.scales.log_x)))
    }
}

type Run = Vec<(f64, Place)>;

/// The parameter between two at which something changes, on the side of the first.
fn border<P>(
    mut from: f64,
    mut to: f64,
    at: &impl Fn(f64) -> Option<P>,
    same: impl Fn(&P) -> bool,
) -> Option<(f64, P)> {
    let mut found = None;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (from + to);
        match at(middle) {
            Some(place) if same(&place) => {
                from = middle;
                found = Some((middle, place));
            }
            _ => to = middle,
        }
    }
    found
}

/// A run's parts within the range, their ends on its border.
fn within(run: &Run, at: &impl Fn(f64) -> Option<Place>, inside: &impl Fn(f64) -> bool) -> Vec<Run> {
    let mut parts = Vec::new();
    let mut part = Run::new();
    let mut before: Option<&(f64, Place)> = None;
    for here in run {
        let is_in = inside(here.1.0);
        match before {
            Some(last) if inside(last.1.0) && !is_in => {
                part.extend(border(last.0, here.0, at, |(x, _)| inside(*x)));
                parts.push(core::mem::take(&mut part));
            }
            Some(last) if !inside(last.1.0) && is_in => {
                part.extend(border(here.0, last.0, at, |(x, _)| inside(*x)));
            }
            _ => {}
        }
        if is_in {
            part.push(*here);
        }
        before = Some(here);
    }
    parts.push(part);
    parts.retain(|part| !part.is_empty());
    parts
}

/// A run's parts that press and that are separated, in turn.
fn parted(run: &Run, at: &impl Fn(f64) -> Option<Place>) -> Vec<(bool, Run)> {
    let mut parts: Vec<(bool, Run)> = Vec::new();
    for here in run {
        let separated = here.1.1.is_separated();
        match parts.last_mut() {
            Some((same, part)) if *same == separated => part.push(*here),
            Some((other, part)) => {
                let other = *other;
                let last = part.last().map_or(here.0, |last| last.0);
                let edge = border(last, here.0, at, |(_, state)| state.is_separated() == other);
                part.extend(edge);
                parts.push((separated, edge.into_iter().chain([*here]).collect()));
            }
            None => parts.push((separated, vec![*here])),
        }
    }
    parts
}
