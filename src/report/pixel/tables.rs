//! `fits/clip.csv`, `fits/footprint.csv`, `fits/weights.csv`, `fits/pixel-weights.csv`.

use super::footprint::footprint_rows;
use crate::fit::clip::ClipRow;
use crate::fit::{TexelWeight, WeightRow, weight_name};
use crate::report::artifacts::ArtifactError;
use crate::report::tables::csv_bytes;
use crate::verdict::Evidence;
use serde::Serialize;

#[derive(Serialize)]
struct ClipLine {
    target: &'static str,
    sigma: Option<f64>,
    points: Option<String>,
    constant: &'static str,
    objective: &'static str,
    p0: f64,
    p1: f64,
    p2: f64,
    p3: Option<f64>,
    max_error: f64,
    at: f64,
    monotone: bool,
    digits_match: bool,
    evidence: &'static str,
}

/// Of every row here: an enclosure proves it.
const EVIDENCE: &str = Evidence::Certified.id();

/// `fits/clip.csv`; `constant` is `free`, `half` or, where nothing was fitted, empty. `evidence` is that of
/// `max_error`; a best σ is an estimate always.
pub(in crate::report) fn clip_csv(rows: &[ClipRow]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| {
        let [p0, p1, p2, p3] = row.coefficients;
        ClipLine {
            target: row.target.id(),
            sigma: row.target.sigma(),
            points: row.points.map(|points| points.id()),
            constant: row.half.map_or("", |half| if half { "half" } else { "free" }),
            objective: row.objective.id(),
            p0,
            p1,
            p2,
            p3: (row.degree == 3).then_some(p3),
            max_error: row.error,
            at: row.at,
            monotone: row.monotone,
            digits_match: row.digits,
            evidence: EVIDENCE,
        }
    }))
}

#[derive(Serialize)]
struct FootprintLine {
    skew_degrees: f64,
    ratio: f64,
    major_paper: f64,
    major_true: f64,
    minor_paper: f64,
    minor_true: f64,
    area_ratio: f64,
    tilt_vector_error_degrees: Option<f64>,
    tilt_conic_error_degrees: Option<f64>,
}

/// `fits/footprint.csv`: half lengths in units of the first vector, which lies along the u axis; the area is
/// the paper's by the true.
pub(in crate::report) fn footprint_csv() -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(footprint_rows().into_iter().map(|row| FootprintLine {
        skew_degrees: row.degrees,
        ratio: row.ratio,
        major_paper: row.paper.0,
        major_true: row.axes.major,
        minor_paper: row.paper.1,
        minor_true: row.axes.minor,
        area_ratio: row.area,
        tilt_vector_error_degrees: row.vector_error,
        tilt_conic_error_degrees: row.conic_error,
    }))
}

#[derive(Serialize)]
struct TexelLine {
    weight: String,
    u: i32,
    v: i32,
    q: f64,
    weight_value: f64,
    share: f64,
}

/// `fits/weights.csv`: the texels inside the ellipse of the paper's figure; `share` is the weight by their
/// sum.
pub(in crate::report) fn texels_csv(rows: &[TexelWeight]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| TexelLine {
        weight: weight_name(row.weight),
        u: row.u,
        v: row.v,
        q: row.q,
        weight_value: row.value,
        share: row.share,
    }))
}

#[derive(Serialize)]
struct WeightLine<'a> {
    weight: &'a str,
    max_error_plane: f64,
    q_plane: f64,
    max_error_ellipse: f64,
    q_ellipse: f64,
    rim_error: f64,
    volume_ratio: f64,
    operations: u32,
    evidence: &'static str,
}

/// `fits/pixel-weights.csv`: errors against e^(-9Q/2) by their upper ends; `volume_ratio` is over the plane,
/// by closed form or a quadrature that is exact up to rounding.
pub(in crate::report) fn weights_csv(rows: &[WeightRow]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| WeightLine {
        weight: &row.name,
        max_error_plane: row.plane.value,
        q_plane: row.plane.q,
        max_error_ellipse: row.ellipse.value,
        q_ellipse: row.ellipse.q,
        rim_error: row.rim,
        volume_ratio: row.volume,
        operations: row.operations,
        evidence: EVIDENCE,
    }))
}
