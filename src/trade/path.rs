//! The code that is timed, and whose errors are taken.

use super::element::Element;
use super::subject::Subject;
use super::table::Table;
use crate::kernel::cubic::CubicLobe;
use crate::kernel::linear::LinearLobe;
use crate::kernel::power::cos_n_whole;
use crate::kernel::stand_in::StandIn;
use std::hint::black_box;

/// A subject with everything made that does not depend on the angle.
pub(super) enum Path<F> {
    StandIn(StandIn),
    Powf,
    Powi,
    Table(Table<F>),
    /// The argument itself: what the loop and the memory take by themselves.
    Copy,
}

impl<F: Element> Path<F> {
    pub(super) fn new(subject: Subject, n: u32) -> Path<F> {
        match subject {
            Subject::StandIn(stand_in) => Path::StandIn(stand_in),
            Subject::Powf => Path::Powf,
            Subject::Powi => Path::Powi,
            Subject::Table(sampling) => Path::Table(Table::new(sampling, n)),
        }
    }

    /// One value at a time, from cosines in [0, 1].
    pub(super) fn single(&self, n: u32, x: &[F], out: &mut [F]) {
        match self {
            Path::StandIn(stand_in) => one_by_one(*stand_in, n, x, out),
            Path::Powf => {
                let n = F::from_u32(n);
                each(x, out, |cos| cos.std_powf(n));
            }
            Path::Powi => each(x, out, |cos| cos.std_powi(n as i32)),
            Path::Table(table) => table.single(x, out),
            Path::Copy => each(x, out, |cos| cos),
        }
    }

    /// Over the slice, from cosines in [0, 1].
    pub(super) fn slice(&self, n: u32, x: &[F], out: &mut [F]) {
        let exponent = F::from_u32(n);
        match self {
            Path::StandIn(stand_in) => F::slice(*stand_in, n, x, out),
            Path::Powf => x.iter().zip(out).for_each(|(cos, out)| *out = cos.std_powf(exponent)),
            Path::Powi => x.iter().zip(out).for_each(|(cos, out)| *out = cos.std_powi(n as i32)),
            Path::Table(table) => table.slice(x, out),
            Path::Copy => out.copy_from_slice(x),
        }
    }
}

/// Neither the argument nor the fate of the result is known to the compiler, so that each call stands for
/// itself; both go through memory for it, at the price of [`Path::Copy`].
#[inline(always)]
fn each<F: Copy>(x: &[F], out: &mut [F], value: impl Fn(F) -> F) {
    for (x, out) in x.iter().zip(out) {
        *out = black_box(value(black_box(*x)));
    }
}

/// A loop for each stand-in, as its caller would write it.
fn one_by_one<F: Element>(stand_in: StandIn, n: u32, x: &[F], out: &mut [F]) {
    let exponent = F::from_u32(n);
    macro_rules! lobe {
        ($lobe:expr) => {{
            let lobe = $lobe;
            each(x, out, |cos| lobe.at(cos))
        }};
    }
    match stand_in {
        StandIn::Cs16 => lobe!(LinearLobe::<16, F>::lyon(exponent)),
        StandIn::Linear2 => lobe!(LinearLobe::<2, F>::new(exponent)),
        StandIn::Linear4 => lobe!(LinearLobe::<4, F>::new(exponent)),
        StandIn::Linear8 => lobe!(LinearLobe::<8, F>::new(exponent)),
        StandIn::Linear16 => lobe!(LinearLobe::<16, F>::new(exponent)),
        StandIn::Linear32 => lobe!(LinearLobe::<32, F>::new(exponent)),
        StandIn::Cubic2 => lobe!(CubicLobe::<2, F>::new(exponent)),
        StandIn::Cubic4 => lobe!(CubicLobe::<4, F>::new(exponent)),
        StandIn::Cubic8 => lobe!(CubicLobe::<8, F>::new(exponent)),
        StandIn::Schlick => each(x, out, |cos| StandIn::Schlick.at(cos, exponent)),
        StandIn::SchlickPrinted => each(x, out, |cos| StandIn::SchlickPrinted.at(cos, exponent)),
        StandIn::SphericalGaussian => each(x, out, |cos| StandIn::SphericalGaussian.at(cos, exponent)),
        StandIn::Squarings => each(x, out, |cos| cos_n_whole(cos, n)),
        StandIn::Exp2Log2 => each(x, out, |cos| StandIn::Exp2Log2.at(cos, exponent)),
        StandIn::Power => each(x, out, |cos| StandIn::Power.at(cos, exponent)),
    }
}
