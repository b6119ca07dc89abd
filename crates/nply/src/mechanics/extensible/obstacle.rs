//! What is in the way of the strands: each bounds the ply's rotation Y from above, as a function of angle and strain.

use super::ply::ExtensiblePly;
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::jet::Jet;
use crate::numerics::jet2::Jet2;

/// The radius of a strand at strain e, in units of r: 1 − νe.
pub(super) fn thickness(ply: &ExtensiblePly, strain: f64) -> f64 {
    1.0 - ply.strand().poissons_ratio() * strain
}

/// The strain as a variable.
fn strain_variable(strain: f64) -> Jet2 {
    Jet2::of_b(Jet::new(strain, 1.0, 0.0))
}

fn thickness_of(ply: &ExtensiblePly, strain: f64) -> Jet2 {
    let nu = ply.strand().poissons_ratio();
    Jet2::of_b(Jet::new(1.0 - nu * strain, -nu, 0.0))
}

/// Y of touching neighbours: λ/s · sin θ/ρ(θ), the ρ of touching strands growing with their radius s.
pub(super) fn neighbours(ply: &ExtensiblePly, angle: HelicalAngle, strain: f64) -> Jet2 {
    let touching = Jet2::of_a(Contact::at(ply.strands(), angle).curved().rotation());
    let lambda = Jet2::constant(1.0) + strain_variable(strain);
    lambda * thickness_of(ply, strain).recip() * touching
}

/// Radius of the core, over angle and strain: it thins as it stretches with the ply. NaN without a core.
pub(super) fn core_radius(ply: &ExtensiblePly, angle: HelicalAngle, strain: f64) -> Jet2 {
    let Some(core) = ply.core() else { return Jet2::constant(f64::NAN) };
    let nu = core.poissons_ratio();
    let z0 = ply.formed().map_or(1.0, |lay| lay.angle.cos());
    let cos = Jet2::of_a(Jet::new(angle.cos(), -angle.sin(), -angle.cos()));
    let stretched = (1.0 / z0) * ((Jet2::constant(1.0) + strain_variable(strain)) * cos);
    // a core whose unstrained lay is not known does not thin
    let nu = if ply.formed().is_some() { nu } else { 0.0 };
    core.radius() * (Jet2::constant(1.0 + nu) - nu * stretched)
}

/// Y of strands on the core: λ sin θ/(s + r_core). NaN without a core.
pub(super) fn core(ply: &ExtensiblePly, angle: HelicalAngle, strain: f64) -> Jet2 {
    let sin = Jet2::of_a(Jet::new(angle.sin(), angle.cos(), -angle.sin()));
    let lambda = Jet2::constant(1.0) + strain_variable(strain);
    let radius = thickness_of(ply, strain) + core_radius(ply, angle, strain);
    lambda * sin * radius.recip()
}

/// cos θ (s ρ(θ) − s − r_core), which vanishes where strands on the core touch their neighbours too, and stays finite at flat rings. NaN
/// without a core.
pub(super) fn seam(ply: &ExtensiblePly, angle: HelicalAngle, strain: f64) -> Jet2 {
    let curved = Contact::at(ply.strands(), angle).curved();
    let (radius, cos) = (Jet2::of_a(curved.radius), Jet2::of_a(curved.cos));
    let thick = thickness_of(ply, strain);
    thick * radius - cos * (thick + core_radius(ply, angle, strain))
}
