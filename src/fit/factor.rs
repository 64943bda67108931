//! A factor in decimals: what is printed is what is certified.

use super::{FactorForm, Line};
use crate::bound::{Formula, Polynomial, decimal};
use crate::integral::Field;
use core::fmt;
use dashu_ratio::RBig;

/// form/(divisor π) with decimal parameters.
///
/// ```
/// use bellfit::fit::{Factor, FactorForm};
/// let factor = Factor::new(FactorForm::Ratio, &["1.0625", "0.94", "0.84", "-0.89"], 2).expect("decimals");
/// assert_eq!(factor.to_string(), "(1.0625 n + 0.94 + 0.84/(n - 0.89))/(2π)");
/// assert!(factor.formula().is_identical(&"(1.0625*n + 0.94 + 0.84/(n - 0.89))/(2*pi)".parse()?));
/// # Ok::<(), bellfit::bound::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Factor {
    form: FactorForm,
    parameters: Vec<String>,
    divisor: u32,
    formula: Formula,
}

impl Factor {
    /// From decimals, as many as the form has parameters; `None` if one of them is not a decimal, or
    /// their number is wrong.
    pub fn new<S: AsRef<str>>(form: FactorForm, parameters: &[S], divisor: u32) -> Option<Self> {
        let texts: Vec<String> = parameters.iter().map(|p| p.as_ref().to_owned()).collect();
        let exact: Option<Vec<RBig>> = texts.iter().map(|p| decimal(p).map(|(value, _)| value)).collect();
        let exact = exact.filter(|p| p.len() == form.parameters() && divisor > 0)?;
        let formula = formula(form, &exact, divisor);
        Some(Factor { form, parameters: texts, divisor, formula })
    }

    /// The form.
    pub fn form(&self) -> FactorForm {
        self.form
    }

    /// p0.., as text.
    pub fn parameters(&self) -> &[String] {
        &self.parameters
    }

    /// The divisor before π.
    pub fn divisor(&self) -> u32 {
        self.divisor
    }

    /// The same as a formula, exactly.
    pub fn formula(&self) -> &Formula {
        &self.formula
    }

    /// The factor as a claims file writes it.
    ///
    /// ```
    /// use bellfit::fit::{Factor, FactorForm};
    /// let factor = Factor::new(FactorForm::Inverse, &["1.05", "5.5", "-8"], 8).expect("decimals");
    /// assert_eq!(factor.source(), "(1.05*n + 5.5 - 8/n)/(8*pi)");
    /// assert!(factor.formula().is_identical(&factor.source().parse()?));
    /// # Ok::<(), bellfit::bound::FormulaError>(())
    /// ```
    pub fn source(&self) -> String {
        if let Some(line) = self.line() {
            return line.source();
        }
        let plain = self.to_string().replace("n²", "n^2").replace('π', "*pi");
        plain.replacen(" n", "*n", 1)
    }

    /// The same as a line a n + b, if it is one.
    pub fn line(&self) -> Option<Line> {
        self.form.as_line()?;
        let b = self.parameters.get(1).map_or("0", String::as_str);
        Line::new(&self.parameters[0], b, &self.divisor.to_string())
    }
}

/// One quotient of polynomials in n, over the divisor and π.
fn formula(form: FactorForm, p: &[RBig], divisor: u32) -> Formula {
    let power = |k: usize, c: &RBig| Polynomial::monomial([k as u32, 0, 0], c.clone());
    let below = Polynomial::pi().scaled(&RBig::int(i64::from(divisor)));
    if form == FactorForm::Ratio {
        // ((p0 n + p1)(n + p3) + p2)/(n + p3)
        let pole = Polynomial::n().plus(&power(0, &p[3]));
        let line = power(1, &p[0]).plus(&power(0, &p[1]));
        return Formula {
            numerator: line.times(&pole).plus(&power(0, &p[2])),
            denominator: pole.times(&below),
        };
    }
    // p0 n + p1 + p2/n + … = (p0 nᵏ + p1 nᵏ⁻¹ + …)/nᵏ⁻¹
    let last = p.len() - 1;
    let highest = last.max(1);
    let terms = p.iter().enumerate().map(|(j, c)| power(highest - j, c));
    let numerator = terms.fold(Polynomial::constant(RBig::int(0)), |sum, term| sum.plus(&term));
    Formula { numerator, denominator: below.times(&power(highest - 1, &RBig::int(1))) }
}

impl fmt::Display for Factor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Factor { form, parameters, divisor, .. } = self;
        let signed = |text: &str| match text.strip_prefix('-') {
            Some(positive) => format!(" - {positive}"),
            None => format!(" + {text}"),
        };
        if let Some(line) = self.line() {
            return write!(f, "{line}");
        }
        write!(f, "({} n{}{}", parameters[0], signed(&parameters[1]), signed(&parameters[2]))?;
        match form {
            FactorForm::Ratio => write!(f, "/(n{})", signed(&parameters[3]))?,
            FactorForm::InverseSquare => write!(f, "/n{}/n²", signed(&parameters[3]))?,
            FactorForm::Proportional | FactorForm::Linear | FactorForm::Inverse => write!(f, "/n")?,
        }
        write!(f, ")/({divisor}π)")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_form_is_its_formula() {
        let p = ["1.0625", "-0.5", "3", "-0.875"];
        for (form, text, shown) in [
            (FactorForm::Proportional, "1.0625*n", "1.0625 n/(2π)"),
            (FactorForm::Linear, "1.0625*n - 0.5", "(1.0625 n - 0.5)/(2π)"),
            (FactorForm::Inverse, "1.0625*n - 0.5 + 3/n", "(1.0625 n - 0.5 + 3/n)/(2π)"),
            (
                FactorForm::InverseSquare,
                "1.0625*n - 0.5 + 3/n - 0.875/n^2",
                "(1.0625 n - 0.5 + 3/n - 0.875/n²)/(2π)",
            ),
            (FactorForm::Ratio, "1.0625*n - 0.5 + 3/(n - 0.875)", "(1.0625 n - 0.5 + 3/(n - 0.875))/(2π)"),
        ] {
            let factor = Factor::new(form, &p[..form.parameters()], 2).unwrap();
            let formula: Formula = format!("({text})/(2*pi)").parse().unwrap();
            assert!(factor.formula().is_identical(&formula), "{text}");
            assert_eq!(factor.to_string(), shown);
            assert_eq!(factor.line().is_some(), form.as_line().is_some());
        }
        assert!(Factor::new(FactorForm::Linear, &["1"], 2).is_none());
        assert!(Factor::new(FactorForm::Linear, &["1", "x"], 2).is_none());
        assert!(Factor::new(FactorForm::Linear, &["1", "1"], 0).is_none());
    }
}
