//! What may stand for cosⁿ, as a value: for programs that choose at run time.

use super::constants::{CUBIC_COS_N, LINEAR_COS_N};
use super::cubic::{BellFormula, CubicLobe};
use super::exact::Cost;
use super::linear::LinearLobe;
use super::lobe::{
    cos_n, cos_n_versine, schlick, schlick_printed, spherical_gaussian, spherical_gaussian_versine,
};
use super::power::{cos_n_exp2, cos_n_whole};
use super::real::Real;

/// What of the lobe's angle is handed over.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Argument {
    /// c = cos θ, a dot product.
    Cosine,
    /// w = 1 - cos θ, from [`versine`](super::lobe::versine) or
    /// [`versine_between`](super::vector::versine_between).
    Versine,
}

/// A lobe that stands for cosⁿ, or cosⁿ by one of the ways to it.
///
/// Each is 1 at θ = 0. Distances from cosⁿ: [`linear`](super::linear) and [`cubic`](super::cubic) for every
/// n ≥ 16; the last three are cosⁿ but for rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StandIn {
    /// The lobe paper's cs_16 with its exact cut, (1).
    Cs16,
    /// [`LinearLobe`], K = 2.
    Linear2,
    /// [`LinearLobe`], K = 4.
    Linear4,
    /// [`LinearLobe`], K = 8.
    Linear8,
    /// [`LinearLobe`], K = 16.
    Linear16,
    /// [`LinearLobe`], K = 32.
    Linear32,
    /// [`CubicLobe`], K = 2.
    Cubic2,
    /// [`CubicLobe`], K = 4.
    Cubic4,
    /// [`CubicLobe`], K = 8.
    Cubic8,
    /// Schlick's rational lobe as [`schlick`] computes it.
    Schlick,
    /// The same as printed, [`schlick_printed`].
    SchlickPrinted,
    /// [`spherical_gaussian`] of sharpness n.
    SphericalGaussian,
    /// cosⁿ by squarings, [`cos_n_whole`]: whole n only.
    Squarings,
    /// cosⁿ as 2^(n log₂ c), [`cos_n_exp2`].
    Exp2Log2,
    /// cosⁿ by `pow`, [`cos_n`].
    Power,
}

impl StandIn {
    /// All of them.
    pub const ALL: [StandIn; 15] = [
        StandIn::Cs16,
        StandIn::Linear2,
        StandIn::Linear4,
        StandIn::Linear8,
        StandIn::Linear16,
        StandIn::Linear32,
        StandIn::Cubic2,
        StandIn::Cubic4,
        StandIn::Cubic8,
        StandIn::Schlick,
        StandIn::SchlickPrinted,
        StandIn::SphericalGaussian,
        StandIn::Squarings,
        StandIn::Exp2Log2,
        StandIn::Power,
    ];

    /// The name in files and on the command line.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::StandIn;
    /// assert_eq!(StandIn::Cubic4.id(), "cubic-4");
    /// ```
    pub const fn id(self) -> &'static str {
        match self {
            StandIn::Cs16 => "cs-16",
            StandIn::Linear2 => "linear-2",
            StandIn::Linear4 => "linear-4",
            StandIn::Linear8 => "linear-8",
            StandIn::Linear16 => "linear-16",
            StandIn::Linear32 => "linear-32",
            StandIn::Cubic2 => "cubic-2",
            StandIn::Cubic4 => "cubic-4",
            StandIn::Cubic8 => "cubic-8",
            StandIn::Schlick => "schlick",
            StandIn::SchlickPrinted => "schlick-printed",
            StandIn::SphericalGaussian => "spherical-gaussian",
            StandIn::Squarings => "squarings",
            StandIn::Exp2Log2 => "exp2-log2",
            StandIn::Power => "pow",
        }
    }

    /// The one with this [`id`](Self::id), exactly spelt; `None` if there is none.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::StandIn;
    /// assert!(StandIn::ALL.iter().all(|s| StandIn::from_id(s.id()) == Some(*s)));
    /// ```
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|stand_in| stand_in.id() == id)
    }

    /// K and the degree of p, for a bell p^K.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::StandIn;
    /// assert_eq!(StandIn::Cubic4.bell(), Some((4, 3)));
    /// assert_eq!(StandIn::Schlick.bell(), None);
    /// ```
    pub const fn bell(self) -> Option<(u32, u32)> {
        match self {
            StandIn::Cs16 | StandIn::Linear16 => Some((16, 1)),
            StandIn::Linear2 => Some((2, 1)),
            StandIn::Linear4 => Some((4, 1)),
            StandIn::Linear8 => Some((8, 1)),
            StandIn::Linear32 => Some((32, 1)),
            StandIn::Cubic2 => Some((2, 3)),
            StandIn::Cubic4 => Some((4, 3)),
            StandIn::Cubic8 => Some((8, 3)),
            _ => None,
        }
    }

    /// The bell's formula over n, with the coefficients as adopted; `None` for what is no bell.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::StandIn;
    /// let formula = StandIn::Cs16.formula().unwrap();
    /// assert_eq!((formula.power, formula.at(64.0)), (16, (16.0, 0.0, 0.0)));
    /// ```
    pub fn formula(self) -> Option<BellFormula> {
        let (power, degree) = self.bell()?;
        if self == StandIn::Cs16 {
            return Some(BellFormula { power, reach: [16.0, 0.0, 0.0], linear: [0.0; 3], square: [0.0; 3] });
        }
        let rows = if degree == 3 { &CUBIC_COS_N[..] } else { &LINEAR_COS_N[..] };
        rows.iter().find(|row| row.power == power).copied()
    }

    /// Whether it is cosⁿ itself but for rounding.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::StandIn;
    /// assert!(StandIn::Squarings.is_exact() && !StandIn::Cs16.is_exact());
    /// ```
    pub const fn is_exact(self) -> bool {
        matches!(self, StandIn::Squarings | StandIn::Exp2Log2 | StandIn::Power)
    }

    /// The value at c = cos θ and n, the constants of n computed on the spot.
    ///
    /// Domain, ends and NaN as the function that the variant names. [`StandIn::Squarings`] at an n that is not
    /// whole or beyond `u32`: NaN.
    ///
    /// ```
    /// use bellfit::kernel::{lobe::schlick, stand_in::StandIn};
    /// assert_eq!(StandIn::Schlick.at(0.9_f64, 20.0), schlick(0.9, 20.0));
    /// assert!(StandIn::Squarings.at(0.9_f64, 20.5).is_nan());
    /// ```
    pub fn at<F: Real>(self, cos: F, n: F) -> F {
        match self {
            StandIn::Cs16 => LinearLobe::<16, F>::lyon(n).at(cos),
            StandIn::Linear2 => LinearLobe::<2, F>::new(n).at(cos),
            StandIn::Linear4 => LinearLobe::<4, F>::new(n).at(cos),
            StandIn::Linear8 => LinearLobe::<8, F>::new(n).at(cos),
            StandIn::Linear16 => LinearLobe::<16, F>::new(n).at(cos),
            StandIn::Linear32 => LinearLobe::<32, F>::new(n).at(cos),
            StandIn::Cubic2 => CubicLobe::<2, F>::new(n).at(cos),
            StandIn::Cubic4 => CubicLobe::<4, F>::new(n).at(cos),
            StandIn::Cubic8 => CubicLobe::<8, F>::new(n).at(cos),
            StandIn::Schlick => schlick(cos, n),
            StandIn::SchlickPrinted => schlick_printed(cos, n),
            StandIn::SphericalGaussian => spherical_gaussian(cos, n),
            StandIn::Squarings => match whole(n) {
                Some(n) => cos_n_whole(cos, n),
                None => F::NAN,
            },
            StandIn::Exp2Log2 => cos_n_exp2(cos, n),
            StandIn::Power => cos_n(cos, n),
        }
    }

    /// The value at the versine w = 1 - cos θ and n. Those that have no form in w go by way of c = 1 - w, but
    /// `pow`, which has [`cos_n_versine`].
    ///
    /// ```
    /// use bellfit::kernel::{lobe::cos_n_versine, stand_in::StandIn};
    /// assert_eq!(StandIn::Power.at_versine(1e-9_f64, 1e9), cos_n_versine(1e-9, 1e9));
    /// ```
    pub fn at_versine<F: Real>(self, versine: F, n: F) -> F {
        match self {
            StandIn::Cs16 => LinearLobe::<16, F>::lyon(n).at_versine(versine),
            StandIn::Linear2 => LinearLobe::<2, F>::new(n).at_versine(versine),
            StandIn::Linear4 => LinearLobe::<4, F>::new(n).at_versine(versine),
            StandIn::Linear8 => LinearLobe::<8, F>::new(n).at_versine(versine),
            StandIn::Linear16 => LinearLobe::<16, F>::new(n).at_versine(versine),
            StandIn::Linear32 => LinearLobe::<32, F>::new(n).at_versine(versine),
            StandIn::Cubic2 => CubicLobe::<2, F>::new(n).at_versine(versine),
            StandIn::Cubic4 => CubicLobe::<4, F>::new(n).at_versine(versine),
            StandIn::Cubic8 => CubicLobe::<8, F>::new(n).at_versine(versine),
            StandIn::Schlick => schlick_versine(versine, n),
            StandIn::SphericalGaussian => spherical_gaussian_versine(versine, n),
            StandIn::Power => cos_n_versine(versine, n),
            StandIn::SchlickPrinted | StandIn::Squarings | StandIn::Exp2Log2 => self.at(F::ONE - versine, n),
        }
    }

    /// What one value costs at the exponent n, what depends on n alone computed beforehand.
    ///
    /// Multiply, add, fused multiply-add and maximum one each; divisions and transcendentals beside. The maxima
    /// that guard a cosine below 0 count for cosⁿ, whose logarithm needs it, and Schlick's, and not for a
    /// bell, which its own maximum ends. n counts for [`StandIn::Squarings`] alone: there whole, rounded
    /// down.
    ///
    /// ```
    /// use bellfit::kernel::{exact::Cost, stand_in::{Argument, StandIn}};
    /// let cost = StandIn::Cubic4.cost(Argument::Cosine, 64.0);
    /// assert_eq!(cost, Cost { operations: 6, divisions: 0, transcendentals: 0 });
    /// ```
    pub fn cost(self, argument: Argument, n: f64) -> Cost {
        let only = |operations| Cost { operations, divisions: 0, transcendentals: 0 };
        // 1 - w or 1 - c, where the other is handed over
        let to_cosine = u32::from(argument == Argument::Versine);
        let to_versine = u32::from(argument == Argument::Cosine);
        match self {
            StandIn::Cubic8 => only(3 + 1 + 3 + to_versine),
            // c + n (1 - c) from c: a difference and a fused multiply-add
            StandIn::Schlick => {
                Cost { operations: 1 + to_cosine + to_versine + 1, divisions: 1, transcendentals: 0 }
            }
            // n + (1 - n) c
            StandIn::SchlickPrinted => {
                Cost { operations: 1 + to_cosine + 1, divisions: 1, transcendentals: 0 }
            }
            StandIn::SphericalGaussian => {
                Cost { operations: 1 + to_versine, divisions: 0, transcendentals: 1 }
            }
            StandIn::Squarings => {
                let n = n as u32;
                only(1 + to_cosine + n.checked_ilog2().map_or(0, |log| log + n.count_ones() - 1))
            }
            StandIn::Exp2Log2 => Cost { operations: 2 + to_cosine, divisions: 0, transcendentals: 2 },
            StandIn::Power => Cost { operations: 1 + to_cosine, divisions: 0, transcendentals: 2 },
            _ => {
                let (power, degree) = self.bell().unwrap_or((1, 0));
                only(degree + 1 + power.trailing_zeros())
            }
        }
    }
}

/// Schlick's lobe from the versine: (1 - w)/((1 - w) + n w).
#[inline]
fn schlick_versine<F: Real>(versine: F, n: F) -> F {
    if versine.is_nan() || n.is_nan() {
        return F::NAN;
    }
    let cos = F::ONE - versine;
    if cos <= F::ZERO {
        return F::ZERO;
    }
    cos / (cos + n * versine)
}

/// n as a whole number, if it is one.
#[inline]
fn whole<F: Real>(n: F) -> Option<u32> {
    let n = n.to_f64();
    let whole = n as u32;
    (f64::from(whole) == n).then_some(whole)
}
