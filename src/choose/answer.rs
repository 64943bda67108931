//! The kernels that qualify, cheapest first.

use super::{Candidate, Costs, Exclusion, Need, NeedError, Verdict};
use crate::kernel::stand_in::StandIn;

/// Which demand is missed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Demand {
    /// The error, rounding included.
    Error,
    /// The energy of lobe and factor.
    Energy,
    /// What a kernel may consist of.
    Exclusion(Exclusion),
}

/// The kernel that comes nearest where none qualifies.
#[derive(Clone, Debug, PartialEq)]
pub struct Miss {
    /// Which.
    pub stand_in: StandIn,
    /// What it misses.
    pub demand: Demand,
    /// Its bound by what is allowed, above 1 but for an exclusion.
    pub ratio: f64,
    /// Its bound.
    pub value: f64,
}

/// All kernels held against one need.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// What was asked.
    pub need: Need,
    /// Every kernel that was asked of, cheapest first; those of one price in the order of
    /// [`StandIn::ALL`].
    pub candidates: Vec<Candidate>,
}

impl Answer {
    /// Those that qualify, cheapest first.
    pub fn qualifying(&self) -> impl Iterator<Item = &Candidate> {
        self.candidates.iter().filter(|candidate| candidate.verdict == Verdict::Qualifies)
    }

    /// The cheapest that qualifies.
    pub fn best(&self) -> Option<&Candidate> {
        self.qualifying().next()
    }

    /// Those before the best, or all if there is none: why they do not do.
    pub fn cheaper(&self) -> &[Candidate] {
        let best = self.candidates.iter().position(|candidate| candidate.verdict == Verdict::Qualifies);
        &self.candidates[..best.unwrap_or(self.candidates.len())]
    }

    /// What comes nearest where none qualifies: the cheapest that would but for what it consists of, else the
    /// one whose bound is the least multiple of what is allowed. `None` if one qualifies, or if none has
    /// a bound.
    ///
    /// ```
    /// use bellfit::choose::{Costs, Demand, Need, choose};
    /// let need = Need { transcendental: false, division: false, ..Need::new("1000..1001".parse()?, 1e-9) };
    /// let answer = choose(&need, &Costs::default())?;
    /// assert!(answer.best().is_none());
    /// let miss = answer.nearest_miss().expect("bells have bounds");
    /// assert!(miss.ratio > 1.0 && miss.demand == Demand::Error);
    /// # Ok::<(), bellfit::choose::NeedError>(())
    /// ```
    pub fn nearest_miss(&self) -> Option<Miss> {
        if self.best().is_some() {
            return None;
        }
        let but_for = self.candidates.iter().find_map(|candidate| match candidate.verdict {
            Verdict::Excluded(exclusion) if candidate.qualifies_but_for_exclusion(&self.need) => {
                let value = candidate.bound?;
                let ratio = value / self.need.max_error;
                Some(Miss {
                    stand_in: candidate.stand_in,
                    demand: Demand::Exclusion(exclusion),
                    ratio,
                    value,
                })
            }
            _ => None,
        });
        let considered = self.candidates.iter().filter(|c| !matches!(c.verdict, Verdict::Excluded(_)));
        let misses = considered.filter_map(|candidate| {
            let (demand, ratio, value) = candidate.ratio(&self.need)?;
            // Within every number, and yet not qualified: there is no factor.
            let demand = if ratio <= 1.0 { Demand::Energy } else { demand };
            Some(Miss { stand_in: candidate.stand_in, demand, ratio, value })
        });
        but_for.or_else(|| misses.min_by(|a, b| a.ratio.total_cmp(&b.ratio)))
    }
}

/// Holds every [`StandIn`], or the one that is asked of, against a need.
///
/// Two calls with the same arguments give the same answer: nothing is timed here.
///
/// # Errors
/// [`NeedError`] for a number out of its domain.
///
/// ```
/// use bellfit::choose::{Costs, Need, Price, Verdict, choose};
/// let answer = choose(&Need::new("16..64".parse()?, 0.02), &Costs::default())?;
/// // Cheapest first, and each of them within the error.
/// let prices: Vec<Price> = answer.qualifying().map(|c| c.price).collect();
/// assert!(prices.is_sorted_by(|a, b| a.order(*b).is_le()));
/// assert!(answer.qualifying().all(|c| c.bound.is_some_and(|bound| bound <= 0.02)));
/// // What is cheaper than the best has a reason.
/// assert!(answer.cheaper().iter().all(|c| c.verdict != Verdict::Qualifies));
/// # Ok::<(), bellfit::choose::NeedError>(())
/// ```
pub fn choose(need: &Need, costs: &Costs<'_>) -> Result<Answer, NeedError> {
    need.check()?;
    costs.weights.check()?;
    let asked: Vec<StandIn> =
        StandIn::ALL.into_iter().filter(|s| need.only.is_none_or(|only| only == *s)).collect();
    // Threads that share nothing, so that their number changes nothing.
    let mut candidates: Vec<Candidate> = std::thread::scope(|scope| {
        let running: Vec<_> = asked
            .iter()
            .map(|&stand_in| scope.spawn(move || Candidate::new(stand_in, need, costs)))
            .collect();
        running.into_iter().map(|thread| thread.join().expect("bounds do not panic")).collect()
    });
    candidates.sort_by(|a, b| a.price.order(b.price));
    Ok(Answer { need: *need, candidates })
}
