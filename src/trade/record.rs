//! A measurement as a file.

use super::row::{Floor, Row};
use super::{EXPONENTS, Machine, Place, Spread, Subject, TradeError};
use crate::bound::Format;
use crate::kernel::stand_in::StandIn;
use serde::{Deserialize, Serialize};
use std::collections::HashSet;

/// The version of the record's form.
pub const VERSION: u64 = 1;

/// Speed and accuracy of every subject on one machine.
///
/// As JSON one object with these fields; a [`Spread`] is `median`, `least`, `most`; rows and floors as [`Row`]
/// and [`Floor`] say. A field that is not known or missing is an error.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// [`VERSION`].
    pub version: u64,
    /// Measured on.
    pub machine: Machine,
    /// The specular exponent.
    pub n: u32,
    /// Rounds.
    pub rounds: usize,
    /// Elements of the slices in cache.
    pub elements: usize,
    /// Bytes of each slice in memory.
    pub memory: usize,
    /// Microseconds that the reference loop took: a fixed number of operations that wait for each other, timed
    /// before each round and after the last.
    pub reference: Spread,
    /// What the loops take by themselves.
    pub floors: Vec<Floor>,
    /// The measurements.
    pub rows: Vec<Row>,
}

/// What can be read of every version.
#[derive(Deserialize)]
struct Versioned {
    version: u64,
}

impl Record {
    /// Reads [`json`](Self::json)'s text.
    ///
    /// ```
    /// use bellfit::trade::{Record, TradeError};
    /// assert_eq!(Record::parse("{\"version\": 9}"), Err(TradeError::Version { found: 9 }));
    /// assert!(matches!(Record::parse("{\n"), Err(TradeError::Text { line: 2, .. })));
    /// ```
    ///
    /// # Errors
    /// [`TradeError::Version`]; [`TradeError::Text`] with the place, for text that is no such JSON and for
    /// times, errors and names outside their domains; [`TradeError::Exponent`]; [`TradeError::Twice`].
    pub fn parse(text: &str) -> Result<Record, TradeError> {
        let Versioned { version } = serde_json::from_str(text)?;
        if version != VERSION {
            return Err(TradeError::Version { found: version });
        }
        let record: Record = serde_json::from_str(text)?;
        if !EXPONENTS.contains(&record.n) {
            return Err(TradeError::Exponent { n: record.n });
        }
        let mut seen = HashSet::new();
        for row in &record.rows {
            if !seen.insert((row.subject, row.format.id(), row.place.id())) {
                let (subject, format, place) = (row.subject.id(), row.format.id(), row.place.id());
                return Err(TradeError::Twice { subject, format, place });
            }
        }
        Ok(record)
    }

    /// The record as JSON, a line a row's field.
    ///
    /// # Errors
    /// [`TradeError::Text`] should the writer refuse.
    pub fn json(&self) -> Result<String, TradeError> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// Its row of a subject, in a format and place.
    pub fn row(&self, subject: Subject, format: Format, place: Place) -> Option<&Row> {
        self.rows.iter().find(|row| (row.subject, row.format, row.place) == (subject, format, place))
    }

    /// The rows of a format and place.
    pub fn rows_of(&self, format: Format, place: Place) -> Vec<&Row> {
        self.rows.iter().filter(|row| (row.format, row.place) == (format, place)).collect()
    }

    /// What the loop takes by itself in a format and place.
    pub fn floor(&self, format: Format, place: Place) -> Option<Spread> {
        let floor = self.floors.iter().find(|floor| (floor.format, floor.place) == (format, place));
        floor.map(|floor| floor.time)
    }

    /// Median nanoseconds an element of a stand-in over a slice in cache; `None` for a format that was not
    /// measured.
    pub fn cost(&self, stand_in: StandIn, format: Format) -> Option<f64> {
        self.row(Subject::StandIn(stand_in), format, Place::Cache).map(|row| row.time.median)
    }
}

impl From<serde_json::Error> for TradeError {
    fn from(error: serde_json::Error) -> Self {
        let text = error.to_string();
        // The place is told apart from the words.
        let reason = text.split(" at line ").next().unwrap_or(&text).to_owned();
        TradeError::Text { line: error.line(), column: error.column(), reason }
    }
}
