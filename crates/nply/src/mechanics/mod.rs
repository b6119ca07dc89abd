//! Section 3–6 of the paper: what the strands carry, and which shapes of the ply are in equilibrium.

mod atlas;
mod balance;
mod batch;
mod buckling;
mod cable;
mod displacement;
mod ends;
mod energy;
mod equilibrium;
mod extensible;
mod flexibility;
mod fold;
mod ledger;
mod line_contact;
mod load;
mod locus;
mod margin;
mod near_straight;
mod path;
mod ply;
mod plying;
mod potential;
mod pressure;
mod row;
mod sensitivity;
mod separation;
mod stability;
mod stiffness;
mod strand;
mod support;
mod twist;
mod twisted_strings;

pub use balance::Balance;
pub use batch::{Plies, States, Twists};
pub use buckling::BendingBounds;
pub use cable::{Cable, CableGrips, CableState, DesignedLay, Layer, LayerState, LayerSupport, LetsGo, LiftOff, Rod};
pub use ends::{Ends, Holding};
pub use energy::Energy;
pub use equilibrium::Equilibrium;
pub use extensible::{
    Axial, Clamped, ExtensiblePly, ExtensibleState, Fibre, FormedLay, Grips, StretchData, StretchEnergy,
    StretchFlexibility, StretchPath, StretchStation, StretchStiffness, StretchingStrand, TouchingLoads, Turning,
    WireStress, WorkingCore,
};
pub use ledger::Link;
pub use load::Load;
pub use locus::Locus;
pub use margin::{Cause, Change, Limit, Margin};
pub use path::{Contacts, Data, End, Event, Mark, Path, Route, Station, Trace};
pub use ply::Ply;
pub use row::{Along, RowState};
pub use sensitivity::{Sensitivity, Variable};
pub use stability::Stability;
pub use stiffness::Stiffness;
pub use strand::StrandResultant;
pub use support::{Support, SupportedState, Wedge};
pub use twist::Twist;
pub use twisted_strings::{ConstantRadius, TwistedStrings};
