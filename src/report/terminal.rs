//! What the program prints.

use super::artifacts::ArtifactError;
use super::number::short;
use super::study::Study;
use super::summary::summaries;
use crate::bound::Extremes;
use crate::fit::{FactorRow, FitRow, Objective};
use serde::Serialize;
use std::fmt::Write;

/// One line a claim: id, verdict, text.
pub fn verdict_lines(study: &Study) -> String {
    let mut text = String::new();
    for summary in summaries(study) {
        let _ = writeln!(text, "{:<4} {:<30} {}", summary.claim.id, summary.verdict(), summary.claim.text);
    }
    text
}

/// From the lower end of the smallest to the upper end of the largest.
fn span(e: &Extremes) -> String {
    format!(
        "{} (n = {}) to {} (n = {})",
        short(e.min.value.lo()),
        short(e.min.n),
        short(e.max.value.hi()),
        short(e.max.n)
    )
}

/// A fit with its certified residuals, for readers.
pub fn fit_lines(row: &FitRow, n: (u32, u32)) -> String {
    let mut text = format!(
        "{}, n = {}..{}, {}\ncoef(n) = {}\nresidual 2π coef(n) Int(n) - 1, certified:\n  over the integers     {}\n  over every real n     {}\n",
        row.case,
        n.0,
        n.1,
        row.objective.id(),
        row.line,
        span(&row.integers),
        span(&row.reals)
    );
    if !row.alternation.is_empty() {
        let at: Vec<String> = row.alternation.iter().map(|n| short(*n)).collect();
        let _ = writeln!(text, "before rounding the residual alternates at n = {}", at.join(", "));
    }
    text
}

#[derive(Serialize)]
struct FitJson<'a> {
    model: &'static str,
    lobe: &'static str,
    limit: &'static str,
    objective: &'static str,
    n_from: u32,
    n_to: u32,
    a: &'a str,
    b: &'a str,
    divisor: &'a str,
    max_residual: f64,
    n_at_max: f64,
    min_residual: f64,
    n_at_min: f64,
    real_max_residual: f64,
    real_n_at_max: f64,
    real_min_residual: f64,
    real_n_at_min: f64,
    evidence: &'static str,
    alternation: &'a [f64],
}

/// The same as one JSON object; a and b as strings, the decimals that were certified.
///
/// # Errors
/// If the text cannot be made, which no finite number causes.
pub fn fit_json(row: &FitRow, n: (u32, u32)) -> Result<String, ArtifactError> {
    let json = FitJson {
        model: row.case.model.id(),
        lobe: row.case.lobe.id(),
        limit: row.case.limit.id(),
        objective: row.objective.id(),
        n_from: n.0,
        n_to: n.1,
        a: row.line.a(),
        b: row.line.b(),
        divisor: row.line.divisor(),
        max_residual: row.integers.max.value.hi(),
        n_at_max: row.integers.max.n,
        min_residual: row.integers.min.value.lo(),
        n_at_min: row.integers.min.n,
        real_max_residual: row.reals.max.value.hi(),
        real_n_at_max: row.reals.max.n,
        real_min_residual: row.reals.min.value.lo(),
        real_n_at_min: row.reals.min.n,
        evidence: "certified",
        alternation: &row.alternation,
    };
    let text =
        serde_json::to_string_pretty(&json).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}

/// A factor fitted over reals with its certified residual, for readers.
pub fn factor_lines(row: &FactorRow) -> String {
    let mut text = format!(
        "{}, {}, {}, n = {}, {}, {}\ncoef(n) = {}\nresidual 2π coef(n) Int(n) - 1, certified over every real n:\n  {}\n",
        row.model.id(),
        row.lobe,
        row.limit,
        row.range,
        row.form().id(),
        row.objective.id(),
        row.factor,
        span(&row.extremes),
    );
    let (optimum, excess) = (short(row.optimum), short(row.excess));
    let sentence = match (Objective::ONE_SIDED.contains(&row.objective), row.optimum > 0.0) {
        (true, false) => format!("it gains nothing and loses at most {excess}"),
        (true, true) => format!(
            "it gains nothing; this form must lose {} somewhere, and this factor loses at most {excess} more",
            short(row.least_loss())
        ),
        (false, false) => format!("its |residual| is at most {excess}"),
        (false, true) => format!(
            "|residual| of this form must reach {optimum} somewhere; this factor's exceeds that by at most {excess}"
        ),
    };
    let _ = writeln!(text, "{sentence}");
    if row.objective == Objective::Minimax && !row.alternation.is_empty() {
        let at: Vec<String> = row.alternation.iter().map(|n| short(*n)).collect();
        let _ = writeln!(text, "before rounding the residual alternates at n = {}", at.join(", "));
    }
    text
}

#[derive(Serialize)]
struct FactorJson<'a> {
    model: &'static str,
    lobe: &'a str,
    limit: &'static str,
    form: &'static str,
    formula: &'static str,
    objective: &'static str,
    n_from: f64,
    n_to: Option<f64>,
    parameters: &'a [String],
    divisor: u32,
    digits: usize,
    max_residual: f64,
    n_at_max: Option<f64>,
    min_residual: f64,
    n_at_min: Option<f64>,
    over: &'static str,
    evidence: &'static str,
    optimum: f64,
    excess: f64,
    alternation: Vec<Option<f64>>,
}

/// The same as one JSON object; parameters as strings, the decimals that were certified, and an infinite
/// n as null.
///
/// # Errors
/// If the text cannot be made, which no finite number causes.
pub fn factor_json(row: &FactorRow) -> Result<String, ArtifactError> {
    let finite = |n: f64| Some(n).filter(|n| n.is_finite());
    let json = FactorJson {
        model: row.model.id(),
        lobe: &row.lobe,
        limit: row.limit,
        form: row.form().id(),
        formula: row.form().formula(),
        objective: row.objective.id(),
        n_from: row.range.from(),
        n_to: finite(row.range.to()),
        parameters: row.factor.parameters(),
        divisor: row.factor.divisor(),
        digits: row.digits,
        max_residual: row.extremes.max.value.hi(),
        n_at_max: finite(row.extremes.max.n),
        min_residual: row.extremes.min.value.lo(),
        n_at_min: finite(row.extremes.min.n),
        over: FactorRow::OVER,
        evidence: "certified",
        optimum: row.optimum,
        excess: row.excess,
        alternation: row.alternation.iter().map(|n| finite(*n)).collect(),
    };
    let text =
        serde_json::to_string_pretty(&json).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}
