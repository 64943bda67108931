//! `bellfit trade`.

use super::{Outcome, print};
use crate::report::{Artifacts, trade_files, trade_lines};
use crate::trade::{EXPONENTS, Plan, measure};
use anyhow::{Result, bail};
use clap::Args;
use std::io::IsTerminal;
use std::path::PathBuf;
use std::time::Instant;

/// Measure speed against accuracy of cosⁿ and of what stands for it, on this machine.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit trade --quick                        a look, in seconds
  bellfit trade --out reports/measured         the record of this machine, with its page and plot
  bellfit trade --quick --json > record.json

Every kernel, the platform's powf and powi, and tables, in f32 and f64: one call after the other, slices in
cache, slices in memory. One thread; other work on the machine shows in the spread.")]
pub struct Arguments {
    /// Nine rounds instead of 101.
    #[arg(long)]
    quick: bool,
    /// The specular exponent, whole, 16 to 65536.
    #[arg(long, value_name = "N", default_value_t = 64,
          value_parser = clap::value_parser!(u32).range(i64::from(*EXPONENTS.start())..=i64::from(*EXPONENTS.end())))]
    n: u32,
    /// Folder to write trade-<machine>.csv and .json, trade.md and the plot into; made if it is not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the record as JSON instead of the table.
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    if let Some(out) = &arguments.out {
        if out.exists() && !out.is_dir() {
            bail!("{}: not a folder", out.display());
        }
        Artifacts::try_folder(out)?;
    }
    let watched = std::io::stderr().is_terminal();
    let start = Instant::now();
    let done = |what: &str| {
        if watched {
            eprintln!("{:>7.2} s  {what}", start.elapsed().as_secs_f64());
        }
    };
    let plan = if arguments.quick { Plan::quick(arguments.n) } else { Plan::full(arguments.n) };
    let record = measure(&plan, &done)?;
    let mut text = if arguments.json { record.json()? } else { trade_lines(&record) };
    if let Some(out) = &arguments.out {
        let artifacts = trade_files(&record)?;
        let written = artifacts.write(out)?;
        done("files");
        if !arguments.json {
            text.push_str(&format!("\n{written} files written, in {}\n", out.display()));
        }
    }
    print(&text)?;
    Ok(Outcome::AsExpected)
}
