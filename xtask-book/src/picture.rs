//! Pictures in a page.

use crate::math::escaped;

/// A picture with its caption; where there is one for dark ground too, the page shows what suits it.
pub(crate) fn figure(light: &str, dark: Option<&str>, caption: &str) -> String {
    let alt = escaped(if caption.is_empty() { "Output of the command above" } else { caption });
    let images = match dark {
        Some(dark) if dark == light => format!("<img src=\"{light}\" alt=\"{alt}\" />"),
        Some(dark) => format!(
            "<img class=\"on-light\" src=\"{light}\" alt=\"{alt}\" /><img class=\"on-dark\" src=\"{dark}\" alt=\"{alt}\" />"
        ),
        None => format!("<img class=\"card\" src=\"{light}\" alt=\"{alt}\" />"),
    };
    let caption =
        if caption.is_empty() { String::new() } else { format!("<figcaption>{}</figcaption>", escaped(caption)) };
    format!("<figure>{images}{caption}</figure>\n")
}

/// The way from a chapter to the folder of made files.
pub(crate) fn to_made(chapter: &str) -> String {
    format!("{}made/", "../".repeat(chapter.matches('/').count()))
}
