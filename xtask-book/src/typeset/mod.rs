//! Formulas written in Unicode, as they stand in the equations' texts, set in LaTeX.
//!
//! A block is one or more lines. A line's columns stand three or more blanks apart, its number at its end; a line that begins with an operator goes on with the one above; one that
//! ends with a colon and has no equals sign is prose. Matrices are drawn with ⎛ ⎜ ⎝.

mod letter;
mod matrix;
mod term;

/// Rows below each other, with room between those that have quotients.
fn stacked(rows: &[String], room: &str) -> String {
    let is_tall = rows.iter().any(|row| row.contains(r"\frac"));
    rows.join(&format!(r"\\[{}]", if is_tall { room } else { "0.2em" }))
}

/// A part of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Block {
    /// LaTeX that stands on its own.
    Formula(String),
    /// A line of words.
    Prose(String),
}

/// A line of a formula.
struct Row {
    latex: String,
    number: Option<String>,
}

/// The parts of a block of formulas; the number, where it is given, stands at the right of the first.
pub(crate) fn set(text: &str, number: Option<&str>) -> Result<Vec<Block>, String> {
    let mut blocks = Vec::new();
    let mut number = number;
    for part in parts(text) {
        match part {
            Part::Prose(line) => blocks.push(Block::Prose(line.to_owned())),
            Part::Lines(lines) => {
                let rows = rows(&lines)?;
                let own = rows.iter().any(|row| row.number.is_some());
                let number = number.take().filter(|_| !own);
                blocks.push(Block::Formula(together(&rows, number)));
            }
        }
    }
    Ok(blocks)
}

enum Part<'a> {
    Prose(&'a str),
    Lines(Vec<&'a str>),
}

/// Blank lines and prose part a block, but not from a line that goes on.
fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut lines: Vec<&str> = Vec::new();
    let mut is_parted = false;
    for line in text.lines() {
        let bare = line.trim();
        if bare.is_empty() {
            is_parted = true;
            continue;
        }
        let is_prose = bare.ends_with(':') && !bare.contains('=');
        if !lines.is_empty() && (is_prose || (is_parted && !goes_on(line))) {
            parts.push(Part::Lines(std::mem::take(&mut lines)));
        }
        is_parted = false;
        if is_prose { parts.push(Part::Prose(bare)) } else { lines.push(line) }
    }
    if !lines.is_empty() {
        parts.push(Part::Lines(lines));
    }
    parts
}

/// Whether a line goes on with the one above.
fn goes_on(line: &str) -> bool {
    line.starts_with(' ') && line.trim_start().starts_with(['=', '+', '−', '·', '<', '≤'])
}

fn rows(lines: &[&str]) -> Result<Vec<Row>, String> {
    let mut rows = Vec::new();
    let mut at = 0;
    while at < lines.len() {
        let drawn = lines[at..].iter().take_while(|line| matrix::is_drawn_in(line)).count();
        if drawn > 0 {
            rows.push(Row { latex: matrix::latex(&lines[at..at + drawn], |text| columns(text, false))?, number: None });
            at += drawn;
            continue;
        }
        let (line, number) = numbered(lines[at]);
        let is_first = rows.is_empty();
        let latex = columns(line.trim(), lines.len() > 1)?;
        let goes_on = !is_first && goes_on(line);
        let hangs = goes_on && !latex.starts_with('&');
        let latex = if hangs { format!(r"&\quad {}", latex.replacen('&', "", 1)) } else { latex };
        rows.push(Row { latex, number });
        at += 1;
    }
    Ok(rows)
}

/// A line without the number at its end, and the number.
fn numbered(line: &str) -> (&str, Option<String>) {
    let line = line.trim_end();
    let found = line.strip_suffix(')').and_then(|rest| rest.rsplit_once("   (").or_else(|| rest.rsplit_once("  (")));
    match found {
        Some((rest, number)) if number.trim_start_matches("A.").bytes().all(|b| b.is_ascii_digit()) => {
            (rest, Some(number.to_owned()))
        }
        _ => (line, None),
    }
}

/// A line's columns, side by side; the first equals sign is where lines are aligned.
fn columns(line: &str, aligned: bool) -> Result<String, String> {
    let mut latex = String::new();
    let mut is_aligned = false;
    for column in line.split("   ").map(str::trim).filter(|column| !column.is_empty()) {
        let is_words = begins_with_word(column);
        let set = match column.strip_suffix(':') {
            Some(label) if is_words => format!(r"\text{{{label}:}}"),
            _ => term::latex(column, aligned && !is_aligned)?,
        };
        if !latex.is_empty() {
            latex.push_str(match (is_words, aligned && is_aligned) {
                (true, true) => r"&&\quad ",
                (true, false) => r"\quad ",
                (false, _) if latex.ends_with(r",\; ") || latex.ends_with(":}") => r"\qquad ",
                // blanks that only bring signs of two lines below each other
                (false, _) => "",
            });
        }
        is_aligned |= set.contains('&');
        latex.push_str(&set);
    }
    Ok(latex)
}

/// Whether a column is said in words, in brackets or not.
fn begins_with_word(column: &str) -> bool {
    let word = column.trim_start_matches('(').split(' ').next().unwrap_or("").trim_end_matches(':');
    word.len() > 1 && word.bytes().all(|b| b.is_ascii_lowercase()) && !letter::is_function(word)
}

/// Rows below each other.
fn together(rows: &[Row], number: Option<&str>) -> String {
    let tag = number.map_or_else(String::new, |number| format!(r" \tag{{{number}}}"));
    match rows {
        [row] => {
            let own = row.number.as_ref().map_or(tag, |number| format!(r" \tag{{{number}}}"));
            format!("{}{own}", row.latex)
        }
        _ if rows.iter().any(|row| row.number.is_some()) => {
            let lines: Vec<String> = rows
                .iter()
                .map(|row| match &row.number {
                    Some(number) => format!(r"{} \tag{{{number}}}", row.latex),
                    None => format!(r"{} \notag", row.latex),
                })
                .collect();
            format!(r"\begin{{align}}{}\end{{align}}", stacked(&lines, "0.9em"))
        }
        _ => {
            let lines: Vec<String> = rows.iter().map(|row| row.latex.clone()).collect();
            format!(r"\begin{{aligned}}{}\end{{aligned}}{tag}", stacked(&lines, "0.9em"))
        }
    }
}

/// Prose whose indices and powers are written `F_ψ`, `W_r^{α+}`, with them below and above the line.
pub(crate) fn prose(text: &str) -> String {
    let mut page = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['_', '^', '`']) {
        let (before, after) = rest.split_at(at);
        page.push_str(before);
        let (sign, behind) = after.split_at(1);
        // code stays as it is
        if let (true, Some(end)) = (sign == "`", behind.find('`')) {
            page.push_str(&after[..end + 2]);
            rest = &behind[end + 1..];
            continue;
        }
        let braced = behind.strip_prefix('{').and_then(|inner| inner.split_once('}'));
        let (hung, next) = braced.unwrap_or_else(|| behind.split_at(term::plain_length(behind)));
        let hangs = sign != "`" && !hung.is_empty() && page.ends_with(|c: char| !c.is_whitespace());
        if hangs {
            let element = if sign == "_" { "sub" } else { "sup" };
            page.push_str(&format!("<{element}>{hung}</{element}>"));
            rest = next;
        } else {
            page.push_str(sign);
            rest = behind;
        }
    }
    page.push_str(rest);
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formulas(text: &str, number: Option<&str>) -> Vec<String> {
        set(text, number)
            .unwrap()
            .into_iter()
            .map(|block| match block {
                Block::Formula(latex) => latex.replace(' ', ""),
                Block::Prose(text) => format!("# {text}"),
            })
            .collect()
    }

    #[test]
    fn columns_stand_apart_and_the_number_at_the_right() {
        assert_eq!(formulas("x = 1,     y = 2", Some("7")), [r"x=1,\;\qquady=2\tag{7}"]);
    }

    #[test]
    fn a_line_that_goes_on_hangs_below() {
        let text = "a = b\n    + c     (56)\n\n  = d";
        assert_eq!(
            formulas(text, None),
            [r"\begin{align}a&=b\notag\\[0.2em]&\quad+c\tag{56}\\[0.2em]&=d\notag\end{align}"]
        );
        assert_eq!(formulas("a = b\n\nc = d", Some("1")), [r"a=b\tag{1}", "c=d"]);
    }

    #[test]
    fn prose_stays_prose() {
        assert_eq!(formulas("radial balance:\n    a = 1     (34)", None), ["# radial balance:", r"a=1\tag{34}"]);
        assert_eq!(
            formulas("radial balance:    a = 1\ncontact balance:   a = 2", None),
            [r"\begin{aligned}\text{radialbalance:}\qquada&=1\\[0.2em]\text{contactbalance:}\qquada&=2\end{aligned}"]
        );
        assert_eq!(
            formulas("q = 1        most turns\nq = 2        most twist", None),
            [
                r"\begin{aligned}q&=1&&\quad\text{most}\\text{turns}\\[0.2em]q&=2&&\quad\text{most}\\text{twist}\end{aligned}"
            ]
        );
    }

    #[test]
    fn a_number_in_the_line_is_no_number_of_the_line() {
        assert_eq!(formulas("p = q,     q from (37)", None), [r"p=q,\;\qquadq\\text{from}\(37)"]);
    }

    #[test]
    fn indices_in_prose_hang() {
        assert_eq!(
            prose("F_ψ = M₀, `a_b`, W_r^{α+} and _so_ C_ply."),
            "F<sub>ψ</sub> = M₀, `a_b`, W<sub>r</sub><sup>α+</sup> and _so_ C<sub>ply</sub>."
        );
    }

    #[test]
    fn matrices_are_drawn() {
        let text = "      ⎛ a   −b ⎞\n𝓡  =  ⎜ c    d ⎟ ,     x = 1\n      ⎝ 0    1 ⎠";
        assert_eq!(
            formulas(text, Some("3")),
            [r"\mathcal{R}=\begin{pmatrix}a&-b\\[0.2em]c&d\\[0.2em]0&1\end{pmatrix},\;\qquadx=1\tag{3}"]
        );
    }
}
