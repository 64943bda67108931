//! The program as its user meets it: exit codes, one clear line for bad input, nothing half
//! written, and files that regenerate to the byte.
#![cfg(feature = "toolkit")]

#[path = "support/program.rs"]
mod program;

use program::{bellfit, fed, refused};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Output;

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("UTF-8")
}

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder");
    path
}

/// Every file below a folder, by relative path.
fn files(root: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![root.to_path_buf()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(&folder).expect("readable") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                let bytes = std::fs::read(&path).expect("readable");
                found.insert(path.strip_prefix(root).expect("below").to_path_buf(), bytes);
            }
        }
    }
    found
}

#[test]
fn the_committed_files_regenerate_to_the_byte() {
    let root = env!("CARGO_MANIFEST_DIR");
    let out = folder("regenerated");
    let path = out.to_str().expect("UTF-8");
    // What is measured, not computed, is not regenerated, and the report shows it as it lies there.
    let measured = out.join("reports/measured");
    std::fs::create_dir_all(&measured).expect("a folder");
    for (name, bytes) in files(&Path::new(root).join("reports/measured")) {
        std::fs::write(measured.join(name), bytes).expect("writable");
    }
    let run = bellfit(&["reproduce", "--out", path]);
    assert_eq!(run.status.code(), Some(0), "{}", stdout(&run));
    let fresh = files(&out);
    for tree in ["fits", "reports"] {
        let committed = files(&Path::new(root).join(tree));
        let below: BTreeMap<_, _> = fresh
            .iter()
            .filter_map(|(p, b)| Some((p.strip_prefix(tree).ok()?.to_path_buf(), b.clone())))
            .collect();
        assert!(
            committed.keys().eq(below.keys()),
            "{tree}: {:?} against {:?}",
            committed.keys(),
            below.keys()
        );
        for (path, bytes) in committed {
            assert!(below[&path] == bytes, "{tree}/{} differs", path.display());
        }
    }

    // A changed file and a missing one are seen and named, and nothing is written.
    let table = out.join("fits/coefficients.csv");
    let mut text = std::fs::read_to_string(&table).expect("readable");
    text.push_str("one line too many\n");
    std::fs::write(&table, &text).expect("writable");
    std::fs::remove_file(out.join("reports/report.md")).expect("removable");
    let check = bellfit(&["--check", "--out", path]);
    assert_eq!(check.status.code(), Some(1));
    let said = stdout(&check);
    assert_eq!(said.matches("differs: ").count(), 2, "{said}");
    assert!(said.contains("differs: fits/coefficients.csv differs, first at line"), "{said}");
    assert!(said.contains("differs: reports/report.md: no such file"), "{said}");
    assert_eq!(std::fs::read_to_string(&table).expect("readable"), text);
    assert!(!out.join("reports/report.md").exists());
}

#[test]
fn what_cannot_be_written_leaves_everything_as_it_was() {
    refused(&["--out", env!("CARGO_BIN_EXE_bellfit")], "not a folder");
    refused(&["--out", "/proc/bellfit"], "/proc/bellfit");
    // The last file of the run cannot be placed: none may be, and the one that stood before stays.
    let out = folder("obstructed");
    std::fs::create_dir_all(out.join("reports/verdicts.json")).expect("a folder in a file's place");
    std::fs::create_dir_all(out.join("fits")).expect("a folder");
    std::fs::write(out.join("fits/coefficients.csv"), "mine\n").expect("writable");
    refused(&["--out", out.to_str().expect("UTF-8")], "is a folder");
    let left: Vec<_> = files(&out).into_iter().collect();
    assert_eq!(left, [(PathBuf::from("fits/coefficients.csv"), b"mine\n".to_vec())]);
}

#[test]
fn a_dash_is_standard_input() {
    for command in ["verify", "choose"] {
        let example = stdout(&bellfit(&[command, "--example"]));
        let answer = fed(&[command, "-"], example.as_bytes());
        assert_eq!(answer.status.code(), Some(0), "{command}: {answer:?}");
        let path = folder("dash").join("example.toml");
        std::fs::write(&path, &example).expect("writable");
        assert_eq!(stdout(&answer), stdout(&bellfit(&[command, path.to_str().expect("UTF-8")])), "{command}");
        let later = example.replace("version = 1", "version = 7");
        let refused = fed(&[command, "-"], later.as_bytes());
        let error = String::from_utf8(refused.stderr).expect("UTF-8");
        assert_eq!(refused.status.code(), Some(2), "{command}");
        assert!(error.starts_with("bellfit: standard input: ") && error.contains('7'), "{command}: {error}");
    }
}

#[test]
fn bad_usage_gets_one_line_that_names_the_value() {
    let n = |range| ["fit", "--model", "phong", "--n", range];
    for range in ["0..10", "20..10", "NaN", "16", "..", "16..", "-1..5", "1.5..3", "1..65537", ""] {
        refused(&n(range), "1 ≤ A ≤ B ≤ 65536");
    }
    refused(&n("16..17"), "n = 16..17: 3 values of n are needed and 2 given");
    refused(&["fit"], "--model");
    refused(&["fit", "--model", "lambert"], "known are phong, ");
    refused(&["fit", "--model", "phong", "--digits", "0"], "0 is not in 1..=15");
    refused(&["fit", "--model", "phong", "--lobe", "cos-n", "--limit", "card"], "support only");
    refused(&["--nonsense"], "--nonsense");
    refused(&["nonsense"], "nonsense");
    refused(&["--check", "--adopt"], "--adopt");
    refused(&["verify"], "<FILE>");
}

#[test]
fn claims_files_that_cannot_be_read_are_told_with_their_place() {
    let out = folder("claims");
    let file = |name: &str, bytes: &[u8]| {
        let path = out.join(name);
        std::fs::write(&path, bytes).expect("writable");
        path.to_str().expect("UTF-8").to_owned()
    };
    refused(&["verify", "/nonexistent.toml"], "/nonexistent.toml: no such file");
    refused(&["verify", out.to_str().expect("UTF-8")], "a folder");
    refused(&["verify", &file("bytes.toml", &[0xff, 0xfe, 0])], "not UTF-8");
    refused(&["verify", &file("empty.toml", b"")], "line 1");
    let unknown = b"version = 1\n\n[[claim]]\nid = \"a\"\ncolour = 3\n";
    refused(&["verify", &file("unknown.toml", unknown)], "line 5, column 1: unknown field `colour`");
    refused(
        &["verify", &file("version.toml", b"version = 2\n")],
        "line 1, column 11: version 2: this program reads version 1",
    );
    let endless = std::fs::File::create(out.join("long.toml")).expect("a file");
    endless.set_len(1 << 23).expect("a long file");
    refused(&["verify", out.join("long.toml").to_str().expect("UTF-8")], "longer than 4194304 bytes");
    refused(&["verify", "--example", "--schema"], "--schema");
}

/// A mark at the beginning, line ends of two characters and tabs are no mistakes.
#[test]
fn claims_files_are_read_as_editors_write_them() {
    let out = folder("editors");
    let example = stdout(&bellfit(&["verify", "--example"]));
    let plain = out.join("plain.toml");
    std::fs::write(&plain, &example).expect("writable");
    let expected = bellfit(&["verify", plain.to_str().expect("UTF-8")]);
    assert_eq!(expected.status.code(), Some(0));
    for (name, text) in [
        ("mark.toml", format!("\u{feff}{example}")),
        ("lines.toml", example.replace('\n', "\r\n")),
        ("tabs.toml", example.replace(" = ", "\t=\t")),
    ] {
        std::fs::write(out.join(name), text).expect("writable");
        let found = bellfit(&["verify", out.join(name).to_str().expect("UTF-8")]);
        assert_eq!(stdout(&found), stdout(&expected), "{name}");
    }
}

#[test]
fn the_example_claims_hold_and_a_false_one_is_refuted() {
    let example = bellfit(&["verify", "--example"]);
    assert_eq!(example.status.code(), Some(0));
    let out = folder("example");
    let path = out.join("claims.toml");
    std::fs::write(&path, &example.stdout).expect("writable");
    let path = path.to_str().expect("UTF-8");
    let verdicts = bellfit(&["verify", path]);
    assert_eq!(verdicts.status.code(), Some(0), "{}", stdout(&verdicts));
    assert_eq!(stdout(&verdicts).matches(": proved.").count(), 7);
    // What rests on quadrature holds too, and is not called proved.
    assert_eq!(stdout(&verdicts).matches(": reproduced.").count(), 1);

    let json: serde_json::Value =
        serde_json::from_slice(&bellfit(&["verify", path, "--json"]).stdout).expect("JSON");
    assert_eq!(json["version"], 1);
    assert_eq!(json["judgements"].as_array().map(Vec::len), Some(8));
    assert_eq!(json["judgements"][0]["verdict"], "proved");

    // 1.07 n/2π on the whole support is 1.07 · 16/17 - 1 = 7.0588e-3 too much at every n.
    let planted = stdout(&example)
        .replace("(1.0625*n + 0.9445)", "1.07*n")
        .replace("\"phong-modified\"\nlobe", "\"phong\"\nlobe")
        .replace("\"phong-modified\"\nlimit", "\"phong\"\nlimit");
    std::fs::write(path, planted).expect("writable");
    let verdicts = bellfit(&["verify", path]);
    assert_eq!(verdicts.status.code(), Some(1), "{}", stdout(&verdicts));
    let text = stdout(&verdicts);
    assert!(text.contains("residual/integers: refuted. stated 5e-3; computed 7.0588e-3; n = 16"), "{text}");
    assert!(text.contains("never gains: refuted."), "{text}");
}

#[test]
fn a_fit_prints_what_it_certified() {
    // Phong's integral over the support is 16/(17 n), so the best factor is (17/16) n/(2π) exactly.
    let text = stdout(&bellfit(&["fit", "--model", "phong", "--objective", "ls-relative"]));
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("phong, cs16, support, n = 16..1024, ls-relative"));
    assert_eq!(lines.next(), Some("coef(n) = 1.0625 n/(2π)"));
    assert_eq!(lines.next(), Some("residual 2π coef(n) Int(n) - 1, certified:"));
    let json = bellfit(&["fit", "--model", "phong", "--form", "proportional", "--n", "20..30", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).expect("JSON");
    assert_eq!((&json["a"], &json["b"]), (&"1.0625".into(), &"0".into()));
    assert!(json["max_residual"].as_f64().is_some_and(|r| r.abs() < 1e-12));
    // To three digits the residual certified is that of the rounded 1.06: 1.06 · 16/17 - 1.
    let rounded = bellfit(&["fit", "--model", "phong", "--digits", "3", "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&rounded.stdout).expect("JSON");
    assert!((json["max_residual"].as_f64().expect("a number") - (1.06 * 16.0 / 17.0 - 1.0)).abs() < 1e-12);
}

#[test]
fn help_and_version_go_to_stdout() {
    for arguments in [&["--help"][..], &["fit", "--help"], &["verify", "--help"], &["reproduce", "--help"]] {
        let output = bellfit(arguments);
        assert_eq!(output.status.code(), Some(0));
        assert!(stdout(&output).contains("Examples:"), "{arguments:?}");
    }
    assert!(stdout(&bellfit(&["--version"])).contains(env!("CARGO_PKG_VERSION")));
}

#[test]
fn a_misspelt_word_is_told_with_the_one_that_was_meant() {
    refused(&["verfy"], "(a similar subcommand exists: 'verify')");
    refused(&["fit", "--modell", "phong"], "(a similar argument exists: '--model')");
}
