//! Claims, expected verdicts, scenes, needs and records: whole, damaged, and not files at all.

use crate::damage::{apply, damage};
use crate::holds;
use bellfit::choose::{EXAMPLE_NEEDS, SceneNeeds};
use bellfit::paper::{ClaimsFile, EXAMPLE, LOBE_PAPER, PIXEL_PAPER};
use bellfit::scene::{EXAMPLE_SCENE, SceneFile};
use bellfit::trade::{Record, TradeError};
use bellfit::verdict::{EXPECTED, EXPECTED_PIXEL, Expectations};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use std::cell::Cell;
use std::path::Path;

/// A place in the text, and one line of printable words.
fn is_told(text: &str, line: usize, column: usize, message: &str) -> TestCaseResult {
    let lines: Vec<&str> = text.split('\n').collect();
    prop_assert!((1..=lines.len()).contains(&line), "line {} of {}: {}", line, lines.len(), message);
    let width = lines[line - 1].chars().count();
    prop_assert!((1..=width + 1).contains(&column), "column {} of {}: {}", column, width, message);
    prop_assert!(!message.is_empty() && !message.contains(char::is_control), "{:?}", message);
    Ok(())
}

fn claims(text: &str, read: &Cell<u32>) -> TestCaseResult {
    match ClaimsFile::parse(text) {
        Ok(file) => {
            read.set(read.get() + 1);
            let mut ids: Vec<&String> = file.claims.iter().map(|claim| &claim.id).collect();
            ids.sort();
            prop_assert!(ids.windows(2).all(|pair| pair[0] != pair[1]));
            for claim in &file.claims {
                let mut ids: Vec<&String> = claim.readings.iter().map(|reading| &reading.id).collect();
                ids.sort();
                prop_assert!(!ids.is_empty() && ids.windows(2).all(|pair| pair[0] != pair[1]));
            }
            // What stands behind the end, or a carriage return before it, means nothing.
            let same = format!("{}\n\n# end\n", text.replace("\r\n", "\n").trim_end());
            prop_assert_eq!(ClaimsFile::parse(&same), Ok(file));
            Ok(())
        }
        Err(error) => is_told(text, error.line, error.column, &error.message),
    }
}

fn needs(text: &str, read: &Cell<u32>) -> TestCaseResult {
    match SceneNeeds::parse(text) {
        Ok(needs) => {
            read.set(read.get() + 1);
            prop_assert!(needs.materials.len() + needs.surfaces.len() > 0);
            prop_assert!(needs.most_cost.is_none_or(|cost| cost > 0.0 && cost.is_finite()));
            for material in &needs.materials {
                prop_assert!(material.need.check().is_ok());
                prop_assert!(material.need.max_error > 0.0 && material.need.max_error <= 1.0);
            }
            for surface in &needs.surfaces {
                let (shape, (from, to)) = (&surface.shape, surface.shape.ratio);
                prop_assert!(shape.longest > 0.0 && shape.longest.is_finite() && from > 0.0 && from <= to);
            }
            prop_assert_eq!(SceneNeeds::parse(&format!("{}\n\n", text.trim_end())), Ok(needs));
            Ok(())
        }
        Err(error) => is_told(text, error.line, error.column, &error.message),
    }
}

fn scene(text: &str, read: &Cell<u32>) -> TestCaseResult {
    let parse = |text: &str| SceneFile::parse(text, "mine", Path::new("."));
    match parse(text) {
        Ok(file) => {
            read.set(read.get() + 1);
            prop_assert!(file.scene.check().is_ok() && !file.techniques.is_empty());
            prop_assert_eq!(parse(&format!("{}\n\n", text.trim_end())), Ok(file));
            Ok(())
        }
        Err(error) => is_told(text, error.line, error.column, &error.message),
    }
}

fn expectations(text: &str, read: &Cell<u32>) -> TestCaseResult {
    match Expectations::parse(text) {
        Ok(file) => {
            read.set(read.get() + 1);
            prop_assert_eq!(Expectations::parse(&format!("{}\n\n", text.trim_end())), Ok(file));
        }
        Err(error) => prop_assert!(error.to_string().starts_with("expected verdicts: "), "{}", error),
    }
    Ok(())
}

fn record(text: &str, read: &Cell<u32>) -> TestCaseResult {
    match Record::parse(text) {
        Ok(record) => {
            read.set(read.get() + 1);
            prop_assert!((16..=65_536).contains(&record.n));
            for row in &record.rows {
                prop_assert!(
                    0.0 < row.time.least && row.time.least <= row.time.median && row.time.most.is_finite()
                );
            }
            // What is printed reads back.
            prop_assert_eq!(Record::parse(&record.json().unwrap()), Ok(record));
            Ok(())
        }
        Err(TradeError::Text { line, column, reason }) => {
            // serde_json counts columns in bytes, 0 at a line's start.
            prop_assert!(line <= text.split('\n').count() && column <= text.len() && !reason.is_empty());
            Ok(())
        }
        Err(TradeError::Version { found }) => {
            prop_assert!(found != 1);
            Ok(())
        }
        Err(TradeError::Exponent { n }) => {
            prop_assert!(!(16..=65_536).contains(&n));
            Ok(())
        }
        Err(TradeError::Twice { .. }) => Ok(()),
        Err(error) => {
            prop_assert!(false, "{}", error);
            Ok(())
        }
    }
}

/// The committed record, three rows of it.
fn small_record() -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/measured");
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let path = paths.iter().find(|path| path.extension().is_some_and(|e| e == "json")).unwrap();
    let mut record = Record::parse(&std::fs::read_to_string(path).unwrap()).unwrap();
    record.rows.truncate(3);
    record.json().unwrap()
}

/// Reads a text, counts it if it is accepted, and says whether what holds of it does.
type Reader = fn(&str, &Cell<u32>) -> TestCaseResult;

fn readers() -> Vec<(Reader, String, u32)> {
    // Of the papers' long files the first claims: what follows is of the same kinds.
    let first = |text: &str, mark: &str, count: usize| {
        let parts: Vec<&str> = text.split_inclusive(mark).take(count).collect();
        parts.concat().strip_suffix(mark).unwrap().to_owned()
    };
    vec![
        (claims, EXAMPLE.to_owned(), 400),
        (claims, first(LOBE_PAPER, "\n[[claim]]", 8), 150),
        (claims, first(PIXEL_PAPER, "\n[[claim]]", 8), 150),
        (needs, EXAMPLE_NEEDS.to_owned(), 600),
        (scene, EXAMPLE_SCENE.to_owned(), 600),
        (expectations, first(EXPECTED, "\n[[expect]]", 20), 150),
        (expectations, first(EXPECTED_PIXEL, "\n[[expect]]", 20), 150),
        (record, small_record(), 400),
    ]
}

#[test]
fn whole_files_are_read() {
    for text in [EXAMPLE, LOBE_PAPER, PIXEL_PAPER] {
        assert!(ClaimsFile::parse(text).is_ok());
    }
    assert!(SceneNeeds::parse(EXAMPLE_NEEDS).is_ok() && Record::parse(&small_record()).is_ok());
    assert!(SceneFile::parse(EXAMPLE_SCENE, "mine", Path::new(".")).is_ok());
    assert!(Expectations::parse(EXPECTED).is_ok() && Expectations::parse(EXPECTED_PIXEL).is_ok());
    for (reader, text, _) in readers() {
        let accepted = Cell::new(0);
        reader(&text, &accepted).unwrap();
        assert_eq!(accepted.get(), 1);
    }
}

#[test]
fn damaged_files_are_read_within_their_domain_or_refused_at_their_place() {
    for (i, (reader, text, cases)) in readers().into_iter().enumerate() {
        let accepted = Cell::new(0);
        holds(40 + i as u8, cases, damage(), |damage| {
            // What is not UTF-8 never reaches a reader: the program refuses it.
            reader(&String::from_utf8_lossy(&apply(&text, &damage)), &accepted)
        });
        // Some damage is none, most is: both ways are walked.
        let accepted = accepted.get();
        assert!(accepted >= 1 && accepted <= cases / 2, "reader {i}: {accepted} of {cases} are read");
    }
}

#[test]
fn bytes_that_are_no_files_are_refused() {
    let bytes = proptest::collection::vec(any::<u8>(), 0..300);
    let words = [
        "version",
        "=",
        "1",
        "[[claim]]",
        "[budget]",
        "{",
        "}",
        "\"",
        "\n",
        "id",
        ":",
        "[",
        "]",
        "1e999",
        ",",
        ".",
        "'''",
    ];
    let text =
        proptest::collection::vec(proptest::sample::select(words.to_vec()), 0..40).prop_map(|w| w.concat());
    let any = prop_oneof![bytes.prop_map(|bytes| String::from_utf8_lossy(&bytes).into_owned()), text];
    let accepted = Cell::new(0);
    holds(60, 1500, any, |text| {
        for reader in [claims, needs, scene, expectations, record] {
            reader(&text, &accepted)?;
        }
        Ok(())
    });
    // Nesting is no way to the stack's end.
    for deep in ["[".repeat(100_000), "{\"a\":".repeat(100_000), format!("a = {}", "[".repeat(100_000))] {
        for reader in [claims, needs, scene, expectations, record] {
            reader(&deep, &accepted).unwrap();
        }
    }
}

/// Lists multiply: an entry of a few kilobytes could ask for more readings than memory holds.
#[test]
fn lists_of_words_cannot_exhaust_memory() {
    let words = ["\"phong\""; 60].join(", ");
    let mut text =
        "version = 1\n[[claim]]\nid = \"a\"\npaper = \"p\"\nlocator = \"l\"\ntext = \"t\"\n".to_owned();
    text += "[[claim.reading]]\nid = \"r\"\nkind = \"factor-residual\"\n";
    for key in
        ["model", "lobe", "limit", "objective", "over", "statistic", "relation", "tilt", "weight", "shape"]
    {
        text += &format!("{key} = [{words}]\n");
    }
    let error = ClaimsFile::parse(&text).unwrap_err();
    assert!(error.message.contains("more than 1024 readings"), "{error}");
    assert_eq!(error.line, 11, "{error}");
}
