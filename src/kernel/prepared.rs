//! A lobe chosen at run time, made ready for one material.

use super::cubic::CubicLobe;
use super::linear::LinearLobe;
use super::power::cos_n_whole;
use super::real::Real;
use super::stand_in::{Argument, StandIn};
use super::vector::{Vec3, versine_between};

/// A [`StandIn`] at one exponent, its constants computed in `f64` once and rounded to the type that evaluates it:
/// what a renderer keeps with a material.
///
/// f(c) = f(1 - w), with f the lobe that the stand-in names: for a bell max(p, 0)^K of the constants of n, which
/// [`LinearLobe::convert`] and [`CubicLobe::convert`] round; for [`StandIn::Squarings`] cⁿ with n kept whole; for the
/// others the function of c and the rounded n.
///
/// - Domain: n as the stand-in's own; outside it, and for squarings at an n that is not whole or beyond `u32`, a
///   lobe of NaN. Ends and NaN in the argument as the function that the stand-in names.
/// - Accuracy: that function's, and its constants' rounding, which moves t = n w by a few u relative to itself. `fits/stability.csv`
///   has what it comes to in each format.
///
/// ```
/// use bellfit::kernel::{cubic::CubicLobe, prepared::Prepared, stand_in::StandIn};
/// let lobe = Prepared::<f32>::new(StandIn::Cubic4, 64.0);
/// assert_eq!(lobe.at(0.99), CubicLobe::<4, f64>::new(64.0).convert::<f32>().at(0.99));
/// assert!((lobe.at(0.99) - libm::powf(0.99, 64.0)).abs() < 4.9e-4);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prepared<F>(Lobe<F>);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Lobe<F> {
    Linear2(LinearLobe<2, F>),
    Linear4(LinearLobe<4, F>),
    Linear8(LinearLobe<8, F>),
    Linear16(LinearLobe<16, F>),
    Linear32(LinearLobe<32, F>),
    Cubic2(CubicLobe<2, F>),
    Cubic4(CubicLobe<4, F>),
    Cubic8(CubicLobe<8, F>),
    Whole(u32),
    Of(StandIn, F),
}

impl<F: Real> Prepared<F> {
    /// The constants of n: each c of `f64` becomes c (1 + δ), |δ| ≤ u = 2⁻²⁴ or 2⁻⁵³.
    ///
    /// ```
    /// use bellfit::kernel::{prepared::Prepared, stand_in::StandIn};
    /// assert_eq!(Prepared::<f64>::new(StandIn::Squarings, 3.0).at(0.5), 0.5 * 0.5 * 0.5);
    /// assert!(Prepared::<f64>::new(StandIn::Squarings, 3.5).at(0.5).is_nan());
    /// ```
    pub fn new(stand_in: StandIn, n: f64) -> Self {
        Prepared(match stand_in {
            StandIn::Cs16 => Lobe::Linear16(LinearLobe::<16, f64>::lyon(n).convert()),
            StandIn::Linear2 => Lobe::Linear2(LinearLobe::<2, f64>::new(n).convert()),
            StandIn::Linear4 => Lobe::Linear4(LinearLobe::<4, f64>::new(n).convert()),
            StandIn::Linear8 => Lobe::Linear8(LinearLobe::<8, f64>::new(n).convert()),
            StandIn::Linear16 => Lobe::Linear16(LinearLobe::<16, f64>::new(n).convert()),
            StandIn::Linear32 => Lobe::Linear32(LinearLobe::<32, f64>::new(n).convert()),
            StandIn::Cubic2 => Lobe::Cubic2(CubicLobe::<2, f64>::new(n).convert()),
            StandIn::Cubic4 => Lobe::Cubic4(CubicLobe::<4, f64>::new(n).convert()),
            StandIn::Cubic8 => Lobe::Cubic8(CubicLobe::<8, f64>::new(n).convert()),
            StandIn::Squarings => {
                let whole = n as u32;
                if f64::from(whole) == n { Lobe::Whole(whole) } else { Lobe::Of(stand_in, F::NAN) }
            }
            StandIn::Schlick
            | StandIn::SchlickPrinted
            | StandIn::SphericalGaussian
            | StandIn::Exp2Log2
            | StandIn::Power => Lobe::Of(stand_in, F::from_f64(n)),
        })
    }

    /// Whether every constant that the argument asks for is a number of the type: binary16 ends at 65504, and a
    /// stand-in's domain where its page says.
    ///
    /// ```
    /// use bellfit::kernel::{prepared::Prepared, stand_in::{Argument, StandIn}};
    /// assert!(Prepared::<f32>::new(StandIn::Power, 1e38).is_finite(Argument::Cosine));
    /// assert!(!Prepared::<f32>::new(StandIn::Power, 1e39).is_finite(Argument::Cosine));
    /// ```
    pub fn is_finite(&self, argument: Argument) -> bool {
        fn linear<const K: u32, F: Real>(lobe: &LinearLobe<K, F>) -> bool {
            lobe.constants().iter().all(|c| c.is_finite())
        }
        fn cubic<const K: u32, F: Real>(lobe: &CubicLobe<K, F>, argument: Argument) -> bool {
            // K = 8 goes by way of 1 - cos θ.
            if argument == Argument::Cosine && K <= 4 {
                lobe.depressed().iter().all(|c| c.is_finite())
            } else {
                lobe.horner().iter().all(|c| c.is_finite())
            }
        }
        match &self.0 {
            Lobe::Linear2(lobe) => linear(lobe),
            Lobe::Linear4(lobe) => linear(lobe),
            Lobe::Linear8(lobe) => linear(lobe),
            Lobe::Linear16(lobe) => linear(lobe),
            Lobe::Linear32(lobe) => linear(lobe),
            Lobe::Cubic2(lobe) => cubic(lobe, argument),
            Lobe::Cubic4(lobe) => cubic(lobe, argument),
            Lobe::Cubic8(lobe) => cubic(lobe, argument),
            Lobe::Whole(_) => true,
            Lobe::Of(_, n) => n.is_finite(),
        }
    }

    /// The lobe at c = cos θ.
    ///
    /// ```
    /// use bellfit::kernel::{lobe::schlick, prepared::Prepared, stand_in::StandIn};
    /// assert_eq!(Prepared::<f64>::new(StandIn::Schlick, 20.0).at(0.9), schlick(0.9, 20.0));
    /// ```
    #[inline]
    pub fn at(&self, cos: F) -> F {
        match &self.0 {
            Lobe::Linear2(lobe) => lobe.at(cos),
            Lobe::Linear4(lobe) => lobe.at(cos),
            Lobe::Linear8(lobe) => lobe.at(cos),
            Lobe::Linear16(lobe) => lobe.at(cos),
            Lobe::Linear32(lobe) => lobe.at(cos),
            Lobe::Cubic2(lobe) => lobe.at(cos),
            Lobe::Cubic4(lobe) => lobe.at(cos),
            Lobe::Cubic8(lobe) => lobe.at(cos),
            Lobe::Whole(n) => cos_n_whole(cos, *n),
            Lobe::Of(stand_in, n) => stand_in.at(cos, *n),
        }
    }

    /// The lobe at the versine w = 1 - cos θ, as [`StandIn::at_versine`] takes it.
    ///
    /// ```
    /// use bellfit::kernel::{prepared::Prepared, stand_in::StandIn};
    /// let lobe = Prepared::<f64>::new(StandIn::Cs16, 1e6);
    /// assert_eq!(lobe.at_versine(8e-6), libm::pow(0.5, 16.0)); // n w = 8
    /// ```
    #[inline]
    pub fn at_versine(&self, versine: F) -> F {
        match &self.0 {
            Lobe::Linear2(lobe) => lobe.at_versine(versine),
            Lobe::Linear4(lobe) => lobe.at_versine(versine),
            Lobe::Linear8(lobe) => lobe.at_versine(versine),
            Lobe::Linear16(lobe) => lobe.at_versine(versine),
            Lobe::Linear32(lobe) => lobe.at_versine(versine),
            Lobe::Cubic2(lobe) => lobe.at_versine(versine),
            Lobe::Cubic4(lobe) => lobe.at_versine(versine),
            Lobe::Cubic8(lobe) => lobe.at_versine(versine),
            Lobe::Whole(n) => cos_n_whole(F::ONE - versine, *n),
            Lobe::Of(stand_in, n) => stand_in.at_versine(versine, *n),
        }
    }

    /// The lobe of the angle between two unit vectors, N and H or R and V: at w = |a - b|²/2
    /// ([`versine_between`]).
    ///
    /// ```
    /// use bellfit::kernel::{prepared::Prepared, stand_in::StandIn, vector::half_vector};
    /// let (up, slant) = ([0.0_f64, 0.0, 1.0], [0.6, 0.0, 0.8]);
    /// let half = half_vector(slant, up).unwrap();
    /// let (lobe, n_h) = (Prepared::new(StandIn::Power, 32.0), libm::sqrt(0.9));
    /// assert!((lobe.between(up, half) - libm::pow(n_h, 32.0)).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn between(&self, a: Vec3<F>, b: Vec3<F>) -> F {
        self.at_versine(versine_between(a, b))
    }

    /// The lobe at an argument of either kind: f(c) or f(1 - w), w = 1 - c.
    ///
    /// ```
    /// use bellfit::kernel::{prepared::Prepared, stand_in::{Argument, StandIn}};
    /// let lobe = Prepared::<f64>::new(StandIn::Linear8, 32.0);
    /// assert_eq!(lobe.of(Argument::Cosine, 0.75), lobe.at(0.75));
    /// assert_eq!(lobe.of(Argument::Versine, 0.25), lobe.at_versine(0.25));
    /// ```
    #[inline]
    pub fn of(&self, argument: Argument, x: F) -> F {
        match argument {
            Argument::Cosine => self.at(x),
            Argument::Versine => self.at_versine(x),
        }
    }
}
