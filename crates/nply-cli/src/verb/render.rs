//! `nply render`: a shaded picture of a ply.

use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Command};
use indicatif::{ProgressBar, ProgressStyle};
use nply_sheet::render::{Ground, Picture, View};
use nply_sheet::{Dimension, ErrorKind, Quantity, SpecError};
use rayon::prelude::*;

use super::Verb;
use super::mesh::{deliver, refusal, shape, shown, text, wanted};
use crate::arguments::count;
use crate::failure::Failure;
use crate::input;
use crate::interrupt;
use crate::output;

const LONG: &str = "\
Draws a ply as a shaded picture (PNG), by rays against the exact surfaces of its strands. Which ply, and how much of it,
is said as for `nply mesh`. It lies across the picture: --tilt turns its near end towards the eye, --turn turns it about
its own axis, --roll in the picture.";

pub(super) const VERB: Verb =
    Verb { name: "render", about: "A shaded picture of a ply", long: LONG, examples: true, arguments, run };

/// Rows drawn between two looks at the clock and at Ctrl-C.
const STRETCH: u32 = 16;

fn arguments(command: Command) -> Command {
    const WIDEST: i64 = 16_384;
    let angle = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name("ANGLE").allow_hyphen_values(true).help(help)
    };
    shown(command)
        .arg(output::file("Where to write the picture (PNG)"))
        .arg(count("width", "Pixels across (1200)", WIDEST))
        .arg(count("height", "Pixels up; fitted to the ply, if nothing is said", WIDEST))
        .arg(angle("turn", "How far the ply is turned about its own axis (0 deg)"))
        .arg(angle("tilt", "How far its end is turned towards the eye (20 deg)"))
        .arg(angle("roll", "How far its axis is turned in the picture (0 deg)"))
        .arg(
            Arg::new("background")
                .long("background")
                .value_name("GROUND")
                .value_parser(PossibleValuesParser::new(["light", "dark", "transparent"]))
                .default_value("light")
                .help("What is behind the ply"),
        )
        .arg(
            Arg::new("no-shadow")
                .long("no-shadow")
                .action(ArgAction::SetTrue)
                .help("No shadow on what is behind the ply"),
        )
        .arg(interrupt::jobs())
        .arg(Arg::new("quiet").long("quiet").short('q').action(ArgAction::SetTrue).help("No progress bar"))
}

/// An angle that a flag says, in rad.
fn angle(arguments: &ArgMatches, name: &str, otherwise: f64) -> Result<f64, SpecError> {
    let Some(said) = text(arguments, name) else { return Ok(otherwise) };
    let wrong = |kind, message: String| Err(refusal(name, kind, message));
    match Quantity::parse(said) {
        Ok(Quantity::Measured { si, unit }) if unit.dimension() == Dimension::ANGLE => Ok(si),
        Ok(quantity) if quantity.si() == 0.0 => Ok(0.0),
        Ok(_) => wrong(ErrorKind::WrongUnit, format!("what is wanted is an angle, such as \"{said} deg\"")),
        Err(error) => wrong(ErrorKind::Syntax, error.to_string()),
    }
}

fn view(arguments: &ArgMatches) -> Result<View, SpecError> {
    let usual = View::default();
    Ok(View {
        width: arguments.get_one::<u32>("width").copied().unwrap_or(usual.width),
        height: arguments.get_one::<u32>("height").copied(),
        turn: angle(arguments, "turn", usual.turn)?,
        tilt: angle(arguments, "tilt", usual.tilt)?,
        roll: angle(arguments, "roll", usual.roll)?,
        ground: match text(arguments, "background") {
            Some("dark") => Ground::Dark,
            Some("transparent") => Ground::Transparent,
            _ => Ground::Light,
        },
        shadow: !arguments.get_flag("no-shadow"),
    })
}

fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let input = input::read_described(arguments)?;
    let refused = |error| input.refused(error);
    let view = view(arguments).map_err(refused)?;
    if text(arguments, "output").is_none() {
        let message = "say where to write the picture, by --output FILE, or --output - for a pipe";
        return Err(input.refused(refusal("output", ErrorKind::Missing, message)));
    }
    let (ply, assembly) = shape(arguments, &input.spec, &wanted(arguments)).map_err(refused)?;
    let no_picture =
        |error: nply_sheet::render::RenderError| input.refused(refusal("width", ErrorKind::Domain, error.to_string()));
    let picture = Picture::of(&[(&assembly, [0.0; 3])], view).map_err(no_picture)?;
    interrupt::prepare(arguments);
    let rows = rows(&picture, arguments.get_flag("quiet"))?;
    let bytes = picture.png(&rows).map_err(no_picture)?;
    let state = ply.state.map_or_else(String::new, |(number, count)| format!(", state {number} of {count}"));
    let title: String = ply.title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let said = format!("{title}{state}: {} by {} pixels\n", picture.width(), picture.height());
    deliver(arguments, &bytes, true, &said)
}

/// Every row, on all cores.
fn rows(picture: &Picture<'_>, quiet: bool) -> Result<Vec<Vec<[u8; 4]>>, Failure> {
    let bar = if quiet { ProgressBar::hidden() } else { ProgressBar::new(u64::from(picture.height())) };
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} rows, {eta} left") {
        bar.set_style(style);
    }
    let mut rows = Vec::new();
    for first in (0..picture.height()).step_by(STRETCH as usize) {
        interrupt::check().inspect_err(|_| bar.finish_and_clear())?;
        let last = (first + STRETCH).min(picture.height());
        rows.par_extend((first..last).into_par_iter().map(|row| picture.row(row)));
        bar.inc(u64::from(last - first));
    }
    bar.finish_and_clear();
    Ok(rows)
}
