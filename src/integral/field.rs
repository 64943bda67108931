//! The arithmetic that a closed form asks for, so that one formula serves floats, intervals,
//! derivatives and exact numbers.

use core::ops::{Add, Div, Mul, Sub};

/// The four operations and the integers.
///
/// A closed form written over `Field` is evaluated in `f64` for speed, in
/// [`Interval`](crate::bound::Interval) for a proof and in exact rationals where it is rational.
///
/// ```
/// use bellfit::integral::Field;
/// assert_eq!(3.0_f64.power(4), 81.0);
/// assert_eq!(f64::int(7), 7.0);
/// ```
pub trait Field:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The integer `value`.
    fn int(value: i64) -> Self;

    /// selfᵏ by squaring; self⁰ = 1.
    fn power(&self, k: u32) -> Self {
        let mut result = Self::int(1);
        let mut base = self.clone();
        let mut rest = k;
        while rest > 0 {
            if rest & 1 == 1 {
                result = result * base.clone();
            }
            rest >>= 1;
            if rest > 0 {
                base = base.clone() * base;
            }
        }
        result
    }
}

/// The few functions beyond [`Field`] that the limits of integration need.
pub trait Edge: Field {
    /// A number of which it is known that lo ≤ it ≤ hi; in floating point the middle.
    fn between(lo: f64, hi: f64) -> Self;
    /// √self, self ≥ 0.
    fn sqrt(&self) -> Self;
    /// (1 - cos √y)/y for y = self in [0, π²/4 + rounding]: every trigonometric term of the
    /// closed forms, as a power series without trigonometry.
    fn versine_ratio(&self) -> Self;
    /// 2^(-1/(2m)) for m = self > 0: what cosⁿ is worth at θ/2 = π/4, with m = 1/n.
    fn half_power(&self) -> Self;
    /// The smaller of the two.
    fn min(&self, other: &Self) -> Self;
    /// π²/4, the square of the hemisphere's edge.
    fn half_pi_squared() -> Self;
}

impl Field for f64 {
    fn int(value: i64) -> Self {
        value as f64
    }
}

impl Edge for f64 {
    fn between(lo: f64, hi: f64) -> Self {
        lo + 0.5 * (hi - lo)
    }

    fn sqrt(&self) -> Self {
        libm::sqrt(*self)
    }

    fn versine_ratio(&self) -> Self {
        // 2 sin²(√y/2)/y does not cancel, 1 - cos √y does.
        if *self < 1e-300 {
            return 0.5;
        }
        let s = libm::sin(0.5 * libm::sqrt(*self));
        2.0 * s * s / *self
    }

    fn half_power(&self) -> Self {
        libm::exp2(-0.5 / *self)
    }

    fn min(&self, other: &Self) -> Self {
        f64::min(*self, *other)
    }

    fn half_pi_squared() -> Self {
        core::f64::consts::FRAC_PI_2 * core::f64::consts::FRAC_PI_2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_by_squaring_equal_repeated_products() {
        for k in 0..20 {
            // Powers of 3 are exact in f64 up to 3^33, so equality is exact.
            assert_eq!(3.0_f64.power(k), (0..k).fold(1.0, |p, _| p * 3.0));
        }
    }

    #[test]
    fn versine_ratio_is_its_definition_where_that_does_not_cancel() {
        for y in [0.5, 1.0, 2.0, 2.4] {
            let direct = (1.0 - libm::cos(libm::sqrt(y))) / y;
            // A few roundings of numbers near 1: 8 ε.
            assert!((y.versine_ratio() - direct).abs() < 8.0 * f64::EPSILON);
        }
        assert_eq!(0.0_f64.versine_ratio(), 0.5);
    }
}
