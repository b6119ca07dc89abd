//! How a state answers small changes: what is free, whether it comes back, flexibility and stiffness.

use super::obstacle;
use super::state::ExtensibleState;
use crate::mechanics::{Stability, Support};
use crate::numerics::quadratic::{Matrix3, Restricted, Vector3};

/// Which displacements of the ends are held while a state is disturbed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Clamped {
    /// The ply's length.
    pub length: bool,
    /// Its rotation.
    pub rotation: bool,
}

/// Flexibility of a state: small changes of displacement per small change of end load, per unit of the present ply length.
///
/// Symmetric, as Maxwell and Betti ask. Dimensionless: strain per B/r², turning (rad·r per length) per B/r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchFlexibility {
    /// Axial strain per force.
    pub strain_by_force: f64,
    /// Axial strain per moment, equal to rotation per length per force.
    pub coupling: f64,
    /// Rotation per length per moment.
    pub rotation_by_moment: f64,
}

/// Stiffness of a state: (force, moment) = matrix · (axial strain, rotation per ply length), the classical 2 × 2 matrix of cables.
///
/// Per unit of the present ply length, in B/r², B/r and B.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchStiffness {
    /// Force per strain with ends that cannot turn: EA of the ply.
    pub axial: f64,
    /// Force per rotation per length, equal to moment per strain.
    pub coupling: f64,
    /// Moment per rotation per length at constant length: GJ of the ply.
    pub torsional: f64,
}

impl StretchStiffness {
    /// Force per strain with ends free to turn, under a dead moment.
    #[must_use]
    pub fn axial_free(&self) -> f64 {
        self.axial - self.coupling * self.coupling / self.torsional
    }

    /// Moment per rotation per length with a length free to change, under a dead force.
    #[must_use]
    pub fn torsional_free(&self) -> f64 {
        self.torsional - self.coupling * self.coupling / self.axial
    }

    /// Moment per force, in units of r, while the ends cannot turn: over the outer diameter it is the *torque factor*.
    #[must_use]
    pub fn moment_by_force(&self) -> f64 {
        self.coupling / self.axial
    }

    /// Rotation per length per force while ends are free to turn, in rad r/B: the *unlay*, negative where it opens a right-handed lay.
    #[must_use]
    pub fn rotation_by_force(&self) -> f64 {
        -self.coupling / (self.axial * self.torsional - self.coupling * self.coupling)
    }
}

impl ExtensibleState {
    /// Rows of closed contacts, of a strain that strands do not take, and of displacements that are held, in (Θ, Y, e) with e in the
    /// units of [`Self::unit`]; and the Lagrangian's second derivatives.
    fn form(&self, clamped: Clamped) -> Restricted {
        let unit = self.unit();
        let spot = self.spot();
        let mut bends = self.slopes().bends;
        let angle = self.angle();
        let mut rows: Vec<Vector3> = Vec::new();
        let closed = match self.support {
            Support::Neighbours => [true, false],
            Support::Core => [false, true],
            Support::Both => [true, true],
            Support::Free => [false, false],
        };
        for (i, closed) in closed.into_iter().enumerate() {
            if !closed {
                continue;
            }
            let b = if i == 0 {
                obstacle::neighbours(&self.ply, angle, self.strain)
            } else {
                obstacle::core(&self.ply, angle, self.strain)
            };
            rows.push([-b.a, 1.0, -b.b * unit]);
            let share = self.shares[i];
            bends[0][0] -= share * b.aa;
            bends[0][2] -= share * b.ab;
            bends[2][0] -= share * b.ab;
            bends[2][2] -= share * b.bb;
        }
        if !self.ply.strand().stretches() {
            rows.push([0.0, 0.0, 1.0]);
        }
        if clamped.rotation {
            rows.push([0.0, 1.0, 0.0]);
        }
        if clamped.length {
            rows.push([-(1.0 + self.strain) * spot.sin, 0.0, spot.cos * unit]);
        }
        let scaled: Matrix3 = core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                let by = |k: usize| if k == 2 { unit } else { 1.0 };
                bends[i][j] * by(i) * by(j)
            })
        });
        Restricted::new(&scaled, &rows)
    }

    /// What one unit of the third variable is in strain, so that stiff strands do not drown the rest in rounding.
    fn unit(&self) -> f64 {
        if self.ply.strand().stretches() {
            1.0 / libm::sqrt(1.0_f64.max(self.ply.strand().axial_stiffness()))
        } else {
            1.0
        }
    }

    /// Whether the state comes back after a small disturbance that leaves the ply uniform, with displacements of its ends held as said;
    /// stable, too, where nothing is left free. Buckling as a whole, local loops and the collapse of a hole are not covered.
    ///
    /// Second derivatives of the energy on closed contacts, which keep their pressures; positive in every free direction.
    ///
    /// ```
    /// use nply::mechanics::{Clamped, ExtensiblePly, Load, Stability, StretchingStrand, Support, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3)?)?;
    /// let states = yarn.states(Twist::Pretwist(-0.2), Load { force: 0.05, moment: 0.0 })?;
    /// let state = states.iter().find(|s| s.support() == Support::Neighbours).expect("it holds together");
    /// assert_eq!(state.stability(Clamped::default()), Stability::Stable);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn stability(&self, clamped: Clamped) -> Stability {
        let form = self.form(clamped);
        form.least().map_or(Stability::Stable, |least| Stability::of(least, 1e2 * f64::EPSILON * form.size()))
    }

    /// Displacements of the ends per end load.
    ///
    /// `None` at a fold, where the response is unbounded.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, Load, StretchingStrand, Support, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3)?)?;
    /// let states = yarn.states(Twist::Pretwist(-0.2), Load { force: 0.05, moment: 0.0 })?;
    /// let state = states.iter().find(|s| s.support() == Support::Neighbours).expect("it holds together");
    /// let flexibility = state.flexibility().expect("no fold");
    /// assert!(flexibility.strain_by_force > 1.0 / (3.0 * 4.0)); // softer than three straight fibres side by side
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn flexibility(&self) -> Option<StretchFlexibility> {
        let n = f64::from(self.ply.strands());
        let (form, unit, spot) = (self.form(Clamped::default()), self.unit(), self.spot());
        // gradients of λ cos θ and of Y
        let length = [-(1.0 + self.strain) * spot.sin, 0.0, spot.cos * unit];
        let rotation = [0.0, 1.0, 0.0];
        let dot = |a: &Vector3, b: &Vector3| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
        let (by_force, by_moment) = (form.solve(&length)?, form.solve(&rotation)?);
        let per = 1.0 / (n * self.extension());
        Some(StretchFlexibility {
            strain_by_force: per * dot(&length, &by_force),
            coupling: self.handedness.sign() * per * dot(&rotation, &by_force),
            rotation_by_moment: per * dot(&rotation, &by_moment),
        })
    }

    /// The 2 × 2 stiffness, inverse of the [flexibility](Self::flexibility); `None` where that has no inverse: at a fold, and where closed
    /// contacts (or strands that do not stretch) leave less than two motions free.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, Load, StretchingStrand, Support, Twist};
    /// let yarn = ExtensiblePly::new(3, StretchingStrand::solid_round(0.3)?)?;
    /// let states = yarn.states(Twist::Pretwist(-0.2), Load { force: 0.05, moment: 0.0 })?;
    /// let stiffness = states[0].stiffness();
    /// assert!(stiffness.is_none_or(|s| s.axial < 3.0 * 4.0 + 1.0));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn stiffness(&self) -> Option<StretchStiffness> {
        let free = self.form(Clamped::default()).freedom();
        let f = self.flexibility().filter(|_| free >= 2)?;
        let determinant = f.strain_by_force * f.rotation_by_moment - f.coupling * f.coupling;
        let lost = determinant.abs() <= 1e3 * f64::EPSILON * (f.strain_by_force * f.rotation_by_moment).abs();
        (!lost && determinant.is_finite()).then(|| StretchStiffness {
            axial: f.rotation_by_moment / determinant,
            coupling: -f.coupling / determinant,
            torsional: f.strain_by_force / determinant,
        })
    }
}
