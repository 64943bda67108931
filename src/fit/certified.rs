//! The least-squares solution itself, enclosed: what a fit's digits are, beyond any doubt about
//! rounding.
//!
//! A fit can end within 1e-16 of a printed tie (1.0625 for Phong: is that 1.062 or 1.063?), so the
//! normal equations are solved in 128-bit fixed-point intervals, and exactly where the data are a
//! line.

use super::{FitError, Form, Objective, Problem};
use crate::bound::Fixed;
use crate::integral::{Case, Field, Limit, Lobe, scaled_bell, scaled_closed_form};
use crate::kernel::model::LobeAngle;
use dashu_ratio::RBig;

/// Enclosures of a and b, ends included; b is 0 in the proportional form.
#[derive(Clone, Debug, PartialEq)]
pub struct CertifiedFit {
    /// (lowest, highest) a.
    pub a: (RBig, RBig),
    /// (lowest, highest) b.
    pub b: (RBig, RBig),
}

/// n Int(n) for the integers of the problem's range: what [`certified_least_squares`] fits, and the
/// costly part of it.
pub fn scaled_integrals(problem: &Problem) -> Vec<Fixed> {
    let at = |n: u32| scaled_closed_form(problem.case, &(Fixed::int(1) / Fixed::int(i64::from(n))));
    (problem.from..=problem.to).map(at).collect()
}

/// Encloses the least-squares line over the integers of the problem's range, given their
/// [`scaled_integrals`].
///
/// # Errors
/// [`FitError`] for a minimax objective or too short a range.
pub fn certified_least_squares(
    problem: &Problem,
    scaled: &[Fixed],
    objective: Objective,
    form: Form,
) -> Result<CertifiedFit, FitError> {
    problem.require(if form == Form::Linear { 2 } else { 1 })?;
    if let Some((a, b)) = exact_line(problem)
        && (form == Form::Linear || b.is_zero())
    {
        // Zero is the least sum of squares there is, under any weights.
        return Ok(CertifiedFit { a: (a.clone(), a), b: (b.clone(), b) });
    }
    let half_divisor = Fixed::int(i64::from(problem.divisor)) / Fixed::int(2);
    let zero = || Fixed::int(0);
    // Normal equations of min Σ (a p + b q - r)².
    let (mut pp, mut pq, mut qq, mut pr, mut qr) = (zero(), zero(), zero(), zero(), zero());
    for (n, scaled) in (problem.from..=problem.to).zip(scaled) {
        let (n, scaled) = (Fixed::int(i64::from(n)), scaled.clone());
        let (p, q, r) = match objective {
            Objective::LsAbsolute => (n.clone(), Fixed::int(1), half_divisor.clone() * n / scaled),
            Objective::LsRelative => {
                let p = scaled / half_divisor.clone();
                (p.clone(), p / n, Fixed::int(1))
            }
            Objective::Minimax | Objective::OneSided | Objective::OneSidedRounded => {
                let case = problem.case.to_string();
                return Err(FitError::NoOptimum { method: "least squares", case });
            }
        };
        pp = pp + p.clone() * p.clone();
        pr = pr + p.clone() * r.clone();
        pq = pq + p * q.clone();
        qq = qq + q.clone() * q.clone();
        qr = qr + q * r;
    }
    if form == Form::Proportional {
        let none = (RBig::int(0), RBig::int(0));
        return Ok(CertifiedFit { a: (pr / pp).ends(), b: none });
    }
    let determinant = pp.clone() * qq.clone() - pq.clone() * pq.clone();
    let a = (pr.clone() * qq - qr.clone() * pq.clone()) / determinant.clone();
    let b = (pp * qr - pq * pr) / determinant;
    Ok(CertifiedFit { a: a.ends(), b: b.ends() })
}

/// (a, b) if divisor/(2 Int(n)) = a n + b exactly for every n of the range, decided in rationals;
/// only where the closed form is rational in n.
fn exact_line(problem: &Problem) -> Option<(RBig, RBig)> {
    let Case { model, lobe, limit } = problem.case;
    let vanishes_at_the_limit = matches!(limit, Limit::ExactZero | Limit::Support)
        && model.angle() == LobeAngle::Full
        && lobe == Lobe::Cs16
        && problem.from >= 16;
    if !vanishes_at_the_limit {
        return None;
    }
    let exact = |n: u32| {
        let n = RBig::int(i64::from(n));
        let scaled = scaled_bell(model, &(RBig::int(1) / n.clone()), &RBig::int(0));
        RBig::int(i64::from(problem.divisor)) * n / (RBig::int(2) * scaled)
    };
    let (first, last) = (exact(problem.from), exact(problem.to));
    let span = RBig::int(i64::from(problem.to - problem.from));
    if span.is_zero() {
        return None;
    }
    let a = (last - first.clone()) / span;
    let b = first - a.clone() * RBig::int(i64::from(problem.from));
    let on_the_line = |n: u32| exact(n) == a.clone() * RBig::int(i64::from(n)) + b.clone();
    (problem.from..=problem.to).all(on_the_line).then_some((a, b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::model::Model;

    #[test]
    fn phong_is_exactly_seventeen_sixteenths() {
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
        let problem = Problem::new(case, 16, 1024).unwrap();
        let fit = certified_least_squares(
            &problem,
            &scaled_integrals(&problem),
            Objective::LsAbsolute,
            Form::Linear,
        )
        .unwrap();
        let exact = RBig::int(17) / RBig::int(16);
        assert_eq!(fit.a, (exact.clone(), exact));
        assert_eq!(fit.b, (RBig::int(0), RBig::int(0)));
    }

    #[test]
    fn at_the_papers_limit_phong_lies_beside_the_tie() {
        // 6/√n lets (1 - t/16)^17/17 with t > 16 in, so Int is larger and a smaller than 17/16.
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Paper };
        let problem = Problem::new(case, 16, 1024).unwrap();
        let fit = certified_least_squares(
            &problem,
            &scaled_integrals(&problem),
            Objective::LsAbsolute,
            Form::Proportional,
        )
        .unwrap();
        let tie = RBig::int(17) / RBig::int(16);
        assert!(fit.a.1 < tie, "the side of the tie is decided");
        assert!(tie - fit.a.0 < crate::bound::power_of_ten(-14));
    }
}
