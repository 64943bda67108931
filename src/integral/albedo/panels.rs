//! One integral over a lobe, in panels that neither step over the lobe nor across a kink.

use super::Profile;
use crate::integral::{Estimate, GaussLegendre};
use std::sync::LazyLock;

/// The two orders that are compared: one even, one odd, so that symmetry does not make them err alike.
static RULES: LazyLock<[GaussLegendre; 2]> =
    LazyLock::new(|| [GaussLegendre::new(10), GaussLegendre::new(21)]);

/// The lobe's own width in t = n w, several times over: at t = 16 a bell has ended and e⁻ᵗ is 1e-7.
const WIDTH: f64 = 16.0;

/// Halvings of a panel before what is left is stated as error.
const DEEPEST: u32 = 40;

/// Relative rounding of the kernels and of the sums.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// ∫ lobe(w) weight(w) n dw up to `end`, split at the kinks of the weight, each piece to `target`.
pub(super) fn over_lobe(
    lobe: &Profile<'_>,
    end: f64,
    kinks: &[f64],
    target: f64,
    weight: &dyn Fn(f64) -> f64,
) -> Estimate {
    let end = end.min(lobe.support());
    let inside = |w: &f64| *w > 0.0 && *w < end;
    let mut ends = vec![0.0, end];
    ends.extend(kinks.iter().copied().chain([WIDTH / lobe.n()]).filter(inside));
    ends.sort_by(f64::total_cmp);
    let mut total = Estimate { value: 0.0, error: 0.0, evaluations: 0 };
    for pair in ends.windows(2) {
        let integrand = |w: f64| lobe.n() * lobe.at(w) * weight(w);
        let part = panel(&integrand, (pair[0], pair[1]), target);
        total.value += part.value;
        total.error += part.error;
        total.evaluations += part.evaluations;
    }
    total.error += ROUNDING * total.value.abs();
    total
}

/// ∫ f over [a, b], where f may end like a square root at either end.
///
/// x = a + (b - a) s² (3 - 2s) makes such ends smooth in s; there Gauss-Legendre of two orders is
/// compared, and a piece on which they differ is halved. The error is the sum of the differences: that
/// of the lower order, so a generous one for the value, which is the higher order's. Kinks are the caller's
/// to split at: one that falls next to an end of a piece, where no node is, hides from both orders, and a
/// jump even more so.
pub(super) fn panel(f: &dyn Fn(f64) -> f64, (a, b): (f64, f64), target: f64) -> Estimate {
    if b <= a {
        return Estimate { value: 0.0, error: 0.0, evaluations: 0 };
    }
    let smooth = |s: f64| {
        // From the nearer end, so that its neighbourhood keeps its digits.
        let r = 1.0 - s;
        let x = if s < 0.5 {
            a + (b - a) * s * s * (1.0 + 2.0 * r)
        } else {
            b - (b - a) * r * r * (1.0 + 2.0 * s)
        };
        6.0 * (b - a) * s * r * f(x)
    };
    halving(&smooth, 0.0, 1.0, target, DEEPEST)
}

fn halving(f: &dyn Fn(f64) -> f64, a: f64, b: f64, target: f64, depth: u32) -> Estimate {
    let [low, high] = RULES.each_ref().map(|rule| rule.integrate(f, a, b));
    let error = (high - low).abs();
    let evaluations = (RULES[0].order() + RULES[1].order()) as u32;
    // A NaN is not halved, but handed on.
    if error.is_nan() || error <= target || depth == 0 {
        return Estimate { value: high, error, evaluations };
    }
    let mid = 0.5 * (a + b);
    let (left, right) = (halving(f, a, mid, target, depth - 1), halving(f, mid, b, target, depth - 1));
    Estimate {
        value: left.value + right.value,
        error: left.error + right.error,
        evaluations: evaluations + left.evaluations + right.evaluations,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::PI;

    /// ∫_0^1 √(x (1 - x)) dx = π/8, and the same split at 0.3 with a smooth factor: ∫ x √(x (1 - x)) = π/16.
    #[test]
    fn roots_at_the_ends_are_within_the_stated_error() {
        let root = |x: f64| libm::sqrt(x * (1.0 - x));
        for (f, exact) in [(&root as &dyn Fn(f64) -> f64, PI / 8.0), (&|x| x * root(x), PI / 16.0)] {
            let whole = panel(f, (0.0, 1.0), 1e-13);
            let [left, right] = [(0.0, 0.3), (0.3, 1.0)].map(|part| panel(f, part, 1e-13));
            let split = (left.value + right.value, left.error + right.error);
            for (value, error) in [(whole.value, whole.error), split] {
                assert!((value - exact).abs() <= error + 4.0 * f64::EPSILON, "{value} ± {error:e}, {exact}");
                assert!(error < 1e-12, "{error:e}");
            }
            assert!(whole.evaluations <= 93, "smooth in s, so halved once at most: {whole:?}");
        }
    }

    /// ∫_0^1 |x - c| dx = (c² + (1 - c)²)/2, found by halving down to a kink that no panel is told of.
    #[test]
    fn a_kink_costs_halvings_and_no_digits() {
        let c = 0.3137;
        let found = panel(&|x| (x - c).abs(), (0.0, 1.0), 1e-12);
        let exact = 0.5 * (c * c + (1.0 - c) * (1.0 - c));
        assert!((found.value - exact).abs() <= found.error && found.error < 1e-11, "{found:?}, {exact}");
        assert!(found.evaluations > 300, "{found:?}");
    }

    #[test]
    fn a_nan_is_handed_on_and_an_empty_panel_is_0() {
        assert!(panel(&|_| f64::NAN, (0.0, 1.0), 1e-12).value.is_nan());
        assert_eq!(panel(&|x| x, (1.0, 1.0), 1e-12).value, 0.0);
    }
}
