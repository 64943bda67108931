//! Fits of coef(n) = (a n + b)/(divisor π) to 2π coef(n) Int(n) = 1, by routes that check one
//! another: QR, exchange, a simplex search, and enclosures of the least-squares solution itself.

mod certified;
mod least_squares;
mod line;
mod minimax;
mod nearest;
mod nonlinear;
mod problem;
mod table;

pub use certified::{CertifiedFit, certified_least_squares, scaled_integrals};
pub use least_squares::least_squares;
pub use line::Line;
pub use minimax::{Minimax, minimax};
pub use nearest::{Nearest, nearest};
pub use nonlinear::simplex_search;
pub use problem::{FitError, Form, Objective, Problem};
pub use table::{FitRow, fit_case};
