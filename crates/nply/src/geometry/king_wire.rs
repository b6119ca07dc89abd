//! What is asked the other way round: the core, the lay or the wires for a gap that is wanted.

use core::f64::consts::PI;

use super::lay::where_rising;
use super::wire_layer::{check_size, touching};
use super::{Contact, WireLay, WireLayer, check_strands};
use crate::DomainError;

// Wires of radius r with a gap g between them lie as touching wires of radius r + g/2 do.

fn thickened(wire_radius: f64, gap: f64) -> Result<f64, DomainError> {
    DomainError::check((0.0..f64::INFINITY).contains(&gap), "gap", gap, "finite and at least 0")?;
    Ok(wire_radius + 0.5 * gap)
}

impl WireLayer {
    /// The radius of the core on which neighbours have the gap g at this lay length. There is one at most: the gap grows with the core.
    ///
    /// # Errors
    /// [`DomainError`] on `gap` unless at least 0, on `lay_length` unless greater than n(2r + g), where wires with this gap are flat rings on
    /// top of each other: no core gives a larger gap.
    ///
    /// ```
    /// use nply::geometry::{WireLay, WireLayer};
    /// let layer = WireLayer::on_core(6, 1.0, 1.0, WireLay::Length(40.0))?;
    /// let core = layer.king_wire_radius_for(0.05)?;
    /// assert!((WireLayer::on_core(6, 1.0, core, WireLay::Length(40.0))?.gap() - 0.05).abs() < 1e-14);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn king_wire_radius_for(&self, gap: f64) -> Result<f64, DomainError> {
        let thick = thickened(self.wire_radius(), gap)?;
        // r′ρ − r = r′(ρ − 1) + g/2
        Ok(touching(self.wires(), thick, self.lay_length())?.hole_radius() * thick + 0.5 * gap)
    }

    /// The layer of n wires of radius r with the gap g between neighbours, on the core that this asks for.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, `wire_radius`, `gap`, and on a lay too short for wires with this gap.
    ///
    /// ```
    /// use nply::geometry::{WireLay, WireLayer};
    /// let layer = WireLayer::on_king_wire(6, 1.865, 0.05, WireLay::Ratio(10.0))?;
    /// assert!((layer.gap() - 0.05).abs() < 1e-14);
    /// assert!((layer.lay_length() / (2.0 * (layer.lay_radius() + 1.865)) - 10.0).abs() < 1e-14);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn on_king_wire(wires: u32, wire_radius: f64, gap: f64, lay: WireLay) -> Result<Self, DomainError> {
        check_strands(wires)?;
        check_size(wire_radius, "wire_radius")?;
        let thick = thickened(wire_radius, gap)?;
        let contact = match lay.checked()? {
            WireLay::Length(length) => touching(wires, thick, length)?,
            WireLay::Angle(theta) => Contact::new(wires, theta)?,
            WireLay::Ratio(ratio) => {
                let allowed = "within 140 orders of magnitude of 1";
                DomainError::check((1e-140..=1e140).contains(&ratio), "lay_ratio", ratio, allowed)?;
                // π over the ratio of 2πρr′/tan θ to 2(ρr′ + r)
                where_rising(wires, PI / ratio, |at| {
                    at.sin * (at.cos.recip() + (wire_radius / thick) * at.radius.recip())
                })
            }
        };
        let core_radius = contact.hole_radius() * thick + 0.5 * gap;
        let lay_length = if let WireLay::Length(length) = lay { length } else { contact.lay_length() * thick };
        Self::on_core(wires, wire_radius, core_radius, WireLay::Length(lay_length))
    }

    /// The layer of n wires of radius r on a core of radius R_c whose lay length leaves the gap g between neighbours: 0, they just touch.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, `wire_radius`, `gap`, and on `core_radius` unless straight wires leave more than this gap on it: laid, they
    /// leave less.
    ///
    /// ```
    /// use nply::geometry::WireLayer;
    /// let layer = WireLayer::with_gap(6, 1.865, 1.97, 0.0)?; // core 3.94, wires 3.73 mm
    /// assert!((layer.angle().degrees() - 15.2963).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn with_gap(wires: u32, wire_radius: f64, core_radius: f64, gap: f64) -> Result<Self, DomainError> {
        check_strands(wires)?;
        check_size(wire_radius, "wire_radius")?;
        let thick = thickened(wire_radius, gap)?;
        let lay_radius = core_radius + wire_radius;
        let contact = Contact::from_radius_ratio(wires, lay_radius / thick)
            .ok()
            .filter(|contact| contact.angle().radians() > 0.0);
        let Some(contact) = contact else {
            let allowed = "so large that straight wires leave more than the gap that is wanted: laid, they come closer";
            return Err(DomainError { quantity: "core_radius", value: core_radius, allowed });
        };
        Self::on_core(wires, wire_radius, core_radius, WireLay::Length(contact.lay_length() * thick))
    }

    /// The layer of n wires, of whatever radius, that has the outer radius R + r and the gap g between neighbours; its core has the
    /// radius that this asks for.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, `outer_radius`, `gap`, the lay, and on `gap` where it leaves no room for wires.
    ///
    /// ```
    /// use nply::geometry::{WireLay, WireLayer};
    /// let layer = WireLayer::in_outer_radius(6, 6.35, 0.0, WireLay::Ratio(14.0))?; // half an inch across
    /// assert!((2.0 * layer.wire_radius() - 4.2096).abs() < 5e-5 && (2.0 * layer.core_radius() - 4.2808).abs() < 5e-5);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn in_outer_radius(wires: u32, outer_radius: f64, gap: f64, lay: WireLay) -> Result<Self, DomainError> {
        check_strands(wires)?;
        check_size(outer_radius, "outer_radius")?;
        let outside = thickened(outer_radius, gap)?; // R + r′
        let contact = match lay.checked()? {
            WireLay::Angle(theta) => Contact::new(wires, theta)?,
            other => Contact::from_lay_ratio(wires, 0.5 * other.length(outer_radius, 0.0)? / outside)?,
        };
        let thick = outside / contact.outer_radius();
        let wire_radius = thick - 0.5 * gap;
        DomainError::check(wire_radius > 0.0, "gap", gap, "smaller: it leaves no room for wires")?;
        let core_radius = contact.hole_radius() * thick + 0.5 * gap;
        Self::on_core(wires, wire_radius, core_radius, WireLay::Length(contact.lay_length() * thick))
    }
}
