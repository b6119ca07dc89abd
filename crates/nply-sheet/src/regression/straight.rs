//! Straight strands side by side: the state of a row without twist and moment, or without turns.
//!
//! They are in equilibrium under any force, with m = nγφ̄a, and what they tell is their length and that moment. Their spot has the one
//! coordinate that is left to them, the force or the strain.

use core::f64::consts::FRAC_PI_2;

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::Ply;

use super::Observable;
use super::row::{Look, Row, Settled};
use super::sensed::{SLOTS, Sensed};
use super::state::{Model, Readings, Second, Spot, Strand};

/// ln tan θ of straight strands.
const STRAIGHT: f64 = f64::NEG_INFINITY;

impl Spot {
    /// Of straight strands, at a force where they do not stretch, at a strain where they do.
    const fn straight(hand: nply::Handedness, second: Second, value: f64) -> Self {
        Self { hand, second, place: [STRAIGHT, value] }
    }

    pub(super) fn is_straight(&self) -> bool {
        self.place[0] <= STRAIGHT
    }
}

impl Model {
    /// What is read off straight strands.
    pub(super) fn straight(&self, strand: &Strand, spot: &Spot) -> Option<Readings> {
        if !strand.is_finite() {
            return None;
        }
        let n = f64::from(self.strands());
        let second = Sensed::coordinate(spot.place[1], 1);
        let one = Sensed::constant(1.0);
        let (force, stretch, thickness) = match spot.second {
            Second::Strain => (n * (self.axial(strand) * second), one + second, one - self.thinning * second),
            _ => (second, one, one),
        };
        let contact = Contact::at_angle(self.strands(), HelicalAngle::new(0.0).ok()?).ok()?;
        let radius_ratio = contact.radius_ratio() * thickness;
        let readings = Readings {
            force,
            moment: n * strand.torque(),
            extension: stretch,
            rotation: Sensed::constant(0.0),
            angle: Sensed::constant(0.0),
            radius_ratio,
            outer: radius_ratio + thickness,
            radius: strand.radius,
            bending: strand.bending,
            strand_length: self.strand_length.unwrap_or(f64::NAN),
            hand: spot.hand,
            pressure: 0.0,
        };
        let all = [readings.force, readings.moment, readings.extension, readings.radius_ratio];
        all.iter().all(Sensed::is_finite).then_some(readings)
    }
}

impl Row {
    /// Whether a number that is held says of itself that the ply has no turns.
    pub(super) fn holds_no_turns(&self) -> bool {
        self.held.iter().any(|(observable, value)| observable.is_signed() && *value == 0.0)
    }

    /// Whether straight strands keep all that is held, whatever their stiffnesses, and something that is held asks for them.
    #[allow(clippy::float_cmp, reason = "straight strands have these numbers to the last bit")]
    pub(super) fn may_lie_straight(&self, model: &Model, untwisted: bool) -> bool {
        let has = |wanted| self.held.iter().any(|(observable, _)| *observable == wanted);
        let stretches = model.stretches();
        let kept = |(observable, value): &(Observable, f64)| match observable {
            Observable::Force => true,
            Observable::Moment => untwisted && *value == 0.0,
            Observable::LengthRatio | Observable::PlyLength if stretches => !has(Observable::Force),
            Observable::LengthRatio => *value == 1.0,
            Observable::PlyLength => model.strand_length == Some(*value),
            Observable::HelicalAngle | Observable::LayAngle => *value == 0.0,
            Observable::PitchAngle => *value == FRAC_PI_2,
            observable => observable.is_signed() && *value == 0.0,
        };
        let asks = |observable: Observable| match observable {
            Observable::Force => false,
            Observable::LengthRatio | Observable::PlyLength => !stretches,
            _ => true,
        };
        self.held.iter().any(|(observable, _)| asks(*observable)) && self.held.iter().all(kept)
    }

    /// Straight strands, where they keep what is held; their force or strain still to be found.
    pub(super) fn straight_spot(&self, model: &Model) -> Option<Spot> {
        let second = if model.stretches() { Second::Strain } else { Second::Force };
        self.straight.then(|| Spot::straight(model.hand.unwrap_or(nply::Handedness::Right), second, 0.0))
    }

    /// Straight strands under the force that is held, or with the length; else under that which comes nearest to what is measured.
    pub(super) fn settle_straight(&self, model: &Model, charted: &Ply, strand: &Strand, spot: Spot) -> Option<Settled> {
        let mut spot = spot;
        let mut look = self.look(model, charted, strand, &spot)?;
        // all is linear in the one coordinate: the second step takes away the rounding of the first
        for _ in 0..2 {
            spot.place[1] += look.straight_step();
            look = self.look(model, charted, strand, &spot)?;
        }
        if look.held.iter().any(|(off, _)| off.abs() >= 1e-9) {
            return None;
        }
        let nothing = [0.0; SLOTS];
        match look.bound() {
            Some((_, held)) => {
                let (by_place, by_slot) = (held.by_place()[1], held.by_slot());
                self.settled_along(spot, &look, [nothing, by_slot.map(|slope| -slope / by_place)], &[])
            }
            None => self.settled_along(spot, &look, [nothing; 2], &[[0.0, 1.0]]),
        }
    }
}

impl Look {
    /// The number held that fixes the coordinate of straight strands.
    fn bound(&self) -> Option<&(f64, Sensed)> {
        self.held.iter().find(|(_, held)| held.by_place()[1] != 0.0)
    }

    fn straight_step(&self) -> f64 {
        if let Some((off, held)) = self.bound() {
            return -off / held.by_place()[1];
        }
        let slopes = || self.measured.iter().map(|at| at.by_place()[1]);
        let square: f64 = slopes().map(|slope| slope * slope).sum();
        let rise: f64 = slopes().zip(&self.residuals).map(|(slope, residual)| slope * residual).sum();
        if square > 0.0 { -rise / square } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use nply::Handedness;
    use nply::mechanics::Balance;

    use super::super::Parameter;
    use super::super::state::place_of;
    use super::*;

    /// Straight strands are what touching ones come to as the angle goes to nothing: in both loads, length, turns and size, and in how these
    /// depend on the parameters.
    #[test]
    fn touching_strands_come_to_straight_ones() {
        for stretches in [false, true] {
            let model = Model::new(3, Balance::Contact)
                .and_then(|m| m.with(Parameter::Radius, 0.3e-3))
                .and_then(|m| m.with(Parameter::BendingStiffness, 2e-9))
                .and_then(|m| m.with(Parameter::StiffnessRatio, 0.8))
                .and_then(|m| m.with(Parameter::TurnsPerLength, -1500.0))
                .unwrap();
            let mut model = if stretches { model.with(Parameter::AxialStiffness, 0.2).unwrap() } else { model };
            model.strand_length = Some(0.2);
            model.thinning = 0.3;
            let strand = model.strand(model.slots(), None);
            let second = if stretches { Second::Strain } else { Second::Force };
            let charted = Ply::new(3, 1.0).unwrap();
            let near =
                Spot { hand: Handedness::Right, second, place: [place_of(HelicalAngle::new(1e-6).unwrap()), 0.01] };
            let near = model.readings(&charted, &strand, &near).unwrap();
            let straight = Spot::straight(Handedness::Right, second, 0.01);
            let straight = model.readings(&charted, &strand, &straight).unwrap();
            for observable in [
                Observable::Force,
                Observable::Moment,
                Observable::LengthRatio,
                Observable::PlyLength,
                Observable::PlyTurns,
                Observable::PlyTurnsPerLength,
                Observable::HelicalAngle,
                Observable::RadiusRatio,
                Observable::OuterDiameter,
            ] {
                let (limit, found) = (observable.of(&near), observable.of(&straight));
                let size = if observable == Observable::PlyTurns { 0.2 / 0.3e-3 } else { found.value.abs() };
                let size = if observable == Observable::PlyTurnsPerLength { 1.0 / 0.3e-3 } else { size.max(1e-9) };
                let size = if observable == Observable::HelicalAngle { 1.0 } else { size };
                let close = |a: f64, b: f64| (a - b).abs() < 1e-4 * size;
                assert!(close(limit.value, found.value), "{stretches} {observable:?}: {limit:?} {found:?}");
                assert!(close(limit.by_place()[1], found.by_place()[1]), "{observable:?}: {limit:?} {found:?}");
                let slopes = limit.by_slot().into_iter().zip(found.by_slot());
                assert!(slopes.into_iter().all(|(a, b)| close(a, b)), "{observable:?}: {limit:?} {found:?}");
            }
            assert!(!Observable::LayLength.of(&straight).is_finite());
        }
    }
}
