//! Any factor by a multiple of it.

use super::{Change, Remedy, Search, TRIES};
use crate::bound::{Formula, Residual};
use crate::fit::digits::Decimal;
use crate::integral::ScaledIntegral;

/// The most digits of the multiple.
const MOST_DIGITS: usize = 12;

impl<I: ScaledIntegral + Clone> Search<'_, I> {
    /// The decimal of fewest digits that brings the factor into the band, and of those the nearest to 1.
    pub(super) fn by_multiple(&self, factor: &Formula, text: &str) -> Option<Remedy> {
        let residual = Residual::new(self.continuum.integral.clone(), factor);
        let extremes = self.exponents.extremes(&residual);
        let (low, high) = self.band.ends();
        // 1 + residual runs from `least` to `most`, all of it to be positive and finite.
        let (least, most) = (1.0 + extremes.min.value.lo(), 1.0 + extremes.max.value.hi());
        let (from, to) = ((1.0 + low) / least, (1.0 + high) / most);
        if !(least > 0.0 && most.is_finite() && from <= to * (1.0 + super::SLACK)) {
            return None;
        }
        let mut tries = 0;
        for digits in 1..=MOST_DIGITS {
            for by in candidates(from, to, digits) {
                let source = format!("{}*({text})", by.text());
                let Ok(scaled) = source.parse::<Formula>() else { continue };
                tries += 1;
                if let Some(extremes) = self.certified(&scaled) {
                    return Some(Remedy { change: Change::Multiple { by: by.text() }, source, extremes });
                }
            }
            if tries > TRIES {
                return None;
            }
        }
        None
    }
}

/// Decimals of at most so many digits between both ends, the nearest to 1 first; at most two.
fn candidates(from: f64, to: f64, digits: usize) -> Vec<Decimal> {
    let places = i32::MAX;
    let below = |x: f64| Decimal::floor(x, digits, places).filter(|d| d.is_positive());
    // From below where 1 is above, else from above.
    let first = if to < 1.0 { below(to) } else { below(from.max(1.0)) };
    let Some(first) = first else { return vec![] };
    let second = if to < 1.0 { first.below(digits) } else { first.above(digits) };
    let inside = |d: &Decimal| d.is_positive() && d.to_f64() >= from && d.to_f64() <= to;
    [first, second].into_iter().filter(inside).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn candidates_lie_between_and_near_one() {
        let texts = |from, to, digits| -> Vec<String> {
            candidates(from, to, digits).into_iter().map(Decimal::text).collect()
        };
        assert_eq!(texts(0.5, 0.987, 1), ["0.9", "0.8"]);
        assert_eq!(texts(0.95, 0.987, 2), ["0.98", "0.97"]);
        assert_eq!(texts(1.03, 1.2, 2), ["1.1"]);
        assert!(texts(1.03, 1.04, 1).is_empty());
    }
}
