//! Ranges of real n, with an end or without.

use super::FitError;
use core::fmt;
use core::str::FromStr;

/// Every real n of [from, to], 1 ≤ from < to, `to` up to ∞.
///
/// ```
/// use bellfit::fit::Reals;
/// let range: Reals = "16..inf".parse()?;
/// assert_eq!((range.from(), range.to()), (16.0, f64::INFINITY));
/// assert_eq!(range.to_string(), "16..inf");
/// assert_eq!("16..1024".parse::<Reals>()?.whole(), Some((16, 1024)));
/// assert!("16..16".parse::<Reals>().is_err());
/// # Ok::<(), bellfit::fit::FitError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reals {
    from: f64,
    to: f64,
}

/// The largest whole end of a range that is also summed over, as for [`super::Problem`].
const LARGEST: f64 = 65_536.0;

impl Reals {
    /// [from, to].
    ///
    /// # Errors
    /// [`FitError::Reals`] unless 1 ≤ from < to.
    pub fn new(from: f64, to: f64) -> Result<Self, FitError> {
        if from >= 1.0 && from < to {
            Ok(Reals { from, to })
        } else {
            Err(FitError::Reals { text: format!("{from}..{to}") })
        }
    }

    /// The first n.
    pub fn from(self) -> f64 {
        self.from
    }

    /// The last n; may be ∞.
    pub fn to(self) -> f64 {
        self.to
    }

    /// Both ends, if they are whole numbers that a sum can run over.
    pub fn whole(self) -> Option<(u32, u32)> {
        let whole = |x: f64| x == libm::floor(x);
        let sums = whole(self.from) && whole(self.to) && self.to <= LARGEST;
        sums.then_some((self.from as u32, self.to as u32))
    }

    /// Ends for a certificate: an end that is no whole number is the double next to the decimal meant,
    /// and one step outward holds that too.
    pub fn outward(self) -> (f64, f64) {
        let is_whole = |x: f64| x == libm::floor(x);
        let from = if is_whole(self.from) { self.from } else { self.from.next_down() };
        (from, if is_whole(self.to) { self.to } else { self.to.next_up() })
    }

    /// 1/n at both ends: the smallest m, which is 0 for an endless range, and the largest.
    pub(super) fn in_m(self) -> (f64, f64) {
        (1.0 / self.to, 1.0 / self.from)
    }
}

impl fmt::Display for Reals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.from, self.to)
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
            end.parse::<f64>().ok().filter(|x| plain && x.is_finite())
        };
        let (from, to) = (from.trim(), to.trim());
        let to = if to == "inf" { Some(f64::INFINITY) } else { number(to) };
        Reals::new(number(from).ok_or_else(problem)?, to.ok_or_else(problem)?).map_err(|_| problem())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_they_are_written() {
        for text in ["16..1024", "1..16", "16.5..17.25", "16..inf", "1..1.5"] {
            assert_eq!(text.parse::<Reals>().unwrap().to_string(), text);
        }
        for text in
            ["", "..", "16", "16..", "..16", "0.5..2", "16..2", "inf..inf", "NaN..3", "1..NaN", "1e1..2e1"]
        {
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

    #[test]
    fn decimals_that_are_no_doubles_lie_inside() {
        let (from, to) = "16.3..17.7".parse::<Reals>().unwrap().outward();
        assert!(from < 16.3 && 17.7 < to && from > 16.2999999 && to < 17.7000001);
        assert_eq!(Reals::new(16.0, f64::INFINITY).unwrap().outward(), (16.0, f64::INFINITY));
    }
}
