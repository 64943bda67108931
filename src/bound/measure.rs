//! How the distance of two lobes is measured.

/// What of two lobes' distance counts.
///
/// ```
/// use bellfit::bound::Measure;
/// assert!(Measure::Relative { floor: 1.0 / 256.0 }.is_valid() && !Measure::Relative { floor: 0.0 }.is_valid());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// |a - b|, for lobes that are 1 at their peak, over every angle in [0, π/2].
    Absolute,
    /// |a - b|/cosⁿ, where cosⁿ ≥ `floor` only.
    Relative {
        /// The least value of cosⁿ that counts, in (0, 1).
        floor: f64,
    },
}

impl Measure {
    /// Whether the floor, if there is one, lies in (0, 1).
    pub fn is_valid(self) -> bool {
        match self {
            Measure::Absolute => true,
            Measure::Relative { floor } => floor > 0.0 && floor < 1.0,
        }
    }
}
