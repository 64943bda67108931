//! A kernel over slices: out of place, in place, or summed.

use super::Unit;
use super::kernel::{Kernel, Kernel2};
use super::lanes::Lanes;
use super::unit::FusedJob;

/// The slices of a call, which takes a kernel to them.
pub(super) trait Pass<F: Lanes> {
    type Output;

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) -> Self::Output;
}

/// The same with a second argument beside each element.
pub(super) trait Pass2<F: Lanes> {
    type Output;

    fn two<K: Kernel2<F>>(self, unit: Unit, kernel: K) -> Self::Output;
}

/// x to out.
pub(super) struct Across<'a, F> {
    pub x: &'a [F],
    pub out: &'a mut [F],
}

/// x to itself.
pub(super) struct Within<'a, F>(pub &'a mut [F]);

/// Σ weight f(x).
pub(super) struct Sum<'a, F> {
    pub x: &'a [F],
    pub weights: &'a [F],
}

/// A pass with second arguments.
pub(super) struct Beside<'a, P, F> {
    pub pass: P,
    pub n: &'a [F],
}

/// A pass over the sums of two slices.
pub(super) struct Added<'a, P, F>(pub Beside<'a, P, F>);

struct Map<'a, K, F> {
    kernel: K,
    x: &'a [F],
    out: &'a mut [F],
}

impl<F: Lanes, K: Kernel<F>> FusedJob for Map<'_, K, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        self.kernel.across::<FUSED>(self.x, self.out);
    }
}

struct MapWithin<'a, K, F> {
    kernel: K,
    x: &'a mut [F],
}

impl<F: Lanes, K: Kernel<F>> FusedJob for MapWithin<'_, K, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        self.kernel.within::<FUSED>(self.x);
    }
}

struct Map2<'a, K, F> {
    kernel: K,
    x: &'a [F],
    n: &'a [F],
    out: &'a mut [F],
}

impl<F: Lanes, K: Kernel2<F>> FusedJob for Map2<'_, K, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        self.kernel.across::<FUSED, _>(self.x, self.n, self.out);
    }
}

struct MapWithin2<'a, K, F> {
    kernel: K,
    x: &'a mut [F],
    n: &'a [F],
}

impl<F: Lanes, K: Kernel2<F>> FusedJob for MapWithin2<'_, K, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        self.kernel.within::<FUSED, _>(self.x, self.n);
    }
}

impl<F: Lanes> Pass<F> for Across<'_, F> {
    type Output = ();

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) {
        unit.run_fused(Map { kernel, x: self.x, out: self.out });
    }
}

impl<F: Lanes> Pass<F> for Within<'_, F> {
    type Output = ();

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) {
        unit.run_fused(MapWithin { kernel, x: self.0 });
    }
}

impl<F: Lanes> Pass2<F> for Beside<'_, Across<'_, F>, F> {
    type Output = ();

    fn two<K: Kernel2<F>>(self, unit: Unit, kernel: K) {
        unit.run_fused(Map2 { kernel, x: self.pass.x, n: self.n, out: self.pass.out });
    }
}

impl<F: Lanes> Pass2<F> for Beside<'_, Within<'_, F>, F> {
    type Output = ();

    fn two<K: Kernel2<F>>(self, unit: Unit, kernel: K) {
        unit.run_fused(MapWithin2 { kernel, x: self.pass.0, n: self.n });
    }
}

/// x[i] + y[i] in place.
struct Add<'a, F>(&'a mut [F], &'a [F]);

impl<F: Lanes> FusedJob for Add<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        for (x, y) in self.0.iter_mut().zip(self.1) {
            *x = *x + *y;
        }
    }
}

impl<F: Lanes> Pass<F> for Added<'_, Within<'_, F>, F> {
    type Output = ();

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) {
        let Beside { pass: Within(x), n } = self.0;
        for (x, y) in x.chunks_mut(BLOCK).zip(n.chunks(BLOCK)) {
            unit.run_fused(Add(x, y));
            unit.run_fused(MapWithin { kernel, x });
        }
    }
}

impl<F: Lanes> Pass<F> for Added<'_, Across<'_, F>, F> {
    type Output = ();

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) {
        let Beside { pass: Across { x, out }, n } = self.0;
        for ((x, out), y) in x.chunks(BLOCK).zip(out.chunks_mut(BLOCK)).zip(n.chunks(BLOCK)) {
            out.copy_from_slice(x);
            unit.run_fused(Add(out, y));
            unit.run_fused(MapWithin { kernel, x: out });
        }
    }
}

impl<F: Lanes> Pass<F> for Added<'_, Sum<'_, F>, F> {
    type Output = F;

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) -> F {
        let (mut block, mut sums) = ([F::ZERO; BLOCK], [F::ZERO; LANES]);
        let Beside { pass: Sum { x, weights }, n } = self.0;
        for ((x, weights), y) in x.chunks(BLOCK).zip(weights.chunks(BLOCK)).zip(n.chunks(BLOCK)) {
            let values = &mut block[..x.len()];
            values.copy_from_slice(x);
            unit.run_fused(Add(values, y));
            unit.run_fused(MapWithin { kernel, x: values });
            unit.run_fused(Gather { values, weights, sums: &mut sums });
        }
        total(sums)
    }
}

/// Elements that are mapped before they are summed: few enough to stay in the nearest cache.
const BLOCK: usize = 512;
/// Partial sums: element j counts to sum j mod LANES, on every unit.
const LANES: usize = 64;

impl<F: Lanes> Pass<F> for Sum<'_, F> {
    type Output = F;

    fn one<K: Kernel<F>>(self, unit: Unit, kernel: K) -> F {
        let (mut block, mut sums) = ([F::ZERO; BLOCK], [F::ZERO; LANES]);
        for (x, weights) in self.x.chunks(BLOCK).zip(self.weights.chunks(BLOCK)) {
            let values = &mut block[..x.len()];
            unit.run_fused(Map { kernel, x, out: values });
            unit.run_fused(Gather { values, weights, sums: &mut sums });
        }
        total(sums)
    }
}

impl<F: Lanes> Pass2<F> for Beside<'_, Sum<'_, F>, F> {
    type Output = F;

    fn two<K: Kernel2<F>>(self, unit: Unit, kernel: K) -> F {
        let (mut block, mut sums) = ([F::ZERO; BLOCK], [F::ZERO; LANES]);
        let Sum { x, weights } = self.pass;
        for ((x, weights), n) in x.chunks(BLOCK).zip(weights.chunks(BLOCK)).zip(self.n.chunks(BLOCK)) {
            let values = &mut block[..x.len()];
            unit.run_fused(Map2 { kernel, x, n, out: values });
            unit.run_fused(Gather { values, weights, sums: &mut sums });
        }
        total(sums)
    }
}

/// Adds weight times value to the partial sums.
struct Gather<'a, F> {
    values: &'a [F],
    weights: &'a [F],
    sums: &'a mut [F; LANES],
}

impl<F: Lanes> FusedJob for Gather<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let mut sums = *self.sums;
        let (values, values_rest) = self.values.as_chunks::<LANES>();
        let (weights, weights_rest) = self.weights.as_chunks::<LANES>();
        for (v, w) in values.iter().zip(weights) {
            for i in 0..LANES {
                sums[i] = F::fma::<FUSED>(v[i], w[i], sums[i]);
            }
        }
        for ((sum, v), w) in sums.iter_mut().zip(values_rest).zip(weights_rest) {
            *sum = F::fma::<FUSED>(*v, *w, *sum);
        }
        *self.sums = sums;
    }
}

/// The partial sums together, halves onto halves.
fn total<F: Lanes>(mut sums: [F; LANES]) -> F {
    let mut half = LANES / 2;
    while half > 0 {
        for i in 0..half {
            sums[i] = sums[i] + sums[i + half];
        }
        half /= 2;
    }
    sums[0]
}
