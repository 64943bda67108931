//! Constants of one's own: judged by laws and by mathematics.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::paper::{ClaimsFile, Kind};
use bellfit::verdict::{Judge, Judgement, Verdict};
use own_claims::{EXACT, file, judge, one, parts, runner};
use proptest::prelude::*;

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

/// (n + 8)/8π for Blinn-Phong with cosⁿ: 2π coef Int is (1 + 2^(-n/2)/n)(1 + 8/n)/((1 + 2/n)(1 + 4/n)) by the
/// integral's own formula, largest at 9 among the whole numbers.
#[test]
fn the_witness_says_how_much_and_where() {
    let over = |n: f64| {
        (1.0 + libm::exp2(-0.5 * n) / n) * (1.0 + 8.0 / n) / ((1.0 + 2.0 / n) * (1.0 + 4.0 / n)) - 1.0
    };
    let largest = (1..=64).map(f64::from).max_by(|a, b| over(*a).total_cmp(&over(*b))).unwrap();
    assert_eq!(largest, 9.0);
    let found = one("model = \"blinn-phong\"\nconvention = \"rdf-cosine\"\nlobe = \"cos-n\"\n\
                     factor = \"(n + 8)/(8*pi)\"\nn = \"1..64\"\nover = \"integers\"\nenergy = \"never-gains\"");
    assert_eq!(found.verdict, Verdict::Refuted);
    let told = format!("gains energy: 2π coef Int - 1 reaches {:.4e} at n = 9", over(9.0));
    assert!(found.witness.contains(&told), "{}: {told}", found.witness);
}
