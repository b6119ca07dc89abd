//! Figures 14 and 15: how strands, end sections and closure make one closed line.

use core::f64::consts::{PI, TAU};

use nply::DomainError;

use super::canvas::{Anchor, Canvas, Pen};
use super::{Data, Parts};
use crate::plot::Theme;

/// The ply's ends and its axis, pixels.
const LEFT: f64 = 150.0;
const RIGHT: f64 = 650.0;
const AXIS: f64 = 120.0;
/// The helices' radius.
const RADIUS: f64 = 52.0;
/// Steps along a strand.
const STEPS: u32 = 240;

/// One strand: its name, its phase, which way it is run through.
struct Strand {
    name: &'static str,
    phase: f64,
    forward: bool,
}

pub(super) fn two() -> Result<Parts, DomainError> {
    let mut data = Data::new(["piece", "kind", "runs"]);
    for (piece, kind, runs) in [
        ("H1", "helix", "forward"),
        ("E12", "end section", "right end"),
        ("H2", "helix", "backward"),
        ("E21", "end section", "left end"),
    ] {
        data.push([piece.into(), kind.into(), runs.into()]);
    }
    Ok(Parts::free(
        "Two strands and two end sections are one closed line: along the first strand, round the end, back along the second, round the \
         other end. Strands that are run through in opposite directions add negative writhe.",
        data,
        draw_two,
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    let mut data = Data::new(["piece", "kind", "runs"]);
    for (piece, kind, runs) in [
        ("H1", "helix", "forward"),
        ("E12", "end section", "right end"),
        ("H2", "helix", "backward"),
        ("E23", "end section", "left end"),
        ("H3", "helix", "forward"),
        ("E3C", "end section", "right end"),
        ("C", "closure", "backward"),
        ("EC1", "end section", "left end"),
    ] {
        data.push([piece.into(), kind.into(), runs.into()]);
    }
    Ok(Parts::free(
        "With an odd number of strands the line comes out at the far end, and a closure leads it back. It stays in a plane and has no \
         stiffness: it only counts by how much the ply's end has turned.",
        data,
        draw_three,
    ))
}

fn draw_two(theme: Theme) -> String {
    let mut canvas = Canvas::new(800.0, 240.0, theme);
    let strands =
        [Strand { name: "H₁⁺", phase: 0.0, forward: true }, Strand { name: "H₂⁻", phase: PI, forward: false }];
    let [upper, lower] = [AXIS - RADIUS, AXIS + RADIUS];
    arc(&mut canvas, RIGHT, upper, lower, 1.0, true);
    arc(&mut canvas, LEFT, lower, upper, -1.0, true);
    helices(&mut canvas, &strands);
    let ink = canvas.ink();
    canvas.words("E_{12}", [RIGHT + RADIUS + 14.0, AXIS + 5.0], 16.0, Anchor::Start, ink);
    canvas.words("E_{21}", [LEFT - RADIUS - 14.0, AXIS + 5.0], 16.0, Anchor::End, ink);
    canvas.svg("Two helices run through in opposite directions and two end sections")
}

fn draw_three(theme: Theme) -> String {
    let mut canvas = Canvas::new(800.0, 300.0, theme);
    let strands = [
        Strand { name: "H₁⁺", phase: PI / 6.0, forward: true },
        Strand { name: "H₂⁻", phase: -PI / 2.0, forward: false },
        Strand { name: "H₃⁺", phase: 5.0 * PI / 6.0, forward: true },
    ];
    let [top, middle, bottom] = [30.0, 90.0, 150.0].map(|degrees: f64| AXIS - RADIUS * libm::cos(degrees.to_radians()));
    let under = AXIS + 2.4 * RADIUS;
    arc(&mut canvas, RIGHT, top, middle, 1.0, true);
    arc(&mut canvas, LEFT, middle, bottom, -1.0, true);
    arc(&mut canvas, RIGHT, bottom, under, 1.0, false);
    arc(&mut canvas, LEFT, under, top, -1.0, false);
    let ink = canvas.ink();
    let pen = Pen::new(canvas.grey(), 3.0);
    canvas.arrow(&[[RIGHT, under], [0.5 * (LEFT + RIGHT), under]], &pen);
    canvas.line(&[[0.5 * (LEFT + RIGHT), under], [LEFT, under]], &pen);
    helices(&mut canvas, &strands);
    canvas.words("E_{12}", [RIGHT + 0.43 * RADIUS + 14.0, 0.5 * (top + middle) + 5.0], 16.0, Anchor::Start, ink);
    canvas.words("E_{23}", [LEFT - 0.43 * RADIUS - 14.0, 0.5 * (middle + bottom) + 3.0], 16.0, Anchor::End, ink);
    canvas.words("E_{3C}", [RIGHT + 0.8 * RADIUS + 14.0, 0.5 * (bottom + under) + 5.0], 16.0, Anchor::Start, ink);
    canvas.words("C", [0.5 * (LEFT + RIGHT), under + 24.0], 16.0, Anchor::Middle, ink);
    canvas.words("E_{C1}", [LEFT - 1.55 * RADIUS - 12.0, 0.5 * (top + under) + 5.0], 16.0, Anchor::End, ink);
    canvas.svg("Three helices, end sections, and a closure that leads from the third back to the first")
}

/// Half an ellipse from one height to another at an end, bulging right (1) or left (−1); tight ones are half circles.
fn arc(canvas: &mut Canvas, x: f64, from: f64, to: f64, side: f64, round: bool) {
    let (middle, half) = (0.5 * (from + to), 0.5 * (from - to));
    let bulge = half.abs() * if round { 1.0 } else { 0.9 };
    let points: Vec<[f64; 2]> = (0..=48)
        .map(|k| PI * f64::from(k) / 48.0)
        .map(|t| [x + side * bulge * libm::sin(t), middle + half * libm::cos(t)])
        .collect();
    let pen = Pen::new(canvas.grey(), 3.0);
    canvas.line(&points, &pen);
    let grey = canvas.grey();
    canvas.head(points[24], points[27], 11.0, grey);
}

/// The strands, near ones over far ones.
fn helices(canvas: &mut Canvas, strands: &[Strand]) {
    const TURNS: f64 = 2.0;
    let place = |strand: &Strand, share: f64| {
        let (sin, cos) = libm::sincos(strand.phase + TAU * TURNS * share);
        ([LEFT + (RIGHT - LEFT) * share, AXIS - RADIUS * cos], sin)
    };
    const RUN: u32 = 4;
    let mut runs: Vec<(f64, usize, u32)> = Vec::new();
    for (i, strand) in strands.iter().enumerate() {
        runs.extend((0..STEPS / RUN).map(|k| {
            let (_, depth) = place(strand, f64::from(RUN * k + RUN / 2) / f64::from(STEPS));
            (depth, i, RUN * k)
        }));
    }
    runs.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, i, first) in runs {
        let points = |from: u32, to: u32| -> Vec<[f64; 2]> {
            (from..=to).map(|k| place(&strands[i], f64::from(k) / f64::from(STEPS)).0).collect()
        };
        let (ground, colour) = (canvas.ground(), canvas.line_colour(i));
        // a rim in the ground's colour, not at the strand's own seams, cuts what lies below
        canvas.flat(&points(first, first + RUN), &Pen::new(ground, 11.0));
        let (from, to) = (first.saturating_sub(1), (first + RUN + 1).min(STEPS));
        canvas.line(&points(from, to), &Pen::new(colour, 5.0));
    }
    for (i, strand) in strands.iter().enumerate() {
        let colour = canvas.line_colour(i);
        // a head where the strand is nearest to the eye, its name where it is highest or lowest by the ends
        // (two strands cross just there, and the head stands a little later)
        let later = if strands.len() == 2 { 0.11 } else { 0.0 };
        let nearest = (0.25 + later - strand.phase / TAU).rem_euclid(1.0) / TURNS;
        let step = if strand.forward { 0.012 } else { -0.012 };
        for turn in [nearest, nearest + 1.0 / TURNS] {
            canvas.head(place(strand, turn - step).0, place(strand, turn + 1.6 * step).0, 17.0, colour);
        }
        let crest = (-strand.phase / TAU).rem_euclid(1.0) / TURNS;
        let crest = if crest < 0.1 { crest + 1.0 / TURNS } else { crest };
        let ([x, y], _) = place(strand, crest);
        canvas.words(strand.name, [x, y - 13.0], 16.0, Anchor::Middle, colour);
    }
}
