//! Fits of coef(n) to 2π coef(n) Int(n) = 1.
//!
//! The papers' line (a n + b)/(divisor π) over the integers, by routes that check one another: QR,
//! exchange, a simplex search, and enclosures of the least-squares solution itself ([`fit_case`]). And
//! every [`FactorForm`] over every real n of a range, for any
//! [`ScaledIntegral`](crate::integral::ScaledIntegral), to both sides or never above 0 ([`fit_factor`]).
//!
//! Lobes themselves are fitted to measured samples in [`measured`].

pub mod bell;
pub mod clip;
pub mod measured;

mod band;
mod certified;
mod continuum;
mod digits;
mod exchange;
mod exponents;
mod factor;
mod factor_row;
mod form;
mod least_squares;
mod line;
mod mend;
mod minimax;
mod nearest;
mod nonlinear;
mod one_sided;
mod problem;
mod ratio;
mod reals;
mod shortest;
mod table;
mod weight;

pub use band::Band;
pub use certified::{CertifiedFit, certified_least_squares, scaled_integrals};
pub use exponents::Exponents;
pub use factor::Factor;
pub use factor_row::{DIGITS, FactorRow, SHORT_DIGITS, factor_rows, fit_factor};
pub use form::FactorForm;
pub use least_squares::least_squares;
pub use line::Line;
pub use mend::{Change, Mended, Remedy, RuledOut, mend};
pub use minimax::{Minimax, minimax};
pub use nearest::{Nearest, nearest};
pub use nonlinear::simplex_search;
pub use problem::{FitError, Form, Objective, Problem};
pub use reals::Reals;
pub use table::{FitRow, fit_case, one_sided_lines};
pub use weight::{
    FIGURE_AXES, TexelWeight, WeightError, WeightRow, figure_weights, pixel_weights, weight_name, weight_rows,
};
