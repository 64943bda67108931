//! The form of least maximal |residual| over every real n of a range, by exchange.

use super::continuum::{Continuum, Sample};
use super::{FactorForm, FitError, ratio};
use crate::integral::ScaledIntegral;
use nalgebra::{DMatrix, DVector};

/// A minimax fit over reals with its witness.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Optimum {
    /// As many as the form has.
    pub parameters: Vec<f64>,
    /// The largest |residual|.
    pub level: f64,
    /// The n, falling, at which residuals of alternating sign reach the level; empty when the level is
    /// rounding (the form is exact).
    pub alternation: Vec<f64>,
}

/// Exchanges after which there is something wrong; five are usual.
const MOST: u32 = 60;
/// How evenly the extremes are levelled, relative: golden section finds a value to less.
const EVEN: f64 = 1e-10;

/// min over the parameters of max |residual| over every real n of the range.
///
/// In m = 1/n the residual is g(m) P(m) - 1 with g > 0 and P a polynomial of k coefficients, so the
/// functions g, m g, m² g, … are a Chebyshev system and the optimum is the one P whose residual reaches
/// its maximum at k + 1 points with alternating signs. Remez' exchange, checked at the end for that
/// alternation. The ratio is rational in m: see [`ratio::minimax`].
///
/// A form whose simpler form is exact already is that, with zeros.
///
/// # Errors
/// [`FitError::NoOptimum`] when the exchange does not end in an alternation.
pub(super) fn minimax<I: ScaledIntegral>(
    continuum: &Continuum<'_, I>,
    form: FactorForm,
) -> Result<Optimum, FitError> {
    if let Some(simpler) = form.simpler() {
        let mut found = minimax(continuum, simpler)?;
        if found.alternation.is_empty() {
            found.parameters.resize(form.parameters(), 0.0);
            return Ok(found);
        }
    }
    let failure = || FitError::NoOptimum { method: "exchange", case: continuum.integral.describe() };
    match form {
        FactorForm::Ratio => ratio::minimax(continuum),
        _ => exchange(continuum, form, 0.0).ok_or_else(failure),
    }
}

/// Remez' exchange for a form linear in its parameters; for the ratio, with p3 = `pole` held fixed.
pub(super) fn exchange<I: ScaledIntegral>(
    continuum: &Continuum<'_, I>,
    form: FactorForm,
    pole: f64,
) -> Option<Optimum> {
    let free = if form == FactorForm::Ratio { 3 } else { form.parameters() };
    let mut reference = spread(continuum, free + 1);
    for _ in 0..MOST {
        let (mut parameters, level) = levelled(continuum, &reference, form, pole)?;
        if form == FactorForm::Ratio {
            parameters.push(pole);
        }
        let extremes = continuum.alternating_extremes(continuum.residual(form, &parameters));
        let worst = extremes.iter().map(|e| e.1.abs()).fold(0.0, f64::max);
        let rounding = continuum.rounding(form, &parameters);
        if worst <= 2.0 * rounding {
            return Some(Optimum { parameters, level: worst, alternation: vec![] });
        }
        if worst <= level.abs() * (1.0 + EVEN) + rounding {
            let at = reference.iter().map(|s| continuum.n(s.m)).collect();
            return Some(Optimum { parameters, level: worst, alternation: at });
        }
        reference = alternation(&extremes, free + 1)?;
    }
    None
}

/// So many points of the range, as the extremes of a Chebyshev polynomial in m lie.
pub(super) fn spread<I: ScaledIntegral>(continuum: &Continuum<'_, I>, count: usize) -> Vec<Sample> {
    let (lo, hi) = continuum.reals.in_m();
    let at = |i: usize| {
        let turn = core::f64::consts::PI * i as f64 / (count - 1) as f64;
        (lo + 0.5 * (hi - lo) * (1.0 - libm::cos(turn))).clamp(lo, hi)
    };
    (0..count).map(|i| continuum.at(at(i))).collect()
}

/// The parameters whose residual is h, -h, h, … at the reference, and h.
///
/// Solved in x = m/m_max, whose powers are of size 1.
pub(super) fn levelled<I: ScaledIntegral>(
    continuum: &Continuum<'_, I>,
    reference: &[Sample],
    form: FactorForm,
    pole: f64,
) -> Option<(Vec<f64>, f64)> {
    let size = reference.len();
    let scale = continuum.reals.in_m().1;
    let mut matrix = DMatrix::zeros(size, size);
    for (i, s) in reference.iter().enumerate() {
        let x = s.m / scale;
        let mut entry = s.g;
        for j in 0..size - 1 {
            let bent = form == FactorForm::Ratio && j == 2;
            matrix[(i, j)] = if bent { entry / (1.0 + pole * s.m) } else { entry };
            entry *= x;
        }
        matrix[(i, size - 1)] = if i.is_multiple_of(2) { -1.0 } else { 1.0 };
    }
    let solution = matrix.lu().solve(&DVector::from_element(size, 1.0))?;
    let mut unit = 1.0;
    let mut parameters = Vec::with_capacity(size);
    for c in solution.iter().take(size - 1) {
        parameters.push(c * unit);
        unit /= scale;
    }
    solution.iter().all(|x| x.is_finite()).then(|| (parameters, solution[size - 1]))
}

/// So many of the extremes, which alternate in sign, still alternating, with the largest among them.
///
/// The smallest go first, an inner one with the smaller of its neighbours. What reaches the old level
/// alternates often enough by itself, so it is what stays: the next level is higher, and an exchange
/// cannot go in circles. `None` if there are too few.
pub(super) fn alternation(extremes: &[(Sample, f64)], count: usize) -> Option<Vec<Sample>> {
    let mut kept = extremes.to_vec();
    while kept.len() > count {
        let size = |i: usize| kept[i].1.abs();
        let last = kept.len() - 1;
        let end = if size(0) < size(last) { 0 } else { last };
        let smallest = (0..=last).fold(0, |least, i| if size(i) < size(least) { i } else { least });
        if kept.len() == count + 1 || smallest == 0 || smallest == last {
            kept.remove(end);
        } else {
            // Two neighbours leave the others alternating.
            let with = if size(smallest - 1) < size(smallest + 1) { smallest - 1 } else { smallest };
            kept.drain(with..with + 2);
        }
    }
    (kept.len() == count).then(|| kept.iter().map(|e| e.0).collect())
}

/// A lower bound of max |residual| for every choice of the form's parameters, proved: the least of the
/// enclosed |residuals| at the alternation, 0 if their signs are not proved to alternate.
///
/// De la Vallée Poussin's theorem. Suppose other parameters had a residual smaller in size than this
/// one's at each of N points where this one's alternates; then the difference of the two would change
/// sign N - 1 times. For a form linear in its k parameters, N = k + 1, the difference is g times a
/// polynomial in m of k coefficients, which has at most k - 1 zeros. For the ratio, N = 5, it is g times
/// (P₁ Q₂ - P₂ Q₁)/(Q₁ Q₂) with P quadratic, Q linear and without a zero in the range: at most 3 zeros.
pub(super) fn lower_bound<I: ScaledIntegral>(
    continuum: &Continuum<'_, I>,
    form: FactorForm,
    optimum: &Optimum,
) -> f64 {
    if optimum.alternation.len() < form.parameters() + 1 {
        return 0.0;
    }
    let at = |&n: &f64| continuum.enclosure(form, &optimum.parameters, n);
    let heights: Vec<_> = optimum.alternation.iter().map(at).collect();
    let alternates = heights
        .windows(2)
        .all(|w| (w[0].lo() > 0.0 && w[1].hi() < 0.0) || (w[0].hi() < 0.0 && w[1].lo() > 0.0));
    let pole = if form == FactorForm::Ratio { optimum.parameters[3] } else { 0.0 };
    if !alternates || pole <= -continuum.reals.from() {
        return 0.0;
    }
    heights.iter().map(|h| h.abs().lo()).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Reals;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    fn case(model: Model) -> Case {
        Case { model, lobe: Lobe::Cs16, limit: Limit::Support }
    }

    /// Residual p0 (16/17)(1 - 8m/9) - 1 by hand: balanced at the two ends.
    #[test]
    fn the_proportional_form_balances_its_ends() {
        let case = case(Model::PhongModified);
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        let found = minimax(&continuum, FactorForm::Proportional).unwrap();
        let end = |n: f64| 16.0 / 17.0 * (1.0 - 8.0 / (9.0 * n));
        let p0 = 2.0 / (end(16.0) + end(1024.0));
        assert!((found.parameters[0] / p0 - 1.0).abs() < 1e-14, "{found:?}");
        assert!((found.level - (p0 * end(1024.0) - 1.0)).abs() < 1e-14);
        assert_eq!(found.alternation, [1024.0, 16.0]);
        let bound = lower_bound(&continuum, FactorForm::Proportional, &found);
        assert!(bound <= found.level && bound > found.level * (1.0 - 1e-9));
    }

    #[test]
    fn without_an_alternation_nothing_is_proved() {
        let case = case(Model::PhongModified);
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        let mut found = minimax(&continuum, FactorForm::Linear).unwrap();
        assert!(lower_bound(&continuum, FactorForm::Linear, &found) > 0.0);
        // Raised until the middle extreme alone is positive.
        let sound = found.clone();
        found.parameters[0] *= 1.01;
        assert_eq!(lower_bound(&continuum, FactorForm::Linear, &found), 0.0);
        found = Optimum { alternation: sound.alternation[..2].to_vec(), ..sound };
        assert_eq!(lower_bound(&continuum, FactorForm::Linear, &found), 0.0);
    }

    #[test]
    fn a_reference_alternates_and_holds_the_largest() {
        let extremes = |values: &[f64]| -> Vec<(Sample, f64)> {
            values.iter().enumerate().map(|(i, v)| (Sample { m: i as f64, g: 1.0 }, *v)).collect()
        };
        let chosen = |values: &[f64], count: usize| -> Option<Vec<usize>> {
            let found = alternation(&extremes(values), count)?;
            Some(found.iter().map(|s| s.m as usize).collect())
        };
        assert_eq!(chosen(&[1.0, -2.0, 1.5], 3), Some(vec![0, 1, 2]));
        assert_eq!(chosen(&[1.0, -2.0, 1.5, -1.2], 3), Some(vec![1, 2, 3]));
        // A small one goes, and of its neighbours the larger stays.
        assert_eq!(chosen(&[1.0, -2.0, 1.5, -0.5, 3.0], 3), Some(vec![0, 1, 4]));
        // An inner pair goes, so that the largest at one end and the second at the other stay.
        assert_eq!(chosen(&[5.0, -4.0, 1.1, -1.2, 3.0], 3), Some(vec![0, 1, 4]));
        assert_eq!(chosen(&[1.0, -2.0], 3), None);
    }

    #[test]
    fn what_is_exact_stays_exact_with_more_terms() {
        let case = case(Model::Phong);
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        for form in FactorForm::ALL {
            let found = minimax(&continuum, form).unwrap();
            assert!((found.parameters[0] - 1.0625).abs() < 1e-14 && found.alternation.is_empty());
            assert_eq!(found.parameters[1..], vec![0.0; form.parameters() - 1]);
        }
    }
}
