//! Limp strings by virtual work, by the stiff theory under a great force, and by the formula in use.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use nply::Handedness;
use nply::geometry::HelicalAngle;
use nply::mechanics::{ConstantRadius, Ply, Twist, TwistedStrings};

/// Torque times motor angle is force times stroke; tension times string fed in is force times length gained and torque times turns lost.
#[test]
fn the_motor_does_the_work_of_the_load() {
    for strands in [2, 3, 4, 7, 12] {
        let most = TwistedStrings::most_turns(strands).unwrap().rotation();
        for share in [0.05, 0.3, 0.6, 0.8, 0.9, 0.97] {
            let rotation = share * most;
            let at = |rotation| TwistedStrings::new(strands, rotation).unwrap();
            let here = at(rotation);
            let step = 1e-5 * most;
            let slope = (at(rotation + step).contraction() - at(rotation - step).contraction()) / (2.0 * step);
            assert!((here.lever() / slope - 1.0).abs() < 1e-6, "{strands} {share}: {} {slope}", here.lever());
            // the length p(L) = L cos θ of strings turned by a fixed angle, rotation = angle/L
            let length = |l: f64| l * at(rotation / l).extension();
            let fed = (length(1.0 + 1e-5) - length(1.0 - 1e-5)) / 2e-5;
            assert!((f64::from(strands) * here.string_tension() / fed - 1.0).abs() < 1e-6, "{strands} {share}");
        }
    }
}

/// B/(F r²) → 0 makes any strand limp, at the rate of that number.
#[test]
fn stiff_strings_under_a_great_force_are_limp() {
    for strands in [2, 3, 6] {
        let ply = Ply::new(strands, 0.75).unwrap();
        let most = TwistedStrings::most_turns(strands).unwrap().rotation();
        for share in [0.2, 0.7, 0.95] {
            let strings = TwistedStrings::new(strands, share * most).unwrap();
            let error = |force: f64| {
                let angle = strings.contact().angle();
                let state = ply.moment_at(angle, Handedness::Right, Twist::Pretwist(0.0), force).unwrap();
                state.load().moment / force / strings.lever() - 1.0
            };
            let (some, tenth) = (error(1e4), error(1e5));
            assert!(some.abs() < 1e-2 && (some / tenth - 10.0).abs() < 1e-4, "{strands} {share}: {some} {tenth}");
        }
    }
}

/// p = √(L² − θ²r²) and θr²/p (Würtz et al. 2010) for two strings up to 45°; beyond, the strings swell and jam at 50.62°, where the
/// formula goes on to 57.52°.
#[test]
fn the_formula_of_constant_radius_is_exact_for_two_strings_up_to_45_degrees() {
    let formula = ConstantRadius::new(2).unwrap();
    for rotation in [0.01, 0.2, 0.5, 0.7] {
        let strings = TwistedStrings::new(2, rotation).unwrap();
        assert!((strings.extension() - (1.0 - rotation * rotation).sqrt()).abs() < 1e-15);
        assert!((strings.extension() - formula.extension(rotation).unwrap()).abs() < 1e-15);
        assert!((strings.lever() / formula.lever(rotation).unwrap() - 1.0).abs() < 1e-14);
        // each of two strings carries half the load over cos θ
        assert!((2.0 * strings.string_tension() * strings.extension() - 1.0).abs() < 1e-14);
    }
    let most = TwistedStrings::most_turns(2).unwrap();
    assert!((most.contact().angle().degrees() - 50.6229).abs() < 5e-5);
    assert!(most.lever().is_infinite() && most.string_tension().is_infinite());
    let steepest = formula.steepest();
    assert!((steepest.tan() - core::f64::consts::FRAC_PI_2).abs() < 1e-15 && (steepest.degrees() - 57.52).abs() < 5e-3);
    assert!(formula.most_turns() > most.rotation());
    // three strings swell from the first turn on: the formula makes too little of the stroke
    let (strings, formula) = (TwistedStrings::new(3, 0.45).unwrap(), ConstantRadius::new(3).unwrap());
    assert!(strings.extension() < formula.extension(0.45).unwrap());
    assert!(strings.lever() > formula.lever(0.45).unwrap());
    assert_eq!(formula.extension(0.9), None);
}

#[test]
fn turns_that_no_strings_take_are_refused() {
    let most = TwistedStrings::most_turns(3).unwrap().rotation();
    for rotation in [most * (1.0 + 1e-9), -0.1, f64::NAN, f64::INFINITY] {
        assert_eq!(TwistedStrings::new(3, rotation).unwrap_err().quantity, "rotation");
    }
    assert!(TwistedStrings::new(1, 0.1).is_err() && ConstantRadius::new(1).is_err());
    let parallel = TwistedStrings::new(3, 0.0).unwrap();
    assert!(parallel.contraction().abs() + parallel.lever().abs() < 1e-300);
    assert!((parallel.string_tension() - 1.0 / 3.0).abs() < 1e-16);
}

/// The ratio of the two twists, against the balance itself.
#[test]
fn the_ratio_of_twists_is_that_of_a_balanced_ply() {
    use nply::mechanics::{Balance, Load};
    for balance in Balance::BOTH {
        for (strands, gamma) in [(2, 1.0), (2, 0.75), (3, 0.75), (4, 1.0), (7, 0.6), (3, 1.7)] {
            let ply = Ply::with_balance(strands, gamma, balance).unwrap();
            let steepest = ply.steepest_balanced();
            let mut last = 1.0;
            for k in 1..40 {
                let angle = HelicalAngle::new(steepest.radians() * f64::from(k) / 40.0).unwrap();
                let ratio = ply.twist_ratio(angle).unwrap();
                assert!(ratio < last && ratio > 0.0, "{strands} {gamma} {k}");
                last = ratio;
                let state = ply.pretwist_at(angle, Handedness::Left, Load::NONE).unwrap();
                let contact = state.contact();
                let counted = angle.tan() / (contact.radius_ratio() * state.pretwist());
                assert!((counted - ratio).abs() < 1e-12, "{strands} {gamma} {k}: {counted} {ratio}");
                let back = ply.angle_of_twist_ratio(ratio).unwrap();
                assert!((back.radians() - angle.radians()).abs() < 1e-11 * (1.0 + 1.0 / angle.radians()));
            }
            assert_eq!(ply.twist_ratio(steepest), None);
        }
    }
    // 26.366°: the published figure for the stiffness ratio of solid rods
    let rods = Ply::with_balance(2, 0.75, Balance::Radial).unwrap();
    assert!((rods.angle_of_twist_ratio(2.0 / 3.0).unwrap().degrees() - 26.366).abs() < 5e-4);
    for ratio in [0.0, 1.0, -0.3, f64::NAN] {
        assert_eq!(rods.angle_of_twist_ratio(ratio).unwrap_err().quantity, "twist_ratio");
    }
}
