//! What the lobe's own angle follows, and how dense it is per solid angle.

use crate::kernel::lobe::{cos_n_versine, cs_versine};
use crate::kernel::model::Model;
use crate::kernel::real::Real;

/// A lobe f whose own angle can be drawn: cosⁿ, or a bell (1 - n w/K)ᴷ of the versine w.
///
/// ```
/// use bellfit::kernel::{lobe::cs_16, sampling::Profile};
/// assert_eq!(Profile::Cs16.value(0.25_f64, 32.0), cs_16(0.75, 32.0));
/// assert_eq!(Profile::ALL.map(Profile::power)[..2], [None, Some(2)]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Profile {
    /// [`cos_n`](crate::kernel::lobe::cos_n).
    CosN,
    /// [`cs`](crate::kernel::lobe::cs) with K = 2.
    Cs2,
    /// K = 4.
    Cs4,
    /// K = 8.
    Cs8,
    /// [`cs_16`](crate::kernel::lobe::cs_16), the paper's lobe.
    Cs16,
    /// K = 32.
    Cs32,
    /// K = 64.
    Cs64,
}

impl Profile {
    /// Every profile, cosⁿ first, then by K.
    pub const ALL: [Self; 7] =
        [Self::CosN, Self::Cs2, Self::Cs4, Self::Cs8, Self::Cs16, Self::Cs32, Self::Cs64];

    /// K of a bell, `None` for cosⁿ.
    #[inline]
    pub const fn power(self) -> Option<u32> {
        match self {
            Self::CosN => None,
            Self::Cs2 => Some(2),
            Self::Cs4 => Some(4),
            Self::Cs8 => Some(8),
            Self::Cs16 => Some(16),
            Self::Cs32 => Some(32),
            Self::Cs64 => Some(64),
        }
    }

    /// The lobe at a versine, (1 - w)ⁿ or (1 - n w/K)ᴷ: [`cos_n_versine`] or [`cs_versine`], whose pages state domain and
    /// accuracy.
    ///
    /// Cost: cosⁿ 1 log1p, 1 exp; a bell log₂ K + 1 multiplications, 1 division by a power of two.
    ///
    /// ```
    /// use bellfit::kernel::sampling::Profile;
    /// assert_eq!(Profile::Cs4.value(0.25_f64, 8.0), libm::pow(1.0 - 8.0 * 0.25 / 4.0, 4.0));
    /// assert!((Profile::CosN.value(0.25_f64, 8.0) - libm::pow(0.75, 8.0)).abs() < 1e-16);
    /// ```
    #[inline]
    pub fn value<F: Real>(self, versine: F, n: F) -> F {
        match self {
            Self::CosN => cos_n_versine(versine, n),
            Self::Cs2 => cs_versine::<2, F>(versine, n),
            Self::Cs4 => cs_versine::<4, F>(versine, n),
            Self::Cs8 => cs_versine::<8, F>(versine, n),
            Self::Cs16 => cs_versine::<16, F>(versine, n),
            Self::Cs32 => cs_versine::<32, F>(versine, n),
            Self::Cs64 => cs_versine::<64, F>(versine, n),
        }
    }
}

/// What the lobe is multiplied by before it is a density per solid angle about its axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Measure {
    /// f(c) dω.
    SolidAngle,
    /// f(c) c dω, solid angle projected onto the plane across the axis.
    Projected,
}

impl Measure {
    /// Power of c beside f: 0 or 1.
    #[inline]
    pub(super) const fn cosines(self) -> u32 {
        match self {
            Self::SolidAngle => 0,
            Self::Projected => 1,
        }
    }
}

/// Distribution of a direction about an axis: proportional to f(c) or f(c) c per solid angle where
/// c > 0, 0 where c ≤ 0; uniform in azimuth.
///
/// ```
/// use bellfit::kernel::{model::Model, sampling::{Density, Measure, Profile}};
/// let density = Density { profile: Profile::Cs16, measure: Measure::Projected };
/// assert_eq!(Density::of(Model::BlinnPhong, Profile::Cs16), density);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Density {
    /// The lobe f.
    pub profile: Profile,
    /// What multiplies it.
    pub measure: Measure,
}

impl Density {
    /// What [`sample`](super::sample) draws for a model about the model's axis: the table of the
    /// [module](super).
    #[inline]
    pub const fn of(model: Model, profile: Profile) -> Self {
        let measure = match model {
            Model::Phong | Model::PhongModified | Model::BlinnPhongNdf => Measure::SolidAngle,
            Model::BlinnPhong | Model::BlinnPhongModified | Model::BlinnPhongHeightfield => {
                Measure::Projected
            }
        };
        Self { profile, measure }
    }

    /// K of the bell that n leaves: where 1 - n rounds to 1, cosⁿ and every bell are 1 to the last digit
    /// and the bells' formulas 0/0, so cosⁿ stands for them.
    #[inline]
    pub(super) fn bell<F: Real>(self, n: F) -> Option<u32> {
        if F::ONE - n < F::ONE { self.profile.power() } else { None }
    }
}

/// Whether n is an exponent that can be sampled: finite and at least 0.
#[inline]
pub(super) fn is_exponent<F: Real>(n: F) -> bool {
    n >= F::ZERO && n.is_finite()
}

/// 1 - (1 - s)ᵐ for s in [0, 1], 1 beyond: the share of a bell's mass within s of its axis.
#[inline]
pub(super) fn fall<F: Real>(m: F, s: F) -> F {
    if s < F::ONE { -(m * (-s).log1p()).expm1() } else { F::ONE }
}

/// ∫ (1 - x w)ᴷ (1 - w) dw from 0 to min(1, 1/x), x ≥ 0.
///
/// With m = K + 2 it is (m x - 1 + (1 - x)ᵐ)/((K + 1) m x²), the power 0 for x > 1. That cancels for
/// small m x, where the binomial series Σ C(K, j) (-x)ʲ/((j + 1)(j + 2)) takes over: its terms alternate
/// and fall faster than (m x)ʲ/(j + 2)!, so that 18 leave less than 2⁻⁵⁹ of the sum.
#[inline]
pub(super) fn projected_mass<F: Real>(k: u32, x: F) -> F {
    let m = F::from_u32(k + 2);
    if m * x >= F::ONE {
        return (m - fall(m, x) / x) / (F::from_u32(k + 1) * m * x);
    }
    let (mut sum, mut term) = (F::HALF, F::ONE);
    for j in 1..18.min(k + 1) {
        term = -term * x * F::from_u32(k + 1 - j) / F::from_u32(j);
        sum = sum + term / F::from_u32((j + 1) * (j + 2));
    }
    sum
}

/// The [`radial_pdf`] on the axis: what the lobe is multiplied by to integrate to 1.
///
/// 1/(2π I), I = ∫ f(1 - w) (1 - w)^m dw over 0 ≤ w ≤ 1, m = 0 for [`Measure::SolidAngle`] and 1 for
/// [`Measure::Projected`]. cosⁿ: (n + 1 + m)/(2π). A bell with n ≥ K: n (K + 1)/(2π K), or
/// n² (K + 1)(K + 2)/(2π K (n (K + 2) - K)); with n < K less what lies behind c = 0.
///
/// - Domain: finite n ≥ 0; per steradian. Other n: NaN. +∞ where it overflows.
/// - Accuracy: relative error within 8 ε, sampled; ε as on the [module's page](super).
/// - Cost: a division and up to 5 multiplications and additions; for bells with n < K one log1p and one
///   expm1 more, or a series of at most 17 terms. It depends on n alone and can be kept.
///
/// ```
/// use bellfit::kernel::{factor::cos_n_factor, model::Model};
/// use bellfit::kernel::sampling::{Density, Measure, Profile, peak};
/// let n = 20.0_f64;
/// let (measure, pi) = (Measure::SolidAngle, std::f64::consts::PI);
/// assert_eq!(peak(Density { profile: Profile::CosN, measure }, n), cos_n_factor(Model::Phong, n));
/// assert_eq!(peak(Density { profile: Profile::Cs16, measure }, n), 17.0 * n / 16.0 / (2.0 * pi));
/// let projected = Density { profile: Profile::Cs16, measure: Measure::Projected };
/// let formula = n * n * 17.0 * 18.0 / (2.0 * pi * 16.0 * (18.0 * n - 16.0));
/// assert!((peak(projected, n) / formula - 1.0).abs() < 1e-15);
/// ```
#[inline]
pub fn peak<F: Real>(density: Density, n: F) -> F {
    if !is_exponent(n) {
        return F::NAN;
    }
    let turn = F::TWO * F::PI;
    let Some(k) = density.bell(n) else {
        return (n + F::from_u32(1 + density.measure.cosines())) / turn;
    };
    let x = n / F::from_u32(k);
    match density.measure {
        Measure::SolidAngle => {
            let m = F::from_u32(k + 1);
            m * x / (fall(m, x) * turn)
        }
        Measure::Projected => F::ONE / (projected_mass(k, x) * turn),
    }
}

/// Density per solid angle of a direction about its axis, from the versine of the angle between them.
///
/// peak · f(n, w) · (1 - w)^m for 0 ≤ w < 1, else 0; m as in [`peak`]. Over the sphere, 2π ∫ … dw = 1.
///
/// - Domain: w in [0, 2], finite n ≥ 0; per steradian. Other n and NaN in either argument: NaN.
/// - Accuracy: that of [`peak`] and of the lobe.
/// - Cost: [`peak`], the lobe and 1 to 3 operations.
///
/// ```
/// use bellfit::kernel::sampling::{Density, Measure, Profile, radial_pdf};
/// let density = Density { profile: Profile::CosN, measure: Measure::Projected };
/// // n = 0: Lambert's c/π.
/// assert!((radial_pdf(density, 0.0, 0.25) - 0.75 / std::f64::consts::PI).abs() < 1e-15);
/// assert_eq!(radial_pdf(density, 0.0, 1.5), 0.0);
/// ```
#[inline]
pub fn radial_pdf<F: Real>(density: Density, n: F, versine: F) -> F {
    if versine.is_nan() || !is_exponent(n) {
        return F::NAN;
    }
    if versine < F::ZERO || versine >= F::ONE {
        return F::ZERO;
    }
    let on_axis = peak(density, n) * density.profile.value(versine, n);
    match density.measure {
        Measure::SolidAngle => on_axis,
        Measure::Projected => on_axis * (F::ONE - versine),
    }
}
