//! One row of measurements and the state that lies nearest to it.
//!
//! A state has two coordinates. Each number of the row that is held takes one away; what is left is moved until the measured numbers,
//! each counted in its own errors, are as near as they can be. So loads with error bars are as good as shapes with error bars.

use nalgebra::DMatrix;
use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::Ply;

use super::observable::Observable;
use super::parameter::Parameter;
use super::sensed::{SLOTS, Sensed};
use super::state::{Model, Readings, Second, Spot, Strand, place_of};

/// One row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// of the file, or its number
    pub(super) line: usize,
    /// one or two; more leave nothing to find
    pub(super) held: Vec<(Observable, f64)>,
    pub(super) measured: Vec<Datum>,
    pub(super) twist: Option<(Parameter, f64)>,
    /// whether straight strands keep what is held
    pub(super) straight: bool,
}

/// One measured number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Datum {
    pub(super) column: usize,
    pub(super) observable: Observable,
    pub(super) value: f64,
    /// one standard error
    pub(super) error: f64,
}

/// A row's state.
#[derive(Clone, Debug)]
pub(super) struct Settled {
    pub(super) spot: Spot,
    /// each measured number as the state has it
    pub(super) fitted: Vec<f64>,
    /// fitted less measured, in errors
    pub(super) residuals: Vec<f64>,
    /// slopes of these by the parameters, what the state's own freedom takes up taken away
    pub(super) slopes: Vec<[f64; SLOTS]>,
    /// how many numbers went into the state itself
    pub(super) spent: usize,
    pub(super) readings: Readings,
}

impl Settled {
    pub(super) fn chi_squared(&self) -> f64 {
        self.residuals.iter().map(|r| r * r).sum()
    }
}

/// All numbers of a row at a spot.
pub(super) struct Look {
    readings: Readings,
    /// held: how far off, over its size
    pub(super) held: Vec<(f64, Sensed)>,
    pub(super) measured: Vec<Sensed>,
    pub(super) residuals: Vec<f64>,
}

const MOST_STEPS: usize = 100;

/// Whether an angle is that of straight strands or flat rings, which a walk comes as near to as it likes.
pub(super) fn is_limit(angle: f64) -> bool {
    const NEXT_TO: f64 = 1e-6;
    !(NEXT_TO..=core::f64::consts::FRAC_PI_2 - NEXT_TO).contains(&angle)
}

/// The least and the greatest number that plies of some strands have, whatever their angle and their loads, strands that do not stretch.
pub(super) fn reach(model: &Model, charted: &Ply, strand: &Strand, observable: Observable) -> Option<[f64; 2]> {
    // angles end at straight strands and flat rings themselves, beside which the last steps are
    if let Observable::HelicalAngle | Observable::LayAngle | Observable::PitchAngle = observable {
        return Some([0.0, core::f64::consts::FRAC_PI_2]);
    }
    const STEPS: u32 = 400;
    let at = |hand: Handedness, step: u32| {
        // close together at both ends, where most have their least and greatest
        let along = f64::from(step) / f64::from(STEPS);
        let angle = HelicalAngle::new(core::f64::consts::FRAC_PI_2 * along * along * (3.0 - 2.0 * along)).ok()?;
        let spot = model.spot(strand, hand, place_of(angle), [Some(0.0), None], false);
        Some(observable.of(&model.readings(charted, strand, &spot)?).value)
    };
    let hands = [Handedness::Right, Handedness::Left];
    let hands = hands.into_iter().filter(|hand| model.hand.is_none_or(|known| known == *hand));
    let values = hands.flat_map(|hand| (1..STEPS).filter_map(move |step| at(hand, step)));
    // straight strands do not turn: what has a sign ends there at 0
    let ends = observable.is_signed().then_some([0.0; 2]);
    values.fold(ends, |ends: Option<[f64; 2]>, value| {
        let [low, high] = ends.unwrap_or([value; 2]);
        Some([low.min(value), high.max(value)])
    })
}

impl Row {
    /// Of the size of what is held.
    fn size(observable: Observable, value: f64, strand: &Strand, model: &Model) -> f64 {
        if value != 0.0 {
            return value.abs();
        }
        let [force, moment] = strand.units();
        let (r, length) = (strand.radius.value, model.strand_length.unwrap_or(1.0));
        match observable {
            Observable::Force => force,
            Observable::Moment => moment,
            Observable::PlyLength => length,
            Observable::PlyRotation | Observable::PlyTurns => length / r,
            Observable::PlyTurnsPerStrandLength | Observable::PlyTurnsPerLength => 1.0 / r,
            Observable::LayLength | Observable::HelixRadius | Observable::OuterDiameter => r,
            _ => 1.0,
        }
    }

    pub(super) fn look(&self, model: &Model, charted: &Ply, strand: &Strand, spot: &Spot) -> Option<Look> {
        let readings = model.readings(charted, strand, spot)?;
        let held = self.held.iter().map(|&(observable, value)| {
            let size = Self::size(observable, value, strand, model);
            let scaled = (1.0 / size) * observable.of(&readings);
            (scaled.value - value / size, scaled)
        });
        let measured: Vec<Sensed> =
            self.measured.iter().map(|datum| (1.0 / datum.error) * datum.observable.of(&readings)).collect();
        let residuals = measured.iter().zip(&self.measured).map(|(at, datum)| at.value - datum.value / datum.error);
        let look = Look { readings, held: held.collect(), residuals: residuals.collect(), measured };
        let finite = look.held.iter().all(|(_, held)| held.is_finite()) && look.measured.iter().all(Sensed::is_finite);
        finite.then_some(look)
    }

    /// The state near a spot that keeps what is held and comes nearest to what is measured; `None` where there is none.
    pub(super) fn settle(&self, model: &Model, charted: &Ply, strand: &Strand, spot: Spot) -> Option<Settled> {
        if spot.is_straight() {
            return self.settle_straight(model, charted, strand, spot);
        }
        let mut spot = spot;
        let mut look = self.look(model, charted, strand, &spot)?;
        let (mut weight, mut damping, mut last) = (1.0_f64, 1e-13, f64::INFINITY);
        let enough = if self.held.len() == 2 { 1e-9 } else { 1e-12 };
        for _ in 0..MOST_STEPS {
            let (step, pull) = look.step(damping)?;
            weight = weight.max(2.0 * pull);
            // no further than is sensible at once
            let largest = if spot.second == Second::Strain { 0.05 } else { f64::INFINITY };
            let cut = (0.7 / step[0].abs()).min(largest / step[1].abs()).min(1.0);
            let merit = look.merit(weight);
            let mut share = cut;
            let mut moved = None;
            while share > 1e-9 {
                let next = Spot { place: [spot.place[0] + share * step[0], spot.place[1] + share * step[1]], ..spot };
                if let Some(there) = self.look(model, charted, strand, &next)
                    && there.merit(weight) <= merit * (1.0 + 1e-15)
                {
                    moved = Some((next, there));
                    break;
                }
                share *= 0.5;
            }
            let second = 1.0 + spot.place[1].abs();
            let size = step[0].abs().max(step[1].abs() / second);
            match moved {
                Some((next, there)) => {
                    spot = next;
                    look = there;
                    damping = (damping * 0.1).max(1e-13);
                    // Newton's steps are squared each time; the others shrink as long as rounding lets them
                    if size < enough || size < 1e-9 && size > 0.5 * last {
                        break;
                    }
                }
                None if size < 1e-6 => break, // rounding leaves no better
                None if damping < 1.0 => damping *= 1e4,
                None => break,
            }
            last = size;
        }
        let kept = look.held.iter().all(|(off, _)| off.abs() < 1e-9);
        // both loads held vanish with the angle, and do so at flat rings: limits keep them, and are no states
        let limit = self.held.len() == 2 && is_limit(look.readings.angle.value);
        if !kept || limit { None } else { self.settled(spot, &look) }
    }

    /// The state with its slopes.
    fn settled(&self, spot: Spot, look: &Look) -> Option<Settled> {
        let held: Vec<[f64; 2]> = look.held.iter().map(|(_, held)| held.by_place()).collect();
        let held_by: Vec<[f64; SLOTS]> = look.held.iter().map(|(_, held)| held.by_slot()).collect();
        // how the coordinates follow the parameters with what is held kept, and which ways are left free
        let (follow, free): ([[f64; SLOTS]; 2], Vec<[f64; 2]>) = match held[..] {
            [] => ([[0.0; SLOTS]; 2], vec![[1.0, 0.0], [0.0, 1.0]]),
            [h] => {
                let square = h[0] * h[0] + h[1] * h[1];
                let along = |i: usize| core::array::from_fn(|k| -h[i] * held_by[0][k] / square);
                ([along(0), along(1)], vec![[-h[1], h[0]]])
            }
            [g, h] => {
                let determinant = g[0] * h[1] - g[1] * h[0];
                let first = |k: usize| -(h[1] * held_by[0][k] - g[1] * held_by[1][k]) / determinant;
                let second = |k: usize| -(g[0] * held_by[1][k] - h[0] * held_by[0][k]) / determinant;
                ([core::array::from_fn(first), core::array::from_fn(second)], Vec::new())
            }
            _ => return None,
        };
        self.settled_along(spot, look, follow, &free)
    }

    /// The same where it is known how the coordinates follow the parameters, and which ways are left free.
    pub(super) fn settled_along(
        &self,
        spot: Spot,
        look: &Look,
        follow: [[f64; SLOTS]; 2],
        free: &[[f64; 2]],
    ) -> Option<Settled> {
        let mut slopes: Vec<[f64; SLOTS]> = look
            .measured
            .iter()
            .map(|at| {
                let (by_place, by_slot) = (at.by_place(), at.by_slot());
                core::array::from_fn(|k| by_slot[k] + by_place[0] * follow[0][k] + by_place[1] * follow[1][k])
            })
            .collect();
        if slopes.iter().flatten().any(|slope| !slope.is_finite()) {
            return None;
        }
        let ways = free.iter().map(|way| {
            look.measured.iter().map(|at| at.by_place()[0] * way[0] + at.by_place()[1] * way[1]).collect::<Vec<f64>>()
        });
        let basis = orthonormal(ways.collect());
        for way in &basis {
            for k in 0..SLOTS {
                let share: f64 = way.iter().zip(&slopes).map(|(w, slope)| w * slope[k]).sum();
                way.iter().zip(&mut slopes).for_each(|(w, slope)| slope[k] -= share * w);
            }
        }
        let fitted = look.measured.iter().zip(&self.measured).map(|(at, datum)| at.value * datum.error).collect();
        let residuals = look.residuals.clone();
        Some(Settled { spot, fitted, residuals, slopes, spent: basis.len(), readings: look.readings })
    }

    /// Every state that the row may belong to, the nearest first: the search that a fit begins with.
    pub(super) fn candidates(&self, model: &Model, charted: &Ply, strand: &Strand) -> Vec<Settled> {
        let mut found: Vec<Settled> = Vec::new();
        for spot in self.spots(model, charted, strand).into_iter().chain(self.straight_spot(model)) {
            let Some(settled) = self.settle(model, charted, strand, spot) else { continue };
            let same = |other: &Settled| {
                other.spot.hand == settled.spot.hand
                    && (0..2).all(|i| {
                        let (a, b) = (other.spot.place[i], settled.spot.place[i]);
                        (a - b).abs() < 1e-6 * (1.0 + a.abs()) || other.spot.second != settled.spot.second && i == 1
                    })
            };
            if !found.iter().any(same) {
                found.push(settled);
            }
        }
        found.sort_by(|a, b| a.chi_squared().total_cmp(&b.chi_squared()));
        found
    }

    fn given(&self, wanted: impl Fn(Observable) -> bool) -> Option<(Observable, f64)> {
        let measured = self.measured.iter().map(|datum| (datum.observable, datum.value));
        self.held.iter().copied().chain(measured).find(|(observable, _)| wanted(*observable))
    }

    /// Where to begin: at every state under the loads, and wherever the shape is that of the row.
    fn spots(&self, model: &Model, charted: &Ply, strand: &Strand) -> Vec<Spot> {
        let [force_unit, moment_unit] = strand.units();
        let force = self.given(|o| o == Observable::Force).map(|(_, value)| value / force_unit);
        let moment = self.given(|o| o == Observable::Moment).map(|(_, value)| value / moment_unit);
        let mut spots = match (force, moment) {
            (Some(force), Some(moment)) => model.states(charted, strand, [force, moment]),
            _ => Vec::new(),
        };
        let loads_held = self.held.len() == 2 && self.held.iter().all(|(observable, _)| observable.is_load());
        if loads_held && !spots.is_empty() {
            return spots;
        }
        let hands = [Handedness::Right, Handedness::Left];
        let mut shapes: Vec<(Observable, f64)> = self.held.iter().copied().filter(|(o, _)| !o.is_load()).collect();
        shapes.extend(self.measured.iter().map(|d| (d.observable, d.value)).filter(|(o, _)| !o.is_load()));
        // one that is signed says the hand too
        shapes.sort_by_key(|(observable, _)| !observable.is_signed());
        if let Some(&(observable, value)) = shapes.first() {
            for hand in hands.into_iter().filter(|hand| model.hand.is_none_or(|known| known == *hand)) {
                if observable.is_signed() && value * hand.sign() < 0.0 {
                    continue;
                }
                for t in places(model, charted, strand, hand, observable, value) {
                    spots.push(model.spot(strand, hand, t, [force, moment], false));
                    if force.is_some() && moment.is_some() {
                        spots.push(model.spot(strand, hand, t, [force, moment], true));
                    }
                }
            }
        }
        spots
    }
}

/// Where a shape takes a value, or comes nearest to it, along the branch of touching strands.
fn places(
    model: &Model,
    charted: &Ply,
    strand: &Strand,
    hand: Handedness,
    observable: Observable,
    value: f64,
) -> Vec<f64> {
    const STEPS: u32 = 90;
    let off = |t: f64| {
        let spot = model.spot(strand, hand, t, [Some(0.0), None], false);
        Some(observable.of(&model.readings(charted, strand, &spot)?).value - value)
    };
    let mut found = Vec::new();
    let mut last: Option<(f64, f64)> = None;
    let mut nearest: Option<(f64, f64)> = None;
    for step in 0..STEPS {
        let degrees = 0.5 + f64::from(step) * 89.0 / f64::from(STEPS - 1);
        let Ok(angle) = HelicalAngle::new(degrees.to_radians()) else { continue };
        let t = place_of(angle);
        let Some(here) = off(t) else { continue };
        if let Some((before, there)) = last
            && there * here <= 0.0
        {
            found.push(before + (t - before) * there / (there - here)); // by the chord
        }
        if nearest.is_none_or(|(_, size)| here.abs() < size) {
            nearest = Some((t, here.abs()));
        }
        last = Some((t, here));
    }
    if found.is_empty() {
        found.extend(nearest.map(|(t, _)| t));
    }
    found
}

impl Look {
    /// Gauss and Newton's step with what is held kept to first order, and how hard that pulls.
    fn step(&self, damping: f64) -> Option<([f64; 2], f64)> {
        let (step, pull) = match &self.held[..] {
            [(off, g), (other, h)] => {
                let (g, h) = (g.by_place(), h.by_place());
                let determinant = g[0] * h[1] - g[1] * h[0];
                ([(g[1] * other - h[1] * off) / determinant, (h[0] * off - g[0] * other) / determinant], 0.0)
            }
            [(off, h)] => {
                // to where it is kept, and along that as far as the measured numbers want
                let (square, slope) = self.squares(damping);
                let h = h.by_place();
                let size = h[0] * h[0] + h[1] * h[1];
                let (to, along) = ([-off * h[0] / size, -off * h[1] / size], [-h[1], h[0]]);
                let rise = |way: [f64; 2], z: [f64; 2]| {
                    (0..2).map(|i| way[i] * (slope[i] + square[i][0] * z[0] + square[i][1] * z[1])).sum::<f64>()
                };
                let bend = rise(along, along) - rise(along, [0.0; 2]);
                let share = if bend > 0.0 { -rise(along, to) / bend } else { 0.0 };
                let step = [to[0] + share * along[0], to[1] + share * along[1]];
                (step, (rise(h, step) / size).abs())
            }
            _ => {
                let (square, slope) = self.squares(damping);
                let determinant = square[0][0] * square[1][1] - square[0][1] * square[1][0];
                let step = [
                    (square[0][1] * slope[1] - square[1][1] * slope[0]) / determinant,
                    (square[1][0] * slope[0] - square[0][0] * slope[1]) / determinant,
                ];
                (step, 0.0)
            }
        };
        (step.iter().all(|x| x.is_finite()) && pull.is_finite()).then_some((step, pull))
    }

    /// The squared slopes of what is measured, damped, and the slope of half the sum of squares.
    fn squares(&self, damping: f64) -> ([[f64; 2]; 2], [f64; 2]) {
        let (mut square, mut slope) = ([[0.0; 2]; 2], [0.0; 2]);
        for (at, residual) in self.measured.iter().zip(&self.residuals) {
            let by = at.by_place();
            for i in 0..2 {
                slope[i] += residual * by[i];
                for k in 0..2 {
                    square[i][k] += by[i] * by[k];
                }
            }
        }
        // coordinates of different sizes are damped each by its own; one that nothing depends on stays where it is
        let own = [square[0][0], square[1][1]];
        for i in 0..2 {
            square[i][i] += if own[i] > 0.0 { damping * own[i] } else { own[1 - i].max(1.0) };
        }
        (square, slope)
    }

    fn merit(&self, weight: f64) -> f64 {
        let off: f64 = self.held.iter().map(|(off, _)| off.abs()).sum();
        if self.held.len() == 2 {
            return off;
        }
        0.5 * self.residuals.iter().map(|r| r * r).sum::<f64>() + weight * off
    }
}

/// An orthonormal basis of what some vectors span.
fn orthonormal(vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut vector in vectors {
        let length = |v: &[f64]| libm::sqrt(v.iter().map(|x| x * x).sum());
        let before = length(&vector);
        for _ in 0..2 {
            for other in &basis {
                let share: f64 = other.iter().zip(&vector).map(|(a, b)| a * b).sum();
                other.iter().zip(&mut vector).for_each(|(a, b)| *b -= share * a);
            }
        }
        let after = length(&vector);
        if after > 1e-9 * before && after > 0.0 {
            vector.iter_mut().for_each(|x| *x /= after);
            basis.push(vector);
        }
    }
    basis
}

/// The slopes of all rows, one below the other, for some of the parameters.
pub(super) fn stacked(settled: &[Settled], slots: &[usize], sizes: &[f64]) -> DMatrix<f64> {
    let rows: Vec<&[f64; SLOTS]> = settled.iter().flat_map(|row| &row.slopes).collect();
    DMatrix::from_fn(rows.len(), slots.len(), |i, k| rows[i][slots[k]] * sizes[k])
}

#[cfg(test)]
mod tests {
    use nply::mechanics::Balance;

    use super::*;

    fn model(stretches: bool) -> Model {
        let model = Model::new(3, Balance::Contact)
            .and_then(|m| m.with(Parameter::Radius, 0.3e-3))
            .and_then(|m| m.with(Parameter::YoungsModulus, 3e5))
            .and_then(|m| m.with(Parameter::ShearModulus, 1.1e5))
            .and_then(|m| m.with(Parameter::TurnsPerLength, -1500.0))
            .unwrap();
        let mut model = if stretches { model.with(Parameter::AxialStiffness, 0.2).unwrap() } else { model };
        model.strand_length = Some(0.2);
        model.thinning = 0.3;
        model
    }

    fn datum((observable, value, error): (Observable, f64, f64)) -> Datum {
        Datum { column: 0, observable, value, error }
    }

    /// Slopes of what is left of a row against rows settled anew with a parameter a little different: of every residual where the state is
    /// fixed by what is held, of the sum of squares (2 Jᵀr) where it moves along.
    #[test]
    fn slopes_are_those_of_the_settled_row() {
        let force = (Observable::Force, 5e-3);
        let moment = (Observable::Moment, 1e-6);
        let turns = (Observable::PlyTurnsPerStrandLength, 900.0);
        let angle = (Observable::HelicalAngle, 0.42, 0.01);
        let lay = (Observable::LayLength, 5e-3, 1e-4);
        let length = (Observable::PlyLength, 0.181, 1e-3);
        let measured_force = (Observable::Force, 4e-3, 5e-4);
        let measured_moment = (Observable::Moment, 0.8e-6, 2e-7);
        type Numbers = Vec<(Observable, f64)>;
        type Measured = Vec<(Observable, f64, f64)>;
        let rows: [(Numbers, Measured); 5] = [
            (vec![force, moment], vec![angle, lay, length]),
            (vec![force, turns], vec![measured_moment, lay]),
            (vec![turns], vec![measured_force, measured_moment, lay]),
            (vec![force], vec![measured_moment, angle, length]),
            (vec![], vec![measured_force, measured_moment, angle, length]),
        ];
        for stretches in [false, true] {
            let model = model(stretches);
            let charted = Ply::new(3, 1.0).unwrap();
            for (held, measured) in &rows {
                let row = Row {
                    line: 1,
                    held: held.clone(),
                    measured: measured.iter().copied().map(datum).collect(),
                    twist: None,
                    straight: false,
                };
                let strand = model.strand(model.slots(), None);
                let settled = row.candidates(&model, &charted, &strand).into_iter().next().expect("a state");
                for k in 0..SLOTS {
                    if k == 4 && !stretches {
                        continue;
                    }
                    let size = if k == 3 { 1500.0 } else { 1.0 };
                    let h = 1e-5;
                    let at = |by: f64| {
                        let mut slots = *model.slots();
                        slots[k] += by * size;
                        row.settle(&model, &charted, &model.strand(&slots, None), settled.spot).expect("a state")
                    };
                    let (up, down) = (at(h), at(-h));
                    let near = |slope: f64, difference: f64| {
                        let difference = difference / (2.0 * h * size);
                        let scale = (1.0 / size).max(slope.abs());
                        assert!(
                            (slope - difference).abs() < 2e-5 * scale,
                            "{stretches} {held:?} {k}: {slope} {difference}"
                        );
                    };
                    if held.len() == 2 {
                        for (i, slopes) in settled.slopes.iter().enumerate() {
                            near(slopes[k], up.residuals[i] - down.residuals[i]);
                        }
                    } else {
                        let slope =
                            settled.residuals.iter().zip(&settled.slopes).map(|(r, slopes)| 2.0 * r * slopes[k]).sum();
                        near(slope, up.chi_squared() - down.chi_squared());
                    }
                }
            }
        }
    }
}
