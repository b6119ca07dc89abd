//! One datum that runs, and what is asked of every state on the way: several plies, hands and balances in one picture.

mod ask;
mod course;
mod csv;
mod curve;
mod picture;
mod window;

use nply::Handedness;
use nply::mechanics::{Balance, Ply};

use crate::map::Axis;
use crate::report::{Column, Known, Measure, Reading, Section, data_of};
use crate::spec::{Spec, Value};
use crate::{Case, Datum, ErrorKind, Lay, Place, Quantity, Question, SpecError, Table};
use course::Course;
pub use curve::{GraphCurve, GraphPoint};
pub use window::Scales;

/// What a graph asks besides the ply.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GraphFlags {
    /// What runs, from where to where: `twist.pretwist=-3..3`, `force=0..2 kN`, `lay.helical_angle=0 deg..80 deg`.
    pub sweep: String,
    /// What is asked of each state: names of [`COLUMNS`](crate::COLUMNS), without unit if you like.
    pub ask: Vec<String>,
    /// What runs along the axis instead of the datum, likewise.
    pub against: Option<String>,
    /// The numbers of strands; none for that of the ply.
    pub strands: Vec<u32>,
    /// The balances; none for that of the ply.
    pub balances: Vec<Balance>,
    /// The hands; none for both.
    pub hands: Vec<Handedness>,
    /// Whether states on which neighbours would have to pull are left out.
    pub touching: bool,
    /// Which axes are logarithmic.
    pub scales: Scales,
}

/// A graph that is understood: every number of it is at hand, nothing is worked out yet.
///
/// ```
/// use nply_sheet::Spec;
/// use nply_sheet::graph::GraphFlags;
/// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")])?;
/// let flags = GraphFlags { sweep: "pretwist=-1..0".into(), ask: vec!["helical_angle".into()], ..GraphFlags::default() };
/// let curves = ply.check_graph(&flags)?.curves();
/// // released after a pretwist of −1 three strands come to rest at 30.613°: there the curve leaves the range
/// let pressing = curves.iter().filter(|curve| !curve.separated).flat_map(|curve| &curve.points);
/// let steepest = pressing.map(|point| point.state.contact().angle().degrees()).fold(0.0, f64::max);
/// assert!((steepest - 30.6130).abs() < 5e-5);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Graph {
    case: Case,
    series: Vec<Series>,
    hands: Vec<Handedness>,
    touching: bool,
    abscissa: Abscissa,
    /// Whether nothing but the shape is spoken of, so that what neighbours do has no meaning.
    shape_alone: bool,
    /// What runs in the words and the unit of the range, where the theory has another datum for it.
    asked: Option<(String, Reading)>,
    against: Option<&'static Column>,
    ask: Vec<&'static Column>,
    scales: Scales,
}

/// One ply, and how its states are found along the datum.
#[derive(Clone, Debug)]
struct Series {
    strands: u32,
    balance: Balance,
    course: Course,
}

/// What runs.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Abscissa {
    Datum(Axis),
    Lay { from: Lay, to: Lay },
}

/// More plies than this cannot be told apart in a picture.
const MOST_SERIES: usize = 24;
/// Colours of the palette that tell numbers of strands, but for black.
const COLOURS: usize = 6;

impl Spec {
    /// The graph that flags ask for, of the ply described here.
    ///
    /// # Errors
    /// [`SpecError`] as for [`Spec::check`]; where the range or a name is not understood; and where a core, or a pressure from outside,
    /// would have to be taken into account.
    pub fn check_graph(&self, flags: &GraphFlags) -> Result<Graph, SpecError> {
        let [from, to] = ask::range(&flags.sweep)?;
        let ask = flags.ask.iter().map(|name| ask::column(name, "ask")).collect::<Result<Vec<_>, _>>()?;
        if ask.is_empty() {
            let message = "what to show is missing: name it, such as `--ask helical_angle,interstrand_pressure`";
            return Err(refused(ErrorKind::Missing, "ask", message));
        }
        let against = flags.against.as_deref().map(|name| ask::column(name, "against")).transpose()?;
        let ends = || [&from, &to].into_iter().flat_map(|corner| &corner.entries);
        if flags.scales.log_x && against.is_none() && ends().any(|end| end.number() <= 0.0) {
            let message =
                "equal lengths for equal ratios have no place for 0 and what is below: let the range lie above 0";
            return Err(refused(ErrorKind::Domain, "log-x", message));
        }
        self.keeps_flags_beside(&from)?;
        let mut plies: Vec<Self> = vec![self.clone()];
        let mut vary = |flag: &str, values: Vec<String>| -> Result<(), SpecError> {
            if values.is_empty() {
                return Ok(());
            }
            let laid: Result<Vec<Self>, SpecError> =
                values.iter().map(|value| Self::from_flags([(flag, value.as_str())])).collect();
            let laid = laid?;
            plies = plies.iter().flat_map(|ply| laid.iter().map(|over| ply.overridden_by(over))).collect();
            Ok(())
        };
        vary("strands", flags.strands.iter().map(u32::to_string).collect())?;
        vary("balance", flags.balances.iter().map(|balance| balance.name().to_owned()).collect())?;
        if plies.len() > MOST_SERIES {
            let message =
                format!("{} plies in one picture cannot be told apart: ask for {MOST_SERIES} at most", plies.len());
            return Err(refused(ErrorKind::Domain, "strands", &message));
        }
        let numbers: std::collections::BTreeSet<u32> = flags.strands.iter().copied().collect();
        if numbers.len() > COLOURS {
            let message =
                format!("{} numbers of strands have no colours of their own: ask for {COLOURS} at most", numbers.len());
            return Err(refused(ErrorKind::Domain, "strands", &message));
        }
        let mut found: Option<(Case, Abscissa)> = None;
        let mut series = Vec::new();
        for ply in &plies {
            let [start, end] = [&from, &to].map(|corner| ply.onward(corner));
            let (start, end) = (start.check()?, end.check()?);
            let (abscissa, course) = course_of(&start, &end, &to)?;
            series.push(Series { strands: start.strands, balance: start.balance, course });
            found.get_or_insert((start, abscissa));
        }
        let Some((case, abscissa)) = found else {
            return Err(refused(ErrorKind::Missing, "strands", "there is no ply")); // plies hold one at least
        };
        let hands = if flags.hands.is_empty() { Handedness::BOTH.to_vec() } else { flags.hands.clone() };
        let asked = match abscissa {
            Abscissa::Datum(axis) => asked([&from, &to], axis),
            Abscissa::Lay { .. } => None,
        };
        let of_shape = |column: &&Column| column.section == Section::Shape;
        let mechanics =
            |entry: &crate::spec::Entry| [Table::Twist, Table::Load, Table::Ends].contains(&entry.key.table);
        let shape_alone = matches!(abscissa, Abscissa::Lay { .. })
            && ask.iter().copied().chain(against).all(|column| of_shape(&column))
            && !self.entries.iter().any(mechanics);
        let (touching, scales) = (flags.touching, flags.scales);
        Ok(Graph { case, series, hands, touching, shape_alone, abscissa, asked, against, ask, scales })
    }
}

fn refused(kind: ErrorKind, flag: &str, message: &str) -> SpecError {
    SpecError::new(kind, Place::Flag(flag.to_owned()), message)
}

/// What runs as it was asked for: turns of the ply and not turns per strand length, turns of the singles and not pretwist. `None` where
/// the theory's datum is the one that was asked for, and for a surface angle, which is no multiple of the twist.
fn asked([from, to]: [&Spec; 2], axis: Axis) -> Option<(String, Reading)> {
    let ends = [(from.entries.first()?, axis.from), (to.entries.first()?, axis.to)];
    let (entry, value) = ends.into_iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    if entry.key.name == axis.datum.name() || entry.key.datum == Datum::SurfaceAngle {
        return None;
    }
    let (written, unit) = match &entry.value {
        Value::Quantity(Quantity::Measured { si, unit }) => (unit.of_si(*si), unit.to_string()),
        _ => (entry.number(), String::new()),
    };
    let factor = written / value;
    factor.is_finite().then(|| (entry.key.flag.replace('-', " "), Reading { factor, unit }))
}

/// What runs between two cases, and how its states are found.
fn course_of(start: &Case, end: &Case, to: &Spec) -> Result<(Abscissa, Course), SpecError> {
    let Some(entry) = to.entries.first() else {
        return Err(refused(ErrorKind::Missing, "sweep", "nothing runs")); // a range names one datum
    };
    let ply = || Ply::with_balance(start.strands, start.stiffness_ratio, start.balance);
    let ply = ply().map_err(|error| start.locate(&error))?;
    if entry.key.table == Table::Lay {
        let lay = |case: &Case| match case.question {
            Question::MomentAt { lay, .. } | Question::ForceAt { lay, .. } | Question::PretwistAt { lay, .. } => {
                Some(lay)
            }
            _ => None,
        };
        let (Some(from), Some(to)) = (lay(start), lay(end)) else {
            return Err(entry.error(ErrorKind::Contradiction, "this lay does not run: give another range"));
        };
        return Ok((Abscissa::Lay { from, to }, Course::lay(start.clone(), from, to)));
    }
    if let Question::Supported { .. } = start.question {
        let core = |entry: &crate::spec::Entry| entry.key.table == Table::Support;
        return Err(start.refuse(core, |said| {
            format!("{said}: curves are of touching strands; a ply on a core is followed by `nply trace --plot`")
        }));
    }
    let (first, last) = (data_of(start)?, data_of(end)?);
    let axis = Axis::between(&first, &last, entry, 2)?;
    Ok((Abscissa::Datum(axis), Course::of(ply, &first, axis)))
}

impl Graph {
    /// The range of what runs, dimensionless, the smaller number first.
    fn range(&self) -> (f64, f64) {
        let (a, b) = match self.abscissa {
            Abscissa::Datum(axis) => (axis.from, axis.to),
            Abscissa::Lay { from, to } => (course::size(from), course::size(to)),
        };
        (a.min(b), a.max(b))
    }

    fn known(&self) -> Known {
        Known { scale: self.case.scale, strand_radius: self.case.strand_radius }
    }

    /// What stands on the axis: its name in tables, for a reader, and how it is read.
    fn axis(&self, largest: f64) -> (&'static str, String, Reading) {
        if let Some(column) = self.against {
            let reading = column.measure.reading(self.known(), &self.case.units, largest);
            return (column.name, ask::label(column), reading);
        }
        match self.abscissa {
            Abscissa::Datum(axis) => {
                let (label, reading) =
                    self.asked.clone().unwrap_or_else(|| (axis.datum.label().to_owned(), axis.reading(&self.case)));
                (axis.datum.name(), label, reading)
            }
            Abscissa::Lay { from, .. } => {
                let (name, label, measure) = course::words(from);
                let reading = match measure {
                    // rad
                    Measure::Degrees => Reading { factor: 1_f64.to_degrees(), unit: "deg".to_owned() },
                    measure => measure.reading(self.known(), &self.case.units, largest),
                };
                (name, label.to_owned(), reading)
            }
        }
    }

    /// The name given to the ply; empty without one.
    #[must_use]
    pub fn title(&self) -> &str {
        self.case.title.as_deref().unwrap_or_default()
    }
}
