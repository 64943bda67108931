//! Which n a factor is asked about: the whole numbers of a range, or every real number of it.

use super::Reals;
use crate::bound::{Extremes, Residual};
use crate::integral::ScaledIntegral;
use core::fmt;

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
    /// First and last n.
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
                let (from, to) = reals.outward();
                residual.over_reals(from, to)
            }
        }
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
