use super::*;

/// Powers 1, t, … t⁶, of which any polynomial is a combination.
struct Powers;

impl Basis<7> for Powers {
    fn at(&self, t: f64) -> [Dual; 7] {
        let x = Dual::new(t, 1.0);
        let mut power = Dual::new(1.0, 0.0);
        core::array::from_fn(|_| {
            let this = power;
            power = power * x;
            this
        })
    }
}

/// Coefficients of Π (t − root).
fn with_roots(roots: &[f64]) -> [f64; 7] {
    let mut c = [0.0; 7];
    c[0] = 1.0;
    for (degree, root) in roots.iter().enumerate() {
        for k in (0..=degree + 1).rev() {
            c[k] = if k > 0 { c[k - 1] } else { 0.0 } - root * c[k];
        }
    }
    c
}

fn all(weights: &[f64; 7]) -> Vec<Root> {
    let mut roots = Vec::new();
    for i in 0..4 {
        let (a, b) = (0.25 * f64::from(i), 0.25 * f64::from(i + 1));
        // of the mirror image, with all coefficients negative, the roots are the same
        let pair = Pair { even: [0.0; 7], odd: *weights };
        Panel::fit(&Powers, a, b).roots(&Powers, &pair, &mut |side, root| {
            if side > 0.0 {
                roots.push(root);
            }
        });
    }
    roots.sort_by(|a, b| a.at.total_cmp(&b.at));
    roots
}

#[test]
fn none_missed_none_twice() {
    for roots in [
        vec![],
        vec![0.3],
        vec![0.25], // on a border
        vec![0.25, 0.5, 0.75],
        vec![0.4, 0.4000001],
        vec![0.1, 0.10001, 0.9, 0.95],
        vec![0.2, 0.7, 1.5, -0.3],
        vec![1e-7, 0.6],
        vec![0.31, 0.32, 0.33, 0.34, 0.35],
    ] {
        let got = all(&with_roots(&roots));
        let mut inside: Vec<f64> = roots.iter().copied().filter(|r| (0.0..1.0).contains(r)).collect();
        inside.sort_by(f64::total_cmp);
        assert_eq!(got.len(), inside.len(), "{roots:?} gave {got:?}");
        for (g, want) in got.iter().zip(&inside) {
            assert!((g.at - want).abs() < 1e-8 && !g.double, "{roots:?} gave {got:?}");
        }
    }
}

#[test]
fn touching_zero_is_one_double_root() {
    let got = all(&with_roots(&[0.6, 0.6]));
    assert!(got.len() == 1 && got[0].double && (got[0].at - 0.6).abs() < 1e-7, "{got:?}");
    let got = all(&[0.36 + 1e-9, -1.2, 1.0, 0.0, 0.0, 0.0, 0.0]); // and misses it by 1e-9
    assert!(got.is_empty(), "{got:?}");
}

/// A dip midway between two nodes, so narrow that the nodes hardly see it.
struct Dip;

const MIDWAY: f64 = 0.5 * (NODES[4] + NODES[5]);
const WIDTH: f64 = 0.03;

impl Basis<2> for Dip {
    fn at(&self, t: f64) -> [Dual; 2] {
        let from = (t - MIDWAY) / WIDTH;
        let dip = libm::exp(-from * from);
        [Dual::new(dip, -2.0 * from / WIDTH * dip), Dual::new(1.0, 0.0)]
    }
}

#[test]
fn where_the_polynomials_fail_they_are_not_trusted() {
    let panel = Panel::fit(&Dip, 0.0, 1.0);
    for (depth, want) in [(1.2, 2), (0.999, 0)] {
        let pair = Pair { even: [-depth, 1.0], odd: [0.0; 2] };
        let mut roots = Vec::new();
        panel.roots(&Dip, &pair, &mut |side, root| {
            if side > 0.0 {
                roots.push(root.at);
            }
        });
        assert_eq!(roots.len(), want, "depth {depth}: {roots:?}");
        for root in roots {
            assert!(((root - MIDWAY).abs() - WIDTH * libm::sqrt(libm::log(depth))).abs() < 1e-12, "{root}");
        }
    }
}

#[test]
fn zero_everywhere_has_no_root_that_stands_out() {
    assert!(all(&[0.0; 7]).is_empty()); // and ends at once
    let faint = with_roots(&[0.6, 0.7]).map(|c| c * 1e-300);
    assert_eq!(all(&faint).len(), 2);
}

#[test]
fn orders_that_cancel_at_zero_end_the_search() {
    // t − sin t and t cancel to third order: t − sin t − h t has a root at √(6h) about
    struct Third;
    impl Basis<3> for Third {
        fn at(&self, t: f64) -> [Dual; 3] {
            let (sin, cos) = libm::sincos(t);
            [Dual::new(t, 1.0), Dual::new(sin, cos), Dual::new(t * t * t, 3.0 * t * t)]
        }
    }
    let count = |weights: [f64; 3]| {
        let mut roots = Vec::new();
        let pair = Pair { even: weights, odd: [0.0; 3] };
        Panel::fit(&Third, 0.0, 0.5).roots(&Third, &pair, &mut |side, root| {
            if side > 0.0 {
                roots.push(root.at);
            }
        });
        roots
    };
    assert!(count([1.0, -1.0, 0.0]).is_empty());
    let _ = count([1.0, -1.0, -1.0 / 6.0]); // fifth order is lost in rounding, but the search ends
    let small = count([1.0 - 1e-6, -1.0, 0.0]);
    assert!(small.len() == 1 && (small[0] / libm::sqrt(6e-6) - 1.0).abs() < 1e-6, "{small:?}");
    let half = count([1.0, -1.0, -1.0 / 6.0 + 1e-3]); // t⁵/120 = 1e-3 t³
    assert!(half.len() == 1 && (half[0] - libm::sqrt(0.12)).abs() < 1e-2, "{half:?}");
}

#[test]
fn zero_itself_is_divided_out() {
    let got = all(&with_roots(&[0.0, 0.0, 0.6])); // t²(t − 0.6)
    assert!(got.len() == 1 && (got[0].at - 0.6).abs() < 1e-14, "{got:?}");
    let got = all(&with_roots(&[0.0, 1e-12, 0.6]));
    assert!(got.len() == 2 && (got[0].at / 1e-12 - 1.0).abs() < 1e-12, "{got:?}");
}

/// Terms of which nothing is left but a few last digits, next to 0, are no roots.
#[test]
fn what_underflows_is_no_root() {
    for weight in [1e-290, 1e-304, 1e-320, 0.0] {
        // t³ + weight·t is positive throughout
        assert_eq!(
            all(&[0.0, weight, 0.0, 1.0, 0.0, 0.0, 0.0]).iter().filter(|root| root.at > 0.0).count(),
            0,
            "{weight}"
        );
    }
}
