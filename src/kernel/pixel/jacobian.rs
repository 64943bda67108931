//! The derivatives of texture coordinates along the screen.

use crate::kernel::real::Real;

/// Derivatives of (u, v) along the screen's x and y, in texels per pixel.
///
/// (ux, vx) = ∂(u, v)/∂x, (uy, vy) = ∂(u, v)/∂y; pixel paper, (1). As a matrix J = [[ux, uy], [vx, vy]].
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
    /// ux vy - uy vx, accurate where it nearly cancels ([`Real::cross`]); its square is the paper's F.
    #[inline]
    pub fn determinant(self) -> F {
        F::cross(self.ux, self.uy, self.vx, self.vy)
    }

    /// s J: the derivatives along s pixels. s = ½ makes Q = 1 the image of the circle of diameter 1.
    #[inline]
    pub fn scaled(self, s: F) -> Self {
        Jacobian { ux: self.ux * s, vx: self.vx * s, uy: self.uy * s, vy: self.vy * s }
    }

    /// Lengths of (ux, vx) and (uy, vy), the two conjugate semi-diameters of the ellipse.
    #[inline]
    pub fn lengths(self) -> (F, F) {
        (self.ux.hypot(self.vx), self.uy.hypot(self.vy))
    }

    /// Whether all four are finite.
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
}
