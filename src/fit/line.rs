//! (a n + b)/(divisor π) with a and b as decimals: what is printed is what is certified.

use super::digits::round_to;
use crate::bound::{Formula, decimal, power_of_ten};
use crate::integral::Field;
use dashu_ratio::RBig;

/// A linear factor in decimals.
///
/// ```
/// use bellfit::fit::Line;
/// let line = Line::from_formula(&"(1.063*n + 1)/(2*pi)".parse()?).unwrap();
/// assert_eq!((line.a(), line.b(), line.divisor()), ("1.063", "1", "2"));
/// assert_eq!(line.to_string(), "(1.063 n + 1)/(2π)");
/// # Ok::<(), bellfit::bound::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    a: String,
    b: String,
    divisor: String,
    formula: Formula,
}

impl Line {
    /// From decimals; `None` if one of them is not a decimal, or the divisor is 0.
    pub fn new(a: &str, b: &str, divisor: &str) -> Option<Self> {
        let exact = |text: &str| decimal(text).map(|(value, _)| value);
        let d = exact(divisor)?;
        if d.is_zero() {
            return None;
        }
        let formula = Formula::linear(&exact(a)?, &exact(b)?, &d);
        Some(Line { a: a.to_owned(), b: b.to_owned(), divisor: divisor.to_owned(), formula })
    }

    /// From doubles, rounded to `digits` significant decimals first.
    pub fn rounded(a: f64, b: f64, divisor: u32, digits: usize) -> Option<Self> {
        Self::new(&round_to(a, digits), &round_to(b, digits), &divisor.to_string())
    }

    /// From a formula that is one: (a n + b)/(divisor π) with a, b, divisor finite decimals.
    pub fn from_formula(formula: &Formula) -> Option<Self> {
        let mut terms = formula.denominator.terms();
        let (exponents, d) = terms.next()?;
        if terms.next().is_some() || *exponents != [0, 0, 1] {
            return None;
        }
        if formula.numerator.degree(0) > 1 || formula.numerator.degree(1) > 0 {
            return None;
        }
        let line = formula.numerator.in_n(0)?;
        let zero = RBig::int(0);
        let (b, a) = (line.first().unwrap_or(&zero), line.get(1).unwrap_or(&zero));
        Self::new(&to_decimal(a)?, &to_decimal(b)?, &to_decimal(d)?)
    }

    /// a, as text.
    pub fn a(&self) -> &str {
        &self.a
    }

    /// b, as text.
    pub fn b(&self) -> &str {
        &self.b
    }

    /// The divisor before π, as text.
    pub fn divisor(&self) -> &str {
        &self.divisor
    }

    /// The line as a claims file writes it.
    ///
    /// ```
    /// use bellfit::fit::Line;
    /// assert_eq!(Line::new("1.063", "-1", "2").expect("decimals").source(), "(1.063*n - 1)/(2*pi)");
    /// ```
    pub fn source(&self) -> String {
        let Line { a, b, divisor, .. } = self;
        let slope = if a == "1" { "n".to_owned() } else { format!("{a}*n") };
        match b.strip_prefix('-') {
            _ if is_zero(b) => format!("{slope}/({divisor}*pi)"),
            Some(positive) => format!("({slope} - {positive})/({divisor}*pi)"),
            None => format!("({slope} + {b})/({divisor}*pi)"),
        }
    }

    /// The same as a formula, exactly.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }
}

impl core::fmt::Display for Line {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let Line { a, b, divisor, .. } = self;
        match b.strip_prefix('-') {
            _ if is_zero(b) => write!(f, "{a} n/({divisor}π)"),
            Some(positive) => write!(f, "({a} n - {positive})/({divisor}π)"),
            None => write!(f, "({a} n + {b})/({divisor}π)"),
        }
    }
}

/// 0 however it is written: -0, 0.00.
fn is_zero(decimal: &str) -> bool {
    decimal.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'))
}

/// The decimal that an exact number is, `None` if its digits never end.
fn to_decimal(value: &RBig) -> Option<String> {
    let places = (0..=60).find(|&k| (value.clone() * power_of_ten(k)).is_int())?;
    let digits = (value.clone() * power_of_ten(places)).numerator().to_string();
    let (sign, digits) = match digits.strip_prefix('-') {
        Some(rest) => ("-", rest.to_owned()),
        None => ("", digits),
    };
    let places = places as usize;
    if places == 0 {
        return Some(format!("{sign}{digits}"));
    }
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    Some(format!("{sign}{whole}.{fraction}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_survive_the_way_through_a_formula() {
        for (a, b, d) in [("1.063", "0", "2"), ("1.068", "0.96", "8"), ("1.027", "-4.8", "8")] {
            let line = Line::new(a, b, d).unwrap();
            assert_eq!(Line::from_formula(line.formula()), Some(line));
        }
        let grouped = Line::from_formula(&"1.068*(n + 0.96)/(8*pi)".parse().unwrap()).unwrap();
        assert_eq!(grouped.b(), "1.02528");
        for not_a_line in ["n^2/pi", "n/(pi + 1)", "n/pi^2", "2^(-n/2)/pi", "n"] {
            assert!(Line::from_formula(&not_a_line.parse().unwrap()).is_none(), "{not_a_line}");
        }
    }

    #[test]
    fn a_zero_is_left_out_however_it_is_written() {
        for b in ["0", "-0", "0.00", "-0.0"] {
            let line = Line::new("1.5", b, "2").unwrap();
            assert_eq!((line.source(), line.to_string()), ("1.5*n/(2*pi)".into(), "1.5 n/(2π)".into()));
        }
        assert_eq!(Line::new("1", "-0.01", "2").unwrap().source(), "(n - 0.01)/(2*pi)");
    }

    #[test]
    fn rounding_keeps_the_digits_asked_for() {
        let line = Line::rounded(1.0624882634596133, 1e-14, 2, 12).unwrap();
        assert_eq!((line.a(), line.b()), ("1.06248826346", "0"));
    }
}
