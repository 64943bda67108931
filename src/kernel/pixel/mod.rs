//! Gaussian pixels: the footprint of a pixel in a texture, and the weights of the texels under it.
//!
//! A pixel is a bell over the screen. The mapping's [`Jacobian`] J turns the circle at its base into an
//! ellipse of texels, xᵀ M⁻¹ x ≤ 1 with M = J Jᵀ ([`Footprint`]); a texel's [`weight`](PixelWeight) is a
//! function of Q = xᵀ M⁻¹ x, 0 in the middle and 1 on the ellipse.
//!
//! Q has three forms: [`Footprint`] for inner loops, which loses as many digits as the ellipse's aspect has;
//! [`Inverse`], which loses none; and the paper's [`Conic`], which loses twice as many.
//!
//! | symbol in the pixel paper | here |
//! |---|---|
//! | (x, y), screen; (u, v), texture | arguments and values of [`Polygon`] |
//! | A1, B1, C1, A2, B2, C2, D, E, F of the polygon | the rows of [`Polygon`] |
//! | (Ux, Vx), (Uy, Vy), (1) | the fields of [`Jacobian`] |
//! | A, B, C, F, (2) | the fields of [`Conic`] |
//! | U, V | `u`, `v` from the footprint's middle, in texels |
//! | L, d, lengths of the axes | twice [`Axes::major`] and [`Axes::minor`] |
//! | α, tilt, (5) | [`Axes::tilt`]; as printed [`TiltFormula`] |
//! | f, (8) and (9) | [`PixelWeight`] |
//! | a rim texel's share: the area the ellipse cuts off | [`coverage`], [`half_plane`] |
//! | P(d), the volume beyond a line | [`clip_volume_paper`]; what it stands for [`clip_volume`], [`clip_volume_cut`]; refitted [`ClipPolynomial`] |
//!
//! **Radius or diameter.** With derivatives per pixel, Q = 1 is the image of the circle of radius 1 pixel.
//! The paper says base diameter 1, which is half of that: [`Jacobian::scaled`] by ½.

mod axes;
mod clip;
mod clip_polynomial;
mod conic;
mod coverage;
mod footprint;
mod inverse;
mod jacobian;
mod polygon;
mod skew;
mod weight;

pub use axes::{Axes, Frame, TiltFormula};
pub use clip::{CLIP_PRINTED, RADIUS, SIGMA, clip_volume, clip_volume_cut, clip_volume_paper};
pub use clip_polynomial::ClipPolynomial;
pub use conic::Conic;
pub use coverage::{Tangent, coverage, half_plane};
pub use footprint::{Footprint, Padding, Row};
pub use inverse::Inverse;
pub use jacobian::Jacobian;
pub use polygon::Polygon;
pub use skew::Skew;
pub use weight::{PaperReading, PixelWeight};
