//! Which value of each datum a row has: places counted from 0, over any stretch of rows.

/// A range of 64 bits that knows its length.
pub(super) struct Exact(core::ops::Range<u64>);

impl Exact {
    pub(super) const fn of(range: core::ops::Range<u64>) -> Self {
        Self(range)
    }
}

impl Iterator for Exact {
    type Item = u64;

    #[inline]
    fn next(&mut self) -> Option<u64> {
        self.0.next()
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let length = (self.0.end - self.0.start) as usize;
        (length, Some(length))
    }
}

impl ExactSizeIterator for Exact {}

/// The places of one datum over rows of a grid: each stays for `stride` rows.
pub(super) struct Places {
    place: u64,
    stays: u64,
    stride: u64,
    count: u64,
    left: u64,
}

impl Places {
    pub(super) const fn new(rows: core::ops::Range<u64>, stride: u64, count: u64) -> Self {
        Self {
            place: rows.start / stride % count,
            stays: stride - rows.start % stride,
            stride,
            count,
            left: rows.end - rows.start,
        }
    }
}

impl Iterator for Places {
    type Item = u64;

    #[inline]
    fn next(&mut self) -> Option<u64> {
        self.left = self.left.checked_sub(1)?;
        let here = self.place;
        self.stays -= 1;
        if self.stays == 0 {
            self.stays = self.stride;
            self.place = if here + 1 == self.count { 0 } else { here + 1 };
        }
        Some(here)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left as usize, Some(self.left as usize))
    }
}

impl ExactSizeIterator for Places {}
