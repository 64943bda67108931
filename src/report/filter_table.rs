//! Texture filters against the references: the table.

use super::artifacts::ArtifactError;
use super::tables::csv_bytes;
use crate::kernel::pixel::Padding;
use crate::scene::{Compared, Comparison, PictureError, Technique};
use serde::Serialize;
use std::fmt::Write;

#[derive(Serialize)]
struct Line<'a> {
    scene: &'a str,
    technique: &'a str,
    method: &'static str,
    weight: Option<&'a str>,
    sigma: Option<f32>,
    conic: Option<&'static str>,
    axes: Option<&'static str>,
    diameter: Option<u8>,
    reference: &'static str,
    rmse: f64,
    psnr: Option<f64>,
    perceptual: f64,
    mean_texels: f64,
    largest_texels: u64,
    reference_error: f64,
    gain: f64,
    alien: f64,
}

fn method_id(technique: &Technique) -> &'static str {
    use crate::filter::Method;
    match technique.method {
        Method::Nearest => "nearest",
        Method::Bilinear => "bilinear",
        Method::Trilinear => "trilinear",
        Method::Ellipse(_) => "ellipse",
    }
}

/// `fits/filter.csv`: a row a scene, technique and reference.
///
/// # Errors
/// [`ArtifactError::Table`] if it cannot be formatted.
pub fn filter_csv(comparisons: &[Comparison]) -> Result<Vec<u8>, ArtifactError> {
    let mut lines = Vec::new();
    for comparison in comparisons {
        for row in &comparison.rows {
            let filter = row.technique.filter();
            let references = &comparison.references;
            for (reference, error, own) in [
                ("area", &row.area, references.area.sampling_error),
                ("gaussian", &row.gaussian, references.gaussian.sampling_error),
            ] {
                lines.push(Line {
                    scene: &comparison.scene.name,
                    technique: &row.technique.id,
                    method: method_id(&row.technique),
                    weight: row.technique.weight,
                    sigma: row.technique.sigma(),
                    conic: filter.map(|f| if f.padding == Padding::Plain { "plain" } else { "padded" }),
                    axes: filter.map(|f| f.axes.id()),
                    diameter: filter.map(|_| row.technique.diameter),
                    reference,
                    rmse: error.rmse,
                    psnr: error.psnr.is_finite().then_some(error.psnr),
                    perceptual: error.perceptual,
                    mean_texels: row.mean_texels,
                    largest_texels: row.largest_texels,
                    reference_error: own,
                    gain: error.gain,
                    alien: error.alien,
                });
            }
        }
    }
    csv_bytes(lines)
}

fn errors(error: &PictureError) -> String {
    format!("{:.5} {:6.2} {:7.2}", error.rmse, error.psnr, error.perceptual)
}

/// The table of one scene for a terminal.
pub fn filter_lines(comparison: &Comparison) -> String {
    let references = &comparison.references;
    let mut text = format!(
        "{}, {} × {} pixels\n{:<28} {:>22}   {:>22}   {:>15}\n{:<28} {:>7} {:>6} {:>7}   {:>7} {:>6} {:>7}   {:>7} {:>7}\n",
        comparison.scene.name,
        comparison.scene.width,
        comparison.scene.height,
        "",
        "against the area",
        "against Gaussian σ ½ px",
        "texels",
        "technique",
        "rmse",
        "psnr",
        "ssim2",
        "rmse",
        "psnr",
        "ssim2",
        "mean",
        "most"
    );
    for row in &comparison.rows {
        let Compared { technique, area, gaussian, mean_texels, largest_texels, .. } = row;
        let _ = writeln!(
            text,
            "{:<28} {}   {}   {mean_texels:7.1} {largest_texels:7}",
            technique.id,
            errors(area),
            errors(gaussian)
        );
    }
    let _ = writeln!(
        text,
        "the references' own sampling error: {:.1e} and {:.1e}",
        references.area.sampling_error, references.gaussian.sampling_error
    );
    text
}
