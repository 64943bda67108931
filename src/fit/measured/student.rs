//! Quantiles of Student's t.

use core::f64::consts::{FRAC_1_SQRT_2, FRAC_2_PI};

/// Up to here the probability is summed in closed form.
const CLOSED: usize = 1000;

/// The t that |T| stays below with this probability, T of Student's distribution with so many degrees of freedom;
/// `None` of them: of the normal distribution, their limit.
///
/// Source: the probability of whole degrees is a finite sum, Abramowitz & Stegun 26.7.3 and 26.7.4, solved for t by
/// halving; beyond 1000 degrees the expansion about the normal quantile, ibid. 26.7.5.
///
/// Domain: a probability in (0, 1), one degree or more; else NaN. Accuracy: relative 1e-11 for probabilities in
/// \[0.5, 0.999\], tested against a table of 30 digits.
///
/// ```
/// use bellfit::fit::measured::student_quantile;
/// assert!((student_quantile(0.95, Some(10)) - 2.228).abs() < 5e-4); // the printed tables' value
/// assert!((student_quantile(0.95, None) - 1.96).abs() < 5e-5);
/// ```
pub fn student_quantile(probability: f64, degrees: Option<usize>) -> f64 {
    if !(probability > 0.0 && probability < 1.0) || degrees == Some(0) {
        return f64::NAN;
    }
    match degrees {
        Some(degrees) if degrees <= CLOSED => solve(probability, |t| within(t, degrees)),
        Some(degrees) => expansion(normal(probability), degrees as f64),
        None => normal(probability),
    }
}

fn normal(probability: f64) -> f64 {
    solve(probability, |t| libm::erf(t * FRAC_1_SQRT_2))
}

/// The t at which a rising function passes the probability.
fn solve(probability: f64, within: impl Fn(f64) -> f64) -> f64 {
    let mut hi = 1.0;
    while within(hi) < probability && hi < 1e300 {
        hi *= 2.0;
    }
    let mut lo = if hi > 1.0 { 0.5 * hi } else { 0.0 };
    // Until no double lies between.
    loop {
        let middle = 0.5 * (lo + hi);
        if middle <= lo || middle >= hi {
            return middle;
        }
        if within(middle) < probability { lo = middle } else { hi = middle }
    }
}

/// P(|T| < t): with φ = arctan(t/√ν), for odd ν (2/π)(φ + sin φ (cos φ + 2/3 cos³φ + …)), for even ν
/// sin φ (1 + 1/2 cos²φ + 3/8 cos⁴φ + …).
fn within(t: f64, degrees: usize) -> f64 {
    let root = (degrees as f64).sqrt();
    let length = libm::hypot(t, root);
    let (sin, cos) = (t / length, root / length);
    let is_odd = degrees % 2 == 1;
    let first = if is_odd { 1 } else { 0 };
    let mut term = if is_odd { cos } else { 1.0 };
    let mut sum = 0.0;
    let mut k = first;
    while k + 2 <= degrees {
        sum += term;
        term *= cos * cos * (k + 1) as f64 / (k + 2) as f64;
        k += 2;
    }
    if is_odd { FRAC_2_PI * (libm::atan2(t, root) + sin * sum) } else { sin * sum }
}

/// t = x + g₁/ν + g₂/ν² + g₃/ν³ + g₄/ν⁴.
fn expansion(x: f64, degrees: f64) -> f64 {
    let s = x * x;
    let g1 = (s + 1.0) / 4.0;
    let g2 = ((5.0 * s + 16.0) * s + 3.0) / 96.0;
    let g3 = (((3.0 * s + 19.0) * s + 17.0) * s - 15.0) / 384.0;
    let g4 = ((((79.0 * s + 776.0) * s + 1482.0) * s - 1920.0) * s - 945.0) / 92_160.0;
    let m = 1.0 / degrees;
    x * (1.0 + m * (g1 + m * (g2 + m * (g3 + m * g4))))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both sides of where the one takes over from the other.
    #[test]
    fn the_expansion_meets_the_closed_form() {
        for probability in [0.5, 0.95, 0.99, 0.999] {
            let [closed, expanded] =
                [student_quantile(probability, Some(CLOSED)), expansion(normal(probability), CLOSED as f64)];
            assert!((closed / expanded - 1.0).abs() < 1e-11, "{probability}: {closed} {expanded}");
        }
    }

    #[test]
    fn arguments_outside_have_no_quantile() {
        for (p, degrees) in [(0.0, Some(3)), (1.0, None), (f64::NAN, Some(3)), (0.95, Some(0))] {
            assert!(student_quantile(p, degrees).is_nan());
        }
    }
}
