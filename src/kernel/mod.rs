//! What a renderer copies: bells, lobes, BRDF models with their factors, and the vectors they need.
//!
//! `no_std`, no allocation, generic over `f32` and `f64` through [`real::Real`]; elementary functions
//! are those of `libm`, so a result has the same bits on every machine. Nothing here panics: arguments
//! outside a function's domain give the value its page states, mostly NaN.
//!
//! | symbol in the lobe paper | here |
//! |---|---|
//! | θ, the lobe's own angle; cos θ | `theta`; `cos` |
//! | 1 - cos θ (not named there) | `versine`, for angles so small that `1 - cos` cancels |
//! | n, specular exponent | `n` |
//! | cosⁿθ | [`lobe::cos_n`] |
//! | cs_16(n, θ), (1) | [`lobe::cs_16`]; with any cut, as printed: [`lobe::cs_16_cut`] |
//! | cr_n, the cut of (1) | [`lobe::cut_exact`], [`lobe::cut_paper`], [`lobe::cut_card`] |
//! | coef(n), Table 1 | [`factor::cos_n_factor`], [`factor::cs_16_factor_printed`], [`factor::cs_16_factor`] |
//! | 1/(2π Int(n)), what coef(n) stands for | [`exact::cs_factor`], [`exact::cs_16_factor_exact`] |
//! | the rows of Table 1 | [`model::Model`] |
//! | (1 - t/K)^K, Lyon's bell | [`bell::bell`] |
//! | L, N, V, R, H | unit vectors of [`vector`] |
//! | (not there) (1 - t/T)^K with the T that fits best | [`linear::LinearLobe`] |
//! | (not there) bells of degree three | [`cubic::cubic_bell`], [`cubic::CubicLobe`] |
//! | (not there) any of these, chosen at run time | [`stand_in::StandIn`] |
//! | (not there) the same with its constants of n rounded once | [`prepared::Prepared`] |
//! | (not there) L drawn for V, its density | [`sampling::sample`], [`sampling::pdf`] |
//! | k_a, k_d, k_s | the fields of [`shading::PhongLambert`] |
//!
//! The pixel paper's symbols: [`pixel`].

pub mod bell;
pub mod constants;
pub mod cubic;
pub mod exact;
pub mod factor;
pub mod linear;
pub mod lobe;
pub mod model;
pub mod pixel;
pub mod power;
pub mod prepared;
pub mod real;
pub mod sampling;
pub mod shading;
pub mod stand_in;
pub mod vector;
