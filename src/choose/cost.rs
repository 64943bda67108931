//! What a value costs: measured, or counted.

use super::{Exponents, Need, NeedError};
use crate::bound::Format;
use crate::kernel::exact::Cost;
use crate::kernel::stand_in::StandIn;
use core::cmp::Ordering;

/// What a division and a transcendental cost, in operations.
///
/// The default is for vector code on a processor with wide units, measured there: a division takes as long
/// as 6 multiply-adds in `f32` (9 in `f64`), an exponential or a logarithm without branches as long as 10.
/// A call of the C library costs 100 and more; a graphics processor's own units 4 and less.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Of a division.
    pub division: f64,
    /// Of an exponential, logarithm or the like.
    pub transcendental: f64,
}

impl Default for Weights {
    fn default() -> Self {
        Weights { division: 6.0, transcendental: 10.0 }
    }
}

impl Weights {
    /// Whether both lie in their domain, [0, 1e6].
    ///
    /// # Errors
    /// [`NeedError::Weight`].
    ///
    /// ```
    /// use bellfit::choose::Weights;
    /// assert!(Weights::default().check().is_ok());
    /// assert!(Weights { division: -1.0, ..Weights::default() }.check().is_err());
    /// ```
    pub fn check(&self) -> Result<(), NeedError> {
        for (name, value) in [("division", self.division), ("transcendental", self.transcendental)] {
            if !(0.0..=1e6).contains(&value) {
                return Err(NeedError::Weight { name, value });
            }
        }
        Ok(())
    }

    /// Operations and what divisions and transcendentals are worth.
    ///
    /// ```
    /// use bellfit::{choose::Weights, kernel::exact::Cost};
    /// let cost = Cost { operations: 4, divisions: 1, transcendentals: 2 };
    /// assert_eq!(Weights { division: 6.0, transcendental: 10.0 }.sum(cost), 30.0);
    /// ```
    pub fn sum(&self, cost: Cost) -> f64 {
        f64::from(cost.operations)
            + self.division * f64::from(cost.divisions)
            + self.transcendental * f64::from(cost.transcendentals)
    }
}

/// A measured time of one value in nanoseconds, of what was measured.
pub type Measured<'a> = dyn Fn(StandIn, Format) -> Option<f64> + Sync + 'a;

/// How kernels are priced: by a record of measured times where there is one, else by their operations.
#[derive(Clone, Copy, Default)]
pub struct Costs<'a> {
    /// For what is counted.
    pub weights: Weights,
    /// A record of times.
    pub measured: Option<&'a Measured<'a>>,
}

/// What a value costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Price {
    /// Nanoseconds, from a record.
    Measured(f64),
    /// Weighted operations.
    Operations(f64),
}

impl Price {
    /// Cheaper first; what is measured comes before what a record does not have.
    ///
    /// ```
    /// use bellfit::choose::Price;
    /// assert!(Price::Operations(5.0).order(Price::Operations(6.0)).is_lt());
    /// assert!(Price::Measured(9.0).order(Price::Operations(6.0)).is_lt());
    /// ```
    pub fn order(self, other: Price) -> Ordering {
        match (self, other) {
            (Price::Measured(a), Price::Measured(b)) | (Price::Operations(a), Price::Operations(b)) => {
                a.total_cmp(&b)
            }
            (Price::Measured(_), Price::Operations(_)) => Ordering::Less,
            (Price::Operations(_), Price::Measured(_)) => Ordering::Greater,
        }
    }
}

impl Costs<'_> {
    /// The operations of a value, at the worst n of the range, and its price.
    pub(super) fn of(&self, stand_in: StandIn, need: &Need) -> (Cost, Price) {
        let cost = stand_in.cost(need.handed.argument(), worst(stand_in, need.n));
        let measured = self.measured.and_then(|measured| measured(stand_in, need.format));
        let measured = measured.filter(|time| *time > 0.0);
        (cost, measured.map_or_else(|| Price::Operations(self.weights.sum(cost)), Price::Measured))
    }
}

/// The n of the range at which a value takes most: of the squarings, whose cost is ⌊log₂ n⌋ and one for each
/// further binary one of n.
fn worst(stand_in: StandIn, n: Exponents) -> f64 {
    let (from, to) = (libm::ceil(n.from()) as u32, n.to() as u32);
    if stand_in != StandIn::Squarings || n.to() > f64::from(u32::MAX) || from > to {
        return n.to();
    }
    // An n < to has a 0 where `to` has its highest bit that differs, and is dearest with ones below it.
    let below = (0..32).filter(|bit| (to >> bit) & 1 == 1).map(|bit| (to & !(1 << bit)) | ((1 << bit) - 1));
    let dear = |n: &u32| (n.checked_ilog2(), n.count_ones());
    let count = |n: &u32| dear(n).0.unwrap_or(0) + dear(n).1;
    let all = below.filter(|n| *n >= from && *n > 0).chain([to]);
    f64::from(all.max_by_key(count).unwrap_or(to))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::stand_in::Argument;

    /// Against every n, one by one.
    #[test]
    fn the_worst_n_is_found() {
        let operations = |n: u32| StandIn::Squarings.cost(Argument::Cosine, f64::from(n)).operations;
        for from in 1..80 {
            for to in from..130 {
                let range = Exponents::new(f64::from(from), f64::from(to)).unwrap();
                let n = worst(StandIn::Squarings, range);
                assert!((f64::from(from)..=f64::from(to)).contains(&n), "{from}..{to}: {n}");
                let most = (from..=to).map(operations).max().unwrap();
                assert_eq!(operations(n as u32), most, "{from}..{to}");
            }
        }
    }
}
