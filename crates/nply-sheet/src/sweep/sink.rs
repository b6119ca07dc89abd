//! Columns of answers that are being filled.

use super::ask::Output;
use crate::report::{Find, Found, Given, Known};
use crate::table::{Kind, Values};

/// Answers to some rows.
pub(super) struct Answers {
    /// For each row of answers the place of the row it belongs to, from 0.
    pub(super) places: Vec<usize>,
    /// Which state of its row it is, from 1; none where no states are looked for.
    pub(super) state: Option<Values>,
    pub(super) outputs: Vec<Values>,
    pub(super) reason: Values,
}

/// Answers on their way.
pub(super) struct Sink<'o> {
    outputs: &'o [Output],
    places: Vec<usize>,
    states: Vec<Option<i64>>,
    columns: Vec<Cells>,
    reasons: Vec<(usize, String)>,
    /// factors of the sizes that were known last
    known: Option<Known>,
    factors: Vec<Option<f64>>,
}

enum Cells {
    Float(Vec<Option<f64>>),
    Integer(Vec<Option<i64>>),
    Boolean(Vec<Option<bool>>),
    Words(Vec<Option<&'static str>>),
}

impl<'o> Sink<'o> {
    pub(super) fn new(outputs: &'o [Output], rows: usize) -> Self {
        let columns = outputs
            .iter()
            .map(|output| match output.find.kind() {
                Kind::Float => Cells::Float(Vec::with_capacity(rows)),
                Kind::Integer => Cells::Integer(Vec::with_capacity(rows)),
                Kind::Boolean => Cells::Boolean(Vec::with_capacity(rows)),
                Kind::Text => Cells::Words(Vec::with_capacity(rows)),
            })
            .collect();
        Self {
            outputs,
            places: Vec::with_capacity(rows),
            states: Vec::with_capacity(rows),
            columns,
            reasons: Vec::new(),
            known: None,
            factors: Vec::new(),
        }
    }

    /// One state of a row.
    pub(super) fn push(&mut self, place: usize, state: Option<i64>, found: Found<'_>, given: &Given, known: Known) {
        if self.known != Some(known) {
            self.known = Some(known);
            self.factors = self.outputs.iter().map(|output| output.factor(known)).collect();
        }
        self.places.push(place);
        self.states.push(state);
        for ((output, cells), factor) in self.outputs.iter().zip(&mut self.columns).zip(&self.factors) {
            let find: Find = output.find;
            match cells {
                Cells::Float(cells) => {
                    let number = find.number(found, given).zip(*factor).map(|(number, factor)| number * factor);
                    cells.push(number.filter(|number| number.is_finite()));
                }
                Cells::Integer(cells) => cells.push(find.whole(found, given)),
                Cells::Boolean(cells) => cells.push(find.holds(found, given)),
                Cells::Words(cells) => cells.push(find.word(found, given)),
            }
        }
    }

    /// A row without an answer.
    pub(super) fn refuse(&mut self, place: usize, reason: String) {
        self.reasons.push((self.places.len(), reason));
        self.places.push(place);
        self.states.push(None);
        for cells in &mut self.columns {
            match cells {
                Cells::Float(cells) => cells.push(None),
                Cells::Integer(cells) => cells.push(None),
                Cells::Boolean(cells) => cells.push(None),
                Cells::Words(cells) => cells.push(None),
            }
        }
    }

    pub(super) fn finish(self, with_state: bool) -> Answers {
        let reason = reasons(self.reasons, self.places.len());
        let outputs = self.columns.into_iter().map(|cells| match cells {
            Cells::Float(cells) => Values::Float(cells),
            Cells::Integer(cells) => Values::Integer(cells),
            Cells::Boolean(cells) => Values::Boolean(cells),
            Cells::Words(cells) => Values::Words(cells),
        });
        Answers {
            places: self.places,
            state: with_state.then_some(Values::Integer(self.states)),
            outputs: outputs.collect(),
            reason,
        }
    }
}

/// The column of reasons, most of them empty.
pub(super) fn reasons(said: Vec<(usize, String)>, length: usize) -> Values {
    if said.is_empty() {
        return Values::Nothing(Kind::Text, length);
    }
    let mut cells = vec![None; length];
    for (at, reason) in said {
        if let Some(cell) = cells.get_mut(at) {
            *cell = Some(reason);
        }
    }
    Values::Text(cells)
}
