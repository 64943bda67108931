//! Numbers as labels.

/// mantissa × 10^exponent, exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    pub(super) mantissa: i64,
    pub(super) exponent: i32,
}

impl Decimal {
    /// The nearest float: the decimal is read, not multiplied out.
    pub(super) fn value(self) -> f64 {
        format!("{}e{}", self.mantissa, self.exponent).parse().unwrap_or(f64::NAN)
    }

    fn sign(self) -> &'static str {
        if self.mantissa < 0 { "-" } else { "" }
    }

    /// `-0.05`, with the decimals that the exponent has.
    fn plain(self) -> String {
        if self.mantissa == 0 {
            return "0".into();
        }
        let digits = self.mantissa.unsigned_abs().to_string();
        let sign = self.sign();
        if self.exponent >= 0 {
            return format!("{sign}{digits}{}", "0".repeat(self.exponent as usize));
        }
        let places = self.exponent.unsigned_abs() as usize;
        let padded = format!("{digits:0>width$}", width = places + 1);
        let (whole, part) = padded.split_at(padded.len() - places);
        format!("{sign}{whole}.{part}")
    }

    /// `-5e-6`, `1.5e-5`, without trailing zeros.
    fn scientific(self) -> String {
        if self.mantissa == 0 {
            return "0".into();
        }
        let digits = self.mantissa.unsigned_abs().to_string();
        let exponent = i64::from(self.exponent) + digits.len() as i64 - 1;
        let (first, rest) = digits.split_at(1);
        let rest = rest.trim_end_matches('0');
        let point = if rest.is_empty() { "" } else { "." };
        let power = if exponent == 0 { String::new() } else { format!("e{exponent}") };
        format!("{}{first}{point}{rest}{power}", self.sign())
    }
}

/// The labels of one axis, all plain or all scientific, whichever reads better.
pub(super) fn labels(ticks: &[Decimal]) -> Vec<String> {
    let largest = ticks.iter().map(|t| t.value().abs()).fold(0.0, f64::max);
    let places = ticks.iter().filter(|t| t.mantissa != 0).map(|t| -t.exponent).max().unwrap_or(0);
    // Decades reach from short to long; steps of one size are long together, or not at all.
    let decades = ticks.iter().any(|t| t.mantissa != 0 && t.exponent != -places);
    let scientific = largest >= 1e6 || (places > 4 && (decades || largest < 0.01));
    ticks.iter().map(|t| if scientific { t.scientific() } else { t.plain() }).collect()
}

/// `2^k` as numbers where all are short, as powers where not.
pub(super) fn powers_of_two(exponents: &[i32]) -> Vec<String> {
    // From 0.0625 to 524288: six characters.
    let short = exponents.iter().all(|k| (-4..=19).contains(k));
    let number = |k: i32| libm::exp2(f64::from(k)).to_string();
    exponents.iter().map(|&k| if short { number(k) } else { format!("2{}", superscript(k)) }).collect()
}

fn superscript(k: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
    };
    k.to_string().chars().map(raise).collect()
}

#[cfg(test)]
mod tests {
    use super::{Decimal, labels, powers_of_two};

    fn of(mantissas: &[i64], exponent: i32) -> Vec<String> {
        let ticks: Vec<Decimal> = mantissas.iter().map(|&mantissa| Decimal { mantissa, exponent }).collect();
        labels(&ticks)
    }

    #[test]
    fn labels_are_short_and_alike() {
        assert_eq!(of(&[-5, 0, 5, 10], -3), ["-0.005", "0", "0.005", "0.010"]);
        assert_eq!(of(&[-5, 0, 5, 10, 15], -6), ["-5e-6", "0", "5e-6", "1e-5", "1.5e-5"]);
        assert_eq!(of(&[0, 2, 4], 2), ["0", "200", "400"]);
        assert_eq!(of(&[0, 5, 10], 5), ["0", "5e5", "1e6"]);
        let decades = [-5, -1, 0].map(|exponent| Decimal { mantissa: 1, exponent });
        assert_eq!(labels(&decades), ["1e-5", "1e-1", "1"]);
        assert_eq!(of(&[999_995, 1_000_000], -6), ["0.999995", "1.000000"]);
    }

    #[test]
    fn powers_of_two_stay_short() {
        assert_eq!(powers_of_two(&[-2, 0, 4, 10]), ["0.25", "1", "16", "1024"]);
        assert_eq!(powers_of_two(&[-10, 0]), ["2⁻¹⁰", "2⁰"]);
    }

    #[test]
    fn values_are_the_nearest_floats() {
        assert_eq!(Decimal { mantissa: 3, exponent: -1 }.value(), 0.3);
        assert_eq!(Decimal { mantissa: -7, exponent: 2 }.value(), -700.0);
    }
}
