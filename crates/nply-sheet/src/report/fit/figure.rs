//! The one list of what is reported of a layer, and of the strand as a whole.

use nply::geometry::{FitFormula, WireLayer};

use super::mass;
use core::f64::consts::PI;

use crate::construction::{Cut, Fit, GivenLayer};
use crate::report::figured::figure;

/// A layer as laid, and what was said of it.
pub(super) struct OfLayer {
    pub(super) laid: WireLayer,
    pub(super) given: GivenLayer,
}

/// What sort of number it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Number,
    Degrees,
    Length,
    Area,
    LinearDensity,
}

/// One reported number.
pub(super) type Figure<T> = crate::report::figured::Figure<T, Sort>;

const LAID: &str = "As laid on the core";
const TOUCH: &str = "Just touching at this lay length";
const TAKEN: &str = "As the wires lie";
const FORMULAS: &str = "Formulas in use, less what is";

#[rustfmt::skip] // a table: one row a line
pub(super) static OF_LAYER: [Figure<OfLayer>; 24] = [
    figure("", "wire_diameter", "wire diameter", Sort::Length, |l| Some(2.0 * l.laid.wire_radius())),
    figure("", "core_diameter", "core diameter (what is below)", Sort::Length, |l| Some(2.0 * l.laid.core_radius())),
    figure("", "lay_length", "lay length", Sort::Length, |l| Some(l.laid.lay_length())),

    figure(LAID, "lay_angle_deg", "lay angle", Sort::Degrees, |l| Some(l.laid.angle().degrees())),
    figure(LAID, "lay_ratio", "lay ratio (lay length/outer diameter)", Sort::Number, |l| Some(0.5 * l.laid.lay_length() / (l.laid.lay_radius() + l.laid.wire_radius()))),
    figure(LAID, "lay_radius", "lay radius", Sort::Length, |l| Some(l.laid.lay_radius())),
    figure(LAID, "wire_gap", "gap between neighbours (−: overlap)", Sort::Length, |l| Some(l.laid.gap())),
    figure(LAID, "outer_diameter", "outer diameter", Sort::Length, |l| Some(2.0 * (l.laid.lay_radius() + l.laid.wire_radius()))),

    figure(TOUCH, "touching_lay_radius", "lay radius", Sort::Length, |l| Some(l.laid.touching_radius())),
    figure(TOUCH, "king_wire_diameter", "core diameter (king wire)", Sort::Length, |l| Some(2.0 * l.laid.king_wire_radius())),
    figure(TOUCH, "wanted_gap", "gap that is wanted", Sort::Length, |l| l.given.gap),
    figure(TOUCH, "king_wire_diameter_for_gap", "core diameter for that gap", Sort::Length, |l| Some(2.0 * l.laid.king_wire_radius_for(l.given.gap?).ok()?)),

    figure(TAKEN, "taken_lay_angle_deg", "lay angle", Sort::Degrees, |l| Some(l.laid.taken_angle().degrees())),
    figure(TAKEN, "taken_lay_radius", "lay radius", Sort::Length, |l| Some(l.laid.taken_radius())),
    figure(TAKEN, "taken_outer_diameter", "outer diameter", Sort::Length, |l| Some(2.0 * l.laid.taken_outer_radius())),
    figure(TAKEN, "core_gap", "clearance to what is below", Sort::Length, |l| (l.laid.core_radius() > 0.0).then(|| l.laid.core_gap())),
    figure(TAKEN, "wire_length_ratio", "wire length/strand length", Sort::Number, |l| Some(l.laid.wire_length_ratio())),
    figure(TAKEN, "layer_mass_per_length", "mass per strand length", Sort::LinearDensity, |l| Some(l.laid.metal_area() * l.given.stuff.density?)),

    figure(FORMULAS, "flat_wire_gap", "", Sort::Length, |l| Some(FitFormula::Flat.gap(&l.laid))),
    figure(FORMULAS, "flat_touching_lay_radius", "", Sort::Length, |l| FitFormula::Flat.touching_radius(&l.laid)),
    figure(FORMULAS, "ellipse_wire_gap", "", Sort::Length, |l| Some(FitFormula::Ellipse.gap(&l.laid))),
    figure(FORMULAS, "ellipse_touching_lay_radius", "", Sort::Length, |l| FitFormula::Ellipse.touching_radius(&l.laid)),
    figure(FORMULAS, "flat_gap_error", "flat r/sin(π/n): gap", Sort::Length, |l| Some(FitFormula::Flat.gap(&l.laid) - l.laid.gap())),
    figure(FORMULAS, "ellipse_gap_error", "ellipse: gap", Sort::Length, |l| Some(FitFormula::Ellipse.gap(&l.laid) - l.laid.gap())),
];

#[rustfmt::skip] // a table: one row a line
pub(super) static OF_FORMULAS: [Figure<OfLayer>; 2] = [
    figure(FORMULAS, "flat_touching_lay_radius_error", "flat r/sin(π/n): touching lay radius", Sort::Length, |l| Some(FitFormula::Flat.touching_radius(&l.laid)? - l.laid.touching_radius())),
    figure(FORMULAS, "ellipse_touching_lay_radius_error", "ellipse: touching lay radius", Sort::Length, |l| Some(FitFormula::Ellipse.touching_radius(&l.laid)? - l.laid.touching_radius())),
];

const STRAND: &str = "The strand";

#[rustfmt::skip] // a table: one row a line
pub(super) static OF_WHOLE: [Figure<Fit>; 7] = [
    figure(STRAND, "strand_outer_diameter", "outer diameter", Sort::Length, |w| Some(2.0 * w.strand.outer_radius())),
    figure(STRAND, "metal_area", "sections in a plane across, the core's too unless of fibre", Sort::Area, |w| Some(area(w, Cut::Across))),
    figure(STRAND, "wire_section_area", "sections across each wire, the core's too unless of fibre", Sort::Area, |w| Some(area(w, Cut::Square))),
    figure(STRAND, "fill_factor", "fill factor: sections across each wire/enclosing circle", Sort::Number, |w| Some(area(w, Cut::Square) / (PI * w.strand.outer_radius() * w.strand.outer_radius()))),
    figure(STRAND, "mass_per_length", "mass per length", Sort::LinearDensity, |w| mass(w, w.strand.layers(), WireLayer::taken_angle)),
    figure(STRAND, "nominal_outer_diameter", "outer diameter, sum of diameters", Sort::Length, |w| w.nominal.last().map(|l| 2.0 * (l.lay_radius() + l.wire_radius()))),
    figure(STRAND, "nominal_mass_per_length", "mass per length, on sums of diameters", Sort::LinearDensity, |w| mass(w, &w.nominal, WireLayer::angle)),
];

/// The sections of all that is metal, of the wires alone where the rods of a layer or the core are strands.
fn area(fit: &Fit, cut: Cut) -> f64 {
    let core = fit.core().map_or(0.0, |core| 0.25 * PI * core.diameter * core.diameter * core.metal_share(cut));
    let layers = fit.strand.layers().iter().zip(&fit.layers);
    let layers = layers.map(|(layer, given)| cut.area(layer) * cut.share(given.strand.as_ref()));
    layers.fold(core, |sum, area| sum + area)
}
