//! cosⁿ for whole n by squarings, in lanes.

use super::kernel::Kernel;
use super::lanes::Lanes;
use crate::kernel::power::cos_n_whole;

/// One n for all: the multiplications of [`cos_n_whole`] in the same order, so the same bits.
#[derive(Clone, Copy)]
pub(super) struct Squarings<const VERSINE: bool>(Option<u32>);

impl<const VERSINE: bool> Squarings<VERSINE> {
    pub fn new<F: Lanes>(n: F) -> Self {
        let n = n.to_f64();
        let whole = n as u32;
        Squarings((f64::from(whole) == n).then_some(whole))
    }
}

/// Elements whose bases and powers stay in the nearest cache from one squaring to the next.
const BLOCK: usize = 256;

impl<const VERSINE: bool, F: Lanes> Kernel<F> for Squarings<VERSINE> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        self.0.map_or(F::NAN, |n| cos_n_whole(cosine::<VERSINE, F>(x), n))
    }

    #[inline(always)]
    fn across<const FUSED: bool>(self, x: &[F], out: &mut [F]) {
        for (x, out) in x.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            out.copy_from_slice(x);
            self.block(out);
        }
    }

    #[inline(always)]
    fn within<const FUSED: bool>(self, x: &mut [F]) {
        for x in x.chunks_mut(BLOCK) {
            self.block(x);
        }
    }
}

#[inline(always)]
fn cosine<const VERSINE: bool, F: Lanes>(x: F) -> F {
    if VERSINE { F::ONE - x } else { x }
}

impl<const VERSINE: bool> Squarings<VERSINE> {
    #[inline(always)]
    fn block<F: Lanes>(self, x: &mut [F]) {
        let Some(n) = self.0 else { return x.fill(F::NAN) };
        let mut bases = [F::ZERO; BLOCK];
        let bases = &mut bases[..x.len()];
        for (base, x) in bases.iter_mut().zip(&mut *x) {
            *base = cosine::<VERSINE, F>(*x).positive();
            *x = if n == 0 && !base.is_nan() { F::ONE } else { *base };
        }
        for bit in (0..n.checked_ilog2().unwrap_or(0)).rev() {
            if (n >> bit) & 1 == 1 {
                for (x, base) in x.iter_mut().zip(&*bases) {
                    *x = *x * *x * *base;
                }
            } else {
                for x in &mut *x {
                    *x = *x * *x;
                }
            }
        }
    }
}
