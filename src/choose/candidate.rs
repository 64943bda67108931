//! One kernel held against a need.

use super::energy::factors;
use super::witness::{Evidence, Witness, largest, theta};
use super::{Costs, Demand, EnergyDemand, Factor, Need, Price, Side};
use crate::bound::{Supremum, approximation, assumes_elementary, rounding_with};
use crate::kernel::exact::Cost;
use crate::kernel::stand_in::StandIn;

/// Why a kernel is not considered, whatever its error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exclusion {
    /// It divides.
    Divides,
    /// It takes an exponential, a logarithm or the like.
    Transcendental,
    /// It takes whole n within 32 bits alone, and others are asked for.
    WholeOnly,
}

impl Exclusion {
    /// In words.
    pub const fn reason(self) -> &'static str {
        match self {
            Exclusion::Divides => "it divides",
            Exclusion::Transcendental => "it takes an exponential or a logarithm",
            Exclusion::WholeOnly => "it takes whole n below 2^32 only, and the range has others",
        }
    }
}

/// How a kernel is known to fall short.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// An error above what is allowed, at this argument.
    Error(Witness),
    /// The best factor's energy is off by more than is allowed: by at least this much, at this n.
    Energy {
        /// Gained or lost.
        side: Side,
        /// Lower bound of |∫ - 1|.
        least: f64,
        /// Where.
        n: f64,
    },
    /// Energy is asked for, and there is no factor for it.
    NoFactor(String),
}

/// What a kernel comes to.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Everything that is asked is met, by enclosure.
    Qualifies,
    /// Something that is asked is not met.
    Fails(Failure),
    /// Nothing shows that it fails, and no enclosure that it does not: the bound exceeds what is allowed, or there
    /// is none.
    Unproved,
    /// Not considered.
    Excluded(Exclusion),
}

impl Verdict {
    /// `qualifies`, `fails`, `unproved` or `excluded`.
    pub const fn id(&self) -> &'static str {
        match self {
            Verdict::Qualifies => "qualifies",
            Verdict::Fails(_) => "fails",
            Verdict::Unproved => "unproved",
            Verdict::Excluded(_) => "excluded",
        }
    }
}

/// One kernel, priced and bounded.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Which.
    pub stand_in: StandIn,
    /// What a value takes at the worst n.
    pub cost: Cost,
    /// What that is worth.
    pub price: Price,
    /// sup of the distance from cosⁿ in exact arithmetic; at is (n, t), t = n (1 - cos θ).
    pub approximation: Option<Supremum<2>>,
    /// Bound of what rounding adds, likewise.
    pub rounding: Option<Supremum<2>>,
    /// Upper bound of the error, the sum of both; `None` where one of them has no bound.
    pub bound: Option<f64>,
    /// Whether the bound rests on the accuracy of the platform's elementary functions, as
    /// [`Need::ulps`](super::Need::ulps) states it: then it is not certified.
    pub assumes_elementary: bool,
    /// The largest error measured, in the format, at arguments where it is likely to be large.
    pub measured: Option<Witness>,
    /// Factors for the model, best first; those that meet the demand where there is one and it can be met.
    pub factors: Vec<Factor>,
    /// Why there is none, where a model is asked for.
    pub no_factor: Option<String>,
    /// The upshot.
    pub verdict: Verdict,
}

impl Candidate {
    /// `certified`, or `assumed` where the bound rests on elementary functions.
    pub const fn evidence(&self) -> &'static str {
        if self.assumes_elementary { "assumed" } else { "certified" }
    }

    /// Where the error's bound is taken: the argument (n, θ) of the larger of its two parts.
    ///
    /// ```
    /// use bellfit::{choose::{Costs, Need, choose}, kernel::stand_in::StandIn};
    /// let need = Need { only: Some(StandIn::Cs16), ..Need::new("16..64".parse()?, 0.02) };
    /// let answer = choose(&need, &Costs::default())?;
    /// // cs_16 is cosⁿ at n = 16 and farther from it the larger n is.
    /// assert!(answer.candidates[0].worst().is_some_and(|(n, _)| n > 50.0));
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn worst(&self) -> Option<(f64, f64)> {
        let (a, r) = (self.approximation?, self.rounding?);
        let [n, t] = if a.value.hi() >= r.value.hi() { a.at } else { r.at };
        Some((n, if n.is_finite() { theta(n, t) } else { 0.0 }))
    }

    /// What shows that its error is too large, where something does.
    pub fn witness(&self) -> Option<Witness> {
        match self.verdict {
            Verdict::Fails(Failure::Error(witness)) => Some(witness),
            _ => None,
        }
    }

    pub(super) fn new(stand_in: StandIn, need: &Need, costs: &Costs<'_>) -> Self {
        let (cost, price) = costs.of(stand_in, need);
        let n = if need.n.is_whole() { (need.n.from(), need.n.to()) } else { need.n.outward() };
        let mut candidate = Candidate {
            stand_in,
            cost,
            price,
            approximation: None,
            rounding: None,
            bound: None,
            assumes_elementary: assumes_elementary(stand_in),
            measured: None,
            factors: Vec::new(),
            no_factor: None,
            verdict: Verdict::Unproved,
        };
        if stand_in == StandIn::Squarings && (!need.n.is_whole() || need.n.to() > f64::from(u32::MAX)) {
            candidate.verdict = Verdict::Excluded(Exclusion::WholeOnly);
            return candidate;
        }
        candidate.approximation = approximation(stand_in, n, need.measure);
        candidate.rounding = rounding_with(stand_in, need.format, need.handed, n, need.measure, need.ulps);
        if let (Some(a), Some(r)) = (candidate.approximation, candidate.rounding) {
            candidate.bound = Some((a.value.hi() + r.value.hi()).next_up()).filter(|bound| bound.is_finite());
        }
        if let Some(model) = need.model {
            match factors(stand_in, model, need.n, need.format, need.energy) {
                Ok(factors) => candidate.factors = factors,
                Err(reason) => candidate.no_factor = Some(reason),
            }
        }
        candidate.measure(need);
        candidate.verdict = candidate.judge(need);
        candidate
    }

    /// Looks for errors near the bounds' arguments and all over the lobe.
    fn measure(&mut self, need: &Need) {
        let seeds: Vec<[f64; 2]> = [self.approximation, self.rounding]
            .iter()
            .flatten()
            .map(|s| s.at)
            .filter(|at| at[0].is_finite())
            .collect();
        self.measured = largest(self.stand_in, need.format, need.handed, need.n, need.measure, &seeds);
    }

    fn judge(&self, need: &Need) -> Verdict {
        if self.cost.divisions > 0 && !need.division {
            return Verdict::Excluded(Exclusion::Divides);
        }
        if self.cost.transcendentals > 0 && !need.transcendental {
            return Verdict::Excluded(Exclusion::Transcendental);
        }
        self.judge_error(need).or_else(|| self.judge_energy(need)).unwrap_or(Verdict::Qualifies)
    }

    /// Whether it would qualify but for what it is excluded for.
    pub(super) fn qualifies_but_for_exclusion(&self, need: &Need) -> bool {
        self.judge_error(need).or_else(|| self.judge_energy(need)).is_none()
    }

    /// `None` if the error is within what is allowed.
    fn judge_error(&self, need: &Need) -> Option<Verdict> {
        if self.bound.is_some_and(|bound| bound <= need.max_error) {
            return None;
        }
        if let (Some(a), Some(r)) = (self.approximation, self.rounding) {
            // The bound's range may reach one step beyond the one that is asked for: a witness may not.
            let n = a.at[0].clamp(need.n.from(), need.n.to());
            let inside =
                if n == a.at[0] { Some(a) } else { approximation(self.stand_in, (n, n), need.measure) };
            // What rounding cannot take back.
            let least = inside.map_or(0.0, |a| (a.value.lo() - r.value.hi()).next_down());
            if let Some(a) = inside.filter(|_| least > need.max_error && !self.assumes_elementary) {
                let witness =
                    Witness { n, theta: theta(n, a.at[1]), error: least, evidence: Evidence::Certified };
                return Some(Verdict::Fails(Failure::Error(witness)));
            }
        }
        match self.measured {
            Some(witness) if witness.error > need.max_error => Some(Verdict::Fails(Failure::Error(witness))),
            _ => Some(Verdict::Unproved),
        }
    }

    /// `None` if the energy is kept as is asked, or nothing is asked.
    fn judge_energy(&self, need: &Need) -> Option<Verdict> {
        let demand = need.energy?;
        if let Some(reason) = &self.no_factor {
            return Some(Verdict::Fails(Failure::NoFactor(reason.clone())));
        }
        if self.factors.iter().any(|factor| factor.meets(demand)) {
            return None;
        }
        let best = self.factors.first()?;
        let (gain, loss) = (best.residual.max, best.residual.min);
        let allowed = match demand {
            EnergyDemand::NeverGains => 0.0,
            EnergyDemand::Unbiased { error } => error,
        };
        // Rounding may go either way: only what the enclosure has beyond it is sure.
        if gain.value.lo() > allowed {
            return Some(Verdict::Fails(Failure::Energy {
                side: Side::Gain,
                least: gain.value.lo(),
                n: gain.n,
            }));
        }
        if -loss.value.hi() > allowed && demand != EnergyDemand::NeverGains {
            return Some(Verdict::Fails(Failure::Energy {
                side: Side::Loss,
                least: -loss.value.hi(),
                n: loss.n,
            }));
        }
        Some(Verdict::Unproved)
    }

    /// How far it is from what is asked: the larger of error and energy by what is allowed, 1 and less if met; `None`
    /// without a bound.
    pub(super) fn ratio(&self, need: &Need) -> Option<(Demand, f64, f64)> {
        let error = self.bound?;
        let of_error = (Demand::Error, error / need.max_error, error);
        let Some(EnergyDemand::Unbiased { error }) = need.energy else { return Some(of_error) };
        let bias = self.factors.first()?.bias().0;
        let of_energy = (Demand::Energy, bias / error, bias);
        Some(if of_error.1 >= of_energy.1 { of_error } else { of_energy })
    }
}
