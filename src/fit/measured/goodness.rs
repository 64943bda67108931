//! Whether residuals have the size that the samples' sigmas say.

use super::chi_square_tails;

/// χ² of a fit to samples whose σ are given, beside what noise of these σ leaves of it.
///
/// If the lobe is of the family and the noise normal and of these σ, χ² is of the χ² distribution with N - p degrees
/// of freedom: about N - p ± √(2 (N - p)).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Goodness {
    /// χ²/(N - p): 1 where the sigmas hold.
    pub reduced: f64,
    /// The probability of a smaller χ².
    pub below: f64,
    /// The probability of a larger χ².
    pub above: f64,
}

/// A tail of the χ² distribution from which chance is no explanation.
const RARE: f64 = 1e-3;

impl Goodness {
    /// Of a χ² with N - p degrees of freedom, one or more.
    pub(super) fn of(chi_square: f64, freedom: usize) -> Self {
        let (below, above) = chi_square_tails(chi_square, freedom);
        Goodness { reduced: chi_square / freedom as f64, below, above }
    }

    /// Whether the residuals are larger than noise of the sigmas leaves them once in 1000: the sigmas are too small,
    /// or the family is not the samples'.
    ///
    /// ```
    /// use bellfit::fit::measured::Goodness;
    /// assert!(Goodness { reduced: 2.0, below: 1.0, above: 1e-4 }.is_excess());
    /// assert!(!Goodness { reduced: 1.5, below: 0.98, above: 0.02 }.is_excess());
    /// ```
    pub fn is_excess(&self) -> bool {
        self.above < RARE
    }

    /// Whether they are smaller than noise of the sigmas leaves them once in 1000: the sigmas are too large.
    pub fn is_short(&self) -> bool {
        self.below < RARE
    }
}
