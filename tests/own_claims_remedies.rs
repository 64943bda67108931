//! Constants of one's own that do not hold, mended by what holds when it is put back.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::bound::decimal;
use bellfit::fit::{Band, Change, Exponents, FactorForm, Line, Mended, mend};
use bellfit::integral::{Case, Limit, Lobe};
use bellfit::kernel::model::Model;
use bellfit::verdict::Verdict;
use own_claims::{one, parts, runner};
use proptest::prelude::*;
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

/// Whatever is named in the place of constants that do not hold is proved when it stands in the file.
#[test]
fn the_nearest_constants_hold_when_they_are_put_back() {
    let lobes = ["cos-n", "cs16", "cs4", "linear-8", "cubic-4", "polynomial"];
    let models = ["phong", "phong-modified", "blinn-phong", "blinn-phong-modified", "blinn-phong-ndf"];
    let demands = [
        "bound = \"2e-2\"",
        "energy = \"never-gains\"",
        "energy = \"never-gains\"\nloses-at-most = \"5e-2\"",
        "bound = \"1e-2\"\nenergy = \"never-gains\"",
        "bound = \"1e-6\"",
    ];
    let strategy = (
        0..lobes.len(),
        0..models.len(),
        0..demands.len(),
        900..1300_u32,
        0..60_u32,
        any::<bool>(),
        (0..3_u32, 0..5_usize),
    );
    let (mended, kinds, none) = (Cell::new(0), RefCell::new(BTreeSet::new()), Cell::new(0));
    runner(120)
        .run(&strategy, |(lobe, model, demand, slope, offset, whole, (form, range))| {
            let divisor = if models[model] == "blinn-phong" || models[model] == "blinn-phong-modified" { 8 } else { 2 };
            let line = format!("(1.{slope:04}*n + {}.{})/({divisor}*pi)", offset / 10, offset % 10);
            let factor = if form == 0 { format!("(1 + 1/n^2)*{line}") } else { line };
            let bell = if lobes[lobe] == "polynomial" {
                "\ncoefficients = [1, \"-0.9\", \"-0.125\"]\npower = \"8\""
            } else {
                ""
            };
            let over = if whole { "integers" } else { "reals" };
            let n = match range {
                0 | 1 => ["16..64", "100..5000"][range],
                2 if !whole => "16..inf",
                3 if !whole => "17.3..90.1",
                _ => "16..700",
            };
            let reading = |factor: &str| {
                format!(
                    "model = \"{}\"\nlobe = \"{}\"{bell}\nfactor = \"{factor}\"\nn = \"{n}\"\nover = \"{over}\"\n{}",
                    models[model], lobes[lobe], demands[demand]
                )
            };
            let found = one(&reading(&factor));
            let lost = -parts(&found).extremes.min.value.hi();
            let Some(found) = &parts(&found).mended else {
                prop_assert_eq!(found.verdict, Verdict::Proved);
                return Ok(());
            };
            let Some(remedy) = &found.remedy else {
                none.set(none.get() + 1);
                return Ok(());
            };
            mended.set(mended.get() + 1);
            kinds.borrow_mut().insert(remedy.change.id());
            let again = one(&reading(&remedy.source));
            prop_assert_eq!(again.verdict, Verdict::Proved, "{} {:?}", remedy.source, again);
            prop_assert_eq!(parts(&again).extremes, remedy.extremes);
            prop_assert!(parts(&again).mended.is_none());
            // Near, by whatever it was found: what is darker by half is no remedy of what is not.
            let loses = -remedy.extremes.min.value.lo();
            prop_assert!(loses <= lost.max(0.5), "{} loses {loses}, {factor} {lost}", remedy.source);
            if let Change::Digits { line, changed } = &remedy.change {
                let read = Line::from_formula(&factor.parse().unwrap()).unwrap();
                let differ = |a: &str, b: &str| a.bytes().zip(b.bytes()).filter(|(x, y)| x != y).count();
                prop_assert_eq!(differ(line.a(), read.a()) + differ(line.b(), read.b()), *changed);
            }
            Ok(())
        })
        .unwrap();
    let (mended, none, kinds) = (mended.get(), none.get(), kinds.into_inner());
    assert!(mended > 60 && none < 60, "{mended} mended, {none} not");
    assert_eq!(kinds.into_iter().collect::<Vec<_>>(), ["digits", "form", "multiple"]);
}

/// n Int = 16/17 - and nothing but n/1 - makes 1.0625 n the factor of cs_16 under Phong, so that a line with a
/// digit wrong has one remedy, and a factor that must be within 1e-9 of a curve none.
#[test]
fn remedies_are_those_of_mathematics() {
    let found = one(
        "model = \"phong\"\nlobe = \"cs16\"\nfactor = \"1.0725*n/(2*pi)\"\nn = \"16..inf\"\nbound = \"1e-9\"",
    );
    let mended = parts(&found).mended.as_ref().unwrap();
    let remedy = mended.remedy.as_ref().unwrap();
    assert_eq!((found.verdict, remedy.source.as_str()), (Verdict::Refuted, "1.0625*n/(2*pi)"));
    assert!(matches!(remedy.change, Change::Digits { changed: 1, .. }));
    let found = one(
        "model = \"blinn-phong\"\nlobe = \"cs16\"\nfactor = \"n/(8*pi)\"\nn = \"16..1024\"\nbound = \"1e-12\"",
    );
    let mended = parts(&found).mended.as_ref().unwrap();
    let forms: Vec<FactorForm> = mended.ruled_out.iter().map(|r| r.form).collect();
    assert!(mended.remedy.is_none() && forms == FactorForm::ALL, "{mended:?}");
    assert!(mended.ruled_out.iter().all(|r| r.level > r.most && r.most < 1.001e-12), "{mended:?}");
}

/// Under cosⁿ and Phong the exact factor is n + 1. (n + 90) is 16 to 17 at n = 16 for no b of two digits but 00;
/// (0 n + 10), which is below it, is all but black at n = 1024: 10/1025.
#[test]
fn what_loses_more_than_half_is_no_remedy() {
    let found = one(
        "model = \"phong\"\nlobe = \"cos-n\"\nfactor = \"(n + 90)/(2*pi)\"\nn = \"16..1024\"\nenergy = \"never-gains\"",
    );
    let remedy = parts(&found).mended.as_ref().unwrap().remedy.as_ref().unwrap();
    assert!(remedy.extremes.min.value.lo() >= -0.5, "{remedy:?}");
}

/// With nothing asked but that it never gains, a form that can be brought to the exact factor is: the middle
/// of what is allowed, down to 0, would be half of it. 3000/(2πn) is no line and no multiple of it does.
#[test]
fn a_form_that_never_gains_is_near_the_exact_factor() {
    for (model, divisor) in [("phong", 2), ("blinn-phong-modified", 8)] {
        let found = one(&format!(
            "model = \"{model}\"\nlobe = \"cos-n\"\nfactor = \"3000/({divisor}*pi*n)\"\nn = \"16..inf\"\nenergy = \"never-gains\""
        ));
        let remedy = parts(&found).mended.as_ref().unwrap().remedy.as_ref().unwrap();
        assert_eq!(found.verdict, Verdict::Refuted);
        // n/(n + 1) at n = 16, and n² (1 + h/n)/((n + 2)(n + 4)): the loss of p0 n with p0 = 1.
        assert_eq!(remedy.source, format!("n/({divisor}*pi)"));
    }
}

/// Phong over the support of cs_16, where Int is 16/(17 n): what is asked of (a n + b)/(2π) is asked of
/// 16/17 (a + b/n) - 1, which is a line in 1/n and has its extremes at the ends.
fn mended_phong(factor: &str, n: Exponents, band: &Band) -> Mended {
    let case = Case { model: Model::Phong, lobe: Lobe::Cs16, limit: Limit::Support };
    mend(&case, n, (&factor.parse().unwrap(), factor), band)
}

/// Every line of as many digits is tried in whole numbers: the remedy has the fewest changed, and of those with as
/// few it is the nearest to 1/Int.
#[test]
fn no_line_of_fewer_digits_changed_holds() {
    // a in thousandths, b in tenths, none with a zero at its end; the bound in ten-thousandths, if there is one.
    let (mut fewest, mut none) = (BTreeSet::new(), 0);
    for (a, b) in [(1125, 25), (1063, 9), (2003, 1), (903, 47), (1009, 13), (1411, 88), (317, 41), (4999, 99)]
    {
        for (bound, never_gains) in
            [(Some(203), false), (Some(617), false), (Some(207), true), (Some(611), true), (None, true)]
        {
            // 17000 n times the residual, whose ends are at n = 16 and 64.
            let residual = |a: i64, b: i64, n: i64| 16 * (a * n + 100 * b) - 17_000 * n;
            let ends = |a, b| [(16, residual(a, b, 16)), (64, residual(a, b, 64))];
            let holds = |a, b| {
                ends(a, b).into_iter().all(|(n, r)| {
                    let is_bounded = bound.is_none_or(|bound| r.abs() * 10_000 <= bound * 17_000 * n);
                    is_bounded && (!never_gains || r <= 0)
                })
            };
            let worst = |a, b| ends(a, b).into_iter().map(|(n, r)| r.abs() * (64 / n)).max().unwrap();
            // The largest loss over 17000 · 64, which is to stay below half, or below what the line loses.
            let loss = |a, b| ends(a, b).into_iter().map(|(n, r)| -r * (64 / n)).max().unwrap();
            let most = loss(a, b).max(17_000 * 32);
            if holds(a, b) {
                continue;
            }
            let changed = |x: i64, y: i64| {
                let differ = |p: i64| usize::from(x / p % 10 != y / p % 10);
                [1, 10, 100, 1000].map(differ).into_iter().sum::<usize>()
            };
            let all = (0..10_000_i64).flat_map(|x| (0..100_i64).map(move |y| (x, y)));
            let best = all
                .filter(|&(x, y)| holds(x, y) && loss(x, y) <= most)
                .map(|(x, y)| (changed(x, a) + changed(y, b), worst(x, y)))
                .filter(|(changed, _)| *changed <= 4)
                .min();
            let text = format!("({}.{:03}*n + {}.{})/(2*pi)", a / 1000, a % 1000, b / 10, b % 10);
            let decimal = |p: i64| decimal(&format!("0.{p:04}")).unwrap().0;
            let band = Band::new(bound.map(decimal).as_ref(), never_gains, None);
            for n in [Exponents::Integers(16, 64), Exponents::Reals("16..64".parse().unwrap())] {
                let found = mended_phong(&text, n, &band).remedy;
                let digits = found.and_then(|remedy| match remedy.change {
                    Change::Digits { line, changed } => Some((line, changed)),
                    _ => None,
                });
                let Some((fewest_changed, least)) = best else {
                    none += 1;
                    assert!(digits.is_none(), "{text} {bound:?} {never_gains}: {digits:?}");
                    continue;
                };
                let (line, changed) = digits.unwrap();
                let read = |text: &str| text.replace('.', "").parse::<i64>().unwrap();
                let (x, y) = (read(line.a()), read(line.b()));
                assert!(holds(x, y));
                assert_eq!(
                    (changed, worst(x, y)),
                    (fewest_changed, least),
                    "{text} {bound:?} {never_gains}: {line:?}"
                );
                fewest.insert(changed);
            }
        }
    }
    assert!(fewest.len() >= 3 && none < 20, "{fewest:?} {none}");
}

/// 17/16 (n + 1 + 1/n)/(2π) times any number is no line: 1 + residual is the number times 1 + m + m², which rises
/// in m = 1/n. Every decimal of a digit, of two, of three … is tried.
#[test]
fn no_multiple_of_fewer_digits_holds() {
    let (most, least) = (1.0 + 1.0 / 16.0 + 1.0 / 256.0, 1.0 + 1.0 / 64.0 + 1.0 / 4096.0);
    let mut digits_found = BTreeSet::new();
    for times in [1.3, 0.7, 3.1, 0.013, 1.07, 0.9] {
        for (bound, never_gains) in
            [(0.1_f64, false), (0.03, false), (0.0251, false), (0.11, true), (0.051, true)]
        {
            let factor = format!("{times}*1.0625*(n + 1 + 1/n)/(2*pi)");
            let (low, high) = (1.0 - bound, if never_gains { 1.0 } else { 1.0 + bound });
            let (from, to) = (low / (times * least), high / (times * most));
            if from <= 1.0 && 1.0 <= to {
                continue;
            }
            let of_digits = |digits: u32| {
                let scales = (-8..=4).map(|e| libm::pow(10.0, f64::from(e)));
                let all = scales.flat_map(|scale| (1..10_i32.pow(digits)).map(move |k| f64::from(k) * scale));
                let inside = all.filter(|x| (from..=to).contains(x));
                inside.min_by(|x, y| (x - 1.0).abs().total_cmp(&(y - 1.0).abs()))
            };
            let (digits, nearest) = (1..=5).find_map(|d| Some((d, of_digits(d)?))).unwrap();
            let band = Band::new(decimal(&bound.to_string()).map(|(b, _)| b).as_ref(), never_gains, None);
            for n in [Exponents::Integers(16, 64), Exponents::Reals("16..64".parse().unwrap())] {
                let remedy = mended_phong(&factor, n, &band).remedy.unwrap();
                let Change::Multiple { by } = &remedy.change else { panic!("{remedy:?}") };
                let by: f64 = by.parse().unwrap();
                assert!((by / nearest - 1.0).abs() < 1e-12, "{factor} {bound} {never_gains}: {by} {nearest}");
            }
            digits_found.insert(digits);
        }
    }
    assert!(digits_found.len() >= 2, "{digits_found:?}");
}
