//! What repeated measurements come to.

use serde::{Deserialize, Serialize};

/// The middle of measurements, and how far they went.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Spread {
    /// The median; of an even count the mean of the middle two.
    pub median: f64,
    /// The least.
    pub least: f64,
    /// The most.
    pub most: f64,
}

impl Spread {
    /// Of measurements in any order; `None` without one, or with one that is not finite.
    ///
    /// ```
    /// use bellfit::trade::Spread;
    /// let spread = Spread::of(&[3.0, 9.0, 1.0, 2.0]).expect("four");
    /// assert_eq!((spread.median, spread.least, spread.most), (2.5, 1.0, 9.0));
    /// ```
    pub fn of(measured: &[f64]) -> Option<Spread> {
        let mut sorted = measured.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (&least, &most) = (sorted.first()?, sorted.last()?);
        let half = sorted.len() / 2;
        let median =
            if sorted.len() % 2 == 1 { sorted[half] } else { 0.5 * (sorted[half - 1] + sorted[half]) };
        sorted.iter().all(|x| x.is_finite()).then_some(Spread { median, least, most })
    }

    /// (most - least)/median.
    ///
    /// ```
    /// use bellfit::trade::Spread;
    /// assert_eq!(Spread { median: 4.0, least: 3.0, most: 5.0 }.relative(), 0.5);
    /// ```
    pub fn relative(&self) -> f64 {
        (self.most - self.least) / self.median
    }

    /// How far the median lies over the least, as a ratio: at least 1.
    ///
    /// ```
    /// use bellfit::trade::Spread;
    /// assert_eq!(Spread { median: 4.5, least: 3.0, most: 5.0 }.wander(), 1.5);
    /// ```
    pub fn wander(&self) -> f64 {
        self.median / self.least
    }

    /// Each number to four significant digits: a clock tells no more.
    #[must_use]
    pub fn rounded(&self) -> Spread {
        let digits = |x: f64| format!("{x:.3e}").parse().unwrap_or(x);
        Spread { median: digits(self.median), least: digits(self.least), most: digits(self.most) }
    }
}
