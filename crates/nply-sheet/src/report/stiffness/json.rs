//! The cable for programs: JSON and CSV.

use serde_json::{Map, Value, json};

use super::StiffnessReport;
use super::figure::{Figure, Member, OF_CABLE, OF_MEMBER, Sort, stress};
use crate::Dimension;
use crate::report::csv::unit_suffix;
use crate::report::json::header;

impl StiffnessReport {
    /// The name of a figure: with its SI unit behind it where the input has units.
    fn name(&self, name: &str, sort: Sort) -> String {
        match unit(sort).filter(|_| self.case.construction.measured) {
            None => name.to_owned(),
            Some(unit) => format!("{name}_{}", unit_suffix(unit)),
        }
    }

    fn named<T>(&self, figure: &Figure<T>, of: &T) -> (String, Option<f64>) {
        let value = (figure.value)(of).filter(|value| value.is_finite()).map(|value| value + 0.0);
        (self.name(figure.name, figure.sort), value)
    }

    /// As JSON: SI with the unit behind each name where the input has units, else the input's own bare units; strains and shares as pure numbers.
    #[must_use]
    pub fn json(&self) -> String {
        let mut top = header();
        if let Some(title) = &self.case.construction.title {
            top.insert("title".into(), json!(title));
        }
        let whole = self.whole();
        for figure in &OF_CABLE {
            let (name, value) = self.named(figure, &whole);
            top.insert(name, json!(value));
        }
        top.insert("lifts_off".into(), json!(self.state.lifts()));
        let members: Vec<Map<String, Value>> = self.members().iter().map(|member| self.object(member)).collect();
        let cored = self.state.cable().core().is_some();
        top.insert("core".into(), json!(if cored { members.first() } else { None }));
        top.insert("layers".into(), json!(members.iter().skip(usize::from(cored)).collect::<Vec<_>>()));
        if let Some(lays) = &self.lays {
            let of =
                |fits: bool| lays.iter().filter(|lay| lay.fits == fits).map(|lay| lay.lay_length).collect::<Vec<f64>>();
            for (name, fits) in [("lay_lengths_for_torque_factor", true), ("lay_lengths_that_do_not_fit", false)] {
                top.insert(self.name(name, Sort::Of(Dimension::LENGTH)), json!(of(fits)));
            }
        }
        if let Some(pretwist) = self.pretwist {
            top.insert(self.name("pretwist_for_no_moment", Sort::Of(Dimension::ANGLE_PER_LENGTH)), json!(pretwist));
        }
        top.insert("notes".into(), json!(self.notes));
        format!("{:#}\n", Value::Object(top))
    }

    fn object(&self, member: &Member) -> Map<String, Value> {
        let mut object = Map::new();
        for (name, word) in words(member) {
            object.insert(name.into(), json!(word));
        }
        object.insert("wires".into(), json!(member.layer.map_or(1, |layer| layer.layer.strands)));
        object.extend(OF_MEMBER.iter().map(|figure| {
            let (name, value) = self.named(figure, member);
            (name, json!(value))
        }));
        object
    }

    /// A header and one row for the core and each layer, from the inside; the cable's own numbers are repeated in each. Named as in JSON.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut out = String::new();
        let (whole, cored) = (self.whole(), self.state.cable().core().is_some());
        for (at, member) in self.members().iter().enumerate() {
            let text =
                |(name, value): (String, Option<f64>)| (name, value.map_or_else(String::new, |v| format!("{v:?}")));
            let number = if cored { at } else { at + 1 };
            let mut cells = vec![("layer".to_owned(), number.to_string())];
            cells.extend(words(member).map(|(name, word)| (name.to_owned(), word.unwrap_or("").to_owned())));
            cells.push(("wires".to_owned(), member.layer.map_or(1, |layer| layer.layer.strands).to_string()));
            cells.extend(OF_MEMBER.iter().map(|figure| text(self.named(figure, member))));
            cells.extend(OF_CABLE.iter().map(|figure| {
                let (name, value) = text(self.named(figure, &whole));
                (format!("cable_{name}"), value)
            }));
            let (names, values): (Vec<String>, Vec<String>) = cells.into_iter().unzip();
            if at == 0 {
                out += &(names.join(",") + "\n");
            }
            out += &(values.join(",") + "\n");
        }
        out
    }
}

/// What is said of a member in words: the hand, what carries it, where its wires are pulled most.
fn words(member: &Member) -> [(&'static str, Option<&'static str>); 3] {
    let letter = member.layer.map(|layer| if layer.layer.handedness == nply::Handedness::Right { "Z" } else { "S" });
    let fibre = member.layer.filter(|_| stress(member).is_some()).map(|layer| {
        if layer.bending_strain > 0.0 {
            "outer"
        } else if layer.bending_strain < 0.0 {
            "inner"
        } else {
            "all"
        }
    });
    [("lay", letter), ("support", member.layer.map(|layer| layer.support.name())), ("greatest_stress_at", fibre)]
}

/// The SI unit of what has one, as it is written in names.
pub(super) fn unit(sort: Sort) -> Option<&'static str> {
    match sort {
        Sort::Number | Sort::Percent => None,
        Sort::Degrees => Some("deg"),
        Sort::Stress => Some("Pa"),
        Sort::Of(dimension) => Some(dimension_unit(dimension)),
        Sort::Unlay => Some("rad/m/N"),
    }
}

const fn dimension_unit(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::ANGLE_PER_LENGTH => "rad/m",
        Dimension::FORCE => "N",
        Dimension::MOMENT => "N m",
        Dimension::STIFFNESS => "N m2",
        Dimension::LENGTH => "m",
        Dimension::AREA => "m2",
        Dimension::PRESSURE => "Pa",
        Dimension::FORCE_PER_LENGTH => "N/m",
        _ => "",
    }
}
