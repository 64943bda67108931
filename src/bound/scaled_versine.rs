//! The lobe's angle by v = -ln cosⁿ: cosⁿ = e⁻ᵛ whatever n is, and t = n (1 - cos θ) = v φ(v/n), φ(x) =
//! (1 - e⁻ˣ)/x, smooth in v and m = 1/n down to m = 0.

use super::Interval;
use super::taylor::Taylor;
use crate::integral::Field;

/// (1/k!) ∫₀¹ sᵏ e^(-xs) ds for k = 0..=5 at one x ≥ 0: |φ⁽ᵏ⁾(x)|/k!.
fn moments(x: f64) -> [Interval; 6] {
    let (at, decay) = (Interval::from(x), Interval::from(-x).exp());
    let mut moments = [Interval::ZERO; 6];
    if x >= 8.0 {
        // Iₖ = (k Iₖ₋₁ - e⁻ˣ)/x, whose errors shrink by k/x < 1.
        moments[0] = (Interval::from(1.0) - decay) / at;
        for k in 1..6 {
            moments[k] = (Interval::int(k as i64) * moments[k - 1] - decay) / at;
        }
    } else {
        // Iₖ₋₁ = (x Iₖ + e⁻ˣ)/k from I₄₄ in [e⁻ˣ/45, 1/45]: what is not known of it shrinks by
        // 8³⁹ 5!/44! < 1e-17 on the way to I₅.
        let mut moment = Interval::new(decay.lo(), 1.0) / Interval::int(45);
        for k in (0..44).rev() {
            moment = (at * moment + decay) / Interval::int(k as i64 + 1);
            if k < 6 {
                moments[k] = moment;
            }
        }
    }
    let mut factorial = 1;
    for (k, moment) in moments.iter_mut().enumerate() {
        factorial *= (k as i64).max(1);
        *moment = *moment / Interval::int(factorial);
    }
    moments
}

/// t over boxes of m = 1/n and v: it falls in m and rises with v.
pub(super) fn scaled_versine(m: Interval, v: Interval) -> Interval {
    // v φ(v m) at one corner; at v = ∞ it ends at n.
    let corner = |m: f64, v: f64| {
        if v == f64::INFINITY {
            return if m > 0.0 { Interval::from(1.0) / Interval::from(m) } else { Interval::from(v) };
        }
        let x = Interval::from(m) * Interval::from(v);
        let phi = |x: f64| moments(x.max(0.0))[0];
        Interval::from(v) * Interval::new(phi(x.hi()).lo(), phi(x.lo()).hi())
    };
    Interval::new(corner(m.hi(), v.lo()).lo().max(0.0), corner(m.lo(), v.hi()).hi())
}

/// The Taylor coefficients of t in m and v.
pub(super) fn scaled_versine_taylor(m: Taylor, v: Taylor) -> Taylor {
    let x = m * v;
    let (near, far) = (moments(x.value().lo().max(0.0)), moments(x.value().hi().max(0.0)));
    // Each falls in x; the signs alternate.
    let phi = x.composed(|k| {
        let size = Interval::new(far[k].lo(), near[k].hi());
        if k % 2 == 0 { size } else { -size }
    });
    v * phi
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_meet_their_closed_forms_on_both_sides_of_the_join() {
        // I₁ = (1 - (1 + x) e⁻ˣ)/x²; at 0 they are 1/(k + 1).
        for x in [0.5, 1.0, 7.9, 8.0, 30.0] {
            let at = Interval::from(x);
            let closed = (Interval::from(1.0) - (Interval::from(1.0) + at) * (-at).exp()) / (at * at);
            assert!(!moments(x)[1].is_disjoint(closed), "{x}");
            assert!(moments(x)[5].width() < 1e-13 * moments(x)[5].hi(), "{x}: {:?}", moments(x)[5]);
        }
        assert!((0..6).all(|k| {
            let factorial: i64 = (1..=k as i64).product();
            let exact = Interval::from(1.0) / Interval::int((k as i64 + 1) * factorial);
            !moments(0.0)[k].is_disjoint(exact)
        }));
    }

    #[test]
    fn the_scaled_versine_undoes_the_logarithm() {
        // n = 4, cos θ = 1/2: v = 4 ln 2, t = 2.
        let v = Interval::int(4) * Interval::LN_2;
        let t = scaled_versine(Interval::from(0.25), v);
        assert!(t.contains(2.0) && t.width() < 1e-14, "{t:?}");
        assert!(scaled_versine(Interval::from(0.25), Interval::new(v.lo(), f64::INFINITY)).contains(4.0));
    }
}
