//! A layer of wires on a core: does it fit?

use core::f64::consts::{PI, TAU};

use super::{Contact, HelicalAngle, WireLay, check_strands};
use crate::DomainError;

/// n wires of radius r laid side by side on a core of radius R_c, with lay length P.
///
/// Lengths are in any unit, the same for all. The core is what lies below: a king wire, or the strand of the layers inside.
/// Wires *as laid on the core* have the lay radius R = R_c + r; where they would then overlap, they cannot lie on it: they
/// *take* the lay radius at which they just touch each other, at the same lay length, and the core lies loose inside.
///
/// ```
/// use nply::geometry::{LayerContact, WireLay, WireLayer};
/// // core 3.94 mm, wires 6 × 3.73 mm, lay length 115 mm: it fits
/// let layer = WireLayer::on_core(6, 1.865, 1.97, WireLay::Length(115.0))?;
/// assert_eq!(layer.contact(), LayerContact::Core);
/// assert!((layer.angle().degrees() - 11.8340).abs() < 5e-5);
/// assert!((layer.gap() - 0.04274).abs() < 5e-6);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WireLayer {
    wire_radius: f64,
    core_radius: f64,
    lay_length: f64,
    /// on the core
    lay_radius: f64,
    angle: HelicalAngle,
    gap: f64,
    touching: Contact,
}

/// What the wires of a layer lie on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LayerContact {
    /// The core: there is a gap between neighbours.
    Core,
    /// Each other: they would overlap on the core, which lies loose.
    Neighbours,
    /// Core and neighbours, to within rounding.
    Both,
}

impl LayerContact {
    /// `core`, `neighbours` or `both`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Core => "core",
            Self::Neighbours => "neighbours",
            Self::Both => "both",
        }
    }
}

/// A gap that is smaller than this share of the lay radius is rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// What lay length n wires take.
const RINGS: &str = "greater than the wires' number times their diameter (and a gap that is wanted), where they are flat rings on top of each other";

const LARGEST: f64 = 1e100;

pub(super) fn check_size(size: f64, quantity: &'static str) -> Result<(), DomainError> {
    // areas and their sums are numbers, too
    let allowed = "greater than 0 (at least 1e-100) and at most 1e100";
    DomainError::check((1e-100..=LARGEST).contains(&size), quantity, size, allowed)
}

pub(super) fn check_core(radius: f64) -> Result<(), DomainError> {
    DomainError::check((0.0..=LARGEST).contains(&radius), "core_radius", radius, "at least 0 and at most 1e100")
}

/// Touching helices of n tubes of radius r with lay length P.
pub(super) fn touching(wires: u32, wire_radius: f64, lay_length: f64) -> Result<Contact, DomainError> {
    let ratio = lay_length / wire_radius;
    Contact::from_lay_length(wires, ratio).map_err(|error| {
        let error =
            DomainError { value: if error.quantity == "lay_length" { lay_length } else { error.value }, ..error };
        // what is too long says so itself
        if ratio <= 3.0 * f64::from(wires) { DomainError { allowed: RINGS, ..error } } else { error }
    })
}

impl WireLayer {
    /// On a core of radius R_c ≥ 0; 0 is none, the wires lie on the axis.
    ///
    /// # Errors
    /// [`DomainError`] on `strands` unless n ≥ 2, on `wire_radius` unless greater than 0, on `core_radius` unless at least 0, on the lay
    /// unless P > 2nr: n flat rings on top of each other need as much, so that no wires take a shorter lay.
    pub fn on_core(wires: u32, wire_radius: f64, core_radius: f64, lay: WireLay) -> Result<Self, DomainError> {
        check_strands(wires)?;
        check_size(wire_radius, "wire_radius")?;
        check_core(core_radius)?;
        let lay_radius = core_radius + wire_radius;
        let lay_length = lay.length(lay_radius, wire_radius)?;
        let within = lay_radius <= 1e140 * lay_length; // the square of a flatter angle would be no number
        DomainError::check(within, "core_radius", core_radius, "within 140 orders of magnitude of the lay length")?;
        let touching = touching(wires, wire_radius, lay_length)?;
        let angle = HelicalAngle::of_tangent(TAU * lay_radius, lay_length);
        let at_angle = Contact::at(wires, angle);
        let gap = 2.0 * (lay_radius / at_angle.radius_ratio() - wire_radius);
        Ok(Self { wire_radius, core_radius, lay_length, lay_radius, angle, gap, touching })
    }

    /// With nothing inside: the wires touch each other.
    ///
    /// ```
    /// use nply::geometry::{LayerContact, WireLay, WireLayer};
    /// let three = WireLayer::without_core(3, 1.0, WireLay::Angle(0.2))?;
    /// assert_eq!((three.contact(), three.gap()), (LayerContact::Neighbours, 0.0));
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`on_core`](Self::on_core).
    pub fn without_core(wires: u32, wire_radius: f64, lay: WireLay) -> Result<Self, DomainError> {
        check_strands(wires)?;
        check_size(wire_radius, "wire_radius")?;
        let touching = match lay.checked()? {
            WireLay::Length(length) => touching(wires, wire_radius, length)?,
            WireLay::Ratio(ratio) => Contact::from_lay_ratio(wires, ratio)?,
            WireLay::Angle(theta) => Contact::new(wires, theta)?,
        };
        let lay_length = match lay {
            WireLay::Length(length) => length,
            _ => touching.lay_length() * wire_radius,
        };
        let lay_radius = touching.radius_ratio() * wire_radius;
        DomainError::check(lay_radius <= LARGEST, "lay_radius", lay_radius, "at most 1e100")?;
        let angle = touching.angle();
        Ok(Self { wire_radius, core_radius: 0.0, lay_length, lay_radius, angle, gap: 0.0, touching })
    }

    /// n.
    #[must_use]
    pub const fn wires(&self) -> u32 {
        self.touching.strands()
    }

    /// r.
    #[must_use]
    pub const fn wire_radius(&self) -> f64 {
        self.wire_radius
    }

    /// R_c; 0 where there is none.
    #[must_use]
    pub const fn core_radius(&self) -> f64 {
        self.core_radius
    }

    /// P, the same as laid and as taken.
    #[must_use]
    pub const fn lay_length(&self) -> f64 {
        self.lay_length
    }

    /// R = R_c + r, as laid on the core.
    #[must_use]
    pub const fn lay_radius(&self) -> f64 {
        self.lay_radius
    }

    /// θ = arctan(2πR/P), as laid on the core.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.angle
    }

    #[doc = include_str!("../equations/wire_gap.md")]
    ///
    /// As laid on the core; negative: the wires would overlap.
    #[must_use]
    pub const fn gap(&self) -> f64 {
        self.gap
    }

    /// What the wires lie on.
    #[must_use]
    pub fn contact(&self) -> LayerContact {
        if self.core_radius == 0.0 && self.gap <= ROUNDING * self.lay_radius {
            LayerContact::Neighbours // nothing else is there
        } else if self.gap.abs() <= ROUNDING * self.lay_radius {
            LayerContact::Both
        } else if self.gap > 0.0 {
            LayerContact::Core
        } else {
            LayerContact::Neighbours
        }
    }

    /// The wires as they just touch each other at this lay length, in units of r.
    #[must_use]
    pub const fn touching(&self) -> Contact {
        self.touching
    }

    /// The lay radius at which neighbours just touch at this lay length.
    #[must_use]
    pub fn touching_radius(&self) -> f64 {
        self.touching.radius_ratio() * self.wire_radius
    }

    /// The radius of the core on which neighbours just touch at this lay length; 0 for two wires up to 45°.
    #[must_use]
    pub fn king_wire_radius(&self) -> f64 {
        self.touching.hole_radius() * self.wire_radius
    }

    /// Whether the wires lie where they were laid, and do not overlap there.
    #[must_use]
    pub fn lies_on_core(&self) -> bool {
        self.contact() != LayerContact::Neighbours
    }

    /// The lay radius that the wires take: R, or where they would overlap that at which they touch.
    #[must_use]
    pub fn taken_radius(&self) -> f64 {
        if self.lies_on_core() { self.lay_radius } else { self.touching_radius() }
    }

    /// The lay angle that the wires take.
    #[must_use]
    pub fn taken_angle(&self) -> HelicalAngle {
        if self.lies_on_core() { self.angle } else { self.touching.angle() }
    }

    /// The radius of the circle round the layer as the wires take it.
    #[must_use]
    pub fn taken_outer_radius(&self) -> f64 {
        self.taken_radius() + self.wire_radius
    }

    /// The clearance between the core and the wires that lie on each other; 0 on the core.
    #[must_use]
    pub fn core_gap(&self) -> f64 {
        if self.lies_on_core() { 0.0 } else { (self.king_wire_radius() - self.core_radius).max(0.0) }
    }

    /// Wire length over strand length, 1/cos θ, as taken.
    #[must_use]
    pub fn wire_length_ratio(&self) -> f64 {
        1.0 / self.taken_angle().cos()
    }

    /// The wires' sections in a plane across the strand, nπr²/cos θ, as taken: exact for tubes of round section, whose volume is
    /// their section times the length of their centreline (Pappus).
    #[must_use]
    pub fn metal_area(&self) -> f64 {
        f64::from(self.wires()) * PI * self.wire_radius * self.wire_radius * self.wire_length_ratio()
    }
}
