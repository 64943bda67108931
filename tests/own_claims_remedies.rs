//! Constants of one's own that do not hold, mended by what holds when it is put back.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::fit::{Change, FactorForm, Line};
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
