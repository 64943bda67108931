//! A value with its first two derivatives, all enclosed: for functions that nearly cancel, where the mean
//! value form is too wide and Taylor's is not.

use super::{Interval, elementary::versine_ratio_slope};
use crate::integral::{Edge, Field};
use core::ops::{Add, Div, Mul, Sub};

/// Enclosures of f(x), f'(x) and f''(x) for every x of an interval.
///
/// ```
/// use bellfit::bound::{Curve, Interval};
/// let x = Curve::variable(Interval::new(2.0, 3.0));
/// let cube = x * x * x;
/// assert!(cube.slope.contains(12.0) && cube.slope.contains(27.0));
/// assert!(cube.bend.contains(12.0) && cube.bend.contains(18.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// f over the interval.
    pub value: Interval,
    /// f' over the interval.
    pub slope: Interval,
    /// f'' over the interval, [`Interval::WHOLE`] where f has none.
    pub bend: Interval,
}

/// Terms of the series of the versine's second derivative for y ≤ 3: 3^10 · 12 · 11/26! < 1e-19.
const VERSINE_TERMS: i64 = 12;

impl Curve {
    /// The identity.
    pub fn variable(x: Interval) -> Self {
        Curve { value: x, slope: Interval::from(1.0), bend: Interval::from(0.0) }
    }

    /// A number that does not depend on the variable.
    pub fn constant(value: Interval) -> Self {
        Curve { value, slope: Interval::from(0.0), bend: Interval::from(0.0) }
    }
}

/// The range of f over `x`, given `at`, f's enclosure at a point: natural extension, Taylor's form around
/// the middle, and the ends alone where the slope keeps its sign.
///
/// Taylor's form holds where f'' is enclosed; where it is not ([`Curve::bend`] whole) nothing is
/// concluded from it, and the slope, one-sided derivatives included, still gives the mean value form.
pub fn curved_range(f: impl Fn(Curve) -> Curve, at: impl Fn(f64) -> Interval, x: Interval) -> Interval {
    if x.lo() == x.hi() {
        return at(x.lo());
    }
    let over = f(Curve::variable(x));
    let mid = x.mid();
    let step = x - Interval::from(mid);
    let middle = f(Curve::variable(Interval::from(mid)));
    let slope = over.slope.intersect(middle.slope + over.bend * step);
    if slope.lo() >= 0.0 {
        return over.value.intersect(Interval::new(at(x.lo()).lo(), at(x.hi()).hi()));
    }
    if slope.hi() <= 0.0 {
        return over.value.intersect(Interval::new(at(x.hi()).lo(), at(x.lo()).hi()));
    }
    let mean = middle.value + slope * step;
    let half_square = step.power(2) * Interval::from(0.5);
    let taylor = middle.value + middle.slope * step + over.bend * half_square;
    over.value.intersect(mean).intersect(taylor)
}

impl Add for Curve {
    type Output = Self;
    fn add(self, rhs: Self) -> Self {
        Curve { value: self.value + rhs.value, slope: self.slope + rhs.slope, bend: self.bend + rhs.bend }
    }
}

impl Sub for Curve {
    type Output = Self;
    fn sub(self, rhs: Self) -> Self {
        Curve { value: self.value - rhs.value, slope: self.slope - rhs.slope, bend: self.bend - rhs.bend }
    }
}

impl Mul for Curve {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        Curve {
            value: self.value * rhs.value,
            slope: self.slope * rhs.value + self.value * rhs.slope,
            bend: self.bend * rhs.value
                + Interval::from(2.0) * self.slope * rhs.slope
                + self.value * rhs.bend,
        }
    }
}

impl Div for Curve {
    type Output = Self;
    /// q = f/g from f = q g: q' = (f' - q g')/g, q'' = (f'' - 2 q' g' - q g'')/g.
    fn div(self, rhs: Self) -> Self {
        let value = self.value / rhs.value;
        let slope = (self.slope - value * rhs.slope) / rhs.value;
        let bend = (self.bend - Interval::from(2.0) * slope * rhs.slope - value * rhs.bend) / rhs.value;
        Curve { value, slope, bend }
    }
}

impl Field for Curve {
    fn int(value: i64) -> Self {
        Curve::constant(Interval::int(value))
    }

    fn power(&self, k: u32) -> Self {
        if k < 2 {
            return if k == 0 { Self::int(1) } else { *self };
        }
        let outer = Interval::int(i64::from(k)) * self.value.power(k - 1);
        let twice = Interval::int(i64::from(k) * (i64::from(k) - 1)) * self.value.power(k - 2);
        Curve {
            value: self.value.power(k),
            slope: outer * self.slope,
            bend: twice * self.slope.power(2) + outer * self.bend,
        }
    }
}

impl Curve {
    /// g(f) from g, g' and g'' at f's values.
    fn outer(self, value: Interval, slope: Interval, bend: Interval) -> Self {
        Curve { value, slope: slope * self.slope, bend: bend * self.slope.power(2) + slope * self.bend }
    }
}

impl Edge for Curve {
    fn between(lo: f64, hi: f64) -> Self {
        Curve::constant(Interval::new(lo, hi))
    }

    fn sqrt(&self) -> Self {
        // (√x)' = 1/(2√x), (√x)'' = -1/(4 x √x)
        let value = self.value.square_root();
        let slope = Interval::from(0.5) / value;
        self.outer(value, slope, -(slope / (Interval::from(2.0) * self.value)))
    }

    fn versine_ratio(&self) -> Self {
        let y = self.value;
        self.outer(y.versine_ratio(), versine_ratio_slope(y), versine_ratio_bend(y))
    }

    fn half_power(&self) -> Self {
        let m = self.value;
        let value = m.half_power();
        if m.lo() <= 0.0 {
            // Their ranges over all m > 0: with y = ln 2/(2m) the slope is y² e^-y · 2/ln 2, at most 1.5620
            // at y = 2, and the bend (y⁴ - 2y³) e^-y · 4/ln² 2, extreme at y = 3 ± √3: -3.496 and 21.23.
            return self.outer(value, Interval::new(0.0, 1.5625), Interval::new(-3.5, 21.25));
        }
        let rate = Interval::LN_2 / (Interval::from(2.0) * m.power(2));
        let bend = value * rate * (rate - Interval::from(2.0) / m);
        self.outer(value, value * rate, bend)
    }

    fn min(&self, other: &Self) -> Self {
        if self.value.hi() <= other.value.lo() {
            *self
        } else if other.value.hi() <= self.value.lo() {
            *other
        } else {
            let slope = self.slope.hull(other.slope);
            Curve { value: self.value.least(other.value), slope, bend: Interval::WHOLE }
        }
    }

    fn half_pi_squared() -> Self {
        Curve::constant(Interval::half_pi_squared())
    }
}

/// d²/dy² of (1 - cos √y)/y for 0 ≤ y ≤ 3.
fn versine_ratio_bend(y: Interval) -> Interval {
    // Σ_{j≥2} (-1)^j j (j-1) y^(j-2)/(2j+2)!, alternating with falling terms for y ≤ 3.
    let point = |x: f64| {
        let x = Interval::from(x);
        let mut sum = Interval::from(0.0);
        let mut term = Interval::from(1.0) / Interval::from(360.0);
        for j in 2..VERSINE_TERMS {
            sum = sum + term;
            // a_(j+1)/a_j = -y (j+1)/((j-1)(2j+3)(2j+4))
            term = -(term * x * Interval::int(j + 1)) / Interval::int((j - 1) * (2 * j + 3) * (2 * j + 4));
        }
        sum + Interval::new(-term.abs().hi(), term.abs().hi())
    };
    // Falling for y ≤ 3: the third derivative's series starts -6/40320 + 24 y/3628800 < 0.
    Interval::new(point(y.hi()).lo(), point(y.lo().max(0.0)).hi())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By the mean value theorem a difference quotient of f is a value of f', one of f' a value of f''.
    fn check(f: impl Fn(Curve) -> Curve, x: Interval) {
        let over = f(Curve::variable(x));
        let at = |p: f64| f(Curve::variable(Interval::from(p)));
        let run = Interval::from(x.hi()) - Interval::from(x.lo());
        let (lo, hi) = (at(x.lo()), at(x.hi()));
        assert!(!over.slope.is_disjoint((hi.value - lo.value) / run), "{x:?}: {over:?}");
        assert!(!over.bend.is_disjoint((hi.slope - lo.slope) / run), "{x:?}: {over:?}");
        let whole = curved_range(&f, |p| at(p).value, x);
        for k in 0..=10 {
            let p = (x.lo() + (x.hi() - x.lo()) * f64::from(k) / 10.0).min(x.hi());
            let point = at(p);
            assert!(!whole.is_disjoint(point.value) && !over.value.is_disjoint(point.value));
            assert!(!over.slope.is_disjoint(point.slope) && !over.bend.is_disjoint(point.bend));
        }
    }

    #[test]
    fn derivatives_contain_difference_quotients() {
        for i in 0..20 {
            let x = Interval::new(0.1 * f64::from(i), 0.1 * f64::from(i + 1));
            check(|x| (x.power(3) - Curve::int(2) * x) / (Curve::int(1) + x * x).sqrt(), x);
            check(|x| x.versine_ratio(), x);
            check(|x| x * x.half_power() + x.min(&Curve::constant(Interval::from(1.05))), x);
            check(|x| x.half_power(), Interval::new(0.001 * f64::from(i), 0.001 * f64::from(i + 1)));
        }
    }

    #[test]
    fn bends_are_worth_something() {
        // (1 - cos √y)/y has the second derivative 2/6! = 1/360 at 0, and 2^(-1/(2m)) the bounds quoted.
        let at_zero = Curve::variable(Interval::from(0.0)).versine_ratio().bend;
        assert!(at_zero.contains(1.0 / 360.0) && at_zero.width() < 1e-16);
        let half_ln_2 = 0.5 * core::f64::consts::LN_2;
        for (y, extreme) in [(3.0 - libm::sqrt(3.0), -3.496), (3.0 + libm::sqrt(3.0), 21.23)] {
            let bend = Curve::variable(Interval::from(half_ln_2 / y)).half_power().bend;
            assert!((bend.mid() - extreme).abs() < 5e-3 && bend.width() < 1e-11, "{bend:?}");
        }
    }

    /// The width of what nearly cancels falls with the third power of the box's.
    #[test]
    fn cancelling_functions_are_bounded_to_third_order() {
        // (1 + x)(1 - x + x²) - 1 = x³
        let f = |x: Curve| (Curve::int(1) + x) * (Curve::int(1) - x + x * x) - Curve::int(1);
        let at = |p: f64| f(Curve::constant(Interval::from(p))).value;
        let width = |w: f64| curved_range(f, at, Interval::new(-w, w)).width();
        assert!(width(1e-3) < 1e-7 && width(1e-4) < 1e-10, "{} {}", width(1e-3), width(1e-4));
    }
}
