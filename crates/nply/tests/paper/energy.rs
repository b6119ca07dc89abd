//! (52)–(59): energy, and equilibrium as its stationary point.

use nply::mechanics::Balance;

use crate::common::touch::{Touch, slope};
use crate::state::{State, close, pressed_states, scale, states};

#[test]
fn eq52_eq53_eq54_eq55() {
    let (scale, r, b, length) = (scale(), 0.3, 7.0, 25.0);
    for pressure in [0.0, -0.4] {
        for state in pressed_states(Balance::Contact, pressure) {
            let Touch { n, s, c, rho, .. } = state.t;
            let (energy, big_r) = (state.got.energy(), rho * r);
            let whole = |part: f64| n * length * scale.energy_per_length(part);
            let kappa = s * s / big_r;
            let bending = 0.5 * n * length * b * kappa * kappa;
            close(whole(energy.bending), bending, bending, 1e-13, "(52)");
            let (stiffness, u3) = (state.gamma * b, state.u3 / r);
            let torsion = 0.5 * n * length * stiffness * u3 * u3;
            close(whole(energy.torsion), torsion, whole(state.gamma), 1e-13, "(53)");
            let p = scale.force_per_length(pressure);
            close(whole(energy.pressure), -n * length * p * big_r, whole(rho), 1e-13, "(54)");
            let (f0, m0) = (scale.force(state.f), scale.moment(state.m));
            let load = -f0 * length * c - state.eps * m0 * length / big_r * s;
            close(whole(energy.load), load, (f0 * length).abs() + (m0 * length / big_r).abs(), 1e-13, "(55)");
        }
    }
}

/// ℒ of (56) per strand length as a function of θ and R, with x given; r = B = 1.
fn lagrangian(state: &State, theta: f64, rho: f64, x: f64, p: f64, lambda: f64) -> f64 {
    let n = state.t.n;
    let (s, c) = theta.sin_cos();
    let delta = 2.0 + x * x * c * c - 2.0 * (x * s - std::f64::consts::TAU / n).cos();
    let twist = state.phi + state.eps * s * c / rho;
    s.powi(4) / (2.0 * rho * rho) + state.gamma / 2.0 * twist * twist
        - state.f / n * c
        - state.eps * state.m / (n * rho) * s
        - p * rho
        - lambda * rho * rho * delta
}

#[test]
fn eq56() {
    for pressure in [0.0, 0.3] {
        for state in pressed_states(Balance::Contact, pressure) {
            let t = state.t;
            let want = lagrangian(&state, t.theta, t.rho, t.x, pressure, 0.0);
            let size = 1.0 + state.f.abs() + state.m.abs() + pressure.abs() * t.rho;
            close(state.got.energy().total(), want, size, 1e-13, &state.name());
        }
    }
}

/// The two conditions (57), (58) for given p, with the λ that (57) asks for, and both as slopes of (56).
fn stationary(state: &State, p: f64, lambda: f64) {
    let Touch { n, theta, s, c, x, rho, beta } = state.t;
    let (eps, gamma, u3) = (state.eps, state.gamma, state.u3);
    let delta = 2.0 + x * x * c * c - 2.0 * beta.cos();
    close(rho * rho * delta, 4.0, rho * rho, 1e-14, "(59)");
    let fifty_seven = state.thirty_seven() - 2.0 * lambda * rho * delta;
    let size = state.pressure_size() + p.abs() + (lambda * rho).abs();
    close(fifty_seven, p, size, 1e-13, &format!("(57): {}", state.name()));
    let delta_slope = -2.0 * x * x * c * s + 2.0 * x * c * beta.sin();
    let fifty_eight =
        2.0 / (rho * rho) * s.powi(3) * c + eps * gamma * u3 / rho * (2.0 * theta).cos() + state.f / n * s
            - eps * state.m / (n * rho) * c
            - lambda * rho * rho * delta_slope;
    let size = state.balance_size() / (n * rho * rho) + (lambda * rho * rho * x * c).abs() * 4.0;
    close(fifty_eight, 0.0, size, 1e-12, &format!("(58): {}", state.name()));

    // by differences, each variable on its own; h⁴ and rounding over h
    let (h, size) = (1e-3, 10.0 * (1.0 + state.m.abs() + state.f.abs() + p.abs() * rho + (lambda * rho * rho).abs()));
    let by_theta = slope(|theta| lagrangian(state, theta, rho, x, p, lambda), theta, h);
    close(by_theta, 0.0, size, 1e-9, &format!("theta: {}", state.name()));
    let by_rho = slope(|rho| lagrangian(state, theta, rho, x, p, lambda), rho, h);
    close(by_rho, 0.0, size, 1e-9, &format!("R: {}", state.name()));
    let by_x = slope(|x| lagrangian(state, theta, rho, x, p, lambda), x, h);
    close(by_x, 0.0, size, 1e-9, &format!("x, which is (5): {}", state.name()));
}

/// Radial balance: λ = 0 and the pressure is the whole load between the strands.
#[test]
fn eq57_eq58_eq59_radial() {
    for state in states(Balance::Radial) {
        stationary(&state, state.got.resultant_pressure(), 0.0);
    }
}

/// Contact balance: the pressure is the external one, and λ carries what the neighbours carry.
#[test]
fn eq57_eq58_eq59_contact() {
    for pressure in [0.0, 0.35, -0.6] {
        for state in pressed_states(Balance::Contact, pressure) {
            let lambda = (state.got.radial_pressure() - pressure) * state.t.rho / 8.0; // 2ρΔ = 8/ρ
            stationary(&state, pressure, lambda);
            let p1 = state.got.interstrand_pressure();
            close(p1, 4.0 * lambda, p1.abs() + state.pressure_size(), 1e-12, "p1 = rho (p - p_e)/2");
        }
    }
}
