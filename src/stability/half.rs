//! binary16 as a type in which every kernel runs: each operation rounded to it.

use crate::kernel::real::{Real, sealed::Sealed};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An IEEE 754 binary16 number whose every operation rounds to nearest, ties to even, subnormals kept.
///
/// 11 significant bits, from 2⁻²⁴ to 65504; what rounds beyond is infinite.
///
/// - `+ - × ÷ √` are correctly rounded: in binary32 first, whose 24 bits are the 2·11 + 2 that make the second
///   rounding harmless (S. A. Figueroa, "When is double rounding innocuous?", SIGNUM Newsletter 30(3), 1995).
/// - The elementary functions are those of `libm` in binary64, rounded once more: ½ (1 + 2⁻⁴⁰) units in the
///   last place. A GPU's are worse.
///
/// ```
/// use bellfit::{kernel::{cubic::CubicLobe, real::Real}, stability::Half};
/// let lobe = CubicLobe::<4, f64>::new(64.0).convert::<Half>();
/// let value = lobe.at_versine(Half::from_f64(0.01)).to_f64();
/// assert!((value - libm::pow(0.99, 64.0)).abs() < 4e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half(f32);

/// The largest finite number.
const LARGEST: f32 = 65504.0;

/// x rounded to binary16.
fn nearest_single(x: f32) -> f32 {
    // The exponent, at least that of the smallest normal number: below, the unit stays.
    let exponent = ((x.to_bits() >> 23) & 0xff).max(127 - 14);
    if exponent > 127 + 15 {
        return if x.is_nan() { x } else { f32::INFINITY.copysign(x) };
    }
    // 1.5·2^(e + 13) has the unit 2^(e - 10), to which the sum is rounded.
    let magic = f32::from_bits(((exponent + 13) << 23) | (1 << 22));
    let rounded = (x.abs() + magic) - magic;
    if rounded > LARGEST { f32::INFINITY.copysign(x) } else { rounded.copysign(x) }
}

/// x rounded to binary16, once.
fn nearest_double(x: f64) -> f32 {
    let exponent = ((x.to_bits() >> 52) & 0x7ff).max(1023 - 14);
    if exponent > 1023 + 15 {
        return if x.is_nan() { f32::NAN } else { f32::INFINITY.copysign(x as f32) };
    }
    // 1.5·2^(e + 42) has the unit 2^(e - 10).
    let magic = f64::from_bits(((exponent + 42) << 52) | (1 << 51));
    let rounded = ((x.abs() + magic) - magic) as f32;
    let rounded = if rounded > LARGEST { f32::INFINITY } else { rounded };
    if x.is_sign_negative() { -rounded } else { rounded }
}

impl Half {
    /// The number with these bits: sign, five of exponent, ten of significand.
    ///
    /// ```
    /// use bellfit::{kernel::real::Real, stability::Half};
    /// assert_eq!(Half::from_bits(0x3c01).to_f64(), 1.0 + 1.0 / 1024.0);
    /// assert_eq!(Half::from_bits(0x0001).to_f64(), libm::exp2(-24.0));
    /// assert!(Half::from_bits(0x7c01).is_nan());
    /// ```
    pub fn from_bits(bits: u16) -> Self {
        let (exponent, significand) = (i32::from(bits >> 10) & 31, f32::from(bits & 0x3ff));
        let size = match exponent {
            0 => libm::scalbnf(significand, -24),
            31 if significand == 0.0 => f32::INFINITY,
            31 => f32::NAN,
            _ => libm::scalbnf(1024.0 + significand, exponent - 25),
        };
        Half(if bits >> 15 == 1 { -size } else { size })
    }

    /// The bits; of a NaN those of the quiet one without payload, 0x7e00.
    ///
    /// ```
    /// use bellfit::{kernel::real::Real, stability::Half};
    /// assert_eq!(Half::from_f64(-2.0).to_bits(), 0xc000);
    /// assert_eq!(Half::from_f64(1e5).to_bits(), 0x7c00); // +∞
    /// ```
    pub fn to_bits(self) -> u16 {
        let (sign, size) = (u16::from(self.0.is_sign_negative()) << 15, self.0.abs());
        if size.is_nan() {
            return 0x7e00;
        }
        if size.is_infinite() {
            return sign | 0x7c00;
        }
        // In units of 2⁻²⁴ a subnormal number is its significand.
        let exponent = size.exponent().max(-14);
        let significand = size.scaled(10 - exponent) as u16;
        if significand < 1024 {
            return sign | significand;
        }
        sign | (((exponent + 15) as u16) << 10) | (significand - 1024)
    }
}

impl PartialOrd for Half {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl Neg for Half {
    type Output = Self;
    fn neg(self) -> Self {
        Half(-self.0)
    }
}

macro_rules! operators {
    ($($operator:ident, $method:ident;)+) => {
        $(impl $operator for Half {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Half(nearest_single($operator::$method(self.0, other.0)))
            }
        })+
    };
}
operators!(Add, add; Sub, sub; Mul, mul; Div, div;);

impl Sealed for Half {}

macro_rules! elementary {
    ($($method:ident = $function:path),+; $($pair:ident = $of_two:path),+) => {
        $(
            fn $method(self) -> Self {
                Self::from_f64($function(f64::from(self.0)))
            }
        )+
        $(
            fn $pair(self, other: Self) -> Self {
                Self::from_f64($of_two(f64::from(self.0), f64::from(other.0)))
            }
        )+
    };
}

impl Real for Half {
    const ZERO: Self = Half(0.0);
    const HALF: Self = Half(0.5);
    const ONE: Self = Half(1.0);
    const TWO: Self = Half(2.0);
    const PI: Self = Half(3.140625); // 201/64
    const NAN: Self = Half(f32::NAN);
    const INFINITY: Self = Half(f32::INFINITY);

    fn from_f64(value: f64) -> Self {
        Half(nearest_double(value))
    }
    fn from_u32(value: u32) -> Self {
        Half(nearest_double(f64::from(value)))
    }
    fn to_f64(self) -> f64 {
        f64::from(self.0)
    }
    fn sqrt(self) -> Self {
        Half(nearest_single(libm::sqrtf(self.0)))
    }
    fn abs(self) -> Self {
        Half(self.0.abs())
    }
    fn scaled(self, exponent: i32) -> Self {
        Self::from_f64(libm::scalbn(f64::from(self.0), exponent))
    }
    fn exponent(self) -> i32 {
        libm::ilogbf(self.0)
    }
    fn is_nan(self) -> bool {
        self.0.is_nan()
    }
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
    /// The products are exact in binary64, their difference rounds once there and once to binary16.
    fn cross(a: Self, b: Self, c: Self, d: Self) -> Self {
        let [a, b, c, d] = [a, b, c, d].map(Self::to_f64);
        Self::from_f64(a * d - b * c)
    }
    elementary!(cbrt = libm::cbrt, sin = libm::sin, cos = libm::cos, asin = libm::asin, exp = libm::exp,
        exp2 = libm::exp2, expm1 = libm::expm1, log = libm::log, log2 = libm::log2, log1p = libm::log1p,
        erf = libm::erf, erfc = libm::erfc;
        pow = libm::pow, atan2 = libm::atan2, hypot = libm::hypot);
}
