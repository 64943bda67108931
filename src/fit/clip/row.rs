//! The table of refits.

use super::exchange::{falling, largest, minimax};
use super::family::{ClipFamily, Ending, falls};
use super::recipe::prints;
use super::squares::weighted_squares;
use super::{ClipPixel, ClipPoints, ClipTarget, at, clip_printed};
use crate::bound::{ClippedPixel, Interval, clip_distance, decimal, enclose};
use crate::fit::DIGITS;
use crate::fit::continuum::golden_section;
use crate::fit::digits::round_to;

/// What a row's polynomial minimises, or its σ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipObjective {
    /// As printed.
    Printed,
    /// Σ or ∫ (P - volume)², over the polynomials.
    Squares,
    /// max |P - volume|, over the polynomials.
    Minimax,
    /// The same over those that fall to 0 at the base.
    Falling,
    /// max |P - volume| of the printed P, over σ.
    NearestSup,
    /// ∫ (P - volume)² of the printed P, over σ.
    NearestSquares,
}

impl ClipObjective {
    /// The name in files.
    pub const fn id(self) -> &'static str {
        match self {
            ClipObjective::Printed => "printed",
            ClipObjective::Squares => "ls",
            ClipObjective::Minimax => "minimax",
            ClipObjective::Falling => "minimax-falling",
            ClipObjective::NearestSup => "nearest-sigma-sup",
            ClipObjective::NearestSquares => "nearest-sigma-ls",
        }
    }
}

/// A polynomial held against a pixel's clip volume.
#[derive(Clone, Debug, PartialEq)]
pub struct ClipRow {
    /// The pixel.
    pub target: ClipTarget,
    /// Where squares are summed; none for what has none.
    pub points: Option<ClipPoints>,
    /// Whether p₀ is fixed at ½; none for the printed P.
    pub half: Option<bool>,
    /// What is least.
    pub objective: ClipObjective,
    /// 2 or 3.
    pub degree: u32,
    /// p₀ to p₃.
    pub coefficients: [f64; 4],
    /// A bound of the largest |P - volume| over [0, ½], proved.
    pub error: f64,
    /// The d where it is reached.
    pub at: f64,
    /// Whether P falls over all of [0, ½].
    pub monotone: bool,
    /// Whether the coefficients round to the printed digits.
    pub digits: bool,
}

/// The proofs' tolerance, absolute: far below the errors' five printed digits.
const TOLERANCE: f64 = 1e-9;

fn row(pixel: &ClipPixel, objective: ClipObjective, p: [f64; 4]) -> ClipRow {
    let exact = |i: usize| {
        let printed = if objective_is_printed(objective) { decimal(&p[i].to_string()) } else { None };
        printed.map_or(Interval::from(p[i]), |(value, _)| enclose(&value))
    };
    let clipped = match pixel.target {
        // Holds 1/σ whether σ or its reciprocal was rounded.
        ClipTarget::Gaussian(s) => ClippedPixel::Gaussian(Interval::new(s.next_down(), s.next_up())),
        ClipTarget::GaussianCut(m) => ClippedPixel::GaussianOnBase(m),
        ClipTarget::Cone => ClippedPixel::Cone,
        ClipTarget::Parabola(k) => ClippedPixel::Bell(k),
    };
    let found = clip_distance([0, 1, 2, 3].map(exact), clipped, TOLERANCE);
    ClipRow {
        target: pixel.target,
        points: None,
        half: None,
        objective,
        degree: if p[3] == 0.0 { 2 } else { 3 },
        coefficients: p,
        error: found.value.hi(),
        at: found.at[0],
        monotone: falls(p),
        digits: prints(p),
    }
}

const fn objective_is_printed(objective: ClipObjective) -> bool {
    matches!(objective, ClipObjective::Printed | ClipObjective::NearestSup | ClipObjective::NearestSquares)
}

/// Every row: for each pixel the printed P, least squares on each set of points, the best quadratic and
/// cubic; for the paper's own σ = 1/6, cut or not, those that fall to 0; and the σ nearest to the printed P.
pub fn clip_rows() -> Vec<ClipRow> {
    let mut rows = Vec::new();
    for target in ClipTarget::ALL {
        let pixel = ClipPixel::new(target);
        rows.push(row(&pixel, ClipObjective::Printed, clip_printed()));
        for points in ClipPoints::ALL {
            let values: Vec<(f64, f64, f64)> =
                points.weighted().into_iter().map(|(d, weight)| (d, weight, pixel.volume(d))).collect();
            for half in [false, true] {
                let Some(p) = weighted_squares(&values, ClipFamily::quadratic(half)) else { continue };
                let rounded = p.map(|c| round_to(c, DIGITS).parse().unwrap_or(c));
                let found = row(&pixel, ClipObjective::Squares, rounded);
                rows.push(ClipRow { points: Some(points), half: Some(half), ..found });
            }
        }
        for degree in [2, 3] {
            for half in [false, true] {
                let family = ClipFamily { degree, half, ending: Ending::Free };
                let Some(unknowns) = minimax(&pixel, family) else { continue };
                let found = row(&pixel, ClipObjective::Minimax, family.rounded(&unknowns));
                rows.push(ClipRow { half: Some(half), ..found });
            }
        }
        if matches!(target, ClipTarget::Gaussian(6.0) | ClipTarget::GaussianCut(6)) {
            for degree in [2, 3] {
                for half in [false, true] {
                    let Some(p) = falling(&pixel, degree, half) else { continue };
                    rows.push(ClipRow { half: Some(half), ..row(&pixel, ClipObjective::Falling, p) });
                }
            }
        }
    }
    rows.extend([ClipObjective::NearestSup, ClipObjective::NearestSquares].map(nearest));
    rows
}

/// The whole Gaussian nearest to the printed P.
///
/// P - volume falls with σ at every d, so its largest size, the maximum of what rises and what falls, has
/// one minimum: golden section. The same search for the squares rests on a scan's looks.
fn nearest(objective: ClipObjective) -> ClipRow {
    let p = clip_printed();
    let places = ClipPoints::Continuous.weighted();
    let distance = |sigma: f64| {
        let pixel = ClipPixel::new(ClipTarget::Gaussian(1.0 / sigma));
        let error = |d: f64| at(p, d) - pixel.volume(d);
        match objective {
            ClipObjective::NearestSup => largest(error).1,
            _ => places.iter().map(|&(d, weight)| weight * error(d) * error(d)).sum(),
        }
    };
    let sigma = golden_section((0.15, 0.3), distance);
    let rounded: f64 = round_to(sigma, 8).parse().unwrap_or(sigma);
    let points = (objective == ClipObjective::NearestSquares).then_some(ClipPoints::Continuous);
    let found = row(&ClipPixel::new(ClipTarget::Gaussian(1.0 / rounded)), objective, p);
    ClipRow { points, ..found }
}
