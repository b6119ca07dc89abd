//! All equilibria of whole arrays of plies.
//!
//! The balance of a case is summed on eight wide panels at once, and the signs of its Bernstein coefficients tell which of them
//! hold no root and which hold one, as in [`Ply::each_equilibrium`]. Roots that stand alone are refined four at a time. Where
//! anything is in doubt (next to a panel's border, to a fold, to straight strands or flat rings) the case is solved by itself.

mod panels;
mod refine;
mod sift;
mod states;

use std::cell::OnceCell;

pub(in crate::mechanics) use panels::Both;
use panels::PANELS;
use refine::{Sought, State, TOGETHER, refine};
use sift::{Doubt, Sums, isolate};
pub use states::States;

use super::row::Chart;
use super::{Balance, Equilibrium, Load, Ply, Twist};
use crate::geometry::Contact;
use crate::numerics::wide::{Job, Wide, dispatch};
use crate::{DomainError, Handedness};

/// Arrays of plies and their data, row by row, all of one length.
///
/// ```
/// use nply::mechanics::{Balance, Plies, States, Twists};
/// let none = [0.0; 2];
/// let plies = Plies {
///     strands: &[3, 3],
///     stiffness_ratio: &[0.75, 0.75],
///     twist: Twists::Pretwist(&[-1.0, 1.0]),
///     force: &none,
///     moment: &none,
/// };
/// let mut states = States::new();
/// plies.equilibria(Balance::Contact, &mut states)?;
/// // after a left-handed pretwist φ̄a = −1 the strands coil right-handed, at 30.613° (simulated: 30.6130°)
/// let first = states.row(0).start;
/// assert!((states.helical_angle()[first].to_degrees() - 30.6130).abs() < 5e-5);
/// assert_eq!(states.row(0).len(), states.row(1).len()); // the mirror image
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Plies<'a> {
    /// n ≥ 2.
    pub strands: &'a [u32],
    /// γ = C/B > 0.
    pub stiffness_ratio: &'a [f64],
    /// φ̄a or r u₃.
    pub twist: Twists<'a>,
    /// f = r²F₀/B, tension positive.
    pub force: &'a [f64],
    /// m = rM₀/B, right-handed positive.
    pub moment: &'a [f64],
}

/// The strands' twist, given in one of the two ways for all rows; see [`Twist`].
///
/// ```
/// use nply::mechanics::Twists;
/// assert_ne!(Twists::Pretwist(&[0.5]), Twists::StrandTwist(&[0.5]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Twists<'a> {
    /// φ̄a = tan χ, (46), (49).
    Pretwist(&'a [f64]),
    /// r u₃, (22), (27).
    StrandTwist(&'a [f64]),
}

impl Twists<'_> {
    fn len(&self) -> usize {
        let (Self::Pretwist(list) | Self::StrandTwist(list)) = self;
        list.len()
    }

    #[inline(always)]
    fn at(&self, row: usize) -> Twist {
        match self {
            Self::Pretwist(list) => Twist::Pretwist(list[row]),
            Self::StrandTwist(list) => Twist::StrandTwist(list[row]),
        }
    }
}

impl Plies<'_> {
    /// Every state of every row, as [`Ply::equilibria`] finds them for each: every angle in (0, π/2), both hands, none missed, to
    /// 1e-12 in the angle (as near to a fold as rounding allows). `states` is emptied and filled, row after row.
    ///
    /// A row with data outside the theory has no states and is among [`States::refused`]; it touches no other.
    ///
    /// Where the processor has fused multiply-add the last digits of an angle are not those of a processor without it.
    /// The first row of a number of strands charts its branch, some tenths of a millisecond: for 2 … 12 strands once in a program,
    /// for others whenever it is not that of the last such row, so that rows of many strands are best sorted by n.
    ///
    /// # Errors
    /// [`DomainError`] unless all arrays are of one length.
    pub fn equilibria(&self, balance: Balance, states: &mut States) -> Result<(), DomainError> {
        for (name, length) in [
            ("stiffness_ratio", self.stiffness_ratio.len()),
            ("twist", self.twist.len()),
            ("force", self.force.len()),
            ("moment", self.moment.len()),
        ] {
            let same = length == self.strands.len();
            DomainError::check(same, name, length as f64, "as many values as there are numbers of strands")?;
        }
        states.clear();
        dispatch(Batch { plies: self, balance, states });
        Ok(())
    }

    /// One of the states that [`equilibria`](Self::equilibria) found, in full: state `at` of [`States::row`] of `row`, in the same balance.
    /// `None` where there is none.
    ///
    /// ```
    /// use nply::mechanics::{Balance, Plies, States, Twists};
    /// let none = [0.0];
    /// let plies =
    ///     Plies { strands: &[3], stiffness_ratio: &[0.75], twist: Twists::Pretwist(&[-1.0]), force: &none, moment: &none };
    /// let mut states = States::new();
    /// plies.equilibria(Balance::Contact, &mut states)?;
    /// let first = plies.equilibrium(Balance::Contact, &states, 0, states.row(0).start).unwrap();
    /// assert!((first.interstrand_pressure() - 0.0637177).abs() < 1e-6);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn equilibrium(&self, balance: Balance, states: &States, row: usize, at: usize) -> Option<Equilibrium> {
        if !states.row(row).contains(&at) || row >= self.strands.len() {
            return None;
        }
        let angle = states.angle(at)?;
        let contact = Contact::at_angle(self.strands[row], angle).ok()?;
        let (fold, handedness) = (states.fold()[at], states.handedness()[at]);
        Some(Equilibrium::found(contact, fold, handedness, self.data(row), balance))
    }

    fn data(&self, row: usize) -> (f64, Twist, Load) {
        let load = Load { force: self.force[row], moment: self.moment[row] };
        (self.stiffness_ratio[row], self.twist.at(row), load)
    }
}

/// Rows that are worked on together, those of one number of strands after the other, so that its polynomials stay at hand.
const BLOCK: usize = 256;
/// Numbers of strands with charts that are kept: n = 2 … 12.
const KEPT: usize = 11;
/// Weights beyond this are left to the solver that scales them.
const UNTAMED: f64 = 1e100;

struct Batch<'a> {
    plies: &'a Plies<'a>,
    balance: Balance,
    states: &'a mut States,
}

impl Job for Batch<'_> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self, w: W) {
        let Self { plies, balance, states } = self;
        let charts = [const { OnceCell::new() }; KEPT];
        let mut sums = Sums::new();
        let mut sought: Vec<Sought<'_>> = Vec::with_capacity(BLOCK);
        let mut found: Vec<Result<State, Doubt>> = Vec::with_capacity(4 * BLOCK);
        let mut alone = Alone { plies, balance, last: None };
        for first in (0..plies.strands.len()).step_by(BLOCK) {
            let rows = first..plies.strands.len().min(first + BLOCK);
            let (order, ends) = by_strands(&plies.strands[rows.clone()]);
            // where the states of each row stand in `found`; those of uncharted rows nowhere
            let mut places = [const { Err(Doubt) }; BLOCK];
            found.clear();
            let mut start = 0;
            for (chart, end) in charts.iter().zip(ends) {
                if start == end {
                    continue;
                }
                let chart = chart.get_or_init(|| Chart::of(plies.strands[first + usize::from(order[start])], balance));
                sought.clear();
                for &at in &order[start..end] {
                    let (row, before) = (first + usize::from(at), sought.len());
                    let sifted = sift(w, plies.data(row), balance, chart, &mut sums, &mut sought);
                    if sifted.is_err() {
                        sought.truncate(before);
                    }
                    places[usize::from(at)] = sifted.map(|()| found.len() + before..found.len() + sought.len());
                }
                for together in sought.chunks(TOGETHER) {
                    found.extend_from_slice(&refine(w, together)[..together.len()]);
                }
                start = end;
            }
            for (row, place) in rows.zip(&places) {
                match place {
                    Ok(place) if states.push(&found[place.clone()]).is_ok() => {}
                    _ => alone.solve(row, states),
                }
                states.end_row();
            }
        }
    }
}

/// The rows of a block by the number of strands, 2 … 12 and then all others, and where each number's rows end.
fn by_strands(strands: &[u32]) -> ([u8; BLOCK], [usize; KEPT]) {
    let key = |n: u32| (n.wrapping_sub(2) as usize).min(KEPT);
    let mut next = [0; KEPT + 1];
    for &n in strands {
        next[key(n)] += 1;
    }
    let mut start = 0;
    for count in &mut next {
        start += core::mem::replace(count, start);
    }
    let mut order = [0; BLOCK];
    for (&n, at) in strands.iter().zip(0_u8..=255) {
        let place = &mut next[key(n)];
        order[*place] = at;
        *place += 1;
    }
    (order, core::array::from_fn(|key| next[key]))
}

/// The roots of one row, each alone in its bracket.
#[inline(always)]
fn sift<'a, W: Wide>(
    w: W,
    (gamma, twist, Load { force, moment }): (f64, Twist, Load),
    balance: Balance,
    chart: &'a Chart,
    sums: &mut Sums,
    sought: &mut Vec<Sought<'a>>,
) -> Result<(), Doubt> {
    let (love, held) = twist.weights(gamma);
    let greatest = gamma + held.abs() + force.abs() + moment.abs();
    // of no number a comparison is true
    if !(gamma > 0.0 && greatest < UNTAMED) {
        return Err(Doubt);
    }
    let weights = [1.0, love, held, force, moment];
    let both = chart.panels();
    let pulled = force != 0.0 || (balance == Balance::Contact && moment != 0.0);
    let panels = if pulled { &both.whole } else { &both.unpulled };
    let mut candidates = if force == 0.0 && moment == 0.0 {
        sums.fill::<W, false>(w, panels, &weights)
    } else {
        sums.fill::<W, true>(w, panels, &weights)
    };
    while candidates != 0 {
        let candidate = candidates.trailing_zeros() as usize;
        candidates &= candidates - 1;
        let handedness = Handedness::BOTH[candidate / PANELS];
        let sign = handedness.sign();
        let signed = [1.0, love, sign * held, force, sign * moment];
        let place = (handedness, candidate % PANELS);
        match sums.single(w, candidate) {
            Ok(bracket) => sought.push(Sought::new(place, bracket, signed, (chart, panels))),
            Err((b, tolerance)) => {
                isolate(&b, tolerance, &mut |bracket| {
                    sought.push(Sought::new(place, bracket, signed, (chart, panels)));
                })?;
            }
        }
    }
    Ok(())
}

/// Rows in doubt, or refused.
struct Alone<'a> {
    plies: &'a Plies<'a>,
    balance: Balance,
    /// the ply of the last such row, whose chart may serve again
    last: Option<Ply>,
}

impl Alone<'_> {
    #[cold]
    #[inline(never)]
    fn solve(&mut self, row: usize, states: &mut States) {
        let (gamma, twist, load) = self.plies.data(row);
        let strands = self.plies.strands[row];
        let ply = match &self.last {
            Some(ply) if ply.strands() == strands => ply.with_stiffness_ratio(gamma),
            _ => Ply::with_balance(strands, gamma, self.balance),
        };
        match ply.and_then(|ply| Ok((ply.equilibria(twist, load)?, ply))) {
            Ok((found, ply)) => {
                for state in &found {
                    states.push_state(state);
                }
                self.last = Some(ply);
            }
            Err(error) => states.refuse(row, error),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::wide::Plain;

    #[test]
    fn every_machine_finds_the_same_states() {
        let even = |i: usize, step: f64| ((i as f64 * step) % 2.0) - 1.0;
        let count = 2000;
        let list = |step: f64, size: f64| (0..count).map(|i| size * even(i, step)).collect::<Vec<_>>();
        let strands: Vec<u32> = (0..count).map(|i| 2 + (i % 12) as u32).collect();
        let (twist, moment) = (list(0.618_034, 2.0), list(0.414_214, 4.0));
        let mut force = list(0.732_051, 1.0);
        force[..count / 3].fill(0.0);
        let plies = Plies {
            strands: &strands,
            stiffness_ratio: &vec![0.75; count],
            twist: Twists::Pretwist(&twist),
            force: &force,
            moment: &moment,
        };
        for balance in Balance::BOTH {
            let (mut fused, mut plain) = (States::new(), States::new());
            plies.equilibria(balance, &mut fused).unwrap();
            Batch { plies: &plies, balance, states: &mut plain }.run(Plain);
            assert_eq!(fused.offsets(), plain.offsets());
            assert_eq!(fused.handedness(), plain.handedness());
            for (a, b) in fused.helical_angle().iter().zip(plain.helical_angle()) {
                assert!((a - b).abs() < 1e-13, "{a} {b}");
            }
            assert!(fused.len() > count);
        }
    }
}
