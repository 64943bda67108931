//! What is stated: claims as data, with every reading their typography allows. Nothing here is
//! derived, and nothing here judges.

mod claims;
mod fields;
mod kind;
mod printed;
mod raw;

pub use claims::{Claim, ClaimsError, ClaimsFile, Reading, parse_range};
pub use kind::{Comparison, CutForm, Kind, Over, Relation, Statistic};
pub use printed::Printed;

/// The lobe paper's claims.
pub const LOBE_PAPER: &str = include_str!("claims.toml");

/// A commented claims file to start from.
pub const EXAMPLE: &str = include_str!("example.toml");
