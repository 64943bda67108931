//! The words of files and of the command line, and what holds where nothing is said.

use super::EnergyDemand;
use crate::bound::Handed;

/// Where a relative error counts if nothing else is said: a display's step below the peak.
pub const FLOOR: f64 = 1.0 / 256.0;

/// The largest |∫ - 1| of what is called unbiased if nothing else is said.
pub const ENERGY_ERROR: f64 = 1e-3;

/// How the angle is handed over, as the command line and files name it.
///
/// ```
/// use bellfit::{bound::Handed, choose::handed_from_word};
/// assert_eq!(handed_from_word("cos"), Some(Handed::Cosine));
/// assert_eq!(handed_from_word("cosine"), None);
/// ```
pub fn handed_from_word(word: &str) -> Option<Handed> {
    match word {
        "cos" => Some(Handed::Cosine),
        "versine" => Some(Handed::Versine),
        "difference" => Some(Handed::Difference),
        _ => None,
    }
}

/// The word of [`handed_from_word`].
///
/// ```
/// use bellfit::{bound::Handed, choose::{handed_from_word, handed_word}};
/// assert!(Handed::ALL.iter().all(|handed| handed_from_word(handed_word(*handed)) == Some(*handed)));
/// ```
pub const fn handed_word(handed: Handed) -> &'static str {
    match handed {
        Handed::Cosine => "cos",
        Handed::Versine => "versine",
        Handed::Difference => "difference",
    }
}

/// The words of [`handed_from_word`].
pub const ANGLE_WORDS: [&str; 3] = ["cos", "versine", "difference"];

/// The demand of a name, with its error where it has one; `None` for an unknown name.
///
/// ```
/// use bellfit::choose::{EnergyDemand, energy_from_word};
/// assert_eq!(energy_from_word("never-gains", 1e-3), Some(EnergyDemand::NeverGains));
/// assert_eq!(energy_from_word("unbiased", 1e-3), Some(EnergyDemand::Unbiased { error: 1e-3 }));
/// ```
pub fn energy_from_word(word: &str, error: f64) -> Option<EnergyDemand> {
    match word {
        "never-gains" => Some(EnergyDemand::NeverGains),
        "unbiased" => Some(EnergyDemand::Unbiased { error }),
        _ => None,
    }
}

/// The words of [`energy_from_word`].
pub const ENERGY_WORDS: [&str; 2] = ["never-gains", "unbiased"];
