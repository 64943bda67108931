//! Ranges of real n, with an end or without.

use super::FitError;
use crate::bound::{Interval, decimal, exact};
use crate::integral::Field;
use core::cmp::Ordering;
use core::fmt;
use core::str::FromStr;
use dashu_ratio::RBig;

/// Every real n of [from, to], 1 ≤ from < to, `to` up to ∞.
///
/// An end is the exact decimal that is written; where that is no double, the two next to it enclose it.
///
/// ```
/// use bellfit::fit::Reals;
/// let range: Reals = "16..inf".parse()?;
/// assert_eq!((range.from(), range.to()), (16.0, f64::INFINITY));
/// assert_eq!(range.to_string(), "16..inf");
/// assert_eq!("16..1024".parse::<Reals>()?.whole(), Some((16, 1024)));
/// assert!("16..16".parse::<Reals>().is_err());
/// // The double nearest to this is 16; the number is not.
/// let below: Reals = "15.9999999999999995..1024".parse()?;
/// assert!(below.from() == 16.0 && below.outward().0 < 16.0 && below.whole().is_none());
/// # Ok::<(), bellfit::fit::FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reals {
    from: End,
    to: End,
}

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq)]
struct End {
    nearest: f64,
    enclosure: Interval,
}

/// The largest whole end of a range that is also summed over, as for [`super::Problem`].
const LARGEST: f64 = 65_536.0;

impl Reals {
    /// [from, to], exactly these doubles.
    ///
    /// # Errors
    /// [`FitError::Reals`] unless 1 ≤ from < to.
    pub fn new(from: f64, to: f64) -> Result<Self, FitError> {
        let end = |x: f64| End { nearest: x, enclosure: Interval::from(x) };
        if from >= 1.0 && from < to {
            Ok(Reals { from: end(from), to: end(to) })
        } else {
            Err(FitError::Reals { text: format!("{from}..{to}") })
        }
    }

    /// The first n, to the nearest double.
    pub fn from(self) -> f64 {
        self.from.nearest
    }

    /// The last n, to the nearest double; may be ∞.
    pub fn to(self) -> f64 {
        self.to.nearest
    }

    /// Both ends, if they are whole numbers that a sum can run over.
    pub fn whole(self) -> Option<(u32, u32)> {
        let whole = |end: End| end.enclosure.width() == 0.0 && end.nearest == libm::floor(end.nearest);
        let sums = whole(self.from) && whole(self.to) && self.to() <= LARGEST;
        sums.then_some((self.from() as u32, self.to() as u32))
    }

    /// Encloses both ends; an end that is a double is enclosed by it alone.
    pub fn ends(self) -> (Interval, Interval) {
        (self.from.enclosure, self.to.enclosure)
    }

    /// Doubles around the range, for a certificate.
    pub fn outward(self) -> (f64, f64) {
        (self.from.enclosure.lo(), self.to.enclosure.hi())
    }

    /// The first and the last double in the range; `None` if it lies between two.
    pub fn inward(self) -> Option<(f64, f64)> {
        let (first, last) = (self.from.enclosure.hi(), self.to.enclosure.lo());
        (first <= last).then_some((first, last))
    }

    /// 1/n at both ends: the smallest m, which is 0 for an endless range, and the largest.
    pub(super) fn in_m(self) -> (f64, f64) {
        (1.0 / self.to(), 1.0 / self.from())
    }
}

/// Both ends to the nearest double.
impl fmt::Display for Reals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.from(), self.to())
    }
}

impl FromStr for Reals {
    type Err = FitError;

    /// `A..B`, decimals, B also `inf`.
    fn from_str(text: &str) -> Result<Self, FitError> {
        let problem = || FitError::Reals { text: text.to_owned() };
        let (from, to) = text.split_once("..").ok_or_else(problem)?;
        let number = |end: &str| {
            // What is printed here must not read as anything but a plain decimal.
            let plain = end.bytes().all(|b| b.is_ascii_digit() || b == b'.');
            let nearest = end.parse::<f64>().ok().filter(|x| plain && x.is_finite())?;
            Some((decimal(end)?.0, nearest))
        };
        let (from, to) = (from.trim(), to.trim());
        let (first, from) = number(from).ok_or_else(problem)?;
        let from = end(&first, from);
        let (last, to) = if to == "inf" {
            (None, End { nearest: f64::INFINITY, enclosure: Interval::from(f64::INFINITY) })
        } else {
            let (last, to) = number(to).ok_or_else(problem)?;
            let to = end(&last, to);
            (Some(last), to)
        };
        let is_range = first >= RBig::int(1) && last.is_none_or(|last| first < last);
        if is_range { Ok(Reals { from, to }) } else { Err(problem()) }
    }
}

/// The decimal between the double nearest to it and the next on its side.
fn end(value: &RBig, nearest: f64) -> End {
    let read = exact(nearest);
    let side = read.map_or(Ordering::Equal, |read| value.cmp(&read));
    let enclosure = match side {
        Ordering::Less => Interval::new(nearest.next_down(), nearest),
        Ordering::Equal => Interval::from(nearest),
        Ordering::Greater => Interval::new(nearest, nearest.next_up()),
    };
    End { nearest, enclosure }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_they_are_written() {
        for text in ["16..1024", "1..16", "16.5..17.25", "16..inf", "1..1.5"] {
            assert_eq!(text.parse::<Reals>().unwrap().to_string(), text);
        }
        for text in [
            "",
            "..",
            "16",
            "16..",
            "..16",
            "0.5..2",
            "16..2",
            "inf..inf",
            "NaN..3",
            "1..NaN",
            "1e1..2e1",
            // The doubles nearest to these are 1, and 1 and 1.
            "0.99999999999999999999..2",
            "1.00000000000000000001..1",
        ] {
            let error = text.parse::<Reals>().unwrap_err().to_string();
            assert!(error.contains(text) && error.contains("1 ≤ A < B"), "{error}");
        }
    }

    #[test]
    fn only_whole_ends_can_be_summed_over() {
        let whole = |text: &str| text.parse::<Reals>().unwrap().whole();
        assert_eq!(whole("1..65536"), Some((1, 65_536)));
        assert!(whole("1..65537").is_none() && whole("1.5..3").is_none() && whole("1..inf").is_none());
    }

    /// The double nearest to 16.3 is 16.300000000000000710…, to 17.7 it is 17.699999999999999289…
    #[test]
    fn decimals_that_are_no_doubles_are_enclosed() {
        let range: Reals = "16.3..17.7".parse().unwrap();
        assert_eq!(range.outward(), (16.3_f64.next_down(), 17.7_f64.next_up()));
        assert_eq!(range.inward(), Some((16.3, 17.7)));
        assert_eq!("16.5..17.25".parse::<Reals>().unwrap().outward(), (16.5, 17.25));
        assert_eq!(Reals::new(16.0, f64::INFINITY).unwrap().outward(), (16.0, f64::INFINITY));
    }

    #[test]
    fn what_rounds_to_a_whole_number_is_none() {
        let range: Reals = "15.9999999999999995..32.0000000000000001".parse().unwrap();
        assert_eq!((range.from(), range.to(), range.whole()), (16.0, 32.0, None));
        assert_eq!(range.outward(), (16.0_f64.next_down(), 32.0_f64.next_up()));
        // More than nothing, though no double lies between.
        assert_eq!("1..1.0000000000000000001".parse::<Reals>().unwrap().inward(), Some((1.0, 1.0)));
        let between: Reals = "1.00000000000000000001..1.00000000000000000002".parse().unwrap();
        assert_eq!(between.inward(), None);
    }
}
