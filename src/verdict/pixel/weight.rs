//! The readings of the weight (9) against the Gaussian with σ = L/divisor, with Q = 1 on the ellipse.

use super::super::judgement::{Finding, Verdict};
use super::axis_by_sigma;
use crate::bound::{Interval, enclose, exact, scaled_bell_excess};
use crate::integral::Field;
use crate::kernel::pixel::PaperReading;
use crate::paper::{Region, Shape, WeightFigure, WeightFormula, WeightProperty};
use dashu_ratio::RBig;

/// Suprema are enclosed to this.
const TOLERANCE: f64 = 1e-9;
/// The power in (9).
const POWER: u32 = 8;

impl WeightFormula {
    /// c in (1 - c Q)^8.
    fn scale(&self) -> RBig {
        // Every reading's scale is a dyadic number.
        exact(self.reading.scale::<f64>()).unwrap_or(RBig::ONE)
    }

    /// The Gaussian is e^(-rate Q).
    fn rate(&self) -> RBig {
        axis_by_sigma(&self.divisor).power(2) / RBig::int(2)
    }

    /// Suprema of the Gaussian above the weight and of the weight above it, with their Q.
    ///
    /// A product lies between its values on an axis, (1 - c Q)^8, and on a diagonal, (1 - c Q/2)^16: with the
    /// sum of two factors given their product is least where one is largest and largest where they are
    /// equal. Every value between is taken, so of the distance from the Gaussian, which depends on Q alone,
    /// the supremum is at one of the two.
    fn excess(&self, region: Region) -> [(Interval, f64, &'static str); 2] {
        let (c, rate) = (enclose(&self.scale()), enclose(&self.rate()));
        let to = match region {
            Region::Ellipse => rate.hi(),
            Region::Plane => f64::INFINITY,
        };
        let [below, mut above] = scaled_bell_excess(POWER, c / rate, to, TOLERANCE);
        let mut at = "";
        if self.shape == Shape::Product {
            let half = c / rate / Interval::from(2.0);
            [_, above] = scaled_bell_excess(2 * POWER, half, to, TOLERANCE);
            at = " on a diagonal";
        }
        let q = |t: f64| t / rate.mid();
        let on_axis = if self.shape == Shape::Product { " on an axis" } else { "" };
        [(below.value, q(below.at[0]), on_axis), (above.value, q(above.at[0]), at)]
    }

    /// The larger of the two, with its place.
    fn distance(&self, region: Region) -> (Interval, String) {
        let [below, above] = self.excess(region);
        let (_, q, where_) = if below.0.lo() >= above.0.lo() { below } else { above };
        let side = if below.0.lo() >= above.0.lo() { "below" } else { "above" };
        (below.0.max(above.0), format!("{side} the Gaussian at Q = {q:.4}{where_}"))
    }

    /// Its volume by the whole Gaussian's, π/rate in units of the semi-axes; exact but for a factor 1/π.
    fn volume(&self, region: Region) -> (Interval, String) {
        let (c, rate) = (self.scale(), self.rate());
        let power = i64::from(POWER);
        let told = |value: RBig| {
            let text = value.to_string();
            let text =
                if text.len() <= 24 { format!("{text} exactly") } else { "a rational number".to_owned() };
            (enclose(&value), text)
        };
        match (self.shape, region) {
            // π ∫ (1 - c Q)^8 dQ = π/(9 c) [1 - (1 - c Q)^9].
            (Shape::Sum, Region::Plane) => told(rate / (c * RBig::int(power + 1))),
            (Shape::Sum, Region::Ellipse) => {
                let rim = (RBig::ONE - c.clone()).power(POWER + 1);
                told(rate * (RBig::ONE - rim) / (c * RBig::int(power + 1)))
            }
            // B(½, 9)²/c.
            (Shape::Product, Region::Plane) => {
                let beta = (1..=power).fold(RBig::int(2), |b, j| b * RBig::int(2 * j) / RBig::int(2 * j + 1));
                let value = rate * beta.power(2) / c;
                (enclose(&value) / Interval::PI, format!("{value}/π"))
            }
            // ∫ a^2i b^2j over the unit circle is π (2i)! (2j)!/(4^(i+j) i! j! (i+j+1)!), c ≤ 1.
            (Shape::Product, Region::Ellipse) => {
                let half = |i: i64| (0..i).fold(RBig::ONE, |h, k| h * RBig::int(2 * k + 1) / RBig::int(2));
                let factorial = |i: i64| (1..=i).fold(RBig::ONE, |f, k| f * RBig::int(k));
                let binomial = |i: i64| factorial(power) / (factorial(i) * factorial(power - i));
                let mut sum = RBig::ZERO;
                for i in 0..=power {
                    for j in 0..=power {
                        let term = binomial(i) * binomial(j) * half(i) * half(j) / factorial(i + j + 1);
                        sum += term * (RBig::ZERO - c.clone()).power((i + j) as u32);
                    }
                }
                told(rate * sum)
            }
        }
    }
}

pub(super) fn number(weight: &WeightFormula, figure: WeightFigure, region: Region) -> Finding {
    match figure {
        WeightFigure::Sup => {
            let (error, place) = weight.distance(region);
            Finding::figure(error, place)
        }
        WeightFigure::Volume => {
            let (volume, text) = weight.volume(region);
            Finding::figure(volume, text)
        }
    }
}

/// Weight - Gaussian at Q = 1: one number for a sum, a range for a product.
pub(super) fn on_rim(weight: &WeightFormula) -> Finding {
    let c = weight.scale();
    let gaussian = (-enclose(&weight.rate())).exp();
    let axis = (RBig::ONE - c.clone()).power(POWER);
    let range = match weight.shape {
        Shape::Sum => enclose(&axis),
        Shape::Product => enclose(&axis).hull(enclose(&(RBig::ONE - c / RBig::int(2)).power(2 * POWER))),
    };
    let witness = format!("there the weight is {}, the Gaussian {:.4e}", range_text(range), gaussian.mid());
    Finding::figure(range - gaussian, witness)
}

fn range_text(range: Interval) -> String {
    let one = |x: f64| if x == 0.0 { "0".to_owned() } else { format!("{x:.4e}") };
    if range.width() < 1e-12 {
        one(range.mid())
    } else {
        format!("{} on an axis to {} on a diagonal", one(range.lo()), one(range.hi()))
    }
}

pub(super) fn has(weight: &WeightFormula, property: WeightProperty) -> Finding {
    let (c, rate) = (weight.scale(), weight.rate());
    // Both shapes are 1 - 8 c Q + … in the middle, the Gaussian 1 - rate Q + ….
    let slope = RBig::int(i64::from(POWER)) * c.clone();
    let sigma = slope == rate;
    let told_sigma = format!(
        "in the middle the weight falls like {} Q, the Gaussian like {} Q",
        super::text(&slope),
        super::text(&rate)
    );
    // On the axis's end and on the diagonal, a² = b² = ½.
    let end = (RBig::ONE - c.clone()).power(POWER);
    let diagonal = match weight.shape {
        Shape::Sum => end.clone(),
        Shape::Product => (RBig::ONE - c / RBig::int(2)).power(2 * POWER),
    };
    let zero = end.is_zero() && diagonal.is_zero();
    let told_rim = if zero {
        "(1 - Q)^8 is 0 at Q = 1 and positive within".to_owned()
    } else if end.is_zero() {
        format!("at Q = 1 it is {diagonal} on a diagonal")
    } else {
        format!("at Q = 1 it is {:.4e} on an axis", enclose(&end).mid())
    };
    match property {
        WeightProperty::Sigma => Finding::truth(sigma, None, told_sigma),
        WeightProperty::ZeroOnRim => Finding::truth(zero, None, told_rim),
        WeightProperty::Both => Finding::truth(sigma && zero, None, format!("{told_sigma}; {told_rim}")),
        WeightProperty::Volume => {
            let (volume, text) = weight.volume(Region::Plane);
            let one = volume == Interval::from(1.0);
            let verdict = match (one, volume.contains(1.0)) {
                (true, _) => Verdict::Proved,
                (_, false) => Verdict::Refuted,
                _ => Verdict::Undecided,
            };
            Finding { printed: String::new(), computed: Some(volume), verdict, witness: text }
        }
    }
}

pub(super) fn is_nearest(weight: &WeightFormula, region: Region) -> Finding {
    let (own, _) = weight.distance(region);
    let others = PaperReading::ALL.into_iter().filter(|r| *r != weight.reading).map(|reading| {
        let other = WeightFormula { reading, ..weight.clone() };
        (other.distance(region).0, reading)
    });
    let others: Vec<_> = others.collect();
    let nearer = others.iter().find(|(other, _)| other.hi() < own.lo());
    let all_farther = others.iter().all(|(other, _)| other.lo() > own.hi());
    let list: Vec<String> =
        others.iter().map(|(e, reading)| format!("{reading:?} {:.4e}", e.mid())).collect();
    let verdict = match (nearer, all_farther) {
        (Some(_), _) => Verdict::Refuted,
        (None, true) => Verdict::Proved,
        (None, false) => Verdict::Undecided,
    };
    let witness = format!("{:.4e} here; {}", own.mid(), list.join(", "));
    Finding { printed: String::new(), computed: Some(own), verdict, witness }
}
