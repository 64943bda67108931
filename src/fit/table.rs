//! One fit from problem to certificate: solved twice, rounded, then certified.

use super::factor_row::shortest_factors;
use super::{
    FactorRow, FitError, Form, Line, Objective, Problem, Reals, fit_factor, least_squares, minimax,
    simplex_search,
};
use crate::bound::{Extremes, Residual};
use crate::integral::Case;

/// A fitted line with its certified residual.
#[derive(Clone, Debug, PartialEq)]
pub struct FitRow {
    /// Which integral.
    pub case: Case,
    /// What was minimised.
    pub objective: Objective,
    /// The line, rounded to the digits asked for.
    pub line: Line,
    /// Its residual over the integers of the range.
    pub integers: Extremes,
    /// Its residual over every real n of the range.
    pub reals: Extremes,
    /// Where a minimax residual alternates.
    pub alternation: Vec<f64>,
}

/// The largest distance between two methods' solutions, relative for a, to 1 for b.
const AGREEMENT: f64 = 1e-6;

/// Fits `problem`, rounds to `digits` significant decimals and certifies what was rounded.
///
/// Every linear least-squares fit is repeated by a nonlinear search. A one-sided fit is over every real n
/// of the range, as [`fit_factor`] makes it.
///
/// # Errors
/// [`FitError::Disagreement`] if the two differ by more than 1e-6; else what the methods report.
pub fn fit_case(
    problem: &Problem,
    objective: Objective,
    form: Form,
    digits: usize,
) -> Result<FitRow, FitError> {
    if Objective::ONE_SIDED.contains(&objective) {
        let range = Reals::new(f64::from(problem.from), f64::from(problem.to))?;
        let row = fit_factor(&problem.case, range, form.into(), objective, digits)?;
        return as_line(problem, row);
    }
    let (a, b, alternation) = if objective == Objective::Minimax {
        let best = minimax(problem, form)?;
        (best.a, best.b, best.alternation)
    } else {
        let (a, b) = least_squares(problem, objective, form)?;
        if form == Form::Linear {
            let (c, d) = simplex_search(problem, objective)?;
            if (a - c).abs() > AGREEMENT * a.abs() || (b - d).abs() > AGREEMENT * b.abs().max(1.0) {
                return Err(FitError::Disagreement {
                    case: format!("{}, {}", problem.case, objective.id()),
                    left: "QR",
                    found: format!("a = {a}, b = {b}"),
                    right: "the simplex search",
                    other: format!("a = {c}, b = {d}"),
                });
            }
        }
        (a, b, vec![])
    };
    let line = Line::rounded(a, b, problem.divisor, digits)
        .ok_or_else(|| FitError::NoOptimum { method: "rounding", case: problem.case.to_string() })?;
    let residual = Residual::new(problem.case, line.formula());
    Ok(FitRow {
        case: problem.case,
        objective,
        integers: residual.over_integers(problem.from, problem.to),
        reals: residual.over_reals(f64::from(problem.from), f64::from(problem.to)),
        line,
        alternation,
    })
}

/// The one-sided rows of the tables of lines: to `DIGITS`, then the shortest for each of `SHORT_DIGITS`; b = 0
/// where that suffices, as [`super::factor_rows`] decides.
///
/// # Errors
/// As for [`super::factor_rows`].
pub fn one_sided_lines(problem: &Problem) -> Result<Vec<FitRow>, FitError> {
    let range = Reals::new(f64::from(problem.from), f64::from(problem.to))?;
    shortest_factors(&problem.case, range)?.into_iter().map(|row| as_line(problem, row)).collect()
}

/// The same row with its residual over the integers beside that over the reals.
fn as_line(problem: &Problem, row: FactorRow) -> Result<FitRow, FitError> {
    let failure = || FitError::NoOptimum { method: "rounding", case: problem.case.to_string() };
    let line = row.factor.line().ok_or_else(failure)?;
    let residual = Residual::new(problem.case, line.formula());
    Ok(FitRow {
        case: problem.case,
        objective: row.objective,
        integers: residual.over_integers(problem.from, problem.to),
        reals: row.extremes,
        line,
        alternation: row.alternation,
    })
}
