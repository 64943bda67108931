//! `bellfit fit`.

use super::fit_data::DataArguments;
use super::{Outcome, known, print};
use crate::fit::{DIGITS, FactorForm, Form, Objective, Problem, Reals, fit_case, fit_factor};
use crate::integral::{Case, Limit, Lobe};
use crate::kernel::model::Model;
use crate::paper::{Over, parse_range};
use crate::report::{DATA_FIT_FIELDS, factor_json, factor_lines, fit_json, fit_lines};
use anyhow::{Result, anyhow, bail};
use clap::Args;

const EXAMPLES: &str = "Examples:
  bellfit fit --model phong
  bellfit fit --model blinn-phong --limit paper --objective ls-absolute --digits 4
  bellfit fit --model blinn-phong-modified --n 32..256 --json
  bellfit fit --model blinn-phong --form ratio --n 16..inf
  bellfit fit --model blinn-phong --objective one-sided
  bellfit fit --model blinn-phong --objective one-sided-rounded --digits 4
  bellfit fit --data-example > samples.csv; bellfit fit --data samples.csv --plot samples.svg
  bellfit fit --data samples.csv --family cos-n --family cubic-4 --family schlick --json";

/// Fit a factor coef(n) = form/(divisor π) to one model's integral and certify the residual; or, with --data, lobes
/// to measured samples.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{DATA_FIT_FIELDS}"))]
pub struct Arguments {
    /// phong, phong-modified, blinn-phong, blinn-phong-modified, blinn-phong-ndf or blinn-phong-heightfield.
    #[arg(long, value_name = "MODEL", value_parser = model)]
    model: Option<Model>,
    /// cs16 or cos-n.
    #[arg(long, value_name = "LOBE", default_value = "cs16", value_parser = lobe)]
    lobe: Lobe,
    /// How far the lobe is integrated: support, exact-zero, paper (6/√n) or card (√(6/n)).
    #[arg(long, value_name = "LIMIT", default_value = "support", value_parser = limit)]
    limit: Limit,
    /// What is minimised: minimax, ls-relative or ls-absolute; one-sided never gains energy and loses
    /// least; one-sided-rounded does so among all decimals of so many digits.
    #[arg(long, value_name = "OBJECTIVE", default_value = "minimax", value_parser = objective)]
    objective: Objective,
    /// The specular exponents to fit, ends included: whole numbers; over reals any A ≥ 1, and B may be inf.
    #[arg(long, value_name = "A..B", default_value = "16..1024", allow_hyphen_values = true)]
    n: String,
    /// proportional (p0 n), linear (p0 n + p1), inverse (p0 n + p1 + p2/n), inverse-square
    /// (p0 n + p1 + p2/n + p3/n²) or ratio (p0 n + p1 + p2/(n + p3)).
    #[arg(long, value_name = "FORM", default_value = "linear", value_parser = form)]
    form: FactorForm,
    /// Whether the integers or every real n of the range count: if not given, the integers for proportional
    /// and linear by minimax or least squares, else every real n.
    #[arg(long, value_name = "OVER", value_parser = over)]
    over: Option<Over>,
    /// Significant decimals of the parameters, 1 to 15 (one-sided-rounded: 1 to 8); the residual is
    /// certified after rounding. 12, or 4 for one-sided-rounded, if not given.
    #[arg(long, value_name = "DIGITS", value_parser = clap::value_parser!(u8).range(1..=15))]
    digits: Option<u8>,
    /// Print one JSON object; the end of an endless range is null. Of --data its fields are in --help.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    data: DataArguments,
}

/// Digits of a shortest factor if none are given: as many as the papers print.
const SHORTEST: usize = 4;

pub(super) fn run(arguments: &Arguments) -> Result<Outcome> {
    let Arguments { model, lobe, limit, objective, ref n, form, over, digits, json, ref data } = *arguments;
    if let Some(outcome) = data.run(json)? {
        return Ok(outcome);
    }
    let model = model.ok_or_else(|| anyhow!("--model MODEL is needed, or --data FILE"))?;
    if !lobe.limits().contains(&limit) {
        bail!("--limit {}: lobe {} is integrated over its support only", limit.id(), lobe.id());
    }
    let case = Case { model, lobe, limit };
    let default = if objective == Objective::OneSidedRounded { SHORTEST } else { DIGITS };
    let digits = digits.map_or(default, usize::from);
    let text = if let Some(form) = line_over_integers(form, objective, over)? {
        let range = integers(n)?;
        let row = fit_case(&Problem::new(case, range.0, range.1)?, objective, form, digits)?;
        if json { fit_json(&row, range)? } else { fit_lines(&row, range) }
    } else {
        let row = fit_factor(&case, n.parse::<Reals>()?, form, objective, digits)?;
        if json { factor_json(&row)? } else { factor_lines(&row) }
    };
    print(&text)?;
    Ok(Outcome::AsExpected)
}

/// The form, if what is asked for is a line over the integers.
fn line_over_integers(form: FactorForm, objective: Objective, over: Option<Over>) -> Result<Option<Form>> {
    let one_sided = Objective::ONE_SIDED.contains(&objective);
    let is_minimax = objective == Objective::Minimax;
    let line = form.as_line().filter(|_| !one_sided);
    match over {
        Some(Over::Integers) if one_sided => {
            bail!("--over integers: {} holds for every real n", objective.id())
        }
        Some(Over::Integers) if is_minimax && line.is_none() => {
            bail!("--over integers: the minimax {} is fitted over every real n", form.id())
        }
        Some(Over::Reals) if !one_sided && !is_minimax => {
            bail!("--over reals: {} sums over whole n", objective.id())
        }
        Some(Over::Reals) => Ok(None),
        Some(Over::Integers) | None => Ok(line),
    }
}

fn integers(n: &str) -> Result<(u32, u32)> {
    match parse_range(n) {
        Ok(range) => Ok(range),
        Err(error) if n.parse::<Reals>().is_ok() => {
            bail!("{error}; real ends and inf need --over reals, which least squares do not have")
        }
        Err(error) => bail!(error),
    }
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
    let all = || Objective::ALL.into_iter().chain(Objective::ONE_SIDED);
    known(all().find(|objective| objective.id() == word), all().map(Objective::id))
}

fn form(word: &str) -> Result<FactorForm, String> {
    known(FactorForm::from_id(word), FactorForm::ALL.map(FactorForm::id))
}

fn over(word: &str) -> Result<Over, String> {
    let found = match word {
        "integers" => Some(Over::Integers),
        "reals" => Some(Over::Reals),
        _ => None,
    };
    known(found, ["integers", "reals"])
}
