//! Numbers as text: constants in the digits of their format, bounds in few digits and rounded outward.

use crate::bound::Format;

/// The digits that a format needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Digits(pub Format);

impl Digits {
    /// The shortest decimal that reads back in the format as `value` rounded to it, with a point or an
    /// exponent.
    pub fn of(self, value: f64) -> String {
        match self.0 {
            Format::Half => shortest_half(half(value)),
            Format::HalfStored | Format::Single => format!("{:?}", value as f32),
            Format::Double => format!("{value:?}"),
        }
    }

    /// c₀ + m (c₁ + m c₂), leaving out what is 0; a sign goes into the operator, which changes no bit.
    pub fn series(self, [c0, c1, c2]: [f64; 3], m: &str) -> String {
        let (lead, sign) = (self.of(c0), if c1 < 0.0 { '-' } else { '+' });
        if c1 == 0.0 && c2 == 0.0 {
            return lead;
        }
        if c2 == 0.0 {
            return format!("{lead} {sign} {m} * {}", self.of(c1.abs()));
        }
        let inner = if (c1 < 0.0) == (c2 < 0.0) { '+' } else { '-' };
        format!("{lead} {sign} {m} * ({} {inner} {m} * {})", self.of(c1.abs()), self.of(c2.abs()))
    }

    /// ` + c` or ` - |c|`.
    pub fn added(self, c: f64) -> String {
        let sign = if c < 0.0 { '-' } else { '+' };
        format!(" {sign} {}", self.of(c.abs()))
    }
}

/// `value` rounded to binary16, ties to even; subnormal numbers kept, +∞ beyond 65520.
pub(super) fn half(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let exponent = libm::ilogb(value).max(-14) - 10;
    let rounded = libm::scalbn(libm::rint(libm::scalbn(value, -exponent)), exponent);
    if rounded.abs() > 65504.0 { f64::INFINITY.copysign(rounded) } else { rounded }
}

/// The shortest decimal that [`half`] takes to `value`.
fn shortest_half(value: f64) -> String {
    let reads_back = |text: &String| text.parse::<f64>().is_ok_and(|read| half(read) == value);
    let text = (0..5).map(|digits| format!("{value:.digits$e}")).find(reads_back);
    let shortest = text.and_then(|text| text.parse::<f64>().ok()).unwrap_or(value);
    format!("{shortest:?}")
}

/// A bound from above in five significant digits.
pub(super) fn upward(x: f64) -> String {
    outward(x, |read| read >= x)
}

/// A bound from below in five significant digits.
pub(super) fn downward(x: f64) -> String {
    outward(x, |read| read <= x)
}

/// The first of the nearest decimal and its neighbours that `bounds`.
fn outward(x: f64, bounds: impl Fn(f64) -> bool) -> String {
    if x == 0.0 {
        return "0".to_owned();
    }
    let unit = if is_plain(x) { 1e-4 } else { libm::exp10(libm::floor(libm::log10(x.abs())) - 4.0) };
    let texts = [0.0, 0.6, -0.6].map(|step| short(x + step * unit));
    texts.into_iter().find(|t| t.parse().is_ok_and(&bounds)).unwrap_or_else(|| format!("{x:?}"))
}

/// Whether [`short`] prints four decimals and no exponent.
fn is_plain(x: f64) -> bool {
    (1e-1..1e5).contains(&x.abs())
}

/// Five significant digits.
pub(super) fn short(x: f64) -> String {
    if x == 0.0 {
        "0".to_owned()
    } else if is_plain(x) {
        let text = format!("{x:.4}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{x:.4e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every positive binary16 by its definition, m 2^(e - 25) or subnormal.
    #[test]
    fn every_half_is_read_back_and_midpoints_go_to_even() {
        let of_bits = |bits: u32| {
            let (e, m) = ((bits >> 10) as i32, f64::from(bits & 1023));
            if e == 0 { libm::scalbn(m, -24) } else { libm::scalbn(1024.0 + m, e - 25) }
        };
        for bits in 0..0x7c00 {
            let value = of_bits(bits);
            assert_eq!(half(value), value);
            let text = Digits(Format::Half).of(value);
            assert_eq!(half(text.parse().unwrap()), value, "{text}");
            if bits > 0 {
                let even = if bits % 2 == 0 { value } else { of_bits(bits - 1) };
                assert_eq!(half(0.5 * (value + of_bits(bits - 1))), even, "{value}");
            }
        }
        assert_eq!((half(65519.0), half(65520.0)), (65504.0, f64::INFINITY));
        assert_eq!(Digits(Format::Half).of(0.1), "0.1");
    }

    #[test]
    fn printed_bounds_still_bound() {
        let mut x = 1e-12;
        while x < 1e8 {
            for x in [x, -x] {
                let (up, down): (f64, f64) = (upward(x).parse().unwrap(), downward(x).parse().unwrap());
                // Four decimals of 0.1 are coarsest, a thousandth on both sides together.
                assert!(down <= x && x <= up && up - down <= 1.3e-3 * x.abs(), "{x}: {down} {up}");
                assert!(upward(x).len() <= 11, "{x}: {}", upward(x));
            }
            x *= 1.0137;
        }
    }

    #[test]
    fn a_series_leaves_out_what_is_zero() {
        let text = |c| Digits(Format::Single).series(c, "m");
        assert_eq!(text([2.5, 0.0, 0.0]), "2.5");
        assert_eq!(text([2.5, -1.5, 0.0]), "2.5 - m * 1.5");
        assert_eq!(text([2.5, -1.5, 0.25]), "2.5 - m * (1.5 - m * 0.25)");
        assert_eq!(text([2.5, -1.5, -0.25]), "2.5 - m * (1.5 + m * 0.25)");
        assert_eq!(text([2.5, 0.0, 0.25]), "2.5 + m * (0.0 + m * 0.25)");
    }
}
