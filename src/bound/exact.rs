//! Exact rationals: decimals as printed, and closed forms where they are rational.

use super::Interval;
use crate::integral::Field;
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

impl Field for RBig {
    fn int(value: i64) -> Self {
        RBig::from(IBig::from(value))
    }
}

/// The exact value of a decimal such as `-1.7e-2`, and the number of decimal places behind its
/// last digit (3 for `1.7e-2`: its last digit counts thousandths).
///
/// `None` unless the text is a sign, digits with at most one point, and an optional exponent.
///
/// ```
/// use bellfit::bound::decimal;
/// let (value, places) = decimal("1.7e-2").unwrap();
/// assert_eq!(value.to_string(), "17/1000");
/// assert_eq!(places, 3);
/// assert!(decimal("1.7e").is_none() && decimal("nan").is_none());
/// ```
pub fn decimal(text: &str) -> Option<(RBig, i32)> {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
        None => (text, 0),
    };
    // Beyond this no double and no printed bound is meant, and 10^k would not fit in memory.
    if exponent.unsigned_abs() > 400 || text.len() > 400 {
        return None;
    }
    let (negative, digits) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa.strip_prefix('+').unwrap_or(mantissa)),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let all: String = [whole, fraction].concat();
    if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    let magnitude = IBig::from(all.parse::<UBig>().ok()?);
    let places = i32::try_from(fraction.len()).ok()? - exponent;
    let value = RBig::from(if negative { -magnitude } else { magnitude });
    Some((value * power_of_ten(-places), places))
}

/// 10^k, exactly.
pub fn power_of_ten(k: i32) -> RBig {
    let power = IBig::from(UBig::from(10u8).pow(k.unsigned_abs() as usize));
    if k >= 0 { RBig::from(power) } else { RBig::int(1) / RBig::from(power) }
}

/// The tightest interval of doubles around an exact number.
pub fn enclose(value: &RBig) -> Interval {
    let nearest = value.to_f64().value();
    if !nearest.is_finite() {
        return Interval::WHOLE;
    }
    match RBig::try_from(nearest) {
        Ok(back) if back == *value => Interval::from(nearest),
        _ => Interval::new(nearest.next_down(), nearest.next_up()),
    }
}

/// The exact rational that a finite double is; `None` for NaN and infinities.
pub fn exact(value: f64) -> Option<RBig> {
    RBig::try_from(value).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_read_exactly() {
        for (text, numerator, denominator, places) in [
            ("1.063", 1063, 1000, 3),
            ("-9.7e-3", -97, 10000, 4),
            ("4.8", 24, 5, 1),
            ("16", 16, 1, 0),
            ("1e3", 1000, 1, -3),
            ("0.50", 1, 2, 2),
        ] {
            let (value, found) = decimal(text).unwrap();
            assert_eq!(value * RBig::int(denominator), RBig::int(numerator), "{text}");
            assert_eq!(found, places, "{text}");
        }
        for bad in
            ["", ".", "-", "1.2.3", "1e", "e5", "0x10", "1 000", "1e999999999", "1e-2147483648", "NaN", "½"]
        {
            assert!(decimal(bad).is_none(), "{bad}");
        }
    }

    #[test]
    fn enclosures_are_tight_and_exact_where_they_can_be() {
        assert_eq!(enclose(&RBig::int(3)), Interval::from(3.0));
        let (tenth, _) = decimal("0.1").unwrap();
        let around = enclose(&tenth);
        assert!(exact(around.lo()).unwrap() < tenth && tenth < exact(around.hi()).unwrap());
        assert!(around.width() < 6e-17);
    }

    #[test]
    fn decimals_end_at_400_digits() {
        let zeros = "0".repeat(400);
        assert!(decimal(&zeros).is_some() && decimal(&format!("{zeros}0")).is_none());
        assert!(decimal("1e400").is_some() && decimal("1e401").is_none());
        assert!(decimal("1e-400").is_some() && decimal("1e-401").is_none());
    }

    /// Digits alone: no marks between them that a reader of whole numbers would pass over.
    #[test]
    fn marks_between_digits_are_no_decimals() {
        for bad in ["1_000", "_1", "1_", "+-1", "--1", "1.+5", "1. 5", "٣", "1e1e1"] {
            assert!(decimal(bad).is_none(), "{bad}");
        }
        assert_eq!(decimal("+1.5").map(|(value, _)| value), decimal("15e-1").map(|(value, _)| value));
    }
}
