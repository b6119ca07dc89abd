//! The equations of a state on the path, by what carries the strands, and what may end it.
//!
//! Coordinates: Θ = εθ, Y = ε sin θ/ρ, the load that is found where a displacement is held, and the share of the path.

use super::course::touch;
use super::{Contacts, Path, Route};
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::potential::{Potential, Slopes};
use crate::mechanics::{Balance, Ends, Mark, Support, Twist};
use crate::numerics::jet::Jet;
use crate::numerics::linear::Vector;

/// What carries the strands, and whether it may let go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::mechanics) enum Regime {
    /// Contacts that push.
    On(Support),
    /// Neighbours kept together.
    Kept(Balance),
}

impl Regime {
    pub(super) const fn start(contacts: Contacts) -> Self {
        match contacts {
            Contacts::Unilateral => Self::On(Support::Neighbours),
            Contacts::Kept(balance) => Self::Kept(balance),
        }
    }

    pub(in crate::mechanics) const fn support(self) -> Support {
        match self {
            Self::On(support) => support,
            Self::Kept(_) => Support::Neighbours,
        }
    }
}

/// A number that depends on the share of the path: its value and slope.
#[derive(Clone, Copy)]
struct Changing {
    value: f64,
    slope: f64,
}

/// Everything at one place.
pub(super) struct Here {
    pub(super) angle: HelicalAngle,
    /// sin Θ, cos Θ
    s: f64,
    c: f64,
    y: f64,
    eps: f64,
    potential: Potential,
    slopes: Slopes,
    /// sin θ/ρ of touching strands with its derivatives, odd in Θ
    touching: Jet,
    /// cos θ/ρ of touching strands, even in Θ
    turning: Jet,
    /// q
    share: f64,
    /// ρ of strands on the core
    on_core: Option<Changing>,
    /// the displacement that is held
    held: Option<Changing>,
    holding: Ends,
    /// d/ds of γ in Love's term, of what is held of the twist, and of f/n and m/n
    love_slope: f64,
    held_slope: f64,
    force_slope: f64,
    moment_slope: f64,
    /// the load that is found; 0 where both are given
    found: f64,
    n: f64,
}

/// An equation's left side and its derivatives.
pub(super) struct Equation {
    pub(super) value: f64,
    pub(super) slopes: Vector,
}

impl Here {
    pub(super) fn new(path: &Path, z: Vector) -> Self {
        let [signed, y, reaction, along] = z;
        let (from, to, data) = (&path.from, &path.to, path.data(along));
        let eps = if signed < 0.0 { -1.0 } else { 1.0 };
        let angle = HelicalAngle::steep(signed.abs().min(FLATTEST));
        let contact = Contact::at(path.strands, angle);
        let at = contact.curved();
        let (even, odd) = (at.cos * at.cos * at.radius.recip(), at.rotation());
        let (value, slope) = match (data.twist, from.twist, to.twist) {
            (
                Twist::Pretwist(v) | Twist::StrandTwist(v),
                Twist::Pretwist(a) | Twist::StrandTwist(a),
                Twist::Pretwist(b) | Twist::StrandTwist(b),
            ) => (v, b - a),
        };
        let gamma = Changing { value: data.stiffness_ratio, slope: to.stiffness_ratio - from.stiffness_ratio };
        let n = f64::from(path.strands);
        let (start, end) = (from.ends.given(), to.ends.given());
        let mut load = data.ends.given();
        let (mut force_slope, mut moment_slope) = (end.force - start.force, end.moment - start.moment);
        let held = match (from.ends, to.ends, data.ends) {
            (
                Ends::Rotation { rotation: a, .. },
                Ends::Rotation { rotation: b, .. },
                Ends::Rotation { rotation, .. },
            ) => {
                (load.moment, moment_slope) = (reaction, 0.0);
                Some(Changing { value: rotation, slope: b - a })
            }
            (Ends::Length { extension: a, .. }, Ends::Length { extension: b, .. }, Ends::Length { extension, .. }) => {
                (load.force, force_slope) = (reaction, 0.0);
                Some(Changing { value: extension, slope: b - a })
            }
            _ => None,
        };
        let potential = Potential::new(path.strands, gamma.value, data.twist, load);
        let (s, c) = (eps * angle.sin(), angle.cos());
        let on_core = from
            .core_radius
            .zip(to.core_radius)
            .map(|(a, b)| Changing { value: 1.0 + data.core_radius.unwrap_or(a), slope: b - a });
        Self {
            angle,
            s,
            c,
            y,
            eps,
            potential,
            slopes: potential.at(s, c, y),
            touching: Jet::new(eps * odd.value, odd.slope, eps * odd.bend),
            turning: Jet::new(even.value, eps * even.slope, even.bend),
            share: contact.shift_ratio_squared(),
            on_core,
            held,
            holding: data.ends,
            love_slope: if potential.love == 0.0 { 0.0 } else { gamma.slope },
            held_slope: gamma.slope * value + gamma.value * slope,
            force_slope: force_slope / n,
            moment_slope: moment_slope / n,
            found: reaction,
            n,
        }
    }

    /// The three equations of a regime.
    pub(super) fn equations(&self, regime: Regime) -> [Equation; 3] {
        let [first, second] = match regime {
            Regime::Kept(Balance::Contact) | Regime::On(Support::Neighbours) => {
                let slope = Jet::new(self.touching.slope, self.touching.bend, 0.0);
                [self.on_touching(), self.balance_along(slope)]
            }
            Regime::Kept(Balance::Radial) => [self.on_touching(), self.balance_along(self.turning)],
            Regime::On(Support::Core) => {
                let (slope, by_path) = self.core_slope();
                let mut balance = self.balance_along(slope);
                balance.slopes[3] += self.slopes.by_rotation * by_path;
                [self.at_core(), balance]
            }
            Regime::On(Support::Both) => [self.on_touching(), self.at_core()],
            Regime::On(Support::Free) => [self.by_rotation(), self.bracket()],
        };
        [first, second, self.ends()]
    }

    /// Y = sin θ/ρ of touching strands.
    fn on_touching(&self) -> Equation {
        Equation { value: self.y - self.touching.value, slopes: [-self.touching.slope, 1.0, 0.0, 0.0] }
    }

    /// Y = sin θ/ρ on the core.
    fn at_core(&self) -> Equation {
        let Some(core) = self.on_core else { return Equation { value: f64::NAN, slopes: [0.0; 4] } };
        let sin_over = self.s / core.value;
        Equation {
            value: self.y - sin_over,
            slopes: [-self.c / core.value, 1.0, 0.0, sin_over * core.slope / core.value],
        }
    }

    /// dY/dΘ on the core as a function of Θ, and its slope along the path.
    fn core_slope(&self) -> (Jet, f64) {
        let Some(core) = self.on_core else { return (Jet::new(f64::NAN, 0.0, 0.0), 0.0) };
        let slope = self.c / core.value;
        (Jet::new(slope, -self.s / core.value, 0.0), -slope * core.slope / core.value)
    }

    /// E_Θ + E_Y k = 0, k = dY/dΘ along what carries the strands.
    fn balance_along(&self, k: Jet) -> Equation {
        let at = &self.slopes;
        let [angle_by_force, angle_by_path] = self.angle_by_loads();
        let [rotation_by_moment, rotation_by_path] = self.rotation_by_loads();
        Equation {
            value: at.by_angle + at.by_rotation * k.value,
            slopes: [
                at.angle_angle + at.angle_rotation * k.value + at.by_rotation * k.slope,
                at.angle_rotation + at.rotation_rotation * k.value,
                angle_by_force + rotation_by_moment * k.value,
                angle_by_path + rotation_by_path * k.value,
            ],
        }
    }

    /// E_Y = 0.
    fn by_rotation(&self) -> Equation {
        let at = &self.slopes;
        let [by_moment, by_path] = self.rotation_by_loads();
        Equation { value: at.by_rotation, slopes: [at.angle_rotation, at.rotation_rotation, by_moment, by_path] }
    }

    /// E_Θ over sin Θ, which straight strands would make 0 whatever else.
    fn bracket(&self) -> Equation {
        let Potential { love, held, force, .. } = self.potential;
        let (s, c, y) = (self.s, self.c, self.y);
        let [by_force, by_path] = self.angle_by_loads();
        Equation {
            value: y * y * c - (love * c * y + held) * y + force,
            slopes: [s * y * y * (love - 1.0), 2.0 * y * c * (1.0 - love) - held, by_force / s, by_path / s],
        }
    }

    /// d E_Θ by the load that is found and by the share of the path.
    fn angle_by_loads(&self) -> [f64; 2] {
        let found = if matches!(self.holding, Ends::Length { .. }) { 1.0 / self.n } else { 0.0 };
        let path = self.force_slope - (self.love_slope * self.c * self.y + self.held_slope) * self.y;
        [self.s * found, self.s * path]
    }

    /// d E_Y by the load that is found and by the share of the path.
    fn rotation_by_loads(&self) -> [f64; 2] {
        let found = if matches!(self.holding, Ends::Rotation { .. }) { -1.0 / self.n } else { 0.0 };
        let path = (self.love_slope * self.c * self.y + self.held_slope) * self.c - self.moment_slope;
        [found, path]
    }

    /// The displacement that is held, or no load to be found.
    fn ends(&self) -> Equation {
        match (self.held, self.holding) {
            (Some(held), Ends::Rotation { .. }) => {
                Equation { value: self.y - held.value, slopes: [0.0, 1.0, 0.0, -held.slope] }
            }
            (Some(held), _) => Equation { value: self.c - held.value, slopes: [-self.s, 0.0, 0.0, -held.slope] },
            _ => Equation { value: self.found, slopes: [0.0, 0.0, 1.0, 0.0] },
        }
    }

    /// What may happen in a regime: each mark with a number whose change of sign is the event. Contacts change where theirs,
    /// positive as long as they hold, turns negative.
    pub(super) fn marks(&self, regime: Regime, route: &Route) -> Vec<(Mark, f64)> {
        let outward = -self.eps * self.slopes.by_rotation; // p̂ρ/Y, whatever carries it
        let gap = self.eps * (self.touching.value - self.y);
        let core_gap = self.on_core.map(|core| self.eps * (self.s / core.value - self.y));
        let mut marks = vec![(Mark::Diagonal, self.angle.radians() - core::f64::consts::FRAC_PI_4)];
        let to = |support| Mark::ContactChange(support);
        match regime {
            Regime::Kept(_) => marks.push((Mark::Separation, outward)),
            Regime::On(Support::Neighbours) => {
                // straight strands neither press nor part; under a thrust they buckle
                let straight = self.angle.sin() == 0.0;
                marks.push((to(Support::Free), if straight { 0.0 } else { outward }));
                marks.push((Mark::Buckling, if straight { self.potential.force } else { f64::NAN }));
                marks.extend(core_gap.map(|gap| (to(Support::Both), gap)));
            }
            Regime::On(Support::Core) => marks.extend([(to(Support::Free), outward), (to(Support::Both), gap)]),
            Regime::On(Support::Both) => {
                let [neighbours, core] = self.shares();
                marks.extend([(to(Support::Core), neighbours), (to(Support::Neighbours), core)]);
            }
            Regime::On(Support::Free) => {
                marks.push((to(Support::Neighbours), gap));
                marks.extend(core_gap.map(|gap| (to(Support::Core), gap)));
            }
        }
        if touch(regime.support()) {
            marks.push((Mark::MostTurns, self.share - 1.0));
        }
        // strands that do not stretch are strained by bending alone
        for (mark, limit) in [(Mark::CurvatureLimit, route.curvature_limit), (Mark::StrainLimit, route.strain_limit)] {
            marks.extend(limit.map(|limit| (mark, (self.y * self.s).abs() - limit)));
        }
        marks
    }

    /// How neighbours and core share the load on both: the multipliers of Y ≤ touching and of Y ≤ sin θ/ρ_core,
    fn shares(&self) -> [f64; 2] {
        let Some(core) = self.on_core else { return [f64::NAN; 2] };
        let (slope, at) = (self.c / core.value, &self.slopes);
        // times their lever, cos θ/ρ − dY/dΘ of touching strands, which vanishes with θ
        let neighbours = -self.eps * (at.by_angle + at.by_rotation * slope);
        let core = self.eps * (at.by_angle + at.by_rotation * self.touching.slope);
        [neighbours, core]
    }
}

/// So near to flat rings the walk ends.
pub(in crate::mechanics) const FLATTEST: f64 = core::f64::consts::FRAC_PI_2 - 1e-9;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{Data, Load};

    /// Every derivative against differences, with everything changing along the path.
    #[test]
    fn slopes_are_differences() {
        let ends = [
            [Ends::Loads(Load { force: 0.3, moment: -0.2 }), Ends::Loads(Load { force: 1.0, moment: 2.0 })],
            [Ends::Rotation { rotation: 0.3, force: 0.2 }, Ends::Rotation { rotation: 0.4, force: -1.0 }],
            [Ends::Length { extension: 0.8, moment: 0.5 }, Ends::Length { extension: 0.7, moment: 1.0 }],
        ];
        let twists =
            [[Twist::Pretwist(-0.3), Twist::Pretwist(0.5)], [Twist::StrandTwist(0.4), Twist::StrandTwist(-0.2)]];
        let supports = [Support::Neighbours, Support::Core, Support::Both, Support::Free].map(Regime::On);
        let regimes = supports.into_iter().chain(Balance::BOTH.map(Regime::Kept));
        let kinds: Vec<_> = ends.into_iter().flat_map(|e| twists.map(|t| (e, t))).collect();
        for (regime, ([ends_a, ends_b], [twist_a, twist_b])) in regimes.flat_map(|r| kinds.iter().map(move |k| (r, *k)))
        {
            let data =
                |stiffness_ratio, twist, ends, core| Data { stiffness_ratio, twist, ends, core_radius: Some(core) };
            let from = data(0.6, twist_a, ends_a, 0.9);
            let path = Path { strands: 4, from, to: data(1.2, twist_b, ends_b, 1.3), contacts: Contacts::Unilateral };
            for z in [[0.6, 0.3, 0.4, 0.35], [-0.9, -0.25, -1.1, 0.7]] {
                let h = 1e-6;
                for (e, equation) in Here::new(&path, z).equations(regime).iter().enumerate() {
                    for i in 0..4 {
                        let at = |by: f64| {
                            let mut z = z;
                            z[i] += by;
                            Here::new(&path, z).equations(regime)[e].value
                        };
                        let slope = (at(h) - at(-h)) / (2.0 * h);
                        let got = equation.slopes[i];
                        assert!(
                            (got - slope).abs() < 1e-8 * (1.0 + slope.abs()),
                            "{regime:?} {e} by {i}: {got} {slope}"
                        );
                    }
                }
            }
        }
    }
}
