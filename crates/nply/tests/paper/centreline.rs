//! (1)–(3) and (14)–(19): the centreline and its frames.

use nply::Handedness;
use nply::geometry::Centreline;
use nply::mechanics::Balance;

use crate::common::touch::slope;
use crate::common::vector::{Vector, add, assert_vector, cross, derivative, dot, times};
use crate::state::{contacts, states};

const ARCLENGTHS: [f64; 4] = [-3.7, 0.0, 0.9, 11.0];
/// Step of differences in arclength, and what they leave: h⁴ of a helix of curvature below 1, and rounding over h.
const H: f64 = 1e-2;
const DIFFERENCE: f64 = 1e-9;

#[test]
fn eq01() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let (eps, line) = (hand.sign(), Centreline::new(&contact, hand, 0));
            assert_eq!(line.azimuth(0.0), 0.0);
            for s in ARCLENGTHS {
                let psi = eps * t.s / t.rho * s;
                let want = [eps * t.rho * psi.sin(), -eps * t.rho * psi.cos(), s * t.c];
                assert_vector(line.position(s), want, 1e-12 * (t.rho + s.abs()), "r1");
                let rate = slope(|s| line.azimuth(s), s, H);
                assert!((rate - eps * t.s / t.rho).abs() < DIFFERENCE, "psi' = {rate}");
            }
        }
    }
}

#[test]
fn eq02_eq03() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            for s in ARCLENGTHS {
                let (sin, cos) = (std::f64::consts::TAU / t.n).sin_cos();
                let mut want: Vector = Centreline::new(&contact, hand, 0).position(s);
                for i in 1..=contact.strands() {
                    want = [cos * want[0] - sin * want[1], sin * want[0] + cos * want[1], want[2]];
                    let got = Centreline::new(&contact, hand, i).position(s);
                    assert_vector(got, want, 1e-13 * (t.rho + s.abs()), "turned by 2 pi/n once more");
                }
            }
        }
    }
}

#[test]
fn eq14_eq15() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let line = Centreline::new(&contact, hand, 1);
            for s in ARCLENGTHS {
                let d3 = line.frame(s).tangent;
                assert_vector(derivative(|s| line.position(s), s, H), d3, DIFFERENCE, "(14)");
                let psi = line.azimuth(s);
                assert_vector(d3, [t.s * psi.cos(), t.s * psi.sin(), t.c], 1e-14, "(15)");
            }
        }
    }
}

/// The directors turn about the Frenet frame by φ, whose rate is the pretwist (44); u has the curvature along the binormal
/// and u₃ along the tangent.
#[test]
fn eq16() {
    for state in states(Balance::Contact) {
        let line = Centreline::new(state.got.contact(), state.got.handedness(), 0);
        let directors = |s: f64| {
            let (frame, phi) = (line.frame(s), state.phi * s);
            let d1 = add(times(phi.cos(), frame.normal), times(phi.sin(), frame.binormal));
            let d2 = add(times(-phi.sin(), frame.normal), times(phi.cos(), frame.binormal));
            [d1, d2, frame.tangent]
        };
        for s in [0.0, 1.3] {
            let frame = line.frame(s);
            let kappa = state.got.contact().curvature();
            let u = add(times(kappa, frame.binormal), times(state.got.strand_twist(), frame.tangent));
            for i in 0..3 {
                let got = derivative(|s| directors(s)[i], s, H);
                assert_vector(got, cross(u, directors(s)[i]), 1e-8, &format!("d{}': {}", i + 1, state.name()));
            }
        }
    }
}

/// With ε before both terms of e_r and e_ψ.
#[test]
fn eq17_eq18_eq19() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let (eps, line) = (hand.sign(), Centreline::new(&contact, hand, 0));
            let e_r = |s: f64| [eps * line.azimuth(s).sin(), -eps * line.azimuth(s).cos(), 0.0];
            let e_psi = |s: f64| [eps * line.azimuth(s).cos(), eps * line.azimuth(s).sin(), 0.0];
            let e_z = [0.0, 0.0, 1.0];
            for s in ARCLENGTHS {
                let rate = eps * t.s / t.rho;
                let p = line.position(s);
                assert_vector([p[0], p[1], 0.0], times(t.rho, e_r(s)), 1e-12 * t.rho, "(17): outward");
                assert_vector(cross(e_r(s), e_psi(s)), e_z, 1e-15, "(17): right-handed");
                assert_vector(derivative(e_r, s, H), times(rate, e_psi(s)), DIFFERENCE, "(18)");
                assert_vector(derivative(e_psi, s, H), times(-rate, e_r(s)), DIFFERENCE, "(18)");
                let d3 = add(times(eps * t.s, e_psi(s)), times(t.c, e_z));
                assert_vector(line.frame(s).tangent, d3, 1e-14, "(19)");
                assert!((dot(line.frame(s).normal, e_r(s)) + 1.0).abs() < 1e-15, "the normal points inwards");
            }
        }
    }
}
