//! The command `nply`: argv, files, terminal and exit codes; everything else is in `nply-sheet` and `nply`.

mod arguments;
mod curves;
mod failure;
mod input;
mod interrupt;
mod output;
mod part;
#[cfg(feature = "explore")]
mod server;
mod verb;

use std::process::ExitCode;

use failure::Failure;

fn main() -> ExitCode {
    let matches = match verb::command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return Failure::usage(&error),
    };
    match verb::run(&matches) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
