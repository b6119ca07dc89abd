//! For programs.

use serde_json::{Map, Value, json};

use super::RegressionReport;
use crate::regression::Observable;
use crate::regression::answer::{Estimate, FittedRow};
use crate::report::header;

impl RegressionReport {
    /// As JSON: numbers in the units that stand beside them; what is not determined is null.
    #[must_use]
    pub fn json(&self) -> String {
        let answer = &self.answer;
        let mut top = header();
        if let Some(title) = &self.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("strands".into(), json!(self.regression.model.strands()));
        top.insert("balance".into(), json!(self.regression.model.balance().name()));
        top.insert("held".into(), json!(self.names(true)));
        top.insert("taken_as_zero".into(), json!(self.assumed.iter().map(|load| load.name()).collect::<Vec<_>>()));
        top.insert("measured".into(), json!(self.names(false)));
        let estimate = |estimate: &Estimate| {
            let (factor, unit) = self.si_of(estimate.parameter);
            json!({
                "name": estimate.parameter.name(),
                "unit": unit,
                "value": estimate.determined.then_some(estimate.value * factor),
                "standard_error": estimate.standard_error.map(|error| error * factor),
                "start": estimate.start * factor,
                "known_to": estimate.known_to.map(|error| error * factor),
            })
        };
        top.insert("estimates".into(), answer.estimates.iter().map(estimate).collect());
        top.insert("correlation".into(), json!(answer.correlation));
        top.insert("chi_squared".into(), json!(answer.weighed.then_some(answer.chi_squared)));
        top.insert("degrees_of_freedom".into(), json!(answer.degrees_of_freedom));
        top.insert("probability".into(), json!(answer.probability));
        top.insert("errors_given".into(), json!(answer.weighed));
        let mut units = Map::new();
        for observable in [Observable::Force, Observable::Moment].into_iter().chain(self.measured()) {
            units.insert(observable.name().into(), json!(self.si(observable).1));
        }
        top.insert("units".into(), Value::Object(units));
        top.insert("rows".into(), answer.rows.iter().map(|row| self.row(row)).collect());
        top.insert("notes".into(), json!(answer.notes));
        format!("{:#}\n", Value::Object(top))
    }

    fn row(&self, fitted: &FittedRow) -> Value {
        let compared = fitted.compared.iter().map(|compared| {
            let factor = self.si(compared.observable).0;
            json!({
                "name": compared.observable.name(),
                "measured": compared.measured * factor,
                "fitted": compared.fitted * factor,
                "residual": compared.residual() * factor,
                "error": compared.error.map(|error| error * factor),
                "standardised": compared.standardised(),
            })
        });
        json!({
            "line": fitted.line,
            "handedness": fitted.handedness.sign() as i8,
            "helical_angle_deg": fitted.helical_angle.to_degrees(),
            "force": fitted.force,
            "moment": fitted.moment,
            "interstrand_pressure": fitted.interstrand_pressure,
            "separated": fitted.interstrand_pressure < 0.0,
            "states": fitted.states,
            "next_state_chi_squared": fitted.next_state,
            "compared": compared.collect::<Vec<_>>(),
        })
    }
}
