//! Contact for whole arrays: x and ρ straight from polynomials, four rows at a time.
//!
//! No sine is worked out and nothing is iterated. What a row needs is six loads of four coefficients, the same whatever
//! its number of strands, so that rows of any numbers may stand in any order.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::contact_chart::{CHARTS, LAST, PIECES};
use super::{Contact, HelicalAngle, check_strands};
use crate::DomainError;
use crate::numerics::wide::{Four, Job, LANES, Wide, dispatch};

/// What π/4 and π/2 as doubles leave out.
const FRAC_PI_4_REST: f64 = 3.061_616_997_868_383e-17;
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;

/// 1.5·2⁵²: added to a small number, it leaves the nearest whole number in the last bits of the sum.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// Groups of four rows in a block, whose steps are taken one after the other for all of them: each step is a short loop, and
/// the rows in it wait for nothing.
const GROUPS: usize = 4;
/// Rows in a block.
const BLOCK: usize = GROUPS * LANES;

/// A number for each row of a block.
type Rows = [Four; GROUPS];

/// What the steps of a block hand on: u, u², u⁴, the place in the charts, what x and ρ are multiplied and divided by, and whether two
/// strands are in line contact. Kept from block to block, so that it need not be emptied for each.
type Notes = [Rows; 7];

/// x and ρ, (6) and (4), of touching strands for arrays of n and θ: `arclength_shift[i]` and `radius_ratio[i]` as
/// [`Contact::arclength_shift`] and [`Contact::radius_ratio`] of `strands[i]` ≥ 2 and `helical_angles[i]` in [0, π/2) rad.
///
/// A row of other numbers is handed to `refused` with its place and the reason, and holds NaN; it touches no other row. Up to
/// twelve strands a row takes some ten cycles of a processor with AVX2, in any order of n; beyond, as long as a [`Contact`].
///
/// Accuracy: both to 4 units in the last place (1e-15), both ends and the pitchfork of n = 2 at π/4 included. Where the
/// processor has fused multiply-add the last digits are not those of a processor without it, nor those of a [`Contact`], which
/// are the same everywhere.
///
/// # Errors
/// [`DomainError`] unless all arrays are of one length.
///
/// ```
/// use nply::geometry::contact_batch;
/// let (mut shift, mut radius) = ([0.0; 3], [0.0; 3]);
/// let mut reasons = Vec::new();
/// let angles = [20_f64.to_radians(), f64::NAN, 0.5];
/// contact_batch(&[6, 3, 2], &angles, &mut shift, &mut radius, |row, error| reasons.push((row, error.quantity)))?;
/// assert!((radius[0] - 2.0998).abs() < 5e-5); // the paper's Figure 11
/// assert_eq!(reasons, [(1, "helical_angle")]);
/// assert_eq!((shift[2], radius[2]), (0.0, 1.0)); // line contact
/// # Ok::<(), nply::DomainError>(())
/// ```
pub fn contact_batch(
    strands: &[u32],
    helical_angles: &[f64],
    arclength_shift: &mut [f64],
    radius_ratio: &mut [f64],
    mut refused: impl FnMut(usize, DomainError),
) -> Result<(), DomainError> {
    for (name, length) in [
        ("helical_angles", helical_angles.len()),
        ("arclength_shift", arclength_shift.len()),
        ("radius_ratio", radius_ratio.len()),
    ] {
        DomainError::check(length == strands.len(), name, length as f64, "as many as there are numbers of strands")?;
    }
    dispatch(Columns { strands, helical_angles, arclength_shift, radius_ratio, refused: &mut refused });
    Ok(())
}

struct Columns<'a, R> {
    strands: &'a [u32],
    helical_angles: &'a [f64],
    arclength_shift: &'a mut [f64],
    radius_ratio: &'a mut [f64],
    refused: &'a mut R,
}

impl<R: FnMut(usize, DomainError)> Job for Columns<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run<W: Wide>(self, wide: W) {
        let mut notes = [[[0.0; LANES]; GROUPS]; 7];
        let mut first = 0;
        while first < self.strands.len() {
            let rows = first..self.strands.len().min(first + BLOCK);
            let length = rows.len();
            let (strands, angles) = (&self.strands[rows.clone()], &self.helical_angles[rows.clone()]);
            let (shift, radius) = (&mut self.arclength_shift[rows.clone()], &mut self.radius_ratio[rows]);
            let charted = match (
                strands.as_chunks().0.as_chunks().0,
                angles.as_chunks().0.as_chunks().0,
                shift.as_chunks_mut().0.as_chunks_mut().0,
                radius.as_chunks_mut().0.as_chunks_mut().0,
            ) {
                ([strands], [angles], [shift], [radius]) => block(wide, strands, angles, shift, radius, &mut notes),
                _ => {
                    let (mut n, mut theta) = ([[2; LANES]; GROUPS], [[0.0; LANES]; GROUPS]);
                    n.as_flattened_mut()[..length].copy_from_slice(strands);
                    theta.as_flattened_mut()[..length].copy_from_slice(angles);
                    let (mut x, mut rho) = ([[0.0; LANES]; GROUPS], [[0.0; LANES]; GROUPS]);
                    let charted = block(wide, &n, &theta, &mut x, &mut rho, &mut notes);
                    shift.copy_from_slice(&x.as_flattened()[..length]);
                    radius.copy_from_slice(&rho.as_flattened()[..length]);
                    charted
                }
            };
            if !charted {
                one_by_one(strands, angles, shift, radius, |row, error| (self.refused)(first + row, error));
            }
            first += length;
        }
    }
}

/// The rows that are not charted: more strands, or refused.
#[cold]
#[inline(never)]
fn one_by_one(
    strands: &[u32],
    angles: &[f64],
    shift: &mut [f64],
    radius: &mut [f64],
    mut refused: impl FnMut(usize, DomainError),
) {
    for (row, (&n, &theta)) in strands.iter().zip(angles).enumerate() {
        let angle = HelicalAngle::new(theta);
        if (2..=LAST).contains(&n) && angle.is_ok() {
            continue;
        }
        (shift[row], radius[row]) = match check_strands(n).and(angle) {
            Ok(angle) => {
                let contact = Contact::at(n, angle);
                (contact.arclength_shift(), contact.radius_ratio())
            }
            Err(error) => {
                refused(row, error);
                (f64::NAN, f64::NAN)
            }
        };
    }
}

/// x and ρ for the charted rows of a block, and whether all of them are; others get numbers without meaning.
#[inline(always)]
fn block<W: Wide>(
    w: W,
    strands: &[[u32; LANES]; GROUPS],
    angles: &Rows,
    shift: &mut Rows,
    radius: &mut Rows,
    notes: &mut Notes,
) -> bool {
    let [us, u2s, u4s, places, factors, divisors, in_line] = notes;
    let (zero, one) = (w.splat(0.0), w.splat(1.0));
    let pieces = w.splat(PIECES as f64);
    let mut charted = 0b1111;
    for i in 0..GROUPS {
        let [a, b, c, d] = strands[i].map(|n| f64::from(n.wrapping_sub(2).cast_signed()));
        let (k, t) = (w.load(&[a, b, c, d]), w.load(&angles[i]));
        let counted = w.and(w.at_least(k, zero), w.at_least(w.splat(f64::from(LAST - 2)), k));
        let good = w.and(counted, w.and(w.at_least(t, zero), w.at_least(w.splat(FRAC_PI_2), t)));
        charted &= w.bits(good);
        let (k, t) = (w.and(good, k), w.and(good, t)); // 0 is as good as any
        let two = w.at_least(zero, k);

        // two strands have all their pieces above π/4
        let share = w.mul(t, w.splat(PIECES as f64 / FRAC_PI_2));
        let place = w.max(w.add(share, w.and(two, w.sub(share, pieces))), zero);
        let below = w.min(w.sub(place, w.splat(0.5)), w.splat(PIECES as f64 - 0.75));
        let marked = w.add(below, w.splat(ROUNDER));
        let piece = w.sub(marked, w.splat(ROUNDER));
        let offset = w.sub(place, piece);
        let u = w.sub(w.add(offset, offset), one);
        let u2 = w.mul(u, u);
        us[i] = w.store(u);
        u2s[i] = w.store(u2);
        u4s[i] = w.store(w.mul(u2, u2));
        places[i] = w.store(w.add(marked, w.mul(k, pieces)));

        let past = w.max(w.sub(w.sub(t, w.splat(FRAC_PI_4)), w.splat(FRAC_PI_4_REST)), zero);
        let pitch = w.add(w.sub(w.splat(FRAC_PI_2), t), w.splat(FRAC_PI_2_REST));
        let flat = w.or(two, w.at_least(piece, w.splat(PIECES as f64 / 2.0)));
        factors[i] = w.store(w.select(two, w.sqrt(past), t));
        divisors[i] = w.store(w.select(flat, pitch, one));
        in_line[i] = w.store(w.and(two, w.at_least(zero, past)));
    }
    for i in 0..GROUPS {
        let (p, u2, u4) = (&places[i], &u2s[i], &u4s[i]);
        let pairs = [
            pair_at(w, p[0], u2[0], u4[0]),
            pair_at(w, p[1], u2[1], u4[1]),
            pair_at(w, p[2], u2[2], u4[2]),
            pair_at(w, p[3], u2[3], u4[3]),
        ];
        let [shift_even, radius_even, shift_odd, radius_odd] = w.transpose(pairs);
        let u = w.load(&us[i]);
        shift[i] = w.store(w.mul_add(shift_odd, u, shift_even));
        radius[i] = w.store(w.mul_add(radius_odd, u, radius_even));
    }
    for i in 0..GROUPS {
        shift[i] = w.store(w.mul(w.load(&factors[i]), w.load(&shift[i])));
        let rho = w.div(w.load(&radius[i]), w.load(&divisors[i]));
        radius[i] = w.store(w.max(w.select(w.load(&in_line[i]), one, rho), one));
    }
    charted == 0b1111
}

/// The even powers of a pair of polynomials, and the odd ones over u.
#[inline(always)]
fn pair_at<W: Wide>(w: W, place: f64, u2: f64, u4: f64) -> W::V {
    let (u2, u4) = (w.splat(u2), w.splat(u4));
    let row = (place.to_bits() & 0x1ff) as usize;
    let [r0, r1, r2, r3, r4, r5] = &CHARTS.0.as_flattened()[row];
    let low = w.mul_add(w.load(r1), u2, w.load(r0));
    let middle = w.mul_add(w.load(r3), u2, w.load(r2));
    let high = w.mul_add(w.load(r5), u2, w.load(r4));
    w.mul_add(w.mul_add(high, u4, middle), u4, low)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::wide::Plain;

    /// Rows near all borders, with every number of strands.
    fn rows() -> (Vec<u32>, Vec<f64>) {
        let places = (0..=480).flat_map(|k| [0.0, 1e-15, -1e-15, 1e-7].map(|d| FRAC_PI_2 * f64::from(k) / 480.0 + d));
        let angles: Vec<f64> = places.map(|t: f64| t.clamp(0.0, FRAC_PI_2)).collect();
        (2..=13_u32).flat_map(|n| angles.iter().map(move |&t| (n, t)).collect::<Vec<_>>()).unzip()
    }

    #[test]
    fn every_machine_gives_the_same_to_a_few_units() {
        let (strands, angles) = rows();
        let work = |plain: bool| {
            let (mut x, mut rho) = (vec![0.0; strands.len()], vec![0.0; strands.len()]);
            let mut refused = |row: usize, _: DomainError| panic!("row {row}");
            let columns = Columns {
                strands: &strands,
                helical_angles: &angles,
                arclength_shift: &mut x,
                radius_ratio: &mut rho,
                refused: &mut refused,
            };
            if plain {
                columns.run(Plain)
            } else {
                dispatch(columns)
            }
            (x, rho)
        };
        let ((x, rho), (fused_x, fused_rho)) = (work(true), work(false));
        for (got, want) in x.iter().zip(&fused_x).chain(rho.iter().zip(&fused_rho)) {
            assert!(got.to_bits().abs_diff(want.to_bits()) <= 3, "{got:e} {want:e}");
        }
    }
}
