//! How far the bells (1 - z t)^K are from e⁻ᵗ above and below it, at any scale z, and the best scale.

use super::difference::MOST_BOXES;
use super::{Interval, Jet, Supremum, range, supremum};
use crate::integral::Field;

/// Beyond it e⁻ᵗ is below 1e-26; the search stops there.
const FAR: f64 = 60.0;

/// Suprema over 0 ≤ t ≤ `to` of e⁻ᵗ - (1 - z t)₊^K and of (1 - z t)₊^K - e⁻ᵗ; `at` is t.
///
/// `to` may be infinite. Both functions fall beyond t = 60, so what they are there bounds the rest.
///
/// ```
/// use bellfit::bound::{Interval, scaled_bell_excess};
/// let eighth = Interval::from(0.125);
/// let [below, above] = scaled_bell_excess(8, eighth, f64::INFINITY, 1e-7);
/// // Lyon's bell lies below e⁻ᵗ everywhere.
/// assert!(below.value.lo() > 3.5e-2 && below.value.hi() < 3.6e-2 && above.value.hi() < 1e-6);
/// ```
pub fn scaled_bell_excess(power: u32, z: Interval, to: f64, tolerance: f64) -> [Supremum<1>; 2] {
    let end = to.min(FAR);
    let bell = |t: Jet| {
        let base = Jet::int(1) - Jet::constant(z) * t;
        let clamped = if base.value.lo() >= 0.0 {
            base
        } else {
            let value = base.value.max(Interval::from(0.0));
            let slope = if base.value.hi() <= 0.0 { Interval::from(0.0) } else { base.slope };
            Jet { value, slope: slope.hull(Interval::from(0.0)) }
        };
        clamped.power(power)
    };
    let below = |[t]: &[Interval; 1]| range(|t| (Jet::int(0) - t).exp() - bell(t), *t);
    let above = |[t]: &[Interval; 1]| range(|t| bell(t) - (Jet::int(0) - t).exp(), *t);
    let domain = [Interval::new(0.0, end)];
    // At t = 0 both are 0, so no supremum is negative; beyond `end` neither exceeds what it subtracts from.
    let last = Jet::constant(Interval::from(end));
    let beyond = |value: Interval| if to > end { value.hi() } else { 0.0 };
    let widen = |found: Supremum<1>, tail: f64| {
        let value = Interval::new(found.value.lo().max(0.0), found.value.hi().max(tail));
        Supremum { value, ..found }
    };
    [
        widen(supremum(below, domain, tolerance, MOST_BOXES), beyond((Jet::int(0) - last).exp().value)),
        widen(supremum(above, domain, tolerance, MOST_BOXES), beyond(bell(last).value)),
    ]
}

/// The scale at which sup over t ≥ 0 of |e⁻ᵗ - (1 - t/T)₊^K| is least.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BestScale {
    /// Encloses T.
    pub reach: Interval,
    /// Encloses the least supremum.
    pub error: Interval,
    /// A scale inside `reach`, whose supremum is at most `error`'s upper end.
    pub at: f64,
}

/// Finds and encloses the best scale for a power K ≥ 1, with `steps` halvings.
///
/// As T grows the bell rises at every t, so the supremum of e⁻ᵗ - bell falls and that of bell - e⁻ᵗ rises:
/// the larger of the two is least where they are equal, which is bracketed by where each is certified to
/// be the larger; and the least is no less than the smaller of the two at any T.
///
/// ```
/// use bellfit::bound::best_scale;
/// let best = best_scale(8, 20);
/// assert!(best.error.hi() < 1.62e-2 && best.reach.lo() > 8.0); // half of Lyon's 3.5e-2
/// ```
pub fn best_scale(power: u32, steps: u32) -> BestScale {
    let k = f64::from(power);
    // Lyon's T = K lies below e⁻ᵗ everywhere; at 4 K + 4 the bell lies far above.
    let (mut low, mut high) = (k, 4.0 * k + 4.0);
    let at = |reach: f64| {
        let z = Interval::from(1.0) / Interval::from(reach);
        scaled_bell_excess(power, z, f64::INFINITY, 1e-9).map(|s| s.value)
    };
    let (mut least, mut most, mut best) = (0.0_f64, f64::INFINITY, low);
    for _ in 0..steps {
        let middle = 0.5 * (low + high);
        let [below, above] = at(middle);
        least = least.max(below.lo().min(above.lo()));
        let larger = below.hi().max(above.hi());
        if larger < most {
            (most, best) = (larger, middle);
        }
        if below.lo() > above.hi() {
            low = middle;
        } else if above.lo() > below.hi() {
            high = middle;
        } else {
            break;
        }
    }
    BestScale { reach: Interval::new(low, high), error: Interval::new(least, most), at: best }
}

#[cfg(test)]
mod tests {
    use super::super::bell_distance;
    use super::*;

    #[test]
    fn at_lyons_scale_it_is_his_distance() {
        for power in [2, 4, 8, 16] {
            let z = Interval::from(1.0) / Interval::int(i64::from(power));
            let [below, above] = scaled_bell_excess(power, z, f64::INFINITY, 1e-8);
            let lyon = bell_distance(power, 1e-8);
            assert!(!below.value.is_disjoint(lyon.value) && above.value.hi() < 1e-7, "{power}");
        }
    }

    /// (1 - t/T)^K with T far beyond where the search stops: at t = 20 it is still (4/5)^2.
    #[test]
    fn a_bell_that_ends_late_is_still_bounded() {
        let [_, above] = scaled_bell_excess(2, Interval::from(0.01), f64::INFINITY, 1e-6);
        let at_five = Interval::from(0.95).power(2) - Interval::from(-5.0).exp();
        assert!(above.value.lo() >= at_five.lo() - 1e-6 && above.value.hi() < 1.0);
    }

    #[test]
    fn a_shorter_range_has_no_larger_supremum() {
        let z = Interval::from(0.1);
        let [short, whole] = [2.0, f64::INFINITY].map(|to| scaled_bell_excess(8, z, to, 1e-7));
        for (short, whole) in short.iter().zip(&whole) {
            assert!(short.value.lo() <= whole.value.hi() && short.at[0] <= 2.0);
        }
    }

    /// Both suprema on a grid of t in doubles, over part of the range and the whole.
    #[test]
    fn excesses_are_those_of_a_grid() {
        for (power, z, to) in
            [(1, 0.5, f64::INFINITY), (2, 0.3, 2.5), (8, 0.1, f64::INFINITY), (4, 0.2, 100.0), (2, 0.01, 3.0)]
        {
            let [below, above] = scaled_bell_excess(power, Interval::from(z), to, 1e-7);
            let at = |t: f64| libm::exp(-t) - libm::pow((1.0 - z * t).max(0.0), f64::from(power));
            let (mut most, mut least) = (0.0_f64, 0.0_f64);
            for i in 0..=10_000 {
                let x = at(to.min(20.0) * f64::from(i) * 1e-4);
                (most, least) = (most.max(x), least.min(x));
            }
            for (found, best, sign) in [(below, most, 1.0), (above, -least, -1.0)] {
                let name = format!("{power} {z} {to}: {found:?} {best}");
                assert!(found.value.hi() >= best && found.value.lo() <= best + 1e-5, "{name}");
                assert!(found.value.width() < 2e-7, "{name}");
                assert!((sign * at(found.at[0]) - best).abs() < 1e-5, "{name}");
            }
        }
        // Beyond t = 60 what is left of the bell there bounds it: (1 - 60/1000)².
        let [below, above] = scaled_bell_excess(2, Interval::from(1e-3), f64::INFINITY, 1e-7);
        assert!(above.value.hi() >= 0.94 * 0.94 && below.value.lo() >= 0.0 && below.value.hi() < 1e-6);
    }

    /// The best scale on a grid of T; its error is no more than at Lyon's.
    #[test]
    fn the_best_scale_is_the_least_of_a_grid() {
        for power in [1, 2, 8] {
            let k = f64::from(power);
            let worst = |reach: f64| {
                let at = |t: f64| (libm::exp(-t) - libm::pow((1.0 - t / reach).max(0.0), k)).abs();
                (0..=4000).map(|i| at(f64::from(i) * 4e-3)).fold(at(reach), f64::max)
            };
            // Steps of K/200 miss the least by 3 % at most.
            let (mut least, mut place) = (f64::INFINITY, 0.0);
            for i in 0..=200 {
                let reach = k * (1.0 + f64::from(i) / 200.0);
                let error = worst(reach);
                if error < least {
                    (least, place) = (error, reach);
                }
            }
            let found = best_scale(power, 12);
            let name = format!("{power}: {found:?} {least} {place}");
            assert!(found.error.lo() <= least && found.error.hi() >= 0.97 * least, "{name}");
            assert!(found.reach.contains(found.at) || found.reach.width() < 1e-2, "{name}");
            assert!(
                found.error.hi() <= least * 1.01 + 1e-4 && (found.at - place).abs() < 0.02 * place,
                "{name}"
            );
            assert!((worst(found.at) - found.error.hi()).abs() < 1e-4, "{name}");
            // A halving each: from 4 K + 4 - K, unless it ends before.
            assert!(found.reach.width() <= 1.001 * (3.0 * k + 4.0) / 4096.0, "{name}");
        }
    }
}
