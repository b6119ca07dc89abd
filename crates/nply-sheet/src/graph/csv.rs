//! A graph's numbers as comma-separated values.

use nply::Handedness;

use super::{Graph, GraphCurve};
use crate::report::unit_suffix;

impl Graph {
    /// Every point of these curves: which ply, which curve, the datum, what is asked; all dimensionless, the datum also in the unit in which
    /// it runs, the others also in SI where the scale is known.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::graph::GraphFlags;
    /// let ply = Spec::from_flags([("strands", "2"), ("stiffness-ratio", "0.75")])?;
    /// let flags = GraphFlags { sweep: "pretwist=-1..1".into(), ask: vec!["helical_angle".into()], ..GraphFlags::default() };
    /// let graph = ply.check_graph(&flags)?;
    /// assert!(graph.csv(&graph.curves()).starts_with("strands,balance,handedness,separated,curve,pretwist,helical_angle_deg\n"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn csv(&self, curves: &[GraphCurve]) -> String {
        let known = self.known();
        let (datum, label, reading) = Graph { against: None, ..self.clone() }.axis(1.0);
        let mut names = ["strands", "balance", "handedness", "separated", "curve", datum].map(str::to_owned).to_vec();
        let columns: Vec<_> = self.against.iter().chain(&self.ask).copied().collect();
        // what runs as it was written, as on the axis of the picture
        let written = (!reading.unit.is_empty()).then(|| {
            let name = if self.asked.is_some() { label.replace(' ', "_") } else { datum.to_owned() };
            format!("{name}_{}", unit_suffix(&reading.unit))
        });
        let is_asked = |name: &String| columns.iter().any(|column| column.name == name);
        let written = written.filter(|name| !is_asked(name));
        names.extend(written.clone());
        for column in &columns {
            names.push(column.name.to_owned());
            names.extend(column.measure.si(known).map(|(_, unit)| format!("{}_{}", column.name, unit_suffix(unit))));
        }
        let mut text = names.join(",") + "\n";
        for (i, curve) in curves.iter().enumerate() {
            for point in &curve.points {
                let hand = if curve.handedness == Handedness::Right { "1" } else { "-1" };
                let mut cells = vec![
                    curve.strands.to_string(),
                    curve.balance.name().to_owned(),
                    hand.to_owned(),
                    curve.separated.to_string(),
                    (i + 1).to_string(),
                    // adding 0 takes the sign from a negative zero
                    (point.x + 0.0).to_string(),
                ];
                cells.extend(written.as_ref().map(|_| (point.x * reading.factor + 0.0).to_string()));
                for column in &columns {
                    let value = column.of(&point.state);
                    let cell = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
                    cells.push(cell(value));
                    cells.extend(column.measure.si(known).map(|(factor, _)| cell(value.map(|v| v * factor))));
                }
                text += &(cells.join(",") + "\n");
            }
        }
        text
    }
}
