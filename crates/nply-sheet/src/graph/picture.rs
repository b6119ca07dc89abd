//! A graph as a picture: a panel for each thing asked.

use std::collections::BTreeSet;

use nply::Handedness;

use super::window::{Window, weights};
use super::{Graph, GraphCurve, GraphPoint, ask};
use crate::plot::{Axis, Chart, Curve, Picture};
use crate::report::Reading;

/// The black of the palette, for what is of no ply.
const BLACK: usize = 6;

impl Graph {
    /// One chart for each thing asked. Colours tell numbers of strands (a left-handed ply is paler) or, where there is one, hands; thin
    /// lines are those of radial balance where both are drawn; dashed ones are separated.
    #[must_use]
    pub fn charts(&self, curves: &[GraphCurve]) -> Vec<Chart> {
        let several = self.ask.len() > 1;
        self.ask
            .iter()
            .enumerate()
            .map(|(i, _)| {
                let chart = self.chart(i, curves);
                let chart = if several { chart.with_size(520.0, 260.0) } else { chart.with_size(520.0, 360.0) };
                if i == 0 { chart } else { chart.without_legend() }
            })
            .collect()
    }

    /// All of them above each other.
    #[must_use]
    pub fn picture(&self, curves: &[GraphCurve]) -> Picture {
        Picture::column(self.charts(curves))
    }

    fn chart(&self, asked: usize, curves: &[GraphCurve]) -> Chart {
        let column = self.ask[asked];
        let along = |point: &GraphPoint| match self.against {
            Some(column) => column.of(&point.state).unwrap_or(f64::NAN),
            None => point.x,
        };
        let (from, to) = self.range();
        let across = match self.against {
            None => Window::from(from, to, self.scales.log_x),
            Some(shown) => {
                // here every place counts the same
                let places = curves.iter().flat_map(|curve| &curve.points).map(|point| (along(point), 1.0));
                Window::of(shown.measure, &places.collect::<Vec<_>>(), self.scales.log_x)
            }
        };
        // poles stand on little of the axis: each number counts by how much it stands on
        let weighed: Vec<(f64, f64)> = curves
            .iter()
            .flat_map(|curve| {
                let shares: Vec<f64> = curve.points.iter().map(|point| across.share(along(point))).collect();
                let values = curve.points.iter().map(|point| column.of(&point.state).unwrap_or(f64::NAN));
                values.zip(weights(&shares)).collect::<Vec<_>>()
            })
            .collect();
        let up = Window::of(column.measure, &weighed, self.scales.log_y);
        let largest = |window: Window| window.low.abs().max(window.high.abs());
        let reading = column.measure.reading(self.known(), &self.case.units, largest(up));
        let (_, label, below) = self.axis(largest(across));
        let ranged = |axis: Axis, (low, high): (f64, f64), factor: f64, logarithmic: bool| {
            let axis = if logarithmic { axis.logarithmic() } else { axis };
            // a logarithmic axis that would begin at 0 shows what it can
            if logarithmic && low <= 0.0 { axis } else { axis.with_range(low * factor, high * factor) }
        };
        let ends = if self.against.is_some() { across.aired() } else { (across.low, across.high) };
        let x = ranged(axis(label, &below), ends, below.factor, self.scales.log_x);
        let y = ranged(axis(ask::label(column), &reading), up.aired(), reading.factor, self.scales.log_y);
        let title = if asked == 0 { self.title() } else { "" };
        let mut chart = Chart::new(title, x, y);
        for curve in curves {
            let points = curve.points.iter().map(|point| {
                let value = column.of(&point.state).unwrap_or(f64::NAN);
                (along(point) * below.factor, value * reading.factor)
            });
            chart = chart.with_curve(self.drawn(curve, curves, points.collect()));
        }
        if curves.iter().any(|curve| curve.separated) {
            let name = if curves.iter().all(|curve| curve.separated) {
                "all separated, p₁ < 0"
            } else {
                "separated, p₁ < 0"
            };
            chart = chart.with_curve(Curve::new(name, []).with_colour(BLACK).dashed());
        }
        chart
    }

    /// A curve in its colour and width, with its name.
    fn drawn(&self, curve: &GraphCurve, curves: &[GraphCurve], points: Vec<(f64, f64)>) -> Curve {
        let numbers: BTreeSet<u32> = curves.iter().map(|curve| curve.strands).collect();
        let hands = self.hands.len() > 1;
        let balances: BTreeSet<&str> = curves.iter().map(|curve| curve.balance.name()).collect();
        let left = curve.handedness == Handedness::Left;
        let mut words = Vec::new();
        if numbers.len() > 1 || !(hands || balances.len() > 1) {
            words.push(format!("n = {}", curve.strands));
        }
        if hands {
            words.push(if left { "left (S)" } else { "right (Z)" }.to_owned());
        }
        if balances.len() > 1 {
            words.push(curve.balance.name().to_owned());
        }
        let several = numbers.len() > 1;
        let colour = match (several, hands) {
            (true, _) => numbers.iter().position(|n| *n == curve.strands).unwrap_or(0),
            (false, _) => usize::from(left),
        };
        // every way of drawing has its name once, whatever its dashes
        let solid = curves.iter().any(|other| {
            !other.separated
                && (other.strands, other.balance, other.handedness) == (curve.strands, curve.balance, curve.handedness)
        });
        let name = if curve.separated && solid { String::new() } else { words.join(", ") };
        let thin = balances.len() > 1 && curve.balance == nply::mechanics::Balance::Radial;
        let mut drawn = Curve::new(name, points).with_colour(colour).with_width(if thin { 1.1 } else { 2.2 });
        if curve.separated {
            drawn = drawn.dashed();
        }
        if several && hands && left { drawn.pale() } else { drawn }
    }
}

fn axis(label: String, reading: &Reading) -> Axis {
    Axis::new(label, reading.unit.clone())
}
