//! The files of a trade record.

use super::artifacts::{ArtifactError, Artifacts};
use super::figures::render;
use super::tables::csv_bytes;
use super::trade_figure::figure;
use super::trade_table::markdown;
use crate::trade::{Record, Row, file_name};
use serde::Serialize;

#[derive(Serialize)]
struct Line<'a> {
    machine: &'a str,
    n: u32,
    subject: String,
    format: &'static str,
    place: &'static str,
    nanoseconds: f64,
    least: f64,
    most: f64,
    operations: u32,
    divisions: u32,
    transcendentals: u32,
    sup_error: f64,
    sup_at: f64,
    mean_error: f64,
    bound: Option<f64>,
    rounding: Option<f64>,
}

/// The files of `bellfit trade --out`: `trade-<machine>.csv` and `.json`, and, of the last measurement,
/// `trade.md` and the plot of error against time.
///
/// # Errors
/// [`ArtifactError`] if one cannot be made.
pub fn trade_files(record: &Record) -> Result<Artifacts, ArtifactError> {
    let machine = record.machine.processor.as_str();
    let line = |row: &Row| Line {
        machine,
        n: record.n,
        subject: row.subject.id(),
        format: row.format.id(),
        place: row.place.id(),
        nanoseconds: row.time.median,
        least: row.time.least,
        most: row.time.most,
        operations: row.cost.operations,
        divisions: row.cost.divisions,
        transcendentals: row.cost.transcendentals,
        sup_error: row.sup_error,
        sup_at: row.sup_at,
        mean_error: row.mean_error,
        bound: row.proven.approximation,
        rounding: row.proven.rounding,
    };
    let json = record.json().map_err(|error| ArtifactError::Table(error.to_string()))?;
    let stem = format!("trade-{}", file_name(machine));
    let mut files = Artifacts::default();
    for (name, bytes) in render(&[figure(record)])? {
        files.insert(&name, bytes);
    }
    files.insert(&format!("{stem}.csv"), csv_bytes(record.rows.iter().map(line))?);
    files.insert(&format!("{stem}.json"), json.into_bytes());
    files.insert("trade.md", markdown(record).into_bytes());
    Ok(files)
}
