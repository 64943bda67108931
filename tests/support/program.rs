//! The program `bellfit` as its user meets it.
#![allow(dead_code)] // every test file uses its part

use std::io::Write;
use std::process::{Command, Output, Stdio};

/// A run to its end.
pub fn bellfit(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_bellfit")).args(arguments).output().expect("the program starts")
}

/// A run to its end with something on its standard input.
pub fn fed(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_bellfit"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    // It may have refused without reading.
    let _ = child.stdin.take().expect("a pipe").write_all(input);
    child.wait_with_output().expect("the program ends")
}

/// Asserts exit code 2, one line on stderr that holds `names`, and nothing on stdout.
#[track_caller]
pub fn refused(arguments: &[&str], names: &str) {
    let output = bellfit(arguments);
    let error = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {error}");
    assert_eq!(error.lines().count(), 1, "{arguments:?}: {error}");
    assert!(error.starts_with("bellfit: ") && error.contains(names), "{arguments:?}: {error}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
}
