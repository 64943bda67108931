//! Weights of texels under a pixel.

use crate::kernel::bell::bell;
use crate::kernel::cubic::cubic_bell;
use crate::kernel::real::Real;

/// Readings of (9), the paper's weight, which is lost in print: (1 - c Q)^8 with c = 1, 9/16, 1/2 and 1/8.
///
/// All are (8), (1 - n x²/(2K))^K with K = 8: the first, third and fourth with n = 8 and three meanings of x,
/// the second with n = 1/σ² and σ = L/6.
///
/// ```
/// use bellfit::kernel::pixel::PaperReading;
/// let zeros = PaperReading::ALL.map(|reading| 1.0 / reading.scale::<f64>()); // Q of the first zero
/// assert_eq!(zeros, [1.0, 16.0 / 9.0, 2.0, 8.0]);
/// ```
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

    /// c, exact in both types.
    ///
    /// ```
    /// use bellfit::kernel::pixel::PaperReading;
    /// assert_eq!(PaperReading::R2.scale::<f32>(), 9.0 / 16.0);
    /// ```
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
/// σ is a standard deviation as a fraction of the semi-axis: the paper's L/6 is σ = 1/3. Domain: σ > 0 whose
/// square is a normal number; σ = 0: 0, NaN in the middle.
///
/// | weight | source | zero from | on the ellipse, Q = 1 |
/// |---|---|---|---|
/// | `Gaussian(σ)` | pixel paper, (3), (4) without their factor | never | e^(-1/(2σ²)), 1.1e-2 for σ = 1/3 |
/// | `Paper(R)` | (8), (9) in reading R | Q = 1, 16/9, 2, 8 | 0, (7/16)^8 = 1.3e-3, 2⁻⁸, (7/8)^8 |
/// | `PaperProduct(R)` | the same as f(u₁) f(v₁) | either square that large | from that up to (1 - c/2)^16 |
/// | `Box` | equal weights | never | 1 |
/// | `Bell(K, σ)` | [`bell`] | Q = 2 K σ² | [`bell`] of 1/(2σ²) |
/// | `Cubic(K, σ)` | [`cubic_bell`] | its cut in t | [`cubic_bell`] of 1/(2σ²) |
///
/// None grows with either square, except `Cubic` by 4 ε between neighbouring floats. Accuracy: for the exponential 1 ulp and
/// what u rounds t by, t u; for the others that of [`bell`] and [`cubic_bell`].
///
/// ```
/// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
/// let q = 0.5_f64;
/// let weight = PixelWeight::Paper(PaperReading::R2).at(q, 0.0);
/// assert_eq!(weight, libm::pow(1.0 - 9.0 / 16.0 * q, 8.0));
/// // the bell of the Gaussian with the same σ
/// let (bell, gaussian) = (PixelWeight::Bell(8, 1.0 / 3.0), PixelWeight::Gaussian(1.0 / 3.0));
/// assert!((weight - bell.at(q, 0.0)).abs() < 1e-16);
/// assert!((weight - gaussian.at(q, 0.0)).abs() < 0.036); // sup |(1 - t/8)^8 - e⁻ᵗ| is 3.53e-2
/// ```
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
    /// The weight at squared coordinates a², b² in units of the semi-axes (Q = a² + b²), inside the ellipse or
    /// beyond; a weight that [is radial](Self::is_radial) takes (Q, 0) as well.
    ///
    /// Values in [0, 1]. +∞: 0, but 1 for the box. NaN: NaN. A power K that is not listed: NaN. Negative
    /// squares: the formula as it is, above 1 but for the box.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
    /// let product = PixelWeight::PaperProduct(PaperReading::R3);
    /// assert_eq!(product.at(0.5_f64, 0.25), libm::pow(0.75 * 0.875, 8.0));
    /// assert_eq!(PixelWeight::Gaussian(0.5_f64).at(0.25, 0.5), libm::exp(-1.5));
    /// assert!(PixelWeight::Bell(3, 0.5_f64).at(0.0, 0.0).is_nan()); // 3 is not a power of two
    /// ```
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
            PixelWeight::Box if q.is_nan() => q,
            PixelWeight::Box => F::ONE,
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
    ///
    /// ```
    /// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
    /// assert!(PixelWeight::<f32>::Paper(PaperReading::R1).is_radial());
    /// assert!(!PixelWeight::<f32>::PaperProduct(PaperReading::R1).is_radial());
    /// ```
    #[inline]
    pub const fn is_radial(self) -> bool {
        !matches!(self, PixelWeight::PaperProduct(_))
    }
}
