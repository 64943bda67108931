//! The factor that normalises a bell lobe exactly, with the hemisphere's cut where it bites.
//!
//! With c the cosine of the lobe's own angle and w = 1 - c, every integral of Table 1 is
//! ∫ (1 - n w/K)ᴷ P(c) dw over 0 ≤ w ≤ min(K/n, E): P is 1, c, 4 c or 4 c (2 c² - 1), and the
//! hemisphere ends at E = 1, or at E = 1 - √½ for a lobe in θ/2. Expanded around c = 1 it is short
//! while K/n ≤ E. Past that its terms cancel, and powers of the bell's base at the hemisphere's edge,
//! all positive, take over.
//!
//! A rescaled bell (1 - s n w/K)ᴷ is [`cs`](super::lobe::cs) at the exponent s n, so its factor is
//! [`cs_factor`] at s n.

use super::model::{LobeAngle, Model};
use super::real::Real;
use core::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};
use core::ops::{Add, Div, Mul, Sub};

/// Versine of π/4, 1 - √½, without its cancellation.
const EDGE_HALF: f64 = 0.5 / (1.0 + FRAC_1_SQRT_2);
/// tan(π/8) = √2 - 1 = √2 (1 - √½), without its cancellation.
const H: f64 = 1.0 / (1.0 + SQRT_2);

/// Where the lobe's support ends, and with it the form that [`cs_factor`] takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Support {
    /// At the bell's zero, on the hemisphere or at its edge: n ≥ K/E.
    Inside,
    /// At the hemisphere's edge, before the bell's zero: n < K/E.
    Cut,
}

/// What one evaluation costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    /// Multiply, add (or subtract), fused multiply-add, max: one each.
    pub operations: u32,
    /// Divisions, beside the operations.
    pub divisions: u32,
    /// Exponentials, logarithms and the like, beside both.
    pub transcendentals: u32,
}

/// Exact factor of the bell lobe [`cs`](super::lobe::cs), per steradian.
///
/// coef(n) = 1/(2π Int(n)), Int(n) over the lobe's whole support on the hemisphere.
///
/// With s = K/n, for n ≥ K/E:
///
/// | model | E | coef(n) · 2π K/((K + 1) n) |
/// |---|---|---|
/// | Phong, Blinn-Phong NDF | 1 | 1 |
/// | Phong modified, Blinn-Phong heightfield | 1 | 1/(1 - s/(K + 2)) |
/// | Blinn-Phong | 1 - √½ | ¼/(1 - s/(K + 2)) |
/// | Blinn-Phong modified | 1 - √½ | ¼/(1 - 5 s/(K + 2) + 12 s²/((K + 2)(K + 3)) - 12 s³/((K + 2)(K + 3)(K + 4))) |
///
/// With B = 1 - n E/K and A_k = Σ_{j=0..K} C(K - j + k, k) Bʲ, h = √2 - 1, for n < K/E:
///
/// | model | coef(n) |
/// |---|---|
/// | Phong, Blinn-Phong NDF | (K + 1)/(2π A_0) |
/// | Phong modified, Blinn-Phong heightfield | (K + 1)(K + 2)/(2π A_1) |
/// | Blinn-Phong | (K + 1)/(4π h (A_0 + h A_1/(K + 2))) |
/// | Blinn-Phong modified | (K + 1)(K + 2)/(8π h² (A_1 + 3 h/(K + 3) (A_2 + h A_3/(K + 4)))) |
///
/// Source: the condition of the lobe paper's Table 1 on the lobe of (1), integrated term by term:
/// ∫ (1 - v)ᴷ vᵏ dv = k! K!/(K + k + 1)! over [0, 1], the same with B + (1 - B) v as the base times A_k,
/// and c = √½ + E v at w = E (1 - v).
///
/// - Domain: real n ≥ 0, K = 2, 4, 8, 16, 32 or 64 (another K does not compile). At n = 0 the lobe is 1
///   and the factor that of [`cos_n_factor`](super::factor::cos_n_factor) at 0; at n = K the two lobes
///   are one.
/// - n = +∞: +∞; nothing overflows before. n < 0 and NaN: NaN.
/// - Accuracy: relative error at most 10.29 ε for every K, model and n, ε = 2⁻²³ for `f32` and 2⁻⁵² for
///   `f64`: all roundings counted to the first order, each weighed by its share of a sum of positive terms,
///   the worst of 4097 n for each form. For K = 16, models in the tables' order: 1.25, 2.36, 2.28 and
///   2.46 ε for n ≥ K/E (the leading constant, its product with n, the bracket, the division); 5.99, 5.91,
///   6.68 and 7.65 ε below, about 1 ε a doubling of [`cs_factor_cost`]'s log₂ K. The largest is K = 64's.
/// - Measured, over n ≥ 0: in `f32` at most 3.15 ε (Phong, K = 64, n = 1.58938), for K = 16 3.03 ε
///   (Blinn-Phong, n = 11.471464), among all floats against `f64`; in `f64` at most 2.70 ε (Blinn-Phong,
///   K = 16, n = 0.18366915724185373), among 40 000 numbers a K and model against 160 bits.
/// - Cost: [`cs_factor_cost`].
///
/// ```
/// use bellfit::kernel::{exact::cs_factor, model::Model};
/// let pi = std::f64::consts::PI;
/// // ∫ (1 - 4 w/8)⁸ dw over [0, 1] is 2/9 (1 - 2⁻⁹), and n = 16 ends inside: 8/16/9.
/// let (cut, inside) = (2.0 / 9.0 * (1.0 - 1.0 / 512.0), 8.0 / 16.0 / 9.0);
/// for (n, int) in [(4.0_f64, cut), (16.0, inside)] {
///     let coef = cs_factor::<8, f64>(Model::Phong, n);
///     assert!((coef * 2.0 * pi * int - 1.0).abs() < 1e-15);
/// }
/// assert_eq!(cs_factor::<8, f64>(Model::Phong, f64::INFINITY), f64::INFINITY);
/// assert!(cs_factor::<8, f64>(Model::Phong, -1.0).is_nan());
/// ```
///
/// ```compile_fail
/// use bellfit::kernel::{exact::cs_factor, model::Model};
/// cs_factor::<3, f64>(Model::Phong, 1.0); // not a power of two
/// ```
#[inline]
pub fn cs_factor<const K: u32, F: Real>(model: Model, n: F) -> F {
    const { assert!(K.is_power_of_two() && K >= 2 && K <= 64, "K is 2, 4, 8, 16, 32 or 64") };
    // NaN goes through either form as it is.
    if n < F::ZERO {
        return F::NAN;
    }
    let edge = match model.angle() {
        LobeAngle::Full => 1.0,
        LobeAngle::Half => EDGE_HALF,
    };
    // Which side a rounded K/E falls on does not matter: next to it the two forms differ by a
    // (K + 1)-th power of their distance from it.
    if n >= F::from_f64(f64::from(K) / edge) {
        inside::<K, F>(model, n)
    } else {
        cut::<K, F>(model, n * F::from_f64(edge / f64::from(K)))
    }
}

/// [`cs_factor`] with the lobe paper's K = 16: the exact factor of [`cs_16`](super::lobe::cs_16).
///
/// Source, domain and accuracy as there. [`cs_16_factor`](super::factor::cs_16_factor) is the straight
/// line beside it.
///
/// ```
/// use bellfit::kernel::{exact::cs_16_factor_exact, factor::cs_16_factor, model::Model};
/// let n = 64.0_f64;
/// let exact = cs_16_factor_exact(Model::Phong, n);
/// assert!((exact / (17.0 * n / (32.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-15);
/// // Phong's line has no residual to leave; Blinn-Phong's leaves up to 1e-3.
/// let line = cs_16_factor(Model::BlinnPhong).at(n);
/// assert!((line / cs_16_factor_exact(Model::BlinnPhong, n) - 1.0).abs() < 1e-3);
/// ```
#[inline]
pub fn cs_16_factor_exact<F: Real>(model: Model, n: F) -> F {
    cs_factor::<16, F>(model, n)
}

/// Cost of one [`cs_factor`] from n, no transcendental in any of them.
///
/// With m = log₂ K, operations + divisions:
///
/// | model | [`Support::Inside`] | [`Support::Cut`] | the same, K = 16 |
/// |---|---|---|---|
/// | Phong, Blinn-Phong NDF | 1 + 0 | 3 m + 2, + 1 | 14 + 1 |
/// | Phong modified, Blinn-Phong heightfield | 3 + 2 | 6 m, + 1 | 24 + 1 |
/// | Blinn-Phong | 3 + 2 | 6 m + 4, + 1 | 28 + 1 |
/// | Blinn-Phong modified | 7 + 2 | 18 m - 2, + 1 | 70 + 1 |
///
/// Counted as written, with no fused multiply-add; what K alone decides counts as a constant.
///
/// ```
/// use bellfit::kernel::exact::{Cost, Support, cs_factor_cost};
/// use bellfit::kernel::model::Model;
/// let cost = cs_factor_cost::<16>(Model::BlinnPhong, Support::Cut);
/// assert_eq!(cost, Cost { operations: 28, divisions: 1, transcendentals: 0 });
/// ```
pub const fn cs_factor_cost<const K: u32>(model: Model, support: Support) -> Cost {
    const { assert!(K.is_power_of_two() && K >= 2 && K <= 64, "K is 2, 4, 8, 16, 32 or 64") };
    let m = K.trailing_zeros();
    let (inside, cut) = match model {
        Model::Phong | Model::BlinnPhongNdf => ((1, 0), 3 * m + 2),
        Model::PhongModified | Model::BlinnPhongHeightfield => ((3, 2), 6 * m),
        Model::BlinnPhong => ((3, 2), 6 * m + 4),
        Model::BlinnPhongModified => ((7, 2), 18 * m - 2),
    };
    match support {
        Support::Inside => Cost { operations: inside.0, divisions: inside.1, transcendentals: 0 },
        Support::Cut => Cost { operations: cut, divisions: 1, transcendentals: 0 },
    }
}

/// What the two forms are made of: a [`Real`], or in this file's test one that counts.
trait Number: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    fn of(value: f64) -> Self;
}

impl<F: Real> Number for F {
    #[inline]
    fn of(value: f64) -> Self {
        F::from_f64(value)
    }
}

/// The factor for n ≥ K/E.
#[inline]
fn inside<const K: u32, T: Number>(model: Model, n: T) -> T {
    let k = f64::from(K);
    let lead = (k + 1.0) / (2.0 * PI * k);
    // s = K/n and never n²: it may underflow to 0, but does not overflow.
    let s = || T::of(k) / n;
    let tilt = || T::of(1.0) - s() * T::of(1.0 / (k + 2.0));
    match model {
        Model::Phong | Model::BlinnPhongNdf => n * T::of(lead),
        Model::PhongModified | Model::BlinnPhongHeightfield => n * T::of(lead) / tilt(),
        Model::BlinnPhong => n * T::of(0.25 * lead) / tilt(),
        Model::BlinnPhongModified => {
            let s = s();
            let second = 12.0 / ((k + 2.0) * (k + 3.0));
            let bend = T::of(second) - s * T::of(second / (k + 4.0));
            n * T::of(0.25 * lead) / (T::of(1.0) - s * (T::of(5.0 / (k + 2.0)) - s * bend))
        }
    }
}

/// The factor for n < K/E, from y = n E/K = 1 - B.
#[inline]
fn cut<const K: u32, T: Number>(model: Model, y: T) -> T {
    let k = f64::from(K);
    let base = T::of(1.0) - y;
    // A_k from the sum over j < K: one factor B, and the term of j = 0.
    let last = |index: u32, sum: T| base * sum + T::of(choose(K + index, index));
    match model {
        Model::Phong | Model::BlinnPhongNdf => {
            let [a0] = sums::<K, 1, T>(y);
            T::of((k + 1.0) / (2.0 * PI)) / last(0, a0)
        }
        Model::PhongModified | Model::BlinnPhongHeightfield => {
            let [_, a1] = sums::<K, 2, T>(y);
            T::of((k + 1.0) * (k + 2.0) / (2.0 * PI)) / last(1, a1)
        }
        Model::BlinnPhong => {
            let [a0, a1] = sums::<K, 2, T>(y);
            // 1/h = 1 + √2
            let lead = (k + 1.0) * (1.0 + SQRT_2) / (4.0 * PI);
            T::of(lead) / (last(0, a0) + T::of(H / (k + 2.0)) * last(1, a1))
        }
        Model::BlinnPhongModified => {
            let [_, a1, a2, a3] = sums::<K, 4, T>(y);
            // 1/h² = 3 + 2 √2
            let lead = (k + 1.0) * (k + 2.0) * (3.0 + 2.0 * SQRT_2) / (8.0 * PI);
            let rest = last(2, a2) + T::of(H / (k + 4.0)) * last(3, a3);
            T::of(lead) / (last(1, a1) + T::of(3.0 * H / (k + 3.0)) * rest)
        }
    }
}

/// A_k(K) = Σ_{j<K} C(K - 1 - j + k, k) Bʲ for k < D, by doubling from A_k(2) = k + 1 + B.
///
/// A_k(2 N) = (1 + Bᴺ) A_k(N) + Σ_{i<k} C(N - 1 + k - i, k - i) A_i(N), with Bᴺ = 1 - y A_0(N), which
/// no power of a rounded B could match: log₂ K steps, all of positive terms.
#[inline]
fn sums<const K: u32, const D: usize, T: Number>(y: T) -> [T; D] {
    let mut a = core::array::from_fn(|k| T::of(k as f64 + 2.0) - y);
    let mut count = 2;
    while count < K {
        let growth = T::of(2.0) - y * a[0];
        for k in (0..D).rev() {
            let mut sum = growth * a[k];
            for (i, &lower) in a.iter().enumerate().take(k) {
                let rise = (k - i) as u32;
                sum = sum + T::of(choose(count - 1 + rise, rise)) * lower;
            }
            a[k] = sum;
        }
        count *= 2;
    }
    a
}

/// C(n, k), exact: below 2²⁴, and every quotient on the way whole.
#[inline]
fn choose(n: u32, k: u32) -> f64 {
    let mut product = 1;
    for i in 1..=k {
        product = product * (n - k + i) / i;
    }
    f64::from(product)
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::sync::atomic::{AtomicU32, Ordering};

    static OPERATIONS: AtomicU32 = AtomicU32::new(0);
    static DIVISIONS: AtomicU32 = AtomicU32::new(0);

    /// A double that counts what is done to it.
    #[derive(Clone, Copy)]
    struct Counted(f64);

    impl Number for Counted {
        fn of(value: f64) -> Self {
            Counted(value)
        }
    }

    macro_rules! counted {
        ($($operator:ident, $method:ident, $counter:ident;)+) => {
            $(impl $operator for Counted {
                type Output = Self;
                fn $method(self, other: Self) -> Self {
                    $counter.fetch_add(1, Ordering::Relaxed);
                    Counted($operator::$method(self.0, other.0))
                }
            })+
        };
    }
    counted!(Add, add, OPERATIONS; Sub, sub, OPERATIONS; Mul, mul, OPERATIONS; Div, div, DIVISIONS;);

    fn spent() -> Cost {
        let take = |counter: &AtomicU32| counter.swap(0, Ordering::Relaxed);
        Cost { operations: take(&OPERATIONS), divisions: take(&DIVISIONS), transcendentals: 0 }
    }

    /// The only test that counts, as the counters are shared.
    #[test]
    fn the_cost_is_what_an_evaluation_takes() {
        fn test<const K: u32>() {
            for model in Model::ALL {
                let edge = if model.angle() == LobeAngle::Full { 1.0 } else { EDGE_HALF };
                let n = 3.0 * f64::from(K) / edge;
                let value = inside::<K, Counted>(model, Counted(n)).0;
                assert_eq!(spent(), cs_factor_cost::<K>(model, Support::Inside), "{model:?}, K = {K}");
                assert_eq!(value, cs_factor::<K, f64>(model, n));
                // The caller's own product n (E/K) is one operation more.
                let n = 0.5 * f64::from(K) / edge;
                let value = cut::<K, Counted>(model, Counted(n) * Counted(edge / f64::from(K))).0;
                assert_eq!(spent(), cs_factor_cost::<K>(model, Support::Cut), "{model:?}, K = {K}");
                assert_eq!(value, cs_factor::<K, f64>(model, n));
            }
        }
        test::<2>();
        test::<4>();
        test::<8>();
        test::<16>();
        test::<32>();
        test::<64>();
    }
}
