//! Loops over slices, compiled for several vector units and chosen at run time.
//!
//! A [`Job`] is one `#[inline(always)]` body; [`Unit::run`] holds a copy of it compiled for each vector
//! unit. No copy fuses a multiply with an add, so every unit gives the same bits.

mod unit;

pub use unit::{Job, Unit};
