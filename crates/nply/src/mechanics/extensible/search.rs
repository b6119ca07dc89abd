//! Every state of strands that stretch, on each support.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::grips::{Axial, Grips, Turning};
use super::obstacle;
use super::ply::ExtensiblePly;
use super::potential::Potential;
use super::reduced::{Held, Here, Reduced};
use super::seam;
use super::state::{ExtensibleState, LEAST_STRAIN, MOST_STRAIN, beyond};
use crate::geometry::{Contact, HelicalAngle, SpecialLays};
use crate::mechanics::{Load, Support, Twist};
use crate::numerics::columns::combination;
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};
use crate::{DomainError, Handedness};

impl ExtensiblePly {
    /// Every state in which all closed contacts push: touching neighbours, on the core, on both, or free, each hand; right-handed
    /// first, then by angle. With `grips` loads or displacements are given, along and around by themselves.
    ///
    /// Each support is searched along the whole range of angles with strain and rotation eliminated, by the same isolation of roots as
    /// for strands that do not stretch; where both contacts are closed, along the strain. Strains between −1/2 and 1 are looked at.
    ///
    /// # Errors
    /// [`DomainError`] unless twist and grips are finite, the displacements can be those of a ply, and the loads stretch strands to no
    /// less than half and no more than double their length whatever their angle.
    ///
    /// ```
    /// use nply::mechanics::{ExtensiblePly, FormedLay, Load, StretchingStrand, Support, Twist, WorkingCore};
    /// use nply::{Handedness, geometry::HelicalAngle};
    /// // a seven-wire strand, stress-free in its lay, pulled: the wires lie on the king wire
    /// let lay = FormedLay {
    ///     handedness: Handedness::Right,
    ///     angle: HelicalAngle::new(8_f64.to_radians())?,
    ///     radius_ratio: 2.05,
    ///     preforming: 1.0,
    /// };
    /// let strand = ExtensiblePly::new(6, StretchingStrand::solid_round(0.3)?)?
    ///     .with_core(WorkingCore::new(1.05, 4.41, 0.935, 0.3)?)?
    ///     .formed_in(lay)?;
    /// let states = strand.states(Twist::Pretwist(0.0), Load { force: 0.01, moment: 0.0 })?;
    /// let state = states.iter().find(|s| s.support() == Support::Core).expect("on the core");
    /// assert!(state.core_pressure() > 0.0 && state.strain() > 0.0);
    /// assert!(state.angle().radians() < lay.angle.radians()); // free ends unlay
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn states(&self, twist: Twist, grips: impl Into<Grips>) -> Result<Vec<ExtensibleState>, DomainError> {
        let grips = grips.into();
        let (Twist::Pretwist(given) | Twist::StrandTwist(given)) = twist;
        DomainError::check(given.is_finite(), "twist", given, "finite")?;
        grips.check(self.strand().stretches())?;
        let mut states = Vec::new();
        for hand in Handedness::BOTH {
            if matches!(grips.turning, Turning::Rotation(rotation) if rotation * hand.sign() < 0.0) {
                continue;
            }
            let search = Search::new(self, hand, twist, grips);
            search.along(Support::Neighbours, &mut states)?;
            if self.core().is_some() {
                search.along(Support::Core, &mut states)?;
                search.on_both(&mut states);
            }
            search.along(Support::Free, &mut states)?;
        }
        states.sort_by(ExtensibleState::in_order);
        Ok(states)
    }
}

/// One hand.
#[derive(Clone, Copy)]
pub(super) struct Search<'p> {
    ply: &'p ExtensiblePly,
    hand: Handedness,
    twist: Twist,
    load: Load,
    held: Held,
}

/// The residual by helical angle, or by pitch angle.
struct Chart<'r> {
    reduced: &'r Reduced<'r>,
    flat: bool,
}

impl Chart<'_> {
    fn angle(&self, t: f64) -> HelicalAngle {
        // π/4 itself belongs to the steep half, so that both see the same numbers on their common border
        if self.flat && t < FRAC_PI_4 {
            HelicalAngle::flat(t.max(HelicalAngle::FLATTEST))
        } else {
            HelicalAngle::steep(t)
        }
    }
}

impl Basis<1> for Chart<'_> {
    fn at(&self, t: f64) -> [Dual; 1] {
        let here = at_angle(self.reduced, self.angle(t));
        let residual = here.map_or(Dual::new(f64::NAN, f64::NAN), |here| here.residual);
        [if self.flat { Dual::new(residual.value, -residual.slope) } else { residual }]
    }
}

fn at_angle(reduced: &Reduced<'_>, angle: HelicalAngle) -> Option<Here> {
    match reduced.support {
        Support::Free => Some(reduced.free(angle)),
        _ => reduced.on_contact(angle),
    }
}

impl<'p> Search<'p> {
    pub(super) fn new(ply: &'p ExtensiblePly, hand: Handedness, twist: Twist, grips: Grips) -> Self {
        let held = Held {
            extension: match grips.axial {
                Axial::Extension(extension) => Some(extension),
                Axial::Force(_) => None,
            },
            rotation: match grips.turning {
                Turning::Rotation(rotation) => Some(rotation.abs()),
                Turning::Moment(_) => None,
            },
        };
        Self { ply, hand, twist, load: grips.given(), held }
    }

    fn reduced(&self, support: Support) -> Reduced<'_> {
        let potential = Potential::new(self.ply, self.hand, self.twist, self.load);
        Reduced { ply: self.ply, potential, held: self.held, support }
    }

    fn along(&self, support: Support, states: &mut Vec<ExtensibleState>) -> Result<(), DomainError> {
        let reduced = self.reduced(support);
        let mut angles = Vec::new();
        let held = self.held;
        if !self.ply.strand().stretches()
            && (held.extension.is_some() || support != Support::Free && held.rotation.is_some())
        {
            // what is held fixes the angle
            angles = self.fixed_angles(support);
        } else {
            if support != Support::Free && held.extension.is_none() && held.rotation.is_none() {
                self.check_stretch(&reduced)?;
            }
            for (from, to) in self.stretches_of_angle(&reduced) {
                roots(&reduced, from, to, &mut angles);
            }
        }
        for angle in angles {
            if let Some(here) = at_angle(&reduced, angle) {
                self.keep(support, angle, here.rotation, here.strain, states);
            }
        }
        Ok(())
    }

    /// Angles at which strands that do not stretch have the displacement that is held.
    fn fixed_angles(&self, support: Support) -> Vec<HelicalAngle> {
        let n = self.ply.strands();
        match (self.held.extension, self.held.rotation, support) {
            (Some(extension), ..) => vec![HelicalAngle::of_cosine(extension)],
            (_, Some(rotation), Support::Core) => {
                let sin = rotation * (1.0 + self.ply.core().map_or(f64::NAN, |core| core.radius()));
                if sin < 1.0 { vec![HelicalAngle::of_sine(sin)] } else { Vec::new() }
            }
            (_, Some(rotation), _) => {
                Contact::from_rotation(n, rotation).map_or(Vec::new(), |both| both.map(|c| c.angle()).into())
            }
            _ => Vec::new(),
        }
    }

    /// Under dead loads the stretch must lie within what is looked at, at every angle.
    fn check_stretch(&self, reduced: &Reduced<'_>) -> Result<(), DomainError> {
        const LOOKS: u32 = 32;
        for i in 0..=LOOKS {
            let t = FRAC_PI_2 * f64::from(i) / f64::from(LOOKS);
            let angle = if i == LOOKS { HelicalAngle::flat(HelicalAngle::FLATTEST) } else { HelicalAngle::steep(t) };
            if reduced.strain_on_surface(angle).is_none() {
                return Err(beyond(self.load.force));
            }
        }
        Ok(())
    }

    /// The ranges of θ over which strains lie within what is looked at.
    fn stretches_of_angle(&self, reduced: &Reduced<'_>) -> Vec<(HelicalAngle, HelicalAngle)> {
        let ends = (HelicalAngle::steep(0.0), HelicalAngle::flat(HelicalAngle::FLATTEST));
        let (straight, flat) = ends;
        let mut ranges = vec![ends];
        if let Some(extension) = self.held.extension {
            let at = |strain: f64| {
                let cos = extension / (1.0 + strain);
                if cos >= 1.0 { straight } else { HelicalAngle::of_cosine(cos) }
            };
            ranges = vec![(at(LEAST_STRAIN), at(MOST_STRAIN))];
        } else if let (Some(rotation), true) = (self.held.rotation, reduced.support != Support::Free) {
            // Y at a given strain grows with θ up to its greatest, and falls beyond it where neighbours touch
            let top = match reduced.support {
                Support::Core => flat,
                _ => SpecialLays::of(self.ply.strands()).map_or(flat, |lays| lays.zero_twist().angle()),
            };
            let bound = |angle, strain| reduced.bound(angle, strain).value;
            let met =
                |from: HelicalAngle, to: HelicalAngle, strain: f64| crossing(from, to, |a| bound(a, strain) - rotation);
            ranges.clear();
            if let Some(first) = met(straight, top, MOST_STRAIN) {
                let most = met(straight, top, LEAST_STRAIN);
                match (reduced.support, most) {
                    (Support::Core, most) => ranges.push((first, most.unwrap_or(flat))),
                    (_, None) => ranges.push((first, met(top, flat, MOST_STRAIN).unwrap_or(flat))),
                    (_, Some(most)) => {
                        ranges.push((first, most));
                        let again = met(top, flat, LEAST_STRAIN).unwrap_or(top);
                        ranges.push((again, met(top, flat, MOST_STRAIN).unwrap_or(flat)));
                    }
                }
            }
        }
        ranges.retain(|(from, to)| from.radians() < to.radians());
        ranges
    }

    /// Neighbours and core both touch: along the seam of both.
    fn on_both(&self, states: &mut Vec<ExtensibleState>) {
        let reduced = self.reduced(Support::Neighbours);
        let Some(core) = self.ply.core() else { return };
        if !self.ply.strand().stretches() {
            // one angle alone, at any loads; a displacement that is held would have to be just that of this angle
            if let Ok(start) = Contact::from_radius_ratio(self.ply.strands(), 1.0 + core.radius())
                && start.shift_ratio_squared() > 0.0
                && self.held.extension.is_none()
                && self.held.rotation.is_none()
            {
                self.keep(Support::Both, start.angle(), reduced.bound(start.angle(), 0.0).value, 0.0, states);
            }
            return;
        }
        if self.held.extension.is_some() && self.held.rotation.is_some() {
            return; // two contacts and two displacements ask for more than three unknowns can give
        }
        for (angle, strain) in seam::places(&reduced) {
            self.keep(Support::Both, angle, reduced.bound(angle, strain).value, strain, states);
        }
    }

    /// The state at a place, if its contacts push and nothing else is in the way.
    fn keep(
        &self,
        support: Support,
        angle: HelicalAngle,
        rotation: f64,
        strain: f64,
        states: &mut Vec<ExtensibleState>,
    ) {
        let clear = |other: f64| rotation <= other;
        let neighbours = || obstacle::neighbours(self.ply, angle, strain).value;
        let core = || self.ply.core().map_or(f64::INFINITY, |_| obstacle::core(self.ply, angle, strain).value);
        let free_of_others = match support {
            Support::Neighbours => clear(core()),
            Support::Core => rotation < neighbours(),
            Support::Both => true,
            Support::Free => clear(neighbours()) && clear(core()),
        };
        let shape = rotation > 0.0 && rotation.is_finite() && angle.sin() > 0.0;
        if !(shape && free_of_others && (LEAST_STRAIN..=MOST_STRAIN).contains(&strain)) {
            return;
        }
        if let Some(state) = self.state(support, angle, rotation, strain)
            && state.shares.iter().all(|share| *share >= 0.0)
        {
            states.push(state);
        }
    }

    /// The loads that are found, and what the contacts carry: E_Y = −Σμ, E_θ = Σμ ∂b/∂θ, E_e = Σμ ∂b/∂e.
    pub(super) fn state(
        &self,
        support: Support,
        angle: HelicalAngle,
        rotation: f64,
        strain: f64,
    ) -> Option<ExtensibleState> {
        let (n, eps) = (f64::from(self.ply.strands()), self.hand.sign());
        let (s, c, lambda) = (angle.sin(), angle.cos(), 1.0 + strain);
        let spot = Reduced::spot(angle, rotation, strain);
        let potential = Potential::new(self.ply, self.hand, self.twist, self.load);
        let [by_angle, by_rotation, by_strain] = potential.at(&spot).by;
        let bounds = match support {
            Support::Neighbours => vec![obstacle::neighbours(self.ply, angle, strain)],
            Support::Core => vec![obstacle::core(self.ply, angle, strain)],
            Support::Both => {
                vec![obstacle::neighbours(self.ply, angle, strain), obstacle::core(self.ply, angle, strain)]
            }
            Support::Free => Vec::new(),
        };
        // unknown: μ of each contact, F where the length is held, M where the rotation is
        let mut columns: Vec<[f64; 3]> = bounds.iter().map(|b| [b.a, -1.0, b.b]).collect();
        if self.held.extension.is_some() {
            columns.push([-lambda * s, 0.0, c]);
        }
        if self.held.rotation.is_some() {
            columns.push([0.0, 1.0, 0.0]);
        }
        let rows = if potential.stretches() { 3 } else { 2 };
        let found = combination(&columns, [by_angle, by_rotation, by_strain], rows)?;
        let mut found = found.into_iter();
        let mut shares: Vec<f64> = bounds.iter().map(|_| found.next().unwrap_or(0.0)).collect();
        let mut load = self.load;
        if self.held.extension.is_some() {
            load.force = n * found.next()?;
        }
        if self.held.rotation.is_some() {
            load.moment = eps * n * found.next()?;
        }
        // what is nothing but rounding of the terms that cancel presses with nothing
        let size = potential.at(&spot).rotation_size;
        for share in &mut shares {
            if share.abs() <= 4.0 * f64::EPSILON * size {
                *share = 0.0;
            }
        }
        let shares = match (support, &shares[..]) {
            (Support::Neighbours, [neighbours]) => [*neighbours, 0.0],
            (Support::Core, [core]) => [0.0, *core],
            (Support::Both, [neighbours, core]) => [*neighbours, *core],
            _ => [0.0; 2],
        };
        Some(ExtensibleState {
            ply: *self.ply,
            support,
            handedness: self.hand,
            touching: Contact::at(self.ply.strands(), angle),
            turn: rotation,
            strain,
            twist: self.twist,
            load,
            shares,
        })
    }
}

/// Where a function of the angle that rises or falls from one end to the other vanishes; `None` where it has one sign.
fn crossing(from: HelicalAngle, to: HelicalAngle, f: impl Fn(HelicalAngle) -> f64) -> Option<HelicalAngle> {
    let (at_from, at_to) = (f(from), f(to));
    if at_from * at_to > 0.0 {
        return None;
    }
    // by pitch angle, which keeps both ends apart from the right angle
    let (mut a, mut b) = (from, to);
    for _ in 0..200 {
        let pitch = 0.5 * (a.pitch_angle() + b.pitch_angle());
        let middle = if pitch > FRAC_PI_4 {
            HelicalAngle::steep(0.5 * (a.radians() + b.radians()))
        } else {
            HelicalAngle::flat(pitch)
        };
        if middle.pitch_angle() >= a.pitch_angle() || middle.pitch_angle() <= b.pitch_angle() {
            break;
        }
        if (f(middle) > 0.0) == (at_from > 0.0) {
            a = middle;
        } else {
            b = middle;
        }
    }
    Some(b)
}

/// Every root of the residual between two angles.
fn roots(reduced: &Reduced<'_>, from: HelicalAngle, to: HelicalAngle, found: &mut Vec<HelicalAngle>) {
    const PANELS: u32 = 3;
    let pair = Pair { even: [1.0], odd: [0.0] };
    let mut search = |flat: bool, start: f64, end: f64| {
        if end.partial_cmp(&start) != Some(core::cmp::Ordering::Greater) {
            return;
        }
        let chart = Chart { reduced, flat };
        let place = |i: u32| if i == PANELS { end } else { start + (end - start) * f64::from(i) / f64::from(PANELS) };
        for i in 0..PANELS {
            let panel = Panel::fit(&chart, place(i), place(i + 1));
            panel.roots(&chart, &pair, &mut |side, root| {
                if side > 0.0 && (!flat || root.at >= HelicalAngle::FLATTEST) {
                    found.push(chart.angle(root.at));
                }
            });
        }
    };
    let (low, high) = (from.radians(), to.radians());
    search(false, low, high.min(FRAC_PI_4));
    if high > FRAC_PI_4 {
        let end = if low < FRAC_PI_4 { FRAC_PI_4 } else { from.pitch_angle() };
        let start = if to.pitch_angle() <= HelicalAngle::FLATTEST { 0.0 } else { to.pitch_angle() };
        search(true, start, end);
    }
}
