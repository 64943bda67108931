//! Fixed-point intervals with 128 fractional bits: for the few numbers that end so close to a
//! printed tie that doubles cannot tell the side.

use super::{Interval, elementary::versine_series};
use crate::integral::{Edge, Field};
use core::ops::{Add, Div, Mul, Sub};
use dashu_int::{IBig, ops::DivEuclid, ops::SquareRoot};
use dashu_ratio::RBig;

const BITS: usize = 128;
/// 2.6^20/42! < 2^-142: below the last bit of a versine series.
const VERSINE_TERMS: i64 = 20;

/// [lo, hi] · 2^-128.
///
/// ```
/// use bellfit::{bound::Fixed, integral::Field};
/// let third = Fixed::int(1) / Fixed::int(3);
/// let one = third.clone() + third.clone() + third;
/// assert!(one.to_interval().contains(1.0) && one.to_interval().width() < 1e-15);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Fixed {
    lo: IBig,
    hi: IBig,
}

fn floor_div(a: IBig, b: &IBig) -> IBig {
    // Euclidean division rounds down for positive divisors.
    if *b > IBig::ZERO { a.div_euclid(b) } else { (-a).div_euclid(-b) }
}

fn ceil_div(a: IBig, b: &IBig) -> IBig {
    -floor_div(-a, b)
}

impl Fixed {
    /// The smallest such interval around an exact number.
    pub fn rational(value: &RBig) -> Self {
        let scaled = value.numerator() << BITS;
        let denominator = IBig::from(value.denominator().clone());
        Fixed { lo: floor_div(scaled.clone(), &denominator), hi: ceil_div(scaled, &denominator) }
    }

    /// Both ends, exactly.
    pub fn ends(&self) -> (RBig, RBig) {
        let scale = IBig::ONE << BITS;
        let end = |v: &IBig| RBig::from(v.clone()) / RBig::from(scale.clone());
        (end(&self.lo), end(&self.hi))
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Self) -> Self {
        Fixed { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The same interval in doubles, rounded outward.
    pub fn to_interval(&self) -> Interval {
        let (lo, hi) = self.ends();
        super::enclose(&lo).hull(super::enclose(&hi))
    }

    fn least_and_most(candidates: [IBig; 4]) -> (IBig, IBig) {
        let [first, rest @ ..] = candidates;
        let (mut lo, mut hi) = (first.clone(), first);
        for c in rest {
            if c < lo {
                lo = c;
            } else if c > hi {
                hi = c;
            }
        }
        (lo, hi)
    }
}

impl Add for Fixed {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Fixed { lo: self.lo + rhs.lo, hi: self.hi + rhs.hi }
    }
}

impl Sub for Fixed {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Fixed { lo: self.lo - rhs.hi, hi: self.hi - rhs.lo }
    }
}

impl Mul for Fixed {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        let (lo, hi) = if self.lo >= IBig::ZERO && rhs.lo >= IBig::ZERO {
            (self.lo * rhs.lo, self.hi * rhs.hi) // the common case, at half the price
        } else {
            Self::least_and_most([
                &self.lo * &rhs.lo,
                &self.lo * &rhs.hi,
                &self.hi * &rhs.lo,
                &self.hi * &rhs.hi,
            ])
        };
        // Shifting right rounds down; up is down of the negative.
        Fixed { lo: lo >> BITS, hi: -((-hi) >> BITS) }
    }
}

impl Div for Fixed {
    type Output = Self;
    /// # Panics
    /// If the divisor contains 0: the closed forms divide by positive numbers only.
    fn div(self, rhs: Self) -> Self {
        assert!(rhs.lo > IBig::ZERO || rhs.hi < IBig::ZERO, "division by an interval around 0");
        if self.lo >= IBig::ZERO && rhs.lo > IBig::ZERO {
            return Fixed { lo: floor_div(self.lo << BITS, &rhs.hi), hi: ceil_div(self.hi << BITS, &rhs.lo) };
        }
        let ends = [(&self.lo, &rhs.lo), (&self.lo, &rhs.hi), (&self.hi, &rhs.lo), (&self.hi, &rhs.hi)];
        let (lo, _) = Self::least_and_most(ends.map(|(a, b)| floor_div(a << BITS, b)));
        let (_, hi) = Self::least_and_most(ends.map(|(a, b)| ceil_div(a << BITS, b)));
        Fixed { lo, hi }
    }
}

impl Field for Fixed {
    fn int(value: i64) -> Self {
        let exact = IBig::from(value) << BITS;
        Fixed { lo: exact.clone(), hi: exact }
    }
}

impl Edge for Fixed {
    fn between(lo: f64, hi: f64) -> Self {
        let end = |x: f64| super::exact(x).map_or_else(|| Self::int(0), |r| Fixed::rational(&r));
        Fixed { lo: end(lo).lo, hi: end(hi).hi }
    }

    fn sqrt(&self) -> Self {
        // √(v 2^-128) = √(v 2^128) 2^-128; the integer root rounds down.
        let root = |v: &IBig| {
            let clamped = if *v < IBig::ZERO { IBig::ZERO } else { v.clone() };
            IBig::from((clamped << BITS).into_parts().1.sqrt())
        };
        Fixed { lo: root(&self.lo), hi: root(&self.hi) + IBig::ONE }
    }

    fn versine_ratio(&self) -> Self {
        let sum = versine_series(self, VERSINE_TERMS);
        Fixed { lo: sum.lo - IBig::ONE, hi: sum.hi + IBig::ONE }
    }

    fn half_power(&self) -> Self {
        // Only cosⁿ needs it, and its fits never come near a tie: the doubles' enclosure serves.
        let coarse = self.to_interval().half_power();
        Self::between(coarse.lo(), coarse.hi())
    }

    fn min(&self, other: &Self) -> Self {
        Fixed { lo: (&self.lo).min(&other.lo).clone(), hi: (&self.hi).min(&other.hi).clone() }
    }

    fn half_pi_squared() -> Self {
        // Machin: π/4 = 4 arctan(1/5) - arctan(1/239).
        let quarter = Self::int(4) * arctan_inverse(5) - arctan_inverse(239);
        let half = Self::int(2) * quarter;
        half.clone() * half
    }
}

/// arctan(1/k) = Σ (-1)^j/((2j+1) k^(2j+1)), alternating and falling.
fn arctan_inverse(k: i64) -> Fixed {
    let square = Fixed::int(k * k);
    let mut power = Fixed::int(1) / Fixed::int(k);
    let mut sum = Fixed::int(0);
    let mut j = 0;
    loop {
        let term = power.clone() / Fixed::int(2 * j + 1);
        if term.hi <= IBig::ONE {
            return Fixed { lo: sum.lo - IBig::ONE, hi: sum.hi + IBig::ONE };
        }
        sum = if j % 2 == 0 { sum + term } else { sum - term };
        power = power / square.clone();
        j += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_and_right_angles_close_on_themselves() {
        let two = Fixed::int(2);
        let square = two.sqrt().power(2);
        let (lo, hi) = square.ends();
        assert!(lo <= RBig::int(2) && RBig::int(2) <= hi);
        // cos(π/2) = 0, so y versine_ratio(y) = 1 at y = π²/4, to within a few of 128 bits.
        let y = Fixed::half_pi_squared();
        let (lo, hi) = (y.clone() * y.versine_ratio()).ends();
        assert!(lo <= RBig::int(1) && RBig::int(1) <= hi);
        assert!(hi - lo < super::super::power_of_ten(-35));
    }

    #[test]
    fn signs_round_outward() {
        let third = Fixed::int(-1) / Fixed::int(3);
        let (lo, hi) = third.ends();
        let exact = RBig::int(-1) / RBig::int(3);
        assert!(lo < exact && exact < hi);
        let ninth = third.clone() * third.clone();
        let (lo, hi) = ninth.ends();
        assert!(lo < RBig::int(1) / RBig::int(9) && RBig::int(1) / RBig::int(9) < hi);
        assert!((third * Fixed::int(1)).to_interval().contains(-1.0 / 3.0));
    }

    #[test]
    fn products_of_either_sign_hold_their_extremes() {
        let of = |lo, hi| Fixed::int(lo).hull(Fixed::int(hi));
        for (a, b, product) in [
            (of(-1, 2), of(3, 5), of(-5, 10)),
            (of(3, 5), of(-1, 2), of(-5, 10)),
            (of(-1, 2), of(-3, 1), of(-6, 3)),
            (of(-3, -2), of(-5, -4), of(8, 15)),
            (of(2, 3), of(4, 5), of(8, 15)),
            (of(0, 2), of(0, 5), of(0, 10)),
        ] {
            assert_eq!(a * b, product);
        }
    }
}
