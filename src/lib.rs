//! Bell-shaped kernels of computer graphics, verified.
#![cfg_attr(not(feature = "toolkit"), no_std)]

#[cfg(feature = "toolkit")]
pub mod bound;
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
pub mod verdict;
