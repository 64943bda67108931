//! What is done to each element, its constants folded beforehand.

use super::exponential::exp;
use super::lanes::Lanes;
use super::second::{Same, Second};
use crate::kernel::cubic::BellFormula;

/// A function of one element; `at` is `#[inline(always)]` and without branches.
pub(super) trait Kernel<F: Lanes>: Copy {
    fn at<const FUSED: bool>(self, x: F) -> F;

    /// out[i] = f(x[i]).
    #[inline(always)]
    fn across<const FUSED: bool>(self, x: &[F], out: &mut [F]) {
        for (out, x) in out.iter_mut().zip(x) {
            *out = self.at::<FUSED>(*x);
        }
    }

    /// x[i] = f(x[i]).
    #[inline(always)]
    fn within<const FUSED: bool>(self, x: &mut [F]) {
        for x in x {
            *x = self.at::<FUSED>(*x);
        }
    }
}

/// A function of two: an argument and its exponent, or the squares along two axes.
pub(super) trait Kernel2<F: Lanes>: Copy {
    fn at<const FUSED: bool>(self, x: F, n: F) -> F;

    /// out[i] = f(x[i], n[i]).
    #[inline(always)]
    fn across<const FUSED: bool, N: Second<F>>(self, x: &[F], n: N, out: &mut [F]) {
        let n = n.part(0, x.len());
        for (i, (out, x)) in out.iter_mut().zip(x).enumerate() {
            *out = self.at::<FUSED>(*x, n.at(i));
        }
    }

    /// x[i] = f(x[i], n[i]).
    #[inline(always)]
    fn within<const FUSED: bool, N: Second<F>>(self, x: &mut [F], n: N) {
        let n = n.part(0, x.len());
        for (i, x) in x.iter_mut().enumerate() {
            *x = self.at::<FUSED>(*x, n.at(i));
        }
    }
}

/// p to the power 2^S, 0 for p below 0.
#[inline(always)]
fn power<const S: u32, F: Lanes>(p: F) -> F {
    let mut power = p.positive();
    for _ in 0..S {
        power = power * power;
    }
    power
}

/// (a + b x) to the power 2^S.
#[derive(Clone, Copy)]
pub(super) struct Line<const S: u32, F>(pub [F; 2]);

impl<const S: u32, F: Lanes> Kernel<F> for Line<S, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        let [a, b] = self.0;
        power::<S, F>(F::fma::<FUSED>(b, x, a))
    }
}

/// (1 - x (k₁ - x (k₂ - x k₃))) to the power 2^S.
#[derive(Clone, Copy)]
pub(super) struct Horner<const S: u32, F>(pub [F; 3]);

impl<const S: u32, F: Lanes> Kernel<F> for Horner<S, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        let [k1, k2, k3] = self.0;
        let inner = F::fma::<FUSED>(-x, k3, k2);
        power::<S, F>(F::fma::<FUSED>(-x, F::fma::<FUSED>(-x, inner, k1), F::ONE))
    }
}

/// (u³ + c u + d) to the power 2^S, u = a + b x.
#[derive(Clone, Copy)]
pub(super) struct Depressed<const S: u32, F>(pub [F; 4]);

impl<const S: u32, F: Lanes> Kernel<F> for Depressed<S, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        let [a, b, c, d] = self.0;
        let u = F::fma::<FUSED>(b, x, a);
        power::<S, F>(F::fma::<FUSED>(F::fma::<FUSED>(u, u, c), u, d))
    }
}

/// A kernel of 1 - x.
#[derive(Clone, Copy)]
pub(super) struct OneLess<K>(pub K);

impl<F: Lanes, K: Kernel<F>> Kernel<F> for OneLess<K> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        self.0.at::<FUSED>(F::ONE - x)
    }
}

/// A kernel, but 0 outside [lo, hi].
#[derive(Clone, Copy)]
pub(super) struct Guarded<K, F> {
    pub kernel: K,
    pub range: [F; 2],
}

impl<F: Lanes, K: Kernel<F>> Kernel<F> for Guarded<K, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        let [lo, hi] = self.range;
        let value = self.kernel.at::<FUSED>(x);
        if x < lo || x > hi { F::ZERO } else { value }
    }
}

/// e^(b x).
#[derive(Clone, Copy)]
pub(super) struct Exponential<F>(pub F);

impl<F: Lanes> Kernel<F> for Exponential<F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        exp::<FUSED, F>(self.0 * x)
    }
}

/// 1, NaN for NaN.
#[derive(Clone, Copy)]
pub(super) struct One;

impl<F: Lanes> Kernel<F> for One {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        if x.is_nan() { x } else { F::ONE }
    }
}

/// The n of a kernel of two arguments, one for all.
#[derive(Clone, Copy)]
pub(super) struct With<K, F>(pub K, pub F);

impl<F: Lanes, K: Kernel2<F>> Kernel<F> for With<K, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        self.0.at::<FUSED>(x, self.1)
    }

    #[inline(always)]
    fn across<const FUSED: bool>(self, x: &[F], out: &mut [F]) {
        self.0.across::<FUSED, _>(x, Same(self.1), out);
    }

    #[inline(always)]
    fn within<const FUSED: bool>(self, x: &mut [F]) {
        self.0.within::<FUSED, _>(x, Same(self.1));
    }
}

/// Bells p^K whose constants follow from each element's n.
///
/// `place` is (1, -1) for cosines and (0, 1) for versines: w = place.0 + place.1 x.
#[derive(Clone, Copy)]
pub(super) struct Each<T, F> {
    pub of: T,
    pub place: [F; 2],
    pub range: [F; 2],
}

/// p of a versine and an exponent.
pub(super) trait Folded<F>: Copy {
    const SQUARINGS: u32;

    fn base<const FUSED: bool>(self, w: F, n: F) -> F;
}

impl<F: Lanes, T: Folded<F>> Kernel2<F> for Each<T, F> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F, n: F) -> F {
        let w = self.place[0] + self.place[1] * x; // exact but for the cosine's difference
        let mut value = self.of.base::<FUSED>(w, n).positive();
        for _ in 0..T::SQUARINGS {
            value = value * value;
        }
        if x < self.range[0] || x > self.range[1] { F::ZERO } else { value }
    }
}

/// 1 - n w/K, K = 2^S.
#[derive(Clone, Copy)]
pub(super) struct Lyon<const S: u32>;

impl<const S: u32, F: Lanes> Folded<F> for Lyon<S> {
    const SQUARINGS: u32 = S;

    #[inline(always)]
    fn base<const FUSED: bool>(self, w: F, n: F) -> F {
        line::<FUSED, F>(n, n / F::from_u32(1 << S), w)
    }
}

/// 1 - n w/T(n).
#[derive(Clone, Copy)]
pub(super) struct Reach<const S: u32, F>([F; 3]);

impl<const S: u32, F: Lanes> Reach<S, F> {
    pub fn new(formula: &BellFormula) -> Self {
        Reach(formula.reach.map(F::from_f64))
    }
}

impl<const S: u32, F: Lanes> Folded<F> for Reach<S, F> {
    const SQUARINGS: u32 = S;

    #[inline(always)]
    fn base<const FUSED: bool>(self, w: F, n: F) -> F {
        line::<FUSED, F>(n, n / quadratic(self.0, n), w)
    }
}

/// 1 - slope w, NaN for an n that has no lobe.
#[inline(always)]
fn line<const FUSED: bool, F: Lanes>(n: F, slope: F, w: F) -> F {
    let p = F::fma::<FUSED>(-slope, w, F::ONE);
    if n >= F::ZERO && slope.is_finite() { p } else { F::NAN }
}

/// The cubic of a [`BellFormula`], K = 2^S.
#[derive(Clone, Copy)]
pub(super) struct Cubic<const S: u32, F>([[F; 3]; 3]);

impl<const S: u32, F: Lanes> Cubic<S, F> {
    pub fn new(formula: &BellFormula) -> Self {
        Cubic([formula.reach, formula.linear, formula.square].map(|c| c.map(F::from_f64)))
    }
}

impl<const S: u32, F: Lanes> Folded<F> for Cubic<S, F> {
    const SQUARINGS: u32 = S;

    #[inline(always)]
    fn base<const FUSED: bool>(self, w: F, n: F) -> F {
        let [reach, linear, square] = self.0;
        let (linear, square, r) = (quadratic(linear, n), quadratic(square, n), n / quadratic(reach, n));
        let (k1, k2, k3) = ((F::ONE - linear) * r, (square - linear) * r * r, square * r * r * r);
        let inner = F::fma::<FUSED>(-w, F::fma::<FUSED>(-w, k3, k2), k1);
        let p = F::fma::<FUSED>(-w, inner, F::ONE);
        if n > F::ZERO && k3.is_finite() { p } else { F::NAN }
    }
}

/// c₀ + c₁/n + c₂/n².
#[inline(always)]
fn quadratic<F: Lanes>([a, b, c]: [F; 3], n: F) -> F {
    let m = F::ONE / n;
    a + m * (b + m * c)
}

/// Schlick's lobe from the cosine or the versine.
#[derive(Clone, Copy)]
pub(super) struct Schlick<const VERSINE: bool>;

impl<const VERSINE: bool, F: Lanes> Kernel2<F> for Schlick<VERSINE> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F, n: F) -> F {
        let (c, w) = (if VERSINE { F::ONE - x } else { x }, if VERSINE { x } else { F::ONE - x });
        quotient(c, F::fma::<FUSED>(n, w, c), n)
    }
}

/// The same as printed, of the cosine.
#[derive(Clone, Copy)]
pub(super) struct SchlickPrinted;

impl<F: Lanes> Kernel2<F> for SchlickPrinted {
    #[inline(always)]
    fn at<const FUSED: bool>(self, c: F, n: F) -> F {
        quotient(c, F::fma::<FUSED>(-n, c, n) + c, n)
    }
}

/// c by the denominator, 0 for c ≤ 0, NaN for n.
#[inline(always)]
fn quotient<F: Lanes>(c: F, denominator: F, n: F) -> F {
    let value = if c <= F::ZERO { F::ZERO } else { c / denominator };
    if n.is_nan() { n } else { value }
}

/// e^(-n w).
#[derive(Clone, Copy)]
pub(super) struct Gaussian<const VERSINE: bool>;

impl<const VERSINE: bool, F: Lanes> Kernel2<F> for Gaussian<VERSINE> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F, n: F) -> F {
        let w = if VERSINE { x } else { F::ONE - x };
        exp::<FUSED, F>(-(n * w))
    }
}

/// A product of the same weight along both.
#[derive(Clone, Copy)]
pub(super) struct Product<K>(pub K);

impl<F: Lanes, K: Kernel<F>> Kernel2<F> for Product<K> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, aa: F, bb: F) -> F {
        self.0.at::<FUSED>(aa) * self.0.at::<FUSED>(bb)
    }
}

/// A scalar function, where no lanes are worth it.
#[derive(Clone, Copy)]
pub(super) struct Singly<T>(pub T);

impl<F: Lanes, T: Fn(F) -> F + Copy> Kernel<F> for Singly<T> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F) -> F {
        self.0(x)
    }
}

impl<F: Lanes, T: Fn(F, F) -> F + Copy> Kernel2<F> for Singly<T> {
    #[inline(always)]
    fn at<const FUSED: bool>(self, x: F, n: F) -> F {
        self.0(x, n)
    }
}
