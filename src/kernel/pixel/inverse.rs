//! Q through the inverse of the Jacobian: accurate for every shape and size.

use super::{Jacobian, Padding};
use crate::kernel::real::Real;

/// The footprint's Q with relative accuracy, for ellipses of any aspect and scale.
///
/// With c₁ = vy U - uy V and c₂ = ux V - vx U, the two components of adj(J) x,
///
/// - plain: Q = |J⁻¹ x|² = (c₁² + c₂²)/det², det = det J;
/// - padded: Q = (c₁² + c₂² + U² + V²)/(det² + |J|² + 1), |J|² the sum of the squares: for matrices of
///   order 2 adj(J Jᵀ + I) = adj(J Jᵀ) + I and det(J Jᵀ + I) = det² + |J|² + 1.
///
/// Every sum is one of squares, and the differences inside are [`Real::cross`], so nothing is lost. J and x
/// are first scaled by a power of two, which is exact, so that no square leaves the type's range.
///
/// - Domain, with a the largest absolute component: every finite J whose |det| is at least 2⁻¹⁰⁰ a² (`f32`)
///   or 2⁻⁹⁰⁰ a² (`f64`) when plain, and a up to 2¹⁰⁰ or 2⁹⁰⁰ when padded. That is an aspect of 1e30 or
///   1e270, and more than any image has.
/// - Accuracy there: relative error of Q at most 12 u + O(u²) when plain and 26 u when padded, u = 2⁻²⁴ or
///   2⁻⁵³, as long as Q and the terms that matter in it do not underflow. By count: 2 u of each cross, u of the
///   quotient, 2 u of its denominator (8 u where that is a root of squares), doubled by squaring, and the
///   sums. Sampled, 6.6 u and 10.6 u were met.
/// - det J = 0, plain: the ellipse holds nothing, +∞ everywhere, its middle included. J not finite: NaN.
/// - (u, v) in texels from the middle. NaN: NaN; infinite: +∞ or NaN.
///
/// Costs two crosses and four divisions a texel where [`Footprint`](super::Footprint) takes three
/// multiplications: for aspects above 100 or so in `f32`, and as the reference of the others.
///
/// ```
/// use bellfit::kernel::pixel::{Inverse, Jacobian, Padding};
/// let j = Jacobian { ux: 3e18_f32, vx: 0.0, uy: 0.0, vy: 2e-18 };
/// assert_eq!(Inverse::of(j, Padding::Plain).q(-3e18, 2e-18), 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inverse<F> {
    /// J 2^-shift, its largest component in [1, 2), or below where padded.
    j: Jacobian<F>,
    /// Root of the denominator at that scale.
    root: F,
    /// One texel at that scale; 0 when plain.
    texel: F,
    shift: i32,
}

impl<F: Real> Inverse<F> {
    /// Of a Jacobian: J and the root √(det²) or √(det² + |J|² + 1) of Q's denominator.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Inverse, Jacobian, Padding};
    /// let line = Jacobian { ux: 3.0_f64, vx: 1.0, uy: 6.0, vy: 2.0 };
    /// assert_eq!(Inverse::of(line, Padding::Plain).q(0.0, 0.0), f64::INFINITY);
    /// // (2·1 - 6·3)² + (3·3 - 1·1)² + 1² + 3² over 3² + 1² + 6² + 2² + 1
    /// assert!((Inverse::of(line, Padding::Padded).q(1.0, 3.0) - 330.0 / 51.0).abs() < 4e-15);
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>, padding: Padding) -> Self {
        if !j.is_finite() {
            let nan = Jacobian { ux: F::NAN, vx: F::NAN, uy: F::NAN, vy: F::NAN };
            return Inverse { j: nan, root: F::NAN, texel: F::ZERO, shift: 0 };
        }
        let largest = match padding {
            Padding::Plain => j.largest(),
            Padding::Padded => j.largest().max(F::ONE),
        };
        let shift = if largest > F::ZERO { largest.exponent() } else { 0 };
        let (m, e) = j.determinant_and_exponent();
        let det = m.abs().scaled(e - 2 * shift);
        let j = j.shifted(-shift);
        match padding {
            Padding::Plain => Inverse { j, root: det, texel: F::ZERO, shift },
            Padding::Padded => {
                let texel = F::ONE.scaled(-shift);
                let (first, second) = j.lengths();
                let root = det.hypot(texel * first.hypot(second)).hypot(texel * texel);
                Inverse { j, root, texel, shift }
            }
        }
    }

    /// Q = (c₁² + c₂²)/det², or padded (c₁² + c₂² + U² + V²)/(det² + |J|² + 1), at (u, v) from the middle, in texels: 1
    /// on the ellipse.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Inverse, Jacobian, Padding};
    /// // aspect 2e8: no digit would survive the conic in either type
    /// let j = Jacobian { ux: 1e4_f32, vx: 1e4, uy: 0.0, vy: 1e-4 };
    /// let inverse = Inverse::of(j, Padding::Plain);
    /// assert!((inverse.q(1e4, 1e4) - 1.0).abs() < 1e-6);
    /// assert!((inverse.q(0.0, 2e-4) - 4.0).abs() < 4e-6);
    /// ```
    #[inline]
    pub fn q(&self, u: F, v: F) -> F {
        if self.root == F::ZERO {
            // NaN for a NaN
            return F::INFINITY + (u + v);
        }
        let (j, u, v) = (self.j, u.scaled(-self.shift), v.scaled(-self.shift));
        let x = F::cross(j.vy, j.uy, v, u) / self.root;
        let y = F::cross(j.ux, j.vx, u, v) / self.root;
        // Before the division: texel/root may overflow where u or v is 0.
        let (du, dv) = (u * self.texel / self.root, v * self.texel / self.root);
        (x * x + y * y) + (du * du + dv * dv)
    }
}
