//! The derivatives of texture coordinates along the screen.

use crate::kernel::real::Real;

/// Derivatives of (u, v) along the screen's x and y, in texels per pixel.
///
/// (ux, vx) = ∂(u, v)/∂x, (uy, vy) = ∂(u, v)/∂y; pixel paper, (1). As a matrix J = [[ux, uy], [vx, vy]].
///
/// Any finite numbers are a Jacobian. Parallel or zero columns (det J = 0) make its ellipse a line or a
/// point; a mirrored mapping (det J < 0) has the ellipse of the one that is not. A component that is not
/// finite makes every Q and every true axis NaN; the paper's own expressions, [`Conic`](super::Conic) and
/// [`Jacobian::lengths`], give what IEEE 754 makes of them.
///
/// ```
/// use bellfit::kernel::pixel::Jacobian;
/// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
/// assert_eq!(j.determinant(), 6.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jacobian<F> {
    /// ∂u/∂x.
    pub ux: F,
    /// ∂v/∂x.
    pub vx: F,
    /// ∂u/∂y.
    pub uy: F,
    /// ∂v/∂y.
    pub vy: F,
}

impl<F: Real> Jacobian<F> {
    /// det J = ux vy - uy vx, in texels² per pixel²: the signed area of a pixel in the texture. Its square is
    /// the paper's F.
    ///
    /// 0 where the columns are exactly parallel or zero, negative where the mapping is mirrored. Accuracy
    /// that of [`Real::cross`], near-parallel columns included; `f64` overflows to ±∞ or NaN for components
    /// beyond 1e154.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Jacobian;
    /// let j = Jacobian { ux: 1.0_f32, vx: 1.0, uy: 1.0, vy: 1.0 + f32::EPSILON };
    /// assert_eq!(j.determinant(), f32::EPSILON);
    /// ```
    #[inline]
    pub fn determinant(self) -> F {
        F::cross(self.ux, self.uy, self.vx, self.vy)
    }

    /// s J: the derivatives along s pixels. s = ½ makes Q = 1 the image of the circle of diameter 1.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Jacobian;
    /// let j = Jacobian { ux: 3.0_f64, vx: -1.0, uy: 0.0, vy: 2.0 };
    /// assert_eq!(j.scaled(0.5), Jacobian { ux: 1.5, vx: -0.5, uy: 0.0, vy: 1.0 });
    /// ```
    #[inline]
    pub fn scaled(self, s: F) -> Self {
        Jacobian { ux: self.ux * s, vx: self.vx * s, uy: self.uy * s, vy: self.vy * s }
    }

    /// Lengths √(ux² + vx²) and √(uy² + vy²) in texels, of two conjugate semi-diameters of the ellipse;
    /// neither below its minor semi-axis nor above the major one.
    ///
    /// Within 1 ulp; +∞ where a length is beyond the type, or a component infinite.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Jacobian;
    /// assert_eq!(Jacobian { ux: 3.0_f64, vx: 4.0, uy: -5.0, vy: 12.0 }.lengths(), (5.0, 13.0));
    /// ```
    #[inline]
    pub fn lengths(self) -> (F, F) {
        (self.ux.hypot(self.vx), self.uy.hypot(self.vy))
    }

    /// Whether all four are finite.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Jacobian;
    /// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
    /// assert!(j.is_finite() && !Jacobian { vx: f64::NAN, ..j }.is_finite());
    /// ```
    #[inline]
    pub fn is_finite(self) -> bool {
        self.ux.is_finite() && self.vx.is_finite() && self.uy.is_finite() && self.vy.is_finite()
    }

    /// The largest absolute component; 0 for the zero Jacobian, NaN if one is NaN.
    #[inline]
    pub(super) fn largest(self) -> F {
        self.ux.abs().max(self.vx.abs()).max(self.uy.abs()).max(self.vy.abs())
    }

    /// J 2ᵉ, exact within the type's range.
    #[inline]
    pub(super) fn shifted(self, e: i32) -> Self {
        Jacobian {
            ux: self.ux.scaled(e),
            vx: self.vx.scaled(e),
            uy: self.uy.scaled(e),
            vy: self.vy.scaled(e),
        }
    }

    /// (m, e) with det J = m 2ᵉ, m of the size of 1 but for cancellation: as accurate as
    /// [`Jacobian::determinant`] for every finite J, however far the products are out of the type's range.
    #[inline]
    pub(super) fn determinant_and_exponent(self) -> (F, i32) {
        // 0 has no exponent: far below any other product, but not so far that differences overflow.
        let exponent = |a: F, b: F| {
            if a == F::ZERO || b == F::ZERO { -1_000_000 } else { a.exponent() + b.exponent() }
        };
        let (first, second) = (exponent(self.ux, self.vy), exponent(self.uy, self.vx));
        let e = if first >= second { first } else { second };
        if e == -1_000_000 {
            return (F::ZERO, 0);
        }
        let significand = |a: F| if a == F::ZERO { a } else { a.scaled(-a.exponent()) };
        // The smaller product is brought beside the larger; where it underflows it is beyond rounding.
        let m = F::cross(
            significand(self.ux),
            significand(self.uy),
            significand(self.vx).scaled(second - e),
            significand(self.vy).scaled(first - e),
        );
        (m, e)
    }
}
