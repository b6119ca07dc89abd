//! (9)–(11): the surface of a strand and the cut across it.

use nply::Handedness;
use nply::geometry::{Centreline, Section};

use crate::common::vector::{add, assert_vector, cross, derivative, norm, times};
use crate::state::{close, contacts};

const ALPHAS: [f64; 6] = [0.0, 0.4, std::f64::consts::FRAC_PI_2, 2.9, 4.0, 5.9];

/// With n = r″/|r″|; print has r′.
#[test]
fn eq09() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let (line, section) = (Centreline::new(&contact, hand, 0), Section::new(&contact, hand));
            let first = |s| derivative(|s| line.position(s), s, 1e-2);
            for s in [0.0, 1.7] {
                let second = derivative(first, s, 1e-2);
                let normal = times(1.0 / norm(second), second);
                let binormal = cross(first(s), normal);
                // differences of differences, over the curvature
                let tolerance = 1e-8 / contact.curvature();
                assert_vector(line.frame(s).normal, normal, tolerance, "n");
                assert_vector(line.frame(s).binormal, binormal, tolerance, "b");
                for alpha in ALPHAS {
                    let want = add(
                        line.position(s),
                        add(times(alpha.sin(), line.frame(s).normal), times(alpha.cos(), line.frame(s).binormal)),
                    );
                    assert_vector(section.surface(s, alpha), want, 1e-14 * (1.0 + t.rho), "(9)");
                }
            }
        }
    }
}

#[test]
fn eq10() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let (eps, section) = (hand.sign(), Section::new(&contact, hand));
            for s in [-2.0, 0.0, 1.7] {
                for alpha in ALPHAS {
                    let psi = eps * s * t.s / t.rho;
                    let (big, cos_theta, sin_theta) = (t.rho, t.c, t.s);
                    let want = [
                        big * psi.sin() - alpha.sin() * psi.sin() - alpha.cos() * cos_theta * psi.cos(),
                        -big * psi.cos() + alpha.sin() * psi.cos() - alpha.cos() * cos_theta * psi.sin(),
                        eps * s * cos_theta + alpha.cos() * sin_theta,
                    ];
                    assert_vector(section.surface(s, alpha), times(eps, want), 1e-13 * (1.0 + t.rho), "(10)");
                }
            }
        }
    }
}

#[test]
fn eq11() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let (eps, section) = (hand.sign(), Section::new(&contact, hand));
            for z0 in [-1.0, 0.0, 0.6] {
                for alpha in ALPHAS {
                    let s = (z0 - eps * alpha.cos() * t.s) / t.c;
                    close(section.arclength(z0, alpha), s, 1.0 + s.abs(), 1e-14, "(11)");
                    let [x, y, z] = section.surface(section.arclength(z0, alpha), alpha);
                    close(z, z0, 1.0, 1e-14, "in the plane");
                    for strand in 0..contact.strands() {
                        let (sin, cos) = (std::f64::consts::TAU * f64::from(strand) / t.n).sin_cos();
                        let [got_x, got_y] = section.outline(strand, z0, alpha);
                        close(got_x, cos * x - sin * y, 1.0 + t.rho, 1e-13, "x of the outline");
                        close(got_y, sin * x + cos * y, 1.0 + t.rho, 1e-13, "y of the outline");
                    }
                }
            }
        }
    }
}
