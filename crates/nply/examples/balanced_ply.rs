//! A yarn that is let go: the angles at which three twisted strands are in balance, what presses between them, and which loads make them part.

use std::error::Error;
use std::io::{Write as _, stdout};

use nply::mechanics::{Change, Load, Ply, Twist};

fn main() -> Result<(), Box<dyn Error>> {
    let mut out = stdout().lock();
    // three strands, C/B = 3/4, each twisted to the left by half a radian per length of its radius
    let ply = Ply::new(3, 0.75)?;
    for state in ply.equilibria(Twist::Pretwist(-0.5), Load::NONE)? {
        let (hand, angle) = (state.handedness().lay_letter(), state.contact().angle().degrees());
        let pressure = state.interstrand_pressure();
        writeln!(out, "{hand}, {angle:.4} degrees to the axis: neighbours press with {pressure:.5} B/r³")?;
        if state.is_separated() {
            writeln!(out, "  they would have to pull on each other: without glue this is no ply")?;
            continue;
        }
        for change in [Change::Force, Change::Moment] {
            let Some(margin) = state.margin(change)? else { continue };
            for limit in [margin.below, margin.above].into_iter().flatten() {
                writeln!(out, "  {} changed by {:+.5}: {}", change.name(), limit.change, limit.cause.name())?;
            }
        }
    }
    Ok(())
}
