//! A map as a picture: what can be had, at which angle, and how hard the strands press.

use nply::Handedness;
use nply::mechanics::{Balance, Ply};

use super::{Cell, Map, MapDatum, Verdict};
use crate::plot::{Axis, Curve, Field, Picture};
use crate::report::{Known, Measure};

/// The picture of a map, filled row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPicture {
    columns: usize,
    counts: Vec<u8>,
    verdicts: Vec<u8>,
    angles: Vec<f64>,
    pressures: Vec<f64>,
}

/// A cell that has not been filled.
const NOTHING: u8 = 255;

impl MapPicture {
    /// Nothing in it yet.
    #[must_use]
    pub fn new(map: &Map) -> Self {
        let (columns, rows) = (map.x.count as usize, map.y.count as usize);
        let size = columns * rows;
        Self {
            columns,
            counts: vec![NOTHING; size],
            verdicts: vec![NOTHING; size],
            angles: vec![f64::NAN; size],
            pressures: vec![f64::NAN; size],
        }
    }

    /// Puts a row in its place.
    pub fn put(&mut self, map: &Map, row: usize, cells: &[Cell]) {
        let balance = map.balance();
        for (i, cell) in cells.iter().enumerate() {
            let at = row * self.columns + i;
            let Some(count) = self.counts.get_mut(at) else { return };
            *count = u8::try_from(cell.states.len().min(9)).unwrap_or(9);
            self.verdicts[at] = cell.verdict(balance).number();
            if let Some(state) = cell.seen(balance) {
                self.angles[at] = state.handedness.sign() * state.helical_angle_deg;
                self.pressures[at] = state.resultant_pressure;
            }
        }
    }

    /// Four panels: how many states, what can be had, the angle and the pressure of what can be had.
    #[must_use]
    pub fn svg(&self, map: &Map) -> String {
        let axis = |axis: &super::Axis| {
            let reading = axis.reading(map.case());
            // a cell's centre is its value, so that the rectangle is half a cell wider all round
            let half = if axis.count > 1 { 0.5 * (axis.to - axis.from) / f64::from(axis.count - 1) } else { 0.5 };
            let (low, high) = ((axis.from - half) * reading.factor, (axis.to + half) * reading.factor);
            Axis::new(axis.datum.label(), reading.unit.clone()).with_range(low, high)
        };
        let (x, y) = (axis(&map.x), axis(&map.y));
        let known = Known { scale: map.case().scale, strand_radius: map.case().strand_radius };
        let greatest = self.pressures.iter().filter(|p| p.is_finite()).fold(0.0, |most: f64, p| most.max(p.abs()));
        let pressure = Measure::ForcePerLength.reading(known, &map.case().units, greatest);
        let pressures: Vec<f64> = self.pressures.iter().map(|p| p * pressure.factor).collect();
        let most = self.counts.iter().filter(|count| **count != NOTHING).max().copied().unwrap_or(0);
        let names: Vec<String> =
            (0..=most).map(|count| if count == 9 { "9 or more".into() } else { count.to_string() }).collect();
        let seen = Verdict::ALL.map(|verdict| map.words(verdict));
        let of = match map.balance() {
            Balance::Contact => "of the stable state",
            Balance::Radial => "of the pressing state",
        };
        let locus = self.locus(map);
        let with_locus = |field: Field| locus.iter().fold(field, |field, curve| field.with_curve(curve.clone()));
        let columns = self.columns;
        let panels = [
            with_locus(Field::of_categories("Number of states", x.clone(), y.clone(), columns, &self.counts, names)),
            with_locus(Field::of_categories("What can be had", x.clone(), y.clone(), columns, &self.verdicts, seen)),
            Field::of_signed_values(
                format!("Angle {of}"),
                x.clone(),
                y.clone(),
                columns,
                &self.angles,
                Axis::new("helical angle, left-handed below 0", "deg"),
            ),
            Field::of_values(format!("Pressure {of}"), x, y, columns, &pressures, Axis::new("p", pressure.unit)),
        ];
        // two and two: four in a row could not be read on a page
        Picture::grid(panels, 2).svg()
    }

    /// p = 0 for both hands, where the map is of force and moment.
    fn locus(&self, map: &Map) -> Vec<Curve> {
        const POINTS: usize = 800;
        if !map.has_locus() {
            return Vec::new();
        }
        let locus = Ply::new(map.case().strands, map.corner.stiffness_ratio)
            .and_then(|ply| ply.separation_locus(map.twist(), POINTS));
        let Ok(locus) = locus else { return Vec::new() };
        let reading = |axis: &super::Axis| axis.reading(map.case()).factor;
        let (across, up) = (reading(&map.x), reading(&map.y));
        Handedness::BOTH
            .map(|hand| {
                let points = locus.forces(hand).iter().zip(locus.moments(hand)).map(|(&force, &moment)| {
                    if map.x.datum == MapDatum::Force {
                        (force * across, moment * up)
                    } else {
                        (moment * across, force * up)
                    }
                });
                let side = if hand == Handedness::Right { "right" } else { "left" };
                let curve = Curve::new(format!("p = 0, {side}"), points).with_colour(6);
                if hand == Handedness::Left { curve.dashed() } else { curve }
            })
            .into()
    }
}
