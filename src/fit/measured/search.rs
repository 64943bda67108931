//! The n of a family: a scan for the valleys, and argmin's Brent inside each.

use super::lobe::Lobe;
use super::points::Points;
use super::{Family, Shape};
use argmin::core::{CostFunction, Error, Executor};
use argmin::solver::brent::BrentOpt;

/// Steps of the scan for each factor of ten in n: neighbours are 1.33 apart, and the sum of squares as a function of
/// ln n bends over a factor of two and more.
const STEPS: f64 = 8.0;
/// Valleys that are descended into, the deepest of the scan first.
const VALLEYS: usize = 3;

/// The projected sum of squares over u = ln n.
struct Valley<'a> {
    points: &'a Points,
    family: Family,
    shape: Shape,
}

impl Valley<'_> {
    fn depth(&self, u: f64) -> f64 {
        self.points.project(&Lobe::new(self.family, libm::exp(u), self.shape)).1
    }
}

impl CostFunction for &Valley<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, u: &f64) -> Result<f64, Error> {
        Ok(self.depth(*u))
    }
}

/// ln n of the least sum of squares in the family's range and that sum; at an end, that end exactly.
pub(super) fn exponent(points: &Points, family: Family, shape: Shape) -> (f64, f64) {
    let (from, to) = family.exponents();
    let (from, to) = (libm::log(from), libm::log(to));
    let count = libm::ceil((to - from) / core::f64::consts::LN_10 * STEPS) as usize;
    let valley = Valley { points, family, shape };
    let at = |i: usize| if i == count { to } else { from + (to - from) * i as f64 / count as f64 };
    let scan: Vec<f64> = (0..=count).map(|i| valley.depth(at(i))).collect();
    let lowest = |i: &usize| {
        let left = *i == 0 || scan[*i] <= scan[*i - 1];
        let right = *i == count || scan[*i] <= scan[*i + 1];
        left && right
    };
    let mut valleys: Vec<usize> = (0..=count).filter(lowest).collect();
    valleys.sort_by(|a, b| scan[*a].total_cmp(&scan[*b]));
    let mut best = (at(valleys[0]), scan[valleys[0]]);
    for i in valleys.into_iter().take(VALLEYS) {
        let (left, right) = (at(i.saturating_sub(1)), at((i + 1).min(count)));
        // The tolerance that a sum of squares supports: √ε in u, which the polish then makes good.
        let solver = BrentOpt::new(left, right).set_tolerance(1.5e-8, 1e-10);
        let run = Executor::new(&valley, solver).configure(|state| state.max_iters(60)).ctrlc(false).run();
        let found = run.ok().and_then(|run| run.state.best_param);
        // A plateau or an end may lie lower than what is found inside.
        for u in found.into_iter().chain([at(i)]).filter(|u| u.is_finite()) {
            let depth = valley.depth(u);
            if depth < best.1 {
                best = (u, depth);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::measured::{Samples, Unit, Weighting};

    /// Thirty samples of the family itself, to where the lobe has fallen to about e⁻⁶.
    fn of(family: Family, n: f64) -> Points {
        let end = (2.0 * libm::sqrt(6.0 / n)).min(1.5);
        let at = |i: u32| end * f64::from(i) / 29.0;
        let value = |theta: f64| {
            let s = libm::sin(0.5 * theta);
            0.8 * family.value(2.0 * s * s, n, Shape::default())
        };
        let rows: Vec<(f64, f64, f64)> = (0..30).map(at).map(|theta| (theta, value(theta), 1.0)).collect();
        Points::new(&Samples::new(Unit::Radians, Weighting::Equal, &rows).unwrap())
    }

    /// A sum of squares that is known to 1e-16 shows ln n to √ of that.
    #[test]
    fn the_exponent_that_made_the_samples_is_found() {
        for family in [Family::CosN, Family::SphericalGaussian, Family::Schlick, Family::Cubic4] {
            for n in [21.0, 60.0, 3333.0, 2e5] {
                let (u, square) = exponent(&of(family, n), family, Shape::default());
                assert!((u - libm::log(n)).abs() < 1e-6, "{family} {n}: {}", libm::exp(u));
                // The roundings of thirty squares that cancel.
                assert!(square < 1e-13, "{family} {n}: {square}");
            }
        }
    }

    /// What lies beyond the range is nearest to its end, and that is returned exactly.
    #[test]
    fn beyond_the_range_is_its_end() {
        for family in [Family::CosN, Family::Cubic4] {
            let (from, to) = family.exponents();
            let found = |n: f64| exponent(&of(family, n), family, Shape::default()).0;
            assert_eq!(found(3.0 * to), libm::log(to), "{family}");
            assert_eq!(
                exponent(&of(Family::CosN, from / 3.0), family, Shape::default()).0,
                libm::log(from),
                "{family}"
            );
        }
    }
}
