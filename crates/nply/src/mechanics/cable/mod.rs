//! Cables: a core and concentric layers of wires or strands, each with its own hand and lay, coupled by strain and turning.

mod deformed;
mod design;
mod layer;
mod lift;
mod rod;
mod shared;
mod state;

pub use design::DesignedLay;
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
/// let sum = 200e3 * strand.wire_section_area();
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

    /// Σ n π r²: sections of all wires, each square to itself, and of a core that counts as one: the area on which nominal stresses, modulus and
    /// breaking load are based. A core of fibre is [left out](Rod::uncounted).
    #[must_use]
    pub fn wire_section_area(&self) -> f64 {
        let layers = self.layers.iter().map(|laid| f64::from(laid.layer.strands) * laid.layer.rod.area());
        self.core.map_or(0.0, Rod::area) + layers.sum::<f64>()
    }

    /// Σ tensile strength × section of all wires, and of a core that counts as one: the metallic (aggregate) breaking load of ropemakers, who take
    /// a loss for laying off it. `None` unless the strength of every one is known.
    ///
    /// ```
    /// use nply::mechanics::{Cable, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// // six wires of 2 mm on one of 2.1 mm, all of 1770 N/mm²
    /// let wire = |radius: f64| Rod::solid_round(radius, 200e3, 0.3)?.of_strength(1770.0);
    /// let six = Layer {
    ///     strands: 6,
    ///     rod: wire(1.0)?,
    ///     handedness: Handedness::Left,
    ///     lay: WireLay::Length(60.0),
    ///     preforming: 1.0,
    ///     pretwist: 0.0,
    /// };
    /// let strand = Cable::new(Some(wire(1.05)?), &[six])?;
    /// let load = strand.metallic_breaking_load().expect("all strengths are known");
    /// assert!((load - 1770.0 * strand.wire_section_area()).abs() < 1e-9 * load);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn metallic_breaking_load(&self) -> Option<f64> {
        let core = self.core.filter(|core| core.area() > 0.0);
        let core = core.map_or(Some(0.0), Rod::breaking_load)?;
        let of_layer = |laid: &Laid| Some(f64::from(laid.layer.strands) * laid.layer.rod.breaking_load()?);
        self.layers.iter().try_fold(core, |sum, laid| Some(sum + of_layer(laid)?))
    }

    /// By how much of its own strain, to first order and for small pulls, the innermost layer would be strained less if the core gave way as a solid
    /// of its Young's modulus: in what is reported of a cable the core thins as it is stretched, and keeps its outline whatever presses on it.
    ///
    /// A layer that lies on the core is strained by ε cos²θ + (ΔR/R) sin²θ. A core of radius r_c, under the mean pressure p that the layers put on it
    /// at the strain ε, gives way by r_c (1 + ν)(1 − 2ν) p/E (Lamé, its length held), which is (r_c/R) tan²θ (1 + ν)(1 − 2ν) p/(E ε) of it. Next to
    /// nothing for a steel wire; above 1 the layer does not lie on such a core at all, but sinks until its rods carry each other.
    /// `None` without a solid core, and where nothing lies on it.
    ///
    /// ```
    /// use nply::mechanics::{Cable, Layer, Rod};
    /// use nply::{Handedness, geometry::WireLay};
    /// let six = Layer {
    ///     strands: 6,
    ///     rod: Rod::solid_round(1.0, 200e3, 0.3)?,
    ///     handedness: Handedness::Right,
    ///     lay: WireLay::Length(40.0),
    ///     preforming: 1.0,
    ///     pretwist: 0.0,
    /// };
    /// let on = |modulus: f64| Cable::new(Some(Rod::solid_round(1.1, modulus, 0.0)?), &[six]);
    /// assert!(on(200e3)?.core_give().is_some_and(|give| give < 0.01)); // a king wire of steel
    /// assert!(on(500.0)?.core_give().is_some_and(|give| give > 1.0)); // a core of fibre
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    #[must_use]
    pub fn core_give(&self) -> Option<f64> {
        const STRAIN: f64 = 1e-6;
        let at = |strain| self.loaded(CableGrips::Clamped { strain, turning: 0.0 }).ok();
        let (laid, pulled) = (at(0.0)?, at(STRAIN)?);
        let [core, first] = [self.core?.radius(), self.layers.first()?.radius];
        let tan = self.layers.first()?.angle.tan();
        let squeeze = (pulled.core_squeeze()? - laid.core_squeeze()?) / STRAIN;
        Some(core / first * tan * tan * squeeze)
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
        Ok(rod.of_area(self.wire_section_area()).of_breaking_load(self.metallic_breaking_load()))
    }

    /// The hand of the outermost layer.
    #[must_use]
    pub fn handedness(&self) -> Handedness {
        self.layers.last().map_or(Handedness::Right, |laid| laid.layer.handedness)
    }
}
