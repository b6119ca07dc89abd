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

/// Where terms cancel next to straight strands to the last digit: held by their moment and about to lean, roots were missed at 1e-6 rad and
/// rounding was told as states.
#[test]
fn straight_strands_held_to_the_last_digit() {
    let radial = Balance::Radial;
    all_hold(&[
        (332, Balance::Contact, 0.75, Twist::Pretwist(0.0), -0.022_295_127_617_639_278, -2.587_998_846_738_416_3e-22),
        (
            5,
            radial,
            0.75,
            Twist::Pretwist(-3.854_236_290_270_209e-9),
            -1.295_593_135_549_269_4,
            -1.445_338_608_851_328_3e-8,
        ),
        (
            2,
            Balance::Contact,
            0.503_628_375_898_647,
            Twist::Pretwist(-6.426_438_097_636_479e-7),
            -1.007_256_751_797_294,
            -6.473_073_163_851_703e-7,
        ),
        (
            4,
            radial,
            0.337_953_044_686_681_86,
            Twist::StrandTwist(3.950_787_919_627_685e-6),
            0.0,
            5.340_723_225_398_151_5e-6,
        ),
        (12, radial, 0.5, Twist::StrandTwist(-3.906_539_086_724_112_4e-7), 0.0, -2.343_923_452_034_468e-6),
        (
            7,
            Balance::Contact,
            0.621_745_732_414_725_3,
            Twist::Pretwist(-2.018_428_827_161_620_3e-7),
            -0.819_327_631_167_343_1,
            -8.784_646_566_294_176e-7,
        ),
        (
            5,
            radial,
            0.015_753_938_728_704_585,
            Twist::StrandTwist(5.651_604_189_059_719e-5),
            0.0,
            4.451_751_305_666_848e-6,
        ),
    ]);
}

/// Two states as near to each other as to flat rings.
#[test]
fn two_states_next_to_flat_rings() {
    all_hold(&[
        (
            293,
            Balance::Radial,
            0.907_951_198_316_351_8,
            Twist::StrandTwist(0.023_866_733_089_658_254),
            -4.997_644_827_766_816e-40,
            -6.837_104_712_328_088e27,
        ),
        (
            7,
            Balance::Radial,
            0.867_302_502_087_289_8,
            Twist::Pretwist(-31.173_484_711_207_32),
            -1.277_338_867_067_329_2e-34,
            1.940_322_526_108_423_1e34,
        ),
    ]);
}

/// Two strands at 45°, where the branch has a corner.
#[test]
fn at_the_corner_of_two_strands() {
    let contact = Balance::Contact;
    all_hold(&[
        (
            2,
            contact,
            15.737_811_602_909_991,
            Twist::Pretwist(3.519_543_159_456_809_5e-27),
            20.135_277_968_878_466,
            21.549_491_531_251_73,
        ),
        (2, contact, 1.163_674_581_027_419, Twist::Pretwist(-0.0), 0.031_205_293_928_440_084, -1.445_418_856_301_523_8),
        (2, contact, 0.317_390_030_875_375_6, Twist::Pretwist(-0.0), -0.652_647_881_334_691_3, 0.761_565_681_038_378_7),
        (
            2,
            contact,
            0.922_449_974_263_366_5,
            Twist::Pretwist(-8.708_003_065_118_3e-22),
            -0.816_779_076_518_435_2,
            0.597_434_485_854_641_8,
        ),
        (2, contact, 1.062_486_822_209_94, Twist::Pretwist(0.0), -0.050_518_752_075_066_46, -1.363_694_810_298_019_8),
    ]);
}

fn all_hold(cases: &[(u32, Balance, f64, Twist, f64, f64)]) {
    let mut run = Run::new(0);
    for &(strands, balance, stiffness_ratio, twist, force, moment) in cases {
        let case = Case { strands, balance, stiffness_ratio, twist, load: Load { force, moment } };
        let states = solve(&case);
        run.certify(&case, states.as_deref(), states.as_deref());
    }
    let wrong = run.report.made_up.iter().chain(&run.report.complaints);
    assert!(run.report.holds(), "{}\n{}", run.report, wrong.cloned().collect::<Vec<_>>().join("\n"));
    assert_eq!(run.report.plies, cases.len() as u64);
}
