//! A function of two variables as its Taylor coefficients up to a fixed degree, all enclosed: what bounds
//! a small difference of two large functions over boxes that need not be small.

use super::Interval;
use crate::integral::Field;
use core::ops::{Add, Div, Mul, Sub};

/// Degree of the last coefficients kept, which bound the remainder.
const DEGREE: usize = 5;

/// ∂ⁱ⁺ʲf/∂xⁱ∂yʲ/(i! j!) for i + j ≤ 5, each enclosed over a box, or at a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Taylor([[Interval; DEGREE + 1]; DEGREE + 1]);

const ZERO: Taylor = Taylor([[Interval::ZERO; DEGREE + 1]; DEGREE + 1]);

/// The pairs (i, j) with i + j ≤ 5.
fn pairs() -> impl Iterator<Item = (usize, usize)> {
    (0..=DEGREE).flat_map(|i| (0..=DEGREE - i).map(move |j| (i, j)))
}

impl Taylor {
    /// The two coordinates.
    pub(super) fn variables([x, y]: [Interval; 2]) -> [Self; 2] {
        let one = Interval::from(1.0);
        let (mut first, mut second) = (Self::constant(x), Self::constant(y));
        first.0[1][0] = one;
        second.0[0][1] = one;
        [first, second]
    }

    /// A number that depends on neither.
    pub(super) fn constant(value: Interval) -> Self {
        let mut constant = ZERO;
        constant.0[0][0] = value;
        constant
    }

    /// The function's own range or value.
    pub(super) fn value(&self) -> Interval {
        self.0[0][0]
    }

    /// Its partial derivatives.
    pub(super) fn slopes(&self) -> [Interval; 2] {
        [self.0[1][0], self.0[0][1]]
    }

    /// g(f) from the coefficients g⁽ᵏ⁾/k! of g over the values of f.
    pub(super) fn composed(mut self, outer: impl Fn(usize) -> Interval) -> Self {
        self.0[0][0] = Interval::ZERO;
        let mut sum = Self::constant(outer(DEGREE));
        for k in (0..DEGREE).rev() {
            sum = sum * self;
            sum.0[0][0] = sum.0[0][0] + outer(k);
        }
        sum
    }

    /// eᶠ.
    pub(super) fn exp(self) -> Self {
        let value = self.value().exp();
        const FACTORIALS: [i64; DEGREE + 1] = [1, 1, 2, 6, 24, 120];
        self.composed(|k| value / Interval::int(FACTORIALS[k]))
    }

    /// The range of f over a box from its coefficients at the middle and over the box, by Taylor's theorem:
    /// those below the last degree at the middle, those of the last degree anywhere in the box.
    pub(super) fn range(middle: &Self, over: &Self, [x, y]: [Interval; 2]) -> Interval {
        let row = |j: usize| {
            let terms: [Interval; DEGREE + 1] = core::array::from_fn(|i| match i + j {
                degree if degree < DEGREE => middle.0[i][j],
                DEGREE => over.0[i][j],
                _ => Interval::ZERO,
            });
            polynomial(&terms, x)
        };
        over.value().intersect(polynomial(&core::array::from_fn(row), y))
    }
}

/// Range of Σ cₖ xᵏ over x, |x| small: the terms up to the square together, the others one by one.
fn polynomial(c: &[Interval; DEGREE + 1], x: Interval) -> Interval {
    let mut rest = Interval::ZERO;
    for k in (3..=DEGREE).rev() {
        rest = rest * x + c[k];
    }
    let right = upper_parabola(c[1].hi(), c[2].hi(), x.hi());
    let left = upper_parabola(-c[1].lo(), c[2].hi(), -x.lo());
    let low_right = upper_parabola(-c[1].lo(), -c[2].lo(), x.hi());
    let low_left = upper_parabola(c[1].hi(), -c[2].lo(), -x.lo());
    let parabola = Interval::new(-low_right.max(low_left), right.max(left));
    c[0] + parabola + rest * x.power(3)
}

/// An upper bound of b x + a x² for 0 ≤ x ≤ r (0 for r ≤ 0).
fn upper_parabola(b: f64, a: f64, r: f64) -> f64 {
    if r <= 0.0 {
        return 0.0;
    }
    let [b, a, r] = [b, a, r].map(Interval::from);
    let end = (r * (b + a * r)).hi().max(0.0);
    // The vertex counts where it may lie inside.
    let inside = a.hi() < 0.0 && b.lo() > 0.0 && (b + Interval::from(2.0) * a * r).lo() < 0.0;
    let vertex = if inside { (b * b / (Interval::from(-4.0) * a)).hi() } else { 0.0 };
    if end.is_nan() || vertex.is_nan() { f64::INFINITY } else { end.max(vertex) }
}

impl Add for Taylor {
    type Output = Self;
    fn add(mut self, rhs: Self) -> Self {
        for (i, j) in pairs() {
            self.0[i][j] = self.0[i][j] + rhs.0[i][j];
        }
        self
    }
}

impl Sub for Taylor {
    type Output = Self;
    fn sub(mut self, rhs: Self) -> Self {
        for (i, j) in pairs() {
            self.0[i][j] = self.0[i][j] - rhs.0[i][j];
        }
        self
    }
}

impl Mul for Taylor {
    type Output = Self;
    fn mul(self, rhs: Self) -> Self {
        let mut product = ZERO;
        for (i, j) in pairs() {
            // A coordinate or a number has few terms: 0 times anything finite adds nothing.
            if self.0[i][j] == Interval::ZERO {
                continue;
            }
            for k in 0..=DEGREE - i - j {
                for l in 0..=DEGREE - i - j - k {
                    if rhs.0[k][l] != Interval::ZERO {
                        let term = self.0[i][j] * rhs.0[k][l];
                        let sum = &mut product.0[i + k][j + l];
                        *sum = if *sum == Interval::ZERO { term } else { *sum + term };
                    }
                }
            }
        }
        product
    }
}

impl Div for Taylor {
    type Output = Self;
    fn div(self, rhs: Self) -> Self {
        let mut quotient = ZERO;
        for (i, j) in pairs() {
            let mut rest = self.0[i][j];
            for k in 0..=i {
                for l in 0..=j {
                    if (k, l) != (i, j) && rhs.0[i - k][j - l] != Interval::ZERO {
                        rest = rest - quotient.0[k][l] * rhs.0[i - k][j - l];
                    }
                }
            }
            quotient.0[i][j] = if rest == Interval::ZERO { rest } else { rest / rhs.value() };
        }
        quotient
    }
}

impl Field for Taylor {
    fn int(value: i64) -> Self {
        Self::constant(Interval::int(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x e⁻ˣ/(1 + y²), with a maximum at (1, 0).
    fn hill<T: Field>([x, y]: [T; 2], exp: impl Fn(T) -> T) -> T {
        x.clone() * exp(T::int(0) - x) / (T::int(1) + y.clone() * y)
    }

    #[test]
    fn ranges_contain_the_values_and_their_excess_shrinks_with_the_square() {
        let mut last = f64::INFINITY;
        for half in [0.25, 0.125, 0.0625] {
            let cell = [Interval::new(1.25 - half, 1.25 + half), Interval::new(0.25 - half, 0.25 + half)];
            let middle = Taylor::variables([1.25, 0.25].map(Interval::from));
            let over = hill(Taylor::variables(cell), Taylor::exp);
            let range = Taylor::range(&hill(middle, Taylor::exp), &over, [Interval::new(-half, half); 2]);
            let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
            for i in 0..=20 {
                for j in 0..=20 {
                    let at = |side: Interval, k: i32| side.lo() + 2.0 * half * f64::from(k) / 20.0;
                    let value = hill([at(cell[0], i), at(cell[1], j)].map(Interval::from), Interval::exp);
                    assert!(range.encloses(value), "{i} {j}: {range:?} {value:?}");
                    (lo, hi) = (lo.min(value.hi()), hi.max(value.lo()));
                }
            }
            // What is too much is products of offsets, bounded apart: a quarter, with boxes half as wide.
            let excess = (range.hi() - hi) + (lo - range.lo());
            assert!(excess < 0.35 * last && excess < half * half, "{half}: {excess:e}");
            last = excess;
        }
    }

    #[test]
    fn parabolas_are_bounded_at_their_vertex() {
        let c = [0.0, 1.0, -1.0, 0.0, 0.0, 0.0].map(Interval::from);
        let range = polynomial(&c, Interval::new(-1.0, 1.0)); // x - x²: -2 to 1/4
        assert!(range.contains(0.25) && range.hi() < 0.2501 && range.contains(-2.0) && range.lo() > -2.001);
    }

    /// 1/(1 - x - y) has the coefficients (i + j)!/(i! j!), e^(x + 2y) those of both exponentials, 2ʲ/(i! j!).
    #[test]
    fn series_have_their_coefficients() {
        let factorial = |k: usize| (1..=k).map(|i| i as f64).product::<f64>();
        let [x, y] = Taylor::variables([Interval::ZERO; 2]);
        let one = Taylor::int(1);
        let quotient = one / (one - x - y);
        let exponential = (x + y + y).exp();
        // A quotient undone: (2 + x y - y)/(…) times what it was divided by.
        let top = Taylor::int(2) + x * y - y;
        let bottom = Taylor::int(4) + x - y * y * Taylor::int(3);
        let back = top / bottom * bottom;
        let near = |found: Interval, exact: f64| {
            (found.mid() - exact).abs() < 1e-13 * exact.abs().max(1.0) && found.width() < 1e-12
        };
        for (i, j) in pairs() {
            let binomial = factorial(i + j) / (factorial(i) * factorial(j));
            assert!(near(quotient.0[i][j], binomial), "{i} {j}: {:?}", quotient.0[i][j]);
            let exact = libm::pow(2.0, j as f64) / (factorial(i) * factorial(j));
            assert!(near(exponential.0[i][j], exact), "{i} {j}: {:?}", exponential.0[i][j]);
            assert!(near(back.0[i][j], top.0[i][j].mid()), "{i} {j}: {:?}", back.0[i][j]);
        }
        assert_eq!(pairs().count(), 21);
        // Around (0.5, -1): x y² and its slopes y², 2 x y.
        let [x, y] = Taylor::variables([0.5, -1.0].map(Interval::from));
        let product = x * y * y;
        assert!(
            near(product.value(), 0.5) && near(product.slopes()[0], 1.0) && near(product.slopes()[1], -1.0)
        );
        assert!(near(product.0[0][2], 0.5) && near(product.0[1][2], 1.0) && near(product.0[1][1], -2.0));
        // sin by its derivatives at f: sin, cos, -sin, … over k!.
        let (sin, cos) = (libm::sin(0.5), libm::cos(0.5));
        let outer = |k: usize| Interval::from([sin, cos, -sin, -cos, sin, cos][k] / factorial(k));
        let composed = x.composed(outer);
        assert!((0..=DEGREE).all(|k| near(composed.0[k][0], outer(k).mid())));
    }

    /// b x + a x² on [0, r]: 0, the end, or the vertex -b²/(4a) where it lies inside.
    #[test]
    fn parabolas_are_bounded_by_the_larger_of_end_and_vertex() {
        for (b, a, r, exact) in [
            (1.0, 0.0, 2.0, 2.0),
            (1.0, 0.5, 2.0, 4.0),
            (-1.0, 0.25, 2.0, 0.0),
            (-1.0, 1.0, 2.0, 2.0),
            (1.0, -1.0, 2.0, 0.25),
            (3.0, -1.0, 2.0, 2.25),
            (3.0, -1.0, 1.0, 2.0),
            (3.0, -0.25, 1.0, 2.75),
            (-3.0, -1.0, 1.0, 0.0),
            (1.0, 1.0, 0.0, 0.0),
            (1.0, 1.0, -1.0, 0.0),
            (0.0, 0.0, 1.0, 0.0),
        ] {
            let found = upper_parabola(b, a, r);
            assert!(found >= exact && found <= exact + 1e-14, "{b} {a} {r}: {found} {exact}");
        }
        assert_eq!(upper_parabola(f64::INFINITY, 1.0, 1.0), f64::INFINITY);
    }

    /// Up to the square together, each higher term by itself: x³, x⁴ and x⁵ over [-½, ½] and one side.
    #[test]
    fn polynomials_are_bounded_term_by_term() {
        let of = |c: [f64; 6], lo: f64, hi: f64| polynomial(&c.map(Interval::from), Interval::new(lo, hi));
        for (c, lo, hi, least, most) in [
            ([2.0, 0.0, 0.0, 1.0, 0.0, 0.0], -0.5, 0.5, 1.875, 2.125),
            ([2.0, 0.0, 0.0, 1.0, 0.0, 0.0], 0.0, 0.5, 2.0, 2.125),
            // x · x³ and (x · x) · x³ by intervals.
            ([0.0, 0.0, 0.0, 0.0, 1.0, 0.0], -0.5, 0.5, -0.0625, 0.0625),
            ([0.0, 0.0, 0.0, 0.0, 0.0, 1.0], -0.5, 0.5, -0.03125, 0.03125),
            ([0.0, 0.0, 0.0, 4.0, 2.0, 1.0], 0.0, 0.5, 0.0, 0.65625),
            ([1.0, 3.0, 0.0, 0.0, 0.0, 0.0], -0.5, 0.25, -0.5, 1.75),
            ([0.0, 0.0, 3.0, 0.0, 0.0, 0.0], -0.5, 0.25, 0.0, 0.75),
            ([0.0, 0.0, -3.0, 0.0, 0.0, 0.0], -0.5, 0.25, -0.75, 0.0),
            ([0.0, 1.0, 1.0, 0.0, 0.0, 0.0], -1.0, 0.5, -0.25, 0.75),
            ([0.0, -1.0, 1.0, 0.0, 0.0, 0.0], -0.5, 1.0, -0.25, 0.75),
            ([0.0, -1.0, -1.0, 0.0, 0.0, 0.0], -1.0, 0.5, -0.75, 0.25),
        ] {
            let found = of(c, lo, hi);
            assert!(found.lo() <= least && found.lo() > least - 1e-14, "{c:?}: {found:?}");
            assert!(found.hi() >= most && found.hi() < most + 1e-14, "{c:?}: {found:?}");
        }
        // Enclosed coefficients count at their worse ends.
        let mut c = [Interval::ZERO; 6];
        (c[1], c[2]) = (Interval::new(-1.0, 2.0), Interval::new(-3.0, 1.0));
        let found = polynomial(&c, Interval::new(-0.5, 0.25));
        // At -½: 1/2 + 1/4 and -1 - 3/4; at ¼: 1/2 + 1/16.
        assert!((found.hi() - 0.75).abs() < 1e-14 && (found.lo() + 1.75).abs() < 1e-14, "{found:?}");
    }

    /// Below the last degree the coefficients at the middle count, of it those of the box.
    #[test]
    fn ranges_take_the_last_degree_from_the_box() {
        let mut middle = Taylor::constant(Interval::from(1.0));
        let mut over = Taylor::constant(Interval::new(-100.0, 100.0));
        middle.0[1][0] = Interval::from(2.0);
        over.0[1][0] = Interval::from(50.0);
        (middle.0[2][3], over.0[2][3]) = (Interval::from(70.0), Interval::from(8.0));
        let side = Interval::new(-0.5, 0.5);
        // 1 + 2 x ± 8 x² y³, x² from 0: 1 - 1 - 1/4 and 1 + 1 + 1/4.
        let found = Taylor::range(&middle, &over, [side, side]);
        assert!((found.lo() + 0.25).abs() < 1e-13 && (found.hi() - 2.25).abs() < 1e-13, "{found:?}");
        over.0[0][0] = Interval::new(0.0, 1.5);
        assert_eq!(Taylor::range(&middle, &over, [side, side]), Interval::new(0.0, 1.5));
    }
}
