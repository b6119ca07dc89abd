//! The report as a table for a spreadsheet: one row a state.

use super::{Report, margin, verdict::Verdicts};

impl Report {
    /// A header and one row a state. Columns are named as in JSON; those in SI, where the scale is known, have their unit
    /// behind the name, as `lay_length_m`.
    #[must_use]
    pub fn csv(&self) -> String {
        if let Some(supported) = &self.solution.supported {
            return super::support::csv(self, supported);
        }
        if let Some(stretched) = &self.solution.stretched {
            return super::support::csv(self, stretched);
        }
        let entries = self.entries();
        let si: Vec<_> = entries.iter().filter_map(|c| Some((c, c.measure.si(self.known())?))).collect();
        let mut head: Vec<String> =
            ["strands", "stiffness_ratio", "balance", "state", "handedness", "lay", "separated", "stability", "fold"]
                .map(String::from)
                .into();
        let held = |verdicts: Verdicts| verdicts.named().into_iter().filter(|(name, ..)| *name != "dead_loads");
        head.extend(held(Verdicts::default()).map(|(name, ..)| format!("stability_{name}")));
        head.extend(entries.iter().map(|entry| entry.name.to_owned()));
        head.extend(si.iter().map(|(entry, (_, unit))| format!("{}_{}", entry.name, unit_suffix(unit))));
        head.extend(margin::csv_head(self.known()));
        let mut out = head.join(",") + "\n";
        for (i, state) in self.solution.states.iter().enumerate() {
            let mut cells = vec![
                self.case.strands.to_string(),
                self.case.stiffness_ratio.to_string(),
                self.case.balance.name().to_owned(),
                (i + 1).to_string(),
                state.handedness().sign().to_string(),
                state.handedness().lay_letter().to_string(),
                (state.is_separated() && !super::at_separation(&self.case)).to_string(),
                state.stability().map_or("", |_| super::text::verdict(state)).to_owned(),
                state.is_fold().to_string(),
            ];
            let text = |value: Option<f64>| value.map_or_else(String::new, |v| format!("{v:?}"));
            cells.extend(
                held(Verdicts::of(state)).map(|(.., verdict)| verdict.map_or("", |verdict| verdict.name()).to_owned()),
            );
            cells.extend(entries.iter().map(|entry| text(entry.values[i])));
            cells.extend(si.iter().map(|(entry, (factor, _))| text(entry.values[i].map(|v| v * factor))));
            cells.extend(margin::csv_cells(&self.margins(state), self.known()));
            out += &(cells.join(",") + "\n");
        }
        out
    }
}

/// A unit as part of a name: `N m^2` as `N_m2`, `rad/(N m)` as `rad_per_N_m`.
pub(crate) fn unit_suffix(unit: &str) -> String {
    unit.replace("1/", "per_").replace('/', "_per_").replace(' ', "_").replace(['^', '(', ')'], "")
}
