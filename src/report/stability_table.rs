//! The tables of rounding at the extremes, `fits/stability*.csv`.

use super::artifacts::ArtifactError;
use super::tables::csv_bytes;
use crate::bound::{Format, Handed};
use crate::kernel::stand_in::StandIn;
use crate::stability::{Peak, Stability};
use serde::Serialize;

/// Every row's evidence.
const SAMPLED: &str = "sampled";

/// An error in five digits: more would say nothing of a maximum that is sampled.
fn digits(error: f64) -> String {
    if error.is_finite() { format!("{error:.4e}") } else { error.to_string() }
}

/// An argument, all its digits.
fn place(at: f64) -> String {
    format!("{at:e}")
}

#[derive(Serialize)]
struct LobeLine {
    kernel: &'static str,
    format: &'static str,
    handed: &'static str,
    n: String,
    error: String,
    /// θ in radians.
    error_at: String,
    rounding: String,
    rounding_at: String,
    evidence: &'static str,
}

/// `fits/stability.csv`: a row a kernel, format, way of handing the angle over and n. `error` is against cosⁿ,
/// `rounding` against the kernel itself in exact arithmetic; empty where the kernel does not exist in the
/// format, inf or NaN where it gave that.
pub(super) fn lobes(study: &Stability) -> Result<Vec<u8>, ArtifactError> {
    let mut lines = Vec::new();
    for stand_in in StandIn::ALL {
        for format in Format::ALL {
            for handed in Handed::ALL {
                let own = |row: &&crate::stability::LobeRow| {
                    (row.stand_in, row.format, row.handed) == (stand_in, format, handed)
                };
                lines.extend(study.lobes.iter().filter(own).map(|row| {
                    let column = |of: &dyn Fn(Peak) -> String, total: bool| {
                        row.errors.map_or(String::new(), |e| of(if total { e.total } else { e.rounding }))
                    };
                    let (value, theta) = (|peak: Peak| digits(peak.value), |peak: Peak| place(peak.theta));
                    LobeLine {
                        kernel: stand_in.id(),
                        format: format.id(),
                        handed: handed.id(),
                        n: row.n.to_string(),
                        error: column(&value, true),
                        error_at: column(&theta, true),
                        rounding: column(&value, false),
                        rounding_at: column(&theta, false),
                        evidence: SAMPLED,
                    }
                }));
            }
        }
    }
    csv_bytes(lines)
}

#[derive(Serialize)]
struct FactorLine {
    factor: &'static str,
    format: &'static str,
    n: String,
    relative: String,
    model: &'static str,
    n_at: String,
    evidence: &'static str,
}

/// `fits/stability-factors.csv`: the largest relative error over the models and the n from one row's to the
/// next's; empty where n or the factor is beyond the format.
pub(super) fn factors(study: &Stability) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(study.factors.iter().map(|row| FactorLine {
        factor: row.factor.id(),
        format: row.format.id(),
        n: row.n.to_string(),
        relative: row.relative.map_or(String::new(), |(error, _, _)| digits(error)),
        model: row.relative.map_or("", |(_, model, _)| model.id()),
        n_at: row.relative.map_or(String::new(), |(_, _, n)| n.to_string()),
        evidence: SAMPLED,
    }))
}

#[derive(Serialize)]
struct FootprintLine {
    form: &'static str,
    format: &'static str,
    aspect: String,
    scale: String,
    measure: &'static str,
    error: String,
    ux: String,
    vx: String,
    uy: String,
    vy: String,
    u: String,
    v: String,
    evidence: &'static str,
}

/// `fits/stability-footprint.csv`: the largest error of Q ≤ 1, absolute or relative as the form's page states
/// its accuracy, with the Jacobian and the point where; inf or NaN where the form gave that.
pub(super) fn footprints(study: &Stability) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(study.footprints.iter().map(|row| FootprintLine {
        form: row.form.id(),
        format: row.format.id(),
        aspect: row.aspect.to_string(),
        scale: place(row.scale),
        measure: if row.form.is_relative() { "relative" } else { "absolute" },
        error: digits(row.error),
        ux: place(row.jacobian.ux),
        vx: place(row.jacobian.vx),
        uy: place(row.jacobian.uy),
        vy: place(row.jacobian.vy),
        u: place(row.point.0),
        v: place(row.point.1),
        evidence: SAMPLED,
    }))
}

#[derive(Serialize)]
struct ClipLine {
    volume: &'static str,
    format: &'static str,
    d: String,
    error: String,
    d_at: String,
    evidence: &'static str,
}

/// `fits/stability-clip.csv`: the largest absolute error over the d from one row's to the next's, in pixels.
pub(super) fn clips(study: &Stability) -> Result<Vec<u8>, ArtifactError> {
    csv_bytes(study.clips.iter().map(|row| ClipLine {
        volume: row.clip.id(),
        format: row.format.id(),
        d: place(row.from),
        error: digits(row.error),
        d_at: place(row.at),
        evidence: SAMPLED,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::{angles, lobe_rows};

    #[test]
    fn what_does_not_exist_is_left_empty() {
        let lobes = lobe_rows(1e6, &angles(1e6));
        let study = Stability { lobes, factors: vec![], footprints: vec![], clips: vec![] };
        let text = String::from_utf8(super::lobes(&study).unwrap()).unwrap();
        let head =
            "kernel,format,handed,n,error,error_at,rounding,rounding_at,evidence\ncs-16,f16,cosine,1000000,";
        assert!(text.starts_with(head), "{text}");
        // 1e6 is beyond binary16, and a material's n is one of its constants.
        assert!(text.contains("\npow,f16,cosine,1000000,,,,,sampled\n"));
        assert_eq!(text.lines().count(), 1 + 15 * 4 * 3);
    }
}
