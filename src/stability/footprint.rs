//! The error of the footprint's Q by the ellipse's aspect and size.

use super::DoubleDouble;
use crate::bound::Format;
use crate::kernel::pixel::{Conic, Footprint, Inverse, Jacobian, Padding};
use crate::kernel::real::Real;

/// A form of Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QForm {
    /// [`Footprint::q`].
    Footprint(Padding),
    /// [`Inverse::q`].
    Inverse(Padding),
    /// [`Conic::q`], which has no padding.
    Conic,
}

impl QForm {
    /// All five.
    pub const ALL: [QForm; 5] = [
        QForm::Footprint(Padding::Plain),
        QForm::Footprint(Padding::Padded),
        QForm::Inverse(Padding::Plain),
        QForm::Inverse(Padding::Padded),
        QForm::Conic,
    ];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            QForm::Footprint(Padding::Plain) => "footprint",
            QForm::Footprint(Padding::Padded) => "footprint-padded",
            QForm::Inverse(Padding::Plain) => "inverse",
            QForm::Inverse(Padding::Padded) => "inverse-padded",
            QForm::Conic => "conic",
        }
    }

    /// Whether the error is measured relative to Q, as [`Inverse`]'s page states its accuracy.
    pub const fn is_relative(self) -> bool {
        matches!(self, QForm::Inverse(_))
    }

    const fn padding(self) -> Padding {
        match self {
            QForm::Footprint(padding) | QForm::Inverse(padding) => padding,
            QForm::Conic => Padding::Plain,
        }
    }

    fn at<F: Real>(self, j: Jacobian<F>, u: F, v: F) -> F {
        match self {
            QForm::Footprint(padding) => Footprint::of(j, padding).q(u, v),
            QForm::Inverse(padding) => Inverse::of(j, padding).q(u, v),
            QForm::Conic => Conic::of(j).q(u, v),
        }
    }
}

/// The largest error of Q met over tilts and points with Q ≤ 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FootprintError {
    /// The form.
    pub form: QForm,
    /// [`Format::Single`] or [`Format::Double`].
    pub format: Format,
    /// Major by minor semi-axis before the Jacobian is rounded to the format.
    pub aspect: f64,
    /// The major semi-axis, in texels, when plain.
    pub scale: f64,
    /// Absolute, or relative to Q where [`QForm::is_relative`]; +∞ or NaN where the form gave that.
    pub error: f64,
    /// The Jacobian where.
    pub jacobian: Jacobian<f64>,
    /// The point (u, v) where.
    pub point: (f64, f64),
}

/// Q in exact arithmetic, to about 100 bits less those of the aspect.
///
/// Plain |adj(J) x|²/det², padded (|adj(J) x|² + |x|²)/(det² + |J|² + 1); components of J within 10^±70.
///
/// ```
/// use bellfit::kernel::pixel::{Jacobian, Padding};
/// let j = Jacobian { ux: 3.0, vx: 1.0, uy: 0.0, vy: 2.0 };
/// assert_eq!(bellfit::stability::exact_q(j, Padding::Plain, (3.0, 1.0)).to_f64(), 1.0);
/// ```
pub fn exact_q(j: Jacobian<f64>, padding: Padding, (u, v): (f64, f64)) -> DoubleDouble {
    let [ux, vx, uy, vy, u, v] = [j.ux, j.vx, j.uy, j.vy, u, v].map(DoubleDouble::from);
    let (first, second) = (vy * u - uy * v, ux * v - vx * u);
    let det = ux * vy - uy * vx;
    let (top, below) = (first * first + second * second, det * det);
    match padding {
        Padding::Plain => top / below,
        Padding::Padded => {
            let square = ux * ux + vx * vx + uy * uy + vy * vy;
            (top + u * u + v * v) / (below + square + DoubleDouble::from(1.0))
        }
    }
}

/// Aspects: 1, 2, 5 a decade to 10⁶.
fn aspects() -> Vec<f64> {
    super::exponents().into_iter().take_while(|aspect| *aspect <= 1e6).collect()
}

/// Every fifth power of ten from 10⁻²⁰ to 10²⁰, each the nearest double.
const SCALES: [f64; 9] = [1e-20, 1e-15, 1e-10, 1e-5, 1.0, 1e5, 1e10, 1e15, 1e20];

/// Angles of the major axis and of its image on the screen, radians: along an axis, and of no special direction.
const TILTS: [f64; 5] = [0.0, 0.3, 0.8, 1.4, 2.5];
const TURNS: [f64; 3] = [0.0, 0.7, 2.0];
/// Points: share of the semi-axes, angle around, and how much of them lies in the padding.
const RADII: [f64; 3] = [0.2, 0.6, 0.98];
const AROUND: u32 = 8;
const PADDED: [f64; 3] = [0.1, 0.7, 1.5];

/// The rows of every form in binary32 and binary64, aspects to 10⁶ and major semi-axes of 10⁻²⁰ to 10²⁰ texels.
///
/// J = scale R(tilt) diag(1, 1/aspect) R(turn)ᵀ, rounded to the format, and points of the ellipse, rounded too:
/// Q is that of the rounded numbers. Sampled: 15 ellipses and 24 or 72 points each.
///
/// ```
/// use bellfit::{bound::Format, stability::{QForm, footprint_errors}};
/// // Inverse keeps its 12 u and 26 u whatever the ellipse.
/// for row in footprint_errors().iter().filter(|row| row.form.is_relative()) {
///     assert!(row.error <= 26.0 * row.format.unit_roundoff(), "{row:?}");
/// }
/// ```
pub fn footprint_errors() -> Vec<FootprintError> {
    let mut rows = Vec::new();
    for form in QForm::ALL {
        for format in [Format::Single, Format::Double] {
            for aspect in aspects() {
                for scale in SCALES {
                    rows.push(match format {
                        Format::Double => largest::<f64>(form, format, aspect, scale),
                        _ => largest::<f32>(form, format, aspect, scale),
                    });
                }
            }
        }
    }
    rows
}

fn largest<F: Real>(form: QForm, format: Format, aspect: f64, scale: f64) -> FootprintError {
    let held = |x: f64| F::from_f64(x).to_f64();
    let nothing = Jacobian { ux: 0.0, vx: 0.0, uy: 0.0, vy: 0.0 };
    let mut row =
        FootprintError { form, format, aspect, scale, error: 0.0, jacobian: nothing, point: (0.0, 0.0) };
    for tilt in TILTS {
        for turn in TURNS {
            let ((c, s), (p, q)) = ((libm::cos(tilt), libm::sin(tilt)), (libm::cos(turn), libm::sin(turn)));
            let (major, minor) = (scale, scale / aspect);
            let j = Jacobian {
                ux: held(major * c * p + minor * s * q),
                vx: held(major * s * p - minor * c * q),
                uy: held(major * c * q - minor * s * p),
                vy: held(major * s * q + minor * c * p),
            };
            let narrow = Jacobian {
                ux: F::from_f64(j.ux),
                vx: F::from_f64(j.vx),
                uy: F::from_f64(j.uy),
                vy: F::from_f64(j.vy),
            };
            for (u, v) in points(j, form.padding()) {
                let point = (held(u), held(v));
                let exact = exact_q(j, form.padding(), point);
                // Where the rounding of x has moved it out, nothing is promised.
                if exact.to_f64() > 1.0 {
                    continue;
                }
                let value = form.at(narrow, F::from_f64(u), F::from_f64(v)).to_f64();
                let difference = (DoubleDouble::from(value) - exact).abs();
                let error = match (value.is_finite(), form.is_relative()) {
                    // ∞ less a number is no double-double.
                    (false, _) => (value - exact.to_f64()).abs(),
                    (true, true) => (difference / exact).to_f64(),
                    (true, false) => difference.to_f64(),
                };
                if error > row.error || error.is_nan() && !row.error.is_nan() {
                    row = FootprintError { error, jacobian: j, point, ..row };
                }
            }
        }
    }
    row
}

/// Points of the ellipse: J a + b for |a|² + |b|² ≤ 1 when padded, J a when plain.
fn points(j: Jacobian<f64>, padding: Padding) -> Vec<(f64, f64)> {
    let parts: &[f64] = if padding == Padding::Plain { &[0.0] } else { &PADDED };
    let mut all = Vec::new();
    for radius in RADII {
        for part in parts {
            for step in 0..AROUND {
                let angle = 0.1 + f64::from(step) * core::f64::consts::TAU / f64::from(AROUND);
                let (of_j, of_unit) = (radius * libm::cos(*part), radius * libm::sin(*part));
                let (c, s) = (libm::cos(angle), libm::sin(angle));
                all.push((
                    of_j * (j.ux * c + j.uy * s) + of_unit * c,
                    of_j * (j.vx * c + j.vy * s) - of_unit * s,
                ));
            }
        }
    }
    all
}
