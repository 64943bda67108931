//! What is wrong with measured samples, and where.

use super::column::KNOWN;
use super::{Family, NoFit};
use thiserror::Error;

/// Without the zeros of 1e60.
fn plain(value: &f64) -> String {
    if *value == 0.0 || (1e-5..1e10).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// Why samples are refused; a row is the file's line, counted from 1, or the sample's number for samples that are
/// given in memory.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DataError {
    /// Bytes that are no text.
    #[error("row {row}: not UTF-8 text")]
    NotUtf8 {
        /// Where.
        row: usize,
    },
    /// Nothing but comments.
    #[error("no header: the first row must name the columns, as in theta_deg,value")]
    Empty,
    /// Numbers where the names should be.
    #[error(
        "row {row}: \"{found}\" is no header: the first row must name the columns, as in theta_deg,value"
    )]
    NoHeader {
        /// Where.
        row: usize,
        /// The line.
        found: String,
    },
    /// A name that means nothing here.
    #[error("row {row}: unknown column \"{name}\"; {KNOWN} (divided by commas, semicolons or tabs)")]
    UnknownColumn {
        /// Where.
        row: usize,
        /// As written.
        name: String,
    },
    /// Two columns for one thing.
    #[error("row {row}: columns \"{first}\" and \"{second}\": one of them at most")]
    ColumnTwice {
        /// Where.
        row: usize,
        /// The one.
        first: String,
        /// The other.
        second: String,
    },
    /// No angles, or no values.
    #[error("row {row}: no column of the {what}; {KNOWN}")]
    NoColumn {
        /// Where.
        row: usize,
        /// `angle` or `value`.
        what: &'static str,
    },
    /// An angle of no unit.
    #[error("row {row}: column \"{name}\" says no unit: name it theta_deg or theta_rad, or give --unit")]
    NoUnit {
        /// Where.
        row: usize,
        /// As written.
        name: String,
    },
    /// Two units for one column.
    #[error("row {row}: column \"{name}\" says its unit, which is not {asked}")]
    UnitTwice {
        /// Where.
        row: usize,
        /// As written.
        name: String,
        /// The unit that was asked for.
        asked: &'static str,
    },
    /// A line of another length than the header's.
    #[error("row {row}: {found} fields under a header of {expected}{hint}")]
    Fields {
        /// Where.
        row: usize,
        /// Fields there.
        found: usize,
        /// Columns named.
        expected: usize,
        /// What may have divided it.
        hint: &'static str,
    },
    /// An empty field.
    #[error("row {row}, column {column}: missing")]
    Missing {
        /// Where.
        row: usize,
        /// Its name.
        column: String,
    },
    /// A field that is no number.
    #[error("row {row}, column {column}: \"{text}\" is not a number{hint}")]
    NotANumber {
        /// Where.
        row: usize,
        /// Its name.
        column: String,
        /// As written.
        text: String,
        /// What it may be.
        hint: &'static str,
    },
    /// NaN or infinite, or beyond the range of doubles.
    #[error("row {row}, column {column}: {text} is not finite")]
    NotFinite {
        /// Where.
        row: usize,
        /// Its name.
        column: String,
        /// As written.
        text: String,
    },
    /// A number that its column cannot hold.
    #[error("row {row}, column {column}: {shown} is not {domain}{hint}", shown = plain(.value))]
    Domain {
        /// Where.
        row: usize,
        /// Its name.
        column: String,
        /// The number.
        value: f64,
        /// What it must be.
        domain: &'static str,
        /// What it may be instead.
        hint: &'static str,
    },
    /// More rows than are read.
    #[error("row {row}: more than {most} samples")]
    TooMany {
        /// Where the first beyond stands.
        row: usize,
        /// How many are read.
        most: usize,
    },
    /// Fewer samples than the smallest fit needs.
    #[error("{found} samples{of}: at least {needed} are needed", of = if *.left_out > 0 { " of positive weight" } else { "" })]
    TooFew {
        /// How many there are.
        found: usize,
        /// One more than parameters.
        needed: usize,
        /// Samples of weight 0.
        left_out: usize,
    },
    /// Every sample at one angle.
    #[error("all {count} samples stand at {theta_deg} degrees: a width needs at least two angles")]
    OneAngle {
        /// How many.
        count: usize,
        /// Where.
        theta_deg: f64,
    },
    /// Weights that leave nothing.
    #[error("column {column}: every weight is 0")]
    NoWeight {
        /// Its name.
        column: String,
    },
    /// Nothing to fit.
    #[error("column {column}: every value is 0")]
    AllZero {
        /// Its name.
        column: String,
    },
    /// Values below 0 rather than above.
    #[error(
        "no lobe of any family nears the values: those inside it are below 0 rather than above, and a scale is positive"
    )]
    NoLobe,
    /// No family at all was asked for.
    #[error("no family to fit")]
    NoFamily,
    /// Every family that was asked for fails.
    #[error("{family}: {reason}")]
    NoFit {
        /// The first of them.
        family: Family,
        /// Why.
        reason: NoFit,
    },
}
