//! The residual 2π coef(n) Int(n) - 1 of a factor, bounded over every integer and over every
//! real n of a range.

use super::compiled::Compiled;
use super::difference::reciprocal;
use super::level::vanishes_nowhere;
use super::{Formula, Interval, enclose, exact};
use crate::integral::{Case, Edge, Field, ScaledIntegral};
use dashu_ratio::RBig;

/// An extreme value with the argument it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// Encloses the extreme value.
    pub value: Interval,
    /// Where: for integers the smallest n at which the enclosures allow it, for reals a point at
    /// which the value is within the enclosure's width.
    pub n: f64,
}

/// Both extremes of a residual.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// The largest, signed.
    pub max: Extreme,
    /// The smallest, signed.
    pub min: Extreme,
}

impl Extremes {
    /// The larger of |max| and |min|.
    pub fn magnitude(&self) -> Extreme {
        let (max, min) = (self.max.value.abs(), self.min.value.abs());
        let n = if max.lo() >= min.lo() { self.max.n } else { self.min.n };
        Extreme { value: max.max(min), n }
    }

    /// The extremes of enclosed values by their n, ascending; `None` of none.
    ///
    /// Each n is the smallest whose enclosure reaches the extreme's.
    pub(super) fn of(values: &[(f64, Interval)]) -> Option<Self> {
        let (_, first) = values.first()?;
        let (max, min) =
            values.iter().fold((*first, *first), |(max, min), (_, v)| (max.max(*v), min.least(*v)));
        let n_where = |reaches: &dyn Fn(&Interval) -> bool| {
            values.iter().find(|(_, v)| reaches(v)).map_or(f64::NAN, |(n, _)| *n)
        };
        Some(Extremes {
            max: Extreme { value: max, n: n_where(&|v| v.hi() >= max.lo()) },
            min: Extreme { value: min, n: n_where(&|v| v.lo() <= min.hi()) },
        })
    }
}

/// The highest power of ½ that is worked out exactly.
pub(super) const MOST_HALVINGS: f64 = 4096.0;

/// A factor held against one integral.
///
/// ```
/// use bellfit::{bound::{Formula, Residual}, integral::{Case, Limit, Lobe}, kernel::model::Model};
/// let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
/// let printed: Formula = "1.063*n/(2*pi)".parse()?;
/// let reals = Residual::new(case, &printed).over_reals(16.0, 1024.0);
/// // 1.063/1.0625 - 1 = 8/17000 for every n
/// assert!(reals.max.value.contains(8.0 / 17000.0) && reals.max.value.width() < 1e-12);
/// # Ok::<(), bellfit::bound::FormulaError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Residual<I = Case> {
    integral: I,
    /// 2π coef(n), as it is written.
    pub(super) written: Formula,
    /// The residual as one quotient with the n from which on it is that, where the integral is rational.
    pub(super) formula: Option<(f64, Formula)>,
    /// 2π coef(n).
    factor: Compiled<Interval>,
    quotient: Option<Quotient>,
}

/// The residual itself as one quotient with exact coefficients, for n ≥ `from`.
#[derive(Clone, Debug)]
struct Quotient {
    from: f64,
    intervals: Compiled<Interval>,
    /// Where the formula has no π left.
    rationals: Option<Compiled<RBig>>,
}

/// Whether 2π coef(n) Int(n) = 1 identically for n ≥ 16, decided in polynomials; only for integrals
/// that are rational in n and 2^(-n/2): cosⁿ, and cs_16 up to its zero in its own angle.
///
/// An enclosure of a residual that is 0 is never 0 itself; this is.
pub fn normalises_exactly(case: Case, factor: &Formula) -> bool {
    residual_formula(&case, factor).is_some_and(|(from, r)| from <= 16.0 && r.numerator.is_zero())
}

/// 2π coef(n) Int(n) - 1 with the n from which on it is that, where the integral is rational.
fn residual_formula(integral: &impl ScaledIntegral, factor: &Formula) -> Option<(f64, Formula)> {
    let m = Formula::int(1) / Formula::n();
    let (from, scaled) = integral.rational(&m, &Formula::h())?;
    let product = factor.times_two_pi() * scaled * m;
    Some((from, product - Formula::int(1))).filter(|(_, r)| !r.denominator.is_zero())
}

impl<I: ScaledIntegral> Residual<I> {
    /// The residual of `factor` for `integral`.
    pub fn new(integral: I, factor: &Formula) -> Self {
        let formula = residual_formula(&integral, factor);
        let quotient = formula.as_ref().map(|(from, r)| Quotient {
            from: *from,
            intervals: Compiled::in_intervals(r),
            rationals: Compiled::in_rationals(r),
        });
        let written = factor.times_two_pi();
        Residual { integral, factor: Compiled::in_intervals(&written), written, formula, quotient }
    }

    /// Whether the residual is 0 at every n of [from, to]; at a pole of the factor it is nothing, whatever
    /// cancels.
    pub(super) fn is_exact(&self, from: f64, to: f64) -> bool {
        let vanishes =
            self.formula.as_ref().is_some_and(|(first, r)| from >= *first && r.numerator.is_zero());
        vanishes && vanishes_nowhere(&self.written.denominator, from, to)
    }

    /// The residual at one n.
    pub fn at(&self, n: f64) -> Interval {
        if self.is_exact(n, n) {
            return Interval::from(0.0);
        }
        let m = reciprocal(Interval::from(n));
        self.of_m(n, &m, |c| *c)
    }

    /// The residual as a function of m = 1/n, for n ≥ `from`, over an arithmetic that intervals can be
    /// lifted into.
    pub(super) fn of_m<T: Edge>(&self, from: f64, m: &T, lift: impl Fn(&Interval) -> T) -> T {
        self.factor.at(m, 1, lift, || m.half_power()) * self.integral.scaled_from(from, m) - T::int(1)
    }

    /// The same as one quotient, where it is one for every n ≥ `from`: what a good factor cancels is then
    /// cancelled in its coefficients, so that a small residual costs no more boxes than a large one.
    pub(super) fn cancelled<T: Edge>(&self, from: f64, m: &T, lift: impl Fn(&Interval) -> T) -> T {
        match &self.quotient {
            Some(q) if from >= q.from => q.intervals.at(m, 0, lift, || m.half_power()),
            _ => self.of_m(from, m, lift),
        }
    }

    /// The same at one m in exact arithmetic: at m = 0, at even n, and
    /// at any where there is no 2^(-n/2), so that a residual of 0 at an end
    /// of a range is known to be 0.
    pub(super) fn in_rationals(&self, m: f64) -> Option<Interval> {
        let quotient = self.quotient.as_ref()?;
        let compiled = quotient.rationals.as_ref()?;
        let h = if m == 0.0 || !compiled.has_power_of_two {
            RBig::int(0)
        } else {
            let half_n = 0.5 / m;
            let is_even = 0.5 / half_n == m && half_n == libm::floor(half_n) && half_n <= MOST_HALVINGS;
            is_even.then(|| RBig::int(1) / RBig::int(2).power(half_n as u32))?
        };
        if m * quotient.from > 1.0 || compiled.numerator_degree > compiled.denominator_degree {
            return None;
        }
        let m = exact(m)?;
        // At a pole there is no residual.
        (!compiled.denominator_at(&m, &h).is_zero())
            .then(|| enclose(&compiled.at(&m, 0, RBig::clone, || h.clone())))
    }

    /// The extremes over the integers from..=to.
    ///
    /// # Panics
    /// If the range is empty.
    pub fn over_integers(&self, from: u32, to: u32) -> Extremes {
        let values: Vec<(f64, Interval)> = (from..=to).map(f64::from).map(|n| (n, self.at(n))).collect();
        Extremes::of(&values).expect("a range with an integer in it")
    }
}

#[cfg(test)]
mod tests;
