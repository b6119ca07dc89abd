//! Measurements beside the fitted states, and what is left of them.

use super::answer::{Compared, FittedRow};
use super::{DataColumn, Given, Observable, RegressionReport, Role};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape};

/// Blue for what is measured, vermilion for what is fitted, black for nothing.
const COLOURS: [usize; 3] = [0, 1, 6];

impl RegressionReport {
    /// What stands below a chart of one thing: what is held and has the most different numbers; where nothing held varies, a load that is
    /// measured, though not the thing itself; else the line.
    fn below(&self, shown: Observable) -> (Axis, Vec<f64>) {
        let lines = || (Axis::new("line", ""), self.answer().rows.iter().map(|row| row.line as f64).collect());
        let places: Option<Vec<usize>> = self.answer().rows.iter().map(|row| self.place_of(row.line)).collect();
        let Some(places) = places else { return lines() };
        let different = |column: &&DataColumn| {
            let mut values: Vec<f64> = places.iter().map(|at| column.values[*at]).collect();
            values.sort_by(f64::total_cmp);
            values.dedup();
            if values.iter().all(|value| value.is_finite()) { values.len() } else { 0 }
        };
        let held = |column: &DataColumn| column.role == Role::Held;
        let load = |column: &DataColumn| matches!(column.given, Given::State(load) if load.is_load() && load != shown);
        let most = |serves: &dyn Fn(&DataColumn) -> bool| {
            let varies = self.columns().iter().filter(|column| serves(column) && different(column) > 1);
            // the first of several, as they stand in the data
            varies.rev().max_by_key(different)
        };
        let Some(column) = most(&held).or_else(|| most(&load)) else { return lines() };
        let (factor, unit) = match column.given {
            Given::State(observable) => self.reading(observable),
            Given::Twist(parameter) => self.si_reading(parameter),
        };
        let values = places.iter().map(|at| column.values[*at] * factor).collect();
        (Axis::new(column.given.name().replace('_', " "), unit), values)
    }

    fn compared(row: &FittedRow, observable: Observable) -> Option<&Compared> {
        row.compared.iter().find(|compared| compared.observable == observable)
    }

    /// Measured numbers with their errors, and the fitted ones.
    pub(super) fn data_charts(&self) -> Vec<Chart> {
        let chart = |observable: Observable| {
            let (axis, places) = self.below(observable);
            let (factor, unit) = self.reading(observable);
            let name = observable.name().replace('_', " ");
            let mut chart = Chart::new("", axis.clone(), Axis::new(name, unit)).with_size(400.0, 260.0);
            let mut bars = Vec::new();
            for (row, x) in self.answer().rows.iter().zip(&places) {
                let Some(compared) = Self::compared(row, observable) else { continue };
                let (y, e) = (compared.measured * factor, compared.error.unwrap_or(0.0) * factor.abs());
                bars.extend([(*x, y - e), (*x, y + e), (f64::NAN, f64::NAN)]);
                chart = chart
                    .with_marker(Marker::new("measured", *x, y, MarkerShape::Circle).with_colour(COLOURS[0]))
                    .with_marker(
                        Marker::new("fitted", *x, compared.fitted * factor, MarkerShape::Cross).with_colour(COLOURS[1]),
                    );
            }
            chart.with_curve(Curve::new("", bars).with_colour(COLOURS[0]).with_width(1.5))
        };
        self.measured().into_iter().map(chart).collect()
    }

    /// Residuals in errors; where errors are not known, in the column's unit.
    pub(super) fn residual_charts(&self) -> Vec<Chart> {
        let chart = |observable: Observable| {
            let (axis, places) = self.below(observable);
            let (factor, unit) = self.reading(observable);
            let name = format!("residual of {}", observable.name().replace('_', " "));
            let mut dots = Vec::new();
            let mut weighed = true;
            for (row, x) in self.answer().rows.iter().zip(&places) {
                let Some(compared) = Self::compared(row, observable) else { continue };
                weighed &= compared.standardised().is_some();
                dots.push((*x, compared.standardised().unwrap_or(compared.residual() * factor)));
            }
            let unit = if weighed { "errors".to_owned() } else { unit };
            let ends =
                dots.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (x, _)| (low.min(*x), high.max(*x)));
            let mut chart =
                Chart::new("", axis.clone(), Axis::new(name, unit)).with_size(400.0, 260.0).without_legend();
            chart = chart.with_curve(
                Curve::new("", [(ends.0, 0.0), (ends.1, 0.0)]).with_colour(COLOURS[2]).with_width(1.0).dashed(),
            );
            let alone = dots.iter().flat_map(|dot| [*dot, (f64::NAN, f64::NAN)]);
            chart = chart.with_curve(Curve::new("", alone).with_colour(COLOURS[0]));
            for (x, y) in dots {
                chart = chart.with_marker(Marker::new("", x, y, MarkerShape::Circle).with_colour(COLOURS[0]));
            }
            chart
        };
        self.measured().into_iter().map(chart).collect()
    }
}
