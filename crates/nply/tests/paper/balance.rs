//! (37)–(43): pressures and the equation of equilibrium at a given twist of the strands.

use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};

use crate::common::touch::Touch;
use crate::state::{State, balanced, close, scale, states};

#[test]
fn eq37() {
    for balance in Balance::BOTH {
        for state in states(balance) {
            let want = state.thirty_seven();
            close(state.got.radial_pressure(), want, state.pressure_size(), 1e-13, &state.name());
            if balance == Balance::Radial {
                close(state.got.resultant_pressure(), want, state.pressure_size(), 1e-13, &state.name());
            }
        }
    }
}

/// In both balances: the relation is geometry.
#[test]
fn eq38() {
    for balance in Balance::BOTH {
        for state in states(balance) {
            let Touch { c, x, rho, beta, .. } = state.t;
            let (p, p1) = (state.got.resultant_pressure(), state.got.interstrand_pressure());
            let lost = 1e-15 / (1.0 - beta.cos()) + 1e-13; // the cosine's last digit
            close(p1, p / (rho * (1.0 - beta.cos())), p1, lost, &format!("first line: {}", state.name()));
            let ratio = (2.0 * (1.0 - beta.cos()) + x * x * c * c).sqrt() / (2.0 * (1.0 - beta.cos()));
            close(p1, p * ratio, p1, lost, &format!("second line: {}", state.name()));
            assert_eq!(p > 0.0, p1 > 0.0, "the same sign");
        }
    }
}

#[test]
fn eq39() {
    let (scale, r, b) = (scale(), 0.3, 7.0);
    for (f, m) in [(0.7, -0.2), (-3.0, 11.0)] {
        let (big_f, big_m) = (scale.force(f), scale.moment(m));
        close(r * r * big_f / b, f, f, 1e-15, "f");
        close(r * big_m / b, m, m, 1e-15, "m");
        let c = scale.stiffness(0.75);
        close(c / b, 0.75, 1.0, 1e-15, "gamma");
    }
}

/// The left side of (40), with the strands' twist given, at states and away from them.
fn forty(state: &State) -> f64 {
    let Touch { n, theta, s, c, rho, .. } = state.t;
    2.0 * n * s.powi(3) * c
        + state.eps * n * rho * state.gamma * state.u3 * (2.0 * theta).cos()
        + rho * rho * state.f * s
        - state.eps * rho * state.m * c
}

#[test]
fn eq40() {
    for state in states(Balance::Radial) {
        close(forty(&state), 0.0, state.balance_size(), 2e-14, &state.name());
        // a dead moment in the strands finds the same state
        let ply = Ply::with_balance(state.got.contact().strands(), state.gamma, Balance::Radial).unwrap();
        let found: Vec<Equilibrium> =
            ply.equilibria(Twist::StrandTwist(state.got.strand_twist()), state.got.load()).unwrap();
        assert!(!found.is_empty());
        let near = found
            .iter()
            .filter(|s| s.handedness() == state.got.handedness())
            .fold(f64::MAX, |least, s| least.min((s.contact().helical_angle() - state.t.theta).abs()));
        assert!(near < 1e-9, "{near:e} from {}", state.name());
    }
}

#[test]
fn eq41() {
    for state in states(Balance::Radial) {
        let Touch { n, theta, s, c, rho, .. } = state.t;
        let sum = n * s * s + rho * rho * state.f * c - state.eps * rho * state.m * s;
        let want = s * s / (n * rho.powi(3) * (2.0 * theta).cos()) * sum;
        // the singularity at π/4 is removable and takes digits
        let size = state.pressure_size() + s * s / rho.powi(3) * (s * s + (rho * rho * state.f).abs());
        close(state.got.resultant_pressure(), want, size, 1e-12, &state.name());
    }
}

#[test]
fn eq42_eq43() {
    for state in balanced(Balance::Radial) {
        let Touch { theta, s, c, rho, .. } = state.t;
        let twist = -2.0 * s.powi(3) * c / (rho * (2.0 * theta).cos());
        let size = state.gamma / rho + twist.abs(); // near straight strands the pretwist undoes the torsion
        close(
            state.eps * state.gamma * state.got.strand_twist(),
            twist,
            size,
            1e-13,
            &format!("(42): {}", state.name()),
        );
        let p = s.powi(4) / (rho.powi(3) * (2.0 * theta).cos());
        close(state.got.resultant_pressure(), p, state.pressure_size(), 1e-12, &format!("(43): {}", state.name()));
        assert_eq!(state.got.is_separated(), theta > std::f64::consts::FRAC_PI_4, "pressed together below 45 degrees");
        assert_eq!(state.got.load(), Load::NONE);
    }
}
