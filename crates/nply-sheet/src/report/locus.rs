//! The loads under which touching strands part, as a curve in the plane of force and moment.

use core::f64::consts::FRAC_PI_4;
use core::fmt::Write as _;

use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Balance, Load, Locus, Ply, Twist};
use nply::{DomainError, Handedness};
use serde_json::{Map, Value, json};

use super::csv::unit_suffix;
use super::json::header;
use super::text::{Emphasis, Row, hand, lay_out};
use super::{Known, Measure, Reading};
use crate::preferred::six_digits;
use crate::{Case, ErrorKind, Question, SpecError};

/// The locus p = 0 of a given twist, for both hands: the loads on whose far side neighbours would have to pull on each other.
///
/// It is the same in both balances. Loads are dimensionless, as in [`nply::mechanics`].
///
/// ```
/// use nply::Handedness::Right;
/// use nply_sheet::{LocusReport, Spec};
/// let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")];
/// let report = LocusReport::of(&Spec::from_flags(flags)?.check()?, 200)?;
/// let straight = report.curve(Right).next().expect("200 points").1;
/// assert!((straight.moment + 0.45).abs() < 1e-15); // the square of Figure 10: m = nγφ̄a
/// assert_eq!(report.csv().lines().count(), 1 + 2 * 200);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LocusReport {
    case: Case,
    twist: Twist,
    locus: Locus,
    special: Vec<SpecialPoint>,
}

/// A point of the locus that has a name.
///
/// ```
/// use nply_sheet::{LocusReport, Spec};
/// let flags = [("strands", "3"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")];
/// let report = LocusReport::of(&Spec::from_flags(flags)?.check()?, 2)?;
/// let turning = report.special_points().iter().find(|point| point.name == "force_turns").expect("it turns");
/// assert!((turning.angle.degrees() - 43.99).abs() < 0.01);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct SpecialPoint {
    /// `straight` (θ = 0), `diagonal` (θ = 45°), `rings` (θ = 90°), `force_turns` or `moment_turns` (the force, or the moment, is greatest
    /// or least among neighbouring angles).
    pub name: &'static str,
    /// Its name for a reader.
    pub label: &'static str,
    /// Which way the ply winds.
    pub handedness: Handedness,
    /// θ.
    pub angle: HelicalAngle,
    /// f and m.
    pub load: Load,
}

/// All loads that hold one angle of one hand: a straight line in the plane of force and moment.
///
/// ```
/// use nply::Handedness::Right;
/// use nply::geometry::HelicalAngle;
/// use nply_sheet::{LocusReport, Spec};
/// let flags = [("strands", "2"), ("stiffness-ratio", "0.75"), ("pretwist", "-0.2")];
/// let report = LocusReport::of(&Spec::from_flags(flags)?.check()?, 2)?;
/// let line = report.line_of_angle(HelicalAngle::new(0.5)?, Right)?;
/// // the moment rises by ρ tan θ per force; two strands in line contact have ρ = 1
/// assert!((line.direction.moment / line.direction.force - 0.5_f64.tan()).abs() < 1e-15);
/// assert_eq!(line.at(0.0), line.parting);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct AngleLine {
    /// The loads at which strands of this angle part.
    pub parting: Load,
    /// Towards loads that press neighbours together.
    pub direction: Load,
}

impl AngleLine {
    /// The loads that many directions from where the strands part; neighbours press where `steps` > 0.
    #[must_use]
    pub fn at(&self, steps: f64) -> Load {
        Load {
            force: self.parting.force + steps * self.direction.force,
            moment: self.parting.moment + steps * self.direction.moment,
        }
    }
}

impl LocusReport {
    /// How many points a curve has where nobody says how many.
    pub const POINTS: usize = 200;

    const MOST: usize = 10_000_000;

    /// The locus of a case's twist at `points` angles, of both hands; its loads, or its ends, are not looked at.
    ///
    /// # Errors
    /// [`SpecError`] where no twist is given, under an external pressure, and unless there are 2 to ten million points.
    pub fn of(case: &Case, points: usize) -> Result<Self, SpecError> {
        if !(2..=Self::MOST).contains(&points) {
            let message = format!("a curve has 2 to {} points, and {points} were asked for", Self::MOST);
            let place = crate::Place::Flag("points".to_owned());
            return Err(SpecError::new(ErrorKind::Domain, place, message).of_key("points"));
        }
        let located = |error| case.locate(&error);
        let twist = match case.question {
            Question::States { twist, .. }
            | Question::MomentAt { twist, .. }
            | Question::ForceAt { twist, .. }
            | Question::SeparationAtForce { twist, .. }
            | Question::SeparationAtMoment { twist, .. }
            | Question::Held { twist, .. }
            | Question::Supported { twist, .. } => twist,
            Question::PretwistAt { .. } => return Err(twist_missing(case)),
            Question::Stretched { .. } => return Err(super::stretch::not_here(case, "this curve")),
        };
        let ply = Ply::with_balance(case.strands, case.stiffness_ratio, case.balance)
            .and_then(|ply| ply.with_external_pressure(case.external_pressure.unwrap_or(0.0)))
            .map_err(located)?;
        let locus = ply.separation_locus(twist, points).map_err(located)?;
        let special = special_points(&ply, twist, &locus).map_err(located)?;
        Ok(Self { case: case.clone(), twist, locus, special })
    }

    /// Angle and loads along the locus of a hand, from straight strands to flat rings.
    pub fn curve(&self, handedness: Handedness) -> impl Iterator<Item = (HelicalAngle, Load)> {
        (0..self.locus.len()).map(move |i| self.locus.point(handedness, i))
    }

    /// The points that have a name, right-handed first, then by angle.
    #[must_use]
    pub fn special_points(&self) -> &[SpecialPoint] {
        &self.special
    }

    /// The line of all loads that hold an angle, in the case's balance: at each of its points the ply with this twist is in equilibrium
    /// at that angle.
    ///
    /// # Errors
    /// [`SpecError`] where no state has this angle; no angle of [`HelicalAngle`] is refused.
    pub fn line_of_angle(&self, angle: HelicalAngle, handedness: Handedness) -> Result<AngleLine, SpecError> {
        let Case { strands, stiffness_ratio, balance, .. } = self.case;
        let parting = Ply::with_balance(strands, stiffness_ratio, balance)
            .and_then(|ply| ply.separation_at(angle, handedness, self.twist))
            .map_err(|error| self.case.locate(&error))?;
        let contact: &Contact = parting.contact();
        let (s, c, rho) = (angle.sin(), angle.cos(), contact.radius_ratio());
        // f ρ sin θ = εm cos θ (1 − q) and what does not change, q without the neighbours' share 0
        let share = match balance {
            Balance::Contact => contact.shift_ratio_squared(),
            Balance::Radial => 0.0,
        };
        let direction = Load { force: c - c * share, moment: handedness.sign() * rho * s };
        Ok(AngleLine { parting: parting.load(), direction })
    }

    /// How a person reads its force and its moment: factors on the dimensionless loads, and the units' names.
    ///
    /// ```
    /// use nply_sheet::{LocusReport, Spec};
    /// let strand = [("strands", "3"), ("radius", "2 mm"), ("bending-stiffness", "1 N mm^2"), ("stiffness-ratio", "0.75")];
    /// let flags = strand.into_iter().chain([("pretwist", "-0.2")]);
    /// let [force, moment] = LocusReport::of(&Spec::from_flags(flags)?.check()?, 200)?.readings();
    /// assert_eq!((force.factor, moment.factor), (250.0, 500.0)); // B/r² = 0.25 N, B/r = 0.5 N mm
    /// assert_eq!((force.unit.as_str(), moment.unit.as_str()), ("mN", "mN mm"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn readings(&self) -> [Reading; 2] {
        let loads = Handedness::BOTH.map(|hand| (self.locus.forces(hand), self.locus.moments(hand)));
        let largest = |values: [&[f64]; 2]| values.iter().copied().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
        let [(right_f, right_m), (left_f, left_m)] = loads;
        [(Measure::Force, [right_f, left_f]), (Measure::Moment, [right_m, left_m])]
            .map(|(measure, values)| measure.reading(self.known(), &self.case.units, largest(values)))
    }

    pub(super) fn title(&self) -> Option<String> {
        self.case.title.clone()
    }

    fn known(&self) -> Known {
        Known { scale: self.case.scale, strand_radius: self.case.strand_radius }
    }

    /// The named points as an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let emphasis = Emphasis(emphasis);
        let mut out = String::new();
        let (name, value) = named(self.twist);
        let headline = format!(
            "{}{} strands, stiffness ratio {}, {} {}: where touching strands part (p = 0)",
            super::text::title(&self.case),
            self.case.strands,
            six_digits(self.case.stiffness_ratio),
            name.replace('_', " "),
            six_digits(value),
        );
        let _ = writeln!(out, "{}", emphasis.heading(&headline));
        let [force, moment] = self.readings();
        let with_unit = |name: &str, reading: &Reading| format!("{name}, {}", reading.unit);
        let head = Row {
            label: "at".to_owned(),
            unit: String::new(),
            cells: vec!["angle, deg".to_owned(), with_unit("force", &force), with_unit("moment", &moment)],
        };
        let mut parts = vec![("", vec![head])];
        for handedness in Handedness::BOTH {
            let points = self.special.iter().filter(|point| point.handedness == handedness);
            let row = |point: &SpecialPoint| Row {
                label: point.label.to_owned(),
                unit: String::new(),
                cells: vec![
                    six_digits(point.angle.degrees()),
                    six_digits(point.load.force * force.factor + 0.0),
                    six_digits(point.load.moment * moment.factor + 0.0),
                ],
            };
            parts.push((hand(handedness), points.map(row).collect()));
        }
        lay_out(&mut out, &parts, &emphasis);
        out
    }

    /// Both curves, one row a point: hand, angle, loads; in SI too where the scale is known.
    #[must_use]
    pub fn csv(&self) -> String {
        let loads = [("force", Measure::Force), ("moment", Measure::Moment)];
        let si = loads.map(|(name, measure)| measure.si(self.known()).map(|(factor, unit)| (name, factor, unit)));
        let mut head = vec!["handedness".to_owned(), "lay".to_owned(), "helical_angle_deg".to_owned()];
        head.extend(loads.map(|(name, _)| name.to_owned()));
        head.extend(si.iter().flatten().map(|(name, _, unit)| format!("{name}_{}", unit_suffix(unit))));
        let mut out = head.join(",") + "\n";
        for hand in Handedness::BOTH {
            for (angle, load) in self.curve(hand) {
                let numbers = [load.force + 0.0, load.moment + 0.0];
                let _ = write!(out, "{},{},{:?}", hand.sign(), hand.lay_letter(), angle.degrees());
                let measured = si.iter().zip(numbers).filter_map(|(si, value)| si.map(|(_, factor, _)| value * factor));
                for value in numbers.into_iter().chain(measured) {
                    let _ = write!(out, ",{value:?}");
                }
                out.push('\n');
            }
        }
        out
    }

    /// The named points and both curves as JSON.
    #[must_use]
    pub fn json(&self) -> String {
        let case = &self.case;
        let mut top = header();
        if let Some(title) = &case.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("strands".into(), json!(case.strands));
        top.insert("stiffness_ratio".into(), json!(case.stiffness_ratio));
        let (name, value) = named(self.twist);
        top.insert(name.into(), json!(value));
        if let Some(radius) = case.strand_radius {
            top.insert("strand_radius_m".into(), json!(radius));
        }
        if let Some(scale) = case.scale {
            top.insert("bending_stiffness_N_m2".into(), json!(scale.bending_stiffness()));
        }
        let loads = [("force", Measure::Force), ("moment", Measure::Moment)];
        let si = || loads.iter().filter_map(|(name, measure)| Some((*name, measure.si(self.known())?)));
        let units: Map<String, Value> = si().map(|(name, (_, unit))| (name.to_owned(), json!(unit))).collect();
        if !units.is_empty() {
            top.insert("si_units".into(), Value::Object(units));
        }
        let of_hand = |hand: Handedness| {
            let mut object = Map::new();
            object.insert("handedness".into(), json!(if hand == Handedness::Right { 1 } else { -1 }));
            object.insert("lay".into(), json!(hand.lay_letter().to_string()));
            object
        };
        let points = self.special.iter().map(|point| {
            let mut object = of_hand(point.handedness);
            object.insert("name".into(), json!(point.name));
            object.insert("helical_angle_deg".into(), json!(point.angle.degrees()));
            let load = |name| if name == "force" { point.load.force + 0.0 } else { point.load.moment + 0.0 };
            for (name, _) in loads {
                object.insert(name.into(), json!(load(name)));
            }
            let si: Map<String, Value> =
                si().map(|(name, (factor, _))| (name.to_owned(), json!(load(name) * factor))).collect();
            if !si.is_empty() {
                object.insert("si".into(), Value::Object(si));
            }
            Value::Object(object)
        });
        top.insert("special_points".into(), points.collect());
        let curves = Handedness::BOTH.map(|hand| {
            let mut object = of_hand(hand);
            let angles: Vec<f64> = self.curve(hand).map(|(angle, _)| angle.degrees()).collect();
            object.insert("helical_angle_deg".into(), json!(angles));
            for (name, values) in [("force", self.locus.forces(hand)), ("moment", self.locus.moments(hand))] {
                let values: Vec<f64> = values.iter().map(|value| value + 0.0).collect();
                object.insert(name.into(), json!(values));
            }
            Value::Object(object)
        });
        top.insert("curves".into(), json!(curves));
        format!("{:#}\n", Value::Object(top))
    }
}

/// The twist's name and value.
const fn named(twist: Twist) -> (&'static str, f64) {
    match twist {
        Twist::Pretwist(value) => ("pretwist", value),
        Twist::StrandTwist(value) => ("strand_twist", value),
    }
}

/// Refused at the head of the input.
fn twist_missing(case: &Case) -> SpecError {
    let nowhere = DomainError { quantity: "locus", value: 0.0, allowed: "" };
    let message = "the twist is missing: strands part along a curve of loads for each twist; give the twist, such as pretwist = -0.2";
    SpecError::new(ErrorKind::Missing, case.locate(&nowhere).place().clone(), message)
}

fn special_points(ply: &Ply, twist: Twist, locus: &Locus) -> Result<Vec<SpecialPoint>, DomainError> {
    let mut points = Vec::new();
    let [by_force, by_moment] = ply.separation_extremes(twist)?;
    for handedness in Handedness::BOTH {
        let mut put = |name, label, angle, load| points.push(SpecialPoint { name, label, handedness, angle, load });
        let (straight, load) = locus.point(handedness, 0);
        put("straight", "straight strands", straight, load);
        let diagonal = ply.separation_at(HelicalAngle::new(FRAC_PI_4)?, handedness, twist)?;
        put("diagonal", "45 degrees", diagonal.contact().angle(), diagonal.load());
        for (name, label, states) in [
            ("force_turns", "turning point of force", &by_force),
            ("moment_turns", "turning point of moment", &by_moment),
        ] {
            for state in states.iter().filter(|state| state.handedness() == handedness) {
                put(name, label, state.contact().angle(), state.load());
            }
        }
        let (rings, load) = locus.point(handedness, locus.len() - 1);
        put("rings", "flat rings", rings, load);
    }
    let left = |point: &SpecialPoint| point.handedness == Handedness::Left;
    // a pitch angle tells flat rings from what is near them
    points.sort_by(|a, b| left(a).cmp(&left(b)).then(b.angle.pitch_angle().total_cmp(&a.angle.pitch_angle())));
    Ok(points)
}
