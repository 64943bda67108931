//! The line of least maximal |residual|, by exchange.

use super::{FitError, Form, Problem};

/// A minimax fit with its witness.
#[derive(Clone, Debug, PartialEq)]
pub struct Minimax {
    /// Slope.
    pub a: f64,
    /// Intercept, 0 for the proportional form.
    pub b: f64,
    /// The largest |residual|.
    pub level: f64,
    /// The n at which residuals of alternating sign reach the level: by Chebyshev's theorem no
    /// other line does better. Empty when the level is rounding (the line is exact).
    pub alternation: Vec<f64>,
}

/// Residuals below this are rounding: a few hundred ε of 1.
const ROUNDING: f64 = 1e-13;

/// min over (a, b) of max |a p + b q - 1| with p, q the [`Problem::columns`].
///
/// p/q = n is monotone and q > 0, so {p, q} is a Chebyshev system and the optimum the one line
/// whose residual reaches its maximum with alternating signs once more often than it has unknowns.
/// Remez' exchange, checked at the end for that alternation.
///
/// # Errors
/// [`FitError`] when the range is too short or the exchange does not end in an alternation.
pub fn minimax(problem: &Problem, form: Form) -> Result<Minimax, FitError> {
    let columns: Vec<(f64, f64)> = problem.columns().collect();
    let failure = || FitError::NoOptimum { method: "exchange", case: problem.case.to_string() };
    let n_at = |i: usize| problem.points[i].0;
    let unknowns = match form {
        Form::Linear => 2,
        Form::Proportional => 1,
    };
    problem.require(unknowns + 1)?;
    if form == Form::Proportional {
        // |a p - 1| is largest at the extremes of p: balance them.
        let by_p = |i: &usize, j: &usize| columns[*i].0.total_cmp(&columns[*j].0);
        let low = (0..columns.len()).min_by(by_p).ok_or_else(failure)?;
        let high = (0..columns.len()).max_by(by_p).ok_or_else(failure)?;
        let a = 2.0 / (columns[low].0 + columns[high].0);
        let level = (a * columns[high].0 - 1.0).abs();
        let alternation = if level < ROUNDING { vec![] } else { vec![n_at(low), n_at(high)] };
        return Ok(Minimax { a, b: 0.0, level, alternation });
    }
    let residual = |a: f64, b: f64, i: usize| a * columns[i].0 + b * columns[i].1 - 1.0;
    let last = columns.len() - 1;
    let mut reference = [0, last / 2, last];
    for _ in 0..50 {
        let (a, b, level) = levelled(&columns, reference).ok_or_else(failure)?;
        let extremes = alternating_extremes(columns.len(), |i| residual(a, b, i));
        let worst = extremes.iter().map(|&i| residual(a, b, i).abs()).fold(0.0, f64::max);
        if worst < ROUNDING {
            return Ok(Minimax { a, b, level: worst, alternation: vec![] });
        }
        // Rounding moves the residuals by some ε; relative to the level that is what remains.
        if worst <= level.abs() * (1.0 + 1e-9) + 4.0 * f64::EPSILON {
            return Ok(Minimax { a, b, level: worst, alternation: reference.map(n_at).to_vec() });
        }
        reference = best_three(&extremes, |i| residual(a, b, i).abs()).ok_or_else(failure)?;
    }
    Err(failure())
}

/// a, b, h with a p + b q - 1 = h, -h, h at the three reference points, by Cramer's rule.
fn levelled(columns: &[(f64, f64)], reference: [usize; 3]) -> Option<(f64, f64, f64)> {
    let [x, y, z] = reference.map(|i| columns[i]);
    // Sum and difference eliminate h: (x + y)·(a, b) = 2 and (y + z)·(a, b) = 2.
    let (p, q) = ((x.0 + y.0, x.1 + y.1), (y.0 + z.0, y.1 + z.1));
    let determinant = p.0 * q.1 - p.1 * q.0;
    let (a, b) = (2.0 * (q.1 - p.1) / determinant, 2.0 * (p.0 - q.0) / determinant);
    (a.is_finite() && b.is_finite()).then_some((a, b, a * x.0 + b * x.1 - 1.0))
}

/// One index per run of equal sign, where |f| is largest in the run.
fn alternating_extremes(count: usize, f: impl Fn(usize) -> f64) -> Vec<usize> {
    let mut extremes: Vec<usize> = Vec::new();
    for i in 0..count {
        match extremes.last_mut() {
            Some(last) if (f(*last) < 0.0) == (f(i) < 0.0) => {
                if f(i).abs() > f(*last).abs() {
                    *last = i;
                }
            }
            _ => extremes.push(i),
        }
    }
    extremes
}

/// The three neighbours in an alternation that hold the largest value and whose least is largest.
fn best_three(extremes: &[usize], size: impl Fn(usize) -> f64) -> Option<[usize; 3]> {
    let least = |w: &[usize]| w.iter().map(|&i| size(i)).fold(f64::INFINITY, f64::min);
    let top = extremes.iter().map(|&i| size(i)).fold(0.0, f64::max);
    extremes
        .windows(3)
        .filter(|w| w.iter().any(|&i| size(i) == top))
        .max_by(|v, w| least(v).total_cmp(&least(w)))
        .map(|w| [w[0], w[1], w[2]])
}
