//! The cable as people read it.

use core::fmt::Write as _;

use super::StiffnessReport;
use super::figure::{Figure, OF_CABLE, OF_MEMBER, SMALL, Sort};
use crate::preferred::six_digits;
use crate::report::item::words;
use crate::report::text::{Emphasis, Row, hand, largest, lay_out};
use crate::{Dimension, Unit};

impl StiffnessReport {
    /// As aligned tables, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let _ = writeln!(out, "{}", emphasis.heading(&self.headline()));
        let mut parts: Vec<(&str, Vec<Row>)> = Vec::new();
        let whole = self.whole();
        for figure in &OF_CABLE {
            self.put(&mut parts, figure, &OF_CABLE, core::slice::from_ref(&whole));
        }
        lay_out(&mut out, &parts, &emphasis);
        let members = self.members();
        let mut number = 0;
        let names: Vec<String> = members
            .iter()
            .map(|member| {
                number += usize::from(member.layer.is_some());
                if member.layer.is_some() { format!("layer {number}") } else { "core".to_owned() }
            })
            .collect();
        let count = |n: u32, strand: bool| if strand { format!("{n} strands") } else { format!("{n} wires") };
        let made: Vec<String> = members
            .iter()
            .map(|member| {
                member.layer.map_or_else(
                    || "1".to_owned(),
                    |layer| count(layer.layer.strands, layer.layer.rod.youngs_modulus().is_none()),
                )
            })
            .collect();
        let head = vec![
            words("", names.iter().map(String::as_str)),
            words("", made.iter().map(String::as_str)),
            words("hand", members.iter().map(|member| member.layer.map_or("–", |layer| hand(layer.layer.handedness)))),
            words(
                "carried by",
                members.iter().map(|member| {
                    member.layer.map_or("–", |layer| match layer.support {
                        nply::mechanics::LayerSupport::Below => "what is below",
                        nply::mechanics::LayerSupport::Neighbours => "each other",
                        nply::mechanics::LayerSupport::Both => "both",
                    })
                }),
            ),
        ];
        let mut parts = vec![("", head)];
        for figure in OF_MEMBER.iter().filter(|figure| !figure.label.is_empty()) {
            self.put(&mut parts, figure, &OF_MEMBER, &members);
        }
        lay_out(&mut out, &parts, &emphasis);
        for note in &self.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    fn headline(&self) -> String {
        let construction = &self.case.construction;
        let plain = |title: &String| title.replace(|c: char| c.is_control(), " ");
        let title = construction.title.as_ref().map_or(String::new(), |title| format!("{}: ", plain(title)));
        let core = if construction.core.is_some() { "1 + " } else { "" };
        let layers: Vec<String> = construction.layers.iter().map(|layer| layer.wires.to_string()).collect();
        let rods = if construction.layers.iter().any(|layer| layer.strand.is_some()) { "strands" } else { "wires" };
        format!("{title}{core}{} {rods}", layers.join(" + "))
    }

    /// A row below its heading, in one unit with the others of its sort there; what nobody has a value of is left out.
    fn put<T>(&self, parts: &mut Vec<(&'static str, Vec<Row>)>, figure: &Figure<T>, figures: &[Figure<T>], all: &[T]) {
        let values_of = |figure: &Figure<T>| -> Vec<Option<f64>> { all.iter().map(|of| (figure.value)(of)).collect() };
        let values = values_of(figure);
        if values.iter().all(Option::is_none) {
            return;
        }
        // lengths, from a gap to a diameter, are each read by themselves; one that is zero goes with the others
        let own = largest(&values);
        let size = if figure.sort == Sort::Of(Dimension::LENGTH) && own > 0.0 {
            own
        } else {
            let beside = figures.iter().filter(|other| (other.heading, other.sort) == (figure.heading, figure.sort));
            beside.map(|other| largest(&values_of(other))).fold(0.0, f64::max)
        };
        let (unit, factor) = self.reading(figure.sort, size, figure.heading == SMALL);
        let cell = |value: &Option<f64>| value.map_or_else(|| "–".to_owned(), |v| six_digits(v * factor + 0.0));
        let label = match self.is_rope() {
            true => figure.label.replace("a wire", "a strand"),
            false => figure.label.to_owned(),
        };
        let row = Row { label, unit, cells: values.iter().map(cell).collect() };
        match parts.last_mut() {
            Some((heading, rows)) if *heading == figure.heading => rows.push(row),
            _ => parts.push((figure.heading, vec![row])),
        }
    }

    /// The name of the unit a reader finds, and what a value is multiplied by. A stiffness is the cable's own: the unit of a load does not change it.
    fn reading(&self, sort: Sort, largest: f64, stiffness: bool) -> (String, f64) {
        let construction = &self.case.construction;
        // nothing is told in the unit that one would be
        let unit = |dimension, si: f64| construction.units.unit(dimension, if si == 0.0 { 1.0 } else { si });
        match sort {
            Sort::Number => (String::new(), 1.0),
            Sort::Percent => ("%".to_owned(), 100.0),
            Sort::Degrees => ("deg".to_owned(), 1.0),
            _ if !construction.measured => (String::new(), 1.0),
            Sort::Of(Dimension::AREA) => {
                let length = unit(Dimension::LENGTH, libm::sqrt(largest));
                let one = length.of_si(1.0);
                (format!("{length}²"), one * one)
            }
            Sort::Stress => {
                let unit = self.stress_unit();
                (unit.to_string(), unit.of_si(1.0))
            }
            Sort::Of(dimension) => {
                let unit = if stiffness {
                    construction.units.unit_by_size(dimension, largest)
                } else {
                    unit(dimension, largest)
                };
                (unit.to_string(), unit.of_si(1.0))
            }
            Sort::Unlay => {
                let force = unit(Dimension::FORCE, 1e3);
                let turning = unit(Dimension::ANGLE_PER_LENGTH, largest * force.to_si(1.0));
                (format!("{turning} per {force}"), turning.of_si(1.0) * Unit::to_si(&force, 1.0))
            }
        }
    }
}
