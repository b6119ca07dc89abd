//! What carries the strands: neighbours, a core, both, or nothing. Contacts push and never pull.

use super::atlas::{Atlas, Condition};
use super::equilibrium::weights;
use super::{Balance, Load, Ply, Twist};
use crate::geometry::{Contact, HelicalAngle};
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};
use crate::{DomainError, Handedness};

/// Which contacts are closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Support {
    /// Strands touch each other; a core, if there is one, lies loose: contact balance.
    Neighbours,
    /// Strands lie on the core with gaps between them: radial balance at the core's radius.
    Core,
    /// Strands lie on the core and touch each other: the core fixes the angle.
    Both,
    /// Neither: free helices, the ply that has opened (birdcage).
    Free,
}

/// A state of n equal helices that touch each other, a core, both or nothing, with every contact pushing.
///
/// Dimensionless (r = B = 1). ρ may be above that of touching strands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportedState {
    /// What carries the strands.
    pub support: Support,
    /// ε.
    pub handedness: Handedness,
    /// θ.
    pub angle: HelicalAngle,
    /// ρ = R/r.
    pub radius_ratio: f64,
    /// p₁ r³/B ≥ 0, from each neighbour.
    pub interstrand_pressure: f64,
    /// p_c r³/B ≥ 0, from the core.
    pub core_pressure: f64,
    /// p r³/B, resultant of both, outward.
    pub resultant_pressure: f64,
    /// Clearance between the surfaces of neighbours, in units of r; 0 where they touch.
    pub neighbour_gap: f64,
    /// Clearance between strand and core, in units of r; 0 on the core; infinite without a core.
    pub core_gap: f64,
    /// r u₃.
    pub strand_twist: f64,
}

/// The loads under which strands on a core keep touching each other too, at the angle the core fixes: a wedge in the plane
/// of (f, m), from its tip along two directions. Figure 11 is one line in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wedge {
    /// The state's angle.
    pub angle: HelicalAngle,
    /// ε.
    pub handedness: Handedness,
    /// Where both contacts are just closed.
    pub tip: Load,
    /// Along this edge neighbours just touch, p₁ = 0: the direction (f, m).
    pub neighbours_just_touch: Load,
    /// Along this edge the core is just touched, p_c = 0.
    pub core_just_touches: Load,
}

/// E(θ, ρ)'s slopes of (45) and (56), per strand: what contacts must balance.
#[derive(Clone, Copy, Debug)]
struct Slopes {
    /// ∂E/∂θ = G/(nρ²)
    angle: f64,
    /// p̂ = ∂E/∂ρ
    radius: f64,
}

/// Radial balance at a fixed ρ, (40): the weights as in contact.
#[derive(Clone, Copy, Debug)]
struct AtRadius(f64);

impl Condition<5> for AtRadius {
    fn terms(&self, contact: &Contact) -> [Dual; 5] {
        let rho = self.0;
        let n = f64::from(contact.strands());
        let (sin, cos) = (contact.angle().sin(), contact.angle().cos());
        let (s, c) = (Dual::new(sin, cos), Dual::new(cos, -sin));
        let cos2 = c * c - s * s;
        [2.0 * n * (s * s * s * c), n * (s * c * cos2), n * rho * cos2, rho * rho * s, -(rho * c)]
    }
}

/// Powers of cos θ, up to the fourth.
struct Powers;

impl Basis<5> for Powers {
    fn at(&self, t: f64) -> [Dual; 5] {
        let c = Dual::new(t, 1.0);
        let mut power = Dual::new(1.0, 0.0);
        core::array::from_fn(|_| {
            let this = power;
            power = power * c;
            this
        })
    }
}

impl Ply {
    /// Every state in which all closed contacts push: touching neighbours, on the core, on both, or free, each hand.
    ///
    /// `core_radius` in units of r; `None` without a core. Right-handed states first, then by angle. The ply's own balance
    /// is of no account: where only neighbours touch it is contact balance, where only the core carries it is radial.
    ///
    /// # Errors
    /// [`DomainError`] unless the data are finite, the core's radius is greater than 0 and no external pressure acts.
    ///
    /// ```
    /// use nply::mechanics::{Load, Ply, Support, Twist};
    /// // the 6-ply of Figure 11 on a core of radius 1.1: it keeps the angle the core fixes while both contacts push
    /// let rope = Ply::new(6, 0.75)?;
    /// let load = Load { force: 8.7, moment: 7.1 };
    /// let states = rope.supported_states(Twist::Pretwist(-0.2), load, Some(1.1))?;
    /// let both = states.iter().find(|s| s.support == Support::Both).expect("inside the wedge");
    /// assert!((both.angle.degrees() - 20.0).abs() < 0.05 && both.core_pressure > 0.0);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn supported_states(
        &self,
        twist: Twist,
        load: Load,
        core_radius: Option<f64>,
    ) -> Result<Vec<SupportedState>, DomainError> {
        self.check(twist, load)?;
        self.check_unpressed()?;
        let core = core_radius.map(check_core).transpose()?;
        let mut states = Vec::new();
        self.touching(twist, load, core, &mut states)?;
        if let Some(rho) = core {
            self.on_core(twist, load, rho, &mut states);
            self.on_both(twist, load, rho, &mut states);
        }
        self.free(twist, load, core, &mut states);
        states.sort_by(|a, b| {
            let left = |s: &SupportedState| s.handedness == Handedness::Left;
            left(a).cmp(&left(b)).then(a.angle.radians().total_cmp(&b.angle.radians()))
        });
        Ok(states)
    }

    /// The loads under which strands on a core of given radius (units of r) touch each other too, for either hand. `None`
    /// where touching strands cannot lie on such a core: it is too small for straight strands.
    ///
    /// # Errors
    /// [`DomainError`] unless the twist is finite, the core's radius is greater than 0 and no external pressure acts.
    ///
    /// ```
    /// use nply::mechanics::{Ply, Twist};
    /// let rope = Ply::new(6, 0.75)?;
    /// let [right, _] = rope.wedges(Twist::Pretwist(-0.2), 1.1)?.expect("six strands touch on this core");
    /// assert!((right.angle.degrees() - 20.0).abs() < 0.05);
    /// assert!(rope.wedges(Twist::Pretwist(-0.2), 0.5)?.is_none());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn wedges(&self, twist: Twist, core_radius: f64) -> Result<Option<[Wedge; 2]>, DomainError> {
        self.check(twist, Load::NONE)?;
        self.check_unpressed()?;
        let rho = check_core(core_radius)?;
        let Ok(contact) = Contact::from_radius_ratio(self.strands(), rho) else { return Ok(None) };
        if contact.angle().sin() == 0.0 {
            return Ok(None);
        }
        let (s, c, q) = (contact.angle().sin(), contact.angle().cos(), contact.shift_ratio_squared());
        // at the tip p̂ and ∂E/∂θ vanish together: the state is on the verge of separation
        let [right, left] = Handedness::BOTH.map(|hand| self.separation_at(contact.angle(), hand, twist));
        Ok(Some([right?, left?].map(|verge| {
            let eps = verge.handedness().sign();
            Wedge {
                angle: contact.angle(),
                handedness: verge.handedness(),
                tip: verge.load(),
                neighbours_just_touch: Load { force: c, moment: eps * rho * s },
                core_just_touches: Load { force: c * (1.0 - q), moment: eps * rho * s },
            }
        })))
    }

    fn slopes(&self, angle: HelicalAngle, rho: f64, handedness: Handedness, twist: Twist, load: Load) -> Slopes {
        let n = f64::from(self.strands());
        let (s, c) = (angle.sin(), angle.cos());
        let (eps, gamma) = (handedness.sign(), self.stiffness_ratio());
        let u3 = strand_twist(twist, handedness, s * c / rho);
        let (f, m) = (load.force, load.moment);
        Slopes {
            angle: 2.0 * s * s * s * c / (rho * rho) + eps * gamma * u3 * (c * c - s * s) / rho + f / n * s
                - eps * m / (n * rho) * c,
            radius: s / (rho * rho) * (eps * (m / n - gamma * u3 * c) - s * s * s / rho),
        }
    }

    /// Neighbours touch and push; the core, if any, is loose.
    fn touching(
        &self,
        twist: Twist,
        load: Load,
        core: Option<f64>,
        states: &mut Vec<SupportedState>,
    ) -> Result<(), DomainError> {
        let contact_balance = Self::with_balance(self.strands(), self.stiffness_ratio(), Balance::Contact)?;
        contact_balance.each_equilibrium(twist, load, |state| {
            let rho = state.contact().radius_ratio();
            if !state.is_separated() && core.is_none_or(|least| rho >= least) {
                states.push(SupportedState {
                    support: Support::Neighbours,
                    handedness: state.handedness(),
                    angle: state.contact().angle(),
                    radius_ratio: rho,
                    interstrand_pressure: state.interstrand_pressure(),
                    core_pressure: 0.0,
                    resultant_pressure: state.resultant_pressure(),
                    neighbour_gap: 0.0,
                    core_gap: core.map_or(f64::INFINITY, |least| rho - least),
                    strand_twist: state.strand_twist(),
                });
            }
        })
    }

    /// Strands on the core, apart from each other.
    fn on_core(&self, twist: Twist, load: Load, rho: f64, states: &mut Vec<SupportedState>) {
        let weights = weights(self.stiffness_ratio(), twist, load);
        Atlas::new(self.strands(), AtRadius(rho)).solve(weights, |handedness, at| {
            let touching = Contact::at(self.strands(), at.angle).radius_ratio();
            let pressure = self.slopes(at.angle, rho, handedness, twist, load).radius;
            if touching < rho && pressure >= 0.0 {
                states.push(SupportedState {
                    support: Support::Core,
                    handedness,
                    angle: at.angle,
                    radius_ratio: rho,
                    interstrand_pressure: 0.0,
                    core_pressure: pressure,
                    resultant_pressure: pressure,
                    neighbour_gap: 2.0 * (rho / touching - 1.0),
                    core_gap: 0.0,
                    strand_twist: strand_twist(twist, handedness, at.angle.sin() * at.angle.cos() / rho),
                });
            }
        });
    }

    /// Strands on the core that touch each other too: p₁ and p_c from ∂E/∂θ = −2qp₁ cot θ and ∂E/∂ρ = 2p₁/ρ + p_c.
    fn on_both(&self, twist: Twist, load: Load, rho: f64, states: &mut Vec<SupportedState>) {
        let Ok(contact) = Contact::from_radius_ratio(self.strands(), rho) else { return };
        let q = contact.shift_ratio_squared();
        if q == 0.0 {
            return; // straight strands on a core that just fits: no angle to be fixed
        }
        for handedness in Handedness::BOTH {
            let slopes = self.slopes(contact.angle(), rho, handedness, twist, load);
            let p1 = -slopes.angle * contact.angle().tan() / (2.0 * q);
            let pc = slopes.radius - 2.0 * p1 / rho;
            if p1 >= 0.0 && pc >= 0.0 {
                states.push(SupportedState {
                    support: Support::Both,
                    handedness,
                    angle: contact.angle(),
                    radius_ratio: rho,
                    interstrand_pressure: p1,
                    core_pressure: pc,
                    resultant_pressure: rho * p1 * contact.one_minus_cos_beta() + pc,
                    neighbour_gap: 0.0,
                    core_gap: 0.0,
                    strand_twist: strand_twist(twist, handedness, contact.torsion()),
                });
            }
        }
    }

    /// Free helices: p̂ = 0 and ∂E/∂θ = 0 with θ and ρ both unknown.
    ///
    /// With y = sin θ/ρ and c = cos θ they read εm/n = y sin²θ + γ(ε r u₃)c and f/n = y(γ ε r u₃ − c y), the moment and the force of
    /// a helical rod by itself. The first gives y, the second then is a polynomial of degree four in c. Where it vanishes for
    /// every c (γ = 1 under a moment alone, without pretwist) every angle is as good as another, and none is given.
    fn free(&self, twist: Twist, load: Load, core: Option<f64>, states: &mut Vec<SupportedState>) {
        let n = f64::from(self.strands());
        let (love, held) = twist.weights(self.stiffness_ratio());
        let lag = love - 1.0;
        for handedness in Handedness::BOTH {
            let eps = handedness.sign();
            // γ ε r u₃ = h + love c y, so y = (M − hc)/(1 + lag c²) and F(1 + lag c²)² = (M − hc)(h + lag M c)
            let (big_m, big_f, h) = (eps * load.moment / n, load.force / n, eps * held);
            let polynomial = [
                big_f - big_m * h,
                h * h - lag * big_m * big_m,
                lag * (2.0 * big_f + big_m * h),
                0.0,
                big_f * lag * lag,
            ];
            let pair = Pair { even: polynomial, odd: [0.0; 5] };
            for (start, end) in [(0.0, 0.25), (0.25, 0.5), (0.5, 0.75), (0.75, 1.0)] {
                Panel::fit(&Powers, start, end).roots(&Powers, &pair.tamed(), &mut |side, root| {
                    if side < 0.0 {
                        return; // both of the pair are the same polynomial
                    }
                    let c = root.at;
                    let y = (big_m - h * c) / (1.0 + lag * c * c);
                    let angle = HelicalAngle::of_cosine(c);
                    let rho = angle.sin() / y;
                    let touching = Contact::at(self.strands(), angle).radius_ratio();
                    if y > 0.0 && rho >= touching && core.is_none_or(|least| rho >= least) && rho < f64::INFINITY {
                        states.push(SupportedState {
                            support: Support::Free,
                            handedness,
                            angle,
                            radius_ratio: rho,
                            interstrand_pressure: 0.0,
                            core_pressure: 0.0,
                            resultant_pressure: 0.0,
                            neighbour_gap: 2.0 * (rho / touching - 1.0),
                            core_gap: core.map_or(f64::INFINITY, |least| rho - least),
                            strand_twist: strand_twist(twist, handedness, c * y),
                        });
                    }
                });
            }
        }
    }
}

/// ρ of strands on a core, from the core's radius.
fn check_core(core_radius: f64) -> Result<f64, DomainError> {
    let positive = core_radius > 0.0 && core_radius < f64::INFINITY;
    DomainError::check(positive, "core_radius", core_radius, "greater than 0 and finite")?;
    Ok(1.0 + core_radius)
}

/// r u₃ of a strand whose centreline has the given torsion (right-handed).
fn strand_twist(twist: Twist, handedness: Handedness, torsion: f64) -> f64 {
    match twist {
        Twist::Pretwist(pretwist) => pretwist + handedness.sign() * torsion,
        Twist::StrandTwist(strand_twist) => strand_twist,
    }
}
