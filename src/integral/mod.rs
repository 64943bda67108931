//! Int(n) of the six models by three routes that share no code, each with its own integrand:
//! closed forms, Gauss-Legendre in w = 1 - cos of the lobe's own angle, and double exponential
//! quadrature in θ through the public kernels.

pub mod albedo;

mod closed;
mod exponential;
mod field;
mod gauss;
mod limit;
mod routes;
mod scaled;

pub use closed::{closed_form, scaled_bell, scaled_closed_form, scaled_cos_n, scaled_versine};
pub use exponential::{Estimate, double_exponential};
pub use field::{Edge, Field};
pub use gauss::{GaussLegendre, GaussTable, gauss_legendre};
pub use limit::{Case, Limit, Lobe};
pub use routes::{AGREEMENT, Disagreement, Routes};
pub use scaled::ScaledIntegral;
