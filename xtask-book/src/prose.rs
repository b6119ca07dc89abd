//! Prose: its directives `{{…}}` and its formulas `$…$`, with the line of each; code in backticks stays as it is.

/// What stands in prose.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Part<'a> {
    /// Text as it is.
    Text(&'a str),
    /// A directive's word, what stands after it in one line, and the line it stands in, counted from 0.
    Directive(&'a str, String, usize),
    /// LaTeX between `$` or, on its own, between `$$`; and its line.
    Formula(&'a str, bool, usize),
}

fn begins_a_line(text: &str, at: usize) -> bool {
    text[..at].trim_end_matches([' ', '>']).chars().next_back().is_none_or(|before| before == '\n')
}

/// Cuts prose into its parts; an error has the line, counted from 0.
pub(crate) fn parts(text: &str) -> Result<Vec<Part<'_>>, (usize, String)> {
    let mut parts = Vec::new();
    let (mut kept, mut at) = (0, 0);
    let line = |at: usize| text[..at].matches('\n').count();
    while let Some(found) = text[at..].find(['`', '{', '$', '\\']) {
        let start = at + found;
        let rest = &text[start..];
        let (part, length) = if let Some(after) = rest.strip_prefix('\\') {
            at = start + 1 + after.chars().next().map_or(0, char::len_utf8);
            continue;
        } else if rest.starts_with("```") && begins_a_line(text, start) {
            let why = "a fence whose words have a backtick is none, and its block would be prose";
            return Err((line(start), why.to_owned()));
        } else if rest.starts_with('`') {
            at = start + code(rest);
            continue;
        } else if let Some(inner) = rest.strip_prefix("{{") {
            let end = inner.find("}}").ok_or_else(|| (line(start), "`{{` is not closed".to_owned()))?;
            let words: Vec<&str> = inner[..end].split_whitespace().collect();
            let word = words.first().copied().unwrap_or("");
            (Part::Directive(word, words[words.len().min(1)..].join(" "), line(start)), end + 4)
        } else if let Some((latex, display, length)) = formula(rest) {
            (Part::Formula(latex, display, line(start)), length)
        } else {
            at = start + 1;
            continue;
        };
        if kept < start {
            parts.push(Part::Text(&text[kept..start]));
        }
        parts.push(part);
        at = start + length;
        kept = at;
    }
    if kept < text.len() {
        parts.push(Part::Text(&text[kept..]));
    }
    Ok(parts)
}

/// The length of a span of code, or of the backticks where none closes them.
fn code(text: &str) -> usize {
    let marks = text.bytes().take_while(|&b| b == b'`').count();
    let mut at = marks;
    while let Some(found) = text[at..].find('`') {
        let run = text[at + found..].bytes().take_while(|&b| b == b'`').count();
        at += found + run;
        if run == marks {
            return at;
        }
    }
    marks
}

/// A formula at the start of a text: nothing blank inside its dollars, so that prices and shells' prompts stay.
fn formula(text: &str) -> Option<(&str, bool, usize)> {
    if let Some(inner) = text.strip_prefix("$$") {
        let end = inner.find("$$")?;
        return Some((inner[..end].trim(), true, end + 4));
    }
    let inner = text.strip_prefix('$')?;
    let end = inner.find('$')?;
    let latex = &inner[..end];
    let closed =
        !latex.starts_with(char::is_whitespace) && !latex.ends_with(char::is_whitespace) && !latex.contains("\n\n");
    let ends = !inner[end + 1..].starts_with(|c: char| c.is_ascii_digit());
    (closed && ends && !latex.is_empty()).then_some((latex, false, end + 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directives_and_formulas_are_found_outside_code() {
        let text = "a {{value nply x |\ny | 2}} `{{no}}` $\\rho$ is \\$5 and $ 6 $\n$$\nx\n$$\n";
        assert_eq!(
            parts(text).unwrap(),
            [
                Part::Text("a "),
                Part::Directive("value", "nply x | y | 2".into(), 0),
                Part::Text(" `{{no}}` "),
                Part::Formula("\\rho", false, 1),
                Part::Text(" is \\$5 and $ 6 $\n"),
                Part::Formula("x", true, 2),
                Part::Text("\n"),
            ]
        );
        assert_eq!(parts("a\n{{value").unwrap_err().0, 1);
        assert_eq!(parts("a\n\n```nply caption=\"`x`\"\n").unwrap_err().0, 2);
    }
}
