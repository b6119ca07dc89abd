//! A ply, its twist and its loads from plain numbers.

use nply::mechanics::{Balance, Load, Ply, Twist};
use nply::{DomainError, Handedness};

/// The balance by its name; contact for any other word.
pub(crate) fn balance(name: &str) -> Balance {
    if name == Balance::Radial.name() { Balance::Radial } else { Balance::Contact }
}

/// A ply of strands in a balance.
pub(crate) fn ply(strands: u32, stiffness_ratio: f64, name: &str) -> Result<Ply, DomainError> {
    Ply::with_balance(strands, stiffness_ratio, balance(name))
}

/// The twist of this kind: `strand_twist`, else the pretwist.
pub(crate) fn twist(kind: &str, value: f64) -> Twist {
    if kind == "strand_twist" { Twist::StrandTwist(value) } else { Twist::Pretwist(value) }
}

/// Right-handed for numbers above 0.
pub(crate) fn hand(sign: f64) -> Handedness {
    if sign < 0.0 { Handedness::Left } else { Handedness::Right }
}

pub(crate) const fn load(force: f64, moment: f64) -> Load {
    Load { force, moment }
}
