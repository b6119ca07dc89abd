//! The energy of one strand that stretches, over angle, rotation and strain.
//!
//! With Θ, the ply's rotation Y = ε λ sin θ/ρ per unstretched strand length and λ = 1 + e:
//! E = ½α e² + ½(Y sin Θ − κ₀)² + ½γ(φ̄a + Y cos Θ − u₀)² − (f/n) λ cos Θ − (m/n) Y + the core's share,
//! ½ a (λ cos Θ − Z₀)² + ½ g (Y − Y₀)², where a = α_c/(n Z₀), g = γ_c/(n Z₀) and Z₀ = cos θ₀.
//! All is written for the right hand; [`Potential::in_hand`] makes the mirror image of the rest.

use super::ply::ExtensiblePly;
use crate::Handedness;
use crate::mechanics::{Load, Twist};
use crate::numerics::dual::Dual;
use crate::numerics::quadratic::{Matrix3, Vector3};

/// What the energy depends on besides shape, per strand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Potential {
    /// α; infinite without stretch
    pub(super) axial: f64,
    /// κ₀
    pub(super) curvature: f64,
    /// γ(u₃ − u₀) = `love`·Y cos Θ + `held`
    pub(super) love: f64,
    pub(super) held: f64,
    /// f/n and m/n
    pub(super) force: f64,
    pub(super) moment: f64,
    /// a, Z₀; g, Y₀
    core_axial: f64,
    core_length: f64,
    core_torsion: f64,
    core_rotation: f64,
}

/// A place: sin θ, cos θ, Y and e, for the right hand.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) sin: f64,
    pub(super) cos: f64,
    pub(super) rotation: f64,
    pub(super) strain: f64,
}

/// First and second derivatives by Θ, Y, e. Without stretch those by e are 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slopes {
    pub(super) by: Vector3,
    pub(super) bends: Matrix3,
    /// the size of the terms of ∂E/∂Y, of which rounding leaves a share where they cancel
    pub(super) rotation_size: f64,
}

impl Potential {
    pub(super) fn new(ply: &ExtensiblePly, hand: Handedness, twist: Twist, load: Load) -> Self {
        let eps = hand.sign();
        let n = f64::from(ply.strands());
        let gamma = ply.strand().stiffness_ratio();
        let (love, held) = twist.weights(gamma);
        let (curvature, natural) = ply.formed().map_or((0.0, 0.0), |lay| (lay.curvature(), lay.twist()));
        let (core_axial, core_torsion, core_length, core_rotation) = match (ply.core(), ply.formed()) {
            (Some(core), Some(lay)) => {
                let z = lay.angle.cos();
                (core.axial_stiffness() / (n * z), core.torsional_stiffness() / (n * z), z, lay.rotation())
            }
            _ => (0.0, 0.0, 1.0, 0.0),
        };
        Self {
            axial: ply.strand().axial_stiffness(),
            curvature,
            love,
            held: eps * (held - gamma * natural),
            force: load.force / n,
            moment: eps * load.moment / n,
            core_axial,
            core_length,
            core_torsion,
            core_rotation: eps * core_rotation,
        }
    }

    pub(super) fn stretches(&self) -> bool {
        self.axial < f64::INFINITY
    }

    /// γ(u₃ − u₀).
    fn torque(&self, at: &Spot) -> f64 {
        self.love * at.rotation * at.cos + self.held
    }

    /// The core's tension, per strand.
    fn core_force(&self, at: &Spot) -> f64 {
        self.core_axial * ((1.0 + at.strain) * at.cos - self.core_length)
    }

    pub(super) fn at(&self, at: &Spot) -> Slopes {
        let Spot { sin: s, cos: c, rotation: y, strain: e } = *at;
        let lambda = 1.0 + e;
        let bent = y * s - self.curvature;
        let torque = self.torque(at);
        let pull = self.force - self.core_force(at);
        let turned = self.core_torsion * (y - self.core_rotation);
        let by_angle = bent * y * c - torque * y * s + pull * lambda * s;
        let by_rotation = bent * s + torque * c - self.moment + turned;
        let rotation_size = (bent * s).abs() + (torque * c).abs() + self.moment.abs() + turned.abs();
        let a = self.core_axial;
        let angle_angle = y * c * y * c - bent * y * s - torque * y * c
            + self.love * y * s * y * s
            + pull * lambda * c
            + a * lambda * s * lambda * s;
        let angle_rotation = s * y * c + bent * c - self.love * c * y * s - torque * s;
        let rotation_rotation = s * s + self.love * c * c + self.core_torsion;
        let (by_strain, angle_strain, strain_strain) = if self.stretches() {
            (self.axial * e - pull * c, pull * s - a * c * lambda * s, self.axial + a * c * c)
        } else {
            (0.0, 0.0, 0.0)
        };
        Slopes {
            by: [by_angle, by_rotation, by_strain],
            bends: [
                [angle_angle, angle_rotation, angle_strain],
                [angle_rotation, rotation_rotation, 0.0],
                [angle_strain, 0.0, strain_strain],
            ],
            rotation_size,
        }
    }

    /// Energies per strand and unstretched strand length: stretch, bending, torsion, the core's share, the loads' (56). Where a strand
    /// twist is held, `love` is 0 and torsion is that of the twist itself.
    pub(super) fn parts(&self, at: &Spot, gamma: f64) -> [f64; 5] {
        let Spot { sin: s, cos: c, rotation: y, strain: e } = *at;
        let bent = y * s - self.curvature;
        let torque = self.torque(at);
        let z = (1.0 + e) * c;
        let (dz, dy) = (z - self.core_length, y - self.core_rotation);
        [
            if self.stretches() { 0.5 * self.axial * e * e } else { 0.0 },
            0.5 * bent * bent,
            0.5 * torque * torque / gamma,
            0.5 * self.core_axial * dz * dz + 0.5 * self.core_torsion * dy * dy,
            -self.force * z - self.moment * y,
        ]
    }

    /// The strain of a free strand at an angle, where ∂E/∂e = 0; 0 without stretch.
    pub(super) fn free_strain(&self, c: f64) -> f64 {
        self.free_strain_of(Dual::new(c, 0.0)).value
    }

    /// The same with its slope.
    pub(super) fn free_strain_of(&self, c: Dual) -> Dual {
        if !self.stretches() {
            return Dual::new(0.0, 0.0);
        }
        let pull = Dual::new(self.force + self.core_axial * self.core_length, 0.0) - self.core_axial * c;
        pull * c * (Dual::new(self.axial, 0.0) + self.core_axial * (c * c)).recip()
    }

    /// The core's tension, per strand, at λ cos θ.
    pub(super) fn core_pull(&self, extension: Dual) -> Dual {
        self.core_axial * (extension - Dual::new(self.core_length, 0.0))
    }

    /// The core's torque, per strand, at Y.
    pub(super) fn core_moment(&self, rotation: Dual) -> Dual {
        self.core_torsion * (rotation - Dual::new(self.core_rotation, 0.0))
    }

    /// Numerator and denominator of the rotation of a free strand at an angle, where ∂E/∂Y = 0.
    pub(super) fn free_rotation_of(&self, s: Dual, c: Dual) -> (Dual, Dual) {
        let dead = Dual::new(self.moment + self.core_torsion * self.core_rotation, 0.0);
        let pulled = dead + self.curvature * s - self.held * c;
        (pulled, s * s + self.love * (c * c) + Dual::new(self.core_torsion, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::HelicalAngle;
    use crate::mechanics::{FormedLay, StretchingStrand, WorkingCore};

    /// The energy typed again, and its differences, for a preformed strand on a working core.
    #[test]
    fn slopes_are_those_of_the_energy() {
        let angle = HelicalAngle::new(0.4).expect("an angle");
        let lay = FormedLay { handedness: Handedness::Right, angle, radius_ratio: 2.3, preforming: 0.6 };
        let strand = StretchingStrand::new(0.7, 3.0, 0.3).expect("a strand");
        let core = WorkingCore::new(1.2, 5.0, 1.7, 0.2).expect("a core");
        let ply = ExtensiblePly::new(6, strand).and_then(|p| p.with_core(core)).and_then(|p| p.formed_in(lay));
        let ply = ply.expect("a ply");
        let load = Load { force: 0.8, moment: -0.5 };
        let potential = Potential::new(&ply, Handedness::Right, Twist::Pretwist(0.2), load);
        let energy = |t: f64, y: f64, e: f64| {
            let (s, c, z0) = (libm::sin(t), libm::cos(t), libm::cos(0.4));
            let (k0, u0) = (0.6 * libm::sin(0.4) * libm::sin(0.4) / 2.3, 0.6 * libm::sin(0.4) * z0 / 2.3);
            let zeta = (1.0 + e) * c / z0;
            let omega = (y - libm::sin(0.4) / 2.3) / z0;
            let core = z0 / 6.0 * (0.5 * 5.0 * (zeta - 1.0) * (zeta - 1.0) + 0.5 * 1.7 * omega * omega);
            let twist = 0.2 + y * c - u0;
            let bent = y * s - k0;
            1.5 * e * e + 0.5 * bent * bent + 0.35 * twist * twist + core - 0.8 / 6.0 * (1.0 + e) * c + 0.5 / 6.0 * y
        };
        let at = |z: Vector3| {
            potential.at(&Spot { sin: libm::sin(z[0]), cos: libm::cos(z[0]), rotation: z[1], strain: z[2] })
        };
        let here = [0.5, 0.27, 0.01];
        let h = 1e-5;
        let moved = |i: usize, by: f64| {
            let mut z = here;
            z[i] += by;
            z
        };
        let parts: f64 = potential
            .parts(&Spot { sin: libm::sin(0.5), cos: libm::cos(0.5), rotation: 0.27, strain: 0.01 }, 0.7)
            .iter()
            .sum();
        assert!((parts - energy(0.5, 0.27, 0.01)).abs() < 1e-15);
        for i in 0..3 {
            let [[t, y, e], [u, x, d]] = [moved(i, h), moved(i, -h)];
            let slope = (energy(t, y, e) - energy(u, x, d)) / (2.0 * h);
            assert!((at(here).by[i] - slope).abs() < 1e-9, "{i}");
            for j in 0..3 {
                let bend = (at(moved(i, h)).by[j] - at(moved(i, -h)).by[j]) / (2.0 * h);
                assert!((at(here).bends[i][j] - bend).abs() < 1e-9, "{i} {j}");
            }
        }
    }
}
