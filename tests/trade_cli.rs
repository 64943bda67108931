//! `bellfit trade`: what it prints and writes, and its refusals.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

#[path = "support/program.rs"]
mod program;

use bellfit::report::trade_files;
use bellfit::trade::{Record, Subject};
use program::{bellfit, refused};
use std::path::Path;

#[test]
fn a_quick_look_prints_the_record_and_writes_the_files() {
    let out = std::env::temp_dir().join(format!("bellfit-trade-{}", std::process::id()));
    let output = bellfit(&["trade", "--quick", "--json", "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let record = Record::parse(&text).unwrap();
    assert_eq!((record.n, record.rounds), (64, 9));
    assert_eq!(record.rows.len(), Subject::all().count() * 6);
    let mut names: Vec<String> = std::fs::read_dir(&out)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let json = names.iter().find(|name| name.ends_with(".json")).unwrap();
    assert_eq!(std::fs::read_to_string(out.join(json)).unwrap(), text);
    assert_eq!(names.len(), 5, "{names:?}");
    for name in ["trade.md", "trade.png", "trade.svg"] {
        assert!(names.iter().any(|n| n == name), "{names:?}");
    }
    std::fs::remove_dir_all(out).unwrap();
}

/// What is committed beside the record says what the record says.
#[test]
fn the_committed_page_is_that_of_its_record() {
    let folder = Path::new("reports/measured");
    let text = std::fs::read_to_string(folder.join("trade-amd-epyc.json")).unwrap();
    let files = trade_files(&Record::parse(&text).unwrap()).unwrap();
    assert_eq!(files.files().count(), 5);
    assert_eq!(files.differences(folder), Vec::<String>::new());
}

#[test]
fn bad_arguments_get_one_line() {
    refused(&["trade", "--fast"], "--fast");
    refused(&["trade", "--n", "15"], "15 is not in 16..=65536");
    refused(&["trade", "--n", "64.5"], "64.5");
    refused(&["trade", "--quick", "--out", env!("CARGO_BIN_EXE_bellfit")], "not a folder");
    // A folder that cannot be made is told before anything is measured.
    let inside = format!("{}/inside", env!("CARGO_BIN_EXE_bellfit"));
    refused(&["trade", "--out", &inside], "inside");
}
