//! The error of the clip volumes by distance and format.

use super::{DoubleDouble, Half};
use crate::bound::Format;
use crate::kernel::pixel::{CLIP_PRINTED, RADIUS, SIGMA, clip_volume, clip_volume_cut, clip_volume_paper};
use crate::kernel::real::Real;
use std::sync::LazyLock;

/// A clip volume of the paper's pixel, σ = 1/6 and r = ½.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clip {
    /// [`clip_volume`].
    Whole,
    /// [`clip_volume_cut`].
    Cut,
    /// [`clip_volume_paper`].
    Printed,
}

impl Clip {
    /// All three.
    pub const ALL: [Clip; 3] = [Clip::Whole, Clip::Cut, Clip::Printed];

    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            Clip::Whole => "clip-volume",
            Clip::Cut => "clip-volume-cut",
            Clip::Printed => "clip-volume-paper",
        }
    }

    fn at<F: Real>(self, d: F) -> F {
        match self {
            Clip::Whole => clip_volume(d, F::from_f64(SIGMA)),
            Clip::Cut => clip_volume_cut(d, F::from_f64(SIGMA), F::from_f64(RADIUS)),
            Clip::Printed => clip_volume_paper(d),
        }
    }

    /// The volume in exact arithmetic, to about 90 bits, for 0 < d < r = ½ and the σ given; d and σ doubles
    /// taken at their word.
    ///
    /// ½ - ½ erf(d/(σ √2)); where the pixel is cut by Owen's T, its integral by 32 nodes of Gauss and Legendre.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{SIGMA, clip_volume};
    /// use bellfit::stability::Clip;
    /// let exact = Clip::Whole.exact(0.25, SIGMA).to_f64();
    /// assert!((exact - clip_volume(0.25, SIGMA)).abs() < 1e-16);
    /// ```
    pub fn exact(self, d: f64, sigma: f64) -> DoubleDouble {
        match self {
            Clip::Whole => {
                let half = number(0.5);
                half - half * (number(d) / (number(sigma) * number(2.0).sqrt())).erf()
            }
            Clip::Cut => exact_cut(number(d), number(sigma), number(RADIUS)),
            Clip::Printed => {
                let [c0, c1, c2] = CLIP_PRINTED.map(number);
                c0 - number(d) * (c1 - c2 * number(d))
            }
        }
    }
}

/// The largest error of a clip volume over a stretch of distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipError {
    /// The volume.
    pub clip: Clip,
    /// The format of d, arithmetic and result.
    pub format: Format,
    /// Where the stretch begins, in pixels; it ends before the next row's, the last at ½.
    pub from: f64,
    /// The largest |computed - exact|.
    pub error: f64,
    /// The d where, as the format holds it.
    pub at: f64,
}

fn number(x: f64) -> DoubleDouble {
    DoubleDouble::from(x)
}

/// V = (2 T(h, a) - E α/π)/(1 - E), h = d/σ, a = tan α = √(r² - d²)/d, E = e^(-r²/(2σ²)).
fn exact_cut(d: DoubleDouble, sigma: DoubleDouble, radius: DoubleDouble) -> DoubleDouble {
    let (one, half) = (number(1.0), number(0.5));
    let chord = (radius * radius - d * d).sqrt();
    let (near, far) = (d / sigma, chord / sigma);
    let rim = (-(half * (radius / sigma) * (radius / sigma))).exp();
    // ∫₀^a e^(-y (1 + x²))/(1 + x²) dx for a ≤ 1: 2π T at y = h²/2, the angle at y = 0.
    let integral = |a: DoubleDouble, y: DoubleDouble| {
        let terms = GAUSS.iter().map(|(node, weight)| {
            let x = a * half * (one + *node);
            let square = one + x * x;
            *weight * (-(y * square)).exp() / square
        });
        half * a * terms.fold(number(0.0), |sum, term| sum + term)
    };
    let (pi, zero) = (DoubleDouble::pi(), number(0.0));
    let (owen, alpha) = if (d - chord).to_f64() >= 0.0 {
        let a = chord / d;
        (integral(a, half * near * near), integral(a, zero))
    } else {
        let (a, root) = (d / chord, half.sqrt());
        let corner = half * pi * (one - (near * root).erf() * (far * root).erf());
        (corner - integral(a, half * far * far), half * pi - integral(a, zero))
    };
    (owen - rim * alpha) / (pi * (one - rim))
}

const NODES: u32 = 32;

/// Nodes and weights on [-1, 1] by Newton's method on Legendre's polynomial.
static GAUSS: LazyLock<Vec<(DoubleDouble, DoubleDouble)>> = LazyLock::new(|| {
    let (one, whole) = (number(1.0), |x: u32| number(f64::from(x)));
    // P and P' of the order at x
    let legendre = |x: DoubleDouble| {
        let (mut before, mut last) = (one, x);
        for k in 2..=NODES {
            let next = (whole(2 * k - 1) * x * last - whole(k - 1) * before) / whole(k);
            (before, last) = (last, next);
        }
        (last, whole(NODES) * (before - x * last) / (one - x * x))
    };
    let node = |i: u32| {
        let guess = core::f64::consts::PI * (f64::from(i) + 0.75) / (f64::from(NODES) + 0.5);
        // Each step doubles the guess's two digits or more.
        let x = (0..6).fold(number(libm::cos(guess)), |x, _| {
            let (value, slope) = legendre(x);
            x - value / slope
        });
        let (_, slope) = legendre(x);
        (x, number(2.0) / ((one - x * x) * slope * slope))
    };
    (0..NODES).map(node).collect()
});

/// Distances in a stretch.
const A_STRETCH: u32 = 24;

/// The rows of each volume and format, d from 10⁻⁸ to ½ in stretches of 1, 2, 5 a decade.
///
/// d is rounded to the format first, σ to that of the arithmetic; the exact volume is that of the rounded
/// numbers. Sampled: 24 distances a stretch.
///
/// ```
/// use bellfit::{bound::Format, stability::{Clip, clip_errors}};
/// for row in clip_errors().iter().filter(|row| row.clip == Clip::Whole) {
///     // the result's own rounding more where the arithmetic has more bits
///     let u = if row.format == Format::HalfStored { 1.0 / 2048.0 } else { row.format.unit_roundoff() };
///     assert!(row.error <= 2.0 * u, "{row:?}");
/// }
/// ```
pub fn clip_errors() -> Vec<ClipError> {
    // The division is exact enough: a stretch may begin anywhere.
    let starts: Vec<f64> =
        super::exponents().into_iter().map(|x| x / 1e8).take_while(|d| *d < RADIUS).chain([RADIUS]).collect();
    let mut rows = Vec::new();
    for clip in Clip::ALL {
        for format in Format::ALL {
            for pair in starts.windows(2) {
                let inner =
                    |j: u32| pair[0] * libm::pow(pair[1] / pair[0], f64::from(j) / f64::from(A_STRETCH));
                let distances: Vec<f64> = (0..A_STRETCH).map(inner).collect();
                let (error, at) = match format {
                    Format::Half => largest::<Half, Half>(clip, &distances),
                    Format::HalfStored => largest::<Half, f32>(clip, &distances),
                    Format::Single => largest::<f32, f32>(clip, &distances),
                    Format::Double => largest::<f64, f64>(clip, &distances),
                };
                rows.push(ClipError { clip, format, from: pair[0], error, at });
            }
        }
    }
    rows
}

fn largest<S: Real, A: Real>(clip: Clip, distances: &[f64]) -> (f64, f64) {
    let sigma = A::from_f64(SIGMA).to_f64();
    distances.iter().fold((0.0, 0.0), |largest, &d| {
        let d = S::from_f64(d).to_f64();
        let value = S::from_f64(clip.at(A::from_f64(d)).to_f64()).to_f64();
        // A d rounded to 0 has its volume too.
        let exact = if d == 0.0 { number(0.5) } else { clip.exact(d, sigma) };
        let error = (number(value) - exact).abs().to_f64();
        // A NaN is worse than any error.
        if error > largest.0 || error.is_nan() && !largest.0.is_nan() { (error, d) } else { largest }
    })
}
