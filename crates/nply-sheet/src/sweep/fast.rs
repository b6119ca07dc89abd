//! Rows that need no description of their own: their numbers go straight into arrays.
//!
//! What is not plain (no whole number of strands, an angle out of range, an empty cell) is left to the general way, row by row, which knows
//! the words for it. Which way a row goes depends on the row alone.

use core::f64::consts::{FRAC_PI_2, TAU};

use nply::geometry::contact_batch;
use nply::mechanics::{Balance, Load, Plies, States as Batch, Twist, Twists};

use super::States;
use super::ask::Output;
use super::plan::{GivenKey, Plan};
use super::sink::{Answers, Sink, reasons};
use crate::key::Group;
use crate::report::{Found, Given, Known, StateKind};
use crate::spec::{Entry, Spec, Value};
use crate::table::{Kind as Cells, Values};
use crate::{Case, Datum, Lay, Place, Quantity, Question, Unit};

/// How the rows of a study go into arrays, if they do.
#[derive(Clone, Debug)]
pub(super) enum Fast {
    None,
    Contact(Box<Contacts>),
    Touching(Box<Equilibria>),
}

impl Fast {
    pub(super) fn of(kind: StateKind, states: States, given: &[GivenKey], rest: &Spec, outputs: &[Output]) -> Self {
        match kind {
            StateKind::Contact => {
                Contacts::of(given, rest, outputs).map_or(Self::None, |it| Self::Contact(Box::new(it)))
            }
            StateKind::Touching if states != States::Continued => {
                Equilibria::of(given, rest).map_or(Self::None, |it| Self::Touching(Box::new(it)))
            }
            _ => Self::None,
        }
    }
}

/// Where a number comes from: the same for all rows, or a column, in SI where it has a unit.
#[derive(Clone, Debug)]
enum Source {
    Fixed(f64),
    Column(usize, Option<Unit>),
}

impl Source {
    /// The number of a row; NaN where there is none.
    #[inline]
    fn at(&self, cells: &[Values], row: usize) -> f64 {
        match self {
            Self::Fixed(value) => *value,
            Self::Column(at, unit) => {
                let value = match cells.get(*at) {
                    Some(Values::Dense(cells)) => cells.get(row).copied(),
                    Some(Values::Float(cells)) => cells.get(row).copied().flatten(),
                    Some(Values::Counts(cells)) => cells.get(row).map(|value| *value as f64),
                    Some(Values::Integer(cells)) => cells.get(row).copied().flatten().map(|value| value as f64),
                    // of a file of text
                    Some(Values::Text(cells)) => {
                        cells.get(row).and_then(Option::as_deref).and_then(|text| text.trim().parse().ok())
                    }
                    _ => None,
                };
                let value = value.unwrap_or(f64::NAN);
                unit.as_ref().map_or(value, |unit| unit.to_si(value))
            }
        }
    }

    /// The source of a datum: its column, if there is one.
    fn column(given: &[GivenKey], datum: Datum) -> Option<Self> {
        let at = given.iter().position(|given| given.key.datum == datum)?;
        Some(Self::Column(at, given[at].unit.clone()))
    }
}

/// Whether every given datum is one of these, in a unit of its own kind.
fn only(given: &[GivenKey], data: &[Datum]) -> bool {
    given.iter().all(|given| {
        let plain = given.unit.as_ref().is_none_or(|unit| given.key.kind.dimension() == Some(unit.dimension()));
        plain && data.contains(&given.key.datum)
    })
}

/// A number of strands, if it is one; as [`crate::case::strands`] has it.
#[inline]
fn strands(value: f64) -> Option<u32> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole and between 2 and a million")]
    let whole = |value: f64| value as u32;
    ((2.0..=1e6).contains(&value) && value.fract() == 0.0).then(|| whole(value))
}

/// Shapes of given lays.
#[derive(Clone, Debug)]
pub(super) struct Contacts {
    strands: Source,
    /// r in m, or 2r
    size: Option<(Source, bool)>,
    lay: Datum,
    measured: bool,
    angle: Source,
    /// what x and ρ give, in the order of the outputs; none where more is asked
    kernel: Option<Vec<Told>>,
}

/// An answer that x, ρ and θ give without more.
#[derive(Clone, Copy, Debug)]
enum Told {
    HelicalAngle,
    PitchAngle,
    RadiusRatio,
    OuterDiameter,
    ArclengthShift,
    Strands,
}

/// Lays that are no angle are turned into one first, by the general way for one ply.
const LAYS: [Datum; 6] =
    [Datum::HelicalAngle, Datum::LayAngle, Datum::PitchAngle, Datum::LayLength, Datum::LayRatio, Datum::RadiusRatio];

impl Contacts {
    fn of(given: &[GivenKey], rest: &Spec, outputs: &[Output]) -> Option<Self> {
        let known = [&LAYS[..], &[Datum::Strands, Datum::Radius, Datum::Diameter]].concat();
        let only_these = only(given, &known);
        let twice = |group: Group| given.iter().filter(|given| given.key.group == Some(group)).count() > 1;
        // what gives a size otherwise, or a lay and a size at once
        let more = [Datum::LinearDensity, Datum::HelixRadius, Datum::CoreRadius, Datum::CoreDiameter];
        if !only_these || twice(Group::Lay) || twice(Group::Size) || more.iter().any(|datum| rest.get(*datum).is_some())
        {
            return None;
        }
        let fixed = |datum: Datum| rest.get(datum).map(Entry::number);
        let source = |datum| Source::column(given, datum).or_else(|| fixed(datum).map(Source::Fixed));
        let is_measured = |datum: Datum| match given.iter().find(|given| given.key.datum == datum) {
            Some(given) => given.unit.is_some(),
            None => rest.get(datum).is_some_and(Entry::is_measured),
        };
        let sizes: Vec<Datum> =
            [Datum::Radius, Datum::Diameter].into_iter().filter(|datum| source(*datum).is_some()).collect();
        let lays: Vec<Datum> = LAYS.into_iter().filter(|datum| source(*datum).is_some()).collect();
        let ([] | [_], [lay]) = (&sizes[..], &lays[..]) else { return None };
        let size = sizes.first().and_then(|datum| Some((source(*datum)?, *datum == Datum::Diameter)));
        if sizes.iter().any(|datum| !is_measured(*datum)) {
            return None;
        }
        // a length goes with a size, a bare one without
        if *lay == Datum::LayLength && is_measured(*lay) != size.is_some() {
            return None;
        }
        // the hand beside a turning is no matter of shape, but must not contradict
        if rest.get(Datum::PlyTurnsPerLength).is_some() {
            return None;
        }
        let told = |output: &Output| {
            Some(match output.name() {
                "helical_angle_deg" => Told::HelicalAngle,
                "pitch_angle_deg" => Told::PitchAngle,
                "radius_ratio" | "ply_radius" => Told::RadiusRatio,
                "outer_diameter" => Told::OuterDiameter,
                "arclength_shift" => Told::ArclengthShift,
                "strands" => Told::Strands,
                _ => return None,
            })
        };
        let by_angle = matches!(lay, Datum::HelicalAngle | Datum::LayAngle);
        let kernel = outputs.iter().map(told).collect::<Option<Vec<Told>>>().filter(|_| by_angle);
        Some(Self {
            strands: source(Datum::Strands)?,
            size,
            lay: *lay,
            measured: is_measured(*lay),
            angle: source(*lay)?,
            kernel,
        })
    }

    /// Whether x and ρ are all that is asked.
    pub(super) const fn is_kernel(&self) -> bool {
        self.kernel.is_some()
    }

    /// r in m; none where it is no size, and the outer none where that is wrong.
    #[inline]
    fn radius(&self, cells: &[Values], row: usize) -> Option<Option<f64>> {
        let Some((source, is_diameter)) = &self.size else { return Some(None) };
        let given = source.at(cells, row);
        let radius = if *is_diameter { given / 2.0 } else { given };
        (radius > 0.0 && given < f64::INFINITY).then_some(Some(radius))
    }

    /// All columns at once.
    pub(super) fn solve(&self, plan: &Plan, cells: &[Values], rows: usize) -> Answers {
        let mut count: Vec<u32> = Vec::with_capacity(rows);
        let mut angle: Vec<f64> = Vec::with_capacity(rows);
        let mut radius: Vec<Option<f64>> = Vec::with_capacity(if self.size.is_some() { rows } else { 0 });
        let mut odd: Vec<usize> = Vec::new();
        for row in 0..rows {
            let theta = self.angle.at(cells, row);
            let n = strands(self.strands.at(cells, row));
            let size = self.radius(cells, row);
            let (n, theta, size) = match (n, size) {
                (Some(n), Some(size)) if (0.0..FRAC_PI_2).contains(&theta) => (n, theta, size),
                _ => {
                    odd.push(row);
                    (2, 0.0, None)
                }
            };
            count.push(n);
            angle.push(theta);
            if self.size.is_some() {
                radius.push(size);
            }
        }
        let (mut shift, mut ratio) = (vec![0.0; rows], vec![0.0; rows]);
        let lengths = contact_batch(&count, &angle, &mut shift, &mut ratio, |row, _| odd.push(row));
        if lengths.is_err() || odd.len() > rows / 2 {
            // so many words take their time anyway
            odd = (0..rows).collect();
        }
        let known = |row: usize| Known { scale: None, strand_radius: radius.get(row).copied().flatten() };
        let outputs: Vec<Values> = plan
            .outputs
            .iter()
            .zip(self.kernel.iter().flatten())
            .map(|(output, told)| {
                let numbers: Vec<f64> = match told {
                    Told::HelicalAngle => angle.iter().map(|theta| degrees(*theta)).collect(),
                    Told::PitchAngle => angle.iter().map(|theta| pitch_degrees(*theta)).collect(),
                    Told::RadiusRatio => ratio.clone(),
                    Told::OuterDiameter => ratio.iter().map(|rho| 2.0 * (rho + 1.0)).collect(),
                    Told::ArclengthShift => shift.clone(),
                    Told::Strands => return Values::Counts(count.iter().map(|n| i64::from(*n)).collect()),
                };
                let fixed = if radius.is_empty() { output.factor(Known::default()) } else { None };
                Values::Dense(match fixed {
                    Some(1.0) => numbers,
                    Some(factor) => numbers.iter().map(|number| number * factor).collect(),
                    None => numbers
                        .iter()
                        .enumerate()
                        .map(|(row, number)| number * output.factor(known(row)).unwrap_or(f64::NAN))
                        .collect(),
                })
            })
            .collect();
        let answers =
            Answers { places: (0..rows).collect(), state: None, outputs, reason: Values::Nothing(Cells::Text, rows) };
        if odd.is_empty() { answers } else { mended(plan, cells, answers, odd) }
    }

    /// Row by row, where more is asked than x and ρ.
    pub(super) fn each(&self, plan: &Plan, cells: &[Values], rows: usize, sink: &mut Sink<'_>) {
        for row in 0..rows {
            let Some((contact, radius)) = self.contact(cells, row) else {
                plan.one(cells, row, sink);
                continue;
            };
            let given =
                Given { strands: contact.strands(), stiffness_ratio: f64::NAN, strand_length: None, parts: false };
            let known = Known { scale: None, strand_radius: radius };
            sink.push(row, None, Found::Contact(&contact), &given, known);
        }
    }

    fn contact(&self, cells: &[Values], row: usize) -> Option<(nply::geometry::Contact, Option<f64>)> {
        let radius = self.radius(cells, row)?;
        let value = self.angle.at(cells, row);
        let positive = Some(value).filter(|value| *value > 0.0 && *value < f64::INFINITY);
        let lay = match self.lay {
            Datum::PitchAngle => Lay::PitchAngle(positive.filter(|value| *value <= FRAC_PI_2)?),
            Datum::LayLength if self.measured => Lay::LayLength(positive? / radius?),
            Datum::LayLength => Lay::LayLength(positive?),
            Datum::LayRatio => Lay::LayRatio(positive?),
            Datum::RadiusRatio => Lay::RadiusRatio(positive?),
            _ => Lay::HelicalAngle(Some(value).filter(|value| (0.0..FRAC_PI_2).contains(value))?),
        };
        Some((lay.contact(strands(self.strands.at(cells, row))?).ok()?, radius))
    }
}

/// The angle in degrees, as [`nply::geometry::HelicalAngle::degrees`].
fn degrees(theta: f64) -> f64 {
    if theta <= core::f64::consts::FRAC_PI_4 { theta.to_degrees() } else { 90.0 - pitch_degrees(theta) }
}

fn pitch_degrees(theta: f64) -> f64 {
    const REST: f64 = 6.123_233_995_736_766e-17; // of π/2 as a double
    ((FRAC_PI_2 - theta) + REST).to_degrees()
}

/// Answers in which some rows are worked out the general way.
fn mended(plan: &Plan, cells: &[Values], answers: Answers, mut odd: Vec<usize>) -> Answers {
    odd.sort_unstable();
    odd.dedup();
    let mut sink = Sink::new(&plan.outputs, odd.len());
    for row in &odd {
        plan.one(cells, *row, &mut sink);
    }
    let other = sink.finish(false);
    let outputs = answers.outputs.into_iter().zip(other.outputs).map(|(own, other)| match (own, other) {
        (Values::Dense(own), Values::Float(other)) => {
            let mut cells: Vec<Option<f64>> = own.into_iter().map(Some).collect();
            for (row, value) in odd.iter().zip(other) {
                cells[*row] = value;
            }
            Values::Float(cells)
        }
        (Values::Counts(own), Values::Integer(other)) => {
            let mut cells: Vec<Option<i64>> = own.into_iter().map(Some).collect();
            for (row, value) in odd.iter().zip(other) {
                cells[*row] = value;
            }
            Values::Integer(cells)
        }
        (own, _) => own,
    });
    let outputs = outputs.collect();
    let said = match other.reason {
        Values::Text(cells) => odd.iter().zip(cells).filter_map(|(row, reason)| Some((*row, reason?))).collect(),
        _ => Vec::new(),
    };
    let length = answers.places.len();
    Answers { outputs, reason: reasons(said, length), ..answers }
}

/// Touching strands with given twist and loads.
#[derive(Clone, Debug)]
pub(super) struct Equilibria {
    balance: Balance,
    known: Known,
    strand_length: Option<f64>,
    strands: Source,
    stiffness_ratio: Source,
    twist: (Datum, Source, bool),
    force: (Source, bool),
    moment: (Source, bool),
}

impl Equilibria {
    fn of(given: &[GivenKey], rest: &Spec) -> Option<Self> {
        const TWISTS: [Datum; 4] = [Datum::Pretwist, Datum::SurfaceAngle, Datum::TurnsPerLength, Datum::StrandTwist];
        let own = [Datum::Strands, Datum::StiffnessRatio, Datum::Force, Datum::Moment];
        if !only(given, &[&TWISTS[..], &own].concat()) {
            return None;
        }
        // a row of plain numbers shows what is the same for all
        let place = Place::Flag("row".to_owned());
        let mut plain = rest.clone();
        for given in given {
            let value = match given.key.datum {
                Datum::Strands => 3.0,
                Datum::StiffnessRatio => 1.0,
                _ => 0.0,
            };
            let value = Value::Quantity(match &given.unit {
                Some(unit) => Quantity::Measured { si: value, unit: unit.clone() },
                None => Quantity::Bare(value),
            });
            plain.entries.push(Entry { key: given.key, value, place: place.clone(), written: String::new() });
        }
        let case: Case = plain.check().ok()?;
        let Question::States { twist, load: fixed } = case.question else { return None };
        if case.external_pressure.is_some() {
            return None;
        }
        let column = |datum| Source::column(given, datum);
        let measured = |datum| given.iter().any(|given| given.key.datum == datum && given.unit.is_some());
        let mut twists = TWISTS.into_iter().filter_map(|datum| Some((datum, column(datum)?, measured(datum))));
        let twist = match (twists.next(), twists.next()) {
            (Some(_), Some(_)) => return None,
            (Some(found), None) => found,
            (None, _) => match twist {
                Twist::Pretwist(value) => (Datum::Pretwist, Source::Fixed(value), false),
                Twist::StrandTwist(value) => (Datum::StrandTwist, Source::Fixed(value), false),
            },
        };
        // a fixed load is dimensionless already
        let load = |datum, value: f64, scaled: bool| match column(datum) {
            Some(source) => (source, scaled),
            None => (Source::Fixed(value), false),
        };
        Some(Self {
            balance: case.balance,
            known: Known::of(&case),
            strand_length: case.strand_length,
            strands: column(Datum::Strands).unwrap_or(Source::Fixed(f64::from(case.strands))),
            stiffness_ratio: column(Datum::StiffnessRatio).unwrap_or(Source::Fixed(case.stiffness_ratio)),
            twist,
            force: load(Datum::Force, fixed.force, measured(Datum::Force)),
            moment: load(Datum::Moment, fixed.moment, measured(Datum::Moment)),
        })
    }

    /// The numbers of a row; none where a word is needed.
    #[inline]
    fn numbers(&self, cells: &[Values], row: usize) -> Option<(u32, f64, f64, Load)> {
        let n = strands(self.strands.at(cells, row))?;
        let gamma = self.stiffness_ratio.at(cells, row);
        let (datum, source, measured) = &self.twist;
        let given = source.at(cells, row);
        let per_length = || self.known.strand_radius.map(|radius| given / (1.0 / radius));
        let twist = match (datum, measured) {
            (Datum::SurfaceAngle, _) => (given > -FRAC_PI_2 && given < FRAC_PI_2).then(|| libm::tan(given))?,
            (Datum::TurnsPerLength, true) | (Datum::StrandTwist, true) => per_length()?,
            // nothing is nothing in every unit
            (Datum::TurnsPerLength, false) if self.known.strand_radius.is_some() && given != 0.0 => return None,
            (Datum::TurnsPerLength, false) => TAU * given,
            _ => given,
        };
        let load = |(source, measured): &(Source, bool), unit: &dyn Fn(nply::Scale) -> f64| {
            let value = source.at(cells, row);
            match (measured, self.known.scale) {
                (true, scale) => Some(value / unit(scale?)),
                (false, Some(_)) if matches!(source, Source::Column(..)) && value != 0.0 => None,
                (false, _) => Some(value),
            }
        };
        let force = load(&self.force, &|scale| scale.force(1.0))?;
        let moment = load(&self.moment, &|scale| scale.moment(1.0))?;
        let finite = gamma > 0.0 && [gamma, twist, force, moment].iter().all(|value| value.is_finite());
        finite.then_some((n, gamma, twist, Load { force, moment }))
    }

    pub(super) fn solve(&self, plan: &Plan, cells: &[Values], rows: usize, sink: &mut Sink<'_>) {
        let mut odd = vec![false; rows];
        let (mut n, mut gamma) = (vec![2_u32; rows], vec![1.0; rows]);
        let (mut twist, mut force, mut moment) = (vec![0.0; rows], vec![0.0; rows], vec![0.0; rows]);
        for row in 0..rows {
            match self.numbers(cells, row) {
                Some((strands, ratio, given, load)) => {
                    (n[row], gamma[row], twist[row], force[row], moment[row]) =
                        (strands, ratio, given, load.force, load.moment);
                }
                None => odd[row] = true,
            }
        }
        let twists =
            if self.twist.0 == Datum::StrandTwist { Twists::StrandTwist(&twist) } else { Twists::Pretwist(&twist) };
        let plies = Plies { strands: &n, stiffness_ratio: &gamma, twist: twists, force: &force, moment: &moment };
        let mut states = Batch::new();
        let lengths = plies.equilibria(self.balance, &mut states);
        for (row, _) in states.refused() {
            odd[*row] = true;
        }
        let mut list = Vec::with_capacity(8);
        for row in 0..rows {
            if odd[row] || lengths.is_err() {
                plan.one(cells, row, sink);
                continue;
            }
            list.clear();
            list.extend(states.row(row).filter_map(|at| plies.equilibrium(self.balance, &states, row, at)));
            let found: Vec<Found<'_>> = list.iter().map(Found::Touching).collect();
            let given =
                Given { strands: n[row], stiffness_ratio: gamma[row], strand_length: self.strand_length, parts: false };
            plan.tell(row, &found, &given, self.known, sink);
        }
    }
}
