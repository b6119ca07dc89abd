//! Figures 2 and 4: plies as they are seen from the side and from their end.

use nply::geometry::{Centreline, Contact, Vector};
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas};
use super::tube::{Station, Tube, View};
use super::{Data, Parts, rad};
use crate::plot::Theme;

/// Between stations, in strand radii.
const STEP: f64 = 0.06;
/// Okabe and Ito's blue, vermilion and green.
pub(super) const COLOURS: [[u8; 3]; 3] = [[0x2f, 0x8f, 0xd0], [0xe0, 0x6d, 0x1a], [0x1a, 0xa8, 0x80]];

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
    let length = 1.6 * contact.lay_length() / contact.angle().cos();
    for strand in 0..strands {
        let line = Centreline::new(&contact, Handedness::Right, strand);
        for k in 0..=100 {
            let s = length * f64::from(k) / 100.0;
            let [x, y, z] = line.position(s);
            data.push([f64::from(strand + 1).into(), s.into(), x.into(), y.into(), z.into()]);
        }
    }
    Ok(Parts::free(caption, data, move |theme| draw(&contact, theme)))
}

/// The tubes of a ply from one height to another.
pub(super) fn tubes(contact: &Contact, from: f64, to: f64) -> Vec<Tube> {
    let cos = contact.angle().cos();
    // what reaches into the picture from beyond its ends
    let over = 2.0;
    (0..contact.strands())
        .map(|strand| {
            let line = Centreline::new(contact, Handedness::Right, strand);
            let (first, last) = ((from - over) / cos, (to + over) / cos);
            let count = libm::ceil((last - first) / STEP);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousands")]
            let stations = (0..=count as u32)
                .map(|k| first + (last - first) * f64::from(k) / count)
                .map(|s| Station { place: line.position(s), tangent: line.frame(s).tangent, stripe: None })
                .collect();
            Tube { stations, radius: 1.0, colour: COLOURS[strand as usize % COLOURS.len()] }
        })
        .collect()
}

fn draw(contact: &Contact, theme: Theme) -> String {
    let half = 0.8 * contact.lay_length();
    let tubes = tubes(contact, -half, half);
    let side = View {
        right: [0.0, 0.0, 1.0],
        up: [1.0, 0.0, 0.0],
        eye: [0.0, 1.0, 0.0],
        centre: [0.0; 3],
        size: (400, 230),
        zoom: 190.0 / (2.0 * half).max(2.0 * contact.outer_radius()),
        cut: (-half, half),
    };
    let zoom = (370.0 / (2.0 * half)).min(210.0 / (2.0 * contact.outer_radius()));
    let side = View { zoom, ..side };
    // the same, its end turned towards the eye
    let (sin, cos) = libm::sincos(rad(52.0));
    let (tip, tilt) = libm::sincos(rad(16.0));
    let eye: Vector = [tip, tilt * cos, tilt * sin];
    let right: Vector = [0.0, -sin, cos];
    let up = [
        eye[1] * right[2] - eye[2] * right[1],
        eye[2] * right[0] - eye[0] * right[2],
        eye[0] * right[1] - eye[1] * right[0],
    ];
    let end = View { right, up, eye, centre: [0.0; 3], size: (320, 270), zoom: 0.8 * zoom, cut: side.cut };
    let mut canvas = Canvas::new(780.0, 310.0, theme);
    for (view, left) in [(&side, 15.0), (&end, 440.0)] {
        let (width, height) = (f64::from(view.size.0), f64::from(view.size.1));
        canvas.image(&view.png(&tubes), [left, 140.0 - 0.5 * height, width, height]);
    }
    let ink = canvas.ink();
    canvas.words("(a) from the side", [215.0, 296.0], 15.0, Anchor::Middle, ink);
    canvas.words("(b) from one end", [600.0, 296.0], 15.0, Anchor::Middle, ink);
    canvas.svg("A ply at 60 degrees from the side and from its end")
}
