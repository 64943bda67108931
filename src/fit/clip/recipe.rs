//! Which recipe prints the digits of P: pixel, points, constant.

use super::family::ClipFamily;
use super::squares::weighted_squares;
use super::{ClipPixel, ClipPoints, ClipTarget, clip_printed};
use crate::bound::{decimal, exact, power_of_ten};
use dashu_ratio::RBig;

/// A least-squares fit whose coefficients round to the printed digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recipe {
    /// The pixel.
    pub target: ClipTarget,
    /// Equidistant points over [0, ½], both ends among them.
    pub points: u32,
    /// Whether p₀ was fixed at ½.
    pub half: bool,
    /// The fit.
    pub coefficients: [f64; 4],
}

/// The σ of the whole Gaussian for which a recipe prints the digits; sampled by bisection, not proved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SigmaRange {
    /// Where the squares are summed.
    pub points: ClipPoints,
    /// Whether p₀ was fixed at ½.
    pub half: bool,
    /// The σ at which p₁ is as printed.
    pub linear: (f64, f64),
    /// The σ at which p₂ is.
    pub square: (f64, f64),
}

impl SigmaRange {
    /// The σ at which both are, if there are any.
    pub fn both(&self) -> Option<(f64, f64)> {
        let (lo, hi) = (self.linear.0.max(self.square.0), self.linear.1.min(self.square.1));
        (lo <= hi).then_some((lo, hi))
    }
}

/// What the printed digits of each coefficient mean, both ends included.
fn meant() -> Option<[(RBig, RBig); 3]> {
    let range = |printed: f64| {
        let (value, places) = decimal(&printed.to_string())?;
        let half = power_of_ten(-places) / RBig::from(2);
        Some((value.clone() - half.clone(), value + half))
    };
    let [a, b, c, _] = clip_printed();
    Some([range(a)?, range(b)?, range(c)?])
}

/// Whether a quadratic rounds to the printed digits, decided exactly.
pub(super) fn prints(p: [f64; 4]) -> bool {
    let within = |p: &f64, (lo, hi): &(RBig, RBig)| exact(*p).is_some_and(|p| *lo <= p && p <= *hi);
    meant().is_some_and(|ranges| p[3] == 0.0 && p.iter().zip(&ranges).all(|(p, r)| within(p, r)))
}

/// Every recipe of [`ClipTarget::ALL`], of 3 to `most` equidistant points and p₀ free or ½, that prints the
/// digits.
///
/// ```
/// use bellfit::fit::clip::{ClipTarget, recipes};
/// let found = recipes(30);
/// // σ = 1/5, 11 points, p₀ free, and no other
/// assert_eq!(found.len(), 1);
/// assert_eq!((found[0].target, found[0].points, found[0].half), (ClipTarget::Gaussian(5.0), 11, false));
/// ```
pub fn recipes(most: u32) -> Vec<Recipe> {
    let mut found = Vec::new();
    for target in ClipTarget::ALL {
        let pixel = ClipPixel::new(target);
        for points in 3..=most {
            let values: Vec<(f64, f64, f64)> = ClipPoints::Equidistant(points)
                .weighted()
                .into_iter()
                .map(|(d, weight)| (d, weight, pixel.volume(d)))
                .collect();
            for half in [false, true] {
                let fit = weighted_squares(&values, ClipFamily::quadratic(half));
                if let Some(coefficients) = fit.filter(|p| prints(*p)) {
                    found.push(Recipe { target, points, half, coefficients });
                }
            }
        }
    }
    found
}

/// The σ between 1/8 and 1/3 for which least squares on these points prints p₁, and p₂: both coefficients
/// shrink as σ grows, which the bisection takes for granted.
pub fn matching_sigmas(points: ClipPoints, half: bool) -> Option<SigmaRange> {
    let [_, linear, square] = meant()?.map(|(lo, hi)| (lo.to_f64().value(), hi.to_f64().value()));
    let places = points.weighted();
    let coefficient = |sigma: f64, k: usize| {
        let pixel = ClipPixel::new(ClipTarget::Gaussian(1.0 / sigma));
        let values: Vec<_> = places.iter().map(|&(d, weight)| (d, weight, pixel.volume(d))).collect();
        weighted_squares(&values, ClipFamily::quadratic(half)).map_or(f64::NAN, |p| p[k].abs())
    };
    let at = |k: usize, value: f64| {
        let (mut lo, mut hi) = (0.125, 1.0 / 3.0);
        for _ in 0..50 {
            let mid = 0.5 * (lo + hi);
            if coefficient(mid, k) > value { lo = mid } else { hi = mid }
        }
        0.5 * (lo + hi)
    };
    let range = |k: usize, (lo, hi): (f64, f64)| {
        let (a, b) = (at(k, lo.abs()), at(k, hi.abs()));
        (a.min(b), a.max(b))
    };
    Some(SigmaRange { points, half, linear: range(1, linear), square: range(2, square) })
}
