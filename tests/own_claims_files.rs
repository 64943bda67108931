//! Files of one's own constants: read without a panic whatever is in them, mistakes told.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::paper::{ClaimedLobe, ClaimsFile};
use bellfit::report::judgements_json;
use bellfit::verdict::Judge;
use own_claims::{file, runner};
use proptest::prelude::*;
use std::cell::Cell;

const SOUND: &str = "model = \"phong\"\nlobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"\n\
                     factor = \"n/(2*pi)\"\nn = \"16..64\"\nbound = \"1e-3\"\nenergy = \"never-gains\"\nloses-at-most = \"0.1\"";

/// One text exchanged for one with ¦ where the mistake is: told there, in one line, with value and domain.
#[track_caller]
fn assert_mistake(from: &str, to: &str, words: &[&str]) {
    let sound = file(&[SOUND.to_owned()]);
    assert!(ClaimsFile::parse(&sound).is_ok());
    assert_eq!(sound.matches(from).count(), 1, "{from}");
    let marked = sound.replace(from, to);
    let before = marked.split('¦').next().unwrap();
    let place = (before.matches('\n').count() + 1, before.rsplit('\n').next().unwrap().chars().count() + 1);
    let error = ClaimsFile::parse(&marked.replace('¦', "")).unwrap_err();
    assert_eq!((error.line, error.column), place, "{error}\n{marked}");
    for word in words {
        assert!(error.message.contains(word) && !error.message.contains('\n'), "{error}: no {word:?}");
    }
}

#[test]
fn mistakes_are_told_with_place_value_and_domain() {
    assert_mistake(
        "\"phong\"",
        "\"phong\"\nconvention = ¦\"ndf\"",
        &["phong", "ndf", "it has rdf, rdf-cosine"],
    );
    assert_mistake(
        "\"phong\"",
        "\"blinn-phong-ndf\"\nconvention = ¦\"heightfield\"",
        &["blinn-phong-ndf", "heightfield", "it has ndf"],
    );
    assert_mistake(
        "\"phong\"",
        "\"phong\"\nconvention = ¦\"brdf\"",
        &["brdf", "rdf, rdf-cosine, ndf, heightfield"],
    );
    assert_mistake(
        "lobe = \"polynomial\"",
        "lobe = ¦\"cs3\"",
        &["cs3", "cs64", "cubic-4, cubic-8, polynomial"],
    );
    // What the lobe has no use for.
    assert_mistake(
        "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"",
        "lobe = \"cs8\"\ncoefficients = ¦[1, \"-1\"]",
        &["no `coefficients`"],
    );
}

#[test]
fn mistakes_of_bells_are_told() {
    let coefficients = "[1, \"-1\"]";
    for (list, words) in [
        ("¦[1, 1]", &["no zero in 0 < y", "no end"][..]),
        ("¦[1, \"-1\", 1]", &["no zero"]),
        ("[¦2, -1]", &["begins with 2", "first coefficient is 1"]),
        ("¦[1]", &["degree 0", "1 to 4"]),
        ("¦[1, 0, 0, 0, 0, -1]", &["degree 5", "K = 16", "1 to 4"]),
        ("¦[1, \"-1e13\"]", &["1e13", "1e-12 to 1e12"]),
        ("[1, ¦\"minus one\"]", &["minus one", "not a decimal"]),
        ("[1, ¦-1.5]", &["in quotes", "exactly as printed"]),
        ("¦\"1, -1\"", &["sequence"]),
        ("¦[]", &["the list is empty", "begins with 1"]),
    ] {
        assert_mistake(coefficients, list, words);
    }
    let long = format!("[1, ¦\"-1.{}\"]", "3".repeat(40));
    assert_mistake(coefficients, &long, &["at most 30 characters"]);
    assert_mistake("power = \"16\"", "power = ¦\"12\"", &["power", "12", "1, 2, 4, 8, 16, 32, 64"]);
    assert_mistake(
        "kind = \"normalisation\"\nmodel = \"phong\"\nlobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\n",
        "kind = ¦\"normalisation\"\nmodel = \"phong\"\nlobe = \"polynomial\"\n",
        &["needs `coefficients`"],
    );
}

#[test]
fn mistakes_of_demands_and_ranges_are_told() {
    assert_mistake("bound = \"1e-3\"", "bound = ¦\"-1e-3\"", &["bound", "-1e-3", "0 or more"]);
    assert_mistake("bound = \"1e-3\"", "bound = ¦\"small\"", &["bound", "small", "not a decimal"]);
    assert_mistake("\"0.1\"", "¦\"1\"", &["loses-at-most", "\"1\"", "less than 1"]);
    assert_mistake("\"never-gains\"", "¦\"conserves\"", &["energy", "conserves", "never-gains"]);
    assert_mistake("energy = \"never-gains\"\nloses-at-most = ", "loses-at-most = ¦", &["beside `energy"]);
    assert_mistake(
        "kind = \"normalisation\"\nmodel = \"phong\"\nlobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"\n\
         factor = \"n/(2*pi)\"\nn = \"16..64\"\nbound = \"1e-3\"\nenergy = \"never-gains\"\nloses-at-most = \"0.1\"",
        "kind = ¦\"normalisation\"\nmodel = \"phong\"\nlobe = \"cos-n\"\nfactor = \"n\"\nn = \"16..64\"",
        &["needs `bound` or `energy`"],
    );
    for (bad, words) in [
        ("16", "1 ≤ A < B"),
        ("16..16", "`over = \"integers\"`"),
        ("0.5..3", "1 ≤ A < B"),
        ("inf..3", "1 ≤ A < B"),
    ] {
        assert_mistake("\"16..64\"", &format!("¦\"{bad}\""), &[bad, words]);
    }
    assert_mistake("\"16..64\"", "¦\"16..inf\"\nover = \"integers\"", &["16..inf", "1 ≤ A ≤ B ≤ 65536"]);
    assert_mistake(
        "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"\nfactor = \"n/(2*pi)\"\nn = \"16..64\"",
        "lobe = \"cubic-4\"\nfactor = \"n/(2*pi)\"\nn = ¦\"15.5..64\"",
        &["15.5..64", "cubic-4", "n ≥ 16"],
    );
    // The double nearest to this is 16.
    assert_mistake(
        "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"\nfactor = \"n/(2*pi)\"\nn = \"16..64\"",
        "lobe = \"cubic-4\"\nfactor = \"n/(2*pi)\"\nn = ¦\"15.9999999999999995..64\"",
        &["15.9999999999999995..64", "cubic-4", "n ≥ 16"],
    );
    assert_mistake(
        "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"",
        "lobe = \"cos-n\"\nlimit = ¦\"card\"",
        &["cos-n", "support only"],
    );
    let many: Vec<String> = (0..1025).map(|i| format!("\"w{i}\"")).collect();
    assert_mistake(
        "id = \"r0\"",
        &format!("id = \"r0\"\nlimit = ¦[{}]", many.join(", ")),
        &["more than 1024"],
    );
}

/// A word that is a number needs no quotes; one that is none stays a mistake.
#[test]
fn a_power_is_read_with_quotes_or_without() {
    let sound = file(&[SOUND.to_owned()]);
    let bare = sound.replace("power = \"16\"", "power = 16");
    assert_ne!(sound, bare);
    assert_eq!(ClaimsFile::parse(&sound), ClaimsFile::parse(&bare));
    let list = |list: &str| ClaimsFile::parse(&sound.replace("power = \"16\"", list)).unwrap();
    assert_eq!(list("power = [8, \"16\"]"), list("power = [\"8\", \"16\"]"));
    assert_mistake("power = \"16\"", "power = ¦12", &["power", "12", "1, 2, 4, 8, 16, 32, 64"]);
    assert_mistake("power = \"16\"", "power = ¦1.5", &["1.5"]);
}

/// Bytes of any kind, and texts that look like claims: a verdict or an error, and soon.
#[test]
fn any_bytes_are_read_or_refused() {
    let bytes = prop::collection::vec(any::<u8>(), 0..300);
    runner(300)
        .run(&bytes, |bytes| {
            if let Err(error) = ClaimsFile::parse(&String::from_utf8_lossy(&bytes)) {
                prop_assert!(error.line >= 1 && error.column >= 1 && !error.message.contains('\n'));
            }
            Ok(())
        })
        .unwrap();
}

#[test]
fn any_file_that_looks_sound_is_judged_or_refused_soon() {
    let pick = |words: &'static [&'static str]| prop::sample::select(words);
    let strategy = (
        pick(&[
            "phong",
            "phong-modified",
            "blinn-phong",
            "blinn-phong-modified",
            "blinn-phong-heightfield",
            "lambert",
        ]),
        pick(&["", "convention = \"rdf\"", "convention = \"rdf-cosine\"", "convention = \"ndf\""]),
        prop_oneof![
            pick(&ClaimedLobe::IDS).prop_map(|lobe| format!("lobe = \"{lobe}\"")),
            (prop::collection::vec(-3000..3000_i32, 0..6), 0..8_u32).prop_map(|(list, power)| {
                let list: Vec<String> = list.iter().map(|c| format!("\"{}e-3\"", c)).collect();
                format!(
                    "lobe = \"polynomial\"\ncoefficients = [1, {}]\npower = \"{}\"",
                    list.join(", "),
                    1 << power
                )
            }),
        ],
        pick(&["support", "exact-zero", "paper", "card"]),
        prop_oneof![
            pick(&[
                "1/(n - 20)",
                "1/(n - 16)",
                "-n",
                "0*n",
                "n^32/(1 + n^31)",
                "2^(4*n)",
                "(n + pi)^8/n^7",
                "n*1e300",
                "1e-300*n",
                "n/pi^3",
                "1/(2^(-n/2) - 1/256)",
                "(n + 1/3)/(2*pi)",
                "123456789.123456789*n/pi",
                "n*n/0",
                "n +"
            ])
            .prop_map(str::to_owned),
            (0..3000_u32, -900..900_i32, 1..9_u32).prop_map(|(a, b, d)| format!(
                "({}*n + {}/100)/({d}*pi)",
                f64::from(a) / 1e3,
                b
            )
            .replace("+ -", "- ")),
        ],
        prop_oneof![
            (1..70_000_u32, 0..70_000_u32)
                .prop_map(|(a, b)| format!("n = \"{a}..{}\"\nover = \"integers\"", a + b)),
            (10..900_u32, 0..900_u32).prop_map(|(a, b)| format!(
                "n = \"{}..{}\"",
                f64::from(a) / 10.0,
                f64::from(a + b) / 10.0
            )),
            Just("n = \"16..inf\"".to_owned()),
        ],
        pick(&[
            "bound = \"1e-2\"",
            "bound = \"0\"",
            "bound = \"1e400\"",
            "bound = \"5\"",
            "energy = \"never-gains\"",
            "energy = \"never-gains\"\nloses-at-most = \"1e-9\"",
            "bound = \"1e-3\"\nenergy = \"never-gains\"",
            "",
        ]),
    );
    let (judged, refused) = (Cell::new(0), Cell::new(0));
    runner(150)
        .run(&strategy, |(model, convention, lobe, limit, factor, n, demand)| {
            let text = file(&[format!(
                "model = \"{model}\"\n{convention}\n{lobe}\nlimit = \"{limit}\"\nfactor = \"{factor}\"\n{n}\n{demand}"
            )]);
            match ClaimsFile::parse(&text) {
                Ok(claims) => {
                    let begun = std::time::Instant::now();
                    let found = Judge::default().judge(&claims).unwrap();
                    // Seconds are usual at most; this is far from minutes on a slow machine.
                    prop_assert!(begun.elapsed().as_secs() < 40, "{:?}\n{}", begun.elapsed(), text);
                    let json = judgements_json(&found).unwrap();
                    prop_assert!(serde_json::from_str::<serde_json::Value>(&json).is_ok());
                    judged.set(judged.get() + 1);
                }
                Err(error) => {
                    prop_assert!(!error.message.contains('\n') && error.line >= 1, "{}", error);
                    refused.set(refused.get() + 1);
                }
            }
            Ok(())
        })
        .unwrap();
    let (judged, refused) = (judged.get(), refused.get());
    assert!(judged > 20 && refused > 20, "{judged} judged, {refused} refused");
}
