//! The energy of one strand as a function of the two displacements through which the end loads work.
//!
//! With Θ = εθ and Y = ε sin θ/ρ, the ply's rotation per strand length, (45) and (56) read
//! E = ½Y² sin²Θ + ½γ(φ̄a + Y cos Θ)² − (f/n) cos Θ − (m/n) Y, smooth through straight strands, where the hand changes.
//! Obstacles bound |Y|: neighbours by sin θ/ρ(θ) of touching strands, a core by sin θ/(1 + r_core/r).

use super::{Load, Twist};
use crate::Handedness;
use crate::geometry::HelicalAngle;

/// What the energy depends on besides shape, per strand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potential {
    /// γ r u₃ = `love`·Y cos Θ + `held`
    pub(super) love: f64,
    pub(super) held: f64,
    /// f/n
    pub(super) force: f64,
    /// m/n
    pub(super) moment: f64,
}

/// First and second derivatives of E with respect to Θ and Y.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slopes {
    /// ∂E/∂Θ
    pub(super) by_angle: f64,
    /// ∂E/∂Y, exactly 0 where its terms cancel to rounding, as on the verge of separation
    pub(super) by_rotation: f64,
    /// ∂²E/∂Θ²
    pub(super) angle_angle: f64,
    /// ∂²E/∂Θ∂Y
    pub(super) angle_rotation: f64,
    /// ∂²E/∂Y²
    pub(super) rotation_rotation: f64,
}

impl Potential {
    pub(super) fn new(strands: u32, gamma: f64, twist: Twist, load: Load) -> Self {
        let n = f64::from(strands);
        let (love, held) = twist.weights(gamma);
        Self { love, held, force: load.force / n, moment: load.moment / n }
    }

    /// At sin Θ (with the sign of the hand), cos Θ and Y. A strand twist that is held works against its moment:
    /// E = ½Y² sin²Θ + γ r u₃ Y cos Θ − … with the same slopes, `love` being 0.
    pub(super) fn at(&self, sin: f64, cos: f64, rotation: f64) -> Slopes {
        let (s, c, y) = (sin, cos, rotation);
        let moment = self.love * c * y + self.held; // γ r u₃
        let bracket = y * y * c - moment * y + self.force; // ∂E/∂Θ over sin Θ
        let by_rotation = y * s * s + moment * c - self.moment;
        let size = (y * s * s).abs() + (moment * c).abs() + self.moment.abs();
        Slopes {
            by_angle: s * bracket,
            by_rotation: if by_rotation.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { by_rotation },
            angle_angle: c * bracket + s * s * y * y * (self.love - 1.0),
            angle_rotation: s * (2.0 * y * c - moment - self.love * c * y),
            rotation_rotation: s * s + self.love * c * c,
        }
    }

    /// At a hand, an angle and ρ.
    pub(super) fn on(&self, handedness: Handedness, angle: HelicalAngle, rho: f64) -> Slopes {
        let eps = handedness.sign();
        self.at(eps * angle.sin(), angle.cos(), eps * angle.sin() / rho)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (56), typed again, and its differences.
    #[test]
    fn slopes_are_those_of_the_energy() {
        let (n, gamma, pretwist, load) = (3, 0.7, -0.4, Load { force: 0.3, moment: -0.5 });
        let energy = |t: f64, y: f64| {
            let u3 = pretwist + y * libm::cos(t);
            let bending = 0.5 * y * y * libm::sin(t) * libm::sin(t);
            bending + 0.5 * gamma * u3 * u3 - load.force / 3.0 * libm::cos(t) - load.moment / 3.0 * y
        };
        let potential = Potential::new(n, gamma, Twist::Pretwist(pretwist), load);
        let at = |t: f64, y: f64| potential.at(libm::sin(t), libm::cos(t), y);
        for (t, y) in [(0.4, 0.3), (-1.2, -0.5), (0.01, 0.005)] {
            let (here, h) = (at(t, y), 1e-5);
            let close = |got: f64, plus: f64, minus: f64| assert!((got - (plus - minus) / (2.0 * h)).abs() < 1e-9);
            close(here.by_angle, energy(t + h, y), energy(t - h, y));
            close(here.by_rotation, energy(t, y + h), energy(t, y - h));
            close(here.angle_angle, at(t + h, y).by_angle, at(t - h, y).by_angle);
            close(here.angle_rotation, at(t + h, y).by_rotation, at(t - h, y).by_rotation);
            close(here.angle_rotation, at(t, y + h).by_angle, at(t, y - h).by_angle);
            close(here.rotation_rotation, at(t, y + h).by_rotation, at(t, y - h).by_rotation);
        }
    }
}
