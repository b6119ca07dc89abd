//! States of the grid, in the paper's letters.

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::{Handedness, Scale};

use crate::common::touch::{Touch, touch};

pub(crate) const STRANDS: [u32; 7] = [2, 3, 4, 5, 6, 7, 12];
/// On both sides of π/4 and close to it, and towards both ends; none is a pole of the equations below.
pub(crate) const DEGREES: [f64; 11] = [2.0, 9.0, 20.0, 33.0, 41.0, 44.5, 46.0, 55.0, 68.0, 80.0, 87.0];

/// One equilibrium with its letters; `t` has n, θ, x, ρ, β by bisection.
pub(crate) struct State {
    pub(crate) got: Equilibrium,
    pub(crate) t: Touch,
    pub(crate) eps: f64,
    pub(crate) gamma: f64,
    /// φ̄a
    pub(crate) phi: f64,
    /// r u₃ by (45)
    pub(crate) u3: f64,
    pub(crate) f: f64,
    pub(crate) m: f64,
}

impl State {
    pub(crate) fn new(got: Equilibrium) -> Self {
        let t = touch(got.contact().strands(), got.contact().angle());
        let (eps, phi) = (got.handedness().sign(), got.pretwist());
        Self {
            got,
            t,
            eps,
            gamma: got.stiffness_ratio(),
            phi,
            u3: phi + eps * (2.0 * t.theta).sin() / (2.0 * t.rho),
            f: got.load().force,
            m: got.load().moment,
        }
    }

    pub(crate) fn name(&self) -> String {
        format!(
            "n = {}, {:.3} deg, eps = {}, gamma = {}, pretwist = {}, f = {}, m = {}, {}",
            self.t.n,
            self.t.theta.to_degrees(),
            self.eps,
            self.gamma,
            self.phi,
            self.f,
            self.m,
            self.got.balance().name()
        )
    }

    /// (37): p̂ r³/B.
    pub(crate) fn thirty_seven(&self) -> f64 {
        let Touch { n, s, c, rho, .. } = self.t;
        -s.powi(4) / rho.powi(3) - self.eps * self.gamma * self.u3 * s * c / rho.powi(2)
            + self.eps * self.m * s / (n * rho.powi(2))
    }

    /// The size of the terms of (37), for tolerances.
    pub(crate) fn pressure_size(&self) -> f64 {
        let Touch { n, s, c, rho, .. } = self.t;
        s.powi(4) / rho.powi(3)
            + (self.gamma * self.u3 * s * c / rho.powi(2)).abs()
            + (self.m * s / n / rho.powi(2)).abs()
    }

    /// The size of the terms of (47), for tolerances.
    pub(crate) fn balance_size(&self) -> f64 {
        let Touch { n, s, c, rho, .. } = self.t;
        2.0 * n * s.powi(3) * c
            + n * self.gamma * s * c
            + (n * self.gamma * self.phi * rho).abs()
            + (rho * rho * self.f * s).abs()
            + (rho * self.m * c).abs()
    }
}

pub(crate) fn angle(degrees: f64) -> HelicalAngle {
    if degrees < 45.0 {
        HelicalAngle::new(degrees.to_radians()).unwrap()
    } else {
        HelicalAngle::from_pitch_angle((90.0 - degrees).to_radians()).unwrap()
    }
}

/// Every contact of the grid with its letters.
pub(crate) fn contacts() -> Vec<(Contact, Touch)> {
    let mut all = Vec::new();
    for n in STRANDS {
        for degrees in DEGREES {
            all.push((Contact::at_angle(n, angle(degrees)).unwrap(), touch(n, angle(degrees))));
        }
    }
    all
}

/// Loaded states at every angle, the moment being what holds them.
pub(crate) fn states(balance: Balance) -> Vec<State> {
    pressed_states(balance, 0.0)
}

pub(crate) fn pressed_states(balance: Balance, pressure: f64) -> Vec<State> {
    let mut all = Vec::new();
    for n in STRANDS {
        for gamma in [0.4, 0.75, 1.0, 1.3] {
            let ply = Ply::with_balance(n, gamma, balance).unwrap().with_external_pressure(pressure).unwrap();
            for degrees in DEGREES {
                for hand in Handedness::BOTH {
                    for (phi, f) in [(-1.2, 0.0), (0.3, -0.7), (0.0, 2.0)] {
                        let state = ply.moment_at(angle(degrees), hand, Twist::Pretwist(phi), f).unwrap();
                        all.push(State::new(state));
                    }
                }
            }
        }
    }
    all
}

/// Balanced states (f = m = 0) at every angle, the pretwist being what holds them.
pub(crate) fn balanced(balance: Balance) -> Vec<State> {
    let mut all = Vec::new();
    for n in STRANDS {
        for gamma in [0.4, 0.75, 1.0, 1.3] {
            let ply = Ply::with_balance(n, gamma, balance).unwrap();
            for degrees in DEGREES {
                for hand in Handedness::BOTH {
                    all.push(State::new(ply.pretwist_at(angle(degrees), hand, Load::NONE).unwrap()));
                }
            }
        }
    }
    all
}

/// A scale that is no power of ten and whose two members differ.
pub(crate) fn scale() -> Scale {
    Scale::new(0.3, 7.0).unwrap()
}

/// Panics unless `got` is `want` to within `tolerance` times `size`.
#[track_caller]
pub(crate) fn close(got: f64, want: f64, size: f64, tolerance: f64, what: &str) {
    assert!((got - want).abs() <= tolerance * size.abs(), "{got:e}, wanted {want:e}: {what}");
}
