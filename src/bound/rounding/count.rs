//! What tests hold the bounds against: the rounding errors of a kernel's code counted by hand, in plain doubles and
//! at one n and one θ, where nothing is an interval.
//!
//! Operations hand errors on by the product rule, second order included; a result r gains half a unit in the
//! last place, u 2ᵏ for 2ᵏ < |r| ≤ 2ᵏ⁺¹, and where it may underflow half the least number.

use super::super::rounded::{Arithmetic, Rounded};
use super::super::{Format, Handed, Interval};
use super::cell::{Argument, Cell};

/// u and half the least number of binary16, binary32 and binary64 (IEEE 754, table 3.5); of binary64 the whole of
/// the least number, as half of it is none.
pub(super) fn unit_and_tiny(format: Format) -> (f64, f64) {
    match format {
        Format::Half => (libm::scalbn(1.0, -11), libm::scalbn(1.0, -25)),
        Format::HalfStored | Format::Single => (libm::scalbn(1.0, -24), libm::scalbn(1.0, -150)),
        Format::Double => (libm::scalbn(1.0, -53), libm::scalbn(1.0, -1074)),
    }
}

/// How results round.
#[derive(Clone, Copy)]
pub(super) struct Rounding {
    pub(super) unit: f64,
    pub(super) tiny: f64,
    /// Relative to each result: constants over a power of n, whose place among the powers of two is open.
    pub(super) relative: bool,
}

impl Rounding {
    pub(super) fn of(format: Format) -> Self {
        let (unit, tiny) = unit_and_tiny(format);
        Rounding { unit, tiny, relative: false }
    }

    pub(super) fn relative(self) -> Self {
        Rounding { relative: true, ..self }
    }

    fn half_unit(self, size: f64) -> f64 {
        if self.relative {
            self.unit * size
        } else {
            self.unit * libm::exp2(libm::ceil(libm::log2(size)) - 1.0)
        }
    }
}

/// A number and how far floating point may be from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Count {
    pub(super) value: f64,
    pub(super) error: f64,
}

impl Count {
    pub(super) fn new(value: f64, error: f64) -> Self {
        Count { value, error }
    }

    pub(super) fn exact(value: f64) -> Self {
        Count { value, error: 0.0 }
    }

    pub(super) fn negative(self) -> Self {
        Count { value: -self.value, ..self }
    }

    /// Rounded once more, as a number of at most the size `most`.
    pub(super) fn rounded(self, by: Rounding, most: f64) -> Self {
        let size = (self.value.abs() + self.error).min(most);
        Count { error: self.error + if size > 0.0 { by.half_unit(size) } else { 0.0 }, ..self }
    }

    pub(super) fn stored(self, by: Rounding) -> Self {
        let rounded = self.rounded(by, f64::INFINITY);
        Count { error: rounded.error + by.tiny, ..rounded }
    }

    pub(super) fn plus(self, rhs: Self, by: Rounding) -> Self {
        Count::new(self.value + rhs.value, self.error + rhs.error).rounded(by, f64::INFINITY)
    }

    pub(super) fn minus(self, rhs: Self, by: Rounding) -> Self {
        self.plus(rhs.negative(), by)
    }

    pub(super) fn times(self, rhs: Self, by: Rounding) -> Self {
        let (a, b) = (self.value.abs(), rhs.value.abs());
        let error = a * rhs.error + self.error * b + self.error * rhs.error;
        Count::new(self.value * rhs.value, error).stored(by)
    }

    /// The quotient, whose computed size is at most `most`.
    pub(super) fn over(self, rhs: Self, by: Rounding, most: f64) -> Self {
        let value = self.value / rhs.value;
        let error = (self.error + value.abs() * rhs.error) / (rhs.value.abs() - rhs.error);
        let rounded = Count { value, error }.rounded(by, most);
        Count { error: rounded.error + by.tiny, ..rounded }
    }

    /// Of a computed size of at most `most`.
    pub(super) fn squared(self, by: Rounding, most: f64) -> Self {
        let error = 2.0 * self.value.abs() * self.error + self.error * self.error;
        let rounded = Count::new(self.value * self.value, error).rounded(by, most * most);
        Count { error: rounded.error + by.tiny, ..rounded }
    }

    /// Whether the bound is this count, to a share of it (and steps of the least doubles), and its enclosure the value.
    pub(super) fn is_met(self, found: Rounded, share: f64) -> bool {
        let room = 1e-9 * self.value.abs() + 1e-13;
        found.error >= self.error * (1.0 - 1e-9)
            && found.error <= self.error * (1.0 + share + 1e-9) + 1e-300
            && found.value.lo() <= self.value + room
            && found.value.hi() >= self.value - room
            && found.value.width() <= room
    }
}

/// One n and one versine w.
pub(super) fn place(n: f64, w: f64) -> Cell {
    let point = Interval::from;
    Cell {
        n: point(n),
        m: point(1.0 / n),
        v: point(-n * libm::log1p(-w)),
        t: point(n * w),
        cosine: point(1.0 - w),
        versine: point(w),
    }
}

/// An argument there that is off by these errors: of cos θ and of w.
pub(super) fn handed(cell: &Cell, handed: Handed, [cosine, versine]: [f64; 2]) -> Argument {
    let off = |value: Interval, error: f64| Rounded { value, error };
    Argument {
        handed,
        cosine: off(cell.cosine, cosine),
        versine: off(cell.versine, versine),
        scaled: off(cell.t, cell.n.hi() * versine),
    }
}

#[test]
fn the_formats_units_are_those_of_the_standard() {
    for format in Format::ALL {
        let by = Arithmetic::of(format);
        assert_eq!((by.unit, by.tiny), unit_and_tiny(format), "{format:?}");
        assert_eq!(format.unit_roundoff(), by.unit);
    }
    let stored = Arithmetic::stored(Format::HalfStored);
    assert_eq!((stored.unit, stored.tiny), unit_and_tiny(Format::Half));
    // The largest numbers: (2 - 2u) 2¹⁵ and (2 - 2u) 2¹²⁷.
    assert_eq!(Arithmetic::of(Format::Half).largest, (2.0 - libm::scalbn(1.0, -10)) * libm::scalbn(1.0, 15));
    assert_eq!(
        Arithmetic::of(Format::Single).largest,
        (2.0 - libm::scalbn(1.0, -23)) * libm::scalbn(1.0, 127)
    );
    assert_eq!(Arithmetic::stored(Format::Single).unit, Arithmetic::of(Format::Single).unit);
}
