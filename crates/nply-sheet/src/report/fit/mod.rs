//! Does it fit? What `nply fit-check` says.

mod figure;
mod json;
pub(super) mod listed;
mod text;

use core::f64::consts::PI;

use nply::geometry::{FitFormula, HelicalAngle, LayerContact, WireLay, WireLayer};

use figure::OfLayer;

use crate::construction::Fit;
use crate::preferred::six_digits;
use crate::{Dimension, Unit};

/// How a layered strand fits together, told as a table, JSON or CSV.
///
/// ```
/// use nply_sheet::FitReport;
/// use nply_sheet::construction::ConstructionSpec;
/// let flags = [("core-diameter", "4"), ("strands", "6"), ("wire-diameter", "4"), ("lay-length", "80")];
/// let report = FitReport::of(ConstructionSpec::from_flags(flags)?.check_fit()?);
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!(json["contact"], "neighbours"); // seven wires alike, laid at 17.4 degrees, overlap
/// assert!((json["lay_angle_deg"].as_f64().unwrap_or(0.0) - 17.4406).abs() < 5e-5);
/// assert!(json["wire_gap"].as_f64().unwrap_or(0.0) < 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FitReport {
    /// The strand.
    pub fit: Fit,
    /// What a reader should know about it, a sentence each.
    pub notes: Vec<String>,
}

impl FitReport {
    /// Reports on a strand.
    #[must_use]
    pub fn of(fit: Fit) -> Self {
        let notes = notes(&fit);
        Self { fit, notes }
    }

    fn of_layers(&self) -> Vec<OfLayer> {
        let layers = self.fit.strand.layers().iter().zip(&self.fit.layers);
        layers.map(|(laid, given)| OfLayer { laid: *laid, given: given.clone() }).collect()
    }

    /// The unit in which a reader, or a script, finds lengths: the first that was written; none where nothing has a unit.
    fn unit(&self) -> Option<Unit> {
        unit(&self.fit)
    }
}

fn unit(fit: &Fit) -> Option<Unit> {
    fit.measured.then(|| fit.units.unit(Dimension::LENGTH, fit.strand.outer_radius()))
}

/// Whether every layer is of strands: a rope.
fn is_rope(fit: &Fit) -> bool {
    fit.layers.iter().all(|given| given.strand.is_some())
}

/// What a layer is of.
fn rods(fit: &Fit) -> &'static str {
    if is_rope(fit) { "strands" } else { "wires" }
}

/// Whether the strand has a core.
fn is_cored(fit: &Fit) -> bool {
    fit.core().is_some()
}

/// Mass per length of core and layers, the wires at the angle that is asked for; `None` where a density is missing.
fn mass(fit: &Fit, layers: &[WireLayer], angle: impl Fn(&WireLayer) -> HelicalAngle) -> Option<f64> {
    let mut mass = match fit.core() {
        Some(core) => 0.25 * PI * core.diameter * core.diameter * core.density?,
        None => 0.0,
    };
    for (layer, given) in layers.iter().zip(&fit.layers) {
        let r = layer.wire_radius();
        mass += f64::from(layer.wires()) * PI * r * r / angle(layer).cos() * given.stuff.density?;
    }
    Some(mass)
}

fn notes(fit: &Fit) -> Vec<String> {
    let length = |value: f64| match unit(fit) {
        Some(unit) => format!("{} {unit}", six_digits(unit.of_si(value))),
        None => six_digits(value),
    };
    let several = fit.strand.layers().len() > 1;
    let rods = rods(fit);
    let mut notes = Vec::new();
    for (at, layer) in fit.strand.layers().iter().enumerate() {
        let which = if several { format!("In layer {} the", at + 1) } else { "The".to_owned() };
        let below = if at == 0 { "core" } else { "layer below" };
        let wanted = fit.layers.get(at).and_then(|given| given.gap);
        if let Some(gap) = wanted.filter(|gap| layer.king_wire_radius_for(*gap).is_err()) {
            notes.push(format!(
                "{which} gap that is wanted, {}, is had on no core: at this lay length neighbours come no further apart than {}.",
                length(gap),
                length(layer.lay_length() / f64::from(layer.wires()) - 2.0 * layer.wire_radius())
            ));
        }
        if layer.contact() != LayerContact::Neighbours || layer.core_radius() == 0.0 {
            continue;
        }
        notes.push(format!(
            "{which} {} {rods} do not fit beside each other on the {below}: laid on it they would overlap by {}. They touch each other \
             instead, at a lay radius of {}, and leave the {below} loose by {} all round. {} thinner by {}, or a {below} of {}, would fit at \
             this lay length.",
            layer.wires(),
            length(-layer.gap()),
            length(layer.touching_radius()),
            length(layer.core_gap()),
            if is_rope(fit) { "Strands" } else { "Wires" },
            length(thinner(layer)),
            length(2.0 * layer.king_wire_radius()),
        ));
        let blind = |formula: &FitFormula| formula.gap(layer) >= -1e-12 * layer.lay_radius();
        let named: Vec<&str> = FitFormula::BOTH.into_iter().filter(blind).map(FitFormula::name).collect();
        if !named.is_empty() {
            let plural = if named.len() > 1 { "s see" } else { " sees" };
            notes.push(format!("{which} {} formula{plural} no overlap there.", named.join(" and the ")));
        }
    }
    for (at, strand) in fit.layers.iter().enumerate().filter_map(|(at, given)| Some((at, given.strand.as_ref()?))) {
        notes.extend(strand.crowded(&format!("the strands of layer {}", at + 1), &length));
    }
    if let Some(strand) = fit.core().and_then(|core| core.strand) {
        notes.extend(strand.crowded("the core", &length));
    }
    if fit.layers.iter().all(|given| given.stuff.density.is_some())
        && fit.core().is_some_and(|core| core.density.is_none())
    {
        notes.push("No mass is given: the density of the core is not known.".to_owned());
    }
    notes
}

/// By how much thinner the wires would have to be to touch on the same core at the same lay length.
fn thinner(layer: &WireLayer) -> f64 {
    let lay = WireLay::Length(layer.lay_length());
    let fits = |radius: f64| {
        WireLayer::on_core(layer.wires(), radius, layer.core_radius(), lay).is_ok_and(|laid| laid.gap() >= 0.0)
    };
    // a thinner wire always has the larger gap: halved until nothing is left to halve
    let (mut low, mut high) = (0.0, layer.wire_radius());
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if fits(middle) { low = middle } else { high = middle }
    }
    2.0 * (layer.wire_radius() - low)
}
