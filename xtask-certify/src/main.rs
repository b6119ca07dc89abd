//! `cargo xtask certify [PLIES] [SEED]`: ends with 1 if the solver missed a root or told one too many.

use std::process::ExitCode;
use std::time::Instant;

use xtask_certify::run::Run;

/// Plies between two lines of progress.
const STEP: usize = 100_000;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number =
        |at: usize, default: u64| arguments.get(at).map_or(Some(default), |text| text.replace('_', "").parse().ok());
    let (Some(plies), Some(seed), true) = (number(0, 100_000), number(1, 2002), arguments.len() <= 2) else {
        eprintln!("usage: cargo xtask certify [plies, default 100000] [seed, default 2002]");
        return ExitCode::from(2);
    };
    let start = Instant::now();
    let mut run = Run::new(seed);
    let mut left = plies as usize;
    while left > 0 {
        let count = left.min(STEP);
        run.go_on(count);
        left -= count;
        if left > 0 {
            let report = &run.report;
            eprintln!(
                "{} plies, {} roots, missed {}, extra {}, misplaced {}, {:.0} s",
                report.plies,
                report.roots,
                report.alone.missed + report.arrays.missed,
                report.alone.extra + report.arrays.extra,
                report.alone.misplaced + report.arrays.misplaced,
                start.elapsed().as_secs_f64()
            );
        }
    }
    for open in &run.report.left_open {
        println!("open  {open}");
    }
    for complaint in run.report.made_up.iter().chain(&run.report.complaints) {
        println!("WRONG {complaint}");
    }
    println!("seed                 {seed}\n{}", run.report);
    println!("in all               {:.1} s", start.elapsed().as_secs_f64());
    if run.report.holds() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
