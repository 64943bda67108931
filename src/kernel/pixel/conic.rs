//! The footprint's ellipse as the paper writes it.

use super::Jacobian;
use crate::kernel::real::Real;

/// Ellipse A U² + B U V + C V² = F, the image of the circle of radius 1 under J.
///
/// A = Vx² + Vy², B = -2 (Ux Vx + Uy Vy), C = Ux² + Uy², F = (Ux Vy - Uy Vx)²; pixel paper, (2), and P. S.
/// Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989.
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
    /// The coefficients by the paper's expressions, F from the accurate determinant.
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

    /// (A U² + B U V + C V²)/F. Cancels for long ellipses that are tilted: [`Footprint::q`] does not.
    ///
    /// [`Footprint::q`]: super::Footprint::q
    #[inline]
    pub fn q(self, u: F, v: F) -> F {
        (self.a * u * u + self.b * u * v + self.c * v * v) / self.f
    }
}
