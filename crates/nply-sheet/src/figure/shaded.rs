//! Figures 2 and 4: plies as they are seen from the side and from their end.

use nply::geometry::{Centreline, Contact, Tube, Vector};
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas};
use super::{Data, Parts, rad};
use crate::mesh::{Assembly, Wire};
use crate::plot::{STRANDS, Theme};
use crate::render::{Ground, Picture, View};

/// Lay lengths shown.
const TURNS: f64 = 1.6;

pub(super) fn two() -> Result<Parts, DomainError> {
    make(
        2,
        "Two right-handed strands at 60°, past the pitchfork: they no longer touch in the axis but on a helix around it, and leave a hole \
         through the middle.",
    )
}

pub(super) fn three() -> Result<Parts, DomainError> {
    make(3, "Three right-handed strands at 60°, which leave a hole at every angle. The cut shows where they begin.")
}

fn make(strands: u32, caption: &str) -> Result<Parts, DomainError> {
    let contact = Contact::new(strands, rad(60.0))?;
    let mut data = Data::new(["strand", "arclength", "x", "y", "z"]);
    let top = TURNS * contact.lay_length();
    let mut wires = Vec::new();
    for strand in 0..strands {
        let line = Centreline::new(&contact, Handedness::Right, strand);
        for k in 0..=100 {
            let s = top / contact.angle().cos() * f64::from(k) / 100.0;
            let [x, y, z] = line.position(s);
            data.push([f64::from(strand + 1).into(), s.into(), x.into(), y.into(), z.into()]);
        }
        wires.push(wire(Tube::new(line, 1.0, 0.0, top)?, STRANDS[strand as usize % STRANDS.len()], 0));
    }
    let ply = Assembly { title: String::new(), wires, lines: Vec::new() };
    Ok(Parts::free(caption, data, move |theme| draw(&ply, theme)))
}

/// A strand to be seen.
pub(super) fn wire(tube: Tube, colour: [u8; 3], stripes: u32) -> Wire {
    Wire { name: String::new(), colour, tube, stripes, values: Vec::new() }
}

/// Bodies as they are seen, so many pixels wide and high; nothing where nothing can be drawn.
pub(super) fn seen(
    bodies: &[(&Assembly, Vector)],
    (width, height): (u32, u32),
    [turn, tilt, roll]: [f64; 3],
) -> Vec<u8> {
    let ground = Ground::Transparent;
    let view = View { width, height: Some(height), turn, tilt, roll, ground, shadow: false };
    let drawn = Picture::of(bodies, view).and_then(|picture| {
        let rows: Vec<_> = (0..picture.height()).map(|row| picture.row(row)).collect();
        picture.png(&rows)
    });
    drawn.unwrap_or_default()
}

fn draw(ply: &Assembly, theme: Theme) -> String {
    let mut canvas = Canvas::new(780.0, 310.0, theme);
    let ink = canvas.ink();
    for (left, size, angles, words) in [
        (10.0, (400, 250), [0.0; 3], "(a) from the side"),
        (430.0, (340, 250), [0.0, rad(52.0), rad(14.0)], "(b) from one end"),
    ] {
        let (width, height) = (f64::from(size.0), f64::from(size.1));
        canvas.image(&seen(&[(ply, [0.0; 3])], size, angles), [left, 10.0, width, height]);
        canvas.words(words, [left + 0.5 * width, 292.0], 15.0, Anchor::Middle, ink);
    }
    canvas.svg("A ply at 60 degrees from the side and from its end")
}
