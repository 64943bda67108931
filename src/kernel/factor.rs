//! Factors coef(n) that normalise the lobes.

use super::constants::{CS16_MINIMAX, CS16_ONE_SIDED, CS16_PRINTED, CUBIC_FACTOR};
use super::cubic;
use super::model::Model;
use super::real::Real;

/// A factor in the paper's linear form.
///
/// coef(n) = (a n + b)/(divisor π), per steradian.
///
/// Source: the lobe paper, Table 1, the column of (1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearFactor<F> {
    /// Slope in n.
    pub a: F,
    /// Value at n = 0.
    pub b: F,
    /// What divides, beside π: 2 or 8.
    pub divisor: F,
}

impl<F: Real> LinearFactor<F> {
    /// coef(n) = (a n + b)/(divisor π).
    ///
    /// Any real n: the line knows no domain of its own, so ±∞ and negative n follow it; NaN: NaN.
    ///
    /// ```
    /// use bellfit::kernel::factor::LinearFactor;
    /// let line = LinearFactor { a: 3.0, b: 1.0, divisor: 2.0 };
    /// assert_eq!(line.at(5.0_f64), (3.0 * 5.0 + 1.0) / (2.0 * std::f64::consts::PI));
    /// ```
    #[inline]
    pub fn at(self, n: F) -> F {
        (self.a * n + self.b) / (self.divisor * F::PI)
    }

    #[inline]
    fn of_row([a, b, divisor]: [f64; 3]) -> Self {
        Self { a: F::from_f64(a), b: F::from_f64(b), divisor: F::from_f64(divisor) }
    }
}

/// Exact factor of the lobe cosⁿ, per steradian.
///
/// | model | coef(n) |
/// |---|---|
/// | Phong, Blinn-Phong NDF | (n + 1)/(2π) |
/// | Phong modified, Blinn-Phong heightfield | (n + 2)/(2π) |
/// | Blinn-Phong | (n + 2)/(4π (2 - 2^(-n/2))) |
/// | Blinn-Phong modified | (n + 2)(n + 4)/(8π (2^(-n/2) + n)) |
///
/// Source: the lobe paper, Table 1, column cosⁿθ.
///
/// Domain: real n ≥ 0, below 16 too: every row is exact there. n = +∞: +∞. n < 0 and NaN: NaN.
///
/// ```
/// use bellfit::kernel::{factor::cos_n_factor, model::Model};
/// let (n, pi) = (16.0_f64, std::f64::consts::PI);
/// let q = libm::exp2(-n / 2.0);
/// let formulas = [
///     (n + 1.0) / (2.0 * pi),
///     (n + 2.0) / (2.0 * pi),
///     (n + 2.0) / (4.0 * pi * (2.0 - q)),
///     (n + 2.0) * (n + 4.0) / (8.0 * pi * (q + n)),
///     (n + 1.0) / (2.0 * pi),
///     (n + 2.0) / (2.0 * pi),
/// ];
/// for (model, formula) in Model::ALL.into_iter().zip(formulas) {
///     assert!((cos_n_factor(model, n) / formula - 1.0).abs() < 1e-15);
/// }
/// ```
#[inline]
pub fn cos_n_factor<F: Real>(model: Model, n: F) -> F {
    if n < F::ZERO {
        return F::NAN;
    }
    let four = F::from_u32(4);
    match model {
        Model::Phong | Model::BlinnPhongNdf => (n + F::ONE) / (F::TWO * F::PI),
        Model::PhongModified | Model::BlinnPhongHeightfield => (n + F::TWO) / (F::TWO * F::PI),
        Model::BlinnPhong => (n + F::TWO) / (four * F::PI * (F::TWO - (-F::HALF * n).exp2())),
        Model::BlinnPhongModified => {
            let q = (-F::HALF * n).exp2();
            // (n + 4)/(q + n) written as 1 + (4 - q)/(q + n): no overflow, and no ∞/∞ at n = ∞.
            (n + F::TWO) / (F::from_u32(8) * F::PI) * (F::ONE + (four - q) / (q + n))
        }
    }
}

/// Linear factor of the lobe cs_16 as the paper prints it.
///
/// coef(n) = (a n + b)/(divisor π) with the row of [`CS16_PRINTED`].
///
/// Source: the lobe paper, Table 1, the column of (1). Lost signs and fraction bars are read as in
/// (1.063 n + 1)/2π. Fitted there on n = 16..1024. Accuracy: [`CS16_PRINTED`]'s source notes each row's
/// certified residual on the lobe's whole support; most are not what the paper states.
///
/// ```
/// use bellfit::kernel::{factor::cs_16_factor_printed, model::Model};
/// let n = 128.0_f64;
/// let printed = 1.063 * n / (2.0 * std::f64::consts::PI);
/// assert_eq!(cs_16_factor_printed(Model::Phong).at(n), printed);
/// ```
#[inline]
pub fn cs_16_factor_printed<F: Real>(model: Model) -> LinearFactor<F> {
    LinearFactor::of_row(CS16_PRINTED[model as usize])
}

/// Linear factor of the lobe cs_16, refitted.
///
/// coef(n) = (a n + b)/(divisor π) with the row of [`CS16_MINIMAX`]: among all a, b the least possible
/// max |2π coef(n) Int(n) - 1| over n = 16..1024, Int(n) on the lobe's true support.
///
/// Source: this crate's fit; the form is that of the lobe paper, Table 1. Outside 16..1024 the line
/// continues, but was not fitted. Accuracy: certified for every real n of 16..1024, row by row with the
/// n of its extremes in [`CS16_MINIMAX`]'s source.
///
/// ```
/// use bellfit::kernel::{constants::CS16_MINIMAX, factor::cs_16_factor, model::Model};
/// let ([a, b, divisor], n) = (CS16_MINIMAX[3], 128.0_f64);
/// let coef = cs_16_factor(Model::BlinnPhongModified).at(n);
/// assert_eq!(coef, (a * n + b) / (divisor * std::f64::consts::PI));
/// ```
#[inline]
pub fn cs_16_factor<F: Real>(model: Model) -> LinearFactor<F> {
    LinearFactor::of_row(CS16_MINIMAX[model as usize])
}

/// Linear factor of the lobe cs_16 that never gains energy.
///
/// coef(n) = (a n + b)/(divisor π) with the row of [`CS16_ONE_SIDED`]: 2π coef(n) Int(n) ≤ 1 for every real
/// n of 16..1024, and among all such a, b the least loss to the twelfth digit, Int(n) on the lobe's true
/// support.
///
/// Source: this crate's fit; the form is that of the lobe paper, Table 1. Outside 16..1024 the line
/// continues and nothing is proved. Accuracy: certified, row by row in [`CS16_ONE_SIDED`]'s source; the
/// floating-point line adds up to 2 ε of rounding to either side.
///
/// ```
/// use bellfit::kernel::{exact::cs_16_factor_exact, factor::cs_16_factor_one_sided, model::Model};
/// for model in Model::ALL {
///     let share = cs_16_factor_one_sided(model).at(100.0_f64) / cs_16_factor_exact(model, 100.0);
///     assert!(share <= 1.0 + 1e-15 && share > 0.99);
/// }
/// ```
#[inline]
pub fn cs_16_factor_one_sided<F: Real>(model: Model) -> LinearFactor<F> {
    LinearFactor::of_row(CS16_ONE_SIDED[model as usize])
}

/// Factor of the cubic lobes [`CubicLobe`](cubic::CubicLobe), never gaining energy.
///
/// coef(n) = (p₀ n + p₁ + p₂/n + p₃/n²)/(divisor π) with the row of [`CUBIC_FACTOR`]; K = 2, 4 or 8 as the
/// lobe's.
///
/// Source: this crate's fit: 2π coef(n) Int(n) ≤ 1 for every real n ≥ 16, Int(n) on the lobe's true
/// support, and the loss as small as the form allows.
///
/// Domain: real n ≥ 16; below, the formula continues and nothing is proved. n = +∞: +∞. NaN: NaN.
/// Accuracy: certified, row by row in [`CUBIC_FACTOR`]'s source: the loss is at most 4.9e-4; floating point
/// adds up to 4 ε to either side.
///
/// ```
/// use bellfit::kernel::{factor::{cos_n_factor, cubic_factor}, model::Model};
/// // Close to the factor of cosⁿ, which the lobe stands for.
/// let (n, model) = (64.0_f64, Model::BlinnPhong);
/// assert!((cubic_factor::<4, f64>(model, n) / cos_n_factor(model, n) - 1.0).abs() < 2e-3);
/// ```
#[inline]
pub fn cubic_factor<const K: u32, F: Real>(model: Model, n: F) -> F {
    let [p0, p1, p2, p3, divisor] = CUBIC_FACTOR[const { cubic::row(K) }][model as usize].map(F::from_f64);
    (p0 * n + p1 + (p2 + p3 / n) / n) / (divisor * F::PI)
}
