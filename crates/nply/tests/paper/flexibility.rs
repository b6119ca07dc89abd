//! (60)–(64), (67): the ply's flexibility.

use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Load, Ply};

use crate::common::touch::{Touch, slope, touch_at};
use crate::state::{State, balanced, close, states};

/// G of (47), and with the share of contact forces in contact balance, along the branch at the state's own data.
pub(crate) fn along(state: &State, theta: f64) -> f64 {
    let n = state.got.contact().strands();
    let t = touch_at(n, theta);
    let here = State { t, u3: state.phi + state.eps * t.s * t.c / t.rho, ..State::new(state.got) };
    let Touch { n, s, c, x, rho, .. } = t;
    let radial = 2.0 * n * s.powi(3) * c
        + n * state.gamma / 4.0 * (4.0 * theta).sin()
        + state.eps * n * state.gamma * state.phi * rho * (2.0 * theta).cos()
        + rho * rho * state.f * s
        - state.eps * rho * state.m * c;
    match state.got.balance() {
        Balance::Radial => radial,
        Balance::Contact => radial + n * rho * rho * here.thirty_seven() * rho.powi(3) * x * x * c / s / 4.0,
    }
}

/// A step small beside the distance to both ends and to π/4, where the 2-ply's branch has a corner.
pub(crate) fn step(theta: f64) -> f64 {
    let quarter = std::f64::consts::FRAC_PI_4;
    2e-2 * theta.min(2.0 * quarter - theta).min((theta - quarter).abs())
}

/// What differences leave of a slope of G: steps of 2 % of the distance to a singularity.
fn slack(state: &State) -> f64 {
    state.balance_size() / step(state.t.theta) * 50.0 / state.t.c.powi(2)
}

#[test]
fn balance_slope_by_differences() {
    for balance in Balance::BOTH {
        for state in states(balance).into_iter().chain(balanced(balance)) {
            let theta = state.t.theta;
            let want = slope(|t| along(&state, t), theta, step(theta));
            close(state.got.balance_slope(), want, slack(&state), 1e-10, &state.name());
            close(state.got.balance_residual(), 0.0, state.balance_size() / state.t.c.powi(2), 1e-13, &state.name());
        }
    }
}

/// The chain rule (60) with (61) and (62), the displacements differentiated along the branch by differences.
#[test]
fn eq60_eq61_eq62() {
    for balance in Balance::BOTH {
        for state in states(balance).into_iter().chain(balanced(balance)) {
            let Touch { theta, s, c, rho, .. } = state.t;
            let n = state.got.contact().strands();
            let g_theta = state.got.balance_slope();
            let (by_force, by_moment) = state.got.angle_slopes().unwrap();
            // ∂G/∂f and ∂G/∂m; contact balance has (1 − q) in the second, q = (xρ/2)²
            let q = if balance == Balance::Contact { (state.t.x * rho / 2.0).powi(2) } else { 0.0 };
            let (g_f, g_m) = (rho * rho * s, -state.eps * rho * c * (1.0 - q));
            close(g_f + g_theta * by_force, 0.0, g_f, 1e-12, "(61), f");
            close(g_m + g_theta * by_moment, 0.0, rho * c * (1.0 + q), 1e-12, "(61), m");
            let [[ff, fm], [mf, mm]] = state.got.flexibility().unwrap();
            let df = slope(f64::cos, theta, 1e-3);
            let dm = slope(|t| state.eps * t.sin() / touch_at(n, t).rho, theta, step(theta));
            close(ff, df * by_force, ff, 1e-9, &format!("(60): {}", state.name()));
            close(fm, df * by_moment, fm, 1e-9, &format!("(60): {}", state.name()));
            close(mf, dm * by_force, by_force, 3e-7, &format!("(60): {}", state.name()));
            close(mm, dm * by_moment, by_moment, 3e-7, &format!("(60): {}", state.name()));
        }
    }
}

/// As printed, which drops ρ′ from d(d_m)/dθ.
#[test]
fn eq63() {
    for state in balanced(Balance::Radial) {
        let Touch { s, c, rho, .. } = state.t;
        let g_theta = state.got.balance_slope();
        let [[ff, fm], [mf, mm]] = state.got.flexibility_as_published().unwrap();
        close(ff, rho * rho * s * s / g_theta, ff, 1e-13, "ff");
        close(fm, -state.eps * rho * s * c / g_theta, fm, 1e-13, "fm");
        close(mf, -state.eps * rho * s * c / g_theta, mf, 1e-13, "mf");
        close(mm, c * c / g_theta, mm, 1e-13, "mm");
        if state.t.n == 2.0 && state.t.theta < std::f64::consts::FRAC_PI_4 {
            let whole = state.got.flexibility().unwrap();
            close(whole[1][0], mf, mf, 1e-13, "line contact: nothing was dropped");
            close(whole[1][1], mm, mm, 1e-13, "line contact: nothing was dropped");
        }
    }
    for state in balanced(Balance::Contact) {
        assert!(state.got.flexibility_as_published().is_none() && state.got.stiffness_as_published().is_none());
    }
}

#[test]
fn eq64() {
    for state in balanced(Balance::Radial) {
        let Touch { n, theta, s, c, x, rho, .. } = state.t;
        let gamma = state.gamma;
        let rho_slope = rho.powi(3) * x * x * c / s / 4.0;
        let cos2 = (2.0 * theta).cos();
        let terms = [
            n * (gamma - 1.0) * cos2 * cos2,
            n / cos2,
            -(8.0 * s.powi(3) * c + gamma * (4.0 * theta).sin()) * n / (4.0 * rho) * rho_slope,
        ];
        let size: f64 = terms.iter().map(|t| t.abs()).sum();
        // the pretwist that holds the state was rounded: times the slope of its term
        let pretwist = (n * gamma * state.phi * rho_slope).abs() + (n * gamma * state.phi * rho).abs();
        close(state.got.balance_slope(), terms.iter().sum(), size + pretwist, 1e-12, &state.name());
    }
}

/// The first terms, expanded here: with u = θ₀², ½G_θ = (γ − 1)cos²2θ₀ + 1/cos 2θ₀ = γ + (6 − 4γ)u + (16γ/3 − 2)u² + …
#[test]
fn eq67() {
    for gamma in [0.6, 0.75, 1.0, 1.4] {
        let ply = Ply::with_balance(2, gamma, Balance::Radial).unwrap();
        let (a1, b1, c1) = (11.0 * gamma / 3.0 - 6.0, 10.0 * gamma / 3.0 - 6.0, 3.0 * gamma - 6.0);
        let a2 = 422.0 / 45.0 * gamma * gamma - 44.0 * gamma + 36.0;
        let b2 = 122.0 / 15.0 * gamma * gamma - 42.0 * gamma + 36.0;
        let c2 = 7.0 * gamma * gamma - 40.0 * gamma + 36.0;
        for hand in Handedness::BOTH {
            let remainder = |theta: f64, terms: usize| {
                let angle = HelicalAngle::new(theta).unwrap();
                let state = ply.pretwist_at(angle, hand, Load::NONE).unwrap();
                let [[ff, fm], [_, mm]] = state.flexibility().unwrap();
                let u = theta * theta / gamma;
                let sum = |k1: f64, k2: f64| match terms {
                    1 => 1.0,
                    2 => 1.0 + k1 * u,
                    _ => 1.0 + k1 * u + k2 * u * u,
                };
                // each over its leading term, so that all three remainders are of the order of u to the terms
                [
                    ff * 2.0 / u - sum(a1, a2),
                    -hand.sign() * fm * 2.0 * theta / u - sum(b1, b2),
                    mm * 2.0 * gamma - sum(c1, c2),
                ]
            };
            for terms in 1..=3 {
                let (wide, narrow) = (remainder(0.04, terms), remainder(0.02, terms));
                for (wide, narrow) in wide.into_iter().zip(narrow) {
                    let order = (wide / narrow).log2() / 2.0;
                    assert!((order - terms as f64).abs() < 0.1, "gamma = {gamma}, {terms} terms: {wide:e} {narrow:e}");
                }
            }
        }
    }
}
