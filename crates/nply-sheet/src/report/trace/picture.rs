//! A path as a picture.

use nply::mechanics::{Data, Ends, Mark, Stability, Station, Twist};

use super::words::what;
use super::{TraceReport, data_of};
use crate::PreferredUnits;
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Picture};
use crate::report::{Known, Measure, Reading};

/// Stations of one verdict in a row, with their legs: its name, whether it is dashed.
type Run<'t> = (&'static str, bool, Vec<(usize, &'t Station)>);

impl TraceReport {
    /// The path as a picture: angle and pressures against the one datum that changes, or against the share of the path.
    #[must_use]
    pub fn picture(&self) -> Picture {
        let known = self.known();
        let across = self.across();
        let axis = |of: &Across| Axis::new(of.name.clone(), of.unit.clone());
        let reading = |measure: Measure, largest: f64| match self.cases.first() {
            Some(case) => measure.reading(known, &case.units, largest),
            None => measure.reading(known, &PreferredUnits::default(), largest),
        };
        let signed = |s: &Station| s.handedness.sign() * s.angle.degrees();
        let largest = self.stations().fold(0.0, |most: f64, (_, s)| most.max(s.resultant_pressure.abs()));
        let pressure = reading(Measure::ForcePerLength, largest);
        let title = self.cases.first().and_then(|case| case.title.clone()).unwrap_or_default();
        let mut angles = Chart::new(title, axis(&across), Axis::new("helical angle, left-handed below 0", "deg"));
        let mut pressures = Chart::new("", axis(&across), Axis::new("pressure", pressure.unit.clone()));
        for (name, dashed, run) in self.runs() {
            let curve = |value: &dyn Fn(&Station) -> f64, name: &str, colour: usize| {
                let points: Vec<(f64, f64)> = run.iter().map(|(leg, s)| ((across.of)(*leg, s), value(s))).collect();
                let curve = Curve::new(name, points).with_colour(colour);
                if dashed { curve.dashed() } else { curve }
            };
            angles = angles.with_curve(curve(&signed, name, 0));
            pressures = pressures.with_curve(curve(
                &|s| s.interstrand_pressure * pressure.factor,
                if dashed { "" } else { "neighbours p₁" },
                0,
            ));
            if self.cases.first().is_some_and(|case| data_of(case).is_ok_and(|data| data.core_radius.is_some())) {
                let of_core = |s: &Station| s.core_pressure * pressure.factor;
                pressures = pressures.with_curve(curve(&of_core, if dashed { "" } else { "core p_c" }, 1));
            }
        }
        for (leg, event) in self.events().filter(|(_, event)| event.mark != Mark::Arrival) {
            let (shape, colour) = shape(event.mark);
            let (x, s) = ((across.of)(leg, &event.station), &event.station);
            angles = angles.with_marker(Marker::new(what(event), x, signed(s), shape).with_colour(colour));
            let p = s.interstrand_pressure * pressure.factor;
            pressures = pressures.with_marker(Marker::new("", x, p, shape).with_colour(colour));
        }
        Picture::column([angles, pressures])
    }

    /// Stations in runs of one verdict, neighbouring runs sharing their border.
    fn runs(&self) -> Vec<Run<'_>> {
        let mut runs: Vec<Run<'_>> = Vec::new();
        for (leg, station) in self.stations() {
            let dashed =
                station.stability.is_some_and(|verdict| verdict != Stability::Stable) || station.is_separated();
            let name = match (dashed, station.stability) {
                (false, None) => "p ≥ 0",
                (false, Some(_)) => "stable",
                (true, _) if station.is_separated() => "p < 0",
                (true, _) => "unstable",
            };
            match runs.last_mut() {
                Some((last, _, run)) if *last == name => run.push((leg, station)),
                Some((_, _, run)) => {
                    let border = run.last().copied();
                    runs.push((name, dashed, border.into_iter().chain([(leg, station)]).collect()));
                }
                None => runs.push((name, dashed, vec![(leg, station)])),
            }
        }
        runs
    }

    /// What the picture's horizontal axis shows.
    fn across(&self) -> Across {
        let shares = || Across {
            name: "legs walked".to_owned(),
            unit: String::new(),
            of: Box::new(|leg, station| leg as f64 - 1.0 + station.along),
        };
        let [from, to] = &self.cases[..] else { return shares() };
        let (Ok(a), Ok(b)) = (data_of(from), data_of(to)) else { return shares() };
        let known = self.known();
        let changing: Vec<&Datum> = DATA.iter().filter(|datum| (datum.of)(&a) != (datum.of)(&b)).collect();
        let [datum] = changing[..] else { return shares() };
        let largest = [&a, &b].into_iter().filter_map(|data| (datum.of)(data)).fold(0.0, |m: f64, v| m.max(v.abs()));
        let reading = (datum.reading)(known, &from.units, largest);
        let factor = reading.factor;
        let of = datum.at;
        Across {
            name: datum.label.to_owned(),
            unit: reading.unit,
            of: Box::new(move |_, station| of(station) * factor),
        }
    }
}

/// The value at a station of a leg.
type At = dyn Fn(usize, &Station) -> f64;

/// What the horizontal axis of a picture shows.
struct Across {
    name: String,
    unit: String,
    of: Box<At>,
}

/// A datum that can change along a path: how it reads in the data, and at a station.
struct Datum {
    label: &'static str,
    reading: fn(Known, &PreferredUnits, f64) -> Reading,
    of: fn(&Data) -> Option<f64>,
    at: fn(&Station) -> f64,
}

const DATA: &[Datum] = &[
    Datum {
        label: "end force",
        reading: |k, u, largest| Measure::Force.reading(k, u, largest),
        of: |d| force(d.ends),
        at: |s| s.load.force,
    },
    Datum {
        label: "end moment",
        reading: |k, u, largest| Measure::Moment.reading(k, u, largest),
        of: |d| moment(d.ends),
        at: |s| s.load.moment,
    },
    Datum {
        label: "turns per strand length",
        reading: Measure::turning,
        of: |d| rotation(d.ends),
        at: Station::rotation,
    },
    Datum { label: "ply length/strand length", reading: number, of: |d| extension(d.ends), at: Station::extension },
    Datum { label: "pretwist", reading: Measure::twist, of: |d| pretwist(d.twist), at: Station::pretwist },
    Datum { label: "strand twist", reading: Measure::twist, of: |d| strand_twist(d.twist), at: Station::strand_twist },
    Datum { label: "stiffness ratio C/B", reading: number, of: |d| Some(d.stiffness_ratio), at: |s| s.stiffness_ratio },
    Datum {
        label: "core radius",
        reading: |k, u, largest| Measure::Length.reading(k, u, largest),
        of: |d| d.core_radius,
        at: |s| s.core_radius.unwrap_or(f64::NAN),
    },
];

fn number(_: Known, _: &PreferredUnits, _: f64) -> Reading {
    Reading { factor: 1.0, unit: String::new() }
}

const fn force(ends: Ends) -> Option<f64> {
    match ends {
        Ends::Loads(load) => Some(load.force),
        Ends::Rotation { force, .. } => Some(force),
        Ends::Length { .. } => None,
    }
}

const fn moment(ends: Ends) -> Option<f64> {
    match ends {
        Ends::Loads(load) => Some(load.moment),
        Ends::Length { moment, .. } => Some(moment),
        Ends::Rotation { .. } => None,
    }
}

const fn rotation(ends: Ends) -> Option<f64> {
    match ends {
        Ends::Rotation { rotation, .. } => Some(rotation),
        _ => None,
    }
}

const fn extension(ends: Ends) -> Option<f64> {
    match ends {
        Ends::Length { extension, .. } => Some(extension),
        _ => None,
    }
}

const fn pretwist(twist: Twist) -> Option<f64> {
    match twist {
        Twist::Pretwist(pretwist) => Some(pretwist),
        Twist::StrandTwist(_) => None,
    }
}

const fn strand_twist(twist: Twist) -> Option<f64> {
    match twist {
        Twist::StrandTwist(strand_twist) => Some(strand_twist),
        Twist::Pretwist(_) => None,
    }
}

const fn shape(mark: Mark) -> (MarkerShape, usize) {
    match mark {
        Mark::Arrival => (MarkerShape::Circle, 6),
        Mark::Fold => (MarkerShape::Circle, 1),
        Mark::ContactChange(_) => (MarkerShape::Square, 3),
        Mark::Separation => (MarkerShape::Cross, 1),
        Mark::Diagonal => (MarkerShape::Diamond, 2),
        Mark::MostTurns => (MarkerShape::Triangle, 4),
        Mark::CurvatureLimit => (MarkerShape::Plus, 5),
        Mark::StrainLimit => (MarkerShape::Plus, 2),
        Mark::Straight => (MarkerShape::Square, 6),
        Mark::Buckling => (MarkerShape::Circle, 3),
    }
}
