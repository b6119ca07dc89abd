//! (4)–(8), (12), (13), (65), (66): contact between neighbours.

use std::f64::consts::{PI, TAU};

use nply::Handedness;
use nply::geometry::{Centreline, Contact, ContactLine, DensestHelix, HelicalAngle};

use crate::common::touch::{slope, touch_at};
use crate::common::vector::{add, assert_vector, derivative, dot, norm, sub, times};
use crate::state::{STRANDS, close, contacts};

#[test]
fn eq04() {
    for (contact, t) in contacts() {
        let (x, rho) = (contact.arclength_shift(), contact.radius_ratio());
        let delta = 2.0 + x * x * t.c * t.c - 2.0 * (x * t.s - TAU / t.n).cos();
        // the terms of print, up to 4, cancel at large ρ
        close(delta, 4.0 / (rho * rho), 1.0, 3e-15, &format!("{contact:?}"));
        close(rho, t.rho, t.rho, 2e-14, "against bisection");
    }
}

#[test]
fn eq05() {
    for (contact, t) in contacts() {
        let x = contact.arclength_shift();
        let five = x * t.c * t.c + t.s * (x * t.s - TAU / t.n).sin();
        close(five, 0.0, t.s, 2e-15, &format!("{contact:?}"));
        close(x, t.x, 1.0, 1e-13, "against bisection");
    }
}

/// The two conditions themselves, on the centrelines; with them the sign and the unit of the shift.
#[test]
fn eq06_and_the_two_conditions() {
    for (contact, _) in contacts() {
        for hand in Handedness::BOTH {
            let (r1, r2) = (Centreline::new(&contact, hand, 0), Centreline::new(&contact, hand, 1));
            let s1 = 2.3;
            let s2 = s1 - hand.sign() * contact.arclength_shift() * contact.radius_ratio();
            let line = sub(r1.position(s1), r2.position(s2));
            close(norm(line), 2.0, 1.0, 1e-13 * contact.radius_ratio(), "C1");
            close(dot(r1.frame(s1).tangent, line), 0.0, 1.0, 1e-13 * contact.radius_ratio(), "C2 on strand 1");
            close(dot(r2.frame(s2).tangent, line), 0.0, 1.0, 1e-13 * contact.radius_ratio(), "C2 on strand 2");
            let shift = ContactLine::new(&contact, hand).shift();
            close(s2 - s1, shift, shift, 1e-13, "the contact line's shift");
        }
    }
}

#[test]
fn eq07_and_the_other_limit() {
    for n in STRANDS {
        let straight = Contact::new(n, 0.0).unwrap();
        let strands = f64::from(n);
        close(straight.radius_ratio(), 1.0 / (PI / strands).sin(), 1.0, 2e-15 * strands, "(7)");
        assert_eq!(straight.arclength_shift(), 0.0);
        let flat = Contact::at_angle(n, HelicalAngle::from_pitch_angle(1e-9).unwrap()).unwrap();
        close(flat.arclength_shift(), TAU / strands, 1.0, 1e-14, "x at pi/2");
        assert!(flat.radius_ratio() > 1e8);
    }
}

#[test]
fn eq08() {
    let helix = DensestHelix::new();
    let (theta, x, rho) = (helix.helical_angle(), helix.arclength_shift(), helix.radius_ratio());
    assert!((theta - 1.190458).abs() < 5e-7 && (theta.to_degrees() - 68.2082).abs() < 5e-5, "{theta}");
    assert!((x - 5.685134).abs() < 5e-7 && (rho - 0.862185).abs() < 5e-7, "{x} {rho}");
    let (s, c) = theta.sin_cos();
    close(2.0 + x * x * c * c - 2.0 * (x * s - TAU).cos(), 4.0 / (rho * rho), 5.0, 1e-15, "(4) with n = 1");
    close(x * c * c + s * (x * s - TAU).sin(), 0.0, 1.0, 1e-15, "(5) with n = 1");
    close(rho, s * s, 1.0, 2e-16, "curvature 1/r");
}

#[test]
fn eq12_eq13() {
    for (contact, t) in contacts() {
        for hand in Handedness::BOTH {
            let eps = hand.sign();
            let (r1, r2) = (Centreline::new(&contact, hand, 0), Centreline::new(&contact, hand, 1));
            let line = ContactLine::new(&contact, hand);
            for s1 in [-4.0, 0.0, 2.5] {
                let s2 = s1 - eps * t.rho * t.x;
                let mean = 0.5 * (s1 + s2);
                let size = 1e-13 * (t.rho + s1.abs() + s2.abs());
                let twelve = times(0.5, add(r1.position(s1), r2.position(s2)));
                assert_vector(line.position(mean), twelve, size, "(12)");
                let psi = eps * t.s / t.rho * mean;
                let radius = t.rho * (0.5 * t.x * t.s - PI / t.n).cos();
                let thirteen =
                    [eps * radius * (psi + PI / t.n).sin(), -eps * radius * (psi + PI / t.n).cos(), mean * t.c];
                assert_vector(line.position(mean), thirteen, size, "(13)");
                close(line.radius(), radius.abs(), t.rho, 2e-14, "its radius");
                // a helix of radius ρ cos(β/2), rising like the strands
                let tangent = derivative(|s| line.position(s), mean, 1e-2);
                close(tangent[2], t.c, 1.0, 1e-9, "its rise");
                close(tangent[0].hypot(tangent[1]), radius.abs() * t.s / t.rho, 1.0, 1e-9, "its way round");
            }
        }
    }
}

/// With −2x sin θ sin β: print has +.
#[test]
fn eq65() {
    for (contact, t) in contacts() {
        let (x, s, c, b) = (t.x, t.s, t.c, t.beta);
        let printed =
            t.rho.powi(3) * (-x * x * c * c - 2.0 * x * s * b.sin() + x * x * b.cos() + b.sin() * b.sin()) * s * c
                / (4.0 * (c * c + s * s * b.cos()));
        let got = contact.radius_ratio_slope();
        // the quotient loses digits towards the pitchfork and towards flat rings
        if !(contact.strands() == 2 && (t.theta - PI / 4.0).abs() < 0.05) && t.theta < 1.3 {
            close(got, printed, 1.0 + got.abs(), 1e-11, &format!("{contact:?}"));
        }
        close(got, t.rho.powi(3) * x * x * c / s / 4.0, 1.0 + got.abs(), 1e-12, "in short");
        let h = 1e-3 * (PI / 2.0 - t.theta).min(t.theta).min((t.theta - PI / 4.0).abs());
        let difference = slope(|theta| touch_at(contact.strands(), theta).rho, t.theta, h);
        close(got, difference, t.rho + got, 3e-8, &format!("by differences: {contact:?}"));
    }
}

#[test]
fn eq66() {
    for (contact, t) in contacts() {
        close(-contact.anomaly(), t.x * t.s - TAU / t.n, 1.0, 2e-14, "beta");
        close(contact.anomaly(), -t.beta, t.beta, 2e-13, "beta, relative");
    }
}
