//! The samples as the fits see them: in one order, and of one size.

use super::lobe::Lobe;
use super::{Sample, Samples, Weighting};

/// The samples of positive weight, sorted by angle, value and weight: sums do not depend on the rows' order.
/// Values are divided by a power of two near the largest and weights by the largest, so that nothing overflows.
pub(super) struct Points {
    pub(super) versine: Vec<f64>,
    pub(super) ln_cos: Vec<f64>,
    pub(super) value: Vec<f64>,
    pub(super) weight: Vec<f64>,
    pub(super) row: Vec<usize>,
    pub(super) theta_deg: Vec<f64>,
    /// What the values were divided by.
    pub(super) unit: f64,
    /// What the weights were divided by.
    pub(super) heaviest: f64,
    pub(super) weighting: Weighting,
    /// Σ q v².
    pub(super) total: f64,
    /// Different angles.
    pub(super) angles: usize,
}

impl Points {
    pub(super) fn new(samples: &Samples) -> Self {
        let mut sorted: Vec<&Sample> = samples.all.iter().filter(|sample| sample.weight > 0.0).collect();
        let order = |a: &Sample, b: &Sample| {
            let by = |key: fn(&Sample) -> f64| key(a).total_cmp(&key(b));
            by(|s| s.versine).then(by(|s| s.value)).then(by(|s| s.weight)).then(a.row.cmp(&b.row))
        };
        sorted.sort_by(|a, b| order(a, b));
        let largest = sorted.iter().map(|s| s.value.abs()).fold(0.0, f64::max);
        let unit = libm::exp2(libm::floor(libm::log2(largest)).max(-1000.0));
        let heaviest = sorted.iter().map(|s| s.weight).fold(0.0, f64::max);
        let value: Vec<f64> = sorted.iter().map(|s| s.value / unit).collect();
        let weight: Vec<f64> = sorted.iter().map(|s| s.weight / heaviest).collect();
        let total = value.iter().zip(&weight).map(|(v, q)| q * v * v).sum();
        let angles = 1 + sorted.windows(2).filter(|pair| pair[0].versine != pair[1].versine).count();
        Points {
            versine: sorted.iter().map(|s| s.versine).collect(),
            ln_cos: sorted.iter().map(|s| libm::log1p(-s.versine)).collect(),
            row: sorted.iter().map(|s| s.row).collect(),
            theta_deg: sorted.iter().map(|s| s.theta_deg).collect(),
            value,
            weight,
            unit,
            heaviest,
            weighting: samples.weighting,
            total,
            angles,
        }
    }

    /// Every so many-th in the order of the angles, at most `most`; `None` if there are no more than that.
    pub(super) fn thinned(&self, most: usize) -> Option<Points> {
        if self.len() <= most {
            return None;
        }
        let every = self.len().div_ceil(most);
        let of = |all: &[f64]| -> Vec<f64> { all.iter().step_by(every).copied().collect() };
        let (versine, value, weight) = (of(&self.versine), of(&self.value), of(&self.weight));
        Some(Points {
            total: value.iter().zip(&weight).map(|(v, q)| q * v * v).sum(),
            angles: 1 + versine.windows(2).filter(|pair| pair[0] != pair[1]).count(),
            ln_cos: of(&self.ln_cos),
            theta_deg: of(&self.theta_deg),
            row: self.row.iter().step_by(every).copied().collect(),
            versine,
            value,
            weight,
            ..*self
        })
    }

    pub(super) fn len(&self) -> usize {
        self.value.len()
    }

    /// (w, ln(1 - w), value, weight) of each.
    pub(super) fn iter(&self) -> impl Iterator<Item = (f64, f64, f64, f64)> + '_ {
        let angles = self.versine.iter().zip(&self.ln_cos);
        angles.zip(self.value.iter().zip(&self.weight)).map(|((w, l), (v, q))| (*w, *l, *v, *q))
    }

    /// The best scale under a lobe, and Σ q (v - a g)²: the scale is linear and drops out (variable projection).
    /// No lobe stands below 0.
    ///
    /// The sum is Σ q v² less what the lobe explains, which cancels to about 1e-16 Σ q v²: enough to search with,
    /// and what is printed is summed from the residuals.
    pub(super) fn project(&self, lobe: &Lobe) -> (f64, f64) {
        let (mut gg, mut gv) = (0.0, 0.0);
        for (w, l, v, q) in self.iter() {
            let g = lobe.value(w, l);
            gg += q * g * g;
            gv += q * g * v;
        }
        if gg > 0.0 && gv > 0.0 {
            (gv / gg, (self.total - gv * (gv / gg)).max(0.0))
        } else {
            (0.0, self.total)
        }
    }

    /// Σ q (v - a g)².
    pub(super) fn square(&self, scale: f64, lobe: &Lobe) -> f64 {
        let residual = |(w, l, v, q): (f64, f64, f64, f64)| {
            let r = v - scale * lobe.value(w, l);
            q * r * r
        };
        self.iter().map(residual).sum()
    }

    /// What rounding alone leaves of the sum: 4 ε of each value and of the lobe there.
    pub(super) fn rounding(&self) -> f64 {
        let unit = 4.0 * f64::EPSILON;
        unit * unit * self.total
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::measured::{Family, Shape, Unit};

    fn ten() -> Points {
        let rows: Vec<(f64, f64, f64)> =
            (0..10).map(f64::from).map(|i| (3.0 * i, 1.0 - 0.09 * i, 1.0 + i)).collect();
        Points::new(&Samples::new(Unit::Degrees, Weighting::Weight, &rows).unwrap())
    }

    /// Ten by fours at most: every third, with its own angle, value, weight and row.
    #[test]
    fn every_third_stands_for_all() {
        let all = ten();
        assert!(all.thinned(10).is_none() && all.thinned(11).is_none());
        let some = all.thinned(4).unwrap();
        assert_eq!(some.row, [1, 4, 7, 10]);
        let every: Vec<_> = all.iter().step_by(3).collect();
        assert_eq!(some.iter().collect::<Vec<_>>(), every);
        assert_eq!((some.len(), some.angles, some.unit, some.heaviest), (4, 4, all.unit, all.heaviest));
        assert_eq!(some.theta_deg, [0.0, 9.0, 18.0, 27.0]);
        let total: f64 = every.iter().map(|(_, _, v, q)| q * v * v).sum();
        assert_eq!(some.total, total);
    }

    /// Under a lobe that is 1 everywhere the best scale is the mean, and what is left the variance; below 0 no
    /// lobe stands.
    #[test]
    fn the_best_scale_is_a_mean() {
        let flat = Lobe::new(Family::CosN, 1e-12, Shape::default());
        let rows = |sign: f64| [(0.0, sign * 0.5, 1.0), (10.0, sign, 1.0), (20.0, sign * 0.75, 1.0)];
        let of = |sign| {
            let points = Points::new(&Samples::new(Unit::Degrees, Weighting::Equal, &rows(sign)).unwrap());
            (points.project(&flat), points.total, points.unit, points.rounding())
        };
        let ((scale, left), total, unit, rounding) = of(1.0);
        assert_eq!(unit, 1.0);
        assert!((scale - 0.75).abs() < 1e-9 && (left - 0.125).abs() < 1e-9, "{scale} {left}");
        // (4 ε)² = 2⁻¹⁰⁰ of ½² + 1² + ¾² = 29/16.
        assert_eq!(rounding, 29.0 / 16.0 * libm::exp2(-100.0));
        assert_eq!(of(-1.0).0, (0.0, total));
    }
}
