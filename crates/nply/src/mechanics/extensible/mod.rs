//! Beyond the paper: strands that stretch and thin, strands formed beforehand, a core that carries its share.

mod course;
mod grips;
mod obstacle;
mod parting;
mod path;
mod ply;
mod potential;
mod reduced;
mod response;
mod seam;
mod search;
mod state;
mod strand;
mod stress;
mod touching;

pub use grips::{Axial, Grips, Turning};
pub use path::{StretchData, StretchPath, StretchStation};
pub use ply::ExtensiblePly;
pub use response::{Clamped, StretchFlexibility, StretchStiffness};
pub use state::{ExtensibleState, StretchEnergy};
pub(crate) use strand::check_poisson;
pub use strand::{FormedLay, StretchingStrand, WorkingCore};
pub use stress::{Fibre, WireStress};
pub use touching::TouchingLoads;
