//! The bells for e⁻ᵗ.

use super::cost::{Cost, operations};
use super::exchange::polish;
use super::shape::Shape;
use crate::bound::{BellProof, Supremum, exponential_bell};
use crate::fit::FitError;
use crate::fit::digits::round_to;

/// Powers that are fitted.
const POWERS: [u32; 5] = [2, 4, 8, 16, 32];
/// To which the error is enclosed, relative: six digits.
const TOLERANCE: f64 = 1e-6;
/// Significant decimals that are kept and certified.
const DIGITS: usize = 12;

/// A bell for e⁻ᵗ with its certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct ExponentialBell {
    /// Whether it is Lyon's (1 - t/K)^K as the papers take it, and not a fit.
    pub printed: bool,
    /// The shape of p.
    pub shape: Shape,
    /// K.
    pub power: u32,
    /// c₁, c₂, c₃ of p = 1 - c₁ z + c₂ z² - c₃ z³, z = t/K, rounded to 12 digits.
    pub coefficients: [f64; 3],
    /// T: the first zero, or where a jumping bell is cut.
    pub cut: f64,
    /// The polished level before rounding, an estimate of the best that the shape can do; of a printed
    /// bell its own error.
    pub level: f64,
    /// t of its alternating extremes; none of a printed bell.
    pub alternation: Vec<f64>,
    /// sup over all t ≥ 0 of |e⁻ᵗ - bell|.
    pub error: Supremum<1>,
    /// What is proved of its form.
    pub proof: BellProof,
    /// Operations.
    pub cost: Cost,
}

/// Lyon's bells for K = 4, 8, 16 and 32, then every shape and power, fitted, rounded and certified.
///
/// # Errors
/// [`FitError::NoOptimum`] if a fit does not end in an alternation.
pub fn exponential_bells() -> Result<Vec<ExponentialBell>, FitError> {
    let mut rows = [4, 8, 16, 32].into_iter().map(printed).collect::<Result<Vec<_>, _>>()?;
    for shape in Shape::ALL {
        for power in POWERS {
            // The best jumping p at K = 2 turns before its cut: no bell.
            if (shape, power) != (Shape::Jump, 2) {
                rows.push(fitted(shape, power)?);
            }
        }
    }
    Ok(rows)
}

fn printed(power: u32) -> Result<ExponentialBell, FitError> {
    let coefficients = [1.0, 0.0, 0.0];
    let (error, proof) =
        exponential_bell(power, coefficients, None, 1e-8).ok_or_else(|| uncertified(power))?;
    Ok(ExponentialBell {
        printed: true,
        shape: Shape::Linear,
        power,
        coefficients,
        cut: f64::from(power),
        level: error.value.mid(),
        alternation: Vec::new(),
        error,
        proof,
        cost: operations(1, power, false),
    })
}

pub(super) fn uncertified(power: u32) -> FitError {
    FitError::NoOptimum { method: "the certificate", case: format!("K = {power}") }
}

fn fitted(shape: Shape, power: u32) -> Result<ExponentialBell, FitError> {
    let best = polish(shape, power)?;
    let coefficients = best.piece.scaled(power).map(|c| rounded(c, DIGITS));
    let jump = (!shape.is_continuous()).then(|| rounded(best.piece.reach, DIGITS));
    let (error, proof) = exponential_bell(power, coefficients, jump, TOLERANCE * best.level)
        .ok_or_else(|| uncertified(power))?;
    let cut = rounded(proof.cut.mid(), DIGITS);
    Ok(ExponentialBell {
        printed: false,
        shape,
        power,
        coefficients,
        cut,
        level: best.level,
        alternation: best.alternation,
        error,
        proof,
        cost: operations(shape.degree(), power, false),
    })
}

/// x to so many significant decimals.
pub(super) fn rounded(x: f64, digits: usize) -> f64 {
    round_to(x, digits).parse().unwrap_or(x)
}
