//! Loops over slices, compiled for several vector units and chosen at run time.
//!
//! A [`Job`] is one `#[inline(always)]` body; [`Unit::run`] holds a copy of it compiled for each vector
//! unit. No copy fuses a multiply with an add, so every unit gives the same bits.

mod error;
mod lobe;
mod unit;

pub use error::LengthError;
pub use lobe::{Exponents, lobe, lobe_in_place, lobe_sum};
pub use unit::{Job, Unit};
