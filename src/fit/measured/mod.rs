//! Lobes fitted to measured samples: scale, exponent and bell, with their uncertainty.
//!
//! [`Samples`] are angles and values, read from CSV with every error in its row and column; a [`Family`] is a lobe
//! g(θ; n) with g = 1 on its axis; [`Comparison::of`] fits scale · g by weighted nonlinear least squares and ranks the
//! families. Everything here is an estimate: it rests on the samples, and its errors on what [`Uncertainty`]
//! presumes of their noise.
//!
//! ```
//! use bellfit::fit::measured::{Comparison, DataError, EXAMPLE_DATA, Family, Samples};
//! let samples = Samples::parse(EXAMPLE_DATA.as_bytes(), None)?;
//! let found = Comparison::of(&samples, &Family::ALL)?;
//! let cos_n = found.estimates.iter().find(|estimate| estimate.family == Family::CosN).unwrap();
//! let (lo, hi) = cos_n.n_interval().unwrap();
//! assert!(lo < 60.0 && 60.0 < hi); // the example is 0.8 cos⁶⁰θ and noise of 0.01
//! # Ok::<(), DataError>(())
//! ```

mod chi_square;
mod column;
mod comparison;
mod doubt;
mod error;
mod estimate;
mod family;
mod free;
mod goodness;
mod lobe;
mod points;
mod polish;
mod samples;
mod search;
mod student;
mod trend;
mod triangle;
mod unit;

pub use chi_square::chi_square_tails;
pub use comparison::{Comparison, INDISTINCT};
pub use doubt::{Doubt, FEW_LEFT};
pub use error::DataError;
pub use estimate::{CONFIDENCE, Estimate, NoFit, NoUncertainty, Residual, Uncertainty};
pub use family::{Family, Shape};
pub use goodness::Goodness;
pub use samples::{Sample, Samples, Weighting};
pub use student::student_quantile;
pub use trend::{FEW_ANGLES, Trend};
pub use unit::Unit;

/// A commented file of samples to start from: 0.8 cos⁶⁰θ with Gaussian noise of 0.01, in thousandths.
pub const EXAMPLE_DATA: &str = include_str!("example.csv");
