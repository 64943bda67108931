//! Bells of degree three: p(t)^K with a cubic p, tens of times nearer to e⁻ᵗ and to cosⁿ than the
//! papers' (1 - t/K)^K at the same count of operations.
//!
//! | K | operations from t or 1 - cos θ | from cos θ | sup error against e⁻ᵗ, and against cosⁿ for n ≥ 16 |
//! |---|---|---|---|
//! | 2 | 5 | 5 | 3.5e-3 |
//! | 4 | 6 | 6 | 4.8e-4 |
//! | 8 | 7 | 8 | 5.4e-5 |
//!
//! cs_16 takes six and misses cosⁿ by 1.7e-2. A fused multiply-add counts one (Rust fuses nothing unasked,
//! for the same bits everywhere: there each takes two, K = 4 nine and cs_16 seven), and what depends on
//! n alone is computed once a material ([`CubicLobe::new`]). The digits, and the certified bound of each
//! row with its argument, stand in [`constants`](super::constants).

use super::constants::{CUBIC_COS_N, CUBIC_EXP};
use super::real::Real;

/// Bell for cosⁿ whose coefficients are polynomials in 1/n.
///
/// p(t)^K with p = (1 - y)(1 + α y + β y²), y = t/T, t = n (1 - cos θ); T, α and β are each
/// c₀ + c₁/n + c₂/n². T is the first zero, where the bell ends.
///
/// Source: this crate's fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BellFormula {
    /// K, a power of two.
    pub power: u32,
    /// T in t = n (1 - cos θ).
    pub reach: [f64; 3],
    /// α.
    pub linear: [f64; 3],
    /// β.
    pub square: [f64; 3],
}

impl BellFormula {
    /// (T, α, β) at the exponent n, each c₀ + c₁/n + c₂/n².
    ///
    /// ```
    /// use bellfit::kernel::cubic::BellFormula;
    /// let f = BellFormula { power: 4, reach: [8.0, 2.0, 0.0], linear: [-1.0, 0.0, 0.0], square: [1.0, 0.0, 4.0] };
    /// assert_eq!(f.at(2.0), (9.0, -1.0, 2.0)); // 8 + 2/2, -1, 1 + 4/2²
    /// ```
    #[inline]
    pub fn at<F: Real>(&self, n: F) -> (F, F, F) {
        let m = F::ONE / n;
        let value = |[a, b, c]: [f64; 3]| F::from_f64(a) + m * (F::from_f64(b) + m * F::from_f64(c));
        (value(self.reach), value(self.linear), value(self.square))
    }
}

/// Row of a power in the tables of constants.
pub(super) const fn row(k: u32) -> usize {
    assert!(k == 2 || k == 4 || k == 8, "K is 2, 4 or 8");
    k.trailing_zeros() as usize - 1
}

/// K-th power of the positive part, by squarings.
#[inline]
pub(super) fn power<const K: u32, F: Real>(base: F) -> F {
    let mut power = base.max(F::ZERO);
    for _ in 0..K.trailing_zeros() {
        power = power * power;
    }
    power
}

/// Compact stand-in for e⁻ᵗ with a cubic under the squarings.
///
/// f(t) = max(p(t), 0)^K, p = 1 - c₁ y + c₂ y² - c₃ y³, y = t/K, the row of K in [`CUBIC_EXP`];
/// K = 2, 4 or 8 (another K does not compile). p falls for every real t.
///
/// Source: this crate's fit, minimax over all t ≥ 0 among p with p(0) = 1.
///
/// - Domain: t ≥ 0, dimensionless; values in [0, 1], exactly 1 at 0 and exactly 0 from a few floats past
///   the cut on. In floating point it may rise by 4 ε between neighbours (ε = 2⁻²³ in `f32`, 2⁻⁵² in
///   `f64`).
/// - Below 0: the polynomial as it is, above 1. At +∞: 0. NaN: NaN.
/// - Operations from t, the constants divided by powers of K beforehand: three fused multiply-adds, one
///   maximum and log₂ K squarings, so 5, 6 or 7.
/// - Accuracy: |f - e⁻ᵗ| as certified beside the row: 3.5e-3, 4.8e-4 or 5.4e-5.
///
/// ```
/// use bellfit::kernel::{constants::CUBIC_EXP, cubic::cubic_bell};
/// let (t, [c1, c2, c3]) = (1.0_f64, CUBIC_EXP[1]);
/// let y = t / 4.0;
/// let p = 1.0 - c1 * y + c2 * y * y - c3 * y * y * y;
/// assert!((cubic_bell::<4, f64>(t) - p * p * p * p).abs() < 1e-15);
/// assert!((cubic_bell::<4, f64>(t) - libm::exp(-t)).abs() < 4.8e-4);
/// assert_eq!(cubic_bell::<4, f64>(9.0), 0.0);
/// ```
#[inline]
pub fn cubic_bell<const K: u32, F: Real>(t: F) -> F {
    let [c1, c2, c3] = CUBIC_EXP[const { row(K) }];
    let y = t / F::from_u32(K);
    power::<K, F>(F::ONE - y * (F::from_f64(c1) - y * (F::from_f64(c2) - y * F::from_f64(c3))))
}

/// Lobe of degree three for one exponent: what depends on n alone, computed once.
///
/// f = max(p, 0)^K for cos θ ≥ 0, p = 1 - w (k₁ - w (k₂ - w k₃)) with w = 1 - cos θ; for K = 2 and 4 from
/// cos θ the same cubic as u³ + c u + d, u = a + b cos θ, whose three operations need no 1 - cos θ.
///
/// Source: this crate's fit, [`CUBIC_COS_N`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubicLobe<const K: u32, F> {
    horner: [F; 3],
    depressed: [F; 4],
}

impl<const K: u32, F: Real> CubicLobe<K, F> {
    /// The constants of exponent n, from the row of K in [`CUBIC_COS_N`]; K = 2, 4 or 8.
    ///
    /// Domain: real n ≥ 16, in `f32` up to 3e13, where n³ still fits. Below 16 the formulas were not
    /// fitted, and the lobe may exceed 1. n ≤ 0, NaN and n whose cube overflows: a lobe of NaN.
    ///
    /// ```
    /// use bellfit::kernel::cubic::CubicLobe;
    /// let lobe = CubicLobe::<4, f64>::new(64.0);
    /// assert!((lobe.at(0.99) - libm::pow(0.99, 64.0)).abs() < 4.8e-4);
    /// ```
    #[inline]
    pub fn new(n: F) -> Self {
        let (reach, linear, square) = CUBIC_COS_N[const { row(K) }].at(n);
        let r = n / reach;
        let (k1, k2, k3) = ((F::ONE - linear) * r, (square - linear) * r * r, square * r * r * r);
        let nan = F::NAN;
        if !(n > F::ZERO && k3.is_finite()) {
            return CubicLobe { horner: [nan; 3], depressed: [nan; 4] };
        }
        // u = u₀ - s w with s³ = k₃ takes the quadratic term out of p.
        let s = k3.cbrt();
        let u = k2 / (F::from_u32(3) * s * s);
        let c = k1 / s - F::from_u32(3) * u * u;
        let d = F::ONE - u * (u * u + c);
        CubicLobe { horner: [k1, k2, k3], depressed: [u - s, s, c, d] }
    }

    /// The same lobe with its constants rounded to another type: those of a material computed in `f64` once, for
    /// a shader that has less. Each constant c becomes c (1 + δ), |δ| ≤ u = 2⁻²⁴ or 2⁻⁵³.
    ///
    /// ```
    /// use bellfit::kernel::cubic::CubicLobe;
    /// let lobe = CubicLobe::<4, f64>::new(1e12).convert::<f32>();
    /// assert_eq!(lobe.at_versine(0.0), 1.0);
    /// ```
    #[inline]
    pub fn convert<G: Real>(&self) -> CubicLobe<K, G> {
        let rounded = |x: F| G::from_f64(x.to_f64());
        CubicLobe { horner: self.horner.map(rounded), depressed: self.depressed.map(rounded) }
    }

    /// k₁, k₂, k₃ of p = 1 - w (k₁ - w (k₂ - w k₃)), w = 1 - cos θ.
    ///
    /// With r = n/T: k₁ = (1 - α) r, k₂ = (β - α) r², k₃ = β r³.
    ///
    /// ```
    /// use bellfit::kernel::{constants::CUBIC_COS_N, cubic::CubicLobe};
    /// let (reach, alpha, beta) = CUBIC_COS_N[1].at(64.0_f64);
    /// let (r, [k1, k2, k3]) = (64.0 / reach, CubicLobe::<4, f64>::new(64.0).horner());
    /// assert_eq!([k1, k2, k3], [(1.0 - alpha) * r, (beta - alpha) * r * r, beta * r * r * r]);
    /// ```
    #[inline]
    pub fn horner(&self) -> [F; 3] {
        self.horner
    }

    /// a, b, c, d of p = u³ + c u + d, u = a + b cos θ.
    ///
    /// ```
    /// use bellfit::kernel::cubic::CubicLobe;
    /// let lobe = CubicLobe::<4, f64>::new(64.0);
    /// let ([a, b, c, d], [k1, k2, k3], w) = (lobe.depressed(), lobe.horner(), 0.01);
    /// let u = a + b * (1.0 - w);
    /// assert!((u * u * u + c * u + d - (1.0 - w * (k1 - w * (k2 - w * k3)))).abs() < 1e-13);
    /// ```
    #[inline]
    pub fn depressed(&self) -> [F; 4] {
        self.depressed
    }

    /// The lobe at c = cos θ.
    ///
    /// - Domain: c in [0, 1]; values in [0, 1] up to rounding. c < 0: 0. NaN: NaN.
    /// - Operations: K = 2 and 4: three fused multiply-adds, one maximum, log₂ K squarings, so 5 and 6;
    ///   K = 8 by way of 1 - c: 8.
    /// - A rounded c alone moves t = n (1 - c) by n ε/4 and so the lobe by as much; the depressed form
    ///   adds up to 0.7 n ε (sampled), at c = 1 too. In `f32` that is 1e-4 at n = 1000: beyond,
    ///   [`Self::at_versine`].
    ///
    /// ```
    /// use bellfit::kernel::cubic::CubicLobe;
    /// let lobe = CubicLobe::<2, f64>::new(32.0);
    /// assert!((lobe.at(0.9) - lobe.at_versine(1.0 - 0.9)).abs() < 1e-13);
    /// assert_eq!(lobe.at(-0.5), 0.0);
    /// ```
    #[inline]
    pub fn at(&self, cos: F) -> F {
        if cos < F::ZERO {
            return F::ZERO;
        }
        if K > 4 {
            return self.at_versine(F::ONE - cos);
        }
        let [a, b, c, d] = self.depressed;
        let u = a + b * cos;
        power::<K, F>((u * u + c) * u + d)
    }

    /// The lobe at the versine w = 1 - cos θ, without the cancellation of that difference.
    ///
    /// Domain: w in [0, 1], n ≥ 16; exactly 1 at 0, never above, exactly 0 from a few floats past the cut
    /// on. w > 1: 0. w < 0: above 1. NaN: NaN. Operations: three fused multiply-adds, one maximum, log₂ K squarings.
    ///
    /// ```
    /// use bellfit::kernel::cubic::CubicLobe;
    /// let lobe = CubicLobe::<8, f64>::new(1e6);
    /// assert_eq!(lobe.at_versine(0.0), 1.0);
    /// assert!((lobe.at_versine(1e-6) - libm::exp(-1.0)).abs() < 5.5e-5); // n w = 1
    /// ```
    #[inline]
    pub fn at_versine(&self, versine: F) -> F {
        if versine > F::ONE {
            return F::ZERO;
        }
        let [k1, k2, k3] = self.horner;
        let w = versine;
        power::<K, F>(F::ONE - w * (k1 - w * (k2 - w * k3)))
    }
}

/// [`CubicLobe::at`] for a single value, f = max(p, 0)^K, the constants computed on the spot; cos θ and n as
/// [`cs`](super::lobe::cs) takes them.
///
/// ```
/// use bellfit::kernel::cubic::{CubicLobe, cubic_lobe};
/// assert_eq!(cubic_lobe::<4, f32>(0.9, 50.0), CubicLobe::<4, f32>::new(50.0).at(0.9));
/// ```
#[inline]
pub fn cubic_lobe<const K: u32, F: Real>(cos: F, n: F) -> F {
    CubicLobe::<K, F>::new(n).at(cos)
}
