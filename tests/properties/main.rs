//! Properties of every parser, file reader and command, over input drawn by proptest from fixed seeds: laws where
//! there are any, and never a panic, minutes of work or much memory.
#![cfg(feature = "toolkit")]
#![allow(clippy::unwrap_used)] // helpers of tests may panic as tests do

mod commands;
mod damage;
mod files;
mod formulas;
mod images;
mod names;
#[path = "../support/png_file.rs"]
mod png_file;
#[path = "../support/program.rs"]
mod program;
mod ranges;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseResult, TestRng, TestRunner};

/// Runs a property over so many cases, the same on every run and machine; no file is written.
#[track_caller]
pub fn holds<S: Strategy>(seed: u8, cases: u32, input: S, property: impl Fn(S::Value) -> TestCaseResult) {
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 2000, ..Config::default() };
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    if let Err(error) = TestRunner::new_with_rng(config, rng).run(&input, property) {
        panic!("{error}");
    }
}
