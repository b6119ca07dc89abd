//! `[sweep]` of a file, and the same from flags.

mod choice;
mod name;
mod run;

use core::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::file::{in_order, read_toml, ticked, unknown_key};
use super::{Entry, Spec, read_text};
use crate::key::nearest;
use crate::{Datum, ErrorKind, KEYS, Key, Place, SpecError, Table, quoted};
pub use choice::{Order, Question, Sample, States};
pub(crate) use name::{find_key, key, unit_behind, unit_of};
pub(crate) use run::{Course, Run};

/// What is written of a study: every part with its place, none of them needed.
#[derive(Clone, Debug, PartialEq, Default)]
pub(crate) struct SweepSpec {
    pub(crate) runs: Vec<Run>,
    pub(crate) outputs: Option<Vec<(String, Place)>>,
    pub(crate) states: Option<(States, Place)>,
    pub(crate) order: Option<(Order, Place)>,
    pub(crate) sample: Option<(Sample, Place)>,
    pub(crate) points: Option<(u64, Place)>,
    pub(crate) seed: Option<(u64, Place)>,
    pub(crate) question: Option<(Question, Place)>,
    pub(crate) rows: Option<(String, Place)>,
    pub(crate) place: Option<Place>,
}

/// What a study asks, as flags say it; what is empty is taken from the file.
///
/// ```
/// use nply_sheet::Spec;
/// use nply_sheet::sweep::{Study, SweepFlags};
/// let ply = Spec::from_flags([("strands", "3"), ("stiffness-ratio", "0.75")])?;
/// let flags = SweepFlags { sweep: vec!["pretwist=-1:1:1001".into()], ..SweepFlags::default() };
/// assert_eq!(Study::from_spec(&ply, &flags)?.rows(), 1001);
/// # Ok::<(), nply_sheet::SpecError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SweepFlags {
    /// What varies: `twist.pretwist=-1:1:1001`, `force=0:2 kN:11`, `force=1 N:1 kN:31:log`, `strands=2,3,6`; without a number of
    /// values for samples.
    pub sweep: Vec<String>,
    /// `grid` or `zip`.
    pub order: Option<String>,
    /// `sobol` or `latin`.
    pub sample: Option<String>,
    /// How many points a sample has.
    pub points: Option<u64>,
    /// What tells one sample from another; 0 if not said.
    pub seed: Option<u64>,
    /// A file whose rows are the data.
    pub rows: Option<String>,
    /// What is asked, by name.
    pub outputs: Vec<String>,
    /// `all`, `stable` or `continued`.
    pub states: Option<String>,
    /// `contact`, `states` or `supports`; by what is given and asked, if not said.
    pub question: Option<String>,
}

/// The keys of `[sweep]` besides what varies, and what they mean.
pub(crate) const SWEEP_KEYS: [(&str, &str); 8] = [
    (
        "outputs",
        "What is asked: columns of `nply solve`, `nply support` or `nply contact`, with a unit behind the name if it is to be written in it",
    ),
    ("states", "Which states a row has: all, the stable ones, or the one continued from the row before; all if absent"),
    ("order", "Each value with each (grid), or the first with the first (zip); grid if absent"),
    ("sample", "How points are spread over the ranges, instead of a grid"),
    ("points", "How many points a sample has"),
    ("seed", "What tells one sample from another; 0 if absent"),
    (
        "question",
        "What is found in every row: the contact of a lay, the states, or what supports them; by what is given, if absent",
    ),
    ("rows", "A file (CSV or Parquet) whose rows are the data"),
];

type Placed<'p> = &'p dyn Fn(Range<usize>) -> Place;

impl SweepSpec {
    pub(crate) fn read(
        content: &DeTable<'_>,
        text: &str,
        place: &impl Fn(Range<usize>) -> Place,
        here: Place,
    ) -> Result<Self, SpecError> {
        let mut sweep = Self { place: Some(here), ..Self::default() };
        let place: Placed<'_> = place;
        for (key, value) in in_order(content) {
            let written: &str = key.get_ref();
            let at = || place(value.span());
            let wrong = |wanted: &str| {
                let message = format!("`{written}`: what is wanted is {wanted}");
                SpecError::new(ErrorKind::WrongType, at(), message).of_key(written)
            };
            let word = || match value.get_ref() {
                DeValue::String(word) => Ok(word.to_string()),
                _ => Err(wrong("a word in quotation marks")),
            };
            let whole = || match value.get_ref() {
                DeValue::Integer(number) => number.as_str().replace('_', "").parse::<u64>().ok(),
                DeValue::Float(number) => whole_number(number.as_str()),
                _ => None,
            };
            if let Some(table) = Table::ALL.into_iter().find(|table| table.name() == written) {
                let DeValue::Table(data) = value.get_ref() else {
                    return Err(wrong("a table of what varies, such as `sweep.twist.pretwist = [0, 1]`"));
                };
                for (name, value) in in_order(data) {
                    let written: &str = name.get_ref();
                    let Some(key) = KEYS.iter().find(|known| known.table == table && known.name == written) else {
                        return Err(unknown_key(table, written, place(name.span())));
                    };
                    sweep.runs.push(read_run(key, value, text, place)?);
                }
                continue;
            }
            match written {
                "outputs" => {
                    let DeValue::Array(names) = value.get_ref() else {
                        return Err(wrong("a list of names, such as [\"helical_angle\", \"radius_ratio\"]"));
                    };
                    let name = |name: &Spanned<DeValue<'_>>| match name.get_ref() {
                        DeValue::String(word) => Ok((word.to_string(), place(name.span()))),
                        _ => Err(wrong("a list of names, such as [\"helical_angle\", \"radius_ratio\"]")),
                    };
                    sweep.outputs = Some(names.iter().map(name).collect::<Result<_, _>>()?);
                }
                "states" => sweep.states = Some((States::read(&word()?, &at())?, at())),
                "order" => sweep.order = Some((Order::read(&word()?, &at())?, at())),
                "sample" => sweep.sample = Some((Sample::read(&word()?, &at())?, at())),
                "question" => sweep.question = Some((Question::read(&word()?, &at())?, at())),
                "rows" => sweep.rows = Some((word()?, at())),
                "points" => sweep.points = Some((whole().ok_or_else(|| wrong("a whole number, such as 1000"))?, at())),
                "seed" => sweep.seed = Some((whole().ok_or_else(|| wrong("a whole number, such as 1"))?, at())),
                _ => {
                    let own = SWEEP_KEYS.map(|(name, _)| name);
                    let known = own.into_iter().chain(Table::ALL.into_iter().map(Table::name));
                    let help = nearest(written, known).map(|name| format!("did you mean `{name}`?"));
                    let message = format!(
                        "{} is no key of [sweep], which has {} and what varies, table by table, such as `load.force`",
                        ticked(written),
                        own.join(", ")
                    );
                    return Err(SpecError::new(ErrorKind::UnknownKey, place(key.span()), message)
                        .of_key(written)
                        .with_help(help));
                }
            }
        }
        // in the order of the file, however tables are mixed
        sweep.runs.sort_by_key(|run| match &run.place {
            Place::File { bytes, .. } => bytes.start,
            Place::Flag(_) => 0,
        });
        Ok(sweep)
    }

    pub(crate) fn of_flags(flags: &SweepFlags) -> Result<Self, SpecError> {
        let place = |flag: &str| Place::Flag(flag.to_owned());
        let mut sweep = Self::default();
        for text in &flags.sweep {
            let run = run_of_flag(text)?;
            if sweep.runs.iter().any(|other| other.key.datum == run.key.datum) {
                let message = format!("{} varies twice: give it once", run.key.name);
                return Err(refused(ErrorKind::Contradiction, "sweep", message));
            }
            sweep.runs.push(run);
        }
        if !flags.outputs.is_empty() {
            sweep.outputs = Some(flags.outputs.iter().map(|name| (name.clone(), place("outputs"))).collect());
        }
        let word = |text: &Option<String>, flag: &str| text.clone().map(|text| (text, place(flag)));
        if let Some((text, at)) = word(&flags.states, "states") {
            sweep.states = Some((States::read(&text, &at)?, at));
        }
        if let Some((text, at)) = word(&flags.order, "order") {
            sweep.order = Some((Order::read(&text, &at)?, at));
        }
        if let Some((text, at)) = word(&flags.sample, "sample") {
            sweep.sample = Some((Sample::read(&text, &at)?, at));
        }
        if let Some((text, at)) = word(&flags.question, "question") {
            sweep.question = Some((Question::read(&text, &at)?, at));
        }
        sweep.rows = word(&flags.rows, "rows");
        sweep.points = flags.points.map(|points| (points, place("points")));
        sweep.seed = flags.seed.map(|seed| (seed, place("seed")));
        Ok(sweep)
    }

    /// This with what flags say laid over it.
    pub(crate) fn overridden_by(&self, flags: Self) -> Self {
        let mut runs = self.runs.clone();
        let same =
            |a: &Run, b: &Run| a.key.datum == b.key.datum || (a.key.group.is_some() && a.key.group == b.key.group);
        runs.retain(|run| !flags.runs.iter().any(|other| same(run, other)));
        runs.extend(flags.runs);
        Self {
            runs,
            outputs: flags.outputs.or_else(|| self.outputs.clone()),
            states: flags.states.or_else(|| self.states.clone()),
            order: flags.order.or_else(|| self.order.clone()),
            sample: flags.sample.or_else(|| self.sample.clone()),
            points: flags.points.or_else(|| self.points.clone()),
            seed: flags.seed.or_else(|| self.seed.clone()),
            question: flags.question.or_else(|| self.question.clone()),
            rows: flags.rows.or_else(|| self.rows.clone()),
            place: self.place.clone().or(flags.place),
        }
    }
}

/// A whole number, also as 1e6.
pub(crate) fn whole_number(text: &str) -> Option<u64> {
    const LARGEST: f64 = 9_007_199_254_740_992.0; // 2⁵³
    let text = text.replace('_', "");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole, from 0 to 2⁵³")]
    let of_float = |value: f64| ((0.0..=LARGEST).contains(&value) && value.fract() == 0.0).then_some(value as u64);
    text.parse().ok().or_else(|| of_float(text.parse().ok()?))
}

/// `{ from = …, to = …, count = … }` or a list.
fn read_run(key: &'static Key, value: &Spanned<DeValue<'_>>, text: &str, place: Placed<'_>) -> Result<Run, SpecError> {
    may_vary(key, &place(value.span()))?;
    let wrong = |at: Range<usize>, wanted: &str| {
        let message = format!("`{}`: what is wanted is {wanted}", key.name);
        SpecError::new(ErrorKind::WrongType, place(at), message).of_key(key.name)
    };
    const RANGE: &str = "a range, such as { from = 0, to = 1, count = 11 }, or a list, such as [0, 0.5, 1]";
    let entry = |value: &Spanned<DeValue<'_>>| read_toml(key, value, text, place(value.span()));
    match value.get_ref() {
        DeValue::Array(list) if list.is_empty() => Err(wrong(value.span(), "a list of one value at least")),
        DeValue::Array(list) => Run::list(&list.iter().map(entry).collect::<Result<Vec<Entry>, _>>()?),
        DeValue::Table(range) => {
            let (mut from, mut to, mut count, mut log) = (None, None, None, false);
            for (name, value) in in_order(range) {
                let written: &str = name.get_ref();
                match (written, value.get_ref()) {
                    ("from", _) => from = Some(entry(value)?),
                    ("to", _) => to = Some(entry(value)?),
                    ("count", DeValue::Integer(number)) => count = whole_number(number.as_str()),
                    ("count", DeValue::Float(number)) => count = whole_number(number.as_str()),
                    ("scale", DeValue::String(word)) if word == "log" => log = true,
                    ("scale", DeValue::String(word)) if word == "linear" => log = false,
                    ("scale", _) => return Err(wrong(value.span(), "`scale = \"linear\"` or `scale = \"log\"`")),
                    ("count", _) => {}
                    _ => {
                        let message =
                            format!("{} is no part of a range, which has from, to, count and scale", ticked(written));
                        return Err(SpecError::new(ErrorKind::UnknownKey, place(name.span()), message).of_key(written));
                    }
                }
                if written == "count" && count.is_none() {
                    return Err(wrong(value.span(), "a whole `count`, such as 11"));
                }
            }
            let (Some(from), Some(to)) = (from, to) else { return Err(wrong(value.span(), RANGE)) };
            Run::range(&from, &to, count, log)
        }
        _ => {
            let message = format!(
                "`{}` has one value here and does not vary: write it in [{}], or give {RANGE}",
                key.name,
                key.table.name()
            );
            Err(SpecError::new(ErrorKind::WrongType, place(value.span()), message).of_key(key.name))
        }
    }
}

/// `key=from:to:count`, `key=from:to:count:log`, `key=a,b,c`.
fn run_of_flag(text: &str) -> Result<Run, SpecError> {
    let wrong = |why: &str| {
        let message = format!(
            "{}: {why}; write a range with the number of its values, such as `pretwist=-1:1:1001` or `force=1 N:1 kN:31:log`, or a list, \
             such as `strands=2,3,6`",
            quoted(text)
        );
        refused(ErrorKind::Syntax, "sweep", message)
    };
    let (name, what) = text.split_once('=').ok_or_else(|| wrong("what varies is missing"))?;
    let key = key(name.trim(), "sweep")?;
    let place = Place::Flag(format!("sweep {}", key.flag));
    may_vary(key, &place)?;
    let entry = |text: &str| -> Result<Entry, SpecError> {
        Ok(Entry { key, value: read_text(key, text, &place)?, place: place.clone(), written: quoted(text) })
    };
    if what.contains("..") {
        return Err(wrong("a table's range is written with colons (two dots are those of `nply plot`)"));
    }
    let mut parts: Vec<&str> = what.split(':').map(str::trim).collect();
    if parts.len() < 2 {
        let listed: Vec<&str> = what.split(',').map(str::trim).collect();
        // a unit at the end stands for all
        let unit = listed.last().and_then(|last| unit(last));
        let entries = listed.iter().map(|one| entry(&with_unit(one, unit))).collect::<Result<Vec<_>, _>>()?;
        return Run::list(&entries);
    }
    let log = parts.last() == Some(&"log");
    if log || parts.last() == Some(&"linear") {
        parts.pop();
    }
    let (from, to, count) = match parts[..] {
        [from, to] => (from, to, None),
        [from, to, count] => {
            (from, to, Some(whole_number(count).ok_or_else(|| wrong("the number of values is no whole number"))?))
        }
        _ => return Err(wrong("this is no range")),
    };
    Run::range(&entry(&with_unit(from, unit(to)))?, &entry(to)?, count, log)
}

/// A number with the unit that stands at the end.
fn with_unit(text: &str, unit: Option<&str>) -> String {
    match (text.parse::<f64>(), unit) {
        (Ok(_), Some(unit)) => format!("{text} {unit}"),
        _ => text.to_owned(),
    }
}

/// What follows the number.
fn unit(text: &str) -> Option<&str> {
    let number = |end: usize| text.get(..end).is_some_and(|head| head.trim().parse::<f64>().is_ok());
    let end = (1..=text.len()).rev().find(|&end| number(end))?;
    let unit = text[end..].trim();
    (!unit.is_empty()).then_some(unit)
}

/// Refuses what has the same value for a whole table.
pub(crate) fn may_vary(key: &'static Key, place: &Place) -> Result<(), SpecError> {
    let why = match key.datum {
        Datum::Title => "a title is one for the whole study: give it in [ply]",
        Datum::Stretch => "whether strands stretch is one for the whole study: give it in [strand]",
        _ => return Ok(()),
    };
    Err(SpecError::new(ErrorKind::Contradiction, place.clone(), format!("`{}`: {why}", key.name)).of_key(key.name))
}

pub(crate) fn refused(kind: ErrorKind, flag: &str, message: impl Into<String>) -> SpecError {
    SpecError::new(kind, Place::Flag(flag.to_owned()), message)
}

pub(crate) fn refused_at(kind: ErrorKind, place: &Place, message: impl Into<String>) -> SpecError {
    SpecError::new(kind, place.clone(), message)
}

impl Spec {
    /// The file of rows that `[sweep]` names.
    ///
    /// ```
    /// let spec = nply_sheet::Spec::from_toml("study.toml", "ply.strands = 3\nsweep.rows = \"lays.csv\"\n")?;
    /// assert_eq!(spec.sweep_rows(), Some("lays.csv"));
    /// # Ok::<(), nply_sheet::SpecError>(())
    /// ```
    #[must_use]
    pub fn sweep_rows(&self) -> Option<&str> {
        self.sweep.as_ref()?.rows.as_ref().map(|(name, _)| name.as_str())
    }
}
