//! Pictures show what is in front, as large as it is.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use nply_sheet::Spec;
use nply_sheet::mesh::{Assembly, Subject, Wanted};
use nply_sheet::render::{Ground, Picture, RenderError, View};

fn assembly(flags: &[(&str, &str)], wanted: &Wanted<'_>) -> Assembly {
    let ply = Subject::of(&Spec::from_flags(flags.iter().copied()).unwrap(), None).unwrap();
    Assembly::of(&ply, wanted).unwrap()
}

/// From the side, its axis across: right, up and the eye are z, x and y.
fn side(width: u32) -> View {
    View { width, tilt: 0.0, ground: Ground::Transparent, shadow: false, ..View::default() }
}

/// The wire that is in front where a line of sight from the side meets the ply, by small steps and every tube's distance; none beside it,
/// nothing where it is a near thing.
fn in_front(assembly: &Assembly, z: f64, x: f64) -> Option<Option<usize>> {
    const STEP: f64 = 0.05;
    let [low, high] = assembly.heights();
    if !(low..high).contains(&z) {
        return Some(None);
    }
    let mut y = assembly.reach() + STEP;
    let mut closest = f64::MAX;
    while y > -assembly.reach() {
        let off: Vec<f64> = assembly.wires.iter().map(|wire| wire.tube.distance([x, y, z])).collect();
        if let Some(wire) = off.iter().position(|off| *off < 0.0) {
            return (closest > 0.0).then_some(Some(wire));
        }
        closest = off.iter().fold(closest, |least, off| least.min(*off));
        y -= STEP;
    }
    (closest > 0.05).then_some(None)
}

#[test]
fn what_is_in_front_is_shown() {
    for (flags, core) in [
        (&[("strands", "3"), ("helical-angle", "25 deg")][..], None),
        (&[("strands", "2"), ("helical-angle", "60 deg"), ("hand", "left")], None),
        (&[("strands", "4"), ("lay-length", "30"), ("hand", "S")], Some("")),
    ] {
        let mut assembly = assembly(flags, &Wanted { length: Some("16"), core, ..Wanted::default() });
        // colours that no light can confuse
        let plain = [[200, 0, 0], [0, 200, 0], [0, 0, 200], [200, 200, 0], [200, 0, 200]];
        assembly.wires.iter_mut().zip(plain).for_each(|(wire, colour)| wire.colour = colour);
        let view = side(56);
        let picture = Picture::of(&[(&assembly, [0.0; 3])], view).unwrap();
        let pixel = (16.0 + 2.4) / 56.0;
        let (mut right, mut wrong) = (0, 0);
        for row in 0..picture.height() {
            for (column, [red, green, blue, cover]) in picture.row(row).into_iter().enumerate() {
                let z = (column as f64 + 0.5 - 28.0) * pixel + 8.0;
                let x = (0.5 * f64::from(picture.height()) - f64::from(row) - 0.5) * pixel;
                // the same everywhere in and next to the pixel
                let around = [[0.0, 0.0], [0.6, 0.6], [-0.6, 0.6], [0.6, -0.6], [-0.6, -0.6]];
                let found: Vec<_> =
                    around.iter().map(|[a, b]| in_front(&assembly, z + a * pixel, x + b * pixel)).collect();
                let Some(wire) = found[0].filter(|_| found.iter().all(|other| *other == found[0])) else { continue };
                let agrees = match wire {
                    None => cover == 0,
                    // the hue that fits best, whatever the light
                    Some(wire) => {
                        let size = |c: [f64; 3]| c.iter().map(|x| x * x).sum::<f64>().sqrt();
                        // less what is white in it: gloss
                        let white = red.min(green).min(blue);
                        let seen = [red, green, blue].map(|x| f64::from(x - white));
                        let fit = |colour: [u8; 3]| {
                            let colour = colour.map(f64::from);
                            let dot: f64 = colour.iter().zip(&seen).map(|(a, b)| a * b).sum();
                            dot / size(colour)
                        };
                        let best = (0..assembly.wires.len())
                            .max_by(|a, b| fit(assembly.wires[*a].colour).total_cmp(&fit(assembly.wires[*b].colour)));
                        cover == 255 && best == Some(wire)
                    }
                };
                if agrees { right += 1 } else { wrong += 1 }
            }
        }
        // a highlight is nearly white, a deep shadow nearly black
        assert!(right > 250 && wrong * 50 < right, "{flags:?}: {right} right, {wrong} wrong");
    }
}

/// Straight strands side by side: a rectangle of 4r by their length.
#[test]
fn it_is_as_large_as_it_is() {
    let straight =
        assembly(&[("strands", "2"), ("helical-angle", "0 deg")], &Wanted { length: Some("20"), ..Wanted::default() });
    for turn in [0.0_f64, 0.4, 1.3] {
        let picture = Picture::of(&[(&straight, [0.0; 3])], View { turn, ..side(200) }).unwrap();
        let cover: f64 = (0..picture.height()).flat_map(|row| picture.row(row)).map(|p| f64::from(p[3]) / 255.0).sum();
        let pixel = 22.4 / 200.0;
        // centrelines 2 apart, seen at an angle; strand 1 stands at −y
        let across = 2.0 + 2.0 * libm::sin(turn).abs();
        let area = cover * pixel * pixel;
        assert!((area / (20.0 * across) - 1.0).abs() < 0.01, "{turn}: {area} {across}");
    }
}

#[test]
fn a_row_is_the_same_whoever_asks() {
    let wanted = Wanted { stripes: 2, lay_lengths: Some(0.5), ..Wanted::default() };
    let ply = assembly(&[("strands", "3"), ("helical-angle", "40 deg")], &wanted);
    for ground in [Ground::Light, Ground::Dark, Ground::Transparent] {
        let picture = || Picture::of(&[(&ply, [0.0; 3])], View { width: 48, ground, ..View::default() }).unwrap();
        let (one, other) = (picture(), picture());
        let forth: Vec<_> = (0..one.height()).map(|row| one.row(row)).collect();
        let mut back: Vec<_> = (0..other.height()).rev().map(|row| other.row(row)).collect();
        back.reverse();
        assert_eq!(forth, back);
        assert!(ground == Ground::Transparent || forth.iter().flatten().all(|pixel| pixel[3] == 255));
    }
}

#[test]
fn a_picture_without_size_or_angle_is_refused() {
    let ply = assembly(&[("strands", "3"), ("helical-angle", "40 deg")], &Wanted::default());
    let of = |view| Picture::of(&[(&ply, [0.0; 3])], view).err();
    assert!(matches!(of(View { width: 3, ..View::default() }), Some(RenderError::Size { .. })));
    assert!(matches!(of(View { height: Some(100_000), ..View::default() }), Some(RenderError::Size { .. })));
    assert_eq!(of(View { tilt: f64::NAN, ..View::default() }), Some(RenderError::Angle));
    assert_eq!(Picture::of(&[], View::default()).err(), Some(RenderError::Empty));
}

/// Along its axis a strand whose wires wind on by more than their spacing can nowhere be seen through beside its core, however near to it.
#[test]
fn no_light_falls_through_along_a_core() {
    const WIDTH: u32 = 240;
    let flags = [("strands", "6"), ("lay-length", "80")];
    let strand = assembly(&flags, &Wanted { lay_lengths: Some(0.2), core: Some(""), ..Wanted::default() });
    let view = View { tilt: core::f64::consts::FRAC_PI_2, ..side(WIDTH) };
    let picture = Picture::of(&[(&strand, [0.0; 3])], view).unwrap();
    let pixel = 2.0 * (strand.reach() + 1.2) / f64::from(WIDTH);
    // the core's radius is about that of a wire
    for row in 0..picture.height() {
        for (column, [.., cover]) in picture.row(row).into_iter().enumerate() {
            let [right, up] = [column as f64, f64::from(row)].map(|at| (at + 0.5 - 0.5 * f64::from(WIDTH)) * pixel);
            let from_axis = f64::sqrt(right * right + up * up);
            assert!(from_axis > 1.2 || cover == 255, "{from_axis} from the axis: {cover}");
        }
    }
}
