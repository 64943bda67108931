//! How far the paper's axes are from the ellipse's own, in closed form.

use super::{Axes, Jacobian};
use crate::kernel::real::Real;

/// Shape of a footprint: the angle from (ux, vx) to (uy, vy), and their lengths' ratio.
///
/// The paper takes the two derivative vectors, of lengths p and q, for the ellipse's semi-axes ((10) is
/// L² = 4 p², and d² = 4 q²). They are *conjugate* semi-diameters: the axes only where they are at right
/// angles. With φ the angle between them and ρ = q/p, the squares of the true semi-axes are the eigenvalues
/// of M = J Jᵀ, whose trace is p² + q² and whose determinant is p² q² sin²φ:
///
/// σ² = ½ (p² + q² ± √((p² + q²)² - 4 p² q² sin²φ)) = ½ (p² + q² ± p² |1 + ρ² e^(2iφ)|),
///
/// since |1 + ρ² e^(2iφ)|² = 1 + 2ρ² cos 2φ + ρ⁴ = (1 + ρ²)² - 4ρ² sin²φ: the second form does not cancel.
///
/// | | ratio, closed form | extremes over φ and ρ |
/// |---|---|---|
/// | major axis, true/paper | [`major`](Self::major) | from 1 up to √2, reached at ρ = 1, sin φ = 0 |
/// | minor axis, true/paper | [`minor`](Self::minor) | from 1 down to 0 as sin φ → 0: too long without bound |
/// | area, paper/true | [`area`](Self::area) | 1/∣sin φ∣ |
/// | tilt, true - first vector's | [`tilt`](Self::tilt) | below 45° for ρ ≤ 1, up to 90° beyond |
///
/// *Major.* A unit vector gives one of the two vectors, so σ₁ ≥ max(p, q); and σ₁² ≤ p² + q² ≤ 2 max(p, q)²,
/// equal in both places only where sin φ = 0 and p = q. *Minor.* σ₁ σ₂ = p q |sin φ| gives σ₂/min(p, q) =
/// |sin φ| max(p, q)/σ₁, at most 1 and at least |sin φ|/√2. *Tilt.* With (ux, vx) along the u axis M has the
/// entries p² + q² cos²φ, q² sin φ cos φ, q² sin²φ, so twice the major axis' tilt is the argument of
/// 1 + ρ² e^(2iφ): a circle of radius ρ² about 1, seen from 0. For ρ < 1 it lies to the right, and the
/// tilt is at most ½ arcsin ρ²; at ρ = 1 it passes through 0, and the tilt, φ/2, tends to 45° as the
/// footprint tends to a circle; for ρ > 1 it goes round 0, and at φ = 90° the tilt is 90° (the axes have
/// changed places).
///
/// Source: this crate; pixel paper, (5), (7) and (10).
///
/// ```
/// use bellfit::kernel::pixel::Skew;
/// // equal vectors 60° apart: axes √(1 ± ½), tilt 30°
/// let skew = Skew { angle: std::f64::consts::FRAC_PI_3, ratio: 1.0 };
/// assert!((skew.major() - 1.5_f64.sqrt()).abs() < 1e-15 && (skew.minor() - 0.5_f64.sqrt()).abs() < 1e-15);
/// assert!((skew.tilt().to_degrees() - 30.0).abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Skew<F> {
    /// φ, from the first vector to the second, radians, in (-π, π].
    pub angle: F,
    /// ρ, the second's length by the first's, positive.
    pub ratio: F,
}

impl<F: Real> Skew<F> {
    /// Of a Jacobian: φ = arg((ux uy + vx vy) + i det J), ρ = |(uy, vy)|/|(ux, vx)|, which is +∞ or NaN where the first
    /// vector is 0.
    ///
    /// Domain: every finite J, whatever its size. A component that is not finite: an angle of NaN.
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Jacobian, Skew};
    /// let tiny = Jacobian { ux: 1e-30_f32, vx: 0.0, uy: 0.0, vy: 2e-30 };
    /// assert_eq!(Skew::of(tiny), Skew { angle: std::f32::consts::FRAC_PI_2, ratio: 2.0 });
    /// ```
    #[inline]
    pub fn of(j: Jacobian<F>) -> Self {
        let (first, second) = j.lengths();
        if !j.is_finite() {
            return Skew { angle: F::NAN, ratio: second / first };
        }
        // |second| sin φ and |second| cos φ times |first|: the second is det of the first vector turned.
        let (cross, a) = j.determinant_and_exponent();
        let (dot, b) = Jacobian { uy: -j.vy, vy: j.uy, ..j }.determinant_and_exponent();
        // A product of 0 has no exponent.
        let e = match (cross == F::ZERO, dot == F::ZERO) {
            (true, _) => b,
            (_, true) => a,
            _ if a >= b => a,
            _ => b,
        };
        Skew { angle: cross.scaled(a - e).atan2(dot.scaled(b - e)), ratio: second / first }
    }

    /// A Jacobian of this shape: the first vector (1, 0), the second ρ (cos φ, sin φ). Each within 3 u = 3·2⁻²⁴ or
    /// 3·2⁻⁵³ relatively.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// let j = Skew { angle: std::f64::consts::FRAC_PI_3, ratio: 2.0 }.jacobian();
    /// assert_eq!((j.ux, j.vx), (1.0, 0.0));
    /// assert!((j.uy - 1.0).abs() < 1e-15 && (j.vy - libm::sqrt(3.0)).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn jacobian(self) -> Jacobian<F> {
        let Skew { angle, ratio } = self;
        Jacobian { ux: F::ONE, vx: F::ZERO, uy: ratio * angle.cos(), vy: ratio * angle.sin() }
    }

    /// 1 + ρ² e^(2iφ).
    #[inline]
    fn turn(self) -> (F, F) {
        let (square, twice) = (self.ratio * self.ratio, self.angle + self.angle);
        (F::ONE + square * twice.cos(), square * twice.sin())
    }

    /// True major axis by the longer of the paper's two, in [1, √2]: √(½ (1 + ρ² + |1 + ρ² e^(2iφ)|))/max(1, ρ).
    ///
    /// Rounding: 4 ε. NaN: NaN; ρ² beyond the type: +∞; ρ² that vanishes: 1.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// // parallel and equal: √2, the largest there is
    /// assert!((Skew { angle: 0.0_f64, ratio: 1.0 }.major() - libm::sqrt(2.0)).abs() < 1e-15);
    /// assert_eq!(Skew { angle: std::f64::consts::FRAC_PI_2, ratio: 3.0 }.major(), 1.0);
    /// ```
    #[inline]
    pub fn major(self) -> F {
        let (x, y) = self.turn();
        let longest = F::ONE.max(self.ratio);
        let sum = F::ONE + self.ratio * self.ratio;
        (F::HALF * (sum + x.hypot(y))).sqrt() / longest
    }

    /// True minor axis by the shorter of the paper's two, in [0, 1]: σ₂/min(p, q) = |sin φ|/[`major`](Self::major), as the axes' product
    /// is that of the vectors times |sin φ|.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// let skew = Skew { angle: std::f64::consts::FRAC_PI_6, ratio: 1.0 };
    /// assert!((skew.minor() * skew.major() - 0.5).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn minor(self) -> F {
        self.angle.sin().abs() / self.major()
    }

    /// Area of the paper's ellipse by that of the true one, a = 1/|sin φ|; +∞ where the true one is a line.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// let area = Skew { angle: -std::f64::consts::FRAC_PI_6, ratio: 5.0 }.area();
    /// assert!((area - 2.0).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn area(self) -> F {
        F::ONE / self.angle.sin().abs()
    }

    /// Tilt ½ arg(1 + ρ² e^(2iφ)) of the true major axis from the first vector, in (-π/2, π/2]: the error of
    /// [`TiltFormula::Vector`](super::TiltFormula::Vector). Without meaning for a circle, φ = ±90° and ρ = 1,
    /// where rounding decides.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// // equal vectors: half way between them
    /// assert!((Skew { angle: 1.0_f64, ratio: 1.0 }.tilt() - 0.5).abs() < 1e-15);
    /// ```
    #[inline]
    pub fn tilt(self) -> F {
        let (x, y) = self.turn();
        let tilt = F::HALF * y.atan2(x);
        if tilt <= -(F::HALF * F::PI) { tilt + F::PI } else { tilt }
    }

    /// Whether [`TiltFormula::Conic`](super::TiltFormula::Conic) gives the minor axis, a quarter turn off,
    /// when the first vector stands at this angle from the u axis; else it gives the major one.
    ///
    /// B/(A - C) is the tangent of twice the true tilt, and half an arctangent lies within ±45°: it is right
    /// where the true tilt does, cos 2(angle + tilt) ≥ 0, and off by 90° elsewhere, for half of all
    /// directions.
    ///
    /// ```
    /// use bellfit::kernel::pixel::Skew;
    /// let skew = Skew { angle: 1.0_f64, ratio: 1.0 }; // tilt ½
    /// assert!(!skew.conic_is_turned(0.25) && skew.conic_is_turned(0.75)); // ¾ and 5/4 radians, about π/4
    /// ```
    #[inline]
    pub fn conic_is_turned(self, first: F) -> bool {
        let twice = F::TWO * (first + self.tilt());
        twice.cos() < F::ZERO
    }

    /// The true axes in units of the first vector, which lies along the u axis: major = max(1, ρ) times
    /// [`major`](Self::major), minor = min(1, ρ) times [`minor`](Self::minor).
    ///
    /// ```
    /// use bellfit::kernel::pixel::{Axes, Padding, Skew};
    /// let skew = Skew { angle: 0.7_f64, ratio: 2.0 };
    /// let (closed, true_ones) = (skew.axes(), Axes::of(skew.jacobian(), Padding::Plain));
    /// assert!((closed.major - true_ones.major).abs() < 1e-14 && (closed.minor - true_ones.minor).abs() < 1e-14);
    /// ```
    #[inline]
    pub fn axes(self) -> Axes<F> {
        let (longest, shortest) = (F::ONE.max(self.ratio), F::ONE.min(self.ratio));
        Axes { major: longest * self.major(), minor: shortest * self.minor(), tilt: self.tilt() }
    }
}
