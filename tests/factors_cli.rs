//! `bellfit fit` over every real n, as its user meets it.
#![cfg(feature = "toolkit")]

#[path = "support/program.rs"]
mod program;

use program::{bellfit, refused};
use std::process::Output;

fn fit(arguments: &str) -> Output {
    bellfit(&words(arguments))
}

fn words(arguments: &str) -> Vec<&str> {
    std::iter::once("fit").chain(arguments.split_whitespace()).collect()
}

fn stdout(arguments: &str) -> String {
    let output = fit(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

fn json(arguments: &str) -> serde_json::Value {
    serde_json::from_str(&stdout(&format!("{arguments} --json"))).expect("JSON")
}

/// Phong (modified) is (17/16)(n + 8/9 + (64/81)/(n - 8/9)) exactly.
#[test]
fn a_factor_over_reals_prints_what_it_certified() {
    let text = stdout("--model phong-modified --form ratio --n 16..inf");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("phong-modified, cs16, support, n = 16..inf, ratio, minimax"));
    assert!(lines.next().is_some_and(|l| l.starts_with("coef(n) = (1.0625 n + 0.9444444444")), "{text}");
    assert_eq!(lines.next(), Some("residual 2π coef(n) Int(n) - 1, certified over every real n:"));

    let inverse = json("--model phong-modified --form inverse");
    assert_eq!((&inverse["over"], &inverse["formula"]), (&"reals".into(), &"p0 n + p1 + p2/n".into()));
    assert_eq!(inverse["parameters"].as_array().map(Vec::len), Some(3));
    assert_eq!(inverse["alternation"].as_array().map(Vec::len), Some(4));
    let number = |key: &str| inverse[key].as_f64().expect("a number");
    assert!(number("optimum") <= number("max_residual").max(-number("min_residual")));

    let endless = json("--model phong-modified --over reals --n 20.5..inf");
    assert!(endless["n_to"].is_null() && endless["n_from"] == 20.5);
}

#[test]
fn one_sided_factors_say_that_they_gain_nothing() {
    let text = stdout("--model blinn-phong --objective one-sided-rounded --digits 3");
    assert!(text.contains("coef(n) = (1.06 n + 1.04)/(8π)") && text.contains("it gains nothing"), "{text}");
    // Four digits where none are given.
    assert_eq!(json("--model blinn-phong --objective one-sided-rounded")["digits"], 4);
    let row = json("--model blinn-phong --objective one-sided --form inverse-square --n 16.5..99.75");
    assert!(row["max_residual"].as_f64().is_some_and(|r| r <= 0.0), "{row}");
    // Phong's exact factor, known to be exact.
    let exact = json("--model phong --objective one-sided");
    assert_eq!((&exact["parameters"][0], &exact["max_residual"]), (&"1.0625".into(), &0.0.into()));
}

#[test]
fn a_line_over_integers_stays_the_default() {
    let over = |words: &str| json(&format!("--model blinn-phong {words}"))["n_at_max"].clone();
    assert_eq!(over("").as_f64(), Some(24.0));
    assert_eq!(over("--over integers").as_f64(), Some(24.0));
    assert_ne!(over("--over reals").as_f64(), Some(24.0));
}

#[test]
fn combinations_that_do_not_exist_are_named() {
    let told = |more: &str, names| refused(&words(&format!("--model phong {more}")), names);
    told("--objective one-sided --over integers", "one-sided holds for every real n");
    told("--form inverse --over integers", "the minimax inverse is fitted over every real n");
    told("--objective ls-relative --over reals", "ls-relative sums over whole n");
    told("--objective ls-relative --form ratio", "not linear in p3");
    told("--objective ls-absolute --form inverse --n 16..inf", "n = 16..inf: a sum runs over whole n");
    told("--objective one-sided-rounded --form ratio", "searched for linear and proportional");
    told("--objective one-sided-rounded --digits 12", "12 digits");
    told("--form cubic", "known are proportional, linear, inverse, inverse-square, ratio");
    told("--objective best", "minimax, one-sided, one-sided-rounded");
    told("--over rationals", "known are integers, reals");
    told("--n 16..inf", "real ends and inf need --over reals");
    for range in ["0.5..3", "3..2", "7..7", "inf..inf", "1e3..2e3", "NaN..3", "-1..5", "16"] {
        told(&format!("--over reals --n {range}"), "1 ≤ A < B, plain decimals; B may be inf");
    }
}
