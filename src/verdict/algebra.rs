//! Statements that are identities or inequalities between formulas: decided exactly.

use super::judgement::{Finding, Verdict};
use crate::bound::{Decision, Formula, Interval, Residual, less_for_all, normalises_exactly};
use crate::integral::{Case, Field, Limit, Lobe, scaled_bell};
use crate::kernel::model::Model;

/// 1/n as a formula.
fn reciprocal() -> Formula {
    Formula::int(1) / Formula::n()
}

/// 16 + n (c - 1) = 0 identically in n: the base of (1) vanishes at cos θ = c.
pub(super) fn lobe_zero(zero: &Formula) -> Finding {
    let base = Formula::int(16) + Formula::n() * (zero.clone() - Formula::int(1));
    let holds = base.numerator.is_zero();
    let witness = if holds {
        "16 + n (cos θ - 1) = 0 identically in n; for n ≥ 16 it lies in [0, 1)".to_owned()
    } else {
        "16 + n (cos θ - 1) is not 0 identically in n".to_owned()
    };
    Finding::truth(holds, None, witness)
}

/// 2π coef(n) Int(n) = 1 identically, Int of cosⁿ over the hemisphere.
pub(super) fn factor_identity(model: Model, factor: &Formula) -> Finding {
    let case = Case { model, lobe: Lobe::CosN, limit: Limit::Support };
    if normalises_exactly(case, factor) {
        let witness = "2π coef(n) Int(n) = 1 as polynomials in n and 2^(-n/2)".to_owned();
        return Finding::truth(true, Some(Interval::from(0.0)), witness);
    }
    let miss = Residual::new(case, factor).at(16.0);
    let verdict = if miss.contains(0.0) { Verdict::Undecided } else { Verdict::Refuted };
    let witness = format!("2π coef(n) Int(n) - 1 = {:.3e} at n = 16", miss.mid());
    Finding { printed: String::new(), computed: Some(miss), verdict, witness }
}

/// lower < upper for every real n from `from` on.
pub(super) fn factor_inequality(lower: &Formula, upper: &Formula, from: u32) -> Finding {
    match less_for_all(lower, upper, from) {
        Decision::Holds(steps) => {
            Finding::truth(true, None, format!("for every real n ≥ {from}; {}", steps.join("; ")))
        }
        Decision::Fails(n) => Finding::truth(false, None, format!("fails at n = {n}")),
        Decision::Open(reason) => {
            Finding { printed: String::new(), computed: None, verdict: Verdict::Undecided, witness: reason }
        }
    }
}

/// Equal integrands in the lobe's own angle, for any base at the limit (the variable h stands for
/// it) and the same angle, so the same limit.
pub(super) fn same_integral(model: Model, other: Model) -> Finding {
    let of = |model| scaled_bell(model, &reciprocal(), &Formula::h());
    let same = model.angle() == other.angle() && of(model).is_identical(&of(other));
    let witness = if same {
        "the integrals are the same polynomial in 1/n and the lobe's base at the limit"
    } else {
        "the integrals differ"
    };
    Finding::truth(same, None, witness.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Phong's integrand is the NDF's; Phong, modified, has another at the same angle, Blinn-Phong the half angle.
    #[test]
    fn integrals_are_the_same_by_integrand_and_angle() {
        let same = |model| same_integral(Model::Phong, model).verdict == Verdict::Proved;
        assert!(same(Model::Phong) && same(Model::BlinnPhongNdf));
        assert!(!same(Model::PhongModified) && !same(Model::BlinnPhong) && !same(Model::BlinnPhongModified));
    }
}
