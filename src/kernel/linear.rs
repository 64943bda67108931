//! Bells of degree one for cosⁿ: (1 - n w/T)^K, w = 1 - cos θ, Lyon's bell with the reach T that fits best.
//!
//! With T = K it is the papers' [`cs`](super::lobe::cs), which lies below cosⁿ everywhere; the T of
//! [`LINEAR_COS_N`] halves the largest error at the same cost. What depends on n alone is computed once a
//! material.

use super::constants::LINEAR_COS_N;
use super::cubic::{BellFormula, power};
use super::real::Real;

/// Row of a power in [`LINEAR_COS_N`].
const fn row(k: u32) -> &'static BellFormula {
    assert!(k.is_power_of_two() && k >= 2 && k <= 32, "K is 2, 4, 8, 16 or 32");
    &LINEAR_COS_N[k.trailing_zeros() as usize - 1]
}

/// Lobe of degree one for one exponent.
///
/// f = max(p, 0)^K for cos θ ≥ 0, p = 1 - s w = (1 - s) + s cos θ, s = n/T; K = 2, 4, 8, 16 or 32 (another K
/// does not compile).
///
/// Source: [`Self::new`] this crate's fit; [`Self::lyon`] the lobe paper, (1), for K = 16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearLobe<const K: u32, F> {
    offset: F,
    slope: F,
}

impl<const K: u32, F: Real> LinearLobe<K, F> {
    /// With the reach T of [`LINEAR_COS_N`], which depends on n: s = n/T.
    ///
    /// Domain: real n ≥ 16; below, the formula continues and nothing is proved. n ≤ 0, NaN, ∞: a lobe of NaN.
    ///
    /// ```
    /// use bellfit::kernel::linear::LinearLobe;
    /// let lobe = LinearLobe::<16, f64>::new(64.0);
    /// assert!((lobe.at(0.99) - libm::pow(0.99, 64.0)).abs() < 8e-3); // cs_16: 1.7e-2
    /// ```
    #[inline]
    pub fn new(n: F) -> Self {
        Self::with_reach(n, const { row(K) }.at(n).0)
    }

    /// With T = K: cs_K, the papers' bell.
    ///
    /// Domain: real n ≥ 0. n < 0, NaN, ∞: a lobe of NaN.
    ///
    /// ```
    /// use bellfit::kernel::{linear::LinearLobe, lobe::cs_16};
    /// assert!((LinearLobe::<16, f64>::lyon(64.0).at(0.99) - cs_16(0.99, 64.0)).abs() < 1e-14);
    /// ```
    #[inline]
    pub fn lyon(n: F) -> Self {
        Self::with_reach(n, F::from_u32(K))
    }

    #[inline]
    fn with_reach(n: F, reach: F) -> Self {
        let slope = n / reach;
        if !(n >= F::ZERO && slope.is_finite()) {
            return LinearLobe { offset: F::NAN, slope: F::NAN };
        }
        LinearLobe { offset: F::ONE - slope, slope }
    }

    /// The same lobe with its constants rounded to another type, as
    /// [`CubicLobe::convert`](super::cubic::CubicLobe::convert): each c becomes c (1 + δ), |δ| ≤ u = 2⁻²⁴ or 2⁻⁵³.
    ///
    /// ```
    /// use bellfit::kernel::linear::LinearLobe;
    /// let lobe = LinearLobe::<8, f64>::new(100.0).convert::<f32>();
    /// assert_eq!(lobe.at_versine(0.0), 1.0);
    /// ```
    #[inline]
    pub fn convert<G: Real>(&self) -> LinearLobe<K, G> {
        let rounded = |x: F| G::from_f64(x.to_f64());
        LinearLobe { offset: rounded(self.offset), slope: rounded(self.slope) }
    }

    /// 1 - s and s of p = (1 - s) + s cos θ.
    ///
    /// ```
    /// use bellfit::kernel::linear::LinearLobe;
    /// assert_eq!(LinearLobe::<16, f64>::lyon(64.0).constants(), [1.0 - 64.0 / 16.0, 64.0 / 16.0]);
    /// ```
    #[inline]
    pub fn constants(&self) -> [F; 2] {
        [self.offset, self.slope]
    }

    /// The lobe at c = cos θ.
    ///
    /// - Domain: c in [0, 1]; values in [0, 1] up to rounding. c < 0: 0. NaN: NaN.
    /// - Operations: one fused multiply-add, one maximum, log₂ K squarings.
    /// - A rounded c moves the lobe by up to n ε/4, the sum (1 - s) + s c by as much: beyond n = 1000 in `f32`,
    ///   [`Self::at_versine`].
    ///
    /// ```
    /// use bellfit::kernel::linear::LinearLobe;
    /// let lobe = LinearLobe::<4, f64>::new(32.0);
    /// assert!((lobe.at(0.9) - lobe.at_versine(1.0 - 0.9)).abs() < 1e-14);
    /// assert_eq!(lobe.at(-0.5), 0.0);
    /// ```
    #[inline]
    pub fn at(&self, cos: F) -> F {
        if cos < F::ZERO {
            return F::ZERO;
        }
        power::<K, F>(self.offset + self.slope * cos)
    }

    /// The lobe at the versine w = 1 - cos θ, without the cancellation of that difference.
    ///
    /// Domain: w in [0, 1]; exactly 1 at 0, never above, 0 past the cut. w > 1: 0. w < 0: above 1. NaN: NaN.
    /// Operations as [`Self::at`].
    ///
    /// ```
    /// use bellfit::kernel::linear::LinearLobe;
    /// let lobe = LinearLobe::<16, f64>::lyon(1e6);
    /// assert_eq!(lobe.at_versine(8e-6), libm::pow(0.5, 16.0)); // n w = 8
    /// ```
    #[inline]
    pub fn at_versine(&self, versine: F) -> F {
        if versine > F::ONE {
            return F::ZERO;
        }
        power::<K, F>(F::ONE - self.slope * versine)
    }
}
