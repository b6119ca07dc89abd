//! `nply figure` and `nply plot` as a script calls them: files, streams, exit statuses.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "helpers of tests")]

mod command;

use std::fs;
use std::path::PathBuf;

use command::{call, out, root};

/// An empty folder of a test's own.
fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Width and height of a PNG, which stand at the head of its first chunk.
fn size(png: &[u8]) -> (u32, u32) {
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn a_figure_has_its_numbers_beside_it() {
    let folder = folder("figure");
    let file = |name: &str| folder.join(name).display().to_string();
    assert_eq!(out(&["figure", "3", "--output", &file("shift.png")]), "");
    let (width, height) = size(&fs::read(file("shift.png")).unwrap());
    assert_eq!(out(&["figure", "fig 3", "-o", &file("small.png"), "--zoom", "1"]), "");
    let small = size(&fs::read(file("small.png")).unwrap());
    assert!(width.abs_diff(2 * small.0) <= 2 && height.abs_diff(2 * small.1) <= 2 && small.0 > 300);
    let csv = fs::read_to_string(file("shift.csv")).unwrap();
    assert_eq!(csv, out(&["figure", "3", "--csv"]));
    assert!(out(&["figure", "3"]).starts_with("<svg "));
    assert_ne!(out(&["figure", "3"]), out(&["figure", "3", "--dark"]));
    let refused = call(&["figure", "16"]);
    assert!(refused.code == 1 && refused.err.contains("1 to 15"), "{}", refused.err);
    assert_eq!(call(&["figure", "all"]).code, 2);
    assert_eq!(call(&["figure", "3", "--output", "no/such/folder/f.svg"]).code, 3);
}

/// The book's figures are those that the command draws; those drawn by rays are only there.
#[test]
fn the_book_has_the_figures_as_they_are() {
    let book = root().join("docs/figures");
    for name in (1..=15).map(|number| number.to_string()).chain(["table1".into(), "table2".into()]) {
        let file = match name.strip_prefix("table") {
            Some(number) => format!("table-{number}.svg"),
            None => format!("figure-{:0>2}.svg", name),
        };
        let committed = fs::read_to_string(book.join(&file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        if ["2", "4", "12"].contains(&name.as_str()) {
            assert!(committed.contains("data:image/png;base64,"), "{file}");
        } else {
            assert!(committed == out(&["figure", &name]), "{file}: draw it anew by `cargo xtask figures`");
        }
    }
    let page = fs::read_to_string(book.join("README.md")).unwrap();
    assert!(page.contains("](figure-15.svg)") && page.contains("](table-2.svg)"));
}

const YARN: &str = "examples/three-ply-yarn.toml";

#[test]
fn a_plot_is_a_picture_numbers_or_a_preview() {
    let folder = folder("plot");
    let file = |name: &str| folder.join(name).display().to_string();
    let sweep =
        ["plot", YARN, "--sweep", "pretwist=-1..1", "--ask", "helical_angle,interstrand_pressure", "--strands", "2,3"];
    fn with<'a>(sweep: &[&'a str], more: &[&'a str]) -> Vec<&'a str> {
        [sweep, more].concat()
    }
    assert_eq!(out(&with(&sweep, &["--output", &file("a.svg"), "--balance", "both", "--hand", "right", "--dark"])), "");
    let svg = fs::read_to_string(file("a.svg")).unwrap();
    assert!(svg.contains("n = 3, radial") && svg.contains("helical angle (deg)") && !svg.contains("left (S)"));
    assert_eq!(out(&with(&sweep, &["-o", &file("a.png"), "--zoom", "1"])), "");
    assert!(size(&fs::read(file("a.png")).unwrap()).1 > 500);
    assert_eq!(out(&with(&sweep, &["-o", &file("a.csv")])), "");
    let csv = fs::read_to_string(file("a.csv")).unwrap();
    assert!(
        csv.lines().next().unwrap().ends_with("pretwist,pretwist_turns_per_mm,helical_angle_deg,interstrand_pressure"),
        "{csv:.120}"
    );
    assert!(csv.lines().any(|line| line.starts_with("2,contact,-1,")));
    // in a terminal: two panels, within its width, without colours in a pipe
    let text = out(&sweep);
    assert_eq!(text.matches("separated, p₁ < 0").count(), 1);
    assert!(text.lines().all(|line| unicode_width::UnicodeWidthStr::width(line) <= 80), "{text}");
    assert!(!text.contains('\u{1b}') && text.contains("interstrand pressure p₁ (B/r³)"));
}

#[test]
fn what_is_not_understood_is_said() {
    for (sweep, ask, said) in [
        ("pretwst=0..1", "helical_angle", "did you mean `pretwist`?"),
        ("pretwist=0..1", "angle", "no"),
        ("pretwist=0", "helical_angle", "no range"),
    ] {
        let refused = call(&["plot", YARN, "--sweep", sweep, "--ask", ask]);
        assert!(refused.code == 2 && refused.err.contains(said), "{}: {}", refused.code, refused.err);
    }
    assert_eq!(call(&["plot", YARN, "--ask", "helical_angle"]).code, 2);
    assert_eq!(call(&["plot", YARN, "--sweep", "pretwist=0..1", "--ask", "helical_angle", "--strands", "x"]).code, 2);
}

/// What a picture could only leave out is refused: ranges below 0 on an axis of ratios, endings that no picture has, sizes that cannot be drawn.
#[test]
fn what_would_be_left_out_is_refused() {
    let plot = |more: &[&str]| {
        let ply = ["plot", "--strands", "3", "--stiffness-ratio", "0.75", "--pretwist", "-1", "--ask", "helical_angle"];
        command::call(&[&ply[..], more].concat())
    };
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let named = |name: &str| folder.join(name).to_str().expect("a path").to_owned();
    for (more, code, said) in [
        (vec!["--sweep".to_owned(), "force=-3..3".into(), "--log-x".into()], 1, "above 0"),
        (vec!["--sweep".into(), "force=0..3".into(), "--output".into(), named("p.pdf")], 2, "SVG or PNG"),
        (
            vec!["--sweep".into(), "force=0..3".into(), "--zoom".into(), "0".into(), "--output".into(), named("p.png")],
            2,
            "0.1 to 20",
        ),
    ] {
        let more: Vec<&str> = more.iter().map(String::as_str).collect();
        let answer = plot(&more);
        assert_eq!(answer.code, code, "{more:?}: {}", answer.err);
        assert!(answer.err.contains(said), "{more:?}: {}", answer.err);
    }
    assert!(!folder.join("p.pdf").exists() && !folder.join("p.png").exists());
}

/// S and Z are what spinners call the hands, here as everywhere; and a plot of what touches has no row of anything else.
#[test]
fn a_plot_takes_the_letters_of_the_hands() {
    let folder = folder("hands");
    let drawn = |name: &str, more: &[&str]| {
        let file = folder.join(name).display().to_string();
        let plot = ["plot", YARN, "--sweep", "pretwist=-1..1", "--ask", "helical_angle", "--output", &file];
        assert_eq!(out(&plot.iter().chain(more).copied().collect::<Vec<_>>()), "");
        fs::read_to_string(file).unwrap()
    };
    for (letter, word) in [("S", "left"), ("Z", "right"), ("s", "left")] {
        assert_eq!(drawn("letter.csv", &["--hand", letter]), drawn("word.csv", &["--hand", word]));
    }
    let (all, touching) = (drawn("all.csv", &[]), drawn("touching.csv", &["--touching"]));
    assert!(all.contains(",true,") && !touching.contains(",true,") && touching.contains(",false,"));
}

/// Strands twisted to the right wind to the left when they are let go: of right-handed plies that touch there is nothing, and that is said.
/// As with every question, that there is no state is an answer.
#[test]
fn a_plot_of_nothing_says_so() {
    let plot =
        ["plot", "--strands", "3", "--stiffness-ratio", "0.75", "--sweep", "pretwist=1..3", "--ask", "helical_angle"];
    let file = folder("nothing").join("a.csv").display().to_string();
    for more in [&["--hand", "Z"][..], &["--hand", "right", "--output", &file]] {
        let answer = call(&[&plot[..], &["--touching"], more].concat());
        assert_eq!(answer.code, 0, "{}", answer.err);
        let said = "note: nowhere in the range is there a state of right-handed (Z) plies with touching strands";
        assert!(answer.err.starts_with(said) && answer.err.lines().count() == 1, "{}", answer.err);
    }
    assert_eq!(fs::read_to_string(&file).unwrap().lines().count(), 1);
    for more in [&["--touching", "--hand", "S"][..], &["--hand", "Z"]] {
        assert_eq!(call(&[&plot[..], more].concat()).err, "");
    }
}
