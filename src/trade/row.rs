//! The lines of a record.

use super::{Place, Proven, Spread, Subject};
use crate::bound::Format;
use crate::kernel::exact::Cost;
use serde::{Deserialize, Serialize};

/// One subject in one format and place.
///
/// As JSON `subject`, `format` and `place` (their ids), `nanoseconds`, `least`, `most`, `operations`,
/// `divisions`, `transcendentals`, `sup_error`, `sup_at`, `mean_error`; `bound` and `rounding`, the two parts of
/// [`Proven`], null where nothing is proved.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "RowFields", into = "RowFields")]
pub struct Row {
    /// What was measured.
    pub subject: Subject,
    /// [`Format::Single`] or [`Format::Double`].
    pub format: Format,
    /// Where.
    pub place: Place,
    /// Nanoseconds an element.
    pub time: Spread,
    /// What a value costs from cos θ: [`Subject::cost`].
    pub cost: Cost,
    /// Largest error found: [`Accuracy::sup`](super::Accuracy::sup).
    pub sup_error: f64,
    /// The cosine where it is.
    pub sup_at: f64,
    /// Mean error: [`Accuracy::mean`](super::Accuracy::mean).
    pub mean_error: f64,
    /// What is proved: [`proven`](super::proven()).
    pub proven: Proven,
}

/// What a loop takes that computes nothing: one by one it hands its argument on through the same
/// barriers, else it copies the slice.
///
/// As JSON `format`, `place`, `nanoseconds`, `least`, `most`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "FloorFields", into = "FloorFields")]
pub struct Floor {
    /// The format.
    pub format: Format,
    /// Where.
    pub place: Place,
    /// Nanoseconds an element.
    pub time: Spread,
}

/// A row as it is written.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct RowFields {
    subject: String,
    format: String,
    place: String,
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

/// A floor as it is written.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct FloorFields {
    format: String,
    place: String,
    nanoseconds: f64,
    least: f64,
    most: f64,
}

/// The formats that are measured.
fn format(id: &str) -> Result<Format, String> {
    let known = Format::from_id(id).filter(|format| matches!(format, Format::Single | Format::Double));
    known.ok_or_else(|| format!("format \"{id}\", where f32 and f64 are known"))
}

fn place(id: &str) -> Result<Place, String> {
    Place::from_id(id).ok_or_else(|| format!("place \"{id}\", where single, cache and memory are known"))
}

fn time(median: f64, least: f64, most: f64) -> Result<Spread, String> {
    if 0.0 < least && least <= median && median <= most && most.is_finite() {
        Ok(Spread { median, least, most })
    } else {
        Err(format!("times {least} to {most} around {median}, where 0 < least <= nanoseconds <= most"))
    }
}

impl TryFrom<RowFields> for Row {
    type Error = String;

    fn try_from(fields: RowFields) -> Result<Self, String> {
        let RowFields { subject: id, sup_error, sup_at, mean_error, bound, rounding, .. } = fields;
        let subject = Subject::from_id(&id).ok_or_else(|| format!("subject \"{id}\", which is not known"))?;
        for (name, error) in [("sup_error", sup_error), ("mean_error", mean_error)] {
            if !(error >= 0.0 && error <= sup_error) {
                return Err(format!("{name} = {error}, where 0 <= mean_error <= sup_error"));
            }
        }
        if !(0.0..=1.0).contains(&sup_at) {
            return Err(format!("sup_at = {sup_at} is no cosine in 0..1"));
        }
        for (name, bound) in [("bound", bound), ("rounding", rounding)] {
            if let Some(bound) = bound.filter(|bound| *bound < 0.0) {
                return Err(format!("{name} = {bound} is below 0"));
            }
        }
        let RowFields { operations, divisions, transcendentals, .. } = fields;
        Ok(Row {
            subject,
            format: format(&fields.format)?,
            place: place(&fields.place)?,
            time: time(fields.nanoseconds, fields.least, fields.most)?,
            cost: Cost { operations, divisions, transcendentals },
            sup_error,
            sup_at,
            mean_error,
            proven: Proven { approximation: bound, rounding },
        })
    }
}

impl From<Row> for RowFields {
    fn from(row: Row) -> Self {
        RowFields {
            subject: row.subject.id(),
            format: row.format.id().to_owned(),
            place: row.place.id().to_owned(),
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
        }
    }
}

impl TryFrom<FloorFields> for Floor {
    type Error = String;

    fn try_from(fields: FloorFields) -> Result<Self, String> {
        Ok(Floor {
            format: format(&fields.format)?,
            place: place(&fields.place)?,
            time: time(fields.nanoseconds, fields.least, fields.most)?,
        })
    }
}

impl From<Floor> for FloorFields {
    fn from(floor: Floor) -> Self {
        FloorFields {
            format: floor.format.id().to_owned(),
            place: floor.place.id().to_owned(),
            nanoseconds: floor.time.median,
            least: floor.time.least,
            most: floor.time.most,
        }
    }
}
