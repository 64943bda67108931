//! The shape of a free bell: argmin's simplex from several starts.

use super::lobe::Lobe;
use super::points::Points;
use super::search::exponent;
use super::{Family, Shape};
use argmin::core::{CostFunction, Error, Executor};
use argmin::solver::neldermead::NelderMead;

/// Shapes to start from, besides the adopted one of the same power: Lyon's bell, a heavy tail, a flat top.
const STARTS: [Shape; 3] = [
    Shape { linear: 0.0, square: 0.0 },
    Shape { linear: -1.8, square: 0.95 },
    Shape { linear: 0.8, square: -0.5 },
];
/// Steps of the first simplex in ln n, α and β.
const STEP: [f64; 3] = [0.1, 0.15, 0.15];
/// Restarts from a smaller simplex, which free a collapsed one.
const ROUNDS: i32 = 3;

/// The projected sum of squares over (ln n, α, β), finite everywhere: the simplex subtracts costs.
struct Bell<'a> {
    points: &'a Points,
    family: Family,
}

impl Bell<'_> {
    fn depth(&self, x: &[f64]) -> f64 {
        let (from, to) = self.family.exponents();
        let shape = Shape { linear: x[1], square: x[2] };
        let n = libm::exp(x[0]);
        // Outside, more than a lobe of scale 0 anywhere inside leaves.
        if !(from..=to).contains(&n) || !shape.falls() {
            return (2.0 - shape.margin().clamp(-1e3, 0.0)) * self.points.total;
        }
        self.points.project(&Lobe::new(self.family, n, shape)).1
    }
}

impl CostFunction for &Bell<'_> {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        Ok(self.depth(x))
    }
}

/// (ln n, shape) near the least sum of squares from each start, the lowest first.
pub(super) fn shapes(points: &Points, family: Family) -> Vec<(f64, Shape)> {
    let bell = Bell { points, family };
    // The limit n → ∞ of the adopted formula.
    let adopted = family
        .stand_in()
        .formula()
        .map(|formula| Shape { linear: formula.linear[0], square: formula.square[0] });
    let mut found: Vec<(f64, Vec<f64>)> = Vec::new();
    for shape in adopted.into_iter().chain(STARTS) {
        let (u, _) = exponent(points, family, shape);
        let mut best = vec![u, shape.linear, shape.square];
        for round in 0..ROUNDS {
            best = simplex(&bell, &best, libm::pow(0.2, f64::from(round)));
        }
        found.push((bell.depth(&best), best));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(_, x)| (x[0], Shape { linear: x[1], square: x[2] })).collect()
}

/// Where the simplex ends, or where it began if that is lower.
fn simplex(bell: &Bell<'_>, from: &[f64], size: f64) -> Vec<f64> {
    let moved = |i: usize| {
        let mut corner = from.to_vec();
        corner[i] += size * STEP[i];
        corner
    };
    let corners = vec![from.to_vec(), moved(0), moved(1), moved(2)];
    let tolerance = 1e-15 * bell.points.total;
    let run = NelderMead::new(corners).with_sd_tolerance(tolerance).and_then(|solver| {
        Executor::new(bell, solver).configure(|state| state.max_iters(80)).ctrlc(false).run()
    });
    let found = run.ok().and_then(|run| run.state.best_param);
    found.filter(|x| bell.depth(x) < bell.depth(from)).unwrap_or_else(|| from.to_vec())
}
