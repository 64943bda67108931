//! The line of few digits that never gains energy and loses least, by an exhaustive search.

use super::continuum::{Continuum, Sample};
use super::digits::Decimal;
use super::one_sided::certified;
use super::{Factor, FactorForm, FitError};
use crate::bound::Extreme;
use crate::integral::ScaledIntegral;

/// Slopes walked through to one side before there is something wrong; a few are usual.
const MOST: u32 = 10_000;

/// What doubles know of one slope.
struct Slope {
    /// A lower bound of the loss at this slope, whatever b: b not rounded.
    unrounded: f64,
    /// The largest b, and another below it if rounding leaves a doubt, each with its loss.
    offsets: Vec<(f64, Decimal)>,
}

/// The line a n + b of least loss among all with at most `digits` significant digits in a and in b, b
/// having no more than `digits` + 1 places behind the point.
///
/// For a given a the best b is the largest decimal that is at most β(a) = min (divisor/(2 Int) - a n)
/// over the range: loss falls in b. With b = β(a) itself the loss is a convex function of a, because the
/// lines that gain nothing are a convex set and the loss of a line is a maximum of linear functions. So
/// the decimals a are walked through outward from the best real a, in both directions, until not even
/// β(a) would beat the best line found: none further out can. The search is in doubles; a line counts as
/// found once enclosures have certified it.
///
/// # Errors
/// [`FitError::NoOptimum`] if none is certified.
pub(super) fn shortest<I: ScaledIntegral + Clone>(
    continuum: &Continuum<'_, I>,
    best_slope: f64,
    digits: usize,
) -> Result<(Factor, Extreme), FitError> {
    let failure = || FitError::NoOptimum { method: "rounding down", case: continuum.integral.describe() };
    let first = Decimal::floor(best_slope, digits, i32::MAX).ok_or_else(failure)?;
    let mut best = None;
    let mut least = f64::INFINITY;
    let mut walk = |mut a: Decimal, next: fn(Decimal, usize) -> Decimal| {
        for _ in 0..MOST {
            let slope = at_slope(continuum, a, digits)?;
            if slope.unrounded >= least || !a.is_positive() {
                return Some(());
            }
            for (loss, b) in slope.offsets {
                if loss >= least {
                    continue;
                }
                if let Some(found) = certified(continuum, FactorForm::Linear, &[a.text(), b.text()]) {
                    (best, least) = (Some(found), loss);
                }
            }
            a = next(a, digits);
        }
        None
    };
    walk(first, Decimal::below).ok_or_else(failure)?;
    walk(first.above(digits), Decimal::above).ok_or_else(failure)?;
    best.ok_or_else(failure)
}

fn at_slope<I: ScaledIntegral>(continuum: &Continuum<'_, I>, a: Decimal, digits: usize) -> Option<Slope> {
    let slope = a.to_f64();
    let room = |s: Sample| {
        if s.m > 0.0 {
            (1.0 / s.g - slope) / s.m
        } else if slope * s.g <= 1.0 + continuum.noise {
            f64::INFINITY // at n = ∞ any b is as good
        } else {
            f64::NEG_INFINITY
        }
    };
    let (at, least) = continuum.maximum(|s| -room(s));
    let highest = -least;
    if highest == f64::NEG_INFINITY {
        return Some(Slope { unrounded: f64::INFINITY, offsets: vec![] });
    }
    // Rounding of 1/g, magnified by n.
    let doubt = 4.0 * continuum.noise / (at.g * at.m);
    let loss = |b: f64| continuum.maximum(|s| 1.0 - (slope + b * s.m) * s.g).1;
    let places = digits as i32 + 1;
    let largest = Decimal::floor(highest + doubt, digits, places)?;
    let surest = Decimal::floor(highest - doubt, digits, places)?;
    let mut offsets = vec![(loss(largest.to_f64()), largest)];
    if surest != largest {
        offsets.push((loss(surest.to_f64()), surest));
    }
    Some(Slope { unrounded: loss(highest + doubt), offsets })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::Reals;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    /// Phong is 1.0625 n. With a = 1.062 the room is 0.0005 n, least at n = 16: b = 0.008, exactly, and
    /// nothing but exact arithmetic can tell that 1.062 n + 0.008 gains nothing there.
    #[test]
    fn a_line_that_touches_is_not_missed() {
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        for (digits, a, b) in
            [(3, "1.06", "0.04"), (4, "1.062", "0.008"), (5, "1.0625", "0"), (6, "1.0625", "0")]
        {
            let (factor, largest) = shortest(&continuum, 1.0625, digits).unwrap();
            assert_eq!(factor.parameters(), [a, b], "{digits} digits");
            assert_eq!((largest.value.hi(), largest.n), (0.0, 16.0), "{digits} digits");
        }
    }

    /// Every line of three digits near the best, judged one by one on a dense grid of n.
    #[test]
    fn no_line_of_the_lattice_does_better() {
        let case = Case { model: Model::BlinnPhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        let (factor, _) = shortest(&continuum, 1.0513, 3).unwrap();
        let p: Vec<f64> = factor.parameters().iter().map(|t| t.parse().unwrap()).collect();
        let span = |a: f64, b: f64| {
            let residuals = continuum.samples.iter().map(|s| (a + b * s.m) * s.g - 1.0);
            residuals.fold((0.0_f64, f64::NEG_INFINITY), |(lo, hi), r| (lo.min(r), hi.max(r)))
        };
        let (loss, _) = span(p[0], p[1]);
        let mut feasible = 0;
        for a in 95..=109 {
            for b in 300..=700 {
                let (a, b) = (f64::from(a) / 100.0, f64::from(b) / 100.0);
                let (lo, hi) = span(a, b);
                feasible += i32::from(hi <= 0.0);
                // The grid misses the extremes by less than a thousandth of the loss.
                assert!(hi > 0.0 || lo <= 0.999 * loss, "{a} n + {b}: {lo:e} against {loss:e}");
            }
        }
        assert!(feasible > 1000, "{feasible} lines were compared");
    }
}
