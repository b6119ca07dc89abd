//! A strand of layers as a person describes it: a core, and wires laid on it layer by layer.
//!
//! ```
//! use nply_sheet::construction::ConstructionSpec;
//! let text = r#"
//! core.diameter = "3.94 mm"
//! [[layer]]
//! wires = 6
//! wire_diameter = "3.73 mm"
//! lay_length = "115 mm"
//! hand = "right"
//! youngs_modulus = "188 GPa"
//! "#;
//! let strand = ConstructionSpec::from_toml("strand.toml", text)?.check()?;
//! let layer = &strand.layers[0];
//! assert_eq!((layer.wires, layer.wire_diameter, layer.youngs_modulus), (6, 3.73e-3, Some(188e9)));
//! # Ok::<(), nply_sheet::SpecError>(())
//! ```

mod cable;
mod check;
mod fit;
mod material;
mod written;

use nply::geometry::WireLay;
use nply::{DomainError, Handedness};

pub(crate) use cable::Cut;
pub use cable::{CableCase, CableQuestion};
pub(crate) use check::GivenLayer;
pub use fit::Fit;
pub use material::{MATERIALS, Material};
pub use written::ConstructionSpec;
pub(crate) use written::{DEEPEST, MOST_LAYERS};

pub use crate::key::CONSTRUCTION_KEYS;
use crate::{PreferredUnits, SpecError};

/// A layered strand in which every size is known. All in SI where the input has units, else in the input's own bare unit of
/// length (and, of densities and moduli, its own).
///
/// Layers stand from the inside; the core of each is what lies below it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Construction {
    /// The name given to it, for the report.
    pub title: Option<String>,
    /// What the first layer lies on; `None` where its wires lie on each other alone.
    pub core: Option<Core>,
    /// At least one, from the inside.
    pub layers: Vec<Layer>,
    /// Whether the input has units.
    pub measured: bool,
    /// The units the input was written in.
    pub units: PreferredUnits,
    written: ConstructionSpec,
}

/// A straight core: a king wire, or anything round.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Core {
    /// > 0.
    pub diameter: f64,
    /// kg/m³ where there are units.
    pub density: Option<f64>,
    /// E, Pa where there are units.
    pub youngs_modulus: Option<f64>,
    /// ν, greater than −1 and at most 0.5.
    pub poissons_ratio: Option<f64>,
    /// > 0, Pa where there are units.
    pub tensile_strength: Option<f64>,
    /// Whether its section counts neither as metal nor for the breaking load.
    pub fibre: bool,
    /// Where the core is a strand itself: that strand.
    pub strand: Option<Box<Construction>>,
}

/// Wires alike, laid side by side.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Layer {
    /// n, 2 to a million.
    pub wires: u32,
    /// > 0.
    pub wire_diameter: f64,
    /// How long, or how steep, a turn is.
    pub lay: WireLay,
    /// Which way it winds: right where the only layer does not say.
    pub hand: Handedness,
    /// kg/m³ where there are units.
    pub density: Option<f64>,
    /// E, Pa where there are units.
    pub youngs_modulus: Option<f64>,
    /// ν, greater than −1 and at most 0.5.
    pub poissons_ratio: Option<f64>,
    /// > 0, Pa where there are units.
    pub tensile_strength: Option<f64>,
    /// How far the wires were bent to their lay beforehand: 0 straight, 1 free of stress in it, which they are where nothing is said.
    pub preforming: f64,
    /// Twist put into each wire before it was laid, rad per wire length, right-handed positive.
    pub pretwist: f64,
    /// Where each of its "wires" is a strand: that strand.
    pub strand: Option<Box<Construction>>,
}

/// Whether a text describes a layered strand, and no ply of one layer: whether it has `[construction]` or `[[layer]]`.
///
/// ```
/// use nply_sheet::construction::is_layered;
/// assert!(is_layered("[[layer]]\nwires = 6\n") && !is_layered("[ply]\nstrands = 3\n"));
/// ```
#[must_use]
pub fn is_layered(text: &str) -> bool {
    toml::de::DeTable::parse(text).is_ok_and(|document| {
        document.get_ref().iter().any(|(header, _)| ["construction", "layer"].contains(&header.get_ref().as_ref()))
    })
}

impl Construction {
    /// A refusal of the theory, said at the datum of a layer (counted from 0) it is about.
    ///
    /// ```
    /// use nply::geometry::WireLayer;
    /// use nply_sheet::construction::ConstructionSpec;
    /// let flags = [("core-diameter", "2"), ("strands", "6"), ("wire-diameter", "2"), ("lay-length", "9")];
    /// let strand = ConstructionSpec::from_flags(flags)?.check()?;
    /// let refused = WireLayer::on_core(6, 1.0, 1.0, strand.layers[0].lay).unwrap_err();
    /// assert!(strand.locate(0, &refused).to_string().starts_with("`--lay-length \"9\"` is lay_length = 9"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn locate(&self, layer: usize, error: &DomainError) -> SpecError {
        self.written.locate(layer, error)
    }
}
