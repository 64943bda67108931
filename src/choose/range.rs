//! Ranges of exponents that a scene has.

use super::NeedError;
use crate::bound::Interval;
use core::fmt;
use core::str::FromStr;

/// Every n of [from, to], 1 ≤ from ≤ to ≤ 1e12: every real one, or the whole ones alone.
///
/// ```
/// use bellfit::choose::Exponents;
/// let range: Exponents = "16..1024".parse()?;
/// assert_eq!((range.from(), range.to(), range.is_whole()), (16.0, 1024.0, false));
/// // One whole number is a range of whole numbers.
/// assert!("50".parse::<Exponents>()?.is_whole());
/// # Ok::<(), bellfit::choose::NeedError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponents {
    from: f64,
    to: f64,
    whole: bool,
}

/// The largest exponent: there a lobe is as wide as 1e-6 radians.
const LARGEST: f64 = 1e12;

impl Exponents {
    /// Every real n of [from, to].
    ///
    /// # Errors
    /// [`NeedError::Exponents`] unless 1 ≤ from ≤ to ≤ 1e12.
    pub fn new(from: f64, to: f64) -> Result<Self, NeedError> {
        if !(1.0 <= from && from <= to && to <= LARGEST) {
            return Err(NeedError::Exponents { text: format!("{from}..{to}") });
        }
        Ok(Exponents { from, to, whole: from == to && from == libm::floor(from) })
    }

    /// The exponents of Beckmann's roughness α in [from, to]: n = 2/α² - 2, both ends rounded outward.
    ///
    /// Source: B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007, which
    /// gives α_p = 2 α_b⁻² - 2 for the Phong exponent with a Beckmann distribution's roughness.
    ///
    /// # Errors
    /// [`NeedError::Roughness`] unless 0 < from ≤ to ≤ 1; [`NeedError::TooRough`] and
    /// [`NeedError::TooSmooth`] where n would be below 1 or above 1e12.
    ///
    /// ```
    /// use bellfit::choose::{Exponents, NeedError};
    /// let range = Exponents::of_roughness(0.1, 0.5)?;
    /// assert!((range.from() - 6.0).abs() < 1e-14 && (range.to() - 198.0).abs() < 1e-12);
    /// assert!(range.from() <= 6.0 && range.to() >= 198.0);
    /// assert!(matches!(Exponents::of_roughness(0.1, 0.9), Err(NeedError::TooRough { .. })));
    /// # Ok::<(), NeedError>(())
    /// ```
    pub fn of_roughness(from: f64, to: f64) -> Result<Self, NeedError> {
        if !(0.0 < from && from <= to && to <= 1.0) {
            return Err(NeedError::Roughness { text: format!("{from}..{to}") });
        }
        // Far from where squares underflow.
        if from < 1e-6 {
            return Err(NeedError::TooSmooth { alpha: from, n: 2.0 / (from * from) });
        }
        let two = Interval::from(2.0);
        // The double is next to the decimal that was meant.
        let exponent = |alpha: f64| {
            let alpha = Interval::new(alpha.next_down(), alpha.next_up());
            two / (alpha * alpha) - two
        };
        let (lo, hi) = (exponent(to).lo(), exponent(from).hi());
        if lo < 1.0 {
            return Err(NeedError::TooRough { alpha: to, n: lo });
        }
        if hi > LARGEST {
            return Err(NeedError::TooSmooth { alpha: from, n: hi });
        }
        Ok(Exponents { from: lo, to: hi, whole: false })
    }

    /// [`Self::of_roughness`] from `A..B` or a single `A`, decimals.
    ///
    /// # Errors
    /// As there; [`NeedError::Roughness`] for what is no range.
    ///
    /// ```
    /// use bellfit::choose::Exponents;
    /// assert_eq!(Exponents::parse_roughness("0.1..0.5")?, Exponents::of_roughness(0.1, 0.5)?);
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn parse_roughness(text: &str) -> Result<Self, NeedError> {
        let problem = || NeedError::Roughness { text: text.to_owned() };
        let (from, to) = ends(text).ok_or_else(problem)?;
        Exponents::of_roughness(from, to)
    }

    /// The same range with its whole numbers alone, `None` if it has none.
    ///
    /// ```
    /// use bellfit::choose::Exponents;
    /// let whole = Exponents::new(16.5, 20.0)?.whole_only().expect("17 to 20");
    /// assert_eq!((whole.from(), whole.to(), whole.is_whole()), (17.0, 20.0, true));
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn whole_only(self) -> Option<Self> {
        let (from, to) = (libm::ceil(self.from), libm::floor(self.to));
        (from <= to).then_some(Exponents { from, to, whole: true })
    }

    /// The least n.
    pub fn from(self) -> f64 {
        self.from
    }

    /// The largest n.
    pub fn to(self) -> f64 {
        self.to
    }

    /// Whether whole n alone are meant.
    pub fn is_whole(self) -> bool {
        self.whole
    }

    /// Ends for a certificate: a decimal that is no whole number lies within one step of its double.
    pub(super) fn outward(self) -> (f64, f64) {
        let is_whole = |x: f64| x == libm::floor(x);
        let from = if is_whole(self.from) { self.from } else { self.from.next_down().max(1.0) };
        (from, if is_whole(self.to) { self.to } else { self.to.next_up() })
    }
}

impl fmt::Display for Exponents {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.from == self.to {
            return write!(f, "{}", self.from);
        }
        write!(f, "{}..{}", self.from, self.to)
    }
}

/// `A..B` or `A`, as plain decimals; `None` for anything else.
fn ends(text: &str) -> Option<(f64, f64)> {
    let number = |end: &str| {
        let end = end.trim();
        let plain = end.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'e' | b'E' | b'-' | b'+'));
        end.parse::<f64>().ok().filter(|x| plain && x.is_finite())
    };
    match text.split_once("..") {
        Some((from, to)) => Some((number(from)?, number(to)?)),
        None => number(text).map(|x| (x, x)),
    }
}

impl FromStr for Exponents {
    type Err = NeedError;

    /// `A..B` or a single `A`, decimals.
    fn from_str(text: &str) -> Result<Self, NeedError> {
        let problem = || NeedError::Exponents { text: text.to_owned() };
        let (from, to) = ends(text).ok_or_else(problem)?;
        Exponents::new(from, to).map_err(|_| problem())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_as_they_are_written() {
        for text in ["16..1024", "1..1.5", "64", "1..1000000000000"] {
            assert_eq!(text.parse::<Exponents>().unwrap().to_string(), text);
        }
        assert_eq!("1e3..2e6".parse::<Exponents>().unwrap().to_string(), "1000..2000000");
        for text in ["", "..", "16..", "..16", "0.5..2", "0", "16..2", "NaN", "1..inf", "1..1.1e12", "a..b"] {
            let error = text.parse::<Exponents>().unwrap_err().to_string();
            assert!(error.contains(&format!("\"{text}\"")) && error.contains("1 ≤ A ≤ B ≤ 1e12"), "{error}");
        }
    }

    /// At powers of two n is exact in doubles, and lies inside, not at an end.
    #[test]
    fn roughness_is_enclosed() {
        for k in 1..=18 {
            let alpha = libm::exp2(-f64::from(k));
            let n = 2.0 / (alpha * alpha) - 2.0; // exact: powers of two
            let range = Exponents::of_roughness(alpha, alpha).unwrap();
            assert!(
                range.from() < n && n < range.to() && range.to() - range.from() < 1e-14 * (n + 2.0) * 2.0
            );
        }
        for alpha in [1.1e-6, 1e-7, 5e-324] {
            assert!(
                matches!(Exponents::of_roughness(alpha, 0.5), Err(NeedError::TooSmooth { .. })),
                "{alpha}"
            );
        }
        for (from, to) in [(0.0, 0.5), (0.5, 0.1), (0.5, 1.5), (f64::NAN, 0.5)] {
            assert!(matches!(Exponents::of_roughness(from, to), Err(NeedError::Roughness { .. })));
        }
    }
}
