//! What is known of the twist of the strands, (44)–(49).

/// The twist of the strands, given in one of the two ways in which a ply is made or held.
///
/// ```
/// use nply::mechanics::Twist;
/// // tan χ = φ̄a, (49): stripes painted along the straight strands stand at χ = 20° after the pretwist.
/// let twist = Twist::Pretwist(0.36397);
/// assert_ne!(twist, Twist::StrandTwist(0.36397));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Twist {
    /// φ̄a = tan χ, (46), (49): the rotation put into each straight strand, per strand length, times r. It stays as it
    /// is when the ply forms, because the strands' ends are clipped together.
    Pretwist(f64),
    /// r u₃, (22), (27): the twist of the strands in the ply itself, as under a prescribed twisting moment.
    StrandTwist(f64),
}

impl Twist {
    /// γ r u₃ = `love`·sin θ cos θ/ρ·ε + `held`, (45): γ times the pretwist and Love's torsion, or the strand twist alone.
    pub(super) fn weights(self, gamma: f64) -> (f64, f64) {
        match self {
            Self::Pretwist(pretwist) => (gamma, gamma * pretwist),
            Self::StrandTwist(strand_twist) => (0.0, gamma * strand_twist),
        }
    }
}
