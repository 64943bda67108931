//! The extremes of a residual over a range that may have no end, to six digits of their own size, with
//! the sign of the largest decided.

use super::difference::reciprocal;
use super::{Curve, Extreme, Extremes, Interval, Residual, curved_range, supremum_until};
use crate::integral::{Field, ScaledIntegral};
use dashu_ratio::RBig;

/// Boxes after which a search settles for what it has.
const MOST_BOXES: usize = 20_000;
/// The relative width asked of an enclosure.
const DIGITS: f64 = 1e-6;
/// The relative width of a box that is a place.
const NEAR: f64 = 1e-9;
/// Where the size and the rounding of a residual are looked at: from·2^k, k below this.
const LOOKS: i32 = 12;

/// The largest or the smallest.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Largest,
    Smallest,
}

impl<I: ScaledIntegral> Residual<I> {
    /// Both extremes over every real n in [from, to], `to` up to ∞: [`Residual::largest`] and
    /// [`Residual::smallest`].
    pub fn over_reals(&self, from: f64, to: f64) -> Extremes {
        Extremes { max: self.largest(from, to), min: self.smallest(from, to) }
    }

    /// The same where an end of the range is a number that is no double: known to lie between these. What is
    /// reached is reached inside the range.
    ///
    /// ```
    /// use bellfit::{bound::{Interval, Residual}, integral::{Case, Limit, Lobe}, kernel::model::Model};
    /// let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
    /// // 16/(n + 1) - 1 is 0 at n = 15: from a little later on it is not reached.
    /// let residual = Residual::new(case, &"16/(2*pi)".parse()?);
    /// let found = residual.over_enclosed(Interval::new(15.0, 15.0_f64.next_up()), Interval::from(64.0));
    /// assert!(found.max.value.lo() < 0.0 && found.max.value.hi() == 0.0);
    /// # Ok::<(), bellfit::bound::FormulaError>(())
    /// ```
    pub fn over_enclosed(&self, from: Interval, to: Interval) -> Extremes {
        let ends = (from, to);
        Extremes { max: self.one_extreme(ends, Side::Largest), min: self.one_extreme(ends, Side::Smallest) }
    }

    /// Encloses the largest residual over every real n in [from, to], `to` up to ∞.
    ///
    /// Branch and bound in m = 1/n with first and second derivatives, to six digits of the residual's size or
    /// to its rounding, whichever is coarser; and on until the sign is known, or rounding hides it, which
    /// [`Residual::stays_at_most`] may decide then. So
    /// `value.hi() <= 0` certifies that the factor never gains energy, and `value.lo() > 0`, reached at
    /// `n`, refutes it.
    ///
    /// ```
    /// use bellfit::{bound::{Formula, Residual}, integral::{Case, Limit, Lobe}, kernel::model::Model};
    /// let case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
    /// // Int = (16/17n)(1 - 8/(9n)): with 17/16 n the residual is -8/(9n), and reaches 0 at n = ∞ only.
    /// let factor: Formula = "1.0625*n/(2*pi)".parse()?;
    /// let residual = Residual::new(case, &factor);
    /// let largest = residual.largest(16.0, f64::INFINITY);
    /// assert_eq!((largest.value.hi(), largest.n), (0.0, f64::INFINITY));
    /// assert!(residual.smallest(16.0, f64::INFINITY).value.contains(-1.0 / 18.0));
    /// # Ok::<(), bellfit::bound::FormulaError>(())
    /// ```
    pub fn largest(&self, from: f64, to: f64) -> Extreme {
        self.one_extreme((from.into(), to.into()), Side::Largest)
    }

    /// Encloses the smallest residual, the same way.
    pub fn smallest(&self, from: f64, to: f64) -> Extreme {
        self.one_extreme((from.into(), to.into()), Side::Smallest)
    }

    /// Where no box is bounded, however small: an n in [from, to] near a pole, or one at which numbers leave the
    /// doubles.
    pub fn unbounded_near(&self, from: f64, to: f64) -> Option<f64> {
        let over = |m: Interval| {
            let curve = |m: Curve| self.cancelled(from, &m, |c| Curve::constant(*c));
            curved_range(curve, |m| self.cancelled(from, &Interval::from(m), |c| *c), m)
        };
        let is_open = |m: &Interval| !over(*m).width().is_finite();
        let mut open = Some(reciprocal(Interval::new(from, to))).filter(is_open)?;
        // A pole of a few doubles' width; nearer no n tells more.
        while open.width() > NEAR * open.hi() {
            let (less, more) = open.bisect();
            // Of two the one of smaller n.
            open = [more, less].into_iter().find(is_open)?;
        }
        Some((1.0 / open.mid()).clamp(from, to))
    }

    fn one_extreme(&self, (first, last): (Interval, Interval), side: Side) -> Extreme {
        let ((from, to), inside) = ((first.lo(), last.hi()), (first.hi(), last.lo()));
        if self.is_exact(from, to) {
            return Extreme { value: Interval::ZERO, n: inside.0 };
        }
        let domain = reciprocal(Interval::new(from, to));
        // A residual that is 0 at an end must not be told as 0 and rounding.
        let ends = [domain.lo(), domain.hi()].map(|end| (Interval::from(end), self.in_rationals(end)));
        let over = |m: Interval| {
            let exact = ends.iter().find(|(end, _)| *end == m).and_then(|(_, exact)| *exact);
            exact.unwrap_or_else(|| self.cancelled(from, &m, |c| *c))
        };
        let at = |n: f64| over(reciprocal(n.into()));
        let looks = (0..LOOKS).map(|k| libm::scalbn(from, k)).take_while(|&n| n < to).chain([to]);
        // What overflows says nothing of the others.
        let finite = looks.map(at).filter(|v| v.width().is_finite());
        let (size, rounding) = finite.fold((0.0_f64, 0.0_f64), |(size, rounding), v| {
            (size.max(v.abs().hi()), rounding.max(v.width()))
        });
        // What a point's enclosure is wide no search can beat; a box's is somewhat wider.
        let finest = 3.0 * rounding;
        let tolerance = (DIGITS * size).max(finest);
        let enough = |best: f64, upper: f64| {
            let decided = side == Side::Smallest || upper <= 0.0 || best > 0.0;
            upper <= best + if decided { tolerance } else { finest }
        };
        let curve = |m: Curve| self.cancelled(from, &m, |c| Curve::constant(*c));
        let oriented = |[m]: &[Interval; 1]| {
            let found = curved_range(curve, |m| over(Interval::from(m)), *m);
            if side == Side::Largest { found } else { -found }
        };
        let found = supremum_until(oriented, [domain], enough, MOST_BOXES);
        // The domain is rounded outward: what is reached is taken at an n of the range, if doubles have one.
        let has_double = inside.0 <= inside.1;
        let n = if has_double { (1.0 / found.at[0]).clamp(inside.0, inside.1) } else { inside.0 };
        let reached = if has_double { at(n) } else { over(domain) };
        let value = if side == Side::Largest {
            let hidden = reached.lo() <= 0.0 && found.value.hi() > 0.0;
            let never = hidden && self.stays_at_most(&RBig::int(0), from, to);
            Interval::new(reached.lo(), if never { 0.0 } else { found.value.hi() })
        } else {
            Interval::new(-found.value.hi(), reached.hi())
        };
        // Ties within the enclosure go to the smallest n.
        let ties = |n: &f64| has_double && !at(*n).is_disjoint(value);
        Extreme { value, n: [inside.0, inside.1].into_iter().find(ties).unwrap_or(n) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::Formula;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    const MODIFIED: Case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };

    fn residual(case: Case, factor: &str) -> Residual {
        Residual::new(case, &factor.parse::<Formula>().unwrap())
    }

    /// (16/17)(17/16 + b m)(1 - 8m/9) - 1 has its top at m = 9/16 - 17/(32 b): inside 16..∞ for b above
    /// 17/18, and 0 at m = 0 always.
    #[test]
    fn touching_zero_is_told_from_crossing_it() {
        let below = residual(MODIFIED, "(1.0625*n + 0.94)/(2*pi)").largest(16.0, f64::INFINITY);
        assert_eq!((below.value.hi(), below.n), (0.0, f64::INFINITY));
        let above = residual(MODIFIED, "(1.0625*n + 0.9445)/(2*pi)").largest(16.0, f64::INFINITY);
        assert!(above.value.lo() > 0.0 && above.value.hi() < 1e-8, "{above:?}");
        // (17/16 n - 0.008 n + 0.128) is exact at n = 16 and falls short everywhere else.
        let phong = Case { model: Model::Phong, ..MODIFIED };
        let touches = residual(phong, "(1.0545*n + 0.128)/(2*pi)").largest(16.0, 1024.0);
        assert_eq!((touches.value, touches.n), (Interval::from(0.0), 16.0));
        assert!(residual(phong, "(1.0545*n + 0.12800001)/(2*pi)").largest(16.0, 1024.0).value.lo() > 0.0);
    }

    /// Six digits of a residual far below 1e-9, which the wider search would not resolve.
    #[test]
    fn small_residuals_keep_their_digits() {
        let phong = Case { model: Model::Phong, ..MODIFIED };
        let found = residual(phong, "(1.0625*n + 0.0000000016)/(2*pi)").over_reals(16.0, f64::INFINITY);
        // (16/17) 1.6e-9 m
        let largest = 16.0 / 17.0 * 1e-10;
        assert!((found.max.value.mid() / largest - 1.0).abs() < 1e-4 && found.max.n == 16.0, "{found:?}");
        assert!(found.min.value.contains(0.0) && found.min.value.width() < 1e-13, "{found:?}");
        assert_eq!(found.min.n, f64::INFINITY);
    }

    #[test]
    fn every_case_has_a_limit_at_infinity() {
        for case in Case::all() {
            let residual = residual(case, "(1.1*n + 3)/(2*pi)");
            let found = residual.over_reals(1.0, f64::INFINITY);
            for n in [1.0, 3.5, 16.0, 1e3, 1e9, 1e200, f64::INFINITY] {
                let at = if n == f64::INFINITY { continue } else { residual.at(n) };
                assert!(at.lo() <= found.max.value.hi() && at.hi() >= found.min.value.lo(), "{case}, {n}");
            }
            let widest = 2e-6 * found.magnitude().value.hi();
            assert!(
                found.max.value.width() < widest && found.min.value.width() < widest,
                "{case}: {found:?}"
            );
        }
    }
}
