//! Formulas on their way through mdBook: an empty element that carries the LaTeX, so that no reader of Markdown on the way can harm it.

use std::collections::{BTreeMap, BTreeSet};

/// A formula's place in a page; `display` for one that stands on its own.
#[must_use]
pub(crate) fn place(latex: &str, display: bool) -> String {
    let element = if display { "div" } else { "span" };
    let digits: String = latex.bytes().map(|byte| format!("{byte:02x}")).collect();
    format!("<{element} data-formula=\"{digits}\"></{element}>")
}

/// A formula that stands in a text: its LaTeX, and whether it stands on its own.
pub type Formula = (String, bool);

/// The formulas whose places stand in a text.
#[must_use]
pub fn formulas(text: &str) -> BTreeSet<Formula> {
    places(text).map(|(_, formula)| formula).collect()
}

/// A page with every formula's HTML in its place.
#[must_use]
pub fn set_formulas(text: &str, html: &BTreeMap<Formula, String>) -> String {
    let mut page = text.to_owned();
    for (place, formula) in places(text) {
        if let Some(html) = html.get(&formula) {
            page = page.replace(&place, html);
        }
    }
    page
}

fn places(text: &str) -> impl Iterator<Item = (String, Formula)> {
    text.match_indices(" data-formula=\"").filter_map(|(at, mark)| {
        let display = match &text[at.checked_sub(4)?..at] {
            "<div" => true,
            "span" => false,
            _ => return None,
        };
        let digits = text[at + mark.len()..].split('"').next()?;
        let bytes: Option<Vec<u8>> = digits
            .as_bytes()
            .chunks(2)
            .map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok())
            .collect();
        let latex = String::from_utf8(bytes?).ok()?;
        Some((place(&latex, display), (latex, display)))
    })
}

/// A text in HTML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_comes_through() {
        let text = format!("a {} b\n\n{}\n", place(r"\frac{x_1}{2}", false), place("φ", true));
        let found = formulas(&text);
        assert_eq!(found, BTreeSet::from([(r"\frac{x_1}{2}".to_owned(), false), ("φ".to_owned(), true)]));
        let html = found.into_iter().map(|formula| (formula.clone(), format!("[{}]", formula.0))).collect();
        assert_eq!(set_formulas(&text, &html), "a [\\frac{x_1}{2}] b\n\n[φ]\n");
    }
}
