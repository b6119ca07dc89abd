//! Points spread over a box: Sobol's sequence and Latin hypercubes, any point by its number alone.

use sobol::Sobol;
use sobol::params::JoeKuoD6;

use super::Sample;

/// The most dimensions: that many data there are not.
const MOST: usize = 100;
/// A double has so many digits below 1.
const DIGITS: u32 = 53;

/// A sample of so many points.
#[derive(Clone, Debug)]
pub(super) struct Points {
    kind: Sample,
    count: u64,
    seed: u64,
    /// Sobol's direction numbers, digit by digit, of every dimension
    directions: Vec<Vec<u64>>,
}

impl Points {
    pub(super) fn new(kind: Sample, count: u64, seed: u64, dimensions: usize) -> Self {
        let directions = match kind {
            Sample::Sobol => {
                let parameters = JoeKuoD6::minimal();
                Sobol::<f64>::init_direction_vals(dimensions.min(MOST), 52, &parameters)
            }
            Sample::Latin => Vec::new(),
        };
        Self { kind, count, seed, directions }
    }

    /// Where a point lies along a dimension, 0 to below 1.
    pub(super) fn share(&self, point: u64, dimension: usize) -> f64 {
        let key = mixed(self.seed ^ mixed(dimension as u64 + 1));
        match self.kind {
            Sample::Sobol => {
                let Some(directions) = self.directions.get(dimension) else { return unit(mixed(key ^ point)) };
                let (mut digits, mut rest, mut sum) = (directions.iter(), point, key);
                while rest != 0 {
                    let Some(direction) = digits.next() else { break };
                    if rest & 1 == 1 {
                        sum ^= direction;
                    }
                    rest >>= 1;
                }
                unit(sum)
            }
            Sample::Latin => {
                let part = shuffled(point, self.count, key);
                let within = unit(mixed(key ^ mixed(part)));
                // rounding must not lead into the next part
                ((part as f64 + within) / self.count as f64).min(((part + 1) as f64 / self.count as f64).next_down())
            }
        }
    }
}

/// The first digits as a number from 0 to below 1.
fn unit(bits: u64) -> f64 {
    (bits >> (u64::BITS - DIGITS)) as f64 / (1_u64 << DIGITS) as f64
}

/// Bits well mixed, one to one: the last step of Steele, Lea and Flood's SplitMix (2014).
const fn mixed(bits: u64) -> u64 {
    let bits = bits.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// One number below `count` for each, in an order of the key's own: Feistel's network on as many bits as are needed, walked on until the
/// number is below `count` (Black and Rogaway 2002).
fn shuffled(number: u64, count: u64, key: u64) -> u64 {
    const ROUNDS: u64 = 6;
    let bits = (u64::BITS - count.saturating_sub(1).leading_zeros()).max(2);
    let half = bits.div_ceil(2);
    let mask = (1_u64 << half) - 1;
    let mut number = number;
    loop {
        let (mut left, mut right) = (number >> half, number & mask);
        for round in 0..ROUNDS {
            (left, right) = (right, left ^ (mixed(right ^ mixed(key ^ round)) & mask));
        }
        number = (left << half) | right;
        if number < count {
            return number;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_of_a_latin_hypercube_has_one_point_along_every_dimension() {
        for count in [1, 2, 3, 7, 64, 1000, 4097] {
            let points = Points::new(Sample::Latin, count, 5, 3);
            for dimension in 0..3 {
                let mut parts: Vec<u64> =
                    (0..count).map(|i| (points.share(i, dimension) * count as f64) as u64).collect();
                parts.sort_unstable();
                assert_eq!(parts, (0..count).collect::<Vec<_>>(), "{count} {dimension}");
            }
        }
        let points = Points::new(Sample::Latin, 1000, 5, 2);
        let order = |dimension| (0..1000).map(|i| (points.share(i, dimension) * 1000.0) as u64).collect::<Vec<_>>();
        assert_ne!(order(0), order(1));
        // as good as uncorrelated
        let correlation: f64 =
            (0..1000).map(|i| (points.share(i, 0) - 0.5) * (points.share(i, 1) - 0.5)).sum::<f64>() / 1000.0 * 12.0;
        assert!(correlation.abs() < 0.1, "{correlation}");
    }

    #[test]
    fn sobols_points_are_a_net() {
        let points = Points::new(Sample::Sobol, 1 << 20, 9, 8);
        let mut distinct = std::collections::BTreeSet::new();
        for first in [0_u64, 256, 3 << 8, 1 << 33] {
            for dimension in 0..8 {
                let mut parts: Vec<u64> =
                    (first..first + 256).map(|i| (points.share(i, dimension) * 256.0) as u64).collect();
                parts.sort_unstable();
                assert_eq!(parts, (0..256).collect::<Vec<_>>(), "{first} {dimension}");
            }
            // the first two dimensions are a (0, 2)-sequence: every elementary box of area 1/256 has one point
            for wide in 0..=8_u32 {
                let boxes: std::collections::BTreeSet<(u64, u64)> = (first..first + 256)
                    .map(|i| {
                        let at = |dimension, bits: u32| (points.share(i, dimension) * f64::from(1_u32 << bits)) as u64;
                        (at(0, wide), at(1, 8 - wide))
                    })
                    .collect();
                assert_eq!(boxes.len(), 256, "{first} {wide}");
            }
        }
        distinct.extend((0..4096).map(|i| points.share(i, 3).to_bits()));
        assert_eq!(distinct.len(), 4096);
        let other = Points::new(Sample::Sobol, 1 << 20, 10, 8);
        assert!((0..8).all(|dimension| (other.share(0, dimension) - points.share(0, dimension)).abs() > 1e-9));
    }
}
