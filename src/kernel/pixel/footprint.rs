//! The footprint Q = xᵀ M⁻¹ x of a pixel.

use super::{Frame, Jacobian};
use crate::kernel::real::Real;

/// Whether a texel's own size is added to the footprint.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
/// let point = Jacobian { ux: 0.0_f64, vx: 0.0, uy: 0.0, vy: 0.0 };
/// assert_eq!(Footprint::of(point, Padding::Plain).bounds(), (0.0, 0.0));
/// assert_eq!(Footprint::of(point, Padding::Padded).bounds(), (1.0, 1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Padding {
    /// M = J Jᵀ.
    Plain,
    /// M = J Jᵀ + I, so that no semi-axis is shorter than one texel.
    Padded,
}

/// Ellipse xᵀ M⁻¹ x ≤ 1 of texels under a pixel, by its matrix M: what an inner loop over texels needs.
///
/// - Domain, in which nothing over- or underflows: components of J up to 2³¹ (2e9) in `f32` and 2²⁵⁵ (5e76)
///   in `f64`; when plain also at least 2⁻⁶³ (1e-19) or 2⁻⁵¹¹ (1e-154): |det J|, the lengths of J's rows, and
///   |det J| by either length, the half chords along u and v. [`Inverse`](super::Inverse) has no such limits.
/// - Below: what vanishes, a chord too, is degenerate. Above, where an entry or det M is infinite: NaN.
/// - Degenerate, det M = 0 (parallel or zero columns, when plain): the ellipse holds nothing, Q = +∞ at
///   every finite point, its middle included. J not finite: NaN.
/// - Accuracy for Q ≤ 1: absolute error at most 16 u times the aspect of the ellipse, u = 2⁻²⁴ or 2⁻⁵³
///   (sampled, 5.3 u met): `u - middle` cancels to the minor axis' size from the major's.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
/// let j = Jacobian { ux: 3.0_f64, vx: 1.0, uy: 0.0, vy: 2.0 };
/// let footprint = Footprint::of(j, Padding::Plain);
/// assert_eq!((footprint.uu, footprint.uv, footprint.vv, footprint.determinant), (9.0, 3.0, 5.0, 36.0));
/// assert!((footprint.q(3.0, 1.0) - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint<F> {
    /// M's entry of u with u: the square of the half width.
    pub uu: F,
    /// Of u with v.
    pub uv: F,
    /// Of v with v: the square of the half height.
    pub vv: F,
    /// det M, computed without cancellation.
    pub determinant: F,
}

/// One row of an ellipse: Q = `least` + `curvature` (u - `middle`)².
///
/// The row's texels inside are those with |u - `middle`| ≤ √((1 - `least`)/`curvature`), none for `least`
/// above 1.
///
/// ```
/// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding, Row};
/// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
/// let row = Footprint::of(j, Padding::Plain).row(1.0);
/// assert_eq!(row, Row { middle: 0.0, least: 1.0 / 4.0, curvature: 1.0 / 9.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row<F> {
    /// u where Q is least.
    pub middle: F,
    /// Q there.
    pub least: F,
    /// Half the second derivative of Q along u.
    pub curvature: F,
}

impl<F: Real> Footprint<F> {
    /// Of a Jacobian: M = J Jᵀ, and I more where padded; det M = (det J)², and uu + vv + 1 more of the plain.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
    /// let j = Jacobian { ux: 3.0_f64, vx: 1.0, uy: 0.0, vy: 2.0 };
    /// let footprint = Footprint::of(j, Padding::Padded);
    /// assert_eq!((footprint.uu, footprint.uv, footprint.vv), (10.0, 3.0, 6.0));
    /// assert_eq!(footprint.determinant, 10.0 * 6.0 - 3.0 * 3.0);
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>, padding: Padding) -> Self {
        let (uu, vv) = (j.ux * j.ux + j.uy * j.uy, j.vx * j.vx + j.vy * j.vy);
        let (uv, det) = (j.ux * j.vx + j.uy * j.vy, j.determinant());
        let determinant = det * det;
        // An infinite entry would give a finite and wrong Q.
        if !(uu.is_finite() && vv.is_finite() && determinant.is_finite()) {
            return Footprint { uu: F::NAN, uv: F::NAN, vv: F::NAN, determinant: F::NAN };
        }
        match padding {
            Padding::Plain => Footprint { uu, uv, vv, determinant },
            Padding::Padded => {
                let determinant = determinant + uu + vv + F::ONE;
                Footprint { uu: uu + F::ONE, uv, vv: vv + F::ONE, determinant }
            }
        }
    }

    /// Of axes: M from [`Frame::matrix`], det M = (major minor)².
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Footprint};
    /// let footprint = Footprint::along(&Axes { major: 3.0_f64, minor: 2.0, tilt: 0.0 }.frame());
    /// assert_eq!(footprint, Footprint { uu: 9.0, uv: 0.0, vv: 4.0, determinant: 36.0 });
    /// ```
    #[inline]
    pub fn along(frame: &Frame<F>) -> Self {
        let [uu, uv, vv] = frame.matrix();
        let area = frame.major * frame.minor;
        Footprint { uu, uv, vv, determinant: area * area }
    }

    /// Half width √uu and half height √vv of the ellipse's bounding box, in texels.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
    /// let j = Jacobian { ux: 3.0_f64, vx: 5.0, uy: 4.0, vy: 12.0 };
    /// assert_eq!(Footprint::of(j, Padding::Plain).bounds(), (5.0, 13.0));
    /// ```
    #[inline]
    pub fn bounds(&self) -> (F, F) {
        (self.uu.sqrt(), self.vv.sqrt())
    }

    /// The texture's u and v exchanged.
    #[inline]
    pub(super) fn swapped(&self) -> Self {
        Footprint { uu: self.vv, vv: self.uu, ..*self }
    }

    /// Q along the row at v from the middle: a sum of two squares, v²/vv + (vv/det M)(u - v uv/vv)².
    ///
    /// Degenerate: `least` = +∞ and `curvature` = 0. NaN for v or the footprint: NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
    /// let j = Jacobian { ux: 3.0_f64, vx: 1.0, uy: 0.0, vy: 2.0 };
    /// let row = Footprint::of(j, Padding::Plain).row(2.0);
    /// assert!((row.middle - 2.0 * 3.0 / 5.0).abs() < 1e-15 && (row.least - 4.0 / 5.0).abs() < 1e-15);
    /// assert!((row.curvature - 5.0 / 36.0).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn row(&self, v: F) -> Row<F> {
        let curvature = self.vv / self.determinant;
        // As M is positive, it is singular only where det M is 0 or too small beside vv: infinite then.
        if curvature == F::INFINITY || self.vv == F::ZERO {
            return Row { middle: F::ZERO, least: F::INFINITY + v, curvature: F::ZERO };
        }
        Row { middle: v * (self.uv / self.vv), least: v * (v / self.vv), curvature }
    }

    /// Q = v²/vv + (vv/det M)(u - v uv/vv)² at (u, v) from the middle, in texels: 0 there, 1 on the ellipse.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Footprint, Jacobian, Padding};
    /// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
    /// assert_eq!(Footprint::of(j, Padding::Plain).q(0.0, 4.0), 4.0);
    /// let line = Footprint::of(Jacobian { vy: 0.0, ..j }, Padding::Plain);
    /// assert_eq!(line.q(0.0, 0.0), f64::INFINITY);
    /// ```
    #[inline]
    pub fn q(&self, u: F, v: F) -> F {
        let row = self.row(v);
        let off = u - row.middle;
        row.least + row.curvature * off * off
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::pixel::{Jacobian, Padding};

    /// A square beyond the type is no footprint, whichever it is.
    #[test]
    fn one_infinite_square_is_enough() {
        let none = Jacobian { ux: 0.0_f64, vx: 0.0, uy: 0.0, vy: 0.0 };
        let (u, v) = (Jacobian { ux: 1e200, ..none }, Jacobian { vy: 1e200, ..none });
        for j in [u, v, Jacobian { ux: 1e100, vy: 1e100, ..none }] {
            for padding in [Padding::Plain, Padding::Padded] {
                let Footprint { uu, uv, vv, determinant } = Footprint::of(j, padding);
                assert!([uu, uv, vv, determinant].iter().all(|x| x.is_nan()), "{j:?}");
            }
        }
    }

    #[test]
    fn exchanging_the_axes_exchanges_the_bounds_and_keeps_q() {
        let j = Jacobian { ux: 3.0_f64, vx: 5.0, uy: 4.0, vy: 12.0 };
        let footprint = Footprint::of(j, Padding::Plain);
        let swapped = footprint.swapped();
        assert_eq!((footprint.bounds(), swapped.bounds()), ((5.0, 13.0), (13.0, 5.0)));
        // (u, v) = (7, 1): det M = (3·12 - 4·5)² = 256 and Q = (vv u² - 2 uv u v + uu v²)/det M.
        let q = (169.0 * 49.0 - 2.0 * 63.0 * 7.0 + 25.0) / 256.0;
        for found in [footprint.q(7.0, 1.0), swapped.q(1.0, 7.0)] {
            assert!((found - q).abs() < 1e-13 * q, "{found} {q}");
        }
    }
}
