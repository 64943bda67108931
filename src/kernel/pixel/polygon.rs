//! The projective mapping from the screen to a polygon's texture.

use super::Jacobian;
use crate::kernel::real::Real;

/// Mapping of a textured polygon: u = (A1 x + B1 y + C1)/w, v = (A2 x + B2 y + C2)/w, w = D x + E y + F.
///
/// Source: pixel paper, the equations of the ellipse's centre. (x, y) in pixels, (u, v) in texels. Nine
/// numbers times a common factor are the same mapping; w > 0 in front of the viewer is the caller's choice of
/// sign. Numbers that are not finite, or whose products are not: NaN or ±∞ as IEEE 754 has it.
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

/// a x + b y + c.
#[inline]
fn row<F: Real>([a, b, c]: [F; 3], x: F, y: F) -> F {
    a * x + b * y + c
}

impl<F: Real> Polygon<F> {
    /// (u, v) at the screen's (x, y). On the horizon, w = 0: ±∞ or NaN; behind it, w of the other sign, the
    /// coordinates of the plane's continuation.
    ///
    /// Absolute error at most 4 u (|A1 x| + |B1 y| + |C1|)/|w| beside u's own, and that of w: 4 u times the
    /// value times (|D x| + |E y| + |F|)/|w|, which grows towards the horizon. u = 2⁻²⁴ or 2⁻⁵³; by count.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Polygon;
    /// let scaling = Polygon { u: [2.0_f64, 0.0, 1.0], v: [0.0, 4.0, 0.0], w: [0.0, 0.0, 2.0] };
    /// assert_eq!(scaling.at(1.0, 3.0), (1.5, 6.0));
    /// ```
    #[inline]
    pub fn at(&self, x: F, y: F) -> (F, F) {
        let w = row(self.w, x, y);
        (row(self.u, x, y) / w, row(self.v, x, y) / w)
    }

    /// Exact derivatives at (x, y), (1) as derivatives: ∂u/∂x = (A1 - u D)/w and so on.
    ///
    /// Evaluated as ((A1 E - B1 D) y + (A1 F - C1 D))/w², in which A1 no longer cancels with u D. Error: 6 u of
    /// the numerator's two terms in absolute value, over w², and twice the relative error of w; u = 2⁻²⁴ or
    /// 2⁻⁵³; by count. On the horizon, w = 0: ±∞ or NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Polygon;
    /// let p = Polygon { u: [1.0_f64, 2.0, 3.0], v: [0.0, 1.0, 0.0], w: [0.5, 0.0, 1.0] };
    /// let ((u, v), w) = (p.at(2.0, 4.0), 0.5 * 2.0 + 1.0);
    /// let j = p.jacobian(2.0, 4.0);
    /// assert_eq!([j.ux, j.uy], [(1.0 - u * 0.5) / w, (2.0 - u * 0.0) / w]);
    /// assert_eq!([j.vx, j.vy], [(0.0 - v * 0.5) / w, (1.0 - v * 0.0) / w]);
    /// ```
    #[inline]
    pub fn jacobian(&self, x: F, y: F) -> Jacobian<F> {
        let [d, e, f] = self.w;
        let w = row(self.w, x, y);
        let slopes = |[a, b, c]: [F; 3]| {
            let (ae, af, bf) = (F::cross(a, b, d, e), F::cross(a, c, d, f), F::cross(b, c, e, f));
            // Not over w², which may leave the type's range.
            ((ae * y + af) / w / w, (bf - ae * x) / w / w)
        };
        let ((ux, uy), (vx, vy)) = (slopes(self.u), slopes(self.v));
        Jacobian { ux, vx, uy, vy }
    }

    /// Differences to the next pixel right and below, the other reading of (1): exact only where w is
    /// constant.
    ///
    /// Their error beside the derivatives is that of [`Polygon::at`], twice, and the mapping's curvature: half
    /// of |∂²u/∂x²| and so on. A pixel further may be on the horizon or behind it: not finite, or of no meaning.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Polygon;
    /// let plane = Polygon { u: [1.0_f64, 0.0, 0.0], v: [0.0, 0.0, 1.0], w: [0.0, 1.0, 0.0] };
    /// let j = plane.differences(3.0, 1.0); // from (3, 1) to (4, 1) and (1.5, 0.5)
    /// assert_eq!([j.ux, j.vx, j.uy, j.vy], [1.0, 0.0, -1.5, -0.5]);
    /// ```
    #[inline]
    pub fn differences(&self, x: F, y: F) -> Jacobian<F> {
        let ((u, v), (u1, v1), (u2, v2)) = (self.at(x, y), self.at(x + F::ONE, y), self.at(x, y + F::ONE));
        Jacobian { ux: u1 - u, vx: v1 - v, uy: u2 - u, vy: v2 - v }
    }
}
