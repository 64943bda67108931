//! The floating-point types that every kernel is written for.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`, with the elementary functions of `libm`; sealed, as the stated behaviour at NaN and
/// infinities is checked for these two only. The toolkit has a third, `stability::Half`, to measure with.
///
/// On a concrete type Rust prefers the inherent methods of the same name (`max` differs: see
/// [`Real::max`]); these are for generic code.
///
/// ```
/// use bellfit::kernel::real::Real;
/// fn hypotenuse<F: Real>(a: F, b: F) -> F {
///     (a * a + b * b).sqrt()
/// }
/// assert_eq!(hypotenuse(3.0_f32, 4.0), 5.0);
/// assert_eq!(hypotenuse(3.0_f64, 4.0), 5.0);
/// ```
pub trait Real:
    sealed::Sealed
    + Copy
    + PartialOrd
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// ½.
    const HALF: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// π, rounded to the type.
    const PI: Self;
    /// A quiet NaN.
    const NAN: Self;
    /// +∞.
    const INFINITY: Self;

    /// `value` rounded to the type.
    fn from_f64(value: f64) -> Self;
    /// `value` rounded to the type; exact up to 2²⁴ in `f32`.
    fn from_u32(value: u32) -> Self;
    /// The value in double precision, exact.
    fn to_f64(self) -> f64;

    /// √x, correctly rounded; NaN below 0.
    fn sqrt(self) -> Self;
    /// ∛x, of the sign of x.
    fn cbrt(self) -> Self;
    /// sin x, x in radians; NaN at ±∞.
    fn sin(self) -> Self;
    /// cos x, x in radians; NaN at ±∞.
    fn cos(self) -> Self;
    /// arcsin x in radians; NaN outside [-1, 1].
    fn asin(self) -> Self;
    /// The angle of (x, y) = (`other`, `self`) from the x axis, in [-π, π].
    ///
    /// On the axes signed zeros decide, as in IEEE 754: (x, +0) is at 0 or π and (x, -0) at -0 or -π, the
    /// origin too. NaN in either: NaN.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!(Real::atan2(2.0_f64, 0.0), std::f64::consts::FRAC_PI_2);
    /// assert_eq!(Real::atan2(0.0_f64, 0.0), 0.0);
    /// assert_eq!(Real::atan2(-0.0_f64, -1.0), -std::f64::consts::PI);
    /// ```
    fn atan2(self, other: Self) -> Self;
    /// √(x² + y²) without overflow or underflow of the squares; +∞ if either is infinite, beside a NaN too,
    /// else NaN if either is NaN.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!(Real::hypot(3e30_f32, 4e30), 5e30); // the squares are beyond the type
    /// ```
    fn hypot(self, other: Self) -> Self;
    /// Error function, 2/√π ∫₀ˣ e^(-t²) dt; ±1 at ±∞. Keeps its relative accuracy near 0.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!(Real::erf(1e-20_f64) / 1e-20, std::f64::consts::FRAC_2_SQRT_PI);
    /// ```
    fn erf(self) -> Self;
    /// Complementary error function, 2/√π ∫ₓ^∞ e^(-t²) dt = 1 - erf x; 2 at -∞, 0 at +∞. Keeps its
    /// relative accuracy for large x, where 1 - erf x would be 0.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!((Real::erfc(0.0_f64), Real::erfc(f64::INFINITY)), (1.0, 0.0));
    /// assert!((Real::erfc(6.0_f64) / 2.1519736712498913e-17 - 1.0).abs() < 1e-15);
    /// ```
    fn erfc(self) -> Self;
    /// a d - b c, accurate where the products nearly cancel.
    ///
    /// - `f64`: relative error at most 2 u, u = 2⁻⁵³, and 1.5 ulp: W. Kahan's form with two fused
    ///   multiply-adds (C.-P. Jeannerod, N. Louvet, J.-M. Muller, Math. Comp. 82, 2013; 1.9 u met), as
    ///   long as no product leaves the range 2⁻⁹⁶⁸ to 2¹⁰²⁴: below, what its rounding lost underflows.
    /// - `f32`: at most u (1 + 2⁻²⁸), u = 2⁻²⁴, in double precision, where the products are exact and stay in
    ///   range whatever the arguments are; the result may still leave that of `f32`.
    /// - NaN, and products that are ∞ - ∞ or 0·∞: NaN.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// let (a, d) = (1.0_f64 + f64::EPSILON, 1.0 - f64::EPSILON);
    /// assert_eq!(Real::cross(a, 1.0, 1.0, d), -f64::EPSILON * f64::EPSILON);
    /// assert_eq!(a * d - 1.0, 0.0);
    /// ```
    fn cross(a: Self, b: Self, c: Self, d: Self) -> Self;
    /// x 2ᵉ, exact unless it leaves the type's range: +∞ or -∞ above, rounded once below. 0, ±∞ and NaN
    /// stay what they are.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!((Real::scaled(0.75_f32, 4), Real::scaled(1.0_f32, 200)), (12.0, f32::INFINITY));
    /// ```
    fn scaled(self, exponent: i32) -> Self;
    /// e with 2ᵉ ≤ |x| < 2ᵉ⁺¹, subnormal x included; a large number without meaning for 0, ±∞ and NaN.
    ///
    /// ```
    /// use bellfit::kernel::real::Real;
    /// assert_eq!((Real::exponent(-12.0_f64), Real::exponent(1e-45_f32)), (3, -149));
    /// ```
    fn exponent(self) -> i32;
    /// eˣ.
    fn exp(self) -> Self;
    /// 2ˣ.
    fn exp2(self) -> Self;
    /// eˣ - 1, without the cancellation of the difference.
    fn expm1(self) -> Self;
    /// Natural logarithm; -∞ at 0, NaN below.
    fn log(self) -> Self;
    /// Logarithm to the base 2; -∞ at 0, NaN below.
    fn log2(self) -> Self;
    /// ln(1 + x), without the cancellation of the sum; -∞ at -1, NaN below.
    fn log1p(self) -> Self;
    /// xʸ as in IEEE 754: x⁰ = 1 and 1ʸ = 1 even where the other argument is NaN.
    fn pow(self, exponent: Self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// Whether x is NaN.
    fn is_nan(self) -> bool;
    /// Whether x is neither NaN nor infinite.
    fn is_finite(self) -> bool;

    /// The larger of the two; NaN if either is, unlike the inherent `max`, which drops a NaN and would
    /// turn a broken dot product into a plausible 0.
    #[inline]
    fn max(self, other: Self) -> Self {
        if self >= other || self.is_nan() { self } else { other }
    }

    /// The smaller of the two; NaN if either is, unlike the inherent `min`.
    #[inline]
    fn min(self, other: Self) -> Self {
        if self <= other || self.is_nan() { self } else { other }
    }
}

macro_rules! real {
    ($float:ident, $($method:ident = $libm:ident),+; $($pair:ident = $of_two:ident),+; $scalbn:ident, $ilogb:ident, $cross:ident) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const PI: Self = core::$float::consts::PI;
            const NAN: Self = $float::NAN;
            const INFINITY: Self = $float::INFINITY;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $float
            }
            #[inline]
            fn from_u32(value: u32) -> Self {
                value as $float
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
            $(
                #[inline]
                fn $method(self) -> Self {
                    libm::$libm(self)
                }
            )+
            $(
                #[inline]
                fn $pair(self, other: Self) -> Self {
                    libm::$of_two(self, other)
                }
            )+
            #[inline]
            fn cross(a: Self, b: Self, c: Self, d: Self) -> Self {
                $cross(a, b, c, d)
            }
            #[inline]
            fn scaled(self, exponent: i32) -> Self {
                libm::$scalbn(self, exponent)
            }
            #[inline]
            fn exponent(self) -> i32 {
                libm::$ilogb(self)
            }
            #[inline]
            fn is_nan(self) -> bool {
                $float::is_nan(self)
            }
            #[inline]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
        }
    };
}

/// The products of two 24-bit significands fit into 53.
#[inline]
fn cross_f32(a: f32, b: f32, c: f32, d: f32) -> f32 {
    (f64::from(a) * f64::from(d) - f64::from(b) * f64::from(c)) as f32
}

/// Kahan's difference of products: the rounding of b c is found by a fused multiply-add and taken back.
#[inline]
fn cross_f64(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = b * c;
    let lost = libm::fma(-b, c, product);
    libm::fma(a, d, -product) + lost
}

real!(f32, sqrt = sqrtf, cbrt = cbrtf, sin = sinf, cos = cosf, asin = asinf, exp = expf, exp2 = exp2f,
    expm1 = expm1f, log = logf, log2 = log2f, log1p = log1pf, abs = fabsf, erf = erff, erfc = erfcf; pow = powf, atan2 = atan2f, hypot = hypotf;
    scalbnf, ilogbf, cross_f32);
real!(f64, sqrt = sqrt, cbrt = cbrt, sin = sin, cos = cos, asin = asin, exp = exp, exp2 = exp2,
    expm1 = expm1, log = log, log2 = log2, log1p = log1p, abs = fabs, erf = erf, erfc = erfc; pow = pow, atan2 = atan2, hypot = hypot;
    scalbn, ilogb, cross_f64);
