//! Which n a factor is asked about: the whole numbers of a range, or every real number of it.

use super::Reals;
use crate::bound::{Extremes, Interval, Residual, exact};
use crate::integral::ScaledIntegral;
use core::fmt;
use dashu_ratio::RBig;

/// A range of the specular exponent.
///
/// ```
/// use bellfit::fit::Exponents;
/// assert_eq!(Exponents::Integers(16, 1024).to_string(), "16..1024");
/// assert_eq!(Exponents::Reals("16..inf".parse()?).ends(), (16.0, f64::INFINITY));
/// # Ok::<(), bellfit::fit::FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exponents {
    /// Every whole number from the first to the second, 1 ≤ first ≤ second ≤ 65536.
    Integers(u32, u32),
    /// Every real number.
    Reals(Reals),
}

impl Exponents {
    /// First and last n, to the nearest double.
    pub fn ends(self) -> (f64, f64) {
        match self {
            Exponents::Integers(from, to) => (f64::from(from), f64::from(to)),
            Exponents::Reals(reals) => (reals.from(), reals.to()),
        }
    }

    /// What n ranges over, in a word.
    pub const fn over(self) -> &'static str {
        match self {
            Exponents::Integers(..) => "integers",
            Exponents::Reals(_) => "reals",
        }
    }

    /// The certified extremes of a residual over these n.
    pub fn extremes<I: ScaledIntegral>(self, residual: &Residual<I>) -> Extremes {
        match self {
            Exponents::Integers(from, to) => residual.over_integers(from, to),
            Exponents::Reals(reals) => {
                let (from, to) = reals.ends();
                residual.over_enclosed(from, to)
            }
        }
    }

    /// Whether the residual is proved to be at most `level` at every one of these n, by exact numbers where it
    /// touches the level: [`Residual::stays_at_most`].
    pub fn stay_at_most<I: ScaledIntegral>(self, residual: &Residual<I>, level: &RBig) -> bool {
        match self {
            Exponents::Integers(..) => self.each(residual, |value| exact(value.hi()), |x| x <= level),
            Exponents::Reals(reals) => residual.stays_at_most(level, reals.outward().0, reals.outward().1),
        }
    }

    /// Whether the residual is proved to be at least `level` at every one of these n, the same way.
    pub fn stay_at_least<I: ScaledIntegral>(self, residual: &Residual<I>, level: &RBig) -> bool {
        match self {
            Exponents::Integers(..) => self.each(residual, |value| exact(value.lo()), |x| x >= level),
            Exponents::Reals(reals) => residual.stays_at_least(level, reals.outward().0, reals.outward().1),
        }
    }

    /// Whether coef(n) is proved to be positive at every real n between the ends.
    pub fn have_positive_factor<I: ScaledIntegral>(self, residual: &Residual<I>) -> bool {
        let (from, to) = match self {
            Exponents::Integers(..) => self.ends(),
            Exponents::Reals(reals) => reals.outward(),
        };
        residual.has_positive_factor(from, to)
    }

    /// The smallest of these n, or one near it, at which the residual is not bounded: [`Residual::unbounded_near`].
    pub fn unbounded_near<I: ScaledIntegral>(self, residual: &Residual<I>) -> Option<f64> {
        match self {
            Exponents::Integers(from, to) => {
                (from..=to).map(f64::from).find(|n| !residual.at(*n).width().is_finite())
            }
            Exponents::Reals(reals) => residual.unbounded_near(reals.outward().0, reals.outward().1),
        }
    }

    /// The residual at n exactly, if n is one of these, or ∞ where they have no end, and it is rational there:
    /// [`Residual::exactly`].
    pub fn exactly<I: ScaledIntegral>(self, residual: &Residual<I>, n: f64) -> Option<RBig> {
        let is_one = match self {
            Exponents::Integers(from, to) => {
                n == libm::floor(n) && (f64::from(from)..=f64::from(to)).contains(&n)
            }
            Exponents::Reals(reals) => reals.inward().is_some_and(|(first, last)| first <= n && n <= last),
        };
        if is_one { residual.exactly(n) } else { None }
    }

    /// Whether every whole n is on one side, by an end of its enclosure or exactly.
    fn each<I: ScaledIntegral>(
        self,
        residual: &Residual<I>,
        end: impl Fn(Interval) -> Option<RBig>,
        inside: impl Fn(&RBig) -> bool,
    ) -> bool {
        let Exponents::Integers(from, to) = self else { return false };
        (from..=to).map(f64::from).all(|n| {
            end(residual.at(n)).is_some_and(|x| inside(&x)) || residual.exactly(n).is_some_and(|x| inside(&x))
        })
    }

    /// The real numbers around them; one more where there is but one whole number.
    pub(super) fn reals(self) -> Option<Reals> {
        match self {
            Exponents::Integers(from, to) => {
                Reals::new(f64::from(from), f64::from(to.max(from.saturating_add(1)))).ok()
            }
            Exponents::Reals(reals) => Some(reals),
        }
    }
}

impl fmt::Display for Exponents {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Exponents::Integers(from, to) => write!(f, "{from}..{to}"),
            Exponents::Reals(reals) => write!(f, "{reals}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::Formula;
    use crate::integral::{Case, Field, Limit, Lobe};
    use crate::kernel::model::Model;

    /// Phong's integral over the support of (2) is 16/(17 n): with this factor the residual is (n + 1)/n - 1 = 1/n.
    fn one_over_n() -> Residual<Case> {
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
        let factor: Formula = "17*(n + 1)/(32*pi)".parse().unwrap();
        Residual::new(case, &factor)
    }

    fn ranges() -> [Exponents; 2] {
        [Exponents::Integers(16, 64), Exponents::Reals("16..64".parse().unwrap())]
    }

    fn one_over(n: i64) -> RBig {
        RBig::int(1) / RBig::int(n)
    }

    /// The ends themselves are kept, and one n of all is enough to break a level.
    #[test]
    fn a_level_is_kept_by_all_or_not_at_all() {
        let residual = one_over_n();
        for n in ranges() {
            assert!(
                n.stay_at_most(&residual, &one_over(16)) && n.stay_at_least(&residual, &one_over(64)),
                "{n:?}"
            );
            assert!(
                !n.stay_at_most(&residual, &one_over(17)) && !n.stay_at_least(&residual, &one_over(63)),
                "{n:?}"
            );
            assert!(n.have_positive_factor(&residual), "{n:?}");
        }
    }

    #[test]
    fn only_these_n_are_asked() {
        let residual = one_over_n();
        for (n, whole, real) in [
            (16.0, true, true),
            (20.0, true, true),
            (20.5, false, true),
            (64.0, true, true),
            (15.0, false, false),
            (65.0, false, false),
        ] {
            let [integers, reals] = ranges().map(|range| range.exactly(&residual, n));
            let exact = RBig::int(2) / RBig::int((2.0 * n) as i64);
            assert_eq!((integers, reals), (whole.then(|| exact.clone()), real.then_some(exact)), "{n}");
        }
    }

    #[test]
    fn a_pole_is_named() {
        let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
        let pole = Residual::new(case, &"1/(n - 20)".parse().unwrap());
        let [integers, reals] = ranges().map(|range| range.unbounded_near(&pole));
        assert_eq!(integers, Some(20.0));
        assert!((reals.unwrap() - 20.0).abs() < 0.1, "{reals:?}");
        assert!(ranges().iter().all(|range| range.unbounded_near(&one_over_n()).is_none()));
    }

    #[test]
    fn what_n_ranges_over_is_told() {
        let [integers, reals] = ranges();
        assert_eq!((integers.over(), reals.over()), ("integers", "reals"));
        assert_eq!((integers.ends(), reals.ends()), ((16.0, 64.0), (16.0, 64.0)));
        assert_eq!((integers.to_string(), reals.to_string()), ("16..64".to_owned(), "16..64".to_owned()));
        // A single whole number stands in a range of reals that has a width.
        assert_eq!(Exponents::Integers(16, 16).reals().map(|r| (r.from(), r.to())), Some((16.0, 17.0)));
        assert_eq!(integers.reals().map(|r| (r.from(), r.to())), Some((16.0, 64.0)));
    }
}
