//! Where print is in error: the printed form fails and ours holds.
#![allow(clippy::disallowed_methods, clippy::unwrap_used, clippy::float_cmp, clippy::panic)] // independent routes

mod common;

use std::f64::consts::{FRAC_PI_4, TAU};

use common::touch::{Touch, slope, touch_at};
use common::vector::{add, cross, derivative, dot, norm, sub, times};
use nply::Handedness::{self, Left, Right};
use nply::geometry::{Centreline, Contact, HelicalAngle, Section};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::topology::PlyWrithe;

fn angle(degrees: f64) -> HelicalAngle {
    HelicalAngle::new(degrees.to_radians()).unwrap()
}

/// A 3-ply far from straight, where what print leaves out is large.
fn rope(balance: Balance) -> Equilibrium {
    Ply::with_balance(3, 0.75, balance).unwrap().moment_at(angle(35.0), Right, Twist::Pretwist(-1.0), 0.4).unwrap()
}

/// (9): the printed normal is the tangent, which leaves no tube round the centreline.
#[test]
fn eq09_normal() {
    let contact = Contact::new(3, 0.6).unwrap();
    let (line, section) = (Centreline::new(&contact, Right, 0), Section::new(&contact, Right));
    let (s, alpha) = (0.8, 2.0_f64);
    let first = |s| derivative(|s| line.position(s), s, 1e-2);
    let second = derivative(first, s, 1e-2);
    let point = |n, b| add(line.position(s), add(times(alpha.sin(), n), times(alpha.cos(), b)));
    let tangent = times(1.0 / norm(first(s)), first(s));
    let printed = point(tangent, cross(first(s), tangent));
    let normal = times(1.0 / norm(second), second);
    let ours = point(normal, cross(first(s), normal));
    let from_axis = |p| norm(cross(sub(p, line.position(s)), tangent));
    assert!(from_axis(printed) < 1e-8, "on the tangent itself");
    assert!((from_axis(ours) - 1.0).abs() < 1e-8, "on the tube");
    assert!(norm(sub(ours, section.surface(s, alpha))) < 1e-7);
}

/// (17): ε before the first term alone turns the frame of a left-handed strand inside out.
#[test]
fn eq17_hand() {
    let contact = Contact::new(3, 0.6).unwrap();
    for (hand, printed_holds) in [(Right, true), (Left, false)] {
        let line = Centreline::new(&contact, hand, 0);
        let (eps, psi, d3) = (hand.sign(), line.azimuth(0.7), line.frame(0.7).tangent);
        let (s, c) = (contact.angle().sin(), contact.angle().cos());
        let nineteen = |e_psi: [f64; 3]| norm(sub(d3, [eps * s * e_psi[0], eps * s * e_psi[1], c])) < 1e-14;
        assert_eq!(nineteen([eps * psi.cos(), psi.sin(), 0.0]), printed_holds);
        assert!(nineteen([eps * psi.cos(), eps * psi.sin(), 0.0]));
    }
}

/// (34), (35): without the contact forces that cross a section, loads on limp strands (B = C = 0) do work on a
/// displacement that the contact allows, and strands with stiffness are not where their energy is stationary.
#[test]
fn eq34_eq35_crossing_forces() {
    for n in [3, 6] {
        let theta = 35_f64.to_radians();
        let t = touch_at(n, theta);
        let q = (t.x * t.rho / 2.0).powi(2);
        // f d(cos θ) + m d(sin θ/ρ) = 0 along the contact
        let by_work = -slope(f64::cos, theta, 1e-3) / slope(|t| t.sin() / touch_at(n, t).rho, theta, 1e-3);
        let lever = |balance| {
            let ply = Ply::with_balance(n, 0.75, balance).unwrap();
            let force = 1e9; // beside which the strands are limp
            ply.moment_at(angle(35.0), Right, Twist::Pretwist(0.0), force).unwrap().load().moment / force
        };
        let printed = t.rho * t.s / t.c;
        assert!((lever(Balance::Radial) / printed - 1.0).abs() < 1e-7);
        assert!((printed / by_work - 1.0).abs() > 0.2, "print: {printed}, work: {by_work}");
        assert!((lever(Balance::Contact) / by_work - 1.0).abs() < 1e-7);
        assert!((by_work / (printed / (1.0 - q)) - 1.0).abs() < 1e-8);
    }
    let energy_slope = |state: &Equilibrium| {
        let energy = |theta: f64| {
            let Touch { n, s, c, rho, .. } = touch_at(3, theta);
            let u3 = state.pretwist() + s * c / rho;
            s.powi(4) / (2.0 * rho * rho) + 0.375 * u3 * u3
                - state.load().force / n * c
                - state.load().moment / (n * rho) * s
        };
        slope(energy, state.contact().helical_angle(), 1e-3)
    };
    assert!(energy_slope(&rope(Balance::Radial)).abs() > 1e-2);
    assert!(energy_slope(&rope(Balance::Contact)).abs() < 1e-9);
}

/// (38), first line: the capital is the p of (37), as the second line tells.
#[test]
fn eq38_letter() {
    let state = rope(Balance::Radial);
    let Touch { c, x, rho, beta, .. } = touch_at(3, state.contact().helical_angle());
    let p = state.resultant_pressure();
    let second = p * (2.0 * (1.0 - beta.cos()) + x * x * c * c).sqrt() / (2.0 * (1.0 - beta.cos()));
    assert!((p / (rho * (1.0 - beta.cos())) / second - 1.0).abs() < 1e-13);
    assert!((state.interstrand_pressure() / second - 1.0).abs() < 1e-13);
}

/// (63): the rotation's slope without ρ′ is not its slope, and hides that radial balance is not symmetric.
#[test]
fn eq63_radius() {
    let theta = 35_f64.to_radians();
    let Touch { s, c, rho, .. } = touch_at(3, theta);
    let true_slope = slope(|t| t.sin() / touch_at(3, t).rho, theta, 1e-3);
    assert!((c / rho / true_slope - 1.0).abs() > 0.2, "as printed");
    let ours = c / rho - s * Contact::new(3, theta).unwrap().radius_ratio_slope() / (rho * rho);
    assert!((ours / true_slope - 1.0).abs() < 1e-9);

    let radial =
        Ply::with_balance(3, 0.75, Balance::Radial).unwrap().pretwist_at(angle(35.0), Right, Load::NONE).unwrap();
    let [[_, fm], [mf, _]] = radial.flexibility_as_published().unwrap();
    assert_eq!(fm, mf, "print looks symmetric");
    let [[_, fm], [mf, _]] = radial.flexibility().unwrap();
    assert!((fm / mf - 1.0).abs() > 0.2, "and is not");
    let contact = Ply::new(3, 0.75).unwrap().pretwist_at(angle(35.0), Right, Load::NONE).unwrap();
    let [[_, fm], [mf, _]] = contact.flexibility().unwrap();
    assert!((fm / mf - 1.0).abs() < 1e-13, "contact balance is");
}

/// (65): one sign.
#[test]
fn eq65_sign() {
    for n in [3, 4, 7] {
        let theta = 0.7;
        let Touch { s, c, x, rho, beta: b, .. } = touch_at(n, theta);
        let with = |sign: f64| {
            rho.powi(3) * (-x * x * c * c + sign * 2.0 * x * s * b.sin() + x * x * b.cos() + b.sin() * b.sin()) * s * c
                / (4.0 * (c * c + s * s * b.cos()))
        };
        let true_slope = slope(|t| touch_at(n, t).rho, theta, 1e-3);
        assert!((with(1.0) / true_slope - 1.0).abs() > 0.1, "as printed");
        assert!((with(-1.0) / true_slope - 1.0).abs() < 1e-9);
        assert!((Contact::new(n, theta).unwrap().radius_ratio_slope() / true_slope - 1.0).abs() < 1e-9);
    }
}

/// (67): the coupling changes sign with the hand.
#[test]
fn eq67_hand() {
    let theta = 0.01;
    for hand in Handedness::BOTH {
        let ply = Ply::with_balance(2, 0.75, Balance::Radial).unwrap();
        let state = ply.pretwist_at(HelicalAngle::new(theta).unwrap(), hand, Load::NONE).unwrap();
        let coupling = state.flexibility().unwrap()[0][1];
        let printed = -0.5 / 0.75 * theta;
        assert_eq!((coupling / printed - 1.0).abs() < 1e-3, hand == Right, "as printed");
        assert!((coupling / (hand.sign() * printed) - 1.0).abs() < 1e-3);
    }
}

/// Below (67): for γ = 1, tan 2θ = −2ερφ̄a; print has no ρ, which only two strands below 45° can do without.
#[test]
fn equal_stiffnesses() {
    for n in [2, 3, 6] {
        for pretwist in [-0.4, 0.3] {
            let states = Ply::with_balance(n, 1.0, Balance::Radial)
                .unwrap()
                .equilibria(Twist::Pretwist(pretwist), Load::NONE)
                .unwrap();
            assert_eq!(states.len(), 2);
            for state in states {
                let (theta, eps) = (state.contact().helical_angle(), state.handedness().sign());
                let ours = -2.0 * eps * state.contact().radius_ratio() * pretwist;
                assert!(((2.0 * theta).tan() / ours - 1.0).abs() < 1e-12);
                let printed = -eps / 2.0 * (2.0 * pretwist).atan();
                let holds = (theta - printed).abs() < 1e-12;
                assert_eq!(holds, n == 2 && theta < FRAC_PI_4, "as printed, n = {n}, {theta}");
            }
        }
    }
}

/// The integrand (A.9).
fn writhing(x: f64, mu: f64) -> f64 {
    if x == 0.0 {
        return 0.0;
    }
    0.5 * x.sin() * (x.sin() - x * x.cos()) / (x.sin().powi(2) + mu * mu * x * x).powf(1.5)
}

/// By the midpoint rule.
fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let h = (to - from) / 2000.0;
    (0..2000).map(|i| f(from + h * (f64::from(i) + 0.5))).sum::<f64>() * h
}

/// (A.8): the limits of the first term belong to the variables in the other order.
#[test]
fn eqa08_order() {
    let (mu, psi) = (1.0 / 0.6_f64.tan(), 5.0);
    let h = psi / 600.0;
    let mut direct = 0.0; // (A.5) as it stands
    for i in 0..600 {
        for j in 0..600 {
            let d = h * f64::from(i - j);
            if i != j {
                let numerator = 2.0 * (1.0 - d.cos()) - d * d.sin();
                direct += h * h * numerator / (2.0 * (1.0 - d.cos()) + mu * mu * d * d).powf(1.5);
            }
        }
    }
    let corners = 4.0 * integral(|x| 2.0 * x * writhing(x, mu), 0.0, psi / 2.0);
    let printed = psi * integral(|x| writhing(x, mu), 0.0, 2.0 * psi) - corners;
    let ours = 2.0 * psi * integral(|x| writhing(x, mu), -psi / 2.0, psi / 2.0) - corners;
    assert!((ours / direct - 1.0).abs() < 1e-2, "{ours} {direct}");
    assert!((printed / direct - 1.0).abs() > 0.1, "{printed} {direct}");
}

/// (A.13): the corners lack the factor εμ that stands before them in (A.8).
#[test]
fn eqa13_factor() {
    let (theta, psi) = (0.6_f64, 5.0);
    let mu = 1.0 / theta.tan();
    let rectangle = mu * 2.0 * psi * integral(|x| writhing(x, mu), -psi / 2.0, psi / 2.0);
    let corners = -4.0 * integral(|x| x * writhing(x, mu), 0.0, psi / 2.0)
        + 4.0 * integral(|x| x * writhing(x, mu), -psi / 2.0, 0.0);
    let angle = HelicalAngle::new(theta).unwrap();
    let writhe = 2.0 * TAU * PlyWrithe::new(1, angle, Right, psi / TAU).unwrap().itself().writhe;
    assert!((rectangle + mu * corners - writhe).abs() < 1e-5, "{rectangle} {corners} {writhe}");
    assert!((rectangle + corners - writhe).abs() > 0.1, "as printed");
}

/// (A.11): a root is missing.
#[test]
fn eqa11_root() {
    let theta = 0.6_f64;
    let (mu, x) = (1.0 / theta.tan(), 1e-5_f64);
    let limit = x / (x.sin().powi(2) + mu * mu * x * x).sqrt();
    assert!((limit - 1.0 / (1.0 + mu * mu)).abs() > 0.1, "as printed");
    assert!((limit - 1.0 / (1.0 + mu * mu).sqrt()).abs() < 1e-9 && (limit - theta.sin()).abs() < 1e-9);
}

/// Caption of Figure 11: 2.1r is the helix's radius; a core of that radius would hold the strands at 3.1r.
#[test]
fn figure_11_core() {
    let by_helix = Contact::from_radius_ratio(6, 2.1).unwrap();
    assert!((by_helix.angle().degrees() - 20.0).abs() < 0.05 && (by_helix.hole_radius() - 1.1).abs() < 1e-14);
    let by_core = Contact::from_radius_ratio(6, 2.1 + 1.0).unwrap();
    assert!(by_core.angle().degrees() > 40.0);
}

/// The contact forces (29) are no part of print's errors: they add up to a radial one, at different heights.
#[test]
fn contact_forces_stand_askew() {
    let contact = Contact::new(3, 0.6).unwrap();
    let (a, b) = (Centreline::new(&contact, Right, 0), Centreline::new(&contact, Right, 1));
    let shift = contact.arclength_shift() * contact.radius_ratio();
    let line = sub(a.position(0.0), b.position(-shift));
    assert!(dot(line, [0.0, 0.0, 1.0]) > 0.5 && (contact.anomaly() - TAU / 3.0).abs() > 0.1);
}
