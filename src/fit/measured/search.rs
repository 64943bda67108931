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
