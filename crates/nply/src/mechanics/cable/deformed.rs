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

/// By how much the cable's length and turns differ from those as laid, over these: nothing is lost of a small difference.
struct Displaced {
    length: Jet2,
    turns: Jet2,
}

/// Shape and energy of a rod at a radius.
struct At {
    /// λ − 1
    strain: Jet2,
    sin: Jet2,
    cos: Jet2,
    thick: Jet2,
    turn: Jet2,
}

impl Laid {
    fn displaced(&self, strain: f64, turning: f64) -> Displaced {
        let by_turning = self.layer.handedness.sign() * self.angle.cos() / self.rotation();
        Displaced {
            length: Jet2::of_a(Jet::new(strain, 1.0, 0.0)),
            turns: Jet2::of_b(Jet::new(by_turning * turning, by_turning, 0.0)),
        }
    }

    /// The rod on a helix of that radius. All differences are taken from the lay as made, in which they are 0 to the last digit: λ² − 1 is
    /// cos²θ₀ [(1 + e)² − 1] + sin²θ₀ [(1 + w)² − 1], with the way around 1 + w = (R/R₀)(1 + turns).
    fn at(&self, displaced: &Displaced, radius: Jet2) -> At {
        let (s0, c0) = (self.angle.sin(), self.angle.cos());
        let one = Jet2::constant(1.0);
        let over = |x: Jet2| 2.0 * x + x * x;
        let wider = (1.0 / self.radius) * (radius - Jet2::constant(self.radius));
        let around = wider + displaced.turns + wider * displaced.turns;
        let excess = (c0 * c0) * over(displaced.length) + (s0 * s0) * over(around);
        let lambda = (one + excess).sqrt();
        let strain = excess * (one + lambda).recip();
        let inverse = lambda.recip();
        At {
            strain,
            sin: s0 * ((one + around) * inverse),
            cos: c0 * ((one + displaced.length) * inverse),
            thick: one - self.layer.rod.poissons_ratio() * strain,
            turn: self.rotation() * (one + displaced.turns),
        }
    }

    /// Energy per rod and unstretched rod length.
    fn energy(&self, at: &At) -> (Jet2, Jet2, Jet2, Jet2) {
        let [k0, u0] = self.natural();
        let rod = self.layer.rod;
        let eps = self.layer.handedness.sign();
        let strain = at.strain;
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
        let to = self.displaced(strain, turning);
        if !(to.length.value > -1.0 && to.turns.value > -1.0) {
            return None; // squeezed to nothing, or unlaid altogether
        }
        let r = self.layer.rod.radius();
        let none = Jet2::constant(0.0);
        let on_below = self.settle(&to, below, |at| r * at.thick)?;
        let on_neighbours = || self.settle(&to, none, |at| r * at.thick * self.touching(at));
        let (support, radius, meeting) = if both {
            (LayerSupport::Both, on_below, Some(on_neighbours()? - on_below))
        } else {
            let at = self.at(&to, on_below);
            let room = r * at.thick * self.touching(&at);
            if room.value > on_below.value {
                (LayerSupport::Neighbours, on_neighbours()?, None)
            } else {
                (LayerSupport::Below, on_below, None)
            }
        };
        let at = self.at(&to, radius);
        let (energy, extension, bent, twisted) = self.energy(&at);
        let angle = HelicalAngle::of_tangent(at.sin.value, at.cos.value);
        let free = self.over_radius(&to, radius.value);
        Some(Deformed {
            support,
            radius,
            outer: radius + r * at.thick,
            energy,
            angle,
            strain: extension.value,
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
    fn over_radius(&self, to: &Displaced, radius: f64) -> At {
        let here = Displaced { length: Jet2::constant(to.length.value), turns: Jet2::constant(to.turns.value) };
        self.at(&here, Jet2::of_a(Jet::new(radius, 1.0, 0.0)))
    }

    /// The radius that is the room it asks for beside what is below, with its derivatives.
    fn settle(&self, to: &Displaced, below: Jet2, room: impl Fn(&At) -> Jet2) -> Option<Jet2> {
        let step = |radius: Jet2| {
            let excess = radius - below - room(&self.at(to, radius));
            (excess, 1.0 - room(&self.over_radius(to, radius.value)).a)
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
            // the radius as laid stays what it is
            if excess.value.abs() <= 2.0 * f64::EPSILON * radius {
                break;
            }
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
        let mut curved = Jet2::constant(radius);
        for _ in 0..3 {
            let (excess, slope) = step(curved);
            curved = Jet2 { value: radius, ..curved - (1.0 / slope) * excess };
        }
        curved.aa.is_finite().then_some(curved)
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
        let to = self.displaced(strain, turning);
        let at = self.at(&to, Jet2::constant(deformed.radius.value));
        let thick = self.layer.rod.radius() * at.thick;
        let total = self.energy(&at).0 + below * thick + neighbours * (thick * self.touching(&at)) + above * thick;
        [total.a, total.b]
    }
}
