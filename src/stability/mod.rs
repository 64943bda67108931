//! What rounding does to the kernels at the extremes: exponents to 10¹², angles to 10⁻⁸, ellipses of aspect
//! 10⁶, derivatives of 10^±20, in binary16, binary32 and binary64.
//!
//! Errors are measured against [`DoubleDouble`], about 100 bits, at sampled arguments: each is a lower bound of
//! the supremum, *sampled* and not certified; [`bound`](crate::bound) has bounds from above.

mod clip;
mod double_double;
mod exact;
mod factor;
mod footprint;
mod half;
mod limit;
mod lobe;
mod study;

pub use clip::{Clip, ClipError, clip_errors};
pub use double_double::DoubleDouble;
pub use exact::{Angle, fitted_bell, lyon_bell};
pub use factor::{Factor, FactorError, factor_errors};
pub use footprint::{FootprintError, QForm, exact_q, footprint_errors};
pub use half::Half;
pub use limit::{DISPLAY_STEP, Limit, limits};
pub use lobe::{LobeErrors, LobeRow, Peak, angles, exponents, lobe_rows};
pub use study::Stability;
