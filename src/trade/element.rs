//! The two number formats that are timed.

use crate::bound::Format;
use crate::kernel::real::Real;
use crate::kernel::stand_in::{Argument, StandIn};
use crate::slice::{Exponents, lobe};

/// `f32` or `f64` with what a subject needs beyond [`Real`].
pub(super) trait Element: Real {
    const FORMAT: Format;
    /// Added to a small number it leaves that number, rounded to whole, in the last bits.
    const SHIFT: Self;

    /// The platform's.
    fn std_powf(self, n: Self) -> Self;
    /// The platform's.
    fn std_powi(self, n: i32) -> Self;
    /// The last bits of a number to which [`SHIFT`](Self::SHIFT) was added.
    fn low_bits(self) -> usize;
    /// The stand-in over a slice, from cosines.
    fn slice(stand_in: StandIn, n: u32, cosines: &[Self], out: &mut [Self]);
}

macro_rules! element {
    ($float:ident, $format:ident, $shift:literal) => {
        // Times and errors of the platform's own functions are what is asked for.
        #[allow(clippy::disallowed_methods)]
        impl Element for $float {
            const FORMAT: Format = Format::$format;
            const SHIFT: Self = $shift;

            #[inline(always)]
            fn std_powf(self, n: Self) -> Self {
                $float::powf(self, n)
            }
            #[inline(always)]
            fn std_powi(self, n: i32) -> Self {
                $float::powi(self, n)
            }
            #[inline(always)]
            fn low_bits(self) -> usize {
                self.to_bits() as u32 as usize
            }
            fn slice(stand_in: StandIn, n: u32, cosines: &[Self], out: &mut [Self]) {
                lobe(stand_in, Argument::Cosine, Exponents::One(n as $float), cosines, out)
                    .expect("both slices were cut to one length");
            }
        }
    };
}

// 1.5 2²³ and 1.5 2⁵², where the spacing of numbers is 1, and a little below them too.
element!(f32, Single, 12_582_912.0);
element!(f64, Double, 6_755_399_441_055_744.0);
