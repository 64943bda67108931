//! Whether a residual stays on one side of a level: by exact numbers where it touches the level, which no
//! enclosure of a rounded number decides.

use super::compiled::Compiled;
use super::difference::reciprocal;
use super::residual::MOST_HALVINGS;
use super::{Curve, Formula, Interval, Polynomial, Residual, curved_range, enclose, exact, supremum_until};
use crate::integral::{Edge, Field, ScaledIntegral};
use dashu_ratio::RBig;

/// Boxes after which a sign is left open.
const MOST_BOXES: usize = 4000;

impl<I: ScaledIntegral> Residual<I> {
    /// Whether the residual is proved to be at most `level` at every real n in [from, to], `to` up to ∞.
    ///
    /// Only where the integral is rational in n and 2^(-n/2) ([`ScaledIntegral::rational`]). The residual less the
    /// level is one quotient with exact coefficients; what it has of powers of 1/n and 2^(-n/2) as factors is
    /// positive and left out; the sign of the rest is searched in from/n and to/n, in which the ends of the range
    /// are 1 and ∞ is 0, so that a level that is met there is met by exact numbers. `false` if that proves nothing.
    ///
    /// ```
    /// use bellfit::bound::{Residual, decimal};
    /// use bellfit::{integral::{Case, Limit, Lobe}, kernel::model::Model};
    /// let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
    /// // n/(n + 1) - 1: 0 at n = ∞, -1/10 at n = 9.
    /// let residual = Residual::new(case, &"n/(2*pi)".parse()?);
    /// let [zero, tenth] = ["0", "-0.1"].map(|text| decimal(text).expect("a decimal").0);
    /// assert!(residual.stays_at_most(&zero, 1.0, f64::INFINITY));
    /// assert!(residual.stays_at_least(&tenth, 9.0, f64::INFINITY));
    /// assert!(!residual.stays_at_least(&tenth, 8.999, f64::INFINITY));
    /// assert_eq!(residual.exactly(9.0), Some(tenth));
    /// # Ok::<(), bellfit::bound::FormulaError>(())
    /// ```
    pub fn stays_at_most(&self, level: &RBig, from: f64, to: f64) -> bool {
        self.excess(level, from).is_some_and(|excess| is_not_positive(&excess, (from, to), Sign::OrZero))
    }

    /// Whether the residual is proved to be at least `level` at every real n in [from, to], the same way.
    pub fn stays_at_least(&self, level: &RBig, from: f64, to: f64) -> bool {
        let excess = self.excess(level, from);
        excess.is_some_and(|excess| is_not_positive(&negated(excess), (from, to), Sign::OrZero))
    }

    /// Whether coef(n) is proved to be positive at every real n in [from, to], `to` up to ∞, whatever it tends
    /// to.
    ///
    /// ```
    /// use bellfit::{bound::Residual, integral::{Case, Limit, Lobe}, kernel::model::Model};
    /// let case = Case { model: Model::Phong, lobe: Lobe::CosN, limit: Limit::Support };
    /// // Nothing of 1/n is left at n = ∞, and yet it is positive.
    /// assert!(Residual::new(case, &"1/(2*pi*n)".parse()?).has_positive_factor(1.0, f64::INFINITY));
    /// assert!(!Residual::new(case, &"(n - 2)/(2*pi)".parse()?).has_positive_factor(2.0, 16.0));
    /// # Ok::<(), bellfit::bound::FormulaError>(())
    /// ```
    pub fn has_positive_factor(&self, from: f64, to: f64) -> bool {
        is_not_positive(&negated(self.written.clone()), (from, to), Sign::Strict)
    }

    /// Whether coef(n) is 0 at every n.
    pub fn has_no_factor(&self) -> bool {
        self.written.numerator.is_zero()
    }

    /// The residual at n exactly, or its limit at n = ∞: where it is rational, which with 2^(-n/2) in it is at even
    /// whole n up to 8192.
    pub fn exactly(&self, n: f64) -> Option<RBig> {
        let (_, r) = self.formula.as_ref().filter(|(from, _)| n >= *from)?;
        let compiled = Compiled::in_rationals(r)?;
        let m = if n == f64::INFINITY { RBig::int(0) } else { RBig::int(1) / exact(n)? };
        let h = if compiled.has_power_of_two { half_power(n)? } else { RBig::int(0) };
        let has_limit = compiled.numerator_degree <= compiled.denominator_degree;
        if (m.is_zero() && !has_limit) || compiled.denominator_at(&m, &h).is_zero() {
            return None;
        }
        Some(compiled.at(&m, 0, RBig::clone, || h.clone()))
    }

    /// The residual less a level, as one quotient.
    fn excess(&self, level: &RBig, from: f64) -> Option<Formula> {
        let (_, Formula { numerator, denominator }) =
            self.formula.as_ref().filter(|(first, _)| from >= *first)?;
        let numerator = numerator.minus(&denominator.scaled(level));
        Some(Formula { numerator, denominator: denominator.clone() })
    }
}

/// What is asked of a sign.
#[derive(Clone, Copy, PartialEq)]
enum Sign {
    OrZero,
    Strict,
}

fn negated(Formula { numerator, denominator }: Formula) -> Formula {
    Formula { numerator: numerator.scaled(&RBig::int(-1)), denominator }
}

/// Whether a polynomial is proved to be 0 nowhere in [from, to].
pub(super) fn vanishes_nowhere(p: &Polynomial, from: f64, to: f64) -> bool {
    let over = |p: Polynomial| Formula { numerator: p, denominator: Polynomial::constant(RBig::int(1)) };
    let range = (from, to);
    is_not_positive(&negated(over(p.clone())), range, Sign::Strict)
        || is_not_positive(&over(p.clone()), range, Sign::Strict)
}

/// Whether a quotient is proved to be negative, or 0, at every finite n of [from, to].
fn is_not_positive(quotient: &Formula, (from, to): (f64, f64), sign: Sign) -> bool {
    let Formula { numerator, denominator } = quotient;
    if numerator.is_zero() {
        return sign == Sign::OrZero && vanishes_nowhere(denominator, from, to);
    }
    let (numerator, denominator) = (without_h(numerator), without_h(denominator));
    // Powers of n are positive: as many above as below leave a limit at n = ∞.
    let missing = |p: &Polynomial, q: &Polynomial| {
        let power = q.degree(0).saturating_sub(p.degree(0));
        p.times(&Polynomial::monomial([power, 0, 0], RBig::int(1)))
    };
    let (numerator, denominator) = (missing(&numerator, &denominator), missing(&denominator, &numerator));
    let quotient = Formula { numerator, denominator };
    let keeps = |end: f64, domain: Interval| {
        Anchored::new(&quotient, end).is_some_and(|anchored| anchored.is_not_positive(domain, sign))
    };
    if to == f64::INFINITY {
        return keeps(from, Interval::new(0.0, 1.0));
    }
    let middle = (libm::sqrt(from) * libm::sqrt(to)).clamp(from, to);
    let (first, last) = ((from / middle).next_down().min(1.0), (to / middle).next_up().max(1.0));
    keeps(from, if from == to { Interval::from(1.0) } else { Interval::new(first, 1.0) })
        && (from == to || keeps(to, Interval::new(1.0, last)))
}

/// A polynomial without the power of h that all its terms share.
fn without_h(p: &Polynomial) -> Polynomial {
    let shared = p.terms().map(|(e, _)| e[1]).min().unwrap_or(0);
    mapped(p, |[n, h, pi], c| Polynomial::monomial([n, h - shared, pi], c.clone()))
}

fn mapped(p: &Polynomial, term: impl Fn([u32; 3], &RBig) -> Polynomial) -> Polynomial {
    p.terms().fold(Polynomial::constant(RBig::int(0)), |sum, (e, c)| sum.plus(&term(*e, c)))
}

/// 2^(-n/2), where it is rational and not too long.
fn half_power(n: f64) -> Option<RBig> {
    if n == f64::INFINITY {
        return Some(RBig::int(0));
    }
    let half = 0.5 * n;
    let is_even = half == libm::floor(half) && half <= MOST_HALVINGS;
    is_even.then(|| RBig::int(1) / RBig::int(2).power(half as u32))
}

/// A quotient as a function of x = end/n: at x = 1 and x = 0 its value is exact.
struct Anchored {
    compiled: Compiled<Interval>,
    /// 1/end.
    reciprocal: Interval,
    at_end: Option<Interval>,
    at_infinity: Option<Interval>,
}

impl Anchored {
    fn new(quotient: &Formula, end: f64) -> Option<Self> {
        let scale = exact(end)?;
        // n = end/x: what Compiled takes for m is x, if the coefficient of n^i is multiplied by end^i.
        let anchored = |p: &Polynomial| {
            let degree = p.degree(0);
            mapped(p, |e, c| Polynomial::monomial(e, c.clone() / scale.power(degree - e[0])))
        };
        let quotient = Formula {
            numerator: anchored(&quotient.numerator),
            denominator: anchored(&quotient.denominator),
        };
        let rationals = Compiled::in_rationals(&quotient);
        let exactly = |x: i64, n: f64| {
            let compiled = rationals.as_ref()?;
            let h = if compiled.has_power_of_two { half_power(n)? } else { RBig::int(0) };
            let x = RBig::int(x);
            let is_pole = compiled.denominator_at(&x, &h).is_zero();
            (!is_pole).then(|| enclose(&compiled.at(&x, 0, RBig::clone, || h.clone())))
        };
        Some(Anchored {
            at_end: exactly(1, end),
            at_infinity: exactly(0, f64::INFINITY),
            compiled: Compiled::in_intervals(&quotient),
            reciprocal: reciprocal(Interval::from(end)),
        })
    }

    /// Whether it is at most 0, or below, everywhere in the domain.
    fn is_not_positive(&self, domain: Interval, sign: Sign) -> bool {
        let m = |x: Interval| {
            let m = x * self.reciprocal;
            Interval::new(m.lo().max(0.0), m.hi())
        };
        let at = |x: f64| {
            let known = if x == 1.0 {
                self.at_end
            } else if x == 0.0 {
                self.at_infinity
            } else {
                None
            };
            let x = Interval::from(x);
            known.unwrap_or_else(|| self.compiled.at(&x, 0, |c| *c, || m(x).half_power()))
        };
        let curve = |x: Curve| {
            let n = Curve { value: m(x.value), ..x * Curve::constant(self.reciprocal) };
            self.compiled.at(&x, 0, |c| Curve::constant(*c), || n.half_power())
        };
        let holds = |upper: f64| upper < 0.0 || (sign == Sign::OrZero && upper <= 0.0);
        let fails = |lower: f64| lower > 0.0 || (sign == Sign::Strict && lower >= 0.0);
        let range = |[x]: &[Interval; 1]| curved_range(curve, at, *x);
        let found = supremum_until(range, [domain], |best, upper| holds(upper) || fails(best), MOST_BOXES);
        holds(found.value.hi())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::decimal;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    fn cosine(model: Model, factor: &str) -> Residual {
        let case = Case { model, lobe: Lobe::CosN, limit: Limit::Support };
        Residual::new(case, &factor.parse().unwrap())
    }

    /// Int of cosⁿ is 4 (n + h)/((n + 2)(n + 4)) for Blinn-Phong (modified) and 1/(n + 1) for Phong: what is
    /// proved of lines holds at every n looked at, and of those that hold all but a few are proved.
    #[test]
    fn what_is_proved_of_lines_holds() {
        let (mut proved, mut open) = (0, 0);
        for (slope, offset, level) in
            (0..2000_i32).map(|i| (960 + 2 * (i % 41), (i * 7) % 97, (i * 13) % 50 - 25))
        {
            let (a, b, level) = (f64::from(slope) / 1e3, f64::from(offset) / 1e1, f64::from(level) / 1e3);
            let blinn = slope % 4 == 0;
            let (model, d) = if blinn { (Model::BlinnPhongModified, 8) } else { (Model::Phong, 2) };
            let residual = |n: f64| {
                let h = libm::exp2(-0.5 * n);
                let int = if blinn { (n + h) / ((n + 2.0) * (n + 4.0)) } else { 1.0 / (n + 1.0) };
                (a * n + b) * int - 1.0
            };
            let exact = decimal(&format!("{level}")).unwrap().0;
            let of = cosine(model, &format!("({a}*n + {b})/({d}*pi)"));
            let (mut largest, mut n) = (f64::NEG_INFINITY, 3.0);
            while n < 1e7 {
                largest = f64::max(largest, residual(n));
                n *= 1.01;
            }
            largest = largest.max(a - 1.0);
            if of.stays_at_most(&exact, 3.0, f64::INFINITY) {
                assert!(largest <= level + 1e-12, "{a} {b} {level}: {largest}");
                proved += 1;
            } else {
                // Between two samples it may be higher by less than 1e-4 of itself.
                open += i32::from(largest < level - 1e-4);
            }
        }
        assert!(proved > 400 && open == 0, "{proved} proved, {open} open");
    }

    /// The same on the other side, and at both ends of a range: n/(n + 1) - 1 runs from -1/4 at 3 to -1/10 at 9.
    #[test]
    fn both_ends_are_met_exactly() {
        let residual = cosine(Model::Phong, "n/(2*pi)");
        let of = |text: &str| decimal(text).unwrap().0;
        assert!(
            residual.stays_at_least(&of("-0.25"), 3.0, 9.0) && residual.stays_at_most(&of("-0.1"), 3.0, 9.0)
        );
        assert!(!residual.stays_at_least(&of("-0.2499999999999999999999"), 3.0, 9.0));
        assert!(!residual.stays_at_most(&of("-0.1000000000000000000001"), 3.0, 9.0));
        assert!(
            residual.stays_at_most(&of("-0.25"), 3.0, 3.0) && !residual.stays_at_most(&of("-0.25"), 3.0, 9.0)
        );
    }

    #[test]
    fn no_limit_is_told_where_there_is_none() {
        assert_eq!(cosine(Model::Phong, "n^2/(2*pi)").exactly(f64::INFINITY), None);
        assert_eq!(cosine(Model::Phong, "n/(2*pi)").exactly(f64::INFINITY), Some(RBig::int(0)));
        assert_eq!(cosine(Model::Phong, "(n + 1)/((n - 4)*pi)").exactly(4.0), None);
        // 2^(-3/2) is not rational.
        assert_eq!(cosine(Model::BlinnPhong, "(n + 2)/(8*pi)").exactly(3.0), None);
        assert!(vanishes_nowhere(&Polynomial::n(), 1.0, f64::INFINITY));
        let minus = Polynomial::n().minus(&Polynomial::constant(RBig::int(20)));
        assert!(!vanishes_nowhere(&minus, 16.0, 30.0) && !vanishes_nowhere(&minus, 20.0, 20.0));
        assert!(vanishes_nowhere(&minus, 1.0, 19.999) && vanishes_nowhere(&minus, 20.001, 30.0));
    }
}
