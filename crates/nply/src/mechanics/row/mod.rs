//! All equilibria for a whole row of data: one datum varies, all others are held.
//!
//! Each of the data enters the balance linearly, A(θ) + x B(θ) = 0 with x the one that varies, so that x(θ) = −A/B is
//! explicit and a row is the inverse of one function for each hand. The branch is charted once in short cells on which the
//! balance's terms are polynomials, and so are the Wronskians of their pairs. For a row the sign of W = A′B − AB′ by its
//! Bernstein coefficients tells where x(θ) runs one way; such a piece holds exactly the values between those at its ends,
//! each once, at a root that a cubic through the ends guesses and Halley's step finishes. Near a fold the cell is halved.
//! Values for which any cell leaves the number of roots in doubt (within rounding of a fold, next to straight strands or to
//! flat rings) are solved one by one as in [`Ply::equilibria`].

mod cell;
mod chart;
mod follow;
mod line;
mod piece;
mod point;
mod values;

use super::equilibrium::weights;
use super::{Balance, Equilibrium, Load, Ply, Stability, Twist};
use crate::geometry::Contact;
use crate::numerics::wide::{Job, Wide, dispatch_alike};
use crate::{DomainError, Handedness};
pub(super) use cell::{TERMS, judged, largest};
pub(super) use chart::Chart;
use follow::{Follower, Found};
use line::Line;
use piece::Search;
use values::Values;

/// The datum that varies along a row: each enters the balance (47) linearly.
///
/// ```
/// use nply::mechanics::Along;
/// assert_eq!(Along::StiffnessRatio.name(), "stiffness_ratio");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Along {
    /// f = r²F₀/B, tension positive.
    Force,
    /// m = rM₀/B, right-handed positive.
    Moment,
    /// φ̄a = tan χ, (46), (49).
    Pretwist,
    /// r u₃, (22), (27).
    StrandTwist,
    /// γ = C/B > 0.
    StiffnessRatio,
}

impl Along {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Force, Self::Moment, Self::Pretwist, Self::StrandTwist, Self::StiffnessRatio];

    /// The datum's public name, such as `stiffness_ratio`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Moment => "moment",
            Self::Pretwist => "pretwist",
            Self::StrandTwist => "strand_twist",
            Self::StiffnessRatio => "stiffness_ratio",
        }
    }
}

/// One equilibrium in a row: what a map shows of it. All else follows from the angle, see [`Equilibrium`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowState {
    /// ε.
    pub handedness: Handedness,
    /// θ in rad, in (0, π/2).
    pub helical_angle: f64,
    /// π/2 − θ in rad, with its own digits.
    pub pitch_angle: f64,
    /// p r³/B, outward positive, (30), (37).
    pub resultant_pressure: f64,
    /// p₁ r³/B, from each of the two neighbours, negative where they would have to pull, (38).
    pub interstrand_pressure: f64,
    /// As [`Equilibrium::stability`]: `None` in radial balance and where neighbours do not press.
    pub stability: Option<Stability>,
    /// Whether this is a limit point: two states that have met, to within rounding.
    pub fold: bool,
}

impl RowState {
    /// Whether the neighbours would have to pull (p₁ < 0) to keep this shape.
    #[must_use]
    pub fn is_separated(&self) -> bool {
        self.interstrand_pressure < 0.0
    }
}

impl From<&Equilibrium> for RowState {
    fn from(state: &Equilibrium) -> Self {
        Self {
            handedness: state.handedness,
            helical_angle: state.contact.helical_angle(),
            pitch_angle: state.contact.pitch_angle(),
            resultant_pressure: state.resultant_pressure(),
            interstrand_pressure: state.interstrand_pressure(),
            stability: state.stability(),
            fold: state.fold,
        }
    }
}

/// Weights beyond this are left to the solver that scales them.
const UNTAMED: f64 = 1e100;

impl Ply {
    /// Every state for each of a row of values of one datum, all others held: every angle in (0, π/2), both hands, as
    /// [`each_equilibrium`](Self::each_equilibrium) finds them value by value, to 1e-12 in the angle (as near to a fold as
    /// rounding allows), and much sooner. `found` gets the index of the value and the state, in no order.
    ///
    /// `values` ascend (equal neighbours are allowed); none is an answer: nothing is found. What this ply, `twist` and `load`
    /// say of the varied datum is ignored: along a pretwist or strand twist that is all of `twist`.
    ///
    /// The first row of a number of strands charts the branch, some tenths of a millisecond; for 2 … 12 strands once in a
    /// program, for others when it is not that of the row before.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, `values` ascend (and are greater than 0 along the stiffness ratio), and no
    /// external pressure acts.
    ///
    /// ```
    /// use nply::Handedness;
    /// use nply::mechanics::{Along, Load, Ply, Stability, Twist};
    /// // three strands released after left-handed pretwists coil right-handed
    /// let mut angles = [f64::NAN; 3];
    /// Ply::new(3, 0.75)?.each_equilibrium_along(
    ///     Along::Pretwist,
    ///     &[-1.0, -0.5, -0.25],
    ///     Twist::Pretwist(0.0),
    ///     Load::NONE,
    ///     |i, state| {
    ///         if state.handedness == Handedness::Right && state.stability == Some(Stability::Stable) {
    ///             angles[i] = state.helical_angle.to_degrees();
    ///         }
    ///     },
    /// )?;
    /// assert!((angles[0] - 30.6130).abs() < 5e-5);
    /// assert!(angles[0] > angles[1] && angles[1] > angles[2]);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn each_equilibrium_along(
        &self,
        along: Along,
        values: &[f64],
        twist: Twist,
        load: Load,
        mut found: impl FnMut(usize, RowState),
    ) -> Result<(), DomainError> {
        let row = Row::new(self, along, twist, load);
        row.check(values)?;
        let Some(values) = Values::new(values) else { return Ok(()) };
        let lines = Handedness::BOTH.map(|hand| Line::new(along, self.stiffness_ratio(), row.twist, load, hand));
        let chart = Chart::of(self.strands(), self.balance());
        let mut search = Search::new(values);
        if lines.iter().all(|line| line.greatest[0].max(line.greatest[1].max(1.0) * values.largest()) < UNTAMED) {
            for cell in 0..chart.cells.len() {
                search.judge(&chart.cells, cell, &lines, 0);
                search.judge(&chart.cells, cell, &lines, 1);
            }
            search.merge_doubts();
        } else {
            search.doubts.push(0..values.list.len());
        }
        dispatch_alike(Following { row: &row, search: &search, chart: &chart, lines: &lines, found: &mut found });
        for value in search.doubts.iter().cloned().flatten() {
            row.solve(value, values.list[value], &mut found);
        }
        Ok(())
    }
}

/// What is held along a row.
struct Row<'a> {
    ply: &'a Ply,
    along: Along,
    twist: Twist,
    load: Load,
}

impl<'a> Row<'a> {
    fn new(ply: &'a Ply, along: Along, twist: Twist, load: Load) -> Self {
        let twist = match along {
            Along::Pretwist => Twist::Pretwist(0.0),
            Along::StrandTwist => Twist::StrandTwist(0.0),
            _ => twist,
        };
        let load = match along {
            Along::Force => Load { force: 0.0, ..load },
            Along::Moment => Load { moment: 0.0, ..load },
            _ => load,
        };
        Self { ply, along, twist, load }
    }

    /// The data with a value put in: γ, twist, loads.
    fn data(&self, x: f64) -> (f64, Twist, Load) {
        let (gamma, twist, load) = (self.ply.stiffness_ratio(), self.twist, self.load);
        match self.along {
            Along::Force => (gamma, twist, Load { force: x, ..load }),
            Along::Moment => (gamma, twist, Load { moment: x, ..load }),
            Along::Pretwist => (gamma, Twist::Pretwist(x), load),
            Along::StrandTwist => (gamma, Twist::StrandTwist(x), load),
            Along::StiffnessRatio => (x, twist, load),
        }
    }

    fn check(&self, values: &[f64]) -> Result<(), DomainError> {
        self.ply.check(self.twist, self.load)?;
        self.ply.check_unpressed()?;
        let name = self.along.name();
        let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = self.twist;
        let factor = match self.along {
            Along::Pretwist | Along::StrandTwist => self.ply.stiffness_ratio(),
            Along::StiffnessRatio => given.abs().max(1.0),
            Along::Force | Along::Moment => 1.0,
        };
        let positive = self.along == Along::StiffnessRatio;
        let mut before = f64::NEG_INFINITY;
        for &value in values {
            let finite = value.is_finite() && (factor * value).is_finite();
            DomainError::check(finite, name, value, "finite, as the twist times the stiffness ratio")?;
            DomainError::check(!positive || value > 0.0, name, value, "greater than 0")?;
            DomainError::check(value >= before, name, value, "at least the value before it: a row ascends")?;
            before = value;
        }
        Ok(())
    }

    /// The states of a value in doubt, each root sought by itself.
    #[cold]
    fn solve(&self, value: usize, x: f64, found: &mut impl FnMut(usize, RowState)) {
        let (gamma, twist, load) = self.data(x);
        let mut states = Vec::with_capacity(4);
        self.ply.atlas().solve(weights(gamma, twist, load), |handedness, at| {
            states.push(self.state(x, Contact::at(self.ply.strands(), at.angle), at.double, handedness));
        });
        Equilibrium::sort(&mut states);
        for state in &states {
            found(value, RowState::from(state));
        }
    }

    fn state(&self, x: f64, contact: Contact, fold: bool, handedness: Handedness) -> Equilibrium {
        let (gamma, twist, load) = self.data(x);
        Equilibrium { stiffness_ratio: gamma, ..self.ply.state(contact, fold, handedness, twist, load) }
    }
}

/// All pieces of a row, which are followed with the widest registers there are.
struct Following<'a, F> {
    row: &'a Row<'a>,
    search: &'a Search<'a>,
    chart: &'a Chart,
    lines: &'a [Line; 2],
    found: &'a mut F,
}

impl<F: FnMut(usize, RowState)> Job for Following<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self, w: W) {
        let Self { row, search, chart, lines, found } = self;
        let list = search.values.list;
        let touching = row.ply.balance() == Balance::Contact;
        for piece in &search.pieces {
            let (cell, line) = (&chart.cells[piece.cell], &lines[piece.line]);
            let follower = Follower::new(piece, cell, line, search.values.largest());
            let verdict = if piece.rises { Stability::Stable } else { Stability::Unstable };
            let handedness = line.handedness;
            for values in search.undoubted(&piece.values) {
                follower.follow(w, list, values, |at: Found| {
                    let (helical_angle, pitch_angle) = cell.angles(at.u);
                    let mut state = RowState {
                        handedness,
                        helical_angle,
                        pitch_angle,
                        resultant_pressure: at.resultant_pressure,
                        interstrand_pressure: at.interstrand_pressure,
                        stability: (touching && at.interstrand_pressure > 0.0).then_some(verdict),
                        fold: false,
                    };
                    if at.lost {
                        let contact = Contact::at(row.ply.strands(), cell.place(at.u));
                        state = RowState::from(&row.state(list[at.value], contact, false, handedness));
                    }
                    found(at.value, state);
                });
            }
        }
    }
}
