//! Weights of texels under a pixel.

use crate::kernel::bell::bell;
use crate::kernel::cubic::cubic_bell;
use crate::kernel::real::Real;

/// Readings of (9), the paper's weight, which is lost in print: (1 - c Q)^8 with c = 1, 9/16, 1/2 and 1/8.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PaperReading {
    /// x = 2√2 u₁/L: (1 - Q)^8, zero on the ellipse.
    R1,
    /// n = 1/σ²: (1 - 9Q/16)^8, the bell of the Gaussian with σ = L/6.
    R2,
    /// x = 2 u₁/L: (1 - Q/2)^8.
    R3,
    /// x = u₁/L: (1 - Q/8)^8.
    R4,
}

impl PaperReading {
    /// All four.
    pub const ALL: [PaperReading; 4] =
        [PaperReading::R1, PaperReading::R2, PaperReading::R3, PaperReading::R4];

    /// c.
    #[inline]
    pub fn scale<F: Real>(self) -> F {
        match self {
            PaperReading::R1 => F::ONE,
            PaperReading::R2 => F::from_f64(0.5625),
            PaperReading::R3 => F::HALF,
            PaperReading::R4 => F::from_f64(0.125),
        }
    }
}

/// Weight of a texel from its place along the two axes; 1 in the middle, not normalised.
///
/// σ is a standard deviation as a fraction of the semi-axis: the paper's L/6 is σ = 1/3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PixelWeight<F> {
    /// exp(-Q/(2σ²)).
    Gaussian(F),
    /// (1 - c Q)^8, clamped at 0.
    Paper(PaperReading),
    /// (1 - c a²)^8 (1 - c b²)^8, each clamped at 0, with a and b the coordinates along the axes.
    PaperProduct(PaperReading),
    /// 1.
    Box,
    /// Lyon's bell (1 - t/K)^K of t = Q/(2σ²), K = 2, 4, 8, 16, 32 or 64.
    Bell(u32, F),
    /// The bell of degree three of t = Q/(2σ²), K = 2, 4 or 8.
    Cubic(u32, F),
}

/// (1 - c q)^8, 0 from q = 1/c on.
#[inline]
fn eighth<F: Real>(c: F, q: F) -> F {
    let p = (F::ONE - c * q).max(F::ZERO);
    let p2 = p * p;
    let p4 = p2 * p2;
    p4 * p4
}

impl<F: Real> PixelWeight<F> {
    /// The weight at squared coordinates a², b² in units of the semi-axes (Q = a² + b²), Q ≤ 1 or beyond.
    ///
    /// NaN: NaN. A power K that is not listed: NaN.
    #[inline]
    pub fn at(self, aa: F, bb: F) -> F {
        let q = aa + bb;
        let t = |sigma: F| q / (F::TWO * sigma * sigma);
        match self {
            PixelWeight::Gaussian(sigma) => (-t(sigma)).exp(),
            PixelWeight::Paper(reading) => eighth(reading.scale(), q),
            PixelWeight::PaperProduct(reading) => {
                let c = reading.scale();
                eighth(c, aa) * eighth(c, bb)
            }
            PixelWeight::Box => q * F::ZERO + F::ONE,
            PixelWeight::Bell(k, sigma) => match k {
                2 => bell::<2, F>(t(sigma)),
                4 => bell::<4, F>(t(sigma)),
                8 => bell::<8, F>(t(sigma)),
                16 => bell::<16, F>(t(sigma)),
                32 => bell::<32, F>(t(sigma)),
                64 => bell::<64, F>(t(sigma)),
                _ => F::NAN,
            },
            PixelWeight::Cubic(k, sigma) => match k {
                2 => cubic_bell::<2, F>(t(sigma)),
                4 => cubic_bell::<4, F>(t(sigma)),
                8 => cubic_bell::<8, F>(t(sigma)),
                _ => F::NAN,
            },
        }
    }

    /// Whether it depends on Q = a² + b² alone.
    #[inline]
    pub const fn is_radial(self) -> bool {
        !matches!(self, PixelWeight::PaperProduct(_))
    }
}
