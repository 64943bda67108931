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

    fn ulps(x: &Fixed) -> RBig {
        let (lo, hi) = x.ends();
        (hi - lo) * (0..128).fold(RBig::int(1), |p, _| p * RBig::int(2))
    }

    /// 2 (π/2)² and its root from π's printed digits: 3.14159265358979323846264338327950288419716939937510… (D. H.
    /// Bailey, J. M. Borwein, "Pi: The Next Generation", 2016, and any table).
    #[test]
    fn a_right_angle_has_the_digits_of_pi() {
        let digits = super::super::decimal("3.1415926535897932384626433832795028841971693993751").unwrap().0;
        let next = digits.clone() + super::super::power_of_ten(-48);
        let before = digits - super::super::power_of_ten(-48);
        let four = RBig::int(4);
        let (lo, hi) = Fixed::half_pi_squared().ends();
        assert!(lo < next.clone() * next / four.clone() && before.clone() * before / four < hi);
        // A few hundred units of 2⁻¹²⁸ from two series of fifty terms, times 16 and squared.
        assert!(ulps(&Fixed::half_pi_squared()) < RBig::int(10_000));
    }

    /// Between two neighbouring partial sums, exactly.
    #[test]
    fn arcs_lie_between_their_partial_sums() {
        for k in [2_i64, 5, 18, 239, 1 << 20] {
            let mut sums = [RBig::int(0), RBig::int(0)];
            let mut power = RBig::int(1) / RBig::int(k);
            for j in 0..90 {
                let term = power.clone() / RBig::int(2 * j + 1);
                let next = if j % 2 == 0 { sums[1].clone() + term } else { sums[1].clone() - term };
                sums = [sums[1].clone(), next];
                power /= RBig::int(k * k);
            }
            let (low, high) = (sums[1].clone(), sums[0].clone());
            let found = arctan_inverse(k);
            let (lo, hi) = found.ends();
            assert!(lo <= low && high <= hi, "{k}");
            // Two roundings a term, and one for the rest on either side.
            assert!(ulps(&found) <= RBig::int(4 * 70 + 2), "{k}: {}", ulps(&found));
        }
    }

    #[test]
    fn roots_round_outward_by_one_unit() {
        for k in [0_i64, 1, 2, 3, 4, 10, 1000] {
            let (lo, hi) = Fixed::int(k).sqrt().ends();
            let exact = RBig::int(k);
            assert!(lo.clone() * lo <= exact && exact < hi.clone() * hi, "{k}");
            assert_eq!(ulps(&Fixed::int(k).sqrt()), RBig::int(1));
        }
        let negative = Fixed::int(-4).hull(Fixed::int(9)).sqrt().ends();
        assert!(negative.0 == RBig::int(0) && negative.1 > RBig::int(3));
    }

    #[test]
    fn quotients_of_either_sign_hold_their_extremes() {
        let of = |lo, hi| Fixed::int(lo).hull(Fixed::int(hi));
        for (a, b, lo, hi) in [
            ((1, 2), (3, 7), (1, 7), (2, 3)),
            ((-1, 2), (3, 7), (-1, 3), (2, 3)),
            ((-2, -1), (3, 7), (-2, 3), (-1, 7)),
            ((1, 2), (-7, -3), (-2, 3), (-1, 7)),
            ((-2, -1), (-7, -3), (1, 7), (2, 3)),
            ((-1, 2), (-7, -3), (-2, 3), (1, 3)),
            ((0, 2), (3, 7), (0, 1), (2, 3)),
        ] {
            let found = of(a.0, a.1) / of(b.0, b.1);
            let ends = found.ends();
            let exact = [lo, hi].map(|(p, q)| RBig::int(p) / RBig::int(q));
            let unit = RBig::int(1) / (0..128).fold(RBig::int(1), |p, _| p * RBig::int(2));
            assert!(ends.0 <= exact[0] && exact[0] < ends.0 + unit.clone(), "{a:?} {b:?}");
            assert!(ends.1 >= exact[1] && exact[1] > ends.1 - unit, "{a:?} {b:?}");
        }
        // Products that do not end at a unit go outward as well.
        let third = Fixed::int(1) / Fixed::int(3);
        for (a, b, exact) in [(&third, &third, (1, 9)), (&third, &(Fixed::int(-1) / Fixed::int(3)), (-1, 9))]
        {
            let product = a.clone() * b.clone();
            let (lo, hi) = product.ends();
            let exact = RBig::int(exact.0) / RBig::int(exact.1);
            assert!(lo < exact && exact < hi && ulps(&product) <= RBig::int(3));
        }
        assert!(std::panic::catch_unwind(|| Fixed::int(1) / Fixed::int(0)).is_err());
        assert!(std::panic::catch_unwind(|| Fixed::int(1) / (Fixed::int(-1).hull(Fixed::int(0)))).is_err());
    }

    #[test]
    fn numbers_in_doubles_and_back() {
        let third = Fixed::rational(&(RBig::int(1) / RBig::int(3)));
        assert_eq!((ulps(&third), ulps(&Fixed::rational(&RBig::int(-5)))), (RBig::int(1), RBig::int(0)));
        let (lo, hi) = Fixed::rational(&(RBig::int(-1) / RBig::int(3))).ends();
        assert!(lo < RBig::int(-1) / RBig::int(3) && RBig::int(-1) / RBig::int(3) < hi);
        assert_eq!(Fixed::between(-0.5, 2.25).to_interval(), Interval::new(-0.5, 2.25));
        assert_eq!(Fixed::int(2).min(&Fixed::int(3)), Fixed::int(2));
        assert_eq!(Fixed::int(4) - Fixed::int(1).hull(Fixed::int(3)), Fixed::int(1).hull(Fixed::int(3)));
        assert_eq!(Fixed::int(4) + Fixed::int(1).hull(Fixed::int(3)), Fixed::int(5).hull(Fixed::int(7)));
        // 2^(-1/(2/4)) = 1/4 at m = 1/4, in doubles.
        let power = Fixed::rational(&(RBig::int(1) / RBig::int(4))).half_power().to_interval();
        assert!(power.contains(0.25) && power.width() < 1e-15);
        // (1 - cos √y)/y at y = (π/3)²: 1/2 over it, to twenty terms' roundings.
        let y = Fixed::half_pi_squared() * Fixed::int(4) / Fixed::int(9);
        let product = y.clone() * y.versine_ratio();
        let (lo, hi) = product.ends();
        let half = RBig::int(1) / RBig::int(2);
        assert!(lo <= half && half <= hi && ulps(&product) < RBig::int(10_000));
    }
}
