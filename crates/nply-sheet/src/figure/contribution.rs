//! Tables I and II: what each pair of strands adds to the writhe of a long ply.

use nply::DomainError;

use super::canvas::{Anchor, Canvas, Pen};
use super::{Data, Parts};
use crate::plot::Theme;

/// One entry, times ψ_L: a number, and another times cos θ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Entry {
    constant: i32,
    cosine: i32,
}

impl Entry {
    /// Strands `i` and `j` (from 0), which are run through forwards if even: (A.15), (A.23) and (A.24), per turn of a long ply.
    const fn of(i: u32, j: u32) -> Self {
        if i == j {
            Self { constant: 1, cosine: -1 }
        } else if i % 2 == j % 2 {
            Self { constant: 1, cosine: 0 }
        } else {
            Self { constant: -1, cosine: 0 }
        }
    }

    fn text(self) -> String {
        match (self.constant, self.cosine) {
            (1, 0) => "ψ_L".to_owned(),
            (-1, 0) => "−ψ_L".to_owned(),
            _ => "ψ_L (1 − cos θ)".to_owned(),
        }
    }
}

pub(super) fn two() -> Result<Parts, DomainError> {
    Ok(make(
        2,
        "Writhe of a long ply of two strands, times 2π, strand by strand; ψ_L is the angle a strand winds through. The strands are run \
         through in opposite directions, and so their own writhe of 1 − cos θ a turn is outweighed by what they add to each other: in all \
         −2 cos θ a turn.",
    ))
}

pub(super) fn three() -> Result<Parts, DomainError> {
    Ok(make(
        3,
        "The same of three strands. The first and the third run the same way and add to each other, either takes from the second: in all \
         1 − 3 cos θ a turn, the 1 being what a closure is wound round.",
    ))
}

fn make(strands: u32, caption: &str) -> Parts {
    let mut data = Data::new(["row", "column", "constant", "cosine"]);
    for (i, j) in (0..strands).flat_map(|i| (0..strands).map(move |j| (i, j))) {
        let Entry { constant, cosine } = Entry::of(i, j);
        data.push([name(i).into(), name(j).into(), f64::from(constant).into(), f64::from(cosine).into()]);
    }
    Parts::free(caption, data, move |theme| draw(strands, theme))
}

const fn name(strand: u32) -> &'static str {
    match strand {
        0 => "H₁⁺",
        1 => "H₂⁻",
        _ => "H₃⁺",
    }
}

fn draw(strands: u32, theme: Theme) -> String {
    const CELL: (f64, f64) = (160.0, 40.0);
    const HEAD: (f64, f64) = (90.0, 44.0);
    let (columns, rows) = (f64::from(strands), f64::from(strands));
    let (width, height) = (HEAD.0 + CELL.0 * columns, HEAD.1 + CELL.1 * rows);
    let mut canvas = Canvas::new(width + 40.0, height + 32.0, theme);
    let (ink, grey) = (canvas.ink(), canvas.grey());
    let at = |x: f64, y: f64| [20.0 + x, 14.0 + y];
    for (y, weight) in [(0.0, 1.6), (HEAD.1, 1.0), (height, 1.6)] {
        canvas.line(&[at(0.0, y), at(width, y)], &Pen::new(ink, weight));
    }
    canvas.line(&[at(HEAD.0, 0.0), at(HEAD.0, height)], &Pen::new(grey, 1.0));
    canvas.words("2π W_r", at(0.5 * HEAD.0, 28.0), 15.0, Anchor::Middle, grey);
    for i in 0..strands {
        let along = f64::from(i) + 0.5;
        let colour = canvas.line_colour(i as usize);
        canvas.words(name(i), at(HEAD.0 + CELL.0 * along, 28.0), 16.0, Anchor::Middle, colour);
        canvas.words(name(i), at(0.5 * HEAD.0, HEAD.1 + CELL.1 * along + 6.0), 16.0, Anchor::Middle, colour);
        for j in 0..strands {
            let place = at(HEAD.0 + CELL.0 * (f64::from(j) + 0.5), HEAD.1 + CELL.1 * along + 5.0);
            canvas.words(&Entry::of(i, j).text(), place, 15.0, Anchor::Middle, ink);
        }
    }
    canvas.svg("What each pair of strands adds to the writhe")
}
