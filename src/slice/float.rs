//! The types of elements.

use super::route::Routes;
use crate::kernel::real::Real;

/// `f32` or `f64`, the elements of the slices; sealed.
///
/// ```
/// use bellfit::slice::{Bell, Float, bell_sum};
/// fn mass<F: Float>(t: &[F], weights: &[F]) -> F {
///     bell_sum(Bell::Lyon(4), t, weights).expect("slices of one length")
/// }
/// assert_eq!(mass(&[0.0_f32, 4.0], &[3.0, 5.0]), 3.0);
/// assert_eq!(mass(&[0.0_f64, 4.0], &[3.0, 5.0]), 3.0);
/// ```
pub trait Float: Real + Routes {}

impl Float for f32 {}
impl Float for f64 {}
