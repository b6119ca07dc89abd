//! A chapter as it is read: prose, and fenced blocks of code, each with its line.

/// A piece of a chapter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Piece<'a> {
    /// Markdown between fenced blocks, line ends included.
    Prose {
        /// First line, counted from 1.
        line: usize,
        /// The text.
        text: &'a str,
    },
    /// A fenced block.
    Fence {
        /// The line of its opening fence, counted from 1.
        line: usize,
        /// What stands before the fence: blanks, or the `> ` of a quotation.
        indent: &'a str,
        /// The words after the fence.
        info: &'a str,
        /// The whole block as it stands, fences included.
        whole: &'a str,
        /// Its lines, without the indent.
        lines: Vec<&'a str>,
    },
}

/// A fenced block whose end is not seen yet.
struct Open<'a> {
    start: usize,
    line: usize,
    indent: &'a str,
    marks: &'a str,
    info: &'a str,
    lines: Vec<&'a str>,
}

impl<'a> Open<'a> {
    /// The block that a line opens, if it opens one.
    fn at(start: usize, line: usize, text: &'a str) -> Option<Self> {
        let inner = text.trim_start_matches([' ', '>']);
        let (marks, info) = inner.split_at(inner.bytes().take_while(|&b| b == b'`').count());
        let indent = &text[..text.len() - inner.len()];
        (marks.len() >= 3 && !info.contains('`')).then(|| Self {
            start,
            line,
            indent,
            marks,
            info: info.trim(),
            lines: Vec::new(),
        })
    }

    /// Whether a line closes the block.
    fn closes(&self, inner: &str) -> bool {
        inner.starts_with(self.marks) && inner.trim_end().bytes().all(|b| b == b'`')
    }

    fn piece(self, text: &'a str) -> Piece<'a> {
        Piece::Fence {
            line: self.line,
            indent: self.indent,
            info: self.info,
            whole: &text[self.start..],
            lines: self.lines,
        }
    }
}

/// Cuts a chapter into its pieces; put together again they are the chapter.
pub(crate) fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let (mut at, mut prose_at, mut prose_line) = (0, 0, 1);
    let mut open: Option<Open<'_>> = None;
    for (line, whole_line) in (1..).zip(text.split_inclusive('\n')) {
        let bare = whole_line.trim_end_matches(['\n', '\r']);
        let end = at + whole_line.len();
        if let Some(mut block) = open.take() {
            let inner = bare.strip_prefix(block.indent).unwrap_or_else(|| bare.trim_start());
            if block.closes(inner) {
                pieces.push(block.piece(&text[..end]));
                (prose_at, prose_line) = (end, line + 1);
            } else {
                block.lines.push(inner);
                open = Some(block);
            }
        } else if let Some(block) = Open::at(at, line, bare) {
            if prose_at < at {
                pieces.push(Piece::Prose { line: prose_line, text: &text[prose_at..at] });
            }
            open = Some(block);
        }
        at = end;
    }
    // an open fence runs to the end, as Markdown has it
    match open {
        Some(block) => pieces.push(block.piece(text)),
        None if prose_at < text.len() => pieces.push(Piece::Prose { line: prose_line, text: &text[prose_at..] }),
        None => {}
    }
    pieces
}

/// A fenced block that holds any text: its fence is longer than any run of backticks in it.
pub(crate) fn fenced(info: &str, body: &str) -> String {
    let longest = body.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let marks = "`".repeat(longest.max(2) + 1);
    format!("{marks}{info}\n{}\n{marks}\n", body.trim_end_matches('\n'))
}

/// Every line of a text behind an indent.
pub(crate) fn indented(text: &str, indent: &str) -> String {
    if indent.is_empty() {
        return text.to_owned();
    }
    text.split_inclusive('\n').map(|line| format!("{indent}{line}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_carry_their_lines_and_make_the_chapter() {
        let text = "# A\n\n- one\n  ```nply hide\n  nply lays\n\n  ```\nafter `x` and ``y``\n````text\n```\n````\nend";
        let pieces = pieces(text);
        let again: String = pieces
            .iter()
            .map(|piece| match piece {
                Piece::Prose { text, .. } => *text,
                Piece::Fence { whole, .. } => *whole,
            })
            .collect();
        assert_eq!(again, text);
        let Piece::Fence { line, indent, info, lines, .. } = &pieces[1] else { panic!("{pieces:?}") };
        assert_eq!((*line, *indent, *info, lines.as_slice()), (4, "  ", "nply hide", ["nply lays", ""].as_slice()));
        assert_eq!(pieces[2], Piece::Prose { line: 8, text: "after `x` and ``y``\n" });
        assert!(matches!(&pieces[3], Piece::Fence { line: 9, lines, .. } if lines == &["```"]));
        assert_eq!(pieces[4], Piece::Prose { line: 12, text: "end" });
    }

    #[test]
    fn a_fence_is_longer_than_what_it_holds() {
        assert_eq!(fenced("text", "a\n```\n"), "````text\na\n```\n````\n");
        assert_eq!(indented("a\nb\n", "  "), "  a\n  b\n");
    }
}
