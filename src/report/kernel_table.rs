//! The tables of bells: `fits/kernels.csv` and `fits/kernels-cosn.csv`.

use super::artifacts::ArtifactError;
use super::tables::csv_bytes;
use crate::fit::bell::{CosineBell, ExponentialBell};
use serde::Serialize;

#[derive(Serialize)]
struct ExponentialLine {
    target: &'static str,
    power: u32,
    degree: u32,
    c1: f64,
    c2: f64,
    c3: f64,
    max_error: f64,
    at: f64,
    operations: u32,
    continuous: bool,
    monotone: bool,
    evidence: &'static str,
    shape: &'static str,
    cut: f64,
    operations_from_cos: u32,
    best_of_shape: f64,
    printed: bool,
}

/// `fits/kernels.csv`; errors by their upper ends. `best_of_shape` is the polished level before rounding,
/// an estimate; `printed` marks the papers' own.
pub(super) fn exponential(rows: &[ExponentialBell]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| {
        let [c1, c2, c3] = row.coefficients;
        ExponentialLine {
            target: "exp",
            power: row.power,
            degree: row.shape.degree(),
            c1,
            c2,
            c3,
            max_error: row.error.value.hi(),
            at: row.error.at[0],
            operations: row.cost.from_t,
            continuous: row.proof.continuous,
            monotone: row.proof.decreasing,
            evidence: "certified",
            shape: row.shape.id(),
            cut: row.cut,
            operations_from_cos: row.cost.from_cos,
            best_of_shape: row.level,
            printed: row.printed,
        }
    }))
}

#[derive(Serialize)]
struct CosineLine {
    target: &'static str,
    power: u32,
    degree: u32,
    t0: f64,
    t1: f64,
    t2: f64,
    alpha0: f64,
    alpha1: f64,
    alpha2: f64,
    beta0: f64,
    beta1: f64,
    beta2: f64,
    n_from: f64,
    max_error: f64,
    n_at_max: f64,
    t_at_max: f64,
    operations_from_t: u32,
    operations_from_cos: u32,
    continuous: bool,
    monotone: bool,
    evidence: &'static str,
    shape: &'static str,
    limit_error: f64,
    printed: bool,
    operations_unfused: u32,
    form: &'static str,
}

/// What the columns t0 to beta2 are.
const FORM: &str = "max(0, (1 - y)(1 + alpha y + beta y^2))^power, y = n (1 - cos)/t; \
                    t = t0 + t1/n + t2/n^2 and so alpha, beta";

/// `fits/kernels-cosn.csv`; errors by their upper ends, over every angle and every real n from `n_from`;
/// `limit_error` is the level of n → ∞, an estimate of what no such formula can be below.
pub(super) fn cosine(rows: &[CosineBell]) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(rows.iter().map(|row| {
        let [t0, t1, t2] = row.formula.reach;
        let [alpha0, alpha1, alpha2] = row.formula.linear;
        let [beta0, beta1, beta2] = row.formula.square;
        CosineLine {
            target: "cos-n",
            power: row.formula.power,
            degree: row.shape.degree(),
            t0,
            t1,
            t2,
            alpha0,
            alpha1,
            alpha2,
            beta0,
            beta1,
            beta2,
            n_from: row.from,
            max_error: row.error.value.hi(),
            n_at_max: row.n_at_maximum(),
            t_at_max: row.t_at_maximum(),
            operations_from_t: row.cost.from_t,
            operations_from_cos: row.cost.from_cos,
            continuous: row.proof.continuous,
            monotone: row.proof.decreasing,
            evidence: "certified",
            shape: row.shape.id(),
            limit_error: row.limit,
            printed: row.printed,
            operations_unfused: row.cost.unfused,
            form: FORM,
        }
    }))
}
