//! Running error analysis: a number's exact range beside a bound of how far floating point is from it.
//!
//! Each operation hands on its operands' errors and adds its own rounding, at most the unit roundoff times the
//! result, or half a unit in the last place of the largest result where that is known to be less, and what
//! underflow loses. Two operations fused round once: their error is below the bound of the two.
//! (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, 3.3.)

use super::{Format, Interval};
use crate::integral::Field;
use core::ops::Neg;

/// Arithmetic of a format, rounding to nearest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arithmetic {
    /// u, the largest relative error of a rounding.
    pub(super) unit: f64,
    /// Half the least positive number: the largest error of a rounding near 0.
    pub(super) tiny: f64,
    /// The largest finite number.
    pub(super) largest: f64,
    /// Whether numbers stand for their product with a power of n not known: their place among the powers of two
    /// is then not known either.
    scaled: bool,
}

impl Arithmetic {
    const HALF: Self = Self::ieee(1.0 / 2048.0, 1.0 / 33_554_432.0, 65_504.0);
    const SINGLE: Self =
        Self::ieee(f32::EPSILON as f64 / 2.0, f32::from_bits(1) as f64 / 2.0, f32::MAX as f64);
    // Half of the least double is none: the whole of it.
    const DOUBLE: Self = Self::ieee(f64::EPSILON / 2.0, f64::from_bits(1), f64::MAX);

    const fn ieee(unit: f64, tiny: f64, largest: f64) -> Self {
        Arithmetic { unit, tiny, largest, scaled: false }
    }

    /// Where constants are computed.
    pub(super) const fn constants() -> Self {
        Self::DOUBLE
    }

    /// Between arguments and result.
    pub(super) const fn of(format: Format) -> Self {
        match format {
            Format::Half => Self::HALF,
            Format::HalfStored | Format::Single => Self::SINGLE,
            Format::Double => Self::DOUBLE,
        }
    }

    /// Of arguments and results.
    pub(super) const fn stored(format: Format) -> Self {
        match format {
            Format::HalfStored => Self::HALF,
            other => Self::of(other),
        }
    }

    /// The same, for numbers that stand for their product with a power of n ≥ 1 whose exponent is not negative.
    pub(super) const fn scaled(self) -> Self {
        Arithmetic { scaled: true, ..self }
    }

    /// A bound of one rounding of a number of at most this size, underflow apart.
    pub(super) fn rounding(self, size: f64) -> f64 {
        if size == 0.0 {
            return 0.0;
        }
        if !size.is_finite() || self.scaled {
            return up(Interval::from(self.unit) * Interval::from(size));
        }
        // Below 2ᵏ numbers are at most 2u 2^(k-1) apart; 2ᵏ itself is one of them.
        let (fraction, exponent) = libm::frexp(size);
        self.unit * libm::scalbn(1.0, if fraction == 0.5 { exponent - 2 } else { exponent - 1 })
    }
}

fn up(x: Interval) -> f64 {
    x.hi()
}

fn sum(terms: &[f64]) -> f64 {
    terms.iter().fold(0.0, |sum, term| up(Interval::from(sum) + Interval::from(*term)))
}

fn product(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == 0.0 { 0.0 } else { up(Interval::from(a) * Interval::from(b)) }
}

/// A number of which floating point has another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rounded {
    /// Encloses it exactly.
    pub(super) value: Interval,
    /// Bounds how far the computed one is from it, not negative.
    pub(super) error: f64,
}

impl Rounded {
    /// A number that the format has.
    pub(super) fn exact(value: Interval) -> Self {
        Rounded { value, error: 0.0 }
    }

    /// The number rounded once more, to another format.
    pub(super) fn stored(self, by: Arithmetic) -> Self {
        self.rounded(self.error, by, by.tiny, f64::INFINITY)
    }

    /// Where its value is known from elsewhere.
    pub(super) fn within(self, value: Interval) -> Self {
        Rounded { value: self.value.intersect(value), ..self }
    }

    /// Bounds the computed number's size.
    pub(super) fn size(self) -> f64 {
        sum(&[self.value.abs().hi(), self.error])
    }

    /// With the rounding of a computed number of at most the size `most`.
    fn rounded(self, error: f64, by: Arithmetic, tiny: f64, most: f64) -> Self {
        let size = Rounded { value: self.value, error }.size().min(most);
        let error = sum(&[error, by.rounding(size), tiny]);
        // What scaled numbers stand for is checked where they are made.
        let overflows = !by.scaled && size > by.largest;
        Rounded { value: self.value, error: if error.is_nan() || overflows { f64::INFINITY } else { error } }
    }

    /// Sum, known to lie in `value`.
    pub(super) fn plus(self, rhs: Self, value: Interval, by: Arithmetic) -> Self {
        let both = Self::exact(self.value + rhs.value).within(value);
        // Sums do not underflow.
        both.rounded(sum(&[self.error, rhs.error]), by, 0.0, f64::INFINITY)
    }

    /// Difference, known to lie in `value`.
    pub(super) fn minus(self, rhs: Self, value: Interval, by: Arithmetic) -> Self {
        self.plus(-rhs, value, by)
    }

    /// Product, known to lie in `value`.
    pub(super) fn times(self, rhs: Self, value: Interval, by: Arithmetic) -> Self {
        let both = Self::exact(self.value * rhs.value).within(value);
        let (a, b) = (self.value.abs().hi(), rhs.value.abs().hi());
        let error = sum(&[product(a, rhs.error), product(self.error, b), product(self.error, rhs.error)]);
        both.rounded(error, by, by.tiny, f64::INFINITY)
    }

    /// 1 - x, known to lie in `value`, of an x whose computed number is not negative: rounded as numbers up to 1 are.
    pub(super) fn complement(self, value: Interval, by: Arithmetic) -> Self {
        let both = Self::exact(Interval::from(1.0) - self.value).within(value);
        both.rounded(self.error, by, 0.0, 1.0)
    }

    /// Square of a number whose computed size is at most `most`.
    pub(super) fn squared(self, by: Arithmetic, most: f64) -> Self {
        let both = Self::exact(self.value.power(2));
        let error = sum(&[product(2.0 * self.value.abs().hi(), self.error), product(self.error, self.error)]);
        both.rounded(error, by, by.tiny, product(most, most))
    }

    /// Quotient, known to lie in `value`, and that of the computed numbers at most `most` in size; no bound where
    /// the divisor may vanish.
    pub(super) fn over(self, rhs: Self, value: Interval, by: Arithmetic, most: f64) -> Self {
        let both = Self::exact(self.value / rhs.value).within(value);
        let least = (Interval::from(rhs.value.abs().lo()) - Interval::from(rhs.error)).lo();
        if least.is_nan() || least <= 0.0 {
            return Rounded { value: both.value, error: f64::INFINITY };
        }
        // â/b̂ - a/b = (â - a - (a/b)(b̂ - b))/b̂
        let above = sum(&[self.error, product(both.value.abs().hi(), rhs.error)]);
        both.rounded(up(Interval::from(above) / Interval::from(least)), by, by.tiny, most)
    }

    /// max(x, 0), which is exact.
    pub(super) fn positive_part(self) -> Self {
        // Where the number is negative, what is computed lies above 0 by what the error carries over it.
        let over = sum(&[self.value.hi(), self.error]).max(0.0);
        Rounded { value: self.value.max(Interval::ZERO), error: self.error.min(over) }
    }
}

impl Neg for Rounded {
    type Output = Self;
    fn neg(self) -> Self {
        Rounded { value: -self.value, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_precision_stays_inside_its_bound() {
        let by = Arithmetic::SINGLE;
        let mut state = 7_u64;
        let mut draw = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 40) as f64 / f64::from(1 << 24) * 4.0 - 2.0 + 1e-9
        };
        let (mut worst, mut count) = (0.0_f64, 0);
        for _ in 0..20_000 {
            let [a, b, c] = [draw(), draw(), draw()];
            let (x, y, z) = (a as f32, b as f32, c as f32);
            let stored = |v: f64| Rounded::exact(Interval::from(v)).stored(by);
            let whole = Interval::WHOLE;
            let bound =
                stored(a).times(stored(b), whole, by).plus(stored(c), whole, by).squared(by, f64::INFINITY);
            // a b + c in doubles is off by 2e-15 at most, nothing beside 1e-7.
            let error = (f64::from((x * y + z) * (x * y + z)) - (a * b + c) * (a * b + c)).abs();
            assert!(error <= bound.error + 1e-14, "{a} {b} {c}: {error:e} {bound:?}");
            worst = worst.max(error / bound.error);
            count += 1;
        }
        assert!(count == 20_000 && worst > 0.3, "{worst}"); // a bound that is never near is none
    }

    #[test]
    fn half_a_unit_in_the_last_place_is_known_on_both_sides_of_a_power_of_two() {
        let by = Arithmetic::DOUBLE;
        let u = f64::EPSILON / 2.0;
        assert_eq!((by.rounding(1.0), by.rounding(1.0_f64.next_up())), (u / 2.0, u));
        assert_eq!((by.rounding(0.75), by.rounding(0.0)), (u / 2.0, 0.0));
        assert_eq!(by.rounding(f64::INFINITY), f64::INFINITY);
    }

    #[test]
    fn what_leaves_the_range_has_no_bound() {
        let two = Rounded::exact(Interval::from(300.0));
        assert_eq!(two.squared(Arithmetic::HALF, f64::INFINITY).error, f64::INFINITY); // 90000 > 65504
        assert!(two.squared(Arithmetic::SINGLE, f64::INFINITY).error < 0.01);
    }

    #[test]
    fn a_divisor_that_may_vanish_has_no_bound() {
        let one = Rounded::exact(Interval::from(1.0));
        let near = Rounded { value: Interval::from(1e-9), error: 1e-8 };
        assert_eq!(one.over(near, Interval::WHOLE, Arithmetic::SINGLE, 1.0).error, f64::INFINITY);
    }
}
