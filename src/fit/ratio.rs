//! The best ratio p0 n + p1 + p2/(n + p3): rational in m = 1/n.

use super::continuum::{Continuum, Sample, golden_section};
use super::exchange::{Optimum, alternation, exchange, spread};
use super::{FactorForm, FitError};
use crate::integral::ScaledIntegral;
use nalgebra::{DMatrix, DVector};

/// n_min + p3 is n_min 2^u: where u is searched. The pole n = -p3 comes no closer to the range than
/// n_min/64, and beyond 64 n_min the last term is a constant but for its rounding.
const POLES: (f64, f64) = (-6.0, 6.0);
/// Newton steps and exchanges after which there is something wrong; five are usual.
const MOST: u32 = 40;
/// How evenly the extremes are levelled, relative.
const EVEN: f64 = 1e-10;

/// min over p0..p3, n + p3 > 0, of max |residual| over every real n of the range.
///
/// coef(n)/n is P(m)/Q(m) with P quadratic and Q = 1 + p3 m, and every such quotient is a ratio. Of
/// those without a pole in the range one is best, and it is the one whose residual reaches its maximum
/// at 5 points with alternating signs (Achieser; 5 = 2 + 1 + 2 - d for degrees 2 and 1, defect d = 0).
///
/// |g P - Q| ≤ λ Q are linear in (P, Q), so the Q for which a P keeps the level λ are a convex set, and
/// the least level as a function of p3 falls and then rises: p3 is found by golden section over the
/// linear problem, then all four parameters are polished by Newton's method on the 5 points' equations
/// inside an exchange. Five alternations, once found, prove it best among all without a pole in the range.
pub(super) fn minimax<I: ScaledIntegral>(continuum: &Continuum<'_, I>) -> Result<Optimum, FitError> {
    let failure = || FitError::NoOptimum { method: "rational exchange", case: continuum.integral.describe() };
    let pole = |u: f64| continuum.reals.from() * (libm::exp2(u) - 1.0);
    let level = |u: f64| exchange(continuum, FactorForm::Ratio, pole(u)).map_or(f64::INFINITY, |o| o.level);
    let best = golden_section(POLES, level);
    let start = exchange(continuum, FactorForm::Ratio, pole(best)).ok_or_else(failure)?;
    if start.alternation.is_empty() {
        return Ok(start);
    }
    polish(continuum, start).ok_or_else(failure)
}

fn polish<I: ScaledIntegral>(continuum: &Continuum<'_, I>, start: Optimum) -> Option<Optimum> {
    let extremes_of = |p: &[f64]| continuum.alternating_extremes(continuum.residual(FactorForm::Ratio, p));
    let mut parameters = start.parameters;
    let mut level = start.level;
    // At the best p3 a fifth extreme has grown to the level of the four, or nearly.
    let mut reference = alternation(&extremes_of(&parameters), 5).unwrap_or_else(|| spread(continuum, 5));
    for _ in 0..MOST {
        (parameters, level) = levelled(continuum, &reference, parameters, level)?;
        let extremes = extremes_of(&parameters);
        let worst = extremes.iter().map(|e| e.1.abs()).fold(0.0, f64::max);
        let rounding = continuum.rounding(FactorForm::Ratio, &parameters);
        if worst <= 2.0 * rounding {
            return Some(Optimum { parameters, level: worst, alternation: vec![] });
        }
        if worst <= level.abs() * (1.0 + EVEN) + rounding {
            let at = reference.iter().map(|s| continuum.n(s.m)).collect();
            return Some(Optimum { parameters, level: worst, alternation: at });
        }
        reference = alternation(&extremes, 5)?;
    }
    None
}

/// The ratio whose residual is h, -h, h, -h, h at five points, and h: Newton's method on
/// g P - (1 ± h) Q = 0, quadratic in its unknowns, in x = m/m_max.
fn levelled<I: ScaledIntegral>(
    continuum: &Continuum<'_, I>,
    reference: &[Sample],
    p: Vec<f64>,
    level: f64,
) -> Option<(Vec<f64>, f64)> {
    let scale = continuum.reals.in_m().1;
    let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    // P = c0 + c1 x + c2 x², Q = 1 + q x.
    let (s, q) = (scale, p[3] * scale);
    let first = reference.first()?;
    let starts_above = FactorForm::Ratio.per_n(&p, &first.m) * first.g > 1.0;
    let mut unknowns = [
        p[0],
        (p[1] + p[0] * p[3]) * s,
        (p[2] + p[1] * p[3]) * s * s,
        q,
        if starts_above { level.abs() } else { -level.abs() },
    ];
    let mut last = f64::INFINITY;
    for _ in 0..MOST {
        let [c0, c1, c2, q, h] = unknowns;
        let mut matrix = DMatrix::zeros(5, 5);
        let mut target = DVector::zeros(5);
        for (i, sample) in reference.iter().enumerate() {
            let (x, g) = (sample.m / scale, sample.g);
            let wanted = 1.0 + sign(i) * h;
            let row = [g, g * x, g * x * x, -x * wanted, -sign(i) * (1.0 + q * x)];
            for (j, entry) in row.into_iter().enumerate() {
                matrix[(i, j)] = entry;
            }
            target[i] = wanted * (1.0 + q * x) - g * (c0 + x * (c1 + x * c2));
        }
        let step = matrix.lu().solve(&target)?;
        for (unknown, change) in unknowns.iter_mut().zip(step.iter()) {
            *unknown += change;
        }
        let size = step.iter().zip(&unknowns).map(|(d, u)| (d / u.abs().max(1.0)).abs()).fold(0.0, f64::max);
        // Quadratic, until rounding ends the fall.
        if size == 0.0 || (size >= 0.5 * last && size < 1e-6) {
            break;
        }
        last = size;
    }
    let [c0, c1, c2, q, h] = unknowns;
    let p3 = q / scale;
    let p1 = c1 / scale - c0 * p3;
    let p2 = c2 / (scale * scale) - p1 * p3;
    let sound = unknowns.iter().all(|u| u.is_finite()) && q > -1.0;
    sound.then(|| (vec![c0, p1, p2, p3], h))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Reals;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    /// Phong (modified): 1/Int = (17/16) n/(1 - 8/(9n)) = (17/16)(n + 8/9 + (64/81)/(n - 8/9)), a ratio.
    #[test]
    fn an_integral_that_is_a_ratio_is_found() {
        let case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        let found = minimax(&continuum).unwrap();
        assert!(found.level < 1e-13 && found.alternation.is_empty(), "{found:?}");
        let exact = [1.0625, 17.0 / 18.0, 17.0 * 64.0 / (16.0 * 81.0), -8.0 / 9.0];
        // What p3 is wrong by changes the residual by less than 1e-5 of it: ε comes back as 1e-11.
        for (p, (expected, tolerance)) in
            found.parameters.iter().zip(exact.iter().zip([1e-14, 1e-11, 1e-9, 1e-8]))
        {
            assert!((p - expected).abs() < tolerance, "{found:?}");
        }
    }

    #[test]
    fn the_residual_alternates_five_times() {
        for model in [Model::BlinnPhong, Model::BlinnPhongModified] {
            let case = Case { model, lobe: Lobe::Cs16, limit: Limit::Support };
            let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
            let found = minimax(&continuum).unwrap();
            assert_eq!(found.alternation.len(), 5, "{model:?}");
            let inverse = exchange(&continuum, FactorForm::Inverse, 0.0).unwrap();
            assert!(found.level < inverse.level, "{model:?}: {} {}", found.level, inverse.level);
        }
    }
}
