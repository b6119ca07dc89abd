//! The one list of everything that can be written of a layered strand.

use super::{Datum, Group, Key, Kind, Table, key};

/// Every key of a layered strand, table by table.
///
/// ```
/// use nply_sheet::construction::CONSTRUCTION_KEYS;
/// let key = CONSTRUCTION_KEYS.iter().find(|key| key.flag == "strands").unwrap();
/// assert_eq!((key.table.name(), key.name), ("layer", "wires"));
/// ```
#[rustfmt::skip] // a table: one row a line
pub static CONSTRUCTION_KEYS: [Key; 29] = [
    key(Datum::StrandTitle, Table::Construction, "title", "title", Kind::Text, "A name for the report"),
    key(Datum::StrandOuterDiameter, Table::Construction, "outer_diameter", "outer-diameter", Kind::Length, "Outer diameter that is wanted; the wire diameter is found"),

    key(Datum::StrandCoreDiameter, Table::Core, "diameter", "core-diameter", Kind::Length, "Diameter of the core (king wire); 0 or absent, there is none").one_of(Group::CoreSize),
    key(Datum::StrandCoreDiameterRatio, Table::Core, "diameter_ratio", "core-diameter-ratio", Kind::Number, "Core diameter over the diameter of the wires on it").one_of(Group::CoreSize),
    key(Datum::StrandCoreDensity, Table::Core, "density", "core-density", Kind::Density, "Density of the core").one_of(Group::Density),
    key(Datum::StrandCoreMaterial, Table::Core, "material", "core-material", Kind::Text, "Material of the core, for its density alone: steel, galvanised steel, aluminium, copper").one_of(Group::Density),
    key(Datum::StrandCoreYoungsModulus, Table::Core, "youngs_modulus", "core-youngs-modulus", Kind::Modulus, "Young's modulus of the core"),
    key(Datum::StrandCorePoissonsRatio, Table::Core, "poissons_ratio", "core-poissons-ratio", Kind::Number, "Poisson's ratio of the core"),
    key(Datum::StrandCoreTensileStrength, Table::Core, "tensile_strength", "core-tensile-strength", Kind::Modulus, "Tensile strength of the core, for breaking load and what of it is used"),
    key(Datum::StrandCoreFibre, Table::Core, "fibre", "core-fibre", Kind::Switch, "The core is of fibre: its section counts neither as metal nor for the breaking load"),

    key(Datum::LayerWires, Table::Layer, "wires", "strands", Kind::Count, "Number of wires (strands) in the layer, 2 or more"),
    key(Datum::LayerWireDiameter, Table::Layer, "wire_diameter", "wire-diameter", Kind::Length, "Diameter of a wire"),
    key(Datum::LayerLayLength, Table::Layer, "lay_length", "lay-length", Kind::Length, "Strand length of one turn of a wire").one_of(Group::LayerLay),
    key(Datum::LayerLayRatio, Table::Layer, "lay_ratio", "lay-ratio", Kind::Number, "Lay length over the outer diameter of the layer").one_of(Group::LayerLay),
    key(Datum::LayerLayAngle, Table::Layer, "lay_angle", "lay-angle", Kind::Angle, "Angle of the wires to the strand's axis, more than 0 and less than 90 deg").one_of(Group::LayerLay),
    key(Datum::LayerHand, Table::Layer, "hand", "hand", Kind::Hand, "Which way the layer is laid: right (Z) or left (S)"),
    key(Datum::LayerGap, Table::Layer, "gap", "gap", Kind::Length, "Gap that is wanted between neighbouring wires; the core for it is found"),
    key(Datum::LayerDensity, Table::Layer, "density", "wire-density", Kind::Density, "Density of the wires").one_of(Group::Density),
    key(Datum::LayerMaterial, Table::Layer, "material", "wire-material", Kind::Text, "Material of the wires, for their density alone: steel, galvanised steel, aluminium, copper").one_of(Group::Density),
    key(Datum::LayerYoungsModulus, Table::Layer, "youngs_modulus", "wire-youngs-modulus", Kind::Modulus, "Young's modulus of the wires"),
    key(Datum::LayerPoissonsRatio, Table::Layer, "poissons_ratio", "wire-poissons-ratio", Kind::Number, "Poisson's ratio of the wires"),
    key(Datum::LayerTensileStrength, Table::Layer, "tensile_strength", "wire-tensile-strength", Kind::Modulus, "Tensile strength of the wires, for breaking load and what of it is used"),
    key(Datum::LayerPreforming, Table::Layer, "preforming", "preforming", Kind::Number, "How far the wires were bent to their lay before they were laid: 0 straight, 1 (the default) free of stress in it"),
    key(Datum::LayerPretwist, Table::Layer, "pretwist_per_length", "wire-pretwist", Kind::TurnsPerLength, "Turns put into each wire per wire length before it was laid, right-handed positive; a machine that turns wires back puts in one a lay, against the hand"),

    key(Datum::CableForce, Table::Load, "force", "force", Kind::Force, "Force on the strand or rope, tension positive"),
    key(Datum::CableMoment, Table::Load, "moment", "moment", Kind::Moment, "Moment on its ends, right-handed positive; 0 on a swivel").one_of(Group::Ends),
    key(Datum::CableTurning, Table::Load, "turns_per_length", "turns-per-length", Kind::TurnsPerLength, "Turns put into it from the lay as made, per length; 0 (the default) where the ends cannot turn").one_of(Group::Ends),

    key(Datum::CableTorqueFactor, Table::Construction, "torque_factor", "torque-factor", Kind::Number, "Moment over force and outer diameter that is wanted; the lay of a layer for it is found"),
    key(Datum::CableBalancedLayer, Table::Construction, "balanced_layer", "balanced-layer", Kind::Count, "The layer whose lay, or pretwist, is found for that, 1 the innermost; the outermost if absent"),
];
