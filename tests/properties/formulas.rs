//! Formulas: what is read has the value of what is written.

use crate::holds;
use bellfit::bound::{Formula, Polynomial, decimal};
use bellfit::integral::Field;
use dashu_ratio::RBig;
use proptest::prelude::*;

fn ratio(a: i64, b: i64) -> RBig {
    RBig::int(a) / RBig::int(b)
}

/// n, 2^(-n/2) and π for the test: independent as functions of n, so any numbers do.
fn places() -> [RBig; 3] {
    [ratio(7, 3), ratio(2, 11), ratio(22, 7)]
}

fn power(base: &RBig, k: u32) -> RBig {
    (0..k).fold(RBig::int(1), |p, _| p * base.clone())
}

fn of_polynomial(polynomial: &Polynomial) -> RBig {
    let at = places();
    polynomial.terms().fold(RBig::int(0), |sum, (exponents, c)| {
        sum + (0..3).fold(c.clone(), |term, i| term * power(&at[i], exponents[i]))
    })
}

/// A text with its value, `None` where it divides by 0.
type Meant = (String, Option<RBig>);

fn expression() -> impl Strategy<Value = Meant> {
    let [n, h, pi] = places();
    let number = (0..1000_u32, 0..100_u32).prop_map(|(whole, part)| {
        let text = format!("{whole}.{part:02}");
        (text.clone(), decimal(&text).map(|(value, _)| value))
    });
    let leaf = prop_oneof![
        number,
        Just(("n".to_owned(), Some(n))),
        Just(("pi".to_owned(), Some(pi.clone()))),
        Just(("π".to_owned(), Some(pi))),
        Just(("2^(-n/2)".to_owned(), Some(h))),
    ];
    leaf.prop_recursive(4, 12, 2, |inner| {
        prop_oneof![
            (inner.clone(), proptest::sample::select(vec!['+', '-', '*', '/']), inner.clone()).prop_map(
                |((a, x), sign, (b, y))| {
                    let value = x.zip(y).and_then(|(x, y)| match sign {
                        '+' => Some(x + y),
                        '-' => Some(x - y),
                        '*' => Some(x * y),
                        _ if y == RBig::int(0) => None,
                        _ => Some(x / y),
                    });
                    (format!("(({a}){sign}({b}))"), value)
                }
            ),
            (inner.clone(), 0..4_u32)
                .prop_map(|((a, x), k)| (format!("(({a})^{k})"), x.map(|x| power(&x, k)))),
            inner.prop_map(|(a, x)| (format!("(-({a}))"), x.map(|x| RBig::int(0) - x))),
        ]
    })
}

#[test]
fn a_formula_has_the_value_of_its_text() {
    holds(20, 500, expression(), |(text, value)| {
        let read = match text.parse::<Formula>() {
            Ok(read) => read,
            // Only for one of the two reasons that a well-formed text can have.
            Err(error) => {
                prop_assert!(
                    error.reason == "division by 0" || error.reason.contains("too large"),
                    "{}",
                    error
                );
                return Ok(());
            }
        };
        let (top, bottom) = (of_polynomial(&read.numerator), of_polynomial(&read.denominator));
        let Some(value) = value else {
            // A divisor that is 0 here need not be 0 as a function of n.
            return Ok(());
        };
        prop_assert_eq!(top, value * bottom, "{}", text);
        // White space between the tokens changes nothing.
        let mut spaced: String = text.replace("2^(-n/2)", "#");
        for mark in ["(", ")", "+", "-", "*", "/", "^", "n", "π"] {
            spaced = spaced.replace(mark, &format!(" {mark}\t"));
        }
        let spaced = spaced.replace('#', " 2 ^ ( - n / 2 ) ");
        prop_assert_eq!(spaced.parse::<Formula>(), Ok(read), "{}", spaced);
        Ok(())
    });
}

#[test]
fn any_text_is_read_or_refused_at_a_place_of_its_own() {
    let parts = [
        "n", "pi", "π", "2", "^", "(", ")", "+", "-", "*", "/", " ", "1.5", ".", "2^(-n/2)", "x", "½", "9e9",
        "0",
    ];
    let text =
        proptest::collection::vec(proptest::sample::select(parts.to_vec()), 0..24).prop_map(|p| p.concat());
    holds(21, 4000, text, |text| {
        match text.parse::<Formula>() {
            Ok(read) => prop_assert!(!read.denominator.is_zero()),
            Err(error) => {
                prop_assert_eq!(&error.text, &text);
                prop_assert!((1..=text.chars().count() + 1).contains(&error.position), "{}", error);
            }
        }
        Ok(())
    });
}

/// However long: an answer comes before it matters.
#[test]
fn long_texts_take_no_time_and_no_memory() {
    let start = std::time::Instant::now();
    let parts =
        ["(n+pi+2^(-n/2))", "1/(n+7)", "(n^32)", "(9^32)", "n", "(1/(pi+3.14159)^9)", "2^(-n/2)", "(n+1)^31"];
    let words = proptest::collection::vec((proptest::sample::select(parts.to_vec()), 0..4_usize), 1..200);
    holds(22, 150, words, |words| {
        let text: String =
            words.iter().map(|(part, sign)| format!("{part}{}", ["+", "*", "/", "-"][*sign])).collect();
        let text = format!("{text}1");
        if let Ok(read) = text.parse::<Formula>() {
            prop_assert!(read.numerator.terms().count() <= 256 && read.denominator.terms().count() <= 256);
        }
        Ok(())
    });
    for text in ["(".repeat(100_000), "n^".repeat(100_000), "1+".repeat(100_000), "-".repeat(100_000)] {
        assert!(text.parse::<Formula>().is_err());
    }
    // A second or so; what was mended took minutes.
    assert!(start.elapsed().as_secs() < 30, "{:?}", start.elapsed());
}
