//! Section 2 of the paper: helices that touch, the curve along which they touch, the cut across the ply; and wires laid on a core, layer on
//! layer.

mod angle;
mod branch;
mod centreline;
mod chords;
mod clearance;
mod contact;
mod contact_batch;
mod contact_chart;
mod contact_line;
mod densest_helix;
mod flat_section;
mod king_wire;
mod lay;
mod section;
mod special_lay;
mod tube;
mod wire_lay;
mod wire_layer;
mod wire_strand;

pub use angle::HelicalAngle;
pub use branch::{Branch, BranchKind, branch_at_anomaly, branches};
pub use centreline::{Centreline, FrenetFrame, Vector};
pub use chords::{ChordLay, Chords};
pub use clearance::{Approach, Clearance, Wire, Wires};
pub use contact::Contact;
pub(crate) use contact::check_strands;
pub use contact_batch::contact_batch;
pub use contact_line::ContactLine;
pub use densest_helix::DensestHelix;
pub use flat_section::FitFormula;
pub use section::Section;
pub use special_lay::{SpecialLays, packing_fraction};
pub use tube::{Course, DoubleHelix, Ends, Facets, Fit, Place, Tube, TubeMesh};
pub use wire_lay::WireLay;
pub use wire_layer::{LayerContact, WireLayer};
pub use wire_strand::WireStrand;
