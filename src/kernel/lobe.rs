//! Specular lobes as functions of the angle between two directions, 1 at angle 0.
//!
//! Each takes the cosine of the lobe's own angle, c = cos θ, as a renderer has it. Near θ = 0, where the
//! lobe lives at a large exponent, a rounded c has lost most of θ's digits and `1 - c` lays that bare:
//! the `_versine` twins take w = 1 - c itself, from [`versine`] or as |a - b|²/2 of two unit vectors.

use super::bell::bell;
use super::real::Real;

/// Versed sine of an angle, without the cancellation of its definition.
///
/// w = 1 - cos θ = 2 sin²(θ/2).
///
/// Source: half-angle identity. Domain: every finite θ, in radians; values in [0, 2]. NaN and ±∞: NaN.
///
/// ```
/// use bellfit::kernel::lobe::versine;
/// assert!((versine(1.0_f64) - (1.0 - libm::cos(1.0))).abs() < 1e-15);
/// assert_eq!(versine(1e-9_f64), 0.5e-18); // 1 - cos 1e-9 would be 0
/// ```
#[inline]
pub fn versine<F: Real>(theta: F) -> F {
    let s = (F::HALF * theta).sin();
    F::TWO * s * s
}

/// Phong's and Blinn's lobe, the power of a cosine.
///
/// max(c, 0)ⁿ, c = cos θ.
///
/// Source: the lobe paper, Table 1, column cosⁿθ.
///
/// - Domain: c in [-1, 1], real n ≥ 0, below 16 too; values in [0, 1].
/// - n = 0: 1 for every c, behind the surface too (0⁰ = 1). c ≤ 0: 0 for n > 0.
/// - n < 0: the power as it is, ≥ 1 (c ≤ 0: +∞). c > 1: above 1. n = +∞: 0 for c < 1, 1 at c = 1.
/// - NaN in either argument: NaN.
///
/// ```
/// use bellfit::kernel::lobe::cos_n;
/// assert_eq!(cos_n(0.5_f64, 3.0), 0.125);
/// assert_eq!(cos_n(-0.5_f64, 3.0), 0.0);
/// ```
#[inline]
pub fn cos_n<F: Real>(cos: F, n: F) -> F {
    // pow(NaN, 0) and pow(1, NaN) are 1.
    if cos.is_nan() || n.is_nan() {
        return F::NAN;
    }
    // In this order -0 becomes +0: pow(-0, 3) is -0, and pow(-0, -1) is -∞.
    F::ZERO.max(cos).pow(n)
}

/// [`cos_n`] from the versine: max(1 - w, 0)ⁿ = e^(n ln(1 - w)).
///
/// Source: as [`cos_n`]. Domain: w in [0, 2], real n ≥ 0. NaN in either argument: NaN; w ≥ 1: 0 for
/// n > 0, 1 for n = 0, +∞ for n < 0; w < 0: grows, NaN where n ln(1 - w) is 0·∞; n = +∞: 0 for w > 0,
/// 1 for w = 0.
///
/// ```
/// use bellfit::kernel::lobe::cos_n_versine;
/// let (w, n) = (0.25_f64, 7.0);
/// assert!((cos_n_versine(w, n) - libm::pow(1.0 - w, n)).abs() < 1e-15);
/// ```
#[inline]
pub fn cos_n_versine<F: Real>(versine: F, n: F) -> F {
    // The ends are pow's: e^(n ln(1 - w)) is NaN where it meets 0·∞.
    if versine >= F::ONE || versine == F::ZERO {
        return cos_n(F::ONE - versine, n);
    }
    (n * (-versine).log1p()).exp()
}

/// The paper's lobe with the exact zero of its base as the cut: cosⁿθ from four squarings.
///
/// cs_16(n, θ) = (1 - n (1 - c)/16)¹⁶ for n (1 - c) < 16, else 0; c = cos θ.
///
/// Source: the lobe paper, (1). This is [`cs`] with K = 16, whose page states the domain.
///
/// ```
/// use bellfit::kernel::lobe::cs_16;
/// let (c, n) = (0.75_f64, 32.0);
/// assert_eq!(cs_16(c, n), libm::pow(1.0 - n * (1.0 - c) / 16.0, 16.0));
/// assert_eq!(cs_16(0.25_f64, 32.0), 0.0);
/// ```
#[inline]
pub fn cs_16<F: Real>(cos: F, n: F) -> F {
    cs::<16, F>(cos, n)
}

/// The lobe of [`cs_16`] with any K: Lyon's bell over n times the versine.
///
/// f_K(n (1 - c)), f_K as in [`bell`], c = cos θ.
///
/// Source: R. F. Lyon, Apple Technical Report 43, 1993; for K = 16 the lobe paper, (1).
///
/// - Domain: c in [-1, 1], real n ≥ 0; values in [0, 1]. At n = K it is exactly the polynomial cᴷ on c ≥ 0.
/// - n < K: the zero 1 - K/n lies at a negative cosine, so the lobe reaches behind c = 0 and is
///   (1 - n/K)ᴷ there; below K/2 it has no zero at all; at n = 0 it is 1.
/// - Out of domain: c > 1 or n < 0 follow the polynomial above 1. Where n (1 - c) is ∞·0: NaN.
/// - NaN in either argument: NaN.
///
/// ```
/// use bellfit::kernel::{bell::bell, lobe::cs};
/// let (c, n) = (0.75_f64, 8.0);
/// assert_eq!(cs::<4, f64>(c, n), bell::<4, f64>(n * (1.0 - c)));
/// ```
#[inline]
pub fn cs<const K: u32, F: Real>(cos: F, n: F) -> F {
    cs_versine::<K, F>(F::ONE - cos, n)
}

/// [`cs`] from the versine: f_K(n w).
///
/// Source and arguments as [`cs`], with w = 1 - c in [0, 2] in place of c.
///
/// ```
/// use bellfit::kernel::lobe::cs_versine;
/// let (w, n) = (0.25_f64, 8.0);
/// let q = 1.0 - n * w / 4.0;
/// assert_eq!(cs_versine::<4, f64>(w, n), q * q * q * q);
/// ```
#[inline]
pub fn cs_versine<const K: u32, F: Real>(versine: F, n: F) -> F {
    bell::<K, F>(n * versine)
}

/// Equation (1) to the letter, with a cut of the caller's choice: past its zero the base is negative
/// and its even power positive again, so a cut beyond [`cut_exact`] lets a second rise through.
///
/// cs_16(n, θ) = (n/16 · (cos θ - 1) + 1)¹⁶ for θ ≤ cr, 0 beyond.
///
/// Source: the lobe paper, (1).
///
/// - Domain: θ in [0, π/2] and cr in radians, real n ≥ 0. Even in θ. A cut beyond π/2 is taken at its word.
/// - A negative cut: 0. θ = ±∞: 0, unless the cut is infinite too (NaN). n = +∞: under the cut +∞, and NaN
///   at θ = 0. NaN in any argument: NaN.
///
/// ```
/// use bellfit::kernel::lobe::cs_16_cut;
/// let (theta, n) = (0.25_f64, 64.0);
/// let printed = libm::pow(n / 16.0 * (libm::cos(theta) - 1.0) + 1.0, 16.0);
/// assert!((cs_16_cut(theta, n, 0.5) - printed).abs() < 1e-15);
/// assert_eq!(cs_16_cut(theta, n, 0.125), 0.0);
/// ```
#[inline]
pub fn cs_16_cut<F: Real>(theta: F, n: F, cut: F) -> F {
    if theta.is_nan() || n.is_nan() || cut.is_nan() {
        return F::NAN;
    }
    if theta.abs() > cut {
        return F::ZERO;
    }
    let base = F::ONE - n * versine(theta) / F::from_u32(16);
    let p2 = base * base;
    let p4 = p2 * p2;
    let p8 = p4 * p4;
    p8 * p8
}

/// Angle at which the base of (1) is zero, where the lobe ends without a jump.
///
/// cr = arccos((n - 16)/n) = 2 arcsin √(8/n), the latter well-conditioned at large n.
///
/// Source: the lobe paper, the exact limit beside (1).
///
/// Domain: real n > 0; radians in (0, π]. 0 < n < 8: the base has no zero on the sphere, so π, all of
/// it. n = +∞: 0. n ≤ 0 and NaN: NaN.
///
/// ```
/// use bellfit::kernel::lobe::cut_exact;
/// let n = 100.0_f64;
/// assert!((cut_exact(n) - libm::acos((n - 16.0) / n)).abs() < 1e-15);
/// ```
#[inline]
pub fn cut_exact<F: Real>(n: F) -> F {
    let eight = F::from_u32(8);
    if n > F::ZERO && n < eight {
        return F::PI;
    }
    if n >= eight { F::TWO * (eight / n).sqrt().asin() } else { F::NAN }
}

/// The paper's approximate cut, in the reading with the radical over n alone.
///
/// cr = 6/√n.
///
/// Source: the lobe paper, the approximate limit beside (1), whose radical the print lost; the other
/// reading is [`cut_card`].
///
/// Domain: real n > 0; radians, beyond π/2 for n < 14.6. n = +∞: 0. n ≤ 0 and NaN: NaN.
///
/// ```
/// use bellfit::kernel::lobe::cut_paper;
/// assert_eq!(cut_paper(144.0_f64), 6.0 / libm::sqrt(144.0));
/// ```
#[inline]
pub fn cut_paper<F: Real>(n: F) -> F {
    if n > F::ZERO { F::from_u32(6) / n.sqrt() } else { F::NAN }
}

/// The approximate cut in the reading with the radical over the whole fraction.
///
/// cr = √(6/n).
///
/// Source: the lobe paper, as [`cut_paper`].
///
/// Domain: real n > 0; radians. n = +∞: 0. n so small that 6/n overflows: +∞. n ≤ 0 and NaN: NaN.
///
/// ```
/// use bellfit::kernel::lobe::cut_card;
/// assert_eq!(cut_card(96.0_f64), libm::sqrt(6.0 / 96.0));
/// ```
#[inline]
pub fn cut_card<F: Real>(n: F) -> F {
    if n > F::ZERO { (F::from_u32(6) / n).sqrt() } else { F::NAN }
}

/// Schlick's rational lobe, in the form that keeps its digits.
///
/// c/(n - n c + c) = c/(c + n (1 - c)) for c > 0, else 0; c = cos γ, γ the lobe's own angle.
///
/// Source: Schlick, "A fast alternative to Phong's specular model", 1994, as the lobe paper quotes it.
///
/// - Domain: c in [-1, 1], real n ≥ 0; values in [0, 1]. n = 0: 1 for c > 0.
/// - Accuracy: relative error at most 4 u + O(u²), u = 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`), barring
///   underflow: two positive terms, four roundings.
/// - c > 1 or n < 0: the quotient as it is, with a pole at c = n/(n - 1). n = +∞: 0, NaN at c = 1.
/// - c = +∞: NaN. NaN in either argument: NaN.
///
/// ```
/// use bellfit::kernel::lobe::schlick;
/// let (c, n) = (0.5_f64, 4.0);
/// assert_eq!(schlick(c, n), c / (n - n * c + c));
/// ```
#[inline]
pub fn schlick<F: Real>(cos: F, n: F) -> F {
    if cos.is_nan() || n.is_nan() {
        return F::NAN;
    }
    if cos <= F::ZERO {
        return F::ZERO;
    }
    cos / (cos + n * (F::ONE - cos))
}

/// [`schlick`] with the denominator as printed, kept so that its loss can be measured: n - n c cancels
/// near c = 1 to an absolute error of about n u in a denominator near 1.
///
/// c/(n - n c + c) for c > 0, else 0.
///
/// Source and arguments as [`schlick`]; n = +∞ is NaN for every c > 0 here (∞ - ∞).
///
/// ```
/// use bellfit::kernel::lobe::schlick_printed;
/// let (c, n) = (0.5_f64, 4.0);
/// assert_eq!(schlick_printed(c, n), c / (n - n * c + c));
/// ```
#[inline]
pub fn schlick_printed<F: Real>(cos: F, n: F) -> F {
    if cos.is_nan() || n.is_nan() {
        return F::NAN;
    }
    if cos <= F::ZERO {
        return F::ZERO;
    }
    cos / (n - n * cos + cos)
}

/// Spherical Gaussian with unit amplitude: what the bells approximate, without their cut.
///
/// e^(λ (c - 1)), c = cos of the angle to the lobe's axis.
///
/// Source: Wang et al., "All-frequency rendering of dynamic, spatially-varying reflectance", 2009.
///
/// Domain: c in [-1, 1], real sharpness λ ≥ 0; values in (0, 1]. λ = 0: 1. λ < 0 or c > 1: above 1.
/// Where λ (c - 1) is ∞·0: NaN. NaN in either argument: NaN.
///
/// ```
/// use bellfit::kernel::lobe::spherical_gaussian;
/// assert_eq!(spherical_gaussian(0.75_f64, 8.0), libm::exp(8.0 * (0.75 - 1.0)));
/// ```
#[inline]
pub fn spherical_gaussian<F: Real>(cos: F, sharpness: F) -> F {
    spherical_gaussian_versine(F::ONE - cos, sharpness)
}

/// [`spherical_gaussian`] from the versine: e^(-λ w).
///
/// Source and arguments as there, with w = 1 - c in [0, 2] in place of c.
///
/// ```
/// use bellfit::kernel::lobe::spherical_gaussian_versine;
/// assert_eq!(spherical_gaussian_versine(0.25_f64, 8.0), libm::exp(-8.0 * 0.25));
/// ```
#[inline]
pub fn spherical_gaussian_versine<F: Real>(versine: F, sharpness: F) -> F {
    (-(sharpness * versine)).exp()
}

/// Gaussian in the angle itself, the small-angle form of cosⁿθ.
///
/// e^(-n θ²/2).
///
/// Source: Taylor series, ln cos θ = -θ²/2 + O(θ⁴).
///
/// Domain: real θ in radians, real n ≥ 0; values in [0, 1]. n = 0: 1. θ = ±∞: 0 for n > 0. n < 0: above
/// 1. Where n θ² is 0·∞: NaN. NaN in either argument: NaN.
///
/// ```
/// use bellfit::kernel::lobe::gaussian;
/// assert_eq!(gaussian(0.5_f64, 8.0), libm::exp(-8.0 * 0.5 * 0.5 / 2.0));
/// ```
#[inline]
pub fn gaussian<F: Real>(theta: F, n: F) -> F {
    (-(F::HALF * n * theta * theta)).exp()
}
