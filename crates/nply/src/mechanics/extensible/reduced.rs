//! Along a closed contact, or along free helices: everything as a function of the angle, with the slope of the energy.

use super::obstacle;
use super::ply::ExtensiblePly;
use super::potential::{Potential, Slopes, Spot};
use super::state::{LEAST_STRAIN, MOST_STRAIN};
use crate::geometry::HelicalAngle;
use crate::mechanics::Support;
use crate::numerics::dual::Dual;
use crate::numerics::jet2::Jet2;

/// Grips of the right hand: a held displacement, or nothing where the load is given.
#[derive(Clone, Copy, Debug)]
pub(super) struct Held {
    /// λ cos θ
    pub(super) extension: Option<f64>,
    /// Y > 0
    pub(super) rotation: Option<f64>,
}

/// A ply in one hand under given loads, a load that is found being 0.
#[derive(Clone, Copy)]
pub(super) struct Reduced<'p> {
    pub(super) ply: &'p ExtensiblePly,
    pub(super) potential: Potential,
    pub(super) held: Held,
    pub(super) support: Support,
}

/// At one angle: rotation, strain, and what must vanish.
pub(super) struct Here {
    pub(super) rotation: f64,
    pub(super) strain: f64,
    pub(super) residual: Dual,
}

/// The energy on a surface Y = b(θ, e): its slopes and bends by θ and e.
pub(super) struct OnSurface {
    pub(super) by_angle: f64,
    pub(super) by_strain: f64,
    pub(super) angle_angle: f64,
    pub(super) angle_strain: f64,
    pub(super) strain_strain: f64,
}

impl OnSurface {
    pub(super) fn of(at: &Slopes, b: &Jet2) -> Self {
        let [ea, ey, ee] = at.by;
        let [[aa, ay, ae], [_, yy, ye], [_, _, ss]] = at.bends;
        Self {
            by_angle: ea + ey * b.a,
            by_strain: ee + ey * b.b,
            angle_angle: aa + 2.0 * ay * b.a + yy * b.a * b.a + ey * b.aa,
            angle_strain: ae + ay * b.b + ye * b.a + yy * b.a * b.b + ey * b.ab,
            strain_strain: ss + 2.0 * ye * b.b + yy * b.b * b.b + ey * b.bb,
        }
    }
}

/// A curve e(θ): value, slope, bend.
#[derive(Clone, Copy)]
struct Strain {
    value: f64,
    slope: f64,
    bend: f64,
}

impl Reduced<'_> {
    pub(super) fn bound(&self, angle: HelicalAngle, strain: f64) -> Jet2 {
        match self.support {
            Support::Core => obstacle::core(self.ply, angle, strain),
            _ => obstacle::neighbours(self.ply, angle, strain),
        }
    }

    pub(super) fn spot(angle: HelicalAngle, rotation: f64, strain: f64) -> Spot {
        Spot { sin: angle.sin(), cos: angle.cos(), rotation, strain }
    }

    /// The slopes on the contact.
    pub(super) fn on_surface(&self, angle: HelicalAngle, strain: f64) -> (Jet2, OnSurface) {
        let b = self.bound(angle, strain);
        let at = self.potential.at(&Self::spot(angle, b.value, strain));
        (b, OnSurface::of(&at, &b))
    }

    /// The strain at which the energy on the contact is stationary at an angle; `None` where that is not within what is looked at.
    pub(super) fn strain_on_surface(&self, angle: HelicalAngle) -> Option<f64> {
        if !self.potential.stretches() {
            return Some(0.0);
        }
        let slope = |e: f64| {
            let on = self.on_surface(angle, e).1;
            (on.by_strain, on.strain_strain)
        };
        let (mut low, mut high) = (LEAST_STRAIN, MOST_STRAIN);
        if !(slope(low).0 <= 0.0 && slope(high).0 >= 0.0) {
            return None;
        }
        let mut e = self.potential.free_strain(angle.cos()).clamp(low, high);
        for _ in 0..80 {
            let (value, bend) = slope(e);
            if value > 0.0 {
                high = e;
            } else {
                low = e;
            }
            let newton = e - value / bend;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - e).abs() <= 2.0 * f64::EPSILON * e.abs().max(1e-300) || next <= low && next >= high {
                return Some(next);
            }
            e = next;
        }
        Some(e)
    }

    /// e at which a length that is held has this angle.
    fn strain_at_length(extension: f64, angle: HelicalAngle) -> Strain {
        let lambda = extension / angle.cos();
        let t = angle.tan();
        Strain { value: lambda - 1.0, slope: lambda * t, bend: lambda * (2.0 * t * t + 1.0) }
    }

    /// e at which the contact at this angle has a rotation that is held: linear in e on neighbours and core alike.
    fn strain_at_rotation(&self, rotation: f64, angle: HelicalAngle) -> Strain {
        // λ A(θ, e) = Y D(θ, e) with A, D linear in e; one step of Newton from any e is exact
        let from = self.bound(angle, 0.0);
        let (b0, b1) = (from.value, self.bound(angle, 1.0).value);
        // b(e) = b₀ (1 + e)/(1 + k e), from two values
        let k = 2.0 * b0 / b1 - 1.0;
        let value = (rotation / b0 - 1.0) / (1.0 - k * rotation / b0);
        let b = self.bound(angle, value);
        let slope = -b.a / b.b;
        Strain { value, slope, bend: -(b.aa + 2.0 * b.ab * slope + b.bb * slope * slope) / b.b }
    }

    /// On the contact at an angle.
    pub(super) fn on_contact(&self, angle: HelicalAngle) -> Option<Here> {
        let along = |e: Strain| {
            let (b, on) = self.on_surface(angle, e.value);
            let value = on.by_angle + on.by_strain * e.slope;
            let slope = on.angle_angle
                + 2.0 * on.angle_strain * e.slope
                + on.strain_strain * e.slope * e.slope
                + on.by_strain * e.bend;
            Here { rotation: b.value, strain: e.value, residual: Dual::new(value, slope) }
        };
        Some(match (self.held.extension, self.held.rotation) {
            (None, None) => {
                let strain = self.strain_on_surface(angle)?;
                let (b, on) = self.on_surface(angle, strain);
                let given = if self.potential.stretches() { on.angle_strain / on.strain_strain } else { 0.0 };
                let slope = on.angle_angle - on.angle_strain * given;
                Here { rotation: b.value, strain, residual: Dual::new(on.by_angle, slope) }
            }
            (Some(extension), None) => along(Self::strain_at_length(extension, angle)),
            // Y is constant along the curve, so that its slope there counts for nothing
            (None, Some(rotation)) => along(self.strain_at_rotation(rotation, angle)),
            (Some(extension), Some(rotation)) => {
                let e = Self::strain_at_length(extension, angle);
                let b = self.bound(angle, e.value);
                Here { rotation, strain: e.value, residual: Dual::new(b.value - rotation, b.a + b.b * e.slope) }
            }
        })
    }

    /// A free helix at an angle. Where Y is found the residual is multiplied by the square of what Y is divided by.
    pub(super) fn free(&self, angle: HelicalAngle) -> Here {
        let Potential { curvature, love, held, force, .. } = self.potential;
        let (s, c) = (Dual::new(angle.sin(), angle.cos()), Dual::new(angle.cos(), -angle.sin()));
        let one = Dual::new(1.0, 0.0);
        let e = match self.held.extension {
            Some(extension) => {
                let e = Self::strain_at_length(extension, angle);
                Dual::new(e.value, e.slope)
            }
            None => self.potential.free_strain_of(c),
        };
        let lambda = one + e;
        // what pulls at a strand; with the length held the force does no work
        let force = if self.held.extension.is_some() { 0.0 } else { force };
        let pull = Dual::new(force, 0.0) - self.potential.core_pull(lambda * c);
        let (y, weight) = match self.held.rotation {
            Some(rotation) => (Dual::new(rotation, 0.0), one),
            None => self.potential.free_rotation_of(s, c),
        };
        // y = N/w; ∂E/∂θ times w²: κ̃ Y c − T Y s + P λ s
        let bent = y * s - curvature * weight;
        let torque = love * (y * c) + held * weight;
        let square = weight * weight;
        let mut residual = bent * y * c - torque * y * s + square * pull * lambda * s;
        if let Some(extension) = self.held.extension {
            // ∂E/∂e = αe − P c along e′ = λ tan θ
            let slope = extension * s * (c * c).recip();
            let axial = if self.potential.stretches() { self.potential.axial } else { 0.0 };
            residual = residual + square * (axial * e - pull * c) * slope;
        }
        Here { rotation: y.value / weight.value, strain: e.value, residual }
    }
}
