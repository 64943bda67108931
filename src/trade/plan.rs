//! How much is measured.

use super::{Machine, TradeError};
use std::ops::RangeInclusive;

/// The exponents that can be measured: whole, as `powi` and squarings ask for, from where the bells'
/// formulas hold to where a cosine in `f32` still tells angles in the lobe apart.
pub const EXPONENTS: RangeInclusive<u32> = 16..=65_536;

/// Slices of this many bytes in memory, where the size of the last cache is not known.
const UNKNOWN: usize = 64 << 20;
/// More is not asked for, however large the last cache is.
const MOST: usize = 256 << 20;

/// What [`measure`](super::measure) is to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The specular exponent, in [`EXPONENTS`].
    pub n: u32,
    /// Rounds over all subjects, at least 1; nine or more for a median that one disturbance leaves alone.
    pub rounds: usize,
    /// Seconds that a sample of [`Single`](super::Place::Single) and [`Cache`](super::Place::Cache) takes at
    /// least; 0: one pass.
    pub sample: f64,
    /// Elements of the slice in cache and of the single calls, at least 1.
    pub elements: usize,
    /// Bytes of each of the two slices in memory, room for a window at least.
    pub memory: usize,
    /// Elements of those that one sample passes over, at least 1. Every sample takes the next window, so that
    /// all of both slices has passed through the caches before a window comes back.
    pub window: usize,
}

impl Plan {
    /// For a record: 101 rounds, half a minute or so. Samples are short, so that other work that takes the
    /// core away now and then meets few of them.
    ///
    /// The slices in memory have twice the bytes of the last-level cache each, 64 MiB where that is not known
    /// and 256 MiB at most.
    pub fn full(n: u32) -> Plan {
        let memory = Machine::this().cache.map_or(UNKNOWN, |cache| cache.saturating_mul(2).min(MOST));
        // Room for some windows on a machine of small caches.
        Plan { n, rounds: 101, sample: 5e-4, elements: 2048, memory: memory.max(UNKNOWN), window: 1 << 18 }
    }

    /// For a look: nine rounds, some seconds; the rest as [`full`](Self::full) has it.
    ///
    /// ```
    /// use bellfit::trade::Plan;
    /// let (quick, full) = (Plan::quick(64), Plan::full(64));
    /// assert!(quick.rounds == 9 && quick == Plan { rounds: 9, ..full });
    /// ```
    pub fn quick(n: u32) -> Plan {
        Plan { rounds: 9, ..Plan::full(n) }
    }

    /// Whether every number is in its domain.
    pub(super) fn check(&self) -> Result<(), TradeError> {
        if !EXPONENTS.contains(&self.n) {
            return Err(TradeError::Exponent { n: self.n });
        }
        let least = |name, value: usize, least: usize, domain| {
            if value >= least { Ok(()) } else { Err(TradeError::Plan { name, value: value as f64, domain }) }
        };
        least("rounds", self.rounds, 1, "1 or more")?;
        least("elements", self.elements, 1, "1 or more")?;
        least("window", self.window, 1, "1 or more")?;
        let bytes = self.window.saturating_mul(size_of::<f64>());
        least("memory", self.memory, bytes, "8 bytes or more for each element of a window")?;
        if self.sample >= 0.0 && self.sample <= 10.0 {
            Ok(())
        } else {
            Err(TradeError::Plan { name: "sample", value: self.sample, domain: "0 to 10 seconds" })
        }
    }
}
