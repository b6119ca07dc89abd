//! Figure 5: what a plane across the axis meets.

use core::f64::consts::TAU;

use nply::geometry::{Contact, Section};
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas, Pen};
use super::{Data, Parts, rad};
use crate::plot::Theme;

const DEGREES: [f64; 3] = [20.0, 60.0, 80.0];
/// Points of an outline.
const POINTS: u32 = 180;
/// A panel's side, pixels.
const SIDE: f64 = 250.0;

/// A cut at one angle.
struct Cut {
    degrees: f64,
    outlines: Vec<Vec<[f64; 2]>>,
    outer: f64,
    hole: f64,
    convex: bool,
}

pub(super) fn make() -> Result<Parts, DomainError> {
    let mut data = Data::new(["helical_angle_deg", "strand", "alpha", "x", "y"]);
    let mut cuts = Vec::new();
    for degrees in DEGREES {
        let contact = Contact::new(3, rad(degrees))?;
        let section = Section::new(&contact, Handedness::Right);
        let mut outlines = Vec::new();
        for strand in 0..3 {
            let alphas = (0..POINTS).map(|k| TAU * f64::from(k) / f64::from(POINTS));
            let outline: Vec<[f64; 2]> = alphas
                .map(|alpha| {
                    let [x, y] = section.outline(strand, 0.0, alpha);
                    data.push([degrees.into(), f64::from(strand + 1).into(), alpha.into(), x.into(), y.into()]);
                    [x, y]
                })
                .collect();
            outlines.push(outline);
        }
        let (outer, hole) = (contact.outer_radius(), contact.hole_radius());
        cuts.push(Cut { degrees, outlines, outer, hole, convex: section.is_convex() });
    }
    let hollow = Section::non_convex_angle(3)?.degrees();
    let caption = format!(
        "A plane across the axis of three right-handed strands at 20°, 60° and 80°, each drawn to its own scale. Steep strands are cut in \
         ovals; above {hollow:.1}° the cut turns hollow towards the axis, and nearly flat ones are cut lengthwise. Neighbours meet \
         where the helix they touch along goes through the plane. Dashed: the cylinder around the ply; dotted: the hole along its axis."
    );
    Ok(Parts::free(caption, data, move |theme| draw(&cuts, theme)))
}

fn draw(cuts: &[Cut], theme: Theme) -> String {
    let mut canvas = Canvas::new(SIDE * cuts.len() as f64 + 20.0, SIDE + 70.0, theme);
    for (i, cut) in cuts.iter().enumerate() {
        let centre = [10.0 + SIDE * (i as f64 + 0.5), 10.0 + 0.5 * SIDE];
        let zoom = 0.46 * SIDE / cut.outer;
        canvas.circle(centre, zoom * cut.outer, &Pen::new(canvas.grey(), 1.0).dashed("5 4"));
        for (strand, outline) in cut.outlines.iter().enumerate() {
            let colour = canvas.line_colour([0, 1, 2][strand % 3]);
            let points: Vec<[f64; 2]> =
                outline.iter().map(|[x, y]| [centre[0] + zoom * x, centre[1] - zoom * y]).collect();
            canvas.polygon(&points, canvas.washed(colour, 0.35), Some(&Pen::new(colour, 1.6)));
        }
        canvas.circle(centre, zoom * cut.hole, &Pen::new(canvas.grey(), 1.0).dashed("1 4"));
        let ink = canvas.ink();
        let letter = ["a", "b", "c"][i % 3];
        let words = format!("({letter}) θ = {}°", cut.degrees);
        canvas.words(&words, [centre[0], SIDE + 36.0], 15.0, Anchor::Middle, ink);
        let words = if cut.convex { "convex" } else { "hollow" };
        canvas.words(words, [centre[0], SIDE + 56.0], 13.0, Anchor::Middle, canvas.grey());
    }
    canvas.svg("Cuts across a ply of three strands at 20, 60 and 80 degrees")
}
