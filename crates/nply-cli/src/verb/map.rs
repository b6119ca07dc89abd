//! `nply map`: every state over a rectangle of two data.

use std::path::Path;

use clap::{Arg, ArgAction, ArgMatches, Command};
use indicatif::{ProgressBar, ProgressStyle};
use nply_sheet::Table;
use nply_sheet::map::{Cell, Map, MapFlags, MapPicture, Tally};
use nply_sheet::table::TableWriter;
use rayon::prelude::*;

use super::Verb;
use crate::arguments::{corners, count, plot, with_keys};
use crate::failure::Failure;
use crate::input::{self, Input};
use crate::interrupt;
use crate::output::{self, Draft};

const LONG: &str = "\
Finds every state over a rectangle of two data, on all cores: the number of states, angle, pressure, stable or not,
separated or not. The corners are given by --from-... and --to-... flags (the first --to-... runs across, the second up)
or by `from` and `to` in [map] of FILE. Writes a table, one row a state, to --output (CSV, or Parquet if it ends in
.parquet) or to standard output, and a picture to --plot.";

/// Points worked out between two looks at the clock and at Ctrl-C, in whole rows, at most 64 of them.
const STRETCH: usize = 1 << 16;

pub(super) const VERB: Verb =
    Verb { name: "map", about: "Every state over two data", long: LONG, examples: true, arguments, run };

fn arguments(command: Command) -> Command {
    let command = with_keys(command, |key| key.table != Table::Lay && key.name != "separation");
    let command = corners(command, "from-", "Where the rectangle begins");
    corners(command, "to-", "Where it ends: the first of these runs across, the second up")
        .arg(count("columns", "Points across (200)", u32::MAX.into()))
        .arg(count("rows", "Points up (200)", u32::MAX.into()))
        .arg(output::file("Where to write the table: CSV, or Parquet if the name ends in .parquet"))
        .arg(plot())
        .arg(interrupt::jobs())
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let flags = MapFlags {
        from: input::corner(arguments, "from-")?,
        to: input::corner(arguments, "to-")?,
        columns: arguments.get_one::<u32>("columns").copied(),
        rows: arguments.get_one::<u32>("rows").copied(),
    };
    let map = input.spec.check_map(Some(&flags)).map_err(|error| input.refused(error))?;
    interrupt::prepare(arguments);
    let drawn = arguments.get_one::<String>("plot");
    let mut picture = drawn.map(|_| MapPicture::new(&map));
    let quiet = arguments.get_flag("quiet");
    match (arguments.get_one::<String>("output"), drawn) {
        (Some(path), _) => {
            let draft = Draft::new(path)?;
            let parquet = Path::new(path).extension().is_some_and(|extension| extension == "parquet");
            let table = if parquet {
                let metadata = metadata(&map);
                let metadata: Vec<(&str, &str)> = metadata.iter().map(|(key, value)| (*key, value.as_str())).collect();
                TableWriter::parquet(map.columns(), &metadata, draft)
            } else {
                TableWriter::csv(map.columns(), draft)
            };
            let cannot = |error| Failure::of_table_in(path, error);
            let mut table = table.map_err(cannot)?;
            let tally = walk(&map, &input, quiet, &mut picture, |first, rows| {
                table.write_chunk(&map.chunk(first, rows)).map_err(cannot)
            })?;
            table.finish().map_err(cannot)?.keep()?;
            finish(arguments, &map, picture.as_ref(), &tally)
        }
        (None, Some(_)) => {
            let tally = walk(&map, &input, quiet, &mut picture, |_, _| Ok(()))?;
            finish(arguments, &map, picture.as_ref(), &tally)
        }
        (None, None) => {
            let mut table = TableWriter::csv(map.columns(), output::Lines::new()).map_err(Failure::of_table)?;
            walk(&map, &input, quiet, &mut picture, |first, rows| {
                table.write_chunk(&map.chunk(first, rows)).map_err(Failure::of_table)
            })?;
            table.finish().map_err(Failure::of_table)?.finish()
        }
    }
}

/// What a file says of itself.
fn metadata(map: &Map) -> Vec<(&'static str, String)> {
    let case = map.case();
    let mut said = vec![
        ("program", "nply".to_owned()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("title", case.title.clone().unwrap_or_default()),
        ("strands", case.strands.to_string()),
        ("balance", case.balance.name().to_owned()),
    ];
    said.extend(map.held().into_iter().map(|(datum, value)| (datum.name(), format!("{value:?}"))));
    said.extend(case.strand_radius.map(|radius| ("strand_radius_m", format!("{radius:?}"))));
    said.extend(case.scale.map(|scale| ("bending_stiffness_N_m2", format!("{:?}", scale.bending_stiffness()))));
    said
}

/// The picture, and a few lines on what is in it.
fn finish(arguments: &ArgMatches, map: &Map, picture: Option<&MapPicture>, tally: &Tally) -> Result<(), Failure> {
    if let Some(picture) = picture {
        output::plot(arguments, || picture.svg(map))?;
    }
    output::write(&tally.text(map))
}

/// Every row, on all cores, handed on in order.
fn walk(
    map: &Map,
    input: &Input,
    quiet: bool,
    picture: &mut Option<MapPicture>,
    mut take: impl FnMut(usize, &[Vec<Cell>]) -> Result<(), Failure>,
) -> Result<Tally, Failure> {
    let rows = map.y.count as usize;
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(rows as u64) };
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} rows, {eta} left") {
        bar.set_style(style);
    }
    let mut tally = Tally::default();
    let stretch = (STRETCH / map.x.count as usize).clamp(1, 64);
    for first in (0..rows).step_by(stretch) {
        interrupt::check().inspect_err(|_| bar.finish_and_clear())?;
        let last = (first + stretch).min(rows);
        let cells: Result<Vec<Vec<Cell>>, _> = (first..last).into_par_iter().map(|row| map.row(row)).collect();
        let cells = cells.map_err(|error| input.refused(map.case().locate(&error)))?;
        for (i, row) in cells.iter().enumerate() {
            tally.add(map, row);
            if let Some(picture) = picture {
                picture.put(map, first + i, row);
            }
        }
        take(first, &cells)?;
        bar.inc((last - first) as u64);
    }
    bar.finish_and_clear();
    Ok(tally)
}
