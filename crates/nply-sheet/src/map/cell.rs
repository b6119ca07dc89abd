//! What is found at one point of a map.

use nply::Handedness;
use nply::mechanics::{Balance, Equilibrium, Holding, RowState, Stability, Support, SupportedState};

/// All states at one point.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// Right-handed first, then by angle.
    pub states: Vec<MapState>,
}

/// A state, in what a map shows of it; dimensionless.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapState {
    /// ε.
    pub handedness: Handedness,
    /// θ in degrees.
    pub helical_angle_deg: f64,
    /// What carries the strands.
    pub support: Support,
    /// p r³/B.
    pub resultant_pressure: f64,
    /// p₁ r³/B, negative where neighbours would have to pull.
    pub interstrand_pressure: f64,
    /// p_c r³/B.
    pub core_pressure: f64,
    /// Among uniform plies with the ends held as they are; `None` where nothing is said of it.
    pub stability: Option<Stability>,
}

/// What can be had at a point, in one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Verdict {
    /// Nothing is in equilibrium.
    NoState,
    /// Only states whose neighbours would have to pull.
    Separated,
    /// Contacts push, but no state is stable.
    Unstable,
    /// One stable state (in radial balance: one whose neighbours press).
    One,
    /// Several of them.
    Several,
}

impl Verdict {
    /// All, from nothing to much.
    pub const ALL: [Self; 5] = [Self::NoState, Self::Separated, Self::Unstable, Self::One, Self::Several];

    /// Its number in [`Verdict::ALL`].
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::NoState => 0,
            Self::Separated => 1,
            Self::Unstable => 2,
            Self::One => 3,
            Self::Several => 4,
        }
    }
}

impl MapState {
    /// Whether neighbours would have to pull.
    #[must_use]
    pub fn is_separated(&self) -> bool {
        self.interstrand_pressure < 0.0
    }

    /// Whether it can be had: contacts push, and it is stable as far as that can be said.
    #[must_use]
    pub fn is_seen(&self, balance: Balance) -> bool {
        !self.is_separated() && (balance == Balance::Radial || self.stability == Some(Stability::Stable))
    }

    pub(super) fn of_row(state: &RowState) -> Self {
        let steep = state.helical_angle <= core::f64::consts::FRAC_PI_4;
        Self {
            handedness: state.handedness,
            helical_angle_deg: if steep {
                state.helical_angle.to_degrees()
            } else {
                90.0 - state.pitch_angle.to_degrees()
            },
            support: Support::Neighbours,
            resultant_pressure: state.resultant_pressure,
            interstrand_pressure: state.interstrand_pressure,
            core_pressure: 0.0,
            stability: state.stability,
        }
    }

    pub(super) fn of_touching(state: &Equilibrium, holding: Holding) -> Self {
        // ends that cannot turn, or a held length, leave touching strands that press no freedom
        let stability = match (holding, state.stability()) {
            (Holding::DeadLoads, stability) => stability,
            (_, Some(_)) => Some(Stability::Stable),
            (_, None) => None,
        };
        Self {
            handedness: state.handedness(),
            helical_angle_deg: state.contact().angle().degrees(),
            support: Support::Neighbours,
            resultant_pressure: state.resultant_pressure(),
            interstrand_pressure: state.interstrand_pressure(),
            core_pressure: 0.0,
            stability,
        }
    }

    pub(super) fn of_supported(state: &SupportedState, holding: Holding) -> Self {
        Self {
            handedness: state.handedness(),
            helical_angle_deg: state.angle().degrees(),
            support: state.support(),
            resultant_pressure: state.resultant_pressure(),
            interstrand_pressure: state.interstrand_pressure(),
            core_pressure: state.core_pressure(),
            stability: Some(state.stability(holding)),
        }
    }
}

impl Cell {
    pub(super) fn sort(&mut self) {
        let left = |s: &MapState| s.handedness == Handedness::Left;
        self.states.sort_by(|a, b| left(a).cmp(&left(b)).then(a.helical_angle_deg.total_cmp(&b.helical_angle_deg)));
    }

    /// The state of least angle that can be had.
    #[must_use]
    pub fn seen(&self, balance: Balance) -> Option<&MapState> {
        let seen = self.states.iter().filter(|state| state.is_seen(balance));
        seen.min_by(|a, b| a.helical_angle_deg.total_cmp(&b.helical_angle_deg))
    }

    /// What can be had here.
    #[must_use]
    pub fn verdict(&self, balance: Balance) -> Verdict {
        match self.states.iter().filter(|state| state.is_seen(balance)).count() {
            0 if self.states.is_empty() => Verdict::NoState,
            0 if self.states.iter().all(MapState::is_separated) => Verdict::Separated,
            0 => Verdict::Unstable,
            1 => Verdict::One,
            _ => Verdict::Several,
        }
    }
}
