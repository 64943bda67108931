//! A line by the fewest of its digits changed.

use super::{Change, Remedy, SLACK, Search, TRIES};
use crate::bound::{Formula, Residual, decimal};
use crate::fit::Line;
use crate::fit::nearest::variants;
use crate::integral::ScaledIntegral;
use std::collections::BTreeMap;

/// At most so many digits are changed, and so many of them in b.
const MOST_CHANGED: usize = 4;
const MOST_IN_B: usize = 3;
/// A line that loses more than half of the light is no neighbour of one that keeps it.
const HALF: f64 = 0.5;
/// Longer lists of decimals are left out, so that constants of many digits take no minutes.
const MOST_VARIANTS: usize = 40_000;

/// A candidate: its largest |residual| in doubles, a and b.
type Ranked = (f64, String, String);

impl<I: ScaledIntegral + Clone> Search<'_, I> {
    /// Fewest digits changed; among those the smallest |residual| first. One that loses too much waits, beside it,
    /// for one of more digits or another form.
    pub(super) fn by_digits(&self, line: &Line) -> (Option<Remedy>, Option<Remedy>) {
        let mut losing = None;
        let found = self.line(line, &mut losing);
        (found, losing)
    }

    fn line(&self, line: &Line, losing: &mut Option<Remedy>) -> Option<Remedy> {
        let most_lost = self.most_lost(line.formula());
        // What the line's g is of the samples' one.
        let divisor: f64 = line.divisor().parse().ok()?;
        let ratio = f64::from(self.continuum.divisor) / divisor;
        if !(ratio.is_finite() && ratio > 0.0) {
            return None;
        }
        let (low, high) = self.allowed();
        let points: Vec<Point> = self
            .samples
            .iter()
            .map(|s| {
                let g = ratio * s.g;
                Point { m: s.m, g, least: low / g, most: high / g }
            })
            .collect();
        let mut slopes: BTreeMap<usize, Vec<(f64, String)>> = BTreeMap::new();
        for total in 1..=MOST_CHANGED {
            let mut ranked: Vec<Ranked> = Vec::new();
            for in_b in 0..=total.min(MOST_IN_B) {
                let a = slopes.entry(total - in_b).or_insert_with(|| listed(line.a(), total - in_b));
                for (b, text) in listed(line.b(), in_b) {
                    ranked.extend(best_slope(&points, a, b).map(|(worst, a)| (worst, a, text)));
                }
            }
            ranked.sort_by(|x, y| x.0.total_cmp(&y.0).then_with(|| (&x.1, &x.2).cmp(&(&y.1, &y.2))));
            for (_, a, b) in ranked.into_iter().take(TRIES) {
                let line = Line::new(&a, &b, line.divisor())?;
                let formula: &Formula = line.formula();
                if let Some(extremes) = self.certified(formula) {
                    let source = line.source();
                    let loses = -extremes.min.value.lo();
                    let remedy = Remedy { change: Change::Digits { line, changed: total }, source, extremes };
                    if loses <= most_lost {
                        return Some(remedy);
                    }
                    losing.get_or_insert(remedy);
                    // The others of as many digits lose more.
                    break;
                }
            }
        }
        None
    }
}

impl<I: ScaledIntegral + Clone> Search<'_, I> {
    /// What a line may lose that stands in for this one: half, or what this one loses.
    fn most_lost(&self, factor: &Formula) -> f64 {
        let extremes = self.exponents.extremes(&Residual::new(self.continuum.integral.clone(), factor));
        HALF.max(-extremes.min.value.hi())
    }
}

/// A sample for one divisor: 1 + residual = g (a + b m), and least ≤ a + b m ≤ most.
struct Point {
    m: f64,
    g: f64,
    least: f64,
    most: f64,
}

/// Decimals that differ in exactly so many digits, ascending; none begins with a zero that was not there.
fn listed(text: &str, changed: usize) -> Vec<(f64, String)> {
    let digits = text.bytes().filter(u8::is_ascii_digit).count();
    let count = (0..changed).fold(1, |count, k| count * 9 * digits.saturating_sub(k) / (k + 1));
    if count > MOST_VARIANTS {
        return vec![];
    }
    let padded = |t: &str| {
        let t = t.trim_start_matches('-');
        t.len() > 1 && t.starts_with('0') && !t.starts_with("0.")
    };
    let known = padded(text);
    let texts = variants(text, changed).into_iter().filter(|t| known || !padded(t));
    let mut all: Vec<(f64, String)> =
        texts.filter_map(|t| Some((decimal(&t)?.0.to_f64().value(), t))).collect();
    all.sort_by(|x, y| x.0.total_cmp(&y.0));
    all
}

/// Of the slopes that keep the band with this b, the one of least |residual|, which is convex in a.
fn best_slope(points: &[Point], slopes: &[(f64, String)], b: f64) -> Option<(f64, String)> {
    let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
    for p in points {
        let bent = b * p.m;
        // The product's own rounding, where the terms cancel.
        let doubt = SLACK * bent.abs();
        least = least.max(p.least - bent - doubt);
        most = most.min(p.most - bent + doubt);
        if least > most {
            return None;
        }
    }
    let from = slopes.partition_point(|(a, _)| *a < least);
    let to = slopes.partition_point(|(a, _)| *a <= most);
    let worst = |i: usize| {
        let a = slopes[i].0;
        points.iter().map(|p| (p.g * (a + b * p.m) - 1.0).abs()).fold(0.0, f64::max)
    };
    let (mut lo, mut hi) = (from, to);
    while hi > lo + 1 {
        let middle = lo + (hi - lo) / 2;
        // Rising from here on: the least is before.
        if worst(middle) >= worst(middle - 1) { hi = middle } else { lo = middle }
    }
    (lo < to).then(|| (worst(lo), slopes[lo].1.clone()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A zero comes to the front only before a point, or where one stood.
    #[test]
    fn lists_hold_every_decimal_that_is_written_so() {
        let texts = |text: &str, changed| -> Vec<String> {
            let all = listed(text, changed);
            assert!(all.windows(2).all(|pair| pair[0].0 < pair[1].0), "{text}");
            assert!(all.iter().all(|(value, text)| text.parse() == Ok(*value)), "{text}");
            all.into_iter().map(|(_, text)| text).collect()
        };
        assert_eq!(texts("1.5", 0), ["1.5"]);
        let twelve = texts("12", 1);
        assert_eq!((twelve.len(), twelve[0].as_str(), twelve[16].as_str()), (17, "10", "92"));
        assert_eq!(texts("0.5", 1).len(), 18);
        assert!(texts("1.5", 1).contains(&"0.5".to_owned()));
        assert_eq!(texts("-12", 1).len(), 17);
        assert_eq!(texts("07", 1).len(), 18);
        assert_eq!(texts("7", 1), ["0", "1", "2", "3", "4", "5", "6", "8", "9"]);
        // Four of eight digits are 9⁴ · 70 decimals, too many; of five 9⁴ · 5.
        assert!(listed("1.2345678", 4).is_empty());
        assert_eq!(listed("1.2345", 4).len(), 32_805);
    }
}
