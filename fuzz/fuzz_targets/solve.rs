//! Any bits as numbers of the theory: states that hold, or a refusal.
#![no_main]

use core::f64::consts::FRAC_PI_2;
use std::time::Duration;

use cpu_time::ProcessTime;
use libfuzzer_sys::fuzz_target;
use nply::geometry::{Contact, HelicalAngle, branches};
use nply::mechanics::{Balance, Equilibrium, Load, Ply, Twist};
use nply::{Handedness, Scale};

/// Below a right angle; within a rounding of it the pitch angle tells.
fn is_open(angle: HelicalAngle) -> bool {
    (0.0..=FRAC_PI_2).contains(&angle.radians()) && angle.pitch_angle() > 0.0
}

fn look_at(state: &Equilibrium) {
    assert!(is_open(state.contact().angle()), "{:?}", state.contact());
    let radius = state.contact().radius_ratio();
    assert!(radius.is_finite() && radius >= 1.0, "{radius}");
    let _ = (state.flexibility(), state.flexibility_as_published(), state.stiffness(), state.stiffness_as_published());
    let _ = (state.energy(), state.strand_resultant(), state.resultant_pressure(), state.interstrand_pressure());
    let _ = (state.angle_slopes(), state.is_fold(), state.is_separated(), state.ply_twist());
}

fn geometry(contact: &Contact) {
    assert!(is_open(contact.angle()), "{contact:?}");
    assert!(contact.radius_ratio() >= 1.0 && contact.radius_ratio().is_finite(), "{contact:?}");
    assert!(contact.curvature() <= 1.0 + 1e-12, "{contact:?}");
    assert!(contact.arclength_shift() >= 0.0, "{contact:?}");
    assert!(!contact.lay_length().is_nan(), "{contact:?}");
}

fuzz_target!(|bytes: &[u8]| {
    let begin = ProcessTime::now();
    solve(bytes);
    assert!(begin.elapsed() < LONGEST, "{:?}", begin.elapsed());
});

/// No answer may take more of the processor.
const LONGEST: Duration = Duration::from_millis(250);

fn solve(bytes: &[u8]) {
    let mut numbers =
        bytes.chunks_exact(8).map(|eight| f64::from_bits(u64::from_le_bytes(eight.try_into().expect("8"))));
    let mut number = || numbers.next().unwrap_or(0.0);
    let head = number().to_bits();
    let strands = match head & 3 {
        0 => ((head >> 8) & 15) as u32,
        1 => ((head >> 8) & 0xfff) as u32,
        2 => (head >> 8) as u32,
        _ => 2 + ((head >> 8) & 3) as u32,
    };
    let balance = if head & 4 == 0 { Balance::Contact } else { Balance::Radial };
    let hand = if head & 8 == 0 { Handedness::Right } else { Handedness::Left };
    let (gamma, twist, force, moment, lay, pressure) = (number(), number(), number(), number(), number(), number());
    let twist = if head & 16 == 0 { Twist::Pretwist(twist) } else { Twist::StrandTwist(twist) };

    let _ = Scale::new(force, moment);
    for contact in [
        Contact::new(strands, lay),
        Contact::from_lay_length(strands, lay),
        Contact::from_lay_ratio(strands, lay),
        Contact::from_radius_ratio(strands, lay),
        HelicalAngle::from_pitch_angle(lay).and_then(|angle| Contact::at_angle(strands, angle)),
    ]
    .into_iter()
    .flatten()
    {
        geometry(&contact);
        let _ = branches(strands, contact.angle(), 3);
    }

    let Ok(mut ply) = Ply::with_balance(strands, gamma, balance) else { return };
    if head & 32 != 0 {
        match ply.with_external_pressure(pressure) {
            Ok(pressed) => ply = pressed,
            Err(_) => return,
        }
    }
    let load = Load { force, moment };
    let _ = ply.straight_holds(twist, load);
    for states in
        [ply.equilibria(twist, load), ply.separation_at_force(twist, force), ply.separation_at_moment(twist, moment)]
            .into_iter()
            .flatten()
    {
        assert!(states.len() <= 64, "{} states", states.len());
        states.iter().for_each(look_at);
    }
    if let Ok(angle) = HelicalAngle::new(lay) {
        for state in [
            ply.moment_at(angle, hand, twist, force),
            ply.force_at(angle, hand, twist, moment),
            ply.pretwist_at(angle, hand, load),
        ]
        .into_iter()
        .flatten()
        {
            look_at(&state);
        }
    }
}
