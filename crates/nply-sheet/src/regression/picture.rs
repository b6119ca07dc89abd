//! Measurements beside the fitted states, and what is left of them.

use super::answer::{Compared, FittedRow};
use super::{Given, Observable, RegressionReport, Role};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape};

/// Blue for what is measured, vermilion for what is fitted, black for nothing.
const COLOURS: [usize; 3] = [0, 1, 6];

impl RegressionReport {
    /// What stands below: the first held column that differs from row to row, else the line.
    fn below(&self) -> (Axis, Vec<f64>) {
        let lines = || self.answer().rows.iter().map(|row| row.line as f64).collect::<Vec<_>>();
        let differs = |values: &[f64]| {
            let known: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
            known.len() == values.len() && known.iter().any(|value| (value - known[0]).abs() > 0.0)
        };
        let column = self.columns().iter().find(|column| column.role == Role::Held && differs(&column.values));
        let Some(column) = column else { return (Axis::new("line", ""), lines()) };
        let (factor, unit) = match column.given {
            Given::State(observable) => self.reading(observable),
            Given::Twist(_) => (1.0, String::new()),
        };
        // rows that say nothing are not among the fitted ones
        let place = |row: &FittedRow| {
            let at = self.place_of(row.line)?;
            Some(column.values[at] * factor)
        };
        let values: Option<Vec<f64>> = self.answer().rows.iter().map(place).collect();
        match values {
            Some(values) => (Axis::new(column.given.name().replace('_', " "), unit), values),
            None => (Axis::new("line", ""), lines()),
        }
    }

    fn compared(row: &FittedRow, observable: Observable) -> Option<&Compared> {
        row.compared.iter().find(|compared| compared.observable == observable)
    }

    /// Measured numbers with their errors, and the fitted ones.
    pub(super) fn data_charts(&self) -> Vec<Chart> {
        let (axis, places) = self.below();
        let chart = |observable: Observable| {
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
        let (axis, places) = self.below();
        let chart = |observable: Observable| {
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
