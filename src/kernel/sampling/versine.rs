//! The lobe's own angle from a uniform number: the inverse of its distribution function.

use super::density::{Density, Measure, fall, is_exponent, projected_mass};
use crate::kernel::real::Real;

/// The most Newton steps that any of 10⁷ sampled inverses took in either type. The loops end by
/// themselves once the error left, about the last step's square or less, no longer shows.
const STEPS: u32 = 6;

/// Versine of the lobe's own angle whose distribution function is u: w with P(versine ≤ w) = u.
///
/// - cosⁿ: w = 1 - (1 - u)^(1/(n + 1 + m)), m = 0 for f dω and 1 for f c dω.
/// - A bell, f dω: w = K/n (1 - (1 - u A)^(1/(K + 1))), A = 1 - max(0, 1 - n/K)^(K + 1).
/// - A bell, f c dω: by Newton's iteration in a logarithm, in which the equation is concave and the
///   start lies on the side from which every step stays there. With n ≥ K it is
///   b^(K + 1) (a + b) = (1 - u)(1 + a) in b = 1 - n w/K, a = (n/K - 1)(K + 2)/(K + 1), whose
///   logarithm has a slope between K + 1 and K + 2 in ln b.
///
/// Grows with u, so that strata of u are strata of the angle; u near 0 is near the axis, where w keeps
/// every digit. Source: inversion; for cosⁿ E. P. Lafortune and Y. D. Willems, "Using the modified Phong
/// reflectance model for physically based rendering", report CW 197, K.U. Leuven, 1994, with 1 - u for
/// their u and from the versine on, so that nothing cancels at large n. The bells' are this crate's.
///
/// - Domain: u in [0, 1), finite n ≥ 0; values in [0, 1]. Elsewhere, and for NaN: NaN.
/// - Accuracy: the distribution function at w is within 2 ε of u, and w within a relative 5 ε for u ≤ ¾;
///   for bells with n < K within 6 ε and 12 ε. Sampled; ε as on the [module's page](super).
/// - Cost: a closed form 1 log1p, 1 expm1, 1 or 2 divisions; with n < K for a bell, the two functions
///   twice. Newton's iteration with n ≥ K takes 1 to 4 steps of 1 expm1, 1 log1p and 3 divisions; with
///   n < K up to 6 steps of 4 to 6 such functions. In the mean 2 steps either way (sampled).
///
/// ```
/// use bellfit::kernel::sampling::{Density, Measure, Profile, sample_versine};
/// let (n, u) = (9.0_f64, 0.3);
/// let phong = Density { profile: Profile::CosN, measure: Measure::SolidAngle };
/// assert!((sample_versine(phong, n, u) - (1.0 - libm::pow(1.0 - u, 1.0 / (n + 1.0)))).abs() < 1e-16);
/// // n = K: the bell's base is c itself, f c = c⁵.
/// let bell = Density { profile: Profile::Cs4, measure: Measure::Projected };
/// let c = 1.0 - sample_versine(bell, 4.0, u);
/// assert!((libm::pow(c, 6.0) - (1.0 - u)).abs() < 1e-15);
/// ```
#[inline]
pub fn sample_versine<F: Real>(density: Density, n: F, u: F) -> F {
    if !(u >= F::ZERO && u < F::ONE && is_exponent(n)) {
        return F::NAN;
    }
    // ln of what lies outside the angle.
    let outside = (-u).log1p();
    let Some(k) = density.bell(n) else {
        return -(outside / (n + F::from_u32(1 + density.measure.cosines()))).expm1();
    };
    let x = n / F::from_u32(k);
    let versine = match density.measure {
        Measure::SolidAngle => {
            let m = F::from_u32(k + 1);
            let outside = if x < F::ONE { (-u * fall(m, x)).log1p() } else { outside };
            -(outside / m).expm1() / x
        }
        Measure::Projected if x < F::ONE => projected_wide(k, x, u, -outside),
        Measure::Projected => projected_narrow(k, x, -outside),
    };
    versine.min(F::ONE)
}

/// Versine for f c dω of a bell that ends before c = 0: x = n/K ≥ 1, depth = -ln(1 - u).
///
/// g(y) = (K + 1) y - ln((a + e⁻ʸ)/(a + 1)) = depth in y = -ln b. g is concave, with 0 ≤ -g″ ≤ ¼ and
/// g′ > K + 1, so a step from an error e below the root leaves at most e²/(8 (K + 1)), below as well. The
/// start is the step from y = 0, and at most depth/((K + 1)(K + 2)) off.
#[inline]
fn projected_narrow<F: Real>(k: u32, x: F, depth: F) -> F {
    let m = F::from_u32(k + 1);
    let a = (x - F::ONE) * (F::from_u32(k + 2) / m);
    let mut y = depth / (m + F::ONE / (a + F::ONE));
    for _ in 0..STEPS {
        let s = -(-y).expm1();
        let share = s / (a + F::ONE);
        let slope = m + (F::ONE - s) / (a + (F::ONE - s));
        let step = (depth - (m * y - (-share).log1p())) / slope;
        y = y + step;
        if y + step * step == y {
            break;
        }
    }
    -(-y).expm1() / x
}

/// Versine for f c dω of a bell that reaches c = 0: x = n/K < 1, depth = -ln(1 - u).
///
/// With b = 1 - x w and M = [`projected_mass`], the mass beyond w is b^K c² M(x c/b) and the mass within
/// it (1 - w)(1 - bᴷ⁺¹)/((K + 1) x) + w² M(x w), each a sum of positive terms; over M(x), -ln of the
/// former is depth. It is concave in y = -ln c, of slope 1/M(x c/b), and under two lines: its tangent at
/// y = 0 and its asymptote, which give the start.
#[inline]
fn projected_wide<F: Real>(k: u32, x: F, u: F, depth: F) -> F {
    let (m, power) = (F::from_u32(k + 1), F::from_u32(k));
    let all = projected_mass(k, x);
    let asymptote = F::HALF * (depth + power * (-x).log1p() - (F::TWO * all).log());
    let mut y = (depth * all).max(asymptote);
    for _ in 0..STEPS {
        let w = -(-y).expm1();
        let c = F::ONE - w;
        let ln_b = (-x * w).log1p();
        let beyond = projected_mass(k, x * c / (F::ONE - x * w));
        let reached = if u < F::HALF {
            let within = -c * (m * ln_b).expm1() / (m * x) + w * w * projected_mass(k, x * w);
            -(-within / all).log1p()
        } else {
            F::TWO * y - power * ln_b - (beyond / all).log()
        };
        let step = (depth - reached) * beyond;
        y = y + step;
        if y + step * step == y {
            break;
        }
    }
    -(-y).expm1()
}
