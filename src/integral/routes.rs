//! The three routes side by side, and the check that they agree.

use super::{Case, Estimate, GaussTable, closed_form, double_exponential, gauss_legendre};
use thiserror::Error;

/// How far two routes may differ, relative: each is good to a few hundred ε.
pub const AGREEMENT: f64 = 1e-12;

/// One Int(n) by every route.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Routes {
    /// The closed form.
    pub closed: f64,
    /// Gauss-Legendre in w.
    pub gauss: f64,
    /// Double exponential in θ.
    pub exponential: Estimate,
}

/// Two routes that differ by more than [`AGREEMENT`].
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "Int({n}) of {case}: {left} gives {a:e}, {right} gives {b:e}: they differ by {relative:e}, more than {AGREEMENT:e}"
)]
pub struct Disagreement {
    /// The integral in question, as text.
    pub case: String,
    /// The specular exponent.
    pub n: f64,
    /// One route.
    pub left: &'static str,
    /// Its value.
    pub a: f64,
    /// The other route.
    pub right: &'static str,
    /// Its value.
    pub b: f64,
    /// Their relative difference.
    pub relative: f64,
}

impl Routes {
    /// Evaluates all three.
    pub fn evaluate(case: Case, n: f64, table: &mut GaussTable) -> Self {
        Routes {
            closed: closed_form(case, n),
            gauss: gauss_legendre(case, n, table),
            exponential: double_exponential(case, n),
        }
    }

    /// # Errors
    /// The first pair that differs by more than [`AGREEMENT`]; a NaN always differs.
    pub fn agree(&self, case: Case, n: f64) -> Result<(), Disagreement> {
        let named = [
            ("the closed form", self.closed),
            ("Gauss-Legendre", self.gauss),
            ("double exponential", self.exponential.value),
        ];
        for (i, &(left, a)) in named.iter().enumerate() {
            for &(right, b) in &named[i + 1..] {
                let relative = (a - b).abs() / a.abs();
                if relative.is_nan() || relative > AGREEMENT {
                    let case = case.to_string();
                    return Err(Disagreement { case, n, left, a, right, b, relative });
                }
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_routes_agree_at_the_corners() {
        let mut table = GaussTable::default();
        for case in Case::all() {
            for n in [16.0, 17.0, 54.0, 55.0, 54.625, 777.75, 1024.0] {
                Routes::evaluate(case, n, &mut table).agree(case, n).unwrap();
            }
        }
    }

    #[test]
    fn a_planted_error_is_seen_and_named() {
        let mut table = GaussTable::default();
        for case in Case::all() {
            let sound = Routes::evaluate(case, 100.0, &mut table);
            let nudged = 1.0 + 3.0 * AGREEMENT;
            let mut wrong = [sound; 4];
            wrong[0].closed *= nudged;
            wrong[1].gauss *= nudged;
            wrong[2].exponential.value *= nudged;
            wrong[3].gauss = f64::NAN;
            for planted in wrong {
                let error = planted.agree(case, 100.0).unwrap_err();
                assert!(
                    error.to_string().contains(case.model.id()) && error.to_string().contains("Int(100)")
                );
            }
        }
    }
}
