//! The families side by side.

use super::points::Points;
use super::{DataError, Doubt, Estimate, FEW_LEFT, Family, NoFit, Samples, Weighting};

/// What every family comes to on the same samples.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// By their BIC, the best first; of equal ones the cheapest first.
    pub estimates: Vec<Estimate>,
    /// Families without a fit.
    pub failures: Vec<(Family, NoFit)>,
    /// Samples of positive weight.
    pub counted: usize,
    /// Samples of weight 0.
    pub left_out: usize,
    /// Different angles among those counted.
    pub angles: usize,
    /// What is known of the noise.
    pub weighting: Weighting,
}

/// The difference of BIC up to which two fits are equally good: "not worth more than a bare mention" (Kass &
/// Raftery, JASA 90, 1995).
pub const INDISTINCT: f64 = 2.0;

impl Comparison {
    /// Fits the families to the samples, each by weighted least squares.
    ///
    /// The scale is linear and drops out; n is found by a scan of its range and argmin's Brent in the deepest
    /// valleys, a free bell's shape by argmin's simplex from four starts; Gauss-Newton steps by QR then settle all
    /// parameters to rounding. Sums run in the order of the angles: the rows' order changes nothing.
    ///
    /// # Errors
    /// [`DataError::NoFamily`] for no family, [`DataError::NoFit`] if none of them can be fitted, [`DataError::NoLobe`]
    /// if that is so of several because the values are below 0 rather than above.
    ///
    /// ```
    /// use bellfit::fit::measured::{Comparison, DataError, Family, Samples, Unit, Weighting};
    /// // 0.8 cos⁵⁰θ, rounded to three decimals
    /// let value = |degrees: f64| libm::round(800.0 * libm::pow(libm::cos(degrees.to_radians()), 50.0)) / 1000.0;
    /// let rows: Vec<_> = (0..30).map(f64::from).map(|degrees| (degrees, value(degrees), 1.0)).collect();
    /// let samples = Samples::new(Unit::Degrees, Weighting::Equal, &rows)?;
    /// let found = Comparison::of(&samples, &[Family::CosN, Family::Schlick])?;
    /// let best = found.best();
    /// let (lo, hi) = best.n_interval().unwrap();
    /// assert!(best.family == Family::CosN && lo < 50.0 && 50.0 < hi && hi - lo < 0.2);
    /// # Ok::<(), DataError>(())
    /// ```
    pub fn of(samples: &Samples, families: &[Family]) -> Result<Self, DataError> {
        let points = Points::new(samples);
        let (mut estimates, mut failures) = (Vec::new(), Vec::new());
        for (i, &family) in families.iter().enumerate() {
            if families[..i].contains(&family) {
                continue;
            }
            match Estimate::of(&points, family) {
                Ok(estimate) => estimates.push(estimate),
                Err(reason) => failures.push((family, reason)),
            }
        }
        if estimates.is_empty() {
            let below = failures.iter().filter(|(_, reason)| *reason == NoFit::NoLobe).count();
            return Err(match failures.first() {
                Some(_) if below > 1 => DataError::NoLobe,
                Some(&(family, reason)) => DataError::NoFit { family, reason },
                None => DataError::NoFamily,
            });
        }
        estimates.sort_by(|a, b| a.bic.total_cmp(&b.bic).then(price(a).cmp(&price(b))));
        let left_out = samples.all().len() - points.len();
        Ok(Comparison {
            estimates,
            failures,
            counted: points.len(),
            left_out,
            angles: points.angles,
            weighting: points.weighting,
        })
    }

    /// The estimate of the least BIC.
    pub fn best(&self) -> &Estimate {
        &self.estimates[0]
    }

    /// By how much an estimate's BIC exceeds the best one's.
    pub fn behind(&self, estimate: &Estimate) -> f64 {
        estimate.bic - self.best().bic
    }

    /// The best and those within [`INDISTINCT`] of it: the samples do not tell them apart.
    pub fn as_good(&self) -> impl Iterator<Item = &Estimate> {
        self.estimates.iter().filter(|estimate| self.behind(estimate) <= INDISTINCT)
    }

    /// Of [`Self::as_good`] the one with the fewest transcendentals, then divisions, then operations from cos θ; one
    /// whose parameters are known before one whose are not.
    pub fn cheapest(&self) -> &Estimate {
        let rank = |estimate: &&Estimate| (estimate.uncertainty.is_err(), price(estimate));
        self.as_good().min_by_key(rank).unwrap_or(self.best())
    }

    /// Why the best family is no final answer, whatever the others' BIC.
    ///
    /// ```
    /// use bellfit::fit::measured::{Comparison, DataError, Doubt, Family, Samples};
    /// // Five samples, two parameters: BIC is for many.
    /// let samples = Samples::parse(b"theta_deg,value\n0,0.8\n5,0.62\n10,0.33\n15,0.1\n20,0.03\n", None)?;
    /// let found = Comparison::of(&samples, &[Family::CosN, Family::Schlick])?;
    /// assert_eq!(found.doubts(), [Doubt::FewLeft { freedom: 3 }]);
    /// assert!(!found.is_told_apart());
    /// # Ok::<(), DataError>(())
    /// ```
    pub fn doubts(&self) -> Vec<Doubt> {
        let best = self.best();
        let freedom = self.estimates.iter().map(|estimate| estimate.freedom).min().unwrap_or(0);
        let few = self.estimates.len() > 1 && freedom <= FEW_LEFT;
        let few = few.then_some(Doubt::FewLeft { freedom });
        let unknown = best.uncertainty.as_ref().err().map(|&reason| Doubt::NotKnown(reason));
        let excess = best.goodness.filter(|goodness| goodness.is_excess()).map(|_| Doubt::Excess);
        [unknown, few, excess].into_iter().flatten().collect()
    }

    /// Whether the samples prefer the best family to every other that was fitted: each more than [`INDISTINCT`]
    /// behind, and no [doubt](Self::doubts).
    pub fn is_told_apart(&self) -> bool {
        self.estimates.len() > 1 && self.as_good().count() == 1 && self.doubts().is_empty()
    }
}

fn price(estimate: &Estimate) -> (u32, u32, u32, Family) {
    let cost = estimate.family.cost(estimate.n);
    (cost.transcendentals, cost.divisions, cost.operations, estimate.family)
}
