//! Numbers as text: constants in the digits of their format.

use crate::bound::Format;
use crate::kernel::real::Real;
use crate::stability::Half;

/// The digits that a format needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Digits(pub Format);

impl Digits {
    /// The shortest decimal that reads back in the format as `value` rounded to it, with a point or an
    /// exponent.
    pub fn of(self, value: f64) -> String {
        match self.0 {
            Format::Half => shortest_half(value),
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

/// The shortest decimal that binary16 takes to what it takes `value` to.
fn shortest_half(value: f64) -> String {
    let half = |x: f64| Half::from_f64(x).to_f64();
    let value = half(value);
    let reads_back = |text: &String| text.parse::<f64>().is_ok_and(|read| half(read) == value);
    let text = (0..5).map(|digits| format!("{value:.digits$e}")).find(reads_back);
    let shortest = text.and_then(|text| text.parse::<f64>().ok()).unwrap_or(value);
    format!("{shortest:?}")
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
        let half = |x: f64| Half::from_f64(x).to_f64();
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
    fn a_series_leaves_out_what_is_zero() {
        let text = |c| Digits(Format::Single).series(c, "m");
        assert_eq!(text([2.5, 0.0, 0.0]), "2.5");
        assert_eq!(text([2.5, -1.5, 0.0]), "2.5 - m * 1.5");
        assert_eq!(text([2.5, -1.5, 0.25]), "2.5 - m * (1.5 - m * 0.25)");
        assert_eq!(text([2.5, -1.5, -0.25]), "2.5 - m * (1.5 + m * 0.25)");
        assert_eq!(text([2.5, 0.0, 0.25]), "2.5 + m * (0.0 + m * 0.25)");
    }
}
