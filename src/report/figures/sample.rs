//! Where curves are sampled, and how their numbers are written.

use crate::bound::Interval;
use crate::report::chart::{Axis, LineChart, Scale};

/// The papers' first and last specular exponent.
pub(super) const RANGE: (f64, f64) = (16.0, 1024.0);

/// Up to here every integer is drawn: curves bend most at small n.
const DENSE: f64 = 64.0;

/// Integers per doubling beyond.
const PER_DOUBLING: f64 = 75.0;

/// f over the interval at `steps` + 1 arguments of equal distance, both ends among them.
pub(super) fn curve((lo, hi): (f64, f64), steps: u32, f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let at = |i: u32| if i == steps { hi } else { lo + (hi - lo) * f64::from(i) / f64::from(steps) };
    (0..=steps).map(at).map(|x| (x, f(x))).collect()
}

/// f at integers of [`RANGE`], about evenly spaced on a logarithmic axis.
pub(super) fn over_n(f: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut integers = Vec::new();
    let mut n = RANGE.0;
    while n < RANGE.1 {
        integers.push(n);
        let ratio = libm::exp2(1.0 / PER_DOUBLING);
        n = if n < DENSE { n + 1.0 } else { (n + 1.0).max(libm::round(n * ratio)) };
    }
    integers.push(RANGE.1);
    integers.into_iter().map(|n| (n, f(n))).collect()
}

/// 16, 32, …, 1024.
pub(super) fn doublings() -> impl Iterator<Item = f64> {
    (4..=10).map(|k| f64::from(1_u32 << k))
}

/// The axis of the specular exponent.
pub(super) fn n_axis() -> Axis {
    Axis::new("specular exponent n", Scale::Log2, RANGE)
}

/// A chart with nothing on it yet.
pub(super) fn empty(x: Axis, y: Axis) -> LineChart {
    LineChart {
        title: String::new(),
        subtitle: String::new(),
        x,
        y,
        bands: vec![],
        series: vec![],
        marks: vec![],
    }
}

/// Three significant digits, `1.70e-2`.
pub(super) fn number(x: f64) -> String {
    format!("{x:.2e}")
}

/// The middle of an enclosure that is far narrower than three digits.
pub(super) fn enclosed(value: Interval) -> String {
    number(value.mid())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_integers_rise_from_end_to_end() {
        let drawn: Vec<f64> = over_n(|n| n).into_iter().map(|p| p.0).collect();
        assert_eq!((drawn[0], drawn[drawn.len() - 1]), RANGE);
        assert!(drawn.windows(2).all(|w| w[0] < w[1]) && drawn.iter().all(|n| n.fract() == 0.0));
        assert!((1..=48).all(|i| drawn[i] == 16.0 + i as f64));
        assert!((300..400).contains(&drawn.len()), "{}", drawn.len());
    }

    #[test]
    fn a_curve_ends_at_its_ends() {
        assert_eq!(curve((0.1, 0.7), 3, |x| x).last(), Some(&(0.7, 0.7)));
        assert_eq!(curve((0.0, 1.0), 2, |x| 2.0 * x), [(0.0, 0.0), (0.5, 1.0), (1.0, 2.0)]);
    }
}
