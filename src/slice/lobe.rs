//! Lobes over slices.

use super::route::{self, Function};
use super::{Float, LengthError, Unit};
use crate::kernel::stand_in::{Argument, StandIn};

/// The specular exponents of a call: one for all elements or one an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exponents<'a, F> {
    /// One n, whose constants are computed once.
    One(F),
    /// One n an element.
    Each(&'a [F]),
}

impl<'a, F: Float> Exponents<'a, F> {
    /// What is computed, if there is an n for each of so many elements.
    #[inline]
    fn of(self, lobe: StandIn, argument: Argument, expected: usize) -> Result<Function<'a, F>, LengthError> {
        match self {
            Exponents::One(n) => Ok(Function::Lobe(lobe, argument, n)),
            Exponents::Each(n) => {
                LengthError::check("n", n.len(), expected)?;
                Ok(Function::Lobes(lobe, argument, n))
            }
        }
    }
}

/// The scalar call for a slice of one, before anything is made of the arguments that must be stored and read
/// back: that would cost more than the value.
#[inline(always)]
fn only<F: Float>(lobe: StandIn, argument: Argument, n: Exponents<'_, F>, x: &[F]) -> Option<F> {
    let (x, n) = match (x, n) {
        ([x], Exponents::One(n)) => (*x, n),
        ([x], Exponents::Each([n])) => (*x, *n),
        _ => return None,
    };
    Some(match argument {
        Argument::Cosine => lobe.at(x, n),
        Argument::Versine => lobe.at_versine(x, n),
    })
}

/// `out[i] = lobe(x[i], n[i])`, x the cosines or the versines.
///
/// Domain, ends and NaN as the scalar kernels' pages, [`StandIn`]; how near the two are, the [module](super)'s.
///
/// # Errors
/// [`LengthError`] for slices of different lengths; `out` is untouched then.
///
/// ```
/// use bellfit::kernel::stand_in::{Argument, StandIn};
/// use bellfit::slice::{Exponents, lobe};
/// let mut out = [0.0_f32; 3];
/// lobe(StandIn::Cs16, Argument::Cosine, Exponents::One(16.0), &[1.0, 0.5, -0.5], &mut out)?;
/// assert_eq!(out, [1.0, 1.0 / 65536.0, 0.0]); // at n = 16 it is c¹⁶
/// let error = lobe(StandIn::Cs16, Argument::Cosine, Exponents::Each(&[16.0]), &[1.0, 0.5], &mut out);
/// assert_eq!(error.unwrap_err().name, "n");
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn lobe<F: Float>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &[F],
    out: &mut [F],
) -> Result<(), LengthError> {
    if let ([out], Some(value)) = (&mut *out, only(lobe, argument, n, x)) {
        *out = value;
        return Ok(());
    }
    route::across(Unit::best, n.of(lobe, argument, x.len())?, x, out)
}

/// [`lobe`] in place: `x[i] = lobe(x[i], n[i])`.
///
/// # Errors
/// [`LengthError`]; `x` is untouched then.
///
/// ```
/// use bellfit::kernel::stand_in::{Argument, StandIn};
/// use bellfit::slice::{Exponents, lobe_in_place};
/// let mut x = [0.5, 0.25];
/// lobe_in_place(StandIn::Power, Argument::Cosine, Exponents::Each(&[3.0, 0.5]), &mut x)?;
/// assert_eq!(x, [0.125, 0.5]);
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn lobe_in_place<F: Float>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &mut [F],
) -> Result<(), LengthError> {
    if let Some(value) = only(lobe, argument, n, x) {
        x[0] = value;
        return Ok(());
    }
    route::within(Unit::best, n.of(lobe, argument, x.len())?, x);
    Ok(())
}

/// `Σ weights[i] lobe(x[i], n[i])`, in 64 partial sums.
///
/// Their order is fixed by the places of the elements: the same on every run, and on every unit.
///
/// # Errors
/// [`LengthError`].
///
/// ```
/// use bellfit::kernel::stand_in::{Argument, StandIn};
/// use bellfit::slice::{Exponents, lobe_sum};
/// let (c, light) = ([1.0, 0.5], [3.0, 65536.0]);
/// assert_eq!(lobe_sum(StandIn::Cs16, Argument::Cosine, Exponents::One(16.0), &c, &light), Ok(4.0));
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn lobe_sum<F: Float>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &[F],
    weights: &[F],
) -> Result<F, LengthError> {
    if let ([weight], Some(value)) = (weights, only(lobe, argument, n, x)) {
        return Ok(*weight * value);
    }
    route::sum(Unit::best, n.of(lobe, argument, x.len())?, x, weights)
}

impl Unit {
    /// [`lobe`] on this unit.
    ///
    /// # Errors
    /// As there.
    ///
    /// ```
    /// use bellfit::kernel::stand_in::{Argument, StandIn};
    /// use bellfit::slice::{Exponents, Unit};
    /// let mut out = [0.0_f64; 2];
    /// for unit in Unit::available() {
    ///     unit.lobe(StandIn::Squarings, Argument::Cosine, Exponents::One(2.0), &[0.5, 0.25], &mut out)?;
    ///     assert_eq!(out, [0.25, 0.0625]);
    /// }
    /// # Ok::<(), bellfit::slice::LengthError>(())
    /// ```
    #[inline]
    pub fn lobe<F: Float>(
        self,
        lobe: StandIn,
        argument: Argument,
        n: Exponents<'_, F>,
        x: &[F],
        out: &mut [F],
    ) -> Result<(), LengthError> {
        route::across(|| self, n.of(lobe, argument, x.len())?, x, out)
    }

    /// [`lobe_in_place`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn lobe_in_place<F: Float>(
        self,
        lobe: StandIn,
        argument: Argument,
        n: Exponents<'_, F>,
        x: &mut [F],
    ) -> Result<(), LengthError> {
        route::within(|| self, n.of(lobe, argument, x.len())?, x);
        Ok(())
    }

    /// [`lobe_sum`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn lobe_sum<F: Float>(
        self,
        lobe: StandIn,
        argument: Argument,
        n: Exponents<'_, F>,
        x: &[F],
        weights: &[F],
    ) -> Result<F, LengthError> {
        route::sum(|| self, n.of(lobe, argument, x.len())?, x, weights)
    }
}
