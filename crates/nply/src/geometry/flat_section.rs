//! The formulas in use for wires side by side, which look at a plane across the strand; to compare with.

use core::f64::consts::{PI, TAU};

use super::WireLayer;

/// What a formula in use says of a layer.
///
/// ```
/// use nply::geometry::{FitFormula, WireLay, WireLayer};
/// // seven wires alike at the lay ratio 9: the flat formula sees no overlap
/// let layer = WireLayer::on_core(6, 1.0, 1.0, WireLay::Ratio(9.0))?;
/// assert!(FitFormula::Flat.gap(&layer).abs() < 1e-15 && layer.gap() < -0.03);
/// assert!((FitFormula::Ellipse.gap(&layer) - layer.gap()).abs() < 1e-3);
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FitFormula {
    #[doc = include_str!("../equations/flat_formula.md")]
    Flat,
    #[doc = include_str!("../equations/ellipse_formula.md")]
    Ellipse,
}

impl FitFormula {
    /// Both.
    pub const BOTH: [Self; 2] = [Self::Flat, Self::Ellipse];

    /// `flat` or `ellipse`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Ellipse => "ellipse",
        }
    }

    /// The lay radius, over r, at which it has neighbours touch at a lay angle whose cosine is given.
    fn radius_ratio(self, wires: u32, cos: f64) -> f64 {
        let (sin_half, cos_half) = libm::sincos(PI / f64::from(wires));
        match self {
            Self::Flat => 1.0 / sin_half,
            Self::Ellipse => {
                let cot = if wires == 2 { 0.0 } else { cos_half / sin_half };
                libm::sqrt(1.0 + cot * cot / (cos * cos))
            }
        }
    }

    /// The gap between neighbours as laid on the core: by how much the wires could be thicker before the formula has them touch.
    #[must_use]
    pub fn gap(self, layer: &WireLayer) -> f64 {
        let touching = self.radius_ratio(layer.wires(), layer.angle().cos());
        2.0 * (layer.lay_radius() / touching - layer.wire_radius())
    }

    /// The lay radius at which neighbours touch at the layer's lay length; `None` where the formula has no such radius, though there is one.
    ///
    /// Flat: r/sin(π/n). Ellipse: with tan θ = 2πR/P in it, R = r/(sin(π/n) √(1 − (2πr cot(π/n)/P)²)).
    #[must_use]
    pub fn touching_radius(self, layer: &WireLayer) -> Option<f64> {
        let (wires, r) = (layer.wires(), layer.wire_radius());
        let (sin_half, cos_half) = libm::sincos(PI / f64::from(wires));
        let flat = r / sin_half;
        match self {
            Self::Flat => Some(flat),
            Self::Ellipse => {
                let cot = if wires == 2 { 0.0 } else { cos_half / sin_half };
                let slant = TAU * r * cot / layer.lay_length();
                (slant < 1.0).then(|| flat / libm::sqrt((1.0 - slant) * (1.0 + slant)))
            }
        }
    }
}
