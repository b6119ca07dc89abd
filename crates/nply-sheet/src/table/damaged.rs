//! Damaged files: the library that reads Parquet panics at some of them, and a panic that a file can cause is a refusal.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::TableError;

thread_local! {
    static IS_READING: Cell<bool> = const { Cell::new(false) };
}

/// Whether a panic of this thread, just now, is one that a damaged file caused and that is caught: a program's hook need not speak of it.
///
/// ```
/// assert!(!nply_sheet::table::panic_is_caught());
/// ```
#[must_use]
pub fn panic_is_caught() -> bool {
    IS_READING.get()
}

/// What reading comes to; a panic within is a file that is not whole. What was being read must not be used any more then.
pub(super) fn caught<T>(read: impl FnOnce() -> Result<T, TableError>) -> Result<T, TableError> {
    let before = IS_READING.replace(true);
    let read = catch_unwind(AssertUnwindSafe(read));
    IS_READING.set(before);
    read.unwrap_or_else(|_| {
        Err(TableError::Unreadable("it is no whole Parquet file (its parts do not fit each other)".to_owned()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_while_reading_is_a_refusal() {
        let fallen = caught(|| -> Result<(), TableError> {
            assert!(!panic_is_caught(), "a hook is silent here");
            Ok(())
        });
        assert!(matches!(fallen, Err(TableError::Unreadable(_))));
        assert!(!panic_is_caught());
        assert!(matches!(caught(|| Ok(7)), Ok(7)));
    }
}
