//! Constants of one's own: judged by laws and by mathematics, mended by what holds when it is put back, and read
//! without a panic whatever the file.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

use bellfit::fit::{Change, FactorForm};
use bellfit::paper::schema::SCHEMA;
use bellfit::paper::{ClaimedLobe, ClaimsFile, EXAMPLE, Kind, LOBE_PAPER, PIXEL_PAPER};
use bellfit::report::judgements_json;
use bellfit::verdict::{Judge, Judgement, NormalisationFinding, Verdict};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

/// A file with one claim of these readings, each without its id.
fn file(readings: &[String]) -> String {
    let numbered = readings.iter().enumerate();
    let readings =
        numbered.map(|(i, r)| format!("[[claim.reading]]\nid = \"r{i}\"\nkind = \"normalisation\"\n{r}\n"));
    let head =
        "version = 1\n[[claim]]\nid = \"mine\"\npaper = \"π\"\nlocator = \"line 1\"\ntext = \"as printed\"\n";
    head.to_owned() + &readings.collect::<String>()
}

fn judge(readings: &[String]) -> Vec<Judgement> {
    let text = file(readings);
    Judge::default().judge(&ClaimsFile::parse(&text).unwrap_or_else(|e| panic!("{e}\n{text}"))).unwrap()
}

fn one(reading: &str) -> Judgement {
    judge(&[reading.to_owned()]).remove(0)
}

fn parts(judgement: &Judgement) -> &NormalisationFinding {
    judgement.normalisation.as_ref().unwrap()
}

/// Always the same cases.
fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

/// The exact factors of cosⁿ: Table 1 of the lobe paper, whose integrals are elementary.
const EXACT: [(&str, &str); 6] = [
    ("phong", "(n + 1)/(2*pi)"),
    ("phong-modified", "(n + 2)/(2*pi)"),
    ("blinn-phong", "(n + 2)/(4*pi*(2 - 2^(-n/2)))"),
    ("blinn-phong-modified", "(n + 2)*(n + 4)/(8*pi*(2^(-n/2) + n))"),
    ("blinn-phong-ndf", "(n + 1)/(2*pi)"),
    ("blinn-phong-heightfield", "(n + 2)/(2*pi)"),
];

#[test]
fn an_exact_factor_leaves_a_residual_of_zero() {
    for (model, factor) in EXACT {
        for over in ["integers", "reals"] {
            let found = one(&format!(
                "model = \"{model}\"\nlobe = \"cos-n\"\nfactor = \"{factor}\"\nn = \"1..4096\"\nover = \"{over}\"\n\
                 bound = \"0\"\nenergy = \"never-gains\"\nloses-at-most = \"0\""
            ));
            assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
            let extremes = parts(&found).extremes;
            assert_eq!((extremes.max.value.hi(), extremes.min.value.lo()), (0.0, 0.0), "{model}");
        }
    }
    // (1 - t/K)^K over its support: n Int = K/(K + 1) under Phong, so the factor (1 + 1/K) n/(2π) is exact where
    // the hemisphere holds it, n ≥ K.
    for k in [2, 4, 8, 16, 32, 64] {
        for lobe in [
            format!("lobe = \"cs{k}\""),
            format!("lobe = \"polynomial\"\ncoefficients = [1, -1]\npower = \"{k}\""),
        ] {
            let found = one(&format!(
                "model = \"phong\"\n{lobe}\nfactor = \"{}*n/({k}*2*pi)\"\nn = \"{k}..inf\"\nbound = \"0\"",
                k + 1
            ));
            assert_eq!(found.verdict, Verdict::Proved, "{k}: {found:?}");
        }
    }
    // 1 - y² ends at 1: ∫ (1 - y²)² dy = 8/15, T = 2, so n Int = 16/15.
    let found = one(
        "model = \"blinn-phong\"\nconvention = \"ndf\"\nlobe = \"polynomial\"\ncoefficients = [1, 0, \"-1.00\"]\n\
         power = \"2\"\nfactor = \"15*n/(16*2*pi)\"\nn = \"2..inf\"\nbound = \"0\"",
    );
    assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
}

/// The bell that is built in, by its closed form, and the same by its coefficients, by a rule.
#[test]
fn a_bell_by_its_coefficients_is_the_one_built_in() {
    let mut compared = 0;
    for (model, divisor) in
        [("phong", 2), ("phong-modified", 2), ("blinn-phong", 8), ("blinn-phong-modified", 8)]
    {
        for limit in ["support", "exact-zero", "paper", "card"] {
            for over in ["integers", "reals"] {
                let of = |lobe: &str| {
                    one(&format!(
                        "model = \"{model}\"\n{lobe}\nlimit = \"{limit}\"\nfactor = \"(1.06*n + 1)/({divisor}*pi)\"\n\
                         n = \"16..300\"\nover = \"{over}\"\nbound = \"5e-3\"\nenergy = \"never-gains\""
                    ))
                };
                let [closed, rule] =
                    ["lobe = \"cs16\"", "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\""]
                        .map(of);
                assert_eq!(closed.verdict, rule.verdict, "{closed:?} {rule:?}");
                let [a, b] = [&closed, &rule].map(|j| parts(j).extremes);
                for (a, b) in [(a.max.value, b.max.value), (a.min.value, b.min.value)] {
                    assert!(!a.is_disjoint(b), "{model}, {limit}: {a:?} {b:?}");
                    // A search stops at six digits of the residual's size, the rest is rounding.
                    let widest = 1e-5 * a.abs().hi().max(1e-6);
                    assert!(
                        (a.lo() - b.lo()).abs() < widest && (a.hi() - b.hi()).abs() < widest,
                        "{a:?} {b:?}"
                    );
                }
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 32);
}

/// An exact factor scaled up by any ε gains exactly ε at every n.
#[test]
fn a_factor_scaled_up_gains() {
    let strategy = (0..6_usize, 1..10_000_u32, 1..9_u32, 1..200_u32);
    runner(60)
        .run(&strategy, |(model, digits, places, from)| {
            let (model, factor) = EXACT[model];
            let epsilon = format!("{digits}e-{}", places + 4);
            let up = one(&format!(
                "model = \"{model}\"\nlobe = \"cos-n\"\nfactor = \"(1 + {digits}*10^(-{}))*{factor}\"\n\
                 n = \"{from}..{}\"\nenergy = \"never-gains\"\nbound = \"{epsilon}\"",
                places + 4,
                from + 50
            ));
            prop_assert_eq!(up.verdict, Verdict::Refuted);
            let exact: f64 = epsilon.parse().unwrap();
            let gains = parts(&up).extremes.max.value;
            prop_assert!((gains.mid() / exact - 1.0).abs() < 1e-3, "{:?} {}", gains, exact);
            let down = one(&format!(
                "model = \"{model}\"\nlobe = \"cos-n\"\nfactor = \"(1 - {digits}*10^(-{}))*{factor}\"\n\
                 n = \"{from}..{}\"\nenergy = \"never-gains\"",
                places + 4,
                from + 50
            ));
            prop_assert_eq!(down.verdict, Verdict::Proved);
            Ok(())
        })
        .unwrap();
}

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
        0..3_u32,
    );
    let (mended, kinds, none) = (Cell::new(0), RefCell::new(BTreeSet::new()), Cell::new(0));
    runner(120)
        .run(&strategy, |(lobe, model, demand, slope, offset, whole, form)| {
            let divisor = if models[model] == "blinn-phong" || models[model] == "blinn-phong-modified" { 8 } else { 2 };
            let line = format!("(1.{slope:04}*n + {}.{})/({divisor}*pi)", offset / 10, offset % 10);
            let factor = if form == 0 { format!("(1 + 1/n^2)*{line}") } else { line };
            let bell = if lobes[lobe] == "polynomial" {
                "\ncoefficients = [1, \"-0.9\", \"-0.125\"]\npower = \"8\""
            } else {
                ""
            };
            let over = if whole { "integers" } else { "reals" };
            let reading = |factor: &str| {
                format!(
                    "model = \"{}\"\nlobe = \"{}\"{bell}\nfactor = \"{factor}\"\nn = \"16..700\"\nover = \"{over}\"\n{}",
                    models[model], lobes[lobe], demands[demand]
                )
            };
            let found = one(&reading(&factor));
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

#[test]
fn a_factor_has_to_be_positive() {
    // Negative everywhere, 0 everywhere, and negative up to its pole.
    for factor in ["-n", "0*n", "1/(n - 20)"] {
        let found = one(&format!(
            "model = \"phong\"\nlobe = \"cs16\"\nfactor = \"{factor}\"\nn = \"16..64\"\nenergy = \"never-gains\""
        ));
        assert_eq!(found.verdict, Verdict::Refuted, "{factor}: {found:?}");
        assert_eq!(parts(&found).demands[0].demand.id(), "positive", "{factor}");
    }
}

#[test]
fn the_order_of_readings_changes_nothing_but_the_order() {
    let readings: Vec<String> = EXACT
        .iter()
        .map(|(model, _)| {
            format!("model = \"{model}\"\nlobe = \"cs16\"\nfactor = \"1.07*n/(2*pi)\"\nn = \"16..64\"\nbound = \"1e-2\"")
        })
        .collect();
    let reversed: Vec<String> = readings.iter().rev().cloned().collect();
    let unnamed = |judgements: Vec<Judgement>| -> Vec<Judgement> {
        judgements.into_iter().map(|j| Judgement { reading: String::new(), ..j }).collect()
    };
    let mut after = unnamed(judge(&reversed));
    after.reverse();
    assert_eq!(unnamed(judge(&readings)), after);
}

#[test]
fn conventions_name_the_models() {
    for (family, convention, model) in [
        ("phong", "rdf", "phong"),
        ("phong", "rdf-cosine", "phong-modified"),
        ("blinn-phong", "rdf", "blinn-phong"),
        ("blinn-phong", "rdf-cosine", "blinn-phong-modified"),
        ("blinn-phong", "ndf", "blinn-phong-ndf"),
        ("blinn-phong", "heightfield", "blinn-phong-heightfield"),
        ("blinn-phong-ndf", "ndf", "blinn-phong-ndf"),
    ] {
        let text = file(&[format!(
            "model = \"{family}\"\nconvention = \"{convention}\"\nlobe = \"cos-n\"\nfactor = \"n\"\nn = \"1..2\"\nbound = \"1\""
        )]);
        let Kind::Normalisation(claim) =
            &ClaimsFile::parse(&text).unwrap().claims[0].readings[0].kind.clone()
        else {
            panic!("{text}")
        };
        assert_eq!(claim.model.id(), model);
    }
}

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
        ("¦[]", &["begins with 0"]),
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
    for (bad, words) in
        [("16", "1 ≤ A < B"), ("16..16", "1 ≤ A < B"), ("0.5..3", "1 ≤ A < B"), ("inf..3", "1 ≤ A < B")]
    {
        assert_mistake("\"16..64\"", &format!("¦\"{bad}\""), &[bad, words]);
    }
    assert_mistake("\"16..64\"", "¦\"16..inf\"\nover = \"integers\"", &["16..inf", "1 ≤ A ≤ B ≤ 65536"]);
    assert_mistake(
        "lobe = \"polynomial\"\ncoefficients = [1, \"-1\"]\npower = \"16\"\nfactor = \"n/(2*pi)\"\nn = \"16..64\"",
        "lobe = \"cubic-4\"\nfactor = \"n/(2*pi)\"\nn = ¦\"15.5..64\"",
        &["15.5..64", "cubic-4", "n ≥ 16"],
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

/// Every kind that the reader knows is in the schema with a heading or a row of its own, and no other is read.
#[test]
fn the_schema_names_every_kind_and_every_lobe() {
    let named =
        |id: &str| SCHEMA.contains(&format!("## `{id}`")) || SCHEMA.contains(&format!("\n| `{id}` |"));
    for id in Kind::IDS {
        assert!(named(id), "{id} is not in the schema");
        let bare = file(&[]) + &format!("[[claim.reading]]\nid = \"a\"\nkind = \"{id}\"\n");
        let read = ClaimsFile::parse(&bare);
        assert!(!read.is_err_and(|error| error.message.contains("unknown kind")), "{id} is not read");
    }
    let unknown = file(&[]) + "[[claim.reading]]\nid = \"a\"\nkind = \"nonsense\"\n";
    let error = ClaimsFile::parse(&unknown).unwrap_err();
    assert!(Kind::IDS.iter().all(|id| error.message.contains(id)), "{error}");
    let mut seen = BTreeSet::new();
    for text in [LOBE_PAPER, PIXEL_PAPER, EXAMPLE] {
        for reading in ClaimsFile::parse(text).unwrap().claims.iter().flat_map(|claim| &claim.readings) {
            assert!(Kind::IDS.contains(&reading.kind.id()));
            seen.insert(reading.kind.id());
        }
    }
    assert_eq!(
        seen.len(),
        Kind::IDS.len(),
        "{:?}",
        Kind::IDS.iter().filter(|id| !seen.contains(*id)).collect::<Vec<_>>()
    );
    for id in ClaimedLobe::IDS {
        assert!(SCHEMA.contains(&format!("`{id}`")), "{id}");
    }
}

/// Every field of the JSON is in the schema, and its version; the fields of a refuted reading are as they were.
#[test]
fn the_json_is_the_one_described() {
    let found = judge(&[
        "model = \"phong\"\nlobe = \"cs16\"\nfactor = \"1.0725*n/(2*pi)\"\nn = \"16..inf\"\nbound = \"1e-3\""
            .to_owned(),
        "model = \"blinn-phong\"\nlobe = \"cs16\"\nfactor = \"n/(8*pi)\"\nn = \"16..64\"\nbound = \"1e-12\""
            .to_owned(),
    ]);
    let json: serde_json::Value = serde_json::from_str(&judgements_json(&found).unwrap()).unwrap();
    fn fields(value: &serde_json::Value, found: &mut BTreeSet<String>) {
        match value {
            serde_json::Value::Object(object) => object.iter().for_each(|(key, value)| {
                found.insert(key.clone());
                fields(value, found);
            }),
            serde_json::Value::Array(list) => list.iter().for_each(|value| fields(value, found)),
            _ => {}
        }
    }
    let mut all = BTreeSet::new();
    fields(&json, &mut all);
    let (_, described) = SCHEMA.split_once("# The verdicts as JSON").unwrap();
    assert!(all.iter().all(|key| described.contains(key.as_str())), "{all:?}");
    let first = &json["judgements"][0];
    assert_eq!(json["version"], 1);
    assert_eq!(
        (&first["verdict"], &first["kind"], &first["stated"]),
        (&"refuted".into(), &"normalisation".into(), &"|residual| ≤ 1e-3".into())
    );
    // 1.0725 · 16/17 - 1, and 1.0625 · 16/17 = 1.
    let exact = 1.0725 * 16.0 / 17.0 - 1.0;
    for end in ["lo", "hi"] {
        assert!((first["computed"][end].as_f64().unwrap() - exact).abs() < 1e-12);
        assert!((first["residual"]["max"][end].as_f64().unwrap() - exact).abs() < 1e-12);
        assert!(first["nearest"]["max"][end].as_f64().unwrap().abs() < 1e-12);
    }
    assert_eq!(
        (&first["nearest"]["factor"], &first["nearest"]["digits_changed"]),
        (&"1.0625*n/(2*pi)".into(), &1.into())
    );
    assert!(first["residual"]["n_to"].is_null() && first["residual"]["n_from"] == 16.0);
    assert_eq!(first["demands"][0]["demand"], "bound");
    assert_eq!(json["judgements"][1]["ruled_out"][0]["form"], "proportional");
}

/// Every key of the example is explained: beside it, or in a comment.
#[test]
fn the_example_explains_its_keys() {
    let comments: String =
        EXAMPLE.lines().filter_map(|line| line.split_once('#')).map(|(_, c)| c.to_owned() + "\n").collect();
    let mut keys = BTreeSet::new();
    for line in EXAMPLE.lines().filter(|line| !line.starts_with('#')) {
        let Some((key, rest)) = line.split_once(" = ") else { continue };
        if rest.contains('#') || comments.contains(key) {
            keys.insert(key.trim().to_owned());
        }
    }
    for line in EXAMPLE.lines().filter(|line| !line.starts_with([' ', '#'])) {
        if let Some((key, _)) = line.split_once(" = ") {
            assert!(keys.contains(key), "{key} is not explained");
        }
    }
    let first = EXAMPLE.find("kind = ").map(|at| &EXAMPLE[at..]).unwrap();
    assert!(first.starts_with("kind = \"normalisation\""), "the new kind comes first");
}

fn example(text: &str) -> Vec<Judgement> {
    Judge::default().judge(&ClaimsFile::parse(text).unwrap()).unwrap()
}

/// cosⁿ along the normal, by Table 1's integrals: 2π coef Int with coef = (n + b)/(8π) is
/// (1 + h/n)(1 + b/n)/((1 + 2/n)(1 + 4/n)), h = 2^(-n/2).
fn albedo(n: f64, b: f64) -> f64 {
    let h = libm::exp2(-n / 2.0);
    (1.0 + h / n) * (1.0 + b / n) / ((1.0 + 2.0 / n) * (1.0 + 4.0 / n))
}

#[test]
fn three_constants_of_renderers_get_the_verdicts_of_mathematics() {
    // three.js: b = 2 leaves (1 + h/n)/(1 + 4/n) < 1, as h < 4; it loses most at n = 16, 1 - 0.8002.
    let found = example(include_str!("../examples/claims/three-blinn-phong.toml"));
    assert!((16..=400).all(|n| (0.8..1.0).contains(&albedo(f64::from(n), 2.0))));
    let verdicts: Vec<Verdict> = found.iter().map(|j| j.verdict).collect();
    assert_eq!(verdicts, [Verdict::Proved, Verdict::Proved]);
    let loss = parts(&found[0]).extremes.min;
    assert!((loss.value.mid() - (albedo(16.0, 2.0) - 1.0)).abs() < 1e-6 && loss.n == 16.0, "{loss:?}");

    // Godot: b = 8 gains, most of all whole n at 9; b = 6 is a lower bound of the exact factor and b = 7 is none.
    let found = example(include_str!("../examples/claims/godot-blinn.toml"));
    let most = (1..=16_384)
        .map(f64::from)
        .fold((0.0, 0.0), |m: (f64, f64), n| if albedo(n, 8.0) > m.1 { (n, albedo(n, 8.0)) } else { m });
    assert!((1..=16_384).all(|n| albedo(f64::from(n), 6.0) < 1.0) && albedo(100.0, 7.0) > 1.0);
    for judgement in &found {
        assert_eq!(judgement.verdict, Verdict::Refuted);
        let remedy = parts(judgement).mended.as_ref().unwrap().remedy.as_ref().unwrap();
        assert_eq!(remedy.source, "(n + 6)/(8*pi)");
    }
    let gain = parts(&found[0]).extremes.max;
    assert!(gain.n == most.0 && (gain.value.mid() - (most.1 - 1.0)).abs() < 1e-9, "{gain:?} {most:?}");

    // pbrt: ∫ (n + 2)/(2π) cosⁿ cos dω = 1, and without the cosine (n + 2)/(n + 1), 3/2 at n = 1.
    let found = example(include_str!("../examples/claims/pbrt-blinn.toml"));
    let verdicts: Vec<Verdict> = found.iter().map(|j| j.verdict).collect();
    assert_eq!(verdicts, [Verdict::Proved, Verdict::Refuted]);
    let gain = parts(&found[1]).extremes.max;
    assert!(gain.n == 1.0 && gain.value.contains(0.5), "{gain:?}");
    let remedy = parts(&found[1]).mended.as_ref().unwrap().remedy.as_ref().unwrap();
    assert_eq!(remedy.source, "(n + 1)/(2*pi)");
    for text in [
        include_str!("../examples/claims/three-blinn-phong.toml"),
        include_str!("../examples/claims/godot-blinn.toml"),
        include_str!("../examples/claims/pbrt-blinn.toml"),
    ] {
        assert!(
            text.starts_with("# ") && text.contains("\n# The source: ") && text.contains("\n# Expected: ")
        );
    }
}
