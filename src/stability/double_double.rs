//! Numbers of two doubles, about 106 bits: what rounding is measured against.

use crate::kernel::real::Real;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::LazyLock;

/// hi + lo, hi the double nearest to the sum.
///
/// Sums, products and quotients keep a relative error below 2⁻¹⁰², as long as no product of two doubles leaves
/// 10⁻²⁹⁰ to 10²⁹⁰ (T. J. Dekker, Numerische Mathematik 18, 1971; M. Joldes, J.-M. Muller, V. Popescu, ACM TOMS
/// 44(2), 2017); the elementary functions as their pages say, from series over these, with nothing from a
/// platform: the same bits everywhere.
///
/// ```
/// use bellfit::stability::DoubleDouble;
/// let third = DoubleDouble::from(1.0) / DoubleDouble::from(3.0);
/// let error = DoubleDouble::from(3.0) * third - DoubleDouble::from(1.0);
/// assert!(error.to_f64().abs() < 1e-31);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

/// a + b and what its rounding lost.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// The same for |a| ≥ |b|, or a = 0.
fn fast_two_sum(a: f64, b: f64) -> DoubleDouble {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// a b and what its rounding lost, by halves of 26 bits.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let high = 134_217_729.0 * x; // 2²⁷ + 1
        let high = high - (high - x);
        (high, x - high)
    };
    let (product, (ah, al), (bh, bl)) = (a * b, split(a), split(b));
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

impl From<f64> for DoubleDouble {
    fn from(hi: f64) -> Self {
        DoubleDouble { hi, lo: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (hi, lo) = two_sum(self.hi, other.hi);
        let (small, rest) = two_sum(self.lo, other.lo);
        let first = fast_two_sum(hi, lo + small);
        fast_two_sum(first.hi, first.lo + rest)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (hi, lo) = two_product(self.hi, other.hi);
        fast_two_sum(hi, lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * Self::from(first);
        let second = rest.hi / other.hi;
        let third = (rest - other * Self::from(second)).hi / other.hi;
        fast_two_sum(first, second) + Self::from(third)
    }
}

/// Terms of the series of eˣ and sin x for |x| ≤ 1: 1/28! < 2⁻⁹⁷ and x falls below ⅛ first for eˣ.
const TERMS: u32 = 28;

static PI: LazyLock<DoubleDouble> = LazyLock::new(|| {
    // Machin: π = 16 arctan(1/5) - 4 arctan(1/239)
    let arctan = |k: f64| {
        let inverse = DoubleDouble::from(1.0) / DoubleDouble::from(k);
        let square = inverse * inverse;
        let term = |j: u32| DoubleDouble::from(1.0) / DoubleDouble::from(f64::from(2 * j + 1));
        inverse * (0..25).rev().fold(DoubleDouble::from(0.0), |sum, j| term(j) - square * sum)
    };
    DoubleDouble::from(16.0) * arctan(5.0) - DoubleDouble::from(4.0) * arctan(239.0)
});

impl DoubleDouble {
    /// a/b of whole numbers, for constants.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// assert_eq!(DoubleDouble::ratio(1, 4).to_f64(), 0.25);
    /// ```
    pub fn ratio(a: i32, b: i32) -> Self {
        Self::from(f64::from(a)) / Self::from(f64::from(b))
    }

    /// π.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// assert_eq!(DoubleDouble::pi().to_f64(), std::f64::consts::PI);
    /// ```
    pub fn pi() -> Self {
        *PI
    }

    /// The nearest double.
    pub fn to_f64(self) -> f64 {
        self.hi
    }

    /// hi and lo.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// assert_eq!(DoubleDouble::from(2.0).parts(), (2.0, 0.0));
    /// ```
    pub fn parts(self) -> (f64, f64) {
        (self.hi, self.lo)
    }

    /// The number of another format nearest to it, rounded once.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// // Half way between two floats but for the last of 106 bits.
    /// let x = DoubleDouble::from(1.0 + libm::exp2(-24.0)) + DoubleDouble::from(libm::exp2(-90.0));
    /// assert_eq!(x.round::<f32>(), 1.0 + f32::EPSILON);
    /// ```
    pub fn round<F: Real>(self) -> F {
        let near = F::from_f64(self.hi);
        if self.lo == 0.0 || near.to_f64() == self.hi || self.hi.to_bits() & 1 == 1 {
            return near;
        }
        // Rounded to odd first, so that what looks half way falls to the right side.
        let towards = if (self.lo > 0.0) == (self.hi > 0.0) { 1 } else { u64::MAX };
        F::from_f64(f64::from_bits(self.hi.to_bits().wrapping_add(towards)))
    }

    /// |x|.
    pub fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    /// √x for x ≥ 0: one Newton step from the double's root, relative error below 2⁻¹⁰⁰.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// let root = DoubleDouble::from(2.0).sqrt();
    /// assert!((root * root - DoubleDouble::from(2.0)).to_f64().abs() < 1e-31);
    /// ```
    pub fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        let root = Self::from(libm::sqrt(self.hi));
        root + (self - root * root) / (root + root)
    }

    /// x to the power 2ᵏ, by k squarings.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// assert_eq!(DoubleDouble::from(3.0).squared(2).to_f64(), 81.0);
    /// ```
    pub fn squared(self, times: u32) -> Self {
        (0..times).fold(self, |power, _| power * power)
    }

    /// eˣ for x ≤ 700: relative error below 2⁻¹⁰⁰ (1 + |x|) 8; 0 below -660, where it is under 10⁻²⁸⁶.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// let one = DoubleDouble::from(5.0).exp() * DoubleDouble::from(-5.0).exp();
    /// assert!((one - DoubleDouble::from(1.0)).to_f64().abs() < 1e-28);
    /// ```
    pub fn exp(self) -> Self {
        if self.hi < -660.0 || self.hi.is_nan() {
            return Self::from(if self.hi.is_nan() { f64::NAN } else { 0.0 });
        }
        // Halved until it is at most ⅛, which is exact.
        let halvings = (self.hi.exponent() + 4).max(0) as u32;
        let scale = Real::scaled(1.0_f64, -(halvings as i32));
        let small = DoubleDouble { hi: self.hi * scale, lo: self.lo * scale };
        (Self::from(1.0) + small.exp_less_one()).squared(halvings)
    }

    /// eˣ - 1 for |x| ≤ ½ by its series, relative error below 2⁻⁹⁸.
    fn exp_less_one(self) -> Self {
        let one = Self::from(1.0);
        let sum = (2..=TERMS).rev().fold(one, |sum, k| one + self * sum / Self::from(f64::from(k)));
        self * sum
    }

    /// ln(1 - x) for x < 1: relative error below 2⁻⁹⁶ for |x| ≤ 0.375, absolute error below 2⁻⁹⁶/(1 - x) beyond.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// let half = DoubleDouble::from(0.5).log_one_minus(); // -ln 2
    /// assert_eq!(half.to_f64(), -std::f64::consts::LN_2);
    /// ```
    pub fn log_one_minus(self) -> Self {
        let one = Self::from(1.0);
        // r = (1 - x) e^-start - 1, as small as the start's error.
        let (start, rest) = if self.hi.abs() <= 0.375 {
            let start = Self::from(libm::log1p(-self.hi));
            let e = (-start).exp_less_one();
            (start, e - self - self * e)
        } else {
            // 1 - x first: near 1 the double next to x is another number.
            let start = Self::from(libm::log((one - self).hi));
            (start, (one - self) * (-start).exp() - one)
        };
        start + rest - rest * rest * Self::from(0.5)
    }

    /// sin x for |x| ≤ 1 by its series, relative error below 2⁻⁹⁸.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// let sixth = DoubleDouble::pi() / DoubleDouble::from(6.0);
    /// assert!((sixth.sin() - DoubleDouble::from(0.5)).to_f64().abs() < 1e-31);
    /// ```
    pub fn sin(self) -> Self {
        let (one, square) = (Self::from(1.0), self * self);
        let step = |sum, k: u32| one - square * sum / Self::from(f64::from(2 * k * (2 * k + 1)));
        self * (1..=TERMS / 2).rev().fold(one, step)
    }

    /// erf x for 0 ≤ x ≤ 4, from 2/√π x e^(-x²) Σ (2 x²)ᵏ/(1·3·5⋯(2k + 1)), all terms positive: relative error
    /// below 2⁻⁹⁴.
    ///
    /// ```
    /// use bellfit::stability::DoubleDouble;
    /// assert!((DoubleDouble::from(0.5).erf().to_f64() - libm::erf(0.5)).abs() < 2e-16);
    /// ```
    pub fn erf(self) -> Self {
        let square = self * self;
        let twice = square + square;
        // (2·16)ᵏ over the odd numbers falls below 2⁻¹¹⁰ before the 140th term.
        let sum = (1..140).rev().fold(Self::from(1.0), |sum, k: u32| {
            Self::from(1.0) + twice * sum / Self::from(f64::from(2 * k + 1))
        });
        Self::from(2.0) / Self::pi().sqrt() * self * (-square).exp() * sum
    }
}
