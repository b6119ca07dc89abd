//! Studies: a table with a row for each set of data, and what is asked of its states in columns beside them.
//!
//! A [`Study`] is a description of a ply, what varies in it, and what is asked. Any row can be worked out by itself, so that a door may share
//! rows out among threads, processes and machines: the answer depends neither on the stretch it is asked in nor on what was asked before.

#[cfg(feature = "parquet")]
mod arrow;
mod ask;
mod fast;
mod follow;
mod places;
mod plan;
mod run;
mod sample;
mod sink;

pub use crate::spec::sweep::{Order, Question, Sample, States, SweepFlags};
pub use follow::Trail;

use crate::report::StateKind;
use crate::spec::Spec;
use crate::spec::sweep::{Run, SweepSpec, refused, refused_at};
use crate::spec::toml_text;
use crate::table::{Column, Values};
use crate::{ErrorKind, Key, Place, SpecError, quoted};
use places::{Exact, Places};
use plan::{GivenKey, Plan};
use sample::Points;

/// A description of a ply, what varies in it from row to row, and what is asked of every row.
///
/// ```
/// use nply_sheet::Spec;
/// use nply_sheet::sweep::{Study, SweepFlags};
/// use nply_sheet::table::Values;
/// let text = "ply.strands = 6\n[sweep]\nlay.helical_angle = { from = \"10 deg\", to = \"20 deg\", count = 2 }\noutputs = [\"radius_ratio\"]\n";
/// let study = Spec::from_toml("study.toml", text).and_then(|spec| Study::from_spec(&spec, &SweepFlags::default()))?;
/// let names: Vec<&str> = study.columns().iter().map(|column| column.name.as_str()).collect();
/// assert_eq!((study.rows(), names), (2, vec!["row", "helical_angle_deg", "radius_ratio", "reason"]));
/// let Values::Dense(ratio) = &study.chunk(1, 1)[2] else { unreachable!() };
/// assert!((ratio[0] - 2.0998).abs() < 5e-5);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Study {
    base: Spec,
    written: SweepSpec,
    layout: Layout,
    rows: u64,
    plan: Option<Plan>,
}

/// Where the values of a row come from.
#[derive(Clone, Debug)]
enum Layout {
    Grid,
    Zip,
    Sample(Points),
    /// From outside, row by row.
    Given,
}

/// Whether every table of a study has a column of this name beside what varies and what is asked.
fn is_of_every_table(name: &str) -> bool {
    ["state", "reason"].contains(&name)
}

/// More rows than this are no table.
const MOST_ROWS: u64 = 1 << 48;

impl Study {
    /// The study that `[sweep]` of a description asks for, or flags, or both: what a flag says takes the place of what the file says.
    ///
    /// Without anything that varies it has one row. Where `rows` names a file, the values come from outside: [`Study::solve_given`].
    ///
    /// # Errors
    /// [`SpecError`] where a name, a unit or a range is not understood, and where data go not together. What no ply can be is no error
    /// here: it is the reason of a row.
    pub fn from_spec(spec: &Spec, flags: &SweepFlags) -> Result<Self, SpecError> {
        let flags = SweepSpec::of_flags(flags)?;
        let written = spec.sweep.as_deref().cloned().unwrap_or_default().overridden_by(flags);
        let mut base = spec.clone();
        base.sweep = None;
        base.map = None;
        base.legs.clear();
        for (at, run) in written.runs.iter().enumerate() {
            if let Some(other) = written.runs[..at].iter().find(|other| other.key.datum == run.key.datum) {
                let message = format!("`{}` varies twice: give it once", other.key.name);
                return Err(refused_at(ErrorKind::Contradiction, &run.place, message));
            }
        }
        let varied: Vec<&'static Key> = written.runs.iter().map(|run| run.key).collect();
        base.keeps_flags_beside(&plan::placeholders(&base, &varied, &Place::Flag("sweep".to_owned())))?;
        let states = written.states.as_ref().map_or(States::default(), |(states, _)| *states);
        let neighbours = |why: &str| match &written.states {
            Some((States::Continued, place)) => {
                let message = format!("a state is continued from row to row of a grid or of zipped values, and {why}");
                Err(refused_at(ErrorKind::Contradiction, place, message))
            }
            _ => Ok(()),
        };
        let order = written.order.as_ref().map_or(Order::default(), |(order, _)| *order);
        let (layout, rows) = match (&written.rows, &written.sample) {
            (Some((_, place)), _) if !written.runs.is_empty() || written.sample.is_some() => {
                let message = "rows are given, and other data vary as well: leave one of the two out";
                return Err(refused_at(ErrorKind::Contradiction, place, message));
            }
            (Some(_), _) => {
                neighbours("given rows are not known to be neighbours")?;
                (Layout::Given, 0)
            }
            (None, Some((sample, place))) => {
                neighbours("samples have no neighbours")?;
                let points = written.points.as_ref().map(|(points, _)| *points).filter(|points| *points > 0);
                let Some(points) = points else {
                    let message = "the number of points is missing: give `points` (--points), such as 1000";
                    return Err(refused_at(ErrorKind::Missing, place, message));
                };
                if written.runs.is_empty() {
                    return Err(refused_at(ErrorKind::Missing, place, "nothing varies: give ranges to draw from"));
                }
                let seed = written.seed.as_ref().map_or(0, |(seed, _)| *seed);
                (Layout::Sample(Points::new(*sample, points, seed, written.runs.len())), points)
            }
            (None, None) => {
                if let Some((_, place)) = written.points.as_ref().or(written.seed.as_ref()) {
                    let message = "this goes with a sample: give `sample` as well, \"sobol\" or \"latin\"";
                    return Err(refused_at(ErrorKind::Missing, place, message));
                }
                let rows = counted(&written.runs, order)?;
                (if order == Order::Zip { Layout::Zip } else { Layout::Grid }, rows)
            }
        };
        if rows > MOST_ROWS {
            let place = written.runs.first().map_or_else(|| base.head(), |run| run.place.clone());
            let message = format!("a study of {rows} rows is too large: split it");
            return Err(refused_at(ErrorKind::Domain, &place, message));
        }
        let mut study = Self { base, written, layout, rows, plan: None };
        if !matches!(study.layout, Layout::Given) {
            let given = study.written.runs.iter().map(GivenKey::of_run).collect();
            let plan = Plan::new(&study.base, &study.written, given, states)?;
            study.plan = Some(plan);
        } else {
            // what is asked is understood before a file is opened
            Plan::new(&study.base, &study.written, Vec::new(), states)?;
        }
        Ok(study)
    }

    /// How many rows it has, counted by sets of data and not by states; 0 where they come from outside.
    #[must_use]
    pub const fn rows(&self) -> u64 {
        self.rows
    }

    /// Whether its rows come from outside.
    #[must_use]
    pub const fn takes_rows(&self) -> bool {
        matches!(self.layout, Layout::Given)
    }

    /// Whether anything varies by itself.
    #[must_use]
    pub const fn varies(&self) -> bool {
        !self.written.runs.is_empty()
    }

    /// The columns of its table: `row` (from 0), what varies, `state` (from 1), what is asked, `reason`. Empty where the rows come from
    /// outside.
    #[must_use]
    pub fn columns(&self) -> &[Column] {
        self.plan.as_ref().map_or(&[], |plan| &plan.columns)
    }

    /// A stretch of its table, a column each, as [`Study::columns`] says. Rows there are not are left out.
    ///
    /// The stretch has a row for each state; a set of data without one, or that no ply can be, has one row with empty cells and its sentence
    /// in `reason`.
    #[must_use]
    pub fn chunk(&self, first: u64, count: usize) -> Vec<Values> {
        self.chunk_on(&mut Trail::default(), first, count)
    }

    /// As [`Study::chunk`]; where states are continued, `trail` is what was followed up to here. If the stretch goes on where the last one
    /// with this trail ended, nothing has to be followed anew.
    #[must_use]
    pub fn chunk_on(&self, trail: &mut Trail, first: u64, count: usize) -> Vec<Values> {
        let Some(plan) = &self.plan else { return Vec::new() };
        let last = first.saturating_add(count as u64).min(self.rows);
        let rows = first.min(last)..last;
        let cells = self.values(rows.clone());
        let length = (rows.end - rows.start) as usize;
        let answers = match plan.states {
            States::Continued => self.follow(plan, trail, rows.clone(), &cells),
            _ => plan.solve(&cells, length),
        };
        #[expect(clippy::cast_possible_wrap, reason = "far below 2⁶³")]
        let number = |place: &usize| (rows.start + *place as u64) as i64;
        let mut chunk = vec![Values::Counts(answers.places.iter().map(number).collect())];
        // as a rule a row has one state
        let same = answers.places.len() == length && answers.places.iter().enumerate().all(|(at, place)| at == *place);
        if same {
            chunk.extend(cells);
        } else {
            chunk.extend(cells.iter().map(|cells| cells.taken(&answers.places)));
        }
        chunk.extend(answers.state);
        chunk.extend(answers.outputs);
        chunk.push(answers.reason);
        chunk
    }

    /// The columns that answers to given rows have, beside which stand the given columns that are [`carried`](Study::carried): `state`, what is asked, `reason`. An answer whose
    /// name a given datum has already is left out.
    ///
    /// # Errors
    /// [`SpecError`] where no column is a datum, two are the same, or a unit is not understood; and as [`Study::from_spec`].
    pub fn given_columns(&self, given: &[Column]) -> Result<Vec<Column>, SpecError> {
        let (plan, _) = self.plan_of(given)?;
        Ok(plan.columns)
    }

    /// Which of the given columns, by their places, stand in the table beside the answers: all but `state` and `reason`, which every table
    /// of a study has. A table that an earlier study made can so be given as rows; its own `state` and `reason` take the place of the old.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::sweep::{Study, SweepFlags};
    /// use nply_sheet::table::{Column, Kind};
    /// let given = ["row", "pretwist", "state", "reason"].map(|name| Column::new(name, Kind::Text));
    /// assert_eq!(Study::carried(&given), [0, 1]);
    /// ```
    #[must_use]
    pub fn carried(given: &[Column]) -> Vec<usize> {
        (0..given.len()).filter(|at| !is_of_every_table(&given[*at].name)).collect()
    }

    /// Answers to given rows: for each row of answers the place of the given row, from 0, and the columns that [`Study::given_columns`] tells.
    ///
    /// A column is a datum by its name: `table.key`, the key's flag with `_` for `-`, or the key alone where no other has that name; with its
    /// unit behind it (`lay_length_mm`) or as the column's unit. An empty cell leaves the datum as the description has it. Other columns are
    /// not looked at.
    ///
    /// # Errors
    /// As [`Study::given_columns`].
    pub fn solve_given(&self, given: &[Column], cells: &[Values]) -> Result<(Vec<usize>, Vec<Values>), SpecError> {
        let (plan, at) = self.plan_of(given)?;
        let rows = cells.first().map_or(0, Values::len);
        let chosen: Vec<Values> = at.iter().filter_map(|at| cells.get(*at).cloned()).collect();
        let answers = plan.solve(&chosen, rows);
        let mut columns: Vec<Values> = answers.state.into_iter().collect();
        columns.extend(answers.outputs);
        columns.push(answers.reason);
        Ok((answers.places, columns))
    }

    fn plan_of(&self, given: &[Column]) -> Result<(Plan, Vec<usize>), SpecError> {
        let mut keys = Vec::new();
        let mut at = Vec::new();
        for (place, column) in given.iter().enumerate() {
            if let Some(key) = GivenKey::of_column(column)? {
                if let Some(other) = keys.iter().find(|other: &&GivenKey| other.key.datum == key.key.datum) {
                    let message = format!(
                        "columns {} and {} are the same datum: leave one of them out",
                        quoted(&other.column.name),
                        quoted(&column.name)
                    );
                    return Err(refused(ErrorKind::Contradiction, "rows", message));
                }
                keys.push(key);
                at.push(place);
            }
        }
        if keys.is_empty() {
            let names: Vec<&str> = given.iter().map(|column| column.name.as_str()).collect();
            let message = format!(
                "no column is a datum of a ply (they are {}): name them as in the file, such as `pretwist`, `load.force` or `lay_length_mm`",
                quoted(&names.join(", "))
            );
            return Err(refused(ErrorKind::UnknownKey, "rows", message));
        }
        let states = self.written.states.as_ref().map_or(States::default(), |(states, _)| *states);
        if states == States::Continued {
            let message = "given rows are not known to be neighbours: no state is continued over them";
            return Err(refused(ErrorKind::Contradiction, "states", message));
        }
        let mut plan = Plan::new(&self.base, &self.written, keys, states)?;
        // what is given stands there already
        let own = plan.columns.split_off(1 + plan.given.len());
        let is_twice =
            |column: &&Column| !is_of_every_table(&column.name) && given.iter().any(|other| other.name == column.name);
        if let Some(twice) = own.iter().find(is_twice) {
            let message = format!(
                "column {} would stand in the table twice, as it is given and as an answer: give it another name there, or ask for others \
                 (--outputs)",
                quoted(&twice.name)
            );
            return Err(refused(ErrorKind::Contradiction, "rows", message));
        }
        plan.columns = own;
        Ok((plan, at))
    }

    /// The values of what varies over a stretch of rows.
    fn values(&self, rows: core::ops::Range<u64>) -> Vec<Values> {
        let runs = &self.written.runs;
        match &self.layout {
            Layout::Given => Vec::new(),
            Layout::Sample(points) => runs
                .iter()
                .enumerate()
                .map(|(dimension, run)| {
                    run.sampled(Exact::of(rows.clone()).map(|point| points.share(point, dimension)))
                })
                .collect(),
            Layout::Zip => runs
                .iter()
                .map(|run| {
                    let single = run.count() == Some(1);
                    run.at(Exact::of(rows.clone()).map(|row| if single { 0 } else { row }))
                })
                .collect(),
            Layout::Grid => {
                let mut stride = 1;
                let mut columns: Vec<Values> = Vec::with_capacity(runs.len());
                for run in runs.iter().rev() {
                    let count = run.count().unwrap_or(1);
                    columns.push(run.at(Places::new(rows.clone(), stride, count)));
                    stride *= count;
                }
                columns.reverse();
                columns
            }
        }
    }

    /// How many rows follow each other along what varies fastest.
    #[must_use]
    pub fn run_length(&self) -> u64 {
        match self.layout {
            Layout::Grid => self.written.runs.last().and_then(Run::count).unwrap_or(1),
            Layout::Zip => self.rows.max(1),
            Layout::Sample(_) | Layout::Given => 1,
        }
    }

    /// Which states are told.
    #[must_use]
    pub fn states(&self) -> States {
        self.written.states.as_ref().map_or(States::default(), |(states, _)| *states)
    }

    /// Whether a row is a matter of nanoseconds (arrays of shapes or equilibria) or of microseconds (each solved by itself).
    #[must_use]
    pub fn is_fast(&self) -> bool {
        self.plan.as_ref().is_some_and(|plan| plan.is_fast())
    }

    /// The whole study as the text of a file: two studies with the same text have the same table.
    ///
    /// ```
    /// use nply_sheet::Spec;
    /// use nply_sheet::sweep::{Study, SweepFlags};
    /// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")])?;
    /// let flags = SweepFlags { sweep: vec!["pretwist=-1:1:3".into()], ..SweepFlags::default() };
    /// let text = Study::from_spec(&ply, &flags)?.text();
    /// let again = Study::from_spec(&Spec::from_toml("study.toml", &text)?, &SweepFlags::default())?;
    /// assert_eq!((again.rows(), again.text()), (3, text));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn text(&self) -> String {
        use core::fmt::Write as _;
        let mut out = String::new();
        let mut entries: Vec<_> = self.base.entries.iter().collect();
        entries.sort_by_key(|entry| (entry.key.table.name(), entry.key.name));
        for entry in entries {
            let _ = writeln!(out, "{}.{} = {}", entry.key.table.name(), entry.key.name, entry.as_toml());
        }
        let _ = writeln!(out, "[sweep]");
        for run in &self.written.runs {
            let _ = writeln!(out, "{}", run.text());
        }
        if let Some(names) = &self.written.outputs {
            let names: Vec<String> = names.iter().map(|(name, _)| format!("\"{}\"", name.trim())).collect();
            let _ = writeln!(out, "outputs = [{}]", names.join(", "));
        }
        let _ = writeln!(out, "states = \"{}\"", self.states().name());
        if let Some((question, _)) = &self.written.question {
            let _ = writeln!(out, "question = \"{}\"", question.name());
        }
        if let Some((rows, _)) = &self.written.rows {
            let _ = writeln!(out, "rows = {}", toml_text(rows));
        }
        if let Some((sample, _)) = &self.written.sample {
            let _ = writeln!(out, "sample = \"{}\"", sample.name());
            let _ = writeln!(out, "points = {}", self.rows);
            let _ = writeln!(out, "seed = {}", self.written.seed.as_ref().map_or(0, |(seed, _)| *seed));
        } else if self.written.runs.len() > 1 {
            let order = self.written.order.as_ref().map_or(Order::default(), |(order, _)| *order);
            let _ = writeln!(out, "order = \"{}\"", order.name());
        }
        out
    }

    /// What a file says of itself: program, version, the study, its balance and what is looked for.
    #[must_use]
    pub fn metadata(&self) -> Vec<(String, String)> {
        let balance = self.base.get(crate::Datum::Balance).map_or("contact".to_owned(), |entry| match &entry.value {
            crate::spec::Value::Balance(balance) => balance.name().to_owned(),
            _ => String::new(),
        });
        let mut said = vec![
            ("program", "nply".to_owned()),
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("study", self.text()),
        ];
        if let Some(plan) = &self.plan {
            let looked_for = match plan.kind {
                StateKind::Contact => "contact",
                StateKind::Touching => "states",
                StateKind::Supported => "supports",
                StateKind::Stretched => "strands that stretch",
            };
            said.push(("question", looked_for.to_owned()));
            if plan.kind == StateKind::Touching {
                said.push(("balance", balance));
            }
        } else {
            said.push(("balance", balance));
        }
        said.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
    }
}

/// How many rows these make.
fn counted(runs: &[Run], order: Order) -> Result<u64, SpecError> {
    let mut counts = Vec::new();
    for run in runs {
        let Some(count) = run.count() else {
            let message = format!("`{}`: the number of values is missing: give a `count`, such as 11", run.key.name);
            return Err(refused_at(ErrorKind::Missing, &run.place, message));
        };
        counts.push((count, run));
    }
    match order {
        Order::Grid => counts.iter().try_fold(1_u64, |product, (count, run)| {
            product.checked_mul(*count).filter(|rows| *rows <= MOST_ROWS).ok_or_else(|| {
                let message = format!("`{}`: a grid of so many rows is too large: split it", run.key.name);
                refused_at(ErrorKind::Domain, &run.place, message)
            })
        }),
        Order::Zip => {
            let longest = counts.iter().map(|(count, _)| *count).max().unwrap_or(1);
            match counts.iter().find(|(count, _)| *count != longest && *count != 1) {
                Some((count, run)) => {
                    let message = format!(
                        "`{}` has {count} values, and another has {longest}: zipped values are as many (or one)",
                        run.key.name
                    );
                    Err(refused_at(ErrorKind::Contradiction, &run.place, message))
                }
                None => Ok(longest),
            }
        }
    }
}
