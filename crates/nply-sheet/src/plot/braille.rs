//! A chart in a terminal: curves as dots, eight to a character.

use super::chart::Curve;
use super::clip::Frame;
use super::panel;
use super::{Chart, Dash, picture};

/// Dots across and up in one character.
const CELL: (usize, usize) = (2, 4);
/// The bits of a character's dots, row by row.
const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];
/// The terminal's own colours nearest to those of the palette.
const COLOURS: [u8; 7] = [34, 31, 32, 35, 33, 36, 39];
/// The least width and height that show anything, in characters.
const LEAST: (usize, usize) = (24, 6);

/// Characters with their colours.
struct Screen {
    width: usize,
    height: usize,
    cells: Vec<(u8, u8)>,
}

impl Screen {
    fn dot(&mut self, x: f64, y: f64, colour: u8) {
        if !(x >= 0.0 && y >= 0.0) {
            return;
        }
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not negative; too large is left out"
        )]
        let (x, y) = (x as usize, y as usize);
        if x < self.width * CELL.0 && y < self.height * CELL.1 {
            let cell = &mut self.cells[y / CELL.1 * self.width + x / CELL.0];
            *cell = (cell.0 | BITS[y % CELL.1][x % CELL.0], colour);
        }
    }

    /// Dots along a stroke; dashed ones leave some out. `done` counts them.
    fn stroke(&mut self, [a, b]: [[f64; 2]; 2], colour: u8, dash: Dash, done: &mut usize) {
        let steps = libm::ceil((b[0] - a[0]).abs().max((b[1] - a[1]).abs())).clamp(1.0, 1e4);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "up to ten thousand")]
        for k in 0..=(steps as usize) {
            let share = k as f64 / steps;
            let shown = match dash {
                Dash::Solid => true,
                Dash::Dotted => done.is_multiple_of(3),
                Dash::Dashed | Dash::DashDotted => *done % 5 < 2,
            };
            if shown {
                let at = [0, 1].map(|i| (1.0 - share) * a[i] + share * b[i]);
                self.dot(at[0], at[1], colour);
            }
            *done += usize::from(k > 0);
        }
    }

    fn line(&self, row: usize) -> String {
        let mut line = String::new();
        let mut last = 0;
        for &(bits, colour) in &self.cells[row * self.width..(row + 1) * self.width] {
            if bits != 0 && colour != last {
                line += &format!("\x1b[{colour}m");
                last = colour;
            }
            line.push(char::from_u32(0x2800 + u32::from(bits)).unwrap_or(' '));
        }
        if last != 0 {
            line += "\x1b[0m";
        }
        line
    }
}

impl Chart {
    /// The chart as lines of text, so many characters wide and high (at least 24 × 6 between the axes), with colours as terminals have
    /// them. Areas, notes and markers are left out.
    ///
    /// ```
    /// use nply_sheet::plot::{Axis, Chart, Curve};
    /// let chart = Chart::new("", Axis::new("f", "N"), Axis::new("θ", "deg"));
    /// let text = chart.with_curve(Curve::new("stable", [(0.0, 0.0), (1.0, 45.0)])).text(60, 16);
    /// assert!(text.lines().count() >= 16 && text.contains('⠊') && text.contains("θ (deg)"));
    /// ```
    #[must_use]
    pub fn text(&self, width: usize, height: usize) -> String {
        let (x, y) = panel::windows(picture::View { chart: self, raster: None });
        let ticks = y.ticks(5);
        let digits = ticks.iter().map(|(_, label)| label.chars().count()).max().unwrap_or(0);
        let width = width.saturating_sub(digits + 3).clamp(LEAST.0, 1000);
        let height = height.saturating_sub(4).clamp(LEAST.1, 300);
        let mut screen = Screen { width, height, cells: vec![(0, 0); width * height] };
        let frame = Frame { low: [x.low, y.low], high: [x.high, y.high] };
        let (across, up) = ((width * CELL.0) as f64 - 1.0, (height * CELL.1) as f64 - 1.0);
        let place = |[u, v]: [f64; 2]| [across * (u - x.low) / (x.high - x.low), up * (y.high - v) / (y.high - y.low)];
        let colours = panel::colours(self);
        for (curve, &colour) in self.curves.iter().zip(&colours) {
            let colour = COLOURS[colour % COLOURS.len()];
            let mut done = 0;
            for piece in frame.pieces(curve.points.iter().map(|&(u, v)| [x.scaled(u), y.scaled(v)])) {
                let piece: Vec<[f64; 2]> = piece.into_iter().map(place).collect();
                match piece[..] {
                    [[u, v]] => screen.dot(u, v, colour),
                    _ => piece
                        .windows(2)
                        .for_each(|pair| screen.stroke([pair[0], pair[1]], colour, curve.dash, &mut done)),
                }
            }
        }
        let row_of = |tick: f64| {
            let share = (y.high - tick) / (y.high - y.low);
            libm::floor((share * height as f64).clamp(0.0, height as f64 - 1.0))
        };
        let mut text = format!("{}\n", self.y.label(&y));
        for row in 0..height {
            #[allow(clippy::float_cmp, reason = "both are whole")]
            let tick = ticks.iter().find(|(tick, _)| row_of(*tick) == row as f64);
            let (label, edge) = tick.map_or(("", '│'), |(_, label)| (label.as_str(), '┤'));
            text += &format!("{label:>digits$} {edge}{}\n", screen.line(row));
        }
        text += &below(&x.ticks((width / 12).clamp(2, 8)), |tick| (tick - x.low) / (x.high - x.low), digits, width);
        let label = self.x.label(&x);
        let indent = (digits + 2 + width / 2).saturating_sub(label.chars().count() / 2);
        text += &format!("{}{label}\n", " ".repeat(indent));
        text + &self.names(&colours, width + digits + 3)
    }

    /// What is what, in lines that are no wider than the chart.
    fn names(&self, colours: &[usize], width: usize) -> String {
        let mut seen: Vec<(&str, Dash, usize)> = Vec::new();
        let (mut text, mut used) = (String::new(), 0);
        let named = |curve: &&Curve| !curve.name.is_empty();
        for (curve, &colour) in self.curves.iter().zip(colours).filter(|(curve, _)| named(curve)) {
            let kind = (curve.name.as_str(), curve.dash, colour);
            if self.legend && !seen.contains(&kind) {
                let sample = if curve.dash == Dash::Solid { "──" } else { "╌╌" };
                let name: String = curve.name.chars().take(width.saturating_sub(5)).collect();
                let size = 5 + name.chars().count();
                if used > 0 && used + size > width {
                    text.push('\n');
                    used = 0;
                }
                text += &format!("  \x1b[{}m{sample}\x1b[0m {name}", COLOURS[colour % COLOURS.len()]);
                used += size;
                seen.push(kind);
            }
        }
        if text.is_empty() { text } else { text + "\n" }
    }
}

/// The axis below, with its numbers.
fn below(ticks: &[(f64, String)], share: impl Fn(f64) -> f64, digits: usize, width: usize) -> String {
    let mut edge: Vec<char> = vec!['─'; width];
    let mut numbers: Vec<char> = Vec::new();
    for (tick, label) in ticks {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the width")]
        let at = libm::round(share(*tick).clamp(0.0, 1.0) * (width as f64 - 1.0)) as usize;
        edge[at] = '┬';
        let start = (digits + 2 + at).saturating_sub(label.chars().count() / 2);
        if start > numbers.len() || numbers.is_empty() {
            numbers.resize(start, ' ');
            numbers.extend(label.chars());
        }
    }
    let pad = " ".repeat(digits + 1);
    format!("{pad}└{}\n{}\n", edge.into_iter().collect::<String>(), numbers.into_iter().collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::Axis;

    #[test]
    fn a_rising_line_runs_from_corner_to_corner() {
        let axis = || Axis::new("q", "").with_range(0.0, 1.0);
        let chart = Chart::new("", axis(), axis()).with_curve(Curve::new("c", [(0.0, 0.0), (1.0, 1.0)]));
        let text = chart.text(40, 14);
        let rows: Vec<&str> = text.lines().filter(|line| line.contains('│') || line.contains('┤')).collect();
        let bare = |row: &str| {
            row.chars().skip_while(|c| !"│┤".contains(*c)).filter(|c| ('⠀'..='⣿').contains(c)).collect::<Vec<_>>()
        };
        let (first, last) = (bare(rows[0]), bare(rows[rows.len() - 1]));
        assert!(first.last() != Some(&'⠀') && first[0] == '⠀', "{text}");
        assert!(last[0] != '⠀' && last.last() == Some(&'⠀'), "{text}");
        // whatever is asked, nothing breaks
        for (width, height) in [(0, 0), (1, 9999), (9999, 1)] {
            assert!(chart.text(width, height).lines().count() > 5);
        }
    }
}
