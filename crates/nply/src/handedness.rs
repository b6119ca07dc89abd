//! The hand of a helix.

/// Which way the strands wind: ε of the paper, +1 right-handed (Z lay), −1 left-handed (S lay).
///
/// ```
/// use nply::Handedness;
/// assert_eq!(Handedness::Left.sign(), -1.0);
/// assert_eq!(Handedness::Right.opposite(), Handedness::Left);
/// assert_eq!(Handedness::Right.lay_letter(), 'Z');
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Handedness {
    /// ε = +1, right-handed, Z lay: the strands rise as the bar of the letter Z.
    Right,
    /// ε = −1, left-handed, S lay.
    Left,
}

impl Handedness {
    /// Both hands, right first.
    pub const BOTH: [Self; 2] = [Self::Right, Self::Left];

    /// ε: +1.0 or −1.0.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left => -1.0,
        }
    }

    /// The hand of which ε has this sign; 0 is left-handed.
    pub(crate) fn of_sign(sign: f64) -> Self {
        if sign > 0.0 { Self::Right } else { Self::Left }
    }

    /// The mirror image's hand.
    #[must_use]
    pub const fn opposite(self) -> Self {
        match self {
            Self::Right => Self::Left,
            Self::Left => Self::Right,
        }
    }

    /// The textile and rope maker's letter, Z or S.
    #[must_use]
    pub const fn lay_letter(self) -> char {
        match self {
            Self::Right => 'Z',
            Self::Left => 'S',
        }
    }
}
