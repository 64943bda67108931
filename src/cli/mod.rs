//! The command line: one file a subcommand, no numerics.

mod choose;
mod emit;
mod fit;
mod fit_data;
mod input;
mod render;
mod reproduce;
mod sample;
mod trade;
mod verify;

use anyhow::Result;
use clap::{Parser, Subcommand};
use std::io::Write;

/// What a run came to, as an exit code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Everything is as expected: 0.
    AsExpected,
    /// A verdict, bound or regenerated file differs, or nothing qualifies: 1.
    Differs,
}

/// Verifies, refits and improves bell-shaped kernels: specular lobes and Gaussian pixels.
///
/// Without a subcommand this is `bellfit reproduce`.
#[derive(Debug, Parser)]
#[command(
    name = "bellfit",
    version,
    args_conflicts_with_subcommands = true,
    after_help = "Examples:
  bellfit                            regenerate fits/ and reports/, print the verdicts
  bellfit --check                    compare them with what would be generated, write nothing
  bellfit verify my-claims.toml      judge your own claims
  bellfit fit --model blinn-phong    the best linear factor for a model
  bellfit fit --data samples.csv     lobes for your own measurements, with their uncertainty
  bellfit choose --n 16..256 --max-error 1e-3 --float f32
                                     the cheapest lobe inside a scene's needs
  bellfit sample texture.png --at 10,20 --jacobian 3,1,-1,2
                                     one texture lookup under a pixel
  bellfit render --image texture.png every texture filter on a plane, and its error
  bellfit trade --quick              speed against accuracy on this machine

Exit code: 0 as expected, 1 a verdict, bound or file differs or nothing qualifies, 2 bad input or usage."
)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    reproduce: reproduce::Arguments,
}

#[derive(Debug, Subcommand)]
enum Command {
    Reproduce(reproduce::Arguments),
    Verify(verify::Arguments),
    Fit(fit::Arguments),
    Choose(choose::Arguments),
    Sample(sample::Arguments),
    Render(render::Arguments),
    Trade(trade::Arguments),
}

impl Cli {
    /// Runs what was asked for.
    ///
    /// # Errors
    /// One line that names the value and the domain, for bad input and for files that cannot be
    /// read or written.
    pub fn run(self) -> Result<Outcome> {
        match self.command {
            None => reproduce::run(&self.reproduce),
            Some(Command::Reproduce(arguments)) => reproduce::run(&arguments),
            Some(Command::Verify(arguments)) => verify::run(&arguments),
            Some(Command::Fit(arguments)) => fit::run(&arguments),
            Some(Command::Choose(arguments)) => choose::run(&arguments),
            Some(Command::Sample(arguments)) => sample::run(&arguments),
            Some(Command::Render(arguments)) => render::run(&arguments),
            Some(Command::Trade(arguments)) => trade::run(&arguments),
        }
    }
}

/// Prints to stdout; a reader that has gone away (a closed pipe) is no error.
fn print(text: &str) -> Result<()> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(anyhow::anyhow!("standard output: {error}"))
        }
        _ => Ok(()),
    }
}

/// Why a file could not be read, in a few words: without the number that the system has for it.
fn reason(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or(&text).to_lowercase()
}

/// The word, or the words there are.
fn known<'a, T>(found: Option<T>, known: impl IntoIterator<Item = &'a str>) -> Result<T, String> {
    found.ok_or_else(|| format!("known are {}", known.into_iter().collect::<Vec<_>>().join(", ")))
}
