//! Factors that never gain energy: residual ≤ 0 for every real n, certified after rounding.

use super::continuum::{Continuum, Sample};
use super::digits::{Decimal, round_to};
use super::exchange::Optimum;
use super::{Factor, FactorForm, FitError};
use crate::bound::{Extreme, Interval, Residual};
use crate::integral::ScaledIntegral;

/// Decimals tried, each a unit below the last: doubles choose the first so that rounding alone can
/// reject it.
const SINGLE: u32 = 4;
/// Then the step doubles so many times: a residual that is nearly the same for every n, because the form
/// is nearly exact, must come further down before its enclosures do.
const DOUBLED: u32 = 24;

/// The parameters of the form that never gains energy and loses least.
///
/// The minimax form divided by 1 + E, E its level. Its 1 + residual lies in [1 - E, 1 + E], so divided it
/// lies in [(1 - E)/(1 + E), 1]: nothing is gained and at most L = 2E/(1 + E) lost. No other form does
/// better: if one kept 1 + residual in [1 - L, 1], divided by 1 - L/2 it would keep |residual| ≤
/// L/(2 - L), which cannot be below E; and L/(2 - L) ≥ E is L ≥ 2E/(1 + E). Every form is closed under
/// division, which is all that this needs: p3 of the ratio stays, the other parameters are divided.
pub(super) fn optimum(form: FactorForm, minimax: &Optimum) -> Vec<f64> {
    let divided = |(k, p): (usize, &f64)| {
        if form == FactorForm::Ratio && k == 3 { *p } else { p / (1.0 + minimax.level) }
    };
    minimax.parameters.iter().enumerate().map(divided).collect()
}

/// 2E/(1 + E), enclosed: what the best one-sided form loses.
pub(super) fn least_loss(level: f64) -> Interval {
    if level == 0.0 {
        return Interval::from(0.0);
    }
    let level = Interval::from(level);
    Interval::from(2.0) * level / (Interval::from(1.0) + level)
}

/// Rounded to so many digits and certified: p1.. to nearest, p0 to the largest decimal for which
/// residual ≤ 0 is proved. One unit of its last digit more is refuted; only where a form is nearly exact
/// p0 comes further down (see [`DOUBLED`]).
///
/// # Errors
/// [`FitError::NoOptimum`] if no decimal is certified.
pub(super) fn rounded<I: ScaledIntegral + Clone>(
    continuum: &Continuum<'_, I>,
    form: FactorForm,
    parameters: &[f64],
    digits: usize,
) -> Result<(Factor, Extreme), FitError> {
    let mut texts: Vec<String> = parameters.iter().map(|p| round_to(*p, digits)).collect();
    let mut rest: Vec<f64> = texts.iter().map(|t| t.parse().unwrap_or(f64::NAN)).collect();
    rest[0] = 0.0;
    // residual ≤ 0 is p0 ≤ 1/g - (what the other terms give).
    let (at, least) = continuum.maximum(|s: Sample| form.per_n(&rest, &s.m) - 1.0 / s.g);
    let highest = -least + 4.0 * continuum.noise / at.g;
    let mut p0 = Decimal::floor(highest, digits, i32::MAX);
    let mut step = 1;
    for round in 0..SINGLE + DOUBLED {
        let Some(candidate) = p0.filter(|p| p.is_positive()) else { break };
        texts[0] = candidate.text();
        if let Some(found) = certified(continuum, form, &texts) {
            return Ok(found);
        }
        step = if round < SINGLE { 1 } else { 2 * step };
        p0 = Some((0..step).fold(candidate, |p, _| p.below(digits)));
    }
    Err(FitError::NoOptimum { method: "rounding down", case: continuum.integral.describe() })
}

/// The factor with its largest residual, if that is proved not to be positive.
pub(super) fn certified<I: ScaledIntegral + Clone>(
    continuum: &Continuum<'_, I>,
    form: FactorForm,
    texts: &[String],
) -> Option<(Factor, Extreme)> {
    let factor = Factor::new(form, texts, continuum.divisor)?;
    let (from, to) = continuum.reals.outward();
    let largest = Residual::new(continuum.integral.clone(), factor.formula()).largest(from, to);
    (largest.value.hi() <= 0.0).then_some((factor, largest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Reals;
    use crate::fit::exchange::minimax;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    #[test]
    fn dividing_the_minimax_form_makes_it_touch_from_below() {
        let case = Case { model: Model::BlinnPhong, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        for form in FactorForm::ALL {
            let best = minimax(&continuum, form).unwrap();
            let p = optimum(form, &best);
            let (_, largest) = continuum.maximum(continuum.residual(form, &p));
            let (_, loss) = continuum.maximum(|s| -continuum.residual(form, &p)(s));
            // Both are evened out to 1e-10 of the level, and rounding.
            let tolerance = 1e-9 * best.level + 4.0 * continuum.noise;
            assert!(largest.abs() < tolerance, "{}: {largest:e}", form.id());
            assert!((loss - least_loss(best.level).mid()).abs() < tolerance, "{}", form.id());
        }
    }

    #[test]
    fn the_first_parameter_is_the_largest_that_holds() {
        let case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        // (p0 + 0.94 m)(16/17)(1 - 8m/9) ≤ 1 at every m: tightest at m = 1/1024.
        let m = 1.0 / 1024.0;
        let highest = 1.0625 / (1.0 - 8.0 * m / 9.0) - 0.94 * m;
        let (factor, largest) = rounded(&continuum, FactorForm::Linear, &[1.0, 0.94], 6).unwrap();
        let p0: f64 = factor.parameters()[0].parse().unwrap();
        assert!(p0 <= highest && p0 + 1e-5 > highest, "{p0} against {highest}");
        assert!(largest.value.hi() <= 0.0 && largest.n == 1024.0);
        let up = format!("{:.5}", p0 + 1e-5);
        assert!(certified(&continuum, FactorForm::Linear, &[up, "0.94".into()]).is_none());
    }
}
