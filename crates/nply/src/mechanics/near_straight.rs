//! The balance next to straight strands, in terms that do not cancel there.
//!
//! Straight strands hold under m = nγφ̄a, and are about to lean where f ρ₀² = −nγ, ρ₀ = 1/sin(π/n): twist and moment, love and
//! force are then the same to first order, and what is left of them is the balance. So each pair is taken together:
//!
//! ```text
//! held·T₂ + m·T₄ = held·(T₂ + n T₄) + (m − n held)·T₄          T₂ + n T₄  goes as sin²θ
//! love·T₁ + f·T₃ = love·(T₁ − n s) + f·(T₃ − ρ₀² s) + (n love + f ρ₀²)·s     both brackets as sin³θ
//! ```
//!
//! T₁ … T₄ being the balance's terms (see [`Balance`]), s = sin θ, and love, held the weights γ, γφ̄a or 0, γ r u₃.

use super::atlas::{Atlas, BORDERS, Condition, Solution};
use super::balance::Balance;
use crate::Handedness;
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};

/// The charted branch of a balance: the panel next to straight strands in these terms, all others as they are.
#[derive(Clone, Debug)]
pub(crate) struct ChartedBalance {
    straight: NearStraight,
    beginning: Panel<6>,
    beyond: Atlas<Balance, 5>,
}

impl ChartedBalance {
    pub(crate) fn new(strands: u32, balance: Balance) -> Self {
        let straight = NearStraight { strands, balance };
        let beginning = Panel::fit(&straight, BORDERS[0], BORDERS[1]);
        Self { straight, beginning, beyond: Atlas::new(strands, balance) }
    }

    /// Hands every state in (0, π/2) of either hand to `found`, none missed and none twice (see
    /// [`crate::numerics::isolate`]), for the balance's weights.
    #[inline]
    pub(crate) fn solve(&self, weights: Pair<5>, mut found: impl FnMut(Handedness, Solution)) {
        let weights = weights.tamed();
        let border = self.beyond.at_start(1, &weights);
        let near = self.straight.weights(&weights);
        self.beginning.roots_up_to(&self.straight, &near, Some(border), &mut |side, root| {
            let angle = HelicalAngle::steep(root.at);
            found(Handedness::of_sign(side), Solution { angle, double: root.double });
        });
        self.beyond.solve_from(1, &weights, found);
    }
}

/// The terms next to straight strands: bending, love and force less their first order, twist with the moment that holds it, then the
/// first order of love and force and the moment itself, for the weights (1, love, held, f, n love + f ρ₀², m − n held).
#[derive(Clone, Copy, Debug)]
struct NearStraight {
    strands: u32,
    balance: Balance,
}

impl NearStraight {
    /// From the weights of the balance's own terms, (1, love, held, f, m).
    ///
    /// A moment within rounding of the one that holds straight strands is that one, as in
    /// [`Ply::straight_holds`](super::Ply::straight_holds).
    #[inline]
    fn weights(self, Pair { even, odd }: &Pair<5>) -> Pair<6> {
        let [bending, love, _, force, _] = *even;
        let [_, _, held, _, moment] = *odd;
        let n = f64::from(self.strands);
        let holds = n * held;
        let more = libm::fma(-n, held, moment);
        let more = if more.abs() <= 4.0 * f64::EPSILON * holds.abs() { 0.0 } else { more };
        let lean = libm::fma(n, love, force * Contact::straight_radius_ratio_squared(self.strands));
        Pair { even: [bending, love, 0.0, force, lean, 0.0], odd: [0.0, 0.0, held, 0.0, 0.0, more] }
    }
}

impl Basis<6> for NearStraight {
    fn at(&self, t: f64) -> [Dual; 6] {
        let contact = Contact::at(self.strands, HelicalAngle::steep(t));
        let [bending, .., moment] = self.balance.terms(&contact);
        let at = contact.regular();
        let n = f64::from(self.strands);
        let (s, c, one) = (at.sin, at.cos, Dual::new(1.0, 0.0));
        let (ss, cc) = (s * s, c * c);
        let share = match self.balance {
            Balance::Contact => at.share,
            Balance::Radial => Dual::new(0.0, 0.0),
        };
        let part = (one + c).recip();
        // 1 − c³ cos 2θ with q, over sin²θ
        let love = (one + c + cc) * part + cc * c * (Dual::new(2.0, 0.0) + share);
        let held = (cc - ss * share) * part + c;
        let straight = Contact::straight_radius_ratio_squared(self.strands);
        [
            bending,
            -(n * (ss * s * love)),
            -(n * (at.radius * ss * held)),
            straight * (ss * s * contact.spread()),
            s,
            moment,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(t: f64, power: usize) -> f64 {
        [t, t, t][..power].iter().product()
    }

    const STRANDS: [u32; 10] = [2, 3, 4, 5, 6, 7, 12, 13, 40, 1000];

    /// The same balance as that of the plain terms, with the same slope.
    #[test]
    fn the_balance_is_the_same() {
        let weights = Pair { even: [1.0, 0.7, 0.0, -0.4, 0.0], odd: [0.0, 0.0, 0.3, 0.0, -0.9] };
        for (balance, strands) in Balance::BOTH.into_iter().flat_map(|balance| STRANDS.map(|n| (balance, n))) {
            let straight = NearStraight { strands, balance };
            let near = straight.weights(&weights);
            for t in [1e-9, 1e-4, 0.01, 0.1, BORDERS[1]] {
                let terms = balance.terms(&Contact::at(strands, HelicalAngle::steep(t)));
                let plain: Vec<Dual> = (0..5).map(|k| (weights.even[k] + weights.odd[k]) * terms[k]).collect();
                let together: Vec<Dual> =
                    straight.at(t).iter().enumerate().map(|(k, term)| (near.even[k] + near.odd[k]) * *term).collect();
                let sum = |terms: &[Dual], part: fn(&Dual) -> f64| terms.iter().map(part).sum::<f64>();
                let off = |part: fn(&Dual) -> f64| (sum(&together, part) - sum(&plain, part)).abs();
                let size: f64 = plain.iter().map(|term| term.value.abs()).sum();
                let steepness: f64 = plain.iter().map(|term| term.slope.abs()).sum();
                let (value, slope) = (off(|term| term.value), off(|term| term.slope));
                assert!(value < 2e-15 * size, "{balance:?} n {strands} at {t}: {value:e} of {size:e}");
                assert!(
                    slope < 1e-14 * (steepness + size),
                    "{balance:?} n {strands} at {t}: {slope:e} of {steepness:e}"
                );
            }
        }
    }

    /// A moment is that which holds straight strands where the two differ by their own rounding and no more, however small both are.
    #[test]
    fn a_small_moment_is_told_from_the_one_that_holds() {
        for (strands, held) in [(2, 1e-9), (3, 0.3), (1000, 1e-200), (7, -1e6)] {
            let straight = NearStraight { strands, balance: Balance::Contact };
            let holds = f64::from(strands) * held;
            let left = |moment: f64| {
                straight.weights(&Pair { even: [1.0, 0.7, 0.0, 0.0, 0.0], odd: [0.0, 0.0, held, 0.0, moment] }).odd[5]
            };
            assert!(left(holds * (1.0 + f64::EPSILON)).abs() <= 0.0);
            assert!((left(holds * (1.0 + 1e-10)) / (holds * 1e-10) - 1.0).abs() < 1e-4);
        }
    }

    /// What is left when the first orders are taken together keeps its digits: over its power of θ it goes to a limit, with a remainder of order θ².
    #[test]
    fn nothing_cancels_next_to_straight_strands() {
        for (balance, strands) in Balance::BOTH.into_iter().flat_map(|balance| STRANDS.map(|n| (balance, n))) {
            let straight = NearStraight { strands, balance };
            for (k, power) in [3, 3, 2, 3, 1, 0].into_iter().enumerate() {
                let over = |t: f64| straight.at(t)[k].value / product(t, power);
                let limit = over(1e-5);
                for t in [1e-30, 1e-12, 1e-7] {
                    assert!((over(t) / limit - 1.0).abs() < 1e-8, "{balance:?} n {strands}: term {k} at {t}");
                    let slope = t * straight.at(t)[k].slope / product(t, power);
                    assert!(power == 0 || (slope / (power as f64 * limit) - 1.0).abs() < 1e-8, "slope of {k} at {t}");
                }
            }
        }
    }
}
