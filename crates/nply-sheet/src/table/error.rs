//! What can go wrong with a table.

/// Why a table could not be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// There is no column at all.
    #[error("A table needs at least one column.")]
    NoColumns,
    /// Two columns have one name.
    #[error("Two columns are named {name}.")]
    SameName {
        /// The name, in quotation marks.
        name: String,
    },
    /// A chunk has too many or too few columns.
    #[error("The table has {expected} columns, the chunk {found}.")]
    ColumnCount {
        /// The table's columns.
        expected: usize,
        /// The chunk's columns.
        found: usize,
    },
    /// A chunk's column holds something else than the table's.
    #[error("Column {name} is for {expected}, not for {found}.")]
    WrongKind {
        /// The column's name, in quotation marks.
        name: String,
        /// What it is for.
        expected: &'static str,
        /// What came.
        found: &'static str,
    },
    /// A chunk's columns are not equally long.
    #[error("Column {name} has {found} cells in this chunk, the first column {expected}.")]
    Length {
        /// The column's name, in quotation marks.
        name: String,
        /// The length of the first column.
        expected: usize,
        /// The length of this one.
        found: usize,
    },
    /// What should be read as a table is none, or not whole: a sentence without its end.
    #[error("{0}.")]
    Unreadable(String),
    /// The place where the table goes took no more.
    #[error("The table could not be written: {0}.")]
    Write(#[from] std::io::Error),
    /// The format's own writer refused.
    #[error("The table could not be encoded: {0}.")]
    Encode(Box<dyn std::error::Error + Send + Sync>),
}
