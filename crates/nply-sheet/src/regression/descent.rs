//! Least squares over all rows: what Levenberg and Marquardt's method walks down.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{DMatrix, DVector, Dyn, storage::Owned};
use nply::mechanics::Ply;

use super::Parameter;
use super::row::{Row, Settled, stacked};
use super::sensed::SLOTS;
use super::state::{Model, Spot};

/// A number of the strands that is sought, and known beforehand with an error: one more measurement, of itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Known {
    pub(super) parameter: Parameter,
    pub(super) value: f64,
    /// one standard error
    pub(super) error: f64,
}

impl Known {
    /// Sought less known, in errors.
    fn residual(&self, model: &Model, slots: &[f64; SLOTS]) -> f64 {
        model.value_at(slots, self.parameter).map_or(f64::NAN, |value| (value - self.value) / self.error)
    }

    /// Its slope with the slot it is sought by, which holds the logarithm of what is positive.
    fn slope(&self, model: &Model, slots: &[f64; SLOTS]) -> f64 {
        let by_slot = if self.parameter.is_positive() { model.value_at(slots, self.parameter) } else { Some(1.0) };
        by_slot.unwrap_or(f64::NAN) / self.error
    }
}

/// What a walk goes over.
#[derive(Clone, Copy)]
pub(super) struct Ground<'a> {
    pub(super) model: &'a Model,
    pub(super) charted: &'a Ply,
    pub(super) rows: &'a [Row],
    /// what is known beforehand of what is sought
    pub(super) known: &'a [Known],
    /// which slots are sought
    pub(super) free: &'a [usize],
    /// the size of one step in each
    pub(super) sizes: &'a [f64],
    /// asked at every row; once it says no, rows are lost and the walk ends soon
    pub(super) may_go_on: &'a dyn Fn() -> bool,
}

/// Where a walk ended.
#[derive(Clone, Debug)]
pub(super) struct Bottom {
    pub(super) slots: [f64; SLOTS],
    pub(super) settled: Vec<Settled>,
    pub(super) chi_squared: f64,
    pub(super) converged: bool,
}

struct Walk<'a> {
    ground: Ground<'a>,
    x: DVector<f64>,
    slots: [f64; SLOTS],
    /// from where each row's state is continued: those of the best place so far
    anchors: Vec<Spot>,
    settled: Option<Vec<Settled>>,
    kept: ([f64; SLOTS], Vec<Settled>),
    best: f64,
    count: usize,
}

impl Ground<'_> {
    /// The sum of squares, of the rows and of what is known beforehand.
    fn sum(&self, slots: &[f64; SLOTS], settled: &[Settled]) -> f64 {
        let of_known = self.known.iter().map(|known| known.residual(self.model, slots));
        settled.iter().map(Settled::chi_squared).sum::<f64>() + of_known.map(|r| r * r).sum::<f64>()
    }

    /// The slopes of all residuals with what is sought, those of the rows first.
    pub(super) fn slopes(&self, slots: &[f64; SLOTS], settled: &[Settled]) -> DMatrix<f64> {
        let rows = stacked(settled, self.free, self.sizes);
        let count = rows.nrows();
        let mut all = rows.resize_vertically(count + self.known.len(), 0.0);
        for (i, known) in self.known.iter().enumerate() {
            let slot = known.parameter.slot() as usize;
            if let Some(k) = self.free.iter().position(|free| *free == slot) {
                all[(count + i, k)] = known.slope(self.model, slots) * self.sizes[k];
            }
        }
        all
    }

    /// Each row's state nearest to it under some parameters; or the lines without one.
    pub(super) fn search(&self, slots: &[f64; SLOTS]) -> Result<Vec<Settled>, Vec<usize>> {
        let nearest = |row: &Row| {
            if !(self.may_go_on)() {
                return None;
            }
            let strand = self.model.strand(slots, row.twist);
            row.candidates(self.model, self.charted, &strand).into_iter().next()
        };
        let found: Vec<Option<Settled>> = self.rows.iter().map(nearest).collect();
        let lost: Vec<usize> =
            found.iter().zip(self.rows).filter(|(state, _)| state.is_none()).map(|(_, row)| row.line).collect();
        if lost.is_empty() { Ok(found.into_iter().flatten().collect()) } else { Err(lost) }
    }

    /// Each row's state continued from where it was; one that is lost is searched for.
    fn follow(&self, slots: &[f64; SLOTS], anchors: &[Spot]) -> Option<Vec<Settled>> {
        let settle = |(row, spot): (&Row, &Spot)| {
            if !(self.may_go_on)() {
                return None;
            }
            let strand = self.model.strand(slots, row.twist);
            row.settle(self.model, self.charted, &strand, *spot)
                .or_else(|| row.candidates(self.model, self.charted, &strand).into_iter().next())
        };
        self.rows.iter().zip(anchors).map(settle).collect()
    }

    /// From some parameters downhill, each row on the branch it is nearest to; where a row turns out to be nearer to another, again.
    pub(super) fn descend(&self, slots: [f64; SLOTS]) -> Result<Bottom, Vec<usize>> {
        const MOST_CHANGES: usize = 8;
        let mut start = (slots, self.search(&slots)?);
        let mut bottom = self.walk(start.0, start.1);
        for _ in 0..MOST_CHANGES {
            let Ok(nearest) = self.search(&bottom.slots) else { break };
            let nearer = |(new, old): (&Settled, &Settled)| {
                let (new, old) = (new.chi_squared(), old.chi_squared());
                new < old - 1e-9 * (1.0 + old)
            };
            if !nearest.iter().zip(&bottom.settled).any(nearer) {
                break;
            }
            start = (bottom.slots, nearest);
            let next = self.walk(start.0, start.1);
            if next.chi_squared >= bottom.chi_squared {
                break;
            }
            bottom = next;
        }
        Ok(bottom)
    }

    fn walk(&self, slots: [f64; SLOTS], settled: Vec<Settled>) -> Bottom {
        let x =
            DVector::from_iterator(self.free.len(), self.free.iter().zip(self.sizes).map(|(k, size)| slots[*k] / size));
        let walk = Walk {
            ground: *self,
            x,
            slots,
            anchors: settled.iter().map(|row| row.spot).collect(),
            best: self.sum(&slots, &settled),
            count: settled.iter().map(|row| row.residuals.len()).sum::<usize>() + self.known.len(),
            settled: Some(settled.clone()),
            kept: (slots, settled),
        };
        let (walk, report) = LevenbergMarquardt::new().with_patience(60).minimize(walk);
        // the best place seen, not the last one tried
        let (slots, settled) = walk.kept;
        let chi_squared = self.sum(&slots, &settled);
        let converged = report.termination.was_successful()
            || matches!(report.termination, levenberg_marquardt::TerminationReason::NoImprovementPossible(_));
        Bottom { slots, settled, chi_squared, converged }
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Walk<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.x.copy_from(x);
        for ((k, size), x) in self.ground.free.iter().zip(self.ground.sizes).zip(x.iter()) {
            self.slots[*k] = x * size;
        }
        self.settled = self.ground.follow(&self.slots, &self.anchors);
        if let Some(settled) = &self.settled
            && self.ground.sum(&self.slots, settled) <= self.best
        {
            self.best = self.ground.sum(&self.slots, settled);
            self.anchors = settled.iter().map(|row| row.spot).collect();
            self.kept = (self.slots, settled.clone());
        }
    }

    fn params(&self) -> DVector<f64> {
        self.x.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(match &self.settled {
            Some(settled) => {
                let known = self.ground.known.iter().map(|known| known.residual(self.ground.model, &self.slots));
                let rows = settled.iter().flat_map(|row| row.residuals.iter().copied());
                DVector::from_iterator(self.count, rows.chain(known))
            }
            // a row without a state is a wall: worse than any place seen, so that the step is taken back
            None => DVector::from_element(self.count, 1.0 + libm::sqrt(1e4 * self.best)),
        })
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        Some(self.ground.slopes(&self.slots, self.settled.as_ref()?))
    }
}
