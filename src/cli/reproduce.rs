//! `bellfit reproduce`.

use super::{Outcome, print};
use crate::report::{Artifacts, Measured, Study, verdict_lines};
use anyhow::{Result, bail};
use clap::Args;
use std::fmt::Write;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Regenerate fits/ and reports/ from the papers' claims, and print the verdicts.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit reproduce                  into the current folder
  bellfit reproduce --out /tmp/try   elsewhere
  bellfit reproduce --check          compare, write nothing; exit code 1 if anything differs
  bellfit reproduce --adopt          also take the refitted constants into the kernels' source")]
pub struct Arguments {
    /// Folder to write into, or to compare with; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Compare with what stands in the folder and write nothing.
    #[arg(long)]
    check: bool,
    /// Write the refitted constants into src/kernel/constants.rs, and print what changes.
    #[arg(long, conflicts_with = "check")]
    adopt: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    let root = &arguments.out;
    if root.exists() && !root.is_dir() {
        bail!("{}: not a folder", root.display());
    }
    if !arguments.check {
        Artifacts::try_folder(root)?;
    }
    let start = Instant::now();
    let watched = std::io::stderr().is_terminal();
    let stages = Mutex::new(Vec::new());
    let stage = |name: &str, took: Duration| {
        if watched {
            eprintln!("{name:<24} {:>6.2} s", took.as_secs_f64());
        }
        let mut stages = stages.lock().unwrap_or_else(PoisonError::into_inner);
        stages.push(format!("{name} {:.1}", took.as_secs_f64()));
    };
    let study = Study::run(&stage)?;
    let studied = Instant::now();
    let mut artifacts = Artifacts::generate(&study, &Measured::read(root))?;
    stage("tables and plots", studied.elapsed());
    let took = start.elapsed().as_secs_f64();
    let stages = stages.into_inner().unwrap_or_else(PoisonError::into_inner).join(", ");
    let times = format!("took {took:.1} s, in parallel: {stages}");
    artifacts.splice_readme(&study, root)?;
    let constants = Artifacts::constants(&study, root)?;
    let mut text = verdict_lines(&study);
    let surprises = study.surprises();
    for surprise in &surprises {
        let _ = writeln!(text, "not as expected: {surprise}");
    }
    let stale = constants.differences(root);
    let mut outcome = if surprises.is_empty() { Outcome::AsExpected } else { Outcome::Differs };
    if arguments.check {
        let mut different = artifacts.differences(root);
        different.extend(stale);
        for difference in &different {
            let _ = writeln!(text, "differs: {difference}");
        }
        if different.is_empty() {
            let _ = writeln!(text, "\n{} files are as they would be written", artifacts.files().count());
            let _ = writeln!(text, "{times}");
        } else {
            outcome = Outcome::Differs;
        }
        print(&text)?;
        return Ok(outcome);
    }
    let written = artifacts.write(root)?;
    if arguments.adopt {
        for change in changes(&constants, root) {
            let _ = writeln!(text, "{change}");
        }
        constants.write(root)?;
    } else if !stale.is_empty() {
        let _ = writeln!(
            text,
            "the kernels' constants differ from the refit: bellfit reproduce --adopt takes them"
        );
        outcome = Outcome::Differs;
    }
    let unchanged = artifacts.files().count() - written;
    let _ = writeln!(text, "\n{written} files written, {unchanged} unchanged, in {}", root.display());
    let _ = writeln!(text, "{times}");
    print(&text)?;
    Ok(outcome)
}

/// The lines of the constants' source that go and that come.
fn changes(constants: &Artifacts, root: &std::path::Path) -> Vec<String> {
    let mut lines = Vec::new();
    for (path, bytes) in constants.files() {
        let before = std::fs::read_to_string(root.join(path)).unwrap_or_default();
        let after = String::from_utf8_lossy(bytes);
        let only = |of: &str, other: &str, sign: char| -> Vec<String> {
            of.lines()
                .filter(|l| !other.lines().any(|o| o == *l))
                .map(|l| format!("{sign} {}", l.trim()))
                .collect()
        };
        lines.extend(only(&before, &after, '-'));
        lines.extend(only(&after, &before, '+'));
    }
    lines
}
