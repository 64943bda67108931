//! Linear least squares by QR.

use super::{FitError, Form, Objective, Problem};
use nalgebra::{DMatrix, DVector};

/// (a, b) that minimise a sum of squares, by Householder QR in the basis n/n_max, 1.
///
/// Scaling the first column keeps the condition number near that of two lines crossing, where
/// raw n would square it away. [`Objective::Minimax`] has its own method.
///
/// # Errors
/// [`FitError`] when the range is shorter than the unknowns, or for a minimax objective.
///
/// ```
/// use bellfit::{fit::*, integral::{Case, Limit, Lobe}, kernel::model::Model};
/// let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
/// let problem = Problem::new(case, 16, 1024)?;
/// let (a, b) = least_squares(&problem, Objective::LsRelative, Form::Linear)?;
/// assert!((a - 17.0 / 16.0).abs() < 1e-13 && b.abs() < 1e-10); // exactly (17/16) n
/// # Ok::<(), FitError>(())
/// ```
pub fn least_squares(problem: &Problem, objective: Objective, form: Form) -> Result<(f64, f64), FitError> {
    let failure = || FitError::NoOptimum { method: "QR", case: problem.case.to_string() };
    let columns = match form {
        Form::Linear => 2,
        Form::Proportional => 1,
    };
    problem.require(columns as u32)?;
    let largest = f64::from(problem.to);
    let rows = problem.points.len();
    let mut matrix = DMatrix::zeros(rows, columns);
    let mut target = DVector::zeros(rows);
    for (i, &(n, int)) in problem.points.iter().enumerate() {
        let exact = f64::from(problem.divisor) / (2.0 * int);
        let weight = match objective {
            Objective::LsAbsolute => 1.0,
            Objective::LsRelative => 1.0 / exact,
            Objective::Minimax => return Err(failure()),
        };
        matrix[(i, 0)] = weight * n / largest;
        if columns == 2 {
            matrix[(i, 1)] = weight;
        }
        target[i] = weight * exact;
    }
    let qr = matrix.qr();
    // The reflections applied one by one: no product whose kernel is picked at run time.
    qr.q_tr_mul(&mut target);
    let right = target.rows(0, columns).into_owned();
    let solution = qr.r().solve_upper_triangular(&right).ok_or_else(failure)?;
    let (a, b) = (solution[0] / largest, if columns == 2 { solution[1] } else { 0.0 });
    if a.is_finite() && b.is_finite() { Ok((a, b)) } else { Err(failure()) }
}
