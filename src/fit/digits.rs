//! Decimals of so many significant digits, as a lattice: floors, neighbours, texts.

use crate::bound::{exact, power_of_ten};
use crate::integral::Field;
use dashu_ratio::RBig;

/// mantissa · 10^-places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    mantissa: i64,
    places: i32,
}

impl Decimal {
    pub(super) const ZERO: Decimal = Decimal { mantissa: 0, places: 0 };

    /// The largest decimal ≤ x with at most so many significant digits and `most_places` places behind
    /// the point; `None` for what is not finite or too large.
    pub(super) fn floor(x: f64, digits: usize, most_places: i32) -> Option<Self> {
        let value = exact(x)?;
        let mut places = places(x, digits).min(most_places);
        loop {
            let mantissa = i64::try_from((value.clone() * power_of_ten(places)).floor()).ok()?;
            if mantissa.unsigned_abs() <= limit(digits) {
                return Some(Decimal { mantissa, places }.trimmed());
            }
            places -= 1; // down from -9.99… to -10
        }
    }

    /// The next decimal of so many digits below a positive one.
    pub(super) fn below(self, digits: usize) -> Self {
        let fine = self.at(digits);
        // Below a power of ten the steps are ten times finer.
        let fine =
            if fine.mantissa == limit(digits) as i64 / 10 { fine.with_places(fine.places + 1) } else { fine };
        Decimal { mantissa: fine.mantissa - 1, ..fine }.trimmed()
    }

    /// The next decimal of so many digits above a positive one.
    pub(super) fn above(self, digits: usize) -> Self {
        let fine = self.at(digits);
        Decimal { mantissa: fine.mantissa + 1, ..fine }.trimmed()
    }

    pub(super) fn is_positive(self) -> bool {
        self.mantissa > 0
    }

    pub(super) fn exact(self) -> RBig {
        RBig::int(self.mantissa) * power_of_ten(-self.places)
    }

    pub(super) fn to_f64(self) -> f64 {
        self.exact().to_f64().value()
    }

    /// Never in exponent form.
    pub(super) fn text(self) -> String {
        let sign = if self.mantissa < 0 { "-" } else { "" };
        let digits = self.mantissa.unsigned_abs();
        if self.places <= 0 {
            return format!("{sign}{digits}{}", "0".repeat(self.places.unsigned_abs() as usize));
        }
        let places = self.places.unsigned_abs() as usize;
        let padded = format!("{digits:0>width$}", width = places + 1);
        let (whole, fraction) = padded.split_at(padded.len() - places);
        format!("{sign}{whole}.{fraction}")
    }

    /// Without zeros at the end.
    fn trimmed(self) -> Self {
        let Decimal { mut mantissa, mut places } = self;
        if mantissa == 0 {
            return Self::ZERO;
        }
        while mantissa % 10 == 0 {
            (mantissa, places) = (mantissa / 10, places - 1);
        }
        Decimal { mantissa, places }
    }

    /// Written with all its digits.
    fn at(self, digits: usize) -> Self {
        let missing = digits as i32 - self.mantissa.unsigned_abs().to_string().len() as i32;
        self.with_places(self.places + missing)
    }

    fn with_places(self, places: i32) -> Self {
        let ten = (0..(places - self.places).max(0)).fold(1, |p, _| p * 10);
        Decimal { mantissa: self.mantissa * ten, places }
    }
}

/// 10^digits.
fn limit(digits: usize) -> u64 {
    (0..digits).fold(1, |p, _| p * 10)
}

/// How many places behind the point the last of so many digits of x stands.
pub(super) fn places(x: f64, digits: usize) -> i32 {
    let text = format!("{x:e}");
    let exponent = text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0);
    digits as i32 - 1 - exponent
}

/// The shortest decimal of x rounded to so many significant digits, never in exponent form
/// between 1e-4 and 1e15; what is below half of the last of 12 decimals of 1 counts as 0, being
/// the rounding of a fit whose other unknown is near 1.
pub(in crate::fit) fn round_to(x: f64, digits: usize) -> String {
    if x.abs() < 5e-13 {
        return "0".to_owned();
    }
    let text = format!("{x:.*e}", digits.saturating_sub(1));
    // Reading back and printing gives the shortest decimal, which has at most `digits` digits.
    let rounded: f64 = text.parse().unwrap_or(x);
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floor(x: f64, digits: usize) -> String {
        Decimal::floor(x, digits, 20).unwrap().text()
    }

    #[test]
    fn floors_have_the_digits_asked_for_and_lie_below() {
        for (x, digits, text) in [
            (1.0625, 4, "1.062"),
            (1.0625, 5, "1.0625"),
            (-1.0625, 4, "-1.063"),
            (0.99999, 3, "0.999"),
            (-0.99999, 3, "-1"),
            (-9.9999, 3, "-10"),
            (0.0012345, 3, "0.00123"),
            (12345.0, 3, "12300"),
            (5.4799, 2, "5.4"),
            (0.0, 4, "0"),
            // The double just below 1.1 and the one just above 0.3.
            (1.1_f64.next_down(), 2, "1"),
            (0.3_f64.next_up(), 1, "0.3"),
        ] {
            assert_eq!(floor(x, digits), text, "{x} to {digits}");
        }
        assert_eq!(Decimal::floor(0.0123, 4, 3).unwrap().text(), "0.012");
        assert_eq!(Decimal::floor(1e-13, 4, 5).unwrap(), Decimal::ZERO);
        assert!(Decimal::floor(f64::NAN, 4, 5).is_none() && Decimal::floor(f64::INFINITY, 4, 5).is_none());
    }

    #[test]
    fn neighbours_are_one_unit_of_the_last_digit_away() {
        for (x, digits, below, above) in [
            (1.062, 4, "1.061", "1.063"),
            (1.06, 4, "1.059", "1.061"),
            (1.0, 3, "0.999", "1.01"),
            (9.99, 3, "9.98", "10"),
            (0.5, 1, "0.4", "0.6"),
        ] {
            let decimal = Decimal::floor(x + 1e-12, digits, 20).unwrap();
            assert_eq!(
                (decimal.below(digits).text(), decimal.above(digits).text()),
                (below.into(), above.into())
            );
            assert_eq!(decimal.text().parse::<f64>(), Ok(decimal.to_f64()));
        }
    }

    #[test]
    fn rounding_is_to_nearest() {
        assert_eq!(round_to(1.0624882634596133, 12), "1.06248826346");
        assert_eq!((round_to(1e-14, 12), round_to(-2.5, 1)), ("0".to_owned(), "-2".to_owned()));
    }
}
