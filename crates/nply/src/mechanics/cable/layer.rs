//! One layer of a cable: equal rods laid side by side on what is below.

use super::rod::Rod;
use crate::Handedness;
use crate::geometry::{HelicalAngle, WireLay};

/// Rods of one layer and how they are laid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// How many; 2 or more.
    pub strands: u32,
    /// Each of them.
    pub rod: Rod,
    /// Which way they wind.
    pub handedness: Handedness,
    /// Lay length, ratio or angle.
    pub lay: WireLay,
    /// How far they were bent and twisted to this lay beforehand: 0 straight, 1 stress-free in the lay.
    pub preforming: f64,
    /// Twist put into each rod before it was laid and held at its ends, rad per rod length, right-handed positive.
    pub pretwist: f64,
}

/// What carries a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LayerSupport {
    /// It lies on what is below, with gaps between its rods.
    Below,
    /// Its rods touch each other; what is below is loose.
    Neighbours,
    /// It lies on what is below and on its neighbours, both of which push: under a range of loads, at one strain for each turning.
    Both,
}

impl LayerSupport {
    /// The name used in JSON: `below`, `neighbours` or `both`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Below => "below",
            Self::Neighbours => "neighbours",
            Self::Both => "both",
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

impl Laid {
    /// Turns of the cable (rad) per rod length.
    pub(super) fn rotation(&self) -> f64 {
        self.angle.sin() / self.radius
    }

    /// κ₀ and u₀ that the rods take by themselves, in the sense of the hand; what was put in as twist comes off u₀.
    pub(super) fn natural(&self) -> [f64; 2] {
        let y = self.layer.preforming * self.rotation();
        [y * self.angle.sin(), y * self.angle.cos() - self.layer.handedness.sign() * self.layer.pretwist]
    }
}
