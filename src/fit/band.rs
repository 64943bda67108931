//! What is asked of a residual: where it has to stay.

use crate::bound::{Extremes, enclose, exact};
use crate::integral::Field;
use dashu_ratio::RBig;

/// The residuals 2π coef(n) Int(n) - 1 that are allowed; never -1 or less, where a factor would not be
/// positive.
///
/// ```
/// use bellfit::{bound::decimal, fit::Band};
/// let percent = decimal("0.01").expect("a decimal").0;
/// let band = Band::new(Some(&percent), true, None);
/// assert_eq!(band.ends(), (-0.01, 0.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    lowest: RBig,
    highest: Option<RBig>,
}

impl Band {
    /// |residual| at most `bound`; if it never gains, at most 0; if it loses at most `loss`, at least -`loss`.
    pub fn new(bound: Option<&RBig>, never_gains: bool, loss: Option<&RBig>) -> Self {
        let zero = RBig::int(0);
        let lows = [bound, loss].into_iter().flatten().map(|x| zero.clone() - x.clone());
        let lowest = lows.fold(RBig::int(-1), |low, x| if x > low { x } else { low });
        let highest = if never_gains { Some(zero) } else { bound.cloned() };
        Band { lowest, highest }
    }

    /// Both ends in doubles, to nearest; ∞ where nothing bounds it above.
    pub fn ends(&self) -> (f64, f64) {
        let highest = self.highest.as_ref().map_or(f64::INFINITY, |x| x.to_f64().value());
        (self.lowest.to_f64().value(), highest)
    }

    /// Whether enclosed extremes prove that it is kept.
    pub fn holds(&self, extremes: &Extremes) -> bool {
        let low = exact(extremes.min.value.lo());
        let kept = low.is_some_and(|low| low > RBig::int(-1) && low >= self.lowest);
        kept && self
            .highest
            .as_ref()
            .is_none_or(|highest| exact(extremes.max.value.hi()).is_some_and(|high| high <= *highest))
    }

    /// The largest level E of a form that can be brought in by a multiple: its 1 + residual then lies in
    /// [s (1 - E), s (1 + E)] for an s of one's choice, so (1 + E)/(1 - E) ≤ (1 + highest)/(1 + lowest).
    /// Rounded up; 1 or more where every form can.
    pub(super) fn most_level(&self) -> f64 {
        let Some(highest) = &self.highest else { return 1.0 };
        let (width, sum) = (highest.clone() - self.lowest.clone(), highest.clone() + self.lowest.clone());
        enclose(&(width / (RBig::int(2) + sum))).hi()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::decimal;

    #[test]
    fn what_a_multiple_can_bring_in_is_the_band_s_own_ratio() {
        let of = |text: &str| decimal(text).unwrap().0;
        // ±b is E = b itself; [-L, 0] is L/(2 - L).
        assert!((Band::new(Some(&of("0.02")), false, None).most_level() - 0.02).abs() < 1e-17);
        assert!((Band::new(None, true, Some(&of("0.1"))).most_level() - 0.1 / 1.9).abs() < 1e-16);
        assert!(Band::new(None, true, None).most_level() >= 1.0);
        let both = Band::new(Some(&of("0.02")), true, Some(&of("0.01")));
        assert_eq!(both.ends(), (-0.01, 0.0));
    }
    /// Enclosures that reach an end keep it, those that straddle it prove nothing.
    #[test]
    fn a_band_is_kept_by_whole_enclosures() {
        use crate::bound::{Extreme, Interval};
        let of = |text: &str| decimal(text).unwrap().0;
        let both = Band::new(Some(&of("0.5")), false, None);
        let never_gains = Band::new(None, true, None);
        for (min, max, is_bounded, is_below) in [
            ((-0.5, -0.5), (0.5, 0.5), true, false),
            ((-0.25, -0.2), (-0.1, 0.0), true, true),
            ((-0.6, -0.4), (0.1, 0.2), false, false),
            ((-0.4, -0.3), (0.4, 0.6), false, false),
            ((-0.9, -0.8), (-0.2, -0.1), false, true),
            ((-1.0, -0.9), (-0.2, -0.1), false, false), // a factor that may be 0
            ((-0.3, -0.2), (-1e-9, 1e-9), true, false),
            ((f64::NEG_INFINITY, 0.0), (0.0, f64::INFINITY), false, false),
        ] {
            let extreme = |(lo, hi)| Extreme { value: Interval::new(lo, hi), n: 16.0 };
            let extremes = Extremes { max: extreme(max), min: extreme(min) };
            assert_eq!(both.holds(&extremes), is_bounded, "{extremes:?}");
            assert_eq!(never_gains.holds(&extremes), is_below, "{extremes:?}");
        }
    }
}
