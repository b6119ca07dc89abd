//! A path as a picture.

use nply::mechanics::{Axial, Grips, Mark, Stability, Station, StretchStation, Turning, Twist};

use super::stop::Stop;
use super::words::what;
use super::{Walked, data_of, twist_of};
use crate::plot::{Axis, Chart, Curve, Marker, MarkerShape, Picture};
use crate::report::{Known, Measure, Reading};
use crate::{Case, PreferredUnits, Question};

/// Stations of one verdict in a row, with their legs: its name, whether it is dashed.
type Run<'t, S> = (&'static str, bool, Vec<(usize, &'t S)>);

impl<S: Drawn> Walked<S> {
    /// The path as a picture: angle and pressures against the one datum that changes, or against the share of the path.
    pub(super) fn picture(&self) -> Picture {
        let known = self.known();
        let across = self.across();
        let axis = |of: &Across<S>| Axis::new(of.name.clone(), of.unit.clone());
        let reading = |measure: Measure, largest: f64| match self.cases.first() {
            Some(case) => measure.reading(known, &case.units, largest),
            None => measure.reading(known, &PreferredUnits::default(), largest),
        };
        let signed = |s: &S| s.hand().sign() * s.lay_angle().degrees();
        let largest = self.stations().fold(0.0, |most: f64, (_, s)| most.max(S::largest(s)));
        let pressure = reading(Measure::ForcePerLength, largest);
        let title = self.cases.first().and_then(|case| case.title.clone()).unwrap_or_default();
        let mut angles = Chart::new(title, axis(&across), Axis::new("helical angle, left-handed below 0", "deg"));
        let mut pressures = Chart::new("", axis(&across), Axis::new("pressure", pressure.unit.clone()));
        for (name, dashed, run) in self.runs() {
            let curve = |value: &dyn Fn(&S) -> f64, name: &str, colour: usize| {
                let points: Vec<(f64, f64)> = run.iter().map(|(leg, s)| ((across.of)(*leg, s), value(s))).collect();
                let curve = Curve::new(name, points).with_colour(colour);
                if dashed { curve.dashed() } else { curve }
            };
            angles = angles.with_curve(curve(&signed, name, 0));
            pressures = pressures.with_curve(curve(
                &|s| s.pressures()[0] * pressure.factor,
                if dashed { "" } else { "neighbours p₁" },
                0,
            ));
            if run.first().is_some_and(|(_, s)| s.has_core()) {
                let of_core = |s: &S| s.pressures()[1] * pressure.factor;
                pressures = pressures.with_curve(curve(&of_core, if dashed { "" } else { "core p_c" }, 1));
            }
        }
        for (leg, event) in self.events().filter(|(_, event)| event.mark != Mark::Arrival) {
            let (shape, colour) = shape(event.mark);
            let (x, s) = ((across.of)(leg, &event.station), &event.station);
            angles = angles.with_marker(Marker::new(what(event), x, signed(s), shape).with_colour(colour));
            let p = s.pressures()[0] * pressure.factor;
            pressures = pressures.with_marker(Marker::new("", x, p, shape).with_colour(colour));
        }
        Picture::column([angles, pressures])
    }

    /// Stations and what happens between them, in the order of the walk, with their legs; and whether a curve may change there: it does not
    /// at an event, which is the end of one stretch and the beginning of the next.
    fn walked(&self) -> impl Iterator<Item = (usize, &S, bool)> {
        self.legs.iter().enumerate().flat_map(|(i, leg)| {
            let stations = leg.trace.stations.iter().enumerate();
            stations.flat_map(move |(at, station)| {
                let events = leg.trace.events.iter().filter(move |event| event.before == at);
                let between = events.map(move |event| (i + 1, &event.station, false));
                between.chain([(i + 1, station, true)])
            })
        })
    }

    /// The walk in runs of one verdict, neighbouring runs sharing their border. What is marginal belongs to the run it is met in.
    fn runs(&self) -> Vec<Run<'_, S>> {
        let mut runs: Vec<Run<'_, S>> = Vec::new();
        let mut met_first = Vec::new();
        for (leg, station, decides) in self.walked() {
            let verdict = station.verdict();
            if !decides || verdict == Some(Stability::Marginal) {
                runs.last_mut().map_or(&mut met_first, |(_, _, run)| run).push((leg, station));
                continue;
            }
            let dashed = verdict.is_some_and(|verdict| verdict != Stability::Stable) || station.separated();
            let name = match (dashed, verdict) {
                (false, None) => "p ≥ 0",
                (false, Some(_)) => "stable",
                (true, _) if station.separated() => "p < 0",
                (true, _) => "unstable",
            };
            match runs.last_mut() {
                Some((last, _, run)) if *last == name => run.push((leg, station)),
                Some((_, _, run)) => {
                    let border = run.last().copied();
                    runs.push((name, dashed, border.into_iter().chain([(leg, station)]).collect()));
                }
                None => {
                    let begun = std::mem::take(&mut met_first);
                    runs.push((name, dashed, begun.into_iter().chain([(leg, station)]).collect()));
                }
            }
        }
        if !met_first.is_empty() {
            runs.push(("marginal", false, met_first));
        }
        runs
    }

    /// What the picture's horizontal axis shows.
    fn across(&self) -> Across<S> {
        let shares = || Across {
            name: "legs walked".to_owned(),
            unit: String::new(),
            of: Box::new(|leg, station: &S| leg as f64 - 1.0 + station.along()),
        };
        let [from, to] = &self.cases[..] else { return shares() };
        let known = self.known();
        let changing: Vec<&Datum<S>> = S::DATA.iter().filter(|datum| (datum.of)(from) != (datum.of)(to)).collect();
        let [datum] = changing[..] else { return shares() };
        let largest = [from, to].into_iter().filter_map(|case| (datum.of)(case)).fold(0.0, |m: f64, v| m.max(v.abs()));
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
type At<S> = dyn Fn(usize, &S) -> f64;

/// What the horizontal axis of a picture shows.
struct Across<S> {
    name: String,
    unit: String,
    of: Box<At<S>>,
}

/// A datum that can change along a path: how it reads in the data, and at a station.
pub(super) struct Datum<S> {
    label: &'static str,
    reading: fn(Known, &PreferredUnits, f64) -> Reading,
    of: fn(&Case) -> Option<f64>,
    at: fn(&S) -> f64,
}

/// What of a state goes into a picture.
pub(super) trait Drawn: Stop {
    /// The data that can change along its path.
    const DATA: &'static [Datum<Self>];

    /// The size of what presses.
    fn largest(&self) -> f64;
}

const fn force<S>(of: fn(&Case) -> Option<f64>, at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "end force", reading: |k, u, largest| Measure::Force.reading(k, u, largest), of, at }
}

const fn moment<S>(of: fn(&Case) -> Option<f64>, at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "end moment", reading: |k, u, largest| Measure::Moment.reading(k, u, largest), of, at }
}

const fn rotation<S>(of: fn(&Case) -> Option<f64>, at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "turns per strand length", reading: Measure::turning, of, at }
}

const fn extension<S>(of: fn(&Case) -> Option<f64>, at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "ply length/strand length", reading: number, of, at }
}

const fn pretwist<S>(at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "pretwist", reading: Measure::twist, of: given_pretwist, at }
}

const fn strand_twist<S>(at: fn(&S) -> f64) -> Datum<S> {
    Datum { label: "strand twist", reading: Measure::twist, of: given_strand_twist, at }
}

impl Drawn for Station {
    const DATA: &'static [Datum<Self>] = &[
        force(|c| along(c, false), |s| s.load.force),
        moment(|c| around(c, false), |s| s.load.moment),
        rotation(|c| around(c, true), Self::rotation),
        extension(|c| along(c, true), Self::extension),
        pretwist(Self::pretwist),
        strand_twist(Self::strand_twist),
        Datum {
            label: "stiffness ratio C/B",
            reading: number,
            of: |case| Some(case.stiffness_ratio),
            at: |s| s.stiffness_ratio,
        },
        Datum {
            label: "core radius",
            reading: |k, u, largest| Measure::Length.reading(k, u, largest),
            of: |case| data_of(case).ok()?.core_radius,
            at: |s| s.core_radius.unwrap_or(f64::NAN),
        },
    ];

    fn largest(&self) -> f64 {
        self.resultant_pressure.abs()
    }
}

impl Drawn for StretchStation {
    const DATA: &'static [Datum<Self>] = &[
        force(|c| along(c, false), |s| s.state.load().force),
        moment(|c| around(c, false), |s| s.state.load().moment),
        rotation(|c| around(c, true), |s| s.state.rotation()),
        extension(|c| along(c, true), |s| s.state.extension()),
        pretwist(|s| s.state.strand_twist() - s.state.rotation() * s.state.angle().cos()),
        strand_twist(|s| s.state.strand_twist()),
    ];

    fn largest(&self) -> f64 {
        let [neighbours, core, _] = self.pressures();
        neighbours.abs().max(core.abs())
    }
}

fn number(_: Known, _: &PreferredUnits, _: f64) -> Reading {
    Reading { factor: 1.0, unit: String::new() }
}

/// What is given along and around, of whatever strands.
fn grips(case: &Case) -> Option<Grips> {
    match case.question {
        Question::Stretched { grips, .. } => Some(grips),
        _ => data_of(case).ok().map(|data| data.ends.into()),
    }
}

/// Force given, or length ratio held.
fn along(case: &Case, held: bool) -> Option<f64> {
    match (grips(case)?.axial, held) {
        (Axial::Force(value), false) | (Axial::Extension(value), true) => Some(value),
        _ => None,
    }
}

/// Moment given, or rotation held.
fn around(case: &Case, held: bool) -> Option<f64> {
    match (grips(case)?.turning, held) {
        (Turning::Moment(value), false) | (Turning::Rotation(value), true) => Some(value),
        _ => None,
    }
}

fn given_pretwist(case: &Case) -> Option<f64> {
    match twist_of(case)? {
        Twist::Pretwist(pretwist) => Some(pretwist),
        Twist::StrandTwist(_) => None,
    }
}

fn given_strand_twist(case: &Case) -> Option<f64> {
    match twist_of(case)? {
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

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "helpers of tests")]
    use super::super::{TraceReport, Walk};
    use super::*;
    use crate::Spec;

    fn walked(flags: &[(&str, &str)], to: &[(&str, &str)]) -> TraceReport {
        let corner = |flags: &[(&str, &str)], prefix| Spec::from_prefixed_flags(prefix, flags.iter().copied()).unwrap();
        let cases = corner(flags, "").check_path(Some(&corner(to, "to-"))).unwrap();
        TraceReport::of(cases, Walk::default()).unwrap()
    }

    /// Three strands pushed until they part are stable up to the force at which they part, and their curve is whole up to there.
    #[test]
    fn a_stretch_has_its_verdict_up_to_the_event_that_ends_it() {
        let report =
            walked(&[("strands", "3"), ("stiffness-ratio", "0.667"), ("pretwist", "-0.1885")], &[("force", "-0.5")]);
        let walked = report.stiff().unwrap();
        let parts = walked.events().find(|(_, event)| matches!(event.mark, Mark::ContactChange(_))).unwrap().1;
        let runs = walked.runs();
        let (name, dashed, run) = &runs[0];
        assert_eq!((*name, *dashed), ("stable", false));
        let reached = run.iter().map(|(_, station)| station.load.force).fold(0.0, f64::min);
        assert!((reached - parts.station.load.force).abs() < 1e-9, "{reached} {}", parts.station.load.force);
        // and the next begins where it ends
        assert_eq!(runs[1].2[0].1.load, run.last().unwrap().1.load);
    }
}
