//! Cables: a core and concentric layers of wires or strands, each with its own hand and lay, coupled by strain and turning.

mod deformed;
mod design;
mod layer;
mod lift;
mod rod;
mod shared;
mod state;

pub use layer::{Layer, LayerSupport};
pub use lift::{LetsGo, LiftOff};
pub use rod::Rod;
pub use state::{CableGrips, CableState, LayerState};

use super::extensible::StretchStiffness;
use crate::geometry::WireStrand;
use crate::{DomainError, Handedness};
use layer::Laid;

/// A straight core, or none, and layers laid on it one after the other, in any consistent units of length and force.
///
/// Each layer lies on what is below, or, where its rods would overlap there, on its neighbours, at its own lay length; stress-free in that lay
/// as far as it is preformed. Layers share the cable's strain and turning (per cable length), as section 7 of the paper proposes; each is a set of
/// rods that stretch, bend, twist and thin without friction. Not in it: flattening where rods cross (point contacts between layers count as
/// evenly spread), friction, plasticity, bending of the cable.
///
/// ```
/// use nply::mechanics::{Cable, Layer, Rod};
/// use nply::{Handedness, geometry::WireLay};
/// // a seven-wire strand in N and mm: king wire 5.2, six wires of 5, lay length 220
/// let six = Layer {
///     strands: 6,
///     rod: Rod::solid_round(2.5, 200e3, 0.3)?,
///     handedness: Handedness::Left,
///     lay: WireLay::Length(220.0),
///     preforming: 1.0,
///     pretwist: 0.0,
/// };
/// let strand = Cable::new(Some(Rod::solid_round(2.6, 200e3, 0.3)?), &[six])?;
/// let stiffness = strand.laid()?.stiffness().expect("it resists");
/// let sum = 200e3 * strand.metal_area();
/// assert!(stiffness.axial < sum && stiffness.axial > 0.95 * sum && stiffness.coupling < 0.0); // left-handed
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cable {
    core: Option<Rod>,
    layers: Vec<Laid>,
}

impl Cable {
    /// From the inside out.
    ///
    /// # Errors
    /// [`DomainError`] unless there is a layer, and on any layer that cannot be laid: fewer than two rods, a lay length no such layer can
    /// have, preforming outside 0 to 1, a pretwist that is not finite.
    pub fn new(core: Option<Rod>, layers: &[Layer]) -> Result<Self, DomainError> {
        DomainError::check(!layers.is_empty(), "layers", 0.0, "at least one")?;
        let mut strand = WireStrand::on_core(core.map(Rod::radius))?;
        let mut laid = Vec::with_capacity(layers.len());
        for layer in layers {
            let preforming = layer.preforming;
            DomainError::check((0.0..=1.0).contains(&preforming), "preforming", preforming, "between 0 and 1")?;
            DomainError::check(layer.pretwist.is_finite(), "pretwist", layer.pretwist, "finite")?;
            let on = strand.lay(layer.strands, layer.rod.radius(), layer.lay)?;
            laid.push(Laid { layer: *layer, angle: on.taken_angle(), radius: on.taken_radius() });
        }
        Ok(Self { core, layers: laid })
    }

    /// The core.
    #[must_use]
    pub const fn core(&self) -> Option<Rod> {
        self.core
    }

    /// The layers, from the inside out.
    pub fn layers(&self) -> impl ExactSizeIterator<Item = &Layer> {
        self.layers.iter().map(|laid| &laid.layer)
    }

    /// Radius of the cylinder around it, as laid.
    #[must_use]
    pub fn outer_radius(&self) -> f64 {
        self.layers.last().map_or(0.0, |laid| laid.radius + laid.layer.rod.radius())
    }

    /// Sections of all wires, each square to itself: the area on which nominal stresses are based.
    #[must_use]
    pub fn metal_area(&self) -> f64 {
        let layers = self.layers.iter().map(|laid| f64::from(laid.layer.strands) * laid.layer.rod.area());
        self.core.map_or(0.0, Rod::area) + layers.sum::<f64>()
    }

    /// Bending stiffness of the cable when its rods slide freely: each layer bends as a set of helical springs, the core as it is.
    ///
    /// nB cos θ/(1 + ½ sin²θ (B/C − 1)), the lower [bound](super::BendingBounds).
    #[must_use]
    pub fn sliding_bending_stiffness(&self) -> f64 {
        let springs = self.layers.iter().map(|laid| {
            let (rod, s) = (laid.layer.rod, laid.angle.sin());
            let (b, c) = (rod.bending_stiffness(), rod.torsional_stiffness());
            f64::from(laid.layer.strands) * b * laid.angle.cos() / (1.0 + 0.5 * s * s * (b / c - 1.0))
        });
        self.core.map_or(0.0, Rod::bending_stiffness) + springs.sum::<f64>()
    }

    /// The cable as one rod, to be laid into a rope: its outer radius, EA, coupling and GJ as laid, its bending stiffness with rods that slide, and
    /// by how much its outside shrinks per strain at no turning.
    ///
    /// Right for small strains about the lay; contacts of single wires with other strands, and wear of its shape, are not in it.
    ///
    /// # Errors
    /// [`DomainError`] where the cable as laid does not resist strain and turning.
    ///
    /// ```
    /// use nply::mechanics::{Cable, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let wire = Rod::solid_round(0.5, 200e3, 0.3)?;
    /// let six = Layer { strands: 6, rod: wire, handedness: Handedness::Left, lay: WireLay::Length(25.0), preforming: 1.0, pretwist: 0.0 };
    /// let strand = Cable::new(Some(Rod::solid_round(0.53, 200e3, 0.3)?), &[six])?.as_rod()?;
    /// // a right-hand ordinary lay rope: six left-hand strands, laid to the right on a fibre core
    /// let outer = Layer { strands: 6, rod: strand, handedness: Handedness::Right, lay: WireLay::Length(70.0), preforming: 1.0, pretwist: 0.0 };
    /// let core = Rod::new(1.7, 1e4, 1e3, 1e3, 0.3)?;
    /// let rope = Cable::new(Some(core), &[outer])?;
    /// assert!(rope.laid()?.stiffness().is_some());
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn as_rod(&self) -> Result<Rod, DomainError> {
        let laid = self.laid()?;
        let StretchStiffness { axial, coupling, torsional } = laid.unchecked_stiffness();
        let resists = axial > 0.0 && torsional > 0.0 && axial * torsional > coupling * coupling;
        DomainError::check(resists, "stiffness", axial, "that of a cable which resists strain and turning as laid")?;
        let bending = self.sliding_bending_stiffness();
        let contraction = laid.contraction().unwrap_or(0.0); // as laid no layer shares: its strain and turning are given
        let rod = Rod::made(self.outer_radius(), [axial, bending, torsional, coupling], contraction);
        Ok(rod.of_area(self.metal_area()))
    }

    /// The hand of the outermost layer.
    #[must_use]
    pub fn handedness(&self) -> Handedness {
        self.layers.last().map_or(Handedness::Right, |laid| laid.layer.handedness)
    }
}
