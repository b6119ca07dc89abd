//! Studies: the locus, a path, a map.

use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::ArgMatches;
use indicatif::{ProgressBar, ProgressStyle};
use nply_sheet::map::{Cell, Map, MapFlags, MapPicture, Tally};
use nply_sheet::table::TableWriter;
use nply_sheet::{ErrorKind, LocusReport, Place, SpecError, TraceReport, Walk};
use rayon::prelude::*;

use crate::failure::Failure;
use crate::input::{self, Input};
use crate::output::{self, Draft, Format};

/// `nply locus`: the loads at which touching strands part.
pub(crate) fn locus(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let points = arguments.get_one::<u32>("points").map_or(LocusReport::POINTS, |points| *points as usize);
    let report =
        input.spec.check().and_then(|case| LocusReport::of(&case, points)).map_err(|error| input.refused(error))?;
    plot(arguments, || report.picture().svg())?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// `nply trace`: a ply followed along a path.
pub(crate) fn trace(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let leg = input::corner(arguments, "to-")?;
    let walk = Walk {
        start: arguments.get_one::<u32>("start").map(|start| *start as usize),
        kept: arguments.get_flag("kept"),
        curvature_limit: arguments.get_one::<f64>("curvature-limit").copied(),
    };
    let report = input
        .spec
        .check_path(leg.as_ref())
        .and_then(|cases| TraceReport::of(cases, walk))
        .map_err(|error| input.refused(error))?;
    plot(arguments, || report.picture().svg())?;
    output::write(&match Format::of(arguments) {
        Format::Table => report.text(true),
        Format::Json => report.json(),
        Format::Csv => report.csv(),
    })
}

/// Draws the picture, where one is asked for.
fn plot(arguments: &ArgMatches, svg: impl Fn() -> String) -> Result<(), Failure> {
    let Some(path) = arguments.get_one::<String>("plot") else { return Ok(()) };
    let mut draft = Draft::new(path)?;
    draft.write(svg().as_bytes())?;
    draft.keep()
}

/// Points worked out between two looks at the clock and at Ctrl-C, in whole rows, at most 64 of them.
const STRETCH: usize = 1 << 16;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// `nply map`: every state over a rectangle of two data.
pub(crate) fn map(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read(arguments)?;
    let flags = MapFlags {
        from: input::corner(arguments, "from-")?,
        to: input::corner(arguments, "to-")?,
        columns: arguments.get_one::<u32>("columns").copied(),
        rows: arguments.get_one::<u32>("rows").copied(),
    };
    let map = input.spec.check_map(Some(&flags)).map_err(|error| input.refused(error))?;
    let file = |name| arguments.get_one::<String>(name);
    if let (Some(table), Some(picture)) = (file("output"), file("plot"))
        && table == picture
    {
        let message = "table and picture would be written to the same file: give one of them another name";
        let place = Place::Flag("plot".to_owned());
        return Err(input.refused(SpecError::new(ErrorKind::Contradiction, place, message)));
    }
    if let Some(jobs) = arguments.get_one::<u32>("jobs").and_then(|jobs| NonZeroUsize::new(*jobs as usize)) {
        // fails only where threads stand already, and then so many are used
        let _ = rayon::ThreadPoolBuilder::new().num_threads(jobs.get()).build_global();
    }
    // where it cannot be caught, Ctrl-C ends the program as it does any other
    let _ = ctrlc::set_handler(|| INTERRUPTED.store(true, Ordering::Relaxed));
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
        plot(arguments, || picture.svg(map))?;
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
        if INTERRUPTED.load(Ordering::Relaxed) {
            bar.finish_and_clear();
            return Err(Failure::Interrupted);
        }
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
