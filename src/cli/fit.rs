//! `bellfit fit`.

use super::{Outcome, print};
use crate::fit::{Form, Objective, Problem, fit_case};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::parse_range;
use crate::report::{fit_json, fit_lines};
use anyhow::{Result, bail};
use clap::Args;

/// Fit coef(n) = (a n + b)/(divisor π) to one model's integral and certify the residual.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  bellfit fit --model phong
  bellfit fit --model blinn-phong --limit paper --objective ls-absolute --digits 4
  bellfit fit --model blinn-phong-modified --n 32..256 --json")]
pub struct Arguments {
    /// phong, phong-modified, blinn-phong, blinn-phong-modified, blinn-phong-ndf or blinn-phong-heightfield.
    #[arg(long, value_name = "MODEL", value_parser = model)]
    model: Model,
    /// cs16 or cos-n.
    #[arg(long, value_name = "LOBE", default_value = "cs16", value_parser = lobe)]
    lobe: Lobe,
    /// How far the lobe is integrated: support, exact-zero, paper (6/√n) or card (√(6/n)).
    #[arg(long, value_name = "LIMIT", default_value = "support", value_parser = limit)]
    limit: Limit,
    /// What is minimised: minimax, ls-relative or ls-absolute.
    #[arg(long, value_name = "OBJECTIVE", default_value = "minimax", value_parser = objective)]
    objective: Objective,
    /// The specular exponents to fit, whole numbers, ends included.
    #[arg(long, value_name = "A..B", default_value = "16..1024", value_parser = parse_range, allow_hyphen_values = true)]
    n: (u32, u32),
    /// linear (a n + b) or proportional (a n).
    #[arg(long, value_name = "FORM", default_value = "linear", value_parser = form)]
    form: Form,
    /// Significant decimals of a and b, 1 to 15; the residual is certified after rounding.
    #[arg(long, value_name = "DIGITS", default_value = "12", value_parser = clap::value_parser!(u8).range(1..=15))]
    digits: u8,
    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    let Arguments { model, lobe, limit, objective, n, form, digits, json } = *arguments;
    if !lobe.limits().contains(&limit) {
        bail!("--limit {}: lobe {} is integrated over its support only", limit.id(), lobe.id());
    }
    let problem = Problem::new(Case { model, lobe, limit }, n.0, n.1)?;
    let row = fit_case(&problem, objective, form, usize::from(digits))?;
    print(&if json { fit_json(&row, n)? } else { fit_lines(&row, n) })?;
    Ok(Outcome::AsExpected)
}

/// The word, or the words there are.
fn known<T>(found: Option<T>, known: impl IntoIterator<Item = &'static str>) -> Result<T, String> {
    found.ok_or_else(|| format!("known are {}", known.into_iter().collect::<Vec<_>>().join(", ")))
}

fn model(word: &str) -> Result<Model, String> {
    known(Model::from_id(word), Model::ALL.map(Model::id))
}

fn lobe(word: &str) -> Result<Lobe, String> {
    known(Lobe::from_id(word), Lobe::ALL.map(Lobe::id))
}

fn limit(word: &str) -> Result<Limit, String> {
    known(Limit::from_id(word), Limit::ALL.map(Limit::id))
}

fn objective(word: &str) -> Result<Objective, String> {
    known(Objective::from_id(word), Objective::ALL.map(Objective::id))
}

fn form(word: &str) -> Result<Form, String> {
    known(Form::from_id(word), Form::ALL.map(Form::id))
}
