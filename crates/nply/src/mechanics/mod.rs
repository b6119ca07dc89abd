//! Section 3–6 of the paper: what the strands carry, and which shapes of the ply are in equilibrium.

mod atlas;
mod balance;
mod displacement;
mod energy;
mod equilibrium;
mod flexibility;
mod load;
mod ply;
mod pressure;
mod separation;
mod stability;
mod stiffness;
mod strand;
mod support;
mod twist;

pub use balance::Balance;
pub use energy::Energy;
pub use equilibrium::Equilibrium;
pub use load::Load;
pub use ply::Ply;
pub use stability::Stability;
pub use stiffness::Stiffness;
pub use strand::StrandResultant;
pub use support::{Support, SupportedState, Wedge};
pub use twist::Twist;
