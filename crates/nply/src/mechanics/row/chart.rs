//! The whole branch in cells, worked out once for each number of strands and each balance.

use core::f64::consts::FRAC_PI_4;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::cell::Cell;
use crate::mechanics::Balance;
use crate::mechanics::batch::Both;

/// Cells of one width on either side of π/4.
const WIDE: u32 = 48;
/// Cells that narrow fourfold towards 0, so that small angles keep their digits.
const NARROW: u32 = 4;

/// Halvings of a cell on which the terms bend more.
const MOST_HALVINGS: u32 = 3;

/// The branch from straight strands to flat rings, by helical angle up to π/4 and by pitch angle beyond.
#[derive(Debug)]
pub(in crate::mechanics) struct Chart {
    strands: u32,
    balance: Balance,
    pub(in crate::mechanics) cells: Vec<Cell>,
    /// the cell in which each bin of the steep and of the flat half begins
    bins: [Vec<usize>; 2],
    panels: OnceLock<Both>,
}

/// Bins as wide as the narrowest cell that was halved.
const BINS: usize = (WIDE << MOST_HALVINGS) as usize;

impl Chart {
    fn new(strands: u32, balance: Balance) -> Self {
        let mut cells = Vec::with_capacity(2 * (WIDE + NARROW + 1) as usize);
        let borders = borders();
        for flat in [false, true] {
            for ends in borders.windows(2) {
                fit(&mut cells, (strands, balance, flat), ends[0], ends[1], MOST_HALVINGS);
            }
        }
        let bins = [false, true].map(|flat| {
            let own = |begin: f64| cells.iter().position(|cell| cell.flat == flat && cell.end() > begin);
            (0..BINS).map(|bin| own(FRAC_PI_4 * bin as f64 / BINS as f64).unwrap_or(0)).collect()
        });
        Self { strands, balance, cells, bins, panels: OnceLock::new() }
    }

    /// The cell at a helical angle below π/4, or at a pitch angle below it.
    #[inline]
    pub(in crate::mechanics) fn cell(&self, flat: bool, t: f64) -> &Cell {
        let bin = ((t * (BINS as f64 / FRAC_PI_4)) as usize).min(BINS - 1);
        let mut at = self.bins[usize::from(flat)][bin];
        while t > self.cells[at].end() && self.cells.get(at + 1).is_some_and(|next| next.flat == flat) {
            at += 1;
        }
        &self.cells[at]
    }

    /// The branch in few and wide panels.
    pub(in crate::mechanics) fn panels(&self) -> &Both {
        self.panels.get_or_init(|| Both::new(self.strands, self.balance))
    }

    /// The chart, kept for the numbers of strands that people use and for the last other one.
    pub(in crate::mechanics) fn of(strands: u32, balance: Balance) -> Arc<Self> {
        const KEPT: usize = 11; // n = 2 … 12
        static CONTACT: [OnceLock<Arc<Chart>>; KEPT] = [const { OnceLock::new() }; KEPT];
        static RADIAL: [OnceLock<Arc<Chart>>; KEPT] = [const { OnceLock::new() }; KEPT];
        static LAST: Mutex<Option<Arc<Chart>>> = Mutex::new(None);
        let kept = match balance {
            Balance::Contact => &CONTACT,
            Balance::Radial => &RADIAL,
        };
        let new = || Arc::new(Self::new(strands, balance));
        if let Some(once) = kept.get(strands as usize - 2) {
            return Arc::clone(once.get_or_init(new));
        }
        // a chart is whole or absent, so that another thread's panic leaves nothing amiss
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        match last.as_ref() {
            Some(chart) if chart.strands == strands && chart.balance == balance => Arc::clone(chart),
            _ => Arc::clone(last.insert(new())),
        }
    }
}

/// A cell, or two of half the width where the polynomials do not keep the terms (two strands not far above π/4).
fn fit(cells: &mut Vec<Cell>, branch: (u32, Balance, bool), start: f64, end: f64, halvings: u32) {
    let (strands, balance, flat) = branch;
    let cell = Cell::fit(strands, balance, flat, start, end);
    if cell.edge || halvings == 0 || cell.faithful {
        cells.push(cell);
    } else {
        let middle = 0.5 * (start + end);
        fit(cells, branch, start, middle, halvings - 1);
        fit(cells, branch, middle, end, halvings - 1);
    }
}

fn borders() -> Vec<f64> {
    let width = FRAC_PI_4 / f64::from(WIDE);
    let mut narrow = Vec::from([width]);
    for _ in 0..NARROW {
        narrow.push(0.25 * narrow[narrow.len() - 1]);
    }
    narrow.push(0.0);
    let wide = (2..=WIDE).map(|i| if i == WIDE { FRAC_PI_4 } else { width * f64::from(i) });
    narrow.into_iter().rev().chain(wide).collect()
}
