//! Factors as the papers print them: quotients of polynomials in n, 2^(-n/2) and π, read from
//! text.

use super::{Polynomial, decimal};
use crate::integral::Field;
use dashu_int::ops::BitTest;
use dashu_ratio::RBig;
use thiserror::Error;

/// Why a formula could not be read.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("formula \"{text}\", at character {position}: {reason}")]
pub struct FormulaError {
    /// The whole text.
    pub text: String,
    /// Where, counted from 1.
    pub position: usize,
    /// What was wrong there.
    pub reason: String,
}

/// numerator/denominator, both polynomials in n, h = 2^(-n/2) and π.
///
/// ```
/// use bellfit::bound::Formula;
/// let table: Formula = "(n + 2)*(n + 4)/(8*pi*(2^(-n/2) + n))".parse()?;
/// let same: Formula = "(n^2 + 6*n + 8)/(8*pi*n + 8*pi*2^(-n/2))".parse()?;
/// assert!(table.is_identical(&same));
/// # Ok::<(), bellfit::bound::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// Above the bar.
    pub numerator: Polynomial,
    /// Below the bar, never 0.
    pub denominator: Polynomial,
}

impl Formula {
    /// (a n + b)/(divisor π) from exact numbers.
    pub fn linear(a: &RBig, b: &RBig, divisor: &RBig) -> Self {
        let line = Polynomial::n().scaled(a).plus(&Polynomial::constant(b.clone()));
        Formula { numerator: line, denominator: Polynomial::pi().scaled(divisor) }
    }

    /// Whether both are the same function of n; a quotient by 0 is the same as none.
    pub fn is_identical(&self, other: &Self) -> bool {
        if self.denominator.is_zero() || other.denominator.is_zero() {
            return false;
        }
        let left = self.numerator.times(&other.denominator);
        left.minus(&other.numerator.times(&self.denominator)).is_zero()
    }

    /// self · other.
    pub fn times(&self, other: &Self) -> Self {
        Formula {
            numerator: self.numerator.times(&other.numerator),
            denominator: self.denominator.times(&other.denominator),
        }
    }

    /// 2π · self, with the powers of π that numerator and denominator share cancelled.
    pub fn times_two_pi(&self) -> Self {
        let numerator = self.numerator.times(&Polynomial::pi().scaled(&RBig::int(2)));
        let shared = numerator.pi_content().min(self.denominator.pi_content());
        Formula { numerator: numerator.without_pi(shared), denominator: self.denominator.without_pi(shared) }
    }

    /// The function n.
    pub fn n() -> Self {
        Self::whole(Polynomial::n())
    }

    /// The function h = 2^(-n/2).
    pub fn h() -> Self {
        Self::whole(Polynomial::h())
    }

    fn constant(value: RBig) -> Self {
        Self::whole(Polynomial::constant(value))
    }

    fn whole(numerator: Polynomial) -> Self {
        Formula { numerator, denominator: Polynomial::constant(RBig::int(1)) }
    }

    fn plus(&self, rhs: &Self) -> Self {
        Formula {
            numerator: self.numerator.times(&rhs.denominator).plus(&rhs.numerator.times(&self.denominator)),
            denominator: self.denominator.times(&rhs.denominator),
        }
    }

    fn inverse(&self) -> Self {
        Formula { numerator: self.denominator.clone(), denominator: self.numerator.clone() }
    }

    /// The value if it does not depend on n and has no π.
    fn as_constant(&self) -> Option<RBig> {
        Some(self.numerator.as_constant()? / self.denominator.as_constant()?)
    }
}

/// Dividing by a formula that is 0 identically gives one that equals no other.
impl Field for Formula {
    fn int(value: i64) -> Self {
        Self::constant(RBig::int(value))
    }
}

impl core::ops::Add for Formula {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        self.plus(&rhs)
    }
}

impl core::ops::Sub for Formula {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        self.plus(&rhs.times(&Self::int(-1)))
    }
}

impl core::ops::Mul for Formula {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        self.times(&rhs)
    }
}

impl core::ops::Div for Formula {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        self.times(&rhs.inverse())
    }
}

impl core::str::FromStr for Formula {
    type Err = FormulaError;

    /// Numbers, `n`, `pi` (or π), + - * / ^ and parentheses; powers are whole numbers, or
    /// `2^(k*n/2)` with a whole k. Degrees up to 32, 400 terms, coefficients of 4096 bits, 1000 characters.
    fn from_str(text: &str) -> Result<Self, FormulaError> {
        let mut reader = Reader { text, characters: text.chars().collect(), at: 0, depth: 0 };
        let length = reader.characters.len();
        if length > LONGEST_TEXT {
            let (text, reason) = (text.chars().take(40).collect::<String>() + "…", "1000 characters at most");
            return Err(FormulaError { text, position: LONGEST_TEXT + 1, reason: reason.to_owned() });
        }
        let formula = reader.sum()?;
        reader.skip();
        if reader.at < reader.characters.len() {
            return Err(reader.error("expected an operator or the end"));
        }
        Ok(formula)
    }
}

/// The deepest nesting read, so that no text can exhaust the stack.
const DEEPEST: usize = 64;
/// The highest whole power read, and the highest degree in any of n, 2^(-n/2) and π, so that no text
/// can exhaust memory: powers of powers multiply.
const HIGHEST: i64 = 32;
/// The longest coefficient read, in bits, for the same reason.
const LONGEST: usize = 4096;
/// The longest formula, in characters, and the most terms of a polynomial: what the work grows with.
const LONGEST_TEXT: usize = 1000;
const MOST_TERMS: usize = 400;

struct Reader<'a> {
    text: &'a str,
    characters: Vec<char>,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    fn error(&self, reason: &str) -> FormulaError {
        FormulaError { text: self.text.to_owned(), position: self.at + 1, reason: reason.to_owned() }
    }

    fn skip(&mut self) {
        while self.characters.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
    }

    fn take(&mut self, wanted: char) -> bool {
        self.skip();
        let found = self.characters.get(self.at) == Some(&wanted);
        self.at += usize::from(found);
        found
    }

    /// A step's result, unless it is too large to go on with.
    fn bounded(&self, formula: Formula) -> Result<Formula, FormulaError> {
        let parts = [&formula.numerator, &formula.denominator];
        let bits = |c: &RBig| c.numerator().bit_len() + c.denominator().bit_len();
        let fits = |p: &&Polynomial| {
            (0..3).all(|k| i64::from(p.degree(k)) <= HIGHEST)
                && p.terms().count() <= MOST_TERMS
                && p.terms().all(|(_, c)| bits(c) <= LONGEST)
        };
        if parts.iter().all(fits) { Ok(formula) } else { Err(self.error("too large to write out")) }
    }

    fn sum(&mut self) -> Result<Formula, FormulaError> {
        let negative = Formula::constant(RBig::int(-1));
        let mut total = if self.take('-') { self.product()?.times(&negative) } else { self.product()? };
        loop {
            if self.take('+') {
                let term = self.product()?;
                total = self.bounded(total.plus(&term))?;
            } else if self.take('-') {
                let term = self.product()?.times(&negative);
                total = self.bounded(total.plus(&term))?;
            } else {
                return Ok(total);
            }
        }
    }

    fn product(&mut self) -> Result<Formula, FormulaError> {
        let mut total = self.power()?;
        loop {
            if self.take('*') {
                let factor = self.power()?;
                total = self.bounded(total.times(&factor))?;
            } else if self.take('/') {
                let divisor = self.power()?;
                if divisor.numerator.is_zero() {
                    return Err(self.error("division by 0"));
                }
                total = self.bounded(total.times(&divisor.inverse()))?;
            } else {
                return Ok(total);
            }
        }
    }

    fn power(&mut self) -> Result<Formula, FormulaError> {
        let base = self.atom()?;
        if !self.take('^') {
            return Ok(base);
        }
        let exponent = self.atom()?;
        if let Some(k) = exponent.as_constant() {
            let k = self.whole(&k, "a power of anything but 2 must be a whole number")?;
            let base = if k < 0 { base.inverse() } else { base };
            if base.denominator.is_zero() {
                return Err(self.error("division by 0"));
            }
            let parts = [&base.numerator, &base.denominator];
            let degree = parts.iter().flat_map(|p| (0..3).map(|i| p.degree(i))).max().unwrap_or(0);
            let bits = |c: &RBig| c.numerator().bit_len() + c.denominator().bit_len();
            let length = parts.iter().flat_map(|p| p.terms().map(|(_, c)| bits(c))).max().unwrap_or(0);
            if k.abs() * i64::from(degree) > HIGHEST || k.unsigned_abs() as usize * length > LONGEST {
                return Err(self.error("a power too large to write out"));
            }
            let one = Formula::constant(RBig::int(1));
            return (0..k.abs()).try_fold(one, |p, _| self.bounded(p.times(&base)));
        }
        if base.as_constant() != Some(RBig::int(2)) {
            return Err(self.error("only 2 can be raised to a power with n in it"));
        }
        // 2^(k n/2) = h^(-k)
        let per_n = exponent.times(&Formula::whole(Polynomial::n()).inverse());
        let ratio = per_n.numerator.in_n(0).zip(per_n.denominator.in_n(0)).and_then(|(top, bottom)| {
            let lead = |p: &[RBig]| p.iter().position(|c| !c.is_zero());
            let (i, j) = (lead(&top)?, lead(&bottom)?);
            let ratio = top[i].clone() / bottom[j].clone();
            let matches = per_n.numerator.minus(&per_n.denominator.scaled(&ratio)).is_zero();
            matches.then_some(ratio)
        });
        let Some(ratio) = ratio else {
            return Err(self.error("the power of 2 must be a multiple of n/2"));
        };
        let k = self.whole(&(ratio * RBig::int(-2)), "the power of 2 must be a multiple of n/2")?;
        let h = Formula::whole(Polynomial::h());
        let h = if k < 0 { h.inverse() } else { h };
        Ok((0..k.abs()).fold(Formula::constant(RBig::int(1)), |p, _| p.times(&h)))
    }

    fn whole(&self, value: &RBig, reason: &str) -> Result<i64, FormulaError> {
        let k = value.clone().to_f64().value();
        if *value != RBig::int(k as i64) || (k as i64).abs() > HIGHEST {
            return Err(self.error(reason));
        }
        Ok(k as i64)
    }

    fn atom(&mut self) -> Result<Formula, FormulaError> {
        self.skip();
        if self.take('(') {
            self.depth += 1;
            if self.depth > DEEPEST {
                return Err(self.error("nested too deeply"));
            }
            let inner = self.sum()?;
            self.depth -= 1;
            return if self.take(')') { Ok(inner) } else { Err(self.error("expected )")) };
        }
        if self.take('π') {
            return Ok(Formula::whole(Polynomial::pi()));
        }
        let start = self.at;
        let word: String = self.characters[start..].iter().take_while(|c| c.is_ascii_alphabetic()).collect();
        if word == "n" || word == "pi" {
            self.at += word.len();
            let variable = if word == "n" { Polynomial::n() } else { Polynomial::pi() };
            return Ok(Formula::whole(variable));
        }
        let number: String =
            self.characters[start..].iter().take_while(|c| c.is_ascii_digit() || **c == '.').collect();
        match decimal(&number) {
            Some((value, _)) => {
                self.at += number.len();
                Ok(Formula::constant(value))
            }
            None => Err(self.error("expected a number, n, pi or (")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn printed_factors_are_read() {
        let a: Formula = "(1.063*n + 1)/(2*pi)".parse().unwrap();
        let b = Formula::linear(&decimal("1.063").unwrap().0, &RBig::int(1), &RBig::int(2));
        assert!(a.is_identical(&b));
        let c: Formula = "1.063*(n + 1)/(2*π)".parse().unwrap();
        assert!(!a.is_identical(&c));
        // 2^(-n) = h², 2^(-n/2)^2
        let d: Formula = "2^(-n)".parse().unwrap();
        assert!(d.is_identical(&"(2^(-n/2))^2".parse().unwrap()));
        assert!(a.times_two_pi().is_identical(&"1.063*n + 1".parse().unwrap()));
        assert_eq!(a.times_two_pi().denominator.degree(2), 0);
    }

    #[test]
    fn what_cannot_be_read_is_named_with_its_place() {
        for (text, position) in [
            ("", 1),
            ("n +", 4),
            ("(n", 3),
            ("n n", 3),
            ("3^n", 4),
            ("2^(n*n)", 8),
            ("n/0", 4),
            ("n^0.5", 6),
            ("x", 1),
        ] {
            let error = text.parse::<Formula>().unwrap_err();
            assert_eq!(error.position, position, "{error}");
        }
        assert!("(".repeat(1000).parse::<Formula>().is_err());
        assert!("n^33".parse::<Formula>().is_err());
        assert!("(n^4)^8".parse::<Formula>().is_ok());
        for tower in [
            "(n^4)^9",
            "((n + 1)^32)^32",
            "((2^(-n/2))^8)^(-5)",
            "((((n + π)^32)^32)^32)^32",
            "((9^32)^32)^32",
        ] {
            assert!(tower.parse::<Formula>().is_err(), "{tower}");
        }
        let sum: Vec<String> = (2..90).map(|k| format!("1/(n + {k})")).collect();
        for long in [
            vec!["(n + π + 2^(-n/2))"; 40].join("*"),
            sum.join(" + "),
            vec!["9^32"; 60].join("*"),
            "n+".repeat(600) + "n",
        ] {
            assert!(long.parse::<Formula>().is_err(), "{long}");
        }
        // Nor do products and sums of quotients grow without end.
        for long in ["(n + 1)*".repeat(60) + "1", "1/(n + 1) + ".repeat(60) + "1", "1 + ".repeat(400) + "1"] {
            let error = long.parse::<Formula>().unwrap_err();
            assert!(error.reason.contains("too large") || error.reason.contains("1000"), "{error}");
        }
        assert!(("n + ".repeat(100) + "1").parse::<Formula>().is_ok());
    }

    #[test]
    fn a_quotient_by_0_is_no_function() {
        let [zero, one] = [0, 1].map(RBig::int);
        let (none, nothing) = (Formula::linear(&zero, &zero, &zero), Formula::linear(&zero, &zero, &one));
        assert!(nothing.is_identical(&nothing));
        assert!(!none.is_identical(&nothing) && !nothing.is_identical(&none) && !none.is_identical(&none));
    }
}
