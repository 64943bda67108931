//! `bellfit choose` as a program.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/program.rs"]
mod program;

use serde_json::Value;
use std::process::Output;

fn bellfit(arguments: &[&str]) -> Output {
    program::bellfit(&[&["choose"], arguments].concat())
}

#[track_caller]
fn refused(arguments: &[&str], names: &str) {
    program::refused(&[&["choose"], arguments].concat(), names);
}

#[track_caller]
fn answered(arguments: &[&str], code: i32) -> String {
    let output = bellfit(arguments);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {error}");
    assert!(error.is_empty(), "{error}");
    String::from_utf8(output.stdout).unwrap()
}

const PLAIN: [&str; 6] = ["--n", "16..256", "--max-error", "1e-3", "--float", "f32"];

fn plain<'a>(more: &[&'a str]) -> Vec<&'a str> {
    PLAIN.iter().copied().chain(more.iter().copied()).collect()
}

#[test]
fn an_answer_is_printed_and_repeats() {
    let text = answered(&plain(&["--angle", "difference"]), 0);
    assert!(text.contains("\n1  cubic-4 "), "{text}");
    for part in
        ["why the cheaper ones do not do", "proofs", "certified", "WGSL and GLSL do not promise", "cs-16"]
    {
        assert!(text.contains(part), "{part}\n{text}");
    }
    assert_eq!(text, answered(&plain(&["--angle", "difference"]), 0));
}

#[test]
fn json_says_the_same() {
    let arguments =
        plain(&["--angle", "difference", "--model", "phong", "--energy", "never-gains", "--json"]);
    let json: Value = serde_json::from_str(&answered(&arguments, 0)).unwrap();
    assert_eq!((&json["version"], &json["best"]), (&Value::from(1), &Value::from("cubic-4")));
    assert_eq!(json["need"]["n_to"], 256.0);
    let kernels = json["kernels"].as_array().unwrap();
    assert_eq!(kernels.len(), 15);
    for kernel in kernels {
        let verdict = kernel["verdict"].as_str().unwrap();
        assert_eq!(verdict == "qualifies", kernel["reason"].is_null(), "{kernel}");
        if verdict == "qualifies" {
            assert!(kernel["error_bound"].as_f64().unwrap() <= 1e-3, "{kernel}");
            assert!(kernel["factors"][0]["gain_hi"].as_f64().unwrap() <= 0.0, "{kernel}");
        }
        if verdict == "fails" && !kernel["witness"].is_null() {
            assert!(kernel["witness"]["error"].as_f64().unwrap() > 1e-3, "{kernel}");
        }
    }
}

#[test]
fn nothing_qualifies_is_exit_1_with_the_nearest_miss() {
    let need = ["--n", "16..256", "--max-error", "1e-12", "--float", "f32"];
    let text = answered(&need, 1);
    assert!(text.contains("nothing qualifies\nnearest: "), "{text}");
    let json: Value = serde_json::from_str(&answered(&[&need[..], &["--json"]].concat(), 1)).unwrap();
    assert!(json["best"].is_null() && json["nearest_miss"]["ratio"].as_f64().unwrap() > 1.0);
}

#[test]
fn roughness_filters_and_one_kernel() {
    let text = answered(
        &[
            "--roughness",
            "0.1..0.3",
            "--max-error",
            "0.05",
            "--relative",
            "--floor",
            "0.3",
            "--float",
            "f32",
            "--no-division",
            "--no-transcendental",
            "--angle",
            "versine",
        ],
        0,
    );
    assert!(!text.contains("\n1  pow") && text.contains("of the value"), "{text}");
    let text = answered(&plain(&["--kernel", "pow", "--ulps", "4", "--angle", "versine"]), 0);
    assert!(text.contains("within 4 ulp") && !text.contains("cubic"), "{text}");
    answered(&plain(&["--kernel", "linear-2"]), 1);
}

#[test]
fn a_file_is_answered() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("choose");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("needs.toml");
    std::fs::write(&path, answered(&["--example"], 0)).unwrap();
    let name = path.to_str().unwrap();
    let text = answered(&[name], 0);
    for sentence in [
        "chalk: no stand-in; cosⁿ by squarings is exact but for rounding, at most",
        "wall: no true axes; skew at most",
        "label: no anisotropy; aspect at most",
        "decal: no pyramid; no derivative exceeds a texel",
    ] {
        assert!(text.contains(sentence), "{sentence}\n{text}");
    }
    assert!(answered(&[name, "--emit", "wgsl"], 0).contains("fn "));
    let json: Value = serde_json::from_str(&answered(&[name, "--json"], 0)).unwrap();
    assert_eq!((&json["version"], &json["is_met"]), (&Value::from(1), &Value::from(true)));
    assert_eq!(json["materials"].as_array().unwrap().len(), 3);
    let wrong = folder.join("wrong.toml");
    std::fs::write(&wrong, "version = 1\n[budget]\nmax_error = 2\n[[material]]\n").unwrap();
    refused(&[wrong.to_str().unwrap()], "wrong.toml: line ");
    refused(&[folder.to_str().unwrap()], "a folder");
    refused(&[folder.join("none.toml").to_str().unwrap()], "no such file");
    refused(&[name, "--n", "16"], "cannot be used with");
}

/// f16 holds nothing beyond 65504: no constant of a bell, and no n.
#[test]
fn a_need_without_any_bound_says_so() {
    let text = answered(&["--n", "1e12", "--max-error", "0.1", "--float", "f16"], 1);
    assert!(text.contains("nothing qualifies\nnearest: none, as no error has a bound here\n"), "{text}");
}

/// What is printed as a bound is none below the one that the JSON object has in full.
#[test]
fn printed_bounds_are_rounded_up() {
    let arguments = ["--n", "2", "--max-error", "0.9", "--float", "f16"];
    let json: Value = serde_json::from_str(&answered(&[&arguments[..], &["--json"]].concat(), 0)).unwrap();
    let text = answered(&arguments, 0);
    let mut count = 0;
    for kernel in json["kernels"].as_array().unwrap().iter().filter(|k| k["verdict"] == "qualifies") {
        let id = kernel["id"].as_str().unwrap();
        let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let row = text.lines().map(words).find(|row| row.get(1).is_some_and(|word| word == id)).unwrap();
        assert!(row[3].parse::<f64>().unwrap() >= kernel["error_bound"].as_f64().unwrap(), "{row:?}");
        count += 1;
    }
    assert!(count > 5, "{text}");
}

#[test]
fn bad_input_is_one_line() {
    refused(&[], "--n A..B");
    refused(&["--n", "16..64"], "--max-error");
    refused(&["--n", "16..64", "--max-error", "0.1"], "--float");
    for (more, names) in [
        (&["--n", "0.5..2"][..], "1 ≤ A ≤ B"),
        (&["--n", "64..16"], "1 ≤ A ≤ B"),
        (&["--n", "1..1e13"], "1 ≤ A ≤ B"),
        (&["--n", "x"], "1 ≤ A ≤ B"),
        (&["--roughness", "0..0.5"], "0 < A ≤ B ≤ 1"),
        (&["--roughness", "0.1..0.95"], "n ≥ 1"),
        (&["--roughness", "1e-8"], "n ≤ 1e12"),
        (&["--n", "16.2..16.8", "--whole"], "no whole number"),
    ] {
        refused(&[more, &["--max-error", "0.1", "--float", "f32"]].concat(), names);
    }
    let of = |flag: &'static str, value: &'static str, names: &str| {
        let mut arguments: Vec<&str> = PLAIN.to_vec();
        if let Some(at) = arguments.iter().position(|a| *a == flag) {
            arguments[at + 1] = value;
        } else {
            arguments.extend([flag, value]);
        }
        refused(&arguments, names);
    };
    of("--max-error", "0", "more than 0");
    of("--max-error", "-1", "more than 0");
    of("--max-error", "2", "at most 1");
    of("--max-error", "nan", "more than 0");
    of("--max-error", "x", "max-error");
    of("--float", "f8", "known are f16, f16-stored, f32, f64");
    of("--angle", "sine", "known are cos, versine, difference");
    of("--model", "ward", "known are phong");
    of("--energy", "some", "known are never-gains, unbiased");
    of("--energy", "unbiased", "--model is needed");
    of("--floor", "0.1", "--relative");
    of("--energy-error", "0.1", "--energy");
    of("--ulps", "0", "--ulps 0, of the elementary functions");
    of("--kernel", "cosine", "known are cs-16");
    of("--weights", "1", "two numbers");
    of("--weights", "1,-2", "0 to 1e6");
    refused(&plain(&["--relative", "--floor", "1"]), "part of the peak");
    refused(&plain(&["--model", "phong", "--energy", "never-gains", "--energy-error", "0.1"]), "of no use");
    refused(&plain(&["--model", "phong", "--energy", "unbiased", "--energy-error", "0"]), "energy-error");
    refused(&plain(&["--roughness", "0.5"]), "cannot be used with");
    refused(&plain(&["--lobes"]), "--lobes");
    refused(&["--example", "--json"], "cannot be used with");
}

#[test]
fn code_is_printed_for_the_best_and_nothing_for_none() {
    let code =
        answered(&plain(&["--angle", "difference", "--emit", "wgsl", "--with", "footprint,cubic-4"]), 0);
    for part in ["fn cubic_4_lobe_versine(", "fn footprint_plain(", "fn footprint_q(", "16..256"] {
        assert!(code.contains(part), "{part}\n{code}");
    }
    // The bound of the comment is the answer's, printed upwards.
    let json: Value =
        serde_json::from_str(&answered(&plain(&["--angle", "difference", "--json"]), 0)).unwrap();
    let kernels = json["kernels"].as_array().unwrap();
    let bound = kernels.iter().find(|k| k["id"] == "cubic-4").unwrap()["error_bound"].as_f64().unwrap();
    let printed: f64 = code.split("<= ").nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
    assert!(printed >= bound && printed < 1.001 * bound, "{printed} for {bound}");
    for language in ["rust", "c", "glsl", "hlsl", "msl"] {
        assert!(answered(&plain(&["--emit", language]), 0).contains("cubic"), "{language}");
    }
    let none = bellfit(&["--n", "16..256", "--max-error", "1e-12", "--float", "f32", "--emit", "c"]);
    assert_eq!(none.status.code(), Some(1));
    assert!(none.stdout.is_empty() && String::from_utf8_lossy(&none.stderr).contains("nothing qualifies"));
    refused(&plain(&["--emit", "cobol"]), "rust, wgsl, glsl, hlsl, msl, c");
    refused(&plain(&["--with", "footprint"]), "--emit");
    refused(&plain(&["--emit", "c", "--with", "cubic-3"]), "cubic-3");
    refused(
        &["--n", "16..64", "--max-error", "0.1", "--float", "f16", "--angle", "difference", "--emit", "msl"],
        "f16",
    );
}

/// What never gains in f64 gains nothing in the code's own arithmetic either.
#[test]
fn an_emitted_factor_is_lowered_by_more_than_its_rounding() {
    let needs = ["--model", "phong", "--energy", "never-gains", "--angle", "difference"];
    let code = answered(&plain(&[&needs[..], &["--emit", "c"]].concat()), 0);
    assert!(code.contains("Lowered by 3.8147e-6"), "{code}");
    let plain_code = answered(&plain(&["--model", "phong", "--angle", "difference", "--emit", "c"]), 0);
    assert!(!plain_code.contains("Lowered"), "{plain_code}");
}

/// The record's order, by nanoseconds, and another one by operations.
#[test]
fn a_record_ranks_by_its_times() {
    let path = format!("{}/reports/measured/trade-amd-epyc.json", env!("CARGO_MANIFEST_DIR"));
    let arguments = ["--n", "64", "--max-error", "0.5", "--float", "f32", "--json"];
    let json: Value =
        serde_json::from_str(&answered(&[&arguments[..], &["--trade", &path]].concat(), 0)).unwrap();
    let record: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let time = |id: &str| {
        let rows = record["rows"].as_array().unwrap();
        let of = |row: &&Value| row["subject"] == id && row["format"] == "f32" && row["place"] == "cache";
        rows.iter().find(of).map(|row| row["nanoseconds"].as_f64().unwrap())
    };
    let qualifying = json["kernels"].as_array().unwrap().iter().filter(|k| k["verdict"] == "qualifies");
    let times: Vec<f64> = qualifying.filter_map(|k| time(k["id"].as_str().unwrap())).collect();
    assert!(times.len() > 10, "{times:?}");
    // squarings keep their operations and come after
    assert!(times[..times.len() - 1].windows(2).all(|pair| pair[0] <= pair[1]), "{times:?}");
    refused(&[&arguments[..], &["--trade", "Cargo.toml"]].concat(), "Cargo.toml: line 1");
    refused(&[&arguments[..], &["--trade", "no-such.json"]].concat(), "no-such.json");
}
