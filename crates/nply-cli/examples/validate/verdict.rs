//! How a number of ours agrees with a published one.

use crate::published::{Number, Printed, Published};

/// What came of one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Agreement {
    /// To every printed digit.
    Digits,
    /// Within the tolerance that the source states or implies.
    Tolerance,
    /// Not; the reason stands beside it.
    Differs,
    /// The source does not say enough to work it out.
    NotRemade,
}

/// A published number beside ours.
#[derive(Clone, Debug)]
pub(crate) struct Row<'a> {
    pub(crate) number: &'a Number,
    pub(crate) published: Printed,
    pub(crate) ours: Option<f64>,
}

/// Half a unit is allowed in full: decimals are not doubles.
const ROUNDING: f64 = 1e-6;

impl<'a> Row<'a> {
    pub(crate) fn new(number: &'a Number, ours: Option<f64>) -> Result<Self, String> {
        Ok(Self { number, published: number.value()?, ours })
    }

    /// Ours less published.
    pub(crate) fn difference(&self) -> Option<f64> {
        self.ours.map(|ours| ours - self.published.value)
    }

    pub(crate) fn agreement(&self) -> Agreement {
        let Some(difference) = self.difference() else { return Agreement::NotRemade };
        if difference.abs() <= self.half() {
            Agreement::Digits
        } else if self.number.within.is_some_and(|within| difference.abs() <= within) {
            Agreement::Tolerance
        } else {
            Agreement::Differs
        }
    }

    /// Whether the difference is the one that is stated (none, if none is), to half a unit of the last printed digit: what fails when either side
    /// moves by a digit.
    pub(crate) fn holds(&self) -> bool {
        let stated = self.number.difference.unwrap_or(0.0);
        // an absent value of ours is held by its reason alone
        self.difference().is_none_or(|difference| (difference - stated).abs() <= self.half())
    }

    fn half(&self) -> f64 {
        self.published.last_digit() * (0.5 + ROUNDING)
    }
}

/// Every number worked out, in the order of the file.
pub(crate) fn rows<'a>(
    published: &'a Published,
    mut ours: impl FnMut(&Number) -> Result<Option<f64>, String>,
) -> Result<Vec<Row<'a>>, String> {
    let of = |number: &'a Number| Row::new(number, ours(number).map_err(|error| format!("{}: {error}", number.id))?);
    published.numbers.iter().map(of).collect()
}
