//! What a strand or rope carries, and how stiffly: what `nply stiffness` says.

mod figure;
mod json;
pub(super) mod listed;
mod text;

use nply::mechanics::{CableGrips, CableState, DesignedLay, LayerSupport, LetsGo};

use figure::{Member, Whole, is_counted, members, modulus, strength_used, stress};

use crate::construction::{CableCase, CableQuestion};
use crate::preferred::six_digits;
use crate::{Dimension, SpecError, Unit};

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
    /// Lays at which the torque factor is as wanted, longest first, where that was asked.
    pub lays: Option<Vec<DesignedLay>>,
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
        let refused = |error: nply::DomainError| spec.locate_load(&case, &error);
        let state = match case.grips {
            None => case.cable.laid(),
            Some(grips) => case.cable.loaded(grips),
        };
        let state = state.map_err(refused)?;
        let (lays, pretwist) = match case.question {
            CableQuestion::State => (None, None),
            CableQuestion::Balance { torque_factor, layer } => {
                let lays = case.cable.lays_for_torque_factor(layer, torque_factor).map_err(refused)?;
                let straight = case.cable.layers().nth(layer).is_some_and(|layer| layer.preforming < 1.0);
                let twist = case.cable.pretwist_for_no_moment(layer).map_err(refused)?;
                (Some(lays), (straight && twist.is_finite()).then_some(twist))
            }
        };
        let mut report = Self { case, state, lays, pretwist, notes: Vec::new() };
        report.notes = report.say();
        Ok(report)
    }

    fn members(&self) -> Vec<Member> {
        members(&self.state, &self.case.strands)
    }

    fn whole(&self) -> Whole {
        Whole { state: self.state.clone(), strands: self.case.strands.clone() }
    }

    /// Whether every layer is of strands.
    fn is_rope(&self) -> bool {
        self.case.construction.layers.iter().all(|layer| layer.strand.is_some())
    }

    /// A value with the reader's unit.
    fn told(&self, dimension: Dimension, value: f64) -> String {
        if self.case.construction.measured {
            self.case.construction.units.format(dimension, value)
        } else {
            six_digits(value)
        }
    }

    /// The unit in which stresses are read: MPa beside moduli in GPa and the like, ksi beside those in Msi, else that of the moduli.
    fn stress_unit(&self) -> Unit {
        let modulus = self.case.construction.units.written(Dimension::PRESSURE);
        let name = match modulus.filter(|unit| !unit.is_decimal()).map(Unit::as_str) {
            None => "MPa",
            Some("Msi" | "Mpsi") => "ksi",
            Some(written) => written,
        };
        Unit::parse(name).unwrap_or_else(|_| Unit::si(Dimension::PRESSURE))
    }

    fn say(&self) -> Vec<String> {
        let (state, construction) = (&self.state, &self.case.construction);
        let mut notes = Vec::new();
        let several = state.layers().len() > 1;
        let wires = if self.is_rope() { "strands" } else { "wires" };
        for (at, layer) in state.layers().iter().enumerate() {
            if layer.support == LayerSupport::Neighbours && (at > 0 || state.cable().core().is_some()) {
                let which = if several { format!("of layer {} ", at + 1) } else { String::new() };
                notes.push(format!(
                    "The {wires} {which}do not fit beside each other on what is below: they carry each other, and what is below lies loose."
                ));
            }
            if layer.support == LayerSupport::Both {
                let which = if several { format!("of layer {} ", at + 1) } else { String::new() };
                notes.push(format!(
                    "The {wires} {which}lie on what is below and on each other, and both push: over a range of loads the cable neither stretches \
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
        notes.extend(self.core_that_gives());
        notes.extend(self.overstressed());
        if construction.layers.iter().any(|layer| layer.strand.is_some()) {
            notes.push(
                "Each strand counts as one rod, with the stiffnesses found for it as laid straight and free of load; of its wires the \
                 table has the greatest stress, at the strand's strain and twist. The rest is had by asking about that strand alone, under the pull that would strain it so \
                 and with the turns that are put into it."
                    .to_owned(),
            );
        }
        notes.extend(construction.crowded_within(&|length| self.told(Dimension::LENGTH, length)));
        notes.extend(self.balanced());
        if let (Some(pretwist), CableQuestion::Balance { layer, .. }) = (self.pretwist, self.case.question) {
            notes.push(format!(
                "As laid, no moment is needed to hold it where each wire of layer {} was twisted by {} beforehand (right-handed +).",
                layer + 1,
                self.told(Dimension::ANGLE_PER_LENGTH, pretwist)
            ));
        }
        notes
    }

    /// That the core would be squeezed by what lies on it, where that matters.
    fn core_that_gives(&self) -> Option<String> {
        const MATTERS: f64 = 0.05;
        let (state, wires) = (&self.state, if self.is_rope() { "strands" } else { "wires" });
        let give = state.cable().core_give().filter(|give| *give > MATTERS)?;
        let modulus = self.told(Dimension::PRESSURE, state.cable().core()?.youngs_modulus()?);
        let squeezed = match (state.pressure_on_core(), state.core_squeeze()) {
            (Some(pressure), Some(squeeze)) if squeeze > 0.0 => format!(
                " Here {} press on it, which would make it thinner by {} % of its diameter.",
                if self.case.construction.measured {
                    let unit = self.stress_unit();
                    format!("{} {unit}", six_digits(unit.of_si(pressure)))
                } else {
                    six_digits(pressure)
                },
                six_digits(100.0 * squeeze)
            ),
            _ => String::new(),
        };
        Some(format!(
            "The core is taken to keep its round outline whatever presses on it. One of {modulus} does not: as a solid it would give way by {} what the {wires} on it \
             are strained.{squeezed} A rope or strand on such a core is softer than it says here, until its {wires} lie on each other; without a core (its diameter 0) \
             the answer is that of {wires} that carry each other.",
            if give < 1.0 { format!("{:.0} % of", 100.0 * give) } else { format!("{give:.1} times") }
        ))
    }

    /// What is past its strength, or past any.
    fn overstressed(&self) -> Vec<String> {
        let members = self.members();
        let cored = usize::from(self.state.cable().core().is_some());
        let named = |at: usize| if at < cored { "the core".to_owned() } else { format!("layer {}", at + 1 - cored) };
        let broken = |m: &Member| strength_used(m).is_some_and(|used| used > 1.0);
        // strands of a rope, and what is not solid, have no stress here; fibre is strained as no metal is
        let absurd = |m: &Member| {
            is_counted(m)
                && matches!((stress(m), modulus(m)), (Some(s), Some(modulus)) if s.equivalent() > modulus / 50.0)
        };
        let all = |is: &dyn Fn(&Member) -> bool| {
            let found = members.iter().enumerate().filter(|(_, m)| is(m)).map(|(at, _)| named(at));
            found.collect::<Vec<_>>().join(" and ")
        };
        let (past, beyond) = (all(&broken), all(&absurd));
        let mut notes = Vec::new();
        if !past.is_empty() {
            notes.push(format!(
                "Past its tensile strength: {past}. What is said here of an elastic cable holds no more."
            ));
        }
        if !beyond.is_empty() {
            notes.push(format!(
                "The equivalent stress is more than a fiftieth of Young's modulus in {beyond}, which no metal wire bears: it would have yielded long before."
            ));
        }
        notes
    }

    /// The lays at which the torque factor is as wanted, those at which the wires do not fit last.
    fn balanced(&self) -> Vec<String> {
        let (Some(lays), CableQuestion::Balance { torque_factor, layer }) = (&self.lays, self.case.question) else {
            return Vec::new();
        };
        let length = |length: f64| self.told(Dimension::LENGTH, length);
        let wires = if self.is_rope() { "strands" } else { "wires" };
        let mut notes: Vec<String> = Vec::new();
        for lay in lays.iter().filter(|lay| lay.fits) {
            let (Some(laid), outer) = (lay.laid.layers().get(layer), 2.0 * lay.laid.outer_radius()) else { continue };
            notes.push(format!(
                "As laid, the torque factor is {torque_factor} at a lay length of layer {} of {}: {} of its outer diameters, laid at {} deg, with a gap of {} between \
                 neighbours. The whole is then {} thick.",
                layer + 1,
                length(lay.lay_length),
                six_digits(0.5 * lay.lay_length / (laid.radius + laid.layer.rod.radius())),
                six_digits(laid.angle.degrees()),
                length(laid.gap),
                length(outer)
            ));
        }
        if notes.is_empty() {
            notes.push(format!("No lay length of layer {} gives a torque factor of {torque_factor}.", layer + 1));
        }
        for lay in lays.iter().filter(|lay| !lay.fits) {
            let all = lay.laid.layers();
            let off = all.iter().enumerate().skip(layer).find(|(_, layer)| layer.support == LayerSupport::Neighbours);
            let Some((at, laid)) = off else { continue };
            let below = match at.checked_sub(1).and_then(|below| all.get(below)) {
                Some(below) => below.radius + below.layer.rod.radius(),
                None => lay.laid.core_radius().unwrap_or(0.0),
            };
            notes.push(format!(
                "On paper it is so at {} too, but there the {wires} of layer {} do not fit beside each other on what is below: they would carry each other, at {} deg, \
                 and stand {} clear of it.",
                length(lay.lay_length),
                at + 1,
                six_digits(laid.angle.degrees()),
                length(laid.radius - laid.layer.rod.radius() - below)
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
