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
    // Of clap's several paragraphs the first says what is wrong, and one may guess what was meant; the rest is --help.
    let in_one_line = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut paragraphs = message.split("\n\n").map(in_one_line);
    let first = paragraphs.next().unwrap_or_default();
    let tip = paragraphs.find_map(|text| Some(format!(" ({})", text.strip_prefix("tip: ")?)));
    let line = format!("{}{}", first.strip_prefix("error: ").unwrap_or(&first), tip.unwrap_or_default());
    // What was given is quoted: a terminal's escape in it is shown, not sent.
    let show = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    let line: String = line.chars().map(show).collect();
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "bellfit: {line}");
    ExitCode::from(2)
}
