//! What is stated: claims as data, with every reading their typography allows. Nothing here is
//! derived, and nothing here judges.

mod claims;
mod fields;
mod kind;
mod lobe_fields;
mod normalisation;
mod normalisation_fields;
mod pixel_fields;
mod pixel_kind;
mod pixel_words;
mod printed;
mod raw;
pub mod schema;

pub use claims::{Claim, ClaimsError, ClaimsFile, Reading, parse_range};
pub use kind::{Comparison, CutForm, Kind, Over, Relation, Statistic};
pub use normalisation::{ClaimedLobe, Normalisation};
pub use pixel_kind::{ClipFormula, PixelKind, WeightFormula};
pub use pixel_words::{
    AxesProperty, Base, BellFigure, ClipProperty, ConstantTerm, Denominator, Octant, Region, RimShare, Shape,
    Sign, SignPair, Vectors, WeightFigure, WeightProperty,
};
pub use printed::Printed;

/// The lobe paper's claims.
pub const LOBE_PAPER: &str = include_str!("claims.toml");

/// The pixel paper's claims.
pub const PIXEL_PAPER: &str = include_str!("pixel.toml");

/// A commented claims file to start from.
pub const EXAMPLE: &str = include_str!("example.toml");
