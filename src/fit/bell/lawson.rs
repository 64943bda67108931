//! Weighted least squares whose weights grow where the residual is large: towards the least maximum.

use nalgebra::{DMatrix, DVector};

/// One row of a linearised problem: the residual and its derivatives by the unknowns.
pub(super) struct Row {
    pub(super) residual: f64,
    pub(super) slopes: Vec<f64>,
}

/// A problem with residuals whose maximum is to be small.
pub(super) trait Minimize {
    /// Residuals at the unknowns, always as many.
    fn residuals(&self, x: &[f64]) -> Vec<Row>;
}

/// Largest change of an unknown in one step; the problems are scaled to unknowns around 1.
const STRIDE: f64 = 0.3;
/// Keeps unknowns that hardly matter from running away.
const RIDGE: f64 = 1e-4;

/// Gauss-Newton steps with Lawson's weights, w ← w |r|^0.7; the best unknowns met, and their largest
/// |residual|.
///
/// Source: C. L. Lawson, "Contributions to the theory of linear least maximum approximations", thesis,
/// UCLA, 1961, for the weights; here about a linearised problem.
pub(super) fn lawson(problem: &impl Minimize, start: &[f64], steps: u32) -> (Vec<f64>, f64) {
    let mut x = start.to_vec();
    let unknowns = x.len();
    let mut weights: Vec<f64> = problem.residuals(&x).iter().map(|_| 1.0).collect();
    let mut best = (x.clone(), f64::INFINITY);
    for _ in 0..steps {
        let residuals = problem.residuals(&x);
        let largest = residuals.iter().map(|r| r.residual.abs()).fold(0.0, f64::max);
        if largest < best.1 {
            best = (x.clone(), largest);
        }
        let total: f64 = weights.iter().sum();
        let scale = weights.len() as f64 / total;
        for (weight, row) in weights.iter_mut().zip(&residuals) {
            *weight = *weight * scale * libm::pow(row.residual.abs(), 0.7) + 1e-12;
        }
        // Normal equations, summed in order; the ridge keeps them regular.
        let mut matrix = DMatrix::<f64>::identity(unknowns, unknowns) * (RIDGE * RIDGE);
        let mut right = DVector::<f64>::zeros(unknowns);
        for (weight, row) in weights.iter().zip(&residuals) {
            for i in 0..unknowns {
                right[i] -= weight * row.slopes[i] * row.residual;
                for j in 0..unknowns {
                    matrix[(i, j)] += weight * row.slopes[i] * row.slopes[j];
                }
            }
        }
        let Some(step) = matrix.lu().solve(&right) else { break };
        let longest = step.iter().map(|d| d.abs()).fold(0.0, f64::max);
        if !longest.is_finite() || longest == 0.0 {
            break;
        }
        let share = (STRIDE / longest).min(1.0);
        for (value, change) in x.iter_mut().zip(step.iter()) {
            *value += share * change;
        }
    }
    best
}
