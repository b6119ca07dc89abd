//! The states of many rows, one after the other.

use core::ops::Range;

use super::refine::State;
use super::sift::Doubt;
use crate::geometry::HelicalAngle;
use crate::mechanics::Equilibrium;
use crate::{DomainError, Handedness};

/// The states of an array of plies: row after row, in each right-handed first, then by angle.
///
/// Filled by [`Plies::equilibria`](super::Plies::equilibria); kept from one call to the next it asks for no new memory.
///
/// ```
/// use nply::mechanics::States;
/// let states = States::new();
/// assert_eq!((states.len(), states.offsets()), (0, &[0][..]));
/// ```
#[derive(Clone, Debug)]
pub struct States {
    offsets: Vec<usize>,
    handedness: Vec<Handedness>,
    helical_angle: Vec<f64>,
    pitch_angle: Vec<f64>,
    fold: Vec<bool>,
    refused: Vec<(usize, DomainError)>,
}

impl Default for States {
    fn default() -> Self {
        Self::new()
    }
}

impl States {
    /// None, of no rows.
    #[must_use]
    pub fn new() -> Self {
        Self {
            offsets: vec![0],
            handedness: Vec::new(),
            helical_angle: Vec::new(),
            pitch_angle: Vec::new(),
            fold: Vec::new(),
            refused: Vec::new(),
        }
    }

    /// Where each row's states begin, and behind the last where they end: one more than there are rows.
    #[must_use]
    pub fn offsets(&self) -> &[usize] {
        &self.offsets
    }

    /// The places of the states of one row. Empty where there are none, and for rows there are not.
    #[must_use]
    pub fn row(&self, row: usize) -> Range<usize> {
        match self.offsets.get(row..).unwrap_or_default() {
            [start, end, ..] => *start..*end,
            _ => self.len()..self.len(),
        }
    }

    /// How many states there are in all rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.helical_angle.len()
    }

    /// Whether no row has a state.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.helical_angle.is_empty()
    }

    /// ε of every state.
    #[must_use]
    pub fn handedness(&self) -> &[Handedness] {
        &self.handedness
    }

    /// θ of every state in rad, in (0, π/2).
    #[must_use]
    pub fn helical_angle(&self) -> &[f64] {
        &self.helical_angle
    }

    /// π/2 − θ of every state in rad, with its own digits.
    #[must_use]
    pub fn pitch_angle(&self) -> &[f64] {
        &self.pitch_angle
    }

    /// Whether a state is a limit point: two states that have met, to within rounding.
    #[must_use]
    pub fn fold(&self) -> &[bool] {
        &self.fold
    }

    /// The rows whose data lie outside the theory, in ascending order, and why.
    #[must_use]
    pub fn refused(&self) -> &[(usize, DomainError)] {
        &self.refused
    }

    /// The angle of a state, from whichever of its two numbers has more digits.
    pub(super) fn angle(&self, at: usize) -> Option<HelicalAngle> {
        let (helical, pitch) = (*self.helical_angle.get(at)?, *self.pitch_angle.get(at)?);
        if helical <= pitch { HelicalAngle::new(helical).ok() } else { HelicalAngle::from_pitch_angle(pitch).ok() }
    }

    pub(super) fn clear(&mut self) {
        self.offsets.clear();
        self.offsets.push(0);
        self.handedness.clear();
        self.helical_angle.clear();
        self.pitch_angle.clear();
        self.fold.clear();
        self.refused.clear();
    }

    /// The states of the row that is being filled, put in order, unless one is in doubt.
    #[inline]
    pub(super) fn push(&mut self, found: &[Result<State, Doubt>]) -> Result<(), Doubt> {
        let mut doubt = false;
        for state in found {
            doubt |= state.is_err();
        }
        if doubt {
            return Err(Doubt);
        }
        let start = self.helical_angle.len();
        for state in found.iter().flatten() {
            self.handedness.push(state.handedness);
            self.helical_angle.push(state.helical_angle);
            self.pitch_angle.push(state.pitch_angle);
            self.fold.push(false);
            let mut at = self.helical_angle.len() - 1;
            // roots come panel by panel: only within one of the flat half they may run downwards
            while at > start
                && self.handedness[at - 1] == self.handedness[at]
                && self.pitch_angle[at - 1] < self.pitch_angle[at]
            {
                self.helical_angle.swap(at - 1, at);
                self.pitch_angle.swap(at - 1, at);
                at -= 1;
            }
        }
        Ok(())
    }

    pub(super) fn push_state(&mut self, state: &Equilibrium) {
        self.handedness.push(state.handedness());
        self.helical_angle.push(state.contact().helical_angle());
        self.pitch_angle.push(state.contact().pitch_angle());
        self.fold.push(state.is_fold());
    }

    pub(super) fn refuse(&mut self, row: usize, error: DomainError) {
        self.refused.push((row, error));
    }

    pub(super) fn end_row(&mut self) {
        self.offsets.push(self.helical_angle.len());
    }
}
