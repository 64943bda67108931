//! Bell-shaped kernels of computer graphics, verified: specular lobes that stand for cosⁿ at the
//! price of a few multiplications, and Gaussian pixels, with proof of how far they are from it.
//!
//! Without default features the crate is [`kernel`] alone: `no_std`, no allocation, `libm` its one
//! dependency. With them it is the toolkit behind the `bellfit` program, whose parts use one
//! another in one direction only, left to right:
//!
//! ```text
//! kernel < slice < filter < integral < bound < fit < paper < verdict < scene < stability < trade < choose < shader < report < cli
//! ```
//!
//! ```
//! use bellfit::kernel::{factor::cs_16_factor, lobe::cs_16, model::Model};
//! // A normalised Blinn-Phong highlight: coef(n) · cs_16(N·H), n = 64, N·H = 0.99
//! let n = 64.0_f32;
//! let highlight = cs_16_factor(Model::BlinnPhong).at(n) * cs_16(0.99, n);
//! assert!(highlight > 1.0 && highlight < 1.5);
//! ```
#![cfg_attr(not(feature = "toolkit"), no_std)]

#[cfg(feature = "toolkit")]
pub mod bound;
#[cfg(feature = "toolkit")]
pub mod choose;
#[cfg(feature = "toolkit")]
pub mod cli;
#[cfg(feature = "toolkit")]
pub mod filter;
#[cfg(feature = "toolkit")]
pub mod fit;
#[cfg(feature = "toolkit")]
pub mod integral;
pub mod kernel;
#[cfg(feature = "toolkit")]
pub mod paper;
#[cfg(feature = "toolkit")]
pub mod report;
#[cfg(feature = "toolkit")]
pub mod scene;
#[cfg(feature = "toolkit")]
pub mod shader;
#[cfg(feature = "toolkit")]
pub mod slice;
#[cfg(feature = "toolkit")]
pub mod stability;
#[cfg(feature = "toolkit")]
pub mod trade;
#[cfg(feature = "toolkit")]
pub mod verdict;

/// The README's examples, compiled and run with the others; one of them needs the toolkit.
#[cfg(all(doctest, feature = "toolkit"))]
#[doc = include_str!("../README.md")]
struct Readme;
