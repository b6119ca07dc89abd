//! An axis: what it shows, in which unit, from where to where.

use kuva::TickFormat;
use kuva::render::render_utils::compute_tick_step;

use super::text;

/// What an axis (or a colour bar) shows.
///
/// ```
/// use nply_sheet::plot::Axis;
/// let axis = Axis::new("end moment", "N m").with_range(0.0, 2e-20);
/// assert_eq!(axis.range, Some((0.0, 2e-20)));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Axis {
    /// The quantity's name.
    pub name: String,
    /// Its unit; empty for plain numbers. A power of ten is put before it where numbers are very large or small.
    pub unit: String,
    /// Where the axis begins and ends, in the unit; `None` for as far as the data reach. Ends that are not finite count as
    /// `None`.
    pub range: Option<(f64, f64)>,
}

impl Axis {
    /// An axis as long as the data need.
    #[must_use]
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { name: name.into(), unit: unit.into(), range: None }
    }

    /// The same from `low` to `high`. On a chart the smaller number is left or at the bottom, whatever the order.
    #[must_use]
    pub fn with_range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// The range where it is of use.
    pub(super) fn fixed(&self) -> Option<(f64, f64)> {
        self.range.filter(|(a, b)| a.is_finite() && b.is_finite())
    }

    /// Name and unit, with the power of ten the tick labels leave out.
    pub(super) fn label(&self, window: &Window) -> String {
        let power = match window.power {
            0 => String::new(),
            n => format!("10{}", text::superscript(n)),
        };
        let unit = match (power.is_empty(), self.unit.is_empty()) {
            (true, true) => return text::clean(&self.name),
            (true, false) => self.unit.clone(),
            (false, true) => format!("×{power}"),
            (false, false) => format!("{power} {}", self.unit),
        };
        text::clean(&format!("{} ({unit})", self.name))
    }
}

/// The part of the number line an axis shows, in units of a power of ten that keeps its numbers short.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Window {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) power: i32,
    unit: f64,
}

/// The number of ticks aimed at.
pub(super) const TICKS: usize = 5;

impl Window {
    /// From one end to the other exactly, but for ends that are (almost) the same, which are moved apart.
    pub(super) fn exact(a: f64, b: f64) -> Self {
        let (low, high) = if a <= b { (a, b) } else { (b, a) };
        let size = low.abs().max(high.abs());
        if size < 1e-300 {
            return Self { low: -1.0, high: 1.0, power: 0, unit: 1.0 };
        }
        #[allow(clippy::cast_possible_truncation, reason = "at most 308")]
        let exponent = libm::floor(libm::log10(size)) as i32;
        let power = if (-2..=4).contains(&exponent) { 0 } else { 3 * exponent.div_euclid(3) };
        let unit = libm::pow(10.0, f64::from(power));
        let (mut low, mut high, size) = (low / unit, high / unit, size / unit);
        if high - low < 1e-9 * size {
            (low, high) = (low - 0.05 * size, high + 0.05 * size);
        }
        Self { low, high, power, unit }
    }

    /// As far as these numbers reach, with some air; those not finite are passed over.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = extent(values).unwrap_or((0.0, 1.0));
        let mut window = Self::exact(low, high);
        let air = 0.04 * (window.high - window.low);
        window.low -= air;
        window.high += air;
        window
    }

    /// A number in the window's units.
    pub(super) fn scaled(&self, value: f64) -> f64 {
        value / self.unit
    }

    /// How the numbers at the ticks are written: all with the same digits, as many as the steps need.
    pub(super) fn format(&self) -> TickFormat {
        let step = compute_tick_step(self.low, self.high, TICKS);
        let is_whole = |decimals: &usize| {
            #[allow(clippy::cast_precision_loss, reason = "at most 14")]
            let scaled = step * libm::pow(10.0, *decimals as f64);
            (scaled - libm::round(scaled)).abs() < 1e-6 * scaled
        };
        let decimals = (0..=14).find(is_whole).unwrap_or(14);
        TickFormat::Custom(std::sync::Arc::new(move |value| {
            let digits = format!("{:.decimals$}", value.abs());
            let is_negative = value < 0.0 && digits.bytes().any(|b| (b'1'..=b'9').contains(&b));
            if is_negative { format!("−{digits}") } else { digits }
        }))
    }
}

/// The smallest and the largest of the finite numbers.
pub(super) fn extent(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let mut finite = values.filter(|v| v.is_finite());
    let first = finite.next()?;
    Some(finite.fold((first, first), |(low, high), v| (low.min(v), high.max(v))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tick_labels_tell_neighbours_apart() {
        let shown = |low, high, value| Window::exact(low, high).format().format(value);
        assert_eq!(shown(30.612_01, 30.612_06, 30.612_03), "30.61203");
        assert_eq!(shown(-1.0, 1.0, -1e-17), "0.0");
        assert_eq!(shown(-10.0, 0.0, -2.5), "−2");
        let dna = Window::exact(0.0, 2.5e-20);
        assert_eq!((dna.power, Axis::new("M", "N m").label(&dna).as_str()), (-21, "M (10⁻²¹ N m)"));
        assert!((dna.scaled(1e-20) - 10.0).abs() < 1e-12);
    }
}
