//! Refits of the pixel paper's P(d) = 0.5 - d (2.151 - 2.358 d), the volume of a pixel of base diameter 1
//! beyond a line at distance d in [0, ½] from its centre.
//!
//! What the pixel is, how the polynomial was fitted, and what would be better: [`clip_rows`] is the table,
//! [`recipes`] the search for the printed digits.

mod exchange;
mod family;
mod recipe;
mod row;
mod squares;
mod target;

pub use family::{ClipFamily, Ending};
pub use recipe::{Recipe, SigmaRange, matching_sigmas, recipes};
pub use row::{ClipObjective, ClipRow, clip_rows};
pub use squares::{ClipPoints, clip_least_squares};
pub use target::{ClipPixel, ClipTarget};

/// p₀, p₁, p₂ of P as the pixel paper prints them, signs written out.
pub const CLIP_PRINTED: [&str; 3] = ["0.5", "-2.151", "2.358"];

/// p₀ + p₁ d + p₂ d² + p₃ d³.
pub(crate) fn at([p0, p1, p2, p3]: [f64; 4], d: f64) -> f64 {
    p0 + d * (p1 + d * (p2 + d * p3))
}

/// [`CLIP_PRINTED`] as doubles, p₃ = 0.
pub fn clip_printed() -> [f64; 4] {
    let mut p = [0.0; 4];
    for (p, text) in p.iter_mut().zip(CLIP_PRINTED) {
        *p = text.parse().unwrap_or(f64::NAN);
    }
    p
}
