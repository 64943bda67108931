//! n Int(n) over every real n of a range: sampled once, refined where an extreme lies.

use super::{FactorForm, Reals};
use crate::bound::{Interval, reciprocal};
use crate::integral::{Edge, ScaledIntegral};

/// Samples per doubling of n. The forms' residuals alternate a few times over the whole range, so
/// neighbouring extremes are many samples apart.
const PER_DOUBLING: f64 = 32.0;
/// Samples at least, however narrow the range.
const LEAST: f64 = 128.0;
/// Every so many samples the rounding is looked at.
const LOOK_EVERY: usize = 32;
/// Doublings after which the rest up to ∞ is one step in m.
const DOUBLINGS: f64 = 24.0;
/// Steps of golden section: 0.618^48 of two samples' distance is √ε of it and less.
const STEPS: u32 = 48;

/// A point of the range: n, m = 1/n and g = (2/divisor) n Int(n), so that residual = g form(n)/n - 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub m: f64,
    pub g: f64,
}

/// One integral over one range.
#[derive(Clone, Debug)]
pub(super) struct Continuum<'a, I> {
    pub integral: &'a I,
    pub reals: Reals,
    pub divisor: u32,
    /// By rising m.
    pub samples: Vec<Sample>,
    /// What rounding may do to g, relative.
    pub noise: f64,
}

impl<'a, I: ScaledIntegral> Continuum<'a, I> {
    pub(super) fn new(integral: &'a I, reals: Reals) -> Self {
        let divisor = integral.divisor();
        // Every sample is an n of the range: what is proved of one is proved of it.
        let (from, to) = reals.inward().unwrap_or((reals.from(), reals.to()));
        let last = to.min(from * libm::exp2(DOUBLINGS));
        let doublings = libm::log2(last / from);
        let steps = libm::ceil(doublings * PER_DOUBLING).max(LEAST);
        let n = |i: u32| from * libm::exp2(doublings * f64::from(i) / steps);
        let mut all: Vec<f64> = (0..steps as u32).map(n).map(|n| 1.0 / n.min(last)).collect();
        all.extend([1.0 / last, 1.0 / to]);
        all.reverse();
        all.dedup();
        let sample = |m: f64| Sample { m, g: g(integral, from, &m) };
        let samples: Vec<Sample> = all.into_iter().map(sample).collect();
        let looks = samples.iter().step_by(LOOK_EVERY).chain(samples.last());
        let width = |s: &Sample| {
            let enclosure = g(integral, from, &Interval::from(s.m));
            enclosure.width() / enclosure.lo()
        };
        let noise = looks.map(width).fold(0.0, f64::max);
        Continuum { integral, reals, divisor, samples, noise }
    }

    /// The sample at one m.
    pub(super) fn at(&self, m: f64) -> Sample {
        Sample { m, g: g(self.integral, self.reals.from(), &m) }
    }

    /// The n of a sample, inside the range.
    pub(super) fn n(&self, m: f64) -> f64 {
        let (from, to) = self.reals.inward().unwrap_or((self.reals.from(), self.reals.to()));
        (1.0 / m).clamp(from, to)
    }

    /// The residual of a form with these parameters.
    pub(super) fn residual(&self, form: FactorForm, p: &[f64]) -> impl Fn(Sample) -> f64 {
        move |s| form.per_n(p, &s.m) * s.g - 1.0
    }

    /// What rounding may do to that residual: narrow ranges have large parameters that cancel.
    pub(super) fn rounding(&self, form: FactorForm, p: &[f64]) -> f64 {
        let m = self.reals.in_m().1;
        let sizes: Vec<f64> = p.iter().map(|c| c.abs()).collect();
        let pole = if form == FactorForm::Ratio { (1.0 + p[3] * m).min(1.0) } else { 1.0 };
        let polynomial = if form == FactorForm::Ratio { FactorForm::Inverse } else { form };
        self.noise * polynomial.per_n(&sizes, &m) / pole
    }

    /// The residual at n of the form with exactly these doubles as parameters, enclosed.
    pub(super) fn enclosure(&self, form: FactorForm, p: &[f64], n: f64) -> Interval {
        let p: Vec<Interval> = p.iter().copied().map(Interval::from).collect();
        let m = reciprocal(Interval::from(n));
        form.per_n(&p, &m) * g(self.integral, self.reals.from(), &m) - Interval::from(1.0)
    }

    /// The largest f over the range, and where.
    pub(super) fn maximum(&self, f: impl Fn(Sample) -> f64) -> (Sample, f64) {
        let values: Vec<f64> = self.samples.iter().map(|&s| f(s)).collect();
        let top = (0..values.len()).fold(0, |top, i| if values[i] > values[top] { i } else { top });
        self.refined(top, &f)
    }

    /// The extreme of each run of equal sign, by rising m, beside the largest |f| of all.
    pub(super) fn alternating_extremes(&self, f: impl Fn(Sample) -> f64) -> Vec<(Sample, f64)> {
        let values: Vec<f64> = self.samples.iter().map(|&s| f(s)).collect();
        let mut tops: Vec<usize> = Vec::new();
        for i in 0..values.len() {
            match tops.last_mut() {
                Some(top) if (values[*top] < 0.0) == (values[i] < 0.0) => {
                    if values[i].abs() > values[*top].abs() {
                        *top = i;
                    }
                }
                _ => tops.push(i),
            }
        }
        let refine = |i: usize| {
            let sign = if values[i] < 0.0 { -1.0 } else { 1.0 };
            let (sample, value) = self.refined(i, &|s| sign * f(s));
            (sample, sign * value)
        };
        tops.into_iter().map(refine).collect()
    }

    /// The largest f between a sample's neighbours, by golden section.
    fn refined(&self, i: usize, f: &impl Fn(Sample) -> f64) -> (Sample, f64) {
        let lo = self.samples[i.saturating_sub(1)].m;
        let hi = self.samples[(i + 1).min(self.samples.len() - 1)].m;
        let m = golden_section((lo, hi), |m| -f(self.at(m)));
        let (sampled, found) = (self.samples[i], self.at(m));
        let (value, refined) = (f(sampled), f(found));
        if refined > value { (found, refined) } else { (sampled, value) }
    }
}

/// (2/divisor) n Int(n) at m = 1/n.
fn g<T: Edge>(integral: &impl ScaledIntegral, from: f64, m: &T) -> T {
    T::int(2) * integral.scaled_from(from, m) / T::int(i64::from(integral.divisor()))
}

/// Where f, falling and then rising, is smallest.
pub(in crate::fit) fn golden_section((mut lo, mut hi): (f64, f64), f: impl Fn(f64) -> f64) -> f64 {
    let inverse = 0.5 * (libm::sqrt(5.0) - 1.0);
    let (mut a, mut b) = (hi - inverse * (hi - lo), lo + inverse * (hi - lo));
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..STEPS {
        if at_a <= at_b {
            (hi, b, at_b) = (b, a, at_a);
            a = hi - inverse * (hi - lo);
            at_a = f(a);
        } else {
            (lo, a, at_a) = (a, b, at_b);
            b = lo + inverse * (hi - lo);
            at_b = f(b);
        }
    }
    0.5 * (lo + hi)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integral::{Case, Limit, Lobe};
    use crate::kernel::model::Model;

    #[test]
    fn samples_rise_from_end_to_end() {
        let case = Case { model: Model::BlinnPhong, lobe: Lobe::Cs16, limit: Limit::Support };
        for (from, to) in
            [(16.0, 1024.0), (1.0, 16.0), (16.0, f64::INFINITY), (16.25, 16.5), (16.0, 16.0_f64.next_up())]
        {
            let continuum = Continuum::new(&case, Reals::new(from, to).unwrap());
            let m: Vec<f64> = continuum.samples.iter().map(|s| s.m).collect();
            assert!(m.windows(2).all(|w| w[0] < w[1]), "{from}..{to}");
            assert_eq!((m[0], m[m.len() - 1]), (1.0 / to, 1.0 / from));
            assert!(continuum.noise > 0.0 && continuum.noise < 1e-11, "{}", continuum.noise);
        }
    }

    /// Phong (modified): g = (16/17)(1 - 8m/9), so m g is a parabola with its top at 9/16, and
    /// -(m - 1/30)² g has its top there.
    #[test]
    fn extremes_are_refined_between_samples() {
        let case = Case { model: Model::PhongModified, lobe: Lobe::Cs16, limit: Limit::Support };
        let continuum = Continuum::new(&case, Reals::new(16.0, 1024.0).unwrap());
        let (sample, value) = continuum.maximum(|s| -(s.m - 1.0 / 30.0) * (s.m - 1.0 / 30.0) * s.g);
        // A parabola is flat to rounding within √ε of its top's distance.
        assert!((sample.m - 1.0 / 30.0).abs() < 1e-9 && value.abs() < 1e-18);
        assert!((golden_section((0.0, 3.0), |x| (x - 1.25) * (x - 1.25)) - 1.25).abs() < 1e-7);
        let runs = continuum.alternating_extremes(|s| (s.m - 0.02) * (0.05 - s.m));
        let signs: Vec<bool> = runs.iter().map(|r| r.1 > 0.0).collect();
        assert_eq!(signs, [false, true, false]);
        assert!((runs[1].0.m - 0.035).abs() < 1e-8);
    }
}
