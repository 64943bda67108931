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

/// p₀ + p₁ d + p₂ d² + p₃ d³.
pub(crate) fn at([p0, p1, p2, p3]: [f64; 4], d: f64) -> f64 {
    p0 + d * (p1 + d * (p2 + d * p3))
}

/// p₀ to p₃ of P from the digits that the kernel has, [`CLIP_PRINTED`](crate::kernel::pixel::CLIP_PRINTED),
/// signs multiplied out; p₃ = 0. As the shortest decimals that read back they are the printed ones.
pub fn clip_printed() -> [f64; 4] {
    let [c0, c1, c2] = crate::kernel::pixel::CLIP_PRINTED;
    [c0, -c1, c2, 0.0]
}
