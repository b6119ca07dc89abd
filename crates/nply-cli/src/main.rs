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

/// A panic ends the program, whatever thread it is in, and is told; but for one that a damaged file causes and that is caught.
fn end_at_a_panic() {
    let tell = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !nply_sheet::table::panic_is_caught() {
            tell(panic);
            std::process::abort();
        }
    }));
}

fn main() -> ExitCode {
    end_at_a_panic();
    let matches = match verb::command().try_get_matches() {
        Ok(matches) => matches,
        Err(error) => return Failure::usage(error),
    };
    match verb::run(&matches) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
