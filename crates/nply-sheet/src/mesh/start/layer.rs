//! One layer of straight elements: how clear it is, and what is told of it.

use core::f64::consts::TAU;

use nply::Handedness;
use nply::geometry::ChordLay;
use serde_json::{Map, Value, json};

/// A layer of straight elements. Lengths in units of its wires' radius.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct StartLayer {
    /// The wires' radius, in units of r.
    pub(super) wire_radius: f64,
    pub(super) hand: Handedness,
    /// The lay that is written.
    pub(super) lay: ChordLay,
    /// The narrowest lay that clears, where another radius was held.
    pub(super) clear: Option<ChordLay>,
    /// The narrowest lay that is clear at any stagger.
    pub(super) at_any: ChordLay,
    /// The helix radius of the wires as they are laid, of a layer of a strand.
    pub(super) laid: Option<f64>,
    pub(super) wanted: f64,
    pub(super) coating: f64,
    /// The radius of what is below, without its coating.
    pub(super) core: Option<f64>,
}

/// What a layer lies on, for words.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Below {
    Core,
    Layer,
}

impl StartLayer {
    pub(super) fn lay_length(&self) -> f64 {
        TAU * self.lay.radius_ratio / self.lay.chords.angle().tan()
    }

    /// How far elements are from what is below, over what is wanted; negative where they overlap it.
    pub(super) fn core_gap(&self) -> Option<f64> {
        let nearest = self.lay.radius_ratio * self.lay.chords.core_distance();
        self.core.map(|core| nearest - (1.0 + core + 2.0 * self.coating))
    }

    pub(super) fn is_clear(&self) -> bool {
        let core = self.core_gap().is_none_or(|gap| gap >= -ROUNDING * self.lay.radius_ratio);
        core && self.lay.least_distance >= self.wanted * (1.0 - ROUNDING)
    }

    /// Whether neighbours keep it off what is below.
    pub(super) fn is_loose(&self) -> bool {
        const SEEN: f64 = 1e-6;
        self.clear.is_none() && self.core_gap().is_some_and(|gap| gap > SEEN)
    }

    /// What is reported: name in JSON, words, value in units of the wires' radius, or bare where it is no length.
    pub(super) fn items(&self, below: Below) -> Vec<(&'static str, &'static str, f64, bool)> {
        let lay = &self.lay;
        let mut items = vec![("helix_radius", "helix radius", lay.radius_ratio, true)];
        if let Some(laid) = self.laid {
            items.push(("laid_helix_radius", "helix radius of the wires as laid", laid, true));
        }
        items.extend([
            ("lay_length", "lay length", self.lay_length(), true),
            ("wanted_distance", "distance wanted: diameter and coatings", self.wanted, true),
            ("smooth_distance", "least distance of the helices", lay.smooth_distance, true),
            ("element_distance", "least distance of the elements", lay.least_distance, true),
            ("geometric_gap", "gap of the helices", lay.smooth_distance - self.wanted, true),
            ("chord_share", "of this lost to chords", lay.smooth_distance - lay.least_distance, true),
            ("gap", "gap of the elements", lay.least_distance - self.wanted, true),
        ]);
        if let (Some(core), Some(gap)) = (self.core, self.core_gap()) {
            let wanted = 1.0 + core + 2.0 * self.coating;
            let [radius, smooth, elements] = match below {
                Below::Core => ["core radius", "gap of the helices to the core", "gap of the elements to the core"],
                Below::Layer => [
                    "radius of the layer below, over its wires",
                    "gap of the helices to the layer below",
                    "gap of the elements to the layer below",
                ],
            };
            items.extend([
                ("core_radius", radius, core, true),
                ("core_geometric_gap", smooth, lay.radius_ratio - wanted, true),
                ("core_chord_share", "of this lost to chords", lay.radius_ratio - wanted - gap, true),
                ("core_gap", elements, gap, true),
            ]);
        }
        if let Some(clear) = &self.clear {
            items.push(("least_helix_radius", "least helix radius that clears", clear.radius_ratio, true));
        }
        items.push((
            "any_stagger_helix_radius",
            "least helix radius, nodes at any stagger",
            self.at_any.radius_ratio,
            true,
        ));
        items
    }

    /// What is no length, into an object.
    pub(super) fn head(&self, object: &mut Map<String, Value>, elements: Value) {
        object.insert("strands".into(), json!(self.lay.chords.strands()));
        object.insert("handedness".into(), json!(if self.hand == Handedness::Right { 1 } else { -1 }));
        object.insert("elements_per_lay_length".into(), elements);
        object.insert("helical_angle_deg".into(), json!(self.lay.chords.angle().degrees()));
    }

    /// Its lengths, in units of r, and in m where r is known, into an object.
    pub(super) fn lengths(&self, object: &mut Map<String, Value>, below: Below, radius: Option<f64>) {
        let mut si = Map::new();
        for (name, _, value, is_length) in self.items(below) {
            let value = if is_length { value * self.wire_radius } else { value };
            object.insert(name.into(), json!(value));
            if let (true, Some(radius)) = (is_length, radius) {
                si.insert(name.into(), json!(value * radius));
            }
        }
        if !si.is_empty() {
            object.insert("si".into(), Value::Object(si));
        }
    }
}

/// Elements nearer than wanted by less than this are as near as wanted.
const ROUNDING: f64 = 1e-9;
