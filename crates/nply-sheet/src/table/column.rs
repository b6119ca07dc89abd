//! Columns and what stands in them.

/// One column's head.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Column {
    /// Its name, unique in its table.
    pub name: String,
    /// What stands in it.
    pub kind: Kind,
    /// The unit of its numbers; empty for plain numbers and for what is no number.
    pub unit: String,
}

impl Column {
    /// A column without a unit.
    #[must_use]
    pub fn new(name: impl Into<String>, kind: Kind) -> Self {
        Self { name: name.into(), kind, unit: String::new() }
    }

    /// The same with a unit. Parquet keeps it beside the column (field metadata `unit`); CSV has no place for it.
    #[must_use]
    pub fn with_unit(mut self, unit: impl Into<String>) -> Self {
        self.unit = unit.into();
        self
    }
}

/// What stands in a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Doubles.
    Float,
    /// Integers of 64 bits, with sign.
    Integer,
    /// `true` or `false`.
    Boolean,
    /// Text.
    Text,
}

impl Kind {
    /// What stands in such a column, in the plural.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Float => "floating-point numbers",
            Self::Integer => "integers",
            Self::Boolean => "truth values",
            Self::Text => "texts",
        }
    }
}

/// A stretch of one column; `None` is an empty cell.
///
/// ```
/// use nply_sheet::table::Values;
/// assert_eq!(Values::from(vec![1.5, 2.5]), Values::Float(vec![Some(1.5), Some(2.5)]));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Values {
    /// For [`Kind::Float`]. NaN is a number like others, not an empty cell.
    Float(Vec<Option<f64>>),
    /// For [`Kind::Integer`].
    Integer(Vec<Option<i64>>),
    /// For [`Kind::Boolean`].
    Boolean(Vec<Option<bool>>),
    /// For [`Kind::Text`].
    Text(Vec<Option<String>>),
    /// For [`Kind::Float`], where no cell is empty.
    Dense(Vec<f64>),
    /// For [`Kind::Integer`], where no cell is empty.
    Counts(Vec<i64>),
    /// For [`Kind::Text`], where all texts are of the program.
    Words(Vec<Option<&'static str>>),
    /// So many empty cells, for any kind.
    Nothing(Kind, usize),
}

impl Values {
    /// The kind of column these can stand in.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Float(_) | Self::Dense(_) => Kind::Float,
            Self::Integer(_) | Self::Counts(_) => Kind::Integer,
            Self::Boolean(_) => Kind::Boolean,
            Self::Text(_) | Self::Words(_) => Kind::Text,
            Self::Nothing(kind, _) => *kind,
        }
    }

    /// The number of cells.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Float(cells) => cells.len(),
            Self::Integer(cells) => cells.len(),
            Self::Boolean(cells) => cells.len(),
            Self::Text(cells) => cells.len(),
            Self::Dense(cells) => cells.len(),
            Self::Counts(cells) => cells.len(),
            Self::Words(cells) => cells.len(),
            Self::Nothing(_, length) => *length,
        }
    }

    /// The cells at these places, one after the other, a place as often as it is said; a place there is not is an empty cell.
    ///
    /// ```
    /// use nply_sheet::table::Values;
    /// assert_eq!(Values::Dense(vec![1.0, 2.0]).taken(&[1, 1, 0]), Values::Dense(vec![2.0, 2.0, 1.0]));
    /// ```
    #[must_use]
    pub fn taken(&self, places: &[usize]) -> Self {
        fn of<T: Clone>(cells: &[Option<T>], places: &[usize]) -> Vec<Option<T>> {
            places.iter().map(|at| cells.get(*at).cloned().flatten()).collect()
        }
        fn all<T: Copy>(cells: &[T], places: &[usize]) -> Option<Vec<T>> {
            places.iter().map(|at| cells.get(*at).copied()).collect()
        }
        match self {
            Self::Float(cells) => Self::Float(of(cells, places)),
            Self::Integer(cells) => Self::Integer(of(cells, places)),
            Self::Boolean(cells) => Self::Boolean(of(cells, places)),
            Self::Text(cells) => Self::Text(of(cells, places)),
            Self::Words(cells) => Self::Words(of(cells, places)),
            Self::Dense(cells) => all(cells, places)
                .map_or_else(|| Self::Float(places.iter().map(|at| cells.get(*at).copied()).collect()), Self::Dense),
            Self::Counts(cells) => all(cells, places)
                .map_or_else(|| Self::Integer(places.iter().map(|at| cells.get(*at).copied()).collect()), Self::Counts),
            Self::Nothing(kind, _) => Self::Nothing(*kind, places.len()),
        }
    }

    /// Puts other cells behind these; of another kind than these, they are left empty.
    ///
    /// ```
    /// use nply_sheet::table::{Kind, Values};
    /// let mut values = Values::Dense(vec![1.0]);
    /// values.extend(Values::Nothing(Kind::Float, 1));
    /// assert_eq!(values, Values::Float(vec![Some(1.0), None]));
    /// ```
    pub fn extend(&mut self, other: Self) {
        match (&mut *self, other) {
            (Self::Float(cells), Self::Float(more)) => cells.extend(more),
            (Self::Integer(cells), Self::Integer(more)) => cells.extend(more),
            (Self::Boolean(cells), Self::Boolean(more)) => cells.extend(more),
            (Self::Text(cells), Self::Text(more)) => cells.extend(more),
            (Self::Dense(cells), Self::Dense(more)) => cells.extend(more),
            (Self::Counts(cells), Self::Counts(more)) => cells.extend(more),
            (Self::Words(cells), Self::Words(more)) => cells.extend(more),
            (Self::Nothing(kind, length), Self::Nothing(other, more)) if *kind == other => *length += more,
            (_, other) => {
                let own = core::mem::replace(self, Self::Nothing(other.kind(), 0));
                let kind = own.kind();
                let mut open = own.open();
                if other.kind() == kind {
                    open.extend(other.open());
                } else {
                    open.extend(Self::Nothing(kind, other.len()).open());
                }
                *self = open;
            }
        }
    }

    /// The same with a place for empty cells.
    fn open(self) -> Self {
        match self {
            Self::Dense(cells) => Self::Float(cells.into_iter().map(Some).collect()),
            Self::Counts(cells) => Self::Integer(cells.into_iter().map(Some).collect()),
            Self::Words(cells) => Self::Text(cells.into_iter().map(|word| word.map(str::to_owned)).collect()),
            Self::Nothing(Kind::Float, length) => Self::Float(vec![None; length]),
            Self::Nothing(Kind::Integer, length) => Self::Integer(vec![None; length]),
            Self::Nothing(Kind::Boolean, length) => Self::Boolean(vec![None; length]),
            Self::Nothing(Kind::Text, length) => Self::Text(vec![None; length]),
            other => other,
        }
    }

    /// Whether there is no cell.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

macro_rules! values_from {
    ($($kind:ident($cell:ty)),*) => { $(
        impl From<Vec<Option<$cell>>> for Values {
            fn from(cells: Vec<Option<$cell>>) -> Self {
                Self::$kind(cells)
            }
        }

        impl From<Vec<$cell>> for Values {
            fn from(cells: Vec<$cell>) -> Self {
                Self::$kind(cells.into_iter().map(Some).collect())
            }
        }
    )* };
}

values_from!(Float(f64), Integer(i64), Boolean(bool), Text(String));
