//! Tables of cosⁿ: the oldest way around `pow`.

use super::element::Element;
use crate::kernel::exact::Cost;
use crate::slice::{Job, Unit};
use std::hint::black_box;

/// What a table's samples are spaced evenly in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Over {
    /// cos θ in [0, 1], the textbook's table: at n = 64 three quarters of it hold next to nothing.
    Cosine,
    /// t = n (1 - cos θ) in [0, 16], the lobe's own width whatever n is; the last sample is 0, and so is all
    /// beyond, where cosⁿ ≤ e⁻¹⁶ = 1.1e-7.
    Scaled,
}

/// How a value is taken from the samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lookup {
    /// The nearest sample.
    Nearest,
    /// The straight line between the two neighbours.
    Linear,
}

/// The sizes that are measured.
pub const SIZES: [u32; 4] = [64, 256, 1024, 4096];

/// The end of a table over t.
pub(super) const END: f64 = 16.0;

/// A table's kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sampling {
    /// What the samples are spaced evenly in.
    pub over: Over,
    /// How a value is taken.
    pub lookup: Lookup,
    /// How many samples, one of [`SIZES`].
    pub samples: u32,
}

impl Sampling {
    /// Every kind that is measured.
    ///
    /// ```
    /// use bellfit::trade::Sampling;
    /// assert_eq!(Sampling::all().count(), 16);
    /// ```
    pub fn all() -> impl Iterator<Item = Sampling> {
        [Over::Cosine, Over::Scaled].into_iter().flat_map(|over| {
            [Lookup::Nearest, Lookup::Linear].into_iter().flat_map(move |lookup| {
                SIZES.into_iter().map(move |samples| Sampling { over, lookup, samples })
            })
        })
    }

    /// The distance between samples, in cos θ or t.
    pub(super) fn step(&self) -> f64 {
        let end = if self.over == Over::Cosine { 1.0 } else { END };
        end / f64::from(self.samples - 1)
    }

    /// Operations of a lookup, counted from cos θ: the multiplication to a place in the table, which over t is
    /// a fused multiply-add and a minimum; the conversion to whole; the load. Between two samples besides the
    /// shift by half a step, the conversion back, two differences, the other load and a fused multiply-add.
    pub(super) fn cost(&self) -> Cost {
        let scaled = u32::from(self.over == Over::Scaled);
        let linear = if self.lookup == Lookup::Linear { 6 } else { 0 };
        Cost { operations: 3 + scaled + linear, divisions: 0, transcendentals: 0 }
    }
}

/// Samples of cosⁿ.
pub(super) struct Table<F> {
    sampling: Sampling,
    /// Places a unit of 1 - cos θ.
    scale: F,
    samples: Vec<F>,
}

impl<F: Element> Table<F> {
    pub(super) fn new(sampling: Sampling, n: u32) -> Table<F> {
        let (exponent, last) = (f64::from(n), sampling.samples - 1);
        let sample = |i: u32| match sampling.over {
            Over::Cosine => libm::pow(f64::from(i) / f64::from(last), exponent),
            Over::Scaled if i == last => 0.0,
            Over::Scaled => libm::exp(exponent * libm::log1p(-(f64::from(i) * sampling.step()) / exponent)),
        };
        let samples = (0..=last).map(|i| F::from_f64(sample(i))).collect();
        Table { sampling, scale: F::from_f64(exponent / sampling.step()), samples }
    }

    /// One value at a time.
    pub(super) fn single(&self, x: &[F], out: &mut [F]) {
        self.sized(x, out, true);
    }

    /// On the widest vector unit.
    pub(super) fn slice(&self, x: &[F], out: &mut [F]) {
        self.sized(x, out, false);
    }

    fn sized(&self, x: &[F], out: &mut [F], single: bool) {
        match self.sampling.samples {
            64 => self.kind::<64>(x, out, single),
            256 => self.kind::<256>(x, out, single),
            1024 => self.kind::<1024>(x, out, single),
            _ => self.kind::<4096>(x, out, single),
        }
    }

    fn kind<const N: usize>(&self, x: &[F], out: &mut [F], single: bool) {
        match (self.sampling.over, self.sampling.lookup) {
            (Over::Cosine, Lookup::Nearest) => self.run::<N, false, false>(x, out, single),
            (Over::Cosine, Lookup::Linear) => self.run::<N, false, true>(x, out, single),
            (Over::Scaled, Lookup::Nearest) => self.run::<N, true, false>(x, out, single),
            (Over::Scaled, Lookup::Linear) => self.run::<N, true, true>(x, out, single),
        }
    }

    fn run<const N: usize, const SCALED: bool, const LINEAR: bool>(
        &self,
        x: &[F],
        out: &mut [F],
        single: bool,
    ) {
        let samples: &[F; N] = self.samples.as_slice().try_into().expect("a table of N samples was made");
        let job = Lookups::<F, N, SCALED, LINEAR> { samples, scale: self.scale, x, out };
        if single { job.one_by_one() } else { Unit::best().run(job) }
    }
}

/// Lookups of one kind: everything the loop's code depends on is a constant.
struct Lookups<'a, F, const N: usize, const SCALED: bool, const LINEAR: bool> {
    samples: &'a [F; N],
    scale: F,
    x: &'a [F],
    out: &'a mut [F],
}

impl<F: Element, const N: usize, const SCALED: bool, const LINEAR: bool> Lookups<'_, F, N, SCALED, LINEAR> {
    /// The value at a cosine in [0, 1]; N is a power of two, so that a mask is the bounds check.
    #[inline(always)]
    fn value(samples: &[F; N], scale: F, cos: F) -> F {
        let top = F::from_u32(N as u32 - 1);
        let place = if SCALED {
            let place = scale - scale * cos;
            if place < top { place } else { top }
        } else {
            top * cos
        };
        // Rounding to whole by a large addend needs no conversion, of which vector units have few.
        if !LINEAR {
            return samples[(place + F::SHIFT).low_bits() & (N - 1)];
        }
        // ½ lower the nearest whole number is the one below; at a tie either neighbour will do.
        let whole = (place - F::HALF) + F::SHIFT;
        let below = whole.low_bits() & (N - 1);
        let (a, b) = (samples[below], samples[(below + 1) & (N - 1)]);
        a + (b - a) * (place - (whole - F::SHIFT))
    }

    fn one_by_one(self) {
        for (x, out) in self.x.iter().zip(self.out) {
            *out = black_box(Self::value(self.samples, self.scale, black_box(*x)));
        }
    }
}

impl<F: Element, const N: usize, const SCALED: bool, const LINEAR: bool> Job
    for Lookups<'_, F, N, SCALED, LINEAR>
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (x, out) in self.x.iter().zip(self.out) {
            *out = Self::value(self.samples, self.scale, *x);
        }
    }
}
