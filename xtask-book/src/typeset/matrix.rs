//! Matrices and columns drawn over several lines with ⎛ ⎜ ⎝ and ⎞ ⎟ ⎠; what stands beside them stands in one of the lines.

const LEFT: [char; 3] = ['⎛', '⎜', '⎝'];
const RIGHT: [char; 3] = ['⎞', '⎟', '⎠'];

/// Whether a line is one of a matrix.
pub(super) fn is_drawn_in(line: &str) -> bool {
    line.contains(LEFT)
}

/// The lines of a matrix or of several beside each other; `beside` sets what stands between them.
pub(super) fn latex(lines: &[&str], beside: impl Fn(&str) -> Result<String, String>) -> Result<String, String> {
    let mut outside: Vec<String> = Vec::new();
    let mut inside: Vec<Vec<String>> = Vec::new();
    for line in lines {
        let pieces: Vec<&str> = line.split(LEFT).flat_map(|piece| piece.split(RIGHT)).collect();
        if pieces.len().is_multiple_of(2) {
            return Err(format!("`{line}`: a matrix is open"));
        }
        for (at, piece) in pieces.into_iter().enumerate() {
            if at % 2 == 1 {
                let row = cells(piece)?;
                match inside.get_mut(at / 2) {
                    Some(rows) => rows.push(row),
                    None => inside.push(vec![row]),
                }
                continue;
            }
            let piece = piece.trim();
            match outside.get_mut(at / 2) {
                None => outside.push(piece.to_owned()),
                Some(text) if text.is_empty() => piece.clone_into(text),
                Some(_) if piece.is_empty() => {}
                Some(_) => return Err(format!("`{piece}`: two lines beside a matrix")),
            }
        }
    }
    let mut latex = String::new();
    for (at, text) in outside.iter().enumerate() {
        latex.push_str(&beside(text)?);
        if let Some(rows) = inside.get(at) {
            latex.push_str(&format!(r"\begin{{pmatrix}}{}\end{{pmatrix}}", super::stacked(rows, "0.4em")));
        }
    }
    Ok(latex)
}

/// The cells of a row stand two or more blanks apart.
fn cells(row: &str) -> Result<String, String> {
    let cells = row.split("  ").map(str::trim).filter(|cell| !cell.is_empty());
    let cells: Result<Vec<String>, String> = cells.map(|cell| super::term::latex(cell, false)).collect();
    Ok(cells?.join("&"))
}
