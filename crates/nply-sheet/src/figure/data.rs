//! The numbers of a figure, as rows.

use crate::plot::{Chart, Curve};

/// Columns of words and numbers.
///
/// ```
/// use nply_sheet::figure::{Cell, Data};
/// let mut data = Data::new(["curve", "x"]);
/// data.push([Cell::from("main"), Cell::from(0.5)]);
/// assert_eq!(data.csv(), "curve,x\nmain,0.5\n");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Data {
    /// The columns' names.
    pub columns: Vec<String>,
    /// Their cells, row by row.
    pub rows: Vec<Vec<Cell>>,
}

/// A word or a number.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A word.
    Word(String),
    /// A number.
    Number(f64),
}

impl From<&str> for Cell {
    fn from(word: &str) -> Self {
        Self::Word(word.to_owned())
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl Data {
    /// No rows yet.
    #[must_use]
    pub fn new<C: Into<String>>(columns: impl IntoIterator<Item = C>) -> Self {
        Self { columns: columns.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// One row more.
    pub fn push(&mut self, row: impl IntoIterator<Item = Cell>) {
        self.rows.push(row.into_iter().collect());
    }

    /// A chart with one curve more, and its points as rows that begin with these words.
    pub(super) fn draw(&mut self, chart: Chart, words: &[&str], curve: Curve) -> Chart {
        for &(x, y) in curve.points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()) {
            let numbers = [Cell::Number(x), Cell::Number(y)];
            self.rows.push(words.iter().map(|&word| Cell::from(word)).chain(numbers).collect());
        }
        chart.with_curve(curve)
    }

    /// The numbers of a column, in the rows whose first cells are these words.
    ///
    /// ```
    /// use nply_sheet::figure::Figure;
    /// let figure = Figure::named("3")?.expect("there is a Figure 3");
    /// assert!(figure.data.numbers(&["main"], "arclength_shift").count() > 20);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn numbers<'d>(&'d self, words: &[&'d str], column: &str) -> impl Iterator<Item = f64> + 'd {
        let place = self.columns.iter().position(|name| name == column);
        let words: Vec<Cell> = words.iter().map(|&word| Cell::from(word)).collect();
        self.rows.iter().filter(move |row| row.starts_with(&words)).filter_map(move |row| match row.get(place?) {
            Some(Cell::Number(number)) => Some(*number),
            _ => None,
        })
    }

    /// As comma-separated values.
    #[must_use]
    pub fn csv(&self) -> String {
        let row = |cells: &mut dyn Iterator<Item = String>| cells.collect::<Vec<_>>().join(",") + "\n";
        let quoted = |word: &str| {
            let plain = !word.contains([',', '"', '\n']);
            if plain { word.to_owned() } else { format!("\"{}\"", word.replace('"', "\"\"")) }
        };
        let mut text = row(&mut self.columns.iter().map(|name| quoted(name)));
        for cells in &self.rows {
            text += &row(&mut cells.iter().map(|cell| match cell {
                Cell::Word(word) => quoted(word),
                // adding 0 takes the sign from a negative zero
                Cell::Number(number) => format!("{}", number + 0.0),
            }));
        }
        text
    }
}
