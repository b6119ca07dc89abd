//! An axis: what it shows, in which unit, from where to where.

use kuva::TickFormat;
use kuva::render::render_utils::{compute_tick_step, generate_ticks, generate_ticks_with_step};

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
    /// From tick to tick, in the unit; `None` for what is read easily.
    pub step: Option<f64>,
    /// Whether equal ratios have equal lengths; numbers that are not greater than 0 are then left out.
    pub logarithmic: bool,
}

impl Axis {
    /// An axis as long as the data need.
    #[must_use]
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { name: name.into(), unit: unit.into(), range: None, step: None, logarithmic: false }
    }

    /// The same with ticks at multiples of `step`, in the unit.
    #[must_use]
    pub fn with_step(mut self, step: f64) -> Self {
        self.step = Some(step);
        self
    }

    /// The same with equal lengths for equal ratios.
    ///
    /// ```
    /// use nply_sheet::plot::{Axis, Chart, Curve};
    /// let axis = || Axis::new("q", "").logarithmic();
    /// let svg = Chart::new("", axis(), axis()).with_curve(Curve::new("", [(0.0, 1.0), (1.0, 1.0), (1e6, 1e3)])).svg();
    /// assert!(svg.contains("10⁶"));
    /// ```
    #[must_use]
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// The same from `low` to `high`. On a chart the smaller number is left or at the bottom, whatever the order.
    #[must_use]
    pub fn with_range(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// The range where it is of use.
    pub(super) fn fixed(&self) -> Option<(f64, f64)> {
        let low = if self.logarithmic { f64::MIN_POSITIVE } else { f64::MIN };
        let fit = |end: &f64| (low..=f64::MAX).contains(end);
        self.range.filter(|(a, b)| fit(a) && fit(b))
    }

    /// What it shows from one number to another.
    pub(super) fn window(&self, a: f64, b: f64) -> Window {
        if self.logarithmic { Window::decades(a, b) } else { Window::exact(a, b).with_step(self.step) }
    }

    /// What it shows of these numbers.
    pub(super) fn window_around(&self, values: impl Iterator<Item = f64>) -> Window {
        if !self.logarithmic {
            return Window::around(values).with_step(self.step);
        }
        let (low, high) = extent(values.filter(|v| *v >= f64::MIN_POSITIVE)).unwrap_or((1.0, 10.0));
        let mut window = Window::decades(low, high);
        let air = 0.04 * (window.high - window.low);
        window.low -= air;
        window.high += air;
        window
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
    /// From tick to tick, where that is given.
    pub(super) step: Option<f64>,
    unit: f64,
    /// Whether places are logarithms to base ten.
    logarithmic: bool,
}

/// The number of ticks aimed at.
pub(super) const TICKS: usize = 5;

impl Window {
    /// From one end to the other exactly, but for ends that are (almost) the same, which are moved apart.
    pub(super) fn exact(a: f64, b: f64) -> Self {
        let (low, high) = if a <= b { (a, b) } else { (b, a) };
        let size = low.abs().max(high.abs());
        if size < 1e-300 {
            return Self { low: -1.0, high: 1.0, power: 0, step: None, unit: 1.0, logarithmic: false };
        }
        #[allow(clippy::cast_possible_truncation, reason = "at most 308")]
        let exponent = libm::floor(libm::log10(size)) as i32;
        let power = if (-2..=4).contains(&exponent) { 0 } else { 3 * exponent.div_euclid(3) };
        let unit = libm::pow(10.0, f64::from(power));
        let (mut low, mut high, size) = (low / unit, high / unit, size / unit);
        if high - low < 1e-9 * size {
            (low, high) = (low - 0.05 * size, high + 0.05 * size);
        }
        Self { low, high, power, step: None, unit, logarithmic: false }
    }

    /// The same with a tick at every multiple of `step`, unless there would be none or a thicket.
    fn with_step(mut self, step: Option<f64>) -> Self {
        let count = |step: f64| (self.high - self.low) / step;
        self.step =
            step.map(|step| step / self.unit).filter(|step| *step > 0.0 && (1.0..=20.0).contains(&count(*step)));
        self
    }

    /// From one number greater than 0 to another, by decades.
    fn decades(a: f64, b: f64) -> Self {
        let [low, high] = [a.min(b), a.max(b)].map(|end| libm::log10(end.max(f64::MIN_POSITIVE)));
        let (low, high) = if high - low < 1e-6 { (low - 0.5, high + 0.5) } else { (low, high) };
        // whole decades are ticks, every second or third where there are many; twos and fives where there are few
        #[allow(clippy::cast_precision_loss, reason = "5")]
        let step = if high - low > 0.7 { Some(libm::ceil((high - low) / (TICKS as f64 + 1.0))) } else { None };
        Self { low, high, power: 0, step, unit: 1.0, logarithmic: true }
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
        match self.logarithmic {
            false => value / self.unit,
            true if value > 0.0 => libm::log10(value),
            true => f64::NAN,
        }
    }

    /// Places and labels of some `count` ticks.
    pub(super) fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        let format = self.format();
        let places = match self.step {
            Some(step) => generate_ticks_with_step(self.low, self.high, step),
            None => generate_ticks(self.low, self.high, count),
        };
        places.into_iter().map(|tick| (tick, format.format(tick))).collect()
    }

    /// Twos and fives between the decades of a short logarithmic axis.
    pub(super) fn between_decades(&self) -> Vec<(f64, String)> {
        if !self.logarithmic || self.step.is_none() || self.high - self.low > 3.0 {
            return Vec::new();
        }
        #[allow(clippy::cast_possible_truncation, reason = "at most 308")]
        let decades = libm::floor(self.low) as i32..=libm::ceil(self.high) as i32;
        let number = |decade: i32, digit: f64| {
            let value = digit * libm::pow(10.0, f64::from(decade));
            let words = if (-3..4).contains(&decade) { crate::preferred::six_digits(value) } else { String::new() };
            (f64::from(decade) + libm::log10(digit), words)
        };
        let all = decades.flat_map(|decade| [number(decade, 2.0), number(decade, 5.0)]);
        all.filter(|(place, _)| (self.low..=self.high).contains(place)).collect()
    }

    /// How the numbers at the ticks are written: all with the same digits, as many as the steps need.
    pub(super) fn format(&self) -> TickFormat {
        if self.logarithmic {
            return TickFormat::Custom(std::sync::Arc::new(power_of_ten));
        }
        let step = self.step.unwrap_or_else(|| compute_tick_step(self.low, self.high, TICKS));
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

/// The number at a logarithm: 1000 as it is, beyond that as a power.
fn power_of_ten(place: f64) -> String {
    let whole = libm::round(place);
    if (place - whole).abs() > 1e-9 {
        let value = libm::pow(10.0, place);
        return if (1e-3..1e4).contains(&value) { crate::preferred::six_digits(value) } else { format!("{value:.2e}") };
    }
    #[allow(clippy::cast_possible_truncation, reason = "at most 308")]
    let power = whole as i32;
    match power {
        0..=3 => format!("{}", libm::pow(10.0, whole)),
        -3..0 => format!("{:.*}", power.unsigned_abs() as usize, libm::pow(10.0, whole)),
        _ => format!("10{}", text::superscript(power)),
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
