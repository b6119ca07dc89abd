//! How a state answers when anything it depends on is a little different: what a fit to measurements needs.

use super::atlas::Condition;
use super::{Equilibrium, Twist};

/// What the equation of equilibrium of touching strands holds together; any one of them follows from the other four.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Variable {
    /// θ, rad.
    HelicalAngle,
    /// γ = C/B.
    StiffnessRatio,
    /// φ̄a, or r u₃ where that is given.
    Twist,
    /// f.
    Force,
    /// m.
    Moment,
}

impl Variable {
    /// All five.
    pub const ALL: [Self; 5] = [Self::HelicalAngle, Self::StiffnessRatio, Self::Twist, Self::Force, Self::Moment];

    const fn place(self) -> usize {
        self as usize
    }
}

#[doc = include_str!("../equations/sensitivity.md")]
///
/// A state's [`balance_residual`](Equilibrium::balance_residual) is a function of five numbers. While it stays zero, any one of them
/// is a function of the other four, whose slopes these are; dimensionless (r = B = 1), external pressure and number of strands held.
///
/// ```
/// use nply::mechanics::{Load, Ply, Twist, Variable};
/// let state = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
/// let sensitivity = state.sensitivity();
/// // a strand that is stiffer in torsion lays the ply steeper: 8.2° per unit of C/B
/// let slope = sensitivity.slope(Variable::HelicalAngle, Variable::StiffnessRatio).expect("no fold");
/// let stiffer = Ply::new(3, 0.75 + 1e-6)?.equilibria(Twist::Pretwist(-1.0), Load::NONE)?[0];
/// let change = stiffer.contact().helical_angle() - state.contact().helical_angle();
/// assert!((change / 1e-6 - slope).abs() < 1e-5 && slope > 0.0);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// the slopes of cos²θ·G
    gradient: [f64; 5],
    /// what rounding may leave of each
    lost: [f64; 5],
    extension: f64,
    rotation: f64,
}

impl Sensitivity {
    /// ∂`of`/∂`by`, the other three held; 1 of a variable by itself.
    ///
    /// `None` where `of` is not a function of the rest: the angle at a [fold](Equilibrium::is_fold), the moment at the angle of the most
    /// turns (q = 1) in contact balance, the force of straight strands, the twist at the limiting angle of large pretwist.
    #[must_use]
    pub fn slope(&self, of: Variable, by: Variable) -> Option<f64> {
        let (of, by) = (of.place(), by.place());
        if of == by {
            return Some(1.0);
        }
        let slope = -self.gradient[by] / self.gradient[of];
        (self.gradient[of].abs() > self.lost[of] && slope.is_finite()).then_some(slope)
    }

    /// d(a·d_f)/dθ along the branch: what the ply's length per strand length loses per rad.
    #[must_use]
    pub const fn extension_per_angle(&self) -> f64 {
        self.extension
    }

    /// d(a·d_m)/dθ along the branch, with the ρ′ of the radius: what the end's rotation per strand length, times r, gains per rad.
    #[must_use]
    pub const fn rotation_per_angle(&self) -> f64 {
        self.rotation
    }
}

impl Equilibrium {
    /// How angle, stiffness ratio, twist, force and moment depend on each other at this state.
    #[must_use]
    pub fn sensitivity(&self) -> Sensitivity {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let eps = self.handedness.sign();
        let gamma = self.stiffness_ratio;
        let [_, love, held, force, moment] = self.balance.terms(&self.contact).map(|term| term.value);
        let (by_ratio, size) = match self.twist {
            Twist::Pretwist(pretwist) => (love + eps * pretwist * held, love.abs() + (pretwist * held).abs()),
            Twist::StrandTwist(strand_twist) => (eps * strand_twist * held, (strand_twist * held).abs()),
        };
        let (slope, lost) = self.slope_and_rounding();
        let angle_lost = if self.fold { f64::INFINITY } else { 1e4 * lost };
        // a term that vanishes by its factor keeps no digits there
        let lost_of = |k: usize, term: f64| {
            let (factor, size) = self.balance.factor(&self.contact, k);
            if factor.abs() > ROUNDING * size { 0.0 } else { term.abs() }
        };
        let (extension, rotation) = self.displacement_slopes();
        Sensitivity {
            gradient: [slope, by_ratio, eps * gamma * held, force, eps * moment],
            lost: [angle_lost, ROUNDING * size, gamma * lost_of(2, held), lost_of(3, force), lost_of(4, moment)],
            extension,
            rotation,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Handedness::{Left, Right};
    use crate::geometry::HelicalAngle;
    use crate::mechanics::{Balance, Load, Ply};

    /// Every pair of variables, by solving anew for one of them with another a little different.
    #[test]
    fn every_slope_is_that_of_the_solved_state() {
        let h = 1e-6;
        let mut checked = 0;
        for balance in Balance::BOTH {
            for (n, degrees, hand) in [
                (2, 30.0, Right),
                (2, 52.0, Left),
                (3, 12.0, Left),
                (3, 41.0, Right),
                (6, 25.0, Right),
                (9, 70.0, Left),
            ] {
                for twist in [Twist::Pretwist(-0.4), Twist::StrandTwist(0.7)] {
                    let angle = f64::to_radians(degrees);
                    let ply = |gamma: f64| Ply::with_balance(n, gamma, balance).unwrap();
                    let state = |angle: f64, gamma: f64, by: f64, force: f64| {
                        let twist = match twist {
                            Twist::Pretwist(value) => Twist::Pretwist(value + by),
                            Twist::StrandTwist(value) => Twist::StrandTwist(value + by),
                        };
                        ply(gamma).moment_at(HelicalAngle::new(angle).unwrap(), hand, twist, force).unwrap()
                    };
                    let moment = |z: [f64; 4]| state(angle + z[0], 0.8 + z[1], z[2], 0.3 + z[3]).load().moment;
                    let here = state(angle, 0.8, 0.0, 0.3);
                    let sensitivity = here.sensitivity();
                    let mut by_moment = [0.0; 5];
                    by_moment[4] = 1.0;
                    for k in 0..4 {
                        let mut z = [0.0; 4];
                        z[k] = h;
                        let up = moment(z);
                        z[k] = -h;
                        by_moment[k] = (up - moment(z)) / (2.0 * h);
                        let slope = sensitivity.slope(Variable::Moment, Variable::ALL[k]).unwrap();
                        assert!(
                            (slope - by_moment[k]).abs() < 2e-8 * (1.0 + slope.abs()),
                            "{n} {degrees} {k}: {slope} {}",
                            by_moment[k]
                        );
                    }
                    // all other slopes are ratios of those
                    for of in Variable::ALL {
                        for by in Variable::ALL {
                            let Some(slope) = sensitivity.slope(of, by) else { continue };
                            let sign = if of == Variable::Moment || by == Variable::Moment { 1.0 } else { -1.0 };
                            let expected =
                                if of == by { 1.0 } else { sign * by_moment[by.place()] / by_moment[of.place()] };
                            assert!(
                                (slope - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                                "{of:?} {by:?}: {slope} {expected}"
                            );
                            checked += 1;
                        }
                    }
                }
            }
        }
        assert_eq!(checked, 2 * 6 * 2 * 25);
    }

    #[test]
    fn slopes_by_loads_are_the_flexibility() {
        let state =
            Ply::new(4, 0.9).unwrap().equilibria(Twist::Pretwist(-0.6), Load { force: 0.2, moment: 0.1 }).unwrap()[0];
        let sensitivity = state.sensitivity();
        let slope = |by| sensitivity.slope(Variable::HelicalAngle, by).unwrap();
        let [[ff, fm], [mf, mm]] = state.flexibility().unwrap();
        let (x, y) = (sensitivity.extension_per_angle(), sensitivity.rotation_per_angle());
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-14, "{a} {b}");
        near(x * slope(Variable::Force), ff);
        near(x * slope(Variable::Moment), fm);
        near(y * slope(Variable::Force), mf);
        near(y * slope(Variable::Moment), mm);
    }

    #[test]
    fn where_a_variable_is_no_function_of_the_rest_there_is_no_slope() {
        let ply = Ply::new(2, 0.75).unwrap();
        let straight = ply.moment_at(HelicalAngle::new(0.0).unwrap(), Right, Twist::Pretwist(-0.2), 1.0).unwrap();
        assert_eq!(straight.sensitivity().slope(Variable::Force, Variable::Moment), None);
        assert!(straight.sensitivity().slope(Variable::Moment, Variable::Twist).is_some());
    }
}
