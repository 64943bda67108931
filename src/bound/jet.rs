//! A value with its derivative, both enclosed: what turns first-order interval bounds into
//! second-order ones.

use super::{Interval, elementary::versine_ratio_slope};
use crate::integral::{Edge, Field};
use core::ops::{Add, Div, Mul, Sub};

/// Enclosures of f(x) and f'(x) for every x of an interval.
///
/// ```
/// use bellfit::bound::{Interval, Jet};
/// let x = Jet::variable(Interval::new(2.0, 3.0));
/// let square = x * x;
/// assert!(square.slope.contains(4.0) && square.slope.contains(6.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// f over the interval.
    pub value: Interval,
    /// f' over the interval.
    pub slope: Interval,
}

impl Jet {
    /// The identity: slope 1.
    pub fn variable(x: Interval) -> Self {
        Jet { value: x, slope: Interval::from(1.0) }
    }

    /// e to the power of this.
    pub fn exp(self) -> Self {
        let value = self.value.exp();
        Jet { value, slope: value * self.slope }
    }

    /// A number that does not depend on the variable.
    pub fn constant(value: Interval) -> Self {
        Jet { value, slope: Interval::from(0.0) }
    }
}

/// The range of f over `x` from f's jets: natural extension, mean value form, and the ends
/// alone where the slope keeps its sign.
///
/// The mean value form holds for the continuous, piecewise smooth functions of this crate as
/// well, with the slope enclosing both one-sided derivatives.
pub fn range(f: impl Fn(Jet) -> Jet, x: Interval) -> Interval {
    let over = f(Jet::variable(x));
    if x.lo() == x.hi() {
        return over.value;
    }
    let at = |point: f64| f(Jet::constant(Interval::from(point))).value;
    if over.slope.lo() >= 0.0 {
        return over.value.intersect(Interval::new(at(x.lo()).lo(), at(x.hi()).hi()));
    }
    if over.slope.hi() <= 0.0 {
        return over.value.intersect(Interval::new(at(x.hi()).lo(), at(x.lo()).hi()));
    }
    let mid = x.mid();
    let mean = at(mid) + over.slope * (x - Interval::from(mid));
    over.value.intersect(mean)
}

impl Add for Jet {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Jet { value: self.value + rhs.value, slope: self.slope + rhs.slope }
    }
}

impl Sub for Jet {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Jet { value: self.value - rhs.value, slope: self.slope - rhs.slope }
    }
}

impl Mul for Jet {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Jet { value: self.value * rhs.value, slope: self.slope * rhs.value + self.value * rhs.slope }
    }
}

impl Div for Jet {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        let value = self.value / rhs.value;
        Jet { value, slope: (self.slope - value * rhs.slope) / rhs.value }
    }
}

impl Field for Jet {
    fn int(value: i64) -> Self {
        Jet::constant(Interval::int(value))
    }

    fn power(&self, k: u32) -> Self {
        if k == 0 {
            return Self::int(1);
        }
        let slope = Interval::int(i64::from(k)) * self.value.power(k - 1) * self.slope;
        Jet { value: self.value.power(k), slope }
    }
}

impl Edge for Jet {
    fn between(lo: f64, hi: f64) -> Self {
        Jet::constant(Interval::new(lo, hi))
    }

    fn sqrt(&self) -> Self {
        let value = self.value.square_root();
        Jet { value, slope: self.slope / (Interval::from(2.0) * value) }
    }

    fn versine_ratio(&self) -> Self {
        Jet { value: self.value.versine_ratio(), slope: versine_ratio_slope(self.value) * self.slope }
    }

    fn half_power(&self) -> Self {
        // d/dm 2^(-1/(2m)) = 2^(-1/(2m)) ln 2/(2 m²)
        let value = self.value.half_power();
        let slope = if self.value.lo() > 0.0 {
            value * Interval::LN_2 / (Interval::from(2.0) * self.value.power(2))
        } else {
            Interval::new(0.0, 1.5625) // its top, 8/(e² ln 2) = 1.5620 at m = ln 2/4
        };
        Jet { value, slope: slope * self.slope }
    }

    fn min(&self, other: &Self) -> Self {
        if self.value.hi() <= other.value.lo() {
            *self
        } else if other.value.hi() <= self.value.lo() {
            *other
        } else {
            Jet { value: self.value.least(other.value), slope: self.slope.hull(other.slope) }
        }
    }

    fn half_pi_squared() -> Self {
        Jet::constant(Interval::half_pi_squared())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rational function with a square root, and difference quotients as the oracle: by the
    /// mean value theorem each lies in the slope's enclosure.
    #[test]
    fn slopes_contain_difference_quotients() {
        let f = |x: Jet| (x.power(3) - Jet::int(2) * x) / (Jet::int(1) + x * x).sqrt() + x.versine_ratio();
        for i in 0..20 {
            let x = Interval::new(0.1 * f64::from(i), 0.1 * f64::from(i + 1));
            let slope = f(Jet::variable(x)).slope;
            let at = |p: f64| f(Jet::constant(Interval::from(p))).value;
            let quotient = (at(x.hi()) - at(x.lo())) / (Interval::from(x.hi()) - Interval::from(x.lo()));
            assert!(!slope.is_disjoint(quotient), "{x:?}: {slope:?} {quotient:?}");
            let whole = range(f, x);
            for k in 0..=10 {
                let p = x.lo() + (x.hi() - x.lo()) * f64::from(k) / 10.0;
                assert!(!whole.is_disjoint(at(p)));
            }
        }
    }

    #[test]
    fn half_powers_differentiate() {
        let m = Interval::new(0.03, 0.0301);
        let slope = Jet::variable(m).half_power().slope;
        let quotient = (Interval::from(m.hi()).half_power() - Interval::from(m.lo()).half_power())
            / (Interval::from(m.hi()) - Interval::from(m.lo()));
        assert!(!slope.is_disjoint(quotient));
        // The enclosure must be worth something: within a tenth.
        assert!(slope.width() < 0.2 * slope.hi());
        let top = Jet::variable(Interval::from(core::f64::consts::LN_2 / 4.0)).half_power().slope;
        let from_zero = Jet::variable(Interval::new(0.0, 1.0)).half_power().slope;
        assert!(from_zero.hi() > top.hi() && from_zero.hi() < 1.001 * top.hi());
    }

    /// Which of two is the smaller decides whose slope it has, and where that is open it may be either's.
    #[test]
    fn the_smaller_brings_its_slope() {
        let jet = |lo, hi, slope| Jet { value: Interval::new(lo, hi), slope: Interval::from(slope) };
        let (low, high) = (jet(1.0, 2.0, -1.0), jet(2.0, 3.0, 5.0));
        assert_eq!((low.min(&high), high.min(&low)), (low, low));
        let both = jet(0.0, 3.0, 5.0).min(&low);
        assert_eq!((both.value, both.slope), (Interval::new(0.0, 2.0), Interval::new(-1.0, 5.0)));
    }
}
