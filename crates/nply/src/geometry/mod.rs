//! Section 2 of the paper: helices that touch, the curve along which they touch, the cut across the ply.

mod angle;
mod contact;

pub use angle::HelicalAngle;
pub use contact::Contact;
pub(crate) use contact::check_strands;
