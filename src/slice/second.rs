//! The second arguments of a kernel of two.

use super::lanes::Lanes;

/// Second arguments: one for all elements or one an element.
pub(super) trait Second<F>: Copy {
    /// That of the element at i.
    fn at(self, i: usize) -> F;

    /// Those of so many elements from one on.
    fn part(self, start: usize, length: usize) -> Self;
}

/// One for all.
#[derive(Clone, Copy)]
pub(super) struct Same<F>(pub F);

impl<F: Lanes> Second<F> for Same<F> {
    #[inline(always)]
    fn at(self, _: usize) -> F {
        self.0
    }

    #[inline(always)]
    fn part(self, _: usize, _: usize) -> Self {
        self
    }
}

impl<F: Lanes> Second<F> for &[F] {
    #[inline(always)]
    fn at(self, i: usize) -> F {
        self[i]
    }

    #[inline(always)]
    fn part(self, start: usize, length: usize) -> Self {
        &self[start..start + length]
    }
}
