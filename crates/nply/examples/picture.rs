//! Draws a ply from the side and cut across, as SVG on standard output:
//!
//! ```text
//! cargo run --release -p nply --example picture > docs/three-ply-yarn.svg
//! ```
//!
//! It is the yarn of `examples/three-ply-yarn.toml`, in the state it takes when it is released.
#![allow(clippy::print_stdout)] // a picture on standard output is what this program is for

use std::f64::consts::TAU;
use std::fmt::Write as _;

use nply::geometry::{Centreline, Section};
use nply::mechanics::{Equilibrium, Load, Ply, Twist};

/// Pixels per strand radius.
const ZOOM: f64 = 44.0;
/// Width and height of the picture.
const SIZE: (f64, f64) = (960.0, 300.0);
/// One colour a strand, told apart by the colour-blind too (after Okabe and Ito): edge, body, light.
const COLOURS: [[&str; 3]; 3] =
    [["#00466f", "#0072b2", "#7cc4ee"], ["#8a4300", "#d55e00", "#ffb37a"], ["#00543d", "#009e73", "#7fdcc0"]];

fn main() -> Result<(), nply::DomainError> {
    let pretwist = TAU * 470.0 * 0.1375e-3; // 470 turns per metre in a strand of radius 0.1375 mm
    let states = Ply::new(3, 0.75)?.equilibria(Twist::Pretwist(pretwist), Load::NONE)?;
    let released = states.into_iter().find(|state| !state.is_separated());
    print!("{}", released.map_or_else(String::new, |state| picture(&state)));
    Ok(())
}

fn picture(state: &Equilibrium) -> String {
    let (width, height) = SIZE;
    let middle = 0.5 * height;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
         aria-label=\"A three-ply yarn from the side, and the cut across it\">\n\
         <rect width=\"{width}\" height=\"{height}\" rx=\"12\" fill=\"#fbfaf7\"/>\n\
         <clipPath id=\"side\"><rect x=\"24\" y=\"0\" width=\"590\" height=\"{height}\"/></clipPath>\n\
         <g clip-path=\"url(#side)\" fill=\"none\" stroke-linejoin=\"round\">\n"
    );
    side(&mut svg, state, middle);
    svg.push_str("</g>\n");
    cut(&mut svg, state, (792.0, middle));
    let angle = state.contact().angle().degrees();
    let _ = writeln!(
        svg,
        "<g font-family=\"sans-serif\" font-size=\"15\" fill=\"#444\">\n\
         <text x=\"24\" y=\"{0}\">helical angle {angle:.2}°, {1}-handed</text>\n\
         <text x=\"792\" y=\"{0}\" text-anchor=\"middle\">cut across the axis</text>\n</g>\n</svg>",
        height - 16.0,
        if state.handedness().sign() > 0.0 { "right" } else { "left" },
    );
    svg
}

/// The strands from the side: short runs of each, the far ones first, each drawn as edge, body and light.
fn side(svg: &mut String, state: &Equilibrium, middle: f64) {
    const STEPS: i32 = 8; // per run, and two more on either side so that no seam shows
    let contact = state.contact();
    let turn = contact.lay_length() / contact.angle().cos(); // strand length of one turn
    let run = turn / 24.0;
    let mut runs: Vec<(f64, u32, Vec<[f64; 2]>)> = Vec::new();
    for strand in 0..contact.strands() {
        let line = Centreline::new(contact, state.handedness(), strand);
        for i in -4..48 {
            let from = f64::from(i) * run;
            let points: Vec<[f64; 3]> =
                (-2..=STEPS + 2).map(|k| line.position(from + run * f64::from(k) / f64::from(STEPS))).collect();
            let depth = points.iter().map(|p| p[1]).sum::<f64>() / points.len() as f64;
            runs.push((depth, strand, points.iter().map(|p| [p[2] * ZOOM, middle - p[0] * ZOOM]).collect()));
        }
    }
    // right, up and towards the eye are z, x and y, in this order right-handed as the paper's frame is
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, strand, points) in runs {
        let [edge, body, light] = COLOURS[strand as usize % 3];
        // the dark edge ends where the run ends, so that it does not cross its neighbour
        for (colour, share, short) in [(edge, 2.0, 2), (body, 1.78, 1), (light, 0.34, 0)] {
            let lift = 0.28 * (2.0 - share) * ZOOM * 0.5; // the light comes from above
            let path: Vec<String> =
                points[short..points.len() - short].iter().map(|p| format!("{:.1},{:.1}", p[0], p[1] - lift)).collect();
            let _ = writeln!(
                svg,
                "<polyline points=\"{}\" stroke=\"{colour}\" stroke-width=\"{:.1}\"/>",
                path.join(" "),
                share * ZOOM,
            );
        }
    }
}

/// The true outlines where a plane across the axis meets the strands, and the hole between them.
fn cut(svg: &mut String, state: &Equilibrium, centre: (f64, f64)) {
    let contact = state.contact();
    let section = Section::new(contact, state.handedness());
    let outer = contact.outer_radius() * ZOOM;
    let hole = contact.hole_radius() * ZOOM;
    let _ = writeln!(
        svg,
        "<circle cx=\"{0}\" cy=\"{1}\" r=\"{outer:.1}\" fill=\"none\" stroke=\"#bbb\" stroke-dasharray=\"4 4\"/>",
        centre.0, centre.1
    );
    for strand in 0..contact.strands() {
        let [edge, body, _] = COLOURS[strand as usize % 3];
        let path: Vec<String> = (0..96)
            .map(|k| section.outline(strand, 0.0, TAU * f64::from(k) / 96.0))
            .map(|[x, y]| format!("{:.1},{:.1}", centre.0 + x * ZOOM, centre.1 - y * ZOOM))
            .collect();
        let _ = writeln!(
            svg,
            "<polygon points=\"{}\" fill=\"{body}\" stroke=\"{edge}\" stroke-width=\"1.5\"/>",
            path.join(" ")
        );
    }
    let _ = writeln!(
        svg,
        "<circle cx=\"{0}\" cy=\"{1}\" r=\"{hole:.1}\" fill=\"none\" stroke=\"#444\" stroke-dasharray=\"2 2\"/>",
        centre.0, centre.1
    );
}
