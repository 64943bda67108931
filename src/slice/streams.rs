//! Powers over blocks: several streams of elements beside each other, as one alone waits for its own steps.

use super::exponential::exp2_below;
use super::kernel::Kernel2;
use super::lanes::Lanes;
use super::power::{exp2_log2, exponents};
use super::second::Second;
use std::array::from_fn;

/// Elements of a block; what is left of a slice goes one by one, to the same bits.
const BLOCK: usize = 256;
/// Streams of a block: four hide the latency of a fused multiply-add, and their state fits sixteen registers.
const STREAMS: usize = 4;
const STREAM: usize = BLOCK / STREAMS;

/// A kernel that has a way of its own with a whole block.
trait Blocks<F: Lanes>: Kernel2<F> {
    /// Whether it has in this type.
    const HAS: bool;

    fn block<const FUSED: bool, N: Second<F>>(self, x: &[F; BLOCK], n: N, out: &mut [F; BLOCK]);
}

/// out[i] = f(x[i], n[i]), the same bits by block as one by one.
#[inline(always)]
fn across<const FUSED: bool, F: Lanes, K: Blocks<F>, N: Second<F>>(kernel: K, x: &[F], n: N, out: &mut [F]) {
    let whole = if K::HAS { x.len() / BLOCK * BLOCK } else { 0 };
    let ((blocks, rest), (outs, out_rest)) = (x.split_at(whole), out.split_at_mut(whole));
    let (blocks, outs) = (blocks.as_chunks().0, outs.as_chunks_mut().0);
    for (i, (x, out)) in blocks.iter().zip(outs).enumerate() {
        kernel.block::<FUSED, N>(x, n.part(i * BLOCK, BLOCK), out);
    }
    one_by_one::<FUSED, F, K, N>(kernel, rest, n.part(whole, rest.len()), out_rest);
}

#[inline(always)]
fn one_by_one<const FUSED: bool, F: Lanes, K: Kernel2<F>, N: Second<F>>(
    kernel: K,
    x: &[F],
    n: N,
    out: &mut [F],
) {
    let n = n.part(0, x.len());
    for (i, (out, x)) in out.iter_mut().zip(x).enumerate() {
        *out = kernel.at::<FUSED>(*x, n.at(i));
    }
}

/// x[i] = f(x[i], n[i]), likewise.
#[inline(always)]
fn within<const FUSED: bool, F: Lanes, K: Blocks<F>, N: Second<F>>(kernel: K, x: &mut [F], n: N) {
    let whole = if K::HAS { x.len() / BLOCK * BLOCK } else { 0 };
    let (blocks, rest) = x.split_at_mut(whole);
    for (i, x) in blocks.as_chunks_mut().0.iter_mut().enumerate() {
        let copy = *x;
        kernel.block::<FUSED, N>(&copy, n.part(i * BLOCK, BLOCK), x);
    }
    let n = n.part(whole, rest.len());
    for (i, x) in rest.iter_mut().enumerate() {
        *x = kernel.at::<FUSED>(*x, n.at(i));
    }
}

macro_rules! kernel {
    ($kernel:ident) => {
        impl<const VERSINE: bool, F: Lanes> Kernel2<F> for $kernel<VERSINE> {
            #[inline(always)]
            fn at<const FUSED: bool>(self, x: F, n: F) -> F {
                self.one::<FUSED, F>(x, n)
            }

            #[inline(always)]
            fn across<const FUSED: bool, N: Second<F>>(self, x: &[F], n: N, out: &mut [F]) {
                across::<FUSED, F, Self, N>(self, x, n, out);
            }

            #[inline(always)]
            fn within<const FUSED: bool, N: Second<F>>(self, x: &mut [F], n: N) {
                within::<FUSED, F, Self, N>(self, x, n);
            }
        }
    };
}

/// cosⁿ to a few ulp.
#[derive(Clone, Copy)]
pub(super) struct Power<const VERSINE: bool>;

impl<const VERSINE: bool> Power<VERSINE> {
    #[inline(always)]
    fn one<const FUSED: bool, F: Lanes>(self, x: F, n: F) -> F {
        x.power::<FUSED, VERSINE>(n)
    }
}

kernel!(Power);

impl<const VERSINE: bool, F: Lanes> Blocks<F> for Power<VERSINE> {
    const HAS: bool = F::POWERS;

    #[inline(always)]
    fn block<const FUSED: bool, N: Second<F>>(self, x: &[F; BLOCK], n: N, out: &mut [F; BLOCK]) {
        for i in 0..STREAM {
            let at = |j| i + j * STREAM;
            let power = F::powers::<FUSED, VERSINE, STREAMS>(from_fn(|j| x[at(j)]), from_fn(|j| n.at(at(j))));
            for j in 0..STREAMS {
                out[at(j)] = power[j];
            }
        }
    }
}

/// 2^(n log₂ c).
#[derive(Clone, Copy)]
pub(super) struct Exp2Log2<const VERSINE: bool>;

impl<const VERSINE: bool> Exp2Log2<VERSINE> {
    #[inline(always)]
    fn cosine<F: Lanes>(x: F) -> F {
        if VERSINE { F::ONE - x } else { x }
    }

    #[inline(always)]
    fn one<const FUSED: bool, F: Lanes>(self, x: F, n: F) -> F {
        exp2_log2::<FUSED, F>(Self::cosine(x), n)
    }

    /// Whether every cosine is at most 1 and every n above 1, none NaN nor infinite: then what is below the
    /// least normal number, 0 and negative cosines with it, flushes to 0 as that number itself does, and no
    /// other end is met.
    #[inline(always)]
    fn is_usual<F: Lanes, N: Second<F>>(x: &[F; BLOCK], n: N) -> bool {
        let mut all = true;
        for (i, x) in x.iter().enumerate() {
            let n = n.at(i);
            all &= (Self::cosine(*x) <= F::ONE) & (n > F::ONE) & (n < F::INFINITY);
        }
        all
    }
}

kernel!(Exp2Log2);

impl<const VERSINE: bool, F: Lanes> Blocks<F> for Exp2Log2<VERSINE> {
    const HAS: bool = true;

    #[inline(always)]
    fn block<const FUSED: bool, N: Second<F>>(self, x: &[F; BLOCK], n: N, out: &mut [F; BLOCK]) {
        if !Self::is_usual(x, n) {
            return one_by_one::<FUSED, F, Self, N>(self, x, n, out);
        }
        let at = |i, j| i + j * STREAM;
        for i in 0..STREAM {
            let (c, n) = (from_fn(|j| Self::cosine(x[at(i, j)])), from_fn(|j| n.at(at(i, j))));
            let y = exponents::<FUSED, F, STREAMS>(c, n);
            for j in 0..STREAMS {
                out[at(i, j)] = y[j];
            }
        }
        // A loop of its own: both in one need more registers than there are.
        for i in 0..STREAM {
            let power = exp2_below::<FUSED, F, STREAMS>(from_fn(|j| out[at(i, j)]));
            for j in 0..STREAMS {
                out[at(i, j)] = power[j];
            }
        }
    }
}
