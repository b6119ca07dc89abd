//! The solver on some random plies; `cargo xtask certify` goes on.

use nply::mechanics::{Balance, Load, Twist};
use xtask_certify::case::Case;
use xtask_certify::run::{Run, solve};

#[test]
fn no_root_missed_and_none_extra() {
    let mut run = Run::new(20);
    run.go_on(2000);
    let report = &run.report;
    assert!(report.holds(), "{report}\n{}", report.complaints.join("\n"));
    assert!(report.roots > 4000 && report.closed > 1800, "{report}");
}

/// The verdict itself: a state taken away is missed, one told twice or put elsewhere is noticed.
#[test]
fn a_wrong_list_of_states_is_noticed() {
    let case = Case {
        strands: 3,
        balance: Balance::Contact,
        stiffness_ratio: 0.75,
        twist: Twist::Pretwist(-1.0),
        load: Load::NONE,
    };
    let right = solve(&case).unwrap();
    assert_eq!(right.len(), 2);
    let judged = |states: &[_]| {
        let mut run = Run::new(0);
        run.certify(&case, Some(states), Some(&right));
        run.report.alone
    };
    assert!(judged(&right).holds());
    assert_eq!(judged(&right[1..]).missed, 1);
    assert_eq!(judged(&[right[0], right[0], right[1]]).extra, 1);
    let mut moved = right.clone();
    moved[0].angle = nply::geometry::HelicalAngle::new(right[0].angle.radians() + 1e-11).unwrap();
    assert_eq!(judged(&moved).misplaced, 1);
    let mut mirrored = right.clone();
    mirrored[0].hand = mirrored[0].hand.opposite();
    assert!(!judged(&mirrored).holds());
}

/// Cases in which roots were missed or put into the wrong place: next to flat rings in radial balance without a force, where a moment's
/// share underflows; next to straight strands held by their moment, where rounding hides the root.
#[test]
fn roots_next_to_both_ends_are_found() {
    let mut run = Run::new(0);
    for (strands, balance, stiffness_ratio, twist, force, moment) in [
        (3, Balance::Radial, 0.141_525_562_931_824_8, Twist::Pretwist(0.0), 0.0, 8.237_341_224_180_01e-28),
        (9, Balance::Radial, 0.75, Twist::Pretwist(0.0), 0.0, 1.425_350_519_860_692_6e-30),
        (6, Balance::Radial, 0.75, Twist::StrandTwist(3.449_921e-32), 0.0, -8.523_315_188_467_103e-13),
        (
            3,
            Balance::Radial,
            1.0,
            Twist::Pretwist(1.083_169_810_374_851_8e-12),
            4.044_522_268_382_12e-36,
            3.141_956_268_933_011e-5,
        ),
        (
            6,
            Balance::Radial,
            1.164_072_662_338_387_5,
            Twist::Pretwist(-10_986_791.489_904_571),
            -1.736_963_372_929_834_6,
            -76_736_541.721_259_73,
        ),
        (
            2,
            Balance::Contact,
            0.811_160_382_456_900_3,
            Twist::StrandTwist(2.763_527_125_793_658),
            3.900_131_692_664_623e-8,
            4.483_327_440_577_605,
        ),
        // exactly held: m = n γ r u₃
        (2, Balance::Contact, 0.75, Twist::StrandTwist(1.75), 3.9e-8, 2.625),
        (8, Balance::Radial, 1.25, Twist::StrandTwist(1.75), 0.05, 17.5),
        (3, Balance::Contact, 1.0, Twist::Pretwist(-1.5), 1e-12 - 2.25, -4.5),
    ] {
        let case = Case { strands, balance, stiffness_ratio, twist, load: Load { force, moment } };
        let states = solve(&case);
        run.certify(&case, states.as_deref(), states.as_deref());
    }
    assert!(run.report.holds(), "{}\n{}", run.report, run.report.complaints.join("\n"));
    assert_eq!(run.report.plies, 9);
}
