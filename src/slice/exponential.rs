//! eˣ and 2ˣ in lanes, without branches.

use super::lanes::Lanes;
use std::array::from_fn;

/// eˣ, subnormal results rounded once more; 0 and ∞ where it leaves the range, NaN for NaN.
#[inline(always)]
pub(super) fn exp<const FUSED: bool, F: Lanes>(x: F) -> F {
    let [lo, hi] = F::EXP_RANGE;
    let x = x.clamped(lo, hi);
    let k = F::fma::<FUSED>(x, F::LOG2_E, F::ROUND) - F::ROUND;
    let [high, low] = F::LN_2;
    let r = F::fma::<FUSED>(-k, low, F::fma::<FUSED>(-k, high, x));
    let p = F::fma::<FUSED>(r, r.polynomial::<FUSED>(F::EXP), F::ONE);
    scaled::<FUSED, F>(p, k)
}

/// p 2ᵏ for p in [√½, √2] and every k that [`exp`] meets, in two steps so that each power of two is a number.
#[inline(always)]
pub(super) fn scaled<const FUSED: bool, F: Lanes>(p: F, k: F) -> F {
    let half = F::fma::<FUSED>(k, F::HALF, F::ROUND_BIASED);
    let rest = (k - (half - F::ROUND_BIASED)) + F::ROUND_BIASED;
    p * half.raised() * rest.raised()
}

/// 2ʸ, 0 where that is subnormal, ∞ above the range; a number without meaning for NaN.
#[inline(always)]
pub(super) fn exp2_flushed<const FUSED: bool, F: Lanes>(y: F) -> F {
    let [least, most] = F::EXPONENTS;
    let inside = y.clamped(least, most);
    let whole = inside + F::ROUND;
    let f = inside - (whole - F::ROUND);
    let p = F::fma::<FUSED>(f, f.polynomial::<FUSED>(F::EXP2), F::ONE);
    // At the upper end p is 1 and the exponent's field full: ∞.
    let value = p.shifted(whole);
    if y < least { F::ZERO } else { value }
}

/// [`exp2_flushed`] of several y ≤ 0 at once, to the same bits.
#[inline(always)]
pub(super) fn exp2_below<const FUSED: bool, F: Lanes, const U: usize>(y: [F; U]) -> [F; U] {
    let [least, _] = F::EXPONENTS;
    // One below the least exponent p is 1 and its exponent's field empty: 0.
    let inside = y.map(|y| if y < least { least - F::ONE } else { y });
    let whole = inside.map(|y| y + F::ROUND);
    let f = from_fn(|j| inside[j] - (whole[j] - F::ROUND));
    let p = F::polynomials::<FUSED, U>(f, F::EXP2);
    from_fn(|j| F::fma::<FUSED>(f[j], p[j], F::ONE).shifted(whole[j]))
}
