//! cosⁿ by other ways than `pow`: squarings for whole n, and through the base 2.

use super::lobe::cos_n;
use super::real::Real;

/// cosⁿ for whole n by binary powering: exact but for its roundings.
///
/// max(c, 0)ⁿ, c = cos θ: ⌊log₂ n⌋ squarings, and a product for each further binary one of n.
///
/// Source: square and multiply, from the highest bit down.
///
/// - Domain: c in [-1, 1], n ≥ 0; n = 0: 1 for every c. c > 1: above 1. NaN: NaN, for n = 0 too.
/// - Accuracy: relative error at most (n - 1) u to the first order, u = 2⁻²⁴ or 2⁻⁵³, as the first squaring is
///   raised to the power n/2: at n = 1024 in `f32` 6e-5, of values near 1 as of small ones.
///
/// ```
/// use bellfit::kernel::power::cos_n_whole;
/// assert_eq!(cos_n_whole(0.5_f64, 10), 1.0 / 1024.0);
/// assert_eq!(cos_n_whole(-0.5_f64, 3), 0.0);
/// ```
#[inline]
pub fn cos_n_whole<F: Real>(cos: F, n: u32) -> F {
    if cos.is_nan() {
        return F::NAN;
    }
    if n == 0 {
        return F::ONE;
    }
    let base = cos.max(F::ZERO);
    let mut power = base;
    for bit in (0..n.ilog2()).rev() {
        power = power * power;
        if (n >> bit) & 1 == 1 {
            power = power * base;
        }
    }
    power
}

/// cosⁿ as shaders compute `pow`: 2^(n log₂ c).
///
/// Source: the definition that WGSL, GLSL and HLSL give of pow's accuracy (WGSL specification, "Accuracy of
/// concrete floating point expressions": inherited from exp2(y * log2(x))).
///
/// - Domain and ends as [`cos_n`], c ≤ 0 with n > 0: 0.
/// - Accuracy: the rounding of n log₂ c stands in the exponent: relative error up to ln 2 · u · |n log₂ c| and
///   what log₂ and exp2 add, so 100 u for values about 10⁻³⁰, 10 u about 10⁻³.
///
/// ```
/// use bellfit::kernel::power::cos_n_exp2;
/// assert!((cos_n_exp2(0.9_f64, 64.0) - libm::pow(0.9, 64.0)).abs() < 1e-15);
/// assert_eq!(cos_n_exp2(-0.5_f64, 3.0), 0.0);
/// ```
#[inline]
pub fn cos_n_exp2<F: Real>(cos: F, n: F) -> F {
    // 0·∞ at the ends is pow's to say.
    if !(cos > F::ZERO && cos != F::ONE && n.is_finite()) {
        return cos_n(cos, n);
    }
    (n * cos.log2()).exp2()
}
