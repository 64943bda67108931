//! Decimals and ranges: read as written, accepted in their domain and nowhere else, refused by name.

use crate::holds;
use bellfit::bound::{decimal, exact, power_of_ten};
use bellfit::choose::{Exponents, NeedError};
use bellfit::fit::Reals;
use bellfit::integral::Field;
use bellfit::paper::{Printed, parse_range};
use dashu_ratio::RBig;
use proptest::prelude::*;

/// Texts of the characters that numbers and ranges are made of.
fn numeric() -> impl Strategy<Value = String> {
    let characters: Vec<char> = "0123456789.+-eEinfNa ½".chars().collect();
    proptest::collection::vec(proptest::sample::select(characters), 0..12)
        .prop_map(|c| c.into_iter().collect())
}

/// A sign, digits with at most one point, an exponent of at most 400: what a decimal is.
fn is_decimal(text: &str) -> bool {
    let (mantissa, exponent) = match text.find(['e', 'E']) {
        Some(at) => (&text[..at], Some(&text[at + 1..])),
        None => (text, None),
    };
    let digits = |text: &str| text.chars().all(|c| c.is_ascii_digit());
    let unsigned = |text: &str| text.strip_prefix(['+', '-']).unwrap_or(text).to_owned();
    let is_exponent = |text: &str| {
        let size = unsigned(text);
        !size.is_empty() && digits(&size) && size.parse::<u64>().is_ok_and(|size| size <= 400)
    };
    let mantissa = unsigned(mantissa);
    let parts: Vec<&str> = mantissa.split('.').collect();
    let is_mantissa =
        parts.len() <= 2 && parts.iter().all(|part| digits(part)) && mantissa.len() >= parts.len();
    is_mantissa && exponent.is_none_or(is_exponent)
}

#[test]
fn a_decimal_is_read_exactly_and_stands_for_what_prints_so() {
    let parts = (any::<bool>(), 0..u64::MAX, 0..20_usize, -300..300_i32);
    holds(1, 600, parts, |(negative, digits, behind, exponent)| {
        let all = format!("{digits:020}");
        let (whole, fraction) = all.split_at(20 - behind);
        let text = format!("{}{whole}.{fraction}e{exponent}", if negative { "-" } else { "" });
        let printed = Printed::parse(&text).unwrap();
        let places = behind as i32 - exponent;
        let unit = power_of_ten(-places);
        let size = RBig::from(dashu_int::IBig::from(digits)) * unit.clone();
        let value = if negative { RBig::int(0) - size } else { size };
        prop_assert_eq!(&printed.value, &value);
        prop_assert_eq!(decimal(&text), Some((value.clone(), places)));
        let half = unit / RBig::int(2);
        prop_assert_eq!(printed.lowest, value.clone() - half.clone());
        prop_assert_eq!(printed.highest, value + half);
        prop_assert_eq!(printed.text, text);
        Ok(())
    });
}

#[test]
fn a_text_is_a_decimal_or_it_is_refused() {
    holds(2, 4000, numeric(), |text| {
        prop_assert_eq!(Printed::parse(&text).is_some(), is_decimal(&text), "{}", text);
        Ok(())
    });
    // Extremes: no double and no memory is asked to hold them.
    for text in ["1e400", "-1e-400", "+0", "-0.0", &"9".repeat(400)] {
        assert!(Printed::parse(text).is_some(), "{text}");
    }
    for text in ["1e401", "1e-2147483648", "1e99999999999999999999", "NaN", "inf", "", &"9".repeat(401)] {
        assert!(Printed::parse(text).is_none(), "{text}");
    }
}

/// 0, 1, the limits and their neighbours among any whole numbers.
fn end() -> impl Strategy<Value = u64> {
    prop_oneof![0..100_u64, 65_530..65_540_u64, any::<u64>(), Just(u64::from(u32::MAX) + 1)]
}

#[test]
fn a_range_of_whole_n_is_accepted_in_its_domain_alone() {
    holds(3, 1500, (end(), end(), " {0,2}", " {0,2}"), |(a, b, left, right)| {
        let text = format!("{left}{a}{right}..{left}{b}{right}");
        match parse_range(&text) {
            Ok((from, to)) => {
                prop_assert!(1 <= a && a <= b && b <= 65_536, "{}", text);
                prop_assert_eq!((u64::from(from), u64::from(to)), (a, b));
                prop_assert_eq!(parse_range(&format!("{from}..{to}")), Ok((from, to)));
            }
            Err(error) => {
                prop_assert!(!(1 <= a && a <= b && b <= 65_536), "{}", text);
                prop_assert!(error.contains(&text) && error.contains("1 ≤ A ≤ B ≤ 65536"), "{}", error);
            }
        }
        Ok(())
    });
    holds(4, 3000, (numeric(), numeric()), |(a, b)| {
        for text in [format!("{a}..{b}"), a] {
            match parse_range(&text) {
                Ok((from, to)) => prop_assert!(1 <= from && from <= to && to <= 65_536),
                Err(error) => prop_assert!(error.contains(&text)),
            }
        }
        Ok(())
    });
}

/// Doubles of every kind, the limits of the ranges among them.
fn double() -> impl Strategy<Value = f64> {
    let special = [
        0.0,
        -0.0,
        0.5,
        1.0,
        1.0_f64.next_down(),
        16.0,
        65_536.0,
        1e12,
        1e12_f64.next_up(),
        f64::MAX,
        f64::MIN_POSITIVE,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        -16.0,
    ];
    prop_oneof![1.0..2000.0, proptest::sample::select(special.to_vec()), any::<f64>()]
}

#[test]
fn a_range_of_reals_is_printed_and_read_back() {
    holds(5, 2000, (double(), double()), |(from, to)| {
        let inside = from >= 1.0 && from < to;
        let made = Reals::new(from, to);
        prop_assert_eq!(made.is_ok(), inside);
        match made {
            Ok(range) => {
                let text = range.to_string();
                prop_assert_eq!(range.outward(), (from, to), "these very doubles");
                // Read, it is the decimals that were printed, to which these doubles are the nearest.
                let read = text.parse::<Reals>();
                prop_assert_eq!(text.replace("..", " .. ").parse::<Reals>(), read.clone());
                let read = read.unwrap();
                prop_assert_eq!((read.from(), read.to()), (from, to), "{}", text);
                let (low, high) = read.outward();
                prop_assert!(low <= from && to <= high && low >= from.next_down() && high <= to.next_up());
            }
            Err(error) => prop_assert!(error.to_string().contains(&format!("{from}..{to}")), "{}", error),
        }
        Ok(())
    });
    holds(6, 3000, (numeric(), numeric()), |(a, b)| {
        let text = format!("{a}..{b}");
        match text.parse::<Reals>() {
            Ok(range) => prop_assert!(range.from() >= 1.0 && range.from() < range.to()),
            Err(error) => prop_assert!(error.to_string().contains(&text), "{}", error),
        }
        Ok(())
    });
}

#[test]
fn exponents_are_printed_and_read_back() {
    holds(7, 2000, (double(), double()), |(from, to)| {
        let made = Exponents::new(from, to);
        prop_assert_eq!(made.is_ok(), 1.0 <= from && from <= to && to <= 1e12);
        match made {
            Ok(range) => {
                prop_assert_eq!(range.to_string().parse::<Exponents>(), Ok(range));
                if let Some(whole) = range.whole_only() {
                    prop_assert!(
                        from <= whole.from() && whole.from() - from < 1.0 && whole.from().fract() == 0.0
                    );
                    prop_assert!(whole.to() <= to && to - whole.to() < 1.0 && whole.to().fract() == 0.0);
                } else {
                    prop_assert!(from.ceil() > to.floor());
                }
            }
            Err(error) => prop_assert!(error.to_string().contains("1 ≤ A ≤ B ≤ 1e12"), "{}", error),
        }
        Ok(())
    });
    holds(8, 3000, numeric(), |text| {
        match text.parse::<Exponents>() {
            Ok(range) => prop_assert!(1.0 <= range.from() && range.to() <= 1e12),
            Err(error) => prop_assert!(error.to_string().contains(&text), "{}", error),
        }
        Ok(())
    });
}

/// The exponents lie around 2/α² - 2, computed in rationals, and hardly further.
#[test]
fn roughness_is_enclosed() {
    let roughness = prop_oneof![1e-6..0.8, double()];
    holds(9, 2000, (roughness, 1.0..1.5), |(alpha, ratio): (f64, f64)| {
        let to = alpha * ratio;
        let made = Exponents::of_roughness(alpha, to);
        prop_assert_eq!(&Exponents::parse_roughness(&format!("{alpha}..{to}")).ok(), &made.clone().ok());
        if !(0.0 < alpha && alpha <= to && to <= 1.0) {
            let refused = matches!(made, Err(NeedError::Roughness { .. }));
            prop_assert!(refused, "{}..{}", alpha, to);
            return Ok(());
        }
        let meant = |alpha: f64| {
            let alpha = exact(alpha).unwrap();
            RBig::int(2) / (alpha.clone() * alpha) - RBig::int(2)
        };
        match made {
            Ok(range) => {
                prop_assert!(
                    exact(range.from()).unwrap() <= meant(to) && meant(alpha) <= exact(range.to()).unwrap()
                );
                // n + 2 is off by the two ulps of α and its own.
                let near = |end: f64, alpha: f64| {
                    let n = meant(alpha).to_f64().value();
                    (end - n).abs() <= 16.0 * f64::EPSILON * (n + 2.0)
                };
                prop_assert!(near(range.from(), to) && near(range.to(), alpha));
            }
            Err(NeedError::TooRough { .. }) => prop_assert!(to > 0.8),
            Err(NeedError::TooSmooth { .. }) => prop_assert!(alpha < 1.5e-6),
            Err(error) => prop_assert!(false, "{}", error),
        }
        Ok(())
    });
}
