//! How far a ply is from coming apart, and from its other limits.

use core::f64::consts::FRAC_PI_4;

use super::{Balance, Equilibrium, Load, Ply, Twist};
use crate::DomainError;
use crate::geometry::{Contact, HelicalAngle, SpecialLays};

/// What is changed while the rest is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Change {
    /// The force, the moment dead.
    Force,
    /// The moment, the force dead.
    Moment,
    /// The force, with ends that cannot turn; the moment follows.
    ForceEndsHeld,
    /// The turns of the ply's end (a·d_m, rad per strand length times r), the force dead; the moment follows.
    Turns,
    /// The pretwist of the strands, the loads dead.
    Pretwist,
}

impl Change {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Force, Self::Moment, Self::ForceEndsHeld, Self::Turns, Self::Pretwist];

    /// The name used in JSON and CSV.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::Moment => "moment",
            Self::ForceEndsHeld => "force_ends_held",
            Self::Turns => "turns",
            Self::Pretwist => "pretwist",
        }
    }

    /// The datum that changes.
    fn of(self, state: &Equilibrium) -> f64 {
        match self {
            Self::Force | Self::ForceEndsHeld => state.load().force,
            Self::Moment => state.load().moment,
            Self::Turns => state.rotation(),
            Self::Pretwist => state.pretwist(),
        }
    }
}

/// What a state meets first as a datum changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Cause {
    /// p = 0: neighbours stop pressing on each other.
    Separation,
    /// The state ends, and the ply jumps.
    Fold,
    /// No more turns fit in (q = 1).
    MostTurns,
    /// The strands are straight; beyond, the ply winds the other way.
    Straight,
    /// The strands lie as flat rings on top of each other; θ → π/2 is not reached, but neared at a finite datum.
    Rings,
}

impl Cause {
    /// The name used in JSON and CSV: `separation`, `fold`, `most_turns`, `straight` or `rings`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Separation => "separation",
            Self::Fold => "fold",
            Self::MostTurns => "most_turns",
            Self::Straight => "straight",
            Self::Rings => "rings",
        }
    }
}

/// Where a change of a datum ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// What is met there.
    pub cause: Cause,
    /// The datum there less the datum now.
    pub change: f64,
    /// The state there.
    pub state: Equilibrium,
}

/// How far a datum can fall and rise before the state meets something; `None` where it can go on without end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// As the datum falls.
    pub below: Option<Limit>,
    /// As the datum rises.
    pub above: Option<Limit>,
}

/// Where a walk along the branch stops: at a limit, or `None`, short of a pole of the datum.
type Mark = (Option<Cause>, Equilibrium);

impl Equilibrium {
    /// How far this state is from the next limit as one datum changes and the rest is held.
    ///
    /// Each datum is an explicit function of the angle along the branch, so that the limits are the nearest angles on either side at
    /// which the strands part, the datum turns (a fold), or the ply is straight: none is stepped over. `None` for a state
    /// that is separated or at a fold, and for a pretwist where the strands' twist is held.
    ///
    /// # Errors
    /// [`DomainError`] under an external pressure.
    ///
    /// ```
    /// use nply::mechanics::{Cause, Change, Load, Ply, Twist};
    /// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-0.2), Load::NONE)?[0];
    /// let margin = state.margin(Change::ForceEndsHeld)?.expect("it touches");
    /// let limit = margin.below.expect("a thrust opens it");
    /// assert!(limit.cause == Cause::Separation && limit.change < 0.0);
    /// assert!(limit.state.interstrand_pressure().abs() < 1e-15);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn margin(&self, change: Change) -> Result<Option<Margin>, DomainError> {
        let ply = Ply::with_balance(self.contact.strands(), self.stiffness_ratio, self.balance)?
            .with_external_pressure(self.external_pressure)?;
        ply.check_unpressed()?;
        let held_twist = matches!(self.twist, Twist::StrandTwist(_)) && change == Change::Pretwist;
        if self.interstrand_pressure() <= 0.0 || self.fold || held_twist {
            return Ok(None);
        }
        let (twist, Load { force, moment }) = (self.twist, self.load);
        let (parted, folds) = match change {
            Change::Force => (ply.separation_at_moment(twist, moment)?, ply.folds_at_moment(twist, moment)?),
            Change::Moment => (ply.separation_at_force(twist, force)?, ply.folds_at_force(twist, force)?),
            Change::Turns => (ply.separation_at_force(twist, force)?, Vec::new()),
            Change::Pretwist => (ply.separation_at_loads(self.load)?, ply.folds_at_loads(self.load)?),
            Change::ForceEndsHeld => {
                let parted = ply.separation_at(self.contact.angle(), self.handedness, twist)?;
                return Ok(Some(Margin::of([Some(self.limit(change, Cause::Separation, parted)), None])));
            }
        };
        let mut marks: Vec<Mark> = parted.into_iter().map(|state| (Some(Cause::Separation), state)).collect();
        marks.extend(folds.into_iter().map(|state| (Some(Cause::Fold), state)));
        let lays = SpecialLays::of(ply.strands())?;
        // the moment has a pole at the most turns, and only the shape is of account; the pretwist has one at its limiting angle:
        // as a datum grows without end the state comes near its pole and never past it
        let pole = match (change, self.balance) {
            (Change::Turns, _) => Some((Some(Cause::MostTurns), lays.zero_twist())),
            (Change::Moment, Balance::Contact) => Some((None, lays.zero_twist())),
            (Change::Pretwist, Balance::Contact) => Some((None, lays.most_torsion())),
            (Change::Pretwist, Balance::Radial) => Some((None, Contact::new(ply.strands(), FRAC_PI_4)?)),
            _ => None,
        };
        marks.extend(pole.map(|(cause, contact)| (cause, Self { contact, ..*self })));
        marks.retain(|(_, state)| state.handedness == self.handedness);
        Ok(Some(Margin::of([self.before(change, &marks, &ply), self.after(change, &marks, &ply)])))
    }

    /// The nearest mark at a greater angle, or flat rings, where the datum has a limit there.
    fn after(&self, change: Change, marks: &[Mark], ply: &Ply) -> Option<Limit> {
        const FLAT: f64 = 1e-100;
        const BOUNDED: f64 = 1e50;
        let here = self.contact.pitch_angle();
        let ahead = marks.iter().filter(|(_, state)| state.contact.pitch_angle() < here);
        let nearest = ahead.max_by(|a, b| a.1.contact.pitch_angle().total_cmp(&b.1.contact.pitch_angle()));
        if let Some((cause, state)) = nearest {
            return Some(self.limit(change, (*cause)?, *state));
        }
        let rings = HelicalAngle::flat(FLAT);
        let state = match change {
            Change::Force | Change::ForceEndsHeld => ply.force_at(rings, self.handedness, self.twist, self.load.moment),
            Change::Moment | Change::Turns => ply.moment_at(rings, self.handedness, self.twist, self.load.force),
            Change::Pretwist => ply.pretwist_at(rings, self.handedness, self.load),
        };
        state.ok().filter(|state| change.of(state).abs() < BOUNDED).map(|state| self.limit(change, Cause::Rings, state))
    }

    /// The nearest mark at a lesser angle, or straight strands, which loads other than the force can reach.
    fn before(&self, change: Change, marks: &[Mark], ply: &Ply) -> Option<Limit> {
        let here = self.contact.helical_angle();
        let behind = marks.iter().filter(|(_, state)| state.contact.helical_angle() < here);
        let nearest = behind.max_by(|a, b| a.1.contact.helical_angle().total_cmp(&b.1.contact.helical_angle()));
        if let Some((cause, state)) = nearest {
            return Some(self.limit(change, (*cause)?, *state));
        }
        let straight = HelicalAngle::steep(0.0);
        let state = match change {
            Change::Moment | Change::Turns => ply.moment_at(straight, self.handedness, self.twist, self.load.force),
            Change::Pretwist => ply.pretwist_at(straight, self.handedness, self.load),
            Change::Force | Change::ForceEndsHeld => return None,
        };
        state.ok().map(|state| self.limit(change, Cause::Straight, state))
    }

    fn limit(&self, change: Change, cause: Cause, state: Self) -> Limit {
        Limit { cause, change: change.of(&state) - change.of(self), state }
    }
}

impl Margin {
    /// Each limit on its side; of two on one side the nearer.
    fn of(limits: [Option<Limit>; 2]) -> Self {
        let side = |below: bool| {
            let mine = limits.iter().flatten().filter(|limit| (limit.change < 0.0) == below).copied();
            mine.min_by(|a, b| a.change.abs().total_cmp(&b.change.abs()))
        };
        Self { below: side(true), above: side(false) }
    }
}
