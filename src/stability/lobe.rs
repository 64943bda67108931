//! The error of the lobes by exponent, format and the way their angle is handed over.

use super::{Angle, DoubleDouble, Half};
use crate::bound::{Format, Handed};
use crate::kernel::prepared::Prepared;
use crate::kernel::real::Real;
use crate::kernel::stand_in::StandIn;
use crate::kernel::vector::versine_between;
use std::f64::consts::FRAC_PI_2;

/// The largest size met of an error, and the angle where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The size: +∞ or NaN where the kernel gave that.
    pub value: f64,
    /// θ in radians; of several with the same error the first.
    pub theta: f64,
}

impl Peak {
    const NONE: Peak = Peak { value: 0.0, theta: 0.0 };

    /// Takes a larger one in; a NaN is larger than all.
    fn raise(&mut self, value: f64, theta: f64) {
        if value > self.value || value.is_nan() && !self.value.is_nan() {
            *self = Peak { value, theta };
        }
    }
}

/// What was met over the angles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeErrors {
    /// |computed - cosⁿθ|.
    pub total: Peak,
    /// |computed - the same kernel in exact arithmetic at θ|: the argument's rounding, the constants' and the
    /// arithmetic's.
    pub rounding: Peak,
    /// |the kernel in exact arithmetic - cosⁿθ|.
    pub approximation: Peak,
}

/// One kernel in one format at one exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LobeRow {
    /// The kernel.
    pub stand_in: StandIn,
    /// The format of argument, arithmetic and result.
    pub format: Format,
    /// What is handed over.
    pub handed: Handed,
    /// The specular exponent.
    pub n: f64,
    /// `None` where the kernel does not exist: a constant of n is beyond the format, or n is no whole number
    /// below 2³² for [`StandIn::Squarings`].
    pub errors: Option<LobeErrors>,
}

/// Formulas of the fitted bells hold from here on.
const FITTED_FROM: f64 = 16.0;
/// Angles a decade from 10⁻⁸ to π/2.
const A_DECADE: i32 = 12;
/// Angles in the lobe's own width, θ √n up to their number times the step.
const OWN: u32 = 320;
const OWN_STEP: f64 = 1.0 / 32.0;

/// 1, 2 and 5 times the powers of ten from 1 to 10¹².
///
/// ```
/// let grid = bellfit::stability::exponents();
/// assert_eq!((grid.len(), grid[0], grid[4], grid[36]), (37, 1.0, 20.0, 1e12));
/// ```
pub fn exponents() -> Vec<f64> {
    let mut decade = 1.0;
    let mut grid = Vec::new();
    for _ in 0..12 {
        grid.extend([decade, 2.0 * decade, 5.0 * decade]);
        decade *= 10.0;
    }
    grid.push(decade);
    grid
}

/// The n from which a kernel's formula is meant: 16 for the fitted bells, else 0.
pub(crate) fn meant_from(stand_in: StandIn) -> f64 {
    if stand_in.bell().is_some() && stand_in != StandIn::Cs16 { FITTED_FROM } else { 0.0 }
}

/// Angles in (0, π/2] for an exponent: 12 a decade from 10⁻⁸, π/2, and 320 at equal distance to ten widths 1/√n
/// of the lobe.
pub fn angles(n: f64) -> Vec<f64> {
    let wide = (0..=8 * A_DECADE + 2).map(|k| libm::exp10(f64::from(k) / f64::from(A_DECADE) - 8.0));
    let own = (1..=OWN).map(|k| f64::from(k) * OWN_STEP / libm::sqrt(n));
    let mut all: Vec<f64> = wide.chain(own).filter(|theta| (1e-8..FRAC_PI_2).contains(theta)).collect();
    all.push(FRAC_PI_2);
    all.sort_by(f64::total_cmp);
    all
}

/// A direction with one across it: the rows of rotations by the quaternions (1, 0, 0, 0), (3, 1, -2, 4) and
/// (2, 5, 1, -3), exact fractions.
fn frames() -> [[[DoubleDouble; 3]; 2]; 3] {
    [[1, 0, 0, 0], [3, 1, -2, 4], [2, 5, 1, -3]].map(|[a, b, c, d]: [i32; 4]| {
        let square = a * a + b * b + c * c + d * d;
        let first = [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)];
        let second = [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)];
        [first, second].map(|row| row.map(|entry| DoubleDouble::ratio(entry, square)))
    })
}

/// What is handed over at an angle: numbers stored as `S`, made ready in `A`. The difference vector stands for
/// three pairs of directions, one of them with a along an axis.
fn handed_over<S: Real, A: Real>(handed: Handed, angle: &Angle) -> Vec<A> {
    let store = |x: DoubleDouble| A::from_f64(x.round::<S>().to_f64());
    match handed {
        Handed::Cosine => vec![store(angle.cosine())],
        Handed::Versine => vec![store(angle.versine())],
        Handed::Difference => {
            let between = |[first, second]: [[DoubleDouble; 3]; 2]| {
                let turned: [usize; 3] = [0, 1, 2];
                let b = turned.map(|i| angle.cosine() * first[i] + angle.sine() * second[i]);
                versine_between(first.map(store), b.map(store))
            };
            frames().map(between).to_vec()
        }
    }
}

/// What a format hands over at each angle.
fn arguments(format: Format, handed: Handed, angles: &[Angle]) -> Vec<Vec<f64>> {
    fn all<S: Real, A: Real>(handed: Handed, angles: &[Angle]) -> Vec<Vec<f64>> {
        let one = |angle| handed_over::<S, A>(handed, angle).into_iter().map(A::to_f64).collect();
        angles.iter().map(one).collect()
    }
    match format {
        Format::Half => all::<Half, Half>(handed, angles),
        Format::HalfStored => all::<Half, f32>(handed, angles),
        Format::Single => all::<f32, f32>(handed, angles),
        Format::Double => all::<f64, f64>(handed, angles),
    }
}

/// A kernel's values at what was handed over; `None` where the kernel does not exist.
fn values(
    (stand_in, n): (StandIn, f64),
    format: Format,
    handed: Handed,
    arguments: &[Vec<f64>],
) -> Option<Vec<Vec<f64>>> {
    fn all<S: Real, A: Real>(
        (stand_in, n): (StandIn, f64),
        handed: Handed,
        arguments: &[Vec<f64>],
    ) -> Option<Vec<Vec<f64>>> {
        let (argument, lobe) = (handed.argument(), Prepared::<A>::new(stand_in, n));
        if !lobe.is_finite(argument) {
            return None;
        }
        let one = |x: &f64| S::from_f64(lobe.of(argument, A::from_f64(*x)).to_f64()).to_f64();
        Some(arguments.iter().map(|pairs| pairs.iter().map(one).collect()).collect())
    }
    match format {
        Format::Half => all::<Half, Half>((stand_in, n), handed, arguments),
        Format::HalfStored => all::<Half, f32>((stand_in, n), handed, arguments),
        Format::Single => all::<f32, f32>((stand_in, n), handed, arguments),
        Format::Double => all::<f64, f64>((stand_in, n), handed, arguments),
    }
}

/// The rows of all kernels in every format and way of handing the angle over at one exponent, the errors'
/// largest over given angles in (0, π/2].
///
/// The constants of n are computed in `f64` and rounded to the format, in [`Format::HalfStored`] to `f32`, as a
/// material's are. Sampled: between the angles more may happen.
///
/// ```
/// use bellfit::{bound::{Format, Handed}, kernel::stand_in::StandIn, stability::lobe_rows};
/// let rows = lobe_rows(1000.0, &[0.01, 0.02, 0.05]);
/// let of = |handed| {
///     let row = rows.iter().find(|r| (r.stand_in, r.format, r.handed) == (StandIn::Cubic4, Format::Single, handed));
///     row.and_then(|r| r.errors).map_or(f64::NAN, |e| e.rounding.value)
/// };
/// assert!(of(Handed::Versine) < 3e-7 && of(Handed::Cosine) > 3e-6);
/// ```
pub fn lobe_rows(n: f64, thetas: &[f64]) -> Vec<LobeRow> {
    let angles: Vec<Angle> = thetas.iter().map(|theta| Angle::of(*theta)).collect();
    let truth: Vec<DoubleDouble> = angles.iter().map(|angle| angle.cos_n(n)).collect();
    let ways = Format::ALL.into_iter().flat_map(|format| Handed::ALL.map(|handed| (format, handed)));
    let ways: Vec<_> =
        ways.map(|(format, handed)| (format, handed, arguments(format, handed, &angles))).collect();
    let mut rows = Vec::new();
    for stand_in in StandIn::ALL {
        let exact: Vec<DoubleDouble> = if stand_in.is_exact() {
            truth.clone()
        } else {
            angles.iter().map(|angle| angle.stand_in(stand_in, n)).collect()
        };
        let mut approximation = Peak::NONE;
        for ((angle, exact), truth) in angles.iter().zip(&exact).zip(&truth) {
            approximation.raise((*exact - *truth).abs().to_f64(), angle.theta());
        }
        for (format, handed, arguments) in &ways {
            let values = values((stand_in, n), *format, *handed, arguments);
            let errors = values.map(|values| {
                let (mut total, mut rounding) = (Peak::NONE, Peak::NONE);
                for (i, pairs) in values.iter().enumerate() {
                    for value in pairs {
                        let theta = angles[i].theta();
                        total.raise((DoubleDouble::from(*value) - truth[i]).abs().to_f64(), theta);
                        rounding.raise((DoubleDouble::from(*value) - exact[i]).abs().to_f64(), theta);
                    }
                }
                LobeErrors { total, rounding, approximation }
            });
            rows.push(LobeRow { stand_in, format: *format, handed: *handed, n, errors });
        }
    }
    rows
}
