//! The loads under which a core and the neighbours both carry.

use super::{check_core, core_contact};
use crate::geometry::HelicalAngle;
use crate::mechanics::{Load, Ply, Twist};
use crate::{DomainError, Handedness};

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

impl Ply {
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
        let Some(contact) = core_contact(self.strands(), rho) else { return Ok(None) };
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
}
