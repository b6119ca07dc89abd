//! Writhe.

use crate::curves::{closed, open, tangle, torus_knot, writhe_by_pairs};

#[test]
fn crossings_less_twist_is_the_sum_over_pairs() {
    for n in [4, 5, 6, 7, 8, 9, 12, 17, 40, 64, 65, 129, 200] {
        for seed in 0..6 {
            let curve = closed(tangle(n, seed + 1));
            let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
            assert!((got.value - want).abs() < 1e-10, "{n} {seed}: {got:?} {want}");
            let curve = open(tangle(n, seed + 1));
            let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
            assert!((got.value - want).abs() < 1e-10, "open {n} {seed}: {got:?} {want}");
        }
    }
    for (p, q) in [(2, 3), (2, -3), (3, 5), (1, 7)] {
        let curve = closed(torus_knot(300, p, q));
        let (got, want) = (curve.writhe().unwrap(), writhe_by_pairs(&curve));
        // four arcsines lose digits between nearly parallel segments
        assert!((got.value - want).abs() < 1e-7, "{p} {q}: {got:?} {want}");
    }
}
