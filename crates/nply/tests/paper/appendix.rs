//! (A.1), (A.5)–(A.32): link and writhe of a ply. Integrals by Simpson's rule, on the variables of the page.

use std::f64::consts::{PI, TAU};

use nply::Handedness;
use nply::geometry::{Contact, HelicalAngle};
use nply::mechanics::{Load, Ply, Twist};
use nply::topology::{ClosedPly, Part, PlyLink, PlyWrithe};

const THETAS: [f64; 4] = [0.15, 0.6, 1.0, 1.35];
const ROTATIONS: [f64; 4] = [0.4, 3.0, 9.7, 40.0];

/// ∫ f by Simpson's rule with n pairs of panels.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64, n: u32) -> f64 {
    let h = (to - from) / f64::from(2 * n);
    let weight = |i: u32| if i == 0 || i == 2 * n { 1.0 } else { f64::from(2 + 2 * (i % 2)) };
    (0..=2 * n).map(|i| weight(i) * f(from + h * f64::from(i))).sum::<f64>() * h / 3.0
}

fn ply(n: u32, theta: f64, hand: Handedness, psi_l: f64) -> PlyWrithe {
    PlyWrithe::new(n, HelicalAngle::new(theta).unwrap(), hand, psi_l.abs() / TAU).unwrap()
}

/// Angles, hands and ψ_L with the sign of the hand.
fn cases() -> impl Iterator<Item = (f64, f64, Handedness, f64)> {
    THETAS.into_iter().flat_map(|theta| {
        ROTATIONS.into_iter().flat_map(move |psi| {
            Handedness::BOTH.into_iter().map(move |hand| (theta, 1.0 / theta.tan(), hand, hand.sign() * psi))
        })
    })
}

/// (A.9), with its limit 0 at x = 0.
fn f_self(x: f64, mu: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    0.5 * x.sin() * (x.sin() - x * x.cos()) / (x.sin().powi(2) + mu * mu * x * x).powf(1.5)
}

/// (A.20)
fn f_pair(x: f64, alpha: f64, mu: f64) -> f64 {
    let v = alpha / 2.0 - x;
    0.5 * v.sin() * (v.sin() + x * v.cos()) / (v.sin().powi(2) + mu * mu * x * x).powf(1.5)
}

/// The five terms of (A.8), the first with dx dy; for a left hand the limits run backwards.
fn five_terms(f: impl Fn(f64) -> f64, mu: f64, eps: f64, psi_l: f64) -> f64 {
    let n = 3000;
    // the inner integrals over y, of a function of x alone, are the lengths of their ranges
    let rectangle = 2.0 * psi_l * (integral(&f, -psi_l / 2.0, 0.0, n) + integral(&f, 0.0, psi_l / 2.0, n));
    let corners = 2.0 * integral(|x| 2.0 * x * f(x), 0.0, psi_l / 2.0, n)
        + 2.0 * integral(|x| -2.0 * x * f(x), -psi_l / 2.0, 0.0, n);
    eps * mu * (rectangle - corners)
}

#[test]
fn eqa01() {
    for n in [2, 4, 6] {
        // parallel strands that touch: semicircles of length πr
        let contact = Contact::new(n, 0.0).unwrap();
        let got = ClosedPly::of_ply(&contact, Handedness::Right, 70.0).unwrap().length();
        assert!((got - f64::from(n) * (70.0 + PI)).abs() < 1e-11, "n = {n}: {got}");
    }
    for n in 1..=7 {
        let closed = ClosedPly::new(n, HelicalAngle::new(0.6).unwrap(), Handedness::Left, 2.5, 70.0).unwrap();
        let sum = |wanted: &dyn Fn(Part) -> bool| {
            closed.pieces().iter().filter(|p| wanted(p.part())).map(nply::topology::Piece::length).sum::<f64>()
        };
        let strands = sum(&|p| matches!(p, Part::Forward(_) | Part::Backward(_)));
        let (l_i, l_c) = (sum(&|p| p == Part::Insert), sum(&|p| p == Part::Closure));
        assert!((strands - 70.0 * f64::from(n)).abs() < 1e-11);
        assert!((closed.length() - strands - l_i - l_c - sum(&|p| p == Part::End)).abs() < 1e-10);
        assert_eq!(l_c > 0.0, n % 2 == 1, "a closure for odd n alone");
        assert!(l_i < TAU * 2.5 / 0.6_f64.sin(), "less than one turn");
    }
}

/// The double integral over the triangle t < s, twice, on s and v = t/s.
#[test]
fn eqa05_eqa06() {
    for (theta, mu, hand, psi_l) in cases().filter(|c| c.3.abs() < 5.0) {
        let integrand = |d: f64| {
            let numerator = 2.0 * (1.0 - d.cos()) - d * d.sin();
            numerator / (2.0 * (1.0 - d.cos()) + mu * mu * d * d).powf(1.5)
        };
        let n = 150;
        let inner = |s: f64| s * integral(|v| if v == 1.0 { 0.0 } else { integrand(s * (1.0 - v)) }, 0.0, 1.0, n);
        let double = 2.0 * integral(|s| if s == 0.0 { 0.0 } else { inner(s) }, 0.0, psi_l, n);
        let want = hand.sign() * mu * double / (4.0 * PI);
        let got = ply(2, theta, hand, psi_l).itself();
        assert!((got.writhe - want).abs() < 1e-7, "{theta} {psi_l}: {} {want}", got.writhe);
    }
}

#[test]
fn eqa07_eqa08_eqa09() {
    for (theta, mu, hand, psi_l) in cases().filter(|c| c.3.abs() < 30.0) {
        let want = five_terms(|x| f_self(x, mu), mu, hand.sign(), psi_l) / (4.0 * PI);
        let got = ply(3, theta, hand, psi_l).itself();
        assert!((got.writhe - want).abs() < 1e-9, "{theta} {psi_l}: {} {want}", got.writhe);
        assert!((got.leading + got.remainder - got.writhe).abs() < 1e-13);
    }
}

#[test]
fn eqa10_eqa11_eqa21() {
    for theta in THETAS {
        let mu = 1.0 / theta.tan();
        let chord = |x: f64, alpha: f64| 0.5 * x / ((alpha / 2.0 - x).sin().powi(2) + mu * mu * x * x).sqrt();
        for (from, to) in [(0.3, 4.0), (-2.0, -0.1), (7.0, 9.0)] {
            let got = integral(|x| f_self(x, mu), from, to, 2000);
            assert!((got - (chord(to, 0.0) - chord(from, 0.0))).abs() < 1e-9, "(A.10) {theta}");
            let got = integral(|x| f_pair(x, 2.1, mu), from, to, 2000);
            assert!((got - (chord(to, 2.1) - chord(from, 2.1))).abs() < 1e-9, "(A.21) {theta}");
        }
        for side in [1.0, -1.0] {
            let limit = 2.0 * chord(side * 1e-5, 0.0);
            assert!((limit - side / (1.0 + mu * mu).sqrt()).abs() < 1e-9 && (limit - side * theta.sin()).abs() < 1e-9);
        }
    }
}

/// (A.12), (A.13): what the double integral is made of; (A.14): 4μ ∫ x f dx is what stays bounded.
#[test]
fn eqa12_eqa13_eqa14() {
    for (theta, mu, hand, _) in cases() {
        let eps = hand.sign();
        let bounded = |psi: f64| {
            let psi_l = eps * psi;
            let corners = -4.0 * integral(|x| x * f_self(x, mu), 0.0, psi_l / 2.0, 20_000)
                + 4.0 * integral(|x| x * f_self(x, mu), -psi_l / 2.0, 0.0, 20_000);
            let whole = 4.0 * PI * ply(1, theta, hand, psi_l).itself().writhe;
            let rectangle = whole - eps * mu * corners;
            // (A.12) is the rectangle's limit: it lacks as ψ_L times 1 − C, that is 1/ψ_L
            let lacks = (rectangle - 2.0 * psi_l * (1.0 - theta.cos())).abs();
            assert!(lacks < 2.0 * theta.tan().powi(2) / psi * 2.0, "{theta} {psi}: {lacks}");
            mu * corners
        };
        let (near, far) = (bounded(200.0), bounded(400.0));
        assert!((far - near).abs() < 4.0 * theta.tan().powi(2) / 200.0, "(A.14) {theta}: {near} {far}");
    }
}

#[test]
fn eqa15_eqa22_eqa23_eqa24() {
    for theta in THETAS {
        for hand in Handedness::BOTH {
            let psi_l = hand.sign() * 2e7;
            let long = ply(5, theta, hand, psi_l);
            assert!((TAU * long.itself().writhe / psi_l - (1.0 - theta.cos())).abs() < 1e-6, "(A.15)");
            for i in 1..5 {
                assert!((TAU * long.pair(i).writhe / psi_l - 1.0).abs() < 1e-6, "(A.23)");
                let want = if i % 2 == 1 { -1.0 } else { 1.0 };
                assert!((TAU * long.entry(0, i).writhe / psi_l - want).abs() < 1e-6, "(A.24)");
                assert!((2.0 * TAU * long.pair(i).leading / (2.0 * psi_l) - 1.0).abs() < 1e-15, "(A.22)");
            }
        }
    }
}

#[test]
fn eqa16_eqa17_eqa18() {
    for (theta, mu, hand, psi_l) in cases().filter(|c| c.0 < 1.2 && c.3.abs() < 5.0) {
        for (n, i) in [(2, 1), (3, 1), (5, 2), (5, 4)] {
            let alpha = TAU * f64::from(i) / f64::from(n);
            let integrand = |d: f64| {
                let numerator = 2.0 * (1.0 - (alpha - d).cos()) + d * (alpha - d).sin();
                numerator / (2.0 * (1.0 - (alpha - d).cos()) + mu * mu * d * d).powf(1.5)
            };
            let double = integral(|a| integral(|b| integrand(a - b), 0.0, psi_l, 200), 0.0, psi_l, 200);
            let want = hand.sign() * mu * double / (4.0 * PI);
            let got = ply(n, theta, hand, psi_l).pair(i);
            assert!((got.writhe - want).abs() < 1e-7, "{theta} {psi_l} {i}/{n}: {} {want}", got.writhe);
        }
    }
}

#[test]
fn eqa19_eqa20() {
    for (theta, mu, hand, psi_l) in cases().filter(|c| c.3.abs() < 30.0) {
        for (n, i) in [(2, 1), (3, 2), (7, 3), (12, 1)] {
            let alpha = TAU * f64::from(i) / f64::from(n);
            let want = five_terms(|x| f_pair(x, alpha, mu), mu, hand.sign(), psi_l) / (4.0 * PI);
            let got = ply(n, theta, hand, psi_l).pair(i).writhe;
            assert!((got - want).abs() < 1e-8, "{theta} {psi_l} {i}/{n}: {got} {want}");
        }
    }
}

/// Tables I and II, entry by entry, and their sums.
#[test]
fn eqa25_eqa26_eqa27() {
    for (theta, _, hand, psi_l) in cases() {
        let s = psi_l * (1.0 - theta.cos());
        let (p, m) = (psi_l, -psi_l);
        let table_1: Vec<Vec<f64>> = vec![vec![s, m], vec![m, s]];
        let table_2 = vec![vec![s, m, p], vec![m, s, m], vec![p, m, s]];
        for (n, table) in [(2, table_1), (3, table_2)] {
            let got = ply(n, theta, hand, psi_l);
            let (mut leading, mut writhe) = (0.0, 0.0);
            for (i, row) in (0..).zip(&table) {
                for (j, want) in (0..).zip(row) {
                    assert!((TAU * got.entry(i, j).leading - want).abs() < 1e-13, "({i}, {j}) of n = {n}");
                    leading += want / TAU;
                    writhe += got.entry(i, j).writhe;
                }
            }
            assert!((got.total().leading - leading).abs() < 1e-13);
            assert!((got.total().writhe - writhe).abs() < 1e-12);
        }
        let leading = |n| ply(n, theta, hand, psi_l).total().leading;
        assert!((leading(2) + 2.0 * psi_l / TAU * theta.cos()).abs() < 1e-13, "(A.25)");
        assert!((leading(3) - psi_l / TAU * (1.0 - 3.0 * theta.cos())).abs() < 1e-13, "(A.26)");
        for n in 1..=9 {
            let (count, sigma) = (f64::from(n), f64::from(n % 2));
            assert!((leading(n) - psi_l / TAU * (sigma - count * theta.cos())).abs() < 1e-12, "(A.27)");
        }
    }
}

/// The ledger before and after the ply forms, against the balanced ply that mechanics finds.
#[test]
fn eqa28_to_eqa32() {
    for n in 2..=7 {
        for (pretwist, length) in [(-0.4, 60.0), (-1.0, 3000.0), (0.7, 5e5)] {
            let state = Ply::new(n, 0.75).unwrap().equilibria(Twist::Pretwist(pretwist), Load::NONE).unwrap()[0];
            let (contact, hand) = (state.contact(), state.handedness());
            let (theta, rho, eps) = (contact.helical_angle(), contact.radius_ratio(), hand.sign());
            let (count, sigma) = (f64::from(n), f64::from(n % 2));
            let phi = pretwist * length;
            let before = PlyLink::straight(n, phi).unwrap();
            assert!((before.link - count * phi / TAU).abs() < 1e-12 * before.link.abs(), "(A.31)");
            assert!((before.link - before.strand_twist).abs() < 1e-15 * before.link.abs());
            let after = before.wound(&PlyWrithe::of_ply(contact, hand, length).unwrap()).unwrap();
            let tolerance = 1e-13 * after.link.abs();
            let t_c = -eps * length * theta.sin() / (TAU * rho);
            assert!((after.closure_twist - sigma * t_c).abs() < tolerance, "(A.29)");
            let l_k = after.strand_twist + sigma * t_c + after.writhe.writhe;
            assert!((after.link - l_k).abs() < tolerance && (after.link - before.link).abs() < tolerance, "(A.28)");
            let rest = after.writhe.remainder;
            let l_k = after.strand_twist - eps * count * length / (TAU * rho) * theta.sin() * theta.cos();
            assert!((after.link - l_k - rest).abs() < tolerance, "(A.30)");
            assert!(rest.abs() < 0.6, "bounded: {rest}");
            let u3 = phi / length + eps * (2.0 * theta).sin() / (2.0 * rho);
            let lacks = after.twist_of_a_strand() / length - u3 + TAU * rest / (count * length);
            assert!(lacks.abs() < 1e-13, "(A.32): {lacks}");
            assert!((state.strand_twist() - u3).abs() < 1e-10, "(45)");
            let per_length = (after.writhe.leading + after.closure_twist) / length;
            assert!(
                (state.link().writhe - per_length).abs() < 1e-13,
                "what mechanics calls writhe has the closure's twist in it"
            );
        }
    }
}
