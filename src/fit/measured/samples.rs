//! Measured samples, and how they are read.

use super::column::{Column, Columns, fields, shown};
use super::unit::MOST_RADIANS;
use super::{DataError, Unit};

/// What is known of the samples' noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weighting {
    /// Nothing: all alike.
    Equal,
    /// A weight each, 1/σ² up to a factor that is the same for all.
    Weight,
    /// The standard deviation σ of each, absolutely.
    Sigma,
}

/// One measured value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The file's line, counted from 1; of samples in memory their number, from 1.
    pub row: usize,
    /// |θ| in degrees, 0 to 90.
    pub theta_deg: f64,
    /// w = 1 - cos θ, 0 to 1.
    pub versine: f64,
    /// What was measured; below 0 where noise takes it there.
    pub value: f64,
    /// 1, the weight, or 1/σ²; 0: left out.
    pub weight: f64,
}

/// A set of samples that can be fitted: finite, in their unit, at two angles at least, not all 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    pub(super) all: Vec<Sample>,
    pub(super) weighting: Weighting,
    unit: Unit,
}

/// Values and weights at most so large, sigmas between its inverse and this: their squares stay finite.
const LARGEST: f64 = 1e60;
/// As many samples are read.
const MOST: usize = 5_000_000;
/// Parameters of the smallest family, and one.
pub(super) const FEWEST: usize = 3;

/// A sample as given.
struct Raw {
    row: usize,
    angle: f64,
    value: f64,
    /// Weight or σ.
    third: f64,
}

/// The columns' names, for messages.
struct Names<'a> {
    angle: &'a str,
    value: &'a str,
    third: &'a str,
}

impl Samples {
    /// Reads CSV: a header that names the columns in any order, then a sample a row.
    ///
    /// - The angle: `theta_deg`, `theta_rad`, `cos_theta` or `one_minus_cos`, in [0°, 90°] from the lobe's axis, or
    ///   on both sides of it (the sign does not count). `theta` alone needs `unit`.
    /// - The value: `value`, in any unit; the scale has the same. Then, if known, `weight` (1/σ² up to a factor,
    ///   0 leaves a row out) or `sigma` (σ in the value's unit).
    /// - Commas, semicolons or tabs; a decimal point; spaces, quotes, a byte order mark, CRLF, CR alone, a delimiter
    ///   at a row's end, empty lines and lines that begin with # do not count. Up to five million rows.
    ///
    /// # Errors
    /// [`DataError`], with row and column.
    ///
    /// ```
    /// use bellfit::fit::measured::{DataError, Samples};
    /// let samples = Samples::parse(b"theta_deg,value\n0,0.8\n10,0.7\n20,0.4\n", None)?;
    /// assert_eq!((samples.all().len(), samples.all()[2].row), (3, 4));
    /// let error = Samples::parse(b"theta_rad,value\n0,0.8\n10,0.7\n20,0.4\n", None).unwrap_err();
    /// assert!(error.to_string().starts_with("row 3, column theta_rad: 10 is not radians"));
    /// # Ok::<(), DataError>(())
    /// ```
    pub fn parse(bytes: &[u8], unit: Option<Unit>) -> Result<Self, DataError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        // Without a single line feed the lines end as on the first Macintosh.
        let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
        let text = core::str::from_utf8(bytes).map_err(|error| {
            let before = &bytes[..error.valid_up_to()];
            DataError::NotUtf8 { row: 1 + before.iter().filter(|b| **b == end).count() }
        })?;
        let mut lines = (1..).zip(text.split(char::from(end))).filter(|(_, line)| {
            let line = line.trim();
            !line.is_empty() && !line.starts_with('#')
        });
        let (row, header) = lines.next().ok_or(DataError::Empty)?;
        let columns = Columns::parse(row, header, unit)?;
        let third = columns.weight.as_ref().or(columns.sigma.as_ref());
        let mut raw = Vec::new();
        let mut read: Vec<&str> = Vec::with_capacity(columns.count);
        for (row, line) in lines {
            if raw.len() == MOST {
                return Err(DataError::TooMany { row, most: MOST });
            }
            read.clear();
            read.extend(fields(line, columns.delimiter));
            // A delimiter at the end of a row, as some spreadsheets write it, begins no field.
            if read.len() == columns.count + 1 && read.last() == Some(&"") {
                read.pop();
            }
            if read.len() != columns.count {
                // Its fields have lost the pair that stood around them.
                let is_quoted = columns.delimiter == ',' && read.iter().any(|field| field.starts_with('"'));
                let hint = if is_quoted {
                    "; a comma inside quotes divides too: decimals follow a point"
                } else {
                    ""
                };
                return Err(DataError::Fields { row, found: read.len(), expected: columns.count, hint });
            }
            let number = |column: &Column| number(row, column, read[column.at]);
            raw.push(Raw {
                row,
                angle: number(&columns.angle)?,
                value: number(&columns.value)?,
                third: third.map_or(Ok(1.0), number)?,
            });
        }
        let weighting = match (&columns.weight, &columns.sigma) {
            (Some(_), _) => Weighting::Weight,
            (_, Some(_)) => Weighting::Sigma,
            _ => Weighting::Equal,
        };
        let names = Names {
            angle: &columns.angle.name,
            value: &columns.value.name,
            third: third.map_or("weight", |column| &column.name),
        };
        Self::checked(raw, columns.unit, weighting, &names)
    }

    /// Samples in memory: angle, value, and weight or σ as `weighting` says (of [`Weighting::Equal`] the third
    /// does not count).
    ///
    /// # Errors
    /// [`DataError`], the row counted from 1 and the columns named as in a file.
    ///
    /// ```
    /// use bellfit::fit::measured::{Samples, Unit, Weighting};
    /// let rows = [(1.0, 0.8, 1.0), (0.9, 0.5, 1.0), (0.5, f64::NAN, 1.0)];
    /// let error = Samples::new(Unit::Cosine, Weighting::Equal, &rows).unwrap_err();
    /// assert_eq!(error.to_string(), "row 3, column value: NaN is not finite");
    /// ```
    pub fn new(unit: Unit, weighting: Weighting, rows: &[(f64, f64, f64)]) -> Result<Self, DataError> {
        let third = if weighting == Weighting::Sigma { "sigma" } else { "weight" };
        let names = Names { angle: unit.column(), value: "value", third };
        let mut raw = Vec::with_capacity(rows.len());
        for (row, &(angle, value, third)) in (1..).zip(rows) {
            let third = if weighting == Weighting::Equal { 1.0 } else { third };
            for (column, x) in [(names.angle, angle), (names.value, value), (names.third, third)] {
                if !x.is_finite() {
                    return Err(DataError::NotFinite { row, column: column.to_owned(), text: x.to_string() });
                }
            }
            raw.push(Raw { row, angle, value, third });
        }
        Self::checked(raw, unit, weighting, &names)
    }

    fn checked(
        raw: Vec<Raw>,
        unit: Unit,
        weighting: Weighting,
        names: &Names<'_>,
    ) -> Result<Self, DataError> {
        let mut all = Vec::with_capacity(raw.len());
        for Raw { row, angle, value, third } in raw {
            let wrong = |column: &str, value, domain, hint| DataError::Domain {
                row,
                column: column.to_owned(),
                value,
                domain,
                hint,
            };
            let (versine, theta_deg) =
                unit.read(angle).ok_or_else(|| wrong(names.angle, angle, unit.domain(), unit.hint(angle)))?;
            if value.abs() > LARGEST {
                return Err(wrong(names.value, value, "a value from -1e60 to 1e60", ""));
            }
            let weight = match weighting {
                Weighting::Equal => 1.0,
                Weighting::Weight if (0.0..=LARGEST).contains(&third) => third,
                Weighting::Weight => {
                    return Err(wrong(names.third, third, "a weight from 0 to 1e60", ""));
                }
                Weighting::Sigma if (1.0 / LARGEST..=LARGEST).contains(&third) => 1.0 / (third * third),
                Weighting::Sigma => {
                    let hint = if third == 0.0 { "; no measurement is exact" } else { "" };
                    return Err(wrong(names.third, third, "a standard deviation from 1e-60 to 1e60", hint));
                }
            };
            all.push(Sample { row, theta_deg, versine, value, weight });
        }
        let counted: Vec<&Sample> = all.iter().filter(|sample| sample.weight > 0.0).collect();
        if counted.is_empty() && !all.is_empty() {
            return Err(DataError::NoWeight { column: names.third.to_owned() });
        }
        if counted.len() < FEWEST {
            let (found, left_out) = (counted.len(), all.len() - counted.len());
            return Err(DataError::TooFew { found, needed: FEWEST, left_out });
        }
        if counted.iter().all(|sample| sample.versine == counted[0].versine) {
            return Err(DataError::OneAngle { count: counted.len(), theta_deg: counted[0].theta_deg });
        }
        if counted.iter().all(|sample| sample.value == 0.0) {
            return Err(DataError::AllZero { column: names.value.to_owned() });
        }
        Ok(Samples { all, weighting, unit })
    }

    /// The samples in the file's order, those of weight 0 among them.
    pub fn all(&self) -> &[Sample] {
        &self.all
    }

    /// What is known of their noise.
    pub fn weighting(&self) -> Weighting {
        self.weighting
    }

    /// The unit that their angles were given in.
    pub fn unit(&self) -> Unit {
        self.unit
    }

    /// Whether the angles may be radians under the name of degrees, `n` being the exponent fitted: the largest lies
    /// between 1 and π/2; or below, and n is beyond 5000, which radians that are read as degrees make of n = 1.6 and
    /// more.
    ///
    /// ```
    /// use bellfit::fit::measured::{Samples, Unit, Weighting};
    /// let rows = [(0.0, 1.0, 1.0), (0.7, 0.8, 1.0), (1.5, 0.1, 1.0)];
    /// assert!(Samples::new(Unit::Degrees, Weighting::Equal, &rows)?.may_be_radians(900.0));
    /// assert!(!Samples::new(Unit::Radians, Weighting::Equal, &rows)?.may_be_radians(900.0));
    /// let near = Samples::new(Unit::Degrees, Weighting::Equal, &rows[..2].repeat(2))?;
    /// assert!(near.may_be_radians(20_000.0) && !near.may_be_radians(900.0));
    /// # Ok::<(), bellfit::fit::measured::DataError>(())
    /// ```
    pub fn may_be_radians(&self, n: f64) -> bool {
        let largest = self.all.iter().map(|sample| sample.theta_deg).fold(0.0, f64::max);
        let is_narrow = largest >= 1.0 || n > TOO_NARROW;
        self.unit == Unit::Degrees && largest <= MOST_RADIANS && is_narrow
    }
}

/// An exponent that few measured lobes have: e^-1 at 1.15 degrees.
const TOO_NARROW: f64 = 5000.0;

fn number(row: usize, column: &Column, text: &str) -> Result<f64, DataError> {
    let name = column.name.clone();
    if text.is_empty() {
        return Err(DataError::Missing { row, column: name });
    }
    match text.parse::<f64>() {
        Ok(x) if x.is_finite() => Ok(x),
        Ok(_) => Err(DataError::NotFinite { row, column: name, text: shown(text) }),
        Err(_) => {
            let is_comma = text.replacen(',', ".", 1).parse::<f64>().is_ok();
            let hint = if is_comma { "; decimals follow a point" } else { "" };
            Err(DataError::NotANumber { row, column: name, text: shown(text), hint })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_sigma_of_0_is_called_exact() {
        for (sigma, says) in [(0.0, true), (-1.0, false), (1e-61, false), (f64::NAN, false)] {
            let rows = [(0.0, 1.0, 0.1), (5.0, 0.5, sigma), (9.0, 0.2, 0.1)];
            let error = Samples::new(Unit::Degrees, Weighting::Sigma, &rows).unwrap_err().to_string();
            assert_eq!(error.contains("no measurement is exact"), says, "{sigma}: {error}");
        }
    }
}
