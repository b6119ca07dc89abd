//! What a strand or rope carries, and how stiffly: what `nply stiffness` says.

mod figure;
mod json;
pub(super) mod listed;
mod text;

use nply::mechanics::{CableGrips, CableState, LayerSupport, LetsGo};

use figure::Member;

use crate::construction::{CableCase, CableQuestion};
use crate::preferred::six_digits;
use crate::{Dimension, SpecError};

/// A strand or rope under its loads, told as a table, JSON or CSV.
///
/// ```
/// use nply_sheet::StiffnessReport;
/// use nply_sheet::construction::ConstructionSpec;
/// let flags = [
///     ("core-diameter", "5.2"), ("core-youngs-modulus", "200"), ("core-poissons-ratio", "0.3"), ("strands", "6"),
///     ("wire-diameter", "5"), ("lay-length", "220"), ("wire-youngs-modulus", "200"), ("wire-poissons-ratio", "0.3"),
/// ];
/// let spec = ConstructionSpec::from_flags(flags)?;
/// let report = StiffnessReport::of(&spec, spec.check_cable()?)?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// let modulus = json["modulus"].as_f64().unwrap_or(0.0);
/// assert!(modulus > 190.0 && modulus < 200.0); // some per cent below the wires' own, for the lay
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StiffnessReport {
    /// What was asked.
    pub case: CableCase,
    /// The answer.
    pub state: CableState,
    /// Lay lengths at which the torque factor is as wanted, longest first, where that was asked.
    pub lay_lengths: Option<Vec<f64>>,
    /// The pretwist (rad per wire length) at which the cable as laid asks for no moment, where that was asked of wires that are not preformed.
    pub pretwist: Option<f64>,
    /// What a reader should know, a sentence each.
    pub notes: Vec<String>,
}

impl StiffnessReport {
    /// Loads the cable and reports on it. `spec` is what it was made from, for the place of a refusal.
    ///
    /// # Errors
    /// [`SpecError`] where no state near the lay as made holds the loads, at the load it is about.
    pub fn of(spec: &crate::construction::ConstructionSpec, case: CableCase) -> Result<Self, SpecError> {
        let refused = |error: nply::DomainError| spec.locate_load(&error);
        let state = match case.grips {
            None => case.cable.laid(),
            Some(grips) => case.cable.loaded(grips),
        };
        let state = state.map_err(refused)?;
        let (lay_lengths, pretwist) = match case.question {
            CableQuestion::State => (None, None),
            CableQuestion::Balance { torque_factor, layer } => {
                let lays = case.cable.lay_lengths_for_torque_factor(layer, torque_factor).map_err(refused)?;
                let straight = case.cable.layers().nth(layer).is_some_and(|layer| layer.preforming < 1.0);
                let twist = case.cable.pretwist_for_no_moment(layer).map_err(refused)?;
                (Some(lays), (straight && twist.is_finite()).then_some(twist))
            }
        };
        let mut report = Self { case, state, lay_lengths, pretwist, notes: Vec::new() };
        report.notes = report.say();
        Ok(report)
    }

    fn members(&self) -> Vec<Member> {
        let core = self.state.cable().core().map(|_| Member { state: self.state.clone(), layer: None });
        let layers = self.state.layers().iter().map(|layer| Member { state: self.state.clone(), layer: Some(*layer) });
        core.into_iter().chain(layers).collect()
    }

    /// A value with the reader's unit.
    fn told(&self, dimension: Dimension, value: f64) -> String {
        if self.case.construction.measured {
            self.case.construction.units.format(dimension, value)
        } else {
            six_digits(value)
        }
    }

    fn say(&self) -> Vec<String> {
        let (state, construction) = (&self.state, &self.case.construction);
        let mut notes = Vec::new();
        let several = state.layers().len() > 1;
        for (at, layer) in state.layers().iter().enumerate() {
            if layer.support == LayerSupport::Neighbours && (at > 0 || state.cable().core().is_some()) {
                let which = if several { format!("of layer {} ", at + 1) } else { String::new() };
                notes.push(format!(
                    "The wires {which}do not fit beside each other on what is below: they carry each other, and what is below lies loose."
                ));
            }
            if layer.support == LayerSupport::Both {
                let which = if several { format!("of layer {} ", at + 1) } else { String::new() };
                notes.push(format!(
                    "The wires {which}lie on what is below and on each other, and both push: over a range of loads the cable neither stretches \
                     nor turns but passes load from one to the other, so that it has no stiffness of its own there."
                ));
            }
        }
        if state.lifts() {
            let (layer, what) = self.lifted();
            notes.push(format!(
                "Under these loads {what} in layer {layer} would have to pull: it lifts off (birdcaging begins), and the numbers are those \
                 of a cable that is held together."
            ));
        } else if let Some(lift) = state.lift_off(true) {
            let what = match lift.lets_go {
                LetsGo::Below => "lifts off what is below",
                LetsGo::Neighbours => "parts from its neighbours",
            };
            let force = lift.state.force();
            let stiff = state.stiffness().map_or(0.0, |k| k.axial);
            let at = if force.abs() <= 1e-12 * stiff {
                "as soon as nothing pulls".to_owned()
            } else {
                format!("at a force of {}", self.told(Dimension::FORCE, force))
            };
            notes.push(format!(
                "With ends that cannot turn layer {} {what} {at}, friction and jackets left aside.",
                lift.layer + 1
            ));
        }
        if state.stiffness().is_none() {
            notes.push("About this state the cable does not resist every small change of length and turning: no stiffness is given.".to_owned());
        }
        if self.case.grips.is_none() {
            notes.push(if state.moment().abs() <= 1e-12 * self.unit_moment() {
                "No load is given: stiffnesses are those about the lay as made, free of stress.".to_owned()
            } else {
                format!(
                    "No load is given: stiffnesses are those about the lay as made, in which a moment of {} and a force of {} hold the wires.",
                    self.told(Dimension::MOMENT, state.moment()),
                    self.told(Dimension::FORCE, state.force())
                )
            });
        } else if let Some(CableGrips::Turned { turning, .. }) = self.case.grips
            && turning == 0.0
        {
            notes.push(
                "The ends cannot turn: the moment is what holds them. Give a moment of 0 for a swivel.".to_owned(),
            );
        }
        notes.push(
            "Linear elastic, without friction, flattening or bending of the cable. Stresses are changes from what wires have by themselves: straight where they \
             are not preformed, free of stress in their lay where they are (which is taken where nothing is said). Layers that cross touch in points, of \
             which nothing is said."
                .to_owned(),
        );
        if construction.layers.iter().any(|layer| layer.strand.is_some()) {
            notes.push(
                "Each strand counts as one rod, with the stiffnesses found for it as laid straight and free of load; its wires' own stresses and contacts are \
                 not in the table."
                    .to_owned(),
            );
        }
        if let (Some(lays), CableQuestion::Balance { torque_factor, layer }) = (&self.lay_lengths, self.case.question) {
            let lengths: Vec<String> = lays.iter().map(|lay| self.told(Dimension::LENGTH, *lay)).collect();
            notes.push(if lengths.is_empty() {
                format!("No lay length of layer {} gives a torque factor of {torque_factor}.", layer + 1)
            } else {
                format!(
                    "As laid, the torque factor is {torque_factor} at a lay length of layer {} of {}.",
                    layer + 1,
                    lengths.join(" or ")
                )
            });
        }
        if let (Some(pretwist), CableQuestion::Balance { layer, .. }) = (self.pretwist, self.case.question) {
            notes.push(format!(
                "As laid, no moment is needed to hold it where each wire of layer {} was twisted by {} beforehand (right-handed +).",
                layer + 1,
                self.told(Dimension::ANGLE_PER_LENGTH, pretwist)
            ));
        }
        notes
    }

    /// A moment of the size of the cable's own.
    fn unit_moment(&self) -> f64 {
        self.state.stiffness().map_or(0.0, |k| k.axial * self.state.outer_radius())
    }

    fn lifted(&self) -> (usize, &'static str) {
        let pulls = |layer: &nply::mechanics::LayerState| layer.pressure_below.min(layer.interstrand_pressure);
        let all = self.state.layers().iter().enumerate();
        let least = all.min_by(|(_, a), (_, b)| pulls(a).total_cmp(&pulls(b)));
        least.map_or((1, "a contact"), |(at, layer)| match layer.support {
            LayerSupport::Below | LayerSupport::Both => (at + 1, "what holds the wires down"),
            LayerSupport::Neighbours => (at + 1, "neighbours"),
        })
    }
}
