//! A simplex search that knows nothing of linear algebra, as a check on the linear fits.

use super::{FitError, Objective, Problem};
use argmin::core::{CostFunction, Error, Executor};
use argmin::solver::neldermead::NelderMead;

/// coef = a (n + d)/(divisor π): nonlinear in its unknowns, with the same optimum b = a d.
#[derive(Clone, Copy)]
struct ShiftedLine<'a> {
    problem: &'a Problem,
    objective: Objective,
}

impl CostFunction for ShiftedLine<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, unknowns: &Vec<f64>) -> Result<f64, Error> {
        let (a, d) = (unknowns[0], unknowns[1]);
        let divisor = f64::from(self.problem.divisor);
        let squares = self.problem.points.iter().map(|&(n, int)| {
            let value = a * (n + d);
            let miss = match self.objective {
                Objective::LsAbsolute => value - divisor / (2.0 * int),
                _ => value * 2.0 * int / divisor - 1.0,
            };
            miss * miss
        });
        Ok(squares.sum())
    }
}

/// (a, b) by Nelder and Mead's simplex from a start far from the optimum, for either sum of
/// squares.
///
/// # Errors
/// [`FitError::NoOptimum`] if the search ends without finite unknowns.
pub fn simplex_search(problem: &Problem, objective: Objective) -> Result<(f64, f64), FitError> {
    let failure = || FitError::NoOptimum { method: "the simplex search", case: problem.case.to_string() };
    problem.require(2)?;
    let cost = ShiftedLine { problem, objective };
    // Not collinear: from a collinear start the search would end on that line without a word.
    let mut simplex = vec![vec![0.5, 0.0], vec![2.0, 0.0], vec![1.0, 10.0]];
    let mut best = vec![1.0, 0.0];
    // Restarting from a fresh, smaller simplex escapes a collapsed one.
    for round in 0..4 {
        let solver = NelderMead::new(simplex).with_sd_tolerance(1e-30).map_err(|_| failure())?;
        let run = Executor::new(cost, solver)
            .configure(|state| state.max_iters(400))
            .ctrlc(false)
            .run()
            .map_err(|_| failure())?;
        best = run.state.best_param.ok_or_else(failure)?;
        let step = libm::pow(0.1, f64::from(round) + 1.0);
        let shifted = |i: usize| {
            let mut point = best.clone();
            point[i] += step;
            point
        };
        simplex = vec![best.clone(), shifted(0), shifted(1)];
    }
    let (a, b) = (best[0], best[0] * best[1]);
    if a.is_finite() && b.is_finite() { Ok((a, b)) } else { Err(failure()) }
}
