//! The footprint's ellipse as the paper writes it.

use super::Jacobian;
use crate::kernel::real::Real;

/// Ellipse A U² + B U V + C V² = F, the image of the circle of radius 1 under J.
///
/// A = Vx² + Vy², B = -2 (Ux Vx + Uy Vy), C = Ux² + Uy², F = (Ux Vy - Uy Vx)²; pixel paper, (2), and P. S.
/// Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, which has the ends of both
/// derivative vectors on it.
///
/// - Units: A, B and C texels², F texels⁴. B² - 4 A C = -4 F.
/// - Nothing overflows for components up to 2³¹ (`f32`) or 2²⁵⁵ (`f64`), or vanishes for |det J| and lengths of
///   J's rows from 2⁻⁶³ or 2⁻⁵¹¹ on. Parallel or zero columns: F = 0. A component that is not finite: some of A, B, C, F are not.
///
/// ```
/// use bellfit::kernel::pixel::{Conic, Jacobian};
/// let conic = Conic::of(Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 });
/// assert_eq!((conic.a, conic.b, conic.c, conic.f), (4.0, 0.0, 9.0, 36.0));
/// assert_eq!(conic.q(3.0, 0.0), 1.0); // on the ellipse
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conic<F> {
    /// Of U².
    pub a: F,
    /// Of U V.
    pub b: F,
    /// Of V².
    pub c: F,
    /// The right side.
    pub f: F,
}

impl<F: Real> Conic<F> {
    /// The coefficients by the paper's expressions, A = Vx² + Vy² and so on, F = (det J)² from the accurate determinant.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Conic, Jacobian};
    /// let (ux, vx, uy, vy) = (3.0_f64, 1.0, -1.0, 2.0);
    /// let conic = Conic::of(Jacobian { ux, vx, uy, vy });
    /// let (a, b, c) = (vx * vx + vy * vy, -2.0 * (ux * vx + uy * vy), ux * ux + uy * uy);
    /// assert_eq!(conic, Conic { a, b, c, f: (ux * vy - uy * vx) * (ux * vy - uy * vx) });
    /// assert_eq!((conic.q(ux, vx), conic.q(uy, vy)), (1.0, 1.0));
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>) -> Self {
        let det = j.determinant();
        Conic {
            a: j.vx * j.vx + j.vy * j.vy,
            b: -F::TWO * (j.ux * j.vx + j.uy * j.vy),
            c: j.ux * j.ux + j.uy * j.uy,
            f: det * det,
        }
    }

    /// Q = (A U² + B U V + C V²)/F, as written.
    ///
    /// For an ellipse that is tilted the three terms cancel: the error of Q ≤ 1 grows as ε times the square
    /// of the aspect, and in `f32` an aspect of 3000 leaves not one digit, or Q below 0. [`Footprint::q`]
    /// loses the aspect's first power, [`Inverse::q`] nothing. F = 0: ±∞ or NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Conic, Inverse, Jacobian, Padding};
    /// let j = Jacobian { ux: 10000.0_f32, vx: 10001.0, uy: 0.0, vy: 1.0 };
    /// let (naive, accurate) = (Conic::of(j).q(j.ux, j.vx), Inverse::of(j, Padding::Plain).q(j.ux, j.vx));
    /// assert_eq!(accurate, 1.0); // (ux, vx) is on the ellipse
    /// assert!((naive - 1.0).abs() > 0.5);
    /// ```
    ///
    /// [`Footprint::q`]: super::Footprint::q
    /// [`Inverse::q`]: super::Inverse::q
    #[inline]
    pub fn q(self, u: F, v: F) -> F {
        (self.a * u * u + self.b * u * v + self.c * v * v) / self.f
    }
}
