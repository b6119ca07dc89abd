//! Stable or not, under each way of holding the ends.

use nply::mechanics::{Equilibrium, Ply, Stability, Twist};

/// The verdicts among uniform plies; each is none where nothing can be said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Verdicts {
    /// Force and moment dead, the twist held as given.
    pub(super) dead_loads: Option<Stability>,
    /// Ends that cannot turn, the force dead.
    pub(super) rotation_held: Option<Stability>,
    /// Ends a given distance apart, the moment dead.
    pub(super) length_held: Option<Stability>,
    /// Force, moment and the strands' twisting moment dead; none where the strand twist is what was given.
    pub(super) strand_twist_held: Option<Stability>,
}

impl Verdicts {
    pub(super) fn of(state: &Equilibrium) -> Self {
        let Some(dead_loads) = state.stability() else { return Self::default() };
        // touching strands have one motion, along the branch: it changes both the rotation and the length
        let nothing_free = Some(Stability::Stable);
        let pretwisted = matches!(state.twist(), Twist::Pretwist(_));
        Self {
            dead_loads: Some(dead_loads),
            rotation_held: nothing_free,
            length_held: nothing_free,
            strand_twist_held: if pretwisted { with_strand_twist_held(state) } else { None },
        }
    }

    /// By name, in the order of the report.
    pub(super) const fn named(&self) -> [(&'static str, &'static str, Option<Stability>); 4] {
        [
            ("dead_loads", "under dead loads", self.dead_loads),
            ("rotation_held", "ends cannot turn", self.rotation_held),
            ("length_held", "length held", self.length_held),
            ("strand_twist_held", "strand twist held", self.strand_twist_held),
        ]
    }
}

/// The same state with the strands' twist held instead of their pretwist.
fn with_strand_twist_held(state: &Equilibrium) -> Option<Stability> {
    let ply = Ply::with_balance(state.contact().strands(), state.stiffness_ratio(), state.balance()).ok()?;
    let ply = ply.with_external_pressure(state.external_pressure()).ok()?;
    let twist = Twist::StrandTwist(state.strand_twist());
    let same = ply.force_at(state.contact().angle(), state.handedness(), twist, state.load().moment).ok()?;
    same.stability()
}
