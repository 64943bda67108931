//! What the program prints.

use super::artifacts::ArtifactError;
use super::number::{enclosure, short};
use super::study::Study;
use super::summary::summaries;
use crate::bound::Extremes;
use crate::fit::FitRow;
use crate::verdict::Judgement;
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

/// One line a reading: claim, reading, verdict, numbers, witness.
pub fn judgement_lines(judgements: &[Judgement]) -> String {
    let mut text = String::new();
    for j in judgements {
        let printed = if j.printed.is_empty() { String::new() } else { format!(" stated {};", j.printed) };
        let computed = j.computed.map(|c| format!(" computed {};", enclosure(c))).unwrap_or_default();
        let _ = writeln!(
            text,
            "{}, {}: {}.{printed}{computed} {}",
            j.claim,
            j.reading,
            j.verdict.id(),
            j.witness
        );
    }
    text
}

/// A fit with its certified residuals, for readers.
pub fn fit_lines(row: &FitRow, n: (u32, u32)) -> String {
    let span = |e: &Extremes| {
        format!(
            "{} (n = {}) to {} (n = {})",
            short(e.min.value.lo()),
            short(e.min.n),
            short(e.max.value.hi()),
            short(e.max.n)
        )
    };
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
