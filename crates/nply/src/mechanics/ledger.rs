//! The ledger of link: what was put in is found again as twist and writhe.

use core::f64::consts::TAU;

use super::{Equilibrium, SupportedState};

/// Link of the strands of a long ply in turns per strand length times r, all strands together: `put_in` = `twist` + `writhe`.
///
/// Joined at the ends the strands keep their link, so that the ledger holds before and after the ply forms, (A.30). At any length, with what
/// stays bounded: [`PlyLink`](crate::topology::PlyLink).
///
/// ```
/// use nply::mechanics::{Load, Ply, Twist};
/// let link = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0].link();
/// assert!((link.put_in - (link.twist + link.writhe)).abs() < 1e-16);
/// assert!(link.put_in < link.twist && link.writhe < 0.0); // a right-handed ply has negative writhe and frees its strands of twist
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// Lk: n φ̄a/2π, the turns put into the strands before they were joined.
    pub put_in: f64,
    /// Tw: n r u₃/2π, the turns left in the strands.
    pub twist: f64,
    /// −εn sin θ cos θ/(2πρ): the writhe of the strands, less what closing the ply adds whatever its shape, in the limit of a long ply.
    pub writhe: f64,
}

impl Link {
    fn new(strands: u32, pretwist: f64, strand_twist: f64, torsion: f64) -> Self {
        let share = f64::from(strands) / TAU;
        Self { put_in: share * pretwist, twist: share * strand_twist, writhe: -share * torsion }
    }
}

impl Equilibrium {
    /// The ledger of link.
    #[must_use]
    pub fn link(&self) -> Link {
        let torsion = self.handedness.sign() * self.contact.torsion();
        Link::new(self.contact.strands(), self.pretwist(), self.strand_twist(), torsion)
    }
}

impl SupportedState {
    /// The ledger of link.
    #[must_use]
    pub fn link(&self) -> Link {
        Link::new(self.strands(), self.pretwist(), self.strand_twist(), self.torsion())
    }
}
