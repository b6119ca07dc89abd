//! Our side of `cargo xtask race`: a job, timed piece by piece, and what came out of it.
//!
//! ```text
//! cargo run --release -p nply --example race -- contacts
//! ```
//!
//! Prints `best median check`: nanoseconds an item of the fastest piece and of the middle one, and a number that the scripts of
//! authorities/peers/ must come to as well. A piece is a few milliseconds long, so that the fastest has the processor to itself.
#![allow(clippy::disallowed_methods, reason = "inputs, not results")]

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;
use std::io::Write as _;
use std::process::ExitCode;
use std::time::Instant;

use nply::geometry::{Contact, contact_batch};
use nply::mechanics::{Balance, Load, Plies, Ply, States, Twist, Twists};
use nply::topology::Curve;

type Answer = Result<(Vec<f64>, f64), Box<dyn Error>>;

/// The fractional part of (i + 1)·step: numbers spread evenly, the same in every language.
fn spread(i: usize, step: f64) -> f64 {
    ((i + 1) as f64 * step).fract()
}

const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Of √2, √3, √5, √7.
const STEPS: [f64; 4] =
    [0.414_213_562_373_095_15, 0.732_050_807_568_877_2, 0.236_067_977_499_790_25, 0.645_751_311_064_590_6];

fn strands(i: usize) -> u32 {
    2 + (i % 11) as u32
}

fn angle(i: usize) -> f64 {
    1e-3 + (FRAC_PI_2 - 2e-3) * spread(i, GOLDEN)
}

/// Seconds an item of each of many pieces of work.
fn pieces(items: usize, mut work: impl FnMut()) -> Vec<f64> {
    const PIECES: usize = 300;
    work(); // once to warm up
    let timed = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64() / items as f64
    };
    (0..PIECES).map(timed).collect()
}

/// x and ρ of arrays.
fn contacts() -> Answer {
    const ROWS: usize = 100_000;
    let n: Vec<u32> = (0..ROWS).map(strands).collect();
    let theta: Vec<f64> = (0..ROWS).map(angle).collect();
    let (mut shift, mut radius) = (vec![0.0; ROWS], vec![0.0; ROWS]);
    let mut whole = Ok(());
    let times = pieces(ROWS, || {
        whole = contact_batch(black_box(&n), black_box(&theta), &mut shift, &mut radius, |_, _| ());
        black_box((&shift, &radius));
    });
    whole?;
    Ok((times, radius.iter().map(|rho| 1.0 / rho).sum()))
}

/// x and ρ, one call after the other.
fn one_contact() -> Answer {
    const ROWS: usize = 100_000;
    let mut sum = 0.0;
    let times = pieces(ROWS, || {
        sum = (0..ROWS)
            .filter_map(|i| Contact::new(strands(i), angle(i)).ok())
            .map(|contact| black_box((contact.arclength_shift(), 1.0 / contact.radius_ratio())).1)
            .sum();
    });
    Ok((times, sum))
}

/// Columns n, γ, φ̄a, f, m; each second row without loads.
fn plies(rows: usize) -> (Vec<u32>, [Vec<f64>; 4]) {
    let column = |step: f64, low: f64, high: f64| -> Vec<f64> {
        (0..rows).map(|i| low + (high - low) * spread(i, step)).collect()
    };
    let loaded = |mut loads: Vec<f64>| {
        loads.iter_mut().step_by(2).for_each(|load| *load = 0.0);
        loads
    };
    let [a, b, c, d] = STEPS;
    let columns =
        [column(a, 0.6, 1.0), column(b, -2.0, 2.0), loaded(column(c, -1.0, 1.0)), loaded(column(d, -4.0, 4.0))];
    ((0..rows).map(strands).collect(), columns)
}

/// Every state of arrays of plies; the check is how many there are, per ply.
fn states(balance: Balance) -> Answer {
    const ROWS: usize = 20_000;
    let (n, [gamma, twist, force, moment]) = plies(ROWS);
    let twist = Twists::Pretwist(&twist);
    let plies = Plies { strands: &n, stiffness_ratio: &gamma, twist, force: &force, moment: &moment };
    let mut states = States::new();
    let mut whole = Ok(());
    let times = pieces(ROWS, || {
        whole = black_box(&plies).equilibria(balance, &mut states);
        black_box(&states);
    });
    whole?;
    Ok((times, states.len() as f64 / ROWS as f64))
}

/// Every state, one ply after the other.
fn one_ply() -> Answer {
    const ROWS: usize = 5_000;
    let (n, [gamma, twist, force, moment]) = plies(ROWS);
    let mut found = 0;
    let times = pieces(ROWS, || {
        let of = |i: usize| {
            let ply = Ply::with_balance(n[i], gamma[i], Balance::Radial)?;
            ply.equilibria(Twist::Pretwist(twist[i]), Load { force: force[i], moment: moment[i] })
        };
        found = (0..ROWS).filter_map(|i| of(i).ok()).map(|states| states.len()).sum();
    });
    Ok((times, found as f64 / ROWS as f64))
}

/// Writhe of a closed trefoil of ten thousand points; an item is the whole curve.
fn writhe() -> Answer {
    const POINTS: usize = 10_000;
    let point = |i: usize| {
        let t = TAU * i as f64 / POINTS as f64;
        let r = 2.0 + (3.0 * t).cos();
        [r * (2.0 * t).cos(), r * (2.0 * t).sin(), (3.0 * t).sin()]
    };
    let points: Vec<_> = (0..POINTS).map(point).collect();
    let mut value = f64::NAN;
    let times = pieces(1, || {
        let found = Curve::closed(black_box(points.clone())).and_then(|curve| curve.writhe());
        value = found.map_or(f64::NAN, |writhe| writhe.value);
    });
    Ok((times, value))
}

fn main() -> ExitCode {
    let wish = std::env::args().nth(1).unwrap_or_default();
    let answer = match wish.as_str() {
        "contacts" => contacts(),
        "one-contact" => one_contact(),
        "states" => states(Balance::Radial),
        "states-contact" => states(Balance::Contact),
        "one-ply" => one_ply(),
        "writhe" => writhe(),
        _ => Err("wanted is one of contacts, one-contact, states, states-contact, one-ply, writhe".into()),
    };
    match answer {
        Ok((mut times, check)) => {
            times.sort_by(f64::total_cmp);
            let middle = times[times.len() / 2];
            let _ = writeln!(std::io::stdout(), "{:.4} {:.4} {check:.12}", 1e9 * times[0], 1e9 * middle);
            ExitCode::SUCCESS
        }
        Err(error) => {
            let _ = writeln!(std::io::stderr(), "race: {error}");
            ExitCode::from(2)
        }
    }
}
