//! Pictures of the texture filters.

use super::artifacts::{ArtifactError, Artifacts};
use super::chart::label;
use super::filter_table::filter_csv;
use crate::report::figures::FigureError;
use crate::scene::{Comparison, Image, Transfer};

/// How much stronger than it is a difference is shown.
const GAIN: f32 = 4.0;

/// ½ + gain × (picture - reference) of linear light, to be written as it is: grey where they agree.
fn difference(picture: &Image, reference: &Image) -> Result<Image, ArtifactError> {
    let channels = picture.channels();
    let has_alpha = channels == 2 || channels == 4;
    let pairs = picture.values().iter().zip(reference.values());
    let values = pairs.enumerate().map(|(i, (p, r))| {
        if has_alpha && i % channels == channels - 1 { 1.0 } else { 0.5 + GAIN * (p - r) }
    });
    Ok(Image::new(picture.width(), picture.height(), channels, values.collect())?)
}

/// The files of `bellfit render`: the references, a picture and a difference a technique, the table.
///
/// # Errors
/// [`ArtifactError`] if one cannot be made.
pub fn filter_files(comparisons: &[Comparison]) -> Result<Artifacts, ArtifactError> {
    let mut files = Artifacts::default();
    for comparison in comparisons {
        let (references, scene) = (&comparison.references, &comparison.scene.name);
        let area = references.area.image.encode(Transfer::Srgb)?;
        files.insert(&format!("{scene}/reference-area.png"), area);
        let gaussian = references.gaussian.image.encode(Transfer::Srgb)?;
        files.insert(&format!("{scene}/reference-gaussian.png"), gaussian);
        for row in &comparison.rows {
            let id = &row.technique.id;
            files.insert(&format!("{scene}/{id}.png"), row.image.encode(Transfer::Srgb)?);
            let off = difference(&row.image, &references.gaussian.image)?;
            let bytes = off.encode(Transfer::Linear)?;
            files.insert(&format!("{scene}/{id}-difference.png"), bytes);
        }
    }
    files.insert("errors.csv", filter_csv(comparisons)?);
    Ok(files)
}

/// What the committed sheets show of each scene, four a row; the first is the reference.
const SHOWN: [(&str, &str); 7] = [
    ("trilinear", "trilinear"),
    ("gaussian-half-padded", "σ = ½, padded"),
    ("gaussian-third-padded", "σ = 1/3 (P4), padded"),
    ("gaussian-half", "σ = ½, plain"),
    ("paper-r1", "paper's weight R1, plain"),
    ("paper-r4", "paper's weight R4, plain"),
    ("gaussian-half-padded-conic-tilt", "σ = ½ padded, paper's axes"),
];
const COLUMNS: usize = 4;
const LABEL: usize = 16;
const GAP: usize = 4;

/// `reports/images/<scene>.png` and `<scene>-difference.png`: labelled sheets in 8-bit grey.
///
/// # Errors
/// [`ArtifactError`] if one cannot be drawn.
pub(super) fn sheets(comparisons: &[Comparison]) -> Result<Vec<(String, Vec<u8>)>, ArtifactError> {
    let mut files = Vec::new();
    for comparison in comparisons {
        let scene = &comparison.scene.name;
        let reference = &comparison.references.gaussian.image;
        let mut pictures = vec![("reference, Gaussian pixel".to_owned(), codes(reference, Transfer::Srgb))];
        let mut differences = Vec::new();
        for (id, title) in SHOWN {
            let Some(row) = comparison.row(id) else { continue };
            pictures.push((title.to_owned(), codes(&row.image, Transfer::Srgb)));
            let off = difference(&row.image, reference)?;
            differences.push((title.to_owned(), codes(&off, Transfer::Linear)));
        }
        let size = (comparison.scene.width, comparison.scene.height);
        files.push((format!("{scene}.png"), sheet(&pictures, size)?));
        files.push((format!("{scene}-difference.png"), sheet(&differences, size)?));
    }
    Ok(files)
}

/// The first channel in 8 bits.
fn codes(image: &Image, transfer: Transfer) -> Vec<u8> {
    // In 32 steps, which the eye hardly tells from 256 in patterns like these and which are half as large.
    let step = |value: f64| libm::round(libm::round(31.0 * value) * 255.0 / 31.0);
    let code = |&value: &f32| step(transfer.encode(f64::from(value).clamp(0.0, 1.0))) as u8;
    image.values().iter().step_by(image.channels()).map(code).collect()
}

fn sheet(panels: &[(String, Vec<u8>)], (width, height): (usize, usize)) -> Result<Vec<u8>, ArtifactError> {
    let rows = panels.len().div_ceil(COLUMNS);
    let (wide, tall) = (COLUMNS * (width + GAP) + GAP, rows * (height + LABEL + GAP) + GAP);
    let mut pixels = vec![255_u8; wide * tall];
    for (i, (title, picture)) in panels.iter().enumerate() {
        let (left, top) = (GAP + i % COLUMNS * (width + GAP), GAP + i / COLUMNS * (height + LABEL + GAP));
        let text =
            label(title, width, LABEL).map_err(|source| FigureError::Render { stem: "sheet", source })?;
        for (y, row) in text.chunks_exact(width).chain(picture.chunks_exact(width)).enumerate() {
            pixels[(top + y) * wide + left..][..width].copy_from_slice(row);
        }
    }
    let values = pixels.iter().map(|&code| f32::from(code) / 255.0).collect();
    Ok(Image::new(wide, tall, 1, values)?.encode(Transfer::Linear)?)
}
