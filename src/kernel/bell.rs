//! The bell (1 - t/K)^K, the compact stand-in for e⁻ᵗ that both papers build on.

use super::real::Real;

/// Lyon's compact bell: e⁻ᵗ with its limit stopped at K, so that squarings replace the exponential and
/// the tail is exactly zero.
///
/// f_K(t) = (1 - t/K)ᴷ for t < K, 0 for t ≥ K; K = 2, 4, 8, 16, 32 or 64 (another K does not compile).
///
/// Source: R. F. Lyon, "Phong Shading Reformulation for Hardware Renderer Simplification", Apple
/// Technical Report 43, 1993; with K = 16 it is the base of the lobe paper, (1).
///
/// - Domain: t ≥ 0, dimensionless; values in [0, 1].
/// - Below 0: the polynomial as it is, which exceeds 1 (t = -∞: +∞). At +∞: 0. NaN: NaN.
/// - Accuracy: within a factor (1 + u)^(±(2K - 1)) of f_K at the float t, u = 2⁻²⁴ for `f32` and 2⁻⁵³
///   for `f64`, as long as nothing underflows: t/K is exact, 1 - t/K rounds once and is raised to the
///   K-th power, and the squarings round K/2 + … + 2 + 1 = K - 1 times, counted with their powers.
/// - Never increases with t, in floating point too: correctly rounded steps keep the order.
///
/// ```
/// use bellfit::kernel::bell::bell;
/// let t = 1.0_f64;
/// let q = 1.0 - t / 4.0;
/// assert_eq!(bell::<4, f64>(t), q * q * q * q); // 81/256
/// assert_eq!(bell::<4, f64>(4.0), 0.0);
/// ```
///
/// ```compile_fail
/// bellfit::kernel::bell::bell::<3, f64>(1.0); // not a power of two
/// ```
#[inline]
pub fn bell<const K: u32, F: Real>(t: F) -> F {
    const { assert!(K.is_power_of_two() && K >= 2 && K <= 64, "K is 2, 4, 8, 16, 32 or 64") };
    let k = F::from_u32(K);
    // Not `max(1 - t/K, 0)`: a NaN must fall through to the polynomial.
    if t >= k {
        return F::ZERO;
    }
    let mut power = F::ONE - t / k;
    for _ in 0..K.trailing_zeros() {
        power = power * power;
    }
    power
}
