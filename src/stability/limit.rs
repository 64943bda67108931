//! Up to which exponent a kernel is good, from its rows.

use super::lobe::{LobeRow, meant_from};
use crate::bound::{Format, Handed};
use crate::kernel::stand_in::StandIn;

/// A display's step, 1/256.
pub const DISPLAY_STEP: f64 = 1.0 / 256.0;

/// The last exponents of the rows up to which rounding stays small.
///
/// From the first n for which the kernel is meant (16 for fitted bells, else 1), at every n of the rows: `None`
/// where that fails at the first already.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The kernel.
    pub stand_in: StandIn,
    /// Its format.
    pub format: Format,
    /// What is handed over.
    pub handed: Handed,
    /// The kernel's own distance from cosⁿ, the largest over the rows with n ≥ 16; 0 for cosⁿ itself.
    pub approximation: f64,
    /// Rounding below that distance; `None` for cosⁿ itself.
    pub below_approximation: Option<f64>,
    /// Rounding below [`DISPLAY_STEP`].
    pub below_display: Option<f64>,
}

/// The limits of each kernel, format and way of handing over in the rows, which rise in n.
///
/// ```
/// use bellfit::{bound::{Format, Handed}, kernel::stand_in::StandIn, stability::{angles, limits, lobe_rows}};
/// let rows: Vec<_> = [100.0, 1e5, 1e8].iter().flat_map(|n| lobe_rows(*n, &angles(*n))).collect();
/// let limits = limits(&rows);
/// let f32_cosine = limits.iter().find(|l| {
///     (l.stand_in, l.format, l.handed) == (StandIn::Cubic4, Format::Single, Handed::Cosine)
/// });
/// assert_eq!(f32_cosine.and_then(|l| l.below_approximation), Some(100.0));
/// ```
pub fn limits(rows: &[LobeRow]) -> Vec<Limit> {
    let mut found = Vec::new();
    for stand_in in StandIn::ALL {
        let own = || rows.iter().filter(move |row| row.stand_in == stand_in);
        let fitted = own().filter(|row| row.n >= 16.0).filter_map(|row| row.errors);
        let approximation = fitted.map(|errors| errors.approximation.value).fold(0.0, f64::max);
        for format in Format::ALL {
            for handed in Handed::ALL {
                let good_to = |limit: f64| {
                    let way = own().filter(|row| (row.format, row.handed) == (format, handed));
                    let meant = way.filter(|row| row.n >= meant_from(stand_in));
                    let good = |row: &&LobeRow| row.errors.is_some_and(|e| e.rounding.value <= limit);
                    meant.take_while(good).last().map(|row| row.n)
                };
                let below_approximation = if stand_in.is_exact() { None } else { good_to(approximation) };
                let below_display = good_to(DISPLAY_STEP);
                found.push(Limit {
                    stand_in,
                    format,
                    handed,
                    approximation,
                    below_approximation,
                    below_display,
                });
            }
        }
    }
    found
}
