//! Round wires that lie along each other: Hertz's line contact.

use core::f64::consts::PI;

use crate::geometry::Contact;

/// The surface of a wire whose centreline is curved.
#[derive(Clone, Copy, Debug)]
pub(super) struct WireSurface {
    pub(super) radius: f64,
    /// of the centreline
    pub(super) curvature: f64,
}

impl WireSurface {
    /// Sum of the principal curvatures where the surface faces so much (a cosine) to the inner side of the bend.
    ///
    /// Two surfaces that touch along a line differ there in curvature across the line alone, so that sums of both principal curvatures, added,
    /// are the curvature that Hertz's formula asks for.
    pub(super) fn facing(self, inward: f64) -> f64 {
        let bent = self.curvature * inward;
        1.0 / self.radius - bent / (1.0 - self.radius * bent)
    }
}

/// How much of the way from a strand to its touching neighbour points to the ply's axis, by (30).
pub(super) fn inward_to_neighbour(touching: &Contact) -> f64 {
    0.5 * touching.radius_ratio() * touching.one_minus_cos_beta()
}

/// p₀ = √(w E*/(π R*)), 1/E* = Σ (1 − ν²)/E, from the load per length of the line, the curvature 1/R* and E, ν of either body (Hertz; Johnson,
/// *Contact Mechanics*, section 4.2). `None` where nothing presses.
pub(super) fn hertz_pressure(line_load: f64, curvature: f64, bodies: [[f64; 2]; 2]) -> Option<f64> {
    let compliance: f64 = bodies.iter().map(|[modulus, nu]| (1.0 - nu * nu) / modulus).sum();
    (line_load > 0.0 && curvature > 0.0).then(|| libm::sqrt(line_load * curvature / (PI * compliance)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two equal steel rollers of radius 10 mm, 100 N/mm: p₀ = 0.418 √(wE/R) for ν = 0.3 and equal bodies on a plane's worth of curvature
    /// (the handbook form of the same formula, R the effective radius).
    #[test]
    fn it_is_the_handbooks_roller() {
        let (load, modulus) = (100.0, 206e3);
        let roller = WireSurface { radius: 10.0, curvature: 0.0 };
        let curvature = 2.0 * roller.facing(1.0);
        let pressure = hertz_pressure(load, curvature, [[modulus, 0.3]; 2]).expect("it presses");
        let handbook = 0.418 * libm::sqrt(load * modulus * curvature);
        assert!((pressure / handbook - 1.0).abs() < 1e-3, "{pressure} {handbook}");
        assert!(hertz_pressure(-1.0, curvature, [[modulus, 0.3]; 2]).is_none());
    }

    /// A ring lying inside a torus' bend: the surface of a bent wire is flatter towards the axis by just the curvature of that side.
    #[test]
    fn a_bent_wire_is_saddle_shaped_inside_and_rounder_outside() {
        let wire = WireSurface { radius: 1.0, curvature: 0.25 };
        assert!((wire.facing(1.0) - (1.0 - 1.0 / 3.0)).abs() < 1e-15); // the inner circle has radius 3
        assert!((wire.facing(-1.0) - (1.0 + 1.0 / 5.0)).abs() < 1e-15); // the outer one 5
    }
}
