//! Constants of one's own that touch what is asked of them: at an end of the range, in the limit, or at a pole.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/own_claims.rs"]
mod own_claims;

use bellfit::verdict::{Judgement, Verdict};
use own_claims::{one, parts};

const NEVER: &str = "energy = \"never-gains\"";

fn cosine(model: &str, factor: &str, n: &str, asked: &str) -> Judgement {
    one(&format!("model = \"{model}\"\nlobe = \"cos-n\"\nfactor = \"{factor}\"\nn = \"{n}\"\n{asked}"))
}

/// Table 1 of the lobe paper: 2π (n + b)/(d π) Int(n) of cosⁿ, Int being 1/(n + 1), 1/(n + 2), 2 (2 - h)/(n + 2) and
/// 4 (n + h)/((n + 2)(n + 4)), h = 2^(-n/2).
fn kept(model: &str, b: f64, n: f64) -> f64 {
    let h = libm::exp2(-0.5 * n);
    match model {
        "phong" | "blinn-phong-ndf" => (n + b) / (n + 1.0),
        "phong-modified" | "blinn-phong-heightfield" => (n + b) / (n + 2.0),
        "blinn-phong" => (n + b) * (2.0 - h) / (2.0 * (n + 2.0)),
        _ => (n + b) * (n + h) / ((n + 2.0) * (n + 4.0)),
    }
}

/// Each keeps less than 1 at every n and all of it in the limit: n + b falls short of the exact factor by 1, by
/// a share h/2 of it, or by (8 - 6 h - n h)/(n + h), in which n h < 1.07 and 6 h < 4.25. A hair more gains.
#[test]
fn what_nears_one_from_below_never_gains() {
    for (model, divisor, b) in [
        ("phong", 2, 0),
        ("phong-modified", 2, 1),
        ("blinn-phong", 8, 2),
        ("blinn-phong-modified", 8, 6),
        ("blinn-phong-ndf", 2, 0),
        ("blinn-phong-heightfield", 2, 1),
    ] {
        for from in [1, 2, 16] {
            let n = format!("{from}..inf");
            let found = cosine(model, &format!("(n + {b})/({divisor}*pi)"), &n, NEVER);
            assert_eq!(found.verdict, Verdict::Proved, "{model}, {n}: {found:?}");
            let extremes = parts(&found).extremes;
            assert_eq!((extremes.max.value.hi(), extremes.max.n), (0.0, f64::INFINITY), "{model}");
            // All of them rise.
            let least = kept(model, f64::from(b), f64::from(from)) - 1.0;
            assert!((extremes.min.value.mid() - least).abs() < 1e-6 && extremes.min.n == f64::from(from));
            let gains = cosine(model, &format!("1.0000001*(n + {b})/({divisor}*pi)"), &n, NEVER);
            assert_eq!(gains.verdict, Verdict::Refuted, "{model}, {n}: {gains:?}");
        }
        // As much again as is missing at n = 100 gains somewhere beyond.
        let more = f64::from(b) + 2.0 * (1.0 / kept(model, f64::from(b), 100.0) - 1.0) * 100.0;
        if more - f64::from(b) > 1e-3 {
            let gains = cosine(model, &format!("(n + {more})/({divisor}*pi)"), "1..inf", NEVER);
            assert_eq!(gains.verdict, Verdict::Refuted, "{model}: {gains:?}");
        }
    }
}

/// 1.0545 n + 0.128 is 17/16 n at n = 16, which is exact for cs_16 under Phong, and more than it below.
#[test]
fn an_end_is_the_decimal_that_is_written() {
    let over = |n: &str| {
        one(&format!(
            "model = \"phong\"\nlobe = \"cs16\"\nfactor = \"(1.0545*n + 0.128)/(2*pi)\"\nn = \"{n}\"\n{NEVER}"
        ))
    };
    assert_eq!(over("16..1024").verdict, Verdict::Proved);
    assert_eq!(over("16.0000000000000005..1024").verdict, Verdict::Proved);
    assert_ne!(over("15.9999999999999995..1024").verdict, Verdict::Proved);
    // A range within one double, and one between two.
    for n in ["1..1.0000000000000000001", "1.00000000000000000001..1.00000000000000000002"] {
        let found = cosine("phong", "(n + 1)/(2*pi)", n, "bound = \"0\"");
        assert_eq!(found.verdict, Verdict::Proved, "{n}: {found:?}");
        let found = cosine("phong", "(n + 2)/(2*pi)", n, NEVER);
        assert_eq!(found.verdict, Verdict::Refuted, "{n}: {found:?}");
    }
    // Met at the double 2.2 is not met at 2.2: 1 - 1/3.2 = 0.6875 of it is kept, and the double lies above.
    let found = cosine("phong", "n/(2*pi)", "2.2..64", &format!("{NEVER}\nloses-at-most = \"0.3125\""));
    assert_eq!(found.verdict, Verdict::Undecided, "{found:?}");
}

/// n/(2π) loses 1/(n + 1) under Phong; (n + 2)/(8π) loses h/2 under Blinn-Phong, 1/4 at n = 2, 1/32 at 8, 1/512 at 16.
#[test]
fn a_level_that_is_met_exactly_is_decided() {
    let loses = |model: &str, factor: &str, n: &str, level: &str| {
        cosine(model, factor, n, &format!("{NEVER}\nloses-at-most = \"{level}\"")).verdict
    };
    let cases = [
        ("phong", "n/(2*pi)", 1.0, ["0.5", "0.4999999999999999999999"]),
        ("phong", "n/(2*pi)", 1.5, ["0.4", "0.3999999999999999999999"]),
        ("phong", "n/(2*pi)", 3.0, ["0.25", "0.2499999999999999999999"]),
        ("phong", "n/(2*pi)", 4.0, ["0.2", "0.1999999999999999999999"]),
        ("phong", "n/(2*pi)", 9.0, ["0.1", "0.0999999999999999999999"]),
        ("phong", "n/(2*pi)", 99.0, ["1e-2", "0.9999999999999999999999e-2"]),
        ("blinn-phong", "(n + 2)/(8*pi)", 2.0, ["0.25", "0.2499999999999999999999"]),
        ("blinn-phong", "(n + 2)/(8*pi)", 8.0, ["0.03125", "0.0312499999999999999999"]),
        ("blinn-phong", "(n + 2)/(8*pi)", 16.0, ["0.001953125", "0.0019531249999999999999"]),
    ];
    for (model, factor, from, [level, less]) in cases {
        for to in ["inf", "1024", "100.25"] {
            let n = format!("{from}..{to}");
            assert_eq!(loses(model, factor, &n, level), Verdict::Proved, "{model}, {n}, {level}");
            // Less by what doubles do not tell apart.
            assert_eq!(loses(model, factor, &n, less), Verdict::Refuted, "{model}, {n}, {less}");
            let bound = cosine(model, factor, &n, &format!("bound = \"{level}\""));
            assert_eq!(bound.verdict, Verdict::Proved, "{bound:?}");
        }
        if from == libm::floor(from) {
            let asked = format!("over = \"integers\"\nbound = \"{level}\"");
            let found = cosine(model, factor, &format!("{from}..2000"), &asked);
            assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
        }
    }
}

/// 1.25 n is exact for cs_4 under Phong from n = 4 on, and for n < 4 it loses (1 - n/4)^5: no gain, which no closed form
/// tells and rounding hides.
#[test]
fn what_stays_open_is_said_to_be_met_nearly() {
    let found = one(&format!(
        "model = \"phong\"\nlobe = \"cs4\"\nfactor = \"1.25*n/(2*pi)\"\nn = \"1..inf\"\n{NEVER}"
    ));
    assert_eq!(found.verdict, Verdict::Undecided);
    assert!(found.witness.contains("met to within") && found.witness.contains("not decided"), "{found:?}");
}

/// What tends to 0 is positive nevertheless: 1/n under Phong keeps 1/(n (n + 1)), 1/2 at most.
#[test]
fn a_factor_may_vanish_in_the_limit_only() {
    let found = cosine("phong", "1/(2*pi*n)", "1..inf", NEVER);
    assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
    let found = cosine("phong", "2^(-n/2)/(2*pi)", "1..inf", NEVER);
    assert_eq!(found.verdict, Verdict::Proved, "{found:?}");
    let loses = cosine("phong", "1/(2*pi*n)", "1..inf", &format!("{NEVER}\nloses-at-most = \"0.999\""));
    assert_eq!(loses.verdict, Verdict::Refuted);
    assert_eq!(parts(&loses).demands.last().unwrap().demand.id(), "loses-at-most");
    for (factor, n) in [("(n - 2)/(2*pi)", "2..16"), ("(n - 2)/(2*pi*n^2)", "1.5..inf"), ("-1/n^2", "1..inf")]
    {
        let found = cosine("phong", factor, n, NEVER);
        assert_eq!(found.verdict, Verdict::Refuted, "{factor}: {found:?}");
        assert_eq!(parts(&found).demands[0].demand.id(), "positive", "{factor}");
    }
    let stand_in =
        one(&format!("model = \"phong\"\nlobe = \"linear-8\"\nfactor = \"0*n\"\nn = \"16..64\"\n{NEVER}"));
    assert_eq!(stand_in.verdict, Verdict::Refuted, "{stand_in:?}");
}

/// At a pole there is no factor, though all else of it cancels.
#[test]
fn a_pole_that_cancels_is_a_pole() {
    let factor = "(n + 1)*(n - 20)/((n - 20)*2*pi)";
    for (n, over) in
        [("20..20", "integers"), ("16..30", "integers"), ("16..30", "reals"), ("19..inf", "reals")]
    {
        let found = cosine("phong", factor, n, &format!("over = \"{over}\"\n{NEVER}"));
        assert_eq!(found.verdict, Verdict::Undecided, "{n}, {over}: {found:?}");
        let place = parts(&found).demands[0].n;
        assert!((place - 20.0).abs() < 1e-6, "{n}, {over}: {place}");
    }
    for (n, over) in [("21..30", "integers"), ("20.01..inf", "reals"), ("1..19.99", "reals")] {
        let found = cosine("phong", factor, n, &format!("over = \"{over}\"\n{NEVER}\nbound = \"0\""));
        assert_eq!(found.verdict, Verdict::Proved, "{n}, {over}: {found:?}");
    }
}

/// The limit of the paper, 6/√n, lies beyond the end of a bell with K below 18 from some n on; there the integral is that of
/// the whole bell. At n (1 - cos (6/√n)) = 16 that is n = 25.9. The card's, √(6/n), reaches t = 3 at most.
#[test]
fn a_limit_beyond_the_bell_leaves_the_whole_of_it() {
    let exact = |k: u32, limit: &str, n: &str| {
        one(&format!(
            "model = \"phong\"\nlobe = \"polynomial\"\ncoefficients = [1, -1]\npower = {k}\nlimit = \"{limit}\"\n\
             factor = \"{}*n/({k}*2*pi)\"\nn = \"{n}\"\nbound = \"0\"",
            k + 1
        ))
        .verdict
    };
    for (k, limit, n) in [
        (2, "paper", "2..inf"),
        (4, "paper", "4..inf"),
        (8, "paper", "8..300"),
        (16, "paper", "26..inf"),
        (2, "card", "2..inf"),
    ] {
        assert_eq!(exact(k, limit, n), Verdict::Proved, "{k}, {limit}, {n}");
    }
    for (k, limit, n) in
        [(16, "card", "16..inf"), (32, "paper", "32..inf"), (4, "card", "4..inf"), (2, "paper", "1..inf")]
    {
        assert_eq!(exact(k, limit, n), Verdict::Refuted, "{k}, {limit}, {n}");
    }
}

/// 2^(n/2) is 2^2500 at n = 5000, more than doubles hold; at n = 10 the gain is 32/11.
#[test]
fn what_overflows_still_gains() {
    for over in ["integers", "reals"] {
        let found = cosine("phong", "2^(n/2)/(2*pi)", "1..5000", &format!("over = \"{over}\"\n{NEVER}"));
        assert_eq!(found.verdict, Verdict::Refuted, "{found:?}");
        assert!(found.witness.contains("gains energy"), "{}", found.witness);
    }
}
