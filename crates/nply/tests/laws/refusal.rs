//! Broken premises are refused by name, whatever the bits; nothing panics.

use nply::geometry::{Contact, HelicalAngle, Section, branches};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::{DomainError, Handedness, Scale};
use proptest::prelude::*;

use crate::config;

/// Any double by its bits, the special ones often.
fn bits() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => any::<u64>().prop_map(f64::from_bits),
        3 => -10.0..10.0_f64,
        1 => prop_oneof![
            Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(0.0), Just(-0.0), Just(f64::MAX), Just(f64::MIN),
            Just(f64::MIN_POSITIVE), Just(5e-324), Just(-5e-324), Just(std::f64::consts::FRAC_PI_2), Just(1e300), Just(1e154)
        ],
    ]
}

/// An error that names `quantity` if `refused`, and says so with its value; else none.
fn named<T>(result: Result<T, DomainError>, refused: bool, quantity: &str, value: f64) -> Result<(), TestCaseError> {
    match result {
        Ok(_) => prop_assert!(!refused, "{quantity} = {value} was accepted"),
        Err(error) => {
            prop_assert!(refused, "{error}");
            prop_assert_eq!(error.quantity, quantity);
            prop_assert!(error.value == value || error.value.is_nan() && value.is_nan());
            prop_assert!(error.to_string().contains(quantity) && error.to_string().contains(error.allowed));
        }
    }
    Ok(())
}

fn proper(states: &[Equilibrium]) -> Result<(), TestCaseError> {
    for state in states {
        let theta = state.contact().helical_angle();
        prop_assert!((0.0..=std::f64::consts::FRAC_PI_2).contains(&theta), "{state:?}");
        prop_assert!(state.contact().radius_ratio().is_finite(), "{state:?}");
        // nothing asked of it panics
        let _ =
            (state.energy(), state.flexibility(), state.stiffness(), state.strand_resultant(), state.is_separated());
        let _ = (state.flexibility_as_published(), state.stiffness_as_published(), state.resultant_pressure());
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(3000))]

    #[test]
    fn angles_and_contacts(v in bits(), n in prop_oneof![Just(0), Just(1), Just(2), 2..50_u32, any::<u32>()]) {
        let half = std::f64::consts::FRAC_PI_2;
        named(HelicalAngle::new(v), !(0.0..=half).contains(&v), "helical_angle", v)?;
        named(HelicalAngle::from_pitch_angle(v), !(1e-150..=half).contains(&v), "pitch_angle", v)?;
        let angle = HelicalAngle::new(0.3).unwrap();
        named(Contact::at_angle(n, angle), n < 2, "strands", f64::from(n))?;
        named(branches(n, angle, 5), n < 2, "strands", f64::from(n))?;
        named(Section::non_convex_angle(n), n < 2, "strands", f64::from(n))?;
        if n >= 2 {
            let nf = f64::from(n);
            named(Contact::new(n, v), !(0.0..=half).contains(&v), "helical_angle", v)?;
            named(Contact::from_lay_length(n, v), !(v > 2.0 * nf && v <= 1e140), "lay_length", v)?;
            named(Contact::from_lay_ratio(n, v), !(1e-140..=1e140).contains(&v), "lay_ratio", v)?;
            let straight = 1.0 / (std::f64::consts::PI / nf).sin();
            let reached = if n == 2 { v > 1.0 } else { v >= straight };
            prop_assume!((v - straight).abs() > 1e-14 * straight || n == 2);
            named(Contact::from_radius_ratio(n, v), !(reached && v <= 1e140), "radius_ratio", v)?;
        }
    }

    #[test]
    fn plies(n in prop_oneof![Just(0), Just(1), 2..=12_u32], v in bits(), r in bits()) {
        for balance in Balance::BOTH {
            named(Ply::with_balance(n, 0.75, balance), n < 2, "strands", f64::from(n))?;
            named(Ply::with_balance(3, v, balance), !(v > 0.0 && v < f64::INFINITY), "stiffness_ratio", v)?;
            let refused = if balance == Balance::Radial { v != 0.0 } else { !v.is_finite() };
            named(Ply::with_balance(3, 0.75, balance).unwrap().with_external_pressure(v), refused, "external_pressure", v)?;
        }
        let positive = |v: f64| v > 0.0 && v < f64::INFINITY;
        named(Scale::new(v, 1.0), !positive(v), "strand_radius", v)?;
        named(Scale::new(1.0, r), !positive(r), "bending_stiffness", r)?;
    }
}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn solves(n in 2..=12_u32, gamma in bits(), twist in bits(), force in bits(), moment in bits(), by_strand in any::<bool>(), radial in any::<bool>(), theta in 0.0..1.57_f64) {
        let gamma = if gamma.abs() > 0.0 && gamma.is_finite() { gamma.abs() } else { 0.75 };
        let balance = if radial { Balance::Radial } else { Balance::Contact };
        let ply = Ply::with_balance(n, gamma, balance).unwrap();
        let (given, name) =
            if by_strand { (Twist::StrandTwist(twist), "strand_twist") } else { (Twist::Pretwist(twist), "pretwist") };
        let load = Load { force, moment };
        let (no_twist, no_force, no_moment) = (!(twist * gamma).is_finite(), !force.is_finite(), !moment.is_finite());
        let (quantity, value) = if no_twist { (name, twist) } else if no_force { ("force", force) } else { ("moment", moment) };
        let states = ply.equilibria(given, load);
        if let Ok(states) = &states {
            proper(states)?;
        }
        named(states, no_twist || no_force || no_moment, quantity, value)?;
        let (quantity, value) = if no_twist { (name, twist) } else { ("force", force) };
        let states = ply.separation_at_force(given, force);
        if let Ok(states) = &states {
            proper(states)?;
        }
        named(states, no_twist || no_force, quantity, value)?;
        let (quantity, value) = if no_twist { (name, twist) } else { ("moment", moment) };
        named(ply.separation_at_moment(given, moment), no_twist || no_moment, quantity, value)?;
        // found data may overflow: then they are named; nothing panics
        let angle = HelicalAngle::new(theta).unwrap();
        let hand = Handedness::Left;
        for result in [
            ply.moment_at(angle, hand, given, force),
            ply.force_at(angle, hand, given, moment),
            ply.pretwist_at(angle, hand, load),
        ] {
            match result {
                Ok(state) => proper(&[state])?,
                Err(error) => prop_assert!(
                    ["pretwist", "strand_twist", "force", "moment", "helical_angle"].contains(&error.quantity), "{error}"
                ),
            }
        }
        let _ = ply.straight_holds(given, load);
    }
}

/// States whose pitch angle is about f, or about 1/φ̄a: what is reported is a number, what is flatter than 1e-150 rad is left out.
#[test]
fn the_flattest_rings_are_numbers() {
    for (pretwist, force) in [(1.0, 1e-300), (1e100, 1e-150), (1e160, 1.0)] {
        for state in
            Ply::new(2, 1.0).unwrap().equilibria(Twist::Pretwist(pretwist), Load { force, moment: 0.0 }).unwrap()
        {
            assert!(state.contact().angle().cos() > 0.0 && state.contact().radius_ratio().is_finite(), "{state:?}");
        }
    }
}

/// Without loads strands of γ = 1 part at p = 0 for every angle at once when their pretwist is nothing or next to it: no angle stands
/// out, and none may be made up by rounding.
#[test]
fn where_everything_parts_no_state_stands_out() {
    for pretwist in [0.0, 1.357e-312, 1e-30] {
        for n in [2, 3, 7] {
            let ply = Ply::new(n, 1.0).unwrap();
            let states = ply.separation_at_force(Twist::Pretwist(pretwist), 0.0).unwrap();
            assert!(states.len() <= 1, "{n} {pretwist}: {} states", states.len());
        }
    }
}
