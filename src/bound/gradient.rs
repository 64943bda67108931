//! A value with its derivatives in two variables, all enclosed.

use super::Interval;
use super::difference::cos_n_range;
use crate::integral::Field;
use core::ops::{Add, Div, Mul, Sub};

/// Enclosures of f(x) and of both partial derivatives for every x of a box.
///
/// ```
/// use bellfit::bound::{Gradient, Interval};
/// let [x, y] = Gradient::variables([Interval::new(2.0, 3.0), Interval::from(5.0)]);
/// let product = x * y;
/// assert!(product.slopes[0].contains(5.0) && product.slopes[1].encloses(Interval::new(2.0, 3.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient {
    /// f over the box.
    pub value: Interval,
    /// Its partial derivatives over the box.
    pub slopes: [Interval; 2],
}

impl Gradient {
    /// The two coordinates of a box.
    pub fn variables([x, y]: [Interval; 2]) -> [Self; 2] {
        let (zero, one) = (Interval::from(0.0), Interval::from(1.0));
        [Gradient { value: x, slopes: [one, zero] }, Gradient { value: y, slopes: [zero, one] }]
    }

    /// A number that depends on neither.
    pub fn constant(value: Interval) -> Self {
        Gradient { value, slopes: [Interval::from(0.0); 2] }
    }

    /// The range of f over a box: natural extension, met with the mean value form.
    pub fn range(f: impl Fn([Gradient; 2]) -> Gradient, x: [Interval; 2]) -> Interval {
        let over = f(Self::variables(x));
        if x.iter().all(|side| side.lo() == side.hi()) {
            return over.value;
        }
        let mid = x.map(|side| Interval::from(side.mid()));
        let mut mean = f(mid.map(Self::constant)).value;
        for i in 0..2 {
            mean = mean + over.slopes[i] * (x[i] - mid[i]);
        }
        over.value.intersect(mean)
    }

    /// cosⁿ = (1 - t m)^(1/m) for this t ≥ 0 and m = 1/n in [0, 1], its limit e⁻ᵗ at m = 0 included.
    pub fn cos_n(t: Self, m: Self) -> Self {
        let value = cos_n_range(t.value, m.value);
        let one = Interval::from(1.0);
        let x = t.value * m.value;
        // ∂/∂t = -cosⁿ/(1 - x); where x may reach 1 the quotient still lies in [0, 1] for m ≤ 1.
        let rest = one - x;
        let quotient = if rest.lo() > 0.0 { (value / rest).least(one) } else { Interval::new(0.0, 1.0) };
        let by_m = value * t.value.power(2) * growth(x);
        let slope = |i: usize| by_m * m.slopes[i] - quotient * t.slopes[i];
        Gradient { value, slopes: [slope(0), slope(1)] }
    }
}

/// (-ln(1 - x) - x/(1 - x))/x² = -Σ_{k≥2} (k-1)/k x^(k-2), so that ∂cosⁿ/∂m = cosⁿ t² growth(t m).
/// Falls in x; -∞ where x may reach 1.
pub(super) fn growth(x: Interval) -> Interval {
    let point = |x: f64| {
        if x >= 1.0 {
            return Interval::new(f64::NEG_INFINITY, -0.5);
        }
        let one = Interval::from(1.0);
        let v = Interval::from(x.max(0.0));
        if v.hi() > 0.1 {
            return (-(one - v).ln() - v / (one - v)) / v.power(2);
        }
        // The tail from k = 21 on is below x^19/(1 - x), as (k-1)/k < 1.
        let mut sum = Interval::from(0.0);
        for k in (2..=20).rev() {
            sum = sum * v + Interval::int(k - 1) / Interval::int(k);
        }
        -(sum + Interval::new(0.0, (v.power(19) / (one - v)).hi()))
    };
    Interval::new(point(x.hi()).lo(), point(x.lo()).hi())
}

impl Add for Gradient {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        let slopes = [self.slopes[0] + rhs.slopes[0], self.slopes[1] + rhs.slopes[1]];
        Gradient { value: self.value + rhs.value, slopes }
    }
}

impl Sub for Gradient {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        let slopes = [self.slopes[0] - rhs.slopes[0], self.slopes[1] - rhs.slopes[1]];
        Gradient { value: self.value - rhs.value, slopes }
    }
}

impl Mul for Gradient {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        let [a, b] = [self.slopes.map(|s| s * rhs.value), rhs.slopes.map(|s| self.value * s)];
        Gradient { value: self.value * rhs.value, slopes: [a[0] + b[0], a[1] + b[1]] }
    }
}

impl Div for Gradient {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        let value = self.value / rhs.value;
        let [a, b] = [self.slopes, rhs.slopes.map(|s| value * s)];
        Gradient { value, slopes: [(a[0] - b[0]) / rhs.value, (a[1] - b[1]) / rhs.value] }
    }
}

impl Field for Gradient {
    fn int(value: i64) -> Self {
        Gradient::constant(Interval::int(value))
    }

    fn power(&self, k: u32) -> Self {
        if k == 0 {
            return Self::int(1);
        }
        let factor = Interval::int(i64::from(k)) * self.value.power(k - 1);
        Gradient { value: self.value.power(k), slopes: self.slopes.map(|s| factor * s) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the mean value theorem a difference quotient is a slope at a point between.
    #[test]
    fn slopes_of_cos_n_contain_difference_quotients() {
        let value = |t: f64, m: f64| cos_n_range(Interval::from(t), Interval::from(m));
        for i in 0..200 {
            let (t, m) = (0.07 * f64::from(i % 100) + 0.01, 0.0005 + 0.0003 * f64::from(i));
            let (dt, dm) = (1e-3, 1e-5);
            let cell = [Interval::new(m, m + dm), Interval::new(t, t + dt)];
            let [gm, gt] = Gradient::variables(cell);
            let over = Gradient::cos_n(gt, gm);
            let by_m = (value(t, m + dm) - value(t, m)) / (Interval::from(m + dm) - Interval::from(m));
            let by_t = (value(t + dt, m) - value(t, m)) / (Interval::from(t + dt) - Interval::from(t));
            assert!(!over.slopes[0].is_disjoint(by_m), "m: {t} {m} {over:?} {by_m:?}");
            assert!(!over.slopes[1].is_disjoint(by_t), "t: {t} {m} {over:?} {by_t:?}");
            assert!(over.slopes[0].width() < 0.05 && over.slopes[1].width() < 0.01);
        }
    }

    #[test]
    fn the_limit_of_cos_n_is_the_exponential() {
        let [m, t] = Gradient::variables([Interval::new(0.0, 1e-9), Interval::from(2.0)]);
        let limit = Gradient::cos_n(t, m);
        assert!(limit.value.encloses(Interval::from(-2.0).exp()) && limit.value.width() < 1e-6);
        // ∂/∂m → -t²/2 e^-t
        assert!(limit.slopes[0].contains(-2.0 * libm::exp(-2.0)) && limit.slopes[0].width() < 1e-6);
    }

    #[test]
    fn growth_meets_its_series_at_the_join() {
        let join = growth(Interval::new(0.1, 0.1_f64.next_up()));
        assert!(join.width() < 1e-12, "{join:?}");
        assert!(growth(Interval::from(0.0)).contains(-0.5));
        assert_eq!(growth(Interval::new(0.5, 1.0)).lo(), f64::NEG_INFINITY);
    }

    /// x/y at (6, 3): 2, with slopes 1/3 and -6/9.
    #[test]
    fn quotients_differentiate() {
        let [x, y] = Gradient::variables([Interval::from(6.0), Interval::from(3.0)]);
        let quotient = x / y;
        assert!(quotient.value.contains(2.0) && quotient.value.width() < 1e-14);
        for (slope, exact) in quotient.slopes.into_iter().zip([1.0 / 3.0, -2.0 / 3.0]) {
            assert!(slope.contains(exact) && slope.width() < 1e-14, "{slope:?}");
        }
    }

    /// x³ y/(1 + y) - 2 x, its partial derivatives by hand; over a small box the range is its spread.
    #[test]
    fn derivatives_and_ranges_are_those_by_hand() {
        let f = |[x, y]: [Gradient; 2]| x.power(3) * y / (Gradient::int(1) + y) - Gradient::int(2) * x;
        let value = |x: f64, y: f64| x * x * x * y / (1.0 + y) - 2.0 * x;
        for (x, y) in [(1.5, 0.5), (-0.7, 2.0), (0.3, -0.4)] {
            let found = f(Gradient::variables([x, y].map(Interval::from)));
            let slopes = [3.0 * x * x * y / (1.0 + y) - 2.0, x * x * x / ((1.0 + y) * (1.0 + y))];
            let near =
                |found: Interval, exact: f64| (found.mid() - exact).abs() < 1e-14 && found.width() < 1e-13;
            assert!(near(found.value, value(x, y)), "{found:?}");
            assert!((0..2).all(|i| near(found.slopes[i], slopes[i])), "{found:?} {slopes:?}");
            for (dx, dy) in [(1e-5, 0.0), (0.0, 1e-5), (1e-5, 1e-5)] {
                let range = Gradient::range(f, [Interval::new(x, x + dx), Interval::new(y, y + dy)]);
                let corners = [value(x, y), value(x + dx, y), value(x, y + dy), value(x + dx, y + dy)];
                let lo = corners.into_iter().fold(f64::INFINITY, f64::min);
                let hi = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
                assert!(range.lo() <= lo + 1e-15 && range.hi() >= hi - 1e-15, "{range:?} {lo} {hi}");
                // The slopes' terms add in size.
                let spread = slopes[0].abs() * dx + slopes[1].abs() * dy;
                assert!(range.width() <= 1.001 * spread + 1e-13, "{range:?} {spread:e}");
            }
        }
        assert_eq!(Gradient::variables([Interval::from(2.0); 2])[0].power(0), Gradient::int(1));
        let point = Gradient::range(f, [1.5, 0.5].map(Interval::from));
        assert!(point.contains(value(1.5, 0.5)) && point.width() < 1e-13);
    }

    /// (-ln(1 - x) - x/(1 - x))/x², by its series Σ (k - 1)/k x^(k-2) to 200 terms.
    #[test]
    fn growth_is_its_series() {
        let series = |x: f64| -(2..200).rev().fold(0.0, |sum, k| sum * x + f64::from(k - 1) / f64::from(k));
        for x in [1e-9, 0.01, 0.05, 0.0999, 0.11, 0.3, 0.6] {
            let found = growth(Interval::from(x));
            assert!((found.mid() / series(x) - 1.0).abs() < 1e-12 && found.width() < 1e-11, "{x}: {found:?}");
        }
        let found = growth(Interval::new(0.05, 0.3));
        assert!((found.lo() - series(0.3)).abs() < 1e-11 && (found.hi() - series(0.05)).abs() < 1e-11);
        assert_eq!(growth(Interval::from(1.0)), Interval::new(f64::NEG_INFINITY, -0.5));
        // cosⁿ at a point: ∂/∂t = -cosⁿ/(1 - t m), ∂/∂m = cosⁿ (ln(1 - x) + x/(1 - x))/-m², x = t m.
        for (t, m) in [(2.0, 0.05), (0.5, 0.1), (7.0, 0.125)] {
            let [gm, gt] = Gradient::variables([m, t].map(Interval::from));
            let found = Gradient::cos_n(gt, gm);
            let (x, value) = (t * m, libm::exp(libm::log1p(-t * m) / m));
            let by_m = value * (-libm::log1p(-x) - x / (1.0 - x)) / (m * m);
            for (found, exact) in
                [(found.value, value), (found.slopes[0], by_m), (found.slopes[1], -value / (1.0 - x))]
            {
                assert!((found.mid() - exact).abs() < 1e-11 && found.width() < 1e-11, "{found:?} {exact}");
            }
        }
    }

    /// x over y + x² in the first variable, and y over x: numerator and denominator both move.
    #[test]
    fn quotients_of_both_variables_differentiate() {
        let (a, b) = (1.5, 0.5);
        let [x, y] = Gradient::variables([a, b].map(Interval::from));
        let below = b + a * a;
        let slopes = [(below - 2.0 * a * a) / (below * below), -a / (below * below)];
        for (found, exact) in [
            (x / (y + x * x), slopes),
            (y / x, [-b / (a * a), 1.0 / a]),
            ((x - y) / (x + y), [2.0 * b / 4.0, -2.0 * a / 4.0]),
        ] {
            let near = |i: usize| {
                (found.slopes[i].mid() - exact[i]).abs() < 1e-14 && found.slopes[i].width() < 1e-14
            };
            assert!(near(0) && near(1), "{found:?} {exact:?}");
        }
    }
}
