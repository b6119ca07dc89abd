//! A map as a table: one row a state.

use nply::mechanics::Stability;

use super::{Cell, Map, MapState};
use crate::table::{Column, Kind, Values};

impl Map {
    /// The columns of the map's table. Data are dimensionless, and in SI beside where the scale is known.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// let text = "ply.strands = 3\nstrand.stiffness_ratio = 0.75\ntwist.pretwist = -0.2\n\
    ///     [map]\nto.load = { force = 2, moment = 3 }\ncolumns = 4\nrows = 4\n";
    /// let map = Spec::from_toml("map.toml", text)?.check_map(None)?;
    /// assert_eq!(map.columns()[1].name, "moment");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn columns(&self) -> Vec<Column> {
        let mut columns = Vec::new();
        for axis in [&self.x, &self.y] {
            columns.push(Column::new(axis.datum.name(), Kind::Float));
        }
        for axis in [&self.x, &self.y] {
            if let Some((_, unit)) = axis.si(&self.case) {
                let name = format!("{}_{}", axis.datum.name(), crate::report::unit_suffix(unit));
                columns.push(Column::new(name, Kind::Float).with_unit(unit));
            }
        }
        columns.push(Column::new("states", Kind::Integer));
        columns.push(Column::new("state", Kind::Integer));
        columns.push(Column::new("handedness", Kind::Integer));
        columns.push(Column::new("helical_angle_deg", Kind::Float).with_unit("deg"));
        columns.push(Column::new("support", Kind::Text));
        columns.push(Column::new("separated", Kind::Boolean));
        columns.push(Column::new("stability", Kind::Text));
        for name in ["resultant_pressure", "interstrand_pressure", "core_pressure"] {
            columns.push(Column::new(name, Kind::Float));
        }
        columns
    }

    /// Rows of the map from `first` on as a stretch of its table: one row a state; a point without any has one row with empty cells.
    #[must_use]
    pub fn chunk(&self, first: usize, rows: &[Vec<Cell>]) -> Vec<Values> {
        let (mut across, mut up, mut counts, mut numbers) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut states: Vec<Option<&MapState>> = Vec::new();
        for (j, row) in rows.iter().enumerate() {
            let y = self.y.value(first + j);
            for (i, cell) in row.iter().enumerate() {
                let x = self.x.value(i);
                for k in 0..cell.states.len().max(1) {
                    across.push(x);
                    up.push(y);
                    counts.push(cell.states.len() as i64);
                    let state = cell.states.get(k);
                    numbers.push(state.map(|_| k as i64 + 1));
                    states.push(state);
                }
            }
        }
        let si: Vec<Values> = [(&self.x, &across), (&self.y, &up)]
            .into_iter()
            .filter_map(|(axis, values)| {
                let (factor, _) = axis.si(&self.case)?;
                Some(values.iter().map(|value| value * factor).collect::<Vec<f64>>().into())
            })
            .collect();
        let mut chunk: Vec<Values> = vec![across.into(), up.into()];
        chunk.extend(si);
        let float = |of: fn(&MapState) -> f64| -> Values {
            states.iter().map(|s| s.map(of)).collect::<Vec<Option<f64>>>().into()
        };
        let text = |of: fn(&MapState) -> Option<&'static str>| -> Values {
            states.iter().map(|s| s.and_then(of).map(str::to_owned)).collect::<Vec<Option<String>>>().into()
        };
        chunk.push(counts.into());
        chunk.push(numbers.into());
        chunk.push(states.iter().map(|s| s.map(|s| s.handedness.sign() as i64)).collect::<Vec<Option<i64>>>().into());
        chunk.push(float(|s| s.helical_angle_deg));
        chunk.push(text(|s| Some(s.support.name())));
        chunk.push(states.iter().map(|s| s.map(MapState::is_separated)).collect::<Vec<Option<bool>>>().into());
        chunk.push(text(|s| s.stability.map(Stability::name)));
        chunk.push(float(|s| s.resultant_pressure));
        chunk.push(float(|s| s.interstrand_pressure));
        chunk.push(float(|s| s.core_pressure));
        chunk
    }
}
