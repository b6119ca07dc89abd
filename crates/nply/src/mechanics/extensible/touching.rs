//! Touching strands that stretch, laid at an angle and a strain: the loads that hold them there, and how these change.

use super::ply::ExtensiblePly;
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::{Load, Twist};
use crate::numerics::dual::Dual;
use crate::{DomainError, Handedness};

/// Loads of a ply of touching strands at a given angle and strain, with their slopes.
///
/// Angle and strain are two freedoms and the end loads two numbers that enter the two equations of equilibrium linearly, so that every
/// angle and strain has its loads. What it leaves open is whether neighbours push: [`interstrand_pressure`](Self::interstrand_pressure).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchingLoads {
    /// f and m.
    pub load: Load,
    /// p₁ r³/B of neighbours on each other, per unstretched strand length; negative where they would have to pull.
    pub interstrand_pressure: f64,
    /// ∂f by θ (rad), e, γ, the twist as it is given, and α.
    pub force_slopes: [f64; 5],
    /// ∂m by the same.
    pub moment_slopes: [f64; 5],
}

impl ExtensiblePly {
    /// The loads that hold touching strands at an angle and a strain; of straight strands that nothing formed, without a core.
    ///
    /// # Errors
    /// [`DomainError`] on `helical_angle` unless it is greater than 0, on `strain` unless between −1/2 and 1, on `core_radius` and
    /// `preforming` where there are such, on `axial_stiffness` where strands do not stretch.
    ///
    /// ```
    /// use nply::geometry::HelicalAngle;
    /// use nply::mechanics::{ExtensiblePly, Load, StretchingStrand, Support, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::new(0.75, 40.0, 0.3)?)?;
    /// let load = Load { force: 0.6, moment: 0.1 };
    /// let states = yarn.states(Twist::Pretwist(-0.5), load)?;
    /// let state = states.iter().find(|s| s.support() == Support::Neighbours).expect("it holds together");
    /// let held = yarn.loads_at(state.angle(), state.handedness(), state.strain(), Twist::Pretwist(-0.5))?;
    /// assert!((held.load.force - 0.6).abs() < 1e-10 && (held.load.moment - 0.1).abs() < 1e-10);
    /// assert!((held.interstrand_pressure - state.interstrand_pressure()).abs() < 1e-10);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn loads_at(
        &self,
        angle: HelicalAngle,
        handedness: Handedness,
        strain: f64,
        twist: Twist,
    ) -> Result<TouchingLoads, DomainError> {
        self.check_touching(angle, strain)?;
        let (gamma, alpha) = (self.strand().stiffness_ratio(), self.strand().axial_stiffness());
        let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = twist;
        let contact = Contact::at(self.strands(), angle);
        let at = |k: usize| {
            let seed = |i: usize, value: f64| Dual::new(value, f64::from(u8::from(i == k)));
            let place = Place { contact: &contact, by_angle: f64::from(u8::from(k == 0)), strain: seed(1, strain) };
            let ratio = seed(2, gamma);
            let held = ratio * (handedness.sign() * seed(3, given));
            let love = if matches!(twist, Twist::Pretwist(_)) { ratio } else { Dual::new(0.0, 0.0) };
            self.loads(&place, love, held, seed(4, alpha))
        };
        let (n, eps) = (f64::from(self.strands()), handedness.sign());
        let all: [[Dual; 3]; 5] = core::array::from_fn(at);
        let [force, moment, pressure] = all[0].map(|part| part.value);
        let load = Load { force: n * force, moment: eps * n * moment };
        DomainError::check(load.force.is_finite(), "force", load.force, "finite")?;
        DomainError::check(load.moment.is_finite(), "moment", load.moment, "finite")?;
        Ok(TouchingLoads {
            load,
            interstrand_pressure: pressure,
            force_slopes: all.map(|parts| n * parts[0].slope),
            moment_slopes: all.map(|parts| eps * n * parts[1].slope),
        })
    }

    fn check_touching(&self, angle: HelicalAngle, strain: f64) -> Result<(), DomainError> {
        DomainError::check(angle.sin() > 0.0, "helical_angle", angle.radians(), "greater than 0")?;
        DomainError::check((-0.5..=1.0).contains(&strain), "strain", strain, "between -1/2 and 1")?;
        let core = self.core().map_or(0.0, |core| core.radius());
        DomainError::check(core == 0.0, "core_radius", core, "0: touching strands alone are asked for")?;
        let formed = self.formed().map_or(0.0, |lay| lay.preforming);
        DomainError::check(formed == 0.0, "preforming", formed, "0: straight strands alone are asked for")?;
        let alpha = self.strand().axial_stiffness();
        DomainError::check(
            alpha < f64::INFINITY,
            "axial_stiffness",
            alpha,
            "finite: strands that stretch are asked for",
        )?;
        Ok(())
    }

    /// Force and moment per strand and the pressure of neighbours, of the right-handed ply: from ∂E/∂θ + P ∂Y/∂θ = 0 and
    /// ∂E/∂e + P ∂Y/∂e = 0 along Y = λ sin θ/(sρ), with P = ∂E/∂Y.
    fn loads(&self, place: &Place<'_>, love: Dual, held: Dual, alpha: Dual) -> [Dual; 3] {
        let one = Dual::new(1.0, 0.0);
        let [s, c, rho, per_angle] = place.shape();
        let e = place.strain;
        let lambda = one + e;
        let nu = self.strand().poissons_ratio();
        let thickness = one - nu * e;
        let unit = lambda * (thickness * rho).recip(); // λ/(sρ)
        let y = unit * s;
        let y_angle = unit * per_angle;
        let y_strain = s * (thickness * rho).recip() * (one + nu * (lambda * thickness.recip()));
        let bent = y * s;
        let torque = love * y * c + held;
        let lean = y * (bent * c - torque * s);
        let pull = alpha * e;
        let inverse = (lambda * s * y_strain + c * y_angle).recip();
        let force = (pull * y_angle - lean * y_strain) * inverse;
        let push = (pull * lambda * s + lean * c) * inverse; // −P
        let moment = bent * s + torque * c + push;
        [force, moment, 0.5 * (push * y * thickness.recip())]
    }
}

/// Where the strands lie.
struct Place<'c> {
    contact: &'c Contact,
    /// the seed of the angle
    by_angle: f64,
    strain: Dual,
}

impl Place<'_> {
    /// sin θ, cos θ, ρ, and cos θ − sin θ ρ′/ρ = cos θ (1 − q).
    fn shape(&self) -> [Dual; 4] {
        let (s, c) = (self.contact.angle().sin(), self.contact.angle().cos());
        let (q, q_slope) = (self.contact.shift_ratio_squared(), self.contact.shift_ratio_squared_slope());
        let d = self.by_angle;
        let cos = Dual::new(c, -s * d);
        [
            Dual::new(s, c * d),
            cos,
            Dual::new(self.contact.radius_ratio(), self.contact.radius_ratio_slope() * d),
            cos * Dual::new(1.0 - q, -q_slope * d),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{Ply, StretchingStrand};

    fn yarn(n: u32, gamma: f64, alpha: f64) -> ExtensiblePly {
        ExtensiblePly::new(n, StretchingStrand::new(gamma, alpha, 0.3).unwrap()).unwrap()
    }

    fn with(twist: Twist, by: f64) -> Twist {
        match twist {
            Twist::Pretwist(value) => Twist::Pretwist(value + by),
            Twist::StrandTwist(value) => Twist::StrandTwist(value + by),
        }
    }

    #[test]
    fn slopes_are_those_of_the_loads() {
        let h = 1e-5;
        for (n, angle, hand) in [(2, 0.5, Handedness::Right), (3, 0.9, Handedness::Left), (7, 0.3, Handedness::Left)] {
            for twist in [Twist::Pretwist(-0.4), Twist::StrandTwist(0.3)] {
                let at = |z: [f64; 5]| {
                    let angle = HelicalAngle::new(angle + z[0]).unwrap();
                    yarn(n, 0.8 + z[2], 30.0 + z[4]).loads_at(angle, hand, 0.02 + z[1], with(twist, z[3])).unwrap()
                };
                let here = at([0.0; 5]);
                for k in 0..5 {
                    let mut z = [0.0; 5];
                    z[k] = h;
                    let up = at(z).load;
                    z[k] = -h;
                    let down = at(z).load;
                    let near = |slope: f64, up: f64, down: f64| {
                        let difference = (up - down) / (2.0 * h);
                        assert!(
                            (slope - difference).abs() < 1e-6 * (1.0 + slope.abs()),
                            "{n} {k}: {slope} {difference}"
                        );
                    };
                    near(here.force_slopes[k], up.force, down.force);
                    near(here.moment_slopes[k], up.moment, down.moment);
                }
            }
        }
    }

    /// Stiff against stretch: the paper's strands.
    #[test]
    fn hard_strands_are_those_of_the_paper() {
        let (n, twist, hand) = (3, Twist::Pretwist(-0.5), Handedness::Right);
        let angle = HelicalAngle::new(0.4).unwrap();
        let alpha = 1e9;
        let slack = yarn(n, 0.75, alpha).loads_at(angle, hand, 0.0, twist).unwrap();
        // a strain that leaves a force of 0.3 in the ply
        let strain = (0.3 - slack.load.force) / slack.force_slopes[1];
        let held = yarn(n, 0.75, alpha).loads_at(angle, hand, strain, twist).unwrap();
        let paper = Ply::new(n, 0.75).unwrap().moment_at(angle, hand, twist, held.load.force).unwrap();
        assert!((held.load.force - 0.3).abs() < 1e-6);
        assert!((held.load.moment - paper.load().moment).abs() < 1e-8, "{} {}", held.load.moment, paper.load().moment);
        assert!((held.interstrand_pressure - paper.interstrand_pressure()).abs() < 1e-8);
    }

    #[test]
    fn what_it_is_not_meant_for_is_refused() {
        let at = |angle: f64, strain: f64| {
            yarn(3, 0.75, 40.0).loads_at(
                HelicalAngle::new(angle).unwrap(),
                Handedness::Right,
                strain,
                Twist::Pretwist(0.1),
            )
        };
        assert_eq!(at(0.0, 0.0).unwrap_err().quantity, "helical_angle");
        assert_eq!(at(0.3, 3.0).unwrap_err().quantity, "strain");
        let hard = ExtensiblePly::new(3, StretchingStrand::inextensible(0.75).unwrap()).unwrap();
        let refused = hard.loads_at(HelicalAngle::new(0.3).unwrap(), Handedness::Right, 0.0, Twist::Pretwist(0.1));
        assert_eq!(refused.unwrap_err().quantity, "axial_stiffness");
    }
}
