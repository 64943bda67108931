//! What a measurement or a record refuses.

use thiserror::Error;

/// Why there is no [`Record`](super::Record).
///
/// ```
/// use bellfit::trade::{Plan, TradeError, measure};
/// let refused = measure(&Plan::quick(7), &|_| ());
/// assert_eq!(refused, Err(TradeError::Exponent { n: 7 }));
/// ```
#[derive(Clone, Debug, Error, PartialEq)]
pub enum TradeError {
    /// An exponent outside [`EXPONENTS`](super::EXPONENTS).
    #[error("n = {n} is not in 16..=65536")]
    Exponent {
        /// The exponent asked for.
        n: u32,
    },
    /// A plan's number outside its domain.
    #[error("{name} = {value} is not {domain}")]
    Plan {
        /// The field's name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        domain: &'static str,
    },
    /// Text that is no record of this form.
    #[error("line {line}, column {column}: {reason}")]
    Text {
        /// Where, counted from 1.
        line: usize,
        /// Where in the line, counted from 1.
        column: usize,
        /// What was expected.
        reason: String,
    },
    /// A record of another version.
    #[error("version {found} of a trade record, where 1 is known")]
    Version {
        /// The version it states.
        found: u64,
    },
    /// Two rows of one subject, format and place.
    #[error("two rows for {subject}, {format}, {place}")]
    Twice {
        /// The subject's name.
        subject: String,
        /// The format's name.
        format: &'static str,
        /// The place's name.
        place: &'static str,
    },
}
