//! `bellfit verify`.

use super::{Outcome, input, print};
use crate::paper::schema::SCHEMA;
use crate::paper::{ClaimsFile, EXAMPLE};
use crate::report::{judgement_lines, judgements_json};
use crate::verdict::{Judge, Verdict};
use anyhow::{Result, anyhow};
use clap::Args;
use std::path::PathBuf;

/// The longest file that is read; the papers' own are below a hundredth of it.
const LONGEST: u64 = 4 << 20;

/// Judge a claims file of your own: every reading gets a verdict with its witness, and constants that do not
/// hold get the nearest that do.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit verify --example > my-claims.toml
  bellfit verify my-claims.toml
  bellfit verify my-claims.toml --json
  generate-claims | bellfit verify -

Kinds of readings for constants of your own (all kinds and keys: bellfit verify --schema):
  normalisation          a factor within a bound, never gaining, losing at most so much; any lobe
  factor-identity        a factor of cos^n is exactly 1/(2π Int(n))
  factor-inequality      one formula is below another for every n
  energy-at-every-angle  no gain at any angle of incidence (estimated)

Exit code: 0 if every reading holds (or is a definition), 1 if one does not, 2 if the file cannot be read.")]
pub struct Arguments {
    /// The claims file (TOML, version = 1); - reads standard input.
    #[arg(value_name = "FILE", required_unless_present_any = ["example", "schema"])]
    file: Option<PathBuf>,
    /// Print the verdicts as JSON.
    #[arg(long)]
    json: bool,
    /// Print a commented claims file to start from.
    #[arg(long, conflicts_with_all = ["file", "json", "schema"])]
    example: bool,
    /// Print every kind of reading with its keys, and the fields of --json (Markdown).
    #[arg(long, conflicts_with_all = ["file", "json"])]
    schema: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    let Some(path) = &arguments.file else {
        print(if arguments.schema { SCHEMA } else { EXAMPLE })?;
        return Ok(Outcome::AsExpected);
    };
    let (name, text) = (input::name(path), input::text(path, "a claims file", LONGEST)?);
    let claims = ClaimsFile::parse(&text).map_err(|error| anyhow!("{name}: {error}"))?;
    let judgements = Judge::default().judge(&claims).map_err(|error| anyhow!("{name}: {error}"))?;
    let output = if arguments.json { judgements_json(&judgements)? } else { judgement_lines(&judgements) };
    print(&output)?;
    let fails = judgements.iter().any(|j| matches!(j.verdict, Verdict::Refuted | Verdict::Undecided));
    Ok(if fails { Outcome::Differs } else { Outcome::AsExpected })
}
