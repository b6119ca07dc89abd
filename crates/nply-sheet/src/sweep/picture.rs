//! A sweep as a picture: a panel for each thing asked.

use std::collections::BTreeSet;

use nply::Handedness;

use super::curve::span_of;
use super::{Sweep, SweepCurve, ask};
use crate::plot::{Axis, Chart, Curve, Picture};
use crate::report::Reading;

/// Which axes are logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Scales {
    /// The one below.
    pub log_x: bool,
    /// The one on the left.
    pub log_y: bool,
}

/// The black of the palette, for what is of no ply.
const BLACK: usize = 6;

impl Sweep {
    /// One chart for each thing asked. Colours tell numbers of strands (a left-handed ply is paler) or, where there is one, hands; thin
    /// lines are those of radial balance where both are drawn; dashed ones are separated.
    #[must_use]
    pub fn charts(&self, curves: &[SweepCurve], scales: Scales) -> Vec<Chart> {
        let several = self.ask.len() > 1;
        self.ask
            .iter()
            .enumerate()
            .map(|(i, _)| {
                let chart = self.chart(i, curves, scales);
                let chart = if several { chart.with_size(520.0, 230.0) } else { chart.with_size(520.0, 360.0) };
                if i == 0 { chart } else { chart.without_legend() }
            })
            .collect()
    }

    /// All of them above each other.
    #[must_use]
    pub fn picture(&self, curves: &[SweepCurve], scales: Scales) -> Picture {
        Picture::column(self.charts(curves, scales))
    }

    fn chart(&self, asked: usize, curves: &[SweepCurve], scales: Scales) -> Chart {
        let column = self.ask[asked];
        let points = || curves.iter().flat_map(|curve| &curve.points);
        let values: Vec<f64> = points().filter_map(|point| column.of(&point.state)).collect();
        let (low, high) = span_of(&values);
        let largest = low.abs().max(high.abs());
        let reading = column.measure.reading(self.known(), &self.case.units, largest);
        let (from, to) = self.range();
        let along = |point: &super::SweepPoint| match self.against {
            Some(column) => column.of(&point.state).unwrap_or(f64::NAN),
            None => point.x,
        };
        let places: Vec<f64> = points().map(along).collect();
        let (left, right) = if self.against.is_some() { span_of(&places) } else { (from, to) };
        let (_, label, across) = self.axis(left.abs().max(right.abs()));
        let mut x = axis(label, &across);
        if !scales.log_x {
            x = x.with_range(left * across.factor, right * across.factor);
        } else if left > 0.0 {
            x = x.with_range(left * across.factor, right * across.factor).logarithmic();
        } else {
            x = x.logarithmic();
        }
        let mut y = axis(ask::label(column), &reading);
        if scales.log_y {
            y = y.logarithmic();
        } else {
            let air = 0.05 * (high - low);
            y = y.with_range((low - air) * reading.factor, (high + air) * reading.factor);
        }
        let title = if asked == 0 { self.title() } else { "" };
        let mut chart = Chart::new(title, x, y);
        for curve in curves {
            let points = curve.points.iter().map(|point| {
                let value = column.of(&point.state).unwrap_or(f64::NAN);
                (along(point) * across.factor, value * reading.factor)
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
    fn drawn(&self, curve: &SweepCurve, curves: &[SweepCurve], points: Vec<(f64, f64)>) -> Curve {
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
