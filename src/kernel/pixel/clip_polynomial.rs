//! Polynomials for the volume of the Gaussian pixel beyond a line.

use crate::kernel::constants::CLIP_MINIMAX;
use crate::kernel::real::Real;

/// Stand-in for the volume of the Gaussian pixel (base diameter 1, σ = 1/6) beyond a line at distance d from
/// its centre, ½ erfc(d/(σ√2)).
///
/// | | form | error over [0, ½] | operations from d |
/// |---|---|---|---|
/// | the paper's P | 0.5 - d (2.151 - 2.358 d) | 4.93e-2 | 2 |
/// | `Quadratic` | as P | 1.32e-2 | 2 |
/// | `Centred` | as P, P(0) = ½ | 1.48e-2 | 2 |
/// | `Falling` | cubic, P(0) = ½, P(½) = 0 | 9.1e-3 | 3 |
///
/// The certified bounds, with their arguments, stand in [`CLIP_MINIMAX`]; operations are fused multiply-adds,
/// each two where nothing fuses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ClipPolynomial {
    /// The quadratic of least error. Below 0 for d from 0.373 to 0.46; P(0) = 0.487.
    Quadratic,
    /// The quadratic of least error with P(0) = ½. Below 0 for d from 0.366 to 0.459.
    Centred,
    /// The cubic of least error with P(0) = ½ among those that fall to 0 at the base: no volume is negative
    /// or grows with the distance, up to rounding.
    Falling,
}

impl ClipPolynomial {
    /// All three.
    pub const ALL: [ClipPolynomial; 3] =
        [ClipPolynomial::Quadratic, ClipPolynomial::Centred, ClipPolynomial::Falling];

    /// p₀ to p₃.
    pub const fn coefficients(self) -> [f64; 4] {
        CLIP_MINIMAX[self as usize]
    }

    /// The volume at d in [0, ½], in pixel diameters.
    ///
    /// Outside the polynomial goes on: take 1 - P(-d) for d < 0, and 0 beyond ½. NaN: NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::ClipPolynomial;
    /// let falling = ClipPolynomial::Falling;
    /// assert_eq!((falling.at(0.0), falling.at(0.5)), (0.5, 0.0));
    /// // d = σ: ½ erfc(√½) = 0.158655…
    /// assert!((falling.at(1.0_f64 / 6.0) - 0.158_655).abs() < 9.1e-3);
    /// ```
    #[inline]
    pub fn at<F: Real>(self, d: F) -> F {
        let [p0, p1, p2, p3] = self.coefficients().map(F::from_f64);
        p0 + d * (p1 + d * (p2 + d * p3))
    }
}
