//! Pixel weights over slices.

use super::route::{self, Function};
use super::{Float, LengthError, Unit};
use crate::kernel::pixel::PixelWeight;

/// `out[i] = weight(q[i])`, q the squared distance Q from the pixel's middle.
///
/// What [`PixelWeight::at`] gives for (q, 0): of a [product](PixelWeight::PaperProduct) the weight on one axis;
/// for both there is [`weight_of_two`]. Domain, ends and NaN as there; how near the two are, the
/// [module](super)'s.
///
/// # Errors
/// [`LengthError`] if `out` has another length; it is untouched then.
///
/// ```
/// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
/// use bellfit::slice::weight;
/// let mut out = [0.0_f32; 3];
/// weight(PixelWeight::Paper(PaperReading::R3), &[0.0, 1.0, 2.0], &mut out)?;
/// assert_eq!(out, [1.0, 0.00390625, 0.0]); // (1 - 1/2)^8
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight<F: Float>(weight: PixelWeight<F>, q: &[F], out: &mut [F]) -> Result<(), LengthError> {
    route::across(Unit::best, Function::Weight(weight), q, out)
}

/// [`weight`] in place.
///
/// ```
/// use bellfit::kernel::pixel::PixelWeight;
/// let mut q = [0.0, 2.0, f64::INFINITY];
/// bellfit::slice::weight_in_place(PixelWeight::Bell(2, 1.0), &mut q);
/// assert_eq!(q, [1.0, 0.25, 0.0]);
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight_in_place<F: Float>(weight: PixelWeight<F>, q: &mut [F]) {
    route::within(Unit::best, Function::Weight(weight), q);
}

/// `Σ weights[i] weight(q[i])`.
///
/// # Errors
/// [`LengthError`].
///
/// ```
/// use bellfit::kernel::pixel::PixelWeight;
/// let sum = bellfit::slice::weight_sum(PixelWeight::Bell(2, 1.0), &[0.0, 2.0], &[3.0, 8.0]);
/// assert_eq!(sum, Ok(5.0));
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight_sum<F: Float>(weight: PixelWeight<F>, q: &[F], weights: &[F]) -> Result<F, LengthError> {
    route::sum(Unit::best, Function::Weight(weight), q, weights)
}

/// `out[i] = weight(aa[i], bb[i])`, the squared coordinates along the two axes: what a
/// [product](PixelWeight::PaperProduct) needs, and any other weight takes.
///
/// # Errors
/// [`LengthError`] for slices of different lengths; `out` is untouched then.
///
/// ```
/// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
/// let weight = PixelWeight::PaperProduct(PaperReading::R3);
/// let mut out = [0.0_f64];
/// bellfit::slice::weight_of_two(weight, &[1.0], &[1.0], &mut out)?;
/// assert_eq!(out, [1.0 / 65536.0]); // (1 - 1/2)^8 twice
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight_of_two<F: Float>(
    weight: PixelWeight<F>,
    aa: &[F],
    bb: &[F],
    out: &mut [F],
) -> Result<(), LengthError> {
    Unit::best().weight_of_two(weight, aa, bb, out)
}

/// [`weight_of_two`] in place of `aa`.
///
/// # Errors
/// [`LengthError`]; `aa` is untouched then.
///
/// ```
/// use bellfit::kernel::pixel::{PaperReading, PixelWeight};
/// let mut aa = [1.0_f32, 0.0];
/// let weight = PixelWeight::PaperProduct(PaperReading::R3);
/// bellfit::slice::weight_of_two_in_place(weight, &mut aa, &[0.0, 2.0])?;
/// assert_eq!(aa, [0.00390625, 0.0]);
/// # Ok::<(), bellfit::slice::LengthError>(())
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight_of_two_in_place<F: Float>(
    weight: PixelWeight<F>,
    aa: &mut [F],
    bb: &[F],
) -> Result<(), LengthError> {
    Unit::best().weight_of_two_in_place(weight, aa, bb)
}

/// `Σ weights[i] weight(aa[i], bb[i])`.
///
/// # Errors
/// [`LengthError`].
///
/// ```
/// use bellfit::kernel::pixel::PixelWeight;
/// let sum = bellfit::slice::weight_of_two_sum(PixelWeight::Bell(2, 1.0), &[1.0], &[1.0], &[8.0]);
/// assert_eq!(sum, Ok(2.0)); // (1 - 1/2)² · 8
/// ```
#[inline(always)] // a slice of one must not cost a call more than the scalar
pub fn weight_of_two_sum<F: Float>(
    weight: PixelWeight<F>,
    aa: &[F],
    bb: &[F],
    weights: &[F],
) -> Result<F, LengthError> {
    Unit::best().weight_of_two_sum(weight, aa, bb, weights)
}

impl Unit {
    /// [`weight`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn weight<F: Float>(self, weight: PixelWeight<F>, q: &[F], out: &mut [F]) -> Result<(), LengthError> {
        route::across(|| self, Function::Weight(weight), q, out)
    }

    /// [`weight_in_place`] on this unit.
    #[inline]
    pub fn weight_in_place<F: Float>(self, weight: PixelWeight<F>, q: &mut [F]) {
        route::within(|| self, Function::Weight(weight), q);
    }

    /// [`weight_sum`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn weight_sum<F: Float>(
        self,
        weight: PixelWeight<F>,
        q: &[F],
        weights: &[F],
    ) -> Result<F, LengthError> {
        route::sum(|| self, Function::Weight(weight), q, weights)
    }

    /// [`weight_of_two`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn weight_of_two<F: Float>(
        self,
        weight: PixelWeight<F>,
        aa: &[F],
        bb: &[F],
        out: &mut [F],
    ) -> Result<(), LengthError> {
        LengthError::check("bb", bb.len(), aa.len())?;
        route::across(|| self, Function::Weights(weight, bb), aa, out)
    }

    /// [`weight_of_two_in_place`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn weight_of_two_in_place<F: Float>(
        self,
        weight: PixelWeight<F>,
        aa: &mut [F],
        bb: &[F],
    ) -> Result<(), LengthError> {
        LengthError::check("bb", bb.len(), aa.len())?;
        route::within(|| self, Function::Weights(weight, bb), aa);
        Ok(())
    }

    /// [`weight_of_two_sum`] on this unit.
    ///
    /// # Errors
    /// As there.
    #[inline]
    pub fn weight_of_two_sum<F: Float>(
        self,
        weight: PixelWeight<F>,
        aa: &[F],
        bb: &[F],
        weights: &[F],
    ) -> Result<F, LengthError> {
        LengthError::check("bb", bb.len(), aa.len())?;
        route::sum(|| self, Function::Weights(weight, bb), aa, weights)
    }
}
