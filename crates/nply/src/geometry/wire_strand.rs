//! Layers of wires on layers.

use core::f64::consts::PI;

use super::wire_layer::check_core;
use super::{WireLay, WireLayer};
use crate::DomainError;

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
        check_core(radius)?;
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

    /// Σ n π r²: the sections of core and wires, each square to itself, as strength tables count.
    #[must_use]
    pub fn wire_section_area(&self) -> f64 {
        let round = |radius: f64| PI * radius * radius;
        let core = round(self.core_radius.unwrap_or(0.0));
        self.layers
            .iter()
            .map(|layer| f64::from(layer.wires()) * round(layer.wire_radius()))
            .fold(core, |sum, area| sum + area)
    }

    /// [`wire_section_area`](Self::wire_section_area) over the circle that encloses the strand (EN 12385-2, 3.10.1, which takes the circle of the nominal
    /// diameter); 0 of nothing.
    #[must_use]
    pub fn fill_factor(&self) -> f64 {
        let outer = self.outer_radius();
        if outer > 0.0 { self.wire_section_area() / (PI * outer * outer) } else { 0.0 }
    }
}
