//! Better bells: p(t)^K cut at the first zero of p, fitted to e⁻ᵗ over all t ≥ 0 and to cosⁿ for every
//! n from 16 on.
//!
//! e⁻ᵗ: a simplex search (argmin) finds the neighbourhood of the best p, an exchange polishes it until
//! its error equioscillates, the coefficients are rounded, and what was rounded is certified. cosⁿ:
//! its limit n → ∞ is e⁻ᵗ, so that fit's p is kept there and the coefficients' terms in 1/n are fitted
//! by weighted least squares whose weights grow where the error is large (Lawson).

mod cosine;
mod cost;
mod exchange;
mod exponential;
mod lawson;
mod shape;

pub use cosine::{CosineBell, cosine_bells};
pub use cost::{Cost, operations};
pub use exchange::{Polished, polish};
pub use exponential::{ExponentialBell, exponential_bells};
pub use shape::{Piece, Shape};
