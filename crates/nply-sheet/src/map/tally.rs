//! What a map holds, counted.

use core::fmt::Write as _;

use super::{Axis, Cell, Map, Verdict};
use crate::preferred::six_digits;

/// How many points have how many states, and what can be had at them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    counts: Vec<u64>,
    verdicts: [u64; 5],
}

impl Tally {
    /// Adds a row's points.
    pub fn add(&mut self, map: &Map, cells: &[Cell]) {
        for cell in cells {
            let count = cell.states.len();
            if self.counts.len() <= count {
                self.counts.resize(count + 1, 0);
            }
            self.counts[count] += 1;
            self.verdicts[cell.verdict(map.balance()).number() as usize] += 1;
        }
    }

    /// All points.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// All states.
    #[must_use]
    pub fn states(&self) -> u64 {
        self.counts.iter().zip(0_u64..).map(|(points, states)| points * states).sum()
    }

    /// A few lines for a reader.
    #[must_use]
    pub fn text(&self, map: &Map) -> String {
        let case = map.case();
        let axis = |axis: &Axis| {
            let reading = axis.reading(case);
            let [from, to] = [axis.from, axis.to].map(|value| six_digits(value * reading.factor));
            format!("{} {from} to {to} {}", axis.datum.label(), reading.unit).trim_end().to_owned()
        };
        let title = case
            .title
            .as_ref()
            .map_or(String::new(), |title| format!("{}: ", title.replace(|c: char| c.is_control(), " ")));
        let held: Vec<String> = map
            .held()
            .into_iter()
            .map(|(datum, value)| {
                let reading = datum.reading(case, value.abs());
                format!("{} {} {}", datum.label(), six_digits(value * reading.factor), reading.unit)
                    .trim_end()
                    .to_owned()
            })
            .collect();
        let mut out = format!(
            "{title}{} strands, {} × {} points, {} states\n  across  {}\n  up      {}\n  held    {}\n",
            case.strands,
            map.x.count,
            map.y.count,
            self.states(),
            axis(&map.x),
            axis(&map.y),
            held.join(", "),
        );
        let points = self.points().max(1) as f64;
        let percent = |count: u64| 100.0 * count as f64 / points;
        for (states, &count) in self.counts.iter().enumerate().filter(|(_, count)| **count > 0) {
            let plural = if states == 1 { "state " } else { "states" };
            let _ = writeln!(out, "  {states} {plural}  {:6.2} % of the points", percent(count));
        }
        for verdict in Verdict::ALL {
            let count = self.verdicts[verdict.number() as usize];
            if count > 0 {
                let _ = writeln!(out, "  {:<24}{:6.2} %", map.words(verdict), percent(count));
            }
        }
        out
    }
}
