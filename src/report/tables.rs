//! The CSV and JSON tables.

use super::artifacts::ArtifactError;
use super::study::{NearestRow, PrintedFactor, SupremumRow};
use crate::bound::{Extremes, IntegralTable};
use crate::fit::FitRow;
use crate::kernel::model::Model;
use crate::verdict::{Expectations, Judgement};
use serde::Serialize;

/// Rows as CSV with a header.
pub(super) fn csv_bytes<R: Serialize>(rows: impl IntoIterator<Item = R>) -> Result<Vec<u8>, ArtifactError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    writer.into_inner().map_err(|error| ArtifactError::Table(error.to_string()))
}

#[derive(Serialize)]
struct IntegralLine {
    model: &'static str,
    lobe: &'static str,
    limit: &'static str,
    n: u32,
    lo: f64,
    hi: f64,
    quadrature: f64,
    quadrature_error: f64,
    evaluations: u32,
}

/// `fits/integrals/<model>.csv`.
pub(super) fn integrals(tables: &[IntegralTable], model: Model) -> Result<Vec<u8>, ArtifactError> {
    let tables = tables.iter().filter(|table| table.case.model == model);
    let rows = tables.flat_map(|IntegralTable { case, rows }| {
        rows.iter().map(move |row| IntegralLine {
            model: case.model.id(),
            lobe: case.lobe.id(),
            limit: case.limit.id(),
            n: row.n,
            lo: row.enclosure.lo(),
            hi: row.enclosure.hi(),
            quadrature: row.quadrature.value,
            quadrature_error: row.quadrature.error,
            evaluations: row.quadrature.evaluations,
        })
    });
    csv_bytes(rows)
}

#[derive(Serialize)]
struct CoefficientLine<'a> {
    model: &'static str,
    lobe: &'static str,
    limit: &'static str,
    objective: &'static str,
    a: &'a str,
    b: &'a str,
    divisor: &'a str,
    max_residual: f64,
    n_at_max: u32,
    min_residual: f64,
    n_at_min: u32,
    evidence: &'static str,
    real_max_residual: f64,
    real_n_at_max: f64,
    real_min_residual: f64,
    real_n_at_min: f64,
    reading: &'a str,
}

impl<'a> CoefficientLine<'a> {
    /// Each extreme is printed by its outer end, so that the residual provably lies between them.
    fn new(
        case: crate::integral::Case,
        objective: &'static str,
        integers: &Extremes,
        reals: &Extremes,
    ) -> Self {
        CoefficientLine {
            model: case.model.id(),
            lobe: case.lobe.id(),
            limit: case.limit.id(),
            objective,
            a: "",
            b: "",
            divisor: "",
            max_residual: integers.max.value.hi(),
            n_at_max: integers.max.n as u32,
            min_residual: integers.min.value.lo(),
            n_at_min: integers.min.n as u32,
            evidence: "certified",
            real_max_residual: reals.max.value.hi(),
            real_n_at_max: reals.max.n,
            real_min_residual: reals.min.value.lo(),
            real_n_at_min: reals.min.n,
            reading: "",
        }
    }

    fn printed(p: &'a PrintedFactor) -> Self {
        let line = Self::new(p.case, "paper", &p.integers, &p.reals);
        CoefficientLine {
            a: p.line.a(),
            b: p.line.b(),
            divisor: p.line.divisor(),
            reading: &p.reading,
            ..line
        }
    }

    fn fitted(row: &'a FitRow) -> Self {
        let line = Self::new(row.case, row.objective.id(), &row.integers, &row.reals);
        CoefficientLine { a: row.line.a(), b: row.line.b(), divisor: row.line.divisor(), ..line }
    }
}

/// `fits/coefficients.csv`: for each case the printed readings, then the fits.
pub(super) fn coefficients(
    integrals: &[IntegralTable],
    printed: &[PrintedFactor],
    fits: &[FitRow],
) -> Result<Vec<u8>, ArtifactError> {
    let rows = integrals.iter().flat_map(|table| {
        let printed = printed.iter().filter(|p| p.case == table.case).map(CoefficientLine::printed);
        let fitted = fits.iter().filter(|row| row.case == table.case).map(CoefficientLine::fitted);
        printed.chain(fitted)
    });
    csv_bytes(rows)
}

#[derive(Serialize)]
struct NearestLine<'a> {
    claim: &'a str,
    model: &'static str,
    limit: &'static str,
    printed_a: &'a str,
    printed_b: &'a str,
    divisor: &'a str,
    printed_bound: &'a str,
    printed_residual: f64,
    printed_n: u32,
    nearest_a: &'a str,
    nearest_b: &'a str,
    digits_changed: Option<usize>,
    nearest_residual: Option<f64>,
    nearest_n: Option<u32>,
}

/// `fits/nearest.csv`: what a printed factor that breaks its bound should have been; the nearest
/// fields are empty where changing printed digits does not help.
pub(super) fn nearest(rows: &[NearestRow]) -> Result<Vec<u8>, ArtifactError> {
    let rows = rows.iter().map(|NearestRow { printed, nearest }| {
        let worst = printed.integers.magnitude();
        let mended = nearest.as_ref().map(|n| n.extremes.magnitude());
        NearestLine {
            claim: &printed.claim,
            model: printed.case.model.id(),
            limit: printed.case.limit.id(),
            printed_a: printed.line.a(),
            printed_b: printed.line.b(),
            divisor: printed.line.divisor(),
            printed_bound: printed.bound.as_ref().map_or("", |b| &b.text),
            printed_residual: worst.value.hi(),
            printed_n: worst.n as u32,
            nearest_a: nearest.as_ref().map_or("", |n| n.line.a()),
            nearest_b: nearest.as_ref().map_or("", |n| n.line.b()),
            digits_changed: nearest.as_ref().map(|n| n.changed),
            nearest_residual: mended.map(|m| m.value.hi()),
            nearest_n: mended.map(|m| m.n as u32),
        }
    });
    csv_bytes(rows)
}

#[derive(Serialize)]
struct SupremumLine<'a> {
    function: &'a str,
    parameter: &'a str,
    lo: f64,
    hi: f64,
    at: &'a str,
    evidence: &'static str,
}

/// `fits/suprema.csv`.
pub(super) fn suprema(rows: &[SupremumRow]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| SupremumLine {
        function: &row.function,
        parameter: &row.parameter,
        lo: row.value.lo(),
        hi: row.value.hi(),
        at: &row.at,
        evidence: "certified",
    }))
}

/// One line of `reports/verdicts.csv` and `reports/verdicts.json`.
#[derive(Serialize)]
struct VerdictLine<'a> {
    claim: &'a str,
    paper: &'a str,
    locator: &'a str,
    reading: &'a str,
    printed: &'a str,
    computed_lo: Option<f64>,
    computed_hi: Option<f64>,
    evidence: Option<&'static str>,
    verdict: &'static str,
    expected: Option<&'static str>,
    witness: &'a str,
}

fn verdict_lines<'a>(
    judgements: &'a [Judgement],
    expected: &'a Expectations,
) -> impl Iterator<Item = VerdictLine<'a>> {
    judgements.iter().map(move |j| VerdictLine {
        claim: &j.claim,
        paper: &j.paper,
        locator: &j.locator,
        reading: &j.reading,
        printed: &j.printed,
        computed_lo: j.computed.map(|c| c.lo()).filter(|x| x.is_finite()),
        computed_hi: j.computed.map(|c| c.hi()).filter(|x| x.is_finite()),
        evidence: j.evidence.map(|e| e.id()),
        verdict: j.verdict.id(),
        expected: expected.of(j).map(|e| e.verdict.id()),
        witness: &j.witness,
    })
}

/// `reports/verdicts.csv`.
pub(super) fn verdicts_csv(
    judgements: &[Judgement],
    expected: &Expectations,
) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(verdict_lines(judgements, expected))
}

/// `reports/verdicts.json`.
pub(super) fn verdicts_json(
    judgements: &[Judgement],
    expected: &Expectations,
) -> Result<Vec<u8>, ArtifactError> {
    json(verdict_lines(judgements, expected))
}

fn json<'a>(lines: impl Iterator<Item = VerdictLine<'a>>) -> Result<Vec<u8>, ArtifactError> {
    let rows: Vec<VerdictLine<'a>> = lines.collect();
    let mut bytes =
        serde_json::to_vec_pretty(&rows).map_err(|error| ArtifactError::Table(error.to_string()))?;
    bytes.push(b'\n');
    Ok(bytes)
}
