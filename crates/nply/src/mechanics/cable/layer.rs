//! One layer of a cable: equal rods laid side by side on what is below.

use super::rod::Rod;
use crate::geometry::{Contact, HelicalAngle, check_strands};
use crate::{DomainError, Handedness};

/// Rods of one layer and how they are laid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// How many; 2 or more.
    pub strands: u32,
    /// Each of them.
    pub rod: Rod,
    /// Which way they wind.
    pub handedness: Handedness,
    /// Cable length per turn.
    pub lay_length: f64,
    /// How far they were bent and twisted to this lay beforehand: 0 straight, 1 stress-free in the lay.
    pub preforming: f64,
}

/// What carries a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LayerSupport {
    /// It lies on what is below, with gaps between its rods.
    Below,
    /// Its rods touch each other; what is below is loose.
    Neighbours,
}

impl LayerSupport {
    /// The name used in JSON: `below` or `neighbours`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Below => "below",
            Self::Neighbours => "neighbours",
        }
    }
}

/// A layer as it was laid: free of strain in its length and turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Laid {
    pub(super) layer: Layer,
    pub(super) angle: HelicalAngle,
    pub(super) radius: f64,
}

impl Layer {
    /// On what is below, or on its neighbours where it would overlap them: never inside.
    pub(super) fn laid_on(self, below: f64) -> Result<Laid, DomainError> {
        check_strands(self.strands)?;
        DomainError::check((0.0..=1.0).contains(&self.preforming), "preforming", self.preforming, "between 0 and 1")?;
        let r = self.rod.radius();
        let touching = Contact::from_lay_length(self.strands, self.lay_length / r)?;
        let on = below + r;
        if touching.radius_ratio() * r >= on {
            return Ok(Laid { layer: self, angle: touching.angle(), radius: touching.radius_ratio() * r });
        }
        let tan = core::f64::consts::TAU * on / self.lay_length;
        let angle = if tan < 1.0 {
            HelicalAngle::new(libm::atan(tan))?
        } else {
            HelicalAngle::from_pitch_angle(libm::atan(1.0 / tan))?
        };
        Ok(Laid { layer: self, angle, radius: on })
    }
}

impl Laid {
    /// Turns of the cable (rad) per rod length.
    pub(super) fn rotation(&self) -> f64 {
        self.angle.sin() / self.radius
    }

    /// κ₀ and u₀ that the rods take by themselves, in the sense of the hand.
    pub(super) fn natural(&self) -> [f64; 2] {
        let y = self.layer.preforming * self.rotation();
        [y * self.angle.sin(), y * self.angle.cos()]
    }
}
