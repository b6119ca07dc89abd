//! Draws three plies, one above the other, as a PNG on standard output:
//!
//! ```text
//! cargo run --release -p nply-sheet --example plies > docs/plies.png
//! ```
//!
//! A two-ply, a three-ply and a strand of six wires on a core, as they lie when they touch.
#![allow(clippy::print_stderr, reason = "a message on standard error is all that is left where there is no picture")]

use std::io::Write as _;
use std::process::ExitCode;

use nply_sheet::mesh::{Assembly, Subject, Wanted};
use nply_sheet::render::{Picture, View};
use nply_sheet::{Spec, SpecError};

/// Strands, helical angle, hand, core, stripes.
const PLIES: [(&str, &str, &str, Option<&str>, u32); 3] =
    [("2", "33 deg", "Z", None, 0), ("3", "26 deg", "S", None, 3), ("6", "24 deg", "Z", Some(""), 0)];

fn assembly(
    (strands, angle, hand, core, stripes): (&str, &str, &str, Option<&str>, u32),
) -> Result<Assembly, SpecError> {
    let ply = Subject::of(&Spec::from_flags([("strands", strands), ("helical-angle", angle), ("hand", hand)])?, None)?;
    Assembly::of(&ply, &Wanted { length: Some("25"), core, stripes, ..Wanted::default() })
}

fn picture() -> Result<Vec<u8>, Box<dyn std::error::Error>> {
    let plies = PLIES.map(assembly).into_iter().collect::<Result<Vec<_>, _>>()?;
    let heights = [6.3, 1.0, -5.6];
    let placed: Vec<_> = plies.iter().zip(heights).map(|(ply, up)| (ply, [0.0, up, 0.0])).collect();
    let view = View { width: 660, tilt: 0.48, roll: -0.12, turn: 0.3, ..View::default() };
    let picture = Picture::of(&placed, view)?;
    let count = std::thread::available_parallelism()?.get() as u32;
    // every thread takes each so-manieth row
    let mut rows = vec![Vec::new(); picture.height() as usize];
    std::thread::scope(|scope| {
        let picture = &picture;
        let shares: Vec<_> = (0..count)
            .map(|first| {
                scope.spawn(move || {
                    let own = (first..picture.height()).step_by(count as usize);
                    own.map(|row| (row as usize, picture.row(row))).collect::<Vec<_>>()
                })
            })
            .collect();
        for (row, pixels) in shares.into_iter().filter_map(|share| share.join().ok()).flatten() {
            rows[row] = pixels;
        }
    });
    Ok(picture.png(&rows)?)
}

fn main() -> ExitCode {
    match picture().and_then(|bytes| Ok(std::io::stdout().write_all(&bytes)?)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
