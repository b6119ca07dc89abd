//! Average crossing number.

use nply::topology::{AverageCrossings, Curve};

use crate::curves::{closed, gauss, open, tangle, torus_knot};

fn by_pairs(curve: &Curve) -> f64 {
    let n = curve.segments();
    let pairs = (0..n).flat_map(|i| (i + 2..n).map(move |j| (i, j)));
    let joined = |i: usize, j: usize| curve.is_closed() && i == 0 && j + 1 == n;
    2.0 * pairs
        .filter(|&(i, j)| !joined(i, j))
        .map(|(i, j)| gauss(curve.segment(i), curve.segment(j)).abs())
        .sum::<f64>()
}

#[test]
fn it_is_the_sum_over_pairs() {
    for n in [4, 9, 63, 64, 65, 66, 130, 260] {
        for curve in [closed(tangle(n, 3)), open(tangle(n, 4))] {
            let (got, want) = (curve.average_crossing_number(), by_pairs(&curve));
            assert!((got.value - want).abs() < 1e-9 * want.max(1.0), "{n}: {got:?} {want}");
            assert!(got.bound < 1e-7);
        }
    }
    // long, so that most pairs are far apart
    for n in [700, 1501] {
        let curve = closed(torus_knot(n, 2, 5));
        let (got, want) = (curve.average_crossing_number(), by_pairs(&curve));
        assert!((got.value - want).abs() < 1e-6, "{n}: {got:?} {want}");
    }
}

#[test]
fn shares_make_the_whole() {
    let curve = closed(torus_knot(1000, 3, 4));
    let work = AverageCrossings::new(&curve);
    let (mut sum, mut pairs) = (0.0, 0);
    for column in 0..work.columns() {
        sum += work.share(column..column + 1).value;
        pairs += work.pairs(column..column + 1);
    }
    assert_eq!(pairs, 1000 * 999 / 2);
    assert!((sum - curve.average_crossing_number().value).abs() < 1e-11);
    // never less than the crossings of the knot, (3, 4): eight
    assert!(sum > 8.0);
}
