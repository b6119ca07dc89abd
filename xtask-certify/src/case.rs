//! One ply and its data.

use nply::Handedness;
use nply::mechanics::{Balance, Load, Twist};

use crate::interval::Interval;
use crate::sheet::TERMS;

/// What a question to the solver is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    pub strands: u32,
    pub balance: Balance,
    pub stiffness_ratio: f64,
    pub twist: Twist,
    pub load: Load,
}

impl Case {
    /// The weights of the balance's terms for right-handed plies; those of number 2 and 4 change their sign for left-handed ones.
    #[must_use]
    pub fn weights(&self) -> [f64; TERMS] {
        let (love, twist) = match self.twist {
            Twist::Pretwist(twist) => (self.stiffness_ratio, twist),
            Twist::StrandTwist(twist) => (0.0, twist),
        };
        [1.0, love, self.stiffness_ratio * twist, self.load.force, self.load.moment]
    }

    /// The same without rounding.
    #[must_use]
    pub fn exact_weights(&self, hand: Handedness) -> [Interval; TERMS] {
        let (Twist::Pretwist(twist) | Twist::StrandTwist(twist)) = self.twist;
        let [bending, love, _, force, moment] = self.weights().map(Interval::point);
        let product = self.stiffness_ratio * twist;
        // no rounding where there was none
        let exact = is_product(self.stiffness_ratio, twist, product);
        let held = if exact {
            Interval::point(product)
        } else {
            Interval::point(self.stiffness_ratio) * Interval::point(twist)
        };
        let signed = |weight: Interval| if hand == Handedness::Right { weight } else { -weight };
        [bending, love, signed(held), force, signed(moment)]
    }

    /// Whether the moment is exactly that which holds straight strands: m = n γφ̄a.
    #[must_use]
    pub fn is_held(&self) -> bool {
        let (Twist::Pretwist(twist) | Twist::StrandTwist(twist)) = self.twist;
        let product = self.stiffness_ratio * twist;
        product != 0.0
            && is_product(self.stiffness_ratio, twist, product)
            && is_product(f64::from(self.strands), product, self.load.moment)
    }
}

/// Whether a·b is exactly `product`.
#[allow(clippy::float_cmp, clippy::disallowed_methods)] // that is the question, and the fused product answers it
fn is_product(a: f64, b: f64, product: f64) -> bool {
    a * b == product && (a.mul_add(b, -product) == 0.0) && (product == 0.0 || product.abs() > 1e-250)
}
