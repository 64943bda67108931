//! From a call, its slices checked, to the loops: compiled here for both types, and not in every crate that
//! calls them.

use super::bell::Bell;
use super::choice;
use super::pass::{Across, Beside, Sum, Within};
use super::{Float, LengthError, Unit};
use crate::kernel::pixel::PixelWeight;
use crate::kernel::real::Real;
use crate::kernel::stand_in::{Argument, StandIn};

/// What is computed of each element.
#[derive(Clone, Copy)]
pub enum Function<'a, F> {
    Lobe(StandIn, Argument, F),
    Lobes(StandIn, Argument, &'a [F]),
    Bell(Bell),
    Weight(PixelWeight<F>),
    Weights(PixelWeight<F>, &'a [F]),
}

/// The three passes over slices whose lengths agree.
pub trait Routes: Sized {
    /// x to out.
    fn across(unit: Unit, function: Function<'_, Self>, x: &[Self], out: &mut [Self]);
    /// x to itself.
    fn within(unit: Unit, function: Function<'_, Self>, x: &mut [Self]);
    /// Σ weight f(x).
    fn sum(unit: Unit, function: Function<'_, Self>, x: &[Self], weights: &[Self]) -> Self;
}

macro_rules! route {
    ($unit:expr, $function:expr, $pass:expr) => {
        match $function {
            Function::Lobe(lobe, argument, n) => choice::lobe($unit, lobe, argument, n, $pass),
            Function::Lobes(lobe, argument, n) => {
                choice::lobes($unit, lobe, argument, Beside { pass: $pass, n })
            }
            Function::Bell(bell) => choice::bell($unit, bell, $pass),
            Function::Weight(weight) => choice::weight($unit, weight, $pass),
            Function::Weights(weight, bb) => choice::weights($unit, weight, Beside { pass: $pass, n: bb }),
        }
    };
}

macro_rules! routes {
    ($float:ty) => {
        impl Routes for $float {
            fn across(unit: Unit, function: Function<'_, Self>, x: &[Self], out: &mut [Self]) {
                route!(unit, function, Across { x, out })
            }

            fn within(unit: Unit, function: Function<'_, Self>, x: &mut [Self]) {
                route!(unit, function, Within(x))
            }

            fn sum(unit: Unit, function: Function<'_, Self>, x: &[Self], weights: &[Self]) -> Self {
                route!(unit, function, Sum { x, weights })
            }
        }
    };
}

routes!(f32);
routes!(f64);

impl<F: Real> Function<'_, F> {
    /// The scalar kernels' value of the element at i.
    #[inline(always)]
    pub fn value(self, x: F, i: usize) -> F {
        let lobe = |lobe: StandIn, argument, n| match argument {
            Argument::Cosine => lobe.at(x, n),
            Argument::Versine => lobe.at_versine(x, n),
        };
        match self {
            Function::Lobe(stand_in, argument, n) => lobe(stand_in, argument, n),
            Function::Lobes(stand_in, argument, n) => lobe(stand_in, argument, n[i]),
            Function::Bell(bell) => bell.at(x),
            Function::Weight(weight) => weight.at(x, F::ZERO),
            Function::Weights(weight, bb) => weight.at(x, bb[i]),
        }
    }
}

/// x to out. A slice of one is the scalar call: the way to the loops would cost more than the value.
#[inline(always)]
pub(super) fn across<F: Float>(
    unit: impl FnOnce() -> Unit,
    function: Function<'_, F>,
    x: &[F],
    out: &mut [F],
) -> Result<(), LengthError> {
    LengthError::check("out", out.len(), x.len())?;
    match (x, &mut *out) {
        ([x], [out]) => *out = function.value(*x, 0),
        _ => F::across(unit(), function, x, out),
    }
    Ok(())
}

/// x to itself, a slice of one likewise.
#[inline(always)]
pub(super) fn within<F: Float>(unit: impl FnOnce() -> Unit, function: Function<'_, F>, x: &mut [F]) {
    match x {
        [x] => *x = function.value(*x, 0),
        _ => F::within(unit(), function, x),
    }
}

/// Σ weight f(x), a slice of one likewise.
#[inline(always)]
pub(super) fn sum<F: Float>(
    unit: impl FnOnce() -> Unit,
    function: Function<'_, F>,
    x: &[F],
    weights: &[F],
) -> Result<F, LengthError> {
    LengthError::check("weights", weights.len(), x.len())?;
    match (x, weights) {
        ([x], [weight]) => Ok(*weight * function.value(*x, 0)),
        _ => Ok(F::sum(unit(), function, x, weights)),
    }
}
