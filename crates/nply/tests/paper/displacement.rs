//! (50), (51): the displacements of the ply's end.

use nply::geometry::Centreline;
use nply::mechanics::Balance;

use crate::state::{close, states};

#[test]
fn eq50_eq51() {
    for state in states(Balance::Contact) {
        let length = 40.0;
        let a = 1.0 / length;
        let line = Centreline::new(state.got.contact(), state.got.handedness(), 1);
        let (start, end) = (line.position(0.0), line.position(length));
        close(state.got.extension() / a, end[2] - start[2], length, 1e-14, "(50): length of the ply");
        close(state.got.extension() / a, state.t.c / a, length, 1e-15, "(50)");
        let turned = line.azimuth(length) - line.azimuth(0.0);
        close(state.got.rotation() / a, turned, length, 1e-14, "(51): rotation of its end");
        close(state.got.rotation() / a, state.eps / (a * state.t.rho) * state.t.s, length, 1e-14, "(51)");
    }
}
