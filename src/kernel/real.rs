//! The two floating-point types that every kernel is written for.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// `f32` or `f64`, with the elementary functions of `libm`; sealed, as the stated behaviour at NaN and
/// infinities is checked for these two only.
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
    /// The angle of (x, y) = (`other`, `self`) from the x axis, in (-π, π]; 0 at the origin.
    fn atan2(self, other: Self) -> Self;
    /// √(x² + y²) without overflow or underflow of the squares; +∞ if either is infinite.
    fn hypot(self, other: Self) -> Self;
    /// Complementary error function, 2/√π ∫ₓ^∞ e^(-t²) dt.
    fn erfc(self) -> Self;
    /// a d - b c, accurate even where the products nearly cancel: to 1.5 u of the result for `f64` (Kahan's
    /// algorithm) and correctly rounded but for a second rounding for `f32` (in double precision, where
    /// the products are exact), as long as no product leaves the type's range.
    fn cross(a: Self, b: Self, c: Self, d: Self) -> Self;
    /// x 2ᵉ, exact unless it leaves the type's range.
    fn scaled(self, exponent: i32) -> Self;
    /// e with 2ᵉ ≤ |x| < 2ᵉ⁺¹; without meaning for 0 and non-finite x.
    fn exponent(self) -> i32;
    /// eˣ.
    fn exp(self) -> Self;
    /// 2ˣ.
    fn exp2(self) -> Self;
    /// eˣ - 1, without the cancellation of the difference.
    fn expm1(self) -> Self;
    /// Natural logarithm; -∞ at 0, NaN below.
    fn log(self) -> Self;
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
    expm1 = expm1f, log = logf, log1p = log1pf, abs = fabsf, erfc = erfcf; pow = powf, atan2 = atan2f, hypot = hypotf;
    scalbnf, ilogbf, cross_f32);
real!(f64, sqrt = sqrt, cbrt = cbrt, sin = sin, cos = cos, asin = asin, exp = exp, exp2 = exp2,
    expm1 = expm1, log = log, log1p = log1p, abs = fabs, erfc = erfc; pow = pow, atan2 = atan2, hypot = hypot;
    scalbn, ilogb, cross_f64);
