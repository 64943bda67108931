//! Bell-shaped kernels of computer graphics, verified: specular lobes that stand for cosⁿ at the price of a few
//! multiplications, and Gaussian pixels, with proof of how far each is from what it stands for.
//!
//! **The idea.** cosⁿ and the Gauss curve look alike near their top, and like a polynomial to a high power: (1 - t/K)^K
//! tends to e^-t. With K a power of two that power is log₂ K squarings; cut at its zero it is a *bell*, compact, never
//! negative, without `pow` or `exp`. What such a bell costs is plain. What it gets wrong is not: how far it is from
//! cosⁿ, whether a normalisation coef(n) printed beside it gains energy, up to which exponent it can be rounded. Two
//! papers answer with constants. This crate integrates, refits and judges them, proves bounds, and
//! hands out better kernels of the same cost.
//!
//! ```text
//! stated   paper ──────────────────────────────┐
//! so       kernel → integral → bound → fit ────┴→ verdict ┐
//! seen     kernel → slice → filter → scene ───────────────┼→ report
//! rounded  kernel → stability ────────────────────────────┘
//! taken    bound, trade → choose → shader: code to paste
//! ```
//!
//! A normalised highlight, six operations for the lobe:
//!
//! ```
//! use bellfit::kernel::{cubic::CubicLobe, factor::cubic_factor, lobe::cos_n, model::Model};
//!
//! let n = 64.0_f32; // specular exponent
//! let lobe = CubicLobe::<4, f32>::new(n); // once a material
//! let coef = cubic_factor::<4, f32>(Model::BlinnPhong, n); // never gains
//! let n_dot_h = 0.99;
//! let highlight = coef * lobe.at(n_dot_h);
//! assert!(highlight > 1.0);
//! // Proved at every angle and every real n from 16 on:
//! assert!((lobe.at(n_dot_h) - cos_n(n_dot_h, n)).abs() < 4.8e-4);
//! ```
//!
//! **Features.** `toolkit` (default): everything that integrates, fits, proves, plots or reads files, and the program.
//! Without it (`default-features = false`) the crate is [`kernel`] alone: `no_std`, no allocation, `libm` its one
//! dependency. Rust 1.89 or newer either way.
//!
//! A module uses those to its left only, and a test holds it to that:
//!
//! ```text
//! kernel < slice < filter < integral < bound < fit < paper < verdict < scene < stability < trade < choose < shader < report < cli
//! ```
//!
//! **Where to go.** The kernels: [`kernel`], whose table maps the papers' symbols.
#![cfg_attr(
    feature = "toolkit",
    doc = "Many at a time: [`slice`](mod@slice); textures: [`filter`]. A proof about a factor of your own: \
           [`bound::Residual`], or `bellfit verify FILE`, whose schema is [`paper`]'s. A fit to measured samples: [`fit`], or \
           `bellfit fit --data FILE`. The cheapest kernel that will do: [`choose`]; as code: [`shader`]. The program behind \
           all of it: `bellfit --help`."
)]
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
