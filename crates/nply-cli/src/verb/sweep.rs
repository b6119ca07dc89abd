//! `nply sweep`: a table with a row for each set of data.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::Path;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError, mpsc};
use std::thread;

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command};
use indicatif::{ProgressBar, ProgressStyle};
use nply_sheet::sweep::{States, Study, SweepFlags, Trail};
use nply_sheet::table::{Block, BlockFile, Column, Encoder, Format, TableError, TableReader, Values};
use nply_sheet::{ErrorKind, Place, SpecError};

use super::Verb;
use crate::arguments::with_keys;
use crate::failure::Failure;
use crate::input::{self, Input};
use crate::interrupt;
use crate::output::{self, shown};
use crate::part::{self, Part};

const LONG: &str = "\
A table with a row for each set of data: any data on ranges, lists, grids or samples, or the rows of a given CSV or Parquet file, and what
is asked of the ply beside them. FILE describes the ply; [sweep] in it, or flags, say what varies and what is asked. Rows are in order (of a
grid the last datum varies fastest), all cores work, memory does not grow with the number of rows. A row that cannot be solved has its
reason in the last column.

The table goes to --output (CSV, Parquet or Arrow, by the name's ending) or as CSV to standard output. Until it is whole it stands as
NAME.part, with NAME.part.log beside it; Ctrl-C leaves it readable, and --resume goes on with it, also after a power cut.";

const EXAMPLES: &str = "\
Examples:
  nply sweep examples/studies/yarn-twist.toml --output yarn.parquet
  nply sweep examples/three-ply-yarn.toml --sweep \"load.force=0:2 mN:11\" --sweep strands=2,3,4 --states stable
  nply sweep --strands 3 --sweep \"helical_angle=1 deg:80 deg:1e6\" --outputs radius_ratio,arclength_shift --output contact.parquet
  nply sweep rope.toml --sample sobol --points 1e5 --sweep \"pretwist=-1:1\" --sweep \"force=0:2 kN\" --output rope.arrow
  nply sweep rope.toml --rows lays.csv --outputs moment --output moments.csv

What varies is named as in the file (`load.force`) or as its flag: KEY=FROM:TO:COUNT, KEY=FROM:TO:COUNT:log or KEY=A,B,C; a unit at the end
stands for all. Samples take KEY=FROM:TO. A file of rows has its data in columns of these names, with their unit behind (`lay_length_mm`).
What can be asked: every column of `nply solve`, `nply support` or `nply contact`, with a unit behind it if you like (`lay_length_mm`).";

pub(super) const VERB: Verb = Verb {
    name: "sweep",
    about: "A table over any data: grids, lists, samples, given rows",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let words = |name: &'static str, known: &'static [&'static str]| {
        Arg::new(name).long(name).value_name("WORD").value_parser(PossibleValuesParser::new(known.iter().copied()))
    };
    let whole = |name: &'static str| Arg::new(name).long(name).value_name("N").value_parser(whole_number);
    with_keys(command, |_| true)
        .after_help(EXAMPLES)
        .arg(
            Arg::new("sweep")
                .long("sweep")
                .value_name("KEY=FROM:TO:COUNT")
                .action(ArgAction::Append)
                .allow_hyphen_values(true)
                .help("What varies (repeat it; of a grid the last varies fastest)"),
        )
        .arg(
            words("order", &["grid", "zip"])
                .help("Each value with each (grid, the default), or the first with the first (zip)"),
        )
        .arg(
            words("sample", &["sobol", "latin"])
                .help("Draw points from the ranges: Sobol's sequence, or a Latin hypercube"),
        )
        .arg(whole("points").help("How many points a sample has, such as 1e6"))
        .arg(whole("seed").help("Which sample: the same seed gives the same points (0)"))
        .arg(Arg::new("rows").long("rows").value_name("FILE").help("A CSV or Parquet file whose rows are the data"))
        .arg(
            Arg::new("outputs")
                .long("outputs")
                .value_delimiter(',')
                .value_name("NAMES")
                .help("What is asked, such as helical_angle,lay_length_mm"),
        )
        .arg(words("states", &["all", "stable", "continued"]).help(
            "A row for every state (all, the default), for stable ones, or for the one followed from the row before",
        ))
        .arg(words("question", &["contact", "states", "supports"]).help(
            "What to find: the shape of a lay, states, or what carries the strands (by what is given, if not said)",
        ))
        .arg(output::file("Where to write: .csv, .parquet, or .arrow"))
        .arg(
            Arg::new("resume")
                .long("resume")
                .action(ArgAction::SetTrue)
                .help("Go on with a table that was left unfinished"),
        )
        .arg(interrupt::jobs())
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
}

/// A whole number, also as 1e6.
fn whole_number(text: &str) -> Result<u64, String> {
    const LARGEST: f64 = 9_007_199_254_740_992.0; // 2⁵³
    let of_float = |value: f64| ((0.0..=LARGEST).contains(&value) && value.fract() == 0.0).then_some(value as u64);
    let found = text.parse().ok().or_else(|| of_float(text.parse().ok()?));
    found.ok_or_else(|| "what is wanted is a whole number, such as 1000 or 1e6".to_owned())
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let word = |name: &str| arguments.get_one::<String>(name).cloned();
    let words = |name: &str| arguments.get_many::<String>(name).into_iter().flatten().cloned().collect();
    let flags = SweepFlags {
        sweep: words("sweep"),
        order: word("order"),
        sample: word("sample"),
        points: arguments.get_one::<u64>("points").copied(),
        seed: arguments.get_one::<u64>("seed").copied(),
        rows: word("rows"),
        outputs: words("outputs"),
        states: word("states"),
        question: word("question"),
    };
    let study = Study::from_spec(&input.spec, &flags).map_err(|error| input.refused(error))?;
    if !study.varies() && !study.takes_rows() {
        let message =
            "nothing varies: say what, such as `--sweep pretwist=-1:1:1001`, by [sweep] in the file, or by --rows FILE";
        return Err(input.refused(SpecError::new(ErrorKind::Missing, Place::Flag("sweep".to_owned()), message)));
    }
    let rows = flags.rows.as_deref().or_else(|| input.spec.sweep_rows());
    if let (Some(rows), Some(path)) = (rows, arguments.get_one::<String>("output"))
        && let place @ Some(_) = output::place_of(rows.as_ref())
        && place == output::place_of(path.as_ref())
    {
        return Err(flag_refused(
            "output",
            &format!("{} is read as well, and would be lost: give another name", shown(rows.as_ref())),
        ));
    }
    let source = Source::of(&study, rows.filter(|_| study.takes_rows()), &input)?;
    let columns = source.columns(&input)?;
    interrupt::prepare(arguments);
    let resume = arguments.get_flag("resume");
    let bar = Bar::new(arguments.get_flag("quiet"), source.total());
    let Some(path) = arguments.get_one::<String>("output") else {
        if resume {
            return Err(flag_refused("resume", "what goes to standard output cannot be gone on with: give --output"));
        }
        let encoder = encoder(Format::Csv, columns, &study)?;
        let mut table = BlockFile::new(&encoder, output::Lines::new()).map_err(Failure::of_table)?;
        walk(&source, &encoder, 0, &bar, &mut |_, block| table.append(block).map(drop).map_err(Failure::of_table))?;
        return table.finish().map_err(Failure::of_table)?.finish();
    };
    let given = Path::new(path);
    let ending = given.extension().map(|ending| ending.to_string_lossy().into_owned());
    let format = ending.as_deref().map_or(Some(Format::Csv), Format::of_ending);
    let is_file = std::fs::metadata(given).map_or(true, |about| about.is_file());
    let Some(format) = format.or_else(|| (!is_file).then_some(Format::Csv)) else {
        let message = format!(
            "tables are CSV (.csv), Parquet (.parquet) or Arrow (.arrow) by the end of the file's name: {} is neither",
            shown(given)
        );
        return Err(flag_refused("output", &message));
    };
    let encoder = encoder(format, columns, &study)?;
    if std::fs::metadata(given).is_ok_and(|about| about.is_dir()) || path.is_empty() {
        let error = io::Error::new(io::ErrorKind::IsADirectory, "it is no file");
        return Err(Failure::File { what: format!("cannot write {}", shown(given)), error });
    }
    if !is_file {
        return to_device(&source, &encoder, given, resume, &bar);
    }
    // a link is followed, so that what it points to is replaced and not the link
    let name = std::fs::canonicalize(given).unwrap_or_else(|_| given.to_owned());
    let identity = format!("{}{}", study_said(&study), source.identity());
    let Some(mut part) = Part::open(&name, &encoder, &identity, resume)? else {
        return output::write(&format!("{} is whole: there is nothing to go on with\n", shown(given)));
    };
    let begins = part.done();
    match walk(&source, &encoder, begins, &bar, &mut |done, block| part.append(done, block)) {
        Ok(()) => part.keep(),
        Err(Failure::Interrupted) => Err(Failure::Stopped(part.leave()?)),
        Err(failure @ (Failure::Table(_) | Failure::Refused(..))) => {
            // what is wrong with the input is wrong another time too
            part.discard();
            Err(failure)
        }
        Err(failure) => Err(failure),
    }
}

/// What is no file (a pipe, a device) is written to as it is.
fn to_device(source: &Source<'_>, encoder: &Encoder, path: &Path, resume: bool, bar: &Bar) -> Result<(), Failure> {
    if resume {
        return Err(flag_refused("resume", "what goes to no file cannot be gone on with"));
    }
    let cannot = |error| Failure::of_table_in(&shown(path), error);
    let file = File::options().write(true).open(path).map_err(|error| cannot(TableError::Write(error)))?;
    let mut table = BlockFile::new(encoder, io::BufWriter::new(file)).map_err(cannot)?;
    walk(source, encoder, 0, bar, &mut |_, block| table.append(block).map(drop).map_err(cannot))?;
    table.finish().map_err(cannot).map(drop)
}

fn encoder(format: Format, columns: Vec<Column>, study: &Study) -> Result<Encoder, Failure> {
    Encoder::new(format, columns, &study.metadata()).map_err(|error| Failure::Table(error.to_string()))
}

fn flag_refused(flag: &str, message: &str) -> Failure {
    Failure::Refused(SpecError::new(ErrorKind::Contradiction, Place::Flag(flag.to_owned()), message), String::new())
}

/// What makes a table this one: everything its file says of itself.
fn study_said(study: &Study) -> String {
    study.metadata().into_iter().map(|(key, value)| format!("{key}: {value}\n")).collect()
}

/// Rows of a block that are worked out as arrays, where little else than x and ρ is asked.
const ARRAY: u64 = 1 << 17;
/// Rows of any other block.
const SINGLE: u64 = 1 << 12;
/// Rows worked out between two looks at Ctrl-C.
const STEP: u64 = 1 << 8;

/// Where blocks come from.
enum Source<'s> {
    /// the study's own rows, so many to a block
    Own { study: &'s Study, block: u64 },
    /// rows of a file
    Given { study: &'s Study, path: String, format: Format, columns: Vec<Column>, total: Option<u64>, about: String },
}

/// What a worker takes: which block, and where its rows begin and how many they are, or the rows themselves.
enum Task {
    Own { first: u64, count: u64 },
    Given { first: u64, cells: Vec<Values> },
}

impl<'s> Source<'s> {
    fn of(study: &'s Study, rows: Option<&str>, input: &Input) -> Result<Self, Failure> {
        let Some(path) = rows else {
            let block = if study.is_fast() { ARRAY } else { SINGLE };
            let run = study.run_length();
            // states are continued within runs: whole runs, where they are short
            let block = match study.states() {
                States::Continued if run <= block => block / run * run,
                _ => block,
            };
            return Ok(Self::Own { study, block });
        };
        let named = Path::new(path);
        let ending = named.extension().map(|ending| ending.to_string_lossy().into_owned());
        let Some(format) = ending.as_deref().map_or(Some(Format::Csv), Format::of_ending) else {
            let message = format!("rows are read from CSV (.csv) or Parquet (.parquet): {} is neither", shown(named));
            return Err(input.refused(SpecError::new(ErrorKind::WrongType, Place::Flag("rows".to_owned()), message)));
        };
        let reader = open(path, format, 0)?;
        let about = about(path).map_err(|error| unreadable(path, TableError::Write(error)))?;
        let (columns, total) = (reader.columns().to_vec(), reader.rows());
        let carried = Study::carried(&columns);
        let left: Vec<&str> =
            (0..columns.len()).filter(|at| !carried.contains(at)).map(|at| columns[at].name.as_str()).collect();
        if !left.is_empty() {
            output::note(&format!(
                "{} of {} comes from an earlier sweep and is left out: this table has its own",
                left.join(" and "),
                shown(named)
            ));
        }
        Ok(Self::Given { study, path: path.to_owned(), format, columns, total, about })
    }

    /// The columns of the table.
    fn columns(&self, input: &Input) -> Result<Vec<Column>, Failure> {
        match self {
            Self::Own { study, .. } => Ok(study.columns().to_vec()),
            Self::Given { study, columns, .. } => {
                let own = study.given_columns(columns).map_err(|error| input.refused(error))?;
                Ok(Study::carried(columns).into_iter().map(|at| columns[at].clone()).chain(own).collect())
            }
        }
    }

    fn total(&self) -> Option<u64> {
        match self {
            Self::Own { study, .. } => Some(study.rows()),
            Self::Given { total, .. } => *total,
        }
    }

    fn identity(&self) -> String {
        match self {
            Self::Own { .. } => String::new(),
            Self::Given { about, .. } => about.clone(),
        }
    }

    /// Whether blocks follow from each other, so that one thread has to work them out in turn.
    fn is_one_run(&self) -> bool {
        match self {
            Self::Own { study, block } => study.states() == States::Continued && study.run_length() > *block,
            Self::Given { .. } => false,
        }
    }

    /// A block's rows, worked out and encoded; `None` if Ctrl-C came between.
    fn solve(&self, task: Task, encoder: &Encoder, trail: &mut Trail) -> Result<(u64, Block), Failure> {
        let (done, chunk) = match (self, task) {
            (Self::Own { study, .. }, Task::Own { first, count }) => {
                let step = if study.is_fast() { count } else { STEP };
                let mut whole: Option<Vec<Values>> = None;
                let mut at = first;
                while at < first + count {
                    interrupt::check()?;
                    let more = step.min(first + count - at);
                    let chunk = study.chunk_on(trail, at, usize::try_from(more).unwrap_or(usize::MAX));
                    match &mut whole {
                        None => whole = Some(chunk),
                        Some(whole) => whole.iter_mut().zip(chunk).for_each(|(whole, more)| whole.extend(more)),
                    }
                    at += more;
                }
                (first + count, whole.unwrap_or_default())
            }
            (Self::Given { study, columns, .. }, Task::Given { first, cells }) => {
                interrupt::check()?;
                let count = cells.first().map_or(0, Values::len) as u64;
                let solved = study.solve_given(columns, &cells);
                let (places, answers) = solved.map_err(|error| Failure::Refused(error, String::new()))?;
                let mut chunk: Vec<Values> =
                    Study::carried(columns).into_iter().map(|at| cells[at].taken(&places)).collect();
                chunk.extend(answers);
                (first + count, chunk)
            }
            _ => (0, Vec::new()), // a source gives tasks of its own kind
        };
        let block = encoder.block(&chunk).map_err(|error| Failure::Table(error.to_string()))?;
        Ok((done, block))
    }
}

fn unreadable(path: &str, error: TableError) -> Failure {
    match error {
        TableError::Write(error) => Failure::File { what: format!("cannot read {}", shown(Path::new(path))), error },
        other => {
            let said = other.to_string();
            Failure::Table(format!(
                "{} cannot be read as a table: {}",
                shown(Path::new(path)),
                said.trim_end_matches('.')
            ))
        }
    }
}

fn open(path: &str, format: Format, skipped: u64) -> Result<TableReader<File>, Failure> {
    let file = File::open(path).and_then(|file| {
        let about = file.metadata()?;
        if about.is_dir() { Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder")) } else { Ok(file) }
    });
    let file = file.map_err(|error| unreadable(path, TableError::Write(error)))?;
    TableReader::open(format, file, SINGLE as usize, skipped).map_err(|error| unreadable(path, error))
}

/// What a file of rows is known by when it is met again: its length, and a sum over its beginning and its end.
fn about(path: &str) -> io::Result<String> {
    const PIECE: u64 = 1 << 16;
    let mut file = File::open(path)?;
    let length = file.metadata()?.len();
    let mut bytes = Vec::new();
    (&mut file).take(PIECE).read_to_end(&mut bytes)?;
    file.seek(SeekFrom::Start(length.saturating_sub(PIECE)))?;
    file.take(PIECE).read_to_end(&mut bytes)?;
    Ok(format!("rows: {length} bytes, {:016x}\n", part::checksum(&bytes)))
}

/// Tasks in order, each handed to one worker.
struct Tasks<'s> {
    next: u64,
    first: u64,
    from: From<'s>,
}

enum From<'s> {
    Own { end: u64, block: u64 },
    Given { reader: Box<TableReader<File>>, path: &'s str },
}

impl Tasks<'_> {
    fn take(&mut self) -> Result<Option<(u64, Task)>, Failure> {
        let number = self.next;
        let first = self.first;
        let task = match &mut self.from {
            From::Own { end, block } => {
                // blocks stand where they would without a beginning in between
                let count = (*block - first % *block).min(end.saturating_sub(first));
                if count == 0 {
                    return Ok(None);
                }
                self.first += count;
                Task::Own { first, count }
            }
            From::Given { reader, path } => match reader.next_chunk().map_err(|error| unreadable(path, error))? {
                None => return Ok(None),
                Some(cells) => {
                    self.first += cells.first().map_or(0, Values::len) as u64;
                    Task::Given { first, cells }
                }
            },
        };
        self.next += 1;
        Ok(Some((number, task)))
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Every block from a row on, worked out on all cores and handed on in order. Workers are at most a few blocks ahead of what is written.
fn walk(
    source: &Source<'_>,
    encoder: &Encoder,
    begins: u64,
    bar: &Bar,
    take: &mut dyn FnMut(u64, Block) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let workers = if source.is_one_run() { 1 } else { rayon::current_num_threads().max(1) };
    let ahead = 2 * workers as u64 + 1;
    let from = match source {
        Source::Own { study, block } => From::Own { end: study.rows(), block: *block },
        Source::Given { path, format, .. } => From::Given { reader: Box::new(open(path, *format, begins)?), path },
    };
    let tasks = Mutex::new(Tasks { next: 0, first: begins, from });
    // how many blocks are written; all of them where nobody waits any more
    let written = (Mutex::new(0_u64), Condvar::new());
    let (send, receive) = mpsc::channel();
    bar.begin(begins);
    let result = thread::scope(|scope| {
        for _ in 0..workers {
            let send = send.clone();
            let (tasks, written) = (&tasks, &written);
            scope.spawn(move || {
                let mut trail = Trail::default();
                loop {
                    let (number, task) = match locked(tasks).take() {
                        Ok(Some(task)) => task,
                        Ok(None) => return,
                        Err(failure) => {
                            let _ = send.send(Err(failure));
                            return;
                        }
                    };
                    let mut count = locked(&written.0);
                    while number >= count.saturating_add(ahead) {
                        count = written.1.wait(count).unwrap_or_else(PoisonError::into_inner);
                    }
                    let gone = *count == u64::MAX;
                    drop(count);
                    if gone {
                        return;
                    }
                    let solved = source.solve(task, encoder, &mut trail).map(|(done, block)| (number, done, block));
                    let failed = solved.is_err();
                    // where nobody takes it any more, there is an error already
                    if send.send(solved).is_err() || failed {
                        return;
                    }
                }
            });
        }
        drop(send);
        let mut early = BTreeMap::new();
        let mut next = 0;
        let mut failure = None;
        for solved in &receive {
            let written_on = solved.and_then(|(number, done, block)| {
                early.insert(number, (done, block));
                while let Some((done, block)) = early.remove(&next) {
                    take(done, block)?;
                    bar.at(done);
                    next += 1;
                }
                interrupt::check()
            });
            *locked(&written.0) = match &written_on {
                Ok(()) => next,
                Err(_) => u64::MAX,
            };
            written.1.notify_all();
            if let Err(found) = written_on {
                failure = Some(found);
                break;
            }
        }
        // what is ready and in order is not thrown away on Ctrl-C
        if matches!(failure, Some(Failure::Interrupted)) {
            for (number, done, block) in receive.iter().flatten() {
                early.insert(number, (done, block));
            }
            while let Some((done, block)) = early.remove(&next) {
                take(done, block)?;
                next += 1;
            }
        }
        failure.map_or(Ok(()), Err)
    });
    bar.end();
    // a failed block of an interrupted run is no other failure
    result
}

/// How far it is, on a terminal.
struct Bar(ProgressBar);

impl Bar {
    fn new(quiet: bool, total: Option<u64>) -> Self {
        let bar = match (quiet, total) {
            (true, _) => ProgressBar::hidden(),
            (false, Some(total)) => ProgressBar::new(total),
            (false, None) => ProgressBar::new_spinner(),
        };
        let style = match total {
            Some(_) => "{wide_bar} {human_pos}/{human_len} rows, {rate}, {eta} left",
            None => "{spinner} {human_pos} rows, {rate}",
        };
        if let Ok(style) = ProgressStyle::with_template(style) {
            let rate = |state: &indicatif::ProgressState, out: &mut dyn std::fmt::Write| {
                let _ = write!(out, "{:.3e}/s", state.per_sec());
            };
            bar.set_style(style.with_key("rate", rate));
        }
        Self(bar)
    }

    fn begin(&self, done: u64) {
        self.0.set_position(done);
        self.0.reset_eta();
    }

    fn at(&self, done: u64) {
        self.0.set_position(done);
    }

    fn end(&self) {
        self.0.finish_and_clear();
    }
}
