//! Strings on a motor: what `nply actuator` says.

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nply::mechanics::{ConstantRadius, Ply, Twist, TwistedStrings};
use nply::{DomainError, Handedness, Scale};
use serde_json::{Map, Value, json};

use super::csv::unit_suffix;
use super::item::{Item, Reader, item};
use super::json::header;
use super::text::{Emphasis, Row, lay_out};
use super::{Known, Measure};
use crate::preferred::{six_digits, six_digits_within};
use crate::{Dimension, ErrorKind, Place, Quantity, SpecError, Strings};

/// Stroke, torque, gear ratio and tension as a motor turns, up to given turns or to the most that go in, beside the formula of a constant
/// radius.
///
/// ```
/// use nply_sheet::{Spec, StringsReport};
/// let flags = [("strands", "2"), ("radius", "0.5 mm"), ("strand-length", "0.5 m"), ("force", "20 N"), ("ply-turns", "100")];
/// let report = StringsReport::of(Spec::from_flags(flags)?.check_strings()?, 10)?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// let length = json["steps"][10]["length"].as_f64().unwrap_or(0.0);
/// let angle: f64 = 100.0 * core::f64::consts::TAU;
/// assert!((length - (0.5_f64.powi(2) - (angle * 0.5e-3).powi(2)).sqrt()).abs() < 1e-12); // √(L² − θ²r²)
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StringsReport {
    strings: Strings,
    steps: Vec<Step>,
    most: TwistedStrings,
    formula: ConstantRadius,
    known: Known,
}

/// What a motor is to do, given in place of its turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StringsGoal {
    /// How far the load comes, m.
    Stroke(f64),
    /// What the motor holds, of limp strings, N m.
    Torque(f64),
    /// The pull in each string, N.
    Tension(f64),
}

impl StringsGoal {
    /// `stroke`, `torque` or `tension` with a number and its unit.
    ///
    /// # Errors
    /// [`SpecError`] at the flag of that name.
    pub fn read(name: &str, text: &str) -> Result<Self, SpecError> {
        let (dimension, example, of): (_, _, fn(f64) -> Self) = match name {
            "stroke" => (Dimension::LENGTH, "30 mm", Self::Stroke),
            "torque" => (Dimension::MOMENT, "5 N mm", Self::Torque),
            _ => (Dimension::FORCE, "12 N", Self::Tension),
        };
        let refuse = |kind, message| SpecError::new(kind, Place::Flag(name.to_owned()), message);
        match Quantity::parse(text).map_err(|why| refuse(ErrorKind::Syntax, why.to_string()))? {
            Quantity::Measured { si, unit } if unit.dimension() == dimension && si > 0.0 => Ok(of(si)),
            read => {
                let wrong = match read {
                    Quantity::Bare(_) => format!("{} has no unit", crate::quoted(text)),
                    Quantity::Measured { .. } => format!("{} is no {name}", crate::quoted(text)),
                };
                let message = format!("{wrong}: what is wanted is {dimension} greater than 0, such as \"{example}\"");
                Err(refuse(ErrorKind::WrongUnit, message))
            }
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Stroke(_) => "stroke",
            Self::Torque(_) => "torque",
            Self::Tension(_) => "tension",
        }
    }
}

/// One position of the motor. Lengths in r, forces in N, moments in N r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Step {
    /// of the motor
    turns: f64,
    limp: TwistedStrings,
    /// L/r
    length: f64,
    force: f64,
    stiff: Option<Stiff>,
    formula: ConstantRadius,
}

/// What strings with stiffness do.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stiff {
    moment: f64,
    /// whether touching neighbours would have to pull on each other
    separated: bool,
}

impl Step {
    fn rotation(&self) -> f64 {
        self.limp.rotation()
    }

    fn separated(&self) -> bool {
        self.stiff.is_some_and(|stiff| stiff.separated)
    }

    /// Motor turns, for a sentence.
    fn turns(&self) -> String {
        six_digits(self.turns)
    }
}

pub(super) const STEP: &[Item<Step>] = {
    use Measure::{Degrees, Force, Length, Moment, Percent, Turns};
    &[
        item("", "motor_turns", "motor", Turns, |s| Some(s.turns)),
        item("", "helical_angle_deg", "angle", Degrees, |s| Some(s.limp.contact().angle().degrees())),
        item("", "length", "length", Length, |s| Some(s.length * s.limp.extension())),
        item("", "stroke", "stroke", Length, |s| Some(s.length * s.limp.contraction())),
        item("", "stroke_percent", "stroke", Percent, |s| Some(100.0 * s.limp.contraction())),
        item("", "stroke_per_turn", "stroke/turn", Length, |s| Some(TAU * s.limp.lever())),
        item("", "torque", "torque", Moment, |s| Some(s.force * s.limp.lever())),
        item("", "stiff_torque", "torque, stiff", Moment, |s| {
            s.stiff.filter(|stiff| !stiff.separated).map(|stiff| stiff.moment)
        }),
        item("", "string_tension", "tension", Force, |s| Some(s.force * s.limp.string_tension())),
        item("", "constant_radius_stroke", "stroke (R const)", Length, |s| {
            Some(s.length * (1.0 - s.formula.extension(s.rotation())?))
        }),
        item("", "constant_radius_torque", "torque (R const)", Moment, |s| {
            Some(s.force * s.formula.lever(s.rotation())?)
        }),
    ]
};

impl StringsReport {
    /// Steps of the motor when nothing else is said.
    pub const STEPS: usize = 10;

    /// From no turns to those given, or to the most that go in, in `steps` equal steps (1 at least).
    ///
    /// # Errors
    /// [`SpecError`] where the theory refuses a stiffness or a load.
    pub fn of(strings: Strings, steps: usize) -> Result<Self, SpecError> {
        let located = |error: DomainError| strings.locate(&error);
        let most = TwistedStrings::most_turns(strings.strands).map_err(located)?;
        let formula = ConstantRadius::new(strings.strands).map_err(located)?;
        // moments in N r come out of forces in N
        let radius = strings.strand_radius;
        let scale = Scale::new(radius, radius * radius).map_err(located)?;
        let known = Known { scale: Some(scale), strand_radius: Some(radius) };
        let steps = steps.max(1);
        let step = |i: usize| -> Result<Step, DomainError> {
            let share = i as f64 / steps as f64;
            let limp = match strings.rotation {
                None if i == steps => most,
                None => TwistedStrings::new(strings.strands, share * most.rotation())?,
                Some(rotation) => TwistedStrings::new(strings.strands, share * rotation)?,
            };
            let stiff = stiff(&strings, &limp)?;
            let turns = strings
                .turns
                .map_or(limp.rotation() * strings.strand_length / TAU, |turns| turns * i as f64 / steps as f64);
            Ok(Step { turns, limp, length: strings.strand_length, force: strings.force, stiff, formula })
        };
        let steps: Vec<Step> = (0..=steps).map(step).collect::<Result<_, _>>().map_err(located)?;
        Ok(Self { strings, steps, most, formula, known })
    }

    /// From no turns to those at which the motor does what it is to.
    ///
    /// # Errors
    /// As [`of`](Self::of); and where turns are given too, or the goal is not reached, or passed before the first turn.
    ///
    /// ```
    /// use nply_sheet::{Spec, StringsGoal, StringsReport};
    /// let flags = [("strands", "2"), ("diameter", "1 mm"), ("strand-length", "0.5 m"), ("force", "20 N")];
    /// let report = StringsReport::up_to(Spec::from_flags(flags)?.check_strings()?, StringsGoal::Stroke(0.1), 10)?;
    /// let json: serde_json::Value = serde_json::from_str(&report.json())?;
    /// // p = √(L² − θ²r²) = 0.4 m at θ = 0.3 m/0.5 mm = 600 rad
    /// let turns = json["steps"][10]["motor_turns"].as_f64().unwrap_or(0.0);
    /// assert!((turns - 600.0 / core::f64::consts::TAU).abs() < 1e-10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn up_to(mut strings: Strings, goal: StringsGoal, steps: usize) -> Result<Self, SpecError> {
        let name = goal.name();
        let refuse = |kind, message: String| SpecError::new(kind, Place::Flag(name.to_owned()), message);
        if strings.rotation.is_some() {
            let message =
                format!("the turns of the motor are given, and those of a {name} are asked for: leave one of them out");
            return Err(refuse(ErrorKind::Contradiction, message));
        }
        let (n, radius, force) = (strings.strands, strings.strand_radius, strings.force);
        let length = strings.strand_length * radius;
        let reached = match goal {
            StringsGoal::Stroke(stroke) => TwistedStrings::reaching(n, TwistedStrings::contraction, stroke / length),
            StringsGoal::Torque(torque) => TwistedStrings::reaching(n, TwistedStrings::lever, torque / force / radius),
            StringsGoal::Tension(tension) => {
                TwistedStrings::reaching(n, TwistedStrings::string_tension, tension / force)
            }
        };
        let turned = |reached: &TwistedStrings| reached.rotation() > 0.0;
        let Some(reached) = reached.map_err(|error| strings.locate(&error))?.filter(turned) else {
            // rounding of a share of the load is no tension beyond it
            let share = (1.0 + 4.0 * f64::EPSILON) * force / f64::from(n);
            let message = match goal {
                StringsGoal::Tension(tension) if tension <= share => {
                    let share = strings.units.format(Dimension::FORCE, force / f64::from(n));
                    format!(
                        "the load alone pulls each string by {share}, before any turn: a {name} that turns make is greater"
                    )
                }
                StringsGoal::Torque(_) | StringsGoal::Tension(_) => format!(
                    "such a {name} comes with no turns that can be told from none or from the most, next to which it is without bound"
                ),
                StringsGoal::Stroke(_) => {
                    let most = TwistedStrings::most_turns(n).map_err(|error| strings.locate(&error))?;
                    let most = strings.units.format(Dimension::LENGTH, length * most.contraction());
                    format!("the strokes of these strings are between 0 and that of the most turns, {most}")
                }
            };
            return Err(refuse(ErrorKind::Domain, message));
        };
        strings.rotation = Some(reached.rotation());
        Self::of(strings, steps)
    }

    /// Columns that have a value anywhere.
    fn columns(&self) -> impl Iterator<Item = &'static Item<Step>> {
        STEP.iter().filter(|item| self.steps.iter().any(|step| item.of(step).is_some()))
    }

    /// As an aligned table, with a bold heading if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = &Emphasis(emphasis);
        let strings = &self.strings;
        let reader = Reader { known: self.known, units: &strings.units, emphasis };
        let mut out = String::new();
        let title = strings
            .title
            .as_ref()
            .map_or_else(String::new, |title| format!("{}: ", title.replace(|c: char| c.is_control(), " ")));
        let kind = if strings.stiffness.is_some() { "strings" } else { "limp strings" };
        let way = match strings.handedness {
            Handedness::Right => "Z",
            Handedness::Left => "S",
        };
        let force = strings.units.format(Dimension::FORCE, strings.force);
        let headline = format!("{title}{} {kind} under {force}, turned {way}", strings.strands);
        let _ = writeln!(out, "{}", emphasis.heading(&headline));
        let mut columns: Vec<Row> = self.columns().filter_map(|item| reader.row(item, "", &self.steps, &[])).collect();
        if columns.is_empty() {
            return out;
        }
        let first = columns.remove(0);
        let row = |label: &str, cells: Vec<String>| Row { label: label.to_owned(), unit: String::new(), cells };
        let mut rows = vec![
            row(&first.label, columns.iter().map(|column| column.label.clone()).collect()),
            row(&first.unit, columns.iter().map(|column| column.unit.clone()).collect()),
        ];
        for (i, label) in first.cells.iter().enumerate() {
            rows.push(row(label, columns.iter().map(|column| column.cells[i].clone()).collect()));
        }
        lay_out(&mut out, &[("", rows)], emphasis);
        for note in self.notes() {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    /// The greatest turns, by contact and by the formula.
    fn limits(&self) -> [(f64, f64); 2] {
        let turns = |rotation: f64| rotation * self.strings.strand_length / TAU;
        [
            (turns(self.most.rotation()), self.most.contact().angle().degrees()),
            (turns(self.formula.most_turns()), self.formula.steepest().degrees()),
        ]
    }

    fn notes(&self) -> Vec<String> {
        let [(most, angle), (formula, steepest)] = self.limits();
        let stroke = 100.0 * self.most.contraction();
        let mut notes = vec![
            format!(
                "The most turns are {}, at {angle:.4}° and a stroke of {stroke:.2} %: there the torque has no bound, and more do not go \
                 in. The formula of a constant radius goes on to {} turns, {steepest:.2}°.",
                six_digits_within(most),
                six_digits_within(formula),
            ),
            if self.strings.strands == 2 {
                "For two strings that formula, L² = p² + (θr)², is exact up to 45°; beyond, they push each other apart.".to_owned()
            } else {
                "That formula leaves out that more than two strings take a greater radius as they are turned.".to_owned()
            },
            match self.strings.stiffness {
                None => "Limp strings: no stiffness against bending and twisting, no stretch, no friction. Torque is force times \
                         stroke per angle."
                    .to_owned(),
                Some(_) => "The torque of stiff strings (bent, and twisted unless their ends swivel) is for motor and \
                            load alone: no stretch, no friction. Angle and stroke are those of limp strings, as contact leaves no other; the \
                            tension is theirs too."
                    .to_owned(),
            },
        ];
        let parted: Vec<String> = self.steps.iter().filter(|step| step.separated()).map(Step::turns).collect();
        if !parted.is_empty() {
            notes.push(format!(
                "At {} turns of the motor stiff strings do not stay together: touching neighbours would have to pull on each other \
                 (p₁ < 0). Their torque is left out; `nply support` finds what they do.",
                parted.join(", ")
            ));
        }
        if let Some(share) = self.strings.packing_fraction {
            notes.push(super::packing_of(share));
        }
        notes
    }

    /// One row a step, in SI; where there is no bound, nothing stands.
    #[must_use]
    pub fn csv(&self) -> String {
        let unit = |item: &Item<Step>| item.measure.si(self.known).map_or("", |(_, unit)| unit);
        let name = |item: &Item<Step>| match unit(item) {
            "" => item.name.to_owned(),
            unit => format!("{}_{}", item.name, unit_suffix(unit)),
        };
        // what stands in the table is looked up once
        let columns: Vec<&Item<Step>> = self.columns().collect();
        let mut out = columns.iter().map(|item| name(item)).collect::<Vec<_>>().join(",") + "\n";
        for step in &self.steps {
            let cell = |item: &Item<Step>| self.si(item, step).map_or_else(String::new, |value| format!("{value:?}"));
            out += &(columns.iter().map(|item| cell(item)).collect::<Vec<_>>().join(",") + "\n");
        }
        out
    }

    fn si(&self, item: &Item<Step>, step: &Step) -> Option<f64> {
        Some(item.of(step)? * item.measure.si(self.known).map_or(1.0, |(factor, _)| factor))
    }

    /// As JSON, in SI; what has no bound is null.
    #[must_use]
    pub fn json(&self) -> String {
        let strings = &self.strings;
        let mut top = header();
        if let Some(title) = &strings.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("strands".into(), json!(strings.strands));
        top.insert("strand_radius_m".into(), json!(strings.strand_radius));
        top.insert("strand_length_m".into(), json!(strings.strand_length * strings.strand_radius));
        top.insert("force_N".into(), json!(strings.force));
        top.extend(super::item::of_hand(strings.handedness));
        let [(most, angle), (formula, steepest)] = self.limits();
        top.insert("most_turns".into(), json!({ "motor_turns": most, "helical_angle_deg": angle }));
        top.insert(
            "constant_radius_most_turns".into(),
            json!({ "motor_turns": formula, "helical_angle_deg": steepest }),
        );
        let units: Map<String, Value> = self
            .columns()
            .filter_map(|item| Some((item.name.to_owned(), json!(item.measure.si(self.known)?.1))))
            .collect();
        top.insert("si_units".into(), Value::Object(units));
        let columns: Vec<&Item<Step>> = self.columns().collect();
        let step = |step: &Step| {
            let mut object: Map<String, Value> =
                columns.iter().map(|item| (item.name.to_owned(), json!(self.si(item, step)))).collect();
            if let Some(stiff) = step.stiff {
                object.insert("separated".into(), json!(stiff.separated));
            }
            Value::Object(object)
        };
        top.insert("steps".into(), self.steps.iter().map(step).collect());
        top.insert("notes".into(), json!(self.notes()));
        format!("{:#}\n", Value::Object(top))
    }
}

/// Strings with stiffness: their moment, in N r, is positive the way the motor turns. `None` for limp ones.
fn stiff(strings: &Strings, limp: &TwistedStrings) -> Result<Option<Stiff>, DomainError> {
    let Some(stiffness) = strings.stiffness else { return Ok(None) };
    let (unit, sign) = (stiffness.scale.force(1.0), strings.handedness.sign());
    if limp.lever().is_infinite() {
        return Ok(Some(Stiff { moment: f64::INFINITY, separated: false }));
    }
    if limp.rotation() == 0.0 {
        // straight strings hold the twist they came with
        let (Twist::Pretwist(held) | Twist::StrandTwist(held)) = stiffness.twist;
        let moment = f64::from(strings.strands) * stiffness.stiffness_ratio * held;
        return Ok(Some(Stiff { moment: sign * moment * unit, separated: false }));
    }
    let ply = Ply::new(strings.strands, stiffness.stiffness_ratio)?;
    let state = ply.moment_at(limp.contact().angle(), strings.handedness, stiffness.twist, strings.force / unit)?;
    Ok(Some(Stiff { moment: sign * state.load().moment * unit, separated: state.is_separated() }))
}
