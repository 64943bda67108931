//! Linear least squares by QR.

use super::{FactorForm, FitError, Form, Objective, Problem};
use crate::integral::ScaledIntegral;
use nalgebra::{DMatrix, DVector};

/// (a, b) that minimise a sum of squares, by Householder QR in the basis n/n_max, 1.
///
/// Scaling the first column keeps the condition number near that of two lines crossing, where
/// raw n would square it away. [`Objective::Minimax`] and those after it have their own methods.
///
/// # Errors
/// [`FitError`] when the range is shorter than the unknowns, or for an objective that is no sum of squares.
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
    let form = FactorForm::from(form);
    problem.require(form.parameters() as u32)?;
    let failure = || FitError::NoOptimum { method: "QR", case: problem.case.to_string() };
    let p = by_qr(&problem.points, problem.divisor, objective, form).ok_or_else(failure)?;
    Ok((p[0], p.get(1).copied().unwrap_or(0.0)))
}

/// The parameters of a form, linear in them, that minimise a sum of squares over the integers from..=to.
///
/// # Errors
/// [`FitError::NoOptimum`] for fewer integers than parameters, for an objective that is no sum of squares,
/// and for the ratio.
pub(super) fn sum_of_squares(
    integral: &impl ScaledIntegral,
    (from, to): (u32, u32),
    objective: Objective,
    form: FactorForm,
) -> Result<Vec<f64>, FitError> {
    let points: Vec<(f64, f64)> =
        (from..=to).map(f64::from).map(|n| (n, integral.scaled(&(1.0 / n)) / n)).collect();
    let failure = || FitError::NoOptimum { method: "QR", case: integral.describe() };
    by_qr(&points, integral.divisor(), objective, form).ok_or_else(failure)
}

/// In the basis n/n_max, 1, n_min/n, (n_min/n)², whose columns are all of size 1.
fn by_qr(points: &[(f64, f64)], divisor: u32, objective: Objective, form: FactorForm) -> Option<Vec<f64>> {
    let (first, last) = (points.first()?.0, points.last()?.0);
    let (rows, columns) = (points.len(), form.parameters());
    if form == FactorForm::Ratio || rows < columns {
        return None;
    }
    let mut matrix = DMatrix::zeros(rows, columns);
    let mut target = DVector::zeros(rows);
    for (i, &(n, int)) in points.iter().enumerate() {
        let exact = f64::from(divisor) / (2.0 * int);
        let weight = match objective {
            Objective::LsAbsolute => 1.0,
            Objective::LsRelative => 1.0 / exact,
            Objective::Minimax | Objective::OneSided | Objective::OneSidedRounded => return None,
        };
        matrix[(i, 0)] = weight * n / last;
        let mut entry = weight;
        for k in 1..columns {
            matrix[(i, k)] = entry;
            entry *= first / n;
        }
        target[i] = weight * exact;
    }
    let qr = matrix.qr();
    // The reflections applied one by one: no product whose kernel is picked at run time.
    qr.q_tr_mul(&mut target);
    let right = target.rows(0, columns).into_owned();
    let solution = qr.r().solve_upper_triangular(&right)?;
    let mut scale = 1.0 / last;
    let mut parameters = Vec::with_capacity(columns);
    for (k, x) in solution.iter().enumerate() {
        parameters.push(if k == 0 { x / last } else { x * scale });
        scale = if k == 0 { 1.0 } else { scale * first };
    }
    parameters.iter().all(|p| p.is_finite()).then_some(parameters)
}
