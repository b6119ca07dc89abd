//! `nply render` as a script calls it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::PathBuf;

use command::{call, command, out};

/// Width, height and bytes of a picture.
fn decoded(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    (info.width, info.height, pixels)
}

const YARN: [&str; 6] = ["render", "examples/three-ply-yarn.toml", "--width", "96", "--lay-lengths", "1"];

#[test]
fn a_picture_is_written_whole_and_said_in_a_line() {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("yarn.png");
    let said = out(&[&YARN[..], &["--stripes", "2", "--quiet", "--output", path.to_str().unwrap()]].concat());
    let (width, height, pixels) = decoded(&fs::read(&path).unwrap());
    assert_eq!((width, pixels.len()), (96, 3 * 96 * height as usize));
    assert_eq!(said, format!("Three-ply yarn, state 2 of 3: 96 by {height} pixels\n"));
    // one thread or many, a file or a pipe
    let piped = command(&[&YARN[..], &["--stripes", "2", "--quiet", "--jobs", "1", "--output", "-"]].concat())
        .output()
        .unwrap();
    assert!(piped.status.success() && piped.stderr.is_empty());
    assert_eq!(piped.stdout, fs::read(&path).unwrap());
}

#[test]
fn a_transparent_picture_has_cover() {
    let arguments =
        [&YARN[..], &["--background", "transparent", "--height", "40", "--quiet", "--output", "-"]].concat();
    let (width, height, pixels) = decoded(&command(&arguments).output().unwrap().stdout);
    assert_eq!((width, height, pixels.len()), (96, 40, 4 * 96 * 40));
    let cover: Vec<u8> = pixels.chunks(4).map(|pixel| pixel[3]).collect();
    assert!(cover.contains(&255) && cover.iter().any(|cover| *cover < 120));
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_sentence() {
    for (more, code, part) in [
        (&[][..], 2, "say where to write the picture"),
        (&["--output", "-", "--tilt", "20"], 2, "an angle, such as"),
        (&["--output", "-", "--tilt", "north"], 2, "--tilt"),
        (&["--output", "-", "--width", "3"], 1, "16 to 16384 pixels"),
        (&["--output", "-", "--state", "9"], 1, "there are 3 states"),
    ] {
        let found = call(&[&["render", "examples/three-ply-yarn.toml", "--quiet"], more].concat());
        assert_eq!((found.code, found.out.as_str()), (code, ""), "{more:?}: {}", found.err);
        assert!(found.err.contains(part) && found.err.starts_with("error: "), "{more:?}: {}", found.err);
    }
}
