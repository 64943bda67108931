//! Closed intervals of doubles with outward rounding.
//!
//! IEEE addition, subtraction, multiplication, division and square root are correctly rounded, so
//! one step outward with `next_down`/`next_up` encloses the exact result on every machine. All
//! other functions are built from these in [`super::elementary`]; no library function is trusted.

use crate::integral::Field;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The closed interval [lo, hi].
///
/// Every operation returns an interval that contains the exact result for every choice of
/// operands for which it is defined. Division by an interval that contains 0 gives (-∞, ∞), unless 0 is
/// its lower end and nothing is negative: then the quotients end at +∞ only.
///
/// ```
/// use bellfit::bound::Interval;
/// let third = Interval::from(1.0) / Interval::from(3.0);
/// assert!(third.lo() < third.hi());                 // 1/3 is not a double
/// assert!((third * Interval::from(3.0)).contains(1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

fn down(x: f64) -> f64 {
    x.next_down()
}

fn up(x: f64) -> f64 {
    x.next_up()
}

impl From<f64> for Interval {
    /// [x, x]; a NaN gives [`Interval::WHOLE`].
    fn from(x: f64) -> Self {
        if x.is_nan() { Interval::WHOLE } else { Interval { lo: x, hi: x } }
    }
}

impl Interval {
    /// All real numbers.
    pub const WHOLE: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };
    /// 0 alone.
    pub const ZERO: Interval = Interval { lo: 0.0, hi: 0.0 };
    /// π, which lies just above the double of that name.
    pub const PI: Interval = Interval { lo: core::f64::consts::PI, hi: core::f64::consts::PI.next_up() };
    /// ln 2, which lies just above the double of that name.
    pub const LN_2: Interval =
        Interval { lo: core::f64::consts::LN_2, hi: core::f64::consts::LN_2.next_up() };

    /// [lo, hi]. A NaN or a reversed pair gives [`Interval::WHOLE`]: what is not known is not
    /// excluded.
    pub fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi { Interval { lo, hi } } else { Interval::WHOLE }
    }

    /// The lower end.
    pub const fn lo(self) -> f64 {
        self.lo
    }

    /// The upper end.
    pub const fn hi(self) -> f64 {
        self.hi
    }

    /// A double inside, near the middle; of an unbounded interval one of its finite numbers.
    pub fn mid(self) -> f64 {
        let finite = |x: f64| x.clamp(f64::MIN, f64::MAX);
        let (lo, hi) = (finite(self.lo), finite(self.hi));
        // Halved first where the difference overflows.
        let mid = if (hi - lo).is_finite() { lo + 0.5 * (hi - lo) } else { 0.5 * lo + 0.5 * hi };
        mid.clamp(self.lo, self.hi)
    }

    /// hi - lo, rounded up.
    pub fn width(self) -> f64 {
        if self.lo == self.hi { 0.0 } else { up(self.hi - self.lo) }
    }

    /// Whether x lies inside, ends included.
    pub fn contains(self, x: f64) -> bool {
        self.lo <= x && x <= self.hi
    }

    /// Whether `other` lies inside, ends included.
    pub fn encloses(self, other: Interval) -> bool {
        self.lo <= other.lo && other.hi <= self.hi
    }

    /// Whether the two have no point in common.
    pub fn is_disjoint(self, other: Interval) -> bool {
        self.hi < other.lo || other.hi < self.lo
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Interval) -> Self {
        Interval { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The common part of two enclosures of one number; `self` where they have none, which only
    /// happens to enclosures of different numbers.
    pub fn intersect(self, other: Interval) -> Self {
        let (lo, hi) = (self.lo.max(other.lo), self.hi.min(other.hi));
        if lo <= hi { Interval { lo, hi } } else { self }
    }

    /// |self|.
    pub fn abs(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Interval { lo: 0.0, hi: self.hi.max(-self.lo) }
        }
    }

    /// The larger of the two, end by end.
    pub fn max(self, other: Interval) -> Self {
        Interval { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The smaller of the two, end by end.
    pub fn least(self, other: Interval) -> Self {
        Interval { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) }
    }

    /// The square root of the part that is not negative.
    pub fn square_root(self) -> Self {
        let root = |x: f64| libm::sqrt(x.max(0.0));
        Interval { lo: down(root(self.lo)).max(0.0), hi: up(root(self.hi)) }
    }

    /// The halves left and right of the middle.
    pub fn bisect(self) -> (Self, Self) {
        let mid = self.mid();
        (Interval { lo: self.lo, hi: mid }, Interval { lo: mid, hi: self.hi })
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Interval { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Interval {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        // new: ∞ - ∞ is not known.
        Interval::new(down(self.lo + rhs.lo), up(self.hi + rhs.hi))
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        self + -rhs
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        // The common case, without the search for the extreme product; 0 × ∞ fails the test on hi.
        if self.lo >= 0.0 && rhs.lo >= 0.0 && self.hi < f64::INFINITY && rhs.hi < f64::INFINITY {
            return Interval { lo: down(self.lo * rhs.lo), hi: up(self.hi * rhs.hi) };
        }
        let products = [self.lo * rhs.lo, self.lo * rhs.hi, self.hi * rhs.lo, self.hi * rhs.hi];
        if products.iter().any(|p| p.is_nan()) {
            return Interval::WHOLE; // 0 × ∞
        }
        let (mut lo, mut hi) = (products[0], products[0]);
        for p in products {
            lo = lo.min(p);
            hi = hi.max(p);
        }
        Interval { lo: down(lo), hi: up(hi) }
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        if self.lo >= 0.0 && rhs.lo > 0.0 && self.hi < f64::INFINITY && rhs.hi < f64::INFINITY {
            return Interval { lo: down(self.lo / rhs.hi), hi: up(self.hi / rhs.lo) };
        }
        if rhs.contains(0.0) {
            let least = self.lo / rhs.hi.abs();
            let upward = rhs.lo == 0.0 && self.lo >= 0.0 && !least.is_nan();
            return if upward { Interval { lo: down(least), hi: f64::INFINITY } } else { Interval::WHOLE };
        }
        let quotients = [self.lo / rhs.lo, self.lo / rhs.hi, self.hi / rhs.lo, self.hi / rhs.hi];
        if quotients.iter().any(|q| q.is_nan()) {
            return Interval::WHOLE; // ∞ / ∞
        }
        let (mut lo, mut hi) = (quotients[0], quotients[0]);
        for q in quotients {
            lo = lo.min(q);
            hi = hi.max(q);
        }
        Interval { lo: down(lo), hi: up(hi) }
    }
}

impl Field for Interval {
    fn int(value: i64) -> Self {
        // Every integer of the closed forms is far below 2^53.
        Interval::from(value as f64)
    }

    fn power(&self, k: u32) -> Self {
        let (lo, hi) = (signed_power(self.lo, k), signed_power(self.hi, k));
        if k > 0 && k.is_multiple_of(2) && self.contains(0.0) {
            Interval { lo: 0.0, hi: lo.hi.max(hi.hi) }
        } else {
            lo.hull(hi) // monotone: odd powers everywhere, even ones away from 0
        }
    }
}

/// xᵏ by squaring |x|, where rounding down and up never meets a sign.
fn signed_power(x: f64, k: u32) -> Interval {
    let (mut lo, mut hi) = (1.0_f64, 1.0_f64);
    let (mut base_lo, mut base_hi) = (x.abs(), x.abs());
    let mut rest = k;
    while rest > 0 {
        if rest & 1 == 1 {
            (lo, hi) = (down(lo * base_lo).max(0.0), up(hi * base_hi));
        }
        rest >>= 1;
        if rest > 0 {
            (base_lo, base_hi) = (down(base_lo * base_lo).max(0.0), up(base_hi * base_hi));
        }
    }
    if x < 0.0 && k % 2 == 1 { Interval { lo: -hi, hi: -lo } } else { Interval { lo, hi } }
}

#[cfg(test)]
mod tests;
