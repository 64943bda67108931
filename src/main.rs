//! The `bellfit` program; `bellfit --help` tells what it does.

use bellfit::cli::{Cli, Outcome};
use clap::Parser;
use clap::error::ErrorKind;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) => {
            // A closed pipe is no reason to complain about help.
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        Err(error) => return fail(&error.to_string()),
    };
    match cli.run() {
        Ok(Outcome::AsExpected) => ExitCode::SUCCESS,
        Ok(Outcome::Differs) => ExitCode::from(1),
        Err(error) => fail(&format!("{error:#}")),
    }
}

/// One line on stderr and exit code 2.
fn fail(message: &str) -> ExitCode {
    // Of clap's several paragraphs the first says what is wrong; the rest is --help.
    let first = message.split("\n\n").next().unwrap_or(message);
    let words: Vec<&str> = first.split_whitespace().collect();
    let line = words.join(" ");
    let line = line.strip_prefix("error: ").unwrap_or(&line);
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "bellfit: {line}");
    ExitCode::from(2)
}
