//! Figure 13: the square over which the writhe of a helix with itself is summed, before and after the change of variables (A.7).

use nply::DomainError;

use super::canvas::{Anchor, Canvas, Pen};
use super::{Data, Parts};
use crate::plot::Theme;

/// The square's corners (ψ(s), ψ(t)) in units of ψ_L.
const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// (A.7): x = (ψ(s) − ψ(t))/2, y = ψ(s) + ψ(t), in units of ψ_L.
fn changed([s, t]: [f64; 2]) -> [f64; 2] {
    [0.5 * (s - t), s + t]
}

pub(super) fn make() -> Result<Parts, DomainError> {
    let mut data = Data::new(["corner", "psi_s", "psi_t", "x", "y"]);
    for (i, corner) in SQUARE.into_iter().enumerate() {
        let [x, y] = changed(corner);
        data.push([f64::from(i as u32 + 1).into(), corner[0].into(), corner[1].into(), x.into(), y.into()]);
    }
    Ok(Parts::free(
        "The writhe of a helical strand with itself is a sum over all pairs of its points, a square in their azimuths ψ(s) and ψ(t). In \
         half their difference x and their sum y the square stands on a corner, with the same area. What is summed depends on x alone, so \
         that it is easiest over the rectangle around, less its four corners; for a long ply the corners do not count. Where a point meets \
         itself, x = 0 (dotted), the integrand stays finite.",
        data,
        draw,
    ))
}

fn draw(theme: Theme) -> String {
    let mut canvas = Canvas::new(760.0, 400.0, theme);
    let (ink, grey) = (canvas.ink(), canvas.grey());
    let (blue, orange) = (canvas.line_colour(0), canvas.line_colour(1));
    let axis = Pen::new(ink, 1.3);
    let thin = Pen::new(grey, 1.1);
    // on the left the square itself
    let side = 220.0;
    let place = |[s, t]: [f64; 2]| [70.0 + side * s, 330.0 - side * t];
    canvas.polygon(&SQUARE.map(place), canvas.washed(blue, 0.75), Some(&Pen::new(blue, 1.8)));
    canvas.line(&[place([0.0, 0.0]), place([1.0, 1.0])], &Pen::new(grey, 1.6).dashed("1 5"));
    canvas.arrow(&[place([0.0, 0.0]), place([1.25, 0.0])], &axis);
    canvas.arrow(&[place([0.0, 0.0]), place([0.0, 1.25])], &axis);
    let words = |canvas: &mut Canvas, text: &str, at: [f64; 2], [dx, dy]: [f64; 2], anchor| {
        canvas.words(text, [at[0] + dx, at[1] + dy], 14.0, anchor, ink);
    };
    words(&mut canvas, "ψ(s)", place([1.25, 0.0]), [-2.0, 22.0], Anchor::Middle);
    words(&mut canvas, "ψ(t)", place([0.0, 1.25]), [-10.0, 6.0], Anchor::End);
    words(&mut canvas, "ψ_L", place([1.0, 0.0]), [0.0, 22.0], Anchor::Middle);
    words(&mut canvas, "ψ_L", place([0.0, 1.0]), [-10.0, 5.0], Anchor::End);
    words(&mut canvas, "0", place([0.0, 0.0]), [-10.0, 18.0], Anchor::End);
    canvas.words("s = t", [place([0.5, 0.5])[0] + 10.0, place([0.5, 0.5])[1] + 16.0], 13.0, Anchor::Start, grey);
    // on the right the same over x and y
    let unit = 130.0;
    let place = |[x, y]: [f64; 2]| [560.0 + unit * x * 1.6, 330.0 - unit * y];
    let rectangle = [[-0.5, 0.0], [0.5, 0.0], [0.5, 2.0], [-0.5, 2.0]];
    canvas.polygon(&rectangle.map(place), canvas.washed(orange, 0.86), Some(&thin.clone().dashed("5 4")));
    let diamond = SQUARE.map(changed).map(place);
    canvas.polygon(&diamond, canvas.washed(blue, 0.75), Some(&Pen::new(blue, 1.8)));
    canvas.line(&[place([0.0, 0.0]), place([0.0, 2.0])], &Pen::new(grey, 1.6).dashed("1 5"));
    canvas.arrow(&[place([-0.72, 0.0]), place([0.78, 0.0])], &axis);
    canvas.arrow(&[place([0.0, 2.0]), place([0.0, 2.3])], &axis);
    words(&mut canvas, "x", place([0.78, 0.0]), [-2.0, 22.0], Anchor::Middle);
    words(&mut canvas, "y", place([0.0, 2.3]), [-10.0, 8.0], Anchor::End);
    words(&mut canvas, "−ψ_L/2", place([-0.5, 0.0]), [0.0, 22.0], Anchor::Middle);
    words(&mut canvas, "ψ_L/2", place([0.5, 0.0]), [0.0, 22.0], Anchor::Middle);
    words(&mut canvas, "ψ_L", place([0.5, 1.0]), [10.0, 5.0], Anchor::Start);
    words(&mut canvas, "2ψ_L", place([0.5, 2.0]), [10.0, 5.0], Anchor::Start);
    for minus in [[-0.38, 0.16], [0.38, 0.16], [0.38, 1.84], [-0.38, 1.84]] {
        let [x, y] = place(minus);
        canvas.words("−", [x, y + 6.0], 20.0, Anchor::Middle, orange);
    }
    canvas.arrow(&[[345.0, 200.0], [415.0, 200.0]], &Pen::new(grey, 2.0));
    canvas.words("(A.7)", [380.0, 188.0], 13.0, Anchor::Middle, grey);
    canvas.svg("The domain of integration, a square, and the same square standing on its corner in a rectangle")
}
