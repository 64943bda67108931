//! From a rough bell to the one whose error equioscillates.

use super::shape::{Piece, Place, Shape};
use crate::fit::FitError;
use crate::fit::continuum::golden_section;
use argmin::core::{CostFunction, Error, Executor};
use argmin::solver::neldermead::NelderMead;
use nalgebra::{DMatrix, DVector};

/// A polished minimax fit to e⁻ᵗ.
#[derive(Clone, Debug, PartialEq)]
pub struct Polished {
    /// The unknowns of the shape.
    pub unknowns: Vec<f64>,
    /// p.
    pub piece: Piece,
    /// The common size of the error's extremes.
    pub level: f64,
    /// t of the alternating extremes, ascending: one more than there are unknowns.
    pub alternation: Vec<f64>,
}

/// Steps of the error's scan for extremes.
const SCAN: u32 = 1200;

#[derive(Clone, Copy)]
struct Distance {
    shape: Shape,
    power: u32,
}

impl Distance {
    /// max |e⁻ᵗ - bell| on a grid; what is no bell counts as farther than anything.
    fn of(self, x: &[f64]) -> f64 {
        let piece = self.shape.piece(x);
        if !piece.is_bell(64) {
            return 2.0;
        }
        let on_grid = (0..=200).map(|i| piece.error(self.power, Place::At(f64::from(i) / 200.0)).abs());
        on_grid.fold(piece.error(self.power, Place::Beyond).abs(), f64::max)
    }
}

impl CostFunction for Distance {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        Ok(self.of(x))
    }
}

/// The best bell of a shape for e⁻ᵗ, p(0) = 1: Nelder and Mead's simplex, then Newton's method on the equations
/// of equioscillation, error(tᵢ) = ± level with alternating signs at one place more than unknowns.
///
/// # Errors
/// [`FitError::NoOptimum`] if the error of what is found does not alternate so often.
///
/// ```
/// use bellfit::fit::bell::{Shape, polish};
/// let best = polish(Shape::Cubic, 4)?;
/// assert!(best.level < 5.0e-4 && best.alternation.len() == 4);
/// # Ok::<(), bellfit::fit::FitError>(())
/// ```
pub fn polish(shape: Shape, power: u32) -> Result<Polished, FitError> {
    let failure = |method| FitError::NoOptimum { method, case: format!("{} bell, K = {power}", shape.id()) };
    let mut x = simplex(shape, power).ok_or_else(|| failure("the simplex search"))?;
    for _ in 0..60 {
        let places = alternation(shape, power, &x).ok_or_else(|| failure("the exchange"))?;
        let step = newton(shape, power, &x, &places).ok_or_else(|| failure("the exchange"))?;
        // Halved until it is a bell again.
        let mut share = 1.0;
        let moved = |share: f64| -> Vec<f64> { x.iter().zip(&step).map(|(x, d)| x + share * d).collect() };
        while !shape.piece(&moved(share)).is_bell(64) && share > 1e-6 {
            share *= 0.5;
        }
        x = moved(share);
        if step.iter().zip(&x).all(|(d, x)| d.abs() <= 1e-13 * x.abs().max(1.0)) {
            break;
        }
    }
    let piece = shape.piece(&x);
    let places = alternation(shape, power, &x).ok_or_else(|| failure("the exchange"))?;
    let sizes: Vec<f64> = places.iter().map(|&p| piece.error(power, p).abs()).collect();
    let (least, most) = sizes.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), &s| (l.min(s), m.max(s)));
    // Extremes are found to the square of the scan's refinement, far below this; p^K rounds K times.
    if most - least > 1e-9 * most + 8.0 * f64::from(power) * f64::EPSILON {
        return Err(failure("the exchange"));
    }
    let t = |place: &Place| match place {
        Place::At(y) => y * piece.reach,
        Place::Beyond => piece.reach,
    };
    Ok(Polished { alternation: places.iter().map(t).collect(), level: most, piece, unknowns: x })
}

/// A start for the polish, from bells about as wide as the error allows.
fn simplex(shape: Shape, power: u32) -> Option<Vec<f64>> {
    let k = f64::from(power);
    let mut best = match shape {
        Shape::Linear => vec![k],
        Shape::Double => vec![2.0 * k],
        Shape::Jump => {
            // e^-z to second order in z = t/K, cut where e⁻ᵗ is about the level of that.
            let reach = 2.0 + 1.6 * f64::from(power.trailing_zeros());
            vec![reach, reach / k, 0.45 * reach * reach / (k * k)]
        }
        Shape::Cubic => vec![5.0 + 1.2 * k, -1.0, 0.9],
    };
    // Restarts from a fresh, smaller simplex escape a collapsed one.
    for round in 0..8 {
        let step = 0.25 / f64::from(1 << round);
        let mut corners = vec![best.clone()];
        for i in 0..best.len() {
            let mut corner = best.clone();
            corner[i] *= 1.0 + step;
            corners.push(corner);
        }
        let solver = NelderMead::new(corners).with_sd_tolerance(1e-14).ok()?;
        let run = Executor::new(Distance { shape, power }, solver)
            .configure(|state| state.max_iters(300))
            .ctrlc(false)
            .run()
            .ok()?;
        best = run.state.best_param?;
    }
    Some(best)
}

/// The places of alternating extremes, one more than there are unknowns; the largest such run.
fn alternation(shape: Shape, power: u32, x: &[f64]) -> Option<Vec<Place>> {
    let piece = shape.piece(x);
    let error = |place: Place| piece.error(power, place);
    // Cosine spacing resolves both ends.
    let y = |i: u32| 0.5 * (1.0 - libm::cos(core::f64::consts::PI * f64::from(i) / f64::from(SCAN)));
    let mut places: Vec<Place> = (0..=SCAN).map(|i| Place::At(y(i))).collect();
    places.push(Place::Beyond);
    // One place per run of equal sign, where |error| is largest.
    let mut extremes: Vec<(usize, Place)> = Vec::new();
    for (i, &place) in places.iter().enumerate() {
        match extremes.last_mut() {
            Some(last) if (error(last.1) < 0.0) == (error(place) < 0.0) => {
                if error(place).abs() > error(last.1).abs() {
                    *last = (i, place);
                }
            }
            _ => extremes.push((i, place)),
        }
    }
    let refined: Vec<Place> = extremes
        .iter()
        .map(|&(i, place)| match place {
            Place::At(_) if i > 0 && i < SCAN as usize => {
                Place::At(golden_section((y(i as u32 - 1), y(i as u32 + 1)), |y| -error(Place::At(y)).abs()))
            }
            _ => place,
        })
        .collect();
    let needed = shape.unknowns() + 1;
    let least = |run: &[Place]| run.iter().map(|&p| error(p).abs()).fold(f64::INFINITY, f64::min);
    let best = refined.windows(needed).max_by(|a, b| least(a).total_cmp(&least(b)))?;
    Some(best.to_vec())
}

/// The step towards error(placeᵢ) = (-1)ⁱ level.
fn newton(shape: Shape, power: u32, x: &[f64], places: &[Place]) -> Option<Vec<f64>> {
    let size = places.len();
    let error = |x: &[f64], i: usize| shape.piece(x).error(power, places[i]);
    let level = (0..size).map(|i| error(x, i).abs()).sum::<f64>() / size as f64;
    let sign = |i: usize| if (error(x, 0) < 0.0) == i.is_multiple_of(2) { -1.0 } else { 1.0 };
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    for i in 0..size {
        right[i] = sign(i) * level - error(x, i);
        for j in 0..x.len() {
            // Central differences: the error's third derivatives are of the order of 1.
            let h = 1e-5 * x[j].abs().max(1e-2);
            let (mut up, mut down) = (x.to_vec(), x.to_vec());
            up[j] += h;
            down[j] -= h;
            matrix[(i, j)] = (error(&up, i) - error(&down, i)) / (2.0 * h);
        }
        matrix[(i, size - 1)] = -sign(i);
    }
    let solution = matrix.lu().solve(&right)?;
    let step: Vec<f64> = solution.iter().take(x.len()).copied().collect();
    step.iter().all(|d| d.is_finite()).then_some(step)
}
