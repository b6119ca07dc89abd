//! All figures on one page.

use core::fmt::Write as _;

use super::Figure;
use crate::plot::Theme;

const INTRODUCTION: &str = "The figures of S. Neukirch and G. H. M. van der Heijden, Geometry and mechanics of uniform n-plies: from engineering ropes to \
biological filaments, Journal of Elasticity 69 (2002) 41–72, worked out anew. Radial balance is the paper's; contact balance counts the contact forces that \
cross from one height to another as well. Where they differ, both are drawn.";

/// One page of HTML that needs no other file.
///
/// ```
/// use nply_sheet::figure::{Figure, html};
/// let figures: Vec<Figure> = ["3", "table2"].into_iter().filter_map(|name| Figure::named(name).ok()?).collect();
/// let page = html(&figures);
/// assert!(page.contains("<svg ") && page.contains("Table II"));
/// ```
#[must_use]
pub fn html(figures: &[Figure]) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <title>Figures of uniform n-plies</title>\n<style>\n\
         body {{ max-width: 62rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 \"DejaVu Sans\", Verdana, sans-serif; color: #222; }}\n\
         figure {{ margin: 3rem 0; }}\nsvg {{ max-width: 100%; height: auto; }}\nfigcaption {{ max-width: 46rem; }}\n\
         nav a {{ margin-right: .8em; }}\n</style>\n</head>\n<body>\n<h1>Figures</h1>\n<p>{INTRODUCTION}</p>\n<nav>"
    );
    for figure in figures {
        let _ = write!(page, "<a href=\"#{}\">{}</a> ", figure.file_name(), figure.heading());
    }
    page += "</nav>\n";
    for figure in figures {
        let _ = writeln!(
            page,
            "<figure id=\"{}\">\n{}\n<figcaption><strong>{}. {}.</strong> {}</figcaption>\n</figure>",
            figure.file_name(),
            figure.svg(Theme::Light),
            figure.heading(),
            escaped(figure.title),
            escaped(&figure.caption)
        );
    }
    page + "</body>\n</html>\n"
}

/// A page of Markdown that shows the pictures beside it; `ending` is theirs, such as `svg`.
///
/// ```
/// use nply_sheet::figure::{Figure, markdown};
/// let figures: Vec<Figure> = Figure::named("table1")?.into_iter().collect();
/// assert!(markdown(&figures, "svg").contains("](table-1.svg)"));
/// # Ok::<(), nply::DomainError>(())
/// ```
#[must_use]
pub fn markdown(figures: &[Figure], ending: &str) -> String {
    let mut page = format!("# Figures\n\n{INTRODUCTION}\n");
    for figure in figures {
        let (heading, title, file) = (figure.heading(), figure.title, figure.file_name());
        let _ = write!(
            page,
            "\n## {heading}. {title}\n\n![{title}]({file}.{ending})\n\n{}\n\nIts numbers: `nply figure {} --csv`\n",
            figure.caption, figure.name
        );
    }
    page
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
