//! The ellipse's axes and tilt, true and as the paper has them.

use super::{Conic, Jacobian, Padding};
use crate::kernel::real::Real;

/// The tilt (5), lost in print: the two formulas it can have been.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TiltFormula {
    /// arctan(Vx/Ux): the direction of ∂(u,v)/∂x.
    Vector,
    /// ½ arctan(B/(A - C)): the conic's, up to a quarter turn.
    Conic,
}

impl TiltFormula {
    /// Both.
    pub const ALL: [TiltFormula; 2] = [TiltFormula::Vector, TiltFormula::Conic];

    /// The angle, in [-π/2, π/2] and [-π/4, π/4]; NaN for 0/0.
    #[inline]
    pub fn angle<F: Real>(self, j: Jacobian<F>) -> F {
        let arctan = |y: F, x: F| (y / x).atan2(F::ONE);
        match self {
            TiltFormula::Vector => arctan(j.vx, j.ux),
            TiltFormula::Conic => {
                let Conic { a, b, c, .. } = Conic::of(j);
                F::HALF * arctan(b, a - c)
            }
        }
    }
}

/// Semi-axes of an ellipse in texels, and the angle of the major one from the u axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes<F> {
    /// Half of the longer axis (the paper's L/2).
    pub major: F,
    /// Half of the shorter axis (d/2).
    pub minor: F,
    /// Of the major axis, radians, in [-π/2, π/2].
    pub tilt: F,
}

impl<F: Real> Axes<F> {
    /// The true axes of M = J Jᵀ, or of J Jᵀ + I: the singular values of J.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Jacobian, Padding};
    /// let axes = Axes::of(Jacobian { ux: 0.0_f64, vx: 3.0, uy: 2.0, vy: 0.0 }, Padding::Plain);
    /// assert_eq!((axes.major, axes.minor, axes.tilt), (3.0, 2.0, std::f64::consts::FRAC_PI_2));
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>, padding: Padding) -> Self {
        if !j.is_finite() {
            return Axes { major: F::NAN, minor: F::NAN, tilt: F::NAN };
        }
        let largest = j.largest();
        let shift = if largest > F::ZERO { largest.exponent() } else { 0 };
        let s = j.shifted(-shift);
        // J = rotation · diag · rotation; the four numbers are sums of two components, so each keeps its
        // relative accuracy, and so do the axes.
        let (e, g) = (s.ux + s.vy, s.vx + s.uy);
        let (f, h) = (s.ux - s.vy, s.vx - s.uy);
        let (q, r) = (e.hypot(h), f.hypot(g));
        let major = F::HALF * (q + r);
        // Not ½ |q - r|, which cancels.
        let minor = if major > F::ZERO { s.determinant().abs() / major } else { F::ZERO };
        // Of the major axis, modulo π.
        let mut tilt = if r > F::ZERO { F::HALF * (g.atan2(f) + h.atan2(e)) } else { F::ZERO };
        if tilt > F::HALF * F::PI {
            tilt = tilt - F::PI;
        }
        if tilt < -(F::HALF * F::PI) {
            tilt = tilt + F::PI;
        }
        let widen = |axis: F| match padding {
            Padding::Plain => axis.scaled(shift),
            Padding::Padded => axis.scaled(shift).hypot(F::ONE),
        };
        Axes { major: widen(major), minor: widen(minor), tilt }
    }

    /// The paper's: half lengths of the two derivative vectors, (10), and either tilt; the first along the
    /// tilt, whether it is the longer one or not.
    #[inline]
    pub fn paper(j: Jacobian<F>, tilt: TiltFormula) -> Self {
        let (major, minor) = j.lengths();
        Axes { major, minor, tilt: tilt.angle(j) }
    }

    /// Major by minor; +∞ for a line, NaN for a point.
    #[inline]
    pub fn aspect(self) -> F {
        self.major / self.minor
    }

    /// The same with the minor axis no shorter than major/`anisotropy`.
    #[inline]
    pub fn limited(self, anisotropy: F) -> Self {
        Axes { minor: self.minor.max(self.major / anisotropy), ..self }
    }

    /// Coordinates along the axes.
    #[inline]
    pub fn frame(self) -> Frame<F> {
        Frame { cos: self.tilt.cos(), sin: self.tilt.sin(), major: self.major, minor: self.minor }
    }
}

/// Coordinates along an ellipse's axes, (4): what weights that are products need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<F> {
    /// cos of the tilt.
    pub cos: F,
    /// sin of the tilt.
    pub sin: F,
    /// Semi-axis along the tilt.
    pub major: F,
    /// Semi-axis across it.
    pub minor: F,
}

impl<F: Real> Frame<F> {
    /// (U cos α + V sin α)/major and (-U sin α + V cos α)/minor: ±1 at the ends of the axes.
    #[inline]
    pub fn coordinates(&self, u: F, v: F) -> (F, F) {
        ((u * self.cos + v * self.sin) / self.major, (v * self.cos - u * self.sin) / self.minor)
    }

    /// The matrix M of the ellipse: uu, uv, vv.
    #[inline]
    pub fn matrix(&self) -> [F; 3] {
        let (a, b) = (self.major * self.major, self.minor * self.minor);
        let (cc, cs, ss) = (self.cos * self.cos, self.cos * self.sin, self.sin * self.sin);
        [a * cc + b * ss, (a - b) * cs, a * ss + b * cc]
    }
}
