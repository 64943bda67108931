//! Lobes over slices.

use super::LengthError;
use crate::kernel::real::Real;
use crate::kernel::stand_in::{Argument, StandIn};

/// The specular exponents of a call: one for all elements or one an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exponents<'a, F> {
    /// One n, whose constants are computed once.
    One(F),
    /// One n an element.
    Each(&'a [F]),
}

impl<F: Real> Exponents<'_, F> {
    fn check(&self, expected: usize) -> Result<(), LengthError> {
        match self {
            Exponents::One(_) => Ok(()),
            Exponents::Each(n) => LengthError::check("n", n.len(), expected),
        }
    }

    fn at(&self, i: usize) -> F {
        match self {
            Exponents::One(n) => *n,
            Exponents::Each(n) => n[i],
        }
    }
}

fn value<F: Real>(lobe: StandIn, argument: Argument, x: F, n: F) -> F {
    match argument {
        Argument::Cosine => lobe.at(x, n),
        Argument::Versine => lobe.at_versine(x, n),
    }
}

/// out[i] = lobe(x[i], n[i]).
///
/// # Errors
/// [`LengthError`] for slices of different lengths; `out` is untouched then.
pub fn lobe<F: Real>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &[F],
    out: &mut [F],
) -> Result<(), LengthError> {
    n.check(x.len())?;
    LengthError::check("out", out.len(), x.len())?;
    for (i, (out, x)) in out.iter_mut().zip(x).enumerate() {
        *out = value(lobe, argument, *x, n.at(i));
    }
    Ok(())
}

/// [`lobe`] in place: x[i] = lobe(x[i], n[i]).
///
/// # Errors
/// [`LengthError`].
pub fn lobe_in_place<F: Real>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &mut [F],
) -> Result<(), LengthError> {
    n.check(x.len())?;
    for (i, x) in x.iter_mut().enumerate() {
        *x = value(lobe, argument, *x, n.at(i));
    }
    Ok(())
}

/// Σ weights[i] lobe(x[i], n[i]).
///
/// # Errors
/// [`LengthError`].
pub fn lobe_sum<F: Real>(
    lobe: StandIn,
    argument: Argument,
    n: Exponents<'_, F>,
    x: &[F],
    weights: &[F],
) -> Result<F, LengthError> {
    n.check(x.len())?;
    LengthError::check("weights", weights.len(), x.len())?;
    let mut sum = F::ZERO;
    for (i, (w, x)) in weights.iter().zip(x).enumerate() {
        sum = sum + *w * value(lobe, argument, *x, n.at(i));
    }
    Ok(sum)
}
