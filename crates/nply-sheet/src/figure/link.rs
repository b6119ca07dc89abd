//! Figure 12: pretwisted strands before and after they are let go, with the closure.

use core::f64::consts::{PI, TAU};

use nply::geometry::{Centreline, Contact, Tube, Vector};
use nply::mechanics::{Load, Ply, Twist};
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas};
use super::shaded::{seen, wire};
use super::{Data, Parts};
use crate::mesh::{Assembly, CORE_COLOUR};
use crate::plot::{STRANDS, Theme};

const PRETWIST: f64 = -1.0;
const GAMMA: f64 = 0.75;
/// L/r.
const LENGTH: f64 = 30.0;
/// The closure's radius, and how far below the ply it lies, in strand radii.
const CLOSURE: (f64, f64) = (0.6, 4.0);
/// Between the ply held straight and the one let go.
const APART: f64 = 9.0;

pub(super) fn make() -> Result<Parts, DomainError> {
    let states = Ply::new(3, GAMMA)?.equilibria(Twist::Pretwist(PRETWIST), Load::NONE)?;
    let released = states.into_iter().find(|state| !state.is_separated());
    let Some(state) = released else {
        let allowed = "one that presses strands together when they are let go";
        return Err(DomainError { quantity: "pretwist", value: PRETWIST, allowed });
    };
    let link = state.link();
    let turns = state.rotation() * LENGTH / TAU;
    let mut data = Data::new(["quantity", "straight", "let_go"]);
    for (name, straight, let_go) in [
        ("helical_angle_deg", 0.0, state.contact().angle().degrees()),
        ("ply_length", LENGTH, LENGTH * state.extension()),
        ("link", link.put_in * LENGTH, link.put_in * LENGTH),
        ("twist", link.put_in * LENGTH, link.twist * LENGTH),
        ("writhe", 0.0, link.writhe * LENGTH + turns),
        ("twist_of_closure", 0.0, -turns),
    ] {
        data.push([name.into(), straight.into(), let_go.into()]);
    }
    let angle = state.contact().angle().degrees();
    let caption = format!(
        "Three strands of 30 radii that were twisted left-handed (φ̄a = −1, γ = 3/4), held straight (a) and let go (b). They coil \
         right-handed at {angle:.2}° and lose some of the stripes' turns. The ply's end turns {turns:.2} times round, and the closure, grey, \
         takes up as much the other way: twist of the strands, twist of the closure and writhe add up to the same link as before. End \
         sections are left out."
    );
    let straight = Contact::new(3, 0.0)?;
    let [before, after] = [(straight, 0.0), (*state.contact(), turns)];
    let bodies = [strands(&before.0)?, closure(&before)?, strands(&after.0)?, closure(&after)?];
    Ok(Parts::free(caption, data, move |theme| draw(&bodies, theme)))
}

/// The strands of a contact, a line of their material painted on each.
fn strands(contact: &Contact) -> Result<Assembly, DomainError> {
    let top = LENGTH * contact.angle().cos();
    let strand = |i: u32| {
        let line = Centreline::new(contact, Handedness::Right, i);
        let tube = Tube::new(line, 1.0, 0.0, top)?.twisted(PRETWIST)?;
        Ok(wire(tube, STRANDS[i as usize % STRANDS.len()], 1))
    };
    let wires = (0..3).map(strand).collect::<Result<Vec<_>, DomainError>>()?;
    Ok(Assembly { title: String::new(), wires, lines: Vec::new() })
}

/// The closure, as long as the ply and turned back by its turns.
fn closure((contact, turns): &(Contact, f64)) -> Result<Assembly, DomainError> {
    let top = LENGTH * contact.angle().cos();
    let tube = Tube::new(Centreline::axis(), CLOSURE.0, 0.0, top)?.twisted(-TAU * turns / top)?;
    Ok(Assembly { title: String::new(), wires: vec![wire(tube, CORE_COLOUR, 1)], lines: Vec::new() })
}

fn draw(bodies: &[Assembly; 4], theme: Theme) -> String {
    let [straight, beside, coiled, below] = bodies;
    let at = |up: f64| -> Vector { [0.0, up, 0.0] };
    let (upper, lower) = (0.5 * APART, -0.5 * APART);
    let placed =
        [(straight, at(upper)), (beside, at(upper - CLOSURE.1)), (coiled, at(lower)), (below, at(lower - CLOSURE.1))];
    let mut canvas = Canvas::new(780.0, 400.0, theme);
    // with a strand in front of the two others
    canvas.image(&seen(&placed, (700, 380), [PI, 0.0, 0.0]), [60.0, 10.0, 700.0, 380.0]);
    let ink = canvas.ink();
    for (letter, up) in [("(a)", 105.0), ("(b)", 295.0)] {
        canvas.words(letter, [30.0, up], 17.0, Anchor::Middle, ink);
    }
    canvas.svg("Three twisted strands held straight, and coiled after they were let go, with their closure")
}
