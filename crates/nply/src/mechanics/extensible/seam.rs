//! The seam where neighbours and core both touch: a curve over angle and strain, and every place on it where the strands are at rest.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::obstacle;
use super::ply::ExtensiblePly;
use super::reduced::{OnSurface, Reduced};
use super::state::{LEAST_STRAIN, MOST_STRAIN};
use crate::geometry::HelicalAngle;
use crate::numerics::dual::Dual;
use crate::numerics::isolate::{Basis, Pair, Panel};

/// Panels to begin with, over the angle's halves or along a stretch of the seam.
const PANELS: u32 = 4;

/// A stretch of the seam narrower than this in angle is followed by its strain, a wider one by its angle: what is followed then fixes the
/// other to 1e-10, and Newton's iteration in both does the rest.
const NARROW: f64 = 1e-6;

/// Every place on the seam at which what the ends leave free is at rest.
pub(super) fn places(reduced: &Reduced<'_>) -> Vec<(HelicalAngle, f64)> {
    let mut found = Vec::new();
    for stretch in stretches(reduced.ply) {
        let along = Along { reduced, stretch };
        let (from, to) = along.ends();
        isolate(&along, from, to, &mut |at| {
            let (theta, strain) = along.place(at);
            found.extend(settle(reduced, theta, strain));
        });
    }
    found
}

/// Angles between which the seam's strain is within what is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stretch {
    from: f64,
    to: f64,
    /// whether the strain runs from one bound to the other
    through: bool,
}

/// The seam at one strain, over the angle.
struct AtStrain<'p> {
    ply: &'p ExtensiblePly,
    strain: f64,
}

impl Basis<1> for AtStrain<'_> {
    fn at(&self, t: f64) -> [Dual; 1] {
        let seam = obstacle::seam(self.ply, HelicalAngle::steep(t), self.strain);
        [Dual::new(seam.value, seam.a)]
    }
}

/// At one angle the seam has one strain, since both radii are linear in it: it is within bounds where the seam's function has two signs there.
fn stretches(ply: &ExtensiblePly) -> Vec<Stretch> {
    // angles at which the seam has the least or the most strain, and which of the two
    let mut crossings: Vec<(f64, bool)> = Vec::new();
    let mut inside = false;
    for (strain, most) in [(LEAST_STRAIN, false), (MOST_STRAIN, true)] {
        let at = AtStrain { ply, strain };
        inside ^= at.at(0.0)[0].value > 0.0;
        for (from, to) in [(0.0, FRAC_PI_4), (FRAC_PI_4, FRAC_PI_2)] {
            isolate(&at, from, to, &mut |angle| crossings.push((angle, most)));
        }
    }
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut list = Vec::new();
    let mut entered = inside.then_some((0.0, None));
    for (angle, most) in crossings {
        entered = match entered {
            None => Some((angle, Some(most))),
            Some((from, at)) => {
                list.push(Stretch { from, to: angle, through: at == Some(!most) });
                None
            }
        };
    }
    list
}

/// A stretch of the seam, followed by its angle or, where that hardly changes, by its stretch λ = 1 + e.
struct Along<'r> {
    reduced: &'r Reduced<'r>,
    stretch: Stretch,
}

impl Along<'_> {
    fn by_strain(&self) -> bool {
        self.stretch.through && self.stretch.to - self.stretch.from < NARROW
    }

    fn ends(&self) -> (f64, f64) {
        let Stretch { from, to, .. } = self.stretch;
        if self.by_strain() { (1.0 + LEAST_STRAIN, 1.0 + MOST_STRAIN) } else { (from, to) }
    }

    /// Angle and strain, whichever is followed.
    fn place(&self, at: f64) -> (f64, f64) {
        let ply = self.reduced.ply;
        let Stretch { from, to, .. } = self.stretch;
        if !self.by_strain() {
            let seam = obstacle::seam(ply, HelicalAngle::steep(at), 0.0);
            return (at, -seam.value / seam.b);
        }
        let (mut theta, strain) = (0.5 * (from + to), at - 1.0);
        for _ in 0..4 {
            let seam = obstacle::seam(ply, HelicalAngle::steep(theta), strain);
            theta = (theta - seam.value / seam.a).max(from).min(to);
        }
        (theta, strain)
    }
}

impl Basis<1> for Along<'_> {
    fn at(&self, t: f64) -> [Dual; 1] {
        let (theta, strain) = self.place(t);
        let angle = HelicalAngle::steep(theta);
        let seam = obstacle::seam(self.reduced.ply, angle, strain);
        let [value, by_angle, by_strain] = rest(self.reduced, angle, strain);
        let slope = if self.by_strain() {
            by_strain - by_angle * seam.b / seam.a
        } else {
            by_angle - by_strain * seam.a / seam.b
        };
        [Dual::new(value, slope)]
    }
}

/// Every root between two places, none twice.
fn isolate(basis: &impl Basis<1>, from: f64, to: f64, found: &mut impl FnMut(f64)) {
    let place = |i: u32| if i == PANELS { to } else { from + (to - from) * f64::from(i) / f64::from(PANELS) };
    let pair = Pair { even: [1.0], odd: [0.0] };
    for i in 0..PANELS {
        let (start, end) = (place(i), place(i + 1));
        if start < end {
            Panel::fit(basis, start, end).roots(basis, &pair, &mut |side, root| {
                if side > 0.0 {
                    found(root.at);
                }
            });
        }
    }
}

/// What vanishes at rest on the seam, with its slopes by angle and strain: the slope of the energy along it, or the displacement held.
fn rest(reduced: &Reduced<'_>, angle: HelicalAngle, strain: f64) -> [f64; 3] {
    let lambda = 1.0 + strain;
    let b = reduced.bound(angle, strain);
    match (reduced.held.extension, reduced.held.rotation) {
        (Some(extension), _) => [lambda * angle.cos() - extension, -lambda * angle.sin(), angle.cos()],
        (_, Some(rotation)) => [b.value - rotation, b.a, b.b],
        _ => {
            // along g = 0: W_e g_θ − W_θ g_e
            let g = obstacle::seam(reduced.ply, angle, strain);
            let on = OnSurface::of(&reduced.potential.at(&Reduced::spot(angle, b.value, strain)), &b);
            [
                on.by_strain * g.a - on.by_angle * g.b,
                on.angle_strain * g.a + on.by_strain * g.aa - on.angle_angle * g.b - on.by_angle * g.ab,
                on.strain_strain * g.a + on.by_strain * g.ab - on.angle_strain * g.b - on.by_angle * g.bb,
            ]
        }
    }
}

/// Newton's iteration in angle and strain, from a place that is near already.
fn settle(reduced: &Reduced<'_>, theta: f64, strain: f64) -> Option<(HelicalAngle, f64)> {
    let (mut t, mut e) = (theta, strain);
    for _ in 0..12 {
        let angle = HelicalAngle::steep(t);
        let g = obstacle::seam(reduced.ply, angle, e);
        let second = rest(reduced, angle, e);
        let determinant = g.a * second[2] - g.b * second[1];
        let dt = (g.value * second[2] - g.b * second[0]) / determinant;
        let de = (g.a * second[0] - g.value * second[1]) / determinant;
        // both known to 1e-10 or better; a step that leads away is one at a fold, where two places are one to rounding
        let near = (t - dt - theta).abs() < NARROW && (e - de - strain).abs() < NARROW;
        if !near {
            break;
        }
        (t, e) = (t - dt, e - de);
        if dt.abs() < 1e-15 && de.abs() < 1e-15 {
            break;
        }
    }
    (t > 0.0 && t < FRAC_PI_2 && (LEAST_STRAIN..=MOST_STRAIN).contains(&e)).then(|| (HelicalAngle::steep(t), e))
}
