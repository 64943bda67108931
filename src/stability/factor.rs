//! The error of the normalising factors by exponent and format.

use super::{DoubleDouble, Half};
use crate::bound::Format;
use crate::kernel::constants::CUBIC_FACTOR;
use crate::kernel::exact::cs_16_factor_exact;
use crate::kernel::factor::{cos_n_factor, cubic_factor};
use crate::kernel::model::{LobeAngle, Model};
use crate::kernel::real::Real;

/// A factor coef(n).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// [`cos_n_factor`].
    CosN,
    /// [`cs_16_factor_exact`].
    Cs16,
    /// [`cubic_factor`], K = 2.
    Cubic2,
    /// [`cubic_factor`], K = 4.
    Cubic4,
    /// [`cubic_factor`], K = 8.
    Cubic8,
}

impl Factor {
    /// All of them.
    pub const ALL: [Factor; 5] = [Factor::CosN, Factor::Cs16, Factor::Cubic2, Factor::Cubic4, Factor::Cubic8];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Factor::CosN => "cos-n-factor",
            Factor::Cs16 => "cs-16-factor",
            Factor::Cubic2 => "cubic-2-factor",
            Factor::Cubic4 => "cubic-4-factor",
            Factor::Cubic8 => "cubic-8-factor",
        }
    }

    fn at<F: Real>(self, model: Model, n: F) -> F {
        match self {
            Factor::CosN => cos_n_factor(model, n),
            Factor::Cs16 => cs_16_factor_exact(model, n),
            Factor::Cubic2 => cubic_factor::<2, F>(model, n),
            Factor::Cubic4 => cubic_factor::<4, F>(model, n),
            Factor::Cubic8 => cubic_factor::<8, F>(model, n),
        }
    }

    /// The factor in exact arithmetic, to about 100 bits; n > 0.
    ///
    /// ```
    /// use bellfit::kernel::{factor::cos_n_factor, model::Model};
    /// use bellfit::stability::Factor;
    /// let exact = Factor::CosN.exact(Model::BlinnPhong, 20.0).to_f64();
    /// assert!((exact / cos_n_factor(Model::BlinnPhong, 20.0) - 1.0).abs() < 1e-15);
    /// ```
    pub fn exact(self, model: Model, n: f64) -> DoubleDouble {
        match self {
            Factor::CosN => exact_cos_n(model, n),
            Factor::Cs16 => exact_cs_16(model, n),
            Factor::Cubic2 => exact_cubic(0, model, n),
            Factor::Cubic4 => exact_cubic(1, model, n),
            Factor::Cubic8 => exact_cubic(2, model, n),
        }
    }
}

/// The largest error of a factor over the models and a stretch of exponents.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FactorError {
    /// The factor.
    pub factor: Factor,
    /// The format of n, arithmetic and result.
    pub format: Format,
    /// Where the stretch begins; it ends before the next row's.
    pub n: f64,
    /// |computed/exact - 1| with the model and the n of the format where; `None` where n or the factor is
    /// beyond the format somewhere.
    pub relative: Option<(f64, Model, f64)>,
}

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

fn exact_cos_n(model: Model, n: f64) -> DoubleDouble {
    let (n, pi, two) = (number(n), DoubleDouble::pi(), number(2.0));
    // 2^(-n/2)
    let q = || (n * number(0.5) * number(0.5).log_one_minus()).exp();
    match model {
        Model::Phong | Model::BlinnPhongNdf => (n + number(1.0)) / (two * pi),
        Model::PhongModified | Model::BlinnPhongHeightfield => (n + two) / (two * pi),
        Model::BlinnPhong => (n + two) / (number(4.0) * pi * (two - q())),
        Model::BlinnPhongModified => (n + two) * (n + number(4.0)) / (number(8.0) * pi * (q() + n)),
    }
}

fn exact_cubic(row: usize, model: Model, n: f64) -> DoubleDouble {
    let [p0, p1, p2, p3, divisor] = CUBIC_FACTOR[row][model as usize].map(number);
    let n = number(n);
    (p0 * n + p1 + (p2 + p3 / n) / n) / (divisor * DoubleDouble::pi())
}

/// By the sums that [`cs_factor`](crate::kernel::exact::cs_factor)'s page states, term by term.
fn exact_cs_16(model: Model, n: f64) -> DoubleDouble {
    let (k, n, one) = (16_u32, number(n), number(1.0));
    let whole = |x: u32| number(f64::from(x));
    let h = number(2.0).sqrt() - one;
    let edge = if model.angle() == LobeAngle::Full { one } else { one - number(0.5).sqrt() };
    let two_pi = number(2.0) * DoubleDouble::pi();
    let s = whole(k) / n;
    if (n * edge - whole(k)).to_f64() >= 0.0 {
        let lead = whole(k + 1) * n / (two_pi * whole(k));
        let quarter = number(0.25);
        return match model {
            Model::Phong | Model::BlinnPhongNdf => lead,
            Model::PhongModified | Model::BlinnPhongHeightfield => lead / (one - s / whole(k + 2)),
            Model::BlinnPhong => quarter * lead / (one - s / whole(k + 2)),
            Model::BlinnPhongModified => {
                let (two, three) = (whole(k + 2), whole((k + 2) * (k + 3)));
                let four = three * whole(k + 4);
                let twelve = number(12.0);
                let rest = one - number(5.0) * s / two + twelve * s * s / three - twelve * s * s * s / four;
                quarter * lead / rest
            }
        };
    }
    let base = one - n * edge / whole(k);
    // A_i = Σ_j C(K - j + i, i) Bʲ, Horner's way from j = K.
    let sum = |i: u32| {
        let choose = |m: u32| (1..=i).fold(1, |product, l| product * (m - i + l) / l);
        (0..=k).rev().fold(number(0.0), |sum, j| sum * base + whole(choose(k - j + i)))
    };
    match model {
        Model::Phong | Model::BlinnPhongNdf => whole(k + 1) / (two_pi * sum(0)),
        Model::PhongModified | Model::BlinnPhongHeightfield => whole((k + 1) * (k + 2)) / (two_pi * sum(1)),
        Model::BlinnPhong => whole(k + 1) / (number(2.0) * two_pi * h * (sum(0) + h * sum(1) / whole(k + 2))),
        Model::BlinnPhongModified => {
            let rest = sum(2) + h * sum(3) / whole(k + 4);
            let bracket = sum(1) + number(3.0) * h / whole(k + 3) * rest;
            whole((k + 1) * (k + 2)) / (number(4.0) * two_pi * h * h * bracket)
        }
    }
}

/// Exponents in a stretch.
const A_STRETCH: u32 = 12;

/// The rows of every factor and format, a stretch from each of the exponents to the next; at the last one alone.
///
/// n is rounded to the format first, and the exact factor is that of the rounded n. Sampled: twelve n a stretch.
///
/// ```
/// use bellfit::{bound::Format, stability::factor_errors};
/// for row in factor_errors(&[16.0, 32.0]).iter().filter(|row| row.format == Format::Double) {
///     assert!(row.relative.is_some_and(|(error, _, _)| error < 3.0 * f64::EPSILON));
/// }
/// ```
pub fn factor_errors(exponents: &[f64]) -> Vec<FactorError> {
    let stretches = exponents.iter().enumerate().map(|(i, &n)| {
        let next = exponents.get(i + 1).copied();
        let inner =
            |j: u32| next.map_or(n, |next| n * libm::pow(next / n, f64::from(j) / f64::from(A_STRETCH)));
        (n, (0..A_STRETCH).map(inner).collect::<Vec<f64>>())
    });
    let stretches: Vec<_> = stretches.collect();
    let mut rows = Vec::new();
    for factor in Factor::ALL {
        for format in Format::ALL {
            for (n, inner) in &stretches {
                let relative = match format {
                    Format::Half => largest::<Half, Half>(factor, inner),
                    Format::HalfStored => largest::<Half, f32>(factor, inner),
                    Format::Single => largest::<f32, f32>(factor, inner),
                    Format::Double => largest::<f64, f64>(factor, inner),
                };
                rows.push(FactorError { factor, format, n: *n, relative });
            }
        }
    }
    rows
}

fn largest<S: Real, A: Real>(factor: Factor, exponents: &[f64]) -> Option<(f64, Model, f64)> {
    let mut largest = None;
    for &n in exponents {
        let n = S::from_f64(n).to_f64();
        if !n.is_finite() {
            return None;
        }
        for model in Model::ALL {
            let value = S::from_f64(factor.at(model, A::from_f64(n)).to_f64()).to_f64();
            if !value.is_finite() {
                return None;
            }
            let error = (number(value) / factor.exact(model, n) - number(1.0)).abs().to_f64();
            if largest.is_none_or(|(largest, _, _)| error > largest) {
                largest = Some((error, model, n));
            }
        }
    }
    largest
}
