//! The fit as people read it: quantities down, layers across.

use core::fmt::Write as _;

use nply::geometry::LayerContact;

use super::figure::{Figure, OF_FORMULAS, OF_LAYER, OF_WHOLE, OfLayer, Sort};
use super::{FitReport, is_cored, is_rope, rods};
use crate::preferred::six_digits;
use crate::report::item::words;
use crate::report::text::{Emphasis, Row, hand, lay_out};
use crate::{Dimension, Unit};

impl FitReport {
    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let _ = writeln!(out, "{}", emphasis.heading(&self.headline()));
        let layers = self.of_layers();
        let mut head = Vec::new();
        if layers.len() > 1 {
            let numbers: Vec<String> = (1..=layers.len()).map(|at| at.to_string()).collect();
            head.push(words("layer", numbers.iter().map(String::as_str)));
        }
        if layers.iter().any(|layer| layer.given.hand.is_some()) {
            head.push(words("hand", layers.iter().map(|layer| layer.given.hand.map_or("–", hand))));
        }
        let wires: Vec<String> = layers.iter().map(|layer| layer.laid.wires().to_string()).collect();
        let rods = rods(&self.fit);
        head.push(words(rods, wires.iter().map(String::as_str)));
        head.push(words(
            if is_rope(&self.fit) { "strands lie on" } else { "wires lie on" },
            layers.iter().enumerate().map(|(at, layer)| self.lies_on(at, layer)),
        ));
        let mut parts = vec![("", head)];
        let laid_on_something = layers.iter().any(|layer| layer.laid.core_radius() > 0.0);
        for figure in OF_LAYER.iter().chain(&OF_FORMULAS).filter(|figure| !figure.label.is_empty()) {
            // without a core the wires are laid as they lie
            if !laid_on_something && (figure.heading.starts_with("As laid") || figure.name == "core_diameter") {
                continue;
            }
            self.put(&mut parts, figure, &layers);
        }
        let drawn_so = same(
            self.fit.nominal.last().map(|l| l.lay_radius()),
            self.fit.strand.layers().last().map(|l| l.taken_radius()),
        );
        for figure in OF_WHOLE.iter().filter(|figure| !(drawn_so && figure.name.starts_with("nominal"))) {
            self.put(&mut parts, figure, core::slice::from_ref(&self.fit));
        }
        lay_out(&mut out, &parts, &emphasis);
        for note in &self.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    fn headline(&self) -> String {
        let fit = &self.fit;
        let plain = |title: &String| title.replace(|c: char| c.is_control(), " ");
        let title = fit.title.as_ref().map_or(String::new(), |title| format!("{}: ", plain(title)));
        let core = if is_cored(fit) { "1 + " } else { "" };
        let wires: Vec<String> = fit.strand.layers().iter().map(|layer| layer.wires().to_string()).collect();
        format!("{title}{core}{} {}", wires.join(" + "), rods(fit))
    }

    fn lies_on(&self, at: usize, layer: &OfLayer) -> &'static str {
        match layer.laid.contact() {
            LayerContact::Core if at == 0 => "the core",
            LayerContact::Core => "the layer below",
            LayerContact::Neighbours => "each other",
            LayerContact::Both if at == 0 => "core and each other",
            LayerContact::Both => "both",
        }
    }

    /// What a figure is called: of a rope, whose rods are strands, as ropemakers say.
    fn label<T>(&self, figure: &Figure<T>) -> &'static str {
        match figure.name {
            "wire_diameter" if is_rope(&self.fit) => "strand diameter",
            "wire_length_ratio" if is_rope(&self.fit) => "strand length/rope length",
            "layer_mass_per_length" if is_rope(&self.fit) => "mass per rope length",
            _ => figure.label,
        }
    }

    /// A row below its heading; what nobody has a value of is left out.
    fn put<T>(&self, parts: &mut Vec<(&'static str, Vec<Row>)>, figure: &Figure<T>, all: &[T]) {
        let values: Vec<Option<f64>> = all.iter().map(|of| (figure.value)(of)).collect();
        if values.iter().all(Option::is_none) {
            return;
        }
        let largest = values.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
        let (name, unit) = self.reading(figure.sort, largest);
        let number = |value: f64| match (&unit, figure.sort) {
            (Some(unit), Sort::Area) => unit.of_si(unit.of_si(value)),
            (Some(unit), _) => unit.of_si(value),
            (None, _) => value,
        };
        let cell = |value: &Option<f64>| value.map_or_else(|| "–".to_owned(), |v| six_digits(number(v) + 0.0));
        let mark = if self.fit.found.contains(&figure.name) { " (found)" } else { "" };
        let row = Row {
            label: format!("{}{mark}", self.label(figure)),
            unit: name,
            cells: values.iter().map(cell).collect(),
        };
        match parts.last_mut() {
            Some((heading, rows)) if *heading == figure.heading => rows.push(row),
            _ => parts.push((figure.heading, vec![row])),
        }
    }

    /// The name of the unit a reader finds, and the unit a value in SI is divided by (once for a length, twice for an area).
    fn reading(&self, sort: Sort, largest: f64) -> (String, Option<Unit>) {
        let Some(length) = self.unit() else {
            return (if sort == Sort::Degrees { "deg".to_owned() } else { String::new() }, None);
        };
        match sort {
            Sort::Number => (String::new(), None),
            Sort::Degrees => ("deg".to_owned(), None),
            Sort::Length => (length.to_string(), Some(length)),
            Sort::Area => (format!("{length}²"), Some(length)),
            Sort::LinearDensity => {
                let unit = self.fit.units.unit(Dimension::LINEAR_DENSITY, largest);
                match unit.as_str() {
                    "" | "N m^-2 s^2" => ("kg/m".to_owned(), None),
                    written => (written.to_owned(), Some(unit)),
                }
            }
        }
    }
}

/// Equal to within rounding.
fn same(a: Option<f64>, b: Option<f64>) -> bool {
    matches!((a, b), (Some(a), Some(b)) if (a - b).abs() <= 1e-12 * a.abs())
}
