//! A layer under strain and turning of the whole cable: where it lies, what it stores, what it presses.

use super::layer::{Laid, LayerSupport};
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::jet::Jet;
use crate::numerics::jet2::Jet2;

/// Everything of one rod of a layer, over the cable's strain and turning.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deformed {
    pub(super) support: LayerSupport,
    pub(super) radius: Jet2,
    /// radius of the cylinder around the layer
    pub(super) outer: Jet2,
    /// energy per rod and unstretched rod length
    pub(super) energy: Jet2,
    pub(super) angle: HelicalAngle,
    pub(super) strain: f64,
    /// λκ − κ₀, and the twist against what the rod takes by itself
    pub(super) bending: f64,
    pub(super) torsion: f64,
    /// ∂E/∂R at given length and turns
    pub(super) by_radius: f64,
    /// by how much the layer's own radius leaves more room as it grows, on what is below and between neighbours: ∂(R − room)/∂R
    pub(super) give: [f64; 2],
    /// where both carry: the radius on neighbours less that on what is below, which is 0 there
    pub(super) meeting: Option<Jet2>,
    /// the same for the outside
    pub(super) outer_by_radius: f64,
    /// touching rods at this angle
    pub(super) touching: Contact,
}

/// Shape and energy of a rod at a radius.
struct At {
    lambda: Jet2,
    sin: Jet2,
    cos: Jet2,
    thick: Jet2,
    turn: Jet2,
}

impl Laid {
    /// Per unstretched rod length: cable length, and turns in the sense of the hand.
    fn displacements(&self, strain: f64, turning: f64) -> (Jet2, Jet2) {
        let c0 = self.angle.cos();
        let eps = self.layer.handedness.sign();
        let z = Jet2::of_a(Jet::new(c0 * (1.0 + strain), c0, 0.0));
        let y = Jet2::of_b(Jet::new(self.rotation() + eps * c0 * turning, eps * c0, 0.0));
        (z, y)
    }

    fn at(&self, z: Jet2, y: Jet2, radius: Jet2) -> At {
        let around = radius * y;
        let lambda = (z * z + around * around).sqrt();
        let inverse = lambda.recip();
        let thick = Jet2::constant(1.0) - self.layer.rod.poissons_ratio() * (lambda - Jet2::constant(1.0));
        At { lambda, sin: around * inverse, cos: z * inverse, thick, turn: y }
    }

    /// Energy per rod and unstretched rod length.
    fn energy(&self, at: &At) -> (Jet2, Jet2, Jet2, Jet2) {
        let [k0, u0] = self.natural();
        let rod = self.layer.rod;
        let eps = self.layer.handedness.sign();
        let strain = at.lambda - Jet2::constant(1.0);
        let bent = at.turn * at.sin - Jet2::constant(k0);
        let twisted = at.turn * at.cos - Jet2::constant(u0);
        let half = |stiffness: f64, x: Jet2| (0.5 * stiffness) * (x * x);
        let energy = half(rod.axial_stiffness(), strain)
            + half(rod.bending_stiffness(), bent)
            + half(rod.torsional_stiffness(), twisted)
            + (eps * rod.coupling()) * (strain * twisted);
        (energy, strain, bent, twisted)
    }

    /// ρ of touching rods as a function of the angle.
    fn touching(&self, at: &At) -> Jet2 {
        let angle = HelicalAngle::of_tangent(at.sin.value, at.cos.value);
        let contact = Contact::at(self.layer.strands, angle);
        let [s, c] = [angle.sin(), angle.cos()];
        let tan = at.sin * at.cos.recip();
        // θ = arctan, and ρ = (ρ cos θ)/cos θ
        let theta = tan.map(Jet::new(angle.radians(), c * c, -2.0 * s * c * c * c));
        let curved = contact.curved();
        theta.map(curved.radius * Jet::new(c, -s, -c).recip())
    }

    /// Where the layer lies on what is below (a radius), or on its neighbours where they would overlap there. With `both` it is taken to lie on
    /// both, with the derivatives of what lies on what is below.
    pub(super) fn deformed(&self, strain: f64, turning: f64, below: Jet2, both: bool) -> Option<Deformed> {
        let (z, y) = self.displacements(strain, turning);
        if !(z.value > 0.0 && y.value > 0.0) {
            return None; // unlaid altogether, or squeezed to nothing
        }
        let r = self.layer.rod.radius();
        let none = Jet2::constant(0.0);
        let on_below = self.settle(z, y, below, |at| r * at.thick)?;
        let on_neighbours = || self.settle(z, y, none, |at| r * at.thick * self.touching(at));
        let (support, radius, meeting) = if both {
            (LayerSupport::Both, on_below, Some(on_neighbours()? - on_below))
        } else {
            let at = self.at(z, y, on_below);
            let room = r * at.thick * self.touching(&at);
            if room.value > on_below.value {
                (LayerSupport::Neighbours, on_neighbours()?, None)
            } else {
                (LayerSupport::Below, on_below, None)
            }
        };
        let at = self.at(z, y, radius);
        let (energy, extension, bent, twisted) = self.energy(&at);
        let angle = HelicalAngle::of_tangent(at.sin.value, at.cos.value);
        let free = self.over_radius(z, y, radius.value);
        Some(Deformed {
            support,
            radius,
            outer: radius + r * at.thick,
            energy,
            angle,
            // what is but rounding of λ is no strain
            strain: if extension.value.abs() <= 4.0 * f64::EPSILON { 0.0 } else { extension.value },
            bending: bent.value,
            torsion: self.layer.handedness.sign() * twisted.value,
            by_radius: self.energy(&free).0.a,
            give: [1.0 - r * free.thick.a, 1.0 - (r * free.thick * self.touching(&free)).a],
            meeting,
            outer_by_radius: 1.0 + r * free.thick.a,
            touching: Contact::at(self.layer.strands, angle),
        })
    }

    /// At given length and turns, the radius being the variable.
    fn over_radius(&self, z: Jet2, y: Jet2, radius: f64) -> At {
        self.at(Jet2::constant(z.value), Jet2::constant(y.value), Jet2::of_a(Jet::new(radius, 1.0, 0.0)))
    }

    /// The radius that is the room it asks for beside what is below, with its derivatives.
    fn settle(&self, z: Jet2, y: Jet2, below: Jet2, room: impl Fn(&At) -> Jet2) -> Option<Jet2> {
        let step = |radius: Jet2| {
            let excess = radius - below - room(&self.at(z, y, radius));
            (excess, 1.0 - room(&self.over_radius(z, y, radius.value)).a)
        };
        let over = |radius: f64| step(Jet2::constant(radius));
        // too little room at next to no radius, more than enough far out: rods lie flat there
        let (mut low, mut high) = (0.0, 2.0 * self.radius);
        while over(high).0.value < 0.0 {
            (low, high) = (high, 2.0 * high);
            if high > 1e12 * self.radius {
                return None;
            }
        }
        let mut radius = self.radius;
        for _ in 0..200 {
            let (excess, slope) = over(radius);
            if excess.value > 0.0 {
                high = radius;
            } else {
                low = radius;
            }
            let newton = radius - excess.value / slope;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            let done = (next - radius).abs() <= 4.0 * f64::EPSILON * radius;
            radius = next;
            if done {
                break;
            }
        }
        // each turn of Newton's iteration gets one more order of the derivatives right
        let mut radius = Jet2::constant(radius);
        for _ in 0..3 {
            let (excess, slope) = step(radius);
            radius = radius - (1.0 / slope) * excess;
        }
        radius.aa.is_finite().then_some(radius)
    }

    /// What of the cable's force and moment is this layer's, per rod and unstretched rod length: the slopes of its energy, and of the room its
    /// contacts (with what is below and between neighbours, and with what is above) ask for, at given radius.
    pub(super) fn share(
        &self,
        deformed: &Deformed,
        strain: f64,
        turning: f64,
        [below, neighbours]: [f64; 2],
        above: f64,
    ) -> [f64; 2] {
        let (z, y) = self.displacements(strain, turning);
        let at = self.at(z, y, Jet2::constant(deformed.radius.value));
        let thick = self.layer.rod.radius() * at.thick;
        let total = self.energy(&at).0 + below * thick + neighbours * (thick * self.touching(&at)) + above * thick;
        [total.a, total.b]
    }
}
