//! How far a pixel's weight is from the Gaussian of σ = 1/3 of the ellipse's semi-axis, over the plane.

use super::{Interval, Jet, Supremum, range, supremum};
use crate::integral::Field;

/// Boxes after which a search settles for what it has.
const MOST_BOXES: usize = 400_000;

/// The Q behind which the search stops: there every weight of these is 0, and the Gaussian below e⁻⁷².
const FAR: f64 = 16.0;

/// Part of the texture plane: Q from 0 to 1 (the ellipse), at 1 (its rim), or all of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WeightRegion {
    /// Q ≤ 1.
    Ellipse,
    /// Q = 1.
    Rim,
    /// Every Q ≥ 0.
    Plane,
}

impl WeightRegion {
    const fn ends(self) -> (f64, f64) {
        match self {
            WeightRegion::Ellipse => (0.0, 1.0),
            WeightRegion::Rim => (1.0, 1.0),
            WeightRegion::Plane => (0.0, FAR),
        }
    }

    /// A supremum over the searched part as one over the region.
    fn with_tail(self, found: Supremum<1>) -> Supremum<1> {
        let tail = if self == WeightRegion::Plane { gaussian(Interval::from(FAR)).hi() } else { 0.0 };
        Supremum { value: Interval::new(found.value.lo(), found.value.hi().max(tail)), ..found }
    }
}

/// e^(-9Q/2).
fn gaussian(q: Interval) -> Interval {
    (-(Interval::from(4.5) * q)).exp()
}

/// max(p, 0)^K, p = 1 - c₁ z + c₂ z² - c₃ z³ with z = 9Q/(2K): a weight by its polynomial.
///
/// p is to stay at or below 0 behind its first zero, and that zero to lie at Q = 16 or before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BellTerms {
    /// K.
    pub power: u32,
    /// c₁, c₂, c₃.
    pub terms: [Interval; 3],
}

impl BellTerms {
    fn base(&self, q: Jet) -> Jet {
        let [c1, c2, c3] = self.terms.map(Jet::constant);
        let z = Jet::constant(Interval::from(4.5) / Interval::int(i64::from(self.power))) * q;
        Jet::int(1) - z * (c1 - z * (c2 - z * c3))
    }

    /// sup over the region of |e^(-9Q/2) - bell(Q)|; `at` is Q.
    ///
    /// ```
    /// use bellfit::bound::{BellTerms, Interval, WeightRegion};
    /// // Lyon's bell, K = 8: on the rim e^-4.5 - (7/16)^8
    /// let [one, zero] = [1.0, 0.0].map(Interval::from);
    /// let bell = BellTerms { power: 8, terms: [one, zero, zero] };
    /// let rim = bell.distance(WeightRegion::Rim, 1e-9).value;
    /// assert!((rim.mid() - (libm::exp(-4.5) - libm::pow(7.0 / 16.0, 8.0))).abs() < 1e-15);
    /// ```
    pub fn distance(&self, region: WeightRegion, tolerance: f64) -> Supremum<1> {
        let (lo, hi) = region.ends();
        let error = |q: Jet| {
            let base = self.base(q);
            let below = base.value.lo() < 0.0;
            let slope = if below { base.slope.hull(Interval::from(0.0)) } else { base.slope };
            let bell = Jet { value: base.value.max(Interval::from(0.0)), slope }.power(self.power);
            (Jet::int(0) - q * Jet::constant(Interval::from(4.5))).exp() - bell
        };
        let found = supremum(|[q]| range(error, *q).abs(), [Interval::new(lo, hi)], tolerance, MOST_BOXES);
        region.with_tail(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// |e^(-9Q/2) - max(p, 0)^K| on a grid of Q.
    #[test]
    fn distances_are_those_of_a_grid() {
        for (power, c) in
            [(8, [1.0, 0.0, 0.0]), (4, [1.1, 0.4, 0.05]), (2, [0.95, 0.3, 0.04]), (1, [0.6, 0.1, 0.01])]
        {
            let bell = BellTerms { power, terms: c.map(Interval::from) };
            let at = |q: f64| {
                let z = 4.5 * q / f64::from(power);
                let p = 1.0 - c[0] * z + c[1] * z * z - c[2] * z * z * z;
                (libm::exp(-4.5 * q) - libm::pow(p.max(0.0), f64::from(power))).abs()
            };
            for (region, end) in [(WeightRegion::Ellipse, 1.0), (WeightRegion::Plane, 16.0)] {
                let found = bell.distance(region, 1e-7);
                let best = (0..=20_000).map(|i| at(end * f64::from(i) / 20_000.0)).fold(0.0, f64::max);
                let name = format!("{power} {region:?}: {found:?} {best}");
                assert!(found.value.hi() >= best && found.value.lo() <= best + 1e-5, "{name}");
                assert!(found.value.width() < 2e-7 && (at(found.at[0]) - best).abs() < 1e-5, "{name}");
            }
            let rim = bell.distance(WeightRegion::Rim, 1e-7);
            assert!(
                (rim.value.mid() - at(1.0)).abs() < 1e-15 && rim.value.width() < 1e-14 && rim.at == [1.0]
            );
        }
    }

    /// Behind the search the Gaussian is left, e⁻⁷².
    #[test]
    fn the_plane_keeps_the_gaussians_tail() {
        let nothing = Supremum { value: Interval::ZERO, at: [0.5], boxes: 3 };
        let tail = WeightRegion::Plane.with_tail(nothing);
        assert!((tail.value.hi() / libm::exp(-72.0) - 1.0).abs() < 1e-12 && tail.value.lo() == 0.0);
        assert_eq!((tail.at, tail.boxes), ([0.5], 3));
        assert_eq!(WeightRegion::Ellipse.with_tail(nothing), nothing);
        assert_eq!(WeightRegion::Rim.with_tail(nothing), nothing);
        for q in [0.0, 0.2, 1.0, 3.0] {
            let found = gaussian(Interval::from(q));
            assert!((found.mid() / libm::exp(-4.5 * q) - 1.0).abs() < 1e-14 && found.width() < 1e-14, "{q}");
        }
    }
}
