//! Singles and the ply they make: what `nply spin` says.

mod notes;

use core::f64::consts::TAU;
use core::fmt::Write as _;

use nply::geometry::HelicalAngle;
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::{DomainError, Handedness};
use serde_json::{Map, Value, json};

use super::csv::unit_suffix;
use super::item::{Item, Reader, item, numbers, of_hand, units, words};
use super::json::header;
use super::text::{Emphasis, Row, hand, lay_out, title};
use super::{Known, Measure};
use crate::preferred::six_digits;
use crate::{Case, Datum, Lay, Question, SpecError};

/// The ply that balances the twist of its singles, the ply by the rule of two thirds, and the one that was given, if one was.
///
/// ```
/// use nply_sheet::{PlyingReport, Spec};
/// let singles = [("strands", "2"), ("stiffness-ratio", "1"), ("diameter", "1 mm"), ("turns-per-length", "8 tpi Z")];
/// let report = PlyingReport::of(Spec::from_flags(singles)?.check_plying()?)?;
/// let json: serde_json::Value = serde_json::from_str(&report.json())?;
/// assert_eq!((&json["plies"][0]["name"], &json["plies"][0]["lay"]), (&"balanced".into(), &"S".into()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlyingReport {
    case: Case,
    plies: Vec<Plied>,
    /// the balance, its angle of two thirds, its steepest angle
    rules: Vec<(Balance, HelicalAngle, HelicalAngle)>,
    notes: Vec<String>,
}

/// One ply of the same singles, and the moment that holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plied {
    name: &'static str,
    balance: Balance,
    state: Equilibrium,
    titre: Option<Titre>,
}

/// The titre of singles, and the radius without which their twist has no unit.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Titre {
    tex: f64,
    /// m
    radius: f64,
}

impl Titre {
    fn of(case: &Case) -> Option<Self> {
        Some(Self { tex: 1e6 * case.linear_density?, radius: case.strand_radius? })
    }

    /// α = T √tex of a yarn of some titre, its twist T in turns/m.
    fn twist_factor(self, turns: f64, tex: f64) -> f64 {
        turns.abs() / self.radius * libm::sqrt(tex)
    }
}

impl Plied {
    /// R: n singles, and what the ply is shorter than they are.
    fn resulting_tex(&self) -> Option<f64> {
        Some(f64::from(self.state.contact().strands()) * self.titre?.tex / self.angle().cos())
    }

    fn angle(&self) -> HelicalAngle {
        self.state.contact().angle()
    }

    /// rad per ply length, times r: tan θ/ρ with the sign of the hand
    fn per_ply_length(&self) -> f64 {
        self.state.handedness().sign() * self.angle().tan() / self.state.contact().radius_ratio()
    }
}

pub(super) const PLIED: &[Item<Plied>] = {
    use Measure::{Degrees, ForcePerLength, Length, Moment, Number, Percent, TurnsPerLength};
    const TWIST: &str = "Twist (Z positive)";
    const SHAPE: &str = "Shape";
    const HELD: &str = "What holds it";
    &[
        item(TWIST, "pretwist_per_length", "singles twist, per singles length", TurnsPerLength, |p| {
            Some(p.state.pretwist() / TAU)
        }),
        item(TWIST, "turns_per_ply_length", "ply twist, per ply length", TurnsPerLength, |p| {
            Some(p.per_ply_length() / TAU)
        }),
        item(TWIST, "turns_per_strand_length", "ply twist, per singles length", TurnsPerLength, |p| {
            Some(p.state.rotation() / TAU)
        }),
        item(TWIST, "twist_ratio", "ply twist (per ply length)/singles twist", Number, |p| {
            Some((p.per_ply_length() / p.state.pretwist()).abs())
        }),
        item(TWIST, "strand_twist_per_length", "twist left in the singles", TurnsPerLength, |p| {
            Some(p.state.strand_twist() / TAU)
        }),
        item(TWIST, "singles_twist_factor", "twist factor of the singles, tpm √tex", Number, |p| {
            let titre = p.titre?;
            Some(titre.twist_factor(p.state.pretwist() / TAU, titre.tex))
        }),
        item(TWIST, "ply_twist_factor", "twist factor of the ply, tpm √tex", Number, |p| {
            Some(p.titre?.twist_factor(p.per_ply_length() / TAU, p.resulting_tex()?))
        }),
        item(SHAPE, "resulting_tex", "resulting titre, R tex", Number, Plied::resulting_tex),
        item(SHAPE, "helical_angle_deg", "ply angle (to the axis)", Degrees, |p| Some(p.angle().degrees())),
        item(SHAPE, "outer_diameter", "ply diameter", Length, |p| Some(2.0 * p.state.contact().outer_radius())),
        item(SHAPE, "lay_length", "lay length", Length, |p| Some(p.state.contact().lay_length())),
        item(SHAPE, "retraction_percent", "take-up", Percent, |p| {
            let half = libm::sin(0.5 * p.angle().radians());
            Some(200.0 * half * half)
        }),
        item(HELD, "moment", "end moment that keeps it from turning", Moment, |p| {
            Some(if p.name == "balanced" { 0.0 } else { p.state.load().moment })
        }),
        item(HELD, "interstrand_pressure", "interstrand pressure p₁", ForcePerLength, |p| {
            Some(p.state.interstrand_pressure())
        }),
    ]
};

/// Angles at which the ratio of twists is listed.
const LISTED: [f64; 9] = [5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 44.0];

const TWO_THIRDS: f64 = 2.0 / 3.0;

impl PlyingReport {
    /// Of a case made by [`Spec::check_plying`](crate::Spec::check_plying).
    ///
    /// # Errors
    /// [`SpecError`] for singles without twist, or a lay that no ply let go can have.
    pub fn of(case: Case) -> Result<Self, SpecError> {
        let located = |error: DomainError| case.locate(&error);
        let balances = match case.balance {
            Balance::Radial => vec![Balance::Radial],
            // touching along a line, two strands have one balance
            Balance::Contact if case.strands == 2 => vec![Balance::Contact],
            Balance::Contact => Balance::BOTH.to_vec(),
        };
        let (mut plies, mut rules) = (Vec::new(), Vec::new());
        for balance in balances {
            let ply = Ply::with_balance(case.strands, case.stiffness_ratio, balance).map_err(located)?;
            plies.extend(plied(&case, &ply)?);
            let rule = ply.angle_of_twist_ratio(TWO_THIRDS).map_err(located)?;
            rules.push((balance, rule, ply.steepest_balanced()));
        }
        let notes = notes::of(&case, &plies, &rules);
        Ok(Self { case, plies, rules, notes })
    }

    fn known(&self) -> Known {
        Known { scale: self.case.scale, strand_radius: self.case.strand_radius }
    }

    /// As an aligned table, with bold headings if `emphasis`.
    #[must_use]
    pub fn text(&self, emphasis: bool) -> String {
        let case = &self.case;
        let emphasis = &Emphasis(emphasis);
        let reader = Reader { known: self.known(), units: &case.units, emphasis };
        let mut out = String::new();
        let gamma = six_digits(case.stiffness_ratio);
        let headline = format!("{}{} singles plied, stiffness ratio {gamma}", title(case), case.strands);
        let _ = writeln!(out, "{}", emphasis.heading(&headline));
        for (balance, ..) in &self.rules {
            let all: Vec<Plied> = self.plies.iter().filter(|plied| plied.balance == *balance).copied().collect();
            if self.rules.len() > 1 {
                let _ = writeln!(out, "\n{}", emphasis.heading(&format!("By {} balance", balance.name())));
            }
            let head = vec![
                words("ply", all.iter().map(|plied| spoken(plied.name))),
                words("hand of the ply", all.iter().map(|plied| hand(plied.state.handedness()))),
            ];
            lay_out(&mut out, &reader.parts(head, PLIED, &all, None), emphasis);
        }
        let _ = writeln!(
            out,
            "\n{}",
            emphasis.heading("Balanced plies: ply twist (per ply length)/singles twist, by angle")
        );
        let head = words("ply angle, deg", self.listed().iter().map(|angle| angle.0.as_str()));
        let row = |balance: &Balance| {
            let cells = self.listed().into_iter().map(|(_, angle)| {
                self.ratio(*balance, angle).map_or_else(|| "–".to_owned(), |ratio| format!("{ratio:.4}"))
            });
            Row { label: format!("{} balance", balance.name()), unit: String::new(), cells: cells.collect() }
        };
        let rows = core::iter::once(head).chain(self.rules.iter().map(|(balance, ..)| row(balance))).collect();
        lay_out(&mut out, &[("", rows)], emphasis);
        for note in &self.notes {
            let _ = writeln!(out, "\n{note}");
        }
        out
    }

    fn listed(&self) -> Vec<(String, HelicalAngle)> {
        let angle = |degrees: &f64| Some((format!("{degrees}"), HelicalAngle::new(degrees.to_radians()).ok()?));
        LISTED.iter().filter_map(angle).collect()
    }

    fn ratio(&self, balance: Balance, angle: HelicalAngle) -> Option<f64> {
        Ply::with_balance(self.case.strands, self.case.stiffness_ratio, balance).ok()?.twist_ratio(angle)
    }

    /// One row a ply: columns named as in JSON; those in SI, where the size is known, have their unit behind the name.
    ///
    /// ```
    /// use nply_sheet::{PlyingReport, Spec};
    /// let singles = [("strands", "2"), ("stiffness-ratio", "1"), ("diameter", "1 mm"), ("turns-per-length", "8 tpi Z")];
    /// let csv = PlyingReport::of(Spec::from_flags(singles)?.check_plying()?)?.csv();
    /// assert!(csv.starts_with("name,balance,handedness,lay,pretwist_per_length,"));
    /// assert!(csv.contains(",lay_length_m") && csv.lines().nth(1).is_some_and(|row| row.starts_with("balanced,contact,-1,S,")));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn csv(&self) -> String {
        let known = self.known();
        let si: Vec<_> = PLIED.iter().filter_map(|item| Some((item, item.measure.si(known)?))).collect();
        let mut head: Vec<String> = ["name", "balance", "handedness", "lay"].map(String::from).into();
        head.extend(PLIED.iter().map(|item| item.name.to_owned()));
        head.extend(si.iter().map(|(item, (_, unit))| format!("{}_{}", item.name, unit_suffix(unit))));
        let mut out = head.join(",") + "\n";
        let text = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
        for plied in &self.plies {
            let hand = plied.state.handedness();
            let mut cells = vec![plied.name.to_owned(), plied.balance.name().to_owned()];
            cells.extend([hand.sign().to_string(), hand.lay_letter().to_string()]);
            cells.extend(PLIED.iter().map(|item| text(item.of(plied))));
            cells.extend(si.iter().map(|(item, (factor, _))| text(item.of(plied).map(|value| value * factor))));
            out += &(cells.join(",") + "\n");
        }
        out
    }

    /// As JSON, named as in `nply solve --json`.
    #[must_use]
    pub fn json(&self) -> String {
        let (case, known) = (&self.case, self.known());
        let mut top = header();
        if let Some(title) = &case.title {
            top.insert("title".into(), json!(title));
        }
        top.insert("strands".into(), json!(case.strands));
        top.insert("stiffness_ratio".into(), json!(case.stiffness_ratio));
        if let Some(radius) = case.strand_radius {
            top.insert("strand_radius_m".into(), json!(radius));
        }
        let units: Map<String, Value> = units(PLIED, known).collect();
        if !units.is_empty() {
            top.insert("si_units".into(), Value::Object(units));
        }
        let plied = |plied: &Plied| {
            let mut object = Map::new();
            object.insert("name".into(), json!(plied.name));
            object.insert("balance".into(), json!(plied.balance.name()));
            object.extend(of_hand(plied.state.handedness()));
            Value::Object(numbers(object, PLIED, plied, known))
        };
        top.insert("plies".into(), self.plies.iter().map(plied).collect());
        let rules = |(balance, rule, steepest): &(Balance, HelicalAngle, HelicalAngle)| {
            json!({
                "balance": balance.name(),
                "two_thirds_angle_deg": rule.degrees(),
                "steepest_balanced_deg": steepest.degrees(),
                "by_angle": self.listed().into_iter().map(|(_, angle)| json!({
                    "helical_angle_deg": angle.degrees(),
                    "twist_ratio": self.ratio(*balance, angle),
                })).collect::<Vec<_>>(),
            })
        };
        top.insert("twist_ratios".into(), self.rules.iter().map(rules).collect());
        top.insert("notes".into(), json!(self.notes));
        format!("{:#}\n", Value::Object(top))
    }
}

const fn opposite(hand: Handedness) -> Handedness {
    match hand {
        Handedness::Right => Handedness::Left,
        Handedness::Left => Handedness::Right,
    }
}

fn spoken(name: &str) -> &str {
    match name {
        "two_thirds" => "two thirds",
        "given" => "as given",
        name => name,
    }
}

/// The balanced ply, that of two thirds, and the one given, of one balance.
fn plied(case: &Case, ply: &Ply) -> Result<Vec<Plied>, SpecError> {
    let located = |error: DomainError| case.locate(&error);
    let given = match case.question {
        Question::MomentAt { lay, hand: Some(hand), twist, .. } => Some((lay, hand, twist)),
        _ => None,
    };
    let twist = match case.question {
        Question::PretwistAt { lay, hand: Some(hand), .. } => {
            let angle = lay.contact(case.strands).map_err(located)?.angle();
            let state = ply.pretwist_at(angle, hand, Load::NONE).map_err(located)?;
            let steepest = ply.steepest_balanced();
            if angle.radians() >= steepest.radians() || angle.sin() == 0.0 {
                return Err(beyond(case, ply.balance(), angle, steepest));
            }
            Twist::Pretwist(state.pretwist())
        }
        Question::States { twist, .. } | Question::MomentAt { twist, .. } => twist,
        _ => Twist::Pretwist(0.0),
    };
    let (Twist::Pretwist(pretwist) | Twist::StrandTwist(pretwist)) = twist;
    if pretwist == 0.0 {
        return Err(
            case.refuse_domain(Datum::Pretwist, "singles without twist make no ply by themselves: give their twist")
        );
    }
    let hand = opposite(if pretwist > 0.0 { Handedness::Right } else { Handedness::Left });
    let steepest = ply.steepest_balanced();
    let states = ply.equilibria(twist, Load::NONE).map_err(located)?;
    // one state lies below that angle for every twist: the ratio of the twists falls all the way
    let balanced = states
        .into_iter()
        .filter(|state| state.handedness() == hand && state.contact().helical_angle() <= steepest.radians())
        .min_by(|a, b| a.contact().helical_angle().total_cmp(&b.contact().helical_angle()));
    let titre = Titre::of(case);
    let plied = |name, state| Plied { name, balance: ply.balance(), state, titre };
    let mut plies: Vec<Plied> = balanced.map(|state| plied("balanced", state)).into_iter().collect();
    // tan θ/ρ is two thirds of the pretwist, where strands can be laid so closely
    if let Ok(contact) = Lay::LayLength(TAU / (TWO_THIRDS * pretwist.abs())).contact(case.strands) {
        plies.push(plied("two_thirds", ply.moment_at(contact.angle(), hand, twist, 0.0).map_err(located)?));
    }
    if let Some((lay, hand, twist)) = given {
        let angle = lay.contact(case.strands).map_err(located)?.angle();
        plies.push(plied("given", ply.moment_at(angle, hand, twist, 0.0).map_err(located)?));
    }
    Ok(plies)
}

/// A lay that no singles of the other hand balance.
fn beyond(case: &Case, balance: Balance, angle: HelicalAngle, steepest: HelicalAngle) -> SpecError {
    let words = format!(
        "at {:.4} deg no twist of the singles, of the other hand than the ply's, balances it: balanced plies of {} strands lie \
         between 0 and {:.4} deg ({} balance)",
        angle.degrees(),
        case.strands,
        steepest.degrees(),
        balance.name(),
    );
    case.refuse_domain(Datum::HelicalAngle, &words)
}
