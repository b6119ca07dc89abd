//! Four numbers at a time, by what the processor has: chosen once, when the program runs.
//!
//! A kernel is written once, for any [`Wide`]: [`Plain`] on every machine, by products and sums; [`Avx2`] where there is
//! AVX2, by fused multiply-add, which rounds once where the other rounds twice. The two differ in last digits; a kernel's
//! documentation says in how many. This is the only place that asks the processor and the only one that must be trusted.

/// Lanes of a register.
pub(crate) const LANES: usize = 4;

/// One number in every lane, in memory.
pub(crate) type Four = [f64; LANES];

/// What a processor can do with four numbers. A mask has all bits of a lane set, or none.
pub(crate) trait Wide: Copy {
    /// Four numbers in a register.
    type V: Copy;
    fn splat(self, a: f64) -> Self::V;
    fn load(self, a: &Four) -> Self::V;
    fn store(self, a: Self::V) -> Four;
    fn add(self, a: Self::V, b: Self::V) -> Self::V;
    fn sub(self, a: Self::V, b: Self::V) -> Self::V;
    fn mul(self, a: Self::V, b: Self::V) -> Self::V;
    fn div(self, a: Self::V, b: Self::V) -> Self::V;
    fn sqrt(self, a: Self::V) -> Self::V;
    /// ab + c, rounded once or twice.
    fn mul_add(self, a: Self::V, b: Self::V, c: Self::V) -> Self::V;
    /// The lesser, `b` where either is not a number.
    fn min(self, a: Self::V, b: Self::V) -> Self::V;
    /// The greater, `b` where either is not a number.
    fn max(self, a: Self::V, b: Self::V) -> Self::V;
    /// The mask of a ≥ b.
    fn at_least(self, a: Self::V, b: Self::V) -> Self::V;
    fn and(self, a: Self::V, b: Self::V) -> Self::V;
    fn or(self, a: Self::V, b: Self::V) -> Self::V;
    /// `a` where the mask is set, else `b`.
    fn select(self, mask: Self::V, a: Self::V, b: Self::V) -> Self::V;
    /// Bit k for lane k of a mask.
    fn bits(self, mask: Self::V) -> u32;
    /// Lane k of register i to lane i of register k.
    fn transpose(self, a: [Self::V; LANES]) -> [Self::V; LANES];
}

/// What is to be done with the widest registers there are.
pub(crate) trait Job {
    type Output;
    fn run<W: Wide>(self, wide: W) -> Self::Output;
}

/// Does a job with the widest registers there are, and fused multiply-add where there is.
pub(crate) fn dispatch<J: Job>(job: J) -> J::Output {
    run::<J, true>(job)
}

/// As [`dispatch`], by products and sums alone: the same bits on every machine.
pub(crate) fn dispatch_alike<J: Job>(job: J) -> J::Output {
    run::<J, false>(job)
}

fn run<J: Job, const FUSED: bool>(job: J) -> J::Output {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") && std::arch::is_x86_feature_detected!("fma") {
        #[expect(unsafe_code, reason = "the processor was just asked for what the function needs")]
        // SAFETY: AVX2 and fused multiply-add are there.
        return unsafe { avx2::run::<J, FUSED>(job) };
    }
    job.run(Plain)
}

/// Every machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plain;

/// Lane by lane, written out so that nothing stands between the lanes and the register.
#[inline(always)]
fn each(f: impl Fn(usize) -> f64) -> Four {
    [f(0), f(1), f(2), f(3)]
}

/// All bits set, or none.
#[inline(always)]
fn mask(set: bool) -> f64 {
    f64::from_bits(if set { u64::MAX } else { 0 })
}

impl Wide for Plain {
    type V = Four;
    #[inline(always)]
    fn splat(self, a: f64) -> Four {
        [a; LANES]
    }
    #[inline(always)]
    fn load(self, a: &Four) -> Four {
        *a
    }
    #[inline(always)]
    fn store(self, a: Four) -> Four {
        a
    }
    #[inline(always)]
    fn add(self, a: Four, b: Four) -> Four {
        each(|i| a[i] + b[i])
    }
    #[inline(always)]
    fn sub(self, a: Four, b: Four) -> Four {
        each(|i| a[i] - b[i])
    }
    #[inline(always)]
    fn mul(self, a: Four, b: Four) -> Four {
        each(|i| a[i] * b[i])
    }
    #[inline(always)]
    fn div(self, a: Four, b: Four) -> Four {
        each(|i| a[i] / b[i])
    }
    #[inline(always)]
    fn sqrt(self, a: Four) -> Four {
        each(|i| a[i].sqrt())
    }
    #[inline(always)]
    fn mul_add(self, a: Four, b: Four, c: Four) -> Four {
        each(|i| a[i] * b[i] + c[i])
    }
    #[inline(always)]
    fn min(self, a: Four, b: Four) -> Four {
        each(|i| if a[i] < b[i] { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn max(self, a: Four, b: Four) -> Four {
        each(|i| if a[i] > b[i] { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn at_least(self, a: Four, b: Four) -> Four {
        each(|i| mask(a[i] >= b[i]))
    }
    #[inline(always)]
    fn and(self, a: Four, b: Four) -> Four {
        each(|i| f64::from_bits(a[i].to_bits() & b[i].to_bits()))
    }
    #[inline(always)]
    fn or(self, a: Four, b: Four) -> Four {
        each(|i| f64::from_bits(a[i].to_bits() | b[i].to_bits()))
    }
    #[inline(always)]
    fn select(self, mask: Four, a: Four, b: Four) -> Four {
        each(|i| if mask[i].to_bits() >> 63 == 1 { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn bits(self, mask: Four) -> u32 {
        mask.iter().rev().fold(0, |bits, lane| bits << 1 | (lane.to_bits() >> 63) as u32)
    }
    #[inline(always)]
    fn transpose(self, a: [Four; LANES]) -> [Four; LANES] {
        [each(|i| a[i][0]), each(|i| a[i][1]), each(|i| a[i][2]), each(|i| a[i][3])]
    }
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    #![allow(unsafe_code, reason = "an `Avx2` exists only in `run`, where the processor has what its methods need")]

    use core::arch::x86_64::*;

    use super::{Four, Job, LANES, Wide};

    /// Proof that AVX2 and fused multiply-add are there: made in [`run`] alone.
    #[derive(Clone, Copy, Debug)]
    pub(super) struct Avx2<const FUSED: bool>(());

    #[target_feature(enable = "avx2,fma")]
    pub(super) fn run<J: Job, const FUSED: bool>(job: J) -> J::Output {
        job.run(Avx2::<FUSED>(()))
    }

    // SAFETY, of every method: whoever holds an `Avx2` is called by `run`. Loads and stores are of whole arrays.
    impl<const FUSED: bool> Wide for Avx2<FUSED> {
        type V = __m256d;
        #[inline(always)]
        fn splat(self, a: f64) -> __m256d {
            unsafe { _mm256_set1_pd(a) }
        }
        #[inline(always)]
        fn load(self, a: &Four) -> __m256d {
            unsafe { _mm256_loadu_pd(a.as_ptr()) }
        }
        #[inline(always)]
        fn store(self, a: __m256d) -> Four {
            let mut four = [0.0; LANES];
            unsafe { _mm256_storeu_pd(four.as_mut_ptr(), a) };
            four
        }
        #[inline(always)]
        fn add(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_add_pd(a, b) }
        }
        #[inline(always)]
        fn sub(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_sub_pd(a, b) }
        }
        #[inline(always)]
        fn mul(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_mul_pd(a, b) }
        }
        #[inline(always)]
        fn div(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_div_pd(a, b) }
        }
        #[inline(always)]
        fn sqrt(self, a: __m256d) -> __m256d {
            unsafe { _mm256_sqrt_pd(a) }
        }
        #[inline(always)]
        fn mul_add(self, a: __m256d, b: __m256d, c: __m256d) -> __m256d {
            if FUSED { unsafe { _mm256_fmadd_pd(a, b, c) } } else { self.add(self.mul(a, b), c) }
        }
        #[inline(always)]
        fn min(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_min_pd(a, b) }
        }
        #[inline(always)]
        fn max(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_max_pd(a, b) }
        }
        #[inline(always)]
        fn at_least(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_cmp_pd::<_CMP_GE_OQ>(a, b) }
        }
        #[inline(always)]
        fn and(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_and_pd(a, b) }
        }
        #[inline(always)]
        fn or(self, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_or_pd(a, b) }
        }
        #[inline(always)]
        fn select(self, mask: __m256d, a: __m256d, b: __m256d) -> __m256d {
            unsafe { _mm256_blendv_pd(b, a, mask) }
        }
        #[inline(always)]
        fn bits(self, mask: __m256d) -> u32 {
            unsafe { _mm256_movemask_pd(mask) }.cast_unsigned()
        }
        #[inline(always)]
        fn transpose(self, [a, b, c, d]: [__m256d; LANES]) -> [__m256d; LANES] {
            unsafe {
                let (ab_even, ab_odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
                let (cd_even, cd_odd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
                [
                    _mm256_permute2f128_pd::<0x20>(ab_even, cd_even),
                    _mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd),
                    _mm256_permute2f128_pd::<0x31>(ab_even, cd_even),
                    _mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd),
                ]
            }
        }
    }
}
