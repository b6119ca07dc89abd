//! All figures together.

use nply_sheet::figure::{Figure, html, markdown};
use nply_sheet::plot::Theme;

/// Those whose pictures are quickly drawn.
fn drawn() -> Vec<Figure> {
    let slow = ["2", "4", "12"];
    Figure::names().filter(|name| !slow.contains(name)).map(|name| Figure::named(name).unwrap().unwrap()).collect()
}

#[test]
fn every_figure_has_numbers_and_a_caption() {
    assert_eq!(Figure::names().count(), 17);
    for name in Figure::names() {
        let figure = Figure::named(name).unwrap().unwrap();
        assert!(figure.caption.len() > 80 && figure.caption.ends_with('.'), "{name}");
        let csv = figure.csv();
        let columns = csv.lines().next().unwrap().split(',').count();
        assert!(csv.lines().count() > 3, "{name}");
        for line in csv.lines() {
            // words with commas stand in quotation marks
            let commas = line.split('"').step_by(2).map(|part| part.matches(',').count()).sum::<usize>();
            assert_eq!(commas + 1, columns, "{name}: {line}");
            assert!(!line.contains("NaN") && !line.contains("inf"), "{name}: {line}");
        }
    }
    assert!(Figure::named("16").unwrap().is_none());
}

#[test]
fn pictures_are_whole_on_either_ground() {
    for figure in drawn() {
        let [light, dark] = [Theme::Light, Theme::Dark].map(|theme| figure.svg(theme));
        for svg in [&light, &dark] {
            assert!(svg.starts_with("<svg ") && svg.trim_end().ends_with("</svg>"), "{}", figure.name);
            assert!(!svg.contains("NaN") && !svg.contains("inf\""), "{}", figure.name);
            assert!(svg.len() < 150_000, "{}: {}", figure.name, svg.len());
        }
        assert_ne!(light, dark);
    }
}

#[test]
fn the_gallery_shows_each() {
    let figures = drawn();
    let (page, text) = (html(&figures), markdown(&figures, "svg"));
    for figure in &figures {
        assert!(page.contains(&format!("id=\"{}\"", figure.file_name())), "{}", figure.name);
        assert!(text.contains(&format!("]({}.svg)", figure.file_name())), "{}", figure.name);
    }
    assert_eq!(page.matches("<svg ").count(), figures.len());
}

/// The book's page is the one that the recipe writes.
#[test]
fn the_book_says_what_the_captions_say() {
    let figures: Vec<Figure> = Figure::names().map(|name| Figure::named(name).unwrap().unwrap()).collect();
    let page = include_str!("../../../../docs/figures/README.md");
    assert!(markdown(&figures, "svg") == page, "draw the figures anew by `cargo xtask figures`");
}
