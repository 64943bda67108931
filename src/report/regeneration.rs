//! The committed tables, a stage at a time: where the byte comparison of the whole says that a file differs,
//! these say in seconds which stage and which row.
//!
//! What the rows should be is judged elsewhere, against references; here, that nothing changed them unseen.

use super::albedo_table::{ALBEDO_DEGREES, ALBEDO_EXPONENTS, albedo_csv, albedo_suprema_csv};
use super::computed::{cubic_factors, factors, nearest_rows, printed_factors, tables_and_lines};
use super::{ArtifactError, factor_table, kernel_table, pixel, stability_table, suprema, tables};
use crate::fit::bell::{cosine_bells, exponential_bells};
use crate::fit::clip::clip_rows;
use crate::fit::{figure_weights, weight_rows};
use crate::integral::albedo::{AlbedoSubject, albedo_curves};
use crate::kernel::model::Model;
use crate::paper::ClaimsFile;
use crate::stability::Stability;
use crate::verdict::{Expectations, Judge};
use std::path::Path;

#[track_caller]
fn is_committed(path: &str, made: Result<Vec<u8>, ArtifactError>) {
    let made = String::from_utf8(made.unwrap()).unwrap();
    let committed = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap();
    for (line, (made, committed)) in made.lines().zip(committed.lines()).enumerate() {
        assert_eq!(made, committed, "{path}, line {}", line + 1);
    }
    assert_eq!(made.lines().count(), committed.lines().count(), "{path}");
}

#[test]
fn integrals_and_lines() {
    let (integrals, fits) = tables_and_lines().unwrap();
    for model in Model::ALL {
        is_committed(&format!("fits/integrals/{}.csv", model.id()), tables::integrals(&integrals, model));
    }
    let printed = printed_factors(&ClaimsFile::papers().unwrap());
    is_committed("fits/coefficients.csv", tables::coefficients(&integrals, &printed, &fits));
    is_committed("fits/nearest.csv", tables::nearest(&nearest_rows(&printed).unwrap()));
}

#[test]
fn suprema_of_functions() {
    is_committed("fits/suprema.csv", tables::suprema(&suprema::suprema()));
}

#[test]
fn verdicts() {
    let judged = Judge::default().judge(&ClaimsFile::papers().unwrap()).unwrap();
    let expected = Expectations::papers().unwrap();
    is_committed("reports/verdicts.csv", tables::verdicts_csv(&judged, &expected));
}

#[test]
fn bells_of_the_exponential() {
    is_committed("fits/kernels.csv", kernel_table::exponential(&exponential_bells().unwrap()));
}

#[test]
fn bells_of_the_cosine_and_all_factors() {
    let bells = cosine_bells().unwrap();
    is_committed("fits/kernels-cosn.csv", kernel_table::cosine(&bells));
    let (lobe, cubic) = (factors().unwrap(), cubic_factors(&bells).unwrap());
    is_committed("fits/factors.csv", factor_table::factors_csv(lobe.iter().chain(&cubic)));
}

#[test]
fn albedo() {
    let curves = albedo_curves(&AlbedoSubject::all(), &ALBEDO_EXPONENTS, &ALBEDO_DEGREES).unwrap();
    is_committed("fits/albedo.csv", albedo_csv(&curves));
    is_committed("fits/albedo-suprema.csv", albedo_suprema_csv(&curves));
}

#[test]
fn clip_volumes() {
    is_committed("fits/clip.csv", pixel::clip_csv(&clip_rows()));
}

#[test]
fn pixel_weights() {
    is_committed("fits/pixel-weights.csv", pixel::weights_csv(&weight_rows()));
    is_committed("fits/weights.csv", pixel::texels_csv(&figure_weights()));
}

#[test]
fn footprints() {
    is_committed("fits/footprint.csv", pixel::footprint_csv());
}

#[test]
fn stability() {
    let study = Stability::run().unwrap();
    is_committed("fits/stability.csv", stability_table::lobes(&study));
    is_committed("fits/stability-factors.csv", stability_table::factors(&study));
    is_committed("fits/stability-footprint.csv", stability_table::footprints(&study));
    is_committed("fits/stability-clip.csv", stability_table::clips(&study));
}
