//! The ellipse's axes and tilt, true and as the paper has them.

use super::{Conic, Jacobian, Padding};
use crate::kernel::real::Real;

/// The tilt (5), lost in print: the two formulas it can have been.
///
/// ```
/// use bellfit::kernel::pixel::{Axes, Jacobian, Padding, TiltFormula};
/// let j = Jacobian { ux: 2.0_f64, vx: 1.0, uy: -2.0, vy: 4.0 }; // perpendicular, the second twice as long
/// let tilt = Axes::of(j, Padding::Plain).tilt; // of (-2, 4), the major axis
/// assert!((tilt - libm::atan(-2.0)).abs() < 1e-15);
/// assert_eq!(TiltFormula::Vector.angle(j), libm::atan(0.5)); // of the minor one
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TiltFormula {
    /// arctan(Vx/Ux): the direction of ∂(u,v)/∂x, which is an axis only where the two derivatives are
    /// perpendicular.
    Vector,
    /// ½ arctan(B/(A - C)): the conic's, up to a quarter turn.
    Conic,
}

impl TiltFormula {
    /// Both.
    pub const ALL: [TiltFormula; 2] = [TiltFormula::Vector, TiltFormula::Conic];

    /// α = arctan(Vx/Ux) or α = ½ arctan(B/(A - C)), in radians, in [-π/2, π/2] and [-π/4, π/4]; NaN for 0/0 (a zero
    /// derivative; a circle).
    ///
    /// As printed: A - C cancels near a circle, and the conic's domain is that of [`Conic`]. A component that is
    /// not finite: NaN, or an angle without meaning.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Jacobian, TiltFormula};
    /// let j = Jacobian { ux: 3.0_f64, vx: 1.0, uy: -0.5, vy: 1.5 }; // perpendicular: both are right
    /// let tilts = TiltFormula::ALL.map(|formula| formula.angle(j));
    /// assert!(tilts.iter().all(|tilt| (tilt - libm::atan(1.0 / 3.0)).abs() < 1e-15));
    /// ```
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
///
/// ```
/// use bellfit::kernel::pixel::Axes;
/// let axes = Axes { major: 3.0_f64, minor: 1.5, tilt: 0.0 }; // the paper's figure, but for its 30°
/// assert_eq!(axes.aspect(), 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes<F> {
    /// Half of the longer axis (the paper's L/2).
    pub major: F,
    /// Half of the shorter axis (d/2).
    pub minor: F,
    /// Of the major axis, radians, in (-π/2, π/2].
    pub tilt: F,
}

impl<F: Real> Axes<F> {
    /// The true axes of M = J Jᵀ, or of J Jᵀ + I: the singular values of J.
    ///
    /// With e = ux + vy, f = ux - vy, g = vx + uy, h = vx - uy: major = ½ (√(e² + h²) + √(f² + g²)),
    /// minor = |det J|/major, tilt = ½ (arg(f + i g) + arg(e + i h)) modulo π; padded √(axis² + 1).
    /// J. Blinn, "Consider the Lowly 2 x 2 Matrix", IEEE Computer Graphics and Applications 16(2), 1996.
    ///
    /// - Domain: every finite J. Parallel or zero columns: minor 0 exactly. A circle, rotated or mirrored:
    ///   tilt 0. An axis beyond the type's largest number: +∞. A component not finite: NaN in all three.
    /// - The tilt is in (-π/2, π/2], π/2 and never -π/2 for an axis along v: rounded values of it too.
    /// - Accuracy: both axes to a relative error of at most 8 u, u = 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`), at any
    ///   aspect, unless they are subnormal; 4.7 u were met. The tilt within 6 u π absolutely, 2.1 u π met (sampled).
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Jacobian, Padding};
    /// let axes = Axes::of(Jacobian { ux: 0.0_f64, vx: 3.0, uy: 2.0, vy: 0.0 }, Padding::Plain);
    /// assert_eq!((axes.major, axes.minor, axes.tilt), (3.0, 2.0, std::f64::consts::FRAC_PI_2));
    /// let long = Axes::of(Jacobian { ux: 1e20_f32, vx: 0.0, uy: 0.0, vy: 1e-20 }, Padding::Padded);
    /// assert_eq!((long.major, long.minor, long.tilt), (1e20, 1.0, 0.0));
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>, padding: Padding) -> Self {
        if !j.is_finite() {
            return Axes { major: F::NAN, minor: F::NAN, tilt: F::NAN };
        }
        let largest = j.largest();
        let shift = if largest > F::ZERO { largest.exponent() } else { 0 };
        let s = j.shifted(-shift);
        // Each is a sum of two components, so each keeps its relative accuracy, and so do the axes.
        let (e, g) = (s.ux + s.vy, s.vx + s.uy);
        let (f, h) = (s.ux - s.vy, s.vx - s.uy);
        let (q, r) = (e.hypot(h), f.hypot(g));
        let major = F::HALF * (q + r);
        // Not ½ |q - r|, which cancels.
        let (det, exponent) = j.determinant_and_exponent();
        let minor = if major > F::ZERO { (det.abs() / major).scaled(exponent - shift) } else { F::ZERO };
        // A circle, turned or mirrored: one of the two angles is free.
        let round = q == F::ZERO || r == F::ZERO;
        let (tilt, half) = (F::HALF * (g.atan2(f) + h.atan2(e)), F::HALF * F::PI);
        let tilt = match tilt {
            _ if round => F::ZERO,
            high if high > half => high - F::PI,
            low if low <= -half => low + F::PI,
            tilt => tilt,
        };
        let major = major.scaled(shift);
        // Where both are rounded, the quotient may come out above.
        let minor = minor.min(major);
        match padding {
            Padding::Plain => Axes { major, minor, tilt },
            Padding::Padded => Axes { major: major.hypot(F::ONE), minor: minor.hypot(F::ONE), tilt },
        }
    }

    /// The paper's: half lengths of the two derivative vectors, √(Ux² + Vx²) and √(Uy² + Vy²), (10), and either tilt;
    /// the first along the tilt, whether it is the longer one or not.
    ///
    /// The true axes where the derivatives are perpendicular, (ux, vx) is the longer and the tilt is
    /// [`TiltFormula::Vector`]; otherwise another ellipse. Domain and NaN: [`Jacobian::lengths`] and
    /// [`TiltFormula::angle`].
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Jacobian, Padding, TiltFormula};
    /// let j = Jacobian { ux: 3.0_f64, vx: 0.0, uy: 0.0, vy: 2.0 };
    /// assert_eq!(Axes::paper(j, TiltFormula::Vector), Axes::of(j, Padding::Plain));
    /// let shear = Jacobian { uy: 4.0, ..j };
    /// assert!(Axes::paper(shear, TiltFormula::Conic).major < Axes::of(shear, Padding::Plain).major);
    /// ```
    #[inline]
    pub fn paper(j: Jacobian<F>, tilt: TiltFormula) -> Self {
        let (major, minor) = j.lengths();
        Axes { major, minor, tilt: tilt.angle(j) }
    }

    /// The aspect a = major/minor; +∞ for a line, NaN for a point.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Axes;
    /// assert_eq!(Axes { major: 3.0_f64, minor: 0.0, tilt: 0.0 }.aspect(), f64::INFINITY);
    /// ```
    #[inline]
    pub fn aspect(self) -> F {
        self.major / self.minor
    }

    /// The same with the minor axis no shorter than major/`anisotropy`: minor' = max(minor, major/anisotropy).
    ///
    /// Domain: anisotropy ≥ 1; +∞ limits nothing. 0 and NaN: minor +∞ and NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Axes;
    /// let axes = Axes { major: 32.0_f64, minor: 1.0, tilt: 0.5 };
    /// assert_eq!(axes.limited(16.0).minor, 2.0);
    /// assert_eq!(axes.limited(f64::INFINITY), axes);
    /// ```
    #[inline]
    pub fn limited(self, anisotropy: F) -> Self {
        Axes { minor: self.minor.max(self.major / anisotropy), ..self }
    }

    /// Coordinates along the axes: cos = cos α and sin = sin α of the tilt α.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Frame};
    /// let frame = Axes { major: 3.0_f64, minor: 2.0, tilt: 0.0 }.frame();
    /// assert_eq!(frame, Frame { cos: 1.0, sin: 0.0, major: 3.0, minor: 2.0 });
    /// ```
    #[inline]
    pub fn frame(self) -> Frame<F> {
        Frame { cos: self.tilt.cos(), sin: self.tilt.sin(), major: self.major, minor: self.minor }
    }
}

/// Coordinates along an ellipse's axes, (4): what weights that are products need.
///
/// ```
/// use bellfit::kernel::pixel::Frame;
/// let upright = Frame { cos: 0.0_f64, sin: 1.0, major: 4.0, minor: 2.0 };
/// assert_eq!(upright.coordinates(0.0, 4.0), (1.0, 0.0)); // the end of the major axis
/// ```
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
    ///
    /// The squares add up to Q; their error is that of [`Footprint`](super::Footprint), u times the aspect. A
    /// semi-axis of 0: ±∞ or NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Jacobian, Padding};
    /// let j = Jacobian { ux: 3.0_f64, vx: 1.0, uy: 0.0, vy: 2.0 };
    /// let (a, b) = Axes::of(j, Padding::Plain).frame().coordinates(3.0, 1.0);
    /// assert!((a * a + b * b - 1.0).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn coordinates(&self, u: F, v: F) -> (F, F) {
        ((u * self.cos + v * self.sin) / self.major, (v * self.cos - u * self.sin) / self.minor)
    }

    /// The matrix M of the ellipse: uu = a² cos²α + b² sin²α, uv = (a² - b²) cos α sin α, vv = a² sin²α + b² cos²α, a
    /// and b the semi-axes.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Frame;
    /// let frame = Frame { cos: 0.6_f64, sin: 0.8, major: 5.0, minor: 0.0 };
    /// let [uu, uv, vv] = frame.matrix(); // of the one vector (3, 4)
    /// assert!((uu - 9.0).abs() + (uv - 12.0).abs() + (vv - 16.0).abs() < 1e-14);
    /// ```
    #[inline]
    pub fn matrix(&self) -> [F; 3] {
        let (a, b) = (self.major * self.major, self.minor * self.minor);
        let (cc, cs, ss) = (self.cos * self.cos, self.cos * self.sin, self.sin * self.sin);
        [a * cc + b * ss, (a - b) * cs, a * ss + b * cc]
    }
}
