//! Text that comes from anybody, made fit for a picture. Markup is escaped where the SVG is written.

/// Longer texts are cut.
const LONGEST: usize = 160;

/// About the width of one character, in parts of the font size.
const WIDTH: f64 = 0.56;

/// Without what XML cannot hold, not longer than a few lines, and with `$` standing for itself.
pub(super) fn clean(text: &str) -> String {
    cut(text, LONGEST).replace('$', "\\$")
}

/// The same for names in a legend.
pub(super) fn name(text: &str) -> String {
    cut(text, 36).replace('$', "\\$")
}

fn cut(text: &str, longest: usize) -> String {
    let spaced = text.replace(['\n', '\t'], " ");
    let mut kept = spaced.chars().filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}'));
    let mut shown: String = kept.by_ref().take(longest).collect();
    if kept.next().is_some() {
        shown.push('…');
    }
    shown
}

/// The width of a line of text, in pixels, estimated.
pub(super) fn width(text: &str, size: f64) -> f64 {
    text.chars().map(|_| WIDTH * size).sum()
}

/// How many characters fit a width.
pub(super) fn fitting(width: f64, size: u32) -> usize {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small and positive")]
    let count = (width / (WIDTH * f64::from(size))) as usize;
    count.max(1)
}

/// `-21` as `⁻²¹`.
pub(super) fn superscript(number: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        _ => '⁹',
    };
    number.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_stays_a_line() {
        assert_eq!(clean("a\nb\0\u{1b}[31mc"), "a b[31mc");
        assert_eq!(clean(&"x".repeat(500)).chars().count(), LONGEST + 1);
        assert_eq!(superscript(-21), "⁻²¹");
    }
}
