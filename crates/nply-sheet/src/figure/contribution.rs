//! Tables I and II: what each pair of strands adds to the writhe of a long ply.

use nply::geometry::HelicalAngle;
use nply::topology::PlyWrithe;
use nply::{DomainError, Handedness};

use super::canvas::{Anchor, Canvas, Pen};
use super::{Data, Parts, rad};
use crate::plot::Theme;

/// One entry of a long ply, times ψ_L: a number, and another times cos θ.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    constant: f64,
    cosine: f64,
}

/// The ply of which the numbers stand beside the table.
const EXAMPLE: (f64, f64) = (30.0, 10.0);

impl Entry {
    /// Strands `i` and `j`, from 0: what grows with length is linear in cos θ, and two angles tell it.
    fn of(strands: u32, i: u32, j: u32) -> Result<Self, DomainError> {
        let leading = |degrees: f64| {
            let ply = PlyWrithe::new(strands, HelicalAngle::new(rad(degrees))?, Handedness::Right, 1.0)?;
            Ok(ply.entry(i, j).leading)
        };
        let (straight, half) = (leading(0.0)?, leading(60.0)?);
        let whole = |value: f64| libm::round(1e9 * value) / 1e9 + 0.0;
        let cosine = 2.0 * (straight - half);
        Ok(Self { constant: whole(straight - cosine), cosine: whole(cosine) })
    }

    fn text(self) -> String {
        let own = self.cosine < -0.5;
        match (own, self.constant > 0.0) {
            (true, _) => "ψ_L (1 − cos θ)",
            (false, true) => "ψ_L",
            (false, false) => "−ψ_L",
        }
        .to_owned()
    }
}

pub(super) fn two() -> Result<Parts, DomainError> {
    make(
        2,
        "Writhe of a long ply of two strands, times 2π, strand by strand; ψ_L is the angle a strand winds through. The strands are run \
         through in opposite directions, and so their own writhe of 1 − cos θ a turn is outweighed by what they add to each other: in all \
         −2 cos θ a turn. The numbers have a ply of ten turns at 30° beside it, with what its ends add.",
    )
}

pub(super) fn three() -> Result<Parts, DomainError> {
    make(
        3,
        "The same of three strands. The first and the third run the same way and add to each other, either takes from the second: in all \
         1 − 3 cos θ a turn, the 1 being what a closure is wound round.",
    )
}

fn make(strands: u32, caption: &str) -> Result<Parts, DomainError> {
    let columns = ["row", "column", "constant", "cosine", "writhe_of_ten_turns_at_30_deg", "of_it_from_ends"];
    let mut data = Data::new(columns);
    let (degrees, turns) = EXAMPLE;
    let example = PlyWrithe::new(strands, HelicalAngle::new(rad(degrees))?, Handedness::Right, turns)?;
    let mut entries = Vec::new();
    for (i, j) in (0..strands).flat_map(|i| (0..strands).map(move |j| (i, j))) {
        let entry = Entry::of(strands, i, j)?;
        let found = example.entry(i, j);
        let numbers = [entry.constant, entry.cosine, found.writhe, found.remainder].map(super::Cell::from);
        data.push([name(i).into(), name(j).into()].into_iter().chain(numbers));
        entries.push(entry);
    }
    Ok(Parts::free(caption, data, move |theme| draw(strands, &entries, theme)))
}

const fn name(strand: u32) -> &'static str {
    match strand {
        0 => "H₁⁺",
        1 => "H₂⁻",
        _ => "H₃⁺",
    }
}

fn draw(strands: u32, entries: &[Entry], theme: Theme) -> String {
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
            let entry = entries[(i * strands + j) as usize];
            canvas.words(&entry.text(), place, 15.0, Anchor::Middle, ink);
        }
    }
    canvas.svg("What each pair of strands adds to the writhe")
}
