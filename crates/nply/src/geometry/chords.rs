//! Strands of straight elements: helices replaced by their chords, as finite elements of beams start from.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::clearance::approach;
use super::{Contact, HelicalAngle, Vector, check_strands};
use crate::DomainError;

/// The strands of a ply whose centrelines are polylines with their nodes on the helices.
///
/// Chords cut the bend short, so that polylines whose helices touch overlap. Everything scales with the helix radius: distances are given over R.
///
/// ```
/// use nply::geometry::{Chords, HelicalAngle};
/// let angle = HelicalAngle::new(17.44_f64.to_radians())?;
/// let wires = Chords::new(6, angle, 24)?;
/// // six wires laid at R = 2r overlap, smooth or not
/// assert!(2.0 * wires.smooth_distance() < 2.0);
/// assert!(wires.least_distance(0.0) < wires.smooth_distance());
/// # Ok::<(), nply::DomainError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chords {
    strands: u32,
    angle: HelicalAngle,
    elements: f64,
}

/// The narrowest lay in which strands of straight elements keep clear of each other. Lengths in units of r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordLay {
    /// Its strands, with their angle.
    pub chords: Chords,
    /// R/r.
    pub radius_ratio: f64,
    /// The least distance of neighbours' polylines.
    pub least_distance: f64,
    /// The least distance of the helices they stand for; what it has more is lost to chords.
    pub smooth_distance: f64,
}

/// Pairs of strands farther apart round the ply than this are farther apart in space, too.
const FARTHEST: u32 = 24;

impl Chords {
    /// From the number of strands n ≥ 2, their angle, and the elements per lay length, which need not be whole.
    ///
    /// # Errors
    /// [`DomainError`] on `strands`, on `helical_angle` for straight strands, which have no lay length, and on `elements` unless there are 3
    /// to a million.
    pub fn new(strands: u32, angle: HelicalAngle, elements: impl Into<f64>) -> Result<Self, DomainError> {
        let elements = elements.into();
        check_strands(strands)?;
        let wound = angle.sin() > 0.0;
        DomainError::check(wound, "helical_angle", angle.radians(), "greater than 0: straight strands have no turns")?;
        let allowed = "at least 3 and at most a million for a lay length";
        DomainError::check((3.0..=1e6).contains(&elements), "elements", elements, allowed)?;
        Ok(Self { strands, angle, elements })
    }

    /// n.
    #[must_use]
    pub const fn strands(&self) -> u32 {
        self.strands
    }

    /// θ of the helices.
    #[must_use]
    pub const fn angle(&self) -> HelicalAngle {
        self.angle
    }

    /// Elements per lay length.
    #[must_use]
    pub const fn elements(&self) -> f64 {
        self.elements
    }

    /// The height of an element over R: 2π/(N tan θ).
    #[must_use]
    pub fn rise(&self) -> f64 {
        TAU / (self.elements * self.angle.tan())
    }

    /// The node at a count of elements, which need not be whole, of a strand whose helix is turned by an angle; over R.
    ///
    /// Right-handed; the left-handed ply is its mirror image.
    #[must_use]
    pub fn node(&self, turned: f64, count: f64) -> Vector {
        let (sin, cos) = libm::sincos(turned + TAU * count / self.elements);
        [sin, -cos, count * self.rise()]
    }

    /// The least distance of two helices over R: 2/ρ of touching strands at this angle, (4).
    #[must_use]
    pub fn smooth_distance(&self) -> f64 {
        2.0 / Contact::at(self.strands, self.angle).radius_ratio()
    }

    /// The least distance of any two strands' polylines over R, where the nodes of each strand stand `stagger` elements farther along than
    /// those of the one before; 0: all nodes at the same heights.
    #[must_use]
    pub fn least_distance(&self, stagger: f64) -> f64 {
        self.pairs().map(|apart| self.distance(apart, f64::from(apart) * stagger)).fold(f64::INFINITY, f64::min)
    }

    /// The least of [`least_distance`](Self::least_distance) over every relative place of two strands' nodes: what holds however they stand.
    #[must_use]
    pub fn least_distance_at_any_stagger(&self) -> f64 {
        const SAMPLES: u32 = 48;
        let mut least = f64::INFINITY;
        for apart in self.pairs() {
            let at = |k: u32| self.distance(apart, f64::from(k % SAMPLES) / f64::from(SAMPLES));
            let samples: Vec<f64> = (0..SAMPLES).map(at).collect();
            for (k, here) in (0..SAMPLES).zip(&samples) {
                let beside = |k: u32| samples[(k % SAMPLES) as usize];
                if *here <= beside(k + 1) && *here <= beside(k + SAMPLES - 1) {
                    let (middle, step) = (f64::from(k) / f64::from(SAMPLES), 1.0 / f64::from(SAMPLES));
                    least = least.min(valley(|stagger| self.distance(apart, stagger), middle - step, middle + step));
                }
            }
        }
        least
    }

    /// The least distance of a polyline from the ply's axis over R, at the middle of each element: cos(π/N).
    #[must_use]
    pub fn core_distance(&self) -> f64 {
        libm::cos(PI / self.elements)
    }

    /// The narrowest lay at this angle whose polylines keep the given distance of centrelines (in units of r; 2: uncoated) from each other, and
    /// `from_core` from the axis (0: no core), with nodes staggered so, or at any stagger.
    ///
    /// # Errors
    /// [`DomainError`] on `distance` unless it is finite and greater than 0.
    ///
    /// ```
    /// use nply::geometry::{Chords, HelicalAngle};
    /// let wires = Chords::new(6, HelicalAngle::new(17.44_f64.to_radians())?, 24)?;
    /// let lay = wires.narrowest(2.0, 0.0, Some(0.0))?;
    /// assert!(lay.radius_ratio > 2.0);
    /// assert!((lay.least_distance - 2.0).abs() < 1e-14 && lay.smooth_distance > 2.0);
    /// # Ok::<(), nply::DomainError>(())
    /// ```
    pub fn narrowest(&self, distance: f64, from_core: f64, stagger: Option<f64>) -> Result<ChordLay, DomainError> {
        let positive = distance > 0.0 && distance < f64::INFINITY;
        DomainError::check(positive, "distance", distance, "greater than 0 and finite")?;
        DomainError::check((0.0..f64::INFINITY).contains(&from_core), "distance", from_core, "at least 0 and finite")?;
        let over_radius = self.over_radius(stagger);
        let radius_ratio = (distance / over_radius).max(from_core / self.core_distance());
        Ok(self.laid(radius_ratio, stagger))
    }

    /// The lay at a given R/r, clear or not.
    #[must_use]
    pub fn laid(&self, radius_ratio: f64, stagger: Option<f64>) -> ChordLay {
        ChordLay {
            chords: *self,
            radius_ratio,
            least_distance: radius_ratio * self.over_radius(stagger),
            smooth_distance: radius_ratio * self.smooth_distance(),
        }
    }

    /// As [`narrowest`](Self::narrowest), with the lay length held (in units of r) and the angle found.
    ///
    /// # Errors
    /// [`DomainError`] as there and for [`new`](Self::new), and on `lay_length` where no lay so short keeps strands of so many elements clear.
    pub fn narrowest_of_lay_length(
        strands: u32,
        lay_length: f64,
        elements: impl Into<f64>,
        distance: f64,
        from_core: f64,
        stagger: Option<f64>,
    ) -> Result<ChordLay, DomainError> {
        const SAMPLES: u32 = 240;
        const FLATTEST: f64 = 1e-4; // rad from flat rings
        let elements = elements.into();
        let allowed = "longer: no lay of this length keeps so many strands clear, in so few elements";
        let none = || DomainError { quantity: "lay_length", value: lay_length, allowed };
        DomainError::check(lay_length > 0.0 && lay_length < f64::INFINITY, "lay_length", lay_length, "greater than 0")?;
        let positive = distance > 0.0 && distance < f64::INFINITY;
        DomainError::check(positive, "distance", distance, "greater than 0 and finite")?;
        let at = |theta: f64| -> Result<(Self, f64), DomainError> {
            let chords = Self::new(strands, HelicalAngle::new(theta)?, elements)?;
            Ok((chords, lay_length * chords.angle.tan() / TAU))
        };
        // how much there is to spare; less than nothing next to straight strands, which lie within each other
        let spare = |theta: f64| -> Result<f64, DomainError> {
            let (chords, radius) = at(theta)?;
            let core = if from_core > 0.0 { radius * chords.core_distance() - from_core } else { f64::INFINITY };
            Ok((radius * chords.over_radius(stagger) - distance).min(core))
        };
        // no two strands come within a distance d of each other on a radius below d/2
        let start = libm::atan(0.5 * distance * TAU / lay_length).min(FRAC_PI_2 - 2.0 * FLATTEST);
        let (mut low, mut high) = (0.5 * start, None);
        for k in 0..=SAMPLES {
            let theta = start + (FRAC_PI_2 - FLATTEST - start) * f64::from(k) / f64::from(SAMPLES);
            if spare(theta)? >= 0.0 {
                high = Some(theta);
                break;
            }
            low = theta;
        }
        let mut high = high.ok_or_else(none)?;
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if spare(middle)? >= 0.0 { high = middle } else { low = middle }
        }
        let (chords, radius) = at(high)?;
        Ok(chords.laid(radius, stagger))
    }

    fn over_radius(&self, stagger: Option<f64>) -> f64 {
        stagger.map_or_else(|| self.least_distance_at_any_stagger(), |stagger| self.least_distance(stagger))
    }

    /// How many places round the ply two strands can be apart, either way.
    fn pairs(&self) -> impl Iterator<Item = u32> + use<> {
        let n = self.strands;
        let near = FARTHEST.min(n - 1);
        (1..=near).chain((n - near).max(near + 1)..n)
    }

    /// The least distance of two polylines so many places apart round the ply, over R; the second's nodes stand `stagger` elements farther
    /// along. A screw takes either polyline along itself by an element, so that one element of the first stands for all.
    fn distance(&self, apart: u32, stagger: f64) -> f64 {
        let turned = TAU * f64::from(apart) / f64::from(self.strands);
        let shift = stagger - libm::floor(stagger);
        let first = [self.node(0.0, 0.0), self.node(0.0, 1.0)];
        let rise = self.rise();
        let mut square = f64::INFINITY;
        let mut out = 0.0;
        // from the elements at the same height up and down, until height alone is too much
        loop {
            let height = (out - 2.0) * rise;
            if height > 0.0 && height * height >= square {
                return libm::sqrt(square);
            }
            for count in [out, -out - 1.0] {
                let count = count + shift;
                let other = [self.node(turned, count), self.node(turned, count + 1.0)];
                square = square.min(approach(first, other).0);
            }
            out += 1.0;
        }
    }
}

/// The least value of a function between two places with one valley between them, by the golden section.
fn valley(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    const STEPS: u32 = 60;
    let (mut a, mut b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..STEPS {
        if at_a <= at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - GOLDEN * (high - low);
            at_a = f(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + GOLDEN * (high - low);
            at_b = f(b);
        }
    }
    at_a.min(at_b)
}
