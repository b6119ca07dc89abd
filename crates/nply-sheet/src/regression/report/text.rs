//! As aligned tables.

use core::fmt::Write as _;

use super::{RegressionReport, plain};
use crate::preferred::six_digits;
use crate::regression::Observable;
use crate::regression::answer::Estimate;
use crate::regression::rows::free_loads;
use crate::report::{Emphasis, Row, lay_out};

/// Rows shown in a terminal; more are for a file.
const SHOWN: usize = 30;

impl RegressionReport {
    /// As aligned tables, with bold headings and coloured dots if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let marks = &Emphasis(emphasis);
        let mut out = String::new();
        let title = self
            .title
            .as_ref()
            .map_or_else(String::new, |title| format!("{}: ", title.replace(|c: char| c.is_control(), " ")));
        let model = &self.regression.model;
        let stretch = if model.stretches() { " that stretch" } else { "" };
        let headline = format!(
            "{title}{} strands{stretch}, {} balance, fitted to {} of {}",
            model.strands(),
            model.balance().name(),
            if self.regression.left_out.is_empty() {
                format!("{} row{}", self.answer.rows.len(), if self.answer.rows.len() == 1 { "" } else { "s" })
            } else {
                format!("{} of {} rows", self.answer.rows.len(), self.lines.len())
            },
            self.file.replace(|c: char| c.is_control(), " ")
        );
        let _ = writeln!(out, "{}", marks.heading(&headline));
        let _ = writeln!(out, "{}", self.roles());
        // each table as wide as it needs
        for table in self.tables() {
            lay_out(&mut out, &[table], marks);
        }
        for observable in self.measured() {
            lay_out(&mut out, &[("", self.residual_table(observable))], marks);
        }
        if self.answer.rows.len() > SHOWN {
            let _ = writeln!(out, "  … {} rows more, all with --output FILE", self.answer.rows.len() - SHOWN);
        }
        let _ = writeln!(out, "\n{}", self.chi());
        for chart in self.residual_charts() {
            let drawn = chart.text(72, 12);
            let _ = write!(out, "\n{}", if emphasis { drawn } else { plain(&drawn) });
        }
        for note in &self.answer.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// What is held and what is measured.
    fn roles(&self) -> String {
        let mut held: Vec<String> = self.names(true).into_iter().map(str::to_owned).collect();
        held.extend(self.assumed.iter().map(|load| format!("{} 0 (not given)", load.name())));
        let free: Vec<&str> = free_loads(self.columns()).into_iter().map(Observable::name).collect();
        format!(
            "held: {}{}; measured: {}",
            if held.is_empty() { "nothing".to_owned() } else { held.join(", ") },
            if free.is_empty() { String::new() } else { format!("; free: {}", free.join(", ")) },
            self.names(false).join(", ")
        )
    }

    fn chi(&self) -> String {
        let answer = &self.answer;
        let freedom = match answer.degrees_of_freedom {
            1 => "1 degree of freedom".to_owned(),
            many => format!("{many} degrees of freedom"),
        };
        if !answer.weighed {
            return format!("{freedom}; errors of the measurements from the residuals");
        }
        let chance = answer.probability.map_or_else(String::new, |chance| {
            format!(
                "; chance alone gives a greater one in {} of 100 cases",
                six_digits(libm::round(1000.0 * chance) / 10.0)
            )
        });
        format!("χ² = {}, {freedom}{chance}", six_digits(answer.chi_squared))
    }

    fn tables(&self) -> Vec<(&'static str, Vec<Row>)> {
        let row =
            |label: &str, unit: &str, cells: Vec<String>| Row { label: label.to_owned(), unit: unit.to_owned(), cells };
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let dash = || "–".to_owned();
        let mut estimates = vec![row("", "", words(&["value", "standard error", "start"]))];
        for Estimate { parameter, value, standard_error, start, determined, known_to } in &self.answer.estimates {
            let (factor, unit) = self.reading_of(*parameter, if *determined { *value } else { *start });
            let digits = |value: f64| six_digits(value * factor);
            let error = match standard_error {
                Some(error) => format!("{} ({})", three_digits(error * factor), percent(error / value.abs())),
                None if *determined => dash(),
                None => "not determined".to_owned(),
            };
            let value = if *determined { digits(*value) } else { dash() };
            let known = known_to.map_or_else(String::new, |error| format!(" ± {}", three_digits(error * factor)));
            estimates.push(row(parameter.name(), &unit, vec![value, error, digits(*start) + &known]));
        }
        let mut tables = vec![("Estimates", estimates)];
        if self.answer.estimates.len() > 1 {
            let names: Vec<&str> = self.answer.estimates.iter().map(|estimate| estimate.parameter.name()).collect();
            let mut rows = vec![row("", "", words(&names))];
            for (name, correlations) in names.iter().zip(&self.answer.correlation) {
                let cells = correlations.iter().map(|r| r.map_or_else(dash, |r| format!("{r:.3}")));
                rows.push(row(name, "", cells.collect()));
            }
            tables.push(("Correlation of the estimates", rows));
        }
        tables
    }

    fn residual_table(&self, observable: Observable) -> Vec<Row> {
        let (factor, unit) = self.reading(observable);
        let cells = |words: [&str; 6]| words.map(str::to_owned).to_vec();
        let mut rows = vec![
            Row {
                label: "Residuals, line".to_owned(),
                unit: String::new(),
                cells: cells(["hand", "angle", observable.name(), "fitted", "residual", "in errors"]),
            },
            Row { label: String::new(), unit: String::new(), cells: cells(["", "deg", &unit, &unit, &unit, ""]) },
        ];
        for fitted in self.answer.rows.iter().take(SHOWN) {
            let Some(compared) = fitted.compared.iter().find(|compared| compared.observable == observable) else {
                continue;
            };
            let hand = match fitted.handedness {
                _ if fitted.is_straight() => "–",
                nply::Handedness::Right => "Z",
                nply::Handedness::Left => "S",
            };
            let parted = if fitted.interstrand_pressure < 0.0 { " (separated)" } else { "" };
            let shown = [
                hand.to_owned(),
                format!("{:.3}", fitted.helical_angle.to_degrees()),
                six_digits(compared.measured * factor),
                six_digits(compared.fitted * factor),
                three_digits(compared.residual() * factor),
                compared.standardised().map_or_else(|| "–".to_owned(), |share| format!("{share:.2}")),
            ];
            rows.push(Row { label: format!("{}{parted}", fitted.line), unit: String::new(), cells: shown.to_vec() });
        }
        rows
    }
}

fn three_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    six_digits(rounded)
}

pub(in crate::regression) fn percent(share: f64) -> String {
    if share.is_finite() { format!("{} %", three_digits(100.0 * share)) } else { "–".to_owned() }
}
