//! The residual 2π coef(n) Int(n) - 1 of a factor, bounded over every integer and over every
//! real n of a range.

use super::difference::reciprocal;
use super::{Coefficient, Exponents, Formula, Interval, Polynomial, enclose, exact};
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
const MOST_HALVINGS: f64 = 4096.0;

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
    /// From which n on the residual is 0 identically, if it ever is.
    exact_from: Option<f64>,
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

/// A quotient of polynomials in n, 2^(-n/2) and π with its coefficients read into one arithmetic.
#[derive(Clone, Debug)]
struct Compiled<C> {
    numerator: Vec<(C, Exponents)>,
    numerator_degree: u32,
    denominator: Vec<(C, Exponents)>,
    denominator_degree: u32,
    has_power_of_two: bool,
    pi: C,
}

impl<C> Compiled<C> {
    fn new(factor: &Formula, compile: impl Fn(&Polynomial) -> Vec<(C, Exponents)>, pi: C) -> Self {
        let Formula { numerator, denominator } = factor;
        Compiled {
            numerator_degree: numerator.degree(0),
            denominator_degree: denominator.degree(0),
            has_power_of_two: numerator.degree(1) + denominator.degree(1) > 0,
            numerator: compile(numerator),
            denominator: compile(denominator),
            pi,
        }
    }

    /// The quotient times m^factors at m = 1/n: both polynomials times the power of m that clears their
    /// poles. h is asked for only where there is a power of 2.
    fn at<T: Field>(&self, m: &T, factors: u32, lift: impl Fn(&C) -> T, h: impl Fn() -> T) -> T {
        let h = if self.has_power_of_two { h() } else { T::int(0) };
        let sum = |terms: &[(C, Exponents)], degree: u32| {
            terms.iter().fold(T::int(0), |total, (c, e)| {
                let mut term = lift(c) * m.power(degree - e[0]);
                if e[1] > 0 {
                    term = term * h.power(e[1]);
                }
                if e[2] > 0 {
                    term = term * lift(&self.pi).power(e[2]);
                }
                total + term
            })
        };
        let quotient =
            sum(&self.numerator, self.numerator_degree) / sum(&self.denominator, self.denominator_degree);
        let (up, down) = (factors + self.denominator_degree, self.numerator_degree);
        if up >= down { quotient * m.power(up - down) } else { quotient / m.power(down - up) }
    }
}

impl Compiled<RBig> {
    /// What the quotient is divided by at m.
    fn denominator_at(&self, m: &RBig, h: &RBig) -> RBig {
        let terms = self.denominator.iter();
        terms.fold(RBig::int(0), |total, (c, e)| {
            total + c.clone() * m.power(self.denominator_degree - e[0]) * h.power(e[1])
        })
    }
}

impl Compiled<Interval> {
    fn in_intervals(factor: &Formula) -> Self {
        Compiled::new(factor, Polynomial::compile, Coefficient::pi())
    }
}

impl<I: ScaledIntegral> Residual<I> {
    /// The residual of `factor` for `integral`.
    pub fn new(integral: I, factor: &Formula) -> Self {
        let residual = residual_formula(&integral, factor);
        let exact_from = residual.as_ref().filter(|(_, r)| r.numerator.is_zero()).map(|(from, _)| *from);
        let exactly = |p: &Polynomial| p.terms().map(|(e, c)| (c.clone(), *e)).collect();
        let quotient = residual.map(|(from, r)| {
            let free_of_pi = r.numerator.degree(2) + r.denominator.degree(2) == 0;
            let rationals = free_of_pi.then(|| Compiled::new(&r, exactly, RBig::int(0)));
            Quotient { from, intervals: Compiled::in_intervals(&r), rationals }
        });
        let factor = Compiled::in_intervals(&factor.times_two_pi());
        Residual { integral, exact_from, factor, quotient }
    }

    pub(super) fn is_exact(&self, n: f64) -> bool {
        self.exact_from.is_some_and(|from| n >= from)
    }

    /// The residual at one n.
    pub fn at(&self, n: f64) -> Interval {
        if self.is_exact(n) {
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

    /// The same at one m in exact arithmetic: at m = 0 and at even n, so that a residual of 0 at an end
    /// of a range is known to be 0.
    pub(super) fn in_rationals(&self, m: f64) -> Option<Interval> {
        let quotient = self.quotient.as_ref()?;
        let compiled = quotient.rationals.as_ref()?;
        let h = if m == 0.0 {
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
