//! (44)–(49): strands that were twisted before the ply formed.

use nply::geometry::Centreline;
use nply::mechanics::{Balance, Load, Ply, Twist};

use crate::common::touch::Touch;
use crate::common::vector::{add, cross, derivative, dot, times};
use crate::state::{STRANDS, close, scale, states};

/// u₃ by its definition, d₁′·d₂, with the directors turned by φ about the Frenet frame.
#[test]
fn eq44() {
    for state in states(Balance::Contact) {
        let line = Centreline::new(state.got.contact(), state.got.handedness(), 0);
        let d1 = |s: f64| {
            let (frame, phi) = (line.frame(s), state.phi * s);
            add(times(phi.cos(), frame.normal), times(phi.sin(), frame.binormal))
        };
        let s = 0.6;
        let d2 = cross(line.frame(s).tangent, d1(s));
        let u3 = dot(derivative(d1, s, 1e-2), d2);
        close(state.got.strand_twist(), u3, 1.0, 1e-8, &state.name());
        let psi_rate = state.eps * state.t.s / state.t.rho;
        close(state.got.strand_twist(), state.phi + psi_rate * state.t.c, 1.0, 1e-14, "(44)");
    }
}

#[test]
fn eq45_eq46() {
    let (scale, r, length) = (scale(), 0.3, 25.0);
    for state in states(Balance::Radial) {
        let a = r / length; // (46)
        let rotation = state.got.pretwist() / a; // φ̄
        let big_r = scale.length(state.got.contact().radius_ratio());
        let u3 = rotation / length + state.eps * (2.0 * state.t.theta).sin() / (2.0 * big_r);
        close(scale.per_length(state.got.strand_twist()), u3, 1.0, 1e-13, &state.name());
    }
}

#[test]
fn eq47() {
    for state in states(Balance::Radial) {
        let Touch { n, theta, s, c, rho, .. } = state.t;
        let (eps, gamma) = (state.eps, state.gamma);
        let g = |f: f64, m: f64, phi: f64| {
            2.0 * n * s.powi(3) * c
                + n * gamma / 4.0 * (4.0 * theta).sin()
                + eps * n * gamma * phi * rho * (2.0 * theta).cos()
                + rho * rho * f * s
                - eps * rho * m * c
        };
        close(g(state.f, state.m, state.phi), 0.0, state.balance_size(), 2e-14, &state.name());
        // the library finds this state from its pretwist and loads
        let ply = Ply::with_balance(state.got.contact().strands(), gamma, Balance::Radial).unwrap();
        let found = ply.equilibria(Twist::Pretwist(state.phi), Load { force: state.f, moment: state.m }).unwrap();
        let near = found
            .iter()
            .filter(|s| s.handedness() == state.got.handedness())
            .fold(f64::MAX, |least, s| least.min((s.contact().helical_angle() - theta).abs()));
        assert!(near < 1e-9, "{near:e} from {}", state.name());
    }
}

#[test]
fn eq48() {
    for state in states(Balance::Radial) {
        let Touch { n, s, c, rho, .. } = state.t;
        let (eps, gamma) = (state.eps, state.gamma);
        let sum = n * (1.0 - gamma) * s * s * c - eps * n * gamma * state.phi * rho * s + rho * rho * state.f;
        let want = s * s / c / (n * rho.powi(3)) * sum;
        let size = state.pressure_size() + s * s / (c * rho.powi(3)) * (s * s * c + (gamma * state.phi * rho).abs());
        close(state.got.resultant_pressure(), want, size + (s * s / c / rho / n * state.f).abs(), 1e-13, &state.name());
    }
}

/// Stripes painted on straight strands stand at χ to the strand once the pretwist is in.
#[test]
fn eq49() {
    for n in STRANDS {
        let ply = Ply::new(n, 0.75).unwrap();
        for chi in [-0.9_f64, -0.2, 0.0, 0.3, 1.2] {
            let twist = Twist::Pretwist(chi.tan());
            let straight = nply::geometry::HelicalAngle::new(0.0).unwrap();
            let state = ply.moment_at(straight, nply::Handedness::Right, twist, 0.4).unwrap();
            // the stripe at the surface of a strand of radius 1 that turns by r u₃ per length
            let stripe = |s: f64| {
                let turn = state.strand_twist() * s;
                [turn.cos(), turn.sin(), s]
            };
            let tangent = derivative(stripe, 0.8, 1e-2);
            close(tangent[0].hypot(tangent[1]).atan2(tangent[2]), chi.abs(), 1.0, 1e-7, "chi");
            close(state.load().moment, f64::from(n) * 0.75 * chi.tan(), 10.0, 1e-14, "m = n gamma tan(chi) holds it");
        }
    }
}
