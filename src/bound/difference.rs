//! Δ(n, θ) = cosⁿθ - cs_16(n, θ), the lobe paper's error, bounded over every real n of a range
//! and every θ in [0, π/2].
//!
//! In t = n (1 - cos θ) and m = 1/n: cosⁿθ = (1 - t m)^n and cs_16 = (1 - t/16)^16 up to its cut.
//! (1 - t m)^(1/m) falls in t and in m, so its range over a box is known from two corners.

use super::{Interval, Jet, infimum, range, supremum};
use crate::integral::{Edge, Field, Limit};
use crate::kernel::model::Model;

/// An extreme value of Δ, with its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DifferenceExtreme {
    /// Encloses the extreme value.
    pub value: Interval,
    /// The specular exponent at which it is reached.
    pub n: f64,
    /// t = n (1 - cos θ) there; for a supremum beyond the cut, the cut itself.
    pub t: f64,
    /// Whether it is approached from beyond the cut (θ → cr+), and not attained.
    pub beyond_cut: bool,
    /// Boxes examined.
    pub boxes: usize,
}

impl DifferenceExtreme {
    /// θ at which the extreme is reached, in radians.
    pub fn theta(&self) -> f64 {
        2.0 * libm::asin(libm::sqrt((0.5 * self.t / self.n).clamp(0.0, 1.0)))
    }
}

/// cosⁿθ = (1 - t m)^(1/m) over a box of t ≥ 0 and m ≥ 0: it falls in both, so two corners tell; at
/// m = 0 it is its limit e⁻ᵗ.
pub fn cos_n_range(t: Interval, m: Interval) -> Interval {
    let limit = |t: f64| (-Interval::from(t)).exp();
    if m.hi() == 0.0 {
        return Interval::new(limit(t.hi()).lo(), limit(t.lo()).hi());
    }
    let base = |t: f64, m: f64| Interval::from(1.0) - Interval::from(t) * Interval::from(m);
    let low = Interval::root_below(base(t.hi(), m.hi()).lo(), m.hi());
    let high = if m.lo() == 0.0 {
        limit(t.lo()).hi()
    } else {
        Interval::root_above(base(t.lo(), m.lo()).hi(), m.lo()).min(limit(t.lo()).hi())
    };
    Interval::new(low, high)
}

/// Boxes after which a search settles for the enclosure it has.
pub(super) const MOST_BOXES: usize = 200_000;

/// The base of (1), 1 - t/16, to its 16th power, not clamped.
fn bell(t: Interval) -> Interval {
    (Interval::from(1.0) - t / Interval::from(16.0)).power(16)
}

/// t at the cut, at most t at θ = π/2.
pub fn cut_range(cut: Limit, m: Interval) -> Interval {
    crate::integral::scaled_versine(Model::Phong, cut, &m)
}

/// (1 - t m)^(1/m) - (1 - t/16)^16 as a jet in t, at one m.
fn difference(t: Jet, m: Interval) -> Jet {
    let sixteen = Jet::int(16);
    cos_n_jet(t, m) - (Jet::int(1) - t / sixteen).power(16)
}

/// cosⁿθ as a jet in t at one m: the slope is -(1 - t m)^(1/m - 1), the value over 1 - t m.
pub(super) fn cos_n_jet(t: Jet, m: Interval) -> Jet {
    let value = cos_n_range(t.value, m);
    let base = |t: f64| Interval::from(1.0) - Interval::from(t) * m;
    let (first, last) = (base(t.value.lo()), base(t.value.hi()));
    // It falls in t as well. Where 1 - t m may reach 0 it is at least 0, and at most 1.
    let least = if last.lo() > 0.0 { (Interval::from(value.lo()) / last).lo().max(0.0) } else { 0.0 };
    let most = if first.lo() > 0.0 { (Interval::from(value.hi()) / first).hi().min(1.0) } else { 1.0 };
    Jet { value, slope: -Interval::new(least, most) * t.slope }
}

/// The range of m = 1/n for n > 0, rounded outward; exact at powers of two, so that the ends of
/// 16..1024 stay what they are, and at ∞.
///
/// ```
/// use bellfit::bound::{Interval, reciprocal};
/// assert_eq!(reciprocal(Interval::new(16.0, 1024.0)), Interval::new(1.0 / 1024.0, 1.0 / 16.0));
/// assert!(reciprocal(Interval::from(1000.0)).width() > 0.0);
/// ```
pub fn reciprocal(n: Interval) -> Interval {
    let end = |x: f64| {
        let exact = x == f64::INFINITY || libm::frexp(x).0 == 0.5;
        if exact { Interval::from(1.0 / x) } else { Interval::from(1.0) / Interval::from(x) }
    };
    Interval::new(end(n.hi()).lo(), end(n.lo()).hi())
}

/// sup Δ over every real n in `n` (16 ≤ n) and θ in [0, π/2].
///
/// Up to the cut, branch and bound over (m, t) with t in [0, 16]: cosⁿθ falls in m at fixed t, so
/// a box's upper bound is taken at its smallest m and its lower one at its largest, each by the
/// mean value form in t. Beyond the cut Δ = cosⁿθ falls in t, so its supremum over θ is its value
/// at the cut, searched over m alone. Beyond t = 16 all is below e^-16: cosⁿθ ≤ e^-t, and the
/// bell is at most 8^-16 up to 6/√n, the furthest cut.
///
/// ```
/// use bellfit::{bound::{difference_supremum, Interval}, integral::Limit};
/// let found = difference_supremum(Limit::ExactZero, Interval::new(16.0, 1024.0), 1e-6);
/// assert!(found.value.lo() > 1.70e-2 && found.value.hi() < 1.71e-2 && found.n == 1024.0);
/// ```
pub fn difference_supremum(cut: Limit, n: Interval, tolerance: f64) -> DifferenceExtreme {
    let over = reciprocal(n);
    let cell = |[m, t]: &[Interval; 2]| {
        let at = |m: f64| range(|t| difference(t, Interval::from(m)), *t);
        Interval::new(at(m.hi()).lo(), at(m.lo()).hi())
    };
    let inside = supremum(cell, [over, Interval::new(0.0, 16.0)], tolerance, MOST_BOXES);
    let beyond = supremum(|[m]| cos_n_range(cut_range(cut, *m), *m), [over], tolerance, MOST_BOXES);
    let tail = Interval::from(-16.0).exp().hi();
    let boxes = inside.boxes + beyond.boxes;
    // The search inside went up to t = 16; what it found counts as reached only before the cut.
    let reached = inside.at[1] <= cut_range(cut, Interval::from(inside.at[0])).lo();
    let value = Interval::new(
        beyond.value.lo().max(if reached { inside.value.lo() } else { f64::NEG_INFINITY }),
        inside.value.hi().max(beyond.value.hi()).max(tail),
    );
    let exponent = |m: f64| (1.0 / m).clamp(n.lo(), n.hi());
    if beyond.value.lo() > inside.value.hi() {
        let m = beyond.at[0];
        let t = cut_range(cut, Interval::from(m)).mid();
        DifferenceExtreme { value, n: exponent(m), t, beyond_cut: true, boxes }
    } else {
        let [m, t] = inside.at;
        DifferenceExtreme { value, n: exponent(m), t, beyond_cut: false, boxes }
    }
}

/// inf Δ at one real n in (0, 16], over θ in [0, π/2], where the lobe lies above cosⁿθ and its
/// zero at or beyond π/2.
///
/// It rises with n. At fixed t cosⁿθ rises with n; and what t gains beyond n, where n ended, is at
/// least -(1 - n/16)^16, which is Δ(n, π/2), as cos(π/2) = 0.
pub fn difference_infimum(n: f64, tolerance: f64) -> DifferenceExtreme {
    let m = reciprocal(Interval::from(n));
    let domain = Interval::new(0.0, n.min(16.0));
    let found = infimum(|[t]| range(|t| difference(t, m), *t), [domain], tolerance, MOST_BOXES);
    DifferenceExtreme { value: found.value, n, t: found.at[0], beyond_cut: false, boxes: found.boxes }
}

/// sup over n of |Δ with the approximate cut - Δ with the exact one|: how much lobe the
/// approximation cuts off or lets through.
///
/// The two differ by the bell between zero and cut, where it is monotone, so the supremum over θ
/// is its value at the cut: (1 - t_cut/16)^16.
pub fn cut_effect(cut: Limit, n: Interval, tolerance: f64) -> DifferenceExtreme {
    let found = supremum(|[m]| bell(cut_range(cut, *m)), [reciprocal(n)], tolerance, MOST_BOXES);
    let t = cut_range(cut, Interval::from(found.at[0])).mid();
    DifferenceExtreme {
        value: found.value,
        n: (1.0 / found.at[0]).clamp(n.lo(), n.hi()),
        t,
        beyond_cut: true,
        boxes: found.boxes,
    }
}

/// √n · arccos(1 - 16/n) at one n ≥ 16: what the numerator of cr ≈ c/√n should be.
///
/// It falls in n: with z = n θ², z (1 - cos √(z m))/(z m) = 16, and (1 - cos √y)/y falls in y, so
/// z must rise with m. Enclosed by testing candidates in interval arithmetic.
pub fn cut_numerator(n: f64) -> Interval {
    let m = reciprocal(Interval::from(n));
    let exact = libm::sqrt(n) * 2.0 * libm::asin(libm::sqrt(8.0 / n));
    let t_at = |c: f64| {
        let z = Interval::from(c).power(2);
        z * (z * m).least(Interval::half_pi_squared()).versine_ratio()
    };
    let mut step = 4.0 * f64::EPSILON;
    let (mut lo, mut hi) = (exact, exact);
    while t_at(lo).hi() > 16.0 {
        lo = exact - step;
        step *= 2.0;
    }
    step = 4.0 * f64::EPSILON;
    let edge = (Interval::half_pi_squared() * Interval::from(n)).square_root().hi();
    while t_at(hi).lo() < 16.0 && hi < edge {
        hi = (exact + step).min(edge);
        step *= 2.0;
    }
    Interval::new(lo, hi)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn at_n_16_the_two_lobes_are_one() {
        // (1/16·16 (cos θ - 1) + 1)^16 = cos^16 θ
        let found = difference_supremum(Limit::ExactZero, Interval::from(16.0), 1e-6);
        assert!(found.value.contains(0.0) && found.value.hi() < 2e-6, "{found:?}");
        // 6/√16 = 1.5 cuts a little off: cos^16 1.5, to rounding.
        let found = difference_supremum(Limit::Paper, Interval::from(16.0), 1e-6);
        let cut_off = libm::pow(libm::cos(1.5), 16.0);
        assert!((found.value.lo() / cut_off - 1.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn the_cut_numerator_ends_at_two_pi_and_the_root_of_32() {
        // n = 16: 4 · π/2 = 2π. n → ∞: n θ²/2 = 16, so √32.
        assert!(cut_numerator(16.0).contains(core::f64::consts::TAU));
        let far = cut_numerator(1e9);
        assert!((far.mid() - libm::sqrt(32.0)).abs() < 1e-6 && far.width() < 1e-12);
    }

    /// t = n (1 - cos θ): n/2 at 60°, n at 90°, and what rounding leaves beyond stays there.
    #[test]
    fn the_angle_of_an_extreme_is_that_of_its_t() {
        let at = |n: f64, t: f64| {
            let found = DifferenceExtreme { value: Interval::ZERO, n, t, beyond_cut: false, boxes: 0 };
            found.theta()
        };
        let right = core::f64::consts::FRAC_PI_2;
        assert!((at(8.0, 4.0) - right * 2.0 / 3.0).abs() < 1e-15 && (at(8.0, 8.0) - right).abs() < 1e-15);
        assert!(
            at(8.0, 0.0) == 0.0
                && (at(8.0, 16.0) - 2.0 * right).abs() < 1e-15
                && at(8.0, 17.0) <= 2.0 * right
        );
    }

    /// In 128 bits: c²'s t is at most 16 at the lower end and at least 16 at the upper one.
    #[test]
    fn cut_numerators_are_enclosed_from_both_sides() {
        use crate::bound::{Fixed, exact};
        for n in
            [16.5, 17.0, 18.0, 20.0, 23.0, 31.0, 40.0, 63.0, 64.0, 100.0, 333.0, 1000.0, 1024.0, 5e4, 1e7]
        {
            let found = cut_numerator(n);
            let t = |c: f64| {
                let c = Fixed::rational(&exact(c).unwrap());
                let z = c.clone() * c;
                let ratio = (z.clone() / Fixed::rational(&exact(n).unwrap())).versine_ratio();
                (z * ratio).to_interval()
            };
            assert!(t(found.lo()).hi() <= 16.0 && t(found.hi()).lo() >= 16.0, "{n}: {found:?}");
            assert!(found.width() < 2e-14, "{n}: {found:?}");
        }
    }

    /// The lobe paper's difference at n = 64 and 1024 on a grid of t in doubles.
    #[test]
    fn extremes_are_those_of_a_grid() {
        let delta = |n: f64, t: f64| {
            libm::exp(n * libm::log1p(-(t / n).min(1.0))) - libm::pow((1.0 - t / 16.0).max(0.0), 16.0)
        };
        for n in [64.0, 1024.0] {
            let found = difference_supremum(Limit::ExactZero, Interval::from(n), 1e-7);
            let best = (0..=16_000).map(|i| delta(n, f64::from(i) * 1e-3)).fold(0.0, f64::max);
            assert!(found.value.hi() >= best && found.value.lo() <= best + 1e-7, "{n}: {found:?} {best}");
            assert!(found.value.width() < 2e-7 && found.n == n && !found.beyond_cut, "{n}: {found:?}");
            assert!((delta(n, found.t) - best).abs() < 1e-6, "{n}: {found:?}");
        }
        for n in [4.0, 10.0] {
            let found = difference_infimum(n, 1e-7);
            let least = (0..=10_000).map(|i| delta(n, n * f64::from(i) * 1e-4)).fold(0.0, f64::min);
            assert!(found.value.lo() <= least && found.value.hi() >= least - 1e-7, "{n}: {found:?} {least}");
            assert!(found.value.width() < 2e-7 && (delta(n, found.t) - least).abs() < 1e-6, "{n}: {found:?}");
        }
        // 6/√n for the zero: (1 - t/16)^16 at t = n (1 - cos(6/√n)), largest where n is least.
        let effect = |n: f64| libm::pow(1.0 - n * (1.0 - libm::cos(6.0 / libm::sqrt(n))) / 16.0, 16.0);
        let best = (0..=1000).map(|i| effect(17.0 + 3.0 * f64::from(i) / 1000.0)).fold(0.0, f64::max);
        let found = cut_effect(Limit::Paper, Interval::new(17.0, 20.0), 1e-3 * best);
        assert!(
            found.value.hi() >= best * (1.0 - 1e-9) && found.value.lo() <= best * 1.001,
            "{found:?} {best:e}"
        );
        assert!(found.value.width() < 2e-3 * best, "{found:?} {best:e}");
        assert!((effect(found.n) / best - 1.0).abs() < 5e-3 && found.beyond_cut, "{found:?}");
    }

    /// By the mean value theorem a difference quotient is a slope at a point between; the slope is -cosⁿ/(1 - t m).
    #[test]
    fn slopes_of_cos_n_are_tight() {
        for (t, m) in [(0.3, 0.0625), (2.0, 0.01), (7.5, 0.125), (7.999, 0.125), (3.0, 0.0)] {
            let found = cos_n_jet(Jet::variable(Interval::from(t)), Interval::from(m));
            let value = if m == 0.0 { libm::exp(-t) } else { libm::exp(libm::log1p(-t * m) / m) };
            let slope = -value / (1.0 - t * m);
            assert!((found.value.mid() - value).abs() < 1e-14 && found.value.width() < 1e-13, "{found:?}");
            assert!((found.slope.mid() - slope).abs() < 1e-13 && found.slope.width() < 1e-12, "{found:?}");
        }
        // Where 1 - t m may reach 0 or leave it: from -1 to 0.
        let edge = cos_n_jet(Jet::variable(Interval::new(7.0, 9.0)), Interval::from(0.125));
        assert!(edge.slope.lo() >= -1.0 && edge.slope.hi() >= 0.0 && edge.slope.hi() < 1e-300, "{edge:?}");
        let steep = -libm::pow(0.125, 7.0);
        assert!(edge.slope.lo() <= steep && edge.slope.lo() > 1.001 * steep, "{edge:?}");
        // Over a box both corners: (1 - t m)^(1/m) falls in t and in m.
        let found = cos_n_range(Interval::new(1.0, 2.0), Interval::new(0.05, 0.1));
        let (lo, hi) = (libm::pow(0.8, 10.0), libm::pow(0.95, 20.0));
        assert!((found.lo() - lo).abs() < 1e-14 && (found.hi() - hi).abs() < 1e-14, "{found:?}");
        let found = cos_n_range(Interval::new(1.0, 2.0), Interval::new(0.0, 0.1));
        assert!((found.lo() - lo).abs() < 1e-14 && (found.hi() - libm::exp(-1.0)).abs() < 1e-14, "{found:?}");
        let n = reciprocal(Interval::new(3.0, f64::INFINITY));
        assert!(n.lo() == 0.0 && n.hi() >= 1.0 / 3.0 && n.hi() <= (1.0_f64 / 3.0).next_up().next_up());
    }
}
