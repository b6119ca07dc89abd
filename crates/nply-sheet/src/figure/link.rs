//! Figure 12: pretwisted strands before and after they are let go, with the closure.

use nply::geometry::{Centreline, Contact, Vector};
use nply::mechanics::{Equilibrium, Load, Ply, Twist};
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas};
use super::shaded::COLOURS;
use super::tube::{Station, Tube, View};
use super::{Data, Parts};
use crate::plot::Theme;

const PRETWIST: f64 = -1.0;
const GAMMA: f64 = 0.75;
/// L/r.
const LENGTH: f64 = 30.0;
/// Between stations, in strand radii.
const STEP: f64 = 0.06;

pub(super) fn make() -> Result<Parts, DomainError> {
    let states = Ply::new(3, GAMMA)?.equilibria(Twist::Pretwist(PRETWIST), Load::NONE)?;
    let released = states.into_iter().find(|state| !state.is_separated());
    let Some(state) = released else {
        let allowed = "one that presses strands together when they are let go";
        return Err(DomainError { quantity: "pretwist", value: PRETWIST, allowed });
    };
    let link = state.link();
    let turns = state.rotation() * LENGTH / core::f64::consts::TAU;
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
    Ok(Parts::free(caption, data, move |theme| draw(&state, theme)))
}

/// The strands of a contact, a stripe painted on each, with the closure beside them.
fn tubes(contact: &Contact, turns: f64) -> Vec<Tube> {
    let cos = contact.angle().cos();
    let half = 0.5 * LENGTH;
    let stations = |line: &dyn Fn(f64) -> Station| {
        // and what reaches into the picture from beyond its ends
        let (length, half) = (LENGTH + 8.0, half + 4.0);
        let count = libm::ceil(length / STEP);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundreds")]
        let places = (0..=count as u32).map(|k| length * f64::from(k) / count - half);
        places.map(line).collect::<Vec<Station>>()
    };
    let mut tubes: Vec<Tube> = (0..3)
        .map(|strand| {
            let line = Centreline::new(contact, Handedness::Right, strand);
            let station = |s: f64| {
                let frame = line.frame(s);
                let (sin, cos) = libm::sincos(PRETWIST * s);
                // against normal and binormal a stripe turns by the pretwist alone, (44)
                let stripe = [0, 1, 2].map(|i| cos * frame.normal[i] + sin * frame.binormal[i]);
                Station { place: line.position(s), tangent: frame.tangent, stripe: Some(stripe) }
            };
            Tube { stations: stations(&station), radius: 1.0, colour: COLOURS[strand as usize % 3] }
        })
        .collect();
    let closure = |s: f64| {
        let (sin, cos_turn) = libm::sincos(-core::f64::consts::TAU * turns * s / LENGTH);
        let place: Vector = [3.9, 0.0, s * cos];
        Station { place, tangent: [0.0, 0.0, 1.0], stripe: Some([-sin, cos_turn, 0.0]) }
    };
    tubes.push(Tube { stations: stations(&closure), radius: 0.6, colour: [0x9a, 0x9a, 0x9a] });
    tubes
}

fn draw(state: &Equilibrium, theme: Theme) -> String {
    let mut canvas = Canvas::new(780.0, 400.0, theme);
    let half = 0.5 * LENGTH;
    let turns = state.rotation() * LENGTH / core::f64::consts::TAU;
    let straight = Contact::new(3, 0.0);
    let rows = [(straight.ok(), 0.0, "a"), (Some(*state.contact()), turns, "b")];
    for (i, (contact, turns, letter)) in rows.into_iter().enumerate() {
        let Some(contact) = contact else { continue };
        let top = 8.0 + 195.0 * i as f64;
        let half = half * contact.angle().cos();
        let view = View {
            right: [0.0, 0.0, 1.0],
            up: [-1.0, 0.0, 0.0],
            eye: [0.0, -1.0, 0.0],
            centre: [0.9, 0.0, 0.0],
            size: (700, 185),
            zoom: 22.0,
            cut: (-half, half),
        };
        canvas.image(&view.png(&tubes(&contact, turns)), [60.0, top, 700.0, 185.0]);
        let ink = canvas.ink();
        canvas.words(&format!("({letter})"), [26.0, top + 80.0], 17.0, Anchor::Middle, ink);
    }
    canvas.svg("Three twisted strands held straight, and coiled after they were let go, with their closure")
}
