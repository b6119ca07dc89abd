//! Strands that stretch, as a course to walk: closed contacts and held displacements are constraints on Θ, Y and e, and the energy is
//! stationary on what they leave.
//!
//! With g = ∂E/∂(Θ, Y, e) and the gradients a of k constraints, g lies in the span of the a where det(g, p, q) = 0 for 3 − k pairs p, q made up
//! of the a and of axes: k + (3 − k) equations, whatever is closed or held. The loads that are found, and what contacts carry, follow.

use core::f64::consts::FRAC_PI_4;

use super::grips::{Axial, Turning};
use super::obstacle;
use super::path::{StretchData, StretchPath, StretchStation};
use super::potential::{Potential, Slopes, Spot};
use super::search::Search;
use super::state::{ExtensibleState, LEAST_STRAIN, MOST_STRAIN};
use crate::Handedness;
use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::path::{Course, FLATTEST, Regime, hand, touch};
use crate::mechanics::{End, Mark, Route, Stability, Support};
use crate::numerics::jet2::Jet2;
use crate::numerics::linear::Vector;
use crate::numerics::quadratic::{Matrix3, Vector3};

/// A path with the unit of its third coordinate, the strain.
pub(super) struct Stretching<'a> {
    path: &'a StretchPath,
    /// so that stiff strands do not drown the rest in rounding
    unit: f64,
}

/// A constraint on (Θ, Y, e): its value, first and second derivatives, and that by the share of the path.
struct Constraint {
    value: f64,
    by: Vector3,
    bends: Matrix3,
    by_path: f64,
}

/// Everything at one place.
struct Here {
    data: StretchData,
    angle: HelicalAngle,
    eps: f64,
    spot: Spot,
    along: f64,
}

const AXES: Matrix3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// So large a pressure, of two contacts or held ends that leave no motion, has passed through infinity.
const UNBOUNDED: f64 = 1e9;

impl<'a> Stretching<'a> {
    pub(super) fn new(path: &'a StretchPath) -> Self {
        let alpha = path.ply().strand().axial_stiffness();
        Self { path, unit: 1.0 / libm::sqrt(1.0_f64.max(alpha)) }
    }

    /// The coordinates of a state at the beginning of the path.
    pub(super) fn place(&self, state: &ExtensibleState) -> Vector {
        [state.handedness().sign() * state.angle().radians(), state.rotation(), state.strain() / self.unit, 0.0]
    }

    /// Straight strands, where they hold at the beginning of the path: under just the moment that keeps their twist in.
    pub(super) fn straight(&self) -> Option<StretchStation> {
        let held = self.path.held();
        if held.length || held.rotation || self.path.ply().formed().is_some() {
            return None;
        }
        let potential = self.potential(&self.path.data(0.0));
        let off = potential.held - potential.moment;
        let strain = potential.free_strain(1.0);
        let holds =
            off.abs() <= 4.0 * f64::EPSILON * potential.held.abs() && (LEAST_STRAIN..=MOST_STRAIN).contains(&strain);
        holds.then(|| self.station(Regime::On(Support::Neighbours), &[0.0, 0.0, strain / self.unit, 0.0]))
    }

    fn here(&self, z: &Vector) -> Here {
        let angle = HelicalAngle::steep(z[0].abs().min(FLATTEST));
        let eps = hand(z[0]).sign();
        let spot = Spot { sin: eps * angle.sin(), cos: angle.cos(), rotation: z[1], strain: z[2] * self.unit };
        Here { data: self.path.data(z[3]), angle, eps, spot, along: z[3] }
    }

    /// For the right hand: with Θ and Y signed it serves both.
    fn potential(&self, data: &StretchData) -> Potential {
        Potential::new(self.path.ply(), Handedness::Right, data.twist, data.load())
    }

    fn neighbours(&self, here: &Here) -> Jet2 {
        obstacle::neighbours(self.path.ply(), here.angle, here.spot.strain)
    }

    fn core(&self, here: &Here) -> Jet2 {
        obstacle::core(self.path.ply(), here.angle, here.spot.strain)
    }

    /// Closed contacts first, then held displacements.
    fn constraints(&self, here: &Here, support: Support) -> Vec<Constraint> {
        let Spot { sin: s, cos: c, rotation: y, strain: e } = here.spot;
        let (eps, lambda) = (here.eps, 1.0 + e);
        let [_, along, around] = self.path.change();
        let contact = |b: Jet2| Constraint {
            value: y - eps * b.value,
            by: [-b.a, 1.0, -eps * b.b],
            bends: [[-eps * b.aa, 0.0, -b.ab], [0.0; 3], [-b.ab, 0.0, -eps * b.bb]],
            by_path: 0.0,
        };
        let mut all = Vec::with_capacity(4);
        if touch(support) {
            all.push(contact(self.neighbours(here)));
        }
        if matches!(support, Support::Core | Support::Both) {
            all.push(contact(self.core(here)));
        }
        if let Axial::Extension(extension) = here.data.grips.axial {
            all.push(Constraint {
                value: lambda * c - extension,
                by: [-lambda * s, 0.0, c],
                bends: [[-lambda * c, 0.0, -s], [0.0; 3], [-s, 0.0, 0.0]],
                by_path: -along,
            });
        }
        if let Turning::Rotation(rotation) = here.data.grips.turning {
            all.push(Constraint { value: y - rotation, by: AXES[1], bends: [[0.0; 3]; 3], by_path: -around });
        }
        all
    }

    /// The slopes of the energy, and what they change by along the path.
    fn gradient(&self, here: &Here) -> (Slopes, Vector3) {
        let Spot { sin: s, cos: c, rotation: y, strain: e } = here.spot;
        let ply = self.path.ply();
        let n = f64::from(ply.strands());
        let [twist, along, around] = self.path.change();
        let held = self.path.held();
        let torque = ply.strand().stiffness_ratio() * twist;
        let force = if held.length { 0.0 } else { along / n };
        let moment = if held.rotation { 0.0 } else { around / n };
        let by_path = [-torque * y * s + force * (1.0 + e) * s, torque * c - moment, -force * c];
        (self.potential(&here.data).at(&here.spot), by_path)
    }

    /// The state at a place: loads that are found, and what contacts carry.
    fn state(&self, here: &Here, support: Support) -> ExtensibleState {
        let Here { data, angle, eps, spot, .. } = *here;
        let search = Search::new(self.path.ply(), hand(eps), data.twist, data.grips);
        let turn = eps * spot.rotation;
        search.state(support, angle, turn, spot.strain).unwrap_or_else(|| ExtensibleState {
            ply: *self.path.ply(),
            support,
            handedness: hand(eps),
            touching: Contact::at(self.path.ply().strands(), angle),
            turn,
            strain: spot.strain,
            twist: data.twist,
            load: data.load(),
            shares: [0.0; 2],
        })
    }

    /// How many constraints there are.
    fn count(&self, support: Support) -> usize {
        let contacts = match support {
            Support::Free => 0,
            Support::Neighbours | Support::Core => 1,
            Support::Both => 2,
        };
        let held = self.path.held();
        contacts + usize::from(held.length) + usize::from(held.rotation)
    }
}

impl Course for Stretching<'_> {
    type Stop = StretchStation;

    fn strands(&self) -> u32 {
        self.path.ply().strands()
    }

    fn equations(&self, regime: Regime, z: &Vector) -> ([f64; 3], [Vector; 3]) {
        let here = self.here(z);
        let constraints = self.constraints(&here, regime.support());
        let row = |by: Vector3, by_path: f64| [by[0], by[1], by[2] * self.unit, by_path];
        let mut all: Vec<(f64, Vector)> = constraints.iter().map(|c| (c.value, row(c.by, c.by_path))).collect();
        let (slopes, by_path) = self.gradient(&here);
        let g = Jets { value: slopes.by, bends: slopes.bends, by_path };
        let mut spanned: Vec<Jets> = constraints.iter().map(Jets::of).collect();
        let [turned, along] = [AXES[0], AXES[2]].map(Jets::axis);
        let around = Jets::axis(AXES[1]);
        let free = regime.support() == Support::Free && !self.path.held().rotation;
        let pairs = match (spanned.pop(), spanned.pop()) {
            (None, _) => vec![(around, along), (along, turned), (turned, around)],
            // a length that is held says nothing about the rotation
            (Some(a), None) if a.value[1] == 0.0 => vec![(a, around), (a, turned)],
            (Some(a), None) => vec![(a, along), (a, turned)],
            (Some(a), Some(b)) if spanned.is_empty() => vec![(a, b)],
            _ => Vec::new(),
        };
        for (i, (p, q)) in pairs.into_iter().enumerate() {
            let (mut value, by, mut by_path) = g.determinant(&p, &q);
            let mut slopes = row(by, 0.0);
            if free && i == 0 {
                // straight strands would make it 0 whatever else
                let Spot { sin: s, cos: c, .. } = here.spot;
                slopes = slopes.map(|x| x / s);
                slopes[0] -= value * c / (s * s);
                (value, by_path) = (value / s, by_path / s);
            }
            slopes[3] = by_path;
            all.push((value, slopes));
        }
        match all[..] {
            [(a, x), (b, y), (c, z)] => ([a, b, c], [x, y, z]),
            // more constraints than coordinates: nothing moves
            _ => ([f64::NAN; 3], [[f64::NAN; 4]; 3]),
        }
    }

    fn marks(&self, regime: Regime, z: &Vector, route: &Route) -> Vec<(Mark, f64)> {
        let (here, support) = (self.here(z), regime.support());
        let state = self.state(&here, support);
        let cored = self.path.ply().core().is_some();
        let y = here.eps * here.spot.rotation;
        let gap = || self.neighbours(&here).value - y;
        let core_gap = || cored.then(|| self.core(&here).value - y);
        let locked = self.locked(regime);
        // beyond infinity, where nothing moves any more, a contact does not open
        let [neighbours, core] =
            state.shares.map(|share| if locked && share.abs() > UNBOUNDED { UNBOUNDED } else { share });
        let mut marks = vec![(Mark::Diagonal, here.angle.radians() - FRAC_PI_4)];
        let to = |support| Mark::ContactChange(support);
        // straight strands neither press nor part; under a thrust they buckle
        let straight = here.angle.sin() == 0.0;
        let presses = |share: f64| if straight { 0.0 } else { share };
        match support {
            Support::Neighbours => {
                marks.push((to(Support::Free), presses(neighbours)));
                marks.push((Mark::Buckling, if straight { state.load().force } else { f64::NAN }));
                marks.extend(core_gap().map(|gap| (to(Support::Both), gap)));
            }
            Support::Core => marks.extend([(to(Support::Free), presses(core)), (to(Support::Both), gap())]),
            Support::Both => marks.extend([(to(Support::Core), neighbours), (to(Support::Neighbours), core)]),
            Support::Free => {
                marks.push((to(Support::Neighbours), gap()));
                marks.extend(core_gap().map(|gap| (to(Support::Core), gap)));
            }
        }
        if touch(support) {
            marks.push((Mark::MostTurns, state.touching.shift_ratio_squared() - 1.0));
        }
        let bent = state.bending().abs();
        marks.extend(route.curvature_limit.map(|limit| (Mark::CurvatureLimit, bent - limit)));
        marks.extend(route.strain_limit.map(|limit| (Mark::StrainLimit, state.strain().abs() + bent - limit)));
        marks
    }

    fn station(&self, regime: Regime, z: &Vector) -> StretchStation {
        let here = self.here(z);
        let state = self.state(&here, regime.support());
        let straight = here.angle.sin() == 0.0 && regime.support() != Support::Free;
        let stability = if straight {
            // contacts do not bound how straight strands may lean and bow: under a thrust the energy falls away from them
            Stability::of(state.load().force, 0.0)
        } else {
            state.stability(self.path.held())
        };
        StretchStation { along: here.along, state, stability }
    }

    fn states_at(&self, along: f64) -> Vec<StretchStation> {
        self.path.past(along).starts().unwrap_or_default()
    }

    fn outside(&self, z: &Vector) -> Option<End> {
        let strain = z[2] * self.unit;
        (!(LEAST_STRAIN..=MOST_STRAIN).contains(&strain)).then_some(End::Overstretched)
    }

    /// Never, as long as anything moves: what strands carry is bounded by their stretch.
    fn unbounded(&self, _: &Vector) -> bool {
        false
    }

    fn locked(&self, regime: Regime) -> bool {
        self.count(regime.support()) >= 3
    }
}

/// A vector with its derivatives by Θ, Y, e and by the share of the path.
#[derive(Clone, Copy)]
struct Jets {
    value: Vector3,
    bends: Matrix3,
    by_path: Vector3,
}

impl Jets {
    fn of(constraint: &Constraint) -> Self {
        Self { value: constraint.by, bends: constraint.bends, by_path: [0.0; 3] }
    }

    fn axis(value: Vector3) -> Self {
        Self { value, bends: [[0.0; 3]; 3], by_path: [0.0; 3] }
    }

    /// det(self, p, q) with its derivatives.
    fn determinant(&self, p: &Self, q: &Self) -> (f64, Vector3, f64) {
        // second derivatives are symmetric: a row of them is the derivative by one variable
        let by = |i: usize| {
            triple(self.bends[i], p.value, q.value)
                + triple(self.value, p.bends[i], q.value)
                + triple(self.value, p.value, q.bends[i])
        };
        let by_path = triple(self.by_path, p.value, q.value)
            + triple(self.value, p.by_path, q.value)
            + triple(self.value, p.value, q.by_path);
        (triple(self.value, p.value, q.value), [by(0), by(1), by(2)], by_path)
    }
}

/// a · (b × c).
fn triple(a: Vector3, b: Vector3, c: Vector3) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{ExtensiblePly, FormedLay, Grips, StretchingStrand, Twist, WorkingCore};

    /// Every derivative against differences, with everything changing along the path, on both hands.
    #[test]
    fn slopes_are_differences() {
        let angle = HelicalAngle::new(0.4).expect("an angle");
        let lay = FormedLay { handedness: Handedness::Right, angle, radius_ratio: 2.3, preforming: 0.6 };
        let core = WorkingCore::new(1.2, 5.0, 1.7, 0.2).expect("a core");
        let strand = StretchingStrand::new(0.7, 3.0, 0.3).expect("a strand");
        let ply = ExtensiblePly::new(6, strand).and_then(|p| p.with_core(core)).and_then(|p| p.formed_in(lay));
        let ply = ply.expect("a ply");
        let axials = [[Axial::Force(0.3), Axial::Force(1.0)], [Axial::Extension(0.8), Axial::Extension(0.9)]];
        let turnings =
            [[Turning::Moment(-0.2), Turning::Moment(2.0)], [Turning::Rotation(0.3), Turning::Rotation(0.4)]];
        let twists =
            [[Twist::Pretwist(-0.3), Twist::Pretwist(0.5)], [Twist::StrandTwist(0.4), Twist::StrandTwist(-0.2)]];
        for support in [Support::Neighbours, Support::Core, Support::Both, Support::Free] {
            for (i, twist) in (0..8).map(|i| (i, twists[i / 4])) {
                let data = |end: usize| StretchData {
                    twist: twist[end],
                    grips: Grips { axial: axials[i % 2][end], turning: turnings[i / 2 % 2][end] },
                };
                let path = StretchPath::new(&ply, data(0), data(1)).expect("a path");
                let course = Stretching::new(&path);
                if course.count(support) > 3 {
                    continue;
                }
                let regime = Regime::On(support);
                for z in [[0.6, 0.3, 0.02, 0.35], [-0.9, -0.25, -0.05, 0.7]] {
                    let h = 1e-6;
                    let (_, rows) = course.equations(regime, &z);
                    for j in 0..4 {
                        let at = |by: f64| {
                            let mut z = z;
                            z[j] += by;
                            course.equations(regime, &z).0
                        };
                        let (above, below) = (at(h), at(-h));
                        for (e, row) in rows.iter().enumerate() {
                            let slope = (above[e] - below[e]) / (2.0 * h);
                            let wrong = (row[j] - slope).abs() >= 1e-8 * (1.0 + slope.abs());
                            assert!(!wrong, "{support:?} {i} {e} by {j}: {} {slope}", row[j]);
                        }
                    }
                }
            }
        }
    }
}
