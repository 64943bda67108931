//! The projective mapping from the screen to a polygon's texture.

use super::Jacobian;
use crate::kernel::real::Real;

/// Mapping of a textured polygon: u = (A1 x + B1 y + C1)/w, v = (A2 x + B2 y + C2)/w, w = D x + E y + F.
///
/// Source: pixel paper, the equations of the ellipse's centre.
///
/// ```
/// use bellfit::kernel::pixel::Polygon;
/// // u = x/y, v = 1/y: a plane to the horizon at y = 0
/// let plane = Polygon { u: [1.0_f64, 0.0, 0.0], v: [0.0, 0.0, 1.0], w: [0.0, 1.0, 0.0] };
/// assert_eq!(plane.at(3.0, 2.0), (1.5, 0.5));
/// let j = plane.jacobian(3.0, 2.0);
/// assert_eq!([j.ux, j.vx, j.uy, j.vy], [0.5, 0.0, -0.75, -0.25]); // 1/y, 0, -x/y², -1/y²
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<F> {
    /// A1, B1, C1.
    pub u: [F; 3],
    /// A2, B2, C2.
    pub v: [F; 3],
    /// D, E, F.
    pub w: [F; 3],
}

impl<F: Real> Polygon<F> {
    fn rows(&self, x: F, y: F) -> (F, F, F) {
        let row = |[a, b, c]: [F; 3]| a * x + b * y + c;
        (row(self.u), row(self.v), row(self.w))
    }

    /// (u, v) at the screen's (x, y). On the horizon, w = 0: ±∞ or NaN; behind it, w of the other sign, the
    /// coordinates of the plane's continuation.
    #[inline]
    pub fn at(&self, x: F, y: F) -> (F, F) {
        let (u, v, w) = self.rows(x, y);
        (u / w, v / w)
    }

    /// Exact derivatives at (x, y): ∂u/∂x = (A1 - u D)/w and so on. On the horizon: not finite.
    #[inline]
    pub fn jacobian(&self, x: F, y: F) -> Jacobian<F> {
        let (u, v, w) = self.rows(x, y);
        let (u, v) = (u / w, v / w);
        let slope = |a: F, value: F, d: F| (a - value * d) / w;
        Jacobian {
            ux: slope(self.u[0], u, self.w[0]),
            vx: slope(self.v[0], v, self.w[0]),
            uy: slope(self.u[1], u, self.w[1]),
            vy: slope(self.v[1], v, self.w[1]),
        }
    }

    /// Differences to the next pixel right and below, the other reading of (1): exact only where w is
    /// constant.
    #[inline]
    pub fn differences(&self, x: F, y: F) -> Jacobian<F> {
        let ((u, v), (u1, v1), (u2, v2)) = (self.at(x, y), self.at(x + F::ONE, y), self.at(x, y + F::ONE));
        Jacobian { ux: u1 - u, vx: v1 - v, uy: u2 - u, vy: v2 - v }
    }
}
