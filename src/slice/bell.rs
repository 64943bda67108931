//! Bells over slices.

use super::route::{self, Function};
use super::{Float, LengthError, Unit};
use crate::kernel::bell::bell as lyon;
use crate::kernel::cubic::cubic_bell;
use crate::kernel::real::Real;

/// A bell of t ≥ 0, or the exponential that it stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Bell {
    /// Lyon's (1 - t/K)^K, [`bell`](crate::kernel::bell::bell); K = 2, 4, 8, 16, 32 or 64, another: NaN.
    Lyon(u32),
    /// The bell of degree three, [`cubic_bell`]; K = 2, 4 or 8, another: NaN.
    Cubic(u32),
    /// e⁻ᵗ.
    Exponential,
}

impl Bell {
    /// The scalar kernel's value at t.
    ///
    /// ```
    /// use bellfit::slice::Bell;
    /// assert_eq!(Bell::Lyon(2).at(1.0_f64), 0.25); // (1 - 1/2)²
    /// assert!(Bell::Cubic(3).at(0.0_f64).is_nan());
    /// ```
    #[inline]
    pub fn at<F: Real>(self, t: F) -> F {
        match self {
            Bell::Lyon(2) => lyon::<2, F>(t),
            Bell::Lyon(4) => lyon::<4, F>(t),
            Bell::Lyon(8) => lyon::<8, F>(t),
            Bell::Lyon(16) => lyon::<16, F>(t),
            Bell::Lyon(32) => lyon::<32, F>(t),
            Bell::Lyon(64) => lyon::<64, F>(t),
            Bell::Cubic(2) => cubic_bell::<2, F>(t),
            Bell::Cubic(4) => cubic_bell::<4, F>(t),
            Bell::Cubic(8) => cubic_bell::<8, F>(t),
            Bell::Lyon(_) | Bell::Cubic(_) => F::NAN,
            Bell::Exponential => (-t).exp(),
        }
    }
}

/// `out[i] = bell(t[i])`.
///
/// Domain, ends and NaN as the scalar kernels' pages; how near the two are, the [module](super)'s.
///
/// # Errors
/// [`LengthError`] if `out` has another length; it is untouched then.
///
/// ```
/// use bellfit::slice::{Bell, bell};
/// let mut out = [0.0_f32; 3];
/// bell(Bell::Lyon(4), &[0.0, 2.0, 4.0], &mut out)?;
/// assert_eq!(out, [1.0, 0.0625, 0.0]);
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn bell<F: Float>(bell: Bell, t: &[F], out: &mut [F]) -> Result<(), LengthError> {
    route::across(Unit::best, Function::Bell(bell), t, out)
}

/// [`bell`] in place.
///
/// ```
/// use bellfit::slice::{Bell, bell_in_place};
/// let mut t = [0.0, 1.0, f64::INFINITY];
/// bell_in_place(Bell::Exponential, &mut t);
/// assert!(t[0] == 1.0 && (t[1] - libm::exp(-1.0)).abs() < 1e-16 && t[2] == 0.0);
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn bell_in_place<F: Float>(bell: Bell, t: &mut [F]) {
    route::within(Unit::best, Function::Bell(bell), t);
}

/// `Σ weights[i] bell(t[i])`.
///
/// # Errors
/// [`LengthError`].
///
/// ```
/// use bellfit::slice::{Bell, bell_sum};
/// assert_eq!(bell_sum(Bell::Lyon(2), &[0.0, 1.0], &[3.0, 8.0]), Ok(5.0));
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn bell_sum<F: Float>(bell: Bell, t: &[F], weights: &[F]) -> Result<F, LengthError> {
    route::sum(Unit::best, Function::Bell(bell), t, weights)
}

impl Unit {
    /// [`bell`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn bell<F: Float>(self, bell: Bell, t: &[F], out: &mut [F]) -> Result<(), LengthError> {
        route::across(|| self, Function::Bell(bell), t, out)
    }

    /// [`bell_in_place`] on this unit.
    #[inline]
    pub fn bell_in_place<F: Float>(self, bell: Bell, t: &mut [F]) {
        route::within(|| self, Function::Bell(bell), t);
    }

    /// [`bell_sum`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn bell_sum<F: Float>(self, bell: Bell, t: &[F], weights: &[F]) -> Result<F, LengthError> {
        route::sum(|| self, Function::Bell(bell), t, weights)
    }
}
