//! The simplest form that can, in few digits; and which provably cannot.

use super::{Change, Remedy, RuledOut, SLACK, Search, TRIES};
use crate::fit::digits::{Decimal, round_to};
use crate::fit::exchange::{Optimum, levelled, lower_bound, minimax};
use crate::fit::{Exponents, Factor, FactorForm};
use crate::integral::ScaledIntegral;

/// Fewest and most significant digits tried.
const DIGITS: core::ops::RangeInclusive<usize> = 2..=12;

impl<I: ScaledIntegral + Clone> Search<'_, I> {
    /// The first form that holds, with those before it that cannot.
    pub(super) fn by_form(&self) -> (Option<Remedy>, Vec<RuledOut>) {
        let most = self.band.most_level();
        let mut ruled_out = Vec::new();
        for form in FactorForm::ALL {
            let Ok(best) = minimax(self.continuum, form) else { continue };
            let level = self.least_level(form, &best);
            if level > most {
                ruled_out.push(RuledOut { form, level, most });
            } else if let Some(remedy) = self.rounded(form, &best) {
                return (Some(remedy), ruled_out);
            }
        }
        (None, ruled_out)
    }

    /// A lower bound, certified, of the largest |residual| of any factor of the form.
    fn least_level(&self, form: FactorForm, best: &Optimum) -> f64 {
        let Exponents::Integers(from, to) = self.exponents else {
            return lower_bound(self.continuum, form, best);
        };
        // Over whole numbers: an alternation of whole numbers, levelled anew.
        let whole = |n: &f64| libm::round(*n).clamp(f64::from(from), f64::from(to));
        let mut at: Vec<f64> = best.alternation.iter().map(whole).collect();
        at.dedup();
        let parameters = if form == FactorForm::Ratio {
            Some(best.parameters.clone())
        } else {
            let reference: Vec<_> = at.iter().map(|n| self.continuum.at(1.0 / n)).collect();
            let enough = reference.len() == form.parameters() + 1;
            enough.then(|| levelled(self.continuum, &reference, form, 0.0)).flatten().map(|found| found.0)
        };
        parameters.map_or(0.0, |parameters| {
            lower_bound(self.continuum, form, &Optimum { parameters, level: best.level, alternation: at })
        })
    }

    /// The minimax form times what brings it into the band, rounded to ever more digits: p1.. to nearest, then
    /// p0 where doubles see the band kept.
    fn rounded(&self, form: FactorForm, best: &Optimum) -> Option<Remedy> {
        let (low, high) = self.band.ends();
        let (from, to) = ((1.0 + low) / (1.0 - best.level), (1.0 + high) / (1.0 + best.level));
        // Where the level is just as high as can be brought in, rounding may put the ends the wrong way round.
        let scale = 1.0_f64.min(to).max(from.min(to));
        let scaled = |(k, p): (usize, &f64)| if form == FactorForm::Ratio && k == 3 { *p } else { p * scale };
        let ideal: Vec<f64> = best.parameters.iter().enumerate().map(scaled).collect();
        let mut tries = 0;
        for digits in DIGITS {
            let mut texts: Vec<String> = ideal.iter().map(|p| round_to(*p, digits)).collect();
            for first in self.first_parameters(form, (&texts, ideal[0]), digits) {
                texts[0] = first;
                let factor = Factor::new(form, &texts, self.continuum.divisor)?;
                tries += 1;
                if let Some(extremes) = self.certified(factor.formula()) {
                    let source = factor.source();
                    return Some(Remedy { change: Change::Form { factor, digits }, source, extremes });
                }
            }
            if tries > TRIES {
                break;
            }
        }
        None
    }

    /// Decimals p0 with which the band is kept, the least |residual| first; at most two.
    fn first_parameters(
        &self,
        form: FactorForm,
        (texts, ideal): (&[String], f64),
        digits: usize,
    ) -> Vec<String> {
        let mut rest: Vec<f64> = texts.iter().map(|t| t.parse().unwrap_or(f64::NAN)).collect();
        rest[0] = 0.0;
        let (low, high) = self.allowed();
        let bent: Vec<f64> = self.samples.iter().map(|s| form.per_n(&rest, &s.m)).collect();
        let both = || self.samples.iter().zip(&bent);
        let least = both().map(|(s, bent)| low / s.g - bent).fold(f64::NEG_INFINITY, f64::max);
        let most = both().map(|(s, bent)| high / s.g - bent).fold(f64::INFINITY, f64::min);
        let worst = |p0: f64| both().map(|(s, bent)| (s.g * (p0 + bent) - 1.0).abs()).fold(0.0_f64, f64::max);
        // The middle of what is allowed is near the best only where both ends are asked for: from below every
        // factor is let in that is positive.
        let is_asked = low > -1.0 + SLACK && most.is_finite();
        let middle = if is_asked { 0.5 * (least + most) } else { ideal };
        let below = |x: f64| Decimal::floor(x, digits, i32::MAX).filter(|d| d.is_positive());
        let lattice = [most, middle].into_iter().filter(|x| x.is_finite()).filter_map(below);
        let mut found: Vec<(f64, String)> = lattice
            .flat_map(|d| [d.below(digits), d, d.above(digits)])
            .filter(|d| d.is_positive() && d.to_f64() >= least && d.to_f64() <= most)
            .map(|d| (worst(d.to_f64()), d.text()))
            .collect();
        found.sort_by(|x, y| x.0.total_cmp(&y.0).then_with(|| x.1.cmp(&y.1)));
        found.dedup();
        found.into_iter().take(2).map(|(_, text)| text).collect()
    }
}
