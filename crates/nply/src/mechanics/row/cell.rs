//! A short piece of the branch, on which all that a row of equilibria needs is polynomial.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::geometry::{Contact, HelicalAngle};
use crate::mechanics::Balance;
use crate::mechanics::atlas::Condition;
use crate::numerics::dual::Dual;
use crate::numerics::septic::{self, Coefficients, NODES, ORDER};

/// The terms of the balance, and the pairs of different ones.
pub(in crate::mechanics) const TERMS: usize = 5;
pub(super) const PAIRS: usize = TERMS * (TERMS - 1) / 2;
/// The terms of the pressure: bending, Love's torsion, the twist held, the moment.
pub(super) const PRESSURES: usize = 4;

/// What polynomials may leave out of a term, relative to its size: some units in the last place.
const FAITHFUL: f64 = 2e-15;

/// What π/2 as a double leaves out.
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;

/// Functions as polynomials in Bernstein form, and how far each may be off.
#[derive(Clone, Debug)]
pub(super) struct Judged<const K: usize> {
    functions: [Coefficients; K],
    tolerance: [f64; K],
}

/// Polynomials in u, −1 at the `start` and 1 at the end, in the helical or the pitch angle.
#[derive(Clone, Debug)]
pub(in crate::mechanics) struct Cell {
    pub(in crate::mechanics) flat: bool,
    /// whether it begins at 0, where the balance or its quotient by the angle may vanish: it is judged and never followed
    pub(in crate::mechanics) edge: bool,
    /// whether the polynomials keep the balance's terms to within rounding
    pub(super) faithful: bool,
    pub(in crate::mechanics) middle: f64,
    half: f64,
    /// 1/`half`
    pub(in crate::mechanics) per_half: f64,
    /// cos²θ times the balance, term by term
    pub(super) terms: Judged<TERMS>,
    /// tₖ′ tₗ − tₖ tₗ′ for k < l, ′ by u
    pub(super) wronskians: Judged<PAIRS>,
    pub(in crate::mechanics) powers: [Coefficients; TERMS],
    pub(super) pressure: Pressure,
}

/// p₁ = Σ weight·term / divisor and p = Σ weight·term × factor.
///
/// The divisor is 1 in contact balance and cos θ in radial balance, whose p₁ has no bound as the strands become rings.
#[derive(Clone, Debug)]
pub(super) struct Pressure {
    pub(super) terms: [Coefficients; PRESSURES],
    pub(super) size: [f64; PRESSURES],
    /// `None` where it is 1
    pub(super) divisor: Option<Coefficients>,
    pub(super) factor: Coefficients,
}

/// A weighted sum of a few functions; the weights that vanish are left out.
#[derive(Clone, Debug, Default)]
pub(super) struct Weights {
    list: Vec<(usize, f64)>,
}

impl Weights {
    pub(super) fn new(weights: &[f64]) -> Self {
        Self { list: weights.iter().copied().enumerate().filter(|&(_, weight)| weight != 0.0).collect() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    #[inline]
    pub(super) fn sum(&self, functions: &[Coefficients]) -> Coefficients {
        let mut sum = [0.0; ORDER];
        for &(k, weight) in &self.list {
            septic::add(&mut sum, weight, &functions[k]);
        }
        sum
    }

    /// The sum of the sizes that go with the functions.
    #[inline]
    pub(super) fn size(&self, sizes: &[f64]) -> f64 {
        self.list.iter().map(|&(k, weight)| weight.abs() * sizes[k]).sum()
    }
}

impl<const K: usize> Judged<K> {
    #[inline]
    pub(super) fn sum(&self, weights: &Weights) -> (Coefficients, f64) {
        (weights.sum(&self.functions), weights.size(&self.tolerance))
    }
}

/// The functions at one place.
struct Sample {
    terms: [Dual; TERMS],
    pressures: [f64; PRESSURES],
    divisor: f64,
    factor: f64,
}

impl Sample {
    fn new(balance: Balance, contact: &Contact) -> Self {
        let (s, c) = (contact.angle().sin(), contact.angle().cos());
        let radius = contact.regular().radius.value;
        let n = f64::from(contact.strands());
        let chord = radius * contact.one_minus_cos_beta() / c; // ρ(1 − cos β)
        // p̂/cos²θ by (37), which is finite at both ends
        let (ring, hoop) = (s / (radius * radius), s * c / (radius * radius * radius));
        let (share, divisor, factor) = match balance {
            Balance::Contact => (0.5 * radius * c, 1.0, chord),
            Balance::Radial => (c * c * (c / chord), c, chord / c),
        };
        let pressures = [-(hoop * s * s * s), -(hoop * s * c * c), -(ring * c), ring / n].map(|term| share * term);
        Self { terms: balance.terms(contact), pressures, divisor, factor }
    }
}

/// Values at the nodes, and then how far the polynomial through them is off.
pub(in crate::mechanics) fn judged(
    values: &Coefficients,
    sizes: f64,
    between: impl Fn(usize) -> f64,
) -> (Coefficients, f64) {
    let powers = septic::powers(values);
    let off = (0..ORDER - 1).map(|i| {
        let u = 0.5 * (NODES[i] + NODES[i + 1]);
        (septic::value(&powers, u) - between(i)).abs()
    });
    (septic::bernstein(values), 4.0 * off.fold(2.0 * f64::EPSILON * sizes, f64::max))
}

pub(in crate::mechanics) fn largest(values: &Coefficients) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
}

/// tₖ′ tₗ − tₖ tₗ′ for k < l, and the size of its parts.
fn wronskians(terms: &[Dual; TERMS], half: f64) -> [(f64, f64); PAIRS] {
    let mut pairs = [(0.0, 0.0); PAIRS];
    let places = (0..TERMS).flat_map(|k| (k + 1..TERMS).map(move |l| (k, l)));
    for (pair, (k, l)) in pairs.iter_mut().zip(places) {
        let (there, here) = (half * terms[k].slope * terms[l].value, half * terms[k].value * terms[l].slope);
        *pair = (there - here, there.abs() + here.abs());
    }
    pairs
}

/// The weights of the pairs in A′B − AB′, from those of A and B.
pub(super) fn pair_weights(a: &[f64; TERMS], b: &[f64; TERMS]) -> Weights {
    let places = (0..TERMS).flat_map(|k| (k + 1..TERMS).map(move |l| (k, l)));
    Weights::new(&places.map(|(k, l)| a[k] * b[l] - a[l] * b[k]).collect::<Vec<_>>())
}

impl Cell {
    pub(super) fn fit(strands: u32, balance: Balance, flat: bool, start: f64, end: f64) -> Self {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start));
        let sample = |t: f64| {
            // π/4 itself belongs to the steep half, so that both see the same numbers on their common border
            let by_pitch = flat && t < FRAC_PI_4;
            let angle = if by_pitch { HelicalAngle::flat(t) } else { HelicalAngle::steep(t) };
            let mut sample = Sample::new(balance, &Contact::at(strands, angle));
            if flat {
                sample.terms = sample.terms.map(|term| Dual::new(term.value, -term.slope));
            }
            sample
        };
        let at: [Sample; ORDER] = core::array::from_fn(|i| match i {
            0 => sample(start),
            7 => sample(end),
            _ => sample(middle + half * NODES[i]),
        });
        let between: [Sample; ORDER - 1] =
            core::array::from_fn(|i| sample(middle + half * (0.5 * (NODES[i] + NODES[i + 1]))));
        let nodes = |f: &dyn Fn(&Sample) -> f64| -> Coefficients { core::array::from_fn(|i| f(&at[i])) };

        let values: [Coefficients; TERMS] = core::array::from_fn(|k| nodes(&|s| s.terms[k].value));
        let terms = core::array::from_fn(|k| judged(&values[k], largest(&values[k]), |i| between[i].terms[k].value));
        let faithful = (0..TERMS).all(|k| {
            // where a term crosses zero rounding is that of its parts, which are as large as it is some way off
            let size = at.iter().fold(0.0, |size: f64, s| {
                let Dual { value, slope } = s.terms[k];
                size.max(value.abs() + slope.abs() * end)
            });
            let (_, tolerance): (Coefficients, f64) = terms[k];
            tolerance <= 4.0 * FAITHFUL * size
        });
        let pairs = at.each_ref().map(|s| wronskians(&s.terms, half));
        let pairs_between = between.each_ref().map(|s| wronskians(&s.terms, half));
        let wronskians = core::array::from_fn(|k| {
            let size = pairs.iter().fold(0.0, |largest: f64, pair| largest.max(pair[k].1));
            judged(&core::array::from_fn(|i| pairs[i][k].0), 2.0 * size, |i| pairs_between[i][k].0)
        });
        let pressures: [Coefficients; PRESSURES] = core::array::from_fn(|k| nodes(&|s| s.pressures[k]));
        Self {
            flat,
            edge: start == 0.0,
            faithful,
            middle,
            half,
            per_half: 1.0 / half,
            terms: Judged::new(terms),
            wronskians: Judged::new(wronskians),
            powers: values.map(|values| septic::powers(&values)),
            pressure: Pressure {
                terms: pressures.map(|values| septic::powers(&values)),
                size: pressures.map(|values| largest(&values)),
                divisor: (balance == Balance::Radial).then(|| septic::powers(&nodes(&|s| s.divisor))),
                factor: septic::powers(&nodes(&|s| s.factor)),
            },
        }
    }

    /// The helical and the pitch angle at u.
    #[inline]
    pub(in crate::mechanics) fn angles(&self, u: f64) -> (f64, f64) {
        let t = self.middle + self.half * u;
        let complement = (FRAC_PI_2 - t) + FRAC_PI_2_REST;
        if self.flat { (complement, t) } else { (t, complement) }
    }

    pub(super) fn end(&self) -> f64 {
        self.middle + self.half
    }

    /// The helical angle at u as a place on the branch.
    pub(super) fn place(&self, u: f64) -> HelicalAngle {
        let t = self.middle + self.half * u;
        if self.flat { HelicalAngle::flat(t) } else { HelicalAngle::steep(t) }
    }
}

impl<const K: usize> Judged<K> {
    fn new(functions: [(Coefficients, f64); K]) -> Self {
        Self { functions: functions.map(|(f, _)| f), tolerance: functions.map(|(_, tolerance)| tolerance) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::row::chart::Chart;

    #[test]
    fn polynomials_keep_the_terms_to_rounding() {
        for balance in Balance::BOTH {
            for strands in [2, 3, 5, 12, 40, 1000] {
                let chart = Chart::of(strands, balance);
                assert!(chart.cells.iter().all(|cell| cell.faithful || cell.edge), "{balance:?}, n = {strands}");
            }
        }
    }
}
