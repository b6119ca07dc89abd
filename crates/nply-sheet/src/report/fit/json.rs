//! The fit for programs: JSON and CSV.

use serde_json::{Map, Value, json};

use super::FitReport;
use super::figure::{Figure, OF_FORMULAS, OF_LAYER, OF_WHOLE, OfLayer, Sort};
use crate::Unit;
use crate::report::csv::unit_suffix;
use crate::report::json::header;

/// A figure's numbers by name: in the written unit, and in SI with the unit behind the name.
fn named<T>(figure: &Figure<T>, of: &T, unit: Option<&Unit>) -> Vec<(String, Option<f64>)> {
    let value = (figure.value)(of).filter(|value| value.is_finite()).map(|value| value + 0.0);
    let name = figure.name.to_owned();
    let Some(unit) = unit else { return vec![(name, value)] };
    let written = |value: f64| match figure.sort {
        Sort::Area => unit.of_si(unit.of_si(value)),
        _ => unit.of_si(value),
    };
    let Some(si) = si(figure.sort) else { return vec![(name, value)] };
    let measured = (format!("{name}_{}", unit_suffix(si)), value);
    match figure.sort {
        Sort::LinearDensity => vec![measured],
        _ => vec![(name, value.map(written)), measured],
    }
}

/// The SI unit of what has one.
pub(super) const fn si(sort: Sort) -> Option<&'static str> {
    match sort {
        Sort::Number | Sort::Degrees => None,
        Sort::Length => Some("m"),
        Sort::Area => Some("m^2"),
        Sort::LinearDensity => Some("kg/m"),
    }
}

impl FitReport {
    /// As JSON. Lengths are in the unit of `length_unit`, the first that was written; where there is one they stand in metres too, under
    /// names that end in `_m`. Where nothing has a unit they are in the bare unit of the input. A single layer's numbers stand at the top as well.
    #[must_use]
    pub fn json(&self) -> String {
        let unit = self.unit();
        let mut top = header();
        if let Some(title) = &self.fit.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("length_unit".into(), json!(unit.as_ref().map(Unit::as_str)));
        top.insert("found".into(), json!(self.fit.found));
        let layers: Vec<Map<String, Value>> = self.layers_json(unit.as_ref());
        if let [only] = layers.as_slice() {
            top.extend(only.clone());
        }
        for figure in &OF_WHOLE {
            top.extend(named(figure, &self.fit, unit.as_ref()).into_iter().map(|(name, value)| (name, json!(value))));
        }
        top.insert("layers".into(), json!(layers));
        top.insert("notes".into(), json!(self.notes));
        format!("{:#}\n", Value::Object(top))
    }

    fn layers_json(&self, unit: Option<&Unit>) -> Vec<Map<String, Value>> {
        let object = |layer: OfLayer| {
            let mut object = Map::new();
            object.insert("wires".into(), json!(layer.laid.wires()));
            for (name, word) in words(&layer) {
                object.insert(name.into(), json!(word));
            }
            for figure in OF_LAYER.iter().chain(&OF_FORMULAS) {
                object.extend(named(figure, &layer, unit).into_iter().map(|(name, value)| (name, json!(value))));
            }
            object
        };
        self.of_layers().into_iter().map(object).collect()
    }

    /// A header and one row a layer, from the inside; the strand's own numbers are repeated in each. Named as in JSON.
    #[must_use]
    pub fn csv(&self) -> String {
        let unit = self.unit();
        let unit = unit.as_ref();
        let mut out = String::new();
        for (at, layer) in self.of_layers().into_iter().enumerate() {
            let mut cells =
                vec![("layer".to_owned(), (at + 1).to_string()), ("wires".to_owned(), layer.laid.wires().to_string())];
            cells.extend(words(&layer).map(|(name, word)| (name.to_owned(), word.unwrap_or("").to_owned())));
            let text =
                |(name, value): (String, Option<f64>)| (name, value.map_or_else(String::new, |v| format!("{v:?}")));
            for figure in OF_LAYER.iter().chain(&OF_FORMULAS) {
                cells.extend(named(figure, &layer, unit).into_iter().map(text));
            }
            for figure in &OF_WHOLE {
                cells.extend(named(figure, &self.fit, unit).into_iter().map(text));
            }
            let (names, values): (Vec<String>, Vec<String>) = cells.into_iter().unzip();
            if at == 0 {
                out += &(names.join(",") + "\n");
            }
            out += &(values.join(",") + "\n");
        }
        out
    }
}

/// What is said of a layer in words.
fn words(layer: &OfLayer) -> [(&'static str, Option<&'static str>); 2] {
    let letter = layer.given.hand.map(|hand| if hand == nply::Handedness::Right { "Z" } else { "S" });
    [("contact", Some(layer.laid.contact().name())), ("lay", letter)]
}
