//! Abaqus' input, which other finite-element programs and converters read too: nodes, and beam elements in sets.

use core::fmt::Write as _;

use super::{Chain, FileUnit, said};

/// Lines of sixteen numbers.
const PER_LINE: usize = 16;

/// Nodes and beams of two or three nodes, each wire with its set of elements, its set of nodes and the radius of its round section as
/// a comment; names are in capitals as Abaqus shows them.
pub(super) fn write(title: &str, chains: &[Chain], unit: &FileUnit) -> Vec<u8> {
    let mut out = format!("*HEADING\n{}\n*NODE\n", said(title, unit));
    let coordinates = || chains.iter().flat_map(|chain| &chain.points).flat_map(|point| unit.point(*point));
    let last = LastPlace::of(coordinates());
    let mut first = Vec::new();
    let mut number = 1;
    for chain in chains {
        first.push(number);
        for point in &chain.points {
            let [x, y, z] = unit.point(*point).map(|x| last.field(x));
            let _ = writeln!(out, "{number}, {x}, {y}, {z}");
            number += 1;
        }
    }
    let mut element = 1;
    for (chain, first) in chains.iter().zip(&first) {
        let set = chain.name.to_uppercase();
        let radius = chain.radius * unit.per_radius;
        let _ = writeln!(out, "** radius {}", LastPlace::of([radius]).field(radius));
        let _ = writeln!(out, "*ELEMENT, TYPE={}, ELSET={set}", chain.element.name());
        let chords = chain.element.chords() as usize;
        for start in (0..chain.points.len() - 1).step_by(chords) {
            let nodes: Vec<String> = (0..=chords).map(|k| (first + start + k).to_string()).collect();
            let _ = writeln!(out, "{element}, {}", nodes.join(", "));
            element += 1;
        }
    }
    for (chain, first) in chains.iter().zip(&first) {
        let _ = writeln!(out, "*NSET, NSET={}-NODES", chain.name.to_uppercase());
        let nodes: Vec<String> = (0..chain.points.len()).map(|i| (first + i).to_string()).collect();
        for line in nodes.chunks(PER_LINE) {
            let _ = writeln!(out, "{}", line.join(", "));
        }
    }
    // the ends, for whoever clamps and pulls
    for (name, node) in [("START", 0), ("END", usize::MAX)] {
        let _ = writeln!(out, "*NSET, NSET={name}");
        let nodes: Vec<String> = chains
            .iter()
            .zip(&first)
            .map(|(chain, first)| (first + node.min(chain.points.len() - 1)).to_string())
            .collect();
        for line in nodes.chunks(PER_LINE) {
            let _ = writeln!(out, "{}", line.join(", "));
        }
    }
    out.into_bytes()
}

/// The last decimal place to which numbers of one kind are written: the sixteenth digit of the greatest. What lies below it is rounding, so
/// that a node on an axis is written with 0 and not with 1e-16 of something.
#[derive(Clone, Copy)]
struct LastPlace(i32);

impl LastPlace {
    fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        const DIGITS: i32 = 16;
        let greatest = numbers.into_iter().fold(0.0, |all: f64, x| all.max(x.abs()));
        // the decimal exponent, read off the number as it is written
        let written = format!("{greatest:e}");
        let exponent = written.rsplit_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0);
        Self(DIGITS - 1 - exponent)
    }

    /// A number in a field: at most twenty characters, for that is all of a field that CalculiX reads (it cuts off what is behind, an
    /// exponent too, without a word) and that Abaqus allows a number.
    fn field(self, number: f64) -> String {
        const WIDTH: usize = 20;
        let Self(place) = self;
        let kept = match usize::try_from(place) {
            // 400 places reach below the least double
            Ok(place) => format!("{number:.*}", place.min(400)).parse().unwrap_or(number),
            Err(_) => number,
        };
        // no negative nought
        let kept = kept + 0.0;
        let shortest = format!("{kept:?}");
        if shortest.len() <= WIDTH {
            return shortest;
        }
        let digits = (0..=WIDTH).rev().map(|digits| format!("{kept:.digits$e}"));
        digits.into_iter().find(|text| text.len() <= WIDTH).unwrap_or(shortest)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::LastPlace;

    proptest! {
        /// Whatever stands in a field is read back to the last place, from twenty characters.
        #[test]
        fn a_number_has_twenty_characters_and_is_read_back(
            mantissa in -1.0..1.0_f64, scale in -300..300_i32, below in 0..40_i32,
        ) {
            let greatest: f64 = format!("1e{scale}").parse().unwrap();
            let number = mantissa * format!("1e{}", scale - below).parse::<f64>().unwrap();
            let field = LastPlace::of([greatest, number]).field(number);
            prop_assert!(field.len() <= 20, "{field}");
            let read: f64 = field.parse().unwrap();
            // sixteen digits of the greatest, or as many of its own as there is room for
            prop_assert!((read - number).abs() <= 1e-15 * greatest + 1e-12 * number.abs(), "{number:e} {field}");
        }
    }

    #[test]
    fn what_is_rounding_is_nought() {
        let last = LastPlace::of([533.4, -2.1]);
        assert_eq!(last.field(-2.624_830_234_716_338e-16), "0.0");
        assert_eq!(last.field(44.450_000_000_000_01), "44.45");
        assert_eq!(LastPlace::of([2.150_000_000_000_000_4]).field(2.150_000_000_000_000_4), "2.15");
        assert_eq!(LastPlace::of([0.0]).field(-0.0), "0.0");
    }
}
