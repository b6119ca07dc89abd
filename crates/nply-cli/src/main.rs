//! The command nply.
fn main() {}
