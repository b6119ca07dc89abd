//! A layer of wires on a core: does it fit?

use core::f64::consts::{PI, TAU};

use super::wire_lay::POSITIVE;
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

pub(super) fn check_size(size: f64, quantity: &'static str) -> Result<(), DomainError> {
    DomainError::check(size > 0.0 && size < f64::INFINITY, quantity, size, POSITIVE)
}

/// Touching helices of n tubes of radius r with lay length P.
pub(super) fn touching(wires: u32, wire_radius: f64, lay_length: f64) -> Result<Contact, DomainError> {
    Contact::from_lay_length(wires, lay_length / wire_radius).map_err(|error| match error.quantity {
        "lay_length" => DomainError {
            value: lay_length,
            allowed: "greater than the wires' number times their diameter (more by the gap, if one is wanted), where they are flat rings on top of each other",
            ..error
        },
        _ => error,
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
        let finite = (0.0..f64::INFINITY).contains(&core_radius);
        DomainError::check(finite, "core_radius", core_radius, "finite and at least 0")?;
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

/// A strand of concentric layers, each laid on what lies below it as its wires take it.
///
/// ```
/// use nply::geometry::{WireLay, WireStrand};
/// let mut strand = WireStrand::on_core(Some(1.0))?;
/// strand.lay(6, 1.0, WireLay::Ratio(20.0))?;
/// strand.lay(12, 1.0, WireLay::Ratio(12.0))?;
/// // twelve wires on seven that overlap a little: a little more than five wire diameters
/// assert!((strand.outer_radius() - 5.0).abs() < 0.06 && strand.outer_radius() > 5.0);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WireStrand {
    core_radius: Option<f64>,
    layers: Vec<WireLayer>,
}

impl WireStrand {
    /// A core alone, or none.
    ///
    /// # Errors
    /// [`DomainError`] on `core_radius` unless at least 0; 0 is a layer on the axis.
    pub fn on_core(core_radius: Option<f64>) -> Result<Self, DomainError> {
        let radius = core_radius.unwrap_or(0.0);
        let finite = (0.0..f64::INFINITY).contains(&radius);
        DomainError::check(finite, "core_radius", radius, "finite and at least 0")?;
        Ok(Self { core_radius, layers: Vec::new() })
    }

    /// Lays one more layer on what is there.
    ///
    /// # Errors
    /// As for [`WireLayer::on_core`].
    pub fn lay(&mut self, wires: u32, wire_radius: f64, lay: WireLay) -> Result<WireLayer, DomainError> {
        let below = self.layers.last().map(WireLayer::taken_outer_radius).or(self.core_radius);
        let layer = match below {
            Some(below) => WireLayer::on_core(wires, wire_radius, below, lay)?,
            None => WireLayer::without_core(wires, wire_radius, lay)?,
        };
        self.layers.push(layer);
        Ok(layer)
    }

    /// The layers, from the inside.
    #[must_use]
    pub fn layers(&self) -> &[WireLayer] {
        &self.layers
    }

    /// The radius of the core; `None` where there is none.
    #[must_use]
    pub const fn core_radius(&self) -> Option<f64> {
        self.core_radius
    }

    /// The radius of the circle round all of it.
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        self.layers.last().map(WireLayer::taken_outer_radius).or(self.core_radius).unwrap_or(0.0)
    }

    /// The true sections of core and wires in a plane across the strand.
    #[must_use]
    pub fn metal_area(&self) -> f64 {
        let core = self.core_radius.unwrap_or(0.0);
        self.layers.iter().map(WireLayer::metal_area).fold(PI * core * core, |sum, area| sum + area)
    }

    /// [`metal_area`](Self::metal_area) over the circle that encloses the strand; 0 of nothing.
    #[must_use]
    pub fn fill_factor(&self) -> f64 {
        let outer = self.outer_radius();
        if outer > 0.0 { self.metal_area() / (PI * outer * outer) } else { 0.0 }
    }
}
