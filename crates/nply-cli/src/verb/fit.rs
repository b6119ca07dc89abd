//! `nply fit`: stiffnesses, size and twist of the strands from measurements.

use clap::{Arg, ArgAction, ArgMatches, Command};
use indicatif::{ProgressBar, ProgressStyle};
use nply_sheet::regression::{Measurements, Regression, RegressionQuestion, RegressionReport};
use nply_sheet::{Datum, ErrorKind, Key, Place, SpecError, Table};

use super::Verb;
use crate::arguments::{count, format, json, plot, with_keys};
use crate::failure::Failure;
use crate::input;
use crate::interrupt;
use crate::output::{self, Draft, Format};

const LONG: &str = "\
Estimates numbers of the strands from measurements, by least squares with the errors of the data: any of stiffness_ratio (C/B),
bending_stiffness, torsional_stiffness, youngs_modulus, shear_modulus, radius, diameter, pretwist, turns_per_length, strand_twist, and
axial_stiffness (EA, the k of a string) where strands stretch. DATA is a table with a header that names columns and their units, as in
`force [N],force_error,lay_length_mm`: loads and shapes in any mix. A column with errors is measured, one without is held; a load in no
column and not in the ply's description is 0; an empty cell is not known. S and Z stand in place of the sign of turns; where `;` or
tabs part the cells, commas are decimal. The ply comes from FILE and flags, as for `nply solve`; what is
estimated stands there too, as a rough value to start from.

Gives estimates with standard errors and correlations, the sum of squares and its chance, and every residual; says which numbers, or
which combination, the data do not determine, which rows are left out and which stands alone. Each row belongs to the state, of all in equilibrium, nearest to what was measured.";

const EXAMPLES: &str = "\
Examples:
  nply fit examples/fit/balance.csv --strands 3 --stiffness-ratio 1 --estimate stiffness_ratio
  nply fit examples/fit/cord-pull.csv examples/fit/cord.toml --estimate bending_stiffness,stiffness_ratio,diameter --plot cord.svg
  nply fit pull.csv ply.toml --estimate pretwist --error lay_length=0.1mm --output residuals.csv --json

Columns: force, moment, length_ratio (ply length/strand length), ply_length, ply_rotation, ply_turns, ply_turns_per_strand_length,
ply_turns_per_length, helical_angle, lay_angle, pitch_angle, lay_length, lay_ratio, radius_ratio, helix_radius, outer_diameter; pretwist,
turns_per_length or strand_twist where the twist differs from row to row; `..._error` beside each; note.";

/// Tables of measurements are not larger than this (64 MiB).
const LARGEST: u64 = 64 << 20;

pub(super) const VERB: Verb = Verb {
    name: "fit",
    about: "Stiffnesses, size and twist of the strands from measurements",
    long: LONG,
    examples: false,
    arguments,
    run,
};

fn arguments(command: Command) -> Command {
    let list = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name("NAMES").value_delimiter(',').action(ArgAction::Append).help(help)
    };
    let data = Arg::new("data").value_name("DATA").required(true).help("Measurements (CSV); `-` reads standard input");
    let wanted = |key: &Key| match key.table {
        Table::Ply | Table::Strand | Table::Twist => true,
        Table::Load => matches!(key.datum, Datum::Force | Datum::Moment),
        _ => false,
    };
    with_keys(command.arg(data), wanted)
        .arg(list("estimate", "What is to be estimated").required(true))
        .arg(list("measured", "Columns that are measured though the data give no errors with them"))
        .arg(list("held", "Columns that are held though the data give errors with them"))
        .arg(
            Arg::new("error")
                .long("error")
                .value_name("COLUMN=ERROR")
                .action(ArgAction::Append)
                .help("Standard error of a column in every row: lay_length=0.1mm, force=2%; or of an estimate's start, where that was measured too: diameter=0.01mm"),
        )
        .arg(count("starts", "Starts of the search, the given one and others about it (12)", 1000))
        .arg(output::file("Where to write the residuals, one row a row of the data (CSV)"))
        .arg(plot())
        .arg(output::zoom())
        .arg(format())
        .arg(json())
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
        .after_help(EXAMPLES)
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    interrupt::listen();
    let path = arguments.get_one::<String>("data").map_or("-", String::as_str);
    if path == "-" && arguments.get_one::<String>("file").is_some_and(|file| file == "-") {
        let message = "standard input is the data and the ply: one of them must be a file";
        return Err(Failure::Refused(
            SpecError::new(ErrorKind::Contradiction, Place::Flag("file".to_owned()), message),
            String::new(),
        ));
    }
    let input = input::read(arguments)?;
    let (name, bytes) = input::contents_of(path, LARGEST, "it is larger than 64 MiB: fit a part of it")?;
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let data = Measurements::read(name, &bytes).map_err(|error| Failure::Refused(error, text))?;
    let words = |name: &str| arguments.get_many::<String>(name).into_iter().flatten().cloned().collect::<Vec<String>>();
    let question = RegressionQuestion {
        estimate: words("estimate"),
        measured: words("measured"),
        held: words("held"),
        errors: words("error"),
        starts: arguments.get_one::<u32>("starts").map(|starts| *starts as usize),
    };
    let bar = bar(arguments, question.starts.unwrap_or(Regression::STARTS));
    let may_go_on = |behind: usize| {
        bar.set_position(behind as u64);
        interrupt::check().is_ok()
    };
    let report = RegressionReport::of_while(&input.spec, &data, &question, &may_go_on);
    bar.finish_and_clear();
    interrupt::check()?;
    let report = report.map_err(|error| match error.place() {
        // the line that is shown is that of the file it stands in
        Place::File { name: file, .. } if **file == *name => Failure::Refused(error, data.text().to_owned()),
        _ => input.refused(error),
    })?;
    if let Some(path) = arguments.get_one::<String>("output") {
        let mut draft = Draft::new(path)?;
        draft.write(report.csv().as_bytes())?;
        draft.keep()?;
    }
    output::plot(arguments, || report.picture().svg())?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// How many starts are behind, on a terminal.
fn bar(arguments: &ArgMatches, starts: usize) -> ProgressBar {
    let bar = if arguments.get_flag("quiet") { ProgressBar::hidden() } else { ProgressBar::new(starts as u64) };
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} starts, {elapsed}") {
        bar.set_style(style);
    }
    bar
}
