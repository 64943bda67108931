//! Lobes fitted to measured samples, for programs.

use super::artifacts::ArtifactError;
use super::data_fit_code::data_fit_code;
use crate::fit::measured::{CONFIDENCE, Comparison, Estimate, Samples, Weighting};
use serde::Serialize;

/// The fields of [`data_fit_json`], as `bellfit fit --help` prints them.
pub const DATA_FIT_FIELDS: &str = include_str!("data_fit_json.md");

/// The version of the fields' names and meaning.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct ComparisonJson<'a> {
    version: u32,
    samples: usize,
    left_out: usize,
    angles: usize,
    unit: &'static str,
    weighting: &'static str,
    may_be_radians: bool,
    evidence: &'static str,
    confidence: f64,
    best: &'static str,
    told_apart: bool,
    doubts: Vec<String>,
    as_good: Vec<&'static str>,
    cheapest: &'static str,
    code: String,
    not_final: Option<String>,
    families: Vec<EstimateJson>,
    not_fitted: Vec<FailureJson<'a>>,
}

#[derive(Serialize)]
struct FailureJson<'a> {
    family: &'a str,
    reason: String,
}

#[derive(Serialize)]
struct EstimateJson {
    family: &'static str,
    scale: f64,
    scale_error: Option<f64>,
    scale_interval: Option<(f64, f64)>,
    n: f64,
    n_error: Option<f64>,
    n_interval: Option<(f64, f64)>,
    alpha: Option<f64>,
    alpha_error: Option<f64>,
    beta: Option<f64>,
    beta_error: Option<f64>,
    correlation: Option<f64>,
    no_uncertainty: Option<String>,
    degrees_of_freedom: usize,
    chi_square: f64,
    reduced_chi_square: Option<f64>,
    p_below: Option<f64>,
    p_above: Option<f64>,
    rms: f64,
    largest_residual: f64,
    largest_residual_theta_deg: f64,
    largest_residual_row: usize,
    bic: f64,
    bic_difference: f64,
    trend: Option<f64>,
    trend_error: Option<f64>,
    is_misfit: Option<bool>,
    operations: u32,
    divisions: u32,
    transcendentals: u32,
}

/// A comparison as one JSON object.
///
#[doc = include_str!("data_fit_json.md")]
///
/// # Errors
/// If the text cannot be made, which no finite number causes.
pub fn data_fit_json(samples: &Samples, found: &Comparison) -> Result<String, ArtifactError> {
    let json = ComparisonJson {
        version: VERSION,
        samples: found.counted,
        left_out: found.left_out,
        angles: found.angles,
        unit: samples.unit().id(),
        weighting: match found.weighting {
            Weighting::Equal => "equal",
            Weighting::Weight => "weight",
            Weighting::Sigma => "sigma",
        },
        may_be_radians: samples.may_be_radians(found.best().n),
        evidence: "estimated",
        confidence: CONFIDENCE,
        best: found.best().family.id(),
        told_apart: found.is_told_apart(),
        doubts: found.doubts().iter().map(ToString::to_string).collect(),
        as_good: found.as_good().map(|estimate| estimate.family.id()).collect(),
        cheapest: found.cheapest().family.id(),
        code: data_fit_code(found.cheapest()),
        not_final: found.cheapest().uncertainty.as_ref().err().map(ToString::to_string),
        families: found.estimates.iter().map(|e| estimate(e, found.behind(e))).collect(),
        not_fitted: found
            .failures
            .iter()
            .map(|(family, reason)| FailureJson { family: family.id(), reason: reason.to_string() })
            .collect(),
    };
    let text =
        serde_json::to_string_pretty(&json).map_err(|error| ArtifactError::Table(error.to_string()))?;
    Ok(text + "\n")
}

fn estimate(e: &Estimate, bic_difference: f64) -> EstimateJson {
    let known = e.uncertainty.as_ref().ok();
    let shape = e.family.is_free().then_some(e.shape);
    let cost = e.family.cost(e.n);
    EstimateJson {
        family: e.family.id(),
        scale: e.scale,
        scale_error: known.map(|u| u.scale),
        scale_interval: e.scale_interval(),
        n: e.n,
        n_error: known.map(|u| u.n),
        n_interval: e.n_interval(),
        alpha: shape.map(|shape| shape.linear),
        alpha_error: known.and_then(|u| u.shape).map(|(alpha, _)| alpha),
        beta: shape.map(|shape| shape.square),
        beta_error: known.and_then(|u| u.shape).map(|(_, beta)| beta),
        correlation: known.map(|u| u.correlation),
        no_uncertainty: e.uncertainty.as_ref().err().map(ToString::to_string),
        degrees_of_freedom: e.freedom,
        chi_square: e.chi_square,
        reduced_chi_square: e.goodness.map(|goodness| goodness.reduced),
        p_below: e.goodness.map(|goodness| goodness.below),
        p_above: e.goodness.map(|goodness| goodness.above),
        rms: e.rms,
        largest_residual: e.worst.value,
        largest_residual_theta_deg: e.worst.theta_deg,
        largest_residual_row: e.worst.row,
        bic: e.bic,
        bic_difference,
        trend: e.trend.map(|trend| trend.correlation),
        trend_error: e.trend.map(|trend| 1.0 / (trend.angles as f64).sqrt()),
        is_misfit: e.trend.map(|trend| trend.is_misfit()),
        operations: cost.operations,
        divisions: cost.divisions,
        transcendentals: cost.transcendentals,
    }
}
